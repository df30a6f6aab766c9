# SPDX-License-Identifier: BSD-3-Clause
"""An oscillation on one page: Lissajous curves of the measured cycles, stress over the phase, moduli and harmonics."""

import numpy as np

from .labels import add_heading, plain_ticks, scaled_ticks, scene_line, short_power
from .run_page import as_formula, say
from .style import BLUE, GREEN, GREY, ORANGE, VERMILION, plt

FEWEST = 3  # replicas, or cycles of a single one, from which an error is known
MOST_HARMONICS = 5
MOST_CYCLES = 30  # more are not drawn one by one


class Cycles:
    """Whole cycles of a run: each series as [replicas][cycles][windows of a cycle]."""

    def __init__(self, run):
        shear = run.scene["shear"]
        self.amplitude = float(shear["amplitude"])
        self.windows = int(shear["cycle_pieces"])
        self.run = run
        self.count = len(run.strain) // self.windows
        self.discarded = run.discarded // self.windows
        self.period = float(shear["period"]) if isinstance(shear.get("period"), (int, float)) else (
            2 * np.pi * self.amplitude / float(shear["peak_rate"]))
        ends = self.amplitude * np.sin(2 * np.pi * np.arange(self.windows + 1) / self.windows)  # strain, of windows
        self.rate = np.diff(ends) * self.windows / self.period
        wave = run.summary.get("oscillation", {}).get("waveform", {})
        self.strain = np.array(wave.get("strain", (ends[:-1] + ends[1:]) / 2))  # at the samples; until known the middle
        self.phase = (np.arange(self.windows) + share_of_window(self.strain, ends)) / self.windows
        self.measured = slice(min(self.discarded, max(self.count - 1, 0)), self.count)

    def of(self, name):
        rows = self.run.each[name][:, :self.count * self.windows]
        return rows.reshape(len(rows), self.count, self.windows)

    def wave(self, name):
        """Mean over measured cycles and replicas at each phase, and its standard error or None. Cycles of one packing may
        repeat each other, so of several replicas the error is over these."""
        passes = self.of(name)[:, self.measured]
        passes = passes.mean(axis=1) if len(passes) > 1 else passes[0]
        error = passes.std(axis=0, ddof=1) / np.sqrt(len(passes)) if len(passes) >= FEWEST else None
        return passes.mean(axis=0), error

    def moduli(self):
        """G' and G'' of each cycle, as the program has them, [replicas][cycles] each."""
        table = self.run.table("cycles")
        shown = table["cycle"] <= self.count
        return [table[name][shown].reshape(-1, self.count) for name in ("G_storage", "G_loss")]


def share_of_window(strain, ends):
    """Mean time of the samples of a window over its length, by the strain, which is linear in each."""
    change = np.diff(ends)
    return float(change @ (strain - ends[:-1]) / (change @ change))


def closed(values):
    """A cycle with its first point at its end too."""
    return np.concatenate([values, values[:1]])


def draw_loop(axes, cycles, x, label):
    """Shear stress against strain or rate: measured cycles together, each of them pale, the first one grey."""
    sigma = cycles.of("sigma").mean(axis=0)
    if cycles.discarded and cycles.count > 1:
        axes.plot(x, sigma[0], color=GREY, lw=0.9, ls=(0, (4, 2)), label="first cycle")
    shown = sigma[cycles.measured]
    for k, one in enumerate(shown if 1 < len(shown) <= MOST_CYCLES else []):
        axes.plot(closed(x), closed(one), color=VERMILION, alpha=0.25, lw=0.6, label=None if k else "each measured one")
    mean, error = cycles.wave("sigma")
    if error is not None:
        low, high = (np.stack([closed(x), closed(mean + sign * error)], axis=1) for sign in (-1, 1))
        for one, two, three, four in zip(low[:-1], low[1:], high[1:], high[:-1]):
            axes.fill(*np.array([one, two, three, four]).T, color=VERMILION, alpha=0.3, lw=0)
    axes.plot(closed(x), closed(mean), color=VERMILION, lw=1.6, label="their mean" if len(shown) > 1 else "measured cycle")
    for line in (axes.axhline, axes.axvline):
        line(0.0, color=GREY, lw=0.6, zorder=0)
    ahead = max(1, len(x) // 32)
    axes.annotate("", (x[ahead], mean[ahead]), (x[0], mean[0]), zorder=4,
                  arrowprops={"arrowstyle": "-|>", "color": VERMILION, "lw": 1.6, "mutation_scale": 16})
    axes.set_xlabel(label)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=3, borderaxespad=0.1, columnspacing=1.2)
    plain_ticks(axes.xaxis)
    axes.xaxis.set_major_locator(plt.MaxNLocator(5))
    scaled_ticks(axes.yaxis, r"$\sigma$", cycles.run.unit.get("sigma", ""))


