# SPDX-License-Identifier: BSD-3-Clause
"""Text files of other programs: how they are opened, their words as numbers, their rows as columns."""

from __future__ import annotations

import codecs
import pathlib
import re
from collections.abc import Callable, Iterable, Sequence
from typing import TextIO

import numpy as np

from ..errors import FileError, InputError
from ..files import regular
from ..frames import Array

#: A number as C, Fortran ("1.0D-3") and Python write it; not "1_000", which only Python reads.
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?")
NOT_FINITE = re.compile(r"[+-]?(nan|inf|infinity)", re.IGNORECASE)
CUT = "the file is cut short, of another style, or has rows of several lengths"
HEAD = 1 << 16  # bytes that tell the encoding


def opened(path: pathlib.Path) -> TextIO:
    """Opens a file of text: UTF-8, with or without a byte order mark, UTF-16 with one, otherwise Latin-1, whose bytes
    above 127 can only be in comments and names. Raises FileError if it is not text."""
    try:
        with open(regular(path), "rb") as file:
            head = file.read(HEAD)
        return open(path, encoding=_encoding(path, head), errors="strict")
    except OSError as error:
        if isinstance(error, FileError):
            raise
        raise FileError(f"{path} cannot be read: {error.strerror or error}") from error


def _encoding(path: pathlib.Path, head: bytes) -> str:
    if head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    if found := re.search(rb"[\x00-\x08\x0e-\x1f]", head):
        raise not_text(path, f"byte {head[found.start()]} at {found.start()}")
    try:
        codecs.getincrementaldecoder("utf-8")("strict").decode(head)  # a letter may go on behind the head
    except UnicodeDecodeError:
        return "latin-1"
    return "utf-8-sig"


def not_text(path: pathlib.Path, reason: str) -> FileError:
    """Message for a file that is not text."""
    return FileError(f"{path} is no text ({reason}): it is compressed or binary; unpack it, or write it as text")


def printable(text: str) -> str:
    """Text without terminal control characters."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def refuse_cut_end(path: pathlib.Path) -> None:
    """Raises InputError if the last line has no end: its last number may be truncated, "0.12" of "0.125"."""
    with opened(path) as file:
        last = ""
        for last in file:
            pass
    if last and not last.endswith("\n"):
        raise InputError(f"{path}: the last line, {last.strip()[-40:]!r}, has no end of line (its last number may be cut); make "
                         "the file again, take an earlier frame, or, if it is whole, add an end of line")


def numbers(words: Iterable[str], where: str) -> list[float]:
    """Words as finite numbers. Raises InputError."""
    found = []
    for word in words:
        value = float(word.lower().replace("d", "e")) if NUMBER.fullmatch(word) else np.nan
        if not np.isfinite(value):
            if NUMBER.fullmatch(word) or NOT_FINITE.fullmatch(word):
                raise InputError(f"{where}: {word} (must be finite); the run that wrote it had failed by then")
            raise InputError(f"{where}: {word!r} is no number; mend the file, or make it again")
        found.append(value)
    return found


def column(rows: Sequence[Sequence[str]], where: Callable[[int], str]) -> Array:
    """Numbers of rows of words of equal length, [N, columns]. Raises InputError, with `where` of the row."""
    words = [word for row in rows for word in row]
    shape = len(rows), len(rows[0]) if rows else 1
    together = " ".join(words)
    if together.isascii() and "_" not in together:  # which Python alone takes for digits, and for part of a number
        try:
            if np.isfinite(found := np.array(words, dtype=np.float64)).all():
                return found.reshape(shape)
        except ValueError:
            pass  # of Fortran, or none: one by one
    return np.array([numbers(row, where(k)) for k, row in enumerate(rows)], dtype=np.float64).reshape(shape)


def whole_number(rows: Sequence[str], where: str) -> int:
    """The only word of the only row. Raises InputError if it is not a whole number."""
    words = " ".join(rows).split()
    if len(words) != 1 or numbers(words, where)[0] % 1:
        raise InputError(f"{where}: {' '.join(words)[:40] or 'nothing'} (must be a whole number); the file is damaged")
    return int(numbers(words, where)[0])


def table(rows: Sequence[str], names: Sequence[str], where: Callable[[int], str], otherwise: Sequence[int] = ()
          ) -> list[list[str]]:
    """Rows of words, one for each name; or all of another length. Raises InputError."""
    split = [row.split() for row in rows]
    width = len(split[0]) if split and len(split[0]) in otherwise else len(names)
    for k, words in enumerate(split):
        if len(words) != width:
            raise InputError(f"{where(k)}: {len(words)} columns (must be {width}{_told(names, width)}): {rows[k].strip()[:80]!r}; "
                             + CUT)
    return split


def _told(names: Sequence[str], width: int) -> str:
    text = " ".join(names)
    return f", {text}" if width == len(names) and len(text) < 120 else ""
