# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold sweep`: what it writes, what it refuses, how it stops and goes on."""

import os
import re
import shutil
import signal
import unittest

import h5py
import numpy as np

from bagnold import files_of, lattice_state, read_summary, write_state
from sweeps import SEEDS, SweepTest, catches_term, rows, tables

LONG = {"shear__strain": 2.0**20, "output__sample_strain": 2.0**10}  # never ends by itself


class Tables(SweepTest):
    def test_rows_are_the_summaries_in_the_order_of_the_file(self):
        path = self.sweep_file(grid={"disks.elasticity": [10, 1], "disks.model": ["CD", "CD_rot"]})
        out = self.folder / "out"
        self.sweep(path, out, "--quiet")
        table, folders = rows(out), self.points(out)
        self.assertEqual(
            [(row["disks.elasticity"], row["disks.model"]) for row in table],
            [("10", "CD"), ("10", "CD_rot"), ("1", "CD"), ("1", "CD_rot")],
        )
        for row, folder in zip(table, folders):
            summary = read_summary(folder)
            self.assertEqual(summary["scene"]["disks"]["model"], row["disks.model"])
            self.assertEqual(summary["scene"]["disks"]["elasticity"], float(row["disks.elasticity"]))
            for name, estimate in summary["observables"].items():
                for key, column in (("mean", name), ("error", name + "_error")):
                    cell = row[column]
                    self.assertEqual(float(cell) if cell else None, estimate[key], column)
        self.assertEqual(table[0]["spin_mean"], "")  # CD has no spins
        self.assertNotEqual(table[1]["spin_mean"], "")

    def test_hdf5_holds_the_same(self):
        path = self.sweep_file(grid={"disks.elasticity": [10, 1], "disks.model": ["CD", "CD_rot"]})
        out = self.folder / "out"
        self.sweep(path, out, "--quiet")
        with h5py.File(out / "sweep.h5") as file:
            self.assertEqual(file.attrs["sweep"], path.read_text())
            self.assertEqual(list(file["points/disks.elasticity"]), [10, 10, 1, 1])
            self.assertEqual(list(file["points/disks.model"].asstr()), ["CD", "CD_rot"] * 2)
            self.assertEqual(list(file["status"].asstr()), ["done"] * 4)
            self.assertEqual(
                list(file["points/folder"].asstr()), [f.name for f in self.points(out)]
            )
            for k, row in enumerate(rows(out)):
                for name, data in file["observables"].items():
                    cell = float(row[name]) if row[name] else np.nan
                    np.testing.assert_equal(data[k], cell)

    def test_a_point_is_the_run_of_its_scene(self):
        path = self.sweep_file(grid=SEEDS)
        out = self.folder / "out"
        self.sweep(path, out, "--quiet")
        alone = self.run_new("alone", disks__seed=2)
        self.assert_same_results(alone, self.points(out)[1])

    def test_same_bytes_for_two_runs_and_any_number_of_jobs(self):
        path = self.sweep_file(grid={"disks.elasticity": [1, 4], **SEEDS})
        for k, arguments in enumerate((["--jobs", "1"], ["--jobs", "2"], ["--threads", "2"])):
            said = self.sweep(path, self.folder / f"out{k}", *arguments).stdout
            self.assertIn("6 of 6 points done, 0 running, 0 failed  strain 100%", said)
        one = tables(self.folder / "out0")
        self.assertEqual(tables(self.folder / "out1"), one)
        self.assertEqual(tables(self.folder / "out2"), one)

    def test_a_chain_goes_from_state_to_state(self):
        path = self.sweep_file(
            grid={"shear.strain_rate": [2.0**-6, 2.0**-7], "disks.seed": [1, 2]},
            chain="shear.strain_rate",
        )
        out = self.folder / "out"
        self.sweep(path, out, "--quiet")
        first, _, second, _ = self.points(out)
        # the same by hand: a run, and a run from its state
        by_hand = self.run_new("one", shear__strain_rate=2.0**-6)
        self.assert_same_state(by_hand, first)
        by_hand = self.run_new("two", start__kind="state", start__file=str(by_hand / "state.h5"))
        self.assert_same_state(by_hand, second)


