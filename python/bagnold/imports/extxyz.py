# SPDX-License-Identifier: BSD-3-Clause
"""Extended XYZ, as `bagnold export`, ASE, OVITO and QUIP write it."""

from __future__ import annotations

import pathlib
import re
from itertools import islice

import numpy as np

from ..errors import InputError
from ..frames import Array
from .columns import Columns, whole_ids
from .comment_line import Words, numbers_in, truths_in
from .configuration import Cell, Configuration, Wishes, chosen, refuse_walls, sheared_box
from .lattice import vectors_of
from .text import numbers, opened, refuse_cut_end, table

PLAIN = "species:S:1:pos:R:3"  # Properties of a file that has none


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """Reads one frame of the file."""
    begun = _frames(path)
    line = chosen(path, begun, wishes.frame)
    if line == begun[-1]:
        refuse_cut_end(path)
    with opened(path) as file:
        head, about, *rest = islice(file, line, None)
        rows = rest[:int(head)]
    if int(head) == 0:
        raise InputError(f"{path}, line {line + 1}: 0 disks (must be at least 2)")
    where = f"{path}, line {line + 2}"
    words = Words(where, about)
    columns = _columns(path, where, line + 3, words.get("properties") or PLAIN, rows)
    if (lattice := words.several("lattice")) is None:
        raise InputError(f"{where}: has no Lattice=\"...\", the box (plain XYZ has none); write extended XYZ")
    vectors, notes = vectors_of(where, numbers_in(lattice, f"{where}, Lattice"))
    if (periodic := words.several("pbc")) is None:
        notes.append("no pbc: periodic along x and y")
    else:
        refuse_walls(where, ["T" if one else "F" for one in truths_in(periodic, f"{where}, pbc")], "T")
    return _configuration(path, where, words, columns, Cell(sheared_box(where, vectors), _origin(where, words), tuple(notes)))


def _frames(path: pathlib.Path) -> list[int]:
    """Lines, from 0, at which frames begin."""
    begun, line, skip = [], 0, 0
    with opened(path) as file:
        for line, text in enumerate(file):
            if skip:
                skip -= 1
                continue
            if not text.strip():
                continue
            if not re.fullmatch(r"\s*\d{1,12}\s*", text, re.ASCII):
                raise InputError(f"{path}, line {line + 1}: {text.strip()[:40]!r} (must be the number of disks of a frame); "
                                 "the file is cut short, or no XYZ")
            begun.append(line)
            skip = int(text) + 1
    if skip or not begun:
        raise InputError(f"{path}: ends within a frame, {skip} lines early; make it again" if begun
                         else f"{path}: holds no frame")
    return begun


def _origin(where: str, words: Words) -> Array:
    """The lower left corner of the cell, [3], which OVITO writes."""
    text = words.several("origin") or words.several("cell_origin")
    found = [] if text is None else numbers_in(text, f"{where}, Origin")
    return np.array([*found, 0.0, 0.0, 0.0][:3])


def _columns(path: pathlib.Path, where: str, line: int, properties: str, rows: list[str]) -> Columns:
    parts = properties.split(":")
    names, kinds, widths = parts[::3], parts[1::3], parts[2::3]
    if len(parts) % 3 or not all(re.fullmatch(r"[1-9]\d?", width, re.ASCII) for width in widths):
        raise InputError(f"{where}: Properties={properties} (must be name:type:columns, again and again)")
    ends = np.cumsum([int(width) for width in widths]).tolist()

    def row(k: int) -> str:
        return f"{path}, line {line + k}"

    each = [name for name, width in zip(names, widths) for _ in range(int(width))]
    split = table(rows, each, row)
    asked = ["numbers" if name == "Z" and kind == "I" else name for name, kind in zip(names, kinds)]  # elements of ASE
    return Columns(f"{where}, Properties={properties}", asked,
                   [[words[end - int(width):end] for words in split] for end, width in zip(ends, widths)], row)


def _configuration(path: pathlib.Path, where: str, words: Words, columns: Columns, cell: Cell) -> Configuration:
    def scalar(name: str) -> float | None:
        text = words.get(name)
        return None if text is None else numbers([text], f"{where}, {name}")[0]

    ids = whole_ids(columns.words("id"), f"{where}, id")
    position = columns.vector("position")
    if position is None:
        raise InputError(f"{columns.where} has no pos, the positions")
    mass, count = columns.scalar("mass"), len(position)
    return Configuration(
        names=[f"disk {k} (from 0)" for k in range(count)] if ids is None else [f"disk {one:.0f}" for one in ids],
        kind=columns.words("type") or ["disk"] * count, position=position - cell.origin * [1, 1, 0], cell=cell,
        diameter=columns.diameter(), mass=mass, velocity=columns.velocity(mass), spin=columns.spin(), time=scalar("time") or 0.0,
        strain_rate=scalar("strain_rate"), notes=(*cell.notes, *columns.notes())).in_order_of(ids, path)
