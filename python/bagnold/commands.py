# SPDX-License-Identifier: BSD-3-Clause
"""Commands of the program on scenes and results: validate, status, analyse, check-limit."""

from __future__ import annotations

import csv
import json
import math
import os
import pathlib
import tomllib
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .errors import needed
from .program import Path, Progress, call, find_program, folder_of, said_by, scene_file
from .scene import Scene, key_of

if TYPE_CHECKING:
    from pandas import DataFrame


@dataclass(frozen=True)
class Validation:
    """Output of `bagnold validate` on a scene; printed, all of it."""

    text: str  #: as `bagnold validate` prints it
    scene: Scene  #: resolved; of a sweep file empty
    remarks: Mapping[str, str]  #: "time step", "steps", "memory", "estimated time", ...

    def __str__(self) -> str:
        return self.text


def validate(scene: Mapping[str, Any] | Path, *, program: Path | None = None, allow_unstable: bool = False,
             **set: Any) -> Validation:
    """Checks a scene, or a sweep file, and returns its steps, memory and time, which it estimates by a trial of a
    second.

    scene, set: as of `bagnold.run`. Raises InputError if it cannot be run."""
    keys = {key_of(name): value for name, value in set.items()}
    with scene_file(scene, keys) as (file, overrides):
        words = ["validate", file, *overrides] + (["--allow-unstable"] if allow_unstable else [])
        text = said_by(find_program(program), words, nobodys=file if isinstance(scene, Mapping) else None)
    remarks = {line[2:17].strip(): line[17:].strip() for line in text.splitlines() if line.startswith("# ")}  # in columns
    try:
        resolved = Scene(tomllib.loads(text))
    except tomllib.TOMLDecodeError:  # the points of a sweep
        resolved = Scene()
    return Validation(text, resolved, {name: what for name, what in remarks.items() if name and what})


@dataclass(frozen=True)
class Status:
    """Status of a run, a cascade or a sweep, whichever process works on it."""

    folder: pathlib.Path
    kind: str  #: "run", "cascade", "sweep"
    state: str  #: "done", "running", "stopped", "failed", "not begun"
    share: float  #: of its steps that are done, 0 .. 1
    seconds_left: float  #: NaN where unknown; of a sweep on one core
    holder: str  #: host and process that work on it; "": none
    warnings: tuple[str, ...] = ()  #: names, of a run that is done
    notes: tuple[str, ...] = ()
    strain: float = math.nan  #: at the last checkpoint; NaN where the length of the run is a time
    failure: str = ""  #: why it failed
    points: tuple[Status, ...] = field(default=(), repr=False)  #: rates of a cascade, points of a sweep


def status(folder: Path, *, program: Path | None = None) -> Status:
    """Status of a run, a cascade or a sweep. Raises InputError if the folder holds none."""
    place = pathlib.Path(folder)
    text = said_by(find_program(program), ["status", os.fspath(folder), "--json"], (0, 1))
    return _status_of(place, json.loads(text))


def _status_of(place: pathlib.Path, found: Mapping[str, Any]) -> Status:
    points = tuple(_status_of(place / one.get("folder", ""), one) for one in found.get("points", ()))
    states = [point.state for point in points]
    most = [one for one in ("running", "failed", "stopped", "not begun") if one in states]  # to be known of a sweep
    state = str(found.get("state") or (most[0] if most else "done"))
    left = found.get("seconds_left", found.get("core_seconds_left"))
    strain = found.get("strain")
    return Status(place, found.get("kind", "run"), state, float(found["share"]), math.nan if left is None else float(left),
                  found["holder"], tuple(found.get("warnings", ())), tuple(found.get("notes", ())),
                  math.nan if strain is None else float(strain), found.get("failure", ""), points)