class Refusals(SweepTest):
    def refused_sweep(self, path, *words):
        out = self.folder / "refused"
        self.assert_clean_error(self.bagnold("sweep", path, "--out", out), 2, *words)
        self.assert_clean_error(self.bagnold("validate", path), 2, *words)
        self.assertFalse(out.exists(), "a refused sweep left a folder")

    def test_every_point_is_checked_before_the_first_is_run(self):
        self.refused_sweep(
            self.sweep_file(grid={"disks.seed": [1], "disks.elasticity": [1, 1e9]}),
            "point 2 of 2", "disks.elasticity = 1", "at most",
        )
        self.refused_sweep(
            self.sweep_file(grid={"integration.time_step": [0.0625, 8.0]}),
            "point 2 of 2", "integration.time_step", "unstable",
        )
        self.refused_sweep(
            self.sweep_file(grid={"start.file": ["none.h5"]}, start__kind="state"),
            "point 1 of 1", "none.h5",
        )

    def test_a_scene_is_no_sweep_and_a_sweep_no_scene(self):
        out = self.folder / "refused"
        scene, sweep = self.scene(), self.sweep_file(grid=SEEDS)
        self.assert_clean_error(
            self.bagnold("sweep", scene, "--out", out), 2, "[sweep]", "bagnold run")
        self.assert_clean_error(self.bagnold("run", sweep, "--out", out), 2, "bagnold sweep")
        self.assertFalse(out.exists())

    def test_comments_are_no_change_and_finished_points_are_not_run_again(self):
        out, path = self.folder / "out", self.sweep_file(grid=SEEDS)
        self.sweep(path, out, "--quiet")
        before = files_of(out / "points")
        path.write_text("# in other words\n" + path.read_text().replace("1.0", "1.00"))
        self.sweep(path, out, "--quiet")
        after = files_of(out / "points")
        self.assertEqual({k: v for k, v in after.items() if ".lock" not in k},
                         {k: v for k, v in before.items() if ".lock" not in k})

    def test_one_sweep_at_a_time(self):
        out, path = self.folder / "out", self.sweep_file(grid=SEEDS, **LONG)
        process = self.start("sweep", path, "--out", out)
        self.wait_until(lambda: len(self.children(out)) > 0, process)
        self.assert_clean_error(self.bagnold("sweep", path, "--out", out), 2, "in use by")

    def test_a_folder_with_a_run(self):
        out = self.run_new("out")
        result = self.bagnold("sweep", self.sweep_file(grid=SEEDS), "--out", out)
        self.assert_clean_error(result, 2, "holds a run")

    def test_a_run_into_the_folder_of_a_sweep(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out)
        for words in ((), ("--force",)):
            self.assert_clean_error(self.bagnold("run", self.scene(), "--out", out, *words), 2, "holds a sweep")
        self.assertFalse((out / "scene.toml").exists())

    def test_chain_numbers(self):
        out, path = self.folder / "out", self.sweep_file(grid=SEEDS)
        result = self.bagnold("sweep", path, "--out", out, "--chain", "4")
        self.assert_clean_error(result, 2, "from 1 to 3")
        result = self.bagnold("sweep", path, "--out", out, "--chain", "1")
        self.assert_clean_error(result, 2, "--emit-slurm")
        self.assertFalse(out.exists())

    def test_validate(self):
        result = self.bagnold("validate", self.sweep_file(grid=SEEDS, zip={"disks.model": ["CD"]}))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("3 in 3 chains", result.stdout)
        self.assertRegex(result.stdout, r"estimated time .* s")


class Failures(SweepTest):
    def bad_start(self):
        good, fast = lattice_state(), lattice_state()
        fast["velocity"][5] = [0.0, 1e3]
        write_state(self.folder / "good.h5", good)
        write_state(self.folder / "fast.h5", fast)
        return self.sweep_file(
            grid={"start.file": ["good.h5", "fast.h5"], "shear.strain": [0.125, 0.25]},
            disks__model="CD", disks__packing_fraction=0.1, start__kind="state",
        )

    def test_the_others_are_done_and_the_end_says_so(self):
        out = self.folder / "out"
        result = self.sweep(self.bad_start(), out, code=1)
        self.assertRegex(result.stderr, r'point 3 of 4 \(start.file = .fast.h5.*exit code 3.*disk 5')
        self.assertIn("point 4 of 4", result.stderr)
        self.assertIn("2 of 4 points", result.stderr)
        table = rows(out)
        self.assertEqual([row["p"] != "" for row in table], [True, True, False, False])
        self.assertEqual({row[name] for row in table[2:] for name in row
                          if "." not in name and name != "folder"}, {""})
        with h5py.File(out / "sweep.h5") as file:
            self.assertEqual(list(file["status"].asstr()), ["done", "done", "failed", "failed"])
            self.assertTrue(np.isnan(file["observables/p"][2]))

    def test_a_repaired_point_is_run_at_the_next_start(self):
        out, path = self.folder / "out", self.bad_start()
        self.sweep(path, out, code=1)
        shutil.copy(self.folder / "good.h5", self.folder / "fast.h5")
        for folder in self.points(out)[2:]:
            for name in folder.glob("checkpoint*"):
                name.unlink()
        self.sweep(path, out)
        self.assertEqual([row["p"] != "" for row in rows(out)], [True] * 4)

    def test_a_failed_point_ends_its_chain_only(self):
        write_state(self.folder / "good.h5", lattice_state())
        fast = lattice_state()
        fast["velocity"][5] = [0.0, 1e3]
        write_state(self.folder / "fast.h5", fast)
        path = self.sweep_file(
            grid={"start.file": ["fast.h5", "good.h5"], "shear.strain_rate": [2.0**-6, 2.0**-7]},
            chain="shear.strain_rate", disks__model="CD", disks__packing_fraction=0.1,
            start__kind="state",
        )
        out = self.folder / "out"
        self.sweep(path, out, code=1)
        with h5py.File(out / "sweep.h5") as file:
            self.assertEqual(list(file["status"].asstr()), ["failed", "open", "done", "done"])


