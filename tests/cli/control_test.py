# SPDX-License-Identifier: BSD-3-Clause
"""Flows at given shear stress or pressure: against flows at given rate and packing fraction, and against a packing."""

import csv
import math
import re
import shlex
import shutil
import signal
import unittest

import h5py
import numpy as np

from bagnold import CliTest, box_length, read_series, read_state, read_summary
from pieces_test import PACKING, shear_modulus
from resume_test import OFTEN, Ended, ResumeTest

GONE = {"shear__strain": None, "shear__discard": None, "integration__time_step": None, "measure__every": 10}
STRESS = {**GONE, "shear__protocol": "stress", "shear__time": 1e4}
PRESSURE = {**GONE, "shear__protocol": "pressure", "shear__strain": 20.0}
FLOWS = {  # at a rate of 0.01: a dilute one, and a dense one in which the damping of contacts matters
    "dilute": {"disks__model": "CD_n", "disks__packing_fraction": 0.65, "disks__elasticity": 5.0},
    "dense": {"disks__model": "CD_rot", "disks__packing_fraction": 0.82, "disks__elasticity": 1.0},
}


def apart(one, other):
    """Difference of two estimates in standard errors."""
    return abs(one["mean"] - other["mean"]) / math.hypot(one["error"], other["error"])


def frames_of(out):
    """Arrays of trajectory.h5md by name, one row a frame."""
    with h5py.File(out / "trajectory.h5md", "r") as file:
        disks, scalars = file["particles/trajectory"], file["observables/trajectory"]
        found = {name: disks[f"{name}/value"][()] for name in ("position", "image", "box/edges")}
        found |= {name: disks[f"position/{name}"][()] for name in ("step", "time")}
        return found | {name: scalars[f"{name}/value"][()] for name in scalars}


