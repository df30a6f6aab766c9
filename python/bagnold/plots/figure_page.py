# SPDX-License-Identifier: BSD-3-Clause
"""A figure of the papers, from its recipe.json.

The recipe is what `bagnold figure` made of inputs/figures/figures.toml (docs/figures.md): panels, each
with its kind, and where its data lie, relative to the recipe. A kind of panel is a function in PANELS.
"""

import json
import os
import sys
import textwrap

import numpy as np

from .analysis_page import LABELS, draw_curve, keep_in_view, label, pretty, read
from .figure_data import band_edges, histogram, points_of, principal_axes, profile, together
from .style import BLUE, COLOURS, DASHED, GREY, MARKERS, VERMILION, colour_of, plt, save

from matplotlib.collections import EllipseCollection

SHORT = {"disks.elasticity": "Q", "disks.packing_fraction": "phi", "shear.strain_rate": "gammadot",
         "disks.count": "N", "disks.model": "disks.model"}
NAMES = {  # of curves of places that an analysis finds, as the papers call them
    "phi_up": "phi_B", "phi_1": "phi_B", "phi_down": "phi_N", "phi_2": "phi_N", "Q_down": ""}
MAPS = {  # what may be done to y, and its derivative
    "abs": (np.abs, np.sign),
    "minus": (np.negative, lambda y: -np.ones_like(y)),
    "double": (lambda y: 2 * y, lambda y: 2 * np.ones_like(y)),
    "hypotenuse - 1": (lambda y: np.hypot(y, 1) - 1, lambda y: y / np.hypot(y, 1)),  # P1 Eq. (25)
}


def curve_name(keys, values):
    text = ", ".join(f"{SHORT.get(key, key)} = {value:g}" if isinstance(value, float) else
                     f"{SHORT.get(key, key)} = {value}" for key, value in zip(keys, values))
    return pretty(text) if text else None


def name_of(curve):
    """Name of a curve of an analysis, for a legend."""
    first, comma, rest = curve.partition(", ")
    return pretty(NAMES[first] + comma + rest) if first in NAMES else pretty(curve)


def curves_in(rows):
    """Names of curves in their order, or in that of their numbers if these are not monotonic: data of several
    sweeps."""
    names = list(dict.fromkeys(row["curve"] for row in rows))
    parts = [name.rpartition(" = ") for name in names]
    try:
        numbers = [float(number) for _, _, number in parts]
    except ValueError:
        return names
    steps = np.diff(numbers)
    if len({start for start, _, _ in parts}) > 1 or (steps > 0).all() or (steps < 0).all():
        return names
    return [name for _, name in sorted(zip(numbers, names))]


