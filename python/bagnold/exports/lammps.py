# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS dumps: NAME.lammpstrj, with contacts NAME.contacts.dump (as of `dump local`), and
NAME.frames.csv with what a dump has no place for: time, strain and rate of each frame."""

from __future__ import annotations

import pathlib

import numpy as np

from ..contacts import ContactFrames
from ..files import beside
from ..frames import Box, Frame, Frames
from .text import in_cell, rows_of, written_whole


def _box(box: Box) -> str:
    """Bounds of the tilted cell; those in x are of its bounding box."""
    low, high = min(0.0, box.tilt), box.length + max(0.0, box.tilt)
    return (f"ITEM: BOX BOUNDS xy xz yz pp pp pp\n{low!r} {high!r} {box.tilt!r}\n"
            f"0.0 {box.height!r} 0.0\n-0.5 0.5 0.0\n")


def _disks(frame: Frame) -> str:
    position, image = in_cell(frame)
    zero = np.zeros(len(frame))
    names = "id type x y z"
    columns = [np.arange(1, len(frame) + 1), frame.species + 1, *position.T, zero]
    if image is not None:
        names += " ix iy iz"
        columns += [*image.T, np.zeros(len(frame), dtype=np.int64)]
    names += " vx vy vz radius mass"
    columns += [*frame.velocity.T, zero, frame.diameter / 2, frame.mass]
    if frame.spin is not None:
        names += " omegaz"
        columns.append(frame.spin)
    return (f"ITEM: TIMESTEP\n{frame.step}\nITEM: NUMBER OF ATOMS\n{len(frame)}\n{_box(frame.box)}"
            f"ITEM: ATOMS {names}\n{rows_of(columns)}")


def write(frames: Frames, contacts: ContactFrames | None, target: pathlib.Path) -> list[pathlib.Path]:
    """Writes the files; returns them."""
    told, pairs = beside(target, ".frames.csv"), beside(target, ".contacts.dump")
    with written_whole(told) as table, written_whole(target) as dump:
        table.write("step,time,strain,strain_rate,tilt\n")
        for frame in frames:
            dump.write(_disks(frame))
            table.write(f"{frame.step},{frame.time!r},{frame.strain!r},{frame.strain_rate!r},{frame.box.tilt!r}\n")
    if contacts is None:
        return [target, told]
    with written_whole(pairs) as dump:
        for frame, found in zip(frames, contacts):
            columns = [found.i + 1, found.j + 1, found.overlap, *found.normal.T, found.normal_force,
                       found.tangential_force]
            dump.write(f"ITEM: TIMESTEP\n{frame.step}\nITEM: NUMBER OF ENTRIES\n{len(found)}\n{_box(frame.box)}"
                       "ITEM: ENTRIES id1 id2 overlap nx ny normal_force tangential_force\n" + rows_of(columns))
    return [target, told, pairs]
