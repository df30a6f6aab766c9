# SPDX-License-Identifier: BSD-3-Clause
"""Runs driven over the edges of the method: each is refused, stopped with a reason, or warned of.

Whatever a run over an edge does, it must not end with exit code 0 and nothing said.
"""

import os
import unittest

from bagnold import PAPERS, CliTest, changed, read_summary, scene_text

# A state that is not over an edge: dense, slow, long enough for errors.
SOUND = {
    "disks": {"model": "CD_n", "count": 256, "packing_fraction": 0.78, "elasticity": 1.0,
              "mass": "area"},
    "shear": {"strain_rate": 1e-3, "strain": 40.0},
    "integration": {"time_step": 0.1},
    "output": {"plot": False},
}


class Edges(CliTest):
    def over(self, *arguments, **changes):
        """(exit code, names of warnings and notes, what was said)"""
        path = self.scene(SOUND, **changes)
        out = self.folder / f"out{self.written}"
        result = self.bagnold("run", path, "--out", out, "--threads", "1", *arguments)
        names = []
        if result.returncode == 0:
            summary = read_summary(out)
            names = [one["name"] for one in summary["warnings"] + summary["notes"]]
        return result.returncode, names, result.stderr

    def test_a_sound_run_says_nothing(self):
        self.assertEqual(self.over(), (0, [], ""))

    def test_a_step_too_coarse_for_the_damping_of_a_packing(self):
        """Stable for one contact, not for a disk with several: refused, or it ends in words."""
        code, _, said = self.over(disks__model="CD_rot", disks__mass="equal", integration__time_step=0.2,
                                  disks__packing_fraction=0.84, shear__strain_rate=1e-2,
                                  integration__scheme=PAPERS)
        self.assertIn(code, (2, 3), said)
        self.assertIn("integration.time_step", said)

    def test_a_hot_gas_of_soft_disks_ends(self):
        """Contacts by events in which disks pass each other: their lists were built without end."""
        scene = {"disks": {"model": "CD_n", "count": 200, "packing_fraction": 0.05, "elasticity": 200.0, "mass": "equal"},
                 "shear": {"strain_rate": 2e-3, "strain": 24.0}, "output": {"plot": False}}
        result = self.bagnold("run", self.scene(scene), "--out", self.folder / "hot", timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_step_near_the_edge_of_a_packing(self):
        """Two stages: contacts that grow at 0.4 are few, and averages hardly show them."""
        for step, seen in ((0.2, False), (0.4, True)):
            code, names, said = self.over(disks__model="CD_rot", disks__mass="equal",
                                          disks__packing_fraction=0.82, integration__time_step=step,
                                          shear__strain=2.0)
            self.assertTrue(code == 3 or "contact_network" in names if seen
                            else (code, "contact_network" in names) == (0, False), (code, names, said))

    def test_a_ramp_is_warned_of_its_step(self):
        path = self.scene({**SOUND, "output": {"plot": False},
                           "shear": {"protocol": "ramp", "strain_rate": 1e-3, "strain_rate_high": 1e-2,
                                     "ramp_rate": 0.01, "ramp_window": 10.0, "strain": 0.1}},
                          disks__model="CD_rot", disks__mass="equal", disks__elasticity=0.5,
                          integration__time_step=0.2)
        result = self.bagnold("run", path, "--out", self.folder / "ramp")
        self.assertTrue(result.returncode == 3 or "contact_network" in result.stderr, result.stderr)

    def test_collisions_missed_at_large_q(self):
        """Q = 500: a collision loses 1% of its energy, one of a few coarse steps loses more."""
        for scheme, step, seen in ((PAPERS, 0.05, set()), (PAPERS, 0.2, {"collision_loss"}),
                                   (PAPERS, 0.5, {"collision_loss", "energy_balance"}),
                                   ("auto", 0.2, set()), ("auto", 0.5, {"collision_loss"}),
                                   ("auto", 0.8, {"collision_loss", "energy_balance"})):
            code, names, said = self.over(disks__elasticity=500.0, integration__time_step=step,
                                          integration__scheme=scheme, shear__strain_rate=1e-4,
                                          shear__strain=20.0)
            self.assertEqual(code, 0, said)
            self.assertEqual({"collision_loss", "energy_balance"} & set(names), seen, said)

    def test_disks_that_reverse_at_small_q(self):
        code, names, said = self.over("--allow-unstable", disks__elasticity=0.1,
                                      integration__time_step=0.2, integration__scheme=PAPERS)
        self.assertTrue(code == 3 or "energy_balance" in names, (code, names, said))

    def test_overlaps_of_soft_bodies(self):
        code, names, said = self.over(disks__model="CD", disks__mass="equal", integration__time_step=0.05,
                                      disks__packing_fraction=0.82, shear__strain_rate=2e-2)
        self.assertTrue(code == 3 or {"large_overlap", "hard_core_limit"} <= set(names), (code, names, said))

    def test_a_rate_not_in_the_hard_core_limit(self):
        code, names, said = self.over(disks__packing_fraction=0.82, shear__strain_rate=1e-2)
        self.assertEqual(code, 0, said)
        self.assertIn("hard_core_limit", names)

    def test_a_rate_that_uses_up_the_skin_in_one_step(self):
        code, _, said = self.over(shear__strain_rate=1.0, integration__time_step=0.5,
                                  disks__packing_fraction=0.3)
        self.assertEqual(code, 3, said)
        self.assertRegex(said, "skin|overlap")

    def test_so_few_disks_that_images_meet(self):
        code, _, said = self.over(disks__count=6)
        self.assertEqual(code, 2)
        self.assertIn("two images", said)

    def test_few_disks(self):
        code, names, said = self.over(disks__count=64)
        self.assertEqual(code, 0, said)
        self.assertIn("box_size", names)

    def test_above_jamming(self):
        code, names, said = self.over(disks__packing_fraction=0.86, shear__strain_rate=1e-3)
        self.assertEqual(code, 0, said)
        self.assertIn("above_jamming", names)

    def test_a_gas_without_collisions(self):
        code, names, said = self.over(disks__packing_fraction=0.05, shear__strain=0.5)
        self.assertEqual(code, 0, said)
        self.assertIn("few_collisions", names)

    def test_a_transient_that_is_measured(self):
        """From a random start at rest, all of it measured: the granular temperature grows for long."""
        code, names, said = self.over(disks__packing_fraction=0.6, disks__elasticity=50.0,
                                      shear__strain_rate=1e-4, shear__strain=8.0, shear__discard=0,
                                      integration__time_step=0.05)
        self.assertEqual(code, 0, said)
        self.assertIn("steady_state", names)

    def test_a_sudden_change_of_the_rate(self):
        """A ramp of one piece a decade and more: lists of the slow flow would be outrun in a step."""
        path = self.scene({**SOUND, "output": {"plot": False},
                           "shear": {"protocol": "ramp", "strain_rate": 1e-4, "strain_rate_high": 1e-2,
                                     "ramp_rate": 0.1, "ramp_every": 20.0, "ramp_window": 20.0,
                                     "strain": 0.1}})
        for engine in ("reference", "auto"):
            out = self.folder / engine
            result = self.bagnold("run", path, "--out", out, "--quiet", "--set",
                                  f"integration.engine={engine}")
            self.assertEqual(result.returncode, 0, result.stderr)
        one, two = (read_summary(self.folder / name)["loop"]["up"] for name in ("reference", "auto"))
        for a, b in zip(one, two):  # the same trajectories: for a few decades of rounding at least
            self.assertAlmostEqual(a["observables"]["Z"]["mean"], b["observables"]["Z"]["mean"], delta=0.2)

    def test_an_error_that_cannot_be_given(self):
        code, names, said = self.over(shear__strain=0.1)
        self.assertEqual(code, 0, said)
        self.assertIn("error_bar", names)

    def test_what_lies_beside_a_run_is_no_part_of_it(self):
        """Neither a scene that is none nor a pipe."""
        path = self.scene(SOUND, name="mine.toml")
        (self.folder / "scene.toml").write_text("no scene")
        self.assertEqual(self.bagnold("run", path, "--out", self.folder / "first").returncode, 0)
        (self.folder / "scene.toml").unlink()
        os.mkfifo(self.folder / "scene.toml")
        result = self.bagnold("run", path, "--out", self.folder / "second", timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_rough_errors_are_marked(self):
        """Of so many quantities in a run of 64 windows some have 4 to 7 blocks, and some do not."""
        path = self.scene(SOUND, shear__strain=4.0, output__sample_strain=2.0**-5)
        out = self.folder / "rough"
        result = self.bagnold("run", path, "--out", out, "--all")
        self.assertEqual(result.returncode, 0, result.stderr)
        rough = {name: one["rough"] for name, one in read_summary(out)["observables"].items()
                 if "rough" in one}
        self.assertEqual(set(rough.values()), {True})
        self.assertLess(len(rough), len(read_summary(out)["observables"]))
        for name in rough:
            self.assertIsNotNone(read_summary(out)["observables"][name]["error"])
            self.assertRegex(result.stdout, rf"(?m)^{name} .* \(rough\)")
        self.assertIn("with Student's factor", result.stdout)


if __name__ == "__main__":
    unittest.main()
