# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold status` and `bagnold plot`: of runs, cascades and sweeps that are done, at work, or not."""

import json
import os
import re
import shlex
import signal
import time
import unittest

from bagnold import files_of, seconds_to_strain
from sweeps import SEEDS, SweepTest

LONG = {"shear__strain": 2.0**20, "output__sample_strain": 2.0**10,
        "output__checkpoint_minutes": 0.002}
JAMMED = {"disks__packing_fraction": 0.86, "disks__model": "CD"}
FORMS = {"png": b"\x89PNG", "pdf": b"%PDF", "svg": b"<?xml"}


class Status(SweepTest):
    def status(self, out, code=0):
        idle = (out / "summary.json").exists()  # else files come and go
        before = files_of(out) if idle else None
        result = self.bagnold("status", out)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stderr, "")
        if idle:
            self.assertEqual(files_of(out), before, "status wrote something")
        return result.stdout

    def test_a_run_that_is_done(self):
        out = self.run_new("out", **JAMMED)
        said = self.status(out)
        told = json.loads(self.bagnold("status", out, "--json").stdout)
        self.assertEqual((told["kind"], told["state"], told["strain"], told["share"]), ("run", "done", 0.125, 1))
        self.assertIn("above_jamming", told["notes"])
        self.assertIn("done: strain 0.125", said)
        self.assertIn("notes: above_jamming", said)

    def test_running_and_stopped(self):
        out = self.folder / "out"
        process = self.start("run", self.scene(**LONG), "--out", out)
        self.wait_until((out / "checkpoint.h5").exists, process)
        said = self.status(out)
        self.assertRegex(said, r"running: strain [\d.e+]+ of 1.049e\+06 \(\d+%\) at its checkpoint, "
                               r"[\d.e-]+ (s|min) ago, about .+ left, until .*pid \d+")
        self.assertIn(f"pid {process.pid}", said)
        process.send_signal(signal.SIGTERM)
        self.finish(process)
        said = self.status(out)
        self.assertIn("stopped: strain", said)
        self.assertIn(f"`bagnold resume {out}` goes on", said)
        self.assertNotIn("until", said)
        blanks = out.rename(self.folder / "it's with blanks")
        command = re.search("`bagnold (.*)` goes on", self.status(blanks))[1]
        self.assertEqual(shlex.split(command), ["resume", str(blanks)])

    def test_a_run_shows_something_soon(self):
        """The first checkpoint comes long before the ten minutes of output.checkpoint_minutes."""
        out = self.folder / "out"
        process = self.start("run", self.scene(**{**LONG, "output__checkpoint_minutes": None,
                                                  "output__sample_strain": 2.0}), "--out", out)
        self.wait_until((out / "scene.toml").exists, process)
        self.assertRegex(self.status(out), r"running: .*its first checkpoint comes after 10 s")
        self.wait_until((out / "checkpoint.h5").exists, process)
        self.wait_until((out / "result.h5").exists, process)
        self.assertRegex(self.status(out), r"running: .* at its checkpoint, .* ago, about .* left, until")
        result = self.bagnold("plot", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((out / "plot.png").exists())

    def test_the_time_left_of_a_resumed_run(self):
        """An old checkpoint is no time of work."""
        out = self.folder / "out"
        path = self.scene(shear__strain=seconds_to_strain(self, 3600), output__sample_strain=2.0**6)
        process = self.start("run", path, "--out", out)
        self.wait_until((out / "scene.toml").exists, process)
        time.sleep(1)
        process.send_signal(signal.SIGTERM)
        self.finish(process)
        old = time.time() - 10 * 3600
        for name in ("checkpoint.h5", ".lock"):
            os.utime(out / name, (old, old))
        process = self.start("resume", out)
        self.wait_until(lambda: "running" in self.status(out), process)
        self.assertRegex(self.status(out), r"running: .*about .+ left, until")
        left = json.loads(self.bagnold("status", out, "--json").stdout)["seconds_left"]
        self.assertGreater(left, 0)
        process.kill()

    def test_failed_and_not_begun(self):
        coarse = {"integration__time_step": 8.0, "shear__strain_rate": 2.0**-5,
                  "shear__strain": 64.0, "output__sample_strain": 1.0}
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(**coarse), "--out", out, "--allow-unstable")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("failed", self.status(out))
        for path in out.glob("failed*"):
            path.unlink()
        for path in out.glob("checkpoint*"):
            path.unlink()
        self.assertIn("not begun", self.status(out))

    def test_remarks_are_no_failure(self):
        """A run that waits to go on, or was killed, where its log ends with a note or a warning."""
        out = self.run_new("out")
        (out / "summary.json").unlink()
        for last in ("note: box_size: 3 is few", "warning: steady_state: still drifts"):
            (out / "log.txt").write_text(f"bagnold: {last}\n")
            self.assertIn("stopped: strain", self.status(out))
        (out / "log.txt").write_text("bagnold: the disk is full\n")
        self.assertIn("failed: strain", self.status(out))

    def test_a_cascade(self):
        changes = {"shear__protocol": "cascade", "shear__strain_rate": None,
                   "shear__strain_rates": [2.0**-6, 2.0**-7]}
        out = self.run_new("out", **changes)
        said = self.status(out)
        self.assertIn("cascade, 2 of 2 rates done", said)
        (out / "summary.json").unlink()
        (out / "0002_strain_rate=0.0078125/summary.json").unlink()
        said = self.status(out)
        self.assertIn("1 of 2 rates done", said)
        self.assertIn("stopped: strain", said)

    def test_a_sweep(self):
        path = self.sweep_file(grid={"disks.packing_fraction": [0.7, 0.86], "disks.seed": [1, 2]})
        out = self.folder / "out"
        self.sweep(path, out, "--emit-slurm")
        said = self.status(out)
        self.assertIn("0 done, 0 running, 0 stopped, 0 failed, 4 not begun; 0% of", said)
        self.assertIn("prepared for Slurm", said)
        self.sweep(path, out, "--quiet")
        said = self.status(out)
        self.assertIn("4 points: 4 done, 0 running", said)
        self.assertIn("notes: above_jamming (2)", said)
        point = self.points(out)[1]
        (point / "summary.json").unlink()
        (point / "log.txt").write_text("bagnold: no space left on this disk\n")
        said = self.status(out, code=1)
        self.assertIn("3 done, 0 running, 0 stopped, 1 failed", said)
        self.assertRegex(said, f"{point.name} .*no space left on this disk")

    def test_a_sweep_at_work(self):
        out = self.folder / "out"
        process = self.start("sweep", self.sweep_file(grid=SEEDS, **LONG), "--out", out, "--jobs", 2)
        self.wait_until(lambda: len(list(out.glob("points/*/checkpoint.h5"))) == 2, process)
        said = self.status(out)
        self.assertIn("0 done, 2 running, 0 stopped, 0 failed, 1 not begun", said)
        self.assertRegex(said, "2 at a time: about .* left, until")
        process.send_signal(signal.SIGTERM)
        self.finish(process)
        said = self.status(out)
        self.assertIn("0 running, 2 stopped, 0 failed, 1 not begun", said)
        self.assertIn("goes on", said)

    def test_refusals(self):
        empty = self.folder / "empty"
        empty.mkdir()
        for command in ("status", "plot"):
            self.assert_clean_error(self.bagnold(command, empty), 2, "holds no run")


