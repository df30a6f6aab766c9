# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program: scenes and sweeps, with their progress, and its messages as exceptions."""

from __future__ import annotations

import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import sysconfig
import tempfile
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, TextIO, Union

from .errors import (Error, FileError, InputError, InternalError, Interrupted, NumericalError,
                     SweepError)
from .results import Run, load
from .scene import flat_items, key_of, toml_text, toml_value
from .sweeps import Sweep, sweep

Path = Union[str, "os.PathLike[str]"]
Progress = Union[bool, Callable[[float], None]]  #: shown or not; or called with the share done, 0 .. 1

ERRORS: dict[int, type[Error]] = {1: SweepError, 2: InputError, 3: NumericalError, 4: FileError,
                                  5: InternalError, 129: Interrupted, 130: Interrupted, 143: Interrupted}
REPORTS = "BAGNOLD_SWEEP_PIPE"  # the descriptor through which the program tells its share, in doubles


def find_program(program: Path | None = None) -> str:
    """Path of the program: `program`, else BAGNOLD_PROGRAM, both a path or a name in PATH; else the one that pip
    installed with this package, else `bagnold` in PATH. Raises FileError."""
    for given, source in ((program, "program"), (os.environ.get("BAGNOLD_PROGRAM"), "BAGNOLD_PROGRAM")):
        if given:
            found = shutil.which(os.fspath(given))
            if found is None:
                raise FileError(f"{source} = {os.fspath(given)} (must be a program); give the path of bagnold, "
                                "as build/openmp/bagnold")
            return os.path.abspath(found)
    found = shutil.which("bagnold", path=sysconfig.get_path("scripts")) or shutil.which("bagnold")
    if found is None:
        raise FileError("the program bagnold is not in PATH; install it, or name it: "
                        "BAGNOLD_PROGRAM=PATH, or program=PATH")
    return os.path.abspath(found)


def run(scene: Mapping[str, Any] | Path, out: Path | None = None, *, program: Path | None = None,
        threads: int | None = None, force: bool = False, allow_unstable: bool = False,
        progress: Progress = True, **set: Any) -> Run:
    """Runs a scene to its end and reads its results. A finished run in the folder is loaded, and a stopped one
    continued, if it is of the same resolved scene; a run of another scene is refused.

    scene: a file, or nested tables ``{"disks": {"model": "CD_n", ...}, "shear": {...}}``, where a relative
    ``start.file`` is relative to the current folder. out: folder for the results; by default results/NAME for a file,
    as in the program. force: replaces the run that is in the folder, of this scene or another. set: keys put over the
    scene, ``disks__elasticity=10`` or ``**{"disks.elasticity": 10}``.

    Raises the errors of the program: InputError, NumericalError, FileError, Interrupted (after Ctrl-C, with a
    checkpoint: KeyboardInterrupt) ... Reasons to doubt the result are warnings, and in `r.warnings`."""
    keys = {key_of(name): value for name, value in set.items()}
    with scene_file(scene, keys) as (file, overrides):
        folder = folder_of(scene, out)
        words = ["run", file, "--out", str(folder), *overrides]
        words += ["--force"] if force else []
        words += ["--allow-unstable"] if allow_unstable else []
        words += [] if threads is None else ["--threads", str(threads)]
        call(find_program(program), words, progress, str(folder), file if isinstance(scene, Mapping) else None)
    return load(folder)


def resume(folder: Path, *, strain: float | None = None, program: Path | None = None,
           threads: int | None = None, progress: Progress = True) -> Run:
    """Continues an interrupted run, bit for bit, and reads its results. strain: makes it longer, finished or not, to
    this total."""
    words = ["resume", os.fspath(folder)] + ([] if threads is None else ["--threads", str(threads)])
    words += [] if strain is None else ["--strain", repr(float(strain))]
    call(find_program(program), words, progress, os.fspath(folder))
    return load(folder)