def say(axes, text):
    """Writes into a panel that there is nothing to draw."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY)
    axes.set(xticks=[], yticks=[])


# -------------------------------------------------------------------------------- kinds of panels


def draw_analysis(axes, panel, _):
    """Draws results of `bagnold analyse`: points with errors, fits, marks."""
    rows = panel["rows"]
    if not rows:
        return
    change, slope = MAPS[panel["map"]] if "map" in panel else (None, None)
    for row in rows if change else []:
        if row["what"] != "mark":
            row["y_error"] = row["y_error"] * abs(slope(row["y"]))
            row["y"] = float(change(row["y"]))
    for name in "xy":
        if name in panel.get("log", "".join(n for n in "xy" if rows[0][f"{n}_scale"] == "log")):
            getattr(axes, f"set_{name}scale")("log", nonpositive="mask")
    rows = [row for row in rows if row["what"] in panel.get("only", row["what"])]
    names, before = curves_in(rows), curves_in(panel["before"])
    alike = len(names) > 1 and set(names) <= set(before)  # the curves of the panel before, of another quantity
    for k, name in enumerate(names):
        curve = [row | ({"y": np.nan} if panel.get("upright") and row["what"] == "mark" else {})
                 for row in rows if row["curve"] == name]
        if name == "phi_J":
            continue
        text = ", ".join(filter(None, (panel.get("name"), name_of(name))))
        place = k if len(names) > 1 else panel["number"]  # single curves over others are told apart
        place = before.index(name) if alike else place
        colour = colour_of(place, max(len(before if alike else names), place + 1))
        if panel.get("only") == ["fit"]:
            colour = "black"
        draw_curve(axes, curve, colour, panel.get("marker", MARKERS[place % len(MARKERS)]),
                   text or None, solid=panel.get("over", False), joined=panel.get("joined"),
                   size=panel.get("size", 4.2), line=DASHED if panel.get("dashed") else "-")
        if panel.get("slope"):
            write_slope(axes, curve, panel["slope"])
    if panel.get("join"):
        join_marks(axes, rows)
    if panel.get("end_point"):
        mark_end_point(axes, rows)
    if not panel.get("over"):
        axes.set_xlabel(label(rows[0]["x_name"]))
        axes.set_ylabel(label(rows[0]["y_name"]))


def write_slope(axes, rows, where):
    """The size of the slope of a fitted power law, "above" or "below" the middle of its line."""
    fit = [(row["x"], row["y"]) for row in rows if row["what"] == "fit"]
    if fit:
        slope = np.polyfit(*np.log(fit).T, 1)[0]
        up = 1 if where == "above" else -1
        right = up if slope < 0 else -up
        axes.annotate(f"{abs(slope):.1f}", fit[len(fit) // 2], (4 * right, 4 * up), textcoords="offset points",
                      fontsize=9, ha="left" if right > 0 else "right", va="bottom" if up > 0 else "top")


def join_marks(axes, rows):
    """Dashed lines through the first marks of all curves, through the second, ...: P2 Fig. 22. A mark that was
    not found has its row too."""
    marks = {}
    for row in rows:
        if row["what"] == "mark":
            marks.setdefault(row["curve"], []).append((row["x"], row["y"]))
    for places in zip(*marks.values()):
        places = [place for place in places if np.isfinite(place[0])]
        if places:
            axes.plot(*np.transpose(places), color="black", ls=DASHED, lw=0.9, zorder=2)


def places_of(rows, endings):
    """{gammadot: phi} of a boundary that an analysis found; it is called phi_up (of a jump) or phi_1
    (of a kink) where the region begins, phi_down or phi_2 where it ends."""
    return {row["y"]: row["x"] for row in rows
            if row["curve"].split(",")[0] in [f"phi_{ending}" for ending in endings]}


BEGIN, END = ("up", "1"), ("down", "2")


def mark_end_point(axes, rows):
    """"*" above the largest rate at which a region begins and ends: its end lies there or beyond (as
    schematic as in P2 Fig. 25)."""
    begin, end = places_of(rows, BEGIN), places_of(rows, END)
    both = [rate for rate in begin if rate in end]
    if both:
        axes.plot((begin[max(both)] + end[max(both)]) / 2, 1.4 * max(both), "*", ms=11, color="black")


def draw_arrows(axes, panel, _):
    """Arrows on the axis at the places (Q*, as `y`) that an analysis found for the curves of the panel
    before, in their colours: P1 Fig. 13b."""
    names = curves_in(panel["before"])
    for row in panel["rows"]:
        name = f"phi = {row['x']:g}"
        if name in names:
            axes.annotate("", (row["y"], 0.0), (row["y"], 0.09), xycoords=("data", "axes fraction"),
                          arrowprops={"color": colour_of(names.index(name), len(names)),
                                      "arrowstyle": "-|>"})


def draw_histogram(axes, panel, points):
    """Densities of /histograms/NAME, or with `at` the density there against `x`."""
    keys = panel.get("curve", [])
    if "at" in panel:
        return draw_density_at(axes, panel, points, keys)
    groups = together(points, keys)
    for k, (values, group) in enumerate(sorted(groups.items())):
        edges, density, error = histogram(group, panel["histogram"])
        middle = (edges[1:] + edges[:-1]) / 2
        colour = colour_of(k, len(groups))
        axes.step(middle, density, where="mid", color=colour, lw=1.2, label=curve_name(keys, values))
        if np.isfinite(error).any():
            axes.fill_between(middle, density - error, density + error, step="mid", color=colour,
                              alpha=0.25, lw=0)
        if panel.get("law") == "|cos|":  # a density per degree: its integral over 360 degrees is 1
            axes.plot(middle, np.abs(np.cos(np.radians(middle))) * np.pi / 720, ":", color="black",
                      label=r"$|\cos\vartheta|$", zorder=4)
    axes.set_ylabel(r"$\mathcal{P}(\vartheta)$  [1/degree]")
    axes.set_xlabel(r"$\vartheta$  [degrees]")
    if panel["histogram"].startswith("theta"):
        axes.set_xticks(range(-180, 181, 90))


def draw_density_at(axes, panel, points, keys):
    x_key = panel["x"]
    for k, (values, group) in enumerate(sorted(together(points, keys).items())):
        rows = []
        for (x,), seeds in sorted(together(group, [x_key]).items()):
            edges, density, error = histogram(seeds, panel["histogram"])
            bin_ = int(np.searchsorted(edges, panel["at"])) - 1
            rows.append((x, density[bin_], error[bin_]))
        x, y, error = np.array(rows).T
        axes.errorbar(x, y, np.nan_to_num(error), fmt=MARKERS[k] + "-", ms=4.2, mfc="white", lw=0.7,
                      color=COLOURS[k % len(COLOURS)], label=curve_name(keys, values))
    axes.set_xscale("log")
    axes.set_xlabel(label(x_key))
    axes.set_ylabel(rf"$\mathcal{{P}}(\vartheta = {panel['at']:g}\degree)$  [1/degree]")


def draw_profile(axes, panel, points):
    """/profiles/NAME against y; `level`: the key whose value the whole box has."""
    keys = panel.get("curve", [])
    groups = together(points, keys)
    for k, (values, group) in enumerate(sorted(groups.items())):
        y, value, error = profile(group, panel["profile"])
        axes.errorbar(y, value, np.nan_to_num(error), fmt="-", color=colour_of(k, len(groups)),
                      elinewidth=0.7, label=curve_name(keys, values))
        if "level" in panel:
            level = group[0].scene[panel["level"]]
            axes.axhline(level, color=GREY, lw=0.9, ls=DASHED)
            for place in band_edges(y, value, level):
                axes.axvline(place, color=GREY, lw=0.9, ls=DASHED)
    axes.set_xlabel("$y/d_s$")
    axes.set_ylabel({"v_x": r"$v_x\tau_e/d_s$", "gammadot": r"$\dot\gamma(y)\tau_e$",
                     "phi": r"$\phi(y)$"}.get(panel["profile"].removesuffix("_aligned")))


def draw_field(axes, panel, points):
    """Disks in grey by the local `field`, small values dark: P2 Fig. 27."""
    columns = points[0].columns("samples/fields")
    value = columns[panel["field"]]
    length = points[0].columns("samples/fields_frame")["box_length"][0]
    height = points[0].scene.get("disks.box_aspect", 1) * length
    disks = EllipseCollection(columns["diameter"], columns["diameter"], 0, units="xy", cmap="gray",
                              offsets=np.stack([columns["x"], columns["y"]], axis=1),
                              transOffset=axes.transData, array=value, lw=0)
    disks.set_clim(*np.nanpercentile(value, [2, 98]))
    axes.add_collection(disks)
    axes.figure.colorbar(disks, ax=axes, shrink=0.8, extend="both").outline.set_visible(False)
    axes.set(xlim=(0, length), ylim=(0, height), aspect="equal", xlabel="$x/d_s$", ylabel="$y/d_s$")


VELOCITIES = {"V_T": "$V_{ij,T}$", "V_R": "$V^R_{ij}$", "V_C_T": "$V^C_{ij,T}$", "V_N": "$V_{ij,N}$"}


def draw_scatter(axes, panel, points):
    """Two columns of `samples` of all points; mean (white) and principal axes (dotted): P2 Fig. 21."""
    parts = [point.columns(panel["samples"]) for point in points]
    x, y = (np.concatenate([part[panel[name]] for part in parts]) for name in ("x", "y"))
    axes.plot(x, y, ".", ms=2.6, mew=0, color=BLUE, alpha=0.45)
    (x0, y0), directions = principal_axes(x, y)
    half = np.percentile(np.abs(np.concatenate([x - x0, y - y0])), 99)
    for _, (dx, dy) in directions:
        axes.plot(x0 + np.array([-2, 2]) * half * dx, y0 + np.array([-2, 2]) * half * dy, ":",
                  color="black", lw=1.1)
    axes.plot(x0, y0, "o", ms=5, mfc="white", mec="black", mew=0.8, zorder=4)
    (_, (dx, dy)), _ = directions
    axes.set_title(f"major axis: slope {dy / dx:.2f}\ncorrelation {np.corrcoef(x, y)[0, 1]:.2f}", fontsize=7,
                   loc="right")
    axes.set(xlim=(x0 - half, x0 + half), ylim=(y0 - half, y0 + half), aspect="equal",
             xlabel=VELOCITIES.get(panel["x"], panel["x"]),
             ylabel=VELOCITIES.get(panel["y"], panel["y"]))


def draw_loop(axes, panel, points):
    """A series of ramps against the strain rate: solid going up, open coming down (P2 Fig. 31)."""
    every, name = panel.get("every", 1), panel.get("series", "sigma")
    for k, point in enumerate(points):
        series = {key: np.atleast_2d(point.read(f"series/{key}"))
                  for key in (name, "strain_rate", "direction")}
        for up, fill, text in ((1, None, "up"), (-1, "white", "down")):
            for row in range(len(series[name])):
                chosen = series["direction"][row] == up
                axes.plot(series["strain_rate"][row][chosen][::every],
                          series[name][row][chosen][::every], MARKERS[k % len(MARKERS)], ms=3.4,
                          mfc=fill, mew=0.7, color=COLOURS[k % len(COLOURS)],
                          label=text if k == 0 and row == 0 else None)
    axes.set(xscale="log", yscale="log")
    axes.set_xlabel(LABELS["shear.strain_rate"])
    axes.set_ylabel(label(name))


def mark_boundary(axes, name, points, k, panel):
    axes.plot(*points.T, panel.get("marker", MARKERS[k]) + ("-" if panel.get("joined", True) else ""),
              color=(BLUE, VERMILION)[k], ms=5, mfc="white",
              label=", ".join(filter(None, (panel.get("name"), name))))


def draw_boundary(axes, panel, _):
    """Draws a boundary phi(gammadot), found by an analysis, in other quantities: `at` are the two of the axes, each of
    the sweep's curves against phi taken at the boundary. P2 Figs. 26, 29."""
    ends = []
    for k, endings in enumerate((BEGIN, END)):
        found = []
        for rate, place in places_of(panel["rows"], endings).items():
            pair = []
            for name in panel["at"]:
                curve = [row for row in panel["of"].get(name, []) if row["curve"] == f"gammadot = {rate:g}"]
                if name == "gammadot":
                    pair.append(rate)
                elif curve:
                    phi, value = np.array([(row["x"], row["y"]) for row in curve]).T
                    pair.append(np.exp(np.interp(place, phi, np.log(value))))
            if len(pair) == 2:
                found.append(pair)
        if found:
            mark_boundary(axes, (r"$\phi_B$", r"$\phi_N$")[k], np.array(found), k, panel)
            ends.append(max(found, key=max))
    if panel.get("end_point") and len(ends) == 2:
        axes.plot(*np.sqrt(np.prod(ends, axis=0)), "*", ms=11, color="black")
    axes.set(xscale="log", yscale="log")
    axes.set_xlabel(label(panel["at"][0]))
    axes.set_ylabel(label(panel["at"][1]))


