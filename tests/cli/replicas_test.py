# SPDX-License-Identifier: BSD-3-Clause
"""disks.replicas = R: the seeds seed .. seed + R - 1 of one scene, side by side."""

import re
import shutil
import signal
import time
import unittest

import h5py
import numpy as np

from bagnold import (
    SCENE, CliTest, discarded_windows, lattice_state, read_series, read_state, read_summary,
    same_bits, without_mean_motion, write_state,
)

SEED, REPLICAS = 5, 3
THREE = {"disks__replicas": REPLICAS, "disks__seed": SEED}


class Replicas(CliTest):
    def alone(self, **changes):
        """The runs of each seed alone."""
        return [self.run_new(f"seed{SEED + r}", **{**changes, "disks__seed": SEED + r})
                for r in range(REPLICAS)]

    def assert_are(self, out, alone):
        """State and series of each replica, bit for bit those of its seed alone."""
        state, series = read_state(out), read_series(out)
        for r, one in enumerate(alone):
            for name, value in read_state(one).items():
                mine = state[name][r] if np.ndim(state[name]) else state[name]
                self.assertTrue(same_bits(mine, value), f"{name} of replica {r}")
            self.assertEqual(set(series), set(read_series(one)))
            for name, value in read_series(one).items():
                self.assertTrue(same_bits(series[name][r], value), f"{name} of replica {r}")


class SameBits(Replicas):
    def test_each_replica_is_its_seed_alone(self):
        for name, changes in {
            "rot": {},
            "n": {"disks__model": "CD_n", "disks__packing_fraction": 0.7, "shear__strain": 1.0},
            "reference": {"integration__engine": "reference"},
            "blocks": {"disks__count": 3000, "shear__strain": 2.0**-5},
        }.items():
            alone = self.alone(**changes)
            for threads in (1, 2, 3, 8):
                with self.subTest(name=name, threads=threads):
                    out = self.run_new(f"{name}{threads}", "--threads", threads, **THREE, **changes)
                    self.assert_are(out, alone)
            for one in alone:
                shutil.rmtree(one)

    def test_threads_and_backend_are_chosen(self):
        self.assert_are(self.run_new("chosen", **THREE), self.alone())

    def test_shapes(self):
        series = read_series(self.run_new("out", **THREE))
        for name, value in series.items():
            self.assertEqual(value.shape, (REPLICAS, 8), name)
        state = read_state(self.folder / "out")
        self.assertEqual(state["position"].shape, (REPLICAS, 64, 2))
        self.assertEqual(state["spin"].shape, (REPLICAS, 64))
        with h5py.File(self.folder / "out" / "result.h5") as file:
            self.assertEqual(list(file.attrs["seeds"]), [5, 6, 7])
            self.assertEqual(file.attrs["start_overlap"].shape, (REPLICAS,))

    def test_replicas_by_different_engines(self):
        """In a loose flow engine = "auto" steps some replicas and others go by events: each tells what it has."""
        loose = {"disks__model": "CD_n", "disks__packing_fraction": 0.78, "disks__elasticity": 10.0, "disks__replicas": 8,
                 "disks__mass": "area", "shear__strain_rate": 3e-4, "shear__strain": 2.0, "disks__seed": 1,
                 "output__sample_strain": None, "measure__every": 10, "integration__time_step": None}
        out = self.run_new("out", **loose)
        with h5py.File(out / "result.h5") as file:
            counts = {name: value for name, value in file.attrs.items() if name.startswith("engine_")}
        self.assertEqual({np.shape(value) for value in counts.values()}, {(8,)})
        missing = np.isnan(np.array(list(counts.values())))
        self.assertTrue((missing.any(axis=1) & ~missing.all(axis=1)).any())
        self.assertFalse(missing.all(axis=1).any())
        alone = self.run_new("alone", **{**loose, "disks__replicas": 1, "disks__seed": 5})
        with h5py.File(alone / "result.h5") as file:
            for name, value in file.attrs.items():
                if name.startswith("engine_"):
                    self.assertEqual(counts[name][4], value, name)

    def test_one_replica_has_no_axis(self):
        out = self.run_new("out", disks__replicas=1)
        self.assertEqual(read_state(out)["position"].shape, (64, 2))
        self.assertEqual(read_series(out)["p"].shape, (8,))
        self.assertNotIn("replicas", read_summary(out))


