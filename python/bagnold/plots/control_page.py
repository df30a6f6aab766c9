# SPDX-License-Identifier: BSD-3-Clause
"""A flow at given shear stress, against time, or at given pressure, against strain: the page of a run, with what answers
in the place of the shares of stress."""

import numpy as np

from .labels import add_heading, scaled_ticks, scene_line
from .run_page import draw_packing, draw_profile, draw_stack, draw_stress, meaning_of_lines
from .style import BLUE, DOTTED, GREEN, ORANGE, SKY, VERMILION, plt

ANSWERS = {
    "stress": [("strain_rate", BLUE, r"$\dot\gamma$", True, None)],
    "pressure": [("packing_fraction", BLUE, r"$\phi$", False, None), ("I", SKY, "$I$", False, None)],
}


def draw_target(axes, run):
    """What is held, dotted."""
    shear = run.scene["shear"]
    wanted = np.atleast_1d(shear["stress" if shear["protocol"] == "stress" else "pressure"]).astype(float)
    stage = np.arange(len(run.x)) * len(wanted) * run.number("window_steps") // run.number("steps")
    axes.plot(run.x, wanted[np.minimum(stage.astype(int), len(wanted) - 1)], color="black", lw=1.2, ls=DOTTED)


def draw_strain(figure, spot, run):
    """Strain of each replica against time."""
    axes = figure.add_subplot(spot)
    for one in run.each["strain"]:
        axes.plot(run.x, one, color=SKY, lw=1.2)
    axes.set_xlim(0.0, run.x[-1])
    axes.set_xlabel(run.x_label)
    axes.set_ylabel(r"strain $\gamma$")
    scaled_ticks(axes.yaxis, r"strain $\gamma$", "")


def what_is_held(shear):
    if shear["protocol"] == "pressure":
        return rf"$\dot\gamma\tau_e$ = {shear['strain_rate']:.3g}    $p$ = {shear['pressure']:.4g} $m/\tau_e^2$"
    wanted = np.atleast_1d(shear["stress"])
    return rf"$\sigma$ = {', '.join(f'{one:.4g}' for one in wanted[:6])}{', ...' if len(wanted) > 6 else ''} $m/\tau_e^2$"


def draw(run):
    shear = run.scene["shear"]
    if shear["protocol"] == "stress":
        run.x, run.x_label = run["time"] - run["time"][0] + run.number("window_steps") * run.number("time_step"), \
            r"time $t$  [$\tau_e$]"
        run.rate = run.state.strain_rate if run.state else np.nan
    if np.ndim(shear.get("stress", 0)) == 1:
        run.discarded = 0  # there is a part of each stress
    figure = plt.figure(figsize=(15.5, 10.0))
    top = figure.add_gridspec(1, 3, left=0.085, right=0.985, bottom=0.585, top=0.875, wspace=0.3)
    bottom = figure.add_gridspec(1, 3, left=0.085, right=0.985, bottom=0.06, top=0.49,
                                 width_ratios=(4.2, 3.2, 6.6), wspace=0.2)
    draw_stress(figure, top[0], run)
    draw_target(figure.axes[0], run)
    draw_stack(figure, top[1], run, [("mu", GREEN, r"$\mu$", False, None), ("Z", ORANGE, "$Z$", False, None)])
    if shear["protocol"] == "stress":
        rate, strain = top[2].subgridspec(2, 1, hspace=0.32)
        draw_stack(figure, rate, run, ANSWERS["stress"])
        figure.axes[-1].set_xlabel("")
        figure.axes[-1].tick_params(labelbottom=False)
        draw_strain(figure, strain, run)
    else:
        draw_stack(figure, top[2], run, ANSWERS["pressure"])
    draw_stack(figure, bottom[0], run, [
        ("T_g", VERMILION, "$T_g$", True, None), ("R_v", BLUE, "$R_v$", True, 1.0)])
    for axes in figure.axes:
        if shear["protocol"] == "stress" and axes.get_xlabel():
            scaled_ticks(axes.xaxis, "time $t$", "tau_e")
    draw_profile(figure, bottom[1], run)
    draw_packing(figure, bottom[2], run)
    about = {k: v for k, v in run.about.items() if k != "packing_fraction" or shear["protocol"] == "stress"}
    add_heading(figure, run.about, scene_line(about, run.strain[-1], run.replicas, what_is_held(shear)),
                f"{meaning_of_lines(run)},  dotted: held", 0.085)
    return figure
