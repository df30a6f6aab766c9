# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS dumps of atoms, as text; time and rate of NAME.frames.csv beside it, where `bagnold export` wrote one."""

from __future__ import annotations

import csv
import pathlib

import numpy as np

from ..errors import InputError
from ..frames import Array, Box
from .configuration import Configuration, Wishes, chosen, in_order, numbers, opened, refuse_walls, table, whole_number

#: Columns of x and y, the better ones first; whether the box scales them; whether they leave it.
PLACES = (("x", "y", "z", False, False), ("xu", "yu", "zu", False, True),
          ("xs", "ys", "zs", True, False), ("xsu", "ysu", "zsu", True, True))


def read(path: pathlib.Path, wishes: Wishes) -> Configuration:
    """One frame of the dump."""
    with opened(path) as file:
        begun = [k for k, text in enumerate(file) if text.startswith("ITEM: TIMESTEP")]
    if not begun:
        raise InputError(f"{path}: has no ITEM: TIMESTEP (a LAMMPS dump has one a frame)")
    first = chosen(path, begun, wishes.frame)
    ends = [*begun[1:], None][begun.index(first)]
    with opened(path) as file:
        lines = [text for k, text in enumerate(file) if k >= first and (ends is None or k < ends)]
    return _frame(path, first, _items(lines))


def _items(lines: list[str]) -> dict[str, tuple[str, list[str], int]]:
    """{ITEM: (the rest of its line, its lines, where they begin)}."""
    names = ("TIMESTEP", "NUMBER OF ATOMS", "BOX BOUNDS", "ATOMS", "TIME", "UNITS")
    out: dict[str, tuple[str, list[str], int]] = {}
    rows: list[str] = []
    for k, text in enumerate(lines):
        if text.startswith("ITEM: "):
            rest = text[6:].strip()
            name = next((one for one in names if rest == one or rest.startswith(one + " ")), rest)
            rows = []
            out[name] = (rest[len(name):].strip(), rows, k + 1)
        elif text.strip():
            rows.append(text)
    return out


def _frame(path: pathlib.Path, first: int, items: dict[str, tuple[str, list[str], int]]) -> Configuration:
    for name in ("NUMBER OF ATOMS", "BOX BOUNDS", "ATOMS"):
        if name not in items:
            raise InputError(f"{path}, line {first + 1}: the frame has no ITEM: {name}; the file is cut short, or no dump of "
                             "atoms")
    count = whole_number(items["NUMBER OF ATOMS"][1], f"{path}, NUMBER OF ATOMS")
    words, rows, start = items["ATOMS"]
    if len(rows) != count:
        raise InputError(f"{path}, line {first + 1}: the frame has {len(rows)} of {count} atoms; the file is cut short")
    names = words.split()
    split = table(rows, len(names), lambda k: f"{path}, line {first + start + k + 1}")
    data = {name: [row[k] for row in split] for k, name in enumerate(names)}
    ids = np.array(numbers(data["id"], f"{path}, id")) if "id" in data else np.arange(1.0, count + 1)
    order = in_order(ids, path)

    def column(*wanted: str) -> Array | None:
        for name in wanted:
            if name in data:
                return np.array(numbers(data[name], f"{path}, column {name}"))[order]
        return None

    box, origin = _box(path, first, items["BOX BOUNDS"])
    position, unwrapped = _places(path, column, names, box, origin)
    vx, vy, radius, diameter = column("vx"), column("vy"), column("radius"), column("diameter")
    time, rate = _told(path, whole_number(items["TIMESTEP"][1], f"{path}, line {first + 1}, TIMESTEP"))
    if "TIME" in items and items["TIME"][1]:
        time = numbers(items["TIME"][1][:1], f"{path}, TIME")[0]
    kinds = data.get("type", data.get("element", ["1"] * count))
    return Configuration(
        names=[f"atom {ids[k]:.0f}" for k in order], kind=[kinds[k] for k in order], position=position, box=box,
        diameter=diameter if radius is None else 2 * radius, mass=column("mass"),
        velocity=None if vx is None or vy is None else np.stack([vx, vy], axis=1), spin=column("omegaz"),
        velocity_in_box=unwrapped, time=time, strain_rate=rate)


def _box(path: pathlib.Path, first: int, item: tuple[str, list[str], int]) -> tuple[Box, list[float]]:
    """The cell, and its lower left corner. Bounds in x are of what the tilted cell covers."""
    words, rows, start = item
    where = f"{path}, line {first + start + 1}, BOX BOUNDS"
    tilted = words.startswith("xy xz yz")
    if words.startswith("abc origin"):
        raise InputError(f"{where} {words} (a cell by its vectors is not read); use `dump_modify triclinic/general no`")
    values = [numbers(row, where) for row in table(rows[:3], 3 if tilted else 2, lambda _: where)]
    if len(values) < 3:
        raise InputError(f"{where}: {len(values)} lines (must be 3)")
    flags = (words.split()[3:] if tilted else words.split()) or ["pp", "pp"]
    refuse_walls(path, flags[0], flags[1], "pp")
    tilt, xz, yz = (values[0][2], values[1][2], values[2][2]) if tilted else (0.0, 0.0, 0.0)
    if xz or yz:
        raise InputError(f"{where}: xz = {xz}, yz = {yz} (must be 0: flow along x, gradient along y)")
    low, high = values[0][0] - min(0.0, tilt), values[0][1] - max(0.0, tilt)
    length, height = high - low, values[1][1] - values[1][0]
    if not (length > 0 and height > 0):
        raise InputError(f"{where}: L_x = {length}, L_y = {height} (must be above 0)")
    if abs(length - height) < 1e-12 * height:  # bounds that hold the tilt cost digits of L_x
        length = height
    return Box(length, height, tilt), [low, values[1][0]]


def _places(path: pathlib.Path, column: object, names: list[str], box: Box, origin: list[float]) -> tuple[Array, bool]:
    for x, y, z, scaled, unwrapped in PLACES:
        if x in names and y in names:
            place = [column(one) for one in (x, y)]  # type: ignore[operator]
            height = column(z)  # type: ignore[operator]
            if scaled:
                place = [place[0] * box.length + place[1] * box.tilt, place[1] * box.height]
            else:
                place = [place[0] - origin[0], place[1] - origin[1]]
            return np.stack([*place, np.zeros_like(place[0]) if height is None or scaled else height], axis=1), unwrapped
    raise InputError(f"{path}: ITEM: ATOMS {' '.join(names)} has no positions (must be x y, xu yu, xs ys or xsu ysu)")


def _told(path: pathlib.Path, step: int) -> tuple[float, float | None]:
    """Time and rate of the step in the table that `bagnold export` writes beside a dump."""
    beside = path.with_suffix(".frames.csv")
    if not beside.is_file():
        return 0.0, None
    with open(beside, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row.get("step") == str(step):
                time, rate = numbers([row.get("time", "0"), row.get("strain_rate", "0")], f"{beside}, step {step}")
                return time, rate
    return 0.0, None
