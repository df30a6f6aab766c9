# SPDX-License-Identifier: BSD-3-Clause
"""examples/workflows: make, Snakemake and signac run a scene once, go on with what was stopped, keep what is done."""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import unittest

from made import SOURCE, Folder, bagnold

EXAMPLE = SOURCE / "examples/workflows"


class Workflow:
    def setUp(self):
        super().setUp()
        self.place = self.folder / "workflow"
        shutil.copytree(EXAMPLE, self.place)
        links = self.folder / "bin"  # the program under its name, and the Python of this test
        links.mkdir()
        (links / "bagnold").symlink_to(os.path.abspath(os.environ["BAGNOLD_PROGRAM"]))
        (links / "python3").symlink_to(sys.executable)
        self.environment = {**os.environ, "PATH": f"{links}:{os.environ['PATH']}", "PYTHONPATH": str(SOURCE / "python"),
                            "HOME": str(self.folder), "XDG_CACHE_HOME": str(self.folder / "cache")}

    def call(self, code=0):
        done = subprocess.run(self.words, cwd=self.place, env=self.environment, capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def runs(self):
        return sorted(path.parent for path in self.place.glob(f"{self.folders}/scene.toml"))

    def kept(self, run):
        return {name: ((run / name).read_bytes(), (run / name).stat().st_mtime_ns) for name in ("result.h5", "state.h5")}

    def test_runs_goes_on_and_keeps(self):
        self.call()
        one, other = self.runs()
        self.assertEqual(sorted(bagnold.load(run).scene["disks.elasticity"] for run in (one, other)), [1, 10])
        before, whole = self.kept(one), self.kept(other)
        for name in ("summary.json", "result.h5", "state.h5"):  # as where it was killed before its end
            (other / name).unlink()
        (self.place / "results/table.csv").unlink(missing_ok=True)
        self.call()
        self.assertEqual(self.kept(one), before)
        self.assertEqual(self.kept(other)["state.h5"][0], whole["state.h5"][0])
        self.assertTrue(json.loads((other / "summary.json").read_text())["observables"])
        self.changed(one)

    def changed(self, run):
        """Another scene is refused, and said."""
        path = self.place / "scene.toml"
        path.write_text(path.read_text().replace("strain = 4.0", "strain = 4.5"))
        before = self.kept(run)
        said = self.call(code=self.failed)
        self.assertIn("shear.strain = 4.5, there 4.0", said)
        self.assertEqual(self.kept(run), before)


@unittest.skipUnless(shutil.which("make"), "make is not installed")
class Make(Workflow, Folder):
    words, folders, failed = ["make"], "results/*", 2

    def test_what_is_done_is_up_to_date(self):
        self.call()
        table = (self.place / "results/table.csv").read_text().splitlines()
        self.assertEqual([line.split(",")[0] for line in table], ["elasticity", "1.0", "10.0"])
        self.assertIn("up to date", self.call())
        os.utime(self.place / "scene.toml")
        before = [self.kept(run) for run in self.runs()]
        self.call()
        self.assertEqual([self.kept(run) for run in self.runs()], before)
        self.assertIn("up to date", self.call())

    def test_a_table_that_failed_is_made_again(self):
        script = self.place / "table.py"
        right = script.read_text()
        script.write_text("raise SystemExit(1)\n")
        self.call(code=2)
        self.assertFalse((self.place / "results/table.csv").exists())
        script.write_text(right)
        self.call()
        self.assertEqual(len((self.place / "results/table.csv").read_text().splitlines()), 3)


@unittest.skipUnless(shutil.which("snakemake"), "snakemake is not installed")
class Snakemake(Workflow, Folder):
    words, folders, failed = ["snakemake", "--cores", "1", "--rerun-incomplete"], "results/*", 1


@unittest.skipUnless(importlib.util.find_spec("signac"), "signac is not installed")
class Signac(Workflow, Folder):
    words, folders, failed = [sys.executable, "project.py"], "workspace/*/run", 1


class Readme(Folder):
    def test_what_it_names_is_there(self):
        text = (EXAMPLE / "README.md").read_text()
        for path in EXAMPLE.iterdir():
            if path.name not in ("README.md", "scene.toml", "table.py"):
                self.assertIn(f"]({path.name})", text)


if __name__ == "__main__":
    unittest.main()
