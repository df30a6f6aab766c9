#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what was measured on frames: plot_frames.py RESULT.h5 FOLDER

profiles.png from /profiles (P2 Fig. 28) and fields.png from /samples/fields (P2 Fig. 27), each where
the result has it. Exit code 1 and one line on stderr otherwise.
"""

import os

from plotting import BLUE, DASHED, GREEN, GREY, ORANGE, VERMILION, h5py, np, plt, command_line, save

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
    axes[0].set_ylabel(r"$v_x$  $[d_s/\tau_e]$")
    curve(axes[1], profiles, "gammadot" + which, VERMILION)
    level(axes[1], rate, r"whole box")
    axes[1].set_ylabel(r"$\dot\gamma\tau_e$")
    curve(axes[2], profiles, "phi" + which, GREEN)
    level(axes[2], phi, r"whole box")
    axes[2].set_ylabel(r"$\phi$")
    for name, color, label in (("p", BLUE, "$p$"), ("sigma", VERMILION, r"$\sigma$"),
                               ("p_kin", ORANGE, r"$p^{kin}$")):
        curve(axes[3], profiles, name + which, color, label)
    axes[3].set_ylabel(r"stress  $[m/\tau_e^2]$")
    axes[3].set_xlabel(r"$y$  $[d_s]$" if not which else r"$y$ from the band, at $L/2$  $[d_s]$")
    for one in axes:
        one.legend(loc="best")


def profiles_page(file):
    figure, axes = plt.subplots(4, 2, figsize=(11, 12), sharex=True, sharey="row",
                                layout="constrained")
    draw_flow(axes[:, 0], file["profiles"], file.attrs, "")
    draw_flow(axes[:, 1], file["profiles"], file.attrs, "_aligned")
    axes[0, 0].set_title("as the box has it")
    axes[0, 1].set_title("each frame moved so that the fastest band is in the middle")
    return figure


def draw_disks(figure, axes, place, diameter, value, limits, label):
    """Disks in grey by a value, small values dark, as in P2 Fig. 27."""
    disks = EllipseCollection(diameter, diameter, 0, units="xy", offsets=place,
                              transOffset=axes.transData, array=value, cmap="gray", lw=0)
    disks.set_clim(*limits)
    axes.add_collection(disks)
    axes.set_facecolor("#c8d6e5")
    bar = figure.colorbar(disks, ax=axes, shrink=0.8, pad=0.02, extend="both")
    bar.set_label(label)
    bar.outline.set_visible(False)


def with_images(place, length, height, offset):
    """Indices and places of all disks, and of the images that reach into the box."""
    index, places = [], []
    for row in (-1, 0, 1):
        for column in (-2, -1, 0, 1, 2):
            there = place + [column * length + row * offset, row * height]
            near = ((there > -0.7) & (there < [length + 0.7, height + 0.7])).all(axis=1)
            index.append(np.nonzero(near)[0])
            places.append(there[near])
    return np.concatenate(index), np.concatenate(places)


def fields_page(file):
    x, y, diameter, phi, rate = file["samples/fields"][()].T
    _, strain, length, offset = file["samples/fields_frame"][0]
    height = file.attrs.get("box_aspect", 1) * length
    index, places = with_images(np.stack([x, y], axis=1), length, height, offset)
    figure, axes = plt.subplots(1, 2, figsize=(15, 7), layout="constrained")
    for one, value, label in ((axes[0], phi, r"$\phi$ within $4 d_s$"),
                              (axes[1], rate, r"$\dot\gamma\tau_e$ within $4 d_s$")):
        known = value[np.isfinite(value)]
        limits = np.percentile(known, [2, 98]) if len(known) else (0, 1)
        draw_disks(figure, one, places, diameter[index], value[index], limits, label)
        one.set_xlim(0, length)
        one.set_ylim(0, height)
        one.set_aspect("equal")
        one.set_xlabel(r"$x$  $[d_s]$")
    axes[0].set_ylabel(r"$y$  $[d_s]$")
    figure.suptitle(f"strain {strain:.4g}", x=0.02, ha="left")
    return figure


def draw(source, folder):
    with h5py.File(source, "r") as file:
        for wanted, page, name in (("profiles", profiles_page, "profiles.png"),
                                   ("samples/fields", fields_page, "fields.png")):
            if wanted in file and len(file[wanted]):
                save(page(file), os.path.join(folder, name))


if __name__ == "__main__":
    command_line("plot_frames.py", "RESULT.h5 FOLDER", draw)
