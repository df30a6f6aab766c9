# SPDX-License-Identifier: BSD-3-Clause
"""scheme = "auto": the cheapest method whose measured bias is within integration.accuracy."""

import json
import math
import re
import unittest

import h5py
import numpy
from bagnold import CliTest, Raw, discarded_windows, read_series, read_summary

# A place where the method may change is a strain of 0.03; a step of two stages is 0.2.
DENSE = {"disks__count": 256, "disks__model": "CD", "disks__packing_fraction": 0.82, "shear__strain_rate": 1e-4,
         "shear__strain": 2.0, "integration__scheme": "auto", "integration__time_step": "auto", "measure__every": 10,
         "output__sample_strain": 0.01}
DILUTE = {**DENSE, "disks__model": "CD_rot", "disks__packing_fraction": 0.6, "shear__strain_rate": 1e-3,
          "shear__strain": 4.0}
IMPLICIT = {"scheme": "implicit-damping", "time_step": 1.6}
TWO_STAGES = {"scheme": "two-stage-leapfrog", "time_step": 0.2}


def counters(out):
    with h5py.File(out / "result.h5") as file:
        return {name.removeprefix("engine_"): value.tolist() for name, value in file.attrs.items() if name.startswith("engine_")}


class Choice(CliTest):
    def assert_same(self, one, two):
        self.assert_same_results(one, two)
        self.assertEqual(read_summary(one)["bias"], read_summary(two)["bias"])
        self.assertEqual(str(counters(one)), str(counters(two)))  # "nan" of a replica whose engine has no such counter
        first, second = read_series(one), read_series(two)
        for name, values in first.items():
            self.assertEqual(values.tobytes(), second[name].tobytes(), name)