def sweep_file(file: Mapping[str, Any] | Path, out: Path | None = None, *, program: Path | None = None,
               jobs: int | None = None, progress: Progress = True) -> Sweep:
    """Runs the points of a sweep that are not done, and reads their table.

    file: a sweep file, or nested tables with ``"sweep": {"grid": {...}}``. out: as of `run`. jobs: points at a time, by
    default as many as there are cores. progress: shown as the program's lines, or called with the share of points that
    are done. Raises SweepError if points failed: the table of the others is then written."""
    with scene_file(file, {}) as (path, _):
        folder = folder_of(file, out)
        words = ["sweep", path, "--out", str(folder)] + ([] if jobs is None else ["--jobs", str(jobs)])
        call(find_program(program), words, progress, str(folder), path if isinstance(file, Mapping) else None, of_sweep=True)
    return sweep(folder)


def folder_of(scene: Mapping[str, Any] | Path, out: Path | None) -> pathlib.Path:
    if out is not None:
        return pathlib.Path(out)
    if isinstance(scene, Mapping):
        raise InputError("out is not given (a scene that is no file has no name); say where the results go, "
                         'out="results/NAME"')
    return pathlib.Path("results") / pathlib.Path(scene).stem


@contextmanager
def scene_file(scene: Mapping[str, Any] | Path, keys: Mapping[str, Any]
                ) -> Iterator[tuple[str, list[str]]]:
    """A file with the scene, and the words that put `keys` over it."""
    if not isinstance(scene, Mapping):
        yield os.fspath(scene), [word for key, value in keys.items()
                                 for word in ("--set", f"{key}={toml_value(value)}")]
        return
    flat = {**dict(flat_items(scene)), **keys}
    if "start.file" in flat:
        flat["start.file"] = os.path.abspath(flat["start.file"])
    for table in ("sweep.grid", "sweep.zip"):
        if "start.file" in flat.get(table, {}):
            flat[table] = {**flat[table], "start.file": [os.path.abspath(one) for one in flat[table]["start.file"]]}
    with tempfile.TemporaryDirectory(prefix="bagnold-") as folder:
        path = pathlib.Path(folder) / "scene.toml"
        path.write_text(toml_text(flat), encoding="utf-8")
        yield str(path), []


