# SPDX-License-Identifier: BSD-3-Clause
"""Files that are read, files that are written whole, and names of files beside others."""

from __future__ import annotations

import contextlib
import errno
import os
import pathlib
from collections.abc import Iterable, Iterator

from .errors import FileError

ANOTHER = "name another file"
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


def replaceable(path: str | os.PathLike[str], remedy: str = ANOTHER) -> pathlib.Path:
    """The file that a new one takes the place of: of a link, what it points to. Raises FileError where that is a
    folder, a device or a pipe."""
    target = pathlib.Path(os.path.realpath(path))
    if (os.path.exists(path) and not os.path.isfile(path)) or target.is_symlink():  # still a link: of a circle
        wrong = "Is a directory" if target.is_dir() else "it is no regular file"
        raise FileError(f"{path} cannot be written: {wrong}; {remedy}")
    return target


@contextlib.contextmanager
def replaced(path: str | os.PathLike[str], ending: str = "", remedy: str = ANOTHER) -> Iterator[pathlib.Path]:
    """Where to write a file, which appears only when it is complete. The name ends with .part and the ending. Raises
    FileError, which ends with the remedy."""
    target = replaceable(path, remedy)
    part = target.with_name(target.name + ".part" + ending)
    try:
        yield part
        os.replace(part, target)
    except FileError:
        raise
    except OSError as error:
        raise FileError(f"{path} cannot be written: {error.strerror or error}; {remedy}") from error
    finally:
        with contextlib.suppress(OSError):  # a file system that may only be read
            part.unlink(missing_ok=True)
