# SPDX-License-Identifier: BSD-3-Clause
"""A sweep or a cascade at first sight: observables against the key that varies most, a curve for the others.

Against the rate it is a flow curve.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from .labels import KEYS, add_heading, log_ticks, plain_ticks, scale_of, scene_line, symbol_of, with_unit
from .run_page import add_slopes
from .style import MARKERS, colour_of, plt

RATE = "shear.strain_rate"
PREFERRED = (RATE, "disks.elasticity", "disks.packing_fraction", "disks.count")  # of keys with as many values
SYMBOLS = {"sigma": (r"$\sigma$", "m/tau_e^2"), "p": ("$p$", "m/tau_e^2"), "B_p": ("$B_p$", ""),
           "B_sigma": (r"$B_\sigma$", ""), "eta_p": (r"$\eta_p$", ""), "eta_sigma": (r"$\eta_\sigma$", ""),
           "G_storage": ("$G'$", "m/tau_e^2"), "G_loss": ("$G''$", "m/tau_e^2"),
           "mu": (r"$\mu = \sigma/p$", ""), "Z": ("$Z$", ""), "T_g": ("$T_g$", "m d_s^2/tau_e^2")}
PANELS = {True: ("sigma", "p", "B_p", "eta_p", "mu", "Z"), False: ("p", "sigma", "B_p", "mu", "Z", "T_g")}
OF_CYCLES = ("G_storage", "G_loss", "p", "Z", "T_g")  # of oscillations
OF_PHYSICS = ("protocol", "strain_rate", "ramp_rate", "strain_rate_high", "pieces", "amplitude", "period", "peak_rate",
              "stress", "box_inertia", "pressure", "inertial_number", "response")  # of shear, as in `bagnold analyse`
MOST_NAMED = 12  # of more curves the first and last have a name
NAMES_A_LINE = 6


@dataclass(frozen=True)
class Curve:
    """Points of equal values of all keys but the running one and the seed."""

    name: str
    rows: list  #: of rows of the sweep, one list for each x
    x: np.ndarray


def key_along(sweep):
    """The key with most values: of those with numbers, else of those with texts, else the seed. Raises InputError
    where the sweep has none."""
    counts = {key: len(set(values)) for key, values in sweep.varied.items()}
    numbers = {key for key, values in sweep.varied.items() if values.dtype.kind == "f" and counts[key] > 1}
    for among in (numbers - {"disks.seed"}, set(counts) - {"disks.seed"}, set(counts)):
        if among:
            return max([key for key in (*PREFERRED, *counts) if key in among], key=counts.get)
    raise InputError(f"{sweep.folder}: no key varies, there is nothing to draw against")


def places_along(sweep, along):
    """Abscissae of points: their numbers; for texts their index, from 0."""
    values = sweep.varied[along]
    if values.dtype.kind == "f":
        return values
    names = list(dict.fromkeys(values))
    return np.array([float(names.index(value)) for value in values])


def is_physics(key):
    """Whether other values of a key are another flow, as `bagnold analyse` has it."""
    table, _, name = key.partition(".")
    return name in OF_PHYSICS if table == "shear" else table in ("disks", "drive") and key != "disks.replicas"


def follows(sweep, key, along):
    """Whether a key has one value for each value of `along`, and, if physical, the other way round: packing fractions
    each at elasticities of their own are curves. Models never follow."""
    values, places = sweep.varied[key], sweep.varied[along]
    pairs = len(set(zip(values, places)))
    if pairs > len(set(places)):
        return False
    return not is_physics(key) or (values.dtype.kind == "f" and pairs == len(set(values)))


def curves_of(sweep, along):
    """In the order of the sweep's file. A key that follows from `along` tells none apart."""
    others = [key for key in sweep.varied if key not in (along, "disks.seed") and len(set(sweep.varied[key])) > 1
              and not follows(sweep, key, along)]
    groups = {}
    for row in range(len(sweep)):
        groups.setdefault(tuple(sweep.varied[key][row] for key in others), []).append(row)
    curves = []
    for values, rows in groups.items():
        places = places_along(sweep, along)[rows]
        x = np.unique(places)
        name = ", ".join(symbol_of(key, value) for key, value in zip(others, values))
        curves.append(Curve(name, [[row for row, at in zip(rows, places) if at == one] for one in x], x))
    return curves


def merged(sweep, name, rows):
    """Mean over seeds and its standard error: for two seeds by their own errors if they have them, otherwise by the
    scatter. Runs with few collisions are left out beside others, and where nothing happened in them."""
    met = [row for row in rows if "few_collisions" not in sweep[int(row)].warnings]
    rows = met or [row for row in rows if sweep.error(name)[row] != 0]
    values, errors = sweep[name][rows], sweep.error(name)[rows]
    values, errors = values[np.isfinite(values)], errors[np.isfinite(values)]
    if not len(values):
        return np.nan, np.nan
    if len(values) == 1 or (len(values) == 2 and np.isfinite(errors).all()):
        return values.mean(), np.sqrt(np.sum(errors**2)) / len(values)
    return values.mean(), values.std(ddof=1) / np.sqrt(len(values))


