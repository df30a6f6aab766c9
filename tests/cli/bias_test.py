# SPDX-License-Identifier: BSD-3-Clause
"""measure.bias: pairs of stretches beside a run, from the scene to the tables."""

import csv
import json
import math
import os
import subprocess
import sys
import unittest

import h5py
import numpy as np

from bagnold import SOURCE, CliTest, Raw, read_series, read_state, read_summary, write_state

# Steps of a strain of 2^-12: a stretch is 3 times 41 of them, the grid 1229.
DENSE = {"disks__count": 64, "disks__model": "CD", "disks__packing_fraction": 0.82,
         "shear__strain_rate": 2.0**-10, "shear__strain": 2.0, "integration__time_step": 0.25,
         "measure__every": 10, "output__sample_strain": 2.0**-6}
DILUTE = {**DENSE, "disks__model": "CD_n", "disks__packing_fraction": 0.4, "disks__count": 256}
EVENTS = {**DILUTE, "integration__time_step": "auto"}  # by turns with steps
ASKED = {"measure__bias": True}
STEP, THIRD, GRID = 2.0**-12, 41, 1229
NAMES = ("p", "sigma", "Z", "T_g")


def pairs_in(out):
    """Rows of step, six averages of the coarse stretch, six of the fine one."""
    with h5py.File(out / "checkpoint.h5") as file:
        return file["events/bias_pairs"][:].reshape(-1, 13)


class Bias(CliTest):
    def assert_same_flow(self, one, two):
        """State and series, bit for bit."""
        self.assert_same_state(one, two)
        first, second = read_series(one), read_series(two)
        for name, values in first.items():
            self.assertEqual(values.tobytes(), second[name].tobytes(), name)

    def counters(self, out):
        with h5py.File(out / "result.h5") as file:
            return {name: value for name, value in file.attrs.items() if name.startswith("engine_")}


class BesideTheRun(Bias):
    def test_the_flow_is_the_same(self):
        """Bits and counters of the run itself, dense and dilute, with and without."""
        for name, where in {"dense": DENSE, "dilute": DILUTE,
                            "by turns": EVENTS, "implicit": {**DENSE, "integration__scheme": "implicit-damping",
                                         "integration__time_step": 1.5}}.items():
            with self.subTest(where=name):
                plain = self.run_new(f"{name}-plain", **where)
                asked = self.run_new(f"{name}-asked", **where, **ASKED)
                self.assert_same_flow(plain, asked)
                self.assertEqual(self.counters(plain), self.counters(asked))
                self.assertNotIn("bias", read_summary(plain))
                self.assertEqual(read_summary(asked)["bias"]["pairs"] > 3, True)
                with h5py.File(plain / "checkpoint.h5") as file:
                    self.assertNotIn("events/bias_pairs", file)

    def test_a_pair_is_two_runs(self):
        """The first pair against runs by hand from the state at its step, looked at at the same instants."""
        asked = self.run_new("asked", **DENSE, **ASKED)
        pair = pairs_in(asked)[0]
        self.assertEqual(pair[0], GRID)
        start = self.run_new("start", **{**DENSE, "shear__strain": GRID * STEP})
        # velocities lie half a step before the positions: for a quarter of the step 3/8 nearer to those of the next step
        next_one = self.run_new("next", **{**DENSE, "start__kind": "state", "start__file": str(start / "state.h5"),
                                           "start__rescale": False, "shear__strain": STEP, "shear__discard": 0.0,
                                           "output__sample_strain": STEP, "measure__every": 1})
        state, then = read_state(start), read_state(next_one)
        rows = np.rint((state["position"][:, 1] + 0.25 * then["velocity"][:, 1] - then["position"][:, 1]) / state["box_length"])
        later = then["velocity"] + np.outer(rows * 2.0**-10 * state["box_length"], [1, 0])
        write_state(self.folder / "handed.h5", {**state, "velocity": state["velocity"] + 0.375 * (later - state["velocity"])})
        for fraction, file, found in ((1, start / "state.h5", pair[1:7]), (4, self.folder / "handed.h5", pair[7:])):
            series = read_series(self.run_new(f"by{fraction}", **{
                **DENSE, "start__kind": "state", "start__file": str(file), "start__rescale": False,
                "shear__strain": 3 * THIRD * STEP, "output__sample_strain": THIRD * STEP, "measure__every": fraction,
                "integration__time_step": 0.25 / fraction}))
            expected = [series[name][1:].mean() for name in (*NAMES, "p_kin")] + [series["T_g"][0]]
            np.testing.assert_allclose(found, expected, rtol=1e-7)

    def test_a_gas_at_a_large_rate(self):
        """Stretches of a few contacts: T_g of the finer one is not off at its begin, as if the default were wrong."""
        out = self.run_new("gas", **{**DILUTE, "disks__packing_fraction": 0.78, "disks__elasticity": 50.0, "disks__mass": "equal",
                                     "shear__strain_rate": 3e-3, "shear__strain": 60.0, "integration__engine": "steps",
                                     "integration__time_step": 0.2, "output__sample_strain": None, **ASKED})
        summary = read_summary(out)
        self.assertNotEqual(summary["bias"]["verdict"], "refused")
        self.assertLess(abs(summary["observables"]["p"]["bias"]), 0.03 * summary["observables"]["p"]["mean"])

    def test_stated_numbers(self):
        """Ratio of sums and Student's errors of the pairs in the checkpoint, by NumPy."""
        out = self.run_new("out", **DENSE, **ASKED)
        pairs, found = pairs_in(out), read_summary(out)
        self.assertEqual(found["bias"]["pairs"], len(pairs))
        self.assertEqual(found["bias"]["steps"], 3 * THIRD * len(pairs))
        self.assertEqual(found["bias"]["finer_steps"], 4 * 3 * THIRD * len(pairs))
        self.assertFalse(found["bias"]["gas"])
        for k, name in enumerate(NAMES):
            coarse, fine = pairs[:, 1 + k], pairs[:, 7 + k]
            b = coarse.sum() / fine.sum() - 1
            rest = (coarse - (1 + b) * fine) / fine.mean()
            error = math.hypot(math.sqrt((rest**2).sum() / len(pairs) / (len(pairs) - 1)), 2e-4)
            one, all_of = found["bias"]["relative"][name], found["observables"][name]
            self.assertAlmostEqual(one["bias"], b, delta=1e-12)
            self.assertGreater(one["error"], math.hypot(error, b / 2))
            self.assertLess(one["error"], 1.66 * math.hypot(error, b / 2))  # Student's factor of four
            self.assertAlmostEqual(all_of["bias"], b * all_of["mean"], delta=1e-9 * abs(all_of["mean"]))
            self.assertAlmostEqual(all_of["bias_error"], one["error"] * abs(all_of["mean"]),
                                   delta=1e-9 * abs(all_of["mean"]))
        for name in ("B_p", "eta_p"):
            scaled = found["observables"][name]
            self.assertAlmostEqual(scaled["bias"] / scaled["mean"], found["bias"]["relative"]["p"]["bias"])
        self.assertNotIn("bias", found["observables"]["R_v"])

    def test_a_coarse_step_is_refused(self):
        """Of a collision that loses far too much, in a gas; and the default is not."""
        gas = {**DILUTE, "disks__elasticity": 50.0, "disks__packing_fraction": 0.6, "shear__strain": 4.0}
        found = read_summary(self.run_new("coarse", **{**gas, "integration__time_step": 0.8}, **ASKED))
        self.assertEqual(found["bias"]["verdict"], "refused")
        self.assertTrue(found["bias"]["gas"])
        warning = [one for one in found["warnings"] if one["name"] == "method_bias"]
        self.assertEqual(len(warning), 1)
        self.assertIn("beyond integration.accuracy = 0.01", warning[0]["reason"])
        self.assertIn("time_step=0.4", warning[0]["command"])