def draw_stack(figure, spot, rows, finish):
    """Panels above each other. rows: (draw(axes), label, its unit)."""
    grid, stack = spot.subgridspec(len(rows), 1, hspace=0.16), []
    for i, (draw_row, label, unit) in enumerate(rows):
        axes = figure.add_subplot(grid[i])
        draw_row(axes)
        scaled_ticks(axes.yaxis, label, unit)
        finish(axes)
        if i < len(rows) - 1:
            axes.tick_params(labelbottom=False)
            axes.set_xlabel("")
        stack.append(axes)
    figure.align_ylabels(stack)


def draw_phase(figure, spot, cycles):
    """Shear stress, pressure and contact number over the phase of the strain."""
    def wave(name, colour):
        def draw_row(axes):
            mean, error = cycles.wave(name)
            axes.plot(cycles.phase, mean, color=colour)
            if error is not None:
                axes.fill_between(cycles.phase, mean - error, mean + error, color=colour, alpha=0.3, lw=0)
        return draw_row

    def stress(axes):
        wave("sigma", VERMILION)(axes)
        axes.axhline(0.0, color=GREY, lw=0.6, zorder=0)
        low, high = axes.get_ylim()
        half = max(abs(low), abs(high))
        axes.plot(cycles.phase, 0.85 * half * np.sin(2 * np.pi * cycles.phase), color=GREY, lw=0.9, ls=(0, (4, 2)), zorder=0,
                  label="dashed: the strain")
        axes.set_ylim(-half, half)
        axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), borderaxespad=0.1)

    def finish(axes):
        axes.set_xlim(0, 1)
        axes.set_xlabel("phase $t/T$, strain $\\gamma_0\\sin 2\\pi t/T$")

    unit = cycles.run.unit
    draw_stack(figure, spot, [(stress, r"$\sigma$", unit.get("sigma", "")), (wave("p", BLUE), "$p$", unit.get("p", "")),
                              (wave("Z", ORANGE), "$Z$", "")], finish)


def draw_by_cycle(axes, cycles, values, colour, label=None):
    """values: [replicas][cycles], a point a cycle."""
    number = np.arange(1, cycles.count + 1)
    marker = "o" if cycles.count <= 60 else None
    for row in values if len(values) > 1 else []:
        axes.plot(number, row, color=colour, alpha=0.3, lw=0.6)
    axes.plot(number, values.mean(axis=0), color=colour, marker=marker, ms=3.5, label=label)


def grey_out(axes, cycles):
    axes.set_xlim(0.5, max(cycles.count, 2) + 0.5)
    axes.axvspan(0.5, cycles.discarded + 0.5, color="#000000", alpha=0.07, lw=0)
    axes.xaxis.set_major_locator(plt.MaxNLocator(integer=True))
    axes.set_xlabel("cycle")


def draw_means(figure, spot, cycles):
    """Pressure and contact number over the cycles."""
    def of(name, colour):
        return lambda axes: draw_by_cycle(axes, cycles, cycles.of(name).mean(axis=2), colour)

    draw_stack(figure, spot, [(of("p", BLUE), "mean $p$", cycles.run.unit.get("p", "")), (of("Z", ORANGE), "mean $Z$", "")],
               lambda axes: grey_out(axes, cycles))


