# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the measurements on frames.

profiles.png from /profiles (P2 Fig. 28), fields.png from /samples/fields (P2 Fig. 27) and histograms.png from
/histograms, each if the result has it; of a ramp maps of its frames (ramp_page.py).
"""

import os

import numpy as np

from . import histogram_page, ramp_page
from .labels import add_heading, plain_ticks, scene_line, with_unit
from .packing_page import with_images
from .style import BLUE, DASHED, GREEN, GREY, ORANGE, VERMILION, plt, save
from ..frames import Box
from ..hdf5 import open_hdf5, plain

from matplotlib.collections import EllipseCollection


def curve(axes, profiles, name, color, label=None):
    """A profile with its errors, where they are known."""
    y, value, error = (profiles[name][part][()] for part in ("y", "value", "error"))
    axes.plot(y, value, "-", color=color, label=label)
    known = np.isfinite(error)
    axes.errorbar(y[known], value[known], error[known], fmt=".", ms=3, color=color, lw=0.8)


def level(axes, value, label):
    axes.axhline(value, color=GREY, lw=0.9, ls=DASHED, label=label)


def draw_flow(axes, profiles, about, which):
    """One column of P2 Fig. 28, and the stresses."""
    rate, phi = float(about["strain_rate"]), float(about["packing_fraction"])
    y = profiles["v_x"]["y"][()]
    curve(axes[0], profiles, "v_x" + which, BLUE)
    axes[0].plot(y, rate * y, color=GREY, lw=0.9, ls=DASHED, label="linear")
    axes[0].set_ylabel(with_unit("$v_x$", "d_s/tau_e"))
    curve(axes[1], profiles, "gammadot" + which, VERMILION)
    level(axes[1], rate, r"whole box")
    axes[1].set_ylabel(r"$\dot\gamma\tau_e$")
    curve(axes[2], profiles, "phi" + which, GREEN)
    level(axes[2], phi, r"whole box")
    axes[2].set_ylabel(r"$\phi$")
    for name, color, label in (("p", BLUE, "$p$"), ("sigma", VERMILION, r"$\sigma$"),
                               ("p_kin", ORANGE, r"$p^{kin}$")):
        curve(axes[3], profiles, name + which, color, label)
    axes[3].set_ylabel(with_unit("stress", "m/tau_e^2"))
    axes[3].set_xlabel(with_unit("$y$" if not which else "$y$, the band at $L_y/2$", "d_s"))
    for one in axes:
        one.legend(loc="best")


def heading_of(figure, file, height, left, strain=None, note="", rate=None):
    """Adds the heading in the uppermost inch of a page of `height` inches."""
    about = {name: plain(value) for name, value in file.attrs.items()}
    replicas = len(file.attrs.get("seeds", [0]))
    add_heading(figure, about, scene_line(about, strain, replicas, rate), note, left, height)


def profiles_page(file):
    if ramp_page.is_ramp(file):
        return of_ramp(file, ramp_page.profiles_page)
    figure, axes = plt.subplots(4, 2, figsize=(11, 13), sharex=True, sharey="row")
    figure.subplots_adjust(left=0.085, right=0.985, bottom=0.045, top=0.895, hspace=0.12, wspace=0.08)
    draw_flow(axes[:, 0], file["profiles"], file.attrs, "")
    draw_flow(axes[:, 1], file["profiles"], file.attrs, "_aligned")
    axes[0, 0].set_title("as the box has it")
    axes[0, 1].set_title("each frame moved so that the fastest band is in the middle")
    for one in axes.flat:
        plain_ticks(one.yaxis)
    for one in axes[:, 1]:
        one.set_ylabel("")
    figure.align_ylabels(axes[:, 0])
    heading_of(figure, file, 13, 0.085)
    return figure


def draw_disks(figure, axes, place, diameter, value, limits, label, bar_width):
    """Disks in grey by a value, small values dark, as in P2 Fig. 27; a bar as high as the box."""
    disks = EllipseCollection(diameter, diameter, 0, units="xy", offsets=place,
                              transOffset=axes.transData, array=value, cmap="gray", lw=0)
    disks.set_clim(*limits)
    axes.add_collection(disks)
    axes.set_facecolor("#c8d6e5")
    bar = figure.colorbar(disks, cax=axes.inset_axes([1 + bar_width, 0, bar_width, 1]), extend="both")
    bar.set_label(label)
    bar.outline.set_edgecolor("#888888")


def two_boxes(aspect):
    """A figure with two boxes of this height over width, beside each other or, of flat ones, one above the other;
    and the width of one in inches."""
    flat = aspect < 0.6
    wide = 12.0 if flat else 6.0 / max(1.0, aspect)
    high = wide * aspect
    columns, rows = (1, 2) if flat else (2, 1)
    width, height = max(11.0, columns * (wide + 2.0)), rows * (high + 0.9) + 1.1
    figure = plt.figure(figsize=(width, height))
    axes = [figure.add_axes([(0.75 + (wide + 2.0) * (k if columns == 2 else 0)) / width,
                             1 - (1.1 + high + (high + 0.9) * (k if rows == 2 else 0)) / height,
                             wide / width, high / height]) for k in (0, 1)]
    return figure, axes, wide


def fields_page(file):
    x, y, diameter, phi, rate = file["samples/fields"][()].T
    _, strain, length, offset = file["samples/fields_frame"][0]
    height = file.attrs.get("box_aspect", 1) * length
    index, places = with_images(np.stack([x, y], axis=1), np.full(len(x), 0.7), Box(length, height, offset))
    figure, axes, inches = two_boxes(height / length)
    for one, value, label in ((axes[0], phi, r"$\phi$ within $4\,d_s$"),
                              (axes[1], rate, r"$\dot\gamma\tau_e$ within $4\,d_s$")):
        known = value[np.isfinite(value)]
        limits = np.percentile(known, [2, 98]) if len(known) else (0, 1)
        draw_disks(figure, one, places, diameter[index], value[index], limits, label, 0.18 / inches)
        one.set_xlim(0, length)
        one.set_ylim(0, height)
        one.set_xlabel(with_unit("$x$", "d_s"))
        one.set_ylabel(with_unit("$y$", "d_s"))
    note = "last frame of the first replica" if len(file.attrs.get("seeds", [0])) > 1 else "last frame"
    heading_of(figure, file, figure.get_figheight(), 0.75 / figure.get_figwidth(), strain, note)
    return figure


def of_ramp(file, page):
    figure, height = page(file)
    heading_of(figure, file, height, 0.105, rate=ramp_page.rates_in_words(file))
    return figure


def histograms_page(file):
    if ramp_page.is_ramp(file):
        return of_ramp(file, ramp_page.histograms_page)
    figure = histogram_page.page(file["histograms"])
    heading_of(figure, file, figure.get_figheight(), 0.07)
    return figure


def draw(source, target):
    """target: a folder, for PNG, or FOLDER/ANY.pdf or .svg, whose form the pictures take."""
    stem, form = os.path.splitext(target)
    folder, form = (os.path.dirname(stem), form) if form in (".pdf", ".svg") else (target, ".png")
    with open_hdf5(source) as file:
        for wanted, page, name in (("profiles", profiles_page, "profiles"),
                                   ("samples/fields", fields_page, "fields"),
                                   ("histograms", histograms_page, "histograms")):
            if wanted in file and len(file[wanted]):
                save(page(file), os.path.join(folder, name + form))
