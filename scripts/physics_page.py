#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of docs/physics.md and docs/accuracy.md that sweeps of inputs/checks make: scripts/physics_page.py [NAME...]

Runs inputs/checks/NAME.toml into RESULTS/NAME (what is done there is kept) and puts its table between the marks of the
page; the text around them stays. With --check nothing is written: tables that come out otherwise are printed, and the
exit status is 1.
"""

import argparse
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "scripts/lib")]
from page_tables import digits, in_page, marks, measured, of_page, table  # noqa: E402

SCRIPT = "physics_page.py"
PAGES = [ROOT / "docs/physics.md", ROOT / "docs/accuracy.md"]


def page_of(name):
    return next(page for page in PAGES if marks(name, SCRIPT)[0] in page.read_text(encoding="utf-8"))


def share(value):
    return f"{100 * value:.2g}%"


def rows(title, keys, **columns):
    """A table that lies on its side: a column a key."""
    lines = [[title, *map("{:g}".format, keys)], ["---"] * (1 + len(keys))]
    lines += [[name, *cells] for name, cells in columns.items()]
    return table(lines)


def angles(point):
    """Of P(theta): its deviation from |cos theta| over the mean, and P at +-90 degrees over the peak."""
    import numpy as np
    histogram = point.load().histograms["theta"]
    centres = (histogram.edges[1:] + histogram.edges[:-1]) / 2
    law = np.abs(np.cos(np.radians(centres)))
    density = histogram.density / histogram.density.mean()
    steep = np.abs(np.abs(centres) - 90).argsort()[:2]  # a bin about each
    return math.sqrt(np.mean((density - law / law.mean())**2)), density[steep].mean() / density.max()


def durations(sweep):
    found = [angles(point) for point in sweep]
    return rows("Q", sweep["disks.elasticity"], **{
        "τ_dur": map(measured, sweep["tau_dur"], sweep.error("tau_dur")),
        "collisions of two disks alone": map(share, sweep["cluster_binary_share"]),
        "P(θ) against \\|cos θ\\|: root mean square deviation over the mean": [share(one[0]) for one in found],
        "P at ±90° over the peak": [share(one[1]) for one in found]})


def contact_number(sweep):
    return rows("Q", sweep["disks.elasticity"], **{
        "Z": map(digits, sweep["Z"]), "τ_dur": map(digits, sweep["tau_dur"]),
        "η_p": map(measured, sweep["eta_p"], sweep.error("eta_p"))})


def kink(sweep):
    import numpy as np
    rate, phi, eta = sweep["shear.strain_rate"], sweep["disks.packing_fraction"], sweep["eta_p"]
    fast, slow = (eta[np.isclose(rate, value)] for value in (1e-4, 2e-5))
    return rows("φ", np.unique(phi), **{"1e-4": map(digits, fast), "2e-5": map(digits, slow),
                                       "their ratio": [digits(value, 2) for value in fast / slow]})


def power_of_ten(value):
    return f"{value:.0e}".replace("e-0", "e-")


def drag(sweep):
    """A row a rate: Q sigma/gammadot at each drag, and the share of the power that the drag takes."""
    import numpy as np
    rates, drags = (np.unique(sweep[key])[::-1] for key in ("shear.strain_rate", "drive.drag"))
    lines = [["γ̇", *(f"ζ = {one:g}" if one else "none" for one in drags)], ["---"] * (1 + len(drags))]
    for rate in rates:
        cells = [power_of_ten(rate)]
        for one in drags:
            at, = np.flatnonzero((sweep["shear.strain_rate"] == rate) & (sweep["drive.drag"] == one))
            cells.append(measured(sweep["eta_sigma"][at], sweep.error("eta_sigma")[at]))
            if one:
                cells[-1] += f"; {100 * sweep['drag_power'][at]:.3g}%"
        lines.append(cells)
    return table(lines)


def boxes(sweep):
    lines = [["law", "Q", "N", "L_x × L_y", "R_v", "B_p", "B_σ", "Z"], ["---"] * 8]
    keys = [sweep[f"disks.{key}"] for key in ("model", "elasticity", "count", "packing_fraction", "box_aspect")]
    for k, (model, q, count, phi, aspect) in enumerate(zip(*keys)):
        width = math.sqrt(count * math.pi / 4 * (1 + 1.4**2) / 2 / phi / aspect)
        lines.append([model, f"{q:g}", f"{count:g}", f"{width:.1f} × {width * aspect:.1f}",
                      *(measured(sweep[name][k], sweep.error(name)[k]) for name in ("R_v", "B_p", "B_sigma", "Z"))])
    return table(lines)


def identities(sweep):
    lines = [["law, φ, Q, rate", "scheme", "dt", "p_dis/p", "P/σγ̇A", "corr(V^C_T, V^R)", "B_p"], ["---"] * 7]
    for k, model in enumerate(sweep["disks.model"]):
        def cell(name, factor=1, unit=""):
            value, error = sweep[name][k], sweep.error(name)[k]
            return "" if math.isnan(value) else measured(factor * value, factor * error) + unit

        lines.append([f"{model} {sweep['disks.packing_fraction'][k]:g}, {sweep['disks.elasticity'][k]:g}, "
                      + power_of_ten(sweep["shear.strain_rate"][k]),
                      {"two-stage-leapfrog": "two stages"}.get(sweep["integration.scheme"][k], "papers'"),
                      f"{sweep['integration.time_step'][k]:g}", cell("p_dis_share", 100, "%"), cell("torque_power", 100, "%"),
                      cell("contact_rotation_correlation"), cell("B_p")])
    return table(lines)


TABLES = {"durations": durations, "contact_number": contact_number, "kink": kink, "drag": drag, "boxes": boxes,
          "identities": identities}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(TABLES)}; default: all")
    parser.add_argument("--program", default=ROOT / "build/openmp/bagnold")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/checks", metavar="RESULTS")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    import bagnold
    wrong = False
    for name in given.names or TABLES:
        subprocess.run([given.program, "sweep", ROOT / f"inputs/checks/{name}.toml", "--out", given.out / name],
                       stdout=subprocess.DEVNULL, check=True)
        page = page_of(name)
        text = page.read_text(encoding="utf-8")
        old = of_page(text, name, SCRIPT)
        new = TABLES[name](bagnold.sweep(given.out / name))
        if given.check and new != old:
            print(f"{name} is kept as\n{old}and comes out as\n{new}")
            wrong = True
        elif not given.check:
            page.write_text(in_page(text, name, SCRIPT, new), encoding="utf-8")
    return wrong


if __name__ == "__main__":
    sys.exit(main())
