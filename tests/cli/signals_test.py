# SPDX-License-Identifier: BSD-3-Clause
"""Signals that come twice: machines send them milliseconds apart, a user who will not wait later."""

import os
import signal
import time
import unittest

from bagnold import CliTest
from sweeps import SEEDS, SweepTest, catches_term

INT, TERM, HUP = signal.SIGINT, signal.SIGTERM, signal.SIGHUP
STOPS = (128 + INT, 128 + TERM, 128 + HUP)
LONG = {"shear__strain": 2.0**20, "output__sample_strain": 2.0**10}


class Twice(CliTest):
    def starting(self, name, count):
        """A run that makes its start: of fewer than 8192 disks that is done before a stop is heeded."""
        out = self.folder / name
        path = self.scene(disks__count=count, disks__packing_fraction=0.845, **LONG)
        process = self.start("run", path, "--out", out, "--threads", 1)
        self.wait_until((out / "scene.toml").exists, process)
        time.sleep(0.1)
        return process, out

    def signalled(self, name, *signals, count=3000):
        """Sends signals, each a number or a pause in seconds; returns the exit code, and whether there is
        a checkpoint."""
        process, out = self.starting(name, count)
        for one in signals:
            if isinstance(one, signal.Signals):
                process.send_signal(one)
            else:
                time.sleep(one)
        status, said = self.finish(process)
        self.assertIn(status, STOPS, said)
        return status, (out / "checkpoint.h5").exists()

    def test_machines_ask_twice_within_milliseconds(self):
        for k, (one, pause, two) in enumerate((
                (TERM, 0.008, TERM), (TERM, 0.02, TERM), (TERM, 0.005, INT), (INT, 0.02, TERM),
                (INT, 0, INT), (HUP, 0.01, TERM), (TERM, 0.01, HUP))):
            with self.subTest(one=one.name, pause=pause, two=two.name):
                _, checkpoint = self.signalled(f"pair{k}", one, pause, two)
                self.assertTrue(checkpoint)

    def test_many_within_a_second(self):
        _, checkpoint = self.signalled("many", *(5 * (TERM, 0.02)), HUP, 0.01, INT, 0.01, TERM)
        self.assertTrue(checkpoint)

    def test_a_user_who_will_not_wait(self):
        for k, (one, pause, two) in enumerate(((INT, 0.2, INT), (TERM, 1.1, TERM), (TERM, 1.1, INT))):
            with self.subTest(one=one.name, pause=pause, two=two.name):
                status, checkpoint = self.signalled(f"user{k}", one, pause, two, count=8000)
                self.assertEqual((status, checkpoint), (128 + two, False))


class Sweeps(SweepTest):
    def test_the_sweep_and_its_points_are_asked_twice(self):
        """Slurm's preemption signals every process of a step, and all again."""
        path = self.sweep_file(grid=SEEDS, **LONG)
        for pause in (0.005, 0.008, 0.02):
            with self.subTest(pause=pause):
                out = self.folder / f"out{pause}"
                process = self.start("sweep", path, "--out", out, "--jobs", 2)
                self.wait_until(lambda: len(self.children(out)) == 2, process)
                children = self.children(out)
                self.wait_until(lambda: all(catches_term(pid) for pid in children), process)
                for _ in range(2):
                    for pid in (*children, process.pid):
                        try:
                            os.kill(pid, TERM)
                        except ProcessLookupError:
                            pass
                    time.sleep(pause)
                status, said = self.finish(process)
                self.assertEqual(status, 143, said)
                self.assertIn("the same command goes on", said)
                self.assertNotIn("failed with", said)
                self.assertEqual([(f / "checkpoint.h5").exists() for f in self.points(out)],
                                 [True, True, False])

    def test_points_that_are_asked_before_the_sweep(self):
        path, out = self.sweep_file(grid=SEEDS, **LONG), self.folder / "out"
        process = self.start("sweep", path, "--out", out, "--jobs", 2)
        self.wait_until(lambda: len(self.children(out)) == 2, process)
        children = self.children(out)
        self.wait_until(lambda: all(catches_term(pid) for pid in children), process)
        for pid in children:
            os.kill(pid, TERM)
        self.wait_until(lambda: self.children(out) == [], process)
        time.sleep(0.3)
        process.send_signal(TERM)
        status, said = self.finish(process)
        self.assertEqual(status, 143, said)
        self.assertNotIn("failed with", said)


if __name__ == "__main__":
    unittest.main()
