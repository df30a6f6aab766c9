# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS dumps of atoms, as text; time and rate of NAME.frames.csv beside it, where `bagnold export` wrote one."""

from __future__ import annotations

import pathlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice

import numpy as np

from .. import files
from ..errors import InputError
from ..frames import Array, Box
from .columns import Columns, whole_ids
from .configuration import Configuration, Wishes, chosen
from .lammps_bounds import read_cell
from .text import numbers, opened, refuse_cut_end, table, whole_number

KNOWN = ("TIMESTEP", "NUMBER OF ATOMS", "BOX BOUNDS", "ATOMS", "TIME", "UNITS")
SCALED = 2.0  # beyond which a place is no share of the cell


@dataclass
class Item:
    """Text behind and below a line `ITEM: NAME`."""

    words: str
    rows: list[str]
    line: int  #: of the file, from 1


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """Reads one frame of the dump."""
    begun = _frames(path)
    if not begun:
        raise InputError(f"{path}: has no ITEM: TIMESTEP (a LAMMPS dump has one a frame)")
    first = chosen(path, begun, wishes.frame)
    ends = [*begun[1:], None][begun.index(first)]
    if ends is None:
        refuse_cut_end(path)
    with opened(path) as file:
        return _frame(path, wishes, _items(list(islice(file, first, ends)), first))


def _item(text: str) -> tuple[str, str] | None:
    """Name of an item and the rest of its line; None for other lines."""
    found = re.match(r"\s*ITEM:\s*(.*)", text, re.IGNORECASE) if ":" in text else None
    if not found:
        return None
    rest = found[1].strip()
    upper = rest.upper()
    name = next((one for one in KNOWN if upper == one or upper.startswith(one + " ")), upper)
    return name, rest[len(name):].strip()


def _frames(path: pathlib.Path) -> list[int]:
    """Lines, from 0, at which frames begin: with the first item behind the atoms of the previous frame, as LAMMPS
    writes the time before the step; or with an item that the frame has already, if the previous one was cut short."""
    begun: list[int] = []
    seen: set[str] = set()
    steps = 0
    with opened(path) as file:
        for line, text in enumerate(file):
            if (item := _item(text)) is None:
                continue
            if not seen or "ATOMS" in seen or item[0] in seen:
                begun.append(line)
                seen = set()
            seen.add(item[0])
            steps += item[0] == "TIMESTEP"
    return begun if steps else []


def _items(lines: list[str], first: int) -> dict[str, Item]:
    out: dict[str, Item] = {}
    rows: list[str] = []
    for k, text in enumerate(lines):
        if item := _item(text):
            rows = []
            out[item[0]] = Item(item[1], rows, first + k + 1)
        elif text.strip():
            rows.append(text)
    return out


def _frame(path: pathlib.Path, wishes: Wishes, items: Mapping[str, Item]) -> Configuration:
    first = min(item.line for item in items.values())
    for name in ("TIMESTEP", "NUMBER OF ATOMS", "BOX BOUNDS", "ATOMS"):
        if name not in items:
            raise InputError(f"{path}, line {first}: the frame has no ITEM: {name}; the file is cut short, or no dump of atoms")
    count = whole_number(items["NUMBER OF ATOMS"].rows, f"{path}, line {first}, NUMBER OF ATOMS")
    atoms, bounds = items["ATOMS"], items["BOX BOUNDS"]
    if len(atoms.rows) != count or count < 1:
        odd = "the file is cut short" if len(atoms.rows) < count else "mend ITEM: NUMBER OF ATOMS, or the rows"
        raise InputError(f"{path}, line {first}: the frame has {len(atoms.rows)} of {count} atoms; {odd}")
    columns = _columns(path, atoms)
    ids = whole_ids(columns.words("id"), f"{path}, line {atoms.line}, id")
    where = f"{path}, line {bounds.line}"
    scaled, unwrapped, position = _places(columns)
    diameter = columns.diameter()
    if scaled:
        cell = read_cell(where, bounds.words, bounds.rows, wishes.bounds, None, None)
        position = np.column_stack([position[:, :2] @ cell.box.matrix[:2, :2], np.zeros(count)])
    else:
        cell = read_cell(where, bounds.words, bounds.rows, wishes.bounds, None if unwrapped else position,
                         None if diameter is None else float(diameter.min()))
        position = position - cell.origin * [1, 1, 0]
    time, rate, told = _told(path, items, cell.box)
    mass = columns.scalar("mass")
    return Configuration(
        names=[f"atom {one:.0f}" for one in (np.arange(1, count + 1) if ids is None else ids)],
        kind=columns.words("type") or ["1"] * count, position=position, cell=cell, diameter=diameter, mass=mass,
        scaled=scaled, velocity=columns.velocity(mass), spin=columns.spin(), velocity_in_box=unwrapped, time=time, strain_rate=rate,
        notes=(*cell.notes, *told, *columns.notes())).in_order_of(ids, path)


