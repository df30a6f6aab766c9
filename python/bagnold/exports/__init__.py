# SPDX-License-Identifier: BSD-3-Clause
"""Trajectories in the formats of other programs.

    bagnold.export("results/first", "lammps")
    bagnold.export(r, "vtk", frames=slice(0, 100), contacts=True)
"""

from __future__ import annotations

import os
import pathlib
import re
from collections.abc import Callable
from typing import Union

from ..contacts import ContactFrames
from ..errors import FileError, InputError
from ..files import replaceable
from ..frames import Frames
from ..results import Run, load
from . import extxyz, gsd_file, lammps, vtk

Writer = Callable[[Frames, "ContactFrames | None", pathlib.Path], list[pathlib.Path]]

#: A format's name, how its files end, and what writes them.
FORMATS: dict[str, tuple[str, Writer]] = {
    "lammps": (".lammpstrj", lammps.write), "extxyz": (".xyz", extxyz.write),
    "gsd": (".gsd", gsd_file.write), "vtk": (".pvd", vtk.write)}


def export(run: Union[Run, str, "os.PathLike[str]"], to: str, out: str | os.PathLike[str] | None = None, *,
           frames: slice = slice(None), contacts: bool = False) -> list[pathlib.Path]:
    """Writes the trajectory of a run in another format; returns the files, the one to open first.

    to: "lammps" (dump), "extxyz", "gsd" (needs the library gsd) or "vtk". out: the file; by default trajectory.ENDING
    in the folder of the run, trajectory_SEED.ENDING for replicas. frames: a slice such as ``slice(0, 100, 10)``.
    contacts: also writes the contacts and their forces (not in extxyz, which cannot hold pairs). Raises InputError,
    FileError, MissingLibrary."""
    if to not in FORMATS:
        raise InputError(f"to = {to!r} (must be one of {', '.join(FORMATS)})")
    if contacts and to == "extxyz":
        raise InputError("--contacts with --to extxyz: the format has no place for pairs; use lammps, gsd or vtk")
    whole = run if isinstance(run, Run) else load(run)
    seeds = whole.seeds
    if out is not None and len(seeds) > 1:
        raise InputError(f"out with {len(seeds)} replicas (a file each): leave it out, they are written beside "
                         "the trajectories")
    ending, write = FORMATS[to]
    written: list[pathlib.Path] = []
    for seed in seeds:
        chosen = whole.frames_of(seed)[frames]
        if not len(chosen):
            raise InputError(f"frames = {frames.start}:{frames.stop} chooses none of the "
                             f"{len(whole.frames_of(seed))} frames of {whole.folder}")
        name = "trajectory" if len(seeds) == 1 else f"trajectory_{seed}"
        target = pathlib.Path(out) if out is not None else whole.folder / f"{name}{ending}"
        if not target.parent.is_dir():
            raise FileError(f"{target.parent} is no folder; make it first")
        replaceable(target)
        try:
            written += write(chosen, ContactFrames(chosen, whole.scene) if contacts else None, target)
        except OSError as error:
            if isinstance(error, FileError):
                raise
            raise FileError(f"{target} cannot be written: {error.strerror or error}") from error
    return written


def parse_frames(text: str) -> slice:
    """``A:B`` as in Python: ``10:20``, ``:5``, ``-1:``, ``::10``; ``7`` is one frame."""
    parts = text.split(":")
    right = all(re.fullmatch(r"-?[0-9]+|", part) for part in parts)
    numbers = [int(part) if part else None for part in parts] if right else []
    if not 1 <= len(numbers) <= 3 or (len(numbers) == 3 and numbers[2] == 0) or numbers == [None]:
        raise InputError(f"--frames {text} (must be A:B, numbers of frames from 0, either left out at will); "
                         "use 0:10 for the first ten, -1: for the last")
    if len(numbers) == 1 and numbers[0] is not None:
        return slice(numbers[0], numbers[0] + 1 or None)
    return slice(*numbers)
