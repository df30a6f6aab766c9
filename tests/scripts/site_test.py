# SPDX-License-Identifier: BSD-3-Clause
"""scripts/site: the site is made without a warning, with its pages, functions, notebooks and search; a link that leads
nowhere fails it.

BAGNOLD is the program, BAGNOLD_SOURCE the root of the repository. Exit status 77 (skipped): Sphinx is not here, and
PyPI is out of reach.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
UNAVAILABLE = 77


class Site(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def make(self, source, *words):
        done = subprocess.run([sys.executable, source / "scripts/site", "--out", self.folder / "site", *words],
                              capture_output=True, text=True, timeout=500)
        if done.returncode == UNAVAILABLE:
            self.skipTest("Sphinx cannot be installed")
        return done

    def page(self, name):
        return (self.folder / "site/html" / name).read_text()

    def test_the_whole(self):
        done = self.make(SOURCE, "--program", os.environ["BAGNOLD"])
        self.assertEqual(done.returncode, 0, done.stderr)
        pages = [*(SOURCE / "docs").glob("*.md"), *(SOURCE / "examples").glob("*.ipynb")]
        index, found = self.page("index.html"), self.page("searchindex.js")
        for page in pages:
            name = page.relative_to(SOURCE).with_suffix("")
            self.assertIn(f'href="{name}.html"', index)
            self.assertIn(f'"{name}"', found)
        functions = self.page("api.html")
        for name in ("bagnold.run", "bagnold.Run.to_xarray", "bagnold.structure.structure_factor", "bagnold.plots.packing"):
            self.assertIn(f'id="{name}"', functions)
        notebook = self.page("examples/first_look.html")
        self.assertRegex(notebook, r"p = [\d.]+\(\d+\) m/tau_e\^2")
        self.assertGreaterEqual(len(re.findall(r'<img [^>]*src="[^"]*_images/', notebook)), 2)

    def test_a_link_that_leads_nowhere(self):
        tree = self.folder / "tree"
        for name in ("scripts", "docs/site", "python", "examples"):
            shutil.copytree(SOURCE / name, tree / name, ignore=shutil.ignore_patterns("results", "__pycache__"))
        for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", "CMakeLists.txt", "docs/index.md"):
            shutil.copy(SOURCE / name, tree / name)
        for name in ("bench", "kernels", "packaging", "src"):
            (tree / name).mkdir()
        done = self.make(tree, "--keep-outputs")
        self.assertEqual(done.returncode, 1)
        self.assertIn("docs/gallery.md", done.stderr)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(UNAVAILABLE if result.skipped else not result.wasSuccessful())
