# SPDX-License-Identifier: BSD-3-Clause
"""Histograms of /histograms: collision angles, durations and clusters of contacts, spins, local phi and gammadot."""

import numpy as np

from .labels import plain_ticks, with_unit
from .style import BLUE, COLOURS, DASHED, GREY, plt

FOUND = 1e-4  # share at either end that is not shown


def densities(groups, names):
    """{name: (edges, density)} of those of `names` that anything was counted in."""
    found = {name: (groups[name]["edges"][()], groups[name]["density"][()]) for name in names if name in groups}
    return {name: one for name, one in found.items() if np.nansum(one[1]) > 0}


def shown(edges, density, least=FOUND):
    """First and last edge of the bins that hold all but `least` at either end."""
    share = np.cumsum(density * np.diff(edges))
    first = int(np.searchsorted(share, least * share[-1]))
    last = int(np.searchsorted(share, (1 - least) * share[-1]))
    return edges[first], edges[min(last + 1, len(edges) - 1)]


def coarser(edges, density, most=120):
    """Joins bins until at most that many are within the shown range."""
    low, high = shown(edges, density)
    bins = int(np.sum((edges[:-1] < high) & (edges[1:] > low)))
    join = -(-bins // most)
    count = len(density) // join * join
    weight = np.add.reduceat((density * np.diff(edges))[:count], np.arange(0, count, join))
    joined = edges[:count + 1:join]
    return joined, weight / np.diff(joined)


def angles(axes, found):
    """theta of P2 Eq. 27, at begins and ends."""
    for (name, (edges, density)), colour in zip(found.items(), COLOURS):
        axes.stairs(density, edges, color=colour, lw=1.2,
                    label={"theta_begin": "contacts begin", "theta_end": "they end"}.get(name, name))
    axes.set_xlim(-182, 180)
    axes.set_xticks(range(-180, 181, 90))
    axes.set_xlabel(r"collision angle $\theta$  [degrees]")
    axes.set_ylabel("density  [1/degree]")


def durations(axes, found):
    """tau_dur, by its logarithm: areas are shares of contacts."""
    (edges, density), = found.values()
    axes.stairs(density * np.diff(edges) / np.diff(np.log10(edges)), edges, color=BLUE, lw=1.2, fill=True, alpha=0.5)
    axes.set_xscale("log")
    axes.set_xlim(*shown(edges, density))
    mean = np.sum(density * (edges[1:]**2 - edges[:-1]**2) / 2)
    axes.axvline(mean, color=GREY, ls=DASHED, lw=1.0, label=rf"mean {mean:.3g} $\tau_e$")
    axes.set_xlabel(with_unit(r"duration of contacts $\tau_{dur}$", "tau_e"))
    axes.set_ylabel("share a decade")


def clusters(axes, found):
    """Disks in the cluster of a contact."""
    (edges, density), = found.values()
    middle = (edges[1:] + edges[:-1]) / 2
    axes.plot(middle, np.where(density > 0, density, np.nan), "o-", ms=3, lw=0.8, color=BLUE)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks((2, 5, 10, 20, 64), ("2", "5", "10", "20", r"$\geq 64$"))
    axes.minorticks_off()
    axes.set_xlabel("disks in the cluster where a contact begins")
    axes.set_ylabel("share")


def spread(symbol, unit_of_line, line, log=True):
    """One quantity, with a line where it has its mean value or that of the flow."""
    def draw(axes, found):
        (edges, density), = found.values()
        edges, density = coarser(edges, density)
        axes.stairs(density, edges, color=BLUE, lw=1.2, fill=True, alpha=0.5)
        axes.set_xlim(*shown(edges, density))
        if line is not None:
            axes.axvline(line, color=GREY, ls=DASHED, lw=1.0, label=unit_of_line)
        if log:
            axes.set_yscale("log")
            seen = density[(edges[1:] > axes.get_xlim()[0]) & (edges[:-1] < axes.get_xlim()[1]) & (density > 0)]
            axes.set_ylim(seen.min() / 1.5, seen.max() * 2)
        axes.set_xlabel(symbol)
        axes.set_ylabel("density")
    return draw


#: Histograms of a panel, and what draws it.
PANELS = ((("theta_begin", "theta_end"), angles), (("tau_dur",), durations), (("cluster_disks",), clusters),
          (("rotation",), spread(r"spin $\dot\theta/\dot\gamma$", "of the flow, -1/2", -0.5)),
          (("local_phi",), spread(r"$\phi$ within $4\,d_s$", None, None, log=False)),
          (("local_gammadot",), spread(r"$\dot\gamma$ within $4\,d_s$ over that of the box", "of the box", 1.0)))


def page(groups):
    """A panel for each that has counts."""
    wanted = [(found, draw) for names, draw in PANELS if (found := densities(groups, names))]
    columns = min(3, max(1, len(wanted)))
    lines = max(1, -(-len(wanted) // columns))
    width, height = max(9.0, 5.0 * columns), 1.3 + 3.9 * lines
    figure, grid = plt.subplots(lines, columns, figsize=(width, height), squeeze=False)
    figure.subplots_adjust(left=0.07, right=0.985, bottom=0.6 / height, top=1 - 1.35 / height, hspace=0.42,
                           wspace=0.26)
    for axes, (found, draw) in zip(grid.flat, wanted):
        draw(axes, found)
        if axes.get_yscale() == "linear":
            plain_ticks(axes.yaxis)
        if axes.get_legend_handles_labels()[1]:
            axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.1)
    for axes in grid.flat[len(wanted):]:
        axes.set_axis_off()
    return figure
