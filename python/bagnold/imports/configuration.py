# SPDX-License-Identifier: BSD-3-Clause
"""What every format is read into."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TextIO

import numpy as np

from ..errors import FileError, InputError
from ..frames import Array, Box


@dataclass(frozen=True)
class Configuration:
    """Disks as a file has them, in its units, in the order of their ids."""

    names: list[str]  #: of each disk in messages, as "atom 7"
    kind: list[str]  #: type or element of each disk
    position: Array  #: [N, 3], from the lower left corner of the box
    box: Box  #: its tilt as the file has it, be it above half a width
    diameter: Array | None  #: [N]
    mass: Array | None  #: [N]
    velocity: Array | None  #: [N, 2], in the laboratory
    spin: Array | None  #: [N], counter-clockwise
    velocity_in_box: bool = False  #: of the image in the box, wherever `position` is
    time: float = 0.0
    strain_rate: float | None = None


@dataclass(frozen=True)
class Wishes:
    """What a file may leave open."""

    frame: int = -1  #: from 0, or from the end
    atom_style: str | None = None  #: of a LAMMPS data file


def opened(path: pathlib.Path) -> TextIO:
    """A file of text. Raises FileError."""
    try:
        return open(path, encoding="utf-8", errors="strict")
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error.strerror or error}") from error


def chosen(path: pathlib.Path, frames: Sequence[int], wanted: int) -> int:
    """Where in the file the frame begins. Raises InputError."""
    try:
        return frames[wanted]
    except IndexError:
        raise InputError(f"--frame {wanted} ({path} has {len(frames)} frame{'s' if len(frames) > 1 else ''}); use 0 "
                         f"to {len(frames) - 1}, or -1 for the last") from None


def numbers(words: Iterable[str], where: str) -> list[float]:
    """Words as finite numbers. Raises InputError."""
    found = []
    for word in words:
        try:
            value = float(word)
        except ValueError:
            raise InputError(f"{where}: {word!r} is no number; mend the file, or make it again") from None
        if not np.isfinite(value):
            raise InputError(f"{where}: {word} (must be finite); the run that wrote it had failed by then")
        found.append(value)
    return found


def whole_number(rows: Sequence[str], where: str) -> int:
    """The first word of the first row. Raises InputError where there is none."""
    words = rows[0].split()[:1] if rows else []
    if not words or numbers(words, where)[0] != int(float(words[0])):
        raise InputError(f"{where}: {' '.join(words) or 'nothing'} (must be a whole number); the file is damaged")
    return int(float(words[0]))


def table(rows: Sequence[str], columns: int, where: Callable[[int], str]) -> list[list[str]]:
    """Rows of words, of at least this many columns. Raises InputError."""
    split = [row.split() for row in rows]
    for k, words in enumerate(split):
        if len(words) < columns:
            raise InputError(f"{where(k)}: {len(words)} columns (must be {columns}): {rows[k].strip()!r}; the file is "
                             "cut short, or of another style")
    return split


def in_order(ids: Array, path: pathlib.Path) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    """Which rows to take for increasing ids. Raises InputError where one is there twice."""
    order = np.argsort(ids, kind="stable")
    twice = np.nonzero(np.diff(ids[order]) == 0)[0]
    if len(twice):
        raise InputError(f"{path}: atom {ids[order[twice[0]]]:.0f} is there twice (each id must be there once); make "
                         "the file again")
    return order.astype(np.int64)


def sheared_box(path: pathlib.Path, vectors: Array) -> Box:
    """The cell of three vectors, [3, 3] rows: (L_x, 0, 0), (tilt, L_y, 0), and the third along z."""
    (length, skew, _), (tilt, height, _), _ = vectors.tolist()
    size = float(np.abs(vectors[:2]).max())
    others = np.array([skew, vectors[0, 2], vectors[1, 2], vectors[2, 0], vectors[2, 1]])
    if not (length > 0 and height > 0) or np.abs(others).max() > 1e-12 * size:
        raise InputError(f"{path}: cell vectors {vectors.tolist()} (must be (L_x, 0, 0), (tilt, L_y, 0), (0, 0, L_z): "
                         "flow along x, gradient along y); turn the configuration")
    return Box(length, height, tilt)


def refuse_walls(path: pathlib.Path, x: str | bool, y: str | bool, periodic: str | bool) -> None:
    """Only periodic boxes are sheared here."""
    for name, found in (("x", x), ("y", y)):
        if found != periodic:
            raise InputError(f"{path}: the boundary along {name} is {found} (must be {periodic}: periodic; there are no "
                             "walls here); take a configuration without walls")


def text_or_refuse(path: pathlib.Path, error: UnicodeDecodeError) -> FileError:
    """What to say of a file that is no text."""
    return FileError(f"{path} is no text ({error.reason} at byte {error.start}): it is compressed or binary; unpack it, "
                     "or write it as text")


def name_of(path: str | os.PathLike[str]) -> pathlib.Path:
    """A file that is there. Raises FileError."""
    place = pathlib.Path(path)
    if not place.is_file():
        raise FileError(f"{place} is {'a folder' if place.is_dir() else 'not there'} (must be a LAMMPS data file, a LAMMPS "
                        "dump or extended XYZ)")
    return place
