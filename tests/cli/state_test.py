# SPDX-License-Identifier: BSD-3-Clause
"""Starting from a state file: [start] kind = "state"."""

import unittest

import h5py
import numpy as np

from bagnold import (
    CliTest, box_length, lattice_state, read_series, read_state, read_summary, same_bits,
    without_mean_motion, write_state,
)

RATE = 2.0**-7
FREE = {"disks__model": "CD", "disks__packing_fraction": 0.1, "start__kind": "state",
        "start__file": "start.h5"}


class Kept(CliTest):
    def run_from(self, state, name="out", **changes):
        write_state(self.folder / "start.h5", state)
        return self.run_new(name, **{**FREE, **changes})

    def assert_flown(self, final, state):
        """Disks that all go with the middle of the flow: velocities bit for bit, x = x_0 + v t for 2^-3 of strain."""
        for name in ("velocity", "diameter"):
            self.assertTrue(same_bits(final[name], state[name]), name)
        away = final["position"] - state["position"] - 2.0**-3 / RATE * state["velocity"]
        away[:, 0] -= state["box_length"] * np.rint(away[:, 0] / state["box_length"])
        self.assertLess(np.abs(away).max(), 1e-12)

    def test_disks_that_meet_no_one_keep_every_bit_of_their_velocity(self):
        for model in ("CD", "CD_n"):
            with self.subTest(model=model):
                state = without_mean_motion(lattice_state(), RATE)
                self.assert_flown(read_state(self.run_from(state, model, disks__model=model)), state)

    def test_spins_stay(self):
        for model in ("CD_rot", "CD_nt"):
            with self.subTest(model=model):
                state = {**without_mean_motion(lattice_state(), RATE), "spin": np.linspace(-1e-2, 1e-2, 64)}
                final = read_state(self.run_from(state, model, disks__model=model))
                self.assert_flown(final, state)
                self.assertTrue(same_bits(final["spin"], state["spin"]))

    def test_order_of_the_disks_is_the_order_of_the_start(self):
        shuffle = np.random.default_rng(1).permutation(64)
        state = lattice_state()
        for name in ("position", "diameter"):
            state[name] = state[name][shuffle]
        state = without_mean_motion(state, RATE)
        self.assert_flown(read_state(self.run_from(state)), state)

    def test_order_survives_a_dense_run(self):
        """A disk that starts at rest in a corner ends near it: nobody is renumbered."""
        first = self.run_new("first", disks__count=256)
        start, length = read_state(first), box_length(256, 0.8)
        (self.folder / "start.h5").write_bytes((first / "state.h5").read_bytes())
        end = read_state(self.run_new("second", disks__count=256, start__kind="state",
                                      start__file="start.h5", shear__strain=2.0**-6))
        self.assertTrue(same_bits(end["diameter"], start["diameter"]))
        step = end["position"] - start["position"]
        rows = np.rint(step[:, 1] / length)
        step[:, 1] -= rows * length
        step[:, 0] -= rows * end["offset"]
        step[:, 0] -= length * np.rint(step[:, 0] / length)
        self.assertLess(np.max(np.abs(step)), 2.0**-6 * length + 1.0)

    def test_free_flight_through_the_sheared_box(self):
        """x = x_0 + v t for every disk, seen in the image where it ends."""
        random, state = np.random.default_rng(2), lattice_state(16, 0.01)
        length = state["box_length"]
        state["velocity"] = np.zeros((16, 2))
        fast = [0, 5, 10, 15]
        state["velocity"][fast] = random.normal(scale=0.5, size=(4, 2))
        state["velocity"][15] = [0.1, 1.0]  # crosses y = L
        state["velocity"][0] = [0.1, -1.0]  # crosses y = 0
        state = without_mean_motion(state, RATE)
        final = read_state(self.run_from(
            state, disks__count=16, disks__packing_fraction=0.01, shear__strain=2.0**-4))
        time = 2.0**-4 / RATE
        self.assertAlmostEqual(final["offset"], 2.0**-4 * length, delta=1e-9)
        free = state["position"] + time * state["velocity"]
        rows = np.rint((free[:, 1] - final["position"][:, 1]) / length)
        self.assertTrue((rows[[0, 15]] == [-1, 1]).all(), "the test should cross the boundary")
        away = free - final["position"] - np.stack([rows * final["offset"], rows * length], 1)
        away[:, 0] -= length * np.rint(away[:, 0] / length)
        hit = np.any(np.abs(final["velocity"] - state["velocity"]
                            + np.outer(rows, [RATE * length, 0])) > 1e-12, axis=1)
        self.assertFalse(hit.any(), "velocities change only at a crossing")
        self.assertLess(np.max(np.abs(away)), 1e-10)

    def test_offset_is_used_and_strain_counts_from_zero(self):
        state = lattice_state()
        length = state["box_length"]
        state["offset"], state["time"] = 0.75 * length, 1000.0
        out = self.run_from(state, shear__strain=0.5)
        self.assertAlmostEqual(read_state(out)["offset"] / length, 0.25, delta=1e-12)
        self.assertEqual(read_summary(out)["strain"]["total"], 0.5)
        self.assertLessEqual(read_series(out)["strain"][-1], 0.5)

    def test_offset_matters_to_a_contact_across_the_boundary(self):
        """Two disks touch across y = L only because the row above is displaced by the offset."""
        state = lattice_state(16, 0.05)
        length = state["box_length"]
        state["diameter"] = np.tile([1.0, 1.4], 8)
        state["offset"] = 0.3 * length
        state["position"][0] = [0.5, 0.05]  # seen above at (0.5 + 0.3 L, L + 0.05)
        state["position"][2] = [0.5 + 0.3 * length, length - 0.85]
        out = self.run_from(state, disks__count=16, disks__packing_fraction=0.05,
                            output__sample_strain=2.0**-11, shear__strain=2.0**-11,
                            measure__every=1, shear__discard=0)
        self.assertAlmostEqual(read_series(out)["Z"][0], 2 / 16, delta=1e-12)

    def test_a_run_goes_on_from_its_own_state(self):
        """No jump at the seam: the state says all there is to know."""
        for model in ("CD", "CD_n", "CD_rot"):
            with self.subTest(model=model):
                changes = {"disks__model": model, "disks__packing_fraction": 0.84}
                whole = read_state(self.run_new(f"{model}0", shear__strain=2.0**-3, **changes))
                half = self.run_new(f"{model}1", shear__strain=2.0**-4, **changes)
                rest = read_state(self.run_new(
                    f"{model}2", shear__strain=2.0**-4, start__kind="state",
                    start__file=f"{model}1/state.h5", **changes))
                self.assertAlmostEqual(whole["offset"], rest["offset"], delta=1e-10)
                away = whole["position"] - rest["position"]
                rows = np.rint(away[:, 1] / whole["box_length"])
                away[:, 1] -= rows * whole["box_length"]
                away[:, 0] -= rows * whole["offset"]
                away[:, 0] -= whole["box_length"] * np.rint(away[:, 0] / whole["box_length"])
                self.assertLess(np.max(np.abs(away)), 1e-7)
                self.assertTrue((half / "state.h5").exists())
                if model == "CD_rot":
                    self.assertLess(np.max(np.abs(whole["spin"] - rest["spin"])), 1e-7)

    def test_last_state_has_the_form_of_a_state_file(self):
        for model in ("CD", "CD_rot"):
            state = read_state(self.run_new(model, disks__model=model))
            self.assertEqual(state["position"].shape, (64, 2))
            self.assertEqual(state["velocity"].shape, (64, 2))
            self.assertEqual(state["diameter"].shape, (64,))
            self.assertEqual("spin" in state, model == "CD_rot")
            self.assertEqual(sorted(set(state["diameter"])), [1.0, 1.4])
            self.assertEqual(np.sum(state["diameter"] == 1.0), 32)
            self.assertAlmostEqual(state["box_length"], box_length(64, 0.8), delta=1e-12)
            self.assertAlmostEqual(state["offset"], 2.0**-3 * state["box_length"], delta=1e-12)
            self.assertEqual(state["time"], 16.0)
            self.assertEqual(state["strain_rate"], RATE)
            for name in ("position", "velocity", "diameter"):
                self.assertEqual(state[name].dtype, np.float64)