PANELS = {"analyse": draw_analysis, "histogram": draw_histogram, "profile": draw_profile,
          "field": draw_field, "samples": draw_scatter, "series": draw_loop,
          "at": draw_boundary, "arrows": draw_arrows}


# ----------------------------------------------------------------------------------------- layout


def kind_of(panel):
    """Kind of a panel, by its key."""
    for key in ("histogram", "profile", "field", "samples", "series", "at", "arrows", "analyse"):
        if key in panel:
            return key
    raise ValueError(f"a panel has none of {', '.join(PANELS)}")


def tables_of(path):
    """Panels of an analysis; none if it found nothing."""
    with open(path, encoding="utf-8") as file:
        return read(path) if file.read(1).strip() else []


def load(panel, folder):
    """Reads the files beside the recipe: tables of analyses, the points of a sweep."""
    if "drawn" in panel:
        tables = tables_of(os.path.join(folder, panel["drawn"]))
        show = panel.get("show", 1)
        panel["rows"] = tables[show - 1] if len(tables) >= show else []
    if "of_drawn" in panel:
        tables = {name: tables_of(os.path.join(folder, path))
                  for name, path in panel["of_drawn"].items()}
        panel["of"] = {name: table[0] for name, table in tables.items() if table}
    if "analyse" in panel:
        return []
    points = points_of([os.path.join(folder, source) for source in panel["folder"]],
                       panel.get("where", {}))
    if not points:
        print(f"no point of {', '.join(panel['folder'])} has {panel.get('where')}", file=sys.stderr)
    return points


