# SPDX-License-Identifier: BSD-3-Clause
"""Configurations: frames of a trajectory, and the last state of a run."""

from __future__ import annotations

import copy
import math
import os
import pathlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from .errors import FileError, InputError
from .hdf5 import open_hdf5

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
GROUP = "particles/trajectory"


@dataclass(frozen=True)
class Box:
    """A Lees-Edwards cell with the vectors (length, 0) and (tilt, height), all in d_s."""

    length: float  #: L_x
    height: float  #: L_y
    tilt: float  #: shift in x of the image above, gamma L_y modulo L_x, in [-L_x/2, L_x/2)

    @property
    def matrix(self) -> Array:
        """Cell vectors as rows, [3, 3]; the third is (0, 0, 1)."""
        return np.array([[self.length, 0, 0], [self.tilt, self.height, 0], [0, 0, 1.0]])

    @property
    def area(self) -> float:
        """L_x L_y, d_s^2."""
        return self.length * self.height

    def nearest(self, away: Array) -> tuple[Array, NDArray[np.float64]]:
        """Differences [..., 2] reduced to the image nearest in y, then in x; and the number of heights, [...]. The
        image of the other disk moves by gammadot L_y times this number."""
        rows = np.rint(away[..., 1] / self.height)
        x = away[..., 0] - rows * self.tilt
        x = x - self.length * np.rint(x / self.length)
        return np.stack([x, away[..., 1] - rows * self.height], axis=-1), rows

    def wrapped(self, position: Array) -> Array:
        """Positions [N, 2] wrapped into the rectangle 0 <= x < L_x, 0 <= y < L_y."""
        rows = np.floor(position[:, 1] / self.height)
        x = position[:, 0] - rows * self.tilt
        return np.stack([x - self.length * np.floor(x / self.length),
                         position[:, 1] - rows * self.height], axis=1)


@dataclass(frozen=True)
class Frame:
    """One configuration of N disks, in the order of the start in all frames."""

    step: int  #: steps done
    time: float  #: tau_e
    strain: float  #: since step 0; NaN where the file does not tell
    strain_rate: float  #: 1/tau_e
    box: Box
    position: Array  #: [N, 2], d_s, in the box
    velocity: Array  #: [N, 2], d_s/tau_e, in the laboratory
    spin: Array | None  #: [N], 1/tau_e, counter-clockwise; None where the law does not rotate
    image: Integers | None  #: [N, 2], cell vectors to add to unwrap; None where the file has none
    diameter: Array  #: [N], d_s
    mass: Array  #: [N], m

    def __len__(self) -> int:
        return len(self.diameter)

    @property
    def species(self) -> Integers:
        """0 for small disks, 1 for big ones, [N]."""
        return (self.diameter > 1.2).astype(np.int64)

    @property
    def unwrapped(self) -> Array:
        """Positions without periodic images, [N, 2], d_s: displacements between frames are their differences. The
        cell's tilt is taken modulo L_x; `image` contains the correction."""
        if self.image is None:
            raise InputError("this frame has no image, which unwraps positions: it is of a state file "
                             "or of an older version; use bagnold.structure.unwrapped(frames)")
        return self.position + self.image @ self.box.matrix[:2, :2]

    @property
    def nonaffine_velocity(self) -> Array:
        """v - gammadot y x_hat, [N, 2], d_s/tau_e."""
        velocity = self.velocity.copy()
        velocity[:, 0] -= self.strain_rate * self.position[:, 1]
        return velocity

    @property
    def packing_fraction(self) -> float:
        """Area of the disks over that of the box."""
        return float(np.sum(np.pi / 4 * self.diameter**2) / self.box.area)


