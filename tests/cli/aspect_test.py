# SPDX-License-Identifier: BSD-3-Clause
"""Boxes that are not square: disks.box_aspect = L_y / L_x, from the scene to every file."""

import csv
import signal
import tomllib
import unittest

import h5py
import numpy as np

from bagnold import (
    PAPERS, SCENE, TWO_STAGE, CliTest, Raw, box_length, lattice_state, read_series, read_state,
    read_summary, same_bits, scene_text, without_mean_motion, write_state,
)

RATE = 2.0**-7
TALL, FLAT = {"disks__box_aspect": 4.0}, {"disks__box_aspect": 0.25}
SHAPES = {"tall": TALL, "flat": FLAT}
DENSE = {"disks__count": 256, "disks__packing_fraction": 0.84}


def free_state(aspect, count=64, packing_fraction=0.1):
    """Disks at rest on a lattice of eight rows."""
    state = lattice_state(count, packing_fraction)
    state["position"] *= [aspect**-0.5, aspect**0.5]
    state["box_length"] *= aspect**-0.5
    return {**state, "box_aspect": aspect}


class Box(CliTest):
    def test_holds_the_packing_fraction(self):
        for name, shape in SHAPES.items():
            aspect = shape["disks__box_aspect"]
            out = self.run_new(name, **shape)
            state = read_state(out)
            length = box_length(64, 0.8) * aspect**-0.5
            self.assertAlmostEqual(state["box_length"], length, delta=1e-12)
            self.assertEqual(state["box_aspect"], aspect)
            self.assertAlmostEqual(state["offset"] / length, 2.0**-3 * aspect % 1, delta=1e-12)
            self.assertTrue((state["position"] >= 0).all())
            self.assertTrue((state["position"] < [length, aspect * length]).all())
            scene = tomllib.loads((out / "scene.toml").read_text())
            self.assertEqual(scene["disks"]["box_aspect"], aspect)
            self.assertEqual(read_summary(out)["scene"]["disks"]["box_aspect"], aspect)
            with h5py.File(out / "result.h5") as file:
                self.assertEqual(file.attrs["box_aspect"], aspect)
                self.assertEqual(file.attrs["box_length"], state["box_length"])

    def test_validate_tells_both_lengths(self):
        result = self.bagnold("validate", self.scene(**TALL))
        width = box_length(64, 0.8) / 2
        self.assertIn(f"{width:.6g} d_s wide, {4 * width:.6g} d_s high", result.stdout)
        self.assertNotIn("high", self.bagnold("validate", self.scene()).stdout)

    def test_refusals(self):
        for value in (0.0, -1.0, 0.015, 65.0):
            self.refused(self.scene(disks__box_aspect=value), "disks.box_aspect")
        for shape in (64.0, 1 / 64):
            self.refused(self.scene(disks__box_aspect=shape), "disks.box_aspect", "disks.count = 64",
                         "wide", "high", "skin", "aspect nearer 1")
        self.refused(self.scene(disks__count=512, measure__fields=True, disks__box_aspect=32.0),
                     "measure.fields", "disks.box_aspect")

    def test_energy_is_balanced(self):
        for name, shape in SHAPES.items():
            for scheme in (PAPERS, TWO_STAGE):
                out = self.run_new(f"{name}-{scheme}", shear__strain=8.0, shear__discard=0.25,
                                   integration__scheme=scheme, **DENSE, **shape)
                mean = {k: v["mean"] for k, v in read_summary(out)["observables"].items()}
                self.assertLess(abs(mean["energy_gap"]), 0.05)  # its errors are 0.01 to 0.02
                density = 256 / box_length(256, 0.84) ** 2
                self.assertAlmostEqual(mean["p_kin"] / (density * mean["T_g"]), 1, delta=1e-9)

    def test_profiles_add_up_to_the_box(self):
        out = self.run_new("out", shear__strain=0.5, measure__profiles=True, **DENSE, **TALL)
        height = 2 * box_length(256, 0.84)
        with h5py.File(out / "result.h5") as file:
            profiles = {name: file[f"profiles/{name}"] for name in ("phi", "gammadot")}
            for profile in profiles.values():
                self.assertEqual(len(profile["y"]), int(height / 1.5))
                self.assertAlmostEqual(profile["y"][-1] + profile["y"][0], height, delta=1e-10)
            self.assertAlmostEqual(np.mean(profiles["phi"]["value"]), 0.84, delta=1e-10)
            self.assertAlmostEqual(np.mean(profiles["gammadot"]["value"]) / RATE, 1, delta=1e-10)

    def test_trajectory_has_its_edges(self):
        for name, shape in SHAPES.items():
            aspect = shape["disks__box_aspect"]
            out = self.run_new(name, output__trajectory_strain=2.0**-5, output__checkpoint_minutes=1e-4,
                               **DENSE, **shape)
            length = read_state(out)["box_length"]
            with h5py.File(out / "trajectory.h5md") as file:
                edges = file["particles/trajectory/box/edges/value"][()]
                time = file["particles/trajectory/position/time"][()]
                place = file["particles/trajectory/position/value"][()]
            self.assertTrue((edges[:, 0] == [length, 0, 0]).all())
            self.assertTrue((edges[:, 1, 1] == aspect * length).all())
            turns = (edges[:, 1, 0] - RATE * time * aspect * length) / length
            np.testing.assert_allclose(turns, np.rint(turns), atol=1e-12)
            self.assertLessEqual(np.abs(edges[:, 1, 0]).max(), length / 2)
            self.assertTrue((place[:, :, 1] >= 0).all() and (place[:, :, 1] < aspect * length).all())
            self.assertGreater(place[:, :, 1].max(), 0.95 * aspect * length)

    def test_pictures(self):
        out = self.run_new("out", output__plot=True, measure__profiles=True, measure__fields=True,
                           disks__count=512, measure__frame_strain=2.0**-6, disks__box_aspect=2.0)
        for name in ("profiles.png", "fields.png", "plot.png"):
            self.assertEqual((out / name).read_bytes()[:4], b"\x89PNG", name)


