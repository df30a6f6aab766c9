# SPDX-License-Identifier: BSD-3-Clause
"""Configurations of other programs as states to start from.

    bagnold.import_state("packing.data", "state.h5")
"""

from __future__ import annotations

import math
import numbers
import os
import pathlib
import re
from collections.abc import Callable, Mapping

from ..errors import InputError
from . import extxyz, lammps_data, lammps_dump
from .configuration import Configuration, Wishes, name_of
from .lammps_bounds import EDGES, OUTER
from .state import ImportedState, Units, write_state
from .text import NUMBER, not_text, opened, printable

#: A format's name, and what reads it.
FORMATS: dict[str, Callable[[pathlib.Path, Wishes], Configuration]] = {
    "lammps": lammps_data.read, "dump": lammps_dump.read, "extxyz": extxyz.read}
ENDINGS = {".data": "lammps", ".lmp": "lammps", ".lammpstrj": "dump", ".dump": "dump", ".xyz": "extxyz",
           ".extxyz": "extxyz"}

__all__ = ["FORMATS", "ImportedState", "import_state", "parse_diameters", "parse_number"]


def import_state(file: str | os.PathLike[str], out: str | os.PathLike[str], *, format: str | None = None, frame: int = -1,
                 unit: float | None = None, time_unit: float = 1.0, strain_rate: float | None = None,
                 diameters: Mapping[str | int, float] | None = None, atom_style: str | None = None,
                 bounds: str | None = None, tolerance: float = 1e-6) -> ImportedState:
    """Writes a state file, for start.kind = "state", from a configuration of another program.

    format: "lammps" (data file), "dump" (of LAMMPS) or "extxyz"; by default detected. frame: from 0, or from the end.
    unit, time_unit: d_s and tau_e in the file's units; by default its smallest diameter, and 1. strain_rate: rate of
    the velocities, in 1 over the file's unit of time; by default as in the file. diameters: by type or element, in the
    file's unit, if it has none. atom_style: for a data file without a hint. bounds: of a tilted cell in a dump, "outer"
    for those of its bounding box, as LAMMPS writes, or "edges" for xlo and xhi; by default chosen by the positions of
    the disks. tolerance: relative, within which diameters are 1 and 1.4.

    Disks are in the order of their ids. Raises InputError, FileError. Assumptions are in `notes` of the returned value,
    and the keys that a scene needs in its `scene`; printed, both are a piece of a scene file."""
    place, target = name_of(file), pathlib.Path(out)
    if format is not None and format not in FORMATS:
        raise InputError(f"--from {format} (must be one of {', '.join(FORMATS)})")
    if not isinstance(frame, numbers.Integral):
        raise InputError(f"frame = {frame!r} (must be an integer: 0 is the first, -1 the last)")
    if bounds not in (None, OUTER, EDGES):
        raise InputError(f"--bounds {bounds} (must be {OUTER} or {EDGES})")
    try:
        read = FORMATS[format or _format_of(place)](place, Wishes(frame, atom_style, bounds))
        by_type = {str(kind): value for kind, value in (diameters or {}).items()}
        return write_state(read, Units(unit, time_unit, strain_rate, by_type, tolerance), target)
    except UnicodeError as error:
        raise not_text(place, str(error)) from error
    except InputError as error:  # words of the file may steer a terminal
        raise InputError(printable(str(error))) from error


def _format_of(path: pathlib.Path) -> str:
    """Format by the beginning of the file, otherwise by the ending of its name."""
    with opened(path) as file:
        head = [line for _, line in zip(range(60), file)]
    if head and re.match(r"\s*ITEM:", head[0], re.IGNORECASE):
        return "dump"
    if len(head) > 1 and re.fullmatch(r"\s*\d+\s*", head[0]) and re.search(r"(lattice|properties)\s*=", head[1], re.IGNORECASE):
        return "extxyz"
    if any(re.match(r"\s*\d+\s+atoms\b", line) for line in head):
        return "lammps"
    if path.suffix in ENDINGS:
        return ENDINGS[path.suffix]
    raise InputError(f"{path} is none of {', '.join(FORMATS)} by its first lines; say which, --from FORMAT")


def parse_number(option: str, text: str) -> float:
    """A number of the command line. Raises InputError."""
    value = float(text) if NUMBER.fullmatch(text.strip()) and "d" not in text.lower() else math.nan
    if not math.isfinite(value):
        raise InputError(f"{option} {text} (must be a number)")
    return value


def parse_diameters(text: str) -> dict[str | int, float]:
    """``1=1.0,2=1.4``, by type."""
    out: dict[str | int, float] = {}
    for part in text.split(","):
        kind, equals, value = part.partition("=")
        if not (kind.strip() and equals):
            raise InputError(f"--diameters {text} (must be TYPE=D,TYPE=D, as 1=1.0,2=1.4)")
        if kind.strip() in out:
            raise InputError(f"--diameters {text} (has {kind.strip()} twice); leave one out")
        out[kind.strip()] = parse_number("--diameters", value)
        if not out[kind.strip()] > 0:
            raise InputError(f"--diameters {text} (must be above 0)")
    return out
