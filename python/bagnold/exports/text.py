# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by the formats."""

from __future__ import annotations

import pathlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, TextIO

import numpy as np

from ..files import replaced
from ..frames import Array, Box, Frame, Integers


@contextmanager
def written_whole(path: pathlib.Path) -> Iterator[TextIO]:
    """A text file that appears only when it is complete."""
    with replaced(path) as part, open(part, "w", encoding="utf-8", newline="\n") as file:
        yield file


def in_cell(frame: Frame) -> tuple[Array, Integers | None]:
    """Positions [N, 2] in the tilted cell instead of the rectangle, and their images, for formats with cell vectors."""
    box = frame.box
    rows = np.floor(frame.position[:, 1] / box.height)
    x = frame.position[:, 0] - rows * box.tilt
    y = frame.position[:, 1] - rows * box.height
    columns = np.floor((x - box.tilt * y / box.height) / box.length)
    moved = np.stack([columns, rows], axis=1).astype(np.int64)
    return np.stack([x - columns * box.length, y], axis=1), None if frame.image is None else frame.image + moved


def contact_segment(box: Box, position: Array, i: Integers, normal: Array, separation: Array) -> Array:
    """Segments from the centre of i to that of the image of j, [M, 2, 2], d_s."""
    start = position[i]
    return np.stack([start, start - separation[:, None] * normal], axis=1)


def rows_of(columns: list[Any]) -> str:
    """Rows of text, whole numbers as such, others so that they read back to the same double."""
    texts = [[str(value) if isinstance(value, (int, str)) else repr(value) for value in np.asarray(one).tolist()]
             for one in columns]
    return "".join(" ".join(row) + "\n" for row in zip(*texts))
