# SPDX-License-Identifier: BSD-3-Clause
"""Types into which every format is read."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import FileError, InputError
from ..frames import Array, Box


@dataclass(frozen=True)
class Cell:
    """Box of the file, if it has one, and the assumptions made to read it."""

    box: Box  #: its tilt as the file has it, be it above half a width
    origin: Array  #: [3], its lower left corner
    notes: tuple[str, ...] = ()
    other: Box | None = None  #: what the same lines mean to other programs
    remedy: str = ""  #: the option that reads the other one

    def noted(self, *notes: str) -> Cell:
        """The cell with more notes."""
        return replace(self, notes=(*self.notes, *notes))

    def instead(self, other: Cell, remedy: str) -> Cell:
        """The cell with its alternative reading, and the option that selects it."""
        return replace(self, other=other.box, remedy=remedy)


@dataclass(frozen=True)
class Configuration:
    """Disks as a file has them, in its units, in the order of their ids."""

    names: list[str]  #: of each disk in messages, as "atom 7"
    kind: list[str]  #: type or element of each disk
    position: Array  #: [N, 3], from the lower left corner of the cell
    cell: Cell
    diameter: Array | None  #: [N]
    mass: Array | None  #: [N]
    velocity: Array | None  #: [N, 2], in the laboratory
    spin: Array | None  #: [N], counter-clockwise
    scaled: bool = False  #: the file has shares of the cell for positions
    velocity_in_box: bool = False  #: of the image in the box, wherever `position` is
    time: float = 0.0
    strain_rate: float | None = None
    notes: tuple[str, ...] = ()  #: what was assumed to read it

    @property
    def box(self) -> Box:
        """Box of the cell."""
        return self.cell.box

    def in_order_of(self, ids: Array | None, path: pathlib.Path) -> Configuration:
        """Disks by increasing id, [N]; unchanged if there are no ids. Raises InputError if one occurs twice."""
        if ids is None:
            return self
        order = np.argsort(ids, kind="stable")
        if len(twice := np.nonzero(np.diff(ids[order]) == 0)[0]):
            raise InputError(f"{path}: {self.names[order[twice[0]]]} is there twice (each id must be there once); make the file again")

        def of(values: Array | None) -> Array | None:
            return None if values is None else values[order]

        return replace(self, names=[self.names[k] for k in order], kind=[self.kind[k] for k in order], position=self.position[order],
                       diameter=of(self.diameter), mass=of(self.mass), velocity=of(self.velocity), spin=of(self.spin))


@dataclass(frozen=True)
class Wishes:
    """Options for data that a file may lack."""

    frame: int = -1  #: from 0, or from the end
    atom_style: str | None = None  #: of a LAMMPS data file
    bounds: str | None = None  #: of a tilted cell in a dump, "outer" or "edges"; None: as the file looks


def chosen(path: pathlib.Path, frames: Sequence[int], wanted: int) -> int:
    """Beginning of the frame in the file. Raises InputError."""
    try:
        return frames[wanted]
    except IndexError:
        raise InputError(f"--frame {wanted} ({path} has {len(frames)} frame{'s' if len(frames) > 1 else ''}); use 0 "
                         f"to {len(frames) - 1}, or -1 for the last") from None


def sheared_box(where: str, vectors: Array, remedy: str = "; turn the configuration") -> Box:
    """Sheared box of three vectors, [3, 3] rows: (L_x, 0, 0), (tilt, L_y, 0), and the third along z. Raises InputError,
    with `remedy` in the message."""
    (length, skew, _), (tilt, height, _), _ = vectors.tolist()
    size = float(np.abs(vectors[:2]).max())
    others = np.array([skew, vectors[0, 2], vectors[1, 2], vectors[2, 0], vectors[2, 1]])
    if not (length > 0 and height > 0) or np.abs(others).max() > 1e-12 * size:
        raise InputError(f"{where}: cell vectors {vectors.tolist()} (must be (L_x, 0, 0), (tilt, L_y, 0), (0, 0, L_z): "
                         f"flow along x, gradient along y){remedy}")
    return Box(length, height, tilt)


def refuse_walls(where: str, boundaries: Sequence[str], periodic: str) -> None:
    """Refuses boxes that are not periodic along x and y."""
    for name, found in zip("xy", boundaries):
        if found != periodic:
            raise InputError(f"{where}: the boundary along {name} is {found} (must be {periodic}: periodic; there are no "
                             "walls here); take a configuration without walls")


def name_of(path: str | os.PathLike[str]) -> pathlib.Path:
    """Name of an existing file. Raises FileError."""
    place = pathlib.Path(path)
    if not place.is_file():
        raise FileError(f"{place} is {'a folder' if place.is_dir() else 'not there'} (must be a LAMMPS data file, a LAMMPS "
                        "dump or extended XYZ)")
    return place