class Signals(SweepTest):
    def begin(self, path, out, jobs=2):
        process = self.start("sweep", path, "--out", out, "--jobs", jobs)
        self.wait_until(lambda: len(self.children(out)) == jobs, process)
        self.wait_until(lambda: all(catches_term(pid) for pid in self.children(out)), process)
        return process

    def test_stop_writes_checkpoints(self):
        path = self.sweep_file(grid=SEEDS, **LONG)
        for number, code in ((signal.SIGTERM, 143), (signal.SIGINT, 130)):
            out = self.folder / number.name
            process = self.begin(path, out)
            process.send_signal(number)
            status, output = self.finish(process)
            self.assertEqual(status, code, output)
            self.assertIn("the same command goes on", output)
            self.assertEqual(self.children(out), [])
            self.assertEqual([(f / "checkpoint.h5").exists() for f in self.points(out)],
                             [True, True, False])
            self.assertFalse((out / "sweep.csv").exists())

    def test_a_signal_to_all_is_taken_once(self):
        """A terminal and Slurm signal sweep and points alike."""
        out = self.folder / "out"
        process = self.begin(self.sweep_file(grid=SEEDS, **LONG), out)
        for pid in self.children(out):
            os.kill(pid, signal.SIGTERM)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(self.finish(process)[0], 143)
        self.assertEqual([(f / "checkpoint.h5").exists() for f in self.points(out)],
                         [True, True, False])

    def test_points_die_with_a_killed_sweep(self):
        out = self.folder / "out"
        process = self.begin(self.sweep_file(grid=SEEDS, **LONG), out)
        process.kill()
        process.wait()
        self.wait_until(lambda: self.children(out) == [], seconds=10)

    def test_stopped_and_gone_on(self):
        path = self.sweep_file(grid=SEEDS, shear__strain=256.0)
        whole, out = self.folder / "whole", self.folder / "out"
        self.sweep(path, whole)
        process = self.begin(path, out)
        process.terminate()
        self.assertEqual(self.finish(process)[0], 143)
        first = self.points(out)[0]
        self.assertTrue((first / "checkpoint.h5").exists())
        self.assertFalse((first / "summary.json").exists(), "too quick for this test")
        self.sweep(path, out)
        self.assertIn("going on from step", (first / "log.txt").read_text())
        self.assertEqual(tables(out), tables(whole))


class Collect(SweepTest):
    def test_chain_by_chain(self):
        """What a job array does, in any order."""
        path = self.sweep_file(grid=SEEDS)
        whole, out = self.folder / "whole", self.folder / "out"
        self.sweep(path, whole)
        self.sweep(path, out, "--emit-slurm")
        self.assertRegex((out / "points.slurm").read_text(), re.compile(r"^#SBATCH --array=1-3$", re.M))
        self.sweep(path, out, "--chain", "3")
        result = self.sweep(path, out, "--collect", code=1)
        self.assertIn("2 of 3 points", result.stderr)
        self.assertEqual([row["p"] != "" for row in rows(out)], [False, False, True])
        self.sweep(path, out, "--chain", "1")
        self.sweep(path, out, "--chain", "2")
        self.sweep(path, out, "--collect")
        self.assertEqual(tables(out), tables(whole))

    def test_scripts_are_bash(self):
        out = self.folder / "it's a folder"
        self.sweep(self.sweep_file(grid=SEEDS), out, "--emit-slurm")
        for name in ("points.slurm", "collect.slurm"):
            self.assertEqual(os.spawnlp(os.P_WAIT, "bash", "bash", "-n", str(out / name)), 0)


class Folders(SweepTest):
    def test_resume_names_the_sweep(self):
        path, out = self.sweep_file(grid=SEEDS), self.folder / "out"
        self.sweep(path, out, "--quiet")
        self.assert_clean_error(self.bagnold("resume", out), 2, "bagnold sweep", str(out))

    def test_fresh_points_say_nothing_of_checkpoints(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out)
        for log in out.glob("points/*/log.txt"):
            self.assertNotIn("checkpoint", log.read_text())

    def test_names_that_slurm_would_take_as_its_own(self):
        """They stand in comments of a script: a new line would make a command of the rest."""
        path = self.sweep_file(grid=SEEDS)
        for name in ('a"b', "a%b", "a\\b", "a\ntouch mark\n", "a\rb"):
            out = self.folder / name
            self.assert_clean_error(self.bagnold("sweep", path, "--out", out, "--emit-slurm"), 2, "--out")
            self.assertFalse(out.exists())
        out = self.folder / "it's $(fine) & good"
        self.sweep(path, out, "--emit-slurm")


if __name__ == "__main__":
    unittest.main()