class FromState(CliTest):
    def run_from(self, state, name="out", **changes):
        write_state(self.folder / "start.h5", state)
        return self.run_new(name, **{"disks__model": "CD", "disks__packing_fraction": 0.1,
                                     "start__kind": "state", "start__file": "start.h5", **changes})

    def test_images_are_a_height_away(self):
        """x = x_0 + v t of disks that fly alone, seen in the image where each ends."""
        for name, shape in SHAPES.items():
            aspect = shape["disks__box_aspect"]
            state = free_state(aspect, 16, 0.01)
            length, height = state["box_length"], aspect * state["box_length"]
            state["velocity"][0] = [0.1, -height / 48]  # from a height of 1/8 through y = 0
            state["velocity"][15] = [0.1, height / 48]  # through y = L_y
            state = without_mean_motion(state, RATE)
            final = read_state(self.run_from(state, name, disks__count=16, shear__strain=2.0**-4,
                                             disks__packing_fraction=0.01, **shape))
            free = state["position"] + 2.0**-4 / RATE * state["velocity"]
            rows = np.rint((free[:, 1] - final["position"][:, 1]) / height)
            self.assertEqual((rows[0], rows[15]), (-1, 1))
            away = free - final["position"] - np.stack([rows * final["offset"], rows * height], 1)
            away[:, 0] -= length * np.rint(away[:, 0] / length)
            self.assertLess(np.max(np.abs(away)), 1e-10)
            slower = state["velocity"][:, 0] - final["velocity"][:, 0]
            np.testing.assert_allclose(slower, rows * RATE * height, atol=1e-12)

    def test_a_run_goes_on_from_its_own_state(self):
        changes = {**DENSE, **TALL}
        whole = read_state(self.run_new("whole", shear__strain=2.0**-3, **changes))
        self.run_new("half", shear__strain=2.0**-4, **changes)
        rest = read_state(self.run_new("rest", shear__strain=2.0**-4, start__kind="state",
                                       start__file="half/state.h5", **changes))
        self.assertAlmostEqual(whole["offset"], rest["offset"], delta=1e-10)
        away = whole["position"] - rest["position"]
        rows = np.rint(away[:, 1] / (4 * whole["box_length"]))
        away -= np.stack([rows * whole["offset"], rows * 4 * whole["box_length"]], 1)
        away[:, 0] -= whole["box_length"] * np.rint(away[:, 0] / whole["box_length"])
        self.assertLess(np.max(np.abs(away)), 1e-7)

    def test_another_shape_is_refused(self):
        write_state(self.folder / "start.h5", free_state(4.0))
        free = {"disks__packing_fraction": 0.1, "start__kind": "state", "start__file": "start.h5"}
        self.refused(self.scene(**free), "box_aspect = 4", "disks.box_aspect = 1",
                     "set disks.box_aspect = 4")
        write_state(self.folder / "start.h5", {**free_state(4.0), "box_aspect": -4.0})
        self.refused(self.scene(**free, **TALL), "box_aspect = -4")

    def test_a_state_without_the_attribute_is_square(self):
        square = self.run_new("square")
        self.assertNotIn("box_aspect", read_state(square))
        self.run_from(lattice_state())
        write_state(self.folder / "start.h5", lattice_state())
        self.refused(self.scene(disks__packing_fraction=0.1, start__kind="state",
                                start__file="start.h5", **TALL), "set disks.box_aspect = 1")


