# SPDX-License-Identifier: BSD-3-Clause
"""GSD, of HOOMD-blue, by its own library. Positions and velocities have single precision there; the box
is about the origin. Contacts are bonds with values in log/."""

from __future__ import annotations

import pathlib

import numpy as np

from ..contacts import ContactFrames, Contacts
from ..errors import MissingLibrary
from ..files import replaced
from ..frames import Frame, Frames
from .text import in_cell


def write(frames: Frames, contacts: ContactFrames | None, target: pathlib.Path) -> list[pathlib.Path]:
    """Writes the file; returns it. MissingLibrary without gsd."""
    try:
        import gsd.hoomd as hoomd
    except ImportError as error:
        raise MissingLibrary(
            f"--to gsd needs the library gsd ({error}; Debian: apt install python3-gsd; else `python3 -m venv ENV && ENV/bin/pip "
            "install gsd h5py`, then BAGNOLD_PYTHON=ENV/bin/python by its absolute path), or --to lammps, which needs "
            "nothing") from error
    new = hasattr(hoomd, "Frame")  # from 2.8 on; Debian 12 has 2.7
    made = hoomd.Frame if new else hoomd.Snapshot
    with replaced(target) as part, hoomd.open(str(part), "w" if new else "wb") as file:
        for k, frame in enumerate(frames):
            file.append(_frame(made(), frame, None if contacts is None else contacts[k]))
    return [target]


def _frame(made: object, frame: Frame, contacts: Contacts | None) -> object:
    box = frame.box
    position, image = in_cell(frame)
    zero = np.zeros(len(frame))
    made.configuration.step = max(0, frame.step)  # type: ignore[attr-defined]
    made.configuration.dimensions = 2  # type: ignore[attr-defined]
    made.configuration.box = [box.length, box.height, 0, box.tilt / box.height, 0, 0]  # type: ignore[attr-defined]
    particles = made.particles  # type: ignore[attr-defined]
    particles.N = len(frame)
    particles.types = ["small", "big"]
    particles.typeid = frame.species
    middle = np.array([box.length + box.tilt, box.height]) / 2
    particles.position = np.column_stack([position - middle, zero])
    particles.velocity = np.column_stack([frame.velocity, zero])
    particles.diameter, particles.mass = frame.diameter, frame.mass
    if image is not None:
        particles.image = np.column_stack([image, zero]).astype(np.int32)
    log = made.log  # type: ignore[attr-defined]
    log.update({"time": np.array([frame.time]), "strain": np.array([frame.strain]),
                "strain_rate": np.array([frame.strain_rate])})
    if frame.spin is not None:
        log["particles/spin"] = frame.spin
    if contacts is not None:
        bonds = made.bonds  # type: ignore[attr-defined]
        bonds.N, bonds.types = len(contacts), ["contact"]
        bonds.group = np.stack([contacts.i, contacts.j], axis=1)
        log.update({"bonds/overlap": contacts.overlap, "bonds/normal_force": contacts.normal_force,
                    "bonds/tangential_force": contacts.tangential_force})  # empty ones too, else those of the first frame
    return made
