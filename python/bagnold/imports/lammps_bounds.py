# SPDX-License-Identifier: BSD-3-Clause
"""ITEM: BOX BOUNDS of a dump, as written by LAMMPS and by other programs.

LAMMPS writes the bounds of the bounding box of a tilted cell, `xlo + min(0, xy)` to `xhi + max(0, xy)`; other programs
write xlo and xhi themselves. Both have the same form."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from ..frames import Array, Box
from .configuration import Cell, refuse_walls, sheared_box
from .text import NUMBER, numbers

TILTS = ("xy", "xz", "yz")
OUTER, EDGES = "outer", "edges"  # --bounds
ROUNDING = 1e-5  # of numbers with six digits, relative
LOOSE = 0.2  # of the smallest diameter, else of the mean distance: how far LAMMPS lets disks out between two lists


@dataclass(frozen=True)
class Bounds:
    """Numbers and words of the lines."""

    where: str  #: in messages
    rows: Array  #: [3, 2], lowest and highest of x, y, z
    tilt: float  #: xy
    named: str  #: what words behind the numbers call them: OUTER, EDGES or ""
    notes: list[str]

    def cell(self, kind: str) -> Cell:
        """Cell with the bounds of its bounding box, or with its edges; its L_x may be below 0."""
        low, high = self.rows[0]
        if kind == OUTER:
            low, high = low - min(0.0, self.tilt), high - max(0.0, self.tilt)
        length, height = float(high - low), float(self.rows[1, 1] - self.rows[1, 0])
        if abs(length - height) < 1e-12 * height:  # bounds that hold the tilt cost digits of L_x
            length = height
        return Cell(Box(length, height, self.tilt), np.array([low, self.rows[1, 0], 0.0]))


def read_cell(where: str, words: str, rows: Sequence[str], asked: str | None, position: Array | None, size: float | None
              ) -> Cell:
    """Cell of a frame.

    words, rows: text behind and below ITEM: BOX BOUNDS. asked: OUTER or EDGES, None: detected. position: [N, 3], in the
    file's coordinates, of the images in the cell; None if it holds none. size: smallest diameter, if known. Raises
    InputError if the cell is ambiguous."""
    if words.lower().startswith("abc"):
        return _by_vectors(where, words, rows)
    bounds = _bounds(where, words, rows)
    outer, edges = bounds.cell(OUTER), bounds.cell(EDGES)
    if edges.box.length <= 0 or edges.box.height <= 0:
        raise InputError(f"{where}: L_x = {edges.box.length}, L_y = {edges.box.height} (must be above 0)")
    if not bounds.tilt:
        return outer.noted(*bounds.notes)
    if asked is not None or bounds.named == OUTER:
        chosen = edges if asked == EDGES else outer
        if chosen.box.length <= 0:
            raise InputError(f"{where}: L_x = {chosen.box.length} (must be above 0: as bounds of all that the cell covers they "
                             f"hold the tilt, {bounds.tilt}); say --bounds {EDGES} if they are xlo and xhi")
        return chosen.noted(*bounds.notes)
    if outer.box.length <= 0:
        return edges.noted(*bounds.notes, f"BOX BOUNDS read as xlo and xhi, L_x = {edges.box.length!r}: LAMMPS' bounds hold the tilt, "
                           f"{bounds.tilt!r}, which these cannot")
    if bounds.named == EDGES:
        raise _unclear(bounds, outer, edges, "the words behind the numbers say xlo xhi")
    other = f"--bounds {EDGES} reads them as xlo and xhi, L_x = {edges.box.length!r}"
    if position is None:
        bounds.notes.append(f"BOX BOUNDS read as LAMMPS writes them, L_x = {outer.box.length!r}; {other}: positions of this kind do not tell")
    else:
        _refuse_other_cell(bounds, outer, edges, position, LOOSE * (size or _spacing(outer, position)), other)
    return outer.noted(*bounds.notes).instead(edges, f"--bounds {EDGES}")


def _refuse_other_cell(bounds: Bounds, outer: Cell, edges: Cell, position: Array, loose: float, other: str) -> None:
    """Raises InputError if disks are outside LAMMPS's cell, farther than it lets them move between two lists, and
    inside the other one."""
    if _holds(outer, position, 0.0):
        return
    few = f"disks lie outside the cell by up to {loose:.2g}, as LAMMPS lets them between two lists; {other}"
    if _inside(outer, position, loose).all() and abs(bounds.tilt) > 2 * loose:
        bounds.notes.append(few)
        return
    for margin in (0.0, loose):
        if _holds(outer, position, margin):
            bounds.notes.append(few)
            return
        if _holds(edges, position, margin):
            count = int(np.sum(~_inside(outer, position, margin)))
            raise _unclear(bounds, outer, edges, f"{count} of {len(position)} disks lie outside the first and none outside the second")
    bounds.notes.append(f"disks lie outside the cell, as LAMMPS' x y do not; {other}")


def _spacing(cell: Cell, position: Array) -> float:
    """Mean distance of disks."""
    return float(np.sqrt(cell.box.length * cell.box.height / len(position)))


def _unclear(bounds: Bounds, outer: Cell, edges: Cell, why: str) -> InputError:
    low, high = bounds.rows[0]
    return InputError(
        f"{bounds.where}: {low:g} {high:g} with the tilt {bounds.tilt:g} (is L_x = {outer.box.length:g}, as LAMMPS writes bounds "
        f"that hold the tilt, or L_x = {edges.box.length:g}, as xlo and xhi: {why}); say --bounds {OUTER} or --bounds {EDGES}")


def _holds(cell: Cell, position: Array, margin: float) -> bool:
    """True if all disks are in the tilted cell, or all in the rectangle of its lengths."""
    square = Cell(Box(cell.box.length, cell.box.height, 0.0), cell.origin)
    return bool(_inside(cell, position, margin).all() or _inside(square, position, margin).all())


def _inside(cell: Cell, position: Array, margin: float) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    x, y = (position[:, :2] - cell.origin[:2]).T
    across = x - cell.box.tilt * y / cell.box.height
    margin = margin + ROUNDING * float(max(np.abs(position[:, :2]).max(), cell.box.length, cell.box.height))
    return np.asarray((across >= -margin) & (across <= cell.box.length + margin) & (y >= -margin) & (y <= cell.box.height + margin))


def _bounds(where: str, words: str, rows: Sequence[str]) -> Bounds:
    tilts, flags = _said(where, words)
    notes = [] if flags else ["BOX BOUNDS says nothing of the boundaries: periodic"]
    refuse_walls(where, [_flag(word) for word in flags], "pp")
    if len(rows) not in (2, 3):
        raise InputError(f"{where}: {len(rows)} lines (must be 3, x y z)")
    found, named = [], ""
    for axis, row in zip("xyz", rows):
        values, behind = _split(where, row)
        labels = {f"{axis}lo": EDGES, f"{axis}hi": EDGES, f"{axis}lo_bound": OUTER, f"{axis}hi_bound": OUTER,
                  **dict.fromkeys(TILTS, "")}
        if odd := [word for word in behind if word.lower() not in labels]:
            raise InputError(f"{where}: {row.strip()!r} ({odd[0]!r} is not known behind the bounds of {axis}); mend the file, or "
                             "make it again")
        named = next((labels[word.lower()] for word in behind if labels[word.lower()]), named) if axis == "x" else named
        found.append(values)
    widths = {len(values) for values in found}
    if len(widths) > 1 or widths - {2, 3} or (tilts and widths != {3}):
        raise InputError(f"{where}: lines of {' and '.join(map(str, sorted(widths)))} numbers (must be "
                         f"{'3 each, lowest, highest and tilt' if tilts else '2 each, or 3 with tilts'}): "
                         f"{' | '.join(row.strip() for row in rows)}; mend the file, or make it again")
    by_name = dict(zip(tilts or TILTS, (values[2] if len(values) > 2 else 0.0 for values in found)))
    if by_name.get("xz") or by_name.get("yz"):
        raise InputError(f"{where}: xz = {by_name.get('xz', 0.0)}, yz = {by_name.get('yz', 0.0)} (must be 0: flow along x, gradient "
                         "along y)" + ("" if tilts else "; the lines have three numbers, read as bounds and tilt, and no xy xz yz "
                                       "says so: take out what is none"))
    if by_name["xy"] and not tilts:
        notes.append(f"BOX BOUNDS has a third number a line and no xy xz yz that says what it is: read as tilt, {by_name['xy']!r}")
    return Bounds(where, np.array([values[:2] for values in found]), by_name["xy"], named, notes)


def _said(where: str, words: str) -> tuple[list[str], list[str]]:
    """Names of tilts, in the order of the lines, and boundaries."""
    left = words.replace(",", " ").split()
    tilts = [word.lower() for word in left if word.lower() in TILTS]
    flags = [word for word in left if re.fullmatch(r"[pfsm]{1,2}", word.lower())]
    odd = [word for word in left if word.lower() not in TILTS and word not in flags]
    if odd or len(flags) not in (0, 2, 3) or sorted(tilts) not in ([], sorted(TILTS)):
        raise InputError(f"{where}: BOX BOUNDS {words!r} (must be three boundaries, as pp pp pp, before them xy xz yz where the "
                         "cell is tilted); mend the line, or make the file again")
    return tilts, flags


def _flag(word: str) -> str:
    return "pp" if word.lower() in ("p", "pp") else word


def _split(where: str, row: str) -> tuple[list[float], list[str]]:
    """Numbers at the beginning of a line, and the words behind them."""
    words = row.split()
    count = next((k for k, word in enumerate(words) if not NUMBER.fullmatch(word)), len(words))
    if count < 2:
        numbers(words[:2], where)  # tells which is none
        raise InputError(f"{where}: {row.strip()!r} (must be two numbers, or three with a tilt); mend the file, or make it again")
    return numbers(words[:count], where), words[count:]


def _by_vectors(where: str, words: str, rows: Sequence[str]) -> Cell:
    """Cell of `abc origin`, general triclinic: its vectors, with a number of the origin behind each."""
    left = words.split()
    if [word.lower() for word in left[:2]] != ["abc", "origin"] or len(rows) != 3 or any(len(row.split()) != 4 for row in rows):
        raise InputError(f"{where}: BOX BOUNDS {words!r} (a cell by its vectors has three lines of 4 numbers, a vector and one of the "
                         "origin); mend the file, or make it again with `dump_modify ID triclinic/general no`")
    refuse_walls(where, [_flag(word) for word in left[2:]], "pp")
    values = np.array([numbers(row.split(), where) for row in rows])
    return Cell(sheared_box(where, values[:, :3], "; LAMMPS turns it so by `dump_modify ID triclinic/general no`"), values[:, 3])