def draw_panel(axes, sweep, name, along, curves):
    """One observable, points with errors where they are known."""
    drawn = []
    for k, curve in enumerate(curves):
        found = np.array([merged(sweep, name, rows) for rows in curve.rows])
        colour, error = colour_of(k, len(curves)), np.nan_to_num(found[:, 1])
        axes.errorbar(curve.x, found[:, 0], error if error.any() else None, fmt=MARKERS[k % len(MARKERS)] + "-", ms=4,
                      lw=0.9, elinewidth=0.9, capsize=2, color=colour, mfc="white", label=curve.name)
        drawn.append(np.stack([curve.x, found[:, 0]]))
    x, y = np.concatenate(drawn, axis=1)
    for axis, values in (("x", x), ("y", y)):
        getattr(axes, f"set_{axis}scale")(scale_of(values))
    finish(axes, along, name)
    if sweep.varied[along].dtype.kind != "f":
        axes.set_xscale("linear")
        axes.set_xticks(np.unique(x), dict.fromkeys(sweep.varied[along]))
    return x, y


def finish(axes, along, name):
    """Labels with units, ticks that can be read."""
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":
            log_ticks(axis)
        else:
            plain_ticks(axis)
    symbol = f"${KEYS[along]}$" if along in KEYS else along
    axes.set_xlabel(f"strain rate {symbol}" if along == RATE else symbol)
    axes.set_ylabel(with_unit(*SYMBOLS[name]))


def name_curves(figure, axes, curves, height):
    """Names the curves above all panels."""
    drawn = dict(zip(*reversed(axes.get_legend_handles_labels())))
    names = [curve.name for curve in curves if curve.name]
    names = names if len(names) <= MOST_NAMED else [names[0], names[-1]]
    if names:
        figure.legend([drawn[name] for name in names], names, loc="upper left", ncol=NAMES_A_LINE,
                      bbox_to_anchor=(0.065, 1 - 0.95 / height), columnspacing=1.4)


def common(sweep, along):
    """Values common to all points, by the names of a result's attributes."""
    def shared(key):
        found = {str(point.scene.get(key)): point.scene.get(key) for point in sweep}
        return next(iter(found.values())) if len(found) == 1 else None

    names = {"model": "disks.model", "mass": "disks.mass", "count": "disks.count", "elasticity": "disks.elasticity",
             "packing_fraction": "disks.packing_fraction", "strain_rate": RATE, "title": "title",
             "replicas": "disks.replicas"}
    found = {name: shared(key) for name, key in names.items() if key != along and key not in sweep.varied}
    return {name: value for name, value in found.items() if value is not None}


def provenance(sweep):
    """Version and git of the first point that has a result."""
    for point in sweep:
        if (point.folder / "result.h5").exists():
            about = point.load().about
            return {name: about[name] for name in ("bagnold_version", "git") if name in about}
    return {}


def draw(sweep):
    """Six panels of what the points have. Raises InputError where there is nothing."""
    points = sweep
    if not sweep.names and hasattr(sweep, "pieces"):
        sweep = sweep.pieces
    along = key_along(sweep)
    names = [name for name in (OF_CYCLES if "G_storage" in sweep.names else PANELS[along == RATE]) if name in sweep.names and np.isfinite(sweep[name]).any()]
    if not names:
        raise InputError(f"{sweep.folder}: none of its points is done")
    columns = min(3, len(names))
    lines = -(-len(names) // columns)
    curves = curves_of(sweep, along)
    named = 0.3 * -(-min(len(curves), MOST_NAMED) // NAMES_A_LINE) if curves[0].name else 0.0
    height = 1.75 + named + 3.6 * lines
    figure, grid = plt.subplots(lines, columns, figsize=(5.1 * columns, height), squeeze=False)
    figure.subplots_adjust(left=0.07, right=0.985, bottom=0.6 / height, top=1 - (1.3 + named) / height, hspace=0.28,
                           wspace=0.32)
    for axes, name in zip(grid.flat, names):
        x, y = draw_panel(axes, sweep, name, along, curves)
        if along == RATE and name == "sigma" and (slopes := add_slopes(axes, x, y)):
            axes.legend(handles=slopes, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.1)
    for axes in grid.flat[len(names):]:
        axes.set_axis_off()
    name_curves(figure, grid[0, 0], curves, height)
    about = common(sweep, along)
    done = sum(point.status == "done" for point in points)
    add_heading(figure, {**provenance(sweep), **about, "title": about.get("title") or sweep.folder.resolve().name},
                scene_line(about, replicas=about.get("replicas", 1)), f"{done} of {len(points)} points", 0.07, height)
    return figure
