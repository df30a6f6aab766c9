# SPDX-License-Identifier: BSD-3-Clause
"""A page as a figure of a paper: one column of a journal (or two), panels with letters, no heading."""

import re
import string

from .labels import is_plain, scale_ticks
from ..errors import InputError

COLUMN, PAGE = 3.375, 7.0  # inches: widths of Phys. Rev.
MOST_IN_A_COLUMN = 3
HEIGHT, GAP_ABOVE, GAP_BELOW = 2.0, 0.2, 0.45  # of a panel, inches
LEFT, RIGHT = 0.82, 0.1
MOST_NAMES, LINE = 6, 0.13  # in a panel; height of a line of names below all, inches
SIZES = {"label": 8, "tick": 7, "legend": 6.5}


def upright(text):
    """A label whose unit, in square brackets, stands upright."""
    return re.sub(r"\$\[(.*?)\]\$", r"$[\\mathrm{\1}]$", text)


def is_bar(axes):
    return axes.get_label() == "<colorbar>"


def chosen(figure, panels):
    """Axes of the requested letters, of all if none are."""
    drawn = [axes for axes in figure.axes if axes.axison and not is_bar(axes)]
    letters = string.ascii_lowercase[:len(drawn)]
    if unknown := [one for one in panels or "" if one not in letters]:
        raise InputError(f"panels = {panels!r} ({unknown[0]!r} is none of {letters})")
    return [drawn[letters.index(one)] for one in panels or letters]


def lend_labels(all_axes, shown):
    """Copies the labels of x from the lowest panel of a stack to those above it."""
    for axes in shown:
        if not axes.get_xlabel():
            axes.set_xlabel(next((one.get_xlabel() for one in all_axes
                                  if one.get_xlabel() and one.get_xlim() == axes.get_xlim()), ""))


def smaller(axes):
    """Letters, lines and markers for a column, which has no room for a power of ten at each tick."""
    if is_plain(axes.yaxis):
        symbol, unit = re.fullmatch(r"(.*?)(?:  \$\[(.*)\]\$)?", axes.get_ylabel()).groups("")
        scale_ticks(axes.yaxis, symbol, unit)
    for axis in (axes.xaxis, axes.yaxis):
        axis.label.set(text=upright(axis.label.get_text()), size=SIZES["label"])
    axes.tick_params(which="both", labelsize=SIZES["tick"], pad=2, length=2.5)
    axes.set_title("")
    axes.set_title("", loc="left")
    axes.set_title("", loc="right")
    for text in axes.texts:
        text.set_size(SIZES["legend"])
    for line in axes.lines:
        line.set_markersize(min(line.get_markersize(), 3.2))
        line.set_linewidth(min(line.get_linewidth(), 1.0))


def with_legend(axes, handles, labels):
    """Moves a legend from above the panel into it, if there is room."""
    legend = axes.get_legend()
    if legend:
        legend.remove()
    if labels:
        axes.legend(handles, labels, loc="best", fontsize=SIZES["legend"], handlelength=1.2,
                    labelspacing=0.25, columnspacing=0.8, borderaxespad=0.2, frameon=True, framealpha=0.8,
                    edgecolor="none")


def names_of(axes):
    """Handles and words of its legend."""
    legend = axes.get_legend()
    return (legend.legend_handles if hasattr(legend, "legend_handles") else legend.legendHandles,
            [text.get_text() for text in legend.get_texts()]) if legend else ([], [])


def fit(figure, panels=None):
    """Changes the figure and returns it. panels: letters, "ac"; all by default."""
    shown = chosen(figure, panels)
    named = {axes: names_of(axes) for axes in shown}
    for legend in list(figure.legends):
        handles = legend.legend_handles if hasattr(legend, "legend_handles") else legend.legendHandles
        first = named[shown[0]]
        named[shown[0]] = (list(first[0]) + list(handles), first[1] + [text.get_text() for text in legend.get_texts()])
        legend.remove()
    for text in list(figure.texts):
        text.remove()
    columns = 1 if len(shown) <= MOST_IN_A_COLUMN else 2
    rows = -(-len(shown) // columns)
    width, high = (COLUMN, PAGE)[columns - 1], HEIGHT + GAP_ABOVE + GAP_BELOW
    bars = [axes for axes in figure.axes if is_bar(axes)]
    if len(shown) == 1 and bars:  # a packing: its own layout, narrower
        square = figure.get_figheight() / figure.get_figwidth()
        figure.set_size_inches(COLUMN, COLUMN * square)
        for axes in bars:
            smaller(axes)
        smaller(shown[0])
        return figure
    lend_labels(figure.axes, shown)
    for axes in [one for one in figure.axes if one not in shown]:
        axes.remove()
    if hasattr(figure, "set_layout_engine"):
        figure.set_layout_engine("none")
    many = next((axes for axes in shown if len(named[axes][1]) > MOST_NAMES), None)
    names = 3 * columns  # beside each other, below all panels
    height = rows * high + (LINE * (-(-len(named[many][1]) // names) + 1) if many else 0)
    figure.set_size_inches(width, height)
    wide = width / columns - LEFT - RIGHT
    for k, axes in enumerate(shown):
        row, column = divmod(k, columns)
        axes.set_position([(column * width / columns + LEFT) / width, 1 - ((row + 1) * high - GAP_BELOW) / height,
                           wide / width, HEIGHT / height])
        smaller(axes)
        axes.yaxis.set_label_coords(-0.74 * LEFT / wide, 0.5)  # one place, whatever the page aligned it with
        axes.xaxis.label.set_visible(True)
        axes.tick_params(labelbottom=True)
        if len(shown) > 1:
            axes.annotate(f"({string.ascii_lowercase[k]})", (0, 1), (-0.92 * LEFT * 72, 3), xycoords="axes fraction",
                          textcoords="offset points", fontsize=SIZES["label"], va="bottom")
        with_legend(axes, *(([], []) if axes is many else named[axes]))
    if many:
        figure.legend(*named[many], loc="lower center", ncol=names, bbox_to_anchor=(0.5, 0.0), fontsize=SIZES["legend"],
                      handlelength=1.2, labelspacing=0.25, columnspacing=0.8, borderaxespad=0.2)
    return figure
