# SPDX-License-Identifier: BSD-3-Clause
"""Contacts of a configuration, with their forces by the contact law of the scene."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np

from .frames import Array, Box, Frame, Frames, Integers
from .scene import Scene

LAWS = ("CD", "CD_n", "CD_rot", "CD_nt")


@dataclass(frozen=True)
class Contacts:
    """The M pairs of disks with r_ij < d_ij of one frame; i < j unless a disk meets an image twice.

    Forces act on i from j; those on j are opposite. r_ij = r_i - r_j, counter-clockwise is positive."""

    count: int  #: N, disks in the frame
    box: Box
    i: Integers  #: [M]
    j: Integers  #: [M]
    normal: Array  #: [M, 2], r_ij / r_ij: from j to i
    separation: Array  #: [M], r_ij, d_s
    contact_distance: Array  #: [M], d_ij = (d_i + d_j)/2, d_s
    velocity: Array  #: [M, 2], d_s/tau_e: v_i - v_j, of the image of j; at the point of contact (P2 Eq. 6) where the law rotates
    elastic_force: Array  #: [M], m d_s/tau_e^2, magnitude along `normal`
    dissipative_force: Array  #: [M, 2], m d_s/tau_e^2; NaN for a law that this package does not know
    age: Array | None = None  #: [M], tau_e, since it began; NaN: at the start of the run, or before. None where
    #: the program did not write contacts (measure.contact_frames)

    def __len__(self) -> int:
        return len(self.i)

    @property
    def relative_overlap(self) -> Array:
        """1 - r_ij/d_ij, [M]."""
        return 1 - self.separation / self.contact_distance

    @property
    def overlap(self) -> Array:
        """d_ij - r_ij, [M], d_s."""
        return self.contact_distance - self.separation

    @property
    def force(self) -> Array:
        """Total force on i, [M, 2], m d_s/tau_e^2."""
        return self.elastic_force[:, None] * self.normal + self.dissipative_force

    @property
    def normal_force(self) -> Array:
        """f . n, positive where disks push, [M], m d_s/tau_e^2."""
        return np.asarray(self.force[:, 0] * self.normal[:, 0] + self.force[:, 1] * self.normal[:, 1], np.float64)

    @property
    def tangential_force(self) -> Array:
        """f . t with t = n rotated by 90 degrees counter-clockwise, [M], m d_s/tau_e^2."""
        return self.force[:, 1] * self.normal[:, 0] - self.force[:, 0] * self.normal[:, 1]

    @property
    def degree(self) -> Integers:
        """Number of contacts of each disk, [N]; its mean is Z."""
        return np.bincount(np.concatenate([self.i, self.j]), minlength=self.count)

    @property
    def Z(self) -> float:
        """Mean number of contacts of a disk."""
        return 2 * len(self) / self.count

    def stress(self, part: str = "all") -> Array:
        """-(1/A) sum f r of the pairs, negative in compression, [2, 2] with rows of f, m/tau_e^2; so
        p = -(s_xx + s_yy)/2 and sigma = s_xy as in the program. part: "all", "elastic" or "dissipative"."""
        force = {"all": self.force, "elastic": self.elastic_force[:, None] * self.normal,
                 "dissipative": self.dissipative_force}[part]
        return np.asarray(-force.T @ (self.separation[:, None] * self.normal) / self.box.area)


def contacts_of(frame: Frame, scene: Mapping[str, Any]) -> Contacts:
    """Contacts of a frame, forces by ``scene["disks"]``: model, elasticity, force_exponent, and
    damping_normal and damping_tangential of CD_nt. `r.contacts` does this for all frames of a run."""
    disks = Scene(scene)["disks"]
    law = str(disks["model"])
    i, j, away, rows = pairs_within(frame.position, frame.box, frame.diameter, 0.0)
    separation = np.hypot(away[:, 0], away[:, 1])
    normal = away / np.where(separation > 0, separation, 1)[:, None]
    distance = (frame.diameter[i] + frame.diameter[j]) / 2
    velocity = frame.velocity[i] - frame.velocity[j]
    velocity[:, 0] -= frame.strain_rate * rows * frame.box.height
    if frame.spin is not None:  # the lever arms are those to the point of contact, r_ij d_i / (d_i + d_j)
        lever = separation / (2 * distance) * (frame.diameter[i] * frame.spin[i]
                                               + frame.diameter[j] * frame.spin[j])
        velocity[:, 0] += lever * normal[:, 1]
        velocity[:, 1] -= lever * normal[:, 0]
    overlap = 1 - separation / distance
    elastic = overlap ** (float(disks.get("force_exponent", 2.0)) - 1) / distance
    return Contacts(len(frame), frame.box, i, j, normal, separation, distance, velocity, elastic,
                    _dissipative(law, disks, normal, velocity))


def _dissipative(law: str, disks: Mapping[str, Any], normal: Array, velocity: Array) -> Array:
    """f_dis on i, [M, 2], with k_d = 1/Q along the normal and along the tangent, as the law says (P2 Eqs. 3-5)."""
    if law not in LAWS:
        return np.full_like(velocity, np.nan)
    along, across = {"CD_n": (1.0, 0.0), "CD_nt": (float(disks.get("damping_normal", 1.0)),
                                                   float(disks.get("damping_tangential", 1.0)))
                     }.get(law, (1.0, 1.0))
    normal_part = np.sum(velocity * normal, axis=1)[:, None] * normal
    return np.asarray(-(along * normal_part + across * (velocity - normal_part)) / float(disks["elasticity"]))


def pairs_within(position: Array, box: Box, diameter: Array, beyond: float
                 ) -> tuple[Integers, Integers, Array, Array]:
    """Pairs with r_ij < d_ij + beyond: i, j, r_ij [M, 2], and rows [M]: the image of j is that many
    heights above j. Each pair once, in the order of (i, j)."""
    outside = np.floor(position[:, 1] / box.height)
    position = box.wrapped(np.asarray(position, dtype=np.float64))
    reach = float(diameter.max()) + beyond
    # slices of y, and cells of the coordinate along x in each, at least `reach` wide
    most = 4 + 2 * math.isqrt(len(position))  # no more cells than disks, in boxes that are nearly empty
    slices, cells = min(int(box.height / reach), most), min(int(box.length / reach), most)
    if slices < 3 or cells < 4:
        found = _all_pairs(position, box, diameter, beyond)
    else:
        found = _cell_pairs(position, box, diameter, beyond, slices, cells)
    i, j, away, rows = found
    order = np.lexsort((j, i))
    i, j = i[order], j[order]
    return i, j, away[order], rows[order] + outside[i] - outside[j]


def _keep(i: Integers, j: Integers, rows: Array, position: Array, box: Box, diameter: Array,
          beyond: float) -> tuple[Integers, Integers, Array, Array]:
    """Candidate pairs, j's image `rows` above j, that are near."""
    away = position[i] - position[j]
    away[:, 1] -= rows * box.height
    away[:, 0] -= rows * box.tilt
    away[:, 0] -= box.length * np.rint(away[:, 0] / box.length)
    near = np.hypot(away[:, 0], away[:, 1]) < (diameter[i] + diameter[j]) / 2 + beyond
    return i[near], j[near], away[near], rows[near]


