#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of docs/reproduction.md, what the papers state in numbers and ours, and its pictures.

Draws every figure from the tables in docs/data/figures (nothing is run), puts what it prints of stated
numbers between the marks of the page and the pictures into docs/figures; the text around them stays.
"""

import argparse
import collections
import csv
import pathlib
import shutil
import subprocess
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/reproduction.md"
PICTURES = ROOT / "docs/figures"
BEGIN, END = "<!-- table: scripts/reproduction_page.py -->\n", "<!-- end of the table -->\n"
NOT_FOUND = "not found"  # ours, where no data are there


def stated(figure, program, out):
    """Rows of stated.csv of a figure, drawn into the folder `out`; none where it has none."""
    subprocess.run([program, "figure", figure, "--data", ROOT / "docs/data/figures", "--out", out],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    shutil.copy(out / f"{figure}.png", PICTURES)
    file = out / figure / "stated.csv"
    if not file.exists():
        return []
    with open(file, newline="") as rows:
        return list(csv.DictReader(rows))


def table(program, out):
    lines = ["| figure | what | the paper | ours | deviation | stated in |", "| --- " * 6 + "|"]
    missing, counts = {}, collections.Counter()
    for figure in tomllib.loads((ROOT / "inputs/figures/figures.toml").read_text()):
        for row in stated(figure, program, out):
            if row["ours"] == NOT_FOUND:
                missing[figure] = missing.get(figure, 0) + 1
                continue
            counts[row["agrees"]] += 1
            cells = [figure, row["what"], row["stated"], row["ours"], row["deviation"], row["source"]]
            lines.append("| " + " | ".join(cell.replace("|", "\\|").replace("+-", "±") for cell in cells) + " |")
    lines += ["", f"Of {sum(counts.values())} numbers {counts['yes']} agree within two standard errors or the bounds, "
              f"{counts['no']} deviate by more, {counts['untold']} lie inside bounds that our errors exceed."]
    if missing:
        lines += ["", "Without data yet: " + ", ".join(f"{n} of {figure}" for figure, n in missing.items()) + "."]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/openmp/bagnold")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "results/reproduction",
                        help="what is drawn, whole; default: %(default)s")
    given = parser.parse_args()
    before, rest = PAGE.read_text().split(BEGIN)
    _, after = rest.split(END)
    PAGE.write_text(before + BEGIN + table(given.program, given.out) + END + after)


if __name__ == "__main__":
    main()
