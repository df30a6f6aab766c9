# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the tables that tables.py writes."""
import csv
import io
import os
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    import numpy as np
    from matplotlib import pyplot as plt
    from PIL import Image  # matplotlib's own
except ImportError as error:
    sys.exit(f"pictures.py: {error}; no picture (Debian: apt install python3-matplotlib)")

import engines as of_engines
from cases import CASES, LEGEND, PAPERS

# Okabe and Ito's palette: told apart by colour-blind eyes too.
COLOURS = dict(zip(LEGEND, ("#777777", "#56B4E9", "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7")))
MARKERS = dict(zip(LEGEND, "s^v<>oD"))
DPI = 220  # twice what a page shows
STYLE = {
    "font.size": 9, "axes.titlesize": 9.5, "axes.titlelocation": "left", "axes.spines.top": False,
    "axes.spines.right": False, "legend.frameon": False, "legend.fontsize": 8, "lines.linewidth": 1.1,
    "mathtext.fontset": "dejavusans", "lines.markersize": 4,
}


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def number(row, key):
    return float(row[key]) if row.get(key) else np.nan


def save(figure, folder, name):
    os.makedirs(folder, exist_ok=True)
    picture = io.BytesIO()
    figure.savefig(picture, dpi=DPI)
    few = Image.open(picture).convert("RGB").quantize(128)
    few.save(os.path.join(folder, name), optimize=True, dpi=(DPI, DPI))
    plt.close(figure)


def panels(count, columns, title):
    rows = -(-count // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.1 * columns, 2.6 * rows), layout="constrained",
                                squeeze=False)
    figure.suptitle(title, x=0.01, ha="left", fontsize=10.5)
    for axis in axes.flat[count:]:
        axis.set_visible(False)
    return figure, axes.flat


def legend(figure, axis):
    handles, labels = axis.get_legend_handles_labels()
    bottom = 0.5 / figure.get_size_inches()[1]
    figure.get_layout_engine().set(rect=(0, bottom, 1, 1 - bottom))
    figure.legend(handles, labels, loc="lower left", ncols=4)


def collision(data, out):
    """Energy lost in a head-on collision; overlap where the disks never part."""
    rows = [r for r in read(data, "collision.csv") if r["model"] == "CD_n" and r["impact"] == "head-on"]
    elasticities = sorted({float(r["Q"]) for r in rows})
    figure, axes = panels(len(elasticities), 4, "One head-on collision (CD_n), averaged over the phase of the step")
    for axis, q in zip(axes, elasticities):
        bound = q < 0.9  # e = 0 or next to nothing: what counts is how the overlap goes
        key = "overlap_error" if bound else "loss_error"
        for scheme, label in LEGEND.items():
            line = [(float(r["dt"]), abs(number(r, key))) for r in rows
                    if r["scheme"] == scheme and float(r["Q"]) == q]
            if line:
                axis.loglog(*zip(*line), color=COLOURS[scheme], marker=MARKERS[scheme], label=label)
        axis.axhline(0.01, color="#BBBBBB", linewidth=0.8)
        axis.set_ylim(1e-6, 10)
        axis.set_title(f"Q = {q:g}: " + ("overlap" if bound else "energy lost"))
        axis.set_xlabel(r"$\Delta t/\tau_e$")
    axes[0].set_ylabel("relative error")
    legend(figure, axes[0])
    save(figure, out, "collision.png")


def bias_of(row):
    """Largest of the relative biases of pressure, shear stress and contact number, and its error."""
    pairs = [(abs(number(row, name)), number(row, name + "_error")) for name in ("p", "sigma", "Z")]
    return max(pairs) if row["status"] == "ok" else (np.nan, np.nan)


def front(points):
    """Of (cost, error) those that no other beats in both."""
    best, chosen = np.inf, []
    for cost, error in sorted(points):
        if error < best:
            best = error
            chosen.append((cost, error))
    return chosen