class Analysis(Sequence[Mapping[str, Any]]):
    """Results of an analysis, a row a curve: ``a[0]["Q_star"]``. `path` is its table, PREFIX.csv."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path  #: PREFIX.csv
        with open(path, newline="", encoding="utf-8") as file:
            self._rows = [{name: _value(text) for name, text in row.items()} for row in csv.DictReader(file)]

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._rows[0]) if self._rows else []

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, which: Any) -> Any:
        """Row by its number."""
        return self._rows[which]

    def __iter__(self) -> Iterator[Mapping[str, Any]]:
        return iter(self._rows)

    def __repr__(self) -> str:
        return f"<analysis {self.path}: {len(self)} rows of {', '.join(self.columns)}>"

    def to_pandas(self) -> DataFrame:
        """The table. Needs pandas."""
        table: DataFrame = needed("pandas", "to_pandas()").DataFrame(self._rows)
        return table


def _value(text: str | None) -> Any:
    if text is None or text == "":
        return math.nan
    try:
        return float(text)
    except ValueError:
        return text


def analyse(kind: str, *sweeps: Path, out: Path | None = None, program: Path | None = None, format: str = "png",
            **options: Any) -> Analysis:
    """Fits and phase boundaries from sweeps, as by `bagnold analyse` (docs/analysis.md).

    kind: "crossover", "divergence", ... sweeps: folders, joined. out: prefix of its files, by default the first sweep
    and the kind. options: those of the command, ``y="B_p"``, ``log_x=True``, ``range=(1, 10)``, ``where={"disks.model":
    "CD"}``. Remarks of the analysis are warnings."""
    prefix = pathlib.Path(out) if out is not None else _folder_of_sweep(sweeps[0]) / kind if sweeps else pathlib.Path(kind)
    words = ["analyse", kind, *[str(os.fspath(one)) for one in sweeps], "--out", str(prefix), "--format", format, "--quiet"]
    for name, value in options.items():
        words += list(_words("--" + name.replace("_", "-"), value))
    for line in said_lines(find_program(program), words):
        warnings.warn(line.removeprefix("warning: "), stacklevel=2)
    return Analysis(pathlib.Path(f"{prefix}.csv"))


def said_lines(program: str, words: list[str]) -> list[str]:
    """Messages of the program on stderr."""
    said: list[str] = []
    said_by(program, words, errors=said)
    return said


def _folder_of_sweep(path: Path) -> pathlib.Path:
    place = pathlib.Path(path)
    return place if place.is_dir() or not place.suffix else place.parent


def _words(name: str, value: Any) -> Iterator[str]:
    """Words of the command line for an option given as a value of Python."""
    if value is True:
        yield name
    elif isinstance(value, Mapping):
        for key, one in value.items():
            yield from (name, f"{key}={one}")
    elif isinstance(value, (list, tuple)):
        yield from (name, *map(str, value))
    elif value is not False and value is not None:
        yield from (name, str(value))


@dataclass(frozen=True)
class LimitCheck:
    """Result of `bagnold check-limit`: is a rate small enough?"""

    folder: pathlib.Path
    verdict: str  #: "Bagnold", "Newton", "neither" or "undecided"
    found: Mapping[str, Any] = field(repr=False)  #: check_limit.json


def check_limit(scene: Mapping[str, Any] | Path, out: Path | None = None, *, tolerance: float = 0.05,
                jobs: int | None = None, program: Path | None = None, progress: Progress = True, **set: Any) -> LimitCheck:
    """Runs a scene at its rate and at half of it, and compares. The same call continues a run that was stopped.

    scene, set: as of `bagnold.run`. out: by default results/NAME-limit for a file. tolerance: relative change that
    counts as none."""
    keys = {key_of(name): value for name, value in set.items()}
    with scene_file(scene, keys) as (file, overrides):
        folder = folder_of(scene, out)
        if out is None:
            folder = folder.with_name(folder.name + "-limit")
        words = ["check-limit", file, *overrides, "--out", str(folder), "--tolerance", repr(float(tolerance))]
        words += [] if jobs is None else ["--jobs", str(jobs)]
        call(find_program(program), words, progress, str(folder), file if isinstance(scene, Mapping) else None, of_sweep=True)
    found = json.loads((folder / "check_limit.json").read_text(encoding="utf-8"))
    return LimitCheck(folder, found["verdict"], found)
