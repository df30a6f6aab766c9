# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps and cascades: a table of many runs."""

from __future__ import annotations

import math
import os
import pathlib
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from .errors import FileError, NotOfThisRun, needed
from .frames import Array
from .hdf5 import open_hdf5
from .results import Run, load, read_summary
from .scene import Scene

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset


@dataclass(frozen=True)
class Point:
    """A run of a sweep, or a rate of a cascade."""

    folder: pathlib.Path
    scene: Scene  #: resolved
    status: str  #: "done"; "failed": begun, no result; "open": not begun, or at work
    warnings: tuple[str, ...] = ()  #: their names

    def load(self) -> Run:
        """Results of the point."""
        return load(self.folder)


class Sweep(Sequence[Point]):
    """The points of a sweep in the order of its file; ``s["B_p"]`` is a column, [P]."""

    def __init__(self, folder: pathlib.Path, points: list[Point], varied: dict[str, NDArray[Any]],
                 observables: dict[str, Array], pieces: dict[str, Array] | None = None) -> None:
        self.folder, self._points, self._pieces = folder, points, pieces
        self.varied = varied  #: values of the varied keys, [P] each
        self._observables = observables

    @property
    def names(self) -> list[str]:
        """Observables of any point."""
        return [name for name in self._observables if not name.endswith(("_error", "_bias"))]

    def __len__(self) -> int:
        return len(self._points)

    @overload
    def __getitem__(self, which: int) -> Point: ...

    @overload
    def __getitem__(self, which: slice) -> list[Point]: ...

    @overload
    def __getitem__(self, which: str) -> NDArray[Any]: ...

    def __getitem__(self, which: int | slice | str) -> Point | list[Point] | NDArray[Any]:
        """A point by its number; a varied key or the means of an observable, [P], by their name, NaN
        where there is none."""
        if isinstance(which, str):
            for table in (self.varied, self._observables):
                if which in table:
                    return table[which]
            raise KeyError(f"{which} is neither a varied key ({', '.join(self.varied)}) nor an observable "
                           f"({', '.join(self.names)})")
        return self._points[which]

    def __iter__(self) -> Iterator[Point]:
        return iter(self._points)

    def __repr__(self) -> str:
        done = sum(point.status == "done" for point in self)
        return f"<sweep {self.folder}: {done} of {len(self)} points done>"

    def _repr_html_(self) -> str:
        """Display in a notebook: a row a point."""
        from .html import of_sweep

        return of_sweep(self)

    @property
    def pieces(self) -> Sweep:
        """Of sequences and lists of stresses: a row a piece of each point, with its number as the key ``piece``; columns are
        its averages and its place: ``strain_rate``, ``begin_strain``, ``strain``, ``begin_time`` and ``time`` of a piece,
        ``stress`` and ``strain`` of a stress."""
        if self._pieces is None:
            raise NotOfThisRun(f"{self.folder} is no sweep over sequences or lists of stresses: it has no pieces, its "
                               "columns are s[\"p\"]")
        of = self._pieces["point"].astype(int)
        varied = {key: values[of] for key, values in self.varied.items()}
        return Sweep(self.folder, [self._points[k] for k in of], {**varied, "piece": self._pieces["piece"]},
                     {name: values for name, values in self._pieces.items() if name not in ("point", "piece")})

    def to_xarray(self) -> Dataset:
        """Observables and their errors over the varied keys, one axis each where the points are a whole grid, else over
        `point`. Needs xarray."""
        xarray = needed("xarray", "to_xarray()")
        variables: dict[str, Any] = {"status": ("point", [point.status for point in self])}
        variables |= {name: ("point", value) for name, value in self._observables.items()}
        axes = {key: list(dict.fromkeys(value.tolist())) for key, value in self.varied.items()}
        table = xarray.Dataset(variables, {key: ("point", value) for key, value in self.varied.items()})
        places = set(zip(*(value.tolist() for value in self.varied.values())))
        if not axes or math.prod(map(len, axes.values())) != len(self) or len(places) != len(self):
            return table
        if len(axes) == 1:
            return table.swap_dims(point=next(iter(axes)))
        return table.set_index(point=list(axes)).unstack("point")

    def error(self, name: str) -> Array:
        """Standard errors of an observable, [P]."""
        return np.asarray(self[f"{name}_error"], dtype=np.float64)

    def bias(self, name: str) -> Array:
        """Biases of the method in an observable, [P]; their errors are ``error(f"{name}_bias")``. NaN where measure.bias
        was not asked for."""
        missing = np.full(len(self), math.nan)
        return np.asarray(self._observables.get(f"{name}_bias", missing), dtype=np.float64)

    def to_pandas(self) -> DataFrame:
        """One row a point: folder, status, varied keys, NAME and NAME_error, names of warnings.
        Needs pandas."""
        pandas = needed("pandas", "to_pandas()")
        return pandas.DataFrame({
            "folder": [str(point.folder) for point in self], "status": [point.status for point in self],
            **dict[str, Any](self.varied), **dict[str, Any](self._observables),
            "warnings": [" ".join(point.warnings) for point in self]})


