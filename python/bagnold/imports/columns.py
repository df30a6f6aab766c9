# SPDX-License-Identifier: BSD-3-Clause
"""Columns of disks by the names that programs use: LAMMPS, OVITO, ASE, QUIP and programs that follow them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from ..errors import InputError
from ..frames import Array
from .text import column

#: Each quantity, and what it may be called: small letters alone, as `_plain` leaves them. A vector may also come as a
#: column each axis, "velocityx" of OVITO's "Velocity.X".
NAMES = {
    "id": ("id", "ids", "identifier", "particleidentifier", "particleid", "atomid"),
    "type": ("type", "types", "species", "element", "elements", "symbol", "symbols", "particletype", "atomtype", "atomtypes",
             "numbers"),
    "radius": ("radius", "radii"), "diameter": ("diameter", "diameters"), "mass": ("mass", "masses"),
    "position": ("pos", "position", "positions", "coordinates", ""),
    "velocity": ("velo", "velocity", "velocities", "vel", "v"),
    "momentum": ("momenta", "momentum"),
    "spin": ("spin", "omega", "angularvelocity", "angularvelocities", "angvel"),
}
#: Rounding in files: numbers that say the same of a quantity twice.
SAME = 1e-5
SAME_VELOCITY = 1e-2  # ASE writes 8 digits behind the point, of velocities of 1e-5 too
UNREAD = "columns that are not read"


def _plain(name: str) -> str:
    return re.sub(r"[\s_.\-\[\]()]", "", name).lower()


class Columns:
    """Columns of a table, by names as in the file: [N] rows of words each."""

    def __init__(self, where: str, names: Sequence[str], words: Sequence[Sequence[Sequence[str]]],
                 row: Callable[[int], str]) -> None:
        """where: place of the header, and row: of a row, for messages. words: those of each name, [names][N]."""
        self.where, self._row = where, row
        self._all = list(zip(names, words))
        self._read: set[str] = set()

    def notes(self) -> list[str]:
        """Notes on columns that were not used."""
        left = [name for name in dict.fromkeys(name for name, _ in self._all) if name not in self._read]
        return [f"{UNREAD}: {' '.join(left)}"] if left else []

    def words(self, quantity: str) -> list[str] | None:
        """One word for each disk; None if there is no such column."""
        found = self._called(NAMES[quantity])
        if not found:
            return None
        self._refuse_widths(quantity, found, (1,))
        first = [row[0] for row in found[0][1]]
        for name, rows in found[1:]:
            if quantity != "type" and [row[0] for row in rows] != first:
                self._refuse_both(quantity, found[0][0], name)
        return first

    def scalar(self, quantity: str) -> Array | None:
        """Numbers, [N]; None if there is no such column."""
        return self._agreed(quantity, [(name, values[:, 0]) for name, values in self._numbers(quantity, (1,))])

    def vector(self, quantity: str) -> Array | None:
        """Vectors, [N, 3], z = 0 if the file has none; None if there is no such column."""
        return self._agreed(quantity, [(name, _in_space(values)) for name, values in
                                       self._numbers(quantity, (2, 3)) + self._by_axes(quantity)])

    def spin(self) -> Array | None:
        """Spins, [N], about z: the only component, or the third."""
        found = self._numbers("spin", (1, 3))
        for base in NAMES["spin"]:
            found += self._numbers_called((base + "z",), "spin", (1,))
        return self._agreed("spin", [(name, values[:, -1]) for name, values in found])

    def of_axes(self, names: Sequence[str]) -> Array | None:
        """Columns by exactly these names, [N, names], 0 if the third is missing; None if the first two are. Raises
        InputError if one of these is."""
        found = [self._numbers_called((name,), name, (1,)) for name in names]
        if not found[0] and not found[1]:
            return None
        for k in (0, 1):
            if not found[k]:
                raise InputError(f"{self.where}: has {names[1 - k]} and no {names[k]} (the plane of the disks is x y); write both")
        agreed = [self._agreed(name, [(one, values[:, 0]) for one, values in got]) for name, got in zip(names, found)]
        return np.column_stack([np.zeros(len(found[0][0][1])) if one is None else one for one in agreed])

    def diameter(self) -> Array | None:
        """Diameters, [N], from radii or diameters."""
        radius = self.scalar("radius")
        return self._agreed("diameter", [(name, values) for name, values in
                                         (("2 radius", None if radius is None else 2 * radius),
                                          ("diameter", self.scalar("diameter"))) if values is not None])

    def velocity(self, mass: Array | None) -> Array | None:
        """Velocities, [N, 2], or momenta divided by masses. Raises InputError if the two differ."""
        velocity = self.vector("velocity")
        heavy = mass is not None and bool(np.all(mass > 0))
        if velocity is None and not heavy and self._called(NAMES["momentum"]):
            raise InputError(f"{self.where}: momenta without masses (velocities need both, masses above 0); write masses, or velocities")
        momentum = self.vector("momentum") if heavy else None
        if momentum is not None and mass is not None:
            velocity = self._agreed("velocity", [(name, values) for name, values in (
                ("velocities", velocity), ("momenta over masses", momentum / mass[:, None])) if values is not None], SAME_VELOCITY)
        return None if velocity is None else velocity[:, :2]

    def _called(self, wanted: Sequence[str]) -> list[tuple[str, Sequence[Sequence[str]]]]:
        found = [(name, rows) for name, rows in self._all if _plain(name) in wanted]
        self._read.update(name for name, _ in found)
        return found

    def _numbers(self, quantity: str, widths: Sequence[int]) -> list[tuple[str, Array]]:
        return self._numbers_called([name for name in NAMES[quantity] if name], quantity, widths)

    def _numbers_called(self, wanted: Sequence[str], quantity: str, widths: Sequence[int]) -> list[tuple[str, Array]]:
        found = self._called(wanted)
        self._refuse_widths(quantity, found, widths)
        return [(name, column(rows, partial(self._place, name))) for name, rows in found]

    def _place(self, name: str, k: int) -> str:
        return f"{self._row(k)}, {name}"

    def _by_axes(self, quantity: str) -> list[tuple[str, Array]]:
        """Vectors from columns such as "vx", "vy"."""
        made = []
        for base in NAMES[quantity]:
            values = self.of_axes([base + axis for axis in "xyz"])
            if values is not None:
                made.append((f"{base}x {base}y", values))
        return made

    def _refuse_widths(self, quantity: str, found: Sequence[tuple[str, Sequence[Sequence[str]]]], widths: Sequence[int]) -> None:
        for name, rows in found:
            if rows and len(rows[0]) not in widths:
                raise InputError(f"{self.where}: {name} has {len(rows[0])} columns (must be {' or '.join(map(str, widths))} of a "
                                 f"{quantity}); mend the header, or make the file again")

    def _agreed(self, quantity: str, found: Sequence[tuple[str, Array]], within: float = SAME) -> Array | None:
        """Value on which all columns of a quantity agree, from the first. Raises InputError if they differ by more than
        rounding."""
        if not found:
            return None
        for name, values in found[1:]:
            if np.abs(values - found[0][1]).max(initial=0.0) > within * np.abs(found[0][1]).max(initial=0.0):
                self._refuse_both(quantity, found[0][0], name)
        return found[0][1]

    def _refuse_both(self, quantity: str, one: str, other: str) -> None:
        raise InputError(f"{self.where}: {one} and {other} differ (both are a {quantity}); take one of them out of the file")


def _in_space(values: Array) -> Array:
    return values if values.shape[1] == 3 else np.column_stack([values, np.zeros(len(values))])


def whole_ids(words: Sequence[str] | None, where: str) -> Array | None:
    """Identifiers as numbers, [N]. Raises InputError if one is not an integer."""
    if words is None:
        return None
    found = column([[word] for word in words], lambda _: where)[:, 0]
    if len(odd := np.nonzero(found % 1)[0]):
        raise InputError(f"{where}: {words[odd[0]]} (must be a whole number); the columns are not what their names say")
    return found
