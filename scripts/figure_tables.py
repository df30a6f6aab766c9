#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes small tables of what the figures of the papers draw, to be kept with the source:

    scripts/figure_tables.py results/figures/data docs/data/figures [NAME...]

For each data set NAME of the first folder (a sweep, done or not; by default all that the figures use)
it writes NAME.csv into the second: a row for each finished point, its KEYS, then mean and standard
error of every observable that a figure names; and, where a panel shows more than averages, NAME.json:
{"points": [{"scene": {KEY: value}, PATH of result.h5: its content}]}. `bagnold figure NAME --data
docs/data/figures` draws from them alone. Means have six digits, errors three, all else four. What a
table has beside these points, from a sweep that is gone, it keeps.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import sys
import tomllib

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from bagnold.plots.figure_data import Point, same  # noqa: E402
from bagnold.scene import Scene  # noqa: E402

FIGURES = pathlib.Path(__file__).resolve().parents[1] / "inputs/figures/figures.toml"
KEYS = ("disks.packing_fraction", "disks.elasticity", "disks.count", "disks.box_aspect", "disks.seed",
        "shear.strain_rate", "shear.ramp_rate")
# What `bagnold analyse KIND` takes where no --x or --y says otherwise.
OWN = {"crossover": ["B_p_el"], "divergence": ["B_p_el", "p_el"], "friction-law": ["I", "mu"],
       "exponents": ["B_p"], "transition": ["Z", "B_p_el"], "kink": ["p_el"], "jump": ["R_v"],
       "peak": ["spin_var"], "constant-pressure": ["p", "mu"], "table": ["p"]}


def filled(node, values):
    """`values` put for {NAME} in texts, as `bagnold figure` does."""
    if isinstance(node, dict):
        return {key: filled(part, values) for key, part in node.items()}
    if isinstance(node, list):
        return [filled(part, values) for part in node]
    if not isinstance(node, str):
        return node
    for name, value in values.items():
        if node == f"{{{name}}}":
            return value
        node = node.replace(f"{{{name}}}", str(value))
    return node


def entries_of(figures):
    """(data sets, panel or stated number) of all figures, in full and quick."""
    for figure in figures.values():
        for quick in (False, True) if "quick" in figure else (False,):
            values = dict(figure.get("values", {}))
            if quick:
                values.update(figure["quick"].get("values", {}))
            for entry in figure["panel"] + figure.get("stated", []):
                data = entry.get("data", figure.get("data"))
                data = data if isinstance(data, list) else [data]
                if quick:
                    instead = figure["quick"]["data"]
                    data = [instead if isinstance(instead, str) else instead.get(d, "") for d in data]
                yield data, filled(entry, values)


def observables_of(words):
    """Observables that an analysis names."""
    names = list(OWN[words.split()[0]])
    for given in re.findall(r"--[xy] (\S+)", words):
        names += [part for part in re.split("[*/]", given) if "." not in part and part != "phi_J-phi"]
    return names


def paths_of(panel):
    """What a panel takes from result.h5."""
    if "histogram" in panel:
        return ["histograms/" + panel["histogram"]]
    if "profile" in panel:
        return ["profiles/" + panel["profile"]]
    if "samples" in panel:
        return [panel["samples"]]
    if "series" in panel:
        return ["series/" + name for name in (panel["series"], "strain_rate", "direction")]
    if "field" in panel:
        return ["samples/fields", "samples/fields_frame"]
    return []  # averages


def rounded(value, digits=4):
    return float(f"{value:.{digits - 1}e}") if np.isfinite(value) else None


def content(point, path):
    """A part of result.h5 as figure_data.Stored takes it."""
    if path.startswith("histograms/"):
        found = point.read(path)
        edges = found["edges"]
        return {"range": [float(edges[0]), float(edges[-1])],
                "density": [rounded(value) for value in found["density"]]}
    if path.startswith("samples/"):
        return {name: [rounded(value) for value in values]
                for name, values in point.columns(path).items()}
    found = point.read(path)
    if isinstance(found, dict):
        return {name: [rounded(value) for value in np.ravel(data)] for name, data in found.items()}
    return np.vectorize(rounded, otypes=[object])(found).tolist()


def points_of(folder):
    """(scene, folder) of the finished points, in the order of the sweep."""
    with open(folder / "points.json", encoding="utf-8") as file:
        listed = json.load(file)["points"]
    for one in listed:
        place = folder / "points" / one["folder"]
        if (place / "summary.json").exists():
            yield Scene(tomllib.loads(one["scene"])).flat(), place


