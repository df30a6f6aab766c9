#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws docs/figures/both_phases.png: flow curves of CD_rot in both phases, beside a packing in which they
coexist. From the tables in docs/data/figures; nothing is run."""

import argparse
import csv
import pathlib
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))

from bagnold.plots.figure_data import points_of  # noqa: E402
from bagnold.plots.style import DASHED, STYLE, plt, save  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.colors import LogNorm  # noqa: E402

TABLES = ROOT / "docs/data/figures"
SHOWN = [0.70, 0.74, 0.76, 0.78, 0.79, 0.795, 0.80, 0.81, 0.82, 0.83]
BANDS = {"disks.packing_fraction": 0.7984, "shear.strain_rate": 3e-5}


def flow_curves(axes):
    """p against the rate at Q = 1, N = 1024: one line a packing fraction."""
    with open(TABLES / "cd_rot_density.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if float(row["disks.elasticity"]) == 1]
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.92, len(SHOWN)))
    for phi, colour in zip(SHOWN, colours):
        rate, p = np.array(sorted((float(row["shear.strain_rate"]), float(row["p"])) for row in rows
                                  if np.isclose(float(row["disks.packing_fraction"]), phi))).T
        axes.loglog(rate, p, "o-", ms=3.5, color=colour)
        axes.text(rate[0] / 1.2, p[0], f"{phi:g}", ha="right", va="center", fontsize=8, color=colour)
    for rate, start, power, text in (((2e-6, 2e-5), 1.5e-3, 1, r"Newtonian, $p\sim\dot\gamma$"),
                                     ((3e-6, 6e-5), 2e-11, 2, r"Bagnold, $p\sim\dot\gamma^2$")):
        axes.plot(rate, [start, start * (rate[1] / rate[0])**power], color="k", lw=1, ls=DASHED)
        axes.text(rate[1] * 1.2, start * (rate[1] / rate[0])**power, text, va="center", fontsize=9)
    axes.set(xlabel=r"$\dot\gamma\tau_e$", ylabel=r"$p$, [$m/\tau_e^2$]", xlim=(5e-7, 1.4e-3), ylim=(3e-12, 0.05),
             title="CD_rot, Q = 1, at packing fractions $\\phi$")


def packing(axes):
    """Disks of a box with shear bands by their local strain rate, lying on its side."""
    (point,) = points_of([str(TABLES / "bands_profiles.json")], BANDS)
    disks, frame = point.columns("samples/fields"), point.columns("samples/fields_frame")
    length = frame["box_length"][0]
    height = point.scene["disks.box_aspect"] * length
    drawn = EllipseCollection(disks["diameter"], disks["diameter"], 0, units="xy", cmap="viridis_r",
                              offsets=np.stack([disks["y"], disks["x"]], axis=1), transOffset=axes.transData,
                              array=np.clip(disks["gammadot"], 1e-7, None), lw=0, norm=LogNorm(3e-6, 2e-4))
    axes.add_collection(drawn)
    axes.set(xlim=(0, height), ylim=(0, length), aspect="equal", xlabel="$y/d_s$", yticks=[0, length],
             yticklabels=["0", f"{length:.0f}"], ylabel="$x/d_s$",
             title=f"$\\phi$ = {point.scene['disks.packing_fraction']:g}, $\\dot\\gamma\\tau_e$ = 3e-5: "
                   "Newtonian (light) and Bagnoldian (dark) bands")
    axes.spines[["top", "right"]].set_visible(True)
    bar = axes.figure.colorbar(drawn, ax=axes, shrink=0.9, pad=0.01, extend="both")
    bar.set_label(r"local $\dot\gamma\tau_e$")
    bar.outline.set_visible(False)


def main():
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(2, 1, figsize=(8.6, 6.2), layout="constrained", height_ratios=[3.2, 1])
        flow_curves(left)
        packing(right)
        save(figure, ROOT / "docs/figures/both_phases.png", dpi=220, colours=128)


if __name__ == "__main__":
    main()