def height_at(rows, x):
    """The largest y of the points nearest to x; 1 where there are none."""
    data = [row for row in rows if row["what"] == "data"]
    nearest = min((row["x"] for row in data), key=lambda at: abs(np.log(at / x)), default=x)
    return max((row["y"] for row in data if row["x"] == nearest), default=1.0)


def finish(axes, panel, rows):
    """Adds the options of all panels: scales, limits, lines, texts."""
    if rows:
        keep_in_view(axes, rows)
    for x in panel.get("vertical", []):
        axes.axvline(x, color=GREY, lw=0.9, ls=DASHED, zorder=0)
        low, high = axes.get_xlim()
        if axes.get_xscale() == "linear" and high < x < high + (high - low) / 2:  # jamming
            axes.set_xlim(low, x + 0.03 * (high - low))
    for y in panel.get("horizontal", []):
        axes.axhline(y, color=GREY, lw=0.9, ls=DASHED, zorder=0)
    for x0, y0, x1, slope, text in panel.get("slopes", []):
        x = np.array([x0, x1])
        if y0 == "above":
            y0 = 1.7 * height_at(rows, x0)
        axes.plot(x, y0 * (x / x0) ** slope, color="black", lw=1.0)
        axes.annotate(text, (x1, y0 * (x1 / x0) ** slope), (3, 2), textcoords="offset points",
                      fontsize=9)
    for name in "xy":
        if f"{name}_range" in panel:
            getattr(axes, f"set_{name}lim")(*panel[f"{name}_range"])
        if f"{name}_label" in panel:
            getattr(axes, f"set_{name}label")(panel[f"{name}_label"])
    axes.set_title(panel.get("title", ""))


