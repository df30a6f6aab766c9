# SPDX-License-Identifier: BSD-3-Clause
"""A run or a sweep in the terminal while it is in progress: status, p, sigma, Z, remaining time."""

from __future__ import annotations

import math
import os
import pathlib
import shutil
import sys
import time
from collections.abc import Iterator

import numpy as np

from .commands import Status, status
from .errors import Error
from .program import Path
from .results import load

NAMES = ("p", "sigma", "Z")
LATE = 10  # means are of the last so many windows


def watch(folder: Path, *, every: float = 2.0, once: bool = False, program: Path | None = None) -> Status:
    """Shows the status of a run, a cascade or a sweep until no process works on it, and returns it.

    every: seconds between updates. once: one update. The status of a run is that of its last checkpoint: means of the
    last ten windows."""
    shown = 0
    while True:
        found = status(folder, program=program)
        lines = list(lines_of(found))
        if sys.stdout.isatty():
            width, height = shutil.get_terminal_size()
            lines = [line[:width - 1] for line in lines[:height - 2]]
            if shown:
                sys.stdout.write(f"\x1b[{shown}A\x1b[J")
            shown = len(lines)
        print("\n".join(lines), flush=True)
        if once or not is_at_work(found):
            return found
        time.sleep(every)


def is_at_work(found: Status) -> bool:
    """True if a process works on it, or on a part of it."""
    return bool(found.holder) or found.state == "running" or any(point.state == "running" for point in found.points)


def lines_of(found: Status) -> Iterator[str]:
    """Lines to show: of many points those in progress and those that failed, one a line, then their numbers."""
    if not found.points:
        yield line_of(found, str(found.folder))
        return
    told = [point for point in found.points if point.state in ("running", "failed", "stopped")] \
        if found.kind == "sweep" else list(found.points)
    for number, point in enumerate(told, 1):
        yield line_of(point, point.folder.name if found.kind == "sweep" else f"{number}")
    states = [point.state for point in found.points]
    counts = ", ".join(f"{states.count(one)} {one}" for one in dict.fromkeys(states))
    yield f"{found.folder}: {len(states)} {'points' if found.kind == 'sweep' else 'rates'}: {counts}; " \
          f"{100 * found.share:.0f}%{left_of(found.seconds_left, ' of one core') if is_at_work(found) else ''}"


def line_of(found: Status, name: str) -> str:
    """One run: its name, state, share, strain, means, time left."""
    text = f"{name}  {found.state} {100 * found.share:3.0f}%"
    if math.isfinite(found.strain):
        text += f"  strain {found.strain:.4g}"
    text += "".join(f"  {one} {value:.4g}" for one, value in late_means(found.folder).items())
    if found.state == "running":
        text += left_of(found.seconds_left)
    if found.failure:
        text += f"  {found.failure}"
    return text + (f"  warnings: {', '.join(found.warnings)}" if found.warnings else "")


def late_means(folder: pathlib.Path) -> dict[str, float]:
    """Means of the last windows; nothing before there are any."""
    if not os.path.exists(folder / "result.h5"):
        return {}
    try:
        series = load(folder).series
        found = {name: np.atleast_2d(series[name]) for name in NAMES if name in series}
        late = {name: each[:, ~np.isnan(each).all(axis=0)][:, -LATE:] for name, each in found.items()}  # replicas may lag
        return {name: float(np.nanmean(each)) for name, each in late.items() if each.size}
    except (Error, OSError, KeyError):  # it is just being written
        return {}


def left_of(seconds: float, what: str = "") -> str:
    """``, 12 min left``; nothing if that is not known."""
    if not math.isfinite(seconds):
        return ""
    for unit, size in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f", {seconds / size:.3g} {unit}{what} left"
    return f", {seconds:.0f} s{what} left"
