# SPDX-License-Identifier: BSD-3-Clause
"""bagnold figure: every figure of the papers is there, and the quick ones come out as pictures."""

import csv
import json
import re
import struct
import subprocess
import tomllib
import unittest
from unittest import mock

import numpy as np

import python_package  # noqa: F401  bagnold_package
from bagnold import SOURCE, CliTest, environment

from bagnold_package.plots import figure_page

FIGURES = SOURCE / "inputs/figures/figures.toml"
WANTED = ([f"P1-{n}" for n in range(1, 18) if n != 9] +
          [f"P2-{n}" for n in range(1, 37) if n != 7])
QUICK = "P1-1 P1-6 P1-10 P1-11 P1-15 P2-1 P2-4 P2-8 P2-12 P2-20 P2-21 P2-31".split()

SWEEP = """title = "tiny"
[disks]
model = "CD_n"
count = 32
packing_fraction = 0.6
mass = "area"
[shear]
strain_rate = 1e-2
strain = 4.0
[output]
plot = false
[sweep]
grid = { "disks.elasticity" = [1, 10], "disks.seed" = [1, 2] }
"""
ONE = """[P9-1]
title = "a title"
claims = "a claim"
data = "tiny"
values = { y = "B_p" }
panel = [{ analyse = "table --x disks.elasticity --y {y}", y_label = "$B_{p}$" }]
stated = [{ what = "B_p", source = "nowhere", analyse = "table", row = { "disks.elasticity" = 10 }, column = "B_p", stated = 1e9 }]
"""


def size_of(picture):
    """Width and height of a PNG."""
    head = picture.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", head[16:])


