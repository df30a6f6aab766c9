# SPDX-License-Identifier: BSD-3-Clause
"""The second line of a frame of extended XYZ: KEY=VALUE, values in quotes, brackets or bare."""

from __future__ import annotations

import re

from ..errors import InputError
from .text import numbers

CLOSING = {'"': '"', "'": "'", "{": "}", "[": "]", "(": ")"}
TRUTHS = {"t": True, "true": True, ".true.": True, "1": True, "p": True, "pp": True,
          "f": False, "false": False, ".false.": False, "0": False, "ff": False}


KEY = re.compile(r"\s*(\"[^\"]*\"|[^\s=\"]+)(\s*=\s*)?")


class Words:
    """Values by key, whatever the case of the key."""

    def __init__(self, where: str, text: str) -> None:
        """Raises InputError if a key occurs twice, or the line is damaged."""
        self._found: dict[str, str] = {}
        self._behind: dict[str, str] = {}  # words alone behind a value that nothing encloses, as in pbc=T T F
        at, last = 0, ""
        while key := KEY.match(text, at):
            at = key.end()
            if not key[2]:
                if last:
                    self._behind[last] += " " + key[1]
                continue
            name = key[1].strip('"').lower()
            last = name if text[at:at + 1] not in CLOSING else ""
            value, at = _value(where, text, at)
            if self._found.setdefault(name, value) != value:
                raise InputError(f"{where}: {key[1]} is there twice (with {self._found[name]!r} and {value!r}); take one out")
            self._behind[name] = ""
        if text[at:].strip():
            raise InputError(f"{where}: {text[at:at + 40].strip()!r} (must be KEY=VALUE, texts with spaces in quotes); mend the line")

    def get(self, name: str) -> str | None:
        """Value of a key; None if there is none."""
        return self._found.get(name)

    def several(self, name: str) -> str | None:
        """Values of a key, including unkeyed words behind a value without delimiters."""
        return None if name not in self._found else self._found[name] + self._behind[name]


def _value(where: str, text: str, at: int) -> tuple[str, int]:
    """A value without its delimiters, and its end."""
    opening = text[at:at + 1]
    if opening not in CLOSING:
        end = re.compile(r"\S*").match(text, at)
        assert end is not None
        return end[0], end.end()
    depth, closing = 0, CLOSING[opening]
    for k in range(at, len(text)):
        if text[k] == closing and (opening == closing and k > at or depth == 1):
            return text[at + 1:k], k + 1
        depth += (text[k] == opening) - (text[k] == closing)
    raise InputError(f"{where}: {text[at:at + 40].strip()!r} (must end with {closing}); the line is damaged")


def _parts(text: str) -> list[str]:
    return re.sub(r"[\[\](){},;\"']", " ", text).split()


def numbers_in(text: str, where: str) -> list[float]:
    """Numbers separated by spaces, commas or brackets. Raises InputError."""
    return numbers(_parts(text), where)


def truths_in(text: str, where: str) -> list[bool]:
    """Truth values for the axes, from T and F, True and False, 1 and 0; a single one holds for all. Raises
    InputError."""
    parts = _parts(text)
    if len(parts) == 1 and re.fullmatch("[tfTF01]{3}", parts[0]):  # TTF
        parts = list(parts[0])
    found = [TRUTHS.get(part.lower()) for part in parts]
    if len(found) not in (1, 2, 3) or None in found:
        raise InputError(f"{where} = {text.strip()!r} (must be T or F of each axis, as \"T T F\"); mend the line")
    truths = [bool(one) for one in found]
    return truths * 3 if len(truths) == 1 else truths
