# SPDX-License-Identifier: BSD-3-Clause
"""HDF5 files, also on file systems without locks (Lustre without -o flock, NFS without a lock service, FUSE)."""

from __future__ import annotations

import os
from typing import Any

import h5py

from .errors import FileError


def open_hdf5(path: str | os.PathLike[str]) -> Any:
    """For reading. Raises FileError."""
    try:
        return unlocked(path, "r")
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error}") from error


def unlocked(path: str | os.PathLike[str], mode: str) -> Any:
    """As h5py.File, without the flock(2) that HDF5 takes of each file: the program replaces files as a whole, and its run
    lock keeps others out. Raises OSError."""
    try:
        return h5py.File(path, mode, locking=False)
    except OSError as error:
        if "locking flag" not in str(error):
            raise
        return h5py.File(path, mode)  # opened by the caller too, with a lock, as HDF5 then wants it of all
