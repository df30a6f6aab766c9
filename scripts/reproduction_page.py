#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of docs/reproduction.md and docs/data/reproduction/details.md, and the pictures in docs/figures.

Draws every figure from the tables in docs/data/figures (nothing is run) and puts the tables between their marks in the
two pages; the text around them stays. docs/data/reproduction.toml holds the verdict on each figure and the size, strain
and rate of the papers; ours come from inputs/figures and docs/data/figures. With --check nothing is drawn or written:
rows that come out otherwise are printed, and the exit status is 1. --keep-pictures writes the tables alone.
"""

import argparse
import collections
import concurrent.futures
import csv
import dataclasses
import difflib
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = [ROOT / "docs/reproduction.md", ROOT / "docs/data/reproduction/details.md"]
DATA = ROOT / "docs/data/figures"
SWEEPS = ROOT / "inputs/figures"
PICTURES = ROOT / "docs/figures"
BEGIN, END = "<!-- table: scripts/reproduction_page.py {} -->\n", "<!-- end of the table -->\n"
NOT_FOUND, NOT_TOLD, NOT_RUN = "not found", "not told", "not run"  # no data; they do not reach; no run at that rate
VERDICTS = ("reproduced", "in part", "not")
# Ranges that the papers state themselves; all other ranges are bounds of ours.
RANGES = {("P1-4", "0.001 to 0.005"), ("P1-4", "-0.001 to -0.0005"), ("P1-8", "0 to 0.093"), ("P1-11", "400 to 4000"),
          ("P1-11", "100 to 1000"), ("P1-16", "0.05 to 0.12"), ("P2-12", "0 to 1"), ("P2-15", "0.79 to 0.81"),
          ("P2-23", "0.1 to 0.2")}
# The limit of small rates is compared once rates near P2's, 2e-7, are run.
WITHOUT_RUNS = {("P2-25", "phi_c, by phi_B at 5e-6")}
LONG = 6  # rows of one statement that the page gives as a range
# Narrow boxes from which the runs of this data set start.
STARTS = {"bands_profiles_large": "8192"}
# P2 App. B: (phi, gammadot) of Fig. 28, and the places of the bands in them.
STATES = [("0.7984", "3e-05"), ("0.802", "2e-05"), ("0.792", "5e-05")]
P2_BANDS = {"phi": (0.7880, 0.8090), "gammadot": (6.2e-5, 4.2e-6)}
GREEK = {"phi": "φ", "sigma": "σ", "mu": "μ", "gammadot": "γ̇", "tau": "τ", "nu": "ν", "eta": "η", "beta": "β"}


@dataclasses.dataclass
class Number:
    """A number that a paper states, and ours: a row of stated.csv."""

    figure: str
    what: str
    stated: str
    ours: str
    deviation: str
    agrees: str
    source: str

    @property
    def kind(self):
        if "nu_coll/Z" in self.what:
            return "identity"
        if "+-" in self.stated and self.figure != "P1-17":  # its 2% has no error; half a digit is taken
            return "error"
        return "own" if " to " in self.stated and (self.figure, self.stated) not in RANGES else "plain"

    @property
    def family(self):
        """Numbers of one statement: the same quantity in several states."""
        return self.figure, self.stated, self.source, self.split()[0]

    def split(self):
        """(quantity, state)"""
        found = re.match(r"(.*?)(?:,| at) ((?:phi|Q) = .*)", self.what)
        return (found[1], found[2]) if found else (self.what, "")


def lettered(text):
    """Greek letters and words for names."""
    for name, word in (("delta_p", "δp"), ("spin_mean", "mean spin"), ("spin_var", "variance of the spin"),
                       ("Q0", "Q_0")):
        text = text.replace(name, word)
    text = re.sub(r"(?<![A-Za-z])(" + "|".join(GREEK) + r")(?![A-Za-z])", lambda one: GREEK[one[1]], text)
    return text.replace("|", "\\|")


def short(text):
    """2e-05 as 2e-5."""
    return re.sub(r"e([+-])0(\d)", r"e\1\2", text)


def power_of_ten(rate):
    """1e-3 for 0.001."""
    return short(f"{rate:.1e}".replace(".0e", "e"))


def with_error(text):
    """VALUE +- ERROR with as many digits as the error has."""
    if "+-" not in text:
        return short(text)
    value, error = map(float, text.split("+-"))
    larger = max(abs(value), error)
    if larger < 1e-3:
        power = math.floor(math.log10(larger))
        return f"({with_error(f'{value / 10.0**power} +- {error / 10.0**power}')})e{power}"
    digits = -math.floor(math.log10(error) + 1e-9)
    return " ± ".join(f"{round(one, digits) + 0.0:.{max(digits, 0)}f}" for one in (value, error))


def sigmas(text):
    """A number of standard errors; beyond a hundred it tells no more than that."""
    bracket, value = ("(", text[1:]) if text.startswith("(") else ("", text)
    return f"{bracket}>100σ" if abs(float(value)) > 100 else f"{bracket}{value}σ"


def deviation(number):
    """In per cent and in our errors, or in standard errors of both."""
    if number.deviation == "-":
        return ""
    text = re.sub(r"(\S+) (?:standard errors|of our errors)", lambda one: sigmas(one[1]), number.deviation)
    return re.sub(r"[+-]0%", "0%", text).replace("inside, our error is wider", "inside")


def agrees(number):
    if number.ours in (NOT_TOLD, NOT_RUN):
        return ""
    return {"yes": "yes", "no": "**no**", "untold": "our error is wider"}[number.agrees]


def grid(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| --- " * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def stated(figure, program, out, draws):
    """Numbers of stated.csv of a figure, drawn into the folder `out`; none where it has none."""
    undrawn = {} if draws else {"BAGNOLD_PYTHON": "/bin/true"}
    subprocess.run([program, "figure", figure, "--data", DATA, "--out", out],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, env=os.environ | undrawn)
    if draws:
        shutil.copy(out / f"{figure}.png", PICTURES)
    file = out / figure / "stated.csv"
    if not file.exists():
        return []
    with open(file, newline="") as rows:
        return [Number(figure, **row) for row in csv.DictReader(rows)]


def numbers(rows):
    """A table of stated numbers: a line a family."""
    families = collections.defaultdict(list)
    for row in rows:
        families[row.family].append(row)
    lines = []
    for (figure, _, source, quantity), members in families.items():
        if len(members) > LONG:
            values = [float(one.ours.split(" +-")[0]) for one in members]
            yes = sum(one.agrees == "yes" for one in members)
            what = f"{quantity}, {len(members)} states"
            cells = [f"{min(values):.3g} to {max(values):.3g}", "", f"{yes} of {len(members)}"]
        else:
            what = listed(members)
            parts = [[with_error(one.ours), deviation(one), agrees(one)] for one in members]
            cells = ["; ".join(filter(None, column)) for column in zip(*parts)]
        paper = members[0].stated.replace("+- 0.005", "").replace("+-", "±")
        paper = "about " + paper.strip() if figure == "P1-17" else paper
        place = re.sub(r"P\d |Sec. ", "", source.split(",")[0])
        lines.append([figure, short(lettered(what)), short(paper), *cells, place])
    return grid(["figure", "what", "the paper", "ours", "deviation", "agrees", "stated in"], lines)


def listed(members):
    """Quantities with their states."""
    states = collections.defaultdict(list)
    for one in members:
        quantity, state = one.split()
        states[quantity].append(state)
    return "; ".join(quantity + " at " * any(found) + "; ".join(found) for quantity, found in states.items())


def bounds(rows):
    """A table of statements without a number, and the bounds that are put on them here."""
    families = collections.defaultdict(list)
    for row in rows:
        families[row.figure, row.stated, row.source].append(row)
    lines = []
    for (figure, between, source), members in families.items():
        says = source.partition(", ")[2] or source
        quantities = [one.split()[0] for one in members]
        members.sort(key=lambda one: quantities.index(one.split()[0]))
        lines.append([figure, lettered(says), short(lettered(listed(members))), between,
                      "; ".join(with_error(one.ours) for one in members),
                      "; ".join(dict.fromkeys(map(agrees, members)))])
    return grid(["figure", "the paper says", "number", "our bounds", "ours", "inside"], lines)


def identity(rows):
    figures = collections.defaultdict(list)
    for row in rows:
        figures[row.figure].append(row)
    return grid(["figure", "states", "τ_dur ν_coll/Z"],
                [[figure, short(lettered("; ".join(one.split()[1] for one in members))),
                  "; ".join(with_error(one.ours) for one in members)] for figure, members in figures.items()])


def tally(rows):
    counts = collections.Counter(NOT_TOLD if one.ours == NOT_TOLD else NOT_RUN if one.ours == NOT_RUN else one.agrees
                                 for one in rows)
    words = {"yes": "agree", "no": "deviate", "untold": "lie inside bounds that our errors exceed",
             NOT_TOLD: "our data do not tell", NOT_RUN: "needs rates that are not run"}
    return f"Of {len(rows)} numbers " + ", ".join(f"{counts[key]} {text}" for key, text in words.items() if counts[key])


def table_of(name):
    """Rows of docs/data/figures/NAME.csv, without the starts of its runs."""
    path = DATA / f"{name}.csv"
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return [row for row in csv.DictReader(file) if row.get("disks.count") != STARTS.get(name)]


def strains(name):
    """{rate: strain} of a sweep."""
    scene = tomllib.loads((SWEEPS / f"{name}.toml").read_text())
    keys = {"shear." + key: value for key, value in scene.get("shear", {}).items()}
    keys |= scene["sweep"].get("zip", {})
    rates, found = keys.get("shear.strain_rates", keys.get("shear.strain_rate")), keys.get("shear.strain")
    if not isinstance(rates, list) or not found:
        return {}
    if isinstance(rates[0], list):
        rates, found = sum(rates, []), sum(found, [])
    elif isinstance(found[0], list):  # one for each packing fraction, alike at the lowest rate
        found = found[-1]
    return {float(rate): f"{strain:g}" for rate, strain in zip(rates, found)}


def data_of(figure):
    """Data sets that a figure draws."""
    listed = [entry.get("data", []) for entry in [figure, *figure["panel"]]]
    return list(dict.fromkeys(sum(([one] if isinstance(one, str) else one for one in listed), [])))


def reach(figure):
    """(N, strain at the lowest rate, lowest rate) of what a figure draws."""
    rows = [(float(row["shear.strain_rate"]), name, row["disks.count"])
            for name in data_of(figure) for row in table_of(name)]
    rate, name, _ = min(rows)
    counts = sorted({int(row[2]) for row in rows})
    return ", ".join(map(str, counts)), strains(name)[rate], power_of_ten(rate)


def figures_table(figures, verdicts):
    lines = []
    for name, figure in figures.items():
        verdict = verdicts[name]
        if verdict["result"] not in VERDICTS:
            sys.exit(f"{name}: {verdict['result']} is none of {', '.join(VERDICTS)}")
        ours = verdict.get("ours") or reach(figure)
        both = [paper if paper == one else f"{paper} / {one}" for paper, one in zip(verdict["paper"], ours)]
        anchor = re.sub(r"[^\w -]", "", f"{name}: {figure['title']}".lower()).replace(" ", "-")
        lines.append([f"[{name}](data/reproduction/details.md#{anchor})",
                      verdict["result"].replace("not", "**not**"), *both, verdict["why"]])
    counts = collections.Counter(verdicts[name]["result"] for name in figures)
    return (grid(["figure", "result", "N", "strain", "lowest rate", "reason"], lines) + "\n" +
            f"Of {len(figures)} figures {counts['reproduced']} are reproduced, {counts['in part']} in part, "
            f"{counts['not']} not.\n")


def fraction(state, bands, errors=(0, 0)):
    """f of state = f fast + (1 - f) slow, and its error; nan where an error is."""
    fast, slow = bands
    value = (state - slow) / (fast - slow)
    return value, math.hypot(value * errors[0], (1 - value) * errors[1]) / abs(fast - slow)


def fractions():
    """P2 App. B: the share of the Bagnoldian band by phi, f, and by gammadot, f'."""
    lines = []
    for phi, rate in STATES:
        (row,) = [row for row in table_of("bands_profiles_large")
                  if (row["disks.packing_fraction"], row["shear.strain_rate"]) == (phi, rate)]
        for letter, name, state in (("f", "phi", phi), ("f′", "gammadot", rate)):
            columns = [f"band_{name}_{side}" for side in ("fast", "slow")]
            theirs, _ = fraction(float(state), P2_BANDS[name])
            ours, error = fraction(float(state), [float(row[key]) for key in columns],
                                   [float(row[key + "_error"] or "nan") for key in columns])
            lines.append([f"({phi}, {short(rate)})", letter, f"{theirs:.3f}",
                          f"{ours:.3f}" if math.isnan(error) else f"{ours:.3f} ± {error:.3f}"])
    return grid(["(φ, γ̇)", "fraction", "from P2's bands", "from ours"], lines)


