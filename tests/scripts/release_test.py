# SPDX-License-Identifier: BSD-3-Clause
"""scripts/validate-release, a thousandth of its lengths: tables, and what they are of. And the tables that are kept.

BAGNOLD is the program, BAGNOLD_SOURCE the root of the repository.
"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
HEADS = {
    "accuracy": "state,observable,default,default_error,papers,papers_error,off_percent,off_error",
    "trajectories": "state,engine,strain,farthest_disk_d_s",
    "coverage": "runs,replicas,reached,beyond_2_errors,beyond_3_errors,bias,bias_error,stated_error,scatter",
    "performance": "state,engine,strain,seconds_a_unit_of_strain"}


class Release(unittest.TestCase):
    def table(self, folder, name):
        text = (folder / f"{name}.csv").read_text()
        self.assertEqual(text.splitlines()[0], HEADS[name])
        return list(csv.DictReader(text.splitlines()))

    def test_a_small_one(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        subprocess.run([sys.executable, SOURCE / "scripts/validate-release", "trajectories", "--share", "0.001", "--out", folder / "runs",
                        "--into", folder / "tables", "--bagnold", os.environ["BAGNOLD"], "--note", "a test"], check=True, timeout=250)
        rows = self.table(folder / "tables", "trajectories")
        self.assertEqual(len(rows), 15)  # five states of three engines
        self.assertLess(max(float(row["farthest_disk_d_s"]) for row in rows), 1e-6)
        about = json.loads((folder / "tables/release.json").read_text())
        self.assertEqual((about["share"], about["note"]), (0.001, "a test"))
        self.assertRegex(about["version"], r"^\d+\.\d+\.\d+$")

    def test_those_that_are_kept(self):
        kept = sorted((SOURCE / "docs/data/releases").iterdir())
        self.assertTrue(kept)
        for folder in kept:
            self.assertEqual(json.loads((folder / "release.json").read_text())["version"], folder.name)
            for name in HEADS:
                rows = self.table(folder, name)
                self.assertTrue(rows)
                for row in rows:
                    for value in list(row.values())[2:]:
                        float(value)


if __name__ == "__main__":
    unittest.main()
