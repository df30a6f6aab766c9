# SPDX-License-Identifier: BSD-3-Clause
"""Results in the folder of a run."""

from __future__ import annotations

import dataclasses
import functools
import json
import math
import os
import pathlib
import shlex
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from .contacts import ContactFrames
from .errors import FileError, InputError, NotOfThisRun, needed
from .files import regular, stamps
from .frames import Array, Frame, Frames, read_states
from .hdf5 import columns_of, open_hdf5, plain
from .observables import Observable, Warning, number, observable
from .scene import Scene

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame
    from xarray import Dataset


T = TypeVar("T")

BY_PIECES = ("sequence", "oscillate", "stress")  # protocols in which the shear may turn or stop


def kept_with(*files: str) -> Callable[[Callable[[Run], T]], Callable[[Run], T]]:
    """Keeps what is read of a run until one of these files (names or patterns) is another one."""
    def keeping(read: Callable[[Run], T]) -> Callable[[Run], T]:
        name: str = getattr(read, "__name__")

        @functools.wraps(read)
        def value(run: Run) -> T:
            now = stamps(run.folder, files)  # before the files are read: a change meanwhile is seen next time
            if name not in run._kept or run._kept[name][0] != now:
                run._kept[name] = now, read(run)
            found: T = run._kept[name][1]
            return found
        return value
    return keeping


