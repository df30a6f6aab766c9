# SPDX-License-Identifier: BSD-3-Clause
"""scripts/accuracy on tiny systems: does every table and picture come out, and is it of the size that the
numbers must have? BAGNOLD_BUILD is the folder of the programs, BAGNOLD_SOURCE the root.
"""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["BAGNOLD_SOURCE"])
BUILD = pathlib.Path(os.environ["BAGNOLD_BUILD"])


def program(*arguments):
    return subprocess.run([str(BUILD / "bagnold_accuracy"), *map(str, arguments)], capture_output=True,
                          text=True)


class Tiny(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.done = subprocess.run(
            [str(SOURCE / "scripts/accuracy"), "--build", str(BUILD), "--tiny", "--jobs", "2",
             "--states", str(cls.folder / "states"), "--data", str(cls.folder), "--pictures", str(cls.folder)],
            capture_output=True, text=True)

    def table(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_runs(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_pictures(self):
        for name in ("collision.png", "stability.png", "bias-0.001.png", "engines.png"):
            self.assertEqual((self.folder / name).read_bytes()[:4], b"\x89PNG", name)

    def test_collisions_have_the_papers_restitution(self):
        """P1 Eq. 7: 0.3970 and 0.8373; and schemes come near it as the step shrinks."""
        rows = [r for r in self.table("collision.csv") if r["model"] == "CD_n" and r["scheme"] == "two-stage"]
        for q, expected in (("2", 0.3970), ("10", 0.8373)):
            mine = [r for r in rows if r["Q"] == q]
            self.assertEqual(len(mine), 4)
            for row in mine:
                self.assertAlmostEqual(float(row["restitution"]), expected, 4)
                self.assertLess(abs(float(row["loss_error"])), 0.02)

    def test_every_scheme_is_in_every_table(self):
        schemes = {row["scheme"] for row in self.table("collision.csv")}
        self.assertEqual(len(schemes), 7)
        for name in ("stretch.csv", "stability_contact.csv", "stability_packing.csv"):
            self.assertEqual({row["scheme"] for row in self.table(name)}, schemes, name)

    def test_two_stage_bears_larger_steps_than_lagged_velocity(self):
        """Its polynomial reaches 7 where that of one stage reaches 2."""
        edge = {(row["model"], row["scheme"]): float(row["largest_dt_over_Q"])
                for row in self.table("stability_packing.csv") if row["arrangement"] == "index"}
        for model in ("CD", "CD_n", "CD_rot"):
            ratio = edge[model, "two-stage"] / edge[model, "lagged-velocity-verlet"]
            self.assertGreater(ratio, 3.0, model)
            self.assertLess(ratio, 3.7, model)

    def test_engines_have_both_schemes_each_with_its_own_step(self):
        rows = self.table("engines.csv")
        self.assertEqual({row["engine"] for row in rows},
                         {"steps", "few-contacts", "many-contacts", "lookahead", "reference"})
        steps = {(row["state"], row["scheme"]): float(row["time_step"]) for row in rows}
        self.assertEqual(steps["cd_n-q50-1e-4-1024", "modified-velocity-verlet"], 0.01)  # 0.5/Q, P1
        self.assertEqual(steps["cd_rot82-1e-4-1024", "modified-velocity-verlet"], 0.05)
        self.assertEqual(steps["cd_n-q50-1e-4-1024", "two-stage-leapfrog"], 0.2)

    def test_auto_takes_implicit_steps_in_dense_flow(self):
        row, = self.table("auto.csv")
        self.assertGreater(float(row["share"]), 0.3)
        self.assertLess(float(row["p_kin_share"]), 1e-4)
        self.assertLess(abs(float(row["Z"])), 5)

    def test_precisions_agree_at_a_large_rate(self):
        rows = self.table("precision.csv")
        self.assertEqual({row["precision"] for row in rows}, {"double", "float-pairs", "float"})
        for row in rows:
            self.assertEqual(row["status"], "ok")

    def test_a_step_beyond_reason_is_a_row_that_says_so(self):
        state = self.folder / "states/cd_rot82-1e-4-1024/state.h5"
        done = program("steady", "--state", state, "--model", "CD_rot", "--phi", 0.82, "--q", 0.01,
                       "--method", "modified-velocity-verlet:0.4", "--strain", 1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("left reason", list(csv.DictReader(done.stdout.splitlines()))[0]["status"])

    def test_wrong_words_are_refused(self):
        state = self.folder / "states/cd_rot82-1e-4-1024/state.h5"
        for method in ("no-such-scheme:0.1", "two-stage:-1", "two-stage+x:0.1", "two-stage:0.1:half"):
            done = program("steady", "--state", state, "--model", "CD_rot", "--phi", 0.82, "--method", method)
            self.assertEqual(done.returncode, 2, method)
            self.assertIn("error: ", done.stderr, method)


if __name__ == "__main__":
    unittest.main()
