# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench on tiny systems: does every row still run, and does the table say what was timed? No
time is asserted. BAGNOLD_BUILD is the folder of the programs, BAGNOLD_SOURCE the root.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SOURCE = pathlib.Path(os.environ["BAGNOLD_SOURCE"])
BUILD = pathlib.Path(os.environ["BAGNOLD_BUILD"])
sys.path.insert(0, str(SOURCE / "bench/table"))

import levels  # noqa: E402
import report  # noqa: E402
import states  # noqa: E402
import targets  # noqa: E402
from measure import lammps  # noqa: E402


def bench(*arguments):
    command = [str(SOURCE / "scripts/bench"), "--build", str(BUILD), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True)


def contacts(path, rate):
    """Overlaps and squared relative velocities of all touching pairs, summed; all images, plain."""
    with h5py.File(path) as file:
        group = file["state"]
        r, v, d = (group[name][:] for name in ("position", "velocity", "diameter"))
        length, offset = group.attrs["box_length"], group.attrs["offset"]
    dr, dv = r[:, None] - r[None], v[:, None] - v[None]
    reach = (d[:, None] + d[None]) / 2
    overlap = motion = 0.0
    for row in (-2, -1, 0, 1, 2):
        for column in (-2, -1, 0, 1, 2):
            if row == column == 0:
                np.fill_diagonal(dr[..., 0], np.inf)
            separation = np.hypot(dr[..., 0] - column * length - row * offset, dr[..., 1] - row * length)
            touch = separation < reach
            overlap += np.sum((1 - separation / reach)[touch])
            motion += np.sum((dv[..., 0] - row * rate * length)[touch] ** 2 + dv[..., 1][touch] ** 2)
            np.fill_diagonal(dr[..., 0], 0.0)
    return overlap, motion


