# SPDX-License-Identifier: BSD-3-Clause
"""Files that are read, and names of files beside others."""

from __future__ import annotations

import errno
import os
import pathlib
from collections.abc import Iterable

ENDINGS = (".lammpstrj", ".dump", ".lmp", ".txt", ".pvd")  # of exports that have files beside them


def beside(path: pathlib.Path, ending: str) -> pathlib.Path:
    """NAME + ending of NAME or NAME.lammpstrj: the ".80" of "phi0.80" is no ending."""
    return path.with_name((path.stem if path.suffix in ENDINGS else path.name) + ending)


def regular(path: str | os.PathLike[str]) -> pathlib.Path:
    """The path itself, unless it is a pipe: nobody may write into that, and who opens it waits without end. Raises
    OSError."""
    path = pathlib.Path(path)
    if path.is_fifo():
        raise OSError(errno.EINVAL, "it is a pipe, not a file", str(path))
    return path


def stamps(folder: pathlib.Path, names: Iterable[str]) -> dict[str, tuple[int, int, int]]:
    """Time of change, inode and size of the files of a folder with these names or patterns. They differ where a file
    was replaced."""
    found = {}
    for path in (path for name in names for path in folder.glob(name)):
        try:
            state = path.stat()
        except OSError:  # removed meanwhile
            continue
        found[path.name] = state.st_mtime_ns, state.st_ino, state.st_size
    return found