def bias(data, out):
    rows = read(data, "stretch.csv")
    rates = sorted({float(r["rate"]) for r in rows}, reverse=True)
    for rate in rates:
        here = [r for r in rows if float(r["rate"]) == rate]
        names = [c for c in CASES if any(belongs(r, c) for r in here)]
        figure, axes = panels(len(names), 4, f"Bias of p, σ, Z (the largest) against cost, rate {rate:g}; "
                                             "open: below its standard error; line: Pareto front")
        for axis, case in zip(axes, names):
            points = []
            for scheme, label in LEGEND.items():
                mine = [r for r in here if belongs(r, case) and r["scheme"] == scheme]
                axis.plot([], [], color=COLOURS[scheme], marker=MARKERS[scheme], linestyle="", label=label)
                for r in mine:
                    error, noise = bias_of(r)
                    if not error < 1:
                        continue
                    error, cost = max(error, 1e-5), (2 if scheme == PAPERS else 1) / float(r["dt"])
                    if scheme != "implicit-verlet":
                        points.append((cost, max(error, noise)))
                    axis.errorbar(cost, error, noise, color=COLOURS[scheme], marker=MARKERS[scheme],
                                  linestyle="", elinewidth=0.6,
                                  markerfacecolor=COLOURS[scheme] if error > noise else "none")
            axis.step(*zip(*front(points)), where="post", color="black", linewidth=0.6)
            axis.set(xscale="log", yscale="log", title=case.name, ylim=(5e-6, 1))
            axis.axhline(0.01, color="#BBBBBB", linewidth=0.8)
            axis.set_xlabel(r"force evaluations per $\tau_e$")
        axes[0].set_ylabel("relative bias")
        legend(figure, axes[0])
        save(figure, out, f"bias-{rate:g}.png")


def belongs(row, case):
    return (row["model"], float(row["phi"]), float(row["Q"])) == (case.model, case.phi, case.q)


def stability(data, out):
    rows, packing = read(data, "stability_contact.csv"), read(data, "stability_packing.csv")
    models = list(dict.fromkeys(r["model"] for r in rows))
    figure, axes = panels(len(models), 3, "Largest stable step: one contact (lines), the contacts of a packing "
                                          "with Z = 3.5, damping alone (dots)")
    for axis, model in zip(axes, models):
        for scheme, label in LEGEND.items():
            mine = [r for r in rows if r["model"] == model and r["scheme"] == scheme]
            edge = [(float(r["Q"]), float(r["unstable_from_dt"])) for r in mine]
            edge = [(q, dt) if np.isfinite(dt) else (q, np.nan) for q, dt in edge]
            axis.loglog(*zip(*edge), color=COLOURS[scheme], label=label)
            for r in packing:
                if r["model"] == model and r["scheme"] == scheme and r["arrangement"] == "index":
                    ratio = float(r["largest_dt_over_Q"])
                    qs = np.array([q for q, _ in edge if ratio * q < 1])
                    axis.loglog(qs, ratio * qs, color=COLOURS[scheme], linestyle=":")
        axis.axhline(0.2, color="#BBBBBB", linewidth=0.8)
        axis.set(title=model, xlabel="Q", ylim=(2e-3, 4))
    axes[0].set_ylabel(r"$\Delta t/\tau_e$")
    legend(figure, axes[0])
    save(figure, out, "stability.png")


def engines(data, out):
    """Seconds of CPU a unit of strain."""
    rows = read(data, "engines.csv")
    markers = dict(zip(of_engines.ENGINES, "oDsv^"))
    titles = [row for row in of_engines.ROWS if any(r["state"] == row.state for r in rows)]
    figure, axis = plt.subplots(figsize=(8, 0.42 * len(titles) + 1.3), layout="constrained")
    for scheme, colour, shift in (("two-stage-leapfrog", COLOURS["two-stage"], 0.15),
                                  ("modified-velocity-verlet", COLOURS[PAPERS], -0.15)):
        for engine in of_engines.ENGINES:
            points = [(float(r["seconds"]), -place + shift) for place, row in enumerate(titles) for r in rows
                      if (r["state"], r["engine"], r["scheme"]) == (row.state, engine, scheme)]
            if points:
                axis.plot(*zip(*points), linestyle="", marker=markers[engine], color=colour,
                          markerfacecolor=colour if engine == "steps" else "none", label=f"{engine}, {scheme}")
    axis.set(xscale="log", xlabel="seconds of CPU a unit of strain, N = 1024",
             yticks=[-place for place in range(len(titles))], yticklabels=[row.title for row in titles],
             title="Engines and schemes; each scheme with its own step")
    axis.grid(axis="x", color="#EEEEEE")
    axis.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, out, "engines.png")


def draw(data, out):
    there = lambda name: os.path.exists(os.path.join(data, name))
    with plt.rc_context(STYLE):
        if there("collision.csv"):
            collision(data, out)
        if there("stretch.csv"):
            bias(data, out)
        if there("stability_contact.csv") and there("stability_packing.csv"):
            stability(data, out)
        if there("engines.csv"):
            engines(data, out)
