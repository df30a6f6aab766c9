# SPDX-License-Identifier: BSD-3-Clause
"""Tools that Debian 12 does not have: taplo reads all TOML and holds the scenes against their schema, cffconvert the
citation, rattler-build the recipe for conda; signac runs its example.

BAGNOLD is the program, BAGNOLD_SOURCE the root of the repository. Exit status 77 (skipped): PyPI is out of reach.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(SOURCE / "scripts/lib"))
import pypi  # noqa: E402

BIN = pypi.provide("test-tools-r2", ["taplo", "cffconvert", "signac", "py-rattler-build"])
FOLDERS = ("inputs", "examples", "python", "docs", "bench", "tests")


class Tools(unittest.TestCase):
    def lint(self, *files):
        return subprocess.run([BIN / "taplo", "lint", *files], capture_output=True, text=True, cwd=SOURCE, timeout=100)

    def test_taplo_reads_all_files(self):
        files = [SOURCE / "pyproject.toml", *(path for name in FOLDERS for path in (SOURCE / name).rglob("*.toml"))]
        self.assertGreater(len(files), 50)
        done = self.lint(*files)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_taplo_finds_what_the_schema_forbids(self):
        text = (SOURCE / "inputs/quickstart.toml").read_text()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SOURCE / "inputs/scene.schema.json", folder)
            scene = pathlib.Path(folder) / "scene.toml"
            for change, said in ((("count = ", "count = -"), "is less than the minimum"),
                                 (('model = "', 'model = "X'), "is not one of"), (("count", "cuont"), "'cuont' was unexpected")):
                self.assertIn(change[0], text)
                scene.write_text(text.replace(*change, 1))
                done = self.lint(scene)
                self.assertEqual(done.returncode, 1)
                self.assertIn(said, done.stderr)

    def test_the_citation(self):
        done = subprocess.run([BIN / "cffconvert", "--validate", "-i", SOURCE / "CITATION.cff"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_conda_s_recipe(self):
        """As rattler-build fills it in for this machine; nothing is fetched or built."""
        folder = SOURCE / "packaging/conda"
        made, = json.loads(subprocess.run([BIN / "python", "-c", """import json, sys
from rattler_build import Stage0Recipe, VariantConfig
recipes = Stage0Recipe.from_file(sys.argv[1]).render(VariantConfig.from_file(sys.argv[2]))
print(json.dumps([one.recipe.to_dict() for one in recipes]))""", folder / "recipe.yaml", folder / "variants.yaml"],
            capture_output=True, text=True, check=True).stdout)
        self.assertEqual((made["package"]["name"], len(made["requirements"]["host"])), ("bagnold", 8))
        self.assertTrue(any(name.startswith("sysroot") for name in made["requirements"]["build"]))
        python = tomllib.loads((SOURCE / "pyproject.toml").read_text())["project"]["requires-python"]
        self.assertIn(f"python {python}", made["requirements"]["run"])

    def test_signac(self):
        done = subprocess.run([BIN / "python", SOURCE / "tests/python/workflows_test.py", "Signac"], capture_output=True,
                              text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("skipped", done.stderr)


if __name__ == "__main__":
    unittest.main()
