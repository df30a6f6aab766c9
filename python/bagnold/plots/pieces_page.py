# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of runs by pieces: a sequence (start-up, reversal, stop) and an oscillation (Lissajous curves)."""

import tomllib

import numpy as np

from .labels import add_heading, log_ticks, plain_ticks, power_of_ten, scale_of, scene_line, with_unit
from .style import BLUE, COLOURS, GREEN, GREY, ORANGE, plt

STRESS = "m/tau_e^2"


def shear_of(run):
    """The table [shear] of the resolved scene."""
    return tomllib.loads(str(run.about["scene"]))["shear"]


def durations(run):
    """Of each window, tau_e."""
    return run.number("time_step") * np.diff(np.concatenate([[0.0], steps_after(run)]))


def steps_after(run):
    return np.rint((run["time"] - start_of(run)) / run.number("time_step"))


def start_of(run):
    """Time at step 0, tau_e: from the strain of the first window, or, of a stop, none but that of its end."""
    rate, strain = run["strain_rate"][0], run["strain"][0]
    steps = run.number("steps")
    return run["time"][0] - strain / rate if rate else run["time"][-1] - steps * run.number("time_step")


def rows_of(run, name):
    """A series of each replica, [R, windows]."""
    return run.each[name] if name in run.each else run[name][None]


def legs_of(run):
    """Windows of each piece: slices in which the rate is the same."""
    ends = np.nonzero(np.diff(run["strain_rate"]))[0] + 1
    return [leg for leg in np.split(np.arange(len(run["strain_rate"])), ends) if len(leg)]


