# SPDX-License-Identifier: BSD-3-Clause
"""One run on one page.

Reads /series of result.h5 and, where they lie in the same folder, the last state (state.h5:
velocity profile and packing) and the standard errors (summary.json).
"""

import json
import os
import tomllib

import numpy as np

from .labels import (add_heading, log_ticks, plain_ticks, power_of_ten, scale_of,
                     scene_line, short_power, with_unit)
from .style import BLUE, COLOURS, DASHED, DOTTED, GREEN, GREY, ORANGE, SKY, VERMILION, colour_of, plt
from ..contacts import pairs_within
from ..errors import InputError
from ..files import regular
from ..frames import read_states
from ..hdf5 import columns_of, open_hdf5, plain
from ..observables import rounded

from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon

MOST_CIRCLES = 20000  # more disks become an image
MANY_WINDOWS = 400  # from here on a running mean is drawn too
THIN = 38.0  # d_s across the drawing where the strongest contact is 3 points wide
MOST_CONTACTS = 5000  # more disks are drawn without their contacts


# ---------------------------------------------------------------------------------------- reading


class Run:
    """Data of the files; everything but /series may be missing."""

    def __init__(self, path):
        with open_hdf5(path) as file:
            group = file["series"]
            self.each = {k: np.atleast_2d(d[()]).astype(float) for k, d in group.items()}
            self.unit = {k: plain(d.attrs.get("unit", "")) for k, d in group.items()}
            self.discarded = int(group.attrs.get("discarded_windows", 0))
            self.about = {k: plain(v) for k, v in file.attrs.items()}
            tables = [name for name in ("cycles", "pieces") if f"samples/{name}" in file]
            self.path, self.tables = path, {name: columns_of(file["samples"][name]) for name in tables}
        self.scene = tomllib.loads(str(self.about.get("scene", "")))
        shapes = {values.shape for values in self.each.values()}
        if any(values.size == 0 for values in self.each.values()):
            raise InputError(f"{path}: no measurement window is finished yet; draw it later")
        if len(shapes) != 1:
            raise ValueError("/series is empty or its datasets differ in length")
        self.replicas, windows = shapes.pop()
        self.series = {k: mean_of_rows(values) for k, values in self.each.items()}
        folder = os.path.dirname(os.path.abspath(path))
        self.summary = read_summary(os.path.join(folder, "summary.json"))
        self.observables = self.summary.get("observables", {})
        self.state = read_state(os.path.join(folder, "state.h5"))
        self.strain = self.series.get("strain", np.arange(1.0, windows + 1.0))
        self.x, self.x_label = self.strain, r"strain $\gamma$"  # what series are drawn against
        self.rate = self.number("strain_rate", mean_of(self["strain_rate"]))

    def __getitem__(self, name):
        return self.series.get(name, np.full(len(next(iter(self.series.values()))), np.nan))

    def replicas_of(self, name):
        """The series of each replica, where there are several."""
        return self.each[name] if self.replicas > 1 and name in self.each else []

    def table(self, name):
        """Columns of a table of /samples by their names."""
        if name not in self.tables:
            raise InputError(f"{self.path} has no /samples/{name}: an older program wrote it; run its scene again")
        return self.tables[name]

    def number(self, name, default=np.nan):
        try:
            return float(self.about[name])
        except (KeyError, TypeError, ValueError):
            return default

    def mean(self, name):
        """Mean and standard error as the run found them, else the plain mean and NaN."""
        found = self.observables.get(name, {})
        if isinstance(found.get("mean"), (int, float)):
            return found["mean"], found.get("error") or np.nan
        if name == "mu":  # a ratio of means, never a mean of ratios
            return self.mean("sigma")[0] / (self.mean("p")[0] or np.nan), np.nan
        return mean_of(self[name][self.discarded:]), np.nan


def mean_of(values):
    """Mean of what is defined."""
    values = values[np.isfinite(values)]
    return float(values.mean()) if len(values) else np.nan


