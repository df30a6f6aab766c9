# SPDX-License-Identifier: BSD-3-Clause
"""What `validate` says of time: by what costs, not by counts of steps. How true it is, is in
docs/run_time.md; here only what no machine can be too slow or too busy for."""

import re
import unittest

from bagnold import Raw, lattice_state, write_state
from sweeps import SweepTest

SECONDS = {"s": 1, "min": 60, "h": 3600, "days": 86400}
TIME = r"([\d.e+-]+) (s|min|h|days)"
DILUTE = {"disks__model": "CD_n", "disks__count": 256, "disks__packing_fraction": 0.6,
          "disks__elasticity": 50.0, "integration__time_step": None, "output__sample_strain": 1e-2}
EVERYTHING = {f"measure__{name}": True for name in "contacts correlations profiles fields".split()}


def times(text, before):
    """[seconds] of all "BEFORE 3 s (2 s to 6 s)", each three."""
    found = re.findall(rf"{before} +{TIME} \({TIME} to {TIME}\)", text)
    return [[float(n) * SECONDS[unit] for n, unit in zip(one[::2], one[1::2])] for one in found]


class RunTime(SweepTest):
    def said(self, before="estimated time", **changes):
        result = self.bagnold("validate", self.scene(**changes))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return times(result.stdout, before)

    def test_bounds_hold_the_estimate(self):
        [(expected, least, most)] = self.said(shear__strain=100.0)
        self.assertTrue(0 < least < expected < most)

    def test_a_dilute_state_costs_by_strain_not_by_steps(self):
        fast, slow = (self.said(**DILUTE, shear__strain_rate=rate, shear__strain=1e4)[0][0]
                      for rate in (1e-4, 1e-6))
        self.assertLess(slow, 20 * fast)  # 100 times the steps

    def test_measuring_costs(self):
        plain = {"disks__count": 256, "shear__strain": 300.0, "output__sample_strain": 1.0}
        bare = self.said(**plain)[0][0]
        full = self.said(**plain, **EVERYTHING, measure__frame_strain=1e-3)[0][0]
        self.assertGreater(full, 3 * bare)  # looks at all disks every few steps

    def test_replicas_count(self):
        one, all = (self.said(shear__strain=1e3, disks__replicas=r)[0][0] for r in (1, 100))
        self.assertGreater(all, 20 * one)

    def test_a_cascade_is_the_sum_of_its_rates(self):
        changes = {"shear__protocol": "cascade", "shear__strain_rate": None, "shear__strain": 1e3,
                   "shear__strain_rates": Raw("[1e-2, 1e-3]")}
        rates = self.said(**changes)
        [(whole, _, _)] = self.said("all 2 rates", **changes)
        self.assertEqual(len(rates), 2)
        self.assertGreater(whole, rates[0][0])

    def test_a_ramp_and_a_given_state_have_a_time(self):
        ramp = {"shear__protocol": "ramp", "shear__strain": 2.0**-5, "shear__discard": None,
                "shear__strain_rate": 2.0**-10, "shear__strain_rate_high": 2.0**-7,
                "shear__ramp_rate": 0.003, "shear__ramp_window": 32.0, "output__sample_strain": None}
        self.assertEqual(len(self.said(**ramp)), 1)
        write_state(self.folder / "state.h5", lattice_state())
        given = {"start__kind": "state", "start__file": "state.h5", "disks__packing_fraction": 0.1}
        self.assertEqual(len(self.said(**given)), 1)

    def test_says_how_it_was_found(self):
        self.assertRegex(self.bagnold("validate", self.scene()).stdout, r"# +from .* s of 64 such disks")
        path = self.sweep_file(grid={"disks.elasticity": [1, 2, 4], "disks.seed": [1, 2]})
        self.assertIn("from trials of 3 of them", self.bagnold("validate", path).stdout)

    def test_what_cannot_be_tried_is_told_by_steps(self):
        """Disks that outrun the list at the first step."""
        state = lattice_state()
        state["velocity"][5] = [0.0, 1e3]
        write_state(self.folder / "state.h5", state)
        given = {"start__kind": "state", "start__file": "state.h5", "disks__packing_fraction": 0.1}
        said = self.bagnold("validate", self.scene(**given)).stdout
        self.assertIn("by the number of steps alone", said)

    def test_nothing_is_written(self):
        path = self.scene(**EVERYTHING, disks__count=256, output__trajectory_strain=1e-3, output__plot=True)
        self.bagnold("validate", path)
        self.assertEqual([file.name for file in self.folder.iterdir()], [path.name])

    def test_points_of_a_sweep_are_told_by_their_neighbours(self):
        """Twenty points, eight trials: all of them count."""
        def whole(seeds):
            path = self.sweep_file(grid={"disks.elasticity": [1 + k / 10 for k in range(20)],
                                         "disks.seed": list(range(seeds))}, shear__strain=1e3)
            return times(self.bagnold("validate", path).stdout, "estimated time")[0][0]

        self.assertGreater(whole(20), 5 * whole(1))


if __name__ == "__main__":
    unittest.main()
