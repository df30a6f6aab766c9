# SPDX-License-Identifier: BSD-3-Clause
"""Numerical failure, the informing subcommands, and life without python."""

import os
import re
import shutil
import unittest

import h5py
import numpy as np

from bagnold import (LAWS, PAPERS, TWO_STAGE, CliTest, environment, lattice_state, read_state,
                     write_state)


class Failure(CliTest):
    def assert_failed(self, result, out):
        """Exit 3 with the step and the disk, and a state to look at."""
        self.assert_clean_error(result, 3, "step", "disk")
        self.assertRegex(result.stderr.lower(), r"step \d+|disk \d+")
        for name in ("summary.json", "state.h5"):
            self.assertFalse((out / name).exists())
        states = [path for path in out.glob("*.h5") if path.name in result.stderr]
        self.assertEqual(len(states), 1, f"the message names the file: {result.stderr}")
        with h5py.File(states[0]) as file:
            self.assertEqual(file["state/position"].shape, file["state/velocity"].shape)
            self.assertIn("box_length", file["state"].attrs)

    def test_a_step_far_too_long(self):
        for model in LAWS:
            with self.subTest(model=model):
                out = self.folder / model
                path = self.scene(disks__model=model, integration__time_step=8.0,
                                  shear__strain_rate=2.0**-5, shear__strain=64.0,
                                  output__sample_strain=1.0)
                refused = self.bagnold("run", path, "--out", out)
                self.assert_clean_error(refused, 2, "time_step", "--allow-unstable")
                self.assert_failed(
                    self.bagnold("run", path, "--out", out, "--allow-unstable"), out)

    def state_run(self, state, **changes):
        write_state(self.folder / "start.h5", state)
        out = self.folder / "out"
        path = self.scene(disks__model="CD", disks__packing_fraction=0.1, start__kind="state",
                          start__file="start.h5", **changes)
        return self.bagnold("run", path, "--out", out), out

    def test_overlap(self):
        state = lattice_state()
        state["position"][1] = state["position"][0] + [0.7, 0.0]
        result, out = self.state_run(state)
        self.assert_failed(result, out)
        self.assertIn("overlap", result.stderr.lower())
        self.assert_told(result, "1 pair of disks overlaps by more than 20%", "0 and 1", "by 30%")
        state["position"][1, 0] += 0.101  # 19.9%
        shutil.rmtree(out)
        result, _ = self.state_run(state)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("overlap", result.stderr)
        state["position"][1] = state["position"][0] + [0.3, 0.1]
        shutil.rmtree(out)
        result, _ = self.state_run(state, start__relax=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("push them apart", result.stderr)

    def assert_told(self, result, *words, remedy="push them apart by start.relax"):
        """Before the run began, and by `validate` too."""
        scene = self.folder / f"scene{self.written}.toml"
        for told in (result.stderr, self.bagnold("validate", scene).stderr):
            first = told.splitlines()[0]
            for word in ("warning", "start.h5", remedy, *words):
                self.assertIn(word, first)
            self.assertEqual("relax" in first, "relax" in remedy)

    def test_coinciding_disks(self):
        state = lattice_state()
        state["position"][1] = state["position"][0]
        result, out = self.state_run(state)
        self.assert_failed(result, out)
        self.assert_told(result, "1 pair of disks", "by 100%", remedy="no packing has overlaps above 50%: the box (L_x = ")

    def test_a_disk_too_fast(self):
        for speed in (1e3, 1e100):
            state = lattice_state()
            state["velocity"][5] = [0.0, speed]
            result, out = self.state_run(state)
            self.assert_failed(result, out)
            self.assertRegex(result.stderr, r"disk 5\b")
            for path in out.glob("*"):
                path.unlink()
            out.rmdir()

    def test_overflow(self):
        state = lattice_state()
        state["velocity"][5] = [1.7e308, 1.7e308]
        self.assert_failed(*self.state_run(state))

    def test_hopeless_packing(self):
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(disks__packing_fraction=0.999), "--out", out)
        self.assertIn(result.returncode, (0, 2, 3), result.stderr)
        if result.returncode:
            self.assertRegex(result.stderr.lower(), "overlap")

    def test_resume_of_a_failed_run(self):
        """It fails again with the same words, or says that it failed."""
        state = lattice_state()
        state["velocity"][5] = [0.0, 1e3]
        first, out = self.state_run(state)
        self.assertEqual(first.returncode, 3)
        self.assertEqual(self.bagnold("resume", out).returncode, 3)


