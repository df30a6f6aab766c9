# SPDX-License-Identifier: BSD-3-Clause
"""An analysis, from its table PREFIX.drawn.csv.

The table says what each panel shows (columns panel, x_name, y_name, x_scale, y_scale, curve, what,
x, x_error, y, y_error): "data" are points, "fit" lines, "mark" a place found, with or without a
height.
"""

import csv

import numpy as np

from .labels import log_ticks
from .style import COLOURS, GREY, MARKERS, plt

MOST_NAMED = 16  # of more curves the first and last have a name

# As the axes of the papers are called.
LABELS = {
    "disks.elasticity": "$Q$", "disks.packing_fraction": r"$\phi$", "disks.count": "$N$",
    "shear.strain_rate": r"$\dot\gamma\tau_e$", "gammadot": r"$\dot\gamma\tau_e$",
    "phi_J-phi": r"$\phi_J - \phi$", "mu": r"$\mu = \sigma/p$", "I": r"$I = \dot\gamma/\sqrt{p/m_0}$",
    "Z": "$Z$", "R_v": r"$R_v = \langle\delta v_x^2\rangle/\langle v_y^2\rangle$",
    "Q_star": "$Q^*$", "q": "$q$", "Q": "$Q$", "phi": r"$\phi$", "exponent": "local exponent",
    "tau_dur": r"$\tau_{dur}/\tau_e$", "nu_coll": r"$\nu_{coll}$", "nu_end": r"$\nu_{end}$", "T_g": "$T_g$",
    "spin_mean": r"$\langle\dot\theta\rangle/\dot\gamma$",
    "spin_var": r"var$[\dot\theta/\dot\gamma]$",
}
STRESSES = {"p": "p", "sigma": r"\sigma", "delta_p": r"\delta p", "sigma_dev": r"\sigma_{dev}"}


def label(name):
    """Name of a quantity as in the papers; the name itself if they have none."""
    if name.startswith("difference of "):
        rest = name[len("difference of "):]
        above, _, below = rest.partition("/")
        symbol = label(above).strip("$")
        if below:
            bottom = label(below).strip("$")
            return rf"$({symbol}/{bottom})_1 - ({symbol}/{bottom})_2$"
        return rf"${{{symbol}}}_{{,1}} - {{{symbol}}}_{{,2}}$"
    if name in LABELS:
        return LABELS[name]
    if "/" in name:
        above, _, below = name.rpartition("/")
        return f"{label(above)} / {label(below)}"
    if "*" in name:
        return r"$\,$".join(label(part) for part in name.split("*"))
    base, _, part = name.rpartition("_") if name.endswith(("_el", "_dis", "_kin")) else (name, "", "")
    top = rf"^{{{part}}}" if part else ""
    if base in STRESSES:
        symbol = {"p": "P", "sigma": r"\Sigma"}.get(base, STRESSES[base])
        return f"${symbol}{top}$"
    for letter, symbol in (("B_", "B"), ("eta_", r"\eta")):
        if base.startswith(letter) and base[len(letter):] in STRESSES:
            return rf"${symbol}_{{{STRESSES[base[len(letter):]]}}}{top}$"
    stem, _, ending = name.rpartition("_")
    if stem in ("Q", "phi", "gammadot"):
        return rf"{label(stem)}$_{{{ending}}}$"
    return name


def read(path):
    """{panel: rows}, numbers as floats, empty ones NaN."""
    panels = {}
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            for key in ("x", "x_error", "y", "y_error"):
                row[key] = float(row[key]) if row[key] else np.nan
            panels.setdefault(row["panel"], []).append(row)
    if not panels:
        raise ValueError("nothing to draw")
    return list(panels.values())


def column(rows, key):
    return np.array([row[key] for row in rows])


def bars(values):
    """Lengths of error bars, None where there is none."""
    return np.nan_to_num(values) if (values > 0).any() else None