class Chosen(Choice):
    def test_newtonian_flow(self):
        """Implicit damping after the first four pairs; means are those of two stages within errors."""
        out = self.run_new("out", **{**DENSE, "shear__strain": 16.0})
        found = read_summary(out)
        self.assertEqual(found["bias"]["method"], IMPLICIT)
        self.assertEqual(found["bias"]["verdict"], "accepted")
        self.assertEqual(found["bias"]["finer"], TWO_STAGES)
        self.assertNotIn("tried", found["bias"])
        steps = counters(out)["steps_by_implicit_damping"]
        self.assertEqual(steps % 504, 0)  # windows of whole steps
        self.assertGreater(steps, 0.5 * found["steps"])
        self.assertEqual(found["scene"]["integration"]["scheme"], "auto")
        self.assertIn("bias", found["observables"]["p"])
        two = read_summary(self.run_new("two", **{**DENSE, "shear__strain": 16.0, "integration__scheme": "two-stage-leapfrog"}))
        for name in ("p", "sigma", "Z"):
            one, other = found["observables"][name], two["observables"][name]
            self.assertLess(abs(one["mean"] - other["mean"]), 5 * math.hypot(one["error"], other["error"]), name)

    def test_gas(self):
        """Two stages all along, without a pair, and with the bits of a run that names them but for lookaheads."""
        found = read_summary(self.run_new("out", **DILUTE))
        self.assertEqual(found["bias"]["verdict"], "usual")
        self.assertEqual(found["bias"]["method"], TWO_STAGES)
        self.assertEqual((found["bias"]["steps"], found["bias"]["pairs"]), (0, 0))
        self.assertEqual([one["reason"] for one in found["bias"]["tried"]], ["inertia"])
        self.assertNotIn("bias", found["observables"]["p"])
        self.assertNotIn("method_bias", [one["name"] for one in found["warnings"]])

    def test_smaller_accuracy(self):
        """Asked for more than the usual method was seen to hold: it is judged too."""
        found = read_summary(self.run_new("out", **{
            **DILUTE, "integration__accuracy": 0.002, "shear__strain": 3.0, "integration__engine": "steps"}))["bias"]
        self.assertEqual(found["accuracy"], 0.002)
        self.assertNotEqual(found["verdict"], "usual")
        judged = [found, *found["tried"]]
        self.assertGreater(sum(one["pairs"] for one in judged if one["method"] == TWO_STAGES), 0)
        self.assertEqual(found["finer"]["time_step"], found["method"]["time_step"] / 4)

    def test_accuracy_that_nothing_looks_at(self):
        """Refused, with the reason, where it would be held by chance alone."""
        for change, reason in (({"measure__contacts": True}, "measure.contacts"), ({"drive__kind": "stokes", "drive__drag": 0.01}, "a drive"),
                               ({"integration__scheme": "two-stage-leapfrog"}, "named"), ({"integration__time_step": 0.4}, "named")):
            with self.subTest(**change):
                scene = {**DENSE, "disks__count": 1024, "integration__accuracy": 0.002, **change}
                self.refused(self.scene(**scene), "integration.accuracy = 0.002 (nothing looks at it", reason, "measure.bias = true")
                self.assertEqual(self.bagnold("validate", self.scene(**{**scene, "measure__bias": True})).returncode, 0)
                self.assertEqual(self.bagnold("validate", self.scene(**{**scene, "integration__accuracy": 0.01})).returncode, 0)

    def test_refused_later(self):
        """On the edge of inertia a method that was taken is left: windows before that are in no average."""
        changes = {**DENSE, "disks__elasticity": 2.0, "disks__count": 72, "shear__strain_rate": 1e-3, "shear__strain": 7.0,
                   "measure__fields": True, "measure__frame_strain": 0.12}
        for seed in range(1, 31):
            out = self.folder / f"seed{seed}"
            said = self.run_scene(self.scene(**{**changes, "disks__seed": seed}), out).stdout
            found = read_summary(out)["bias"]
            left = re.search(r"strain ([\d.]+): implicit.*what was before is left out", said)
            self.assertEqual(found["dropped_strain"] > 0, left is not None)
            if not left or float(left[1]) > 5.0:  # too late for frames
                continue
            self.assertIn("left: implicit-damping, a step of", said)
            self.assertGreater(counters(out)["steps_by_implicit_damping"], 0)
            self.assertAlmostEqual(found["dropped_strain"], float(left[1]), delta=1e-3 * float(left[1]))
            strain = read_series(out)["strain"]
            windows, window = len(strain), strain[1] - strain[0]
            dropped = round(found["dropped_strain"] / window)
            discarded = discarded_windows(out)
            self.assertEqual(discarded, dropped + math.ceil((windows - dropped) / 2))
            frames = math.floor(windows * window / 0.12 + 1e-6) - math.ceil(discarded * window / 0.12 - 1e-6) + 1
            with h5py.File(out / "result.h5") as file:
                found = file["histograms/local_phi"]
                counts = found["density"][...] * numpy.diff(found["edges"][...]) * 72 * frames
            self.assertEqual(round(counts.sum()), 72 * frames)
            self.assertLess(abs(counts - counts.round()).max(), 1e-6, "of these frames and no others")
            return
        self.fail("no seed leaves a method")

    def test_windows_weigh_the_same(self):
        """A window of two stages has 17 evaluations here, one of implicit damping 3 of its own."""
        changes = {**DENSE, "shear__strain_rate": 3e-4, "shear__strain": 1.0, "shear__discard": 0}
        out = self.run_new("out", **changes)
        self.assertEqual(read_summary(out)["bias"]["method"], IMPLICIT)
        self.assertLess(counters(out)["steps_by_implicit_damping"], read_summary(out)["steps"])
        p = read_series(out)["p"][discarded_windows(out):]
        self.assertAlmostEqual(read_summary(out)["observables"]["p"]["mean"] / p.mean(), 1, delta=1e-9)

    def test_cascade(self):
        out = self.run_new("out", **{**DENSE, "shear__protocol": "cascade", "shear__strain_rate": None,
                                     "shear__strain_rates": Raw("[1e-3, 1e-4]"), "shear__strain": 1.0})
        stages = sorted(path for path in out.iterdir() if path.is_dir())
        self.assertEqual(read_summary(stages[1])["bias"]["method"], IMPLICIT)


