# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS data files, as of `write_data`: disks are atoms of style sphere, or of another with diameters by type."""

from __future__ import annotations

import pathlib
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from ..frames import Array, Box
from .columns import whole_ids
from .configuration import Cell, Configuration, Wishes, chosen, sheared_box
from .text import column, numbers, opened, refuse_cut_end, table, whole_number

#: Columns of a row of Atoms; three image flags may follow.
STYLES = {
    "sphere": "id type diameter density x y z", "bpm/sphere": "id molecule type diameter density x y z",
    "atomic": "id type x y z", "charge": "id type q x y z", "bond": "id molecule type x y z",
    "angle": "id molecule type x y z", "molecular": "id molecule type x y z", "full": "id molecule type q x y z"}
SECTION = re.compile(r"[A-Z][A-Za-z]*( [A-Z][A-Za-z]*)*")
NUMBER = re.compile(r"[-+]?[\d.][-+.\deE]*")
VECTORS = ("avec", "bvec", "cvec", "abc origin")  # of a general triclinic cell
OF_CELLS = "xlo xhi ylo yhi zlo zhi xy xz yz avec bvec cvec abc origin tilt"  # words that are of cells alone


@dataclass
class Section:
    """A section of the file."""

    hint: str  #: behind # in its first line
    rows: list[str]


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """Reads the only configuration of the file."""
    chosen(path, [0], wishes.frame)
    refuse_cut_end(path)
    with opened(path) as file:
        head, sections = _sections(path, file.read().splitlines())
    if "Atoms" not in sections:
        raise InputError(f"{path}: has no section Atoms; it is no LAMMPS data file, or one without disks")
    atoms = sections["Atoms"]
    names = _columns(path, wishes.atom_style, atoms.hint)
    split = table(atoms.rows, names, lambda k: f"{path}, Atoms, row {k + 1}", otherwise=[len(names) + 3])
    said = _header(head, "atoms")
    if not split or (said is not None and whole_number([" ".join(said)], f"{path}, atoms of the header") != len(split)):
        more = split and said is not None and len(split) > whole_number([" ".join(said)], f"{path}, atoms of the header")
        raise InputError(f"{path}: {len(split)} rows in Atoms, the header says {' '.join(said or ['none'])} atoms; "
                         + ("mend the header, or the rows" if more else "the file is cut short"))
    return _configuration(path, head, sections, {name: [row[k] for row in split] for k, name in enumerate(names)})


def _sections(path: pathlib.Path, lines: list[str]) -> tuple[list[list[str]], dict[str, Section]]:
    """Words of the lines of the header, and the sections; the first line of the file is a title."""
    head: list[str] = []
    out: dict[str, Section] = {}
    rows = head
    for line in lines[1:]:
        text, _, comment = line.partition("#")
        if SECTION.fullmatch(text.strip()):
            name, rows = text.strip().title(), []
            if name in out:
                raise InputError(f"{path}: section {name} is there twice; make the file again")
            out[name] = Section(comment.strip(), rows)
        elif text.strip():
            rows.append(text)
    return [line.split() for line in head], out


def _refuse_unclear(path: pathlib.Path, head: list[list[str]], names: Sequence[str]) -> None:
    """Refuses lines of numbers without a name, and names of two lines: the valid one cannot be known."""
    for words in head:
        if all(NUMBER.fullmatch(word) for word in words):
            raise InputError(f"{path}: {' '.join(words)!r} in the header has no name (three after the bounds are a tilt: write "
                             "xy xz yz behind them); mend the line")
    for name in names:
        if sum(" ".join(words).lower().endswith(" " + name) for words in head) > 1:
            raise InputError(f"{path}: two lines of the header end with {name}; leave one")


def _header(head: list[list[str]], *names: str) -> list[str] | None:
    """Words before the names that end lines of the header."""
    for words in head:
        if [word.lower() for word in words[-len(names):]] == list(names):
            return words[:-len(names)]
    return None


def _columns(path: pathlib.Path, asked: str | None, hint: str) -> list[str]:
    style = (asked or hint).lower()
    if not style:
        raise InputError(f"{path}: Atoms without the hint of its style, `Atoms # sphere` (columns mean other things in others); "
                         f"say it, --atom-style {', '.join(STYLES)}")
    if style not in STYLES:
        raise InputError(f"{path}: atom style {style} (must be {', '.join(STYLES)}); write the file in one of them, or as a "
                         "dump with radius")
    return STYLES[style].split()


