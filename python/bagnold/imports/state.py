# SPDX-License-Identifier: BSD-3-Clause
"""From a configuration in the units of a file to a state in those of Bagnold."""

from __future__ import annotations

import pathlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..contacts import pairs_within
from ..errors import FileError, InputError
from ..files import replaced
from ..frames import Array, Box
from ..hdf5 import unlocked
from ..scene import toml_text
from .columns import UNREAD
from .configuration import Configuration
from .text import printable

SMALL, BIG = 1.0, 1.4  # d_s
LARGEST_OVERLAP = 0.2  # relative, above which a run stops
NO_PACKING = 0.5  # relative overlap, above which disks lie at random, or the box is another
STILL = 1e-9  # of the fastest disk: a mean velocity that is rounding


@dataclass(frozen=True)
class Units:
    """Units of a file in those of Bagnold, and the tolerance of its numbers."""

    length: float | None = None  #: d_s in the file's unit of length; None: its smallest diameter
    time: float = 1.0  #: tau_e in the file's unit of time
    strain_rate: float | None = None  #: in the file's unit; None: as the file says
    diameters: Mapping[str, float] = field(default_factory=dict)  #: by type, in the file's unit
    tolerance: float = 1e-6  #: relative, of diameters


@dataclass(frozen=True)
class ImportedState:
    """A written state file, and the keys that a scene needs to start from it."""

    path: pathlib.Path
    scene: dict[str, dict[str, Any]]  #: tables of a scene, to be joined with one's own
    notes: list[str]  #: what was found and what was assumed

    def __str__(self) -> str:
        return "".join(f"# {note}\n" for note in self.notes) + toml_text(self.scene).lstrip("\n")


def write_state(read: Configuration, units: Units, out: pathlib.Path) -> ImportedState:
    """Checks, converts, writes. Raises InputError, FileError."""
    for name, value in (("--unit", units.length), ("--time-unit", units.time), ("--tolerance", units.tolerance)):
        if value is not None and not (np.isfinite(value) and value > 0):
            raise InputError(f"{name} {value} (must be finite and above 0)")
    if len(read.position) < 2:
        raise InputError(f"the file has {len(read.position)} disks (must be at least 2)")
    found = _diameters(read, units)
    if read.mass is not None and not np.all(read.mass > 0):
        least = int(np.argmin(read.mass))
        raise InputError(f"mass of {read.names[least]} = {float(read.mass[least])!r} (must be above 0); mend the file, or take the masses "
                         "out of it")
    unit = float(found.min()) if units.length is None else units.length
    diameter, mass = _species(read, found / unit, units.tolerance), read.mass
    notes = [f"{len(diameter)} disks; d_s = {unit!r} of the file, tau_e = {units.time!r}", *read.notes]
    rate = units.strain_rate if units.strain_rate is not None else read.strain_rate
    box, position, rows = _place(read, unit)
    velocity = _velocity(read, units, unit, rate, box, position, rows, notes)
    rate = None if rate is None else rate * units.time
    if read.velocity is not None and rate is not None:
        velocity = _at_rest(velocity, rate, box, position, mass, notes)
    spin = None if read.spin is None else read.spin * units.time
    if spin is None:
        notes.append("no spins: where the law rotates the run begins with -strain_rate/2")
    if not all(np.isfinite(one).all() for one in (box.matrix, position, velocity, np.zeros(1) if spin is None else spin)):
        raise InputError("positions, velocities, spins or the box are too large for numbers (must be of the size of disks in a "
                         "simulation); look at the columns and at --unit")
    deepest = _deepest(box, position, diameter)
    _refuse_other_box(read, unit, diameter, deepest)
    scene = _scene(out, box, deepest, diameter, mass, notes)
    _write(out, {"position": position, "velocity": velocity, "spin": spin, "diameter": diameter}, box,
           read.time / units.time, rate)
    return ImportedState(out, scene, [printable(note) for note in notes])