class Series(Mapping[str, Array]):
    """/series of result.h5: ``series["B_p"]`` is [n], one value a window, of R replicas [R, n]; NaN
    where undefined. `discarded` windows at the front are in no average. Values are read on access."""

    def __init__(self, path: pathlib.Path, averaged: Callable[[], str] = str) -> None:
        """`averaged`: tells the attribute of the result with averages over parts of the series, "" for one over all."""
        self._path, self._averaged = path, averaged
        with open_hdf5(path) as file:
            if "series" not in file:
                raise FileError(f"{path} has no /series: it is no result of Bagnold")
            group = file["series"]
            self._names = list(group)
            self._units = {name: plain(group[name].attrs.get("unit", "")) for name in group}
            self._words = {name: plain(group[name].attrs.get("description", "")) for name in group}

    @property
    def discarded(self) -> int:
        """Windows of the transient, at the front."""
        return self._read()[0]

    def _read(self, *names: str) -> tuple[int, dict[str, Array]]:
        """Discarded windows and these series, of one state of the file."""
        for name in names:
            if name not in self._names:
                raise KeyError(f"{name} is not among the series: {', '.join(self._names)}")
        with open_hdf5(self._path) as file:
            group = file["series"]
            return (int(group.attrs.get("discarded_windows", 0)),
                    {name: np.asarray(group[name][()], dtype=np.float64) for name in names})

    def __getitem__(self, name: str) -> Array:
        return self._read(name)[1][name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def unit(self, name: str) -> str:
        """Unit of a series, "1" or in d_s, tau_e and m."""
        return str(self._units[name])

    def description(self, name: str) -> str:
        """Meaning of a series, in words."""
        return str(self._words[name])

    def measured(self, name: str) -> Array:
        """Windows of the averages, [n - discarded] or [R, n - discarded]. NotOfThisRun where each part has an average of
        its own."""
        if parts := self._averaged():
            raise NotOfThisRun(f"{self._path.parent} has an average for each of its {parts}, over the later part of each: take "
                               f"r.{parts}")
        discarded, found = self._read(name)
        return found[name][..., discarded:]


@dataclass(frozen=True)
class Histogram:
    """A density that integrates to the share between its edges."""

    edges: Array  #: [n + 1]
    density: Array  #: [n]


@dataclass(frozen=True)
class Profile:
    """Means over slices of y."""

    y: Array  #: [n], middle of the slice, d_s
    value: Array  #: [n]
    error: Array  #: [n], standard error; NaN where unknown


@dataclass(frozen=True)
class Branch:
    """One direction of the hysteresis loop of a ramp, in bins of a twentieth of a decade."""

    strain_rate: Array  #: [n], 1/tau_e
    mean: Array  #: [n]
    error: Array  #: [n], jackknife over passes; NaN below three


@dataclass(frozen=True)
class Piece:
    """One piece of a sequence, averaged over its later part. Beginnings are those in the first cycle."""

    strain_rate: float  #: 1/tau_e, of any sign; 0 of a stop
    begin_strain: float  #: since the start of the run
    strain: float  #: of the piece, with its sign
    begin_time: float  #: tau_e, since the start of the run
    time: float  #: tau_e, of the piece
    windows: int  #: measured, of all cycles and replicas
    mean: dict[str, float]  #: by the names of the series
    error: dict[str, float]  #: standard errors; NaN where unknown


@dataclass(frozen=True)
class Stress:
    """One stress of a list that was held, averaged over the later part of its time."""

    stress: float  #: m/tau_e^2
    strain: float  #: of the measured part
    windows: int  #: measured
    mean: dict[str, float]  #: by the names of the series, and "strain_rate"
    error: dict[str, float]  #: standard errors; NaN where unknown


@dataclass(frozen=True)
class Oscillation:
    """An oscillation gamma_0 sin(2 pi t/T), and its mean cycle: [K] values at the windows of a cycle."""

    amplitude: float  #: gamma_0
    period: float  #: T, tau_e
    cycles: int  #: in all
    discarded_cycles: int  #: the first ones, in no average
    strain: Array  #: [K]
    strain_rate: Array  #: [K], 1/tau_e
    sigma: Array  #: [K], m/tau_e^2
    sigma_error: Array  #: [K], standard errors; NaN where unknown
    p: Array  #: [K], m/tau_e^2
    p_error: Array  #: [K], as sigma_error


class Run:
    """Folder of a run. Files are read on access, and again when they have changed, so a run that is in progress can
    be read."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = pathlib.Path(folder)  #: where it lies
        self._kept: dict[str, tuple[object, Any]] = {}  # by attribute: stamps of its files, what was read of them

    def __repr__(self) -> str:
        return f"<run {self.folder}{'' if self.complete else ', not complete'}>"

    def _repr_html_(self) -> str:
        """Display in a notebook: averages with errors, warnings, notes."""
        from .html import of_run

        return of_run(self)

    def to_pandas(self) -> DataFrame:
        """All series, a row a window; of replicas the index is (seed, window). The windows of the transient too:
        ``frame[r.series.discarded:]``. Needs pandas."""
        pandas = needed("pandas", "to_pandas()")
        series, seeds = self.series, self.seeds
        _, values = series._read(*series)
        if len(seeds) == 1:
            frame = pandas.DataFrame(values)
            frame.index.name = "window"
        else:
            windows = next(iter(values.values())).shape[-1]
            index = pandas.MultiIndex.from_product([seeds, range(windows)], names=["seed", "window"])
            frame = pandas.DataFrame({name: np.broadcast_to(one, (len(seeds), windows)).ravel()
                                      for name, one in values.items()}, index=index)
        frame.attrs["units"] = {name: series.unit(name) for name in series}
        return frame

    def to_xarray(self) -> Dataset:
        """All series over the strain at the end of each window, or the time where the shear turns or stops (sequences,
        oscillations); of replicas over their seeds too. Units and meanings are attributes. Needs xarray."""
        xarray = needed("xarray", "to_xarray()")
        series, seeds = self.series, self.seeds
        along = "time" if self.scene.get("shear.protocol") in BY_PIECES else "strain"
        discarded, values = series._read(*series)
        axis = values[along]
        variables = {}
        for name, value in values.items():
            if name != along:
                dimensions = ("seed", along) if value.ndim == 2 else (along,)
                variables[name] = (dimensions, value, {"units": series.unit(name), "long_name": series.description(name)})
        if axis.ndim == 2:  # of a run that goes on some replicas are behind
            axis = axis[np.argmax(np.isfinite(axis).sum(axis=1))]
        coordinates = {along: (along, axis, {"units": series.unit(along)})}
        if len(seeds) > 1:
            coordinates["seed"] = ("seed", np.array(seeds), {})
        return xarray.Dataset(variables, coordinates, {"title": str(self.scene.get("title", "")),
                                                       "discarded_windows": discarded})

    @property
    def complete(self) -> bool:
        """True if the run has come to its end."""
        return (self.folder / "summary.json").exists()

    @property
    @kept_with("summary.json")
    def summary(self) -> dict[str, Any]:
        """summary.json as it is. FileError while the run is not complete."""
        return read_summary(self.folder)

    @property
    @kept_with("summary.json", "scene.toml")
    def scene(self) -> Scene:
        """The resolved scene, all defaults filled in: ``r.scene["disks.count"]``."""
        if self.complete and "scene" in self.summary:
            return Scene(self.summary["scene"])
        with _opened(self.folder / "scene.toml") as file:
            return Scene(tomllib.load(file))

    @property
    @kept_with("result.h5")
    def series(self) -> Series:
        """One value a window of every quantity."""
        return Series(self._file("result.h5"), self._averaged_parts)

    def _averaged_parts(self) -> str:
        stress = self.scene.get("shear.stress")
        by_stress = isinstance(stress, list) and len(stress) > 1
        return "pieces" if self.scene.get("shear.protocol") == "sequence" else "stresses" if by_stress else ""

    @property
    @kept_with("result.h5", "summary.json")
    def observables(self) -> dict[str, Observable]:
        """Averages by their names. FileError while the run is not complete, and of a cascade, whose
        rates have averages of their own (`points`)."""
        if "observables" not in self.summary:
            raise FileError(f"{self.folder} is a cascade, a run a rate: see r.points, or "
                            f"bagnold.sweep({str(self.folder)!r})")
        units = self.series if (self.folder / "result.h5").exists() else None
        return {name: observable(name, found, units.unit(name) if units and name in units else "")
                for name, found in self.summary["observables"].items()}

    def __getitem__(self, name: str) -> Observable:
        """``r["B_p"].mean, r["B_p"].error``."""
        found = self.observables
        if name not in found:
            raise KeyError(f"{name} is not among the averages of {self.folder}: "
                           f"{', '.join(found) or 'a ramp has none, see r.loop, nor a sequence, see r.pieces'}")
        return found[name]

    @property
    def points(self) -> list[Run]:
        """The runs of a cascade, one a rate, largest first; of a single run, itself."""
        if self.complete:
            return [Run(self.folder / one["folder"]) for one in self.summary["points"]] \
                if "points" in self.summary else [self]
        stages = sorted(path.parent for path in self.folder.glob("[0-9]*_strain_rate=*/scene.toml"))
        return [Run(stage) for stage in stages] or [self]

    @property
    @kept_with("result.h5", "summary.json")
    def replicas(self) -> list[dict[str, Observable]]:
        """Averages of each replica alone, in the order of `seeds`; of one system, of that one."""
        parts = self.summary.get("replicas")
        if parts is None:
            return [self.observables]
        return [{name: observable(name, found) for name, found in part["observables"].items()}
                for part in parts]

    @property
    def warnings(self) -> list[Warning]:
        """Reasons to doubt the result; empty if there are none."""
        return self._said("warnings")

    @property
    def notes(self) -> list[Warning]:
        """Remarks on the meaning of the numbers, for instance at a finite rate; nothing is wrong with them."""
        return self._said("notes")

    def _said(self, what: str) -> list[Warning]:
        return [Warning(one["name"], one["reason"], one["remedy"], dict(one["numbers"]), one.get("command", ""))
                for part in self.summary.get("points", [self.summary]) for one in part.get(what, [])]

    @property
    def seeds(self) -> list[int]:
        """Seeds of the replicas."""
        first = int(self.scene["disks.seed"])
        return list(range(first, first + int(self.scene.get("disks.replicas", 1))))

    @property
    @kept_with("result.h5")
    def about(self) -> dict[str, Any]:
        """Provenance of the result: version, git, compiler, seed, engine_NAME, ..."""
        with open_hdf5(self._file("result.h5")) as file:
            return {name: plain(value) for name, value in file.attrs.items()}

    # ------------------------------------------------------------------------------ configurations

    @property
    @kept_with("summary.json", "scene.toml", "checkpoint.h5", "trajectory*")
    def frames(self) -> Frames:
        """The trajectory, of replicas that of the first. FileError where none was written."""
        return self.frames_of(self.seeds[0])

    def frames_of(self, seed: int) -> Frames:
        """The trajectory of one replica."""
        seeds = self.seeds
        if seed not in seeds:
            raise InputError(f"seed = {seed} is not among those of {self.folder}: {seeds[0]} .. {seeds[-1]}")
        name = "trajectory" if len(seeds) == 1 else f"trajectory_{seed}"
        rate = float(self.scene.get("shear.strain_rate", math.nan))
        if self.scene.get("shear.protocol", "steady") != "steady":
            rate = math.nan
        whole, parts = self.folder / f"{name}.h5md", self.folder / f"{name}.parts"
        if whole.is_file() and (self.complete or not any(parts.glob("*.h5md"))):
            return Frames(whole, rate)
        if any(parts.glob("*.h5md")):  # beside the whole one of a finished run that is made longer they hold its frames too
            found = Frames(parts, rate)
            return max(found, Frames(whole, rate), key=len) if whole.is_file() else found
        spacing = f"output.{self.frame_spacing}"
        raise FileError(self._rates_apart() or f"{self.folder} has no {name}.h5md: " + (
            "no frame is written yet, the first ones come with a checkpoint"
            if self.scene.get(spacing) and not self.complete
            else f"set {spacing} between frames in the scene and run it again"))

    @property
    def frame_spacing(self) -> str:
        """Key of `[output]` that spaces the frames of its trajectory."""
        protocol = str(self.scene.get("shear.protocol", "steady"))
        return {"ramp": "trajectory_decades"}.get(protocol, "trajectory_time" if protocol in BY_PIECES else "trajectory_strain")

    @property
    def contacts(self) -> ContactFrames:
        """Contacts of each frame, with forces by the contact law of the scene."""
        return ContactFrames(self.frames, self.scene)

    @property
    def state(self) -> Frame:
        """The last state, of replicas that of the first."""
        return self.states[0]

    @property
    def states(self) -> list[Frame]:
        """The last states of all replicas."""
        file, by_area = self._file("state.h5"), self.scene.get("disks.mass") == "area"
        if not self.complete:
            return read_states(file, by_area)
        if self.scene.get("shear.protocol") not in BY_PIECES:
            return read_states(file, by_area, float(self.summary["strain"]["total"]))
        ends = np.atleast_2d(self.series["strain"])[:, -1]  # at given stress each replica has its own
        return [dataclasses.replace(state, strain=float(end)) for state, end in zip(read_states(file, by_area), ends)]

    # ------------------------------------------------------------------------- what else it has

    @property
    @kept_with("result.h5")
    def histograms(self) -> dict[str, Histogram]:
        """/histograms: those that `[measure]` switched on; of a ramp one for each frame."""
        return {name: Histogram(group["edges"], group["density"])
                for name, group in self._groups("histograms").items()}

    @property
    @kept_with("result.h5")
    def profiles(self) -> dict[str, Profile]:
        """/profiles over y, with `measure.profiles`; of a ramp one for each frame."""
        return {name: Profile(group["y"], group["value"],
                              group.get("error", np.full_like(group["value"], np.nan)))
                for name, group in self._groups("profiles").items()}

    @property
    @kept_with("result.h5")
    def samples(self) -> dict[str, dict[str, Array]]:
        """/samples: tables of rows that belong together, ``{column: [rows]}``."""
        with open_hdf5(self._file("result.h5")) as file:
            return {name: columns_of(table) for name, table in file.get("samples", {}).items()}

    def loop(self, name: str) -> dict[str, Branch]:
        """Hysteresis loop of an observable of a ramp: "up" and "down"."""
        if "loop" not in self.summary:
            raise InputError(f"{self.folder} is no ramp: it has no loop, its averages are r[{name!r}]")
        branches = {}
        for way, bins in self.summary["loop"].items():
            have = [one for one in bins if name in one["observables"]]
            if not have:
                raise KeyError(f"{name} is not among {', '.join(bins[0]['observables']) if bins else 'nothing'}")
            branches[way] = Branch(np.array([one["strain_rate"] for one in have]),
                                   np.array([number(one["observables"][name]["mean"]) for one in have]),
                                   np.array([number(one["observables"][name]["error"]) for one in have]))
        return branches

    @property
    @kept_with("summary.json")
    def pieces(self) -> list[Piece]:
        """Pieces of a sequence, in their order: ``r.pieces[0].mean["sigma"]``."""
        if "pieces" not in self.summary:
            raise NotOfThisRun(f"{self.folder} is no sequence: it has no pieces, its averages are r[\"p\"]")
        return [_piece(one) for one in self.summary["pieces"]]

    @property
    @kept_with("summary.json")
    def stresses(self) -> list[Stress]:
        """Stresses of a list that were held, in their order: ``r.stresses[0].mean["strain_rate"]``."""
        return [Stress(one["stress"], one["strain"], one["windows"], *_means(one["observables"]))
                for one in self.summary.get("stresses", [])]

    @property
    @kept_with("summary.json")
    def oscillation(self) -> Oscillation:
        """The mean cycle of an oscillation; its moduli are ``r["G_storage"]`` and ``r["G_loss"]``."""
        if "oscillation" not in self.summary:
            raise NotOfThisRun(f"{self.folder} is no oscillation: it has no mean cycle")
        found = self.summary["oscillation"]
        wave = {name: np.array([number(one) for one in values]) for name, values in found["waveform"].items()}
        return Oscillation(found["amplitude"], found["period"], found["cycles"], found["discarded_cycles"], wave["strain"],
                           wave["strain_rate"], wave["sigma"], wave["sigma_error"], wave["p"], wave["p_error"])

    def plot(self) -> Figure:
        """The picture of the run, plot.png. Needs matplotlib."""
        from . import plots

        return plots.run(self)

    def _groups(self, name: str) -> dict[str, dict[str, Array]]:
        with open_hdf5(self._file("result.h5")) as file:
            return {key: {part: np.asarray(values[()]) for part, values in group.items()}
                    for key, group in file.get(name, {}).items()}

    def _rates_apart(self) -> str:
        """Where the files of a cascade are; of a single run \"\"."""
        first = self.points[0].folder
        return "" if first == self.folder else f"{self.folder} is a cascade, a run a rate: take one of r.points, as {first}"

    def _file(self, name: str) -> pathlib.Path:
        path = self.folder / name
        if not path.exists():
            raise FileError(self._rates_apart() or f"{path} is not there: {_what_is(self.folder)}")
        return path


def load(folder: str | os.PathLike[str]) -> Run:
    """A run by its folder, or by a file in it.

    Raises FileError if there is none; sweeps are read by `bagnold.sweep`, and cascades as a table too."""
    place = pathlib.Path(folder)
    if place.is_file():
        place = place.parent
    if not (place / "scene.toml").exists() and not (place / "result.h5").exists():
        raise FileError(f"{place} is no folder of a run: {_what_is(place)}")
    return Run(place)


def _means(observables: dict[str, Any]) -> tuple[dict[str, float], dict[str, float]]:
    mean, error = ({name: number(one[part]) for name, one in observables.items()} for part in ("mean", "error"))
    return mean, error


def _piece(found: dict[str, Any]) -> Piece:
    mean, error = _means(found["observables"])
    return Piece(found["strain_rate"], found["begin_strain"], found["strain"], found["begin_time"], found["time"],
                 found["windows"], mean, error)


def read_summary(folder: pathlib.Path) -> dict[str, Any]:
    """summary.json of a run or a cascade."""
    path = folder / "summary.json"
    if not path.exists():
        raise FileError(f"{path} is not there: " + (
            f"the run is not complete, `bagnold resume {shlex.quote(str(folder))}` goes on with it"
            if (folder / "scene.toml").exists() else _what_is(folder)))
    with _opened(path) as file:
        try:
            found: dict[str, Any] = json.load(file)
        except ValueError as error:
            raise FileError(f"{path} is damaged: {error}") from error
    return found


def _what_is(folder: pathlib.Path) -> str:
    if not folder.exists():
        return "the folder is not there"
    if (folder / "sweep.toml").exists() or (folder / "sweep.h5").exists():
        return f"the folder is of a sweep, which bagnold.sweep({str(folder)!r}) reads"
    return "the folder holds no run" if not (folder / "scene.toml").exists() else "the run has not come that far"


def _opened(path: pathlib.Path) -> Any:
    try:
        return open(regular(path), "rb")
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error}") from error