def mean_of_rows(values):
    """[R, n] to [n]: the mean over the replicas that have a value."""
    defined = np.isfinite(values)
    count = defined.sum(axis=0)
    total = np.where(defined, values, 0.0).sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def read_summary(path):
    """summary.json, {} while there is none."""
    try:
        with open(regular(path), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


def read_state(path):
    try:
        return read_states(path)[0]  # of replicas the first one
    except (OSError, KeyError, TypeError, ValueError):
        return None


def as_formula(mean, error):
    """``rounded`` with its power of ten as a formula."""
    if not (np.isfinite(error) and 0 < error < abs(mean)):
        return short_power(float(f"{mean:.3g}")) if np.isfinite(mean) else "undefined"
    digits, _, power = rounded(mean, error).partition("e")
    exponent = f"\\times 10^{{{int(power)}}}" if power else ""
    return f"${digits}{exponent}$"


# ---------------------------------------------------------------------------------------- series


def smooth(values, width):
    """Running mean over `width` windows, of what is defined."""
    defined = np.isfinite(values).astype(float)
    kernel = np.ones(width)
    total = np.convolve(np.where(defined > 0, values, 0.0), kernel, mode="same")
    count = np.convolve(defined, kernel, mode="same")
    return np.where(count > 0, total / np.maximum(count, 1.0), np.nan)


def draw_series(axes, run, name, colour, label):
    """Windows as a line (many: pale, with a running mean), the mean of the measured ones dashed."""
    label = f"{label} = {as_formula(*run.mean(name))}"
    windows = len(run.x)
    for one in run.replicas_of(name):
        pale = smooth(one, windows // 100) if windows >= MANY_WINDOWS else one
        axes.plot(run.x, pale, color=colour, alpha=0.25, lw=0.5, zorder=1)
    if windows >= MANY_WINDOWS:
        axes.plot(run.x, run[name], color=colour, alpha=0.3, lw=0.5)
        axes.plot(run.x, smooth(run[name], windows // 100), color=colour, lw=1.3, label=label)
    else:
        axes.plot(run.x, run[name], color=colour, marker="." if windows < 20 else None,
                  alpha=0.85, label=label)
    mean, error = run.mean(name)
    if np.isfinite(mean):
        measured = [run.x[min(run.discarded, len(run.x) - 1)], run.x[-1]]
        axes.plot(measured, [mean, mean], color="black", lw=1.0, ls=(0, (4, 2)))
        if np.isfinite(error):
            axes.fill_between(measured, mean - error, mean + error, color=colour, alpha=0.25, lw=0)


def finish_series(axes, run, *names, log=False, bottom=True):
    """Scale, limits, the discarded part in grey."""
    shown = np.concatenate([run[name][np.isfinite(run[name])] for name in names])
    late = np.concatenate([run[name][run.discarded:] for name in names])
    late = late[np.isfinite(late)] if np.isfinite(late).any() else shown
    if log and len(late) and late.min() > 0 and late.max() > 5 * late.min():
        axes.set_yscale("log", nonpositive="mask")
        low, high = np.log10([np.percentile(shown[shown > 0], 1), late.max()])
        low = min(low, np.log10(late.min()))
        high = max(high, np.log10(np.percentile(shown, 99)))
        edge = 0.06 * (high - low)
        axes.set_ylim(10 ** (low - edge), 10 ** (high + edge))
        log_ticks(axes.yaxis)
    elif len(late):  # the start should not flatten the rest
        low, high = late.min(), late.max()
        edge = 0.35 * (high - low) or 0.1 * abs(high) or 1.0
        axes.set_ylim(low - edge, high + edge)
        plain_ticks(axes.yaxis)
    start = run.x[min(run.discarded, len(run.x)) - 1] if run.discarded else 0.0
    axes.set_xlim(0.0, run.x[-1])
    axes.axvspan(0.0, start, color="#000000", alpha=0.07, lw=0)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=3, borderaxespad=0.1,
                columnspacing=1.2)
    if bottom:
        axes.set_xlabel(run.x_label)
    else:
        axes.tick_params(labelbottom=False)


def draw_stress(figure, spot, run):
    axes = figure.add_subplot(spot)
    draw_series(axes, run, "p", BLUE, "$p$")
    draw_series(axes, run, "sigma", VERMILION, r"$\sigma$")
    axes.set_ylabel(with_unit("stress", "m/tau_e^2"))
    finish_series(axes, run, "p", "sigma", log=True)


def meaning_of_lines(run):
    """Meaning of the lines of all series."""
    parts = ["grey: not measured"] if run.discarded else []
    parts += ["bold: running mean"] if len(run.strain) >= MANY_WINDOWS else []
    parts += ["pale: each replica"] if run.replicas > 1 else []
    return ",  ".join([*parts, "dashed: mean ± standard error"])


def draw_stack(figure, spot, run, rows):
    """Several quantities above each other over one strain axis."""
    rows = [row for row in rows if np.isfinite(run[row[0]]).any()]
    if not rows:
        return say(figure.add_subplot(spot), "nothing defined here")
    grid, stack = spot.subgridspec(len(rows), 1, hspace=0.32), []
    for i, (name, colour, label, log, line) in enumerate(rows):
        axes = figure.add_subplot(grid[i])
        if line is not None:
            axes.axhline(line, color=GREY, lw=0.8)
        draw_series(axes, run, name, colour, label)
        axes.set_ylabel(with_unit(label, run.unit.get(name, "")))
        finish_series(axes, run, name, log=log, bottom=i == len(rows) - 1)
        stack.append(axes)
    figure.align_ylabels(stack)


def draw_shares(figure, spot, run):
    """Elastic, dissipative, kinetic in per cent of the whole."""
    axes = figure.add_subplot(spot)
    parts = ("el", "dis", "kin")
    for shift, name, colour, label in ((-0.19, "p", BLUE, "of $p$"),
                                       (0.19, "sigma", VERMILION, r"of $\sigma$")):
        whole = run.mean(name)[0]
        if not (np.isfinite(whole) and whole):
            continue
        share = np.array([100 * run.mean(f"{name}_{part}")[0] / whole for part in parts])
        share[~np.isfinite(share)] = 0.0
        axes.bar(np.arange(3) + shift, share, 0.34, color=colour, label=label)
        for x, value in zip(np.arange(3) + shift, share):
            text = f"{value:.0f}%" if abs(value) >= 10 else f"{value:.2g}%" if abs(value) >= 0.1 else f"{value:.2f}%"
            axes.annotate(text, (x, value), (0, 3 if value >= 0 else -3),
                          textcoords="offset points", ha="center", fontsize=9,
                          va="bottom" if value >= 0 else "top")
    axes.axhline(0.0, color="#444444", lw=0.8)
    axes.set_xticks(range(3), ["elastic", "dissipative", "kinetic"])
    axes.tick_params(axis="x", length=0)
    axes.set_ylabel("share of the stress  [%]")
    axes.margins(y=0.12)
    if not axes.patches:
        return say(axes, "no stress to share")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.1)


# ---------------------------------------------------------------------------------------- the state


def say(axes, text):
    axes.text(0.5, 0.5, text, ha="center", va="center", color=GREY, transform=axes.transAxes)
    axes.set_axis_off()


def draw_profile(figure, spot, run):
    """v_x(y) of the last state: single disks and means of slices about 1.5 d_s thick."""
    axes = figure.add_subplot(spot)
    state = run.state
    if state is None or not abs(run.rate) > 0:
        return say(axes, "no state.h5 beside the result" if state is None else "at rest")
    height = state.box.height
    y = state.position[:, 1] / height
    rows = np.floor(y)
    velocity = state.velocity[:, 0] / (run.rate * height) - rows  # at the image inside the box
    y -= rows
    bins = int(np.clip(height / 1.5, 5, 60))
    which = np.minimum((y * bins).astype(int), bins - 1)
    count = np.bincount(which, minlength=bins)
    mean = np.bincount(which, velocity, minlength=bins) / np.maximum(count, 1)
    few = np.random.default_rng(0).permutation(len(y))[:4000]
    axes.plot(velocity[few], y[few], ".", ms=2.5 if len(y) > 1000 else 6, color=SKY, alpha=0.5,
              mew=0)
    axes.plot([0, 1], [0, 1], color="black", lw=1.0, ls=(0, (4, 2)), label="linear")
    middle = (np.arange(bins) + 0.5) / bins
    axes.plot(mean[count > 0], middle[count > 0], "o-", ms=3.2, color=BLUE, label="slices")
    low, high = np.percentile(velocity, [1, 99])
    axes.set_xlim(min(-0.05, 1.1 * low - 0.05), max(1.05, 1.1 * high))
    axes.set_ylim(0, 1)
    axes.set_xlabel(r"$v_x / (\dot\gamma L_y)$")
    axes.set_ylabel("$y / L_y$")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.1)


def with_images(position, diameter, tilt, length, height):
    """Indices and positions of all disks and of the images that overlap the cell."""
    index, places = [], []
    for row in (-1, 0, 1):
        for column in (-1, 0, 1):
            place = position + [column * length + row * tilt, row * height]
            along = place[:, 0] - tilt * place[:, 1] / height
            near = diameter * (0.5 + abs(tilt) / height)
            inside = ((place[:, 1] > -near) & (place[:, 1] < height + near)
                      & (along > -near) & (along < length + near))
            index.append(np.nonzero(inside)[0])
            places.append(place[inside])
    return np.concatenate(index), np.concatenate(places)


def draw_packing(figure, spot, run):
    axes = figure.add_subplot(spot)
    state = run.state
    if state is None:
        return say(axes, "no state.h5 beside the result")
    length, height = state.box.length, state.box.height
    tilt = state.box.tilt if state.box.tilt > -length / 2 else length / 2  # halfway it leans along the shear
    position, diameter = state.position.copy(), state.diameter
    rate = run.rate if np.isfinite(run.rate) else 0.0
    excess = (state.velocity[:, 0] - rate * position[:, 1]) / (rate or 1.0)  # in gammadot d_s
    rows = np.floor(position[:, 1] / height)
    position -= np.outer(rows, [tilt, height])
    position[:, 0] -= length * np.floor((position[:, 0] - tilt * position[:, 1] / height) / length)

    corners = np.array([[0, 0], [length, 0], [length + tilt, height], [tilt, height]])
    cell = Polygon(corners, closed=True, fill=False, ec="#222222", lw=1.0, zorder=5)
    axes.add_patch(cell)
    limit = np.percentile(np.abs(excess), 97) or 1.0
    extent = max(length + abs(tilt), height)
    if len(diameter) <= MOST_CIRCLES:
        index, places = with_images(position, diameter, tilt, length, height)
        size = diameter[index]
        coloured = EllipseCollection(
            size, size, 0, units="xy", offsets=places, transOffset=axes.transData,
            array=excess[index], cmap="PuOr", ec="#333333",
            lw=0.35 * min(1.0, THIN / extent) if len(diameter) <= 3000 else 0.0)
        axes.add_collection(coloured)
    else:
        coloured = excess_image(axes, position, excess, tilt, length, height)
    coloured.set_clim(-limit, limit)
    coloured.set_clip_path(cell)
    strongest = np.nan
    if len(diameter) <= MOST_CONTACTS:
        i, j, away, _ = pairs_within(position, state.box, diameter, 0.0)
        overlap = 1 - np.hypot(*away.T) / ((diameter[i] + diameter[j]) / 2)
        if len(overlap):
            segments = np.stack([position[i], position[i] - away], axis=1)
            strongest = overlap.max()
            copies = [(c * length + r * tilt, r * height) for r in (-1, 0, 1) for c in (-1, 0, 1)]
            drawn = np.concatenate([segments + np.array(shift) for shift in copies])
            width = 3.0 * THIN / extent * np.tile(overlap / strongest, len(copies))
            lines = LineCollection(drawn, linewidths=np.clip(width, 0.1, 4.0), colors="#000000",
                                   capstyle="round", zorder=4)
            axes.add_collection(lines)
            lines.set_clip_path(cell)
    edge = 0.02 * max(length, height)
    axes.set_xlim(min(0, tilt) - edge, length + max(0, tilt) + edge)
    axes.set_ylim(-edge, height + edge)
    axes.set_aspect("equal")
    axes.set_axis_off()
    bar = figure.colorbar(coloured, ax=axes, shrink=0.8, pad=0.02, extend="both", aspect=28)
    bar.set_label(r"$(v_x - \dot\gamma y) / (\dot\gamma d_s)$")
    bar.outline.set_visible(False)
    note = "last state" + (" of the first replica" if run.replicas > 1 else "")
    if np.isfinite(strongest):
        note += f"; lines: overlaps up to {strongest:.2g}"
    axes.set_title(note, fontsize=9, color="#333333")


def excess_image(axes, position, excess, tilt, length, height):
    """Mean excess velocity on a sheared grid, about 20 disks a cell."""
    def bins(along, across):
        return int(np.clip(np.sqrt(len(excess) / 20 * along / across), 20, 300))

    rest = np.stack([position[:, 0] - tilt * position[:, 1] / height, position[:, 1]])
    columns, rows = bins(length, height), bins(height, length)
    column = np.clip((rest[0] / length * columns).astype(int), 0, columns - 1)
    row = np.clip((rest[1] / height * rows).astype(int), 0, rows - 1)
    cell = row * columns + column
    count = np.bincount(cell, minlength=rows * columns)
    mean = np.bincount(cell, excess, minlength=rows * columns) / np.maximum(count, 1)
    x, y = np.meshgrid(np.linspace(0, length, columns + 1), np.linspace(0, height, rows + 1))
    return axes.pcolormesh(x + tilt * y / height, y, mean.reshape(rows, columns), cmap="PuOr",
                           rasterized=True)


# ---------------------------------------------------------------------------------------- the page


def passes_of(run):
    """[(cycle from 1, +1 up or -1 down, its windows)] of a ramp, in their order."""
    direction = run["direction"]
    ends = np.nonzero(np.diff(direction))[0] + 1
    found, cycle = [], 0
    for windows in np.split(np.arange(len(direction)), ends):
        way = direction[windows[0]] if len(windows) else 0
        cycle += bool(way > 0 or (way < 0 and not found))
        if way in (1, -1):
            found.append((cycle, int(way), windows))
    return found


def draw_loop(axes, run, name, label):
    """One quantity against the strain rate, a line a pass, one colour a cycle; as in P2 Fig. 31 up is filled and
    down open."""
    passes = passes_of(run)
    values = run.each[name] if name in run.each else run[name][None]
    shown = values[:, run["direction"] != 0]
    axes.set_xscale("log")
    axes.set_yscale(scale_of(shown[shown > 0]))
    for cycle, way, windows in passes:
        colour = colour_of(cycle - 1, passes[-1][0])
        every = max(1, len(windows) // 40)
        for row in values:
            axes.plot(run["strain_rate"][windows], np.where(row[windows] > 0, row[windows], np.nan),
                      ls="-" if way > 0 else DASHED, lw=1.0, marker="o", ms=3.2, mew=0.8, markevery=every,
                      color=colour, mfc=colour if way > 0 else "white", alpha=0.8 if len(values) == 1 else 0.5)
    axes.set_xlabel(r"strain rate $\dot\gamma\tau_e$")
    axes.set_ylabel(label)
    log_ticks(axes.xaxis)
    if axes.get_yscale() == "log":
        log_ticks(axes.yaxis)
    else:
        plain_ticks(axes.yaxis)


def name_passes(axes, run, others):
    """Names colours and lines of the loops, of many cycles the first and the last, and other lines."""
    cycles = passes_of(run)[-1][0]
    named = range(1, cycles + 1) if cycles <= len(COLOURS) else (1, cycles)
    handles = [Line2D([], [], color=colour_of(cycle - 1, cycles), label=f"cycle {cycle}") for cycle in named]
    for way, fill, text in (("-", "#444444", "up"), (DASHED, "white", "down")):
        handles.append(Line2D([], [], color="#444444", ls=way, marker="o", ms=3.2, mfc=fill, label=text))
    axes.legend(handles=[*handles, *others], loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=len(COLOURS) + 4, borderaxespad=0.1,
                handlelength=2.6, columnspacing=1.4)


def add_slope(axes, rate, values, slope, style):
    """A line of this slope through the middle of the values, as long as there is room."""
    good = np.isfinite(values) & (values > 0)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    x, y = (np.exp(np.mean(np.log(one[good]))) for one in (rate, values))
    ends = np.array([max(left, x * (low / y) ** (1 / slope)), min(right, x * (high / y) ** (1 / slope))])
    line, = axes.plot(ends, y * (ends / x) ** slope, color=GREY, lw=0.9, ls=style, zorder=0)
    axes.set_xlim(left, right)
    axes.set_ylim(low, high)
    return line


def add_slopes(axes, rate, stress):
    """Adds slopes of the stresses with the rate, for hard disks and where damping dominates, if both axes are
    logarithmic: lines with their names, for a legend."""
    if "linear" in (axes.get_xscale(), axes.get_yscale()):
        return []
    lines = [add_slope(axes, rate, stress, 2, DASHED), add_slope(axes, rate, stress, 1, DOTTED)]
    for line, name in zip(lines, (r"Bagnoldian, $\dot\gamma^2$", r"Newtonian, $\dot\gamma$")):
        line.set_label(name)
    return lines


def draw_ramp(run):
    """The hysteresis loops of a ramp."""
    figure = plt.figure(figsize=(15.5, 10.0))
    left = figure.add_gridspec(1, 1, left=0.075, right=0.47, bottom=0.07, top=0.86)
    right = figure.add_gridspec(2, 2, left=0.55, right=0.985, bottom=0.07, top=0.86, wspace=0.3,
                                hspace=0.24)
    main = figure.add_subplot(left[0])
    draw_loop(main, run, "sigma", with_unit(r"$\sigma$", "m/tau_e^2"))
    going = run["direction"] != 0
    name_passes(main, run, add_slopes(main, run["strain_rate"][going], run["sigma"][going]))
    for spot, name, label in ((right[0, 0], "B_p", "$B_p$"), (right[0, 1], "eta_p", r"$\eta_p$"),
                              (right[1, 0], "Z", "$Z$"), (right[1, 1], "R_v", "$R_v$")):
        draw_loop(figure.add_subplot(spot), run, name, label)
    add_heading(figure, run.about, scene_line(run.about, run.strain[-1], run.replicas, rates_of_ramp(run)),
                "a line a replica" if run.replicas > 1 else "")
    return figure


def rates_of_ramp(run):
    """Rates that it passes, and their numbers of passes."""
    rate, cycles = run["strain_rate"][np.isin(run["direction"], (1, -1))], passes_of(run)[-1][0]
    low, high = (power_of_ten(float(f"{one:.1g}")) for one in (rate.min(), rate.max()))
    return rf"$\dot\gamma\tau_e = ${low} to {high}, {cycles} cycle{'s' if cycles > 1 else ''}"


def draw(run):
    if "direction" in run.series and passes_of(run):
        return draw_ramp(run)
    figure = plt.figure(figsize=(15.5, 10.0))
    top = figure.add_gridspec(1, 3, left=0.085, right=0.985, bottom=0.585, top=0.875, wspace=0.24)
    bottom = figure.add_gridspec(1, 3, left=0.085, right=0.985, bottom=0.06, top=0.49,
                                 width_ratios=(4.2, 3.2, 6.6), wspace=0.2)
    draw_stress(figure, top[0], run)
    draw_stack(figure, top[1], run, [("mu", GREEN, r"$\mu$", False, None), ("Z", ORANGE, "$Z$", False, None)])
    draw_shares(figure, top[2], run)
    draw_stack(figure, bottom[0], run, [
        ("T_g", VERMILION, "$T_g$", True, None), ("R_v", BLUE, "$R_v$", True, 1.0),
        ("spin_mean", GREEN, r"$\langle\dot\theta\rangle/\dot\gamma$", False, -0.5)])
    draw_profile(figure, bottom[1], run)
    draw_packing(figure, bottom[2], run)
    add_heading(figure, run.about, scene_line(run.about, run.strain[-1], run.replicas), meaning_of_lines(run), 0.085)
    return figure