def _diameters(read: Configuration, units: Units) -> Array:
    """Diameters in the file's unit, [N]."""
    if not units.diameters:
        if read.diameter is None:
            left = next((f" ({note})" for note in read.notes if note.startswith(UNREAD)), "")
            raise InputError(f"the file has no diameters{left}; say them by type, --diameters "
                             + ",".join(f"{kind}=D" for kind in sorted(set(read.kind))[:4]))
        least = int(np.argmin(read.diameter))
        if not read.diameter[least] > 0:
            raise InputError(f"diameter of {read.names[least]} = {float(read.diameter[least])!r} (must be above 0); say "
                             "those of the types, --diameters TYPE=D,TYPE=D")
        return read.diameter
    missing = sorted(set(read.kind) - set(units.diameters))
    if missing:
        raise InputError(f"--diameters has none of type {missing[0]}; say {missing[0]}=D too")
    return np.array([units.diameters[kind] for kind in read.kind])


def _species(read: Configuration, diameter: Array, tolerance: float) -> Array:
    """Diameters in d_s, exactly 1 or 1.4. Raises InputError for other ones."""
    near = np.where(np.abs(diameter - SMALL) < np.abs(diameter - BIG), SMALL, BIG)
    off = np.abs(diameter / near - 1)
    worst = int(np.argmax(off))
    if off[worst] > tolerance:
        raise InputError(f"diameter of {read.names[worst]} = {float(diameter[worst])!r} d_s (must be {SMALL} or {BIG}, within a "
                         f"relative {tolerance:g}; d_s is the smallest one, or --unit); only such mixtures are "
                         "simulated, --tolerance takes rounded diameters")
    small = int(np.sum(near == SMALL))
    if 2 * small != len(near):
        raise InputError(f"{small} of {len(near)} disks are small (must be half: {SMALL} d_s, the others {BIG}); take out "
                         "or add disks")
    return near


def _place(read: Configuration, unit: float) -> tuple[Box, Array, Array]:
    """Box in d_s, with its tilt in [-L_x/2, L_x/2); positions [N, 2] in it; and the number of heights by which each
    disk was above it."""
    z = read.position[:, 2]
    if np.ptp(z) > 1e-3 * unit:
        raise InputError(f"z goes from {z.min():g} to {z.max():g} (must be the same of all: disks move in a plane)")
    length, height = read.box.length / unit, read.box.height / unit
    tilt = read.box.tilt / unit
    if not -length / 2 <= tilt < length / 2:
        tilt -= length * float(np.floor(tilt / length + 0.5))
    box = Box(length, height, tilt)
    position = read.position[:, :2] / unit
    return box, box.wrapped(position), np.floor(position[:, 1] / height)


def _velocity(read: Configuration, units: Units, unit: float, rate: float | None, box: Box, position: Array,
              rows: Array, notes: list[str]) -> Array:
    """Velocities, [N, 2], d_s/tau_e, of the images in the box."""
    scaled = None if rate is None else rate * units.time
    if read.velocity is None:
        notes.append("no velocities: 0, as the file has no strain rate; --strain-rate gives those of the shear flow"
                     if scaled is None else f"no velocities: those of the shear flow, v_x = {scaled!r} y")
        flow = np.zeros_like(position)
        flow[:, 0] = (scaled or 0.0) * position[:, 1]
        return flow
    velocity = read.velocity * (units.time / unit)
    outside = np.nonzero(rows)[0]
    if len(outside) and not read.velocity_in_box:
        if scaled is None:
            raise InputError(f"{len(outside)} disks, as {read.names[outside[0]]}, are above or below the box (the velocities "
                             "of their images in it differ by strain_rate L_y); say --strain-rate, 0 of a box at rest")
        velocity[:, 0] -= scaled * box.height * rows
    if scaled is None:
        notes.append("no strain rate: velocities are taken as those of the run's own; --strain-rate says another, from which "
                     "start.rescale scales them")
    return velocity


def _at_rest(velocity: Array, rate: float, box: Box, position: Array, mass: Array | None, notes: list[str]) -> Array:
    """Velocities without the mean of v - gammadot y x_hat, which a run would keep; it appears for instance in boxes
    about the origin."""
    excess = velocity - np.outer(position[:, 1], [rate, 0.0])
    mean = np.average(excess, axis=0, weights=mass)
    least = STILL * np.abs(velocity).max() if mass is not None else 0.01 * abs(rate) * box.height
    if np.hypot(*mean) <= least:
        return velocity
    notes.append(f"mean of v - strain_rate y = ({mean[0]:.4g}, {mean[1]:.4g}) d_s/tau_e taken off: a run would keep it")
    return np.asarray(velocity - mean)