def said_by(program: str, words: list[str], codes: tuple[int, ...] = (0,), *, nobodys: str | None = None,
            errors: list[str] | None = None) -> str:
    """Output of the program until it ends, with one of these codes; its messages go to `errors`, otherwise they are
    warnings. Raises as `run` does."""
    try:
        done = subprocess.run([program, *words], stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise FileError(f"{program} cannot be started: {error}") from error
    said = done.stderr if nobodys is None else done.stderr.replace(nobodys + ":", "scene:").replace(nobodys, "scene")
    lines = [line.removeprefix("bagnold: ") for line in said.splitlines() if line.strip()]
    if done.returncode not in codes:
        raise ERRORS.get(done.returncode, InternalError)("\n".join(lines) or f"{program} ended with code {done.returncode}")
    if errors is not None:
        errors.extend(lines)
    else:
        for line in lines:
            warnings.warn(line.removeprefix("warning: "), stacklevel=3)
    return done.stdout if nobodys is None else done.stdout.replace(nobodys, "scene")


def call(program: str, words: list[str], progress: Progress, name: str, nobodys: str | None = None,
          of_sweep: bool = False) -> None:
    """Runs the program to its end. On KeyboardInterrupt it writes its checkpoint first. nobodys: a file that is removed
    afterwards; messages name the copy in the folder instead, and "scene" for a line of it."""
    reader, writer = os.pipe()
    environment = {**os.environ, **({} if of_sweep else {REPORTS: str(writer)})}
    try:  # a group of its own: a Ctrl-C comes from here, once
        child = subprocess.Popen([program, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True, errors="replace", env=environment,
                                 pass_fds=(writer,), process_group=0)
    except OSError as error:
        os.close(reader)
        raise FileError(f"{program} cannot be started: {error}") from error
    finally:
        os.close(writer)
    told: list[str] = []
    shown = _Shown(progress, name)
    threads = [threading.Thread(target=_lines, args=(child.stdout, shown if of_sweep else None), daemon=True),
               threading.Thread(target=lambda: told.append(child.stderr.read() if child.stderr else ""),
                                daemon=True),
               threading.Thread(target=_shares, args=(reader, shown), daemon=True)]
    for thread in threads:
        thread.start()
    try:
        with _passed_on(child):
            child.wait()
    except KeyboardInterrupt:
        child.send_signal(signal.SIGINT)
        child.wait()
        raise
    finally:
        if child.returncode is None:
            child.terminate()
            child.wait()
        for thread in threads:
            thread.join()
        for stream in (child.stdout, child.stderr):
            if stream is not None:
                stream.close()
        shown.end(done=child.returncode == 0 and not of_sweep)
    said = "".join(told)
    if nobodys is not None:
        copy = pathlib.Path(name) / ("sweep.toml" if of_sweep else "scene.toml")
        said = said.replace(nobodys + ":", "scene:").replace(nobodys, str(copy) if copy.exists() else "scene")
    lines = [line.removeprefix("bagnold: ") for line in said.splitlines() if line.strip()]
    if child.returncode != 0:
        kind = ERRORS.get(child.returncode or 0, InternalError)
        raise kind("\n".join(lines) or f"{program} ended with code {child.returncode}")
    for line in lines:
        if line.startswith("note: "):  # in the run's notes
            continue
        warnings.warn(line.removeprefix("warning: "), stacklevel=3)


@contextmanager
def _passed_on(child: subprocess.Popen[str]) -> Iterator[None]:
    """SIGTERM, as of a batch system, goes to the program too, which writes its checkpoint; then Python exits with 143, unless
    the caller has a handler of its own."""
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGTERM) is not signal.SIG_DFL:
        yield
        return
    asked: list[int] = []

    def pass_on(number: int, frame: object) -> None:
        asked.append(number)
        child.send_signal(number)

    signal.signal(signal.SIGTERM, pass_on)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if asked:
        raise SystemExit(128 + signal.SIGTERM)


def _bar(name: str) -> Any:
    """A bar of tqdm in a notebook, where that is installed; None elsewhere."""
    if "ipykernel" not in sys.modules:
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # no widgets: a bar of text
            from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(total=100, desc=name, bar_format="{l_bar}{bar}| {elapsed}<{remaining}")


class _Shown:
    """Progress in the requested form: a bar in a notebook, else a line on stderr; a call; or nothing."""

    def __init__(self, progress: Progress, name: str) -> None:
        self._call = progress if callable(progress) else None
        self._bar = _bar(name) if progress is True else None
        self._line = progress is True and self._bar is None
        self._name, self._begun, self._last = name, False, 0.0

    def share(self, share: float) -> None:
        """Shows a share of the work."""
        self._last = share
        if self._call is not None:
            self._call(share)
        elif self._bar is not None:
            self._bar.n = round(100 * share)
            self._bar.refresh()
        elif self._line:
            self.text(f"{self._name}: {100 * share:.0f}%")

    def text(self, line: str) -> None:
        """Replaces the last line by a line."""
        if self._line:
            self._begun = True
            sys.stderr.write(f"\r{line:<60}")
            sys.stderr.flush()

    def end(self, done: bool) -> None:
        """Ends the line, if `done` with the whole."""
        if done and self._last < 1:
            self.share(1.0)
        if self._bar is not None:
            self._bar.close()
        if self._begun:
            sys.stderr.write("\n")


def _shares(reader: int, shown: _Shown) -> None:
    """Reads shares until the program ends."""
    with os.fdopen(reader, "rb", buffering=0) as pipe:
        rest = b""
        while part := pipe.read(4096):
            rest += part
            whole = len(rest) // 8 * 8
            if whole:
                shown.share(struct.unpack(f"{whole // 8}d", rest[:whole])[-1])
            rest = rest[whole:]


def _lines(stream: TextIO, shown: _Shown | None) -> None:
    """Reads the output of the program; the lines of a sweep are its progress: "3 of 8 points done, ..."."""
    for line in stream:
        words = line.split()
        if shown is not None and words[1:2] == ["of"] and words[3:5] == ["points", "done,"]:
            shown.text(line.strip())
            if not shown._line:
                shown.share(int(words[0]) / int(words[2]))
