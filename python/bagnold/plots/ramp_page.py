# SPDX-License-Identifier: BSD-3-Clause
"""Measurements on the frames of a ramp: maps over the path of the rate, in decades up and down, of profiles over y and
of histograms. Of replicas the first one."""

import numpy as np

from .labels import log_ticks, power_of_ten, with_unit
from .style import BLUE, GREY, plt

RATE = r"\dot\gamma"
#: /profiles/NAME: label, over what, colours, whether they are about 1.
PROFILES = (("gammadot", rf"${RATE}(y)/{RATE}$", "rate", "RdBu_r", True),
            ("phi", r"$\phi(y)$", None, "viridis", False),
            ("sigma", r"$\sigma(y)$ over its mean", "mean", "RdBu_r", True),
            ("T_g", r"$T_g(y)$ over its mean", "mean", "RdBu_r", True))
#: /histograms/NAME: label, scale of the axis.
HISTOGRAMS = (("tau_dur", with_unit(r"$\tau_{dur}$", "tau_e"), "log"), ("cluster_disks", "disks in the cluster", "log"),
              ("theta", r"$\theta$  [degrees]", "linear"), ("rotation", rf"$\dot\theta/{RATE}$", "linear"),
              ("local_phi", r"$\phi$ within $4\,d_s$", "linear"),
              ("local_gammadot", rf"$\dot\gamma$ within $4\,d_s$ over ${RATE}$", "linear"))
SHOWN = 5e-3  # share of all counts at either end of an axis that is left out


def is_ramp(file):
    return "samples/ramp_frames" in file


def way(file):
    """Rates of the frames, decades gone through at each, and the edges between them."""
    rates = file["samples/ramp_frames"][:, 1]
    gone = np.concatenate([[0], np.cumsum(np.abs(np.diff(np.log10(rates))))])
    typical = np.median(np.diff(gone)) if len(gone) > 1 else 1.0
    gone = np.arange(len(gone)) * typical  # frames are equally far apart, turns included
    return rates, gone, np.concatenate([gone - typical / 2, gone[-1:] + typical / 2])


def rates_in_words(file):
    """The rates that a ramp goes through, up and down."""
    rates = [float(f"{rate:.2g}") for rate in np.sort(file["samples/ramp_frames"][:, 1])[[0, -1]]]
    return rf"${RATE}\tau_e = ${power_of_ten(rates[0])} to {power_of_ten(rates[1])} and back"


def rows_of(values):
    """[frames][n], of several systems those of the first."""
    return values[0] if values.ndim == 3 else values


def panels(count, title_room=1.3):
    """Axes for the rate, and `count` maps below with a bar each."""
    height = title_room + 1.5 + 2.1 * count
    figure, axes = plt.subplots(count + 1, 1, figsize=(11, height), sharex=True,
                                gridspec_kw={"height_ratios": [1.2] + [2.0] * count})
    figure.subplots_adjust(left=0.105, right=0.88, bottom=0.55 / height, top=1 - title_room / height, hspace=0.12)
    return figure, axes, height


def draw_rate(axes, gone, rates):
    axes.plot(gone, rates, "-", color=BLUE)
    axes.set_yscale("log")
    axes.set_ylabel(rf"${RATE}\tau_e$")
    log_ticks(axes.yaxis)


def draw_map(figure, axes, x, y, values, label, colours, limits):
    """values: [frames][n]; x, y: edges."""
    seen = axes.pcolormesh(x, y, values.T, cmap=colours, vmin=limits[0], vmax=limits[1], rasterized=True)
    box = axes.get_position()
    bar = figure.colorbar(seen, cax=figure.add_axes([0.895, box.y0, 0.014, box.height]), extend="both")
    bar.set_label(label)
    axes.set_facecolor("#eeeeee")


def last(axes):
    axes[-1].set_xlabel("way of the rate, up and down  [decades]")
    axes[0].figure.align_ylabels(axes)


def profiles_page(file):
    """Returns the figure and its height."""
    rates, gone, edges = way(file)
    wanted = [one for one in PROFILES if one[0] in file["profiles"]]
    figure, axes, height = panels(len(wanted))
    draw_rate(axes[0], gone, rates)
    for one, (name, label, over, colours, about_one) in zip(axes[1:], wanted):
        group = file["profiles"][name]
        y, values = group["y"][()], rows_of(group["value"][()])
        if over == "rate":
            values = values / rates[:, None]
        elif over == "mean":
            values = values / np.nanmean(values, axis=1, keepdims=True)
        known = values[np.isfinite(values)]
        low, high = np.percentile(known, [2, 98]) if len(known) else (0, 1)
        if about_one:
            reach = max(1 - low, high - 1)
            low, high = 1 - reach, 1 + reach
        thickness = y[1] - y[0] if len(y) > 1 else 1.0
        draw_map(figure, one, edges, np.append(y - thickness / 2, y[-1] + thickness / 2), values, label, colours,
                 (low, high))
        one.set_ylabel(with_unit("$y$", "d_s"))
    last(axes)
    return figure, height


def window(edges, shares):
    """First and last edge of the bins that hold nearly all counts."""
    total = np.cumsum(np.nansum(shares, axis=0))
    first = int(np.searchsorted(total, SHOWN * total[-1]))
    end = int(np.searchsorted(total, (1 - SHOWN) * total[-1])) + 1
    return edges[first], edges[min(end, len(edges) - 1)]


def joined(bins, shares, most=80):
    """Joins bins until at most that many are in the window."""
    low, high = window(bins, shares)
    join = -(-int(np.sum((bins[:-1] < high) & (bins[1:] > low))) // most)
    count = shares.shape[1] // join * join
    return bins[:count + 1:join], np.add.reduceat(shares[:, :count], np.arange(0, count, join), axis=1)


def told(name, group):
    """True if a map is meaningful: it has counts, and not all of them are in the last bin, which is open."""
    shares = np.nansum(rows_of(group["density"][()]), axis=0) * np.diff(group["edges"][()])
    return shares.sum() > 0 and not (name == "cluster_disks" and shares[-1] > 0.9 * shares.sum())


def histograms_page(file):
    """Returns the figure and its height. Colours: density over its largest in that frame."""
    rates, gone, edges = way(file)
    found = file["histograms"]
    wanted = [one for one in HISTOGRAMS if one[0] in found and told(one[0], found[one[0]])]
    figure, axes, height = panels(len(wanted))
    draw_rate(axes[0], gone, rates)
    for one, (name, label, scale) in zip(axes[1:], wanted):
        bins, density = found[name]["edges"][()], rows_of(found[name]["density"][()])
        bins, shares = joined(bins, density * np.diff(bins))
        drawn = shares / np.diff(np.log(bins) if scale == "log" else bins)
        peak = np.nanmax(np.where(np.isfinite(drawn), drawn, 0), axis=1, keepdims=True)
        draw_map(figure, one, edges, bins, drawn / np.where(peak > 0, peak, np.nan), "density over its peak", "magma_r",
                 (0, 1))
        one.set_yscale(scale)
        one.set_ylim(*window(bins, shares))
        one.set_ylabel(label)
        if name in ("rotation", "local_gammadot"):
            one.axhline(-0.5 if name == "rotation" else 1.0, color=GREY, lw=0.8)
    last(axes)
    return figure, height