def _write(out: pathlib.Path, data: Mapping[str, Array | None], box: Box, time: float, rate: float | None) -> None:
    """Writes a state file (docs/files.md), whole or not at all."""
    units = {"position": "d_s", "velocity": "d_s/tau_e", "spin": "1/tau_e", "diameter": "d_s"}
    if not out.parent.is_dir():
        raise FileError(f"{out.parent} is no folder; make it first")
    with replaced(out) as part, unlocked(part, "w") as file:
        group = file.create_group("state")
        for name, values in data.items():
            if values is not None:
                group.create_dataset(name, data=values, dtype="<f8").attrs["unit"] = units[name]
        group["velocity"].attrs["frame"] = "laboratory"
        group.attrs["box_length"] = box.length
        if box.height != box.length:
            group.attrs["box_aspect"] = box.height / box.length
        group.attrs["offset"] = box.tilt + box.length if box.tilt < 0 else box.tilt
        group.attrs["time"] = time
        if rate is not None:
            group.attrs["strain_rate"] = rate


def _deepest(box: Box, position: Array, diameter: Array) -> float:
    """Largest relative overlap."""
    i, j, away, _ = pairs_within(position, box, diameter, 0.0)
    overlap = 1 - 2 * np.hypot(away[:, 0], away[:, 1]) / (diameter[i] + diameter[j])
    return float(overlap.max(initial=0.0))


def _refuse_other_box(read: Configuration, unit: float, diameter: Array, deepest: float) -> None:
    """Refuses a box in which disks overlap deeply, if they do not in the other possible box."""
    other = read.cell.other
    if other is None or deepest <= LARGEST_OVERLAP:
        return
    box = Box(other.length / unit, other.height / unit, other.tilt / unit)
    position = read.position[:, :2]
    if read.scaled:  # shares of the cell are the same in the other one
        position = position @ np.linalg.inv(read.box.matrix[:2, :2]) @ other.matrix[:2, :2]
    found = _deepest(box, box.wrapped(position / unit), diameter)
    if found <= LARGEST_OVERLAP:
        raise InputError(f"largest relative overlap {deepest:.3g} with L_x = {read.box.length:g}, {found:.3g} with L_x = {other.length:g} "
                         f"(the bounds of the file may mean both); say {read.cell.remedy} for the second")


def _scene(out: pathlib.Path, box: Box, deepest: float, diameter: Array, mass: Array | None, notes: list[str]
           ) -> dict[str, dict[str, Any]]:
    """Keys of a scene that the state needs."""
    disks: dict[str, Any] = {"count": len(diameter),
                             "packing_fraction": float(np.sum(np.pi / 4 * diameter**2) / box.area)}
    if box.height != box.length:
        disks["box_aspect"] = box.height / box.length
    if mass is not None and (kind := _masses(diameter, mass, notes)):
        disks["mass"] = kind
    start: dict[str, Any] = {"kind": "state", "file": str(out)}
    said = f"largest relative overlap: {deepest:.3g}"
    if deepest > NO_PACKING:
        said += (f", above {NO_PACKING:g}: no packing has such (the box, L_x = {box.length:.6g}, L_y = {box.height:.6g}, tilt "
                 f"{box.tilt:.6g} d_s, or the diameters are not those of the disks, unless they were put at random)")
    elif deepest > LARGEST_OVERLAP:
        said += f", above {LARGEST_OVERLAP:g}, where a run stops: start.relax pushes disks apart"
        start["relax"] = True
    notes.append(said)
    return {"disks": disks, "start": start}


def _masses(diameter: Array, mass: Array, notes: list[str]) -> str:
    """Value of disks.mass, "" if it has none."""
    means = [float(mass[diameter == one].mean()) for one in (SMALL, BIG)]
    spread = max(float(np.ptp(mass[diameter == one])) / mean for one, mean in zip((SMALL, BIG), means))
    if spread > 1e-3:
        notes.append(f"masses of disks of one size differ by up to {spread:.3g} of their mean: here they are equal; disks.mass is "
                     "\"equal\" or \"area\", choose one")
        return ""
    ratio = means[1] / means[0] if means[0] > 0 else np.nan
    for name, expected in (("equal", 1.0), ("area", (BIG / SMALL)**2)):
        if abs(ratio / expected - 1) < 1e-3:
            return name
    notes.append(f"a big disk has {ratio:.4g} times the mass of a small one: disks.mass is \"equal\" (1) or \"area\" (1.96), "
                 "choose one")
    return ""
