# SPDX-License-Identifier: BSD-3-Clause
"""scripts/coverage: what it says of runs is what their summaries say."""

import re
import subprocess
import sys
import unittest

from bagnold import PROGRAM, SOURCE, CliTest, Raw, read_summary

NUMBER = r"[-+]?[\d.]+(?:e[-+]\d+)?"


class Coverage(CliTest):
    def coverage(self, scene):
        out = self.folder / "coverage"
        command = [SOURCE / "scripts/coverage", "--scene", scene, "--bagnold", PROGRAM, "--out", out,
                   "--runs", "3", "--truth", "3", "--truth-strain", "2"]
        result = subprocess.run([sys.executable, *command], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return out, result.stdout

    def test_counts_and_means_are_those_of_the_summaries(self):
        scene = self.scene(shear__strain=24.0, output__sample_strain=2.0**-5,
                           shear__target_error=Raw("{ B_p = 0.3 }"))
        out, said = self.coverage(scene)
        truth = read_summary(out / "truth3")
        runs = [read_summary(out / f"1_{run:04d}") for run in range(3)]
        self.assertEqual([run["scene"]["disks"]["seed"] for run in runs], [1, 2, 3])
        self.assertEqual(truth["scene"]["shear"]["target_error"], {})
        mean = truth["observables"]["B_p"]["mean"]
        z = [(run["observables"]["B_p"]["mean"] - mean) / run["observables"]["B_p"]["error"] for run in runs]
        for limit in (2, 3):
            self.assertIn(f"> {limit}: {sum(abs(one) > limit for one in z)}", said)
        bias = float(re.search(rf"bias ({NUMBER})", said)[1])
        self.assertAlmostEqual(bias, sum(run["observables"]["B_p"]["mean"] for run in runs) / 3 / mean - 1,
                               delta=1e-4)
        reached = sum(run["target_error_reached"] for run in runs)
        self.assertIn(f"{reached} reached their target", said)
        before = [(out / f"1_{run:04d}/summary.json").read_bytes() for run in range(3)]
        self.assertEqual(self.coverage(scene)[1], said)
        self.assertEqual(before, [(out / f"1_{run:04d}/summary.json").read_bytes() for run in range(3)])


if __name__ == "__main__":
    unittest.main()