class Plot(SweepTest):
    def plot(self, out, form):
        result = self.bagnold("plot", out, "--format", form)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def assert_picture(self, path):
        form = path.suffix[1:]
        self.assertEqual(path.read_bytes()[:len(FORMS[form])], FORMS[form])

    def test_forms(self):
        out = self.run_new("out", measure__profiles=True, measure__fields=True, disks__count=400,
                           measure__frame_strain=0.02)
        for form in FORMS:
            said = self.plot(out, form)
            for name in ("plot", "profiles", "fields", "histograms"):
                self.assert_picture(out / f"{name}.{form}")
                self.assertIn(f"{name}.{form}\n", said)
        result = self.bagnold("plot", out, "--format", "bmp")
        self.assert_clean_error(result, 2, "png")

    def test_while_it_runs(self):
        out = self.folder / "out"
        process = self.start("run", self.scene(**{**LONG, "output__sample_strain": 2.0}), "--out", out)
        self.wait_until((out / "result.h5").exists, process)
        said = self.plot(out, "png")
        self.assertRegex(said, r"plot.png, of strain [\d.e+]+ of 1.049e\+06 \(.* ago; `kill -USR1")
        self.assert_picture(out / "plot.png")
        self.assertIsNone(process.poll())

    def test_killed_before_its_first_checkpoint(self):
        out = self.folder / "out"
        process = self.start("run", self.scene(**{**LONG, "output__checkpoint_minutes": None}), "--out", out)
        self.wait_until((out / "scene.toml").exists, process)
        process.kill()
        self.finish(process)
        result = self.bagnold("plot", out)
        self.assert_clean_error(result, 2, "nothing to draw", f"`bagnold resume {out}`")
        self.assertNotIn("USR1", result.stderr)

    def test_cascades_and_sweeps(self):
        out = self.run_new("cascade", shear__protocol="cascade", shear__strain_rate=None,
                           shear__strain_rates=[2.0**-6, 2.0**-7])
        said = self.plot(out, "svg")
        self.assertEqual(said.count("plot.svg"), 2)
        self.assertIn("flow_curve.svg\n", said)
        self.assert_picture(out / "flow_curve.svg")
        out = self.folder / "sweep"
        path = self.sweep_file(grid={"disks.packing_fraction": [0.7, 0.72]}, shear__strain=8.0)
        self.sweep(path, out, "--emit-slurm")
        self.assert_clean_error(self.bagnold("plot", out), 2, "--collect")
        self.sweep(path, out, "--quiet")
        self.assertIn("sweep.pdf\n", self.plot(out, "pdf"))
        self.assert_picture(out / "table.pdf")
        self.assert_picture(out / "sweep.pdf")

    def test_a_sweep_in_which_disks_hardly_met(self):
        out = self.folder / "sweep"
        self.sweep(self.sweep_file(grid={"disks.packing_fraction": [0.7, 0.72]}), out, "--quiet")
        result = self.bagnold("plot", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("2 of 2 points are left out: disks hardly met", result.stderr)
        self.assertFalse((out / "table.png").exists())
        self.assert_picture(out / "sweep.png")

    def test_a_sweep_over_what_makes_no_curve(self):
        """Seeds or texts alone: the points are drawn, and why no table is."""
        for grid in ({"disks.seed": [1, 2]}, {"disks.model": ["CD", "CD_n"]}):
            out = self.folder / next(iter(grid))
            self.sweep(self.sweep_file(grid=grid, shear__strain=8.0), out, "--quiet")
            result = self.bagnold("plot", out)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("no table is drawn: ", result.stderr)
            self.assertFalse((out / "table.png").exists())
            self.assert_picture(out / "sweep.png")


if __name__ == "__main__":
    unittest.main()
