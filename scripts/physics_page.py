#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of docs/physics.md that sweeps of inputs/checks make: scripts/physics_page.py [NAME...]

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
sys.path.insert(0, str(ROOT / "python"))

PAGE = ROOT / "docs/physics.md"


def marks(name):
    return f"<!-- table {name}: scripts/physics_page.py -->\n", f"<!-- end of {name} -->\n"


def digits(value, count=3):
    """So many significant digits, without an exponent."""
    return f"{value:.{max(0, count - 1 - math.floor(math.log10(abs(value))))}f}"


def measured(value, error):
    """Value and, in brackets, the error in units of its last digit: one digit of it, two where the first is 1. Without
    an error, of a run too short for one, three digits."""
    if not error > 0:
        return digits(value)
    place = math.floor(math.log10(error))
    if f"{error / 10**place:.0f}" == "1":
        place -= 1
    return f"{value:.{max(0, -place)}f} ({error / 10**place:.0f})"


def share(value):
    return f"{100 * value:.2g}%"


def rows(title, keys, **columns):
    """A table that lies on its side: a column a key."""
    lines = [[title, *map("{:g}".format, keys)], ["---"] * (1 + len(keys))]
    lines += [[name, *cells] for name, cells in columns.items()]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


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


TABLES = {"durations": durations, "contact_number": contact_number, "kink": kink}


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
        begin, end = marks(name)
        before, rest = PAGE.read_text(encoding="utf-8").split(begin)
        old, after = rest.split(end)
        new = TABLES[name](bagnold.sweep(given.out / name))
        if given.check and new != old:
            print(f"{name} is kept as\n{old}and comes out as\n{new}")
            wrong = True
        elif not given.check:
            PAGE.write_text(before + begin + new + end + after, encoding="utf-8")
    return wrong


if __name__ == "__main__":
    sys.exit(main())
