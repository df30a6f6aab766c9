# SPDX-License-Identifier: BSD-3-Clause
"""HDF5 files, also on file systems without locks (Lustre without -o flock, NFS without a lock service, FUSE)."""

from __future__ import annotations

import os
from typing import Any

import h5py
import numpy as np

from .errors import FileError
from .files import regular


def open_hdf5(path: str | os.PathLike[str]) -> Any:
    """Opens a file for reading. Raises FileError."""
    try:
        return unlocked(path, "r")
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error}") from error


def unlocked(path: str | os.PathLike[str], mode: str) -> Any:
    """Opens a file as h5py.File does, without HDF5's flock(2): the program replaces files as a whole, and its run lock
    excludes other processes. Raises OSError."""
    try:
        return h5py.File(regular(path), mode, locking=False)
    except OSError as error:
        if "locking flag" not in str(error):
            raise
        return h5py.File(path, mode)  # opened by the caller too, with a lock, as HDF5 then wants it of all


def plain(value: Any) -> Any:
    """An attribute as a text, a number or an array."""
    if isinstance(value, bytes):
        return value.decode(errors="replace")
    return value.item() if isinstance(value, np.generic) else value


def columns_of(table: Any) -> dict[str, Any]:
    """Columns of a dataset of /samples by their names, without units."""
    rows, names = table[()], str(plain(table.attrs["columns"])).split(", ")
    return {name.split(" [")[0]: rows[:, k] for k, name in enumerate(names)}
