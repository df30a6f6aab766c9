# SPDX-License-Identifier: BSD-3-Clause
"""Data of figures from the folder of a sweep, or from a table made of it (scripts/figure_tables.py): points picked by
scene keys, seeds taken together."""

import json
import math
import os
import tomllib

import h5py
import numpy as np

from ..files import regular
from ..hdf5 import columns_of, open_hdf5
from ..scene import Scene


def same(one, other):
    """True if a value of a scene equals the wanted one, or one of a list."""
    if isinstance(other, list) and not isinstance(one, list):
        return any(same(one, value) for value in other)
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return math.isclose(one, other, rel_tol=1e-9)
    return one == other


class Point:
    """A run of a sweep: `scene` by "table.key", and its result.h5."""

    def __init__(self, folder, scene):
        self.folder, self.scene = folder, scene

    def read(self, path):
        """A dataset of result.h5, or all of a group by name."""
        with open_hdf5(os.path.join(self.folder, "result.h5")) as file:
            found = file[path]
            if isinstance(found, h5py.Dataset):
                return found[()]
            return {name: data[()] for name, data in found.items()}

    def columns(self, path):
        """The columns of a /samples dataset by their names, without units."""
        with open_hdf5(os.path.join(self.folder, "result.h5")) as file:
            return columns_of(file[path])


class Stored:
    """A run of a table NAME.json: the part of a Point that is kept."""

    def __init__(self, entry):
        self.scene, self.kept = entry["scene"], entry

    def read(self, path):
        found = self.kept[path]
        if "density" in found:
            edges = np.linspace(*found["range"], len(found["density"]) + 1)
            return {"edges": edges, "density": np.array(found["density"], float)}
        if isinstance(found, dict):
            return {name: np.array(values, float) for name, values in found.items()}
        return np.array(found, float)

    columns = read


def points_in(source):
    """All points with results, in the order of the sweep."""
    if source.endswith(".json"):
        with open(regular(source), encoding="utf-8") as file:
            return [Stored(entry) for entry in json.load(file)["points"]]
    with open_hdf5(os.path.join(source, "sweep.h5")) as file:
        names, scenes, status = (file[path].asstr()[:]
                                 for path in ("points/folder", "points/scene", "status"))
    return [Point(os.path.join(source, "points", name), Scene(tomllib.loads(scene)).flat())
            for name, scene, done in zip(names, scenes, status) if done == "done"]


def points_of(sources, where):
    """Points of all existing sources whose scene agrees with `where`."""
    points = [point for source in sources if os.path.exists(source) for point in points_in(source)]
    return [p for p in points if all(same(p.scene.get(k), v) for k, v in where.items())]


def together(points, keys):
    """{values of keys: their points}; points of one entry differ in the seed only."""
    groups = {}
    for point in points:
        groups.setdefault(tuple(point.scene[key] for key in keys), []).append(point)
    return groups


def mean_and_error(values):
    """Mean and its error over seeds (axis 0); the error is NaN for one seed."""
    values = np.asarray(values, dtype=float)
    n = len(values)
    error = values.std(axis=0, ddof=1) / np.sqrt(n) if n > 1 else np.full(values.shape[1:], np.nan)
    return values.mean(axis=0), error


def profile(points, name):
    """y, mean, error of /profiles/NAME over seeds; one seed has its own error."""
    parts = [point.read(f"profiles/{name}") for point in points]
    mean, error = mean_and_error([part["value"] for part in parts])
    return parts[0]["y"], mean, parts[0]["error"] if len(parts) == 1 else error


def smoothed(value):
    """The mean of a profile, periodic in y, over a twentieth of the box."""
    width = max(1, len(value) // 20)
    around = np.concatenate([value[len(value) - width:], value, value[:width]])
    return np.convolve(around, np.ones(width) / width, "same")[width:-width]


def band_edges(y, value, level):
    """Places where the profile of a sheared box, periodic in y, crosses `level` between bands: of the mean over a
    twentieth of the box, without excursions below a quarter of the largest on their side, which are noise."""
    mean = smoothed(value) - level
    sides = np.sign(mean)
    for side in (1, -1):
        for run in runs_of(sides == side):
            if abs(mean[run]).max() < abs(mean[sides == side]).max() / 4:
                mean[run] = -1e-300 * side
    sides = np.where(mean < 0, -1, 1)
    return y[np.nonzero(np.diff(sides))[0]] + (y[1] - y[0]) / 2


def runs_of(chosen):
    """Indices of runs of chosen neighbours, the last and the first being neighbours."""
    if chosen.all():
        return [np.arange(len(chosen))]
    start = int(np.argmin(chosen))  # not chosen: no run goes across
    order = (np.arange(len(chosen)) + start) % len(chosen)
    pieces = np.split(order, np.nonzero(np.diff(chosen[order]))[0] + 1)
    return [piece for piece in pieces if chosen[piece[0]]]


def histogram(points, name):
    """Edges, mean density and its error over seeds."""
    parts = [point.read(f"histograms/{name}") for point in points]
    return (parts[0]["edges"], *mean_and_error([part["density"] for part in parts]))


def principal_axes(x, y):
    """Mean, and [(variance, unit vector)] of the covariance matrix, the larger one first."""
    values, vectors = np.linalg.eigh(np.cov(x, y))
    return (x.mean(), y.mean()), [(values[k], vectors[:, k]) for k in (1, 0)]
