#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of docs that no other script draws: scripts/page_pictures.py [NAME...]

quickstart, start_up and oscillation are of scenes in inputs, flow-curve of the sweep in docs/tutorial.md: these are run.
The others of docs/analysis are of made data, those of tests/cli/analyse_test.py.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/cli"))
os.environ["BAGNOLD_SOURCE"] = str(ROOT)
import python_package  # noqa: E402 F401  the Python package as bagnold_package, beside the tests' bagnold.py
import bagnold_package  # noqa: E402

DPI = 220  # of a PNG: twice what a page shows
SCENES = {"quickstart": "quickstart", "start_up": "start_up", "oscillation": "oscillate"}  # picture: input
MADE = {  # of made data: the test's method that makes them, and what is asked of `bagnold analyse`
    "crossover": ("bagnold_states", []), "transition": ("two_transitions", []),
    "kink": ("bands", ["--kinks", "2", "--log-y"]), "constant-pressure": ("bands", ["--pressure", "2e-5"])}


def call(program, *words):
    subprocess.run([program, *words], check=True, stdout=subprocess.DEVNULL)


def scene(program, folder, name):
    from bagnold_package.plots import style
    call(program, "run", ROOT / f"inputs/{SCENES[name]}.toml", "--out", folder / "run", "--set", "output.plot=false")
    figure = bagnold_package.plots.run(bagnold_package.load(folder / "run"))
    style.save(figure, ROOT / f"docs/{name}.png", dpi=DPI * 5 / 6, colours=128)


def analysed(program, folder, kind, options, name):
    """An analysis of folder/sweep, as a picture of docs/analysis."""
    call(program, "analyse", kind, folder / "sweep", *options)
    figure = bagnold_package.plots.analysis(folder / f"sweep/{kind}.drawn.csv")
    bagnold_package.plots.save(figure, ROOT / f"docs/analysis/{name}.svg")


def flow_curve(program, folder):
    text = re.search(r"^```toml\n(# flow.toml\n.*?)^```", (ROOT / "docs/tutorial.md").read_text(), re.M | re.S)[1]
    (folder / "flow.toml").write_text(text)
    call(program, "sweep", folder / "flow.toml", "--out", folder / "sweep")
    analysed(program, folder, "exponents", ["--x", "shear.strain_rate", "--y", "p"], "flow-curve")


def made(program, folder, name):
    os.environ["BAGNOLD"] = str(program)
    from analyse_test import AnalyseTest
    method, options = MADE[name]
    test = AnalyseTest()
    test.folder = folder
    getattr(test, method)()
    analysed(program, folder, name, options, name)


def main():
    names = [*SCENES, "flow-curve", *MADE]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", choices=[*names, []], help=f"of {', '.join(names)}")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/openmp/bagnold")
    given = parser.parse_args()
    for name in given.names or names:
        with tempfile.TemporaryDirectory() as folder:
            arguments = given.program.resolve(), pathlib.Path(folder)
            if name in MADE:
                made(*arguments, name)
            elif name in SCENES:
                scene(*arguments, name)
            else:
                flow_curve(*arguments)


if __name__ == "__main__":
    main()
