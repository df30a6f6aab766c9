# SPDX-License-Identifier: BSD-3-Clause
"""The program's pictures, as functions that return a figure of matplotlib.

    figure = bagnold.plots.run("results/first")
    bagnold.plots.save(figure, "first.pdf")

``style="paper"`` makes a page a figure for a journal, 3.375 inches wide, or 7 with more than three panels, which have
letters; ``panels="ac"`` takes some.
"""

from __future__ import annotations

import json
import os
import pathlib
from typing import TYPE_CHECKING, Any, Union

from . import (analysis_page, control_page, figure_page, frame_pages, oscillation_page, packing_page, paper, run_page, sequence_page,
               style as styles, sweep_page)
from ..errors import FileError, InputError
from ..hdf5 import open_hdf5
from ..sweeps import Sweep, sweep as read_sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..contacts import Contacts
    from ..frames import Frame, Frames
    from ..results import Run

    Source = Union["Run", str, "os.PathLike[str]"]

_PAGES = {"sequence": sequence_page.draw, "oscillate": oscillation_page.draw, "stress": control_page.draw,
          "pressure": control_page.draw}  # of protocols that have their own

__all__ = ["analysis", "draw_to", "fields", "figure", "film", "histograms", "packing", "profiles", "run", "save", "sweep"]


def run(source: Source, *, style: str = "page", panels: str | None = None) -> Figure:
    """One run on one page, plot.png: stresses, Z, mu, T_g, R_v, the last state; of a ramp its loop, of a sequence each
    piece against strain, of an oscillation Lissajous curves and moduli; at given stress the strain rate against time,
    at given pressure the packing fraction.

    source: a run, its folder, or its result.h5."""
    data = run_page.Run(str(_result(source)))
    with _styled():
        return _as(style, _PAGES.get(str(data.about.get("protocol")), run_page.draw)(data), panels)


def profiles(source: Source, *, style: str = "page", panels: str | None = None) -> Figure:
    """Profiles over y (P2 Fig. 28), profiles.png: of a run with measure.profiles."""
    return _as(style, _frame_page(source, "profiles", frame_pages.profiles_page), panels)


def fields(source: Source) -> Figure:
    """Local phi and gammadot of the last frame (P2 Fig. 27), fields.png: of a run with measure.fields."""
    return _frame_page(source, "samples/fields", frame_pages.fields_page)


def histograms(source: Source, *, style: str = "page", panels: str | None = None) -> Figure:
    """Angles, durations and clusters of contacts, spins, local phi and gammadot, histograms.png: of a run with
    measure.contacts, measure.rotation or measure.fields."""
    return _as(style, _frame_page(source, "histograms", frame_pages.histograms_page), panels)


def sweep(source: Sweep | str | os.PathLike[str], *, style: str = "page", panels: str | None = None) -> Figure:
    """A sweep at first sight, sweep.png: stresses, B_p, mu, Z against the key with most values. Of a cascade, or
    another sweep of rates, flow curves."""
    found = source if isinstance(source, Sweep) else read_sweep(source)
    with _styled():
        return _as(style, sweep_page.draw(found), panels)


def packing(source: Source | Frame, which: int = -1, *, color: str | Any = "velocity", forces: bool | Contacts = True,
            axes: Any = None, style: str = "page") -> Figure:
    """A packing with its contact forces, right at the images.

    source: a frame, or a run: frame `which` of its trajectory, else its last state. color: "velocity" (beyond the mean flow,
    along it), "speed", "rate" (of its slice: bands), "spin", "contacts", "size", or a number for each disk, [N]. forces: lines
    between centres, as wide as the force, of a frame alone as the elastic one (``forces=r.contacts[k]`` has the scene's law); or
    the contacts that they are of. axes: to draw into."""
    with _styled():
        return _as(style, packing_page.draw(source, which, color, forces, axes))


def film(run: Run, frames: Frames, *, color: str = "velocity", forces: bool = True, series: str = "") -> packing_page.Film:
    """Film of `bagnold.movie`: ``film.show(k)`` draws frame k into ``film.figure``."""
    with _styled():
        return packing_page.Film(run, frames, color, forces, series)


def analysis(drawn: str | os.PathLike[str], *, style: str = "page", panels: str | None = None) -> Figure:
    """Picture of an analysis from PREFIX.drawn.csv, which `bagnold analyse` wrote."""
    tables = analysis_page.read(os.fspath(drawn))
    with _styled():
        return _as(style, analysis_page.draw(tables), panels)


def figure(recipe: str | os.PathLike[str], *, style: str = "page", panels: str | None = None) -> Figure:
    """A figure of the papers from the recipe.json that `bagnold figure` wrote."""
    with open(recipe, encoding="utf-8") as file:
        content = json.load(file)
    with _styled():
        return _as(style, figure_page.draw(content, os.path.dirname(os.path.abspath(recipe))), panels)


def save(figure: Figure, target: str | os.PathLike[str], dpi: int = 110) -> None:
    """Writes a picture whole or not at all, in the form of its name: .pdf, .svg, else PNG."""
    styles.save(figure, target, dpi)


def draw_to(source: str | os.PathLike[str], target: str | os.PathLike[str], frames: bool = False,
            style: str = "page", panels: str | None = None) -> None:
    """Draws the picture that belongs to a file into a file: from result.h5 (or its folder) the page of the run, from
    the folder of a sweep or a cascade its points, from PREFIX.drawn.csv the analysis, from recipe.json the figure.
    frames: from result.h5 profiles, fields and histograms instead, as far as it has them; `target` is then a folder,
    for PNG, or FOLDER/ANY.pdf or .svg."""
    place = pathlib.Path(source)
    if place.suffix == ".csv":
        save(analysis(place, style=style, panels=panels), target)
    elif place.suffix == ".json" and style == "paper":
        save(figure(place, style=style, panels=panels), target)
    elif place.suffix == ".json":
        with _styled():
            figure_page.draw_to(os.fspath(place), os.fspath(target))
    elif (place / "sweep.h5").exists() or (place.is_dir() and not (place / "result.h5").exists()
                                           and (place / "summary.json").exists()):
        save(sweep(place, style=style, panels=panels), target)
    elif frames:
        with _styled():
            frame_pages.draw(os.fspath(_result(place)), os.fspath(target))
    else:
        save(run(place, style=style, panels=panels), target)


def _styled() -> Any:
    return styles.plt.rc_context(styles.STYLE)


def _as(style: str, drawn: Figure, panels: str | None = None) -> Figure:
    """A page, or its form for a journal."""
    if style not in ("page", "paper"):
        raise InputError(f"style = {style!r} (must be \"page\" or \"paper\")")
    if style == "page" and panels:
        raise InputError(f"panels = {panels!r} (are chosen with style = \"paper\")")
    return paper.fit(drawn, panels) if style == "paper" else drawn


def _result(source: Source) -> pathlib.Path:
    folder = source if isinstance(source, (str, os.PathLike)) else source.folder
    path = pathlib.Path(folder)
    path = path / "result.h5" if path.is_dir() else path
    if not path.exists():
        raise FileError(f"{path} is not there: a picture is drawn of a run that has measured something")
    return path


def _frame_page(source: Source, wanted: str, page: Any) -> Figure:
    path = _result(source)
    with open_hdf5(path) as file, _styled():
        if wanted not in file or not len(file[wanted]):
            key = {"profiles": "measure.profiles", "histograms": "measure.contacts"}.get(wanted, "measure.fields")
            raise InputError(f"{path} has no /{wanted}: set {key} = true in the scene and run it again")
        drawn: Figure = page(file)
        return drawn
