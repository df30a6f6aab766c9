# SPDX-License-Identifier: BSD-3-Clause
"""Errors, by who can correct them. The message says what is wrong, why, and what to do."""

from __future__ import annotations

import importlib
from typing import Any


class Error(Exception):
    """Base of all errors that this package raises on its own."""


class InputError(Error, ValueError):
    """A scene, a sweep file or an argument is wrong (exit code 2 of the program)."""


class NotOfThisRun(InputError, AttributeError):
    """A run of another protocol has it: ``hasattr(run, "pieces")`` is false."""


class NumericalError(Error, ArithmeticError):
    """The motion is unphysical, for instance because of a time step too large (exit code 3)."""


class FileError(Error, OSError):
    """A file or a folder is missing, cannot be written, or is not what it should be (exit code 4)."""

    def __str__(self) -> str:  # of OSError it would be that of errno
        return " ".join(str(part) for part in self.args)


class SweepError(Error):
    """Points of a sweep failed; the others are done (exit code 1)."""


class Interrupted(Error):
    """The program was stopped by a signal, with a checkpoint written (exit codes 129, 130, 143)."""


class InternalError(Error):
    """An error in the program, to be reported (exit code 5, or a crash)."""


class MissingLibrary(Error, ImportError):
    """A library that only this function needs is not installed."""


def needed(name: str, what: str) -> Any:
    """Imports the library `name`, which `what` needs. Raises MissingLibrary."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise MissingLibrary(f"{what} needs {name} ({error}; Debian: apt install python3-{name}, else "
                             f"pip install {name})") from error
