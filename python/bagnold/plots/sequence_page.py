# SPDX-License-Identifier: BSD-3-Clause
"""A sequence of pieces on one page: start-up and reversal against strain, a stop against the time since it began."""

from dataclasses import dataclass

import numpy as np

from .labels import add_heading, log_ticks, plain_ticks, power_of_ten, scaled_ticks, scene_line, with_unit
from .run_page import MANY_WINDOWS, smooth
from .style import GREY, colour_of, plt

from matplotlib.lines import Line2D

MOST_NAMED = 8  # pieces; of more the first and the last have a name
FEWEST = 3  # replicas from which an error is known
SYMBOLS = {"sigma": r"$\sigma$", "p": "$p$", "Z": "$Z$", "T_g": "$T_g$"}


@dataclass
class Piece:
    """Windows of one piece, in one pass through the sequence."""

    number: int  # in the sequence, from 1
    windows: slice
    strain_before: float
    time_before: float  # [tau_e]
    rate: float  # [1/tau_e]

    def strain(self, run):
        """At the middle of each window."""
        return middles(run["strain"][self.windows], self.strain_before)

    def time(self, run):
        """Since the piece began, at the middle of each window [tau_e]."""
        return middles(run["time"][self.windows], self.time_before) - self.time_before


def middles(ends, before):
    return (ends + np.concatenate([[before], ends[:-1]])) / 2


def pieces_of(run):
    """Pieces that have windows, in their order; a run at work has fewer."""
    table = run.table("pieces")
    windows = len(run["time"])
    return [Piece(int(number), slice(int(first), min(int(end), windows)), strain, time, rate)
            for number, first, end, strain, time, rate in zip(
                *(table[name] for name in ("piece", "first_window", "end_window", "begin_strain", "begin_time", "strain_rate")))
            if first < windows]


def mean_and_error(run, name, piece, sign=1.0):
    """Mean over replicas and its standard error, None where it is unknown."""
    rows = sign * run.each[name][:, piece.windows]
    mean = sign * run[name][piece.windows]
    error = rows.std(axis=0, ddof=1) / np.sqrt(len(rows)) if len(rows) >= FEWEST else None
    return mean, error