def _all_pairs(position: Array, box: Box, diameter: Array, beyond: float
               ) -> tuple[Integers, Integers, Array, Array]:
    """Pairs in small boxes: all pairs with all images in y."""
    i, j = np.triu_indices(len(position), 1)
    parts = [_keep(i, j, np.full(len(i), float(row)), position, box, diameter, beyond)
             for row in (-1, 0, 1)]
    return (np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts]),
            np.concatenate([p[2] for p in parts]), np.concatenate([p[3] for p in parts]))


def _cell_pairs(position: Array, box: Box, diameter: Array, beyond: float, slices: int, cells: int
                ) -> tuple[Integers, Integers, Array, Array]:
    """Pairs by cells of a grid: each disk with its own cell, the next one, and those of the slice above, whose image is
    shifted by the tilt at the top of the box."""
    row = np.minimum((position[:, 1] / box.height * slices).astype(np.int64), slices - 1)
    column = np.minimum((position[:, 0] / box.length * cells).astype(np.int64), cells - 1)
    cell = row * cells + column
    order = np.argsort(cell, kind="stable")
    first = np.searchsorted(cell[order], np.arange(slices * cells + 1))
    width = box.length / cells
    everyone = np.arange(len(position))
    parts = []

    def visit(target_row: Integers, target_column: Integers, image: Array, half: bool) -> None:
        target = target_row * cells + target_column % cells
        count = first[target + 1] - first[target]
        i = np.repeat(everyone, count)
        offset = np.arange(len(i)) - np.repeat(np.cumsum(count) - count, count)
        j = order[np.repeat(first[target], count) + offset]
        rows = np.repeat(image, count)
        chosen = i < j if half else np.ones(len(i), dtype=bool)
        parts.append(_keep(i[chosen], j[chosen], rows[chosen], position, box, diameter, beyond))

    none = np.zeros(len(position))
    visit(row, column, none, half=True)
    visit(row, column + 1, none, half=False)
    above = (row + 1) % slices
    image = (row + 1 == slices).astype(float)
    # x of the disk as the slice above has it, where that is an image
    x = position[:, 0] - image * box.tilt
    there = np.floor(x / width).astype(np.int64)
    for step in (-1, 0, 1):
        visit(above, there + step, image, half=False)
    i, j, away, rows = (np.concatenate([part[k] for part in parts]) for k in range(4))
    swap = i > j
    i[swap], j[swap] = j[swap], i[swap]
    away[swap] *= -1
    rows[swap] *= -1
    return i, j, away, rows


def _written(frame: Frame, rows: Mapping[str, Any]) -> Contacts:
    """Contacts that the program wrote."""
    i, j = rows["pair"].T.astype(np.int64)
    distance = (frame.diameter[i] + frame.diameter[j]) / 2
    return Contacts(len(frame), frame.box, i, j, rows["normal"], distance - rows["overlap"], distance,
                    rows["velocity"], rows["elastic_force"], rows["dissipative_force"], rows["age"])


class ContactFrames(Sequence[Contacts]):
    """Contacts of each frame of a trajectory: those that the program wrote (measure.contact_frames), otherwise computed
    on access."""

    def __init__(self, frames: Frames, scene: Scene) -> None:
        self._frames, self._scene = frames, scene

    def __len__(self) -> int:
        return len(self._frames)

    @overload
    def __getitem__(self, which: int) -> Contacts: ...

    @overload
    def __getitem__(self, which: slice) -> ContactFrames: ...

    def __getitem__(self, which: int | slice) -> Contacts | ContactFrames:
        if isinstance(which, slice):
            return ContactFrames(self._frames[which], self._scene)
        return next(iter(self[range(len(self))[which]:]))

    def __iter__(self) -> Iterator[Contacts]:
        if self._frames.with_contacts:
            for frame, rows in self._frames.contact_rows():
                yield _written(frame, rows)
        else:
            for frame in self._frames:
                yield contacts_of(frame, self._scene)
