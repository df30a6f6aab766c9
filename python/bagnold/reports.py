# SPDX-License-Identifier: BSD-3-Clause
"""A page of HTML to mail: the results of a run, a cascade or a sweep, its pictures, its scene, its provenance."""

from __future__ import annotations

import base64
import io
import os
import pathlib
import re
import shlex
from collections.abc import Callable, Iterable
from html import escape
from typing import Any

from . import html
from .errors import Error, InputError
from .files import regular, replaced
from .results import Run, load
from .sweeps import Sweep, sweep

MOST_BYTES = 3_000_000  # of a picture of vectors; larger ones are dots

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 72rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.5rem; margin-bottom: 0 } h2 { font-size: 1.15rem; margin-top: 2rem; border-bottom: 1px solid #ddd }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem }
th, td { padding: .15rem .7rem .15rem 0; text-align: left; vertical-align: top; white-space: nowrap }
td:last-child { white-space: normal } th { border-bottom: 1px solid #999 } tbody tr:hover { background: #f4f6fa }
.sorts th { cursor: pointer } .sorts th[aria-sort=ascending]::after { content: " \\25B2" }
.sorts th[aria-sort=descending]::after { content: " \\25BC" }
.wide { overflow-x: auto } .warning { border-left: 4px solid #D55E00; padding-left: .7rem }
.note { border-left: 4px solid #56B4E9; padding-left: .7rem } pre { background: #f6f6f6; padding: .7rem; overflow-x: auto }
figure { margin: 1rem 0 } svg, img { max-width: 100%; height: auto } .small { color: #666; font-size: .85rem }
@media print { body { max-width: none } figure { break-inside: avoid } }
"""

# A click on the head of a column sorts by it, a second one the other way round; what has no number comes last.
SORT = """
for (const head of document.querySelectorAll(".sorts th")) head.addEventListener("click", () => {
  const table = head.closest("table"), body = table.tBodies[0], column = head.cellIndex;
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of table.querySelectorAll("th")) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const key = row => { const cell = row.cells[column], value = cell.dataset.value;
    return value === undefined ? cell.textContent : value === "" ? null : Number(value); };
  const order = (a, b) => a === b ? 0 : a === null ? 1 : b === null ? -1 : (a < b ? -1 : 1) * (down ? -1 : 1);
  [...body.rows].sort((a, b) => order(key(a), key(b))).forEach(row => body.append(row));
});
"""


def report(source: Run | Sweep | str | os.PathLike[str], out: str | os.PathLike[str] | None = None) -> pathlib.Path:
    """Writes the page of a run, a cascade or a sweep, which needs nothing else, and returns its path.

    out: the file, by default report.html in the folder. Pictures need matplotlib."""
    folder = source.folder if isinstance(source, (Run, Sweep)) else pathlib.Path(source)
    found = _read(folder)
    target = pathlib.Path(out) if out is not None else folder / "report.html"
    text = _of_sweep(found) if isinstance(found, Sweep) else _of_run(found)
    with replaced(target, remedy="choose another --out") as part:
        part.write_text(text, encoding="utf-8")
    return target


def _read(folder: pathlib.Path) -> Run | Sweep:
    if (folder / "points.json").exists() and not (folder / "sweep.h5").exists():
        raise InputError(f"{folder} has no tables yet; `bagnold sweep {_quoted(folder / 'sweep.toml')} --out {_quoted(folder)} "
                         "--collect` writes those of the points that are done")
    if (folder / "sweep.h5").exists():
        return sweep(folder)
    from .commands import status

    run = load(folder)
    if not run.complete and status(folder).state == "running":
        raise InputError(f"{folder} holds a run that is at work; `bagnold plot {_quoted(folder)}` draws what there is, and a report can "
                         "be made at its end")
    if not run.complete:
        raise InputError(f"{folder} holds a run that is not complete; `bagnold resume {_quoted(folder)}` goes on with it, "
                         f"`bagnold plot {_quoted(folder)}` draws what there is, and a report can be made at its end")
    return sweep(folder) if "points" in run.summary else run


def _page(title: str, parts: Iterable[str]) -> str:
    body = "\n".join(part for part in parts if part)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{escape(title)}</title>\n'
            f"<style>{STYLE}</style>\n</head>\n<body>\n{body}\n<script>{SORT}</script>\n</body>\n</html>\n")


def _section(title: str, body: str) -> str:
    return f"<h2>{escape(title)}</h2>\n{body}" if body else ""


def _of_run(run: Run) -> str:
    from . import plots

    scene = run.scene
    title = str(scene.get("title", "")) or run.folder.resolve().name
    averages = f'<div class="wide">{html.observables(run)}</div>' if run.summary.get("observables") else ""
    pictures = _pictures([lambda: plots.run(run), lambda: plots.profiles(run), lambda: plots.fields(run),
                          lambda: plots.histograms(run)])
    steady = scene.get("shear.protocol", "steady") == "steady"
    longer = "" if not steady else (
        f"bagnold resume {_quoted(run.folder)} --strain {2 * float(scene['shear.strain']):g}   # twice as long, bit for bit")
    commands = "\n".join(line for line in (
        longer, f"bagnold run {_quoted(run.folder)}/scene.toml --set disks.seed={run.seeds[-1] + 1} --out ...   # another start",
        f"bagnold check-limit {_quoted(run.folder)}/scene.toml   # is the rate small enough?" if steady else "",
        f"python3 -c \"import bagnold; print(bagnold.load({str(run.folder)!r})['p'])\"" 
        if "p" in run.summary.get("observables", {}) else "")
        if line)
    return _page(title, [
        f'<h1>{escape(title)}</h1>\n<p class="small">{escape(_what(run))}</p>',
        _section("Warnings and notes", html.said(run.warnings, "warning") + html.said(run.notes, "note")),
        _section("Averages", averages and averages + _units()), _section("Pictures", pictures),
        _section("Scene", _pre(_text(run.folder / "scene.toml"))), _section("To go on", _pre(commands)),
        _section("Where it came from", _provenance(run))])


def _of_sweep(found: Sweep) -> str:
    from . import plots

    file = found.folder / ("sweep.toml" if (found.folder / "sweep.toml").exists() else "scene.toml")
    title = next((str(point.scene.get("title", "")) for point in found if point.scene.get("title", "")), "") or \
        found.folder.resolve().name
    done = sum(point.status == "done" for point in found)
    suspect: dict[str, int] = {}
    for point in found:
        for name in point.warnings:
            suspect[name] = suspect.get(name, 0) + 1
    names = "".join(f'<p class="warning"><b>{escape(name)}</b>: {count} points</p>' for name, count in suspect.items())
    first = next((point for point in found if point.status == "done"), None)
    again = f"bagnold sweep {_quoted(file)} --out {_quoted(found.folder)}   # what is open, new points, more strain"
    if file.name != "sweep.toml":
        again = f"bagnold resume {_quoted(found.folder)} --strain S   # what is open, a longer last rate"
    return _page(title, [
        f'<h1>{escape(title)}</h1>\n<p class="small">{done} of {len(found)} points of {escape(str(found.folder))}</p>',
        _section("Warnings and notes", names),
        _section("Points", f'<div class="wide">{html.of_sweep(found, " class=sorts")}</div>{_units()}'
                           '<p class="small">A click on the head of a column sorts by it.</p>'),
        _section("Pictures", _pictures([lambda: plots.sweep(found)])),
        _section(file.name, _pre(_text(file))), _section("To go on", _pre(again)),
        _section("Where it came from", _provenance(first.load()) if first else "")])


def _what(run: Run) -> str:
    scene = run.scene
    return (f"{scene['disks.model']}, {scene['disks.count']} disks, packing fraction {scene['disks.packing_fraction']:g}, "
            f"Q = {scene['disks.elasticity']:g}, masses {scene['disks.mass']}; {scene.get('shear.protocol', 'steady')}, strain "
            f"{float(run.summary['strain']['total']):g}; {run.folder}")


def _units() -> str:
    return ('<p class="small">Lengths in d_s, the diameter of the small disks, times in tau_e, masses in m. In brackets the standard '
            "error of the last digits.</p>")


def _pictures(makers: Iterable[Callable[[], Any]]) -> str:
    """Pictures that exist; what a run has not measured is left out."""
    drawn = []
    for make in makers:
        try:
            drawn.append(f"<figure>{_vectors(make())}</figure>")
        except InputError:
            continue
        except Error as error:
            return f'<p class="small">No pictures: {escape(str(error))}</p>'
    return "\n".join(drawn)


def _vectors(figure: Any) -> str:
    """A picture for a page: an SVG, or if that is large a PNG."""
    from .plots import style

    with style.plt.rc_context(style.STYLE):
        picture = io.StringIO()
        figure.savefig(picture, format="svg", metadata={"Date": None, "Creator": None})
        text = picture.getvalue()
        if len(text) <= MOST_BYTES:
            style.plt.close(figure)
            return re.sub(r"<metadata>.*?</metadata>", "", text[text.index("<svg"):], flags=re.S)
        dots = io.BytesIO()
        figure.savefig(dots, format="png", dpi=160)
        style.plt.close(figure)
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(dots.getvalue()).decode()}">'


def _provenance(run: Run) -> str:
    rows = [(name, f"{value:g}" if isinstance(value, float) else str(value)) for name, value in run.about.items()
            if name not in ("scene", "seeds") and not name.startswith("engine_")]
    return html.table(("", ""), rows)


def _text(path: pathlib.Path) -> str:
    try:
        return regular(path).read_text(encoding="utf-8")
    except OSError:
        return ""


def _pre(text: str) -> str:
    return f"<pre>{escape(text.strip())}</pre>" if text.strip() else ""


def _quoted(path: pathlib.Path) -> str:
    return shlex.quote(str(path))
