# SPDX-License-Identifier: BSD-3-Clause
"""Lattice="..." of extended XYZ: nine numbers, or a shorter form."""

from __future__ import annotations

import numpy as np

from ..errors import InputError
from ..frames import Array


def vectors_of(where: str, values: list[float]) -> tuple[Array, list[str]]:
    """Vectors of the cell as rows, [3, 3], and assumptions. Raises InputError if the numbers give no cell, or more than
    one."""
    if len(values) == 9:
        return np.array(values).reshape(3, 3), []
    found = {name: vectors for name, vectors in _readings(values) if _is_cell(vectors)}
    different = {tuple(vectors.ravel()) for vectors in found.values()}
    if len(different) != 1:
        raise InputError(f"{where}: Lattice has {len(values)} numbers, {' '.join(f'{one:g}' for one in values)} (must be 9, three "
                         "vectors, or mean one cell alone); write (L_x, 0, 0), (tilt, L_y, 0), (0, 0, L_z)")
    name, vectors = next(iter(found.items()))
    (length, _, _), (tilt, height, _), _ = vectors.tolist()
    return vectors, [f"Lattice of {len(values)} numbers read as {name}: L_x = {length!r}, L_y = {height!r}, tilt {tilt!r}"]


def _readings(values: list[float]) -> list[tuple[str, Array]]:
    """Possible readings of that many numbers, with the vectors, [3, 3], of each."""
    if len(values) == 2:
        return [("lengths", np.diag([*values, 1.0]))]
    if len(values) == 4:
        return [("two vectors in the plane", _in_space(np.array(values).reshape(2, 2)))]
    if len(values) != 6:
        return []
    a, b, c, x, y, z = values
    angles = np.radians([x, y, z])
    out = [("two vectors", np.vstack([np.array(values).reshape(2, 3), [0, 0, 1]])),
           ("L_x, L_y, L_z, xy, xz, yz", np.array([[a, 0, 0], [x, b, 0], [y, z, c]]))]
    if y == z == 0:
        out.append(("three vectors in the plane", _in_space(np.array(values[:4]).reshape(2, 2))))
    if x == y == 90 and 0 < z < 180:
        tilt = 0.0 if z == 90 else b * float(np.cos(angles[2]))
        out.append(("lengths and angles", np.array([[a, 0, 0], [tilt, b * float(np.sin(angles[2])), 0], [0, 0, c]])))
    return out


def _in_space(vectors: Array) -> Array:
    """Two vectors in the plane, [2, 2], and the third along z."""
    return np.vstack([np.column_stack([vectors, [0, 0]]), [0, 0, 1]])


def _is_cell(vectors: Array) -> bool:
    """True for the form (L_x, 0, 0), (tilt, L_y, 0), (0, 0, L_z)."""
    (length, skew, above), (_, height, lift), (xz, yz, depth) = vectors.tolist()
    return length > 0 and height > 0 and depth >= 0 and not any((skew, above, lift, xz, yz))
