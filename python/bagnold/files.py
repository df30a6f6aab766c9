# SPDX-License-Identifier: BSD-3-Clause
"""Files that are read."""

from __future__ import annotations

import errno
import os
import pathlib


def regular(path: str | os.PathLike[str]) -> pathlib.Path:
    """The path itself, unless it is a pipe: nobody may write into that, and who opens it waits without end. Raises
    OSError."""
    path = pathlib.Path(path)
    if path.is_fifo():
        raise OSError(errno.EINVAL, "it is a pipe, not a file", str(path))
    return path