class Information(CliTest):
    def test_validate(self):
        path = self.scene(shear__strain=2.0)
        before = set(self.folder.iterdir())
        result = self.bagnold("validate", path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(set(self.folder.iterdir()), before)
        text = result.stdout
        for word in ("packing_fraction", "0.8", "strain_rate", "CD_rot", "seed", "checkpoint"):
            self.assertIn(word, text)
        self.assertRegex(re.sub(r"[,_']", "", text), r"\b4096\b")  # steps
        self.assertRegex(text.lower(), r"steps")
        self.assertRegex(text, r"\b[kKMG]?i?B\b")
        self.assertRegex(text.lower(), r"\btime\b|\bseconds?\b|\bminutes?\b")

    def test_validate_resolves_the_automatic_step(self):
        """The papers' rule, with their scheme or by its name, and that of two stages."""
        for model, elasticity, papers, two_stage in (
            ("CD", 1.0, 0.05, 0.2), ("CD", 0.4, 0.04, 0.2), ("CD", 0.05, 0.01, 0.025),
            ("CD_rot", 1.0, 0.05, 0.2), ("CD_n", 1.0, 0.1, 0.2), ("CD_n", 0.1, 0.02, 0.05),
            ("CD_n", 50.0, 0.01, 0.2),
        ):
            for scheme, word, step in ((PAPERS, "auto", papers), (TWO_STAGE, "auto", two_stage),
                                       ("auto", "auto", two_stage), ("auto", "paper", papers)):
                with self.subTest(model=model, elasticity=elasticity, scheme=scheme, word=word):
                    path = self.scene(disks__model=model, disks__elasticity=elasticity,
                                      integration__time_step=word, shear__strain_rate=1e-3,
                                      shear__strain=1.0, output__sample_strain=0.01,
                                      integration__scheme=scheme)
                    text = self.bagnold("validate", path).stdout
                    steps = round(1.0 / (1e-3 * step))
                    said = [int(number) for number in re.findall(r"\b\d+\b", re.sub(r"[,_']", "", text))]
                    most = 1.02 * steps if scheme == word == "auto" else steps  # whole windows
                    self.assertTrue(any(steps <= number <= most for number in said), text)
                    changes = scheme == word == "auto" and (model, elasticity) != ("CD_n", 50.0)  # on the way
                    expected = PAPERS if scheme == PAPERS else "auto" if changes else TWO_STAGE
                    self.assertIn(f'scheme = "{expected}"', text)

    def test_info(self):
        result = self.bagnold("info")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        text = result.stdout.lower()
        for word in ("git", "kokkos", "serial", "cpu"):
            self.assertIn(word, text)
        self.assertRegex(text, r"(version|bagnold)\s+\d+\.\d+")
        self.assertRegex(text, r"kokkos\D*\d+\.\d+")

    def test_help(self):
        for command in ("run", "validate", "info", "resume", "check-limit"):
            result = self.bagnold(command, "--help")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(command, result.stdout)
        result = self.bagnold("--help")
        self.assertEqual(result.returncode, 0)
        for word in ("run", "validate", "info", "resume", "check-limit"):
            self.assertIn(word, result.stdout)

    def test_help_gives_units(self):
        self.assertIn("tau_e", self.bagnold("run", "--help").stdout)
        for command in ("run", "validate", "resume"):
            self.assertRegex(self.bagnold(command, "--help").stdout,
                             r"tau_e|d_s|minutes|steps|units?")

    def test_closed_standard_output(self):
        """bagnold ... | head -1 is no failure of the run."""
        process = self.start("run", self.scene(shear__strain=1.0), "--out", self.folder / "out")
        process.stdout.close()
        self.wait_until(lambda: process.poll() is not None)
        self.assertTrue((self.folder / "out" / "summary.json").exists())


class WithoutPython(CliTest):
    def check(self, **env):
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(output__plot=True), "--out", out,
                              env=environment(**env))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertFalse((out / "plot.png").exists())
        self.assertTrue((out / "summary.json").exists())
        self.assertTrue((out / "state.h5").exists())
        self.assertRegex((result.stderr + result.stdout).lower(), "warning|no picture|python|plot")

        return result.stderr

    def python(self, script):
        """One that does what a script of the shell says."""
        fake = self.folder / "python"
        fake.write_text(f"#!/bin/sh\n{script}\n")
        os.chmod(fake, 0o755)
        return str(fake)

    def test_none(self):
        said = self.check(PATH="", BAGNOLD_PYTHON="/nonexistent")
        self.assertIn("/nonexistent cannot be started; python3 with h5py and matplotlib is needed", said)

    def test_one_that_fails(self):
        said = self.check(BAGNOLD_PYTHON="/bin/false")
        self.assertIn("no picture drawn: /bin/false ended with code 1", said)
        self.assertNotIn("is needed", said)

    def test_one_without_matplotlib(self):
        said = self.check(BAGNOLD_PYTHON=self.python('exec /usr/bin/python3 -S -I "$@"'))
        self.assertIn("says: bagnold: No module named '", said)
        self.assertIn("python3 with h5py and matplotlib is needed", said)

    def test_the_last_line_of_any_other_failure(self):
        """Not that libraries are missing, which are there."""
        for script, expected in (
                ("echo Traceback >&2; echo 'MemoryError: of 3 GB' >&2; echo >&2; exit 1", "says: MemoryError: of 3 GB"),
                ("printf 'no end of\\nline' >&2; exit 3", "says: line"),
                ("printf 'a \\033[31mcolour' >&2; exit 3", "says: a ?[31mcolour"),
                ("yes 'a long story' | head -100000 >&2; echo 'OSError: disk full' >&2; exit 1", "says: OSError: disk full"),
                ("echo begun >&2; kill -9 $$", "was ended by signal 9 (Killed)"), ("exit 9", "ended with code 9")):
            with self.subTest(script=script):
                said = self.check(BAGNOLD_PYTHON=self.python(script))
                self.assertIn("warning: no picture drawn: ", said)
                self.assertIn(expected, said)
                self.assertNotIn("is needed", said)
                shutil.rmtree(self.folder / "out")

    def test_what_plots_say_of_a_folder_that_cannot_be_written(self):
        """And of data that are not what they should be."""
        self.check(BAGNOLD_PYTHON="/bin/false")
        out = self.folder / "out"
        (out / "plot.png").mkdir()
        said = self.bagnold("plot", out)
        self.assertEqual(said.returncode, 4)
        self.assertRegex(said.stderr, "plot.png: .*Is a directory")
        self.assertNotIn("is needed", said.stderr)
        (out / "plot.png").rmdir()
        with h5py.File(out / "result.h5", "r+") as file:
            del file["series"]
        said = self.bagnold("plot", out)
        self.assertEqual(said.returncode, 4)
        self.assertRegex(said.stderr, "no picture drawn: /usr/bin/python3 says: bagnold plot: .*series")

    def test_imports_and_exports(self):
        """A Python that cannot be started, and one that ends otherwise."""
        for words in (("import", self.scene(), "--out", self.folder / "x.h5"), ("export", self.folder, "--to", "vtk")):
            for script, expected in (('exec /usr/bin/python3 -S -I "$@"', "says: bagnold: No module named"), ("kill -9 $$", "ended by signal 9")):
                said = self.bagnold(*words, env=environment(BAGNOLD_PYTHON=self.python(script)))
                self.assertNotEqual(said.returncode, 0)
                self.assertIn(expected, said.stderr)
                self.assertEqual(len(said.stderr.splitlines()), 1, said.stderr)


class RandomStart(CliTest):
    def test_overlaps_are_relaxed(self):
        """At 0.6 no overlap is left worth mentioning before the first step."""
        out = self.run_new("out", disks__packing_fraction=0.6, disks__count=256,
                           shear__strain=2.0**-11, output__sample_strain=2.0**-11,
                           measure__every=1)
        state = read_state(out)
        length = state["box_length"]
        away = state["position"][:, None] - state["position"][None]
        rows = np.rint(away[..., 1] / length)
        away[..., 1] -= rows * length
        away[..., 0] -= rows * state["offset"]
        away[..., 0] -= length * np.rint(away[..., 0] / length)
        contact = (state["diameter"][:, None] + state["diameter"][None]) / 2
        overlap = 1 - np.hypot(*np.moveaxis(away, -1, 0)) / contact
        self.assertLess(np.max(overlap[~np.eye(256, dtype=bool)]), 1e-2)


if __name__ == "__main__":
    unittest.main()
