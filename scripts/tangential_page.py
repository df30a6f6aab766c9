#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and tables of docs/results/tangential_damping.md: scripts/tangential_page.py [--sweeps FOLDER]

They come from docs/data/results/tangential*.csv; nothing is run. With --sweeps finished points of FOLDER/NAME, sweeps of
inputs/checks/NAME.toml, are first added to these tables. What a table has of sweeps that are gone, it keeps.
"""

import argparse
import csv
import json
import math
import pathlib
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "scripts/lib")]

import numpy as np  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from bagnold.plots.style import DASHED, GREY, STYLE, plt, save  # noqa: E402
from page_tables import in_page, measured, table  # noqa: E402

DATA = ROOT / "docs/data/results"
PAGE = ROOT / "docs/results/tangential_damping.md"
KEYS = {"disks.packing_fraction": float, "disks.damping_tangential": float, "disks.count": int, "disks.seed": int,
        "shear.strain_rate": float, "integration.scheme": str, "integration.engine": str}
SOFT = 1e-3  # p in k_e from which on overlaps show
HARD = 0.82  # phi up to which p at k_t = 0 goes as the square of the rate
NAMES = ("p", "sigma", "mu", "p_kin", "Z", "T_g", "spin_var")
SOURCES = {"tangential": ("tangential", "tangential_slow"), "tangential_methods": ("tangential_methods",)}


def number(value):
    return "" if value is None or value != value else f"{value:.6g}"


def rows_of(folder):
    """A row for each finished rate of each point of a sweep."""
    from bagnold.scene import Scene
    with open(folder / "points.json", encoding="utf-8") as file:
        listed = json.load(file)["points"]
    for one in listed:
        place = folder / "points" / one["folder"]
        for summary in [place / "summary.json", *sorted(place.glob("*/summary.json"))]:
            if not summary.exists():
                continue
            found = json.loads(summary.read_text(encoding="utf-8"))
            if "observables" not in found:
                continue
            toml = summary.parent / "scene.toml"
            scene = Scene(tomllib.loads(toml.read_text(encoding="utf-8"))).flat()
            row = {key: scene.get(key, "") for key in KEYS}
            row["strain"] = scene["shear.strain"]
            for name in NAMES:
                of = found["observables"].get(name, {})
                row[name], row[name + "_error"] = (number(of.get(part)) for part in ("mean", "error"))
                if name in ("p", "Z"):
                    for part in ("bias", "bias_error"):
                        row[f"{name}_{part}"] = number(of.get(part))
            row["warnings"] = " ".join(one["name"] for one in found.get("warnings", []))
            yield {key: str(value) for key, value in row.items()}


def collect(name, sweeps):
    path = DATA / f"{name}.csv"
    rows = {}
    if path.exists():
        with open(path, newline="", encoding="utf-8") as file:
            rows = {tuple(row[key] for key in KEYS): row for row in csv.DictReader(file)}
    for source in SOURCES[name]:
        if (sweeps / source / "points.json").exists():
            rows.update((tuple(row[key] for key in KEYS), row) for row in rows_of(sweeps / source))
    if not rows:
        return
    with open(path, "w", newline="", encoding="utf-8") as file:
        head = list(next(iter(rows.values())))
        writer = csv.DictWriter(file, head, lineterminator="\n")
        writer.writeheader()
        def order(key):
            return [KEYS[name](value) for name, value in zip(KEYS, key)]

        writer.writerows(rows[key] for key in sorted(rows, key=order))
    print(f"{path.name}: {len(rows)} rows")


def collect_clusters(folder):
    """Velocities in contact by cluster, a row a class of each run: each collision once, and in time."""
    import h5py
    rows = []
    for place in sorted((folder / "points").glob("*/result.h5")):
        with h5py.File(place) as file:
            if "samples/collision_clusters" not in file:
                continue
            once, in_time = (file[f"samples/{name}_clusters"] for name in ("collision", "contact"))
            if len(once) == 0 or not (place.parent / "summary.json").exists():
                continue
            scene = tomllib.loads((place.parent / "scene.toml").read_text(encoding="utf-8"))
            for one, other in zip(once[()], in_time[()]):
                row = [scene["disks"]["packing_fraction"], scene["shear"]["strain_rate"], scene["disks"]["seed"], one[0]]
                rows.append([f"{value:g}" for value in row] + [number(value) for value in (*one[1:], *other[1:])])
    names = ["contacts", "share", "V_N_rms", "V_T_rms", "V_R_rms", "V_C_T_rms"]
    with open(DATA / "clusters.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["packing_fraction", "strain_rate", "seed", "least_disks", *(name + "_once" for name in names),
                         *(name + "_in_time" for name in names)])
        writer.writerows(rows)


def data(name):
    """Rows of docs/data/results/NAME.csv, numbers as such."""
    with open(DATA / f"{name}.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key, text in row.items():
            if key not in ("integration.scheme", "integration.engine", "warnings"):
                row[key] = float(text) if text else math.nan
    return rows


def means(rows):
    """{(k_t/k_n, phi, rate): (p, relative error)}, over seeds with weights of their strain. The error of one run that tells
    none, and the least of any, is that of a correlation over a strain of 0.02."""
    found = {}
    for row in rows:
        key = tuple(row[name] for name in ("disks.damping_tangential", "disks.packing_fraction", "shear.strain_rate"))
        found.setdefault(key, []).append((row["p"], row["strain"], row["p_error"] / row["p"]))
    def joined(runs):
        p, strain, error = map(np.array, zip(*runs))
        weight = strain / strain.sum()
        mean = weight @ p
        return mean, math.sqrt((weight**2) @ np.maximum(np.nan_to_num(error), np.sqrt(0.02 / strain))**2)

    return {key: joined(runs) for key, runs in found.items()}


def exponents(found, fast, slow):
    """{(k_t/k_n, phi): (d ln p/d ln rate, error)} between two rates."""
    return {(k_t, phi): (math.log(p / found[k_t, phi, slow][0]) / math.log(fast / slow),
                         math.hypot(error, found[k_t, phi, slow][1]) / math.log(fast / slow))
            for (k_t, phi, rate), (p, error) in found.items() if rate == fast and (k_t, phi, slow) in found}


def diagram(found):
    """(phi, k_t/k_n): the exponent between two rates, a panel for each two that many states have."""
    pairs = [pair for pair in ((1e-3, 1e-4), (1e-4, 1e-5), (1e-5, 1e-6)) if len(exponents(found, *pair)) >= 6]
    ratios, densities = (sorted({key[k] for key in found}) for k in (0, 1))
    figure, panels = plt.subplots(1, len(pairs), figsize=(1.4 + 4.6 * len(pairs), 3.8), layout="constrained",
                                  squeeze=False, sharey=True)
    for axes, pair in zip(panels.flat, pairs):
        value = np.full((len(ratios), len(densities)), np.nan)
        for (k_t, phi), (exponent, _) in exponents(found, *pair).items():
            at = ratios.index(k_t), densities.index(phi)
            value[at] = exponent
            axes.text(*at[::-1], f"{exponent:.1f}", ha="center", va="center", fontsize=7)
        drawn = axes.imshow(value, cmap="coolwarm", vmin=0, vmax=2, origin="lower", aspect="auto", alpha=0.8)
        axes.set(xlabel=r"$\phi$", yticks=range(len(ratios)), yticklabels=[f"{k_t:g}" for k_t in ratios],
                 title=rf"$d\ln p/d\ln\dot\gamma$ from {power(pair[1])} to {power(pair[0])}")
        axes.set_xticks(range(len(densities)), [f"{phi:g}" for phi in densities], rotation=60, fontsize=8)
    panels[0, 0].set_ylabel("$k_t/k_n$")
    figure.colorbar(drawn, ax=panels, label="1: Newton, 2: Bagnold", pad=0.01)
    return figure


def power(rate):
    return f"$10^{{{round(math.log10(rate))}}}$"


def collapse(found):
    """p/(k_t gammadot) against gammadot/k_t, a panel a density."""
    shown = [0.74, 0.78, 0.80, 0.82]
    figure, panels = plt.subplots(1, len(shown), figsize=(11, 3.6), sharex=True, sharey=True)
    figure.subplots_adjust(left=0.06, right=0.92, bottom=0.14, top=0.92, wspace=0.06)
    ratios = sorted({k_t for k_t, _, _ in found if k_t > 0}, reverse=True)
    colours = dict(zip(ratios, plt.get_cmap("viridis")(np.linspace(0, 0.92, len(ratios)))))
    for axes, phi in zip(panels.flat, shown):
        bare = [p / rate**2 for (k_t, one, rate), (p, _) in found.items() if k_t == 0 and one == phi and rate <= 1e-4]
        if bare:
            x = np.array([1e-3, 3])
            axes.plot(x, np.mean(bare) * x, color=GREY, lw=0.9, ls=DASHED)
        for k_t in ratios:
            points = sorted((rate / k_t, p / rate / k_t, error, p) for (one_k, one, rate), (p, error) in found.items()
                            if one_k == k_t and one == phi)
            if points:
                x, y, error, p = map(np.array, zip(*points))
                axes.errorbar(x, y, y * error, color=colours[k_t], marker="o", ms=4, lw=0.8)
                soft = p > SOFT
                axes.plot(x[soft], y[soft], "o", ms=4, color="white", mec=colours[k_t], zorder=3)
        axes.set(xscale="log", yscale="log", title=rf"$\phi$ = {phi:g}")
        axes.set_xlabel(r"$\dot\gamma/k_t$")
    panels[0].set_ylabel(r"$p/(k_t\dot\gamma)$")
    names = {k_t: Line2D([], [], marker="o", ms=4, lw=0.8, color=colour) for k_t, colour in colours.items()}
    figure.legend(list(names.values()), [f"{k_t:g}" for k_t in names], loc="center right", title="$k_t/k_n$")
    return figure


def by_ratio(found):
    """p/(k_t gammadot): a row a value of gammadot/k_t that two ratios have, a column a ratio."""
    ratios = sorted({k_t for k_t, _, _ in found if k_t > 0}, reverse=True)
    rows = [["φ", "γ̇/k_t", *(f"k_t = {k_t:g}" for k_t in ratios)], ["---"] * (2 + len(ratios))]
    for phi in (0.82, 0.80, 0.78, 0.74):
        at = {}
        for (k_t, one, rate), (p, error) in found.items():
            if one == phi and k_t > 0:
                y = p / rate / k_t
                at.setdefault(float(f"{rate / k_t:.1e}"), {})[k_t] = measured(y, y * error) + ("*" if p > SOFT else "")
        for x in sorted(at):
            if len(at[x]) > 1:
                rows.append([f"{phi:g}", f"{x:.2g}", *(at[x].get(k_t, "") for k_t in ratios)])
    return table(rows)


def limits(found):
    """A row a density at which disks are hard: B_0 of no tangential damping, F where gammadot/k_t is 1e-3, where both meet, and exponents with the
    rate at two values of k_t over the same gammadot/k_t."""
    def cell(value, error):
        return measured(value, value * error)

    rows = [["φ", "B_0, from p at k_t = 0, γ̇ = 1e-4", "F at γ̇/k_t = 1e-3, k_t = 0.1", "F/B_0",
             "exponent, γ̇/k_t of 1e-3 to 0.01, k_t = 0.1", "the same, k_t = 0.01"], ["---"] * 6]
    for phi in sorted({one for _, one, _ in found}):
        if phi > HARD or (0, phi, 1e-4) not in found or (0.1, phi, 1e-4) not in found:
            continue
        (bare, bare_error), (p, error) = found[0, phi, 1e-4], found[0.1, phi, 1e-4]
        steep = [exponents(found, *pair).get((k_t, phi)) for k_t, pair in ((0.1, (1e-3, 1e-4)), (0.01, (1e-4, 1e-5)))]
        rows.append([f"{phi:g}", cell(bare / 1e-8, bare_error), cell(p / 1e-5, error),
                     cell(p / bare * 1e-3, math.hypot(error, bare_error)),
                     *("" if one is None else measured(*one) for one in steep)])
    return table(rows)


def checks(rows):
    """States by other methods and of more disks, beside those of the tables' own runs."""
    out = [["φ, k_t", "γ̇", "two stages, 1024 disks", "4096 disks", "the papers' scheme", "contacts as events"], ["---"] * 6]
    found = {}
    for row in rows:
        what = ("events" if row["integration.engine"] == "events" else
                "papers" if row["integration.scheme"].startswith("modified") else int(row["disks.count"]))
        key = tuple(row[name] for name in ("disks.packing_fraction", "disks.damping_tangential", "shear.strain_rate"))
        found.setdefault(key, {})[what] = row
    for (phi, k_t, rate), of in found.items():
        def cell(what, phi=phi, k_t=k_t, rate=rate, of=of):
            runs = [of[what]] if what in of else []
            if what == 1024:
                runs += [row for row in data("tangential") if row["shear.strain_rate"] == rate
                         and row["disks.packing_fraction"] == phi and row["disks.damping_tangential"] == k_t]
            if not runs:
                return ""
            (p, error), = means(runs).values()
            return measured(p / rate / k_t, p / rate / k_t * error)

        out.append([f"{phi:g}, {k_t:g}", f"{rate:g}", *map(cell, (1024, 4096, "papers", "events"))])
    return table(out)


