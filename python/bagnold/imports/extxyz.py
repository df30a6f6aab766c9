# SPDX-License-Identifier: BSD-3-Clause
"""Extended XYZ, as `bagnold export` and ASE write it."""

from __future__ import annotations

import pathlib
import re

import numpy as np

from ..errors import InputError
from ..frames import Array
from .configuration import Configuration, Wishes, chosen, numbers, opened, refuse_walls, sheared_box, table

#: What a property may be called, with its power of the radius or of the mass.
RADII = {"radius": 2.0, "radii": 2.0, "diameter": 1.0, "diameters": 1.0}
MASSES = ("masses", "mass")
VELOCITIES = ("velo", "velocities", "velocity", "vel")
SPINS = ("spin", "omega", "angular_velocity")


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """One frame of the file."""
    line = chosen(path, _frames(path), wishes.frame)
    with opened(path) as file:
        lines = [text for k, text in enumerate(file) if line <= k < line + 2]
        count = int(lines[0])
    with opened(path) as file:
        rows = [text for k, text in enumerate(file) if line + 2 <= k < line + 2 + count]
    words = _words(lines[1])
    if "Lattice" not in words:
        raise InputError(f"{path}, line {line + 2}: has no Lattice=\"...\", the box (plain XYZ has none); write extended XYZ")
    columns = _columns(path, line + 3, words.get("Properties", "species:S:1:pos:R:3"), rows)
    lattice = np.array(numbers(words["Lattice"].split(), f"{path}, line {line + 2}, Lattice"))
    if lattice.size != 9:
        raise InputError(f"{path}, line {line + 2}: Lattice has {lattice.size} numbers (must be 9, three vectors)")
    x, y = (words.get("pbc", "T T F").split() + ["F", "F"])[:2]
    refuse_walls(path, x[:1].upper(), y[:1].upper(), "T")
    return _configuration(path, words, columns, lattice.reshape(3, 3), line)


def _frames(path: pathlib.Path) -> list[int]:
    """Lines, from 0, in which frames begin."""
    begun, line, skip = [], 0, 0
    with opened(path) as file:
        for line, text in enumerate(file):
            if skip:
                skip -= 1
                continue
            if not text.strip():
                continue
            if not re.fullmatch(r"\s*\d+\s*", text):
                raise InputError(f"{path}, line {line + 1}: {text.strip()[:40]!r} (must be the number of disks of a frame); "
                                 "the file is cut short, or no XYZ")
            begun.append(line)
            skip = int(text) + 1
    if skip or not begun:
        raise InputError(f"{path}: ends within a frame, {skip} lines early; make it again" if begun
                         else f"{path}: holds no frame")
    return begun


def _words(text: str) -> dict[str, str]:
    """key=value and key="several values" of the second line of a frame."""
    return {key: (quoted or curly or plain)
            for key, quoted, curly, plain in re.findall(r'(\w+)=(?:"([^"]*)"|\{([^}]*)\}|(\S+))', text)}


def _columns(path: pathlib.Path, line: int, properties: str, rows: list[str]) -> dict[str, list[list[str]]]:
    """{property: [N] rows of its words}."""
    parts = properties.split(":")
    widths = parts[2::3]
    if len(parts) % 3 or not all(width.isdigit() for width in widths):
        raise InputError(f"{path}: Properties={properties} (must be name:type:columns, again and again)")
    split = table(rows, sum(map(int, widths)), lambda k: f"{path}, line {line + k}")
    out, first = {}, 0
    for name, width in zip(parts[::3], map(int, widths)):
        out[name] = [words[first:first + width] for words in split]
        first += width
    if "pos" not in out:
        raise InputError(f"{path}: Properties={properties} has no pos, the positions")
    return out


def _configuration(path: pathlib.Path, words: dict[str, str], columns: dict[str, list[list[str]]], lattice: Array,
                   line: int) -> Configuration:
    def found(names: tuple[str, ...]) -> tuple[str, Array | None]:
        for name in names:
            if name in columns:
                return name, np.array([numbers(row, f"{path}, line {line + 3 + k}, {name}")
                                       for k, row in enumerate(columns[name])])
        return "", None

    def scalar(name: str) -> float | None:
        return numbers([words[name]], f"{path}, line {line + 2}, {name}")[0] if name in words else None

    _, position = found(("pos",))
    assert position is not None
    if position.shape[1] == 2:
        position = np.column_stack([position, np.zeros(len(position))])
    size, diameter = found(tuple(RADII))
    _, mass = found(MASSES)
    _, velocity = found(VELOCITIES)
    _, spin = found(SPINS)
    momenta = found(("momenta",))[1] if velocity is None else None
    if momenta is not None:
        if mass is None:
            raise InputError(f"{path}: momenta without masses (velocities need both); write masses, or velocities")
        velocity = momenta / mass
    species = columns.get("species", columns.get("type", [["disk"]] * len(position)))
    strain_rate = scalar("strain_rate")
    return Configuration(
        names=[f"disk {k} (from 0)" for k in range(len(position))], kind=[row[0] for row in species], position=position,
        box=sheared_box(path, lattice), diameter=None if diameter is None else RADII[size] * diameter[:, 0],
        mass=None if mass is None else mass[:, 0], velocity=None if velocity is None else velocity[:, :2],
        spin=None if spin is None else spin[:, -1], time=scalar("time") or 0.0, strain_rate=strain_rate)