class Framed(Choice):
    def test_frames(self):
        """At whole steps of all methods: as far apart with one method as with the other."""
        out = self.run_new("out", **{**DENSE, "disks__model": "CD_rot", "output__trajectory_strain": 0.0321})
        self.assertEqual(read_summary(out)["bias"]["method"]["scheme"], "implicit-damping")
        with h5py.File(out / "trajectory.h5md") as file:
            steps = file["particles/trajectory/position/step"][...]
        self.assertEqual(set((steps[1:] - steps[:-1]).tolist()), {1611})  # 0.0321/2e-5 = 1605, made up to whole ones of 9


class Continued(Choice):
    def test_killed_and_resumed(self):
        changes = {**DENSE, "disks__count": 512, "shear__strain": 4.0, "output__checkpoint_minutes": 0.0003,
                   "measure__fields": True, "measure__frame_strain": 0.1}
        whole = self.run_new("whole", **changes)
        self.assertEqual(read_summary(whole)["bias"]["method"], IMPLICIT)
        out = self.folder / "out"
        kills = self.kill_and_resume(self.scene(**changes), out, 8)
        self.assertGreater(kills, 2)
        self.assert_same(whole, out)

    def test_made_longer(self):
        """Lengths before, at and after the place of the change; inside stretches and at their ends."""
        whole = self.run_new("whole", **{**DENSE, "shear__strain": 1.5})
        self.assertEqual(read_summary(whole)["bias"]["method"], IMPLICIT)
        for short in (0.09, 0.12, 0.1321, 0.15, 0.1621):
            with self.subTest(short=short):
                out = self.run_new(f"short{short}", **{**DENSE, "shear__strain": short})
                self.assertEqual(self.bagnold("resume", out, "--strain", 1.5).returncode, 0)
                self.assert_same(whole, out)

    def test_target_error(self):
        changes = {**DENSE, "shear__target_error": Raw("{ p = 0.5 }"), "output__sample_strain": 0.005}
        out = self.run_new("short", **{**changes, "shear__strain": 0.13})
        self.assertEqual(self.bagnold("resume", out, "--strain", 1.5).returncode, 0)
        self.assert_same(self.run_new("whole", **{**changes, "shear__strain": 1.5}), out)

    def test_replicas(self):
        """One verdict, on any number of threads, after two rounds of three: from the start none feels inertia."""
        changes = {**DENSE, "disks__replicas": 3, "shear__strain_rate": 3e-5, "shear__strain": 1.0}
        first = self.run_new("one", "--threads", 1, **changes)
        found = read_summary(first)["bias"]
        self.assertEqual(found["method"], IMPLICIT)
        self.assertEqual(found["looks"][0]["pairs"] % 3, 0)
        for threads in (2, 3):
            self.assert_same(first, self.run_new(f"threads{threads}", "--threads", threads, **changes))


