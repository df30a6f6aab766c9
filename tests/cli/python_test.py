# SPDX-License-Identifier: BSD-3-Clause
"""Pictures: no code of the folder where the user stands, drawn where a kill left them out, any form."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy as np

from bagnold import SOURCE, CliTest, environment

HOSTILE = "import os\nopen({mark!r}, 'a').write(__file__ if '__file__' in globals() else 'run')\n"
MODULES = "h5py matplotlib numpy PIL bagnold types io json usercustomize sitecustomize".split()


class PictureTest(CliTest):
    def picture(self, name, *arguments, **options):
        out = self.folder / "results" / name
        self.said = self.run_scene(self.scene(output__plot=True), out, "--quiet", *arguments, **options).stderr
        return out / "plot.png"


class HostileFolders(PictureTest):
    """h5py.py, bagnold.py and python3 lie where the user stands; none of them is run."""

    def setUp(self):
        super().setUp()
        self.mark = self.folder / "mark"
        self.here = self.folder / "here"
        self.here.mkdir()
        for name in MODULES:
            (self.here / f"{name}.py").write_text(HOSTILE.format(mark=str(self.mark)))
        for name in ("python3", "python"):
            program = self.here / name
            program.write_text(f"#!/bin/sh\necho run >>{self.mark}\nexit 0\n")
            program.chmod(0o755)
        (self.here / "matplotlibrc").write_text("this is : no setting\nfigure.dpi : broken\n")

    def draw(self, name, **variables):
        picture = self.picture(name, env=environment(**variables), cwd=self.here)
        self.assertFalse(self.mark.exists(), self.mark.exists() and self.mark.read_text())
        return picture

    def test_modules_and_settings(self):
        self.assertTrue(self.draw("modules").exists())
        self.assertTrue(self.draw("path", PYTHONPATH=".").exists())
        self.assertTrue(self.draw("home", PYTHONPATH=str(self.here)).exists())

    def test_programs_of_a_path_with_this_folder(self):
        system = pathlib.Path(sys.executable).parent
        for number, path in enumerate((f".:{system}", f":{system}", f"../here:{system}")):
            picture = self.draw(f"path{number}", PATH=path, BAGNOLD_PYTHON="python3")
            self.assertTrue(picture.exists(), path)
        for number, path in enumerate((".", "", "../here")):
            self.assertFalse(self.draw(f"none{number}", PATH=path, BAGNOLD_PYTHON="python3").exists())

    def test_packages(self):
        """One that lies here as an installed one would, or is named by no absolute path, is not run."""
        for folder in ("share/bagnold/python/bagnold", "bagnold"):
            (self.here / folder).mkdir(parents=True)
            for name in ("__init__.py", "__main__.py"):
                (self.here / folder / name).write_text(HOSTILE.format(mark=str(self.mark)))
        self.assertTrue(self.draw("here").exists())
        for number, name in enumerate((".", "share/bagnold/python", "../here", "")):
            picture = self.draw(f"package{number}", BAGNOLD_PYTHON_PACKAGE=name)
            self.assertFalse(picture.exists(), name)
            self.assertIn(f"BAGNOLD_PYTHON_PACKAGE = {name}", self.said)

    def test_a_relative_interpreter_is_none(self):
        self.assertFalse(self.draw("relative", BAGNOLD_PYTHON="./python3").exists())

    def test_an_interpreter_by_its_path(self):
        self.assertTrue(self.draw("chosen", BAGNOLD_PYTHON=sys.executable).exists())


class Packages(PictureTest):
    def test_a_changed_colour_needs_no_rebuild(self):
        shutil.copytree(SOURCE / "python", self.folder / "own", ignore=shutil.ignore_patterns("__pycache__"))
        style = self.folder / "own/bagnold/plots/style.py"
        style.write_text(style.read_text().replace("#0072B2", "#123456"))
        picture, own = self.picture("usual"), self.picture(
            "own", env=environment(BAGNOLD_PYTHON_PACKAGE=str(self.folder / "own")))

        def colours(path):
            import matplotlib.image
            pixels = (255 * matplotlib.image.imread(path)[..., :3]).round().astype(int)
            return set(np.unique(pixels @ (0x10000, 0x100, 1)).tolist())

        blue, other = 0x0072B2, 0x123456
        for path, there, missing in ((picture, blue, other), (own, other, blue)):
            found = colours(path)
            self.assertTrue(there in found and missing not in found, path)
        self.assertEqual(list((self.folder / "own").rglob("__pycache__")), [], "written beside the package")


class MissingPictures(PictureTest):
    def test_resume_draws_what_a_kill_left_out(self):
        out = self.folder / "out"
        self.run_scene(self.scene(output__plot=True, measure__profiles=True), out, "--quiet")
        pictures = [out / "plot.png", out / "profiles.png"]
        for picture in pictures:
            picture.unlink()
        result = self.bagnold("resume", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("nothing to resume", result.stdout)
        for picture in pictures:
            self.assertTrue(picture.exists(), picture)

    def test_of_a_cascade_too(self):
        out = self.folder / "out"
        path = self.scene(output__plot=True, shear__protocol="cascade", shear__strain_rate=None,
                          shear__strain_rates=[2.0**-6, 2.0**-7])
        self.run_scene(path, out, "--quiet")
        (out / "summary.json").unlink()
        stages = sorted(out.glob("*/plot.png"))
        self.assertEqual(len(stages), 2)
        self.assertTrue((out / "flow_curve.png").exists())
        stages[0].unlink()
        self.assertEqual(self.bagnold("resume", out).returncode, 0)
        self.assertTrue(stages[0].exists())


class Scripts(PictureTest):
    def test_a_pdf_is_a_pdf(self):
        out = self.run_new("out")
        for name, begin in (("x.pdf", b"%PDF"), ("x.svg", b"<?xml"), ("x.PNG", b"\x89PNG"), ("x", b"\x89PNG")):
            picture = self.folder / name
            subprocess.run([sys.executable, "-m", "bagnold", "plot", out, picture],
                           check=True, env=environment(PYTHONPATH=str(SOURCE / "python")))
            self.assertTrue(picture.read_bytes().startswith(begin), name)


if __name__ == "__main__":
    unittest.main()