class Rescaled(CliTest):
    own = np.where(np.arange(64) % 2 == 0, 2.0**-10, -(2.0**-10))

    def final(self, name, rate=None, **changes):
        state = {**lattice_state(), "spin": np.full(64, 2.0**-9)}
        state["velocity"][:, 0] += self.own  # against each other: so slow that nobody meets anybody
        if rate is not None:
            state["strain_rate"] = rate
        write_state(self.folder / "start.h5", state)
        out = self.run_new(name, **{**FREE, "disks__model": "CD_rot", **changes})
        return read_state(out)

    def expect(self, final, factor):
        """Velocities against each other are scaled; the mean is that of the flow."""
        middle = RATE * lattice_state()["position"][:, 1].mean()
        np.testing.assert_allclose(final["velocity"][:, 0], middle + factor * self.own, rtol=0, atol=1e-15)
        self.assertTrue((final["velocity"][:, 1] == 0).all())
        self.assertTrue((final["spin"] == 2.0**-9 * factor).all())

    def test_velocities_follow_the_rate(self):
        self.expect(self.final("none"), 1)
        self.expect(self.final("equal", RATE), 1)
        self.expect(self.final("slower", 4 * RATE), 0.25)
        self.expect(self.final("faster", RATE / 2), 2)

    def test_it_can_be_turned_off(self):
        self.expect(self.final("off", 4 * RATE, start__rescale=False), 1)
        self.expect(self.final("on", 4 * RATE, start__rescale=True), 0.25)