class Protocols(CliTest):
    STEADY = {"shear__strain": 32.0, "output__sample_strain": 2.0**-4}
    RAMP = {"shear__protocol": "ramp", "shear__discard": None, "output__sample_strain": None,
            "shear__strain_rate": 2.0**-9, "shear__strain_rate_high": 2.0**-6,
            "shear__ramp_rate": 2.5e-4, "shear__ramp_window": 64.0, "shear__strain": 2.0**-5}

    def test_stopped_and_resumed_ends_the_same(self):
        for name, changes in {"tall": {**TALL, **self.STEADY}, "flat": {**FLAT, **self.STEADY},
                              "ramp": {**TALL, **self.RAMP},
                              "replicas": {**TALL, **self.STEADY, "disks__replicas": 2}}.items():
            with self.subTest(name=name):
                trajectory = {"output__trajectory_strain": 2.0**-3} if name in SHAPES else {}
                scene = self.scene(output__checkpoint_minutes=0.0005, **DENSE, **changes, **trajectory)
                whole, cut = self.folder / name, self.folder / f"{name}-cut"
                self.run_scene(scene, whole, "--quiet")
                process = self.start("run", scene, "--out", cut)
                self.assertTrue(self.wait_until((cut / "checkpoint.h5").exists, process))
                process.send_signal(signal.SIGTERM)
                self.assertEqual(self.finish(process)[0], 143, "the run was over too soon")
                self.assertEqual(self.bagnold("resume", cut, "--quiet").returncode, 0)
                self.assert_same_results(whole, cut)
                if trajectory:
                    self.assertEqual((whole / "trajectory.h5md").read_bytes(),
                                     (cut / "trajectory.h5md").read_bytes())

    def test_a_ramp_ends_at_the_offset_of_its_strain(self):
        for name, shape in SHAPES.items():
            out = self.run_new(name, **DENSE, **self.RAMP, **shape)
            state, strain = read_state(out), read_summary(out)["strain"]["total"]
            turns = state["offset"] / state["box_length"] - strain * shape["disks__box_aspect"]
            self.assertAlmostEqual(turns, round(turns), delta=1e-10)

    def test_replicas_are_the_runs_of_their_seeds(self):
        for name, shape in SHAPES.items():
            both = self.run_new(name, disks__replicas=2, **DENSE, **shape)
            state, series = read_state(both), read_series(both)
            self.assertEqual(state["box_aspect"], shape["disks__box_aspect"])
            for r in range(2):
                alone = self.run_new(f"{name}{r}", disks__seed=1 + r, **DENSE, **shape)
                for key in ("position", "velocity", "spin"):
                    self.assertTrue(same_bits(state[key][r], read_state(alone)[key]), key)
                self.assertTrue(same_bits(series["p"][r], read_series(alone)["p"]))

    def test_a_cascade_goes_on_in_its_box(self):
        out = self.run_new("out", shear__protocol="cascade", shear__strain_rate=None,
                           shear__strain_rates=Raw(str([2.0**-6, 2.0**-7])), **DENSE, **TALL)
        for stage in ("0001_strain_rate=0.015625", "0002_strain_rate=0.0078125"):
            self.assertEqual(read_state(out / stage)["box_aspect"], 4.0)

    def test_a_sweep_over_shapes(self):
        sweep = self.folder / "sweep.toml"
        sweep.write_text(scene_text(SCENE) + '[sweep]\ngrid = { "disks.box_aspect" = [1, 2, 4] }\n')
        out = self.folder / "sweep"
        result = self.bagnold("sweep", sweep, "--out", out, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(out / "sweep.csv", newline="", encoding="utf-8") as file:
            self.assertEqual([float(row["disks.box_aspect"]) for row in csv.DictReader(file)],
                             [1, 2, 4])


if __name__ == "__main__":
    unittest.main()
