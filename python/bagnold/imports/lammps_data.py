# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS data files, as of `write_data`: disks are atoms of style sphere, or of another with diameters by type."""

from __future__ import annotations

import pathlib
import re

import numpy as np

from ..errors import InputError
from ..frames import Array, Box
from .configuration import Configuration, Wishes, chosen, in_order, numbers, opened, table, whole_number

#: Columns of a row of Atoms; three image flags may follow.
STYLES = {
    "sphere": "id type diameter density x y z", "bpm/sphere": "id molecule type diameter density x y z",
    "atomic": "id type x y z", "charge": "id type q x y z", "bond": "id molecule type x y z",
    "angle": "id molecule type x y z", "molecular": "id molecule type x y z", "full": "id molecule type q x y z"}
SECTION = re.compile(r"[A-Z][A-Za-z]*( [A-Z][A-Za-z]*)*")


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """The only configuration of the file."""
    chosen(path, [0], wishes.frame)
    with opened(path) as file:
        head, sections = _sections(file.read().splitlines())
    if "Atoms" not in sections:
        raise InputError(f"{path}: has no section Atoms; it is no LAMMPS data file, or one without disks")
    hint, rows, first = sections["Atoms"]
    names = _columns(path, wishes.atom_style, hint)
    split = table(rows, len(names), lambda k: f"{path}, Atoms, row {k + 1}")
    for k, row in enumerate(split):
        if len(row) not in (len(names), len(names) + 3):
            raise InputError(f"{path}, Atoms, row {k + 1}: {len(row)} columns (must be {len(names)}, {' '.join(names)}, or 3 "
                             "image flags more); say the style, --atom-style")
    data = {name: [row[k] for row in split] for k, name in enumerate(names)}
    ids = np.array(numbers(data["id"], f"{path}, Atoms, id"))
    said = _header(head, "atoms")
    if said is not None and whole_number(said, f"{path}, atoms of the header") != len(rows):
        raise InputError(f"{path}: {len(rows)} rows in Atoms, the header says {said[0]} atoms; the file is cut short")
    return _configuration(path, head, sections, data, ids)


def _sections(lines: list[str]) -> tuple[list[str], dict[str, tuple[str, list[str], int]]]:
    """The header, and {section: (hint behind #, rows, line)}; the first line of the file is a title."""
    head: list[str] = []
    out: dict[str, tuple[str, list[str], int]] = {}
    rows = head
    for k, line in enumerate(lines[1:]):
        text, _, comment = line.partition("#")
        if SECTION.fullmatch(text.strip()):
            rows = []
            out[text.strip()] = (comment.strip(), rows, k + 2)
        elif text.strip():
            rows.append(text)
    return head, out


def _header(head: list[str], *names: str) -> list[str] | None:
    """The words before names that end a line of the header."""
    for line in head:
        words = line.split()
        if words[-len(names):] == list(names):
            return words[:-len(names)]
    return None


def _columns(path: pathlib.Path, asked: str | None, hint: str) -> list[str]:
    style = asked or hint
    if not style:
        raise InputError(f"{path}: Atoms without the hint of its style, `Atoms # sphere` (columns mean other things in others); "
                         f"say it, --atom-style {', '.join(STYLES)}")
    if style not in STYLES:
        raise InputError(f"{path}: atom style {style} (must be {', '.join(STYLES)}); write the file in one of them, or as a "
                         "dump with radius")
    return STYLES[style].split()


def _box(path: pathlib.Path, head: list[str]) -> tuple[Box, Array]:
    low = []
    size = []
    for axis in "xy":
        found = _header(head, f"{axis}lo", f"{axis}hi")
        if found is None:
            raise InputError(f"{path}: has no {axis}lo {axis}hi, the box" + (
                " (cells by avec, bvec, cvec are not read; use `write_data ... triclinic/general no`)"
                if _header(head, "avec") else ""))
        ends = numbers(found, f"{path}, {axis}lo {axis}hi")
        if len(ends) != 2 or not ends[1] > ends[0]:
            raise InputError(f"{path}: {' '.join(found)} {axis}lo {axis}hi (must be two numbers, the second above the first)")
        low.append(ends[0])
        size.append(ends[1] - ends[0])
    tilts = numbers(_header(head, "xy", "xz", "yz") or ["0", "0", "0"], f"{path}, xy xz yz")
    if len(tilts) != 3 or tilts[1] or tilts[2]:
        raise InputError(f"{path}: xy xz yz = {tilts} (must be three, xz and yz 0: flow along x, gradient along y)")
    return Box(size[0], size[1], tilts[0]), np.array([*low, 0.0])


def _of_types(path: pathlib.Path, sections: dict[str, tuple[str, list[str], int]], kind: list[str]) -> Array | None:
    """Masses by type."""
    if "Masses" not in sections:
        return None
    rows = table(sections["Masses"][1], 2, lambda k: f"{path}, Masses, row {k + 1}")
    mass = {row[0]: numbers([row[1]], f"{path}, Masses, type {row[0]}")[0] for row in rows}
    missing = sorted(set(kind) - set(mass))
    if missing:
        raise InputError(f"{path}: Masses has none of type {missing[0]}")
    return np.array([mass[one] for one in kind])


def _motion(path: pathlib.Path, sections: dict[str, tuple[str, list[str], int]], ids: Array
            ) -> tuple[Array | None, Array | None]:
    """Velocities [N, 2] and spins [N] in the order of `ids`."""
    if "Velocities" not in sections:
        return None, None
    rows = table(sections["Velocities"][1], 4, lambda k: f"{path}, Velocities, row {k + 1}")
    values = {row[0]: numbers(row[1:], f"{path}, Velocities, atom {row[0]}") for row in rows}
    names = [f"{one:.0f}" for one in ids]
    missing = [name for name in names if name not in values]
    if missing or len({len(row) for row in values.values()}) > 1:
        raise InputError(f"{path}: Velocities " + (f"has none of atom {missing[0]}" if missing else "has rows of several lengths")
                         + "; the file is damaged, make it again")
    found = np.array([values[name] for name in names])
    return found[:, :2], found[:, 5] if found.shape[1] >= 6 else None


def _configuration(path: pathlib.Path, head: list[str], sections: dict[str, tuple[str, list[str], int]],
                   data: dict[str, list[str]], ids: Array) -> Configuration:
    order = in_order(ids, path)

    def column(name: str) -> Array:
        return np.array(numbers(data[name], f"{path}, Atoms, {name}"))[order]

    kind = [data["type"][k] for k in order]
    box, origin = _box(path, head)
    mass, diameter = _of_types(path, sections, kind), None
    if "diameter" in data:  # a mass is that of a ball, as LAMMPS has it in two dimensions too
        diameter = column("diameter")
        mass = np.pi / 6 * column("density") * diameter**3
    velocity, spin = _motion(path, sections, ids[order])
    return Configuration(
        names=[f"atom {ids[k]:.0f}" for k in order], kind=kind,
        position=np.stack([column("x"), column("y"), column("z")], axis=1) - origin, box=box, diameter=diameter,
        mass=mass, velocity=velocity, spin=spin)