class _Part:
    """A file with frames, and the frames taken from it."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path
        with open_hdf5(path) as file:
            if GROUP not in file:
                raise FileError(f"{path} has no /{GROUP}: it is no trajectory of Bagnold")
            self.frames = len(file[GROUP]["position/step"])
            counts = file["contacts/count"][()] if "contacts" in file else np.zeros(0, dtype=np.int64)
            self.contact_ends = np.concatenate([[0], np.cumsum(counts)])


class Frames(Sequence[Frame]):
    """A trajectory: ``len(frames)``, ``frames[3]``, ``frames[::10]``, ``for frame in frames``.

    Frames are read on access only. During a run these are the frames up to its last checkpoint (its parts).
    ``positions`` and the like read all frames into one array."""

    def __init__(self, path: str | os.PathLike[str], strain_rate: float = math.nan) -> None:
        """path: trajectory.h5md, or the folder trajectory.parts. strain_rate: for files without rates, 1/tau_e."""
        self.path = pathlib.Path(path)
        self._rate = strain_rate
        self._parts = [_Part(one) for one in _part_files(self.path)]
        self._starts = np.concatenate([[0], np.cumsum([part.frames for part in self._parts])]).astype(int)
        self._chosen = range(int(self._starts[-1]))
        if not self._parts:
            raise FileError(f"{self.path} holds no frames")

    def __len__(self) -> int:
        return len(self._chosen)

    @overload
    def __getitem__(self, which: int) -> Frame: ...

    @overload
    def __getitem__(self, which: slice) -> Frames: ...

    def __getitem__(self, which: int | slice) -> Frame | Frames:
        if isinstance(which, slice):
            chosen = copy.copy(self)  # of the same files, which need not be looked through again
            chosen._chosen = self._chosen[which]
            return chosen
        return next(iter(self[range(len(self))[which]:]))

    def __iter__(self) -> Iterator[Frame]:
        for part, file, k in self._opened():
            yield self._read(file, k)

    def _opened(self) -> Iterator[tuple[_Part, Any, int]]:
        """The part of each frame, its open file, and the number of the frame in it."""
        opened, file = -1, None
        try:
            for frame in self._chosen:
                part = int(np.searchsorted(self._starts, frame, side="right")) - 1
                if part != opened:
                    if file is not None:
                        file.close()
                    opened, file = part, open_hdf5(self._parts[part].path)
                yield self._parts[part], file, frame - int(self._starts[part])
        finally:
            if file is not None:
                file.close()

    def __repr__(self) -> str:
        return f"<{len(self)} frames of {self.path}>"

    def _read(self, file: Any, k: int) -> Frame:
        group = file[GROUP]
        edges = group["box/edges/value"][k]
        scalars = file.get("observables/trajectory", {})

        def scalar(name: str, otherwise: float) -> float:
            return float(scalars[name]["value"][k]) if name in scalars else otherwise

        time = float(group["position/time"][k])
        rate = scalar("strain_rate", self._rate)
        strain = scalar("strain", math.nan)
        if math.isnan(strain) and not math.isnan(self._rate):  # an older file, of one rate
            strain = self._rate * (time - self._first_time())
        return Frame(
            step=int(group["position/step"][k]), time=time, strain=strain, strain_rate=rate,
            box=Box(float(edges[0, 0]), float(edges[1, 1]), float(edges[1, 0])),
            position=group["position/value"][k, :, :2], velocity=group["velocity/value"][k, :, :2],
            spin=group["spin/value"][k] if "spin" in group else None,
            image=group["image/value"][k, :, :2].astype(np.int64) if "image" in group else None,
            diameter=group["diameter"][:], mass=group["mass"][:])

    @property
    def with_contacts(self) -> bool:
        """True if the program wrote the contacts of each frame (measure.contact_frames)."""
        return len(self._parts[0].contact_ends) > 1

    def contact_rows(self) -> Iterator[tuple[Frame, dict[str, Any]]]:
        """Frames, and the data of contacts in the file for each, by the names of docs/files.md."""
        for part, file, k in self._opened():
            rows = slice(int(part.contact_ends[k]), int(part.contact_ends[k + 1]))
            group = file["contacts"]
            yield self._read(file, k), {name: group[name][rows] for name in group if name != "count"}

    def _first_time(self) -> float:
        with open_hdf5(self._parts[0].path) as file:
            return float(file[GROUP]["position/time"][0])

    def _all(self, path: str, columns: int | None = None) -> Array:
        rows: list[Array] = []
        for k, part in enumerate(self._parts):
            first, last = self._starts[k], self._starts[k + 1]
            inside = [frame - int(first) for frame in self._chosen if first <= frame < last]
            if inside:
                with open_hdf5(part.path) as file:
                    if path not in file:
                        raise InputError(f"{self.path} has no /{path}: the law does not rotate, or the "
                                         "file is of an older version")
                    values = file[path]
                    found = np.stack([values[k] for k in inside])
                    rows.append(found if columns is None else found[..., :columns])
        if self._chosen.step < 0:
            rows.reverse()
        return np.concatenate(rows) if rows else np.zeros((0,))

    @property
    def steps(self) -> NDArray[np.int64]:
        """Steps done at each frame, [T]."""
        return self._all(f"{GROUP}/position/step").astype(np.int64)

    @property
    def times(self) -> Array:
        """Times of the frames, [T], tau_e."""
        return self._all(f"{GROUP}/position/time")

    @property
    def strains(self) -> Array:
        """Strain of each frame since step 0, [T]."""
        return np.array([frame.strain for frame in self])

    @property
    def positions(self) -> Array:
        """All positions, [T, N, 2], d_s, in the box."""
        return self._all(f"{GROUP}/position/value", 2)

    @property
    def velocities(self) -> Array:
        """All velocities, [T, N, 2], d_s/tau_e, in the laboratory."""
        return self._all(f"{GROUP}/velocity/value", 2)

    @property
    def spins(self) -> Array:
        """All spins, [T, N], 1/tau_e, counter-clockwise. InputError where the law does not rotate."""
        return self._all(f"{GROUP}/spin/value")


def _part_files(path: pathlib.Path) -> list[pathlib.Path]:
    """The file itself, or the parts in a folder that the checkpoint beside it counts: others may be left from before a
    kill. Without such a checkpoint one for each number, the newest, up to the first that does not follow in steps."""
    if not path.is_dir():
        if not path.exists():
            raise FileError(f"{path} is not there")
        return [path]
    for names in _counted_parts(path.parent / "checkpoint.h5"):
        counted = [path / name for name in names]
        if counted and all(part.exists() for part in counted):
            return counted
    youngest: dict[str, pathlib.Path] = {}
    for part in sorted(path.glob("*.h5md"), key=lambda one: one.stat().st_mtime):
        youngest[part.name.split("_")[0]] = part
    parts: list[pathlib.Path] = []
    last = -1
    for part in (youngest[name] for name in sorted(youngest)):
        with open_hdf5(part) as file:
            steps = file[GROUP]["position/step"] if GROUP in file else [last + 1]  # _Part says what is wrong with it
            if int(steps[0]) <= last:
                break
            last = int(steps[-1])
        parts.append(part)
    return parts


def _counted_parts(checkpoint: pathlib.Path) -> list[list[str]]:
    """Names of the parts that a checkpoint counts, for each replica; [] where it cannot be read."""
    try:
        with open_hdf5(checkpoint) as file:
            replicas = [group["frames/trajectory_hashes"][()]
                        for group in (file["replicas"].values() if "replicas" in file else [file])
                        if "frames/trajectory_hashes" in group]
    except FileError:
        return []
    return [[f"{number:06}_{int(high) << 32 | int(low):016x}.h5md"
             for number, (high, low) in enumerate(zip(halves[::2], halves[1::2]))] for halves in replicas]


def read_states(path: pathlib.Path, masses_by_area: bool = False, strain: float = math.nan) -> list[Frame]:
    """States of a state.h5, one for each replica. The caller sets the strain."""
    with open_hdf5(path) as file:
        if "state" not in file:
            raise FileError(f"{path} has no /state: it is no state of Bagnold")
        group, about = file["state"], dict(file["state"].attrs)
        data = {name: np.asarray(group[name][()], dtype=np.float64) for name in group}
    if data["diameter"].ndim == 1:
        data = {name: values[None] for name, values in data.items()}
    aspect = float(about.get("box_aspect", 1))

    def own(name: str, r: int) -> float:  # a row where a controller led replicas apart
        return float(data[name][r]) if name in data else float(about.get(name, math.nan))

    def box(r: int) -> Box:
        length, offset = own("box_length", r), own("offset", r)
        return Box(length, aspect * length, offset - length * math.floor(offset / length + 0.5))

    return [Frame(step=-1, time=float(about["time"]), strain=strain, strain_rate=own("strain_rate", r), box=box(r),
                  position=data["position"][r], velocity=data["velocity"][r],
                  spin=data["spin"][r] if "spin" in data else None, image=None,
                  diameter=data["diameter"][r],
                  mass=np.pi / 2 * data["diameter"][r]**2 if masses_by_area
                  else np.ones_like(data["diameter"][r]))
            for r in range(len(data["diameter"]))]
