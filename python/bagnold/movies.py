# SPDX-License-Identifier: BSD-3-Clause
"""Films of trajectories: disks, force chains, bands, and a series with the position of the frame."""

from __future__ import annotations

import os
import pathlib
import shutil
from collections.abc import Callable
from typing import Any

from .errors import InputError, MissingLibrary
from .files import replaceable, replaced
from .results import Run, load

FORMS = (".gif", ".mp4")


def movie(source: Run | str | os.PathLike[str], out: str | os.PathLike[str], *, frames: slice = slice(None), color: str = "velocity",
          forces: bool = True, series: str = "", fps: int = 15, dpi: int = 100, progress: Callable[[float], None] | None = None) -> pathlib.Path:
    """Writes a film of a run's trajectory and returns its path.

    out: NAME.gif, by Pillow, or NAME.mp4, by ffmpeg: that of imageio-ffmpeg, or in PATH. color: of disks, as in
    `bagnold.plots.packing`; "rate" shows bands. series: the series drawn below, over the strain; by default sigma, of a
    ramp its strain rate. progress: called with the share done."""
    from . import plots

    target = pathlib.Path(out)
    if target.suffix not in FORMS:
        raise InputError(f"out = {target} (must end with {' or '.join(FORMS)}); as film.mp4")
    run = source if isinstance(source, Run) else load(source)
    chosen = run.frames[frames]
    if not len(chosen):
        raise InputError(f"frames = {frames} (none of the {len(run.frames)} frames of {run.folder}); use a range within them")
    writer = _writer(target, fps)
    replaceable(target)
    film: Any = plots.film(run, chosen, color=color, forces=forces, series=series)
    try:
        with replaced(target, target.suffix) as part, writer.saving(film.figure, os.fspath(part), dpi):
            for number in range(len(chosen)):
                film.show(number)
                writer.grab_frame()
                if progress is not None:
                    progress((number + 1) / len(chosen))
    finally:
        film.close()
    return target


def _writer(target: pathlib.Path, fps: int) -> Any:
    from matplotlib import animation, rcParams

    if target.suffix == ".gif":
        return animation.PillowWriter(fps=fps)
    try:
        import imageio_ffmpeg

        rcParams["animation.ffmpeg_path"] = imageio_ffmpeg.get_ffmpeg_exe()
    except ImportError as error:
        if shutil.which("ffmpeg") is None:
            raise MissingLibrary(f"{target} needs ffmpeg ({error}; pip install imageio-ffmpeg, or Debian: apt install ffmpeg); or "
                                 f"name {target.with_suffix('.gif')}") from error
    return animation.FFMpegWriter(fps=fps, extra_args=["-pix_fmt", "yuv420p", "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2"])
