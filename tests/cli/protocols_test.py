# SPDX-License-Identifier: BSD-3-Clause
"""Cascades, ramps, automatic steady states and target errors, from scene to files."""

import os
import random
import re
import shlex
import shutil
import signal
import time
import unittest

import h5py
import numpy as np

from bagnold import (STEP_STRAIN, CliTest, Raw, discarded_windows, lattice_state, read_series, read_state, read_summary,
                     same_bits, write_state)
from sweeps import SweepTest, rows

RATES = [2.0**-5, 2.0**-6, 2.0**-7]
STAGES = ["0001_strain_rate=0.03125", "0002_strain_rate=0.015625", "0003_strain_rate=0.0078125"]
CASCADE = {"shear__protocol": "cascade", "shear__strain_rate": None, "shear__strain_rates": Raw(str(RATES))}
RAMP = {  # 16 steps a tau_e, pieces of 1 tau_e, windows of 8
    "shear__protocol": "ramp", "shear__discard": None, "output__sample_strain": None,
    "shear__strain_rate": 2.0**-11, "shear__strain_rate_high": 2.0**-7, "shear__ramp_rate": 0.01,
    "shear__ramp_window": 8.0, "shear__strain": 2.0**-5, "shear__cycles": 2}
OFTEN = {"output__checkpoint_minutes": 0.0003}