def sweep(folder: str | os.PathLike[str]) -> Sweep:
    """A sweep by its folder (or its sweep.h5), or a cascade by its folder, one point a rate.

    Raises FileError if there is no table: a sweep that was killed has none until `bagnold sweep FILE --out DIR` is
    continued, or called with `--collect`."""
    place = pathlib.Path(folder)
    if place.is_file():
        place = place.parent
    if (place / "sweep.h5").exists():
        return _of_table(place)
    if (place / "summary.json").exists() and "points" in (found := read_summary(place)):
        return _of_cascade(place, found["points"])
    raise FileError(f"{place} has no sweep.h5 and is no cascade: " + (
        "the sweep has written no table yet, `bagnold sweep FILE --out DIR --collect` writes one of what is there"
        if (place / "points.json").exists() else "bagnold.load() reads a single run"))


def _of_table(place: pathlib.Path) -> Sweep:
    with open_hdf5(place / "sweep.h5") as file:
        points, observables = file["points"], file["observables"]
        texts = {name: [str(one) for one in points[name].asstr()[:]] for name in ("folder", "scene")}
        status, warnings = ([str(one) for one in file[name].asstr()[:]] for name in ("status", "warnings"))
        varied: dict[str, NDArray[Any]] = {}
        for key, values in points.items():
            if key not in texts:
                varied[key] = values[:] if values.dtype.kind == "f" else np.array(
                    [str(one) for one in values.asstr()[:]], dtype=object)
        means, pieces = ({name: np.asarray(values[:], dtype=np.float64) for name, values in group.items()}
                         for group in (observables, file.get("pieces", {})))
    return Sweep(place, [Point(place / "points" / name, Scene(tomllib.loads(scene)), done, tuple(words.split()))
                         for name, scene, done, words in zip(texts["folder"], texts["scene"], status, warnings)],
                 varied, means, pieces or None)


def _of_cascade(place: pathlib.Path, found: list[dict[str, Any]]) -> Sweep:
    points = [Point(place / one["folder"], load(place / one["folder"]).scene, "done",
                    tuple(warning["name"] for warning in one["warnings"])) for one in found]
    names = dict.fromkeys(name for one in found for name in one["observables"])
    means: dict[str, Array] = {}
    for name in names:
        entries = [one["observables"].get(name, {}) for one in found]
        measured = any("bias" in entry for entry in entries)
        for ending, what in (("", "mean"), ("_error", "error"),
                             *((("_bias", "bias"), ("_bias_error", "bias_error")) if measured else ())):
            means[name + ending] = np.array([math.nan if entry.get(what) is None else float(entry[what])
                                             for entry in entries])
    rates = np.array([float(one["strain_rate"]) for one in found])
    return Sweep(place, points, {"shear.strain_rate": rates}, means)
