#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of docs/reproduction.md, what the papers state in numbers and ours, and its pictures.

Draws every figure from the tables in docs/data/figures (nothing is run), puts what it prints of stated
numbers between the marks of the page and the pictures into docs/figures; the text around them stays. With --check
nothing is drawn or written: rows that come out otherwise are printed, and the exit status is 1.
"""

import argparse
import collections
import concurrent.futures
import csv
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/reproduction.md"
PICTURES = ROOT / "docs/figures"
BEGIN, END = "<!-- table: scripts/reproduction_page.py -->\n", "<!-- end of the table -->\n"
NOT_FOUND = "not found"  # ours, where no data are there
NOT_TOLD = "not told"  # where they do not reach


def stated(figure, program, out, draws):
    """Rows of stated.csv of a figure, drawn into the folder `out`; none where it has none."""
    undrawn = {} if draws else {"BAGNOLD_PYTHON": "/bin/true"}
    subprocess.run([program, "figure", figure, "--data", ROOT / "docs/data/figures", "--out", out],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, env=os.environ | undrawn)
    if draws:
        shutil.copy(out / f"{figure}.png", PICTURES)
    file = out / figure / "stated.csv"
    if not file.exists():
        return []
    with open(file, newline="") as rows:
        return list(csv.DictReader(rows))


def table(program, out, draws=True):
    lines = ["| figure | what | the paper | ours | deviation | stated in |", "| --- " * 6 + "|"]
    missing, counts = {}, collections.Counter()
    figures = list(tomllib.loads((ROOT / "inputs/figures/figures.toml").read_text()))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as at_once:
        found = list(at_once.map(lambda figure: stated(figure, program, out, draws), figures))
    for figure, of_figure in zip(figures, found):
        for row in of_figure:
            if row["ours"] == NOT_FOUND:
                missing[figure] = missing.get(figure, 0) + 1
                continue
            counts[NOT_TOLD if row["ours"] == NOT_TOLD else row["agrees"]] += 1
            cells = [figure, row["what"], row["stated"], row["ours"], row["deviation"], row["source"]]
            lines.append("| " + " | ".join(cell.replace("|", "\\|").replace("+-", "±") for cell in cells) + " |")
    lines += ["", f"Of {sum(counts.values())} numbers {counts['yes']} agree within two standard errors or the bounds, "
              f"{counts['no']} deviate by more, {counts['untold']} lie inside bounds that our errors exceed, "
              f"{counts[NOT_TOLD]} our data do not tell."]
    if missing:
        lines += ["", "Without data yet: " + ", ".join(f"{n} of {figure}" for figure, n in missing.items()) + "."]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/openmp/bagnold")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/reproduction",
                        help="what is drawn, whole; default: %(default)s")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args()
    before, rest = PAGE.read_text().split(BEGIN)
    old, after = rest.split(END)
    new = table(given.program, given.out, draws=not given.check)
    if not given.check:
        PAGE.write_text(before + BEGIN + new + END + after)
        return 0
    for line in difflib.unified_diff(old.splitlines(), new.splitlines(), "kept", "found", n=0, lineterm=""):
        print(line)
    return int(old != new)


if __name__ == "__main__":
    sys.exit(main())