def _cell(path: pathlib.Path, head: list[list[str]]) -> Cell:
    """Cell by its edges and the tilt of the line xy xz yz, or by the vectors of a general triclinic cell."""
    names = ("xlo xhi", "ylo yhi", "zlo zhi", "xy xz yz", *VECTORS)
    _refuse_unclear(path, head, ("atoms", *names))
    lines = {name: _header(head, *name.split()) for name in names}
    for words in head:
        known = any(" ".join(words).lower().endswith(name) for name in lines)
        if not known and {word.lower() for word in words} & {*OF_CELLS.split()}:
            raise InputError(f"{path}: {' '.join(words)!r} in the header (must end with one of {', '.join(lines)}); mend the line")
    values = {name: numbers(words, f"{path}, {name}") for name, words in lines.items() if words is not None}
    if any(name in values for name in VECTORS):
        return _by_vectors(path, values)
    for axis in "xy":
        name = f"{axis}lo {axis}hi"
        ends = values.get(name)
        if ends is None:
            raise InputError(f"{path}: has no {name}, the box")
        if len(ends) != 2 or not ends[1] > ends[0]:
            raise InputError(f"{path}: {' '.join(lines[name] or [])} {name} (must be two numbers, the second above the first)")
    tilts = values.get("xy xz yz", [0.0, 0.0, 0.0])
    if len(tilts) != 3 or tilts[1] or tilts[2]:
        raise InputError(f"{path}: xy xz yz = {tilts} (must be three, xz and yz 0: flow along x, gradient along y)")
    (left, right), (low, high) = values["xlo xhi"], values["ylo yhi"]
    return Cell(Box(right - left, high - low, tilts[0]), np.array([left, low, 0.0]))


def _by_vectors(path: pathlib.Path, values: dict[str, list[float]]) -> Cell:
    found = [values.get(name, []) for name in VECTORS]
    if any(len(one) != 3 for one in found):
        raise InputError(f"{path}: a cell by its vectors, {' | '.join(' '.join(map(str, one)) or 'none' for one in found)} (must be "
                         f"three numbers each of {', '.join(VECTORS)}); make the file again by `write_data FILE`, without "
                         "triclinic/general")
    vectors = np.array(found)
    return Cell(sheared_box(str(path), vectors[:3], "; LAMMPS turns it so by `write_data FILE`, without triclinic/general"), vectors[3])


def _of_types(path: pathlib.Path, sections: dict[str, Section], kind: list[str]) -> Array | None:
    """Masses by type."""
    if "Masses" not in sections:
        return None
    rows = table(sections["Masses"].rows, ["type", "mass"], lambda k: f"{path}, Masses, row {k + 1}")
    mass = {row[0]: numbers([row[1]], f"{path}, Masses, type {row[0]}")[0] for row in rows}
    missing = sorted(set(kind) - set(mass))
    if missing or len(mass) != len(rows):
        raise InputError(f"{path}: Masses has " + (f"none of type {missing[0]}" if missing else "a type twice"))
    return np.array([mass[one] for one in kind])


def _motion(path: pathlib.Path, sections: dict[str, Section], ids: Array) -> tuple[Array | None, Array | None]:
    """Velocities [N, 2] and spins [N] of the disks with these ids."""
    if "Velocities" not in sections:
        return None, None
    split = table(sections["Velocities"].rows, "id vx vy vz".split(), lambda k: f"{path}, Velocities, row {k + 1}", otherwise=[7])
    values = column(split, lambda k: f"{path}, Velocities, row {k + 1}")
    place = {one: k for k, one in enumerate(values[:, 0].tolist())}
    missing = [f"{one:.0f}" for one in ids.tolist() if one not in place]
    if missing or len(values) != len(ids):
        raise InputError(f"{path}: Velocities has " + (f"none of atom {missing[0]}" if missing else
                                                       f"{len(values)} rows (must be {len(ids)}, one of each atom)")
                         + "; the file is damaged, make it again")
    found = values[[place[one] for one in ids.tolist()]]
    return found[:, 1:3], found[:, 6] if found.shape[1] == 7 else None


def _configuration(path: pathlib.Path, head: list[list[str]], sections: dict[str, Section], data: dict[str, list[str]]
                   ) -> Configuration:
    def of(name: str) -> Array:
        return column([[word] for word in data[name]], lambda k: f"{path}, Atoms, row {k + 1}, {name}")[:, 0]

    ids = whole_ids(data["id"], f"{path}, Atoms, id")
    assert ids is not None
    cell, kind = _cell(path, head), data["type"]
    mass, diameter = _of_types(path, sections, kind), None
    if "diameter" in data:  # a mass is that of a ball, as LAMMPS has it in two dimensions too; of a point the density
        diameter = of("diameter")
        mass = of("density") * np.where(diameter > 0, np.pi / 6 * diameter**3, 1.0)
    velocity, spin = _motion(path, sections, ids)
    return Configuration(
        names=[f"atom {one:.0f}" for one in ids], kind=kind,
        position=np.stack([of("x"), of("y"), of("z")], axis=1) - cell.origin * [1, 1, 0], cell=cell, diameter=diameter, mass=mass,
        velocity=velocity, spin=spin).in_order_of(ids, path)
