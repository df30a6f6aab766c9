# SPDX-License-Identifier: BSD-3-Clause
"""Reads, plots and exports results of the simulator Bagnold, and runs it.

    r = bagnold.load("results/first")
    r["B_p"].mean, r["B_p"].error      # averages
    r.series["B_p"]                    # one value a window, [n]
    for frame in r.frames: ...         # the trajectory
    bagnold.sweep("results/many").to_pandas()
    bagnold.run({"disks": {...}, "shear": {...}}, out="results/new")

Lengths are in d_s (diameter of the small disks), times in tau_e, masses in m. `bagnold.plots` draws;
`bagnold.structure` has g(r), S(q), force networks; `python -m bagnold export` writes other formats, `import` reads
them.
"""

from typing import TYPE_CHECKING, Any

from . import structure
from .commands import Analysis, LimitCheck, Status, Validation, analyse, check_limit, status, validate
from .contacts import Contacts, contacts_of
from .errors import (Error, FileError, InputError, InternalError, Interrupted, MissingLibrary,
                     NumericalError, SweepError)
from .exports import export
from .frames import Box, Frame, Frames
from .imports import ImportedState, import_state
from .movies import movie
from .observables import Observable, Warning
from .program import find_program, resume, run, sweep_file
from .reports import report
from .results import Run, load
from .scene import Scene
from .sweeps import Sweep, sweep
from .watching import watch

if TYPE_CHECKING:
    from . import plots

__version__ = "1.0.0"

__all__ = [
    "Analysis", "Box", "Contacts", "Error", "FileError", "Frame", "Frames", "ImportedState", "InputError",
    "InternalError", "Interrupted", "LimitCheck", "MissingLibrary", "NumericalError", "Observable", "Run", "Scene", "Status",
    "Sweep", "SweepError", "Validation", "Warning", "analyse", "check_limit", "contacts_of", "export", "find_program",
    "import_state", "load", "movie", "plots", "report", "resume", "run", "status", "structure", "sweep", "sweep_file", "validate", "watch",
]


def __getattr__(name: str) -> Any:
    """Imports `bagnold.plots` when it is used: it needs matplotlib."""
    if name == "plots":
        import importlib

        return importlib.import_module(".plots", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """Public names."""
    return sorted([*__all__, "__doc__", "__version__"])