def data_table(figures):
    """What is run: a line a data set."""
    uses = collections.defaultdict(list)
    for name, figure in figures.items():
        for data in data_of(figure):
            uses[data].append(name)
    lines = []
    for data, names in uses.items():
        rows = table_of(data)
        if not rows:
            continue
        sweep = tomllib.loads((SWEEPS / f"{data}.toml").read_text())
        rates = sorted({float(row["shear.strain_rate"]) for row in rows})
        highest = sweep.get("shear", {}).get("strain_rate_high", rates[-1])
        keys = [key for key in ("disks.packing_fraction", "disks.elasticity", "shear.ramp_rate") if key in rows[0]]
        seeds = collections.defaultdict(set)
        for row in rows:
            if float(row["shear.strain_rate"]) == rates[0]:
                seeds[tuple(row[key] for key in keys)].add(row.get("disks.seed"))
        several = sorted({len(one) for one in seeds.values()})
        lines.append([f"`{data}`", " ".join(names), sweep["disks"]["model"],
                      ", ".join(sorted({row["disks.count"] for row in rows})),
                      f"{power_of_ten(highest)} to {power_of_ten(rates[0])}", strains(data).get(rates[0], ""),
                      str(len(seeds)),
                      f"{several[0]} to {several[-1]}" if several[1:] else str(several[0])])
    return grid(["data", "figures", "law", "N", "rates", "strain at the lowest", "states there", "seeds"], lines)


