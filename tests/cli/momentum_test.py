# SPDX-License-Identifier: BSD-3-Clause
"""What disks of a start have of motion together: no force changes it, so a run takes it off, and says so."""

import unittest

import h5py
import numpy as np

from bagnold import CliTest, box_length, lattice_state, read_series, read_state, read_summary, write_state

RATE = 2.0**-7
FROM_REST = """ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
4
ITEM: BOX BOUNDS pp pp pp
0 6
0 6
-0.5 0.5
ITEM: ATOMS id type x y vx vy radius mass
1 1 1 1.5 -0.015 0 0.5 1
2 1 4 1.5 -0.015 0 0.5 1
3 2 1 4.5 0.015 0 0.7 1
4 2 4 4.5 0.015 0 0.7 1
"""


def momentum(state, rate, by_area=False):
    """sum m (v - gammadot y x^) over sum m |v - gammadot y x^|, of each replica."""
    mass = state["diameter"] ** 2 if by_area else np.ones_like(state["diameter"])
    own = state["velocity"] - rate * state["position"][..., 1:] * [1.0, 0.0]
    weighed = mass[..., None] * own
    return np.linalg.norm(weighed.sum(-2), axis=-1) / np.linalg.norm(weighed, axis=-1).sum(-1)


class Momentum(CliTest):
    def state(self, rate=RATE, boost=(0.02, -0.01), count=64, phi=0.4):
        """A lattice in the shear flow, with motions that differ by size, all faster by `boost`."""
        state = lattice_state(count, phi)
        random = np.random.default_rng(3)
        big = state["diameter"] > 1.2
        state["velocity"] = random.normal(scale=2 * RATE, size=(count, 2)) + np.outer(big, [RATE, -RATE]) + boost
        state["velocity"][:, 0] += rate * state["position"][:, 1]
        return {**state, "strain_rate": rate}

    def run_from(self, state, name, said=True, **changes):
        write_state(self.folder / "start.h5", state)
        out = self.folder / name
        scene = self.scene(**{"disks__packing_fraction": 0.4, "start__kind": "state", "start__file": "start.h5",
                              **changes})
        result = self.run_scene(scene, out)
        self.assertEqual("the mean motion against the shear flow" in result.stdout, said, result.stdout)
        return out

    def note(self, out):
        summary = read_summary(out)
        self.assertNotIn("net_momentum", [one["name"] for one in summary["warnings"]])
        (note,) = [one for one in summary["notes"] if one["name"] == "net_momentum"]
        self.assertIn("taken off", note["reason"])
        with h5py.File(out / "result.h5") as file:
            for name, value in note["numbers"].items():
                self.assertIn(value, np.atleast_1d(file.attrs[name]))
        return note["numbers"]

    def test_it_is_taken_off_at_every_start(self):
        at_rest = {**self.state(), "velocity": np.zeros((64, 2))}
        del at_rest["strain_rate"]
        two = {name: np.stack([value, np.roll(value, 1, axis=0)]) if np.ndim(value) else value
               for name, value in self.state().items()}
        two["diameter"] = np.stack([self.state()["diameter"]] * 2)
        for name, state, changes in (
                ("as it is", self.state(), {}), ("across alone", self.state(boost=(0.0, 0.01)), {}),
                ("other masses", self.state(), {"disks__mass": "area"}), ("at rest", at_rest, {}),
                ("other rate", self.state(4 * RATE), {}),
                ("not scaled", self.state(4 * RATE), {"start__rescale": False}),
                ("copies", self.state(), {"start__copies": True, "disks__count": 256}),
                ("replicas", two, {"disks__replicas": 2}),
                ("no spins", self.state(), {"disks__model": "CD_n"}),
                ("relaxed", self.state(), {"start__relax": True})):
            with self.subTest(name):
                out = self.run_from(state, name.replace(" ", "_"), **changes)
                by_area = changes.get("disks__mass") == "area"
                self.assertLess(np.max(momentum(read_state(out), RATE, by_area)), 1e-13)
                self.assertGreater(self.note(out)["start_mean_motion_share"], 0.01)

    def test_in_cascades_and_ramps(self):
        out = self.run_from(self.state(2 * RATE), "cascade", shear__protocol="cascade", shear__strain_rate=None,
                            shear__strain_rates=[2 * RATE, RATE])
        points = read_summary(out)["points"]
        self.assertEqual([[one["name"] for one in point["notes"]].count("net_momentum") for point in points], [1, 0])
        self.assertLess(momentum(read_state(out / points[1]["folder"]), RATE), 1e-13)
        out = self.run_from(self.state(2.0**-8), "ramp", shear__protocol="ramp", shear__strain_rate=2.0**-8,
                            shear__strain_rate_high=2.0**-6, shear__ramp_rate=2.0**-8, shear__discard=None,
                            shear__ramp_window=8.0, shear__strain=2.0**-5, output__sample_strain=None)
        state = read_state(out)
        self.assertLess(momentum(state, state["strain_rate"]), 1e-13)
        self.note(out)

    def test_the_rest_is_as_without_it(self):
        """The same pressures, up to rounding, as from the state that has none."""
        boosted = self.run_from(self.state(boost=(0.3, -0.2)), "boosted")
        state = self.state(boost=(0, 0))
        own = state["velocity"] - RATE * state["position"][:, 1:] * [1.0, 0.0]
        state["velocity"] -= own.mean(axis=0)
        plain = self.run_from(state, "plain", said=False)
        self.assertNotIn("net_momentum", [one["name"] for one in read_summary(plain)["notes"]])
        for name in ("p", "p_kin", "Z", "R_v"):
            expected = read_series(plain)[name]
            np.testing.assert_allclose(read_series(boosted)[name], expected, atol=1e-9 * np.abs(expected).max())

    def test_a_state_of_ones_own_has_none(self):
        first = self.run_new("first")
        state = read_state(first)
        again = {**state, "strain_rate": RATE}
        write_state(self.folder / "start.h5", again)
        out = self.run_new("second", start__kind="state", start__file="start.h5", shear__strain=2.0**-6,
                           shear__discard=0)
        self.assertNotIn("net_momentum", [one["name"] for one in read_summary(out)["notes"]])

    def test_a_run_that_goes_on_has_the_bits_of_one_that_did_not_stop(self):
        changes = {"disks__packing_fraction": 0.4, "start__kind": "state", "start__file": "start.h5"}
        whole = self.run_from(self.state(), "whole", shear__strain=2.0**-2)
        half = self.run_new("half", shear__strain=2.0**-3, **changes)
        result = self.bagnold("resume", half, "--strain", 2.0**-2)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("taken off\n", result.stdout)  # nothing is at a resume
        self.assert_same_results(whole, half)
        self.assertEqual(read_summary(whole)["notes"], read_summary(half)["notes"])

    def imported(self, *options):
        file = self.folder / "rest.lammpstrj"
        file.write_text(FROM_REST)
        result = self.bagnold("import", file, "--out", self.folder / "start.h5", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        phi = 2 * np.pi / 4 * (1 + 1.96) / 36
        self.assertAlmostEqual(box_length(4, phi), 6, 12)
        return {"disks__count": 4, "disks__packing_fraction": float(phi), "disks__model": "CD_n",
                "start__kind": "state", "start__file": "start.h5", "shear__strain_rate": 0.01,
                "integration__time_step": 0.1, "shear__strain": 0.5}

    def test_imports_with_and_without_a_rate(self):
        """A box sheared about its middle, v_x = 0.01 (y - 3): at either import the run is that of v_x = 0.01 y."""
        found = []
        for options in ((), ("--strain-rate", "0.01")):
            changes = self.imported(*options)
            out = self.run_new(f"out{len(options)}", **changes)
            state = read_state(out)
            own = state["velocity"] - 0.01 * state["position"][:, 1:] * [1.0, 0.0]
            self.assertLess(np.abs(own.sum(axis=0)).max(), 1e-15)
            found.append(read_series(out)["p"])
        self.assertLess(np.abs(found[0]).max(), 1e-30)  # of the shear flow itself, no two disks meet
        np.testing.assert_allclose(found[0], found[1], atol=1e-30)


if __name__ == "__main__":
    unittest.main()