class Resumed(Replicas):
    LONG = {"shear__strain": 64.0, "output__sample_strain": 1.0, "disks__packing_fraction": 0.82,
            "output__checkpoint_minutes": 0.0005}

    def test_stopped_killed_and_resumed(self):
        alone = self.alone(**self.LONG)
        path, out = self.scene(**self.LONG, **THREE), self.folder / "out"
        command = ["run", path, "--out", out, "--threads", "2"]
        stops = 0
        for leg, number in enumerate((signal.SIGTERM, signal.SIGKILL, signal.SIGINT)):
            process = self.start(*command)
            stamp = self.stamp(out)
            self.wait_until(lambda: self.stamp(out) not in (None, stamp), process)
            process.send_signal(number)
            status, output = self.finish(process)
            self.assertIn(status, (143, 130, -signal.SIGKILL, 0), output)
            stops += status != 0
            command = ["resume", out, "--threads", str(3 - leg)]
        self.assertGreaterEqual(stops, 2, "the runs are too short for this test")
        self.assertFalse((out / "summary.json").exists())
        result = self.bagnold("resume", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_are(out, alone)

    def stamp(self, out):
        path = out / "checkpoint.h5"
        return path.stat().st_mtime_ns if path.exists() else None

    def test_partial_results_are_padded(self):
        """Between checkpoints replicas need not be equally far: what is not there is NaN."""
        path, out = self.scene(**self.LONG, **THREE), self.folder / "out"
        process = self.start("run", path, "--out", out, "--threads", "2")
        self.wait_until((out / "result.h5").exists, process)
        process.send_signal(signal.SIGTERM)
        self.finish(process)
        series = read_series(out)
        self.assertEqual({value.shape[0] for value in series.values()}, {REPLICAS})
        self.assertEqual(len({value.shape for value in series.values()}), 1)
        missing = np.isnan(series["evaluations"])
        self.assertFalse(missing.all(axis=0).any())
        self.assertTrue(np.isnan(series["p"][missing]).all())
        self.assertTrue(np.isfinite(series["p"][~missing]).all())

    def test_signals(self):
        path, out = self.scene(**{**self.LONG, "output__checkpoint_minutes": 1e6}, **THREE), \
            self.folder / "out"
        process = self.start("run", path, "--out", out, "--threads", "2")
        self.wait_until((out / "scene.toml").exists, process)
        time.sleep(0.1)
        process.send_signal(signal.SIGUSR1)
        self.assertTrue(self.wait_until(lambda: self.stamp(out) is not None, process))
        process.send_signal(signal.SIGTERM)
        status, output = self.finish(process)
        self.assertEqual(status, 143, output)
        self.assertIn("resume", output)

    def test_resumed_on_another_backend_is_refused(self):
        path, out = self.scene(**self.LONG, **THREE), self.folder / "out"
        process = self.start("run", path, "--out", out)
        self.wait_until(lambda: self.stamp(out) is not None, process)
        process.kill()
        self.finish(process)
        self.assert_clean_error(self.bagnold("resume", out, "--backend", "openmp"), 2,
                                "--backend openmp", "disks.replicas = 3")


class Summary(Replicas):
    CHANGES = {"shear__strain": 1.0, "shear__discard": 0.25, "disks__model": "CD_rot"}

    def test_mean_and_error_are_those_over_replicas(self):
        """Independent of the program: from the series of each, which for p are averages."""
        out = self.run_new("out", **{**self.CHANGES, **THREE, "disks__replicas": 4})
        summary, series = read_summary(out), read_series(out)
        first = discarded_windows(out)
        self.assertEqual(first, 16)
        weight = series["evaluations"][:, first:]
        for name in ("p", "sigma", "Z", "T_g", "delta_p", "B_p"):
            mean = (series[name][:, first:] * weight).sum(axis=1) / weight.sum(axis=1)
            found = summary["observables"][name]
            self.assertAlmostEqual(found["mean"] / mean.mean(), 1.0, delta=1e-12)
            error = mean.std(ddof=1) / np.sqrt(len(mean))
            self.assertAlmostEqual(found["error"] / error, 1.0, delta=1e-9)
            self.assertEqual(found["samples"], 4 * 48)
            for r, replica in enumerate(summary["replicas"]):
                self.assertAlmostEqual(replica["observables"][name]["mean"] / mean[r], 1.0,
                                       delta=1e-12)
        p, sigma = (summary["observables"][name]["mean"] for name in ("p", "sigma"))
        self.assertAlmostEqual(summary["observables"]["mu"]["mean"] * p / sigma, 1.0, delta=1e-12)
        self.assertIn("jackknife", summary["errors_from"])
        self.assertEqual([replica["seed"] for replica in summary["replicas"]], [5, 6, 7, 8])

    def test_each_replica_has_the_averages_of_its_seed_alone(self):
        out = self.run_new("out", **{**self.CHANGES, **THREE})
        for replica, one in zip(read_summary(out)["replicas"], self.alone(**self.CHANGES)):
            self.assertEqual(replica["observables"], read_summary(one)["observables"])

    def test_two_combine_their_own_errors(self):
        out = self.run_new("out", **{**self.CHANGES, **THREE, "disks__replicas": 2,
                                     "shear__strain": 8.0, "output__sample_strain": 2.0**-7})
        summary = read_summary(out)
        self.assertIn("combined", summary["errors_from"])
        known = 0
        for name, found in summary["observables"].items():
            own = [replica["observables"][name]["error"] for replica in summary["replicas"]]
            if None in own:
                self.assertIsNone(found["error"], name)
            elif max(own) > 0:
                known += 1
                self.assertAlmostEqual(found["error"] / (np.hypot(*own) / 2), 1.0, delta=1e-9)
        self.assertGreater(known, 3, "too short for any error")

    def test_speed_counts_all_disks(self):
        summary = read_summary(self.run_new("out", **THREE))
        rate = 64 * REPLICAS * summary["steps"] / summary["wall_seconds"]
        self.assertAlmostEqual(summary["disk_steps_per_second"] / rate, 1.0, delta=1e-6)

    def test_table_and_picture(self):
        out = self.folder / "out"
        result = self.run_scene(self.scene(**{**self.CHANGES, **THREE}, output__plot=True), out)
        self.assertRegex(result.stdout, r"3 replicas, seeds 5 to 7; errors: jackknife")
        if "no picture" not in result.stderr:
            self.assertEqual((out / "plot.png").read_bytes()[:4], b"\x89PNG")


class StateFiles(Replicas):
    FREE = {"disks__model": "CD", "disks__packing_fraction": 0.1, "start__kind": "state",
            "start__file": "start.h5", "disks__replicas": REPLICAS}

    def states(self, replicas=REPLICAS):
        """Lattices at rest, each moved by a little of its own."""
        state = lattice_state()
        for name in ("position", "velocity", "diameter"):
            state[name] = np.repeat(state[name][None], replicas, axis=0)
        state["position"] += 0.01 * np.arange(replicas)[:, None, None]
        return without_mean_motion(state, SCENE["shear"]["strain_rate"])

    def test_each_replica_starts_from_its_own(self):
        state = self.states()
        write_state(self.folder / "start.h5", state)
        final = read_state(self.run_new("out", **self.FREE))
        for name in ("velocity", "diameter"):
            self.assertTrue(same_bits(final[name], state[name]), name)
        away = final["position"] - state["position"] - 16.0 * state["velocity"]
        away[..., 0] -= state["box_length"] * np.rint(away[..., 0] / state["box_length"])
        self.assertLess(np.abs(away).max(), 1e-12)

    def test_replicas_go_on_from_their_last_states(self):
        self.run_new("first", **THREE)
        shutil.copy(self.folder / "first" / "state.h5", self.folder / "start.h5")
        changes = {"start__kind": "state", "start__file": "start.h5"}
        out = self.run_new("second", **THREE, **changes)
        state = read_state(self.folder / "start.h5")
        for r in range(REPLICAS):
            write_state(self.folder / "start.h5",
                        {k: v[r] if np.ndim(v) else v for k, v in state.items()})
            one = self.run_new(f"alone{r}", **changes)
            for name, value in read_series(one).items():
                self.assertTrue(same_bits(read_series(out)[name][r], value), name)

    def test_other_numbers_of_states_are_refused(self):
        write_state(self.folder / "start.h5", lattice_state())
        self.refused(self.scene(**self.FREE), "start.h5", "holds 1 state", "disks.replicas = 3")
        write_state(self.folder / "start.h5", self.states(2))
        self.refused(self.scene(**self.FREE), "holds 2 states", "disks.replicas = 3")
        self.refused(self.scene(**{**self.FREE, "disks__replicas": 1}), "holds 2 states",
                     "set disks.replicas = 2")

    def test_equal_states_are_refused(self):
        state = self.states()
        state["position"][2] = state["position"][1]
        write_state(self.folder / "start.h5", state)
        self.refused(self.scene(**self.FREE), "states 1 and 2", "the same")


class Refused(Replicas):
    def test_key(self):
        for value in (0, -1, 4097, 10**15):
            with self.subTest(value=value):
                self.refused(self.scene(disks__replicas=value), f"disks.replicas = {value}",
                             "at least 1", "4096")
        self.refused(self.scene(disks__replicas=2.5), "disks.replicas", "integer")
        self.refused(self.scene(disks__replicas="two"), "disks.replicas", "integer")

    def test_memory(self):
        self.refused(self.scene(disks__count=4_000_000, disks__replicas=4096), "memory",
                     "disks.replicas = 4096")

    def test_backend(self):
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(**THREE), "--out", out, "--backend", "openmp")
        self.assert_clean_error(result, 2, "--backend openmp", "disks.replicas = 3", "serial")
        self.assertFalse(out.exists())

    def test_validate_counts_all(self):
        one = self.bagnold("validate", self.scene(disks__count=1024)).stdout
        many = self.bagnold("validate", self.scene(disks__count=1024, disks__replicas=10)).stdout

        def number(text, pattern):
            return float(re.search(pattern, text)[1])

        million = r"([\d.]+) million disk-steps"
        self.assertAlmostEqual(number(many, million) / number(one, million), 10, delta=0.01)
        memory = r"memory +([\d.e+]+) MB"
        self.assertGreater(number(many, memory), number(one, memory))
        self.assertRegex(many, r"replicas +10, seeds 1 to 10")

    def test_a_failure_names_its_replica(self):
        state = lattice_state()
        for name in ("position", "velocity", "diameter"):
            state[name] = np.repeat(state[name][None], REPLICAS, axis=0)
        state["position"] += 0.001 * np.arange(REPLICAS)[:, None, None]
        state["position"][1, 1] = state["position"][1, 0] + [0.7, 0.0]
        write_state(self.folder / "start.h5", state)
        out = self.folder / "out"
        for threads in (1, 2):
            result = self.bagnold("run", self.scene(**{**StateFiles.FREE, "disks__seed": SEED}),
                                  "--out", out, "--force", "--threads", threads)
            self.assert_clean_error(result, 3, "replica 2", "seed 6", "step", "disk", "overlap")
            self.assertIn("failed_state.h5", result.stderr)
            failed = read_state(out / "failed_state.h5")
            self.assertEqual(failed["position"].shape, (64, 2))
            self.assertFalse((out / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
