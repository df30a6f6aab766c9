# SPDX-License-Identifier: BSD-3-Clause
"""Results as HTML: the display of runs and sweeps in notebooks, and tables of reports."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from .errors import Error
from .observables import Observable, Warning, rounded

if TYPE_CHECKING:
    from .results import Run
    from .sweeps import Sweep

# What most people look at, as in the table of the program; B is constant in Bagnold's rheology, eta in Newton's.
SHORT = ("p", "sigma", "mu", "Z", "T_g", "B_p", "B_sigma", "eta_p", "eta_sigma", "tau_dur", "nu_coll",
         "band_fraction_phi", "band_fraction_gammadot")


def table(columns: Sequence[str], rows: Iterable[Sequence[Any]], attributes: str = "") -> str:
    """A table; a cell is a text, or a pair of its display and its sort key."""
    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    body = "".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in rows)
    return f"<table{attributes}><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _cell(cell: Any) -> str:
    if isinstance(cell, tuple):
        shown, value = cell
        return f'<td data-value="{"" if math.isnan(value) else repr(float(value))}">{escape(str(shown))}</td>'
    return f"<td>{escape(str(cell))}</td>"


def value_of(observable: Observable) -> str:
    """A mean with its error, marked if it is rough."""
    return rounded(observable.mean, observable.error) + (" (rough)" if observable.rough else "")


def observables(run: Run, names: Iterable[str] | None = None) -> str:
    """Averages with errors, units and meanings; names: only these."""
    found, series = run.observables, run.series
    rows = [(name, value_of(one), "" if one.unit == "1" else one.unit,
             series.description(name) if name in series else "")
            for name, one in found.items() if names is None or name in names]
    return table(("", "mean (error)", "unit", ""), rows)


def said(found: Iterable[Warning], what: str) -> str:
    """Warnings or notes, a paragraph each."""
    return "".join(f'<p class="{what}"><b>{what} {escape(one.name)}</b>: {escape(one.reason)}; {escape(one.remedy)}</p>'
                   for one in found)


def of_run(run: Run) -> str:
    """A run in a notebook."""
    head = f"<p><b>{escape(str(run.scene.get('title', '')) or 'run')}</b> <code>{escape(str(run.folder))}</code></p>"
    if not run.complete:
        return head + "<p>not complete; <code>bagnold.resume</code> goes on with it</p>"
    try:
        body = observables(run, SHORT) if run.summary.get("observables") else ""
    except Error as error:
        body = f"<p>{escape(str(error))}</p>"
    if len(run.points) > 1:
        from .sweeps import sweep

        body = of_sweep(sweep(run.folder))
    return head + body + said(run.warnings, "warning") + said(run.notes, "note")


def columns_of(sweep: Sweep) -> list[str]:
    """Observables in a table of a sweep."""
    return [name for name in SHORT if name in sweep.names and any(math.isfinite(one) for one in sweep[name])]


def of_sweep(sweep: Sweep, attributes: str = "") -> str:
    """A sweep in a notebook: a row a point."""
    names = columns_of(sweep)
    rows = []
    for k, point in enumerate(sweep):
        varied = [_number(values[k]) for values in sweep.varied.values()]
        means = [(rounded(float(sweep[name][k]), float(sweep.error(name)[k])) if math.isfinite(sweep[name][k]) else "",
                  float(sweep[name][k])) for name in names]
        rows.append([(k + 1, float(k + 1)), *varied, *means, " ".join((*point.warnings,)) if point.status == "done" else point.status])
    return table(["", *(key.partition(".")[2] or key for key in sweep.varied), *names, "warnings"], rows, attributes)


def _number(value: Any) -> Any:
    return (f"{value:.6g}", float(value)) if isinstance(value, float) else str(value)
