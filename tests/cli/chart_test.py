# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold chart`: bias against seconds of all methods that can do a scene."""

import csv
import math
import signal
import unittest

from bagnold import CliTest, Raw

DENSE = {"disks__count": 64, "disks__model": "CD", "disks__packing_fraction": 0.82, "shear__strain_rate": 1e-3,
         "shear__strain": 2.0, "integration__time_step": "auto", "measure__every": 10, "output__sample_strain": 0.01}
FEW = ("--strain", 0.2, "--states", 4)


def chart_in(out):
    with open(out / "chart.csv") as file:
        return {(row["scheme"], float(row["time_step"])): row for row in csv.DictReader(file)}


class Chart(CliTest):
    def chart(self, *arguments, **changes):
        out = self.folder / "out"
        done = self.bagnold("chart", self.scene(**{**DENSE, **changes}), "--out", out, *FEW, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, chart_in(out)

    def test_methods_of_a_dense_flow(self):
        text, rows = self.chart()
        self.assertLessEqual({("implicit-damping", 1.6), ("implicit-damping", 0.8), ("two-stage-leapfrog", 0.4),
                              ("two-stage-leapfrog", 0.2), ("two-stage-leapfrog", 0.1),
                              ("modified-velocity-verlet", 0.05)}, set(rows))
        for (scheme, step), row in rows.items():
            self.assertGreater(float(row["seconds"]), 0)
            self.assertAlmostEqual(float(row["disk_steps"]), 64 / (step * 1e-3), delta=1e-6)
            self.assertIn(row["verdict"], ("accepted", "open", "refused"), (scheme, step))
            for name in ("p", "sigma", "Z", "T_g", "mu"):
                self.assertTrue(math.isfinite(float(row[f"{name}_bias"])))
        # Two stages are of second order: half the step, a quarter of the bias of what is smooth.
        self.assertLess(abs(float(rows["two-stage-leapfrog", 0.05]["p_bias"])), 0.01)
        self.assertLess(float(rows["two-stage-leapfrog", 0.2]["seconds"]),
                        float(rows["two-stage-leapfrog", 0.05]["seconds"]))
        self.assertIn("results in", text)
        self.assertRegex(text, r"implicit-damping +1\.6 ")
        self.assertTrue((self.folder / "out/chart.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_coarse_step_is_refused(self):
        _, rows = self.chart(disks__model="CD_n", disks__elasticity=50.0, disks__packing_fraction=0.7, disks__count=256)
        self.assertEqual(rows["two-stage-leapfrog", 0.4]["verdict"], "refused")
        self.assertNotIn(("implicit-damping", 0.4), rows)

    def test_cascade_is_charted_at_its_last_rate(self):
        """With a smaller accuracy than a run of this scheme would look at: a chart does."""
        text, rows = self.chart(shear__protocol="cascade", shear__strain_rate=None, shear__strain_rates=Raw("[1e-2, 2e-3]"),
                                integration__scheme="two-stage-leapfrog", integration__accuracy=0.004)
        self.assertIn("0.4%", text)
        self.assertAlmostEqual(float(rows["two-stage-leapfrog", 0.2]["disk_steps"]), 64 / (0.2 * 2e-3))

    def test_refused_scenes(self):
        ramp = self.scene(**DENSE, shear__protocol="ramp", shear__strain_rate_high=1e-2, shear__ramp_rate=1e-3)
        self.assert_clean_error(self.bagnold("chart", ramp), 2, "shear.protocol", "ramp")
        noise = self.scene(**DENSE, drive__kind="thermal", drive__drag=0.1, drive__temperature=1e-6)
        self.assert_clean_error(self.bagnold("chart", noise), 2, "drive.kind", "thermal")

    def test_interrupted(self):
        process = self.start("chart", self.scene(**{**DENSE, "disks__count": 1024}), "--out", self.folder / "out",
                             "--states", 500)
        self.wait_until(lambda: (self.folder / "out").is_dir(), process)
        process.send_signal(signal.SIGINT)
        code, said = self.finish(process)
        self.assertEqual(code, 130)
        self.assertRegex(said, r"stopped after \d+ of 500 states; a chart keeps no checkpoint")


if __name__ == "__main__":
    unittest.main()