def percent(share):
    return f"{100 * share:.0f}" if share > 0.1 else f"{100 * share:.2g}"


def clusters(rows, rate=1e-4):
    """A row a class of clusters, a column a density: shares and rms V_C_T, each collision once; in time."""
    rows = [row for row in rows if row["strain_rate"] == rate]
    least, densities = (sorted({row[name] for row in rows}) for name in ("least_disks", "packing_fraction"))
    found = {(row["packing_fraction"], row["least_disks"]): row for row in rows}
    out = [["disks", *(f"φ = {phi:g}" for phi in densities)], ["---"] * (1 + len(densities))]
    for first, after in zip(least, [*least[1:], math.inf]):
        name = f"{first:g} and more" if after == math.inf else f"{first:g}" if after == first + 1 else f"{first:g} to {after - 1:g}"

        def cell(phi, first=first):
            row = found[phi, first]
            if row["contacts_once"] < 100:
                return ""
            return "; ".join(f"{percent(row['share' + how])}%, {row['V_C_T_rms' + how]:.2f}" for how in ("_once", "_in_time"))

        out.append([name, *map(cell, densities)])
    return table(out)


def tables():
    """{name: table of the page}"""
    found = means(data("tangential"))
    result = {"ratios": by_ratio(found), "limits": limits(found)}
    if (DATA / "tangential_methods.csv").exists():
        result["checks"] = checks(data("tangential_methods"))
    if (DATA / "clusters.csv").exists():
        result["clusters"] = clusters(data("clusters"))
    return result


def page_with_tables():
    text = PAGE.read_text(encoding="utf-8")
    for name, new in tables().items():
        text = in_page(text, name, "tangential_page.py", new)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweeps", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--check", action="store_true", help="write nothing; exit status 1 if the page has other tables")
    given = parser.parse_args()
    if given.check:
        return page_with_tables() != PAGE.read_text(encoding="utf-8")
    if given.sweeps:
        for name in SOURCES:
            collect(name, given.sweeps)
        if (given.sweeps / "clusters/points").exists():
            collect_clusters(given.sweeps / "clusters")
    found = means(data("tangential"))
    with plt.rc_context(STYLE):
        save(diagram(found), PAGE.parent / "tangential_diagram.svg")
        save(collapse(found), PAGE.parent / "tangential_collapse.svg")
    PAGE.write_text(page_with_tables(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