class Copies(CliTest):
    """start.copies: side by side, the flow of copies is that of the state until rounding errors have grown."""

    def setUp(self):
        super().setUp()
        made = self.run_new("made", disks__count=64, disks__box_aspect=2.0, disks__model="CD_rot",
                            shear__strain=0.4)
        (self.folder / "start.h5").write_bytes((made / "state.h5").read_bytes())

    def go_on(self, name, count, aspect, **changes):
        return self.run_new(name, disks__count=count, disks__box_aspect=aspect, disks__model="CD_rot",
                            start__kind="state", start__file="start.h5", **changes)

    def test_the_flow_is_that_of_one(self):
        one = self.go_on("one", 64, 2.0)
        for count, aspect in ((128, 1.0), (128, 4.0), (256, 2.0), (384, 3.0)):
            with self.subTest(count=count, aspect=aspect):
                many = self.go_on(f"{count}-{aspect}", count, aspect, start__copies=True)
                expected, found = read_series(one), read_series(many)
                for name in ("p", "sigma", "p_dis", "p_kin", "Z"):
                    scale = np.abs(expected[name]).max()
                    self.assertGreater(scale, 0, name)
                    np.testing.assert_allclose(found[name], expected[name], rtol=0, atol=1e-9 * scale)
                with h5py.File(many / "result.h5") as file:
                    self.assertEqual(file.attrs["start_copies"], count / 64)

    def test_so_it_is_at_another_rate_and_without_scaling(self):
        for rescale in (True, False):
            changes = {"shear__strain_rate": RATE / 2, "start__rescale": rescale}
            one = self.go_on(f"one-{rescale}", 64, 2.0, **changes)
            for count, aspect in ((128, 1.0), (128, 4.0)):
                with self.subTest(rescale=rescale, aspect=aspect):
                    many = self.go_on(f"{aspect}-{rescale}", count, aspect, start__copies=True, **changes)
                    expected, found = read_series(one), read_series(many)
                    scale = np.abs(expected["p"]).max()
                    np.testing.assert_allclose(found["p"], expected["p"], rtol=0, atol=1e-9 * scale)

    def test_copies_part(self):
        """As far as independent disks, without a push: rounding errors grow."""
        many = read_state(self.go_on("many", 128, 1.0, start__copies=True, shear__strain=8.0,
                                     shear__strain_rate=2.0**-10))
        one, other = many["velocity"][:64, 1], many["velocity"][64:, 1]
        self.assertGreater(np.std(one - other), np.std(one))

    def test_refusals(self):
        self.refused(self.scene(disks__count=64, start__copies=True), "start.copies", "random start")
        self.refused(self.scene(disks__count=100, disks__box_aspect=2.0, disks__model="CD_rot",
                                start__kind="state", start__file="start.h5", start__copies=True),
                     "64 disks", "set disks.count = 64")