class Flows(CliTest):
    def flow(self, name, **changes):
        return read_summary(self.run_new(name, disks__count=144, disks__replicas=8, shear__strain_rate=0.01,
                                         output__sample_strain=0.05, **changes))["observables"]

    def test_the_stress_of_a_rate_gives_that_rate(self):
        for name, what in FLOWS.items():
            at_rate = self.flow(name, **{**GONE, **what, "shear__strain": 40.0})
            found = self.flow(name + "_stress", **{**STRESS, **what, "shear__stress": at_rate["sigma"]["mean"]})
            self.assertLess(found["strain_rate"]["error"], 0.05 * 0.01)
            # 1% of sigma is 0.5 to 1% of the rate
            rate = {"mean": 0.01, "error": 0.01 * at_rate["sigma"]["error"] / at_rate["sigma"]["mean"]}
            self.assertLess(apart(found["strain_rate"], rate), 4, name)
            self.assertAlmostEqual(found["sigma"]["mean"] / at_rate["sigma"]["mean"], 1, delta=0.02)
            for quantity in ("mu", "Z", "p"):
                self.assertLess(apart(found[quantity], at_rate[quantity]), 4, f"{name} {quantity}")

    def test_the_pressure_of_a_density_gives_that_density(self):
        for name, what in FLOWS.items():
            at_density = self.flow(name, **{**GONE, **what, "shear__strain": 40.0})
            pressure = at_density["p"]["mean"]
            found = self.flow(name + "_pressure", **{**PRESSURE, **what, "shear__pressure": pressure})
            phi = found["packing_fraction"]
            self.assertLess(phi["error"], 0.005)
            self.assertLess(abs(phi["mean"] - what["disks__packing_fraction"]), 0.004 + 4 * phi["error"], name)
            self.assertAlmostEqual(found["p"]["mean"] / pressure, 1, delta=0.02)
            for quantity in ("mu", "T_g"):
                self.assertLess(apart(found[quantity], at_density[quantity]), 4, f"{name} {quantity}")

    def test_replicas_on_two_threads_begin_in_one_box(self):
        out = self.folder / "threads"
        path = self.scene(**{**PRESSURE, **FLOWS["dense"], "disks__replicas": 16, "shear__pressure": 0.02,
                             "shear__strain_rate": 0.01, "shear__strain": 0.5})
        self.run_scene(path, out, "--threads", 2, "--quiet")
        phi = read_series(out)["packing_fraction"]
        self.assertLess(np.abs(phi / 0.82 - 1).max(), 0.05)
        alone = self.run_new("alone", **{**PRESSURE, **FLOWS["dense"], "disks__seed": 7, "shear__pressure": 0.02,
                                         "shear__strain_rate": 0.01, "shear__strain": 0.5})
        np.testing.assert_array_equal(read_series(alone)["packing_fraction"], phi[6])

    def test_powers_are_those_of_the_box_as_it_is(self):
        """A drag takes its share of the power of the shear wherever the box began."""
        driven = {**GONE, **PRESSURE, **FLOWS["dilute"], "disks__elasticity": 1.0, "shear__pressure": 3e-3, "disks__mass": "equal",
                  "shear__strain_rate": 0.01, "shear__strain": 40.0, "disks__count": 128, "disks__replicas": 4,
                  "drive__kind": "stokes", "drive__drag": 0.1, "output__sample_strain": None}
        for phi in (0.5, 0.8):
            summary = read_summary(self.run_new(f"from{phi}", **{**driven, "disks__packing_fraction": phi}))
            found = summary["observables"]
            self.assertLess(abs(found["energy_gap"]["mean"]), 0.03, phi)
            self.assertNotIn("energy_balance", [one["name"] for one in summary["warnings"]])
            self.assertAlmostEqual(found["packing_fraction"]["mean"], 0.794, delta=0.004)
            self.assertAlmostEqual(found["drag_power"]["mean"], 0.655, delta=0.03)

    def test_the_work_of_the_box_is_no_lost_energy(self):
        """A box that shrinks presses on contacts: 11% of the power of the shear here, whatever the time step."""
        summary = read_summary(self.run_new("shrinks", **{
            **GONE, **PRESSURE, "disks__model": "CD", "disks__mass": "equal", "disks__elasticity": 1.0, "disks__count": 128,
            "disks__replicas": 3, "disks__packing_fraction": 0.72, "shear__pressure": 1e-3, "shear__strain_rate": 1e-4,
            "shear__strain": 1.0, "output__sample_strain": None}))
        self.assertAlmostEqual(summary["observables"]["energy_gap"]["mean"], -0.1, delta=0.03)
        self.assertNotIn("energy_balance", [one["name"] for one in summary["warnings"]])

    def test_a_stress_that_is_not_reached_is_told(self):
        """Of a box too heavy for the time: its averages are of another stress."""
        heavy = {**GONE, **STRESS, "disks__model": "CD", "disks__packing_fraction": 0.80, "disks__elasticity": 1.0,
                 "shear__strain_rate": 1e-4, "shear__time": 3e3, "output__sample_strain": None}
        for stress, asked in ((1e-2, 1e-2), ([1e-2, 5e-2], 5e-2)):
            summary = read_summary(self.run_new(f"heavy{asked}", **{**heavy, "shear__stress": stress}))
            told = [one for one in summary["warnings"] if one["name"] == "stress_not_held"]
            self.assertEqual(len(told), 1)
            self.assertLess(told[0]["numbers"]["sigma"], 0.95 * told[0]["numbers"]["stress"])
            self.assertNotIn("arrest", [one["name"] for one in summary["notes"]])
        light = read_summary(self.run_new("light", **{**heavy, "shear__stress": 1e-2, "shear__strain_rate": 5e-3, "shear__time": 1e4}))
        self.assertNotIn("stress_not_held", [one["name"] for one in light["warnings"]])

    def test_a_packing_comes_to_rest_whatever_the_box(self):
        """Pieces are short against its swing, so that the control does not shake the packing; a lighter box is refused."""
        packing = {**GONE, **STRESS, "disks__model": "CD", "disks__packing_fraction": 0.88, "disks__elasticity": 1.0,
                   "disks__mass": "equal", "shear__stress": 1e-3, "shear__time": 4e3, "output__sample_strain": 0.005}
        for name, changes in {
                "implicit": {"shear__strain_rate": 5e-3, "integration__scheme": "implicit-damping"},
                "light": {"shear__strain_rate": 2e-2}, "lighter": {"shear__strain_rate": 2e-2, "shear__box_inertia": 1.0},
                "undamped": {"shear__strain_rate": 2e-2, "shear__box_inertia": 1.0, "disks__elasticity": 100.0}}.items():
            summary = read_summary(self.run_new(name, **{**packing, **changes}))
            self.assertLess(summary["observables"]["T_g"]["mean"], 1e-9, name)
            self.assertGreater(summary["observables"]["Z"]["mean"], 4.5, name)
        said = self.bagnold("validate", self.scene(**{**packing, "shear__strain_rate": 2e-2, "shear__box_inertia": 0.1}))
        self.assert_clean_error(said, 2, "shear.box_inertia = 0.1", "raise it")
        said = self.bagnold("validate", self.scene(**{**packing, "shear__strain_rate": 0.1}))
        self.assert_clean_error(said, 2, "shear.strain_rate = 0.1", "lower it")

    def test_stresses_below_yield_in_a_list(self):
        """The largest at which the packing stops, and what was measured of all."""
        out = self.run_new("list", **{**GONE, **STRESS, "disks__model": "CD", "disks__packing_fraction": 0.88, "disks__elasticity": 1.0,
                                      "shear__stress": [5e-4, 1e-3, 4e-3], "shear__strain_rate": 5e-3, "shear__time": 4e3,
                                      "output__sample_strain": 0.005})
        summary = read_summary(out)
        note = next(one for one in summary["notes"] if one["name"] == "arrest")
        self.assertIn("at the stress 0.001 ", note["reason"])
        measured = sum(abs(one["strain"]) for one in summary["stresses"])
        self.assertAlmostEqual(summary["strain"]["measured"] / measured, 1, places=9)

    def test_a_pressure_that_is_not_reached_is_told(self):
        slow = {**GONE, **PRESSURE, "disks__model": "CD", "disks__packing_fraction": 0.842, "disks__elasticity": 1.0,
                "shear__pressure": 1e-4, "shear__strain_rate": 1e-4, "shear__strain": 1.0, "shear__response": 200.0,
                "output__sample_strain": 0.01}
        found = read_summary(self.run_new("slow", **slow))
        self.assertIn("pressure_not_held", [one["name"] for one in found["warnings"]])
        self.assertGreater(found["observables"]["p"]["mean"], 1.2e-4)
        found = read_summary(self.run_new("quick", **{**slow, "shear__response": 5.0, "shear__strain": 10.0, "shear__strain_rate": 1e-3}))
        self.assertNotIn("pressure_not_held", [one["name"] for one in found["warnings"]])

    def test_correlations_are_told_in_the_strain_that_is_found(self):
        """Not in that of the strain rate it begins with, which is nine times smaller here."""
        out = self.run_new("found", **{**GONE, **STRESS, "disks__model": "CD", "disks__packing_fraction": 0.80,
                                       "disks__elasticity": 1.0, "shear__stress": 1e-2, "shear__strain_rate": 1e-3,
                                       "shear__box_inertia": 10.0, "output__sample_strain": 0.005})
        windows = len(read_series(out)["strain"])
        window = read_series(out)["strain"][-1] / windows
        self.assertGreater(window, 0.04)
        for name in ("p", "sigma", "mu"):
            self.assertGreaterEqual(read_summary(out)["observables"][name]["correlation_strain"], 0.49 * window, name)

    def test_the_remedy_of_deep_overlaps(self):
        out = self.folder / "deep"
        result = self.bagnold("run", self.scene(**{
            **GONE, **PRESSURE, **FLOWS["dense"], "shear__pressure": 0.03, "shear__strain_rate": 0.01, "shear__strain": 5.0}), "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        note = next(one for one in read_summary(out)["notes"] if one["name"] == "large_overlap")
        self.assertEqual(note["remedy"], "lower shear.pressure")
        words = shlex.split(note["command"].replace("DIR", str(out)))
        self.assertEqual(self.bagnold(*words[1:], "--quiet").returncode, 0)

    def test_a_state_keeps_its_box(self):
        scene = {**PRESSURE, **FLOWS["dense"], "shear__strain_rate": 0.01, "shear__pressure": 0.02, "disks__packing_fraction": 0.80}
        first = self.run_new("first", **{**scene, "shear__strain": 2.0})
        state = read_state(first)
        self.assertGreater(abs(state["box_length"] / box_length(64, 0.80) - 1), 0.002)
        more = self.run_new("more", **{**scene, "shear__strain": 1.0, "output__sample_strain": 0.02,
                                       "start__kind": "state", "start__file": str(first / "state.h5")})
        phi = 0.80 * (box_length(64, 0.80) / state["box_length"])**2
        series = read_series(more)
        self.assertLess(abs(series["packing_fraction"][0] / phi - 1), 0.003)
        end = read_state(more)
        last = 0.80 * (box_length(64, 0.80) / end["box_length"])**2
        self.assertLess(abs(series["packing_fraction"][-1] / last - 1), 0.003)

    def test_the_box_has_the_packing_fraction_that_is_told(self):
        out = self.run_new("p", **{**PRESSURE, **FLOWS["dense"], "shear__pressure": 0.02, "shear__strain": 2.0,
                                   "disks__packing_fraction": 0.80, "shear__strain_rate": 0.01})
        series, state = read_series(out), read_state(out)
        phi = 0.80 * (box_length(64, 0.80) / state["box_length"])**2
        self.assertGreater(abs(phi - 0.80), 0.005)
        self.assertLess(abs(series["packing_fraction"][-1] - phi), 0.002)  # the mean of a window of pieces
        np.testing.assert_allclose(series["strain"][-1], 2.0, rtol=1e-3)


class Box(CliTest):
    """A box against a packing: M d^2 gamma/dt^2 = stress - G gamma, less what is damped."""

    def of(self, **more):
        flat = {f"{table}__{key}": value for table, keys in PACKING.items() for key, value in keys.items()}
        return {**flat, "disks__seed": 7, **more}

    def packing(self):
        """A packing that bears a stress, at rest."""
        return self.run_new("packing", **self.of(**GONE, shear__strain_rate=None, output__sample_strain=None,
                                                 shear__pieces=[[1e-3, 1.0], [1e-5, 0.02], [0, 3e5]]))

    def test_it_comes_to_rest_where_the_packing_bears_the_stress(self):
        packing = self.packing()
        modulus, before = shear_modulus(read_state(packing)), read_series(packing)["sigma"][-1]
        self.assertGreater(before, 0)
        for more in (1e-7, -1e-7):
            out = self.run_new(f"held{more}", **self.of(**{
                **STRESS, "start__kind": "state", "start__file": str(packing / "state.h5"),
                "shear__stress": before + more, "shear__strain_rate": 1e-9, "shear__time": 4e4,
                "shear__box_inertia": 100.0, "output__sample_strain": 1e-8}))
            series = read_series(out)
            self.assertAlmostEqual(series["strain"][-1] * modulus / more, 1, delta=1e-4)
            self.assertAlmostEqual((series["sigma"][-1] - before) / more, 1, delta=1e-6)
            self.assertLess(abs(series["strain_rate"][-1]), 1e-15)
            self.assertIn("arrest", [note["name"] for note in read_summary(out)["notes"]])

    def test_it_swings_about_that_place(self):
        """With omega = sqrt(G/M), where that is slow enough for the packing to follow."""
        packing = self.packing()
        modulus, before = shear_modulus(read_state(packing)), read_series(packing)["sigma"][-1]
        inertia = 1e7
        out = self.run_new("swings", **self.of(**{
            **STRESS, "start__kind": "state", "start__file": str(packing / "state.h5"), "shear__stress": before + 1e-7,
            "shear__strain_rate": 1e-12, "shear__time": 2.6e5, "shear__box_inertia": inertia, "output__sample_strain": 1e-10}))
        series = read_series(out)
        away = series["strain"] - 1e-7 / modulus
        turns = np.flatnonzero(away[:-1] * away[1:] < 0)
        self.assertGreaterEqual(len(turns), 5)
        at = turns + away[turns] / (away[turns] - away[turns + 1])
        half_period = np.diff(at).mean() * (series["time"][1] - series["time"][0])
        self.assertAlmostEqual(half_period / (math.pi * math.sqrt(inertia / modulus)), 1, delta=0.01)

    def test_a_list_of_stresses_is_held_one_after_the_other(self):
        stresses = [0.001, 0.002, 0.001]
        out = self.run_new("list", **{**STRESS, **FLOWS["dense"], "shear__stress": stresses, "shear__strain_rate": 0.001,
                                      "shear__time": 3e4})
        found = read_summary(out)["stresses"]
        self.assertEqual([one["stress"] for one in found], stresses)
        rates = [one["observables"]["strain_rate"]["mean"] for one in found]
        self.assertGreater(rates[1], 1.3 * rates[0])
        self.assertGreater(rates[1], 1.3 * rates[2])
        for one in found:
            self.assertAlmostEqual(one["observables"]["sigma"]["mean"] / one["stress"], 1, delta=0.05)


class Longer(CliTest):
    """What a run that is too short names as remedy is accepted, and is longer."""

    SHORT = {**STRESS, **FLOWS["dense"], "disks__count": 64, "shear__stress": 0.002, "shear__strain_rate": 0.002,
             "shear__time": 400.0, "shear__discard": "auto", "output__sample_strain": 0.01}

    def test_a_sweep_over_lists_has_a_row_a_stress(self):
        path = self.scene(**{**self.SHORT, "shear__stress": [0.002, 0.003], "shear__discard": 0.5})
        path.write_text(path.read_text() + '[sweep]\ngrid = { "disks.seed" = [1, 2] }\n')
        out = self.folder / "sweep"
        self.assertEqual(self.bagnold("sweep", path, "--out", out).returncode, 0)
        with open(out / "pieces.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["disks.seed"], row["piece"], float(row["stress"])) for row in rows],
                         [("1", "1", 0.002), ("1", "2", 0.003), ("2", "1", 0.002), ("2", "2", 0.003)])
        for row in rows:
            held = read_summary(out / "points" / row["folder"])["stresses"][int(row["piece"]) - 1]
            self.assertEqual(float(row["p"]), held["observables"]["p"]["mean"])
            self.assertEqual(float(row["strain_rate"]), held["observables"]["strain_rate"]["mean"])
            self.assertEqual(float(row["strain"]), held["strain"])
        self.assert_clean_error(self.bagnold("analyse", "kink", out, "--out", self.folder / "k"), 2, "pieces.csv")
        self.assertEqual(self.bagnold("analyse", "table", out / "pieces.csv", "--x", "stress", "--y", "p", "--along", "piece",
                                      "--out", self.folder / "t").returncode, 0)

    def test_a_stress_is_held_for_longer(self):
        out = self.folder / "short"
        told = self.run_scene(self.scene(**self.SHORT), out).stdout
        commands = re.findall(r"`bagnold (run [^`]*)`", told)
        self.assertTrue(commands, told)
        for command in set(commands):
            arguments = shlex.split(command)
            longer = self.folder / arguments[arguments.index("--out") + 1]
            self.assertEqual(self.bagnold(*arguments, "--quiet").returncode, 0, command)
            self.assertGreaterEqual(read_series(longer)["time"][-1], 1.5 * read_series(out)["time"][-1])
            shutil.rmtree(longer)

    def test_a_pressure_without_errors_is_held_for_longer(self):
        told = self.run_scene(self.scene(**{**PRESSURE, **FLOWS["dense"], "shear__pressure": 0.02, "shear__strain_rate": 0.01,
                                            "shear__strain": 1.0}), self.folder / "short").stdout
        (command,) = set(re.findall(r"`bagnold (resume [^`]*)`", told))
        self.assertEqual(self.bagnold(*shlex.split(command), "--quiet").returncode, 0, command)


class Trajectories(CliTest):
    """Frames tell the strain and the box that a controller has chosen."""

    FLOW = {**FLOWS["dense"], "shear__strain_rate": 0.01}

    def test_frames_at_given_stress(self):
        path = {**STRESS, **self.FLOW, "shear__stress": 0.005, "shear__time": 2000.0, "output__sample_strain": 0.05}
        out = self.run_new("stress", **path, output__trajectory_time=10.0)
        frames, series = frames_of(out), read_series(out)
        rate = np.interp(series["time"], frames["time"], frames["strain_rate"])
        self.assertGreater(np.ptp(rate), 1e-3)  # it is no longer that of the start
        window = np.diff(series["strain"], prepend=0)
        self.assertGreater(np.ptp(window) / window.mean(), 0.1)
        strain = np.interp(series["time"], frames["time"], frames["strain"])
        np.testing.assert_allclose(strain[:-1], series["strain"][:-1], atol=2e-3)
        length = box_length(64, 0.82)
        away = (frames["strain"] * length - frames["offset"] + frames["offset"][0]) / length
        np.testing.assert_allclose(away, np.rint(away), atol=1e-10)
        self.assertGreater(np.rint(away).max(), 3)

    def test_frames_at_given_pressure(self):
        scene = {**PRESSURE, **self.FLOW, "shear__pressure": 0.004, "shear__strain": 6.0, "shear__response": 2.0}
        fine = frames_of(self.run_new("fine", **scene, output__trajectory_strain=0.05))
        coarse = frames_of(self.run_new("coarse", **scene, output__trajectory_strain=0.5))
        self.assertGreater(np.ptp(fine["box/edges"][:, 0, 0]), 0.1)
        for edges in fine["box/edges"]:
            self.assertEqual(edges[0, 0], edges[1, 1])
        every = np.searchsorted(fine["step"], coarse["step"])
        np.testing.assert_array_equal(fine["step"][every], coarse["step"])
        for name in ("position", "strain", "box/edges"):
            np.testing.assert_array_equal(fine[name][every], coarse[name], err_msg=name)
        # a disk goes where its images near in time say, also over half a strain
        np.testing.assert_array_equal(fine["image"][every], coarse["image"])
        self.assertGreater(np.abs(fine["image"]).max(), 3)


class Restarts(ResumeTest):
    def test_a_run_that_is_stopped_goes_on_with_its_bits(self):
        for name, protocol in (("stress", {**STRESS, "shear__stress": 0.002, "shear__time": 1.5e4}),
                               ("pressure", {**PRESSURE, "shear__pressure": 0.005, "shear__strain": 30.0})):
            frames = {"stress": {"output__trajectory_time": 500.0}, "pressure": {"output__trajectory_strain": 1.0}}[name]
            path = self.scene(**{**protocol, **FLOWS["dense"], "shear__strain_rate": 0.002, "disks__replicas": 2, **OFTEN,
                                 **frames})
            whole, out = self.folder / f"{name}_whole", self.folder / f"{name}_cut"
            self.run_scene(path, whole, "--threads", 1, "--quiet")
            process, stops = self.start("run", path, "--out", out, "--threads", 1), 0
            try:
                while stops < 4:
                    self.stop_after_checkpoint(process, out, self.checkpoint_stamp(out), signal.SIGTERM)
                    stops += 1
                    process = self.start("resume", out, "--threads", 1)
                self.assertEqual(self.finish(process)[0], 0)
            except Ended:
                self.assertGreater(stops, 0)
            self.assert_same_results(whole, out)

    def test_a_pressure_is_held_longer(self):
        scene = {**PRESSURE, **FLOWS["dense"], "shear__strain_rate": 0.01, "shear__pressure": 0.02}
        out = self.run_new("short", **{**scene, "shear__strain": 1.0})
        self.resume(out, "--strain", 2.0)
        self.assert_same_results(self.run_new("long", **{**scene, "shear__strain": 2.0}), out)


if __name__ == "__main__":
    unittest.main()