def draw_moduli(axes, cycles):
    """G' and G'' over the cycles; their means are in words."""
    for values, name, colour, symbol in zip(cycles.moduli(), ("G_storage", "G_loss"), (BLUE, VERMILION), ("$G'$", "$G''$")):
        mean, error = cycles.run.mean(name)
        told = f"{symbol} = {as_formula(mean, error)}" if np.isfinite(mean) else symbol
        draw_by_cycle(axes, cycles, values, colour, told)
    axes.axhline(0.0, color=GREY, lw=0.6, zorder=0)
    scaled_ticks(axes.yaxis, "$G'$, $G''$", "m/tau_e^2")
    axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=2, borderaxespad=0.1)
    grey_out(axes, cycles)


def draw_harmonics(axes, cycles):
    """Harmonics of the stress over gamma_0, in per cent of the first one."""
    run = cycles.run
    first = np.hypot(run.mean("G_storage")[0], run.mean("G_loss")[0])
    if not (np.isfinite(first) and first > 0):
        return say(axes, "harmonics come with the end of the run")
    for shift, name, colour, label in ((-0.19, "G_storage", BLUE, r"in $\sin n\omega t$"),
                                       (0.19, "G_loss", VERMILION, r"in $\cos n\omega t$")):
        numbers = [n for n in range(2, MOST_HARMONICS + 1) if np.isfinite(run.mean(f"{name}_{n}")[0])]
        found = np.array([run.mean(f"{name}_{n}") for n in numbers]).reshape(-1, 2) * 100 / first
        x = np.array(numbers) + shift
        axes.bar(x, found[:, 0], 0.34, color=colour, label=label, yerr=np.nan_to_num(found[:, 1]),
                 error_kw={"lw": 1.0, "ecolor": "#222222"})
        for place, (value, error) in zip(x, found):
            end = value + np.sign(value) * np.nan_to_num(error)
            axes.annotate(f"{value:.1f}", (place, end), (0, 3 if value >= 0 else -3), textcoords="offset points", ha="center",
                          va="bottom" if value >= 0 else "top", fontsize=9)
    axes.axhline(0.0, color="#444444", lw=0.8)
    axes.set_xticks(range(2, MOST_HARMONICS + 1))
    axes.set_xlabel("harmonic $n$")
    axes.set_ylabel(r"$\sigma_n$ over $\sigma_1$  [%]")
    axes.margins(y=0.12)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=2, borderaxespad=0.1)


def draw(run):
    cycles = Cycles(run)
    figure = plt.figure(figsize=(15.5, 10.0))
    grid = figure.add_gridspec(2, 3, left=0.08, right=0.985, bottom=0.06, top=0.875, wspace=0.27, hspace=0.3)
    if cycles.count == 0:
        say(figure.add_subplot(grid[:, :]), "no cycle is finished yet")
    else:
        draw_loop(figure.add_subplot(grid[0, 0]), cycles, cycles.strain, r"strain $\gamma$")
        draw_loop(figure.add_subplot(grid[0, 1]), cycles, cycles.rate / (cycles.amplitude * 2 * np.pi / cycles.period),
                  r"strain rate over its peak  $\dot\gamma T/2\pi\gamma_0$")
        draw_phase(figure, grid[0, 2], cycles)
        draw_means(figure, grid[1, 0], cycles)
        draw_moduli(figure.add_subplot(grid[1, 1]), cycles)
        draw_harmonics(figure.add_subplot(grid[1, 2]), cycles)
    what = (rf"$\gamma_0 = {cycles.amplitude:.4g}$    $T = ${short_power(float(f'{cycles.period:.4g}'))} $\tau_e$    "
            f"{cycles.count} cycle{'s' if cycles.count != 1 else ''}")
    notes = ["grey: not measured"] if cycles.discarded else []
    notes += ["pale, below: each replica"] if run.replicas > 1 else []
    notes += ["shaded: standard error"] if cycles.count and cycles.wave("sigma")[1] is not None else []
    add_heading(figure, run.about, scene_line(run.about, None, run.replicas, what), ",  ".join(notes))
    return figure