def _columns(path: pathlib.Path, atoms: Item) -> Columns:
    names = atoms.words.split()

    def row(k: int) -> str:
        return f"{path}, line {atoms.line + k + 1}"

    split = table(atoms.rows, names, row)
    return Columns(f"{path}, line {atoms.line}, ITEM: ATOMS {atoms.words}", names,
                   [[[words[k]] for words in split] for k in range(len(names))], row)


def _places(columns: Columns) -> tuple[bool, bool, Array]:
    """Two truth values, for positions scaled by the cell and for unwrapped ones; and the positions, [N, 3]."""
    found = columns.vector("position")
    if found is not None:
        return False, False, found
    for names, scaled, unwrapped in (("xu yu zu", False, True), ("xs ys zs", True, False), ("xsu ysu zsu", True, True)):
        found = columns.of_axes(names.split())
        if found is None:
            continue
        if scaled and not unwrapped and np.abs(found[:, :2] - 0.5).max(initial=0.0) > SCALED:
            raise InputError(f"{columns.where}: xs ys from {found[:, :2].min():g} to {found[:, :2].max():g} (must be within 0 and 1, "
                             "shares of the cell); call the columns x y, or xsu ysu, if they are these")
        return scaled, unwrapped, found
    raise InputError(f"{columns.where} has no positions (must be x y, xu yu, xs ys or xsu ysu)")


def _told(path: pathlib.Path, items: Mapping[str, Item], box: Box) -> tuple[float, float | None, list[str]]:
    """Time, strain rate, and assumptions."""
    where = f"{path}, line {items['TIMESTEP'].line}"
    step = _only_number(items["TIMESTEP"], f"{where}, TIMESTEP", "a whole number")
    time, rate = 0.0, None
    notes = []
    if not "".join(items["TIMESTEP"].rows).strip().isdigit():  # of one file, 0.5 and 5.0 are the same quantity
        time = step
        notes.append(f"TIMESTEP {step!r} is written as no whole number: read as the time")
    elif beside := _beside(path, int(step), box):
        time, rate = beside
        notes.append(f"time and strain rate of {files.beside(path, '.frames.csv').name}")
    if "TIME" in items:
        time = _only_number(items["TIME"], f"{path}, line {items['TIME'].line}, TIME", "a number")
    return time, rate, notes


def _only_number(item: Item, where: str, kind: str) -> float:
    words = " ".join(item.rows).split()
    if len(words) != 1:
        raise InputError(f"{where}: {' '.join(words)[:40] or 'nothing'} (must be {kind}); the file is damaged")
    return numbers(words, where)[0]


def _beside(path: pathlib.Path, step: int, box: Box) -> tuple[float, float] | None:
    """Time and rate of the step in the table that `bagnold export` writes beside a dump. Raises InputError if it is the
    table of another dump."""
    beside = files.beside(path, ".frames.csv")
    if not beside.is_file():
        return None
    refuse_cut_end(beside)
    with opened(beside) as file:
        rows = [line.strip().split(",") for line in file]
    wanted = ("step", "time", "strain_rate", "tilt")
    for k, row in enumerate(rows[1:]):
        where = f"{beside}, line {k + 2}"
        if len(row) != len(rows[0]) or any(name not in rows[0] for name in wanted):
            raise InputError(f"{where}: {','.join(row)!r} (must have the columns {','.join(rows[0])}); export again, or take it away")
        if row[rows[0].index("step")] != str(step):
            continue
        time, rate, tilt = numbers([row[rows[0].index(name)] for name in wanted[1:]], where)
        if abs((tilt - box.tilt) - box.length * round((tilt - box.tilt) / box.length)) > 1e-6 * box.length:
            raise InputError(f"{where}: tilt {tilt} at step {step} (must be that of {path.name}, {box.tilt}: it is of another dump); "
                             "take it away")
        return time, rate
    return None