def write_whole(path, text):
    part = path.with_name(path.name + ".part")
    part.write_text(text, encoding="utf-8")
    os.replace(part, path)


def keys_of(points):
    """Those that all points have; the shape of the box where one is not square."""
    keys = [key for key in KEYS if all(key in scene for scene, _ in points)]
    if all(scene.get("disks.box_aspect", 1) == 1 for scene, _ in points):
        keys = [key for key in keys if key != "disks.box_aspect"]
    return keys


def identity(row, keys):
    """What tells a point of a table from others, however its numbers are written."""
    return tuple(float(row[key]) for key in keys)


def rows_kept(path, head, keys, new):
    """Lines of the table at `path` whose points are not among `new` lines."""
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if rows and not set(keys) <= set(rows[0]):
        sys.exit(f"figure_tables.py: {path} lacks {sorted(set(keys) - set(rows[0]))}; its points cannot "
                 "be told from new ones. Move it away")
    found = {identity(dict(zip(head, line)), keys) for line in new}
    return [[row.get(name, "") for name in head] for row in rows if identity(row, keys) not in found]


def write_means(path, points, names):
    keys = keys_of(points)
    head = keys + [name + ending for name in names for ending in ("", "_error")]
    lines = []
    for scene, place in points:
        with open(place / "summary.json", encoding="utf-8") as file:
            found = json.load(file)["observables"]
        line = [f"{scene[key]:g}" if isinstance(scene[key], float) else scene[key] for key in keys]
        for name in names:
            one = found.get(name, {})
            for what, digits in (("mean", 6), ("error", 3)):
                value = one.get(what)
                line.append("" if value is None else f"{value:.{digits}g}")
        lines.append(line)
    lines = [head] + rows_kept(path, head, keys, lines) + lines
    part = path.with_name(path.name + ".part")
    with open(part, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(lines)
    os.replace(part, path)


def write_rest(path, points, panels):
    """`panels`: those of the data set that show more than averages."""
    stored = []
    keys = keys_of(points)
    for scene, place in points:
        wanted = {name for panel in panels for name in paths_of(panel)
                  if all(same(scene.get(k), v) for k, v in panel.get("where", {}).items())}
        point = Point(str(place), scene)
        if wanted:
            stored.append({"scene": {key: scene[key] for key in keys}}
                          | {name: content(point, name) for name in sorted(wanted)})
    if path.exists():
        with open(path, encoding="utf-8") as file:
            before = json.load(file)["points"]
        found = [entry["scene"] for entry in stored]
        stored = [entry for entry in before if entry["scene"] not in found] + stored
    if stored:
        lines = ",\n".join(json.dumps(one, separators=(",", ":")) for one in stored)
        write_whole(path, f'{{"points": [\n{lines}\n]}}\n')


def wanted(figures):
    """{data set: {observable: None}}, {data set: panels that show more than averages}."""
    names, panels = {}, {}
    for data, entry in entries_of(figures):
        for name in filter(None, data):
            names.setdefault(name, {})
            for words in [entry["analyse"]] if "analyse" in entry else []:
                for one in [words, *entry.get("of", {}).values()]:
                    names[name].update(dict.fromkeys(observables_of(one)))
            if paths_of(entry):
                panels.setdefault(name, []).append(entry)
    return names, panels


def main():
    line = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    line.add_argument("source", type=pathlib.Path, help="folder of sweeps, results/figures/data")
    line.add_argument("target", type=pathlib.Path, help="folder of tables, docs/data/figures")
    line.add_argument("names", nargs="*", help="data sets [all]")
    line.add_argument("--figures", type=pathlib.Path, default=FIGURES, help="figures.toml")
    options = line.parse_args()
    with open(options.figures, "rb") as file:
        names, panels = wanted(tomllib.load(file))
    for name in options.names or names:
        folder = options.source / name
        if options.names and not (folder / "points.json").exists():
            sys.exit(f"figure_tables.py: {folder} is no sweep; run it first")
        points = list(points_of(folder)) if (folder / "points.json").exists() else []
        if not points:
            continue
        options.target.mkdir(parents=True, exist_ok=True)
        write_means(options.target / f"{name}.csv", points, list(names.get(name, {})))
        write_rest(options.target / f"{name}.json", points, panels.get(name, []))
        print(f"{name}: {len(points)} points")


if __name__ == "__main__":
    main()
