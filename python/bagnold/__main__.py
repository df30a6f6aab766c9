# SPDX-License-Identifier: BSD-3-Clause
"""python -m bagnold plot SOURCE TARGET, export DIR --to FORMAT, import FILE --out STATE, report DIR, watch DIR, movie DIR FILE.

The program calls them so. Exit codes: 0 done, 1 no picture, else those of the program.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import re
import sys
from collections.abc import Sequence

from .errors import Error, FileError, InputError
from .exports import FORMATS, export, parse_frames
from .imports import FORMATS as SOURCES, import_state, parse_diameters, parse_number
from .movies import movie
from .reports import report
from .watching import watch

PLOT_FAILED, BAD_INPUT, FILE_FAILURE, INTERRUPTED, NOBODY_READS = 1, 2, 4, 130, 141


def plot(options: argparse.Namespace) -> int:
    """Draws without a display."""
    try:
        import matplotlib

        matplotlib.use("Agg")
        from . import plots

        plots.draw_to(options.source, options.target, options.frames, options.style, options.panels)
    except Exception as error:  # the program shows this one line
        kind = "" if isinstance(error, (Error, OSError, ImportError)) else f"{type(error).__name__}: "
        print(f"bagnold plot: {options.source}, {options.target}: {kind}{' '.join(str(error).split())}", file=sys.stderr)
        return PLOT_FAILED
    return 0


def run_export(options: argparse.Namespace) -> int:
    """Writes a trajectory in another format."""
    for path in export(options.folder, options.to, options.out, frames=parse_frames(options.frames),
                       contacts=options.contacts):
        if not options.quiet:
            print(path)
    return 0


def run_import(options: argparse.Namespace) -> int:
    """Writes a state from a configuration of another program, and prints the keys that a scene needs."""
    def number(option: str, text: str | None) -> float | None:
        return None if text is None else parse_number(option, text)

    if not re.fullmatch("-?[0-9]+", options.frame):
        raise InputError(f"--frame {options.frame} (must be a whole number in decimal digits)")
    made = import_state(options.file, options.out, format=options.format, frame=int(options.frame),
                        unit=number("--unit", options.unit), time_unit=parse_number("--time-unit", options.time_unit),
                        strain_rate=number("--strain-rate", options.strain_rate),
                        diameters=None if options.diameters is None else parse_diameters(options.diameters),
                        atom_style=options.atom_style, bounds=options.bounds, tolerance=parse_number("--tolerance", options.tolerance))
    if not options.quiet:
        print(made, end="")
    return 0


def run_report(options: argparse.Namespace) -> int:
    """Writes a page of HTML."""
    if importlib.util.find_spec("matplotlib"):
        import matplotlib

        matplotlib.use("Agg")
    path = report(options.folder, options.out)
    if not options.quiet:
        print(path)
    return 0


def run_watch(options: argparse.Namespace) -> int:
    """Shows a run until no process works on it."""
    watch(options.folder, every=options.every, once=options.once, program=options.program)
    return 0


def run_movie(options: argparse.Namespace) -> int:
    """Films a trajectory."""
    if importlib.util.find_spec("matplotlib"):
        import matplotlib

        matplotlib.use("Agg")
    shown = sys.stderr.isatty() and not options.quiet

    def progress(share: float) -> None:
        if shown:
            print(f"\r{100 * share:3.0f}%", end="" if share < 1 else "\n", file=sys.stderr, flush=True)

    path = movie(options.folder, options.file, frames=parse_frames(options.frames), color=options.color,
                 forces=not options.no_forces, series=options.series, fps=options.fps, progress=progress)
    if not options.quiet:
        print(path)
    return 0


def main(words: Sequence[str] | None = None) -> int:
    """Reads the command line and returns the exit code."""
    line = argparse.ArgumentParser(prog="python -m bagnold", description="Pictures, exports and imports of Bagnold.")
    commands = line.add_subparsers(required=True, metavar="COMMAND")
    command = commands.add_parser("plot", help="draw a run, a sweep, an analysis, a figure")
    command.add_argument("source", help="a folder of a run, a cascade or a sweep, result.h5, PREFIX.drawn.csv, or recipe.json")
    command.add_argument("target", help="picture (.png, .pdf, .svg)")
    command.add_argument("--frames", action="store_true",
                         help="of a run: profiles.png, fields.png and histograms.png, into the folder TARGET, or as FOLDER/ANY.pdf")
    command.add_argument("--style", choices=("page", "paper"), default="page", help="paper: 3.375 inches wide, panels with letters")
    command.add_argument("--panels", help="of paper: which, as \"ac\"")
    command.set_defaults(run=plot)
    command = commands.add_parser("export", help="write a trajectory in another format")
    command.add_argument("folder", help="folder of a run with a trajectory")
    command.add_argument("--to", required=True, metavar="FORMAT", help=", ".join(FORMATS))
    command.add_argument("--out", help="file [trajectory.ENDING in the folder]")
    command.add_argument("--frames", default=":", metavar="A:B", help="from frame A to before B, from 0 [all]")
    command.add_argument("--contacts", action="store_true", help="contacts and their forces too")
    command.add_argument("--quiet", action="store_true", help="do not tell the files")
    command.set_defaults(run=run_export)
    command = commands.add_parser("import", help="write a state of a configuration of another program")
    command.add_argument("file", help="LAMMPS data file, LAMMPS dump, or extended XYZ")
    command.add_argument("--out", required=True, metavar="STATE", help="state file to write, for start.file")
    command.add_argument("--from", dest="format", metavar="FORMAT", help=f"{', '.join(SOURCES)} [as the file looks]")
    command.add_argument("--frame", default="-1", metavar="K", help="from 0, or from the end [-1, the last]")
    command.add_argument("--unit", metavar="LENGTH", help="d_s in the file's unit [its smallest diameter]")
    command.add_argument("--time-unit", default="1", metavar="TIME", help="tau_e in the file's unit [1]")
    command.add_argument("--strain-rate", metavar="RATE", help="of the velocities, in the file's unit [as it says]")
    command.add_argument("--diameters", metavar="TYPE=D,TYPE=D", help="by type, of a file without [none]")
    command.add_argument("--atom-style", metavar="STYLE", help="of a LAMMPS data file [its hint]")
    command.add_argument("--bounds", metavar="KIND", help="of a tilted cell in a dump: outer, of all that it covers, or edges, xlo "
                         "and xhi [as the disks lie]")
    command.add_argument("--tolerance", default="1e-6", help="of diameters, relative [1e-6]")
    command.add_argument("--quiet", action="store_true", help="do not tell what a scene needs")
    command.set_defaults(run=run_import)
    command = commands.add_parser("report", help="write a page of HTML of a run, a cascade or a sweep")
    command.add_argument("folder", help="of a run, a cascade or a sweep")
    command.add_argument("--out", help="file [report.html in the folder]")
    command.add_argument("--quiet", action="store_true", help="do not tell the file")
    command.set_defaults(run=run_report)
    command = commands.add_parser("watch", help="see a run, a cascade or a sweep go on")
    command.add_argument("folder", help="of a run, a cascade or a sweep")
    command.add_argument("--every", type=float, default=2.0, help="seconds between looks [2]")
    command.add_argument("--once", action="store_true", help="one look")
    command.add_argument("--program", help="bagnold [BAGNOLD_PROGRAM, or in PATH]")
    command.set_defaults(run=run_watch)
    command = commands.add_parser("movie", help="film a trajectory")
    command.add_argument("folder", help="folder of a run with a trajectory")
    command.add_argument("file", help="NAME.gif or NAME.mp4")
    command.add_argument("--frames", default=":", metavar="A:B:K", help="from frame A to before B, every K-th, from 0 [all]")
    command.add_argument("--color", default="velocity", help="velocity, speed, rate, spin, contacts, size [velocity]")
    command.add_argument("--no-forces", action="store_true", help="disks alone")
    command.add_argument("--series", default="", help="drawn below [sigma; of a ramp its rate]")
    command.add_argument("--fps", type=int, default=15, help="frames a second [15]")
    command.add_argument("--quiet", action="store_true", help="no progress")
    command.set_defaults(run=run_movie)
    options = line.parse_args(words)
    try:
        code: int = options.run(options)
        sys.stdout.flush()
    except Error as error:
        print(f"bagnold: {error}", file=sys.stderr)
        return FILE_FAILURE if isinstance(error, FileError) else BAD_INPUT
    except KeyboardInterrupt:
        return INTERRUPTED
    except OSError as error:
        if error.filename is not None:
            raise
        return _without_output(error)
    return code


def _without_output(error: OSError) -> int:
    """Ends quietly if standard output cannot be written, or its reader has closed it."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # what is left would fail again at the end
    if isinstance(error, BrokenPipeError):
        return NOBODY_READS
    print(f"bagnold: standard output cannot be written: {error.strerror or error}", file=sys.stderr)
    return FILE_FAILURE


if __name__ == "__main__":
    sys.exit(main())