def draw_sequence(run):
    """Stresses and contacts along the way, strains of both signs added up, and stops over the logarithm of time."""
    path = np.cumsum(np.abs(run["strain_rate"]) * durations(run))
    legs = legs_of(run)
    stops = [leg for leg in legs if run["strain_rate"][leg[0]] == 0]
    figure = plt.figure(figsize=(15.5, 10.0))
    grid = figure.add_gridspec(2, 2, left=0.075, right=0.985, bottom=0.07, top=0.86, wspace=0.2, hspace=0.24)
    panels = [("sigma", with_unit(r"$\sigma$", STRESS)), ("p", with_unit("$p$", STRESS)), ("Z", "$Z$"), ("mu", r"$\mu$")]
    for spot, (name, label) in enumerate(panels[:3 if stops else 4]):
        axes = figure.add_subplot(grid[spot // 2, spot % 2])
        for k, leg in enumerate(legs):
            if leg[0] in [stop[0] for stop in stops]:
                axes.axvline(path[leg[0]], color=GREY, lw=0.8, ls=":")
                continue
            for row in rows_of(run, name):
                axes.plot(path[leg], row[leg], color=COLOURS[k % len(COLOURS)], lw=1.2,
                          alpha=0.9 if run.replicas == 1 else 0.3)
            if run.replicas > 1:
                axes.plot(path[leg], run[name][leg], color=COLOURS[k % len(COLOURS)], lw=1.8)
        if name in ("sigma", "mu"):
            axes.axhline(0, color=GREY, lw=0.6, zorder=0)
        axes.set_xlim(0, path[-1] or 1)
        axes.set_xlabel(r"strain, both ways added up")
        axes.set_ylabel(label)
        plain_ticks(axes.yaxis)
    if stops:
        draw_stops(figure.add_subplot(grid[1, 1]), run, stops)
    add_heading(figure, run.about, scene_line(run.about, replicas=run.replicas, rate=rates_in_words(run, legs)),
                "a colour a piece" + ("; dotted: stops" if stops else "") + ("; pale: replicas" if run.replicas > 1 else ""))
    return figure


def draw_stops(axes, run, stops):
    """Pressure and temperature since each stop began."""
    since_start = run.number("time_step") * steps_after(run)
    length = durations(run)
    for k, stop in enumerate(stops):
        begin = since_start[stop[0]] - length[stop[0]]
        time = since_start[stop] - length[stop] / 2 - begin
        for name, colour, label in (("p", BLUE, "$p$"), ("p_kin", ORANGE, "$p_{kin}$")):
            axes.plot(time, run[name][stop], color=colour, lw=1.4, ls=("-", "--", ":")[k % 3],
                      label=label if k == 0 else None)
    axes.set_xscale("log")
    axes.set_yscale(scale_of(np.concatenate([run["p_kin"][stop] for stop in stops])))
    axes.set_xlabel(r"time since the stop $t/\tau_e$")
    axes.set_ylabel(with_unit("stress", STRESS))
    log_ticks(axes.xaxis)
    axes.legend(loc="best")


def rates_in_words(run, legs):
    rates = [float(run["strain_rate"][leg[0]]) for leg in legs]
    shown = [power_of_ten(float(f"{rate:.2g}")) if rate else "0" for rate in rates[:4]]
    return r"$\dot\gamma\tau_e = $" + ", ".join(shown) + (" ..." if len(rates) > 4 else "")


def draw_oscillation(run):
    """Lissajous curves of measured cycles, their mean, and how pressure and contacts go from cycle to cycle."""
    shear = shear_of(run)
    pieces = int(shear["cycle_pieces"])
    rate = run["strain_rate"]
    strain = run["strain"] - rate * durations(run) / 2
    cycles = len(rate) // pieces
    first = min(run.discarded // pieces, max(cycles - 1, 0))
    figure = plt.figure(figsize=(15.5, 10.0))
    grid = figure.add_gridspec(2, 2, left=0.075, right=0.985, bottom=0.07, top=0.86, wspace=0.2, hspace=0.24)
    for spot, x, label in ((0, strain, r"strain $\gamma$"), (1, rate, r"strain rate $\dot\gamma\tau_e$")):
        axes = figure.add_subplot(grid[0, spot])
        draw_loops(axes, run, x, pieces, range(first, cycles))
        axes.set_xlabel(label)
        axes.set_ylabel(with_unit(r"$\sigma$", STRESS))
        axes.axhline(0, color=GREY, lw=0.6, zorder=0)
        axes.axvline(0, color=GREY, lw=0.6, zorder=0)
        axes.ticklabel_format(axis="x", style="sci", scilimits=(-2, 3))
    for spot, name, label, colour in ((0, "p", with_unit("$p$", STRESS), BLUE), (1, "Z", "$Z$", GREEN)):
        axes = figure.add_subplot(grid[1, spot])
        number = (np.arange(len(rate)) + 0.5) / pieces
        for row in rows_of(run, name):
            axes.plot(number, row, color=colour, lw=0.6, alpha=0.4)
        mean = run[name][:cycles * pieces].reshape(cycles, pieces).mean(axis=1)
        axes.plot(np.arange(cycles) + 0.5, mean, color="black", marker="o", ms=3, lw=1.0)
        axes.axvspan(0, first, color="#000000", alpha=0.07, lw=0)
        axes.set_xlim(0, max(cycles, 1))
        axes.set_xlabel("cycle")
        axes.set_ylabel(label)
        plain_ticks(axes.yaxis)
    moduli = ", ".join(f"{label} = {run.mean(name)[0]:.4g}" for name, label in (
        ("G_storage", "$G'$"), ("G_loss", "$G''$"), ("G_storage_3", "$G'_3$"), ("G_loss_3", "$G''_3$"))
        if np.isfinite(run.mean(name)[0]))
    amplitude = rf"$\gamma_0 = $ {float(shear['amplitude']):.3g}"
    add_heading(figure, run.about, scene_line(run.about, replicas=run.replicas, rate=amplitude), moduli)
    return figure


def draw_loops(axes, run, x, pieces, cycles):
    total = []
    for cycle in cycles:
        part = slice(cycle * pieces, (cycle + 1) * pieces)
        for row in rows_of(run, "sigma"):
            axes.plot(closed(x[part]), closed(row[part]), color=ORANGE, lw=0.6, alpha=0.4)
            total.append(row[part])
    if total:
        part = slice(cycles[0] * pieces, (cycles[0] + 1) * pieces)
        axes.plot(closed(x[part]), closed(np.nanmean(total, axis=0)), color="black", lw=1.5)


def closed(values):
    return np.append(values, values[0])


def draw(run):
    return draw_sequence(run) if run.about["protocol"] == "sequence" else draw_oscillation(run)