class Rows(unittest.TestCase):
    """All rows, one round, two engines."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.page = cls.folder / "page.md"
        cls.begin, cls.end = report.markers(report.TABLE)
        cls.page.write_text(f"before\n{cls.begin}\nobsolete\n{cls.end}\nafter\n")
        cls.done = bench("--quick", "--repeats", 1, "--states", cls.folder / "states", "--into", cls.page)

    def test_runs(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_writes_between_the_markers_only(self):
        text = self.page.read_text()
        self.assertTrue(text.startswith(f"before\n{self.begin}\n"), text)
        self.assertTrue(text.endswith(f"\n{self.end}\nafter\n"), text)
        self.assertNotIn("obsolete", text)
        self.assertIn(self.done.stdout.strip(), text)
        self.assertNotIn(str(self.folder), text)

    def test_has_every_row(self):
        lines = [line.split(" | ") for line in self.done.stdout.splitlines()]
        timed = {(cells[0].removeprefix("| "), cells[1]) for cells in lines if len(cells) == 7}
        for row in targets.ROWS:
            for engine in ("auto", "reference"):
                self.assertIn((row, engine), timed)

    def test_every_target_is_measured(self):
        lines = [line.split(" | ") for line in self.done.stdout.splitlines()]
        for target in targets.TARGETS:
            if target.other_engine == targets.LAMMPS:
                continue  # not installed everywhere
            found = [cells for cells in lines if len(cells) == 4 and cells[0] == "| " + target.what]
            self.assertTrue(found, target.what)
            self.assertNotIn("not measured", str(found), target.what)

    def test_a_missing_state_is_told(self):
        done = bench("--rows", "cd_rot76|q1-", "--states", self.folder / "none", "--repeats", 1)
        self.assertNotEqual(done.returncode, 0)
        for state in ("cd_rot76-1e-5-1024", "cd_n-q1-1e-5-1024"):
            self.assertIn(f"skipped: {state}: no state", done.stderr)

    def test_the_benchmark_alone_skips_a_missing_state(self):
        done = subprocess.run([BUILD / "bagnold_bench", "--states", self.folder / "none",
                               "--benchmark_filter=^cd_rot76-1e-5-1024/auto/"],
                              capture_output=True, text=True)
        self.assertIn("scripts/bench states", done.stdout + done.stderr)

    def test_copies_are_the_same_packing(self):
        """A box of 2 x 2 copies has four times the contacts, overlaps and relative velocities."""
        folder = self.folder / "states"
        one = contacts(folder / "cd_rot82-1e-4-16384/state.h5", 1e-4)
        many = contacts(folder / "cd_rot82-1e-4-1048576/state.h5", 1e-4)
        self.assertGreater(one[0], 0)
        np.testing.assert_allclose(many, 4 * np.array(one), rtol=1e-9)


class Table(unittest.TestCase):
    def test_the_program_has_every_row(self):
        done = subprocess.run([BUILD / "bagnold_bench", "--benchmark_list_tests"],
                              capture_output=True, text=True, check=True)
        names = {name.split("/iterations:")[0] for name in done.stdout.splitlines()}
        for engine in ("auto", "default", "reference", "few-contacts", "many-contacts", "lookahead"):
            for row in targets.ROWS:
                self.assertIn(targets.benchmark_of(row, engine), names)

    def test_rows_and_states_exist(self):
        for target in targets.TARGETS:
            self.assertIn(target.row, targets.ROWS)
            self.assertIn(target.other_row or target.row, targets.ROWS)
        for row in targets.ROWS:
            self.assertIn(targets.state_of(row), states.STATES)

    def test_ratios_are_taken_within_a_round(self):
        rounds = [{("a", "auto"): {"q": 6.0}, ("b", "auto"): {"q": 2.0}},
                  {("a", "auto"): {"q": 40.0}, ("b", "auto"): {"q": 10.0}},
                  {("a", "auto"): {"q": 1.0}}]
        target = targets.Target("", "q", "a", 3.5, other_row="b")
        self.assertEqual(target.values(rounds, "auto"), [3.0, 4.0])
        self.assertEqual(report.spread([3.0, 4.0]), "3.5 (3-4)")
        self.assertTrue(target.met(3.5))
        self.assertFalse(target.met(3.4))
        self.assertFalse(targets.below("", "q", "a", 3.5).met(3.6))

    def test_peers_are_compared_at_equal_bias(self):
        row = "cd_rot82-1e-4-1024"
        rounds = [{(row, targets.LAMMPS): {targets.SECONDS: 20.0}, (row, targets.LAMMPS_LONGEST): {
            targets.SECONDS: 10.0 * k}, (row, targets.DEFAULT): {targets.SECONDS: 2.0}} for k in (1, 2, 3)]
        self.assertEqual(report.peer_table(rounds, targets.ROWS).splitlines()[2:],
                         ["| cd_rot82-1e-4-1024 | 20 | 0.1 | 20 (10-30) | 2 | 10 (5-15) |"])
        self.assertEqual(report.peer_table([{}], targets.ROWS), "")

    def test_levels_are_held_against_the_best_one(self):
        rounds = [{(row, level): {targets.SECONDS: seconds * k} for row, times in (("a", (1.0, 1.2, 2.0)),
                                                                                   ("b", (2.0, 3.0, 5.0)))
                   for level, seconds in zip(levels.NAMES, times)} for k in (1, 2)]
        found = levels.text(rounds, ["a", "b", "not timed"], levels.NAMES, "").splitlines()
        self.assertEqual([line.split(" | ")[1:] for line in found if " over avx512, " in line],
                         [["at most 1.35", "1.5: b", "**no** |"], ["at most 3", "2.5: b", "yes |"]])
        self.assertEqual(found[-2:], ["| a | 1.5 (1-2) | 1.2 | 2 |", "| b | 3 (2-4) | 1.5 | 2.5 |"])

    def test_a_program_of_one_level_is_refused(self):
        info = subprocess.run([BUILD / "bagnold", "info"], capture_output=True, text=True, check=True).stdout
        if "also" in info:
            self.skipTest("this build has several levels")
        done = bench("levels", "--quick", "--rows", "cd_rot76")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("BAGNOLD_NATIVE=OFF", done.stderr)

    def test_a_peer_looks_at_its_list_as_often_in_time(self):
        scene = lammps.peer.Scene("CD_n", 1.0, 1e-4, "area")
        case = lammps.Case("", "", 1, 0.8, scene, lammps.peer.Tuning(every=10))
        longer = lammps.with_time_step(case, 0.1)
        self.assertEqual((longer.scene.time_step, longer.tuning.every), (0.1, 5))
        self.assertEqual(set(targets.PEER_ROWS) - set(lammps.LONGEST), set())

    def test_bad_input_is_refused(self):
        for arguments, word in ((("--rows", "nothing"), "nothing"), (("--rows", "("), "regular"),
                                (("--repeats", 0), "repeats"), (("--engines", "fast"), "fast")):
            done = bench(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(word, done.stderr)

    def test_a_page_without_markers_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "page.md")
            page.write_text("nothing\n")
            with self.assertRaises(SystemExit):
                report.put_into(str(page), report.TABLE, "new")
            self.assertEqual(page.read_text(), "nothing\n")


if __name__ == "__main__":
    unittest.main()