class Continued(Bias):
    def assert_same(self, one, two):
        self.assert_same_results(one, two)
        self.assertEqual(read_summary(one)["bias"], read_summary(two)["bias"])
        self.assertEqual(pairs_in(one).tobytes(), pairs_in(two).tobytes())

    def test_killed_and_resumed(self):
        changes = {**DENSE, "disks__count": 256, "shear__strain": 8.0, "output__checkpoint_minutes": 0.0003, **ASKED}
        whole = self.run_new("whole", **changes)
        out = self.folder / "out"
        kills = self.kill_and_resume(self.scene(**changes), out, 6)
        self.assertGreater(kills, 2)
        self.assert_same(whole, out)

    def test_made_longer(self):
        """Lengths at which a pair is due, and at which no engine would stop; places of pairs stay."""
        for name, where in {"dense": DENSE, "dilute": DILUTE, "by turns": EVENTS}.items():
            for short in (GRID * 2 * STEP, 1.0005):
                with self.subTest(where=name, short=short):
                    changes = {**where, **ASKED}
                    out = self.run_new(f"{name}{short}", **{**changes, "shear__strain": short})
                    begun = pairs_in(out)
                    self.assertEqual(self.bagnold("resume", out, "--strain", 2.2).returncode, 0)
                    whole = self.run_new(f"{name}{short}whole", **{**changes, "shear__strain": 2.2})
                    self.assert_same(whole, out)
                    self.assertEqual(pairs_in(out)[:len(begun)].tobytes(), begun.tobytes())

    def test_made_longer_with_a_target(self):
        """Its looks end legs between pairs."""
        changes = {**DENSE, "output__sample_strain": 2.0**-8, **ASKED}
        for target in ("1e-9", "0.5"):
            more = {**changes, "shear__target_error": Raw(f"{{ p = {target} }}")}
            out = self.run_new(f"short{target}", **{**more, "shear__strain": 1.0005})
            self.assertEqual(self.bagnold("resume", out, "--strain", 1.9).returncode, 0)
            self.assert_same(self.run_new(f"whole{target}", **{**more, "shear__strain": 1.9}), out)

    def test_replicas_far_ahead(self):
        """Lookaheads longer than the grid: nobody waits for a pair that never comes."""
        changes = {**DILUTE, "disks__packing_fraction": 0.05, "disks__replicas": 3, "shear__strain_rate": 2.0**-7,
                   "integration__engine": "lookahead", "shear__strain": 5.0, **ASKED}
        first = self.run_new("one", "--threads", 1, **changes)
        self.assert_same_results(first, self.run_new("three", "--threads", 3, **changes))
        self.assertGreater(read_summary(first)["bias"]["pairs"], 0)

    def test_replicas(self):
        """One sum and one verdict, on any number of threads."""
        changes = {**DENSE, "disks__replicas": 3, **ASKED}
        first = self.run_new("one", "--threads", 1, **changes)
        found = read_summary(first)["bias"]
        self.assertEqual(found["pairs"] % 3, 0)
        self.assertGreaterEqual(found["pairs"], 6)
        for threads in (2, 3):
            other = self.run_new(f"threads{threads}", "--threads", threads, **changes)
            self.assert_same_results(first, other)
            self.assertEqual(found, read_summary(other)["bias"])
        plain = self.run_new("plain", **{**changes, "measure__bias": False})
        self.assert_same_flow(plain, first)


