# SPDX-License-Identifier: BSD-3-Clause
"""One import of bytes, and what holds of it whatever they are: refused in words, or a state that is sound and agrees with
what a plain look at the file says."""

import codecs
import math
import pathlib
import re
import sys
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "python"))

import numpy as np  # noqa: E402

import bagnold  # noqa: E402

if not hasattr(bagnold, "import_state"):  # the module of that name of the tests of the command line
    import python_package  # noqa: F401

    bagnold = sys.modules["bagnold_package"]

HEADERS = pathlib.Path(__file__).resolve().parent / "headers"
FORMATS = (None, "lammps", "dump", "extxyz")


def corpus():
    """Small files with the headers that programs write."""
    return [path.read_bytes() for path in sorted(HEADERS.iterdir())]


class Broken(Exception):
    """What does not hold."""


def attack(folder, data):
    """The first byte says how the rest is imported. Returns whether it was. Raises Broken, or what nobody foresaw."""
    how, data = (data[0] if data else 0), data[1:]
    file, out = folder / "x.txt", folder / "x.h5"
    file.write_bytes(data)
    out.unlink(missing_ok=True)
    options = {"format": FORMATS[how & 3], "frame": 0 if how & 4 else -1, "bounds": (None, None, "outer", "edges")[how >> 3 & 3]}
    if how & 32:
        options |= {"diameters": {"1": 1.0, "2": 1.4, "H": 1.0, "He": 1.4}, "atom_style": "atomic"}
    if how & 64:
        options["strain_rate"] = 0.01
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            made = bagnold.import_state(file, out, tolerance=1e-3, **options)
    except bagnold.Error as error:
        if not str(error).strip() or not str(error).isprintable() or out.exists() or list(folder.glob("*.part")):
            raise Broken(f"refused without a word, with one that steers terminals, or with a file left: {error!r}") from error
        return False
    try:
        (state,) = bagnold.frames.read_states(made.path)
    finally:
        out.unlink()
    sound(state, made)
    text = lines(data)
    if not text.endswith("\n") and how & 4 == 0:
        raise Broken("the last line has no end")
    if how & 4 == 0 and (options["format"] == "dump" or (options["format"] is None and text.lstrip().upper().startswith("ITEM:"))):
        agrees(text, state, made)
    return True


def sound(state, made):
    """Of any state."""
    box, count = state.box, len(state.position)
    for what, holds in (
            ("box", box.length > 0 and box.height > 0 and -box.length / 2 <= box.tilt < box.length / 2),
            ("numbers", all(np.isfinite(one).all() for one in (state.position, state.velocity, state.diameter))),
            ("places", (state.position >= 0).all() and (state.position[:, 0] <= box.length).all()
             and (state.position[:, 1] <= box.height).all()),
            ("species", count >= 2 and (np.sort(state.diameter) == np.repeat([1.0, 1.4], count // 2)).all()),
            ("scene", made.scene["disks"]["count"] == count
             and math.isclose(made.scene["disks"]["packing_fraction"], state.packing_fraction, rel_tol=1e-9)),
            ("notes", str(made).isprintable() or str(made).replace("\n", "").isprintable())):
        if not holds:
            raise Broken(f"{what}: {box}, {count} disks, {made}")


def lines(data):
    """As text, by its byte order mark."""
    encoding = "utf-16" if data[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE) else "utf-8"
    return data.decode(encoding, errors="replace").lstrip("\ufeff").replace("\r\n", "\n").replace("\r", "\n")


def agrees(text, state, made):
    """Of the last frame of a dump: rows as long as their header, as many as disks; the tilt not dropped."""
    parts = re.split(r"(?im)^[^\S\n]*ITEM:[^\S\n]*ATOMS\b(.*)\n", text)
    if len(parts) > 1 and not re.search(r"(?im)^[^\S\n]*ITEM:", parts[-1]):
        rows = [row.split() for row in parts[-1].split("\n") if row.strip()]
        if len(rows) != len(state.position) or {len(row) for row in rows} != {len(parts[-2].split())}:
            raise Broken(f"{len(rows)} rows, {len(state.position)} disks: {made}")
        bounds = re.split(r"(?im)^[^\S\n]*ITEM:[^\S\n]*BOX BOUNDS\b(.*)\n", parts[-3])
        first = bounds[-1].split("\n")[0].split()
        words = bounds[-2].lower().split() if len(bounds) > 2 else []
        if len(first) == 3 and not words[:1] == ["abc"] and "xz" not in words[:1] and "yz" not in words[:1]:
            tilt = float(first[2].lower().replace("d", "e")) / (state.box.length or 1)
            if state.box.tilt == 0 and 1e-9 < abs(tilt) and "d_s = 1.0 " in str(made) and abs(tilt - round(tilt)) > 1e-9:
                raise Broken(f"the tilt {first[2]} was dropped: {made}")