MANY = 6  # names in a legend, beyond which it stands beside its panel


def add_legends(grid, panels):
    """Places legends inside if there is room; long ones to the right of their panel, once for neighbours with the same
    names. panels: of each axes. Returns True if one is beside the last column."""
    beside = False
    for line in grid:
        asked = False
        for k, axes in enumerate(line):
            handles, names = axes.get_legend_handles_labels()
            panel = panels.get(axes, {})
            asked = bool(names) and (asked or panel.get("legend", True))
            if not asked:
                continue
            if len(names) <= MANY:
                axes.legend(handles, names, fontsize=8, loc=panel.get("legend_at", "best"))
            elif k + 1 < len(line) and line[k + 1].get_legend_handles_labels()[1] == names:
                continue
            else:
                axes.legend(handles, names, fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0))
                beside |= k + 1 == len(line)
            asked = False
    return beside


def draw(recipe, folder):
    own = [panel for panel in recipe["panel"] if not panel.get("over")]
    columns = recipe.get("columns", min(2, len(own)))
    lines = -(-len(own) // columns)
    width, height = recipe.get("panel_size", [4.6, 3.7])
    figure, grid = plt.subplots(lines, columns, squeeze=False, layout="constrained",
                                figsize=(width * columns, height * lines + 0.4))
    places, axes, shown, group, number, groups = list(grid.flat), None, [], {}, 0, {}
    for k, panel in enumerate(recipe["panel"]):
        points = load(panel, folder)
        if not panel.get("over"):
            axes, shown, group = places.pop(0), [], {}
        kind = kind_of(panel)
        group |= panel
        number = number + 1 if panel.get("over") else 0  # on this axes
        panel |= {"before": shown, "number": number}
        if points or kind in ("analyse", "at", "arrows"):
            PANELS[kind](axes, panel, points)
        else:
            group["nothing"] = "no data yet"
        if kind == "analyse":
            shown = shown + [row for row in panel["rows"] if row["what"] in panel.get("only", row["what"])]
        if k + 1 == len(recipe["panel"]) or not recipe["panel"][k + 1].get("over"):
            if not axes.has_data():
                say(axes, group.get("nothing") or f"nothing found: {group['analyse'].split()[0]}")
            finish(axes, group, shown)
            groups[axes] = group
    for axes in places:
        axes.set_axis_off()
    if add_legends(grid, groups):
        width += 1.1 / columns
        figure.set_figwidth(width * columns)
    title = textwrap.fill(f"{recipe['name']}  {recipe.get('title', '')}", int(11 * width * columns))
    figure.suptitle(title, x=0.01, ha="left", fontsize=11, weight="bold")
    if "remark" in recipe:
        figure.supxlabel(textwrap.fill(recipe["remark"], int(14 * width * columns)), x=0.01, ha="left", fontsize=8)
    return figure


def draw_to(source, target):
    with open(source, encoding="utf-8") as file:
        recipe = json.load(file)
    save(draw(recipe, os.path.dirname(os.path.abspath(source))), target, recipe.get("dpi", 160), 160)
