# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: nested tables, or keys with dots as in sweep files and `--set`."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from typing import Any


class Scene(dict[str, Any]):
    """A resolved scene, one dictionary a table; ``scene["disks.count"]`` is
    ``scene["disks"]["count"]``."""

    def __missing__(self, key: str) -> Any:
        table, dot, rest = key.partition(".")
        if dot and table in self and isinstance(self[table], Mapping) and rest in self[table]:
            return self[table][rest]
        raise KeyError(f"{key} is not in the scene; it has {', '.join(self.flat())}")

    def get(self, key: str, default: Any = None) -> Any:
        """The value of a key, with dots or without; `default` where the scene has none."""
        try:
            return self[key]
        except KeyError:
            return default

    def flat(self) -> dict[str, Any]:
        """``{"disks.count": 1024, ...}``."""
        return dict(flat_items(self))


def flat_items(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Keys with dots and their values; a table without keys, as ``target_error = {}``, is a value."""
    for key, value in table.items():
        if isinstance(value, Mapping) and value and not (prefix and _is_inline(prefix + key)):
            yield from flat_items(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def _is_inline(key: str) -> bool:
    """True for keys whose values are tables."""
    return key in ("shear.target_error", "sweep.grid", "sweep.zip")


def toml_value(value: Any) -> str:
    """A value as TOML: bool, number, text, list or table; NumPy's scalars and arrays too.

    Raises TypeError for what TOML has no form of."""
    if hasattr(value, "tolist"):  # NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_toml_text(k)} = {toml_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_value(one) for one in value) + "]"
    if isinstance(value, str) or hasattr(value, "__fspath__"):
        return _toml_text(str(value))
    raise TypeError(f"{value!r} ({type(value).__name__}) has no form in a scene; "
                    "use a bool, a number, a text, a list or a table")


def _toml_text(text: str) -> str:
    """A basic string of TOML: JSON's escapes are among TOML's, but DEL is to be escaped too."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def toml_text(scene: Mapping[str, Any]) -> str:
    """A scene as the text of a file, from nested tables or keys with dots; keys without a table,
    as ``title``, come first."""
    flat = dict(flat_items(scene))
    tables: dict[str, list[str]] = {}
    for key, value in flat.items():
        table, _, name = key.rpartition(".")
        tables.setdefault(table, []).append(f"{name} = {toml_value(value)}")
    lines = tables.pop("", [])
    for table, keys in tables.items():
        lines += ["", f"[{table}]", *keys]
    return "\n".join(lines) + "\n"


def key_of(keyword: str) -> str:
    """``disks__packing_fraction`` as a keyword of Python is ``disks.packing_fraction``."""
    return keyword.replace("__", ".", 1)
