# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold check-limit`: the scene at its rate and at half of it."""

import json
import re
import shlex
import signal
import unittest

import numpy as np

from bagnold import CliTest, SCENE, read_summary

RATIOS = {"Bagnold": ("B_p", "B_sigma"), "Newton": ("eta_p", "eta_sigma")}


class CheckLimit(CliTest):
    def check(self, name, *arguments, **changes):
        out = self.folder / name
        result = self.bagnold("check-limit", self.scene(**changes), "--out", out, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((out / "check_limit.json").read_text()), result.stdout, out

    def test_numbers_are_those_of_the_two_runs(self):
        found, said, out = self.check("one", shear__strain=8.0, disks__replicas=3)
        rate = SCENE["shear"]["strain_rate"]
        self.assertEqual(found["strain_rates"], [rate, rate / 2])
        self.assertEqual(found["tolerance"], 0.05)
        whole, half = (read_summary(folder) for folder in sorted((out / "points").iterdir()))
        self.assertEqual([run["scene"]["shear"]["strain_rate"] for run in (whole, half)], [rate, rate / 2])
        for limit, names in RATIOS.items():
            for name in names:
                a, b = (run["observables"][name] for run in (whole, half))
                ratio = found["limits"][limit]["ratios"][name]
                self.assertAlmostEqual(ratio["value"], b["mean"] / a["mean"], places=12)
                error = ratio["value"] * np.hypot(a["error"] / a["mean"], b["error"] / b["mean"])
                self.assertAlmostEqual(ratio["error"], error, places=12)
                self.assertIn(name, said)
        x = found["exponents"]["p"]
        p = [run["observables"]["p"]["mean"] for run in (whole, half)]
        self.assertAlmostEqual(x["value"], np.log2(p[0] / p[1]), places=12)
        self.assertIn(f"verdict: {found['verdict']}", said)

    def test_a_newtonian_and_a_bagnoldian_state(self):
        """P2 Sec. III A: CD is Newtonian below Q_c and Bagnoldian above; 0.6 is far from jamming."""
        for elasticity, verdict, other in ((1.0, "Newton", "Bagnold"), (50.0, "Bagnold", "Newton")):
            found, _, _ = self.check(
                verdict, "--tolerance", "0.2", disks__model="CD", disks__count=128, disks__replicas=8,
                disks__packing_fraction=0.7, disks__elasticity=elasticity, shear__strain_rate=2e-3,
                shear__strain=8.0, integration__time_step=0.05, measure__every=10,
                output__sample_strain=2.0**-4)
            self.assertEqual(found["verdict"], verdict, json.dumps(found))
            self.assertEqual(found["limits"][other]["verdict"], "fails")

    def test_too_short_to_tell(self):
        found, said, _ = self.check("short")
        self.assertEqual(found["verdict"], "undecided")
        self.assertIn("undecided", said)

    def test_the_command_that_goes_on_is_the_same_but_longer(self):
        out = self.folder / "blanks in it"
        words = ("--set", "disks.seed=3", "--set", "title='a b'", "--tolerance", 0.02)
        said = self.bagnold("check-limit", self.scene(), "--out", out, *words)
        self.assertEqual(said.returncode, 0, said.stderr)
        command = re.search(r"`bagnold (check-limit .*--set shear.strain=)[^`]*?( --out [^`]*)` goes on", said.stdout)
        longer = shlex.split(f"{command[1]}0.75{command[2]}")
        self.assertEqual(self.bagnold(*longer).returncode, 0)
        found = json.loads((out / "check_limit.json").read_text())
        self.assertEqual(found["tolerance"], 0.02)
        points = [read_summary(point)["scene"] for point in (out / "points").iterdir()]
        self.assertEqual([(one["disks"]["seed"], one["shear"]["strain"]) for one in points], [(3, 0.75)] * 2)

    def test_the_command_after_a_failed_point(self):
        out, scene = self.folder / "failed", self.scene(shear__strain_rate=0.5, disks__packing_fraction=0.84)
        said = self.bagnold("check-limit", scene, "--out", out, "--set", "disks.seed=3", "--set", "shear.strain=20")
        self.assertNotEqual(said.returncode, 0, said.stderr)
        command = re.search(r"`bagnold (check-limit .*)` tries them again", said.stderr)
        self.assertIsNotNone(command, said.stderr)
        again = self.bagnold(*shlex.split(command[1]))
        self.assertNotIn("holds the sweep of another file", again.stderr)
        self.assertIn("tries them again", again.stderr)

    def test_disks_that_never_met_tell_nothing(self):
        """Their B_p is rounding, 1e-33, with an error of 0."""
        found, said, out = self.check(
            "alone", disks__model="CD_n", disks__count=16, disks__packing_fraction=0.05, disks__seed=1,
            shear__strain_rate=1e-3, shear__strain=0.5, integration__time_step=None, measure__every=None,
            output__sample_strain=None)
        self.assertEqual(found["verdict"], "undecided", json.dumps(found))
        for limit in found["limits"].values():
            self.assertEqual(limit["verdict"], "undecided", json.dumps(found))
        again = self.bagnold("check-limit", out.parent / "scene1.toml", "--out", out)
        self.assertIn("few_collisions", again.stderr)
        self.assertRegex(again.stderr, r"`bagnold check-limit \S+scene1.toml --out")

    def test_goes_on_where_it_was_stopped(self):
        changes = dict(shear__strain=96.0, output__sample_strain=2.0**-2, output__checkpoint_minutes=0.001)
        path = self.scene(**changes)
        whole, _, _ = self.check("whole", **changes)
        process = self.start("check-limit", path, "--out", "cut")
        points = self.folder / "cut" / "points"
        self.wait_until(lambda: list(points.glob("*/checkpoint.h5")), process)
        process.send_signal(signal.SIGTERM)
        code, said = self.finish(process)
        self.assertIn(code, (0, 143), said)
        result = self.bagnold("check-limit", path, "--out", self.folder / "cut", "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(json.loads((self.folder / "cut" / "check_limit.json").read_text()), whole)

    def test_one_rate_only(self):
        path = self.scene(shear__protocol="cascade", shear__strain_rate=None,
                          shear__strain_rates=[2.0**-6, 2.0**-7])
        self.assert_clean_error(self.bagnold("check-limit", path), 2, "shear.protocol", "cascade")


if __name__ == "__main__":
    unittest.main()