class FigureTest(CliTest):
    def figure(self, *arguments, code=0, **options):
        result = self.bagnold("figure", *arguments, **options)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def own(self, text, sweep=SWEEP):
        (self.folder / "tiny.toml").write_text(sweep)
        path = self.folder / "own.toml"
        path.write_text(text)
        return path

    def test_all_figures_of_the_papers_are_there(self):
        """And whatever one of them says of analyses, data and values is understood."""
        lines = self.figure("--figures", FIGURES).stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], WANTED)
        self.assertEqual([line.split()[0] for line in lines if "--quick" in line], QUICK)
        with open(FIGURES, "rb") as file:
            figures = tomllib.load(file)
        for name, figure in figures.items():
            self.assertGreater(figure["hours"], 0, name)
            self.assertGreater(len(figure["claims"]), 10, name)

    def test_the_documentation_shows_them(self):
        """docs/figures.md how they are made, docs/reproduction.md what agrees, its appendix each with its picture."""
        how = (SOURCE / "docs/figures.md").read_text()
        results = (SOURCE / "docs/reproduction.md").read_text()
        page = (SOURCE / "docs/data/reproduction/details.md").read_text()
        for name in WANTED:
            with self.subTest(figure=name):
                self.assertIn(f"\n| {name} | ", how)
                self.assertRegex(results, rf"\n\| \[{name}\]\(data/reproduction/details\.md#[^)]+\) \| ")
                self.assertRegex(page, rf"\n### {name}: .*\n!\[{name}\]\(\.\./\.\./figures/{name}\.png\)\n\n"
                                       r"The paper: .*\n\nOurs: .*\n")
                picture = SOURCE / f"docs/figures/{name}.png"
                size_of(picture)
                self.assertLess(picture.stat().st_size, 300e3)  # at twice the size

    def test_every_data_set_is_used_and_says_what_it_costs(self):
        text = FIGURES.read_text()
        for path in FIGURES.parent.glob("*.toml"):
            if path != FIGURES:
                self.assertIn(f'"{path.stem}"', text)
                comment = path.read_text().splitlines()[0]
                self.assertRegex(comment, "^# (P[12] Figs?[.]|The rate|For the quick)")

    def test_quick_figures_come_out(self):
        """With data sets made tiny: the way from figures.toml to the picture, not its content."""
        folder = self.folder / "figures"
        folder.mkdir()
        for path in FIGURES.parent.glob("*.toml"):
            text = path.read_text()
            if path.stem.endswith("_quick"):
                text = text.replace("count = 256", "count = 32")
                text = re.sub(r"\nstrain = .*", "\nstrain = 0.1", text)
                text = re.sub(r"strain_rates = .*", "strain_rates = [1e-3, 1e-4]", text)
                text = text.replace("ramp_rate = 1e-4", "ramp_rate = 1e-3")
                text = text.replace('"disks.seed" = [1, 2]', '"disks.seed" = [1]').replace("replicas = 4\n", "")
                text = text.replace("[0.60, 0.70, 0.78, 0.82]", "[0.60, 0.78, 0.82]")
                text = text.replace("[0.70, 0.76, 0.79, 0.81, 0.83]", "[0.70, 0.81]")
                text = text.replace("[output]", "[output]\nsample_strain = 5e-3"
                                    if "ramp" not in path.stem else "[output]")
            (folder / path.name).write_text(text)
        figures = FIGURES.read_text().replace("values = { rate = 1e-5,", "values = { rate = 1e-4,")
        figures = figures.replace("fast = 1e-4", "fast = 1e-3")
        (folder / "figures.toml").write_text(figures)
        out = self.folder / "out"
        for name in QUICK:
            with self.subTest(figure=name):
                self.figure(name, "--quick", "--figures", folder / "figures.toml", "--out", out)
                width, height = size_of(out / f"{name}-quick.png")
                self.assertGreater(min(width, height), 200)

    def test_remarks_stand_under_the_picture(self):
        """What ours shows beside the paper's claims; P1-2's left panel has nothing to show but errors."""
        own = self.own(ONE.replace('claims = "a claim"', 'claims = "a claim"\nremark = "a remark"'))
        result = self.figure("P9-1", "--figures", own, "--out", "out")
        self.assertIn("The paper: a claim\nOurs: a remark\n", result.stdout)
        folder = self.folder / "out/P9-1"
        drawn = figure_page.draw(json.loads((folder / "recipe.json").read_text()), str(folder))
        self.assertIn("a remark", [text.get_text() for text in drawn.texts])
        figures = tomllib.loads(FIGURES.read_text())
        self.assertIn("p_dis of whole contacts is 0", figures["P1-2"]["remark"])
        self.assertIn("time step", figures["P1-2"]["remark"])
        self.assertIn("the range of Q decides", figures["P1-5"]["remark"])

    def test_runs_once_and_compares(self):
        own = self.own(ONE)
        result = self.figure("P9-1", "--figures", own, "--out", "out")
        self.assertIn("a claim", result.stdout)
        self.assertRegex(result.stdout, r"B_p +1e\+09 .* standard errors +nowhere")
        with open(self.folder / "out/P9-1/stated.csv", newline="") as file:
            row = next(csv.DictReader(file))
        self.assertEqual((row["what"], row["stated"]), ("B_p", "1e+09"))
        size_of(self.folder / "out/P9-1.png")
        for form, begin in (("pdf", b"%PDF"), ("svg", b"<?xml")):
            result = self.figure("P9-1", "--figures", own, "--out", "out", "--format", form)
            self.assertIn(f"picture in out/P9-1.{form}\n", result.stdout)
            self.assertEqual((self.folder / f"out/P9-1.{form}").read_bytes()[:len(begin)], begin)
        stamps = {p: p.stat().st_mtime_ns for p in (self.folder / "out/data").rglob("state.h5")}
        self.assertEqual(len(stamps), 4)
        self.figure("P9-1", "--figures", own, "--out", "out")
        for path, stamp in stamps.items():
            self.assertEqual(path.stat().st_mtime_ns, stamp)

    def test_tables_draw_the_same_without_the_sweep(self):
        """Also from a sweep of which half is done."""
        text = ONE.replace("panel = [", """panel = [
  { histogram = "theta", where = { "disks.elasticity" = 10 } }, { profile = "phi_aligned" },""")
        sweep = SWEEP.replace("[output]", "[measure]\ncontacts = true\nprofiles = true\n[output]")
        own = self.own(text, sweep.replace("count = 32", "count = 64"))
        self.figure("P9-1", "--figures", own, "--out", "run")

        def redrawn(out, tables="tables"):
            subprocess.run(["/usr/bin/python3", SOURCE / "scripts/figure_tables.py", self.folder / "run/data",
                            self.folder / tables, "--figures", own], check=True, capture_output=True)
            self.figure("P9-1", "--figures", own, "--data", tables, "--out", out)
            size_of(self.folder / out / "P9-1.png")
            with open(self.folder / out / "P9-1/panel3.drawn.csv", newline="") as file:
                return list(csv.DictReader(file))

        with open(self.folder / "run/P9-1/panel3.drawn.csv", newline="") as file:
            before = list(csv.DictReader(file))
        after = redrawn("again")
        self.assertEqual(len(after), 2)
        for one, other in zip(before, after):
            for name, digits in (("x", 1e-12), ("y", 1e-5), ("y_error", 1e-2)):
                self.assertLess(abs(float(one[name]) - float(other[name])), digits * abs(float(one[name])))
        self.assertFalse((self.folder / "again/data").exists())
        recipe = json.loads((self.folder / "again/P9-1/recipe.json").read_text())
        self.assertEqual(recipe["panel"][0]["folder"], ["../../tables/tiny.json"])
        for folder in (self.folder / "run/data/tiny/points").glob("*=10_*"):
            (folder / "summary.json").unlink()
        self.assertEqual(len(redrawn("half", "half_tables")), 1)
        # What a table has of points that are gone it keeps.
        whole = [sorted((self.folder / "tables" / name).read_text().splitlines()) for name in ("tiny.csv", "tiny.json")]
        self.assertEqual(len(redrawn("kept")), 2)
        for name, lines in zip(("tiny.csv", "tiny.json"), whole):
            kept = (self.folder / "tables" / name).read_text().splitlines()
            self.assertEqual(sorted(line.rstrip(",") for line in kept), [line.rstrip(",") for line in lines])

    def test_tables_that_are_not_there_are_said(self):
        own = self.own(ONE.replace("panel = [", 'panel = [{ analyse = "table", data = "other" }, '))
        (self.folder / "other.toml").write_text(SWEEP)
        (self.folder / "tables").mkdir()
        result = self.bagnold("figure", "P9-1", "--figures", own, "--data", "tables", "--out", "out")
        self.assert_clean_error(result, 2, "tiny.csv", "other.csv", "--data")
        (self.folder / "tables/tiny.csv").write_text("disks.elasticity,B_p,B_p_error\n1,2,0.1\n10,3,0.1\n")
        result = self.figure("P9-1", "--figures", own, "--data", "tables", "--out", "out")
        self.assertIn("other.csv not in tables", result.stderr)

    def test_notes_of_fits_are_said_once(self):
        """Of a panel and of what is stated: a datum without an error weighs by that of the others."""
        fit = "exponents --x disks.elasticity --y B_p"
        own = self.own(ONE.replace("table --x disks.elasticity --y {y}", fit).replace('"table"', f'"{fit}"'))
        (self.folder / "tables").mkdir()
        table = self.folder / "tables/tiny.csv"
        for error, count in (("0.1", 0), ("", 1)):
            table.write_text(f"disks.elasticity,B_p,B_p_error\n1,2,0.1\n3,3,0.1\n10,4,{error}\n")
            result = self.figure("P9-1", "--figures", own, "--data", "tables", "--out", "out",
                                 env=environment() | {"BAGNOLD_PYTHON": "/bin/true"})
            self.assertEqual(result.stderr.count("1 of 3 data have a run without an error"), count, result.stderr)

    def test_several_sweeps_are_one_table(self):
        own = self.own(ONE.replace('data = "tiny"', 'data = ["tiny", "finer"]'))
        finer = SWEEP.replace("[1, 10]", "[3]").replace('"disks.seed" = [1, 2]', '"disks.seed" = [3]')
        (self.folder / "finer.toml").write_text(finer)
        self.figure("P9-1", "--figures", own, "--out", "out")
        with open(self.folder / "out/P9-1/panel1.drawn.csv", newline="") as file:
            self.assertEqual([float(row["x"]) for row in csv.DictReader(file)], [1, 3, 10])

    def test_kinds_of_panels_that_no_quick_figure_has(self):
        text = """[P9-2]
title = "of frames and contacts"
claims = "a claim"
data = "tiny"
panel = [
  { profile = "v_x_aligned", where = { "disks.elasticity" = 1 } },
  { profile = "phi_aligned", level = "disks.packing_fraction", curve = ["disks.elasticity"] },
  { field = "phi", where = { "disks.elasticity" = 10 } },
  { histogram = "theta", at = 90, x = "disks.elasticity" },
]
"""
        sweep = SWEEP.replace("[output]", "[measure]\ncontacts = true\nprofiles = true\nfields = true\n[output]")
        own = self.own(text, sweep.replace("count = 32", "count = 64"))
        self.figure("P9-2", "--figures", own, "--out", "out")
        size_of(self.folder / "out/P9-2.png")

    def test_boundaries_are_taken_over_to_other_quantities(self):
        """phi_B = 0.78 and 0.80 at two rates; p = gammadot e^(10 phi) there is read off curves of p."""
        head = "panel,x_name,y_name,x_scale,y_scale,curve,what,x,x_error,y,y_error\n"
        rates = (1e-5, 1e-4)
        places = "".join(f"1,phi,shear.strain_rate,linear,log,phi_up,data,{x},0.001,{rate},\n"
                         for x, rate in zip((0.80, 0.78), rates))
        curves = "".join(f"1,disks.packing_fraction,p,linear,log,gammadot = {rate:g},data,{x},,"
                         f"{rate * np.exp(10 * x)},\n" for rate in rates for x in (0.7, 0.75, 0.85))
        (self.folder / "jump.csv").write_text(head + places)
        (self.folder / "p.csv").write_text(head + curves)
        recipe = {"name": "P9-3", "panel": [{"analyse": "jump", "drawn": "jump.csv", "at": ["p", "gammadot"],
                                             "of": {"p": ""}, "of_drawn": {"p": "p.csv"}}]}
        (self.folder / "recipe.json").write_text(json.dumps(recipe))
        found = []
        with mock.patch.object(figure_page, "mark_boundary",
                               lambda axes, name, points, k, panel: found.append((name, points))):
            figure_page.draw(json.loads((self.folder / "recipe.json").read_text()), str(self.folder))
        (name, points), = found
        np.testing.assert_allclose(points[:, 1], rates)
        np.testing.assert_allclose(points[:, 0], np.multiply(rates, np.exp([8.0, 7.8])), rtol=1e-9)

    def test_mistakes_are_told_before_anything_runs(self):
        for old, new, *words in (
                ('"tiny"', '"huge"', "huge.toml"),
                ("table --x", "tabel --x", "tabel", "table"),
                ("--y {y}", "--why {y}", "--why"),
                ('title = "a title"', "", "title"),
                ('claims = "a claim"', 'claims = "a claim', "own.toml:3"),
                ("panel = [{", "panel = [] #", "no panel")):
            with self.subTest(new=new):
                own = self.own(ONE.replace(old, new))
                for arguments in ((), ("P9-1",)):
                    result = self.bagnold("figure", *arguments, "--figures", own, "--out", "bad")
                    self.assert_clean_error(result, 2, *words)
                self.assertFalse((self.folder / "bad").exists())
        own = self.own(ONE)
        self.assert_clean_error(self.bagnold("figure", "P9-2", "--figures", own), 2, "P9-1")
        self.assert_clean_error(self.bagnold("figure", "P9-1", "--quick", "--figures", own), 2, "quick")


if __name__ == "__main__":
    unittest.main()