class ProtocolTest(CliTest):
    def undisturbed(self, path):
        """A run and its duration."""
        whole = self.folder / "whole"
        started = time.monotonic()
        self.run_scene(path, whole, "--quiet")
        return whole, time.monotonic() - started

    def kill_and_resume(self, path, name, moments, seconds, number=signal.SIGKILL):
        """A run of so many seconds ended at random moments and resumed, as often as `moments` says."""
        chance = random.Random(os.urandom(4))
        out, ended = self.folder / name, 0
        command = ["run", str(path), "--out", str(out), "--quiet"]
        for _ in range(moments):
            process = self.start(*command)
            self.wait_until((out / "scene.toml").exists, process)
            time.sleep(chance.uniform(0.0, 0.8 * seconds / moments))
            process.send_signal(number)
            status, output = self.finish(process)
            self.assertIn(status, (-number, 128 + number, 0), output)
            ended += status != 0
            command = ["resume", str(out), "--quiet"]
        result = self.bagnold("resume", out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreaterEqual(ended, 1, "the run was over too soon to be ended")
        return out


class Cascade(ProtocolTest):
    def test_each_rate_is_the_run_by_hand_from_the_state_before(self):
        for replicas in (1, 2):
            with self.subTest(replicas=replicas):
                out = self.run_new(f"cascade{replicas}", disks__replicas=replicas,
                                   shear__strain=Raw("[0.25, 0.125, 0.125]"),
                                   **CASCADE)
                state = {}
                for rate, strain, stage in zip(RATES, (0.25, 0.125, 0.125), STAGES):
                    by_hand = self.run_new(f"{replicas}{stage}", disks__replicas=replicas,
                                           shear__strain_rate=rate, shear__strain=strain, **state)
                    self.assert_same_state(by_hand, out / stage)
                    one, two = read_series(by_hand), read_series(out / stage)
                    for series in one:
                        self.assertTrue(same_bits(one[series], two[series]), series)
                    state = {"start__kind": "state", "start__file": str(by_hand / "state.h5")}
                with h5py.File(out / STAGES[1] / "result.h5") as file:
                    np.testing.assert_array_equal(file.attrs["start_velocity_scale"], 0.5)
                summary = read_summary(out)
                self.assertEqual([p["folder"] for p in summary["points"]], STAGES)
                for point, rate in zip(summary["points"], RATES):
                    self.assertEqual(point["strain_rate"], rate)
                    self.assertEqual(point["observables"],
                                     read_summary(out / point["folder"])["observables"])
                self.assertIn("finished", self.bagnold("resume", out).stdout)

    def test_kills_change_no_bit(self):
        # 0.7: nearer to jamming overlaps come to 20% at the largest rate, where runs stop
        path = self.scene(shear__strain=16.0, disks__packing_fraction=0.7, **CASCADE, **OFTEN)
        whole, seconds = self.undisturbed(path)
        for number, moments in ((signal.SIGKILL, 6), (signal.SIGTERM, 3)):
            out = self.kill_and_resume(path, f"ended{number}", moments, seconds, number=number)
            for stage in STAGES:
                self.assert_same_state(whole / stage, out / stage)
                one, two = read_series(whole / stage), read_series(out / stage)
                for name in one:
                    self.assertTrue(same_bits(one[name], two[name]), name)
            self.assertEqual(read_summary(whole), read_summary(out))

    def test_stopped_in_a_rate_it_names_its_own_folder(self):
        out = self.folder / "out"
        path = self.scene(shear__strain=2.0**20, output__sample_strain=2.0**10, disks__packing_fraction=0.7, **CASCADE, **OFTEN)
        process = self.start("run", path, "--out", out)
        self.wait_until((out / STAGES[0] / "checkpoint.h5").exists, process)
        process.send_signal(signal.SIGTERM)
        code, said = self.finish(process)
        self.assertEqual(code, 143, said)
        self.assertIn(f"`bagnold resume {out}` goes on", said)

    def test_killed_between_two_stages(self):
        whole = self.run_new("whole", **CASCADE)
        for gone in (["summary.json"], ["summary.json", STAGES[2]],
                     ["summary.json", STAGES[2], f"{STAGES[1]}/summary.json"]):
            out = self.folder / f"without{len(gone)}"
            shutil.copytree(whole, out)
            for name in gone:
                shutil.rmtree(out / name) if (out / name).is_dir() else (out / name).unlink()
            self.assertEqual(self.bagnold("resume", out, "--quiet").returncode, 0)
            self.assertEqual(read_summary(whole), read_summary(out))
            for stage in STAGES:
                self.assert_same_state(whole / stage, out / stage)

    def test_force_removes_the_stages(self):
        path = self.scene(**CASCADE)
        out = self.folder / "out"
        self.run_scene(path, out, "--quiet")
        short = self.scene(**{**CASCADE, "shear__strain_rates": Raw("[0.03125]")})
        self.assert_clean_error(self.bagnold("run", short, "--out", out), 2, "--force")
        self.run_scene(short, out, "--quiet", "--force")
        self.assertEqual(sorted(p.name for p in out.iterdir() if p.is_dir()), STAGES[:1])

    def test_validate_shows_every_rate(self):
        said = self.bagnold("validate", self.scene(**CASCADE)).stdout
        for rate in RATES:
            self.assertIn(f"# strain rate    {rate:g}", said)
        self.assertIn("# all 3 rates", said)
        self.refused(self.scene(**{**CASCADE, "shear__strain_rates": Raw("[1e-3, 1e-2]")}), "largest first")


class SweepOfCascades(SweepTest):
    def test_has_a_row_for_each_rate(self):
        path = self.sweep_file(grid={"disks.seed": [1, 2]}, **CASCADE)
        out = self.folder / "out"
        self.sweep(path, out, "--quiet")
        table = rows(out)
        self.assertEqual([(r["disks.seed"], float(r["shear.strain_rate"])) for r in table],
                         [(seed, rate) for seed in "12" for rate in RATES])
        alone = self.run_new("alone", disks__seed=2, **CASCADE)
        for stage, point in zip(STAGES, self.points(out)[3:]):
            self.assert_same_state(alone / stage, point)
        for row, point in zip(table[3:], read_summary(alone)["points"]):
            self.assertEqual(float(row["B_p"]), point["observables"]["B_p"]["mean"])

    def test_refusals(self):
        out = self.folder / "out"
        for changes, words in (
                ({"grid": {"disks.seed": [1]}, "chain": "disks.seed", **CASCADE}, ["sweep.chain does not go"]),
                ({"grid": {"disks.packing_fraction": [0.8, 1.2]}, **CASCADE}, ["point 2 of 2"])):
            result = self.bagnold("sweep", self.sweep_file(**changes), "--out", out)
            self.assert_clean_error(result, 2, *words)


class Ramp(ProtocolTest):
    def test_disks_that_hardly_meet_are_warned_of(self):
        """A ramp has no average Z: its windows tell."""
        ramp = {"disks__count": 16, "disks__elasticity": 0.5, "disks__model": "CD_n", "disks__seed": 1, "shear__protocol": "ramp",
                "shear__strain_rate": 1e-4, "shear__strain_rate_high": 1e-3, "shear__ramp_rate": 1e-4,
                "shear__ramp_window": 1000, "shear__strain": 0.2, "shear__discard": None, "integration__time_step": None, "measure__every": None,
                "output__sample_strain": None}
        for packing_fraction, few in ((0.05, True), (0.8, False)):
            out = self.run_new(f"out{packing_fraction}", disks__packing_fraction=packing_fraction, **ramp)
            names = [one["name"] for one in read_summary(out)["warnings"]]
            self.assertEqual("few_collisions" in names, few, names)

    def expected_rates(self):
        """Mean rates of the windows: P2 Eq. 38 in pieces of tau_e, from the scene alone."""
        leg = int(np.ceil(4 * np.log10(2) / 0.01 / 8)) * 8  # pieces, whole windows
        up = 2.0**-11 * 10 ** (0.01 * np.arange(leg))
        way = up.reshape(-1, 8).mean(axis=1)
        one_cycle = np.concatenate([way, way[::-1]])
        directions = np.repeat([1, -1], len(way))
        return np.tile(one_cycle, 2), np.tile(directions, 2)

    def test_series(self):
        out = self.run_new("ramp", **RAMP)
        series, before = read_series(out), discarded_windows(out)
        rates, directions = self.expected_rates()
        np.testing.assert_allclose(series["strain_rate"][before:], rates, rtol=1e-12)
        np.testing.assert_array_equal(series["direction"][before:], directions)
        self.assertTrue((series["direction"][:before] == 0).all())
        # by way of 1e-3 (2^-5 / 1e-3 = 31.25 tau_e: 4 windows), then 64 tau_e: 8 windows
        np.testing.assert_allclose(series["strain_rate"][:before], [1e-3] * 4 + [2.0**-11] * 8)
        np.testing.assert_allclose(series["strain"], np.cumsum(8 * series["strain_rate"]), rtol=1e-12)
        np.testing.assert_allclose(series["time"], 8 * np.arange(1, len(series["time"]) + 1))
        summary = read_summary(out)
        np.testing.assert_allclose(summary["strain"]["total"], series["strain"][-1])
        np.testing.assert_allclose(series["B_p"], series["p"] / series["strain_rate"] ** 2, rtol=1e-12)
        np.testing.assert_allclose(series["eta_sigma"], series["sigma"] / series["strain_rate"], rtol=1e-12)
        self.assertEqual(read_state(out)["strain_rate"], 2.0**-11)
        self.check_loop(summary["loop"], series, before)

    def check_loop(self, loop, series, before):
        """Bins of a twentieth of a decade hold the windows of both cycles."""
        rate, p = series["strain_rate"][before:], series["p"][before:]
        place = np.floor(20 * np.log10(rate / 2.0**-11))
        for name, direction in (("up", 1), ("down", -1)):
            of_way = series["direction"][before:] == direction
            self.assertEqual(len(loop[name]), len(set(place)))
            for found, where in zip(loop[name], sorted(set(place))):
                inside = of_way & (place == where)
                self.assertEqual(found["windows"], inside.sum())
                np.testing.assert_allclose(found["strain_rate"], rate[inside].mean(), rtol=1e-12)
                np.testing.assert_allclose(found["observables"]["p"]["mean"], p[inside].mean(), rtol=1e-9)
                self.assertIsNone(found["observables"]["p"]["error"])  # two passes

    def test_replicas_are_the_runs_of_their_seeds_and_give_errors(self):
        out = self.run_new("two", disks__replicas=2, **RAMP)
        second = self.run_new("second", disks__seed=2, **RAMP)
        both, one = read_series(out), read_series(second)
        for name in one:
            self.assertTrue(same_bits(both[name][1], one[name]), name)
        self.assertGreater(read_summary(out)["loop"]["up"][0]["observables"]["p"]["error"], 0)

    def test_kills_change_no_bit(self):
        path = self.scene(**{**RAMP, "shear__cycles": 12}, **OFTEN)
        whole, seconds = self.undisturbed(path)
        for number, moments in ((signal.SIGKILL, 6), (signal.SIGTERM, 3)):
            out = self.kill_and_resume(path, f"ended{number}", moments, seconds, number=number)
            self.assert_same_results(whole, out)
            self.assertEqual(read_summary(whole)["loop"], read_summary(out)["loop"])

    def test_no_hysteresis_where_the_state_follows(self):
        """CD at Q = 1 is Newtonian (P2 Sec. III A): the viscosity does not remember the way, if a factor e
        in the rate takes a strain of order one: gammadot/kappa is 0.8 at the lowest rate."""
        out = self.run_new("newton", **{
            **RAMP, "disks__model": "CD", "disks__replicas": 6, "integration__time_step": 2.0**-4,
            "shear__strain_rate": 2.0**-10, "shear__strain_rate_high": 2.0**-7, "shear__ramp_rate": 5e-4,
            "shear__ramp_every": 4.0, "shear__ramp_window": 64.0, "shear__strain": 2.0, "shear__cycles": 3})
        loop = read_summary(out)["loop"]
        eta = [[bin_["observables"]["eta_sigma"] for bin_ in loop[way]] for way in ("up", "down")]
        differences = [(a["mean"] - b["mean"]) / np.hypot(a["error"], b["error"]) for a, b in zip(*eta)]
        self.assertLess(abs(np.mean(differences)), 2.5)  # bins of one pass may be all alike
        self.assertLess(np.sqrt(np.mean(np.square(differences))), 2.5)
        sigma = [bin_["observables"]["sigma"]["mean"] for bin_ in loop["up"]]
        self.assertGreater(sigma[-1] / sigma[0], 3.0)  # by 7 in rate: 7 if Newtonian, 49 if Bagnoldian
        self.assertLess(sigma[-1] / sigma[0], 14.0)

    def test_starts_from_a_state(self):
        first = self.run_new("first")
        out = self.run_new("ramp", start__kind="state", start__file=str(first / "state.h5"), **RAMP)
        self.assertEqual(discarded_windows(out), 8)
        with h5py.File(out / "result.h5") as file:
            self.assertEqual(file.attrs["start_velocity_scale"], 2.0**-4)
        np.testing.assert_allclose(read_series(out)["time"][0], read_state(first)["time"] + 8)

    def test_validate_and_refusals(self):
        said = self.bagnold("validate", self.scene(**RAMP)).stdout
        for words in ("# ramp           2 times up to", "in 128 rates of 16 steps", "strain 0.032 at 0.001"):
            self.assertIn(words, said)
        self.refused(self.scene(**{**RAMP, "integration__time_step": 0.07}), "shear.ramp_every")
        self.refused(self.scene(**RAMP, measure__frame_strain=0.1),
                     "measure.frame_strain", "belongs to")

    def test_advice_after_a_target_is_met(self):
        """More strain would change nothing: the run would end where it did."""
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(disks__model="CD_n", disks__packing_fraction=0.78, shear__strain=40.0,
                                                shear__target_error=Raw("{ p = 0.5 }"), shear__discard=0.5), "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        summary = read_summary(out)
        self.assertTrue(summary["target_error_reached"])
        self.assertLess(summary["strain"]["total"], 40)
        self.assertNotIn("bagnold resume", result.stderr + result.stdout)
        for one in summary["warnings"]:
            if "command" in one and "target_error" in one["command"]:
                words = shlex.split(one["command"].replace("DIR", str(out)))
                self.assertEqual(self.bagnold("validate", *words[2:words.index("--out")]).returncode, 0)

    def test_a_step_that_is_proposed_can_be_taken(self):
        """It divides the pieces of the ramp."""
        out = self.folder / "coarse"
        result = self.bagnold("run", self.scene(**{**RAMP, "disks__model": "CD_rot", "shear__ramp_every": 1.0,
                                                   "integration__time_step": 0.5}), "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        command = next(one["command"] for one in read_summary(out)["warnings"] if one["name"] == "contact_network")
        step = re.search(r"integration.time_step=(\S+)", command).group(1)
        self.assertAlmostEqual(1 / float(step), round(1 / float(step)), places=9)
        result = self.bagnold("validate", out / "scene.toml", "--set", f"integration.time_step={step}")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_picture(self):
        self.run_new("ramp", **{**RAMP, "output__plot": True})
        self.assertGreater((self.folder / "ramp/plot.png").stat().st_size, 20000)


class Steady(ProtocolTest):
    LONG = {"shear__strain": 2.0**5, "output__sample_strain": 2.0**-5}  # 1024 windows

    def test_auto_discards_what_mser_says(self):
        out = self.run_new("auto", **{**self.LONG, "shear__discard": "auto"})
        series = read_series(out)
        first = max(mser5(series[name]) for name in ("B_p", "B_sigma"))
        self.assertEqual(discarded_windows(out), first)
        summary = read_summary(out)
        self.assertEqual(summary["steady_state"]["discarded_windows"], first)
        self.assertTrue(summary["steady_state"]["found"])
        np.testing.assert_allclose(summary["observables"]["p"]["mean"], series["p"][first:].mean(), rtol=1e-9)
        self.assertEqual(summary["scene"]["shear"]["discard"], "auto")

    LONGER = {**LONG, "shear__strain": 2.0**7}  # 4096 windows

    def test_target_error_ends_the_run_where_it_is_reached(self):
        wanted = {"B_p": 0.2, "Z": 0.1}
        changes = {**self.LONGER, "shear__target_error": Raw("{ B_p = 0.2, Z = 0.1 }")}
        for name, more in (("half", {}), ("auto", {"shear__discard": "auto"}),
                           ("three", {"disks__replicas": 3})):
            with self.subTest(name=name):
                out = self.run_new(name, **changes, **more)
                series = read_series(out)
                windows = series["p"].shape[-1]
                summary = read_summary(out)
                self.assertTrue(summary["target_error_reached"])
                for key, error in wanted.items():
                    found = summary["observables"][key]
                    self.assertLessEqual(found["error"] / abs(found["mean"]), error)
                    self.assertEqual(summary["target_error"][key]["reached"],
                                     found["error"] / abs(found["mean"]))
                grid = [100]
                while grid[-1] < windows:
                    grid.append(grid[-1] + -(-grid[-1] // 2))
                self.assertEqual(grid[-1], windows)
                self.assertLess(windows, 4096)
                # at the look before, targets were met once: too few for a run that may go on to there
                shorter = read_summary(self.run_new(
                    f"{name}shorter", **{**changes, **more, "shear__strain": grid[-2] * 2.0**-5}))
                self.assertEqual(shorter["strain"]["total"], grid[-2] * 2.0**-5)
                self.assertFalse(shorter["target_error_reached"])
                for key, error in wanted.items():
                    self.assertLessEqual(shorter["target_error"][key]["reached"], error)
                # and the run that ends there is the run of that strain
                same = self.run_new(f"{name}same", **{**self.LONGER, **more, "shear__strain": windows * 2.0**-5})
                self.assertEqual(read_summary(same)["observables"].keys(), summary["observables"].keys())
                np.testing.assert_allclose(read_series(same)["p"], series["p"], rtol=1e-6)
                if name == "auto":
                    first = max(mser5(series[key]) for key in ("B_p", "B_sigma"))
                    self.assertEqual(discarded_windows(out), min(2 * first, (windows + 1) // 2))
                if name == "three":  # Student's t, 2 degrees of freedom: 4.53 stays above 95.45%
                    self.assertIn("Student", summary["errors_from"])
                    for key in wanted:
                        own = [one["observables"][key]["mean"] for one in summary["replicas"]]
                        self.assertGreater(summary["observables"][key]["error"],
                                           2.26 * np.std(own, ddof=1) / np.sqrt(3))

    def test_target_error_that_is_not_reached(self):
        out = self.run_new("cap", shear__target_error=Raw("{ B_p = 1e-9 }"))
        summary = read_summary(out)
        self.assertFalse(summary["target_error_reached"])
        self.assertEqual(summary["strain"]["total"], 2.0**-3)

    def test_a_missed_target_tells_the_strain_that_it_takes(self):
        """Errors fall with the root of the strain; the look before the last has two thirds of it."""
        path, out = self.scene(**self.LONG, shear__target_error=Raw("{ B_p = 0.02, Z = 0.5 }")), self.folder / "short"
        said = self.run_scene(path, out).stdout
        found = read_summary(out)["target_error"]["B_p"]
        times = (found["reached"] / found["wanted"]) ** 2
        self.assertGreater(times, 1.5)
        strain = float(re.search(r"not reached at two looks in a row; `bagnold resume \S+ --strain ([\d.]+)`", said)[1])
        self.assertGreaterEqual(strain, 2.0**5 * 1.5 * times * 0.999)
        self.assertLess(strain, 2.0**5 * 1.5 * times * 1.11)  # rounded up to two digits

    def test_a_target_is_not_reached_by_disks_that_have_not_met(self):
        """16 disks of phi = 0.15 meet no one for a while: B_p is rounding, and does not change."""
        dilute = {"disks__model": "CD_n", "disks__count": 16, "disks__packing_fraction": 0.15, "disks__elasticity": 0.5,
                  "disks__seed": 1, "shear__strain_rate": 1e-3, "integration__scheme": "two-stage-leapfrog", "integration__time_step": None,
                  "measure__every": None, "output__sample_strain": None, "shear__target_error": Raw("{ B_p = 0.05, Z = 0.05 }")}
        for strain, enough in ((10.0, False), (400.0, True)):
            out = self.folder / f"strain{strain:g}"
            result = self.run_scene(self.scene(**dilute, shear__strain=strain), out)
            summary = read_summary(out)
            self.assertEqual(summary["target_error_reached"], enough)
            self.assertGreater(summary["strain"]["total"], 5.0)
            self.assertNotIn("nan", result.stdout + result.stderr)
            few = [one["name"] for one in summary["warnings"]].count("few_collisions")
            self.assertFalse(few and enough)
        self.assertGreater(summary["observables"]["B_p"]["mean"], 0.1)
        still = lattice_state(16, 0.15)
        still["velocity"][:, 0] = 1e-3 * still["position"][:, 1]
        write_state(self.folder / "start.h5", still)
        out = self.run_new("still", **dilute, start__kind="state", start__file="start.h5", shear__strain=1.5)
        self.assertEqual([read_summary(out)["target_error"][name]["reached"] for name in ("B_p", "Z")], [None, None])

    def test_kills_change_no_bit(self):
        path = self.scene(**self.LONGER, shear__target_error=Raw("{ B_p = 0.12 }"), disks__replicas=2,
                          **OFTEN)
        whole, seconds = self.undisturbed(path)
        self.assertTrue(read_summary(whole)["target_error_reached"])
        for number, moments in ((signal.SIGKILL, 5), (signal.SIGTERM, 3)):
            out = self.kill_and_resume(path, f"ended{number}", moments, seconds, number=number)
            self.assert_same_results(whole, out)

    def test_unknown_names(self):
        self.refused(self.scene(shear__target_error=Raw("{ B_pp = 0.1 }")), "shear.target_error = { B_pp = 0.1 }",
                     "did you mean B_p?")

    def test_names_of_frames(self):
        for profiles, words in ((False, ["shear.target_error = { band_fraction_phi = 0.1 }", "measured on frames"]),
                                (True, ["shear.target_error does not go with measure.profiles", "frames begin"])):
            self.refused(self.scene(shear__target_error=Raw("{ band_fraction_phi = 0.1 }"),
                                    measure__profiles=profiles), *words)


def mser5(values):
    """White's MSER-5, sum by sum."""
    means = values[: len(values) // 5 * 5].reshape(-1, 5).mean(axis=1)
    spread = [np.var(means[d:]) / len(means[d:]) for d in range(len(means) // 2 + 1)]
    return 5 * int(np.argmin(spread))


if __name__ == "__main__":
    unittest.main()