class Refused(CliTest):
    def refuse(self, state, *words, **changes):
        write_state(self.folder / "start.h5", state)
        self.refused(self.scene(**{**FREE, **changes}), *words)

    def test_disagreement_with_the_scene(self):
        state = lattice_state()
        self.refuse(lattice_state(36), "count")
        self.refuse({**state, "box_length": state["box_length"] * (1 + 1e-8)}, "box_length")
        self.refuse({**state, "box_length": -state["box_length"]}, "box_length")
        self.refuse({**state, "diameter": state["diameter"] * 1.1}, "diameter")
        self.refuse({**state, "diameter": np.ones(64)}, "diameter")
        self.refuse({**state, "diameter": np.where(np.arange(64) < 31, 1.0, 1.4)}, "diameter")

    def test_a_box_within_rounding_is_accepted(self):
        state = lattice_state()
        length = state["box_length"] * (1 + 5e-10)
        write_state(self.folder / "start.h5", {**state, "box_length": length})
        out = self.run_new("out", **FREE)
        self.assertEqual(read_state(out)["box_length"], length)

    def test_missing_parts(self):
        for name in ("position", "velocity", "diameter", "box_length", "offset"):
            with self.subTest(name=name):
                state = lattice_state()
                del state[name]
                self.refuse(state, name)

    def test_wrong_shapes_and_values(self):
        state = lattice_state()
        bad = state["position"].copy()
        bad[3, 1] = np.nan
        self.refuse({**state, "position": bad}, "position")
        self.refuse({**state, "velocity": bad}, "velocity")
        self.refuse({**state, "position": state["position"].T.copy()}, "position")
        self.refuse({**state, "velocity": np.zeros((64, 3))}, "velocity")
        self.refuse({**state, "velocity": np.zeros((63, 2))}, "velocity")
        self.refuse({**state, "diameter": np.ones((64, 1))}, "diameter")
        self.refuse({**state, "position": np.array([b"text"] * 64)}, "position")
        self.refuse({**state, "offset": np.inf}, "offset")
        self.refuse({**state, "strain_rate": np.nan}, "strain_rate")

    def test_spin(self):
        """Too many spins do no harm; missing ones are named or follow from the shear."""
        write_state(self.folder / "start.h5", {**lattice_state(), "spin": np.zeros(64)})
        result = self.bagnold("run", self.scene(**FREE), "--out", self.folder / "extra")
        self.assertIn(result.returncode, (0, 2), result.stderr)
        write_state(self.folder / "start.h5", lattice_state())
        result = self.bagnold("run", self.scene(**{**FREE, "disks__model": "CD_rot"}),
                              "--out", self.folder / "missing")
        if result.returncode == 0:
            self.assertTrue((read_state(self.folder / "missing")["spin"] == -RATE / 2).all())
        else:
            self.assert_clean_error(result, 2, "spin")

    def test_not_a_state_file(self):
        path, scene = self.folder / "start.h5", self.scene(**FREE)
        for content in (b"", b"hello", b"\x89HDF\r\n\x1a\n" + bytes(4096)):
            path.write_bytes(content)
            self.refused(scene, "start.h5")
        with h5py.File(path, "w") as file:
            file["other"] = 1
        self.refused(scene, "state")
        write_state(path, lattice_state())
        whole = path.read_bytes()
        for size in (100, len(whole) // 2, len(whole) - 1):
            path.write_bytes(whole[:size])
            self.refused(scene, "start.h5")
        path.unlink()
        path.mkdir()
        self.refused(scene, "start.h5")

    def test_links_out_of_the_file(self):
        state = lattice_state()
        write_state(self.folder / "real.h5", state)
        secret = self.folder / "secret.bin"
        secret.write_bytes(state["position"].tobytes())
        path, scene = self.folder / "start.h5", self.scene(**FREE)
        with h5py.File(path, "w") as file:
            file["state"] = h5py.ExternalLink(str(self.folder / "real.h5"), "/state")
        self.refused(scene)
        for kind in ("link", "storage", "virtual", "group"):
            with self.subTest(kind=kind):
                write_state(path, {k: v for k, v in state.items() if k != "position"})
                with h5py.File(path, "r+") as file:
                    self.reach_out(file["state"], kind, secret)
                self.refused(scene, "position")

    def reach_out(self, group, kind, secret):
        real = str(self.folder / "real.h5")
        if kind == "link":
            group["position"] = h5py.ExternalLink(real, "/state/position")
        elif kind == "storage":
            group.create_dataset("position", (64, 2), "f8", external=[(str(secret), 0, 1024)])
        elif kind == "virtual":
            layout = h5py.VirtualLayout((64, 2), "f8")
            layout[:] = h5py.VirtualSource(real, "state/position", (64, 2))
            group.create_virtual_dataset("position", layout)
        else:
            group.create_group("position")

    def test_declared_terabytes(self):
        path, scene = self.folder / "start.h5", self.scene(**FREE)
        for shape in ((10**12, 2), (64, 2**40)):
            write_state(path, {k: v for k, v in lattice_state().items() if k != "position"})
            with h5py.File(path, "r+") as file:
                file["state"].create_dataset("position", shape, "f8", chunks=(64, 2))
            self.refused(scene, "position")


class Path(CliTest):
    def test_file_is_relative_to_the_scene(self):
        (self.folder / "deep").mkdir()
        write_state(self.folder / "deep" / "start.h5", lattice_state())
        scene = self.scene(name="deep/scene.toml", **FREE)
        out = self.folder / "out"
        self.run_scene(scene, out, cwd="/")
        again = self.folder / "again"  # the resolved scene stands elsewhere and still finds it
        self.run_scene(out / "scene.toml", again, cwd="/")
        self.assert_same_state(out, again)
        result = self.bagnold("validate", self.scene(**FREE), cwd=self.folder / "deep")
        self.assert_clean_error(result, 2, "start.h5")


if __name__ == "__main__":
    unittest.main()