def tables(program, out, draws):
    """{name: text} of all tables."""
    figures = tomllib.loads((SWEEPS / "figures.toml").read_text())
    verdicts = tomllib.loads((DATA.parent / "reproduction.toml").read_text())
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as at_once:
        found = sum(at_once.map(lambda figure: stated(figure, program, out, draws), figures), [])
    missing = collections.Counter(one.figure for one in found if one.ours == NOT_FOUND)
    found = [dataclasses.replace(one, ours=NOT_RUN, deviation="") if (one.figure, one.what) in WITHOUT_RUNS else one
             for one in found if one.ours != NOT_FOUND]
    kinds = collections.defaultdict(list)
    for one in found:
        kinds[one.kind].append(one)
    families = collections.Counter(one.family for one in kinds["plain"])
    rest = [one for one in kinds["plain"] if families[one.family] > LONG]
    without = "".join(f"\nWithout data yet: {', '.join(f'{n} of {name}' for name, n in missing.items())}.\n"
                      for _ in range(bool(missing)))
    return {
        "figures": figures_table(figures, verdicts),
        "errors": numbers(kinds["error"]) + f"\n{tally(kinds['error'])}.\n",
        "plain": numbers(kinds["plain"]) + f"\n{tally(kinds['plain'])}.\n" + without,
        "fractions": fractions(),
        "data": data_table(figures),
        "states": grid(["figure", "number", "ours", "agrees"],
                       [[one.figure, lettered(short(one.what)), with_error(one.ours), agrees(one)] for one in rest]),
        "bounds": bounds(kinds["own"]) + f"\n{tally(kinds['own'])}.\n",
        "identity": identity(kinds["identity"]),
    }


def filled(text, made):
    """A page with its tables anew."""
    for name in re.findall(BEGIN.format(r"(\w+)"), text):
        before, rest = text.split(BEGIN.format(name))
        text = before + BEGIN.format(name) + made[name] + END + rest.split(END, maxsplit=1)[1]
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/openmp/bagnold")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/reproduction",
                        help="what is drawn, whole; default: %(default)s")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--keep-pictures", action="store_true")
    given = parser.parse_args()
    made = tables(given.program, given.out, draws=not (given.check or given.keep_pictures))
    differs = False
    for page in PAGES:
        old = page.read_text()
        new = filled(old, made)
        differs |= old != new
        if not given.check:
            page.write_text(new)
            continue
        for line in difflib.unified_diff(old.splitlines(), new.splitlines(), "kept", "found", n=0, lineterm=""):
            print(line)
    return int(given.check and differs)


if __name__ == "__main__":
    sys.exit(main())