class Said(Bias):
    def test_refused_scenes(self):
        for words, changes in (
                (('integration.engine = "events"',), {**DILUTE, "integration__engine": "events",
                                                      "integration__time_step": "auto"}),
                (('integration.engine = "quasi-static"',), {**DENSE, "integration__engine": "quasi-static",
                                                            "integration__time_step": "auto"}),
                (('drive.kind = "thermal"',), {**DENSE, "drive__kind": "thermal", "drive__drag": 0.1,
                                               "drive__temperature": 1e-6})):
            with self.subTest(words=words):
                self.refused(self.scene(**changes, **ASKED), "measure.bias", *words)
        self.refused(self.scene(**DENSE, integration__accuracy=0.0), "integration.accuracy")

    def test_on_the_screen(self):
        text = self.run_scene(self.scene(**DENSE, **ASKED), self.folder / "out").stdout
        self.assertRegex(text, r"\np +0.00\d+( \(no error\)|\(\d+\)), method [+-]\d\.\d+\(\d+\)% ")
        self.assertRegex(text, r"bias of the method: \w+ within 1% after \d+ pairs of stretches")

    def test_short_run(self):
        """Too short for a verdict: said so, with a longer run as the remedy."""
        found = read_summary(self.run_new("out", **{**DENSE, "shear__strain": 1.0}, **ASKED))
        self.assertEqual(found["bias"]["verdict"], "none")
        warning = [one for one in found["warnings"] if one["name"] == "method_bias"][0]
        self.assertIn("do not tell", warning["reason"])
        self.assertIn("resume DIR --strain", warning["command"])

    def test_tables_and_python(self):
        sweep = self.folder / "sweep.toml"
        sweep.write_text(self.scene(**{**DENSE, "shear__strain": 16.0}).read_text()
                         + '[sweep]\ngrid = { "measure.bias" = [true, false] }\n')
        out = self.folder / "sweep"
        result = self.bagnold("sweep", sweep, "--out", out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(out / "sweep.csv") as file:
            rows = list(csv.DictReader(file))
        stated = [row for row in rows if row["p_bias"]]
        self.assertEqual(len(stated), 1)
        code = """if True:
            import sys, json, bagnold
            s = bagnold.sweep(sys.argv[1])
            r = bagnold.load(s[0].folder)
            print(json.dumps([list(s["p_bias"]), list(s.bias("p")), "p_bias" in s.names, list(s.error("p_bias")),
                              r["p"].bias, r["p"].bias_error, r["p"].error, r["p"].total_error, str(r["p"])]))"""
        done = subprocess.run([sys.executable, "-c", code, str(out)], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
        self.assertEqual(done.returncode, 0, done.stderr)
        column, same, named, errors, bias, bias_error, error, total, text = json.loads(done.stdout)
        p = json.loads((out / "points" / rows[0]["folder"] / "summary.json").read_text())["observables"]["p"]
        self.assertEqual(float(rows[0]["p_bias"]), p["bias"])
        self.assertEqual(column[0], p["bias"])
        self.assertTrue(math.isnan(column[1]))
        self.assertEqual(errors[0], p["bias_error"])
        self.assertFalse(named)
        self.assertEqual((bias, bias_error), (p["bias"], p["bias_error"]))
        self.assertAlmostEqual(total, math.sqrt(error**2 + bias**2 + bias_error**2))
        self.assertIn(", method ", text)


if __name__ == "__main__":
    unittest.main()