def draw_lines(axes, run, name, pieces, where, value=lambda run, name, piece: mean_and_error(run, name, piece), least=-np.inf):
    """A line a piece, with a band of its error, or if there are many windows pale below its running mean. `least`: of the
    band, above 0 on a logarithmic axis."""
    count = max(piece.number for piece in pieces)
    for piece in pieces:
        colour = colour_of(piece.number - 1, count)
        x, (mean, error) = where(piece), value(run, name, piece)
        marker = "o" if len(x) < 40 else None
        if error is not None:
            axes.fill_between(x, np.maximum(mean - error, least), mean + error, color=colour, alpha=0.25, lw=0)
        elif len(x) >= MANY_WINDOWS:
            axes.plot(x, mean, color=colour, alpha=0.3, lw=0.5)
            mean = smooth(mean, len(x) // 100)
        axes.plot(x, mean, color=colour, marker=marker, ms=3, lw=1.2)


def draw_against_strain(axes, run, name, pieces):
    draw_lines(axes, run, name, pieces, lambda piece: piece.strain(run))
    if name == "sigma":
        axes.axhline(0.0, color=GREY, lw=0.8, zorder=0)
    for piece in pieces:  # a ring where it begins
        axes.plot(piece.strain(run)[0], run[name][piece.windows][0], "o", ms=5, mfc="white", mew=1.2, zorder=3,
                  color=colour_of(piece.number - 1, max(one.number for one in pieces)))
    axes.set_xlabel(r"strain $\gamma$")
    plain_ticks(axes.xaxis)
    scaled_ticks(axes.yaxis, SYMBOLS[name], run.unit.get(name, ""))


def draw_since_begin(axes, run, name, pieces):
    """All pieces from their own beginning, the shear stress along the direction of the shear."""
    def along(run, name, piece):
        return mean_and_error(run, name, piece, np.sign(piece.rate) if name == "sigma" else 1.0)

    draw_lines(axes, run, name, pieces, lambda piece: np.abs(piece.strain(run) - piece.strain_before), along)
    if name == "sigma":
        axes.axhline(0.0, color=GREY, lw=0.8, zorder=0)
    axes.set_xlabel("strain since the piece began")
    plain_ticks(axes.xaxis)
    scaled_ticks(axes.yaxis, r"$\sigma$ along the shear" if name == "sigma" else SYMBOLS[name], run.unit.get(name, ""))


def draw_stop(axes, run, name, pieces):
    """Against the time since the stop; the shear stress open where it is negative."""
    def size(run, name, piece):
        mean, error = mean_and_error(run, name, piece)
        return np.abs(mean), error

    draw_lines(axes, run, name, pieces, lambda piece: piece.time(run), size, np.finfo(float).tiny)
    count = max(piece.number for piece in pieces)
    for piece in pieces:
        mean = run[name][piece.windows]
        axes.plot(piece.time(run)[mean < 0], -mean[mean < 0], "o", ms=3, mfc="white", zorder=3,
                  color=colour_of(piece.number - 1, count))
    shown = np.concatenate([np.abs(run[name][piece.windows]) for piece in pieces])
    axes.set_ylabel(with_unit(r"$|\sigma|$" if name == "sigma" else SYMBOLS[name], run.unit.get(name, "")))
    axes.set_xlabel(r"time since the stop  $[\tau_e]$")
    axes.set_xscale("log")
    if name != "Z" and (shown > 0).any():
        axes.set_yscale("log", nonpositive="mask")
        axes.set_ylim(shown[shown > 0].min() / 1.5, shown.max() * 1.5)
        log_ticks(axes.yaxis)
    log_ticks(axes.xaxis)


def name_of(number, rate, amount):
    """"1: $\\dot\\gamma = 10^{-3}$, strain 2"."""
    if rate == 0:
        return f"{number}: stop, {power_of_ten(amount)} " + r"$\tau_e$"
    sign = "-" if rate < 0 else ""
    return rf"{number}: $\dot\gamma\tau_e = {sign}${power_of_ten(abs(rate))}, strain {amount:.4g}"


def name_pieces(figure, run, pieces):
    """Names above all panels, of many pieces the first and the last."""
    wanted = run.scene["shear"]["pieces"]
    drawn = sorted({piece.number for piece in pieces})
    named = drawn if len(drawn) <= MOST_NAMED else [drawn[0], drawn[-1]]
    handles = [Line2D([], [], lw=2, color=colour_of(number - 1, drawn[-1]), label=name_of(number, *wanted[number - 1]))
               for number in named]
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.07, 0.915), ncol=4, borderaxespad=0.0,
                  columnspacing=2.0)


def panels_of(flows, stops):
    """Rows of panels: (what draws it, quantity, pieces)."""
    rows = []
    if flows:
        rows.append([(draw_against_strain, name, flows) for name in ("sigma", "p", "Z")])
        rows.append([(draw_since_begin, name, flows) for name in ("sigma", "p", "Z")])
    if stops:
        of_stop = [(draw_stop, name, stops) for name in ("p", "sigma", "Z")]
        rows = [rows[0], [rows[1][0], *of_stop[:2]]] if flows else [of_stop]
    return rows


def draw(run):
    pieces = pieces_of(run)
    rows = panels_of([one for one in pieces if one.rate != 0], [one for one in pieces if one.rate == 0])
    figure = plt.figure(figsize=(15.5, 10.0))
    grid = figure.add_gridspec(len(rows), 3, left=0.075, right=0.985, bottom=0.06, top=0.86, wspace=0.25, hspace=0.24)
    for i, row in enumerate(rows):
        for j, (draw_panel, name, shown) in enumerate(row):
            draw_panel(figure.add_subplot(grid[i, j]), run, name, shown)
    name_pieces(figure, run, pieces)
    cycles = int(run.scene["shear"].get("cycles", 1))
    count = len(run.scene["shear"]["pieces"])
    what = f"{count} piece{'s' if count > 1 else ''}" + (f", {cycles} times" if cycles > 1 else "")
    path = float(np.abs(np.diff(run.strain, prepend=0.0)).sum())
    notes = ["shaded: standard error over replicas"] if run.replicas >= FEWEST else []
    notes += ["rings: where a piece begins"] if any(one.rate != 0 for one in pieces) else []
    notes += [r"open: $\sigma < 0$"] if any(one.rate == 0 for one in pieces) else []
    add_heading(figure, run.about, scene_line(run.about, path, run.replicas, what), ",  ".join(notes))
    return figure