def draw_curve(axes, rows, colour, marker, name, solid=False, joined=None, size=4.2, line="-"):
    """Points, lines and marks of one curve. joined: a thin line through points without a fit; None: through
    three or more, as two far apart make no curve. line: of a fit."""
    of = {what: [row for row in rows if row["what"] == what] for what in ("data", "fit", "mark")}
    joined = len(of["data"]) > 2 if joined is None else joined
    if of["data"]:
        axes.errorbar(column(of["data"], "x"), column(of["data"], "y"),
                      xerr=bars(column(of["data"], "x_error")),
                      yerr=bars(column(of["data"], "y_error")), fmt=marker, ms=size,
                      mfc=colour if solid else "white",
                      color=colour, ls="none" if of["fit"] or not joined else "-", lw=0.5, elinewidth=0.9,
                      capsize=1.5, label=name, zorder=3)
    if of["fit"]:
        x, y = column(of["fit"], "x"), column(of["fit"], "y")
        for piece in np.split(np.arange(len(x)), np.nonzero(np.diff(x) < 0)[0] + 1):
            axes.plot(x[piece], y[piece], color=colour, lw=1.2, ls=line, zorder=2)
    for row in of["mark"]:
        if np.isfinite(row["y"]):
            axes.plot(row["x"], row["y"], "s", ms=9, mfc="none", color=colour, zorder=4)
        elif np.isfinite(row["x"]):
            axes.axvline(row["x"], color=colour, lw=0.9, ls=(0, (4, 3)), zorder=1)


def keep_in_view(axes, rows):
    """Sets limits from the points and their error bars, without bars longer than the range of all points, and from
    marks that are no further away than that."""
    data = [row for row in rows if row["what"] == "data"]
    marks = [row for row in rows if row["what"] == "mark"]
    for name in ("x", "y"):
        log = getattr(axes, f"get_{name}scale")() == "log"
        values, errors = column(data, name), np.nan_to_num(column(data, f"{name}_error"))
        good = np.isfinite(values) & ((values > 0) | (not log))
        if not good.any():
            continue
        values, errors = values[good], errors[good]
        scale, back = (np.log10, lambda v: 10.0**v) if log else ((lambda v: v), (lambda v: v))
        low, high = scale(values.min()), scale(values.max())
        width = high - low or 0.1 * abs(high) or 0.1
        places = column(marks, name)
        ends = np.concatenate([values - errors, values + errors, places[np.isfinite(places)]])
        ends = scale(ends[(ends > 0) | (not log)])
        low = max(low - width, min(low, ends.min()))
        high = min(high + width, max(high, ends.max()))
        room = 0.06 * (high - low or width)
        getattr(axes, f"set_{name}lim")(back(low - room), back(high + room))


def draw_panel(axes, rows):
    for name in ("x", "y"):
        values = column(rows, name)
        if rows[0][f"{name}_scale"] == "log" and (values[np.isfinite(values)] > 0).any():
            getattr(axes, f"set_{name}scale")("log")
    names = list(dict.fromkeys(row["curve"] for row in rows))
    many = len(names) > len(COLOURS)
    for i, name in enumerate(names):
        colour = plt.cm.viridis(0.92 * i / (len(names) - 1)) if many else COLOURS[i]
        shown = name and (len(names) <= MOST_NAMED or i in (0, len(names) - 1))
        if name == "phi_J":
            colour = GREY
        draw_curve(axes, [row for row in rows if row["curve"] == name], colour,
                   MARKERS[i % len(MARKERS)], pretty(name) if shown else None)
    keep_in_view(axes, rows)
    marks = [row["x"] for row in rows if row["curve"] == "phi_J"]
    if marks:
        low, high = axes.get_xlim()
        axes.set_xlim(low, max(high, max(marks) + 0.03 * (high - low)))
        axes.annotate(r"$\phi_J$", (max(marks), 0.02), (4, 0), xycoords=("data", "axes fraction"),
                      textcoords="offset points", color=GREY)
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":
            log_ticks(axis)
    axes.set_xlabel(label(rows[0]["x_name"]))
    axes.set_ylabel(label(rows[0]["y_name"]))
    if axes.get_legend_handles_labels()[1]:
        axes.legend(ncols=1 if len(names) < 7 else 2)


def with_four_digits(value):
    """A number of many digits with four: names of curves tell them apart."""
    try:
        return f"{float(value):.4g}" if len(value) > 8 else value
    except ValueError:
        return value


def pretty(name):
    """"phi = 0.8, Q = 10" with the letters of the papers."""
    parts = []
    for part in name.split(", "):
        key, _, value = part.partition(" = ")
        parts.append(f"{label(key)} = {with_four_digits(value)}" if value else label(part))
    return ", ".join(parts)


def draw(panels):
    columns = min(3, len(panels))
    lines = -(-len(panels) // columns)
    figure, grid = plt.subplots(lines, columns, figsize=(5.2 * columns, 4.2 * lines),
                                squeeze=False, layout="constrained")
    for axes, rows in zip(grid.flat, panels):
        draw_panel(axes, rows)
    for axes in grid.flat[len(panels):]:
        axes.set_axis_off()
    return figure
