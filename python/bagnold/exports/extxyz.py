# SPDX-License-Identifier: BSD-3-Clause
"""Extended XYZ. Small disks are H, big ones He: readers want names of elements. Velocities are there twice: OVITO reads
`velo`, ASE `momenta`."""

from __future__ import annotations

import pathlib

import numpy as np

from ..contacts import ContactFrames
from ..frames import Frame, Frames
from .text import in_cell, rows_of, written_whole

ELEMENTS = np.array(["H", "He"])


def _frame(frame: Frame) -> str:
    position, image = in_cell(frame)
    zero = np.zeros(len(frame))
    momentum = frame.mass[:, None] * frame.velocity
    properties = "species:S:1:pos:R:3:velo:R:3:radius:R:1:masses:R:1:momenta:R:3"
    columns = [ELEMENTS[frame.species], *position.T, zero, *frame.velocity.T, zero, frame.diameter / 2, frame.mass,
               *momentum.T, zero]
    if frame.spin is not None:
        properties += ":spin:R:1"
        columns.append(frame.spin)
    if image is not None:
        properties += ":image:I:3"
        columns += [*image.T, np.zeros(len(frame), dtype=np.int64)]
    lattice = " ".join(repr(value) for value in frame.box.matrix.ravel().tolist())
    about = f"step={frame.step} time={frame.time!r}"
    if np.isfinite(frame.strain):
        about += f" strain={frame.strain!r}"
    if np.isfinite(frame.strain_rate):
        about += f" strain_rate={frame.strain_rate!r}"
    return (f'{len(frame)}\nLattice="{lattice}" Properties={properties} pbc="T T F" {about}\n'
            f"{rows_of(columns)}")


def write(frames: Frames, _contacts: ContactFrames | None, target: pathlib.Path) -> list[pathlib.Path]:
    """Writes the file; returns it."""
    with written_whole(target) as file:
        for frame in frames:
            file.write(_frame(frame))
    return [target]