class Creeping(Choice):
    """Quasi-static steps, beside which the run steps by implicit damping while they are on trial."""

    # Of eight seeds all are accepted. With 24 disks and 1% none was, after 52 short pairs.
    CREEP = {**DENSE, "shear__strain_rate": 2e-6, "shear__strain": 1.0, "integration__accuracy": 0.03,
             "output__checkpoint_minutes": 0.0003}
    TOO_FEW = {**CREEP, "disks__count": 24, "integration__accuracy": 0.01}

    def test_taken(self):
        out = self.folder / "out"
        said = self.run_scene(self.scene(**self.CREEP), out).stdout
        self.assertIn("beside it implicit-damping, a step of 1.6 tau_e", said)
        found = read_summary(out)
        self.assertEqual(found["bias"]["method"], {"scheme": "backward-euler", "time_step": 99.2})
        self.assertEqual(found["bias"]["finer"], IMPLICIT)
        self.assertEqual(found["bias"]["dropped_strain"], 0)
        steps = counters(out)
        self.assertGreater(steps["steps_by_quasi_static"], 0.4 * found["steps"])
        self.assertGreater(steps["steps_by_implicit_damping"], 0)
        self.assertLess(steps["steps_by_quasi_static"] + steps["steps_by_implicit_damping"], found["steps"])
        by_name = read_summary(self.run_new("implicit", **{**self.CREEP, "integration__scheme": "implicit-damping"}))
        for name in ("p", "sigma", "Z"):
            one, other = found["observables"][name], by_name["observables"][name]
            self.assertLess(abs(one["mean"] / other["mean"] - 1), 0.5, name)  # of one system, a strain of 0.5

    def test_given_up(self):
        """Implicit damping, by which the run stepped beside them, is next on trial; what was before is dropped."""
        out, given_up = self.folder / "out", "backward-euler, a step of 99.2 tau_e, is open"
        for seed in (1, 2, 3, 4):  # bits differ between processors; of eight seeds seven here are as asked
            scene = self.scene(**{**self.TOO_FEW, "disks__seed": seed})
            said = self.run_scene(scene, out, "--force").stdout
            found = read_summary(out)["bias"]
            if given_up in said and found["verdict"] == "accepted":
                break
        self.assertIn(given_up, said)
        self.assertEqual((found["method"], found["finer"]), (IMPLICIT, TWO_STAGES))
        self.assertEqual(found["verdict"], "accepted")
        places = found["dropped_strain"] / found["stretch_strain"]  # 52 pairs, the first at one of these
        self.assertIn(round(places, 3) - 52, (1, 2, 4), "twice as far where inertia has a part")

    def test_goes_on(self):
        """Killed, or made longer from lengths on and off the trial, it has the bits of one run."""
        whole = self.run_new("whole", **self.CREEP)
        out = self.folder / "out"
        kills = self.kill_and_resume(self.scene(**self.CREEP), out, 6)
        self.assertGreater(kills, 2)
        self.assert_same(whole, out)
        for short in (0.04, 0.08, 0.1321, 0.2):
            with self.subTest(short=short):
                out = self.run_new(f"short{short}", **{**self.CREEP, "shear__strain": short})
                self.assertEqual(self.bagnold("resume", out, "--strain", 1.0).returncode, 0)
                self.assert_same(whole, out)

    def test_replicas(self):
        changes = {**self.CREEP, "disks__replicas": 3, "shear__strain": 0.5}
        first = self.run_new("one", "--threads", 1, **changes)
        self.assertIn("backward-euler", json.dumps(read_summary(first)["bias"]))
        self.assert_same(first, self.run_new("two", "--threads", 2, **changes))


class Said(Choice):
    def test_on_the_screen(self):
        text = self.run_scene(self.scene(**DENSE), self.folder / "out").stdout
        self.assertRegex(text, r"strain 0\.15\d*: implicit-damping, a step of 1\.6 tau_e, is accepted after 4 pairs of "
                               r"stretches \(p [+-]\d.*\); taken from here on")
        self.assertIn("method: implicit-damping, a step of 1.6 tau_e", text)
        text = self.run_scene(self.scene(**DILUTE), self.folder / "gas").stdout
        self.assertIn("not taken: implicit-damping, a step of 1.8 tau_e: inertia (p_kin/p above 0.0001)", text)

    def test_measures_the_bias_of_all(self):
        """measure.bias with scheme = "auto" judges the usual method too."""
        found = read_summary(self.run_new("out", **{**DILUTE, "shear__strain": 6.0, "measure__bias": True,
                                                    "integration__engine": "steps"}))
        self.assertNotEqual(found["bias"]["verdict"], "usual")
        self.assertIn("bias", found["observables"]["p"])


if __name__ == "__main__":
    unittest.main()
