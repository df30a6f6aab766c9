# SPDX-License-Identifier: BSD-3-Clause
"""kill -9 in a sweep of 20 short points, at ten random moments: the tables are those of one that was
left alone, byte by byte."""

import contextlib
import os
import random
import signal
import time
import unittest

from bagnold import seconds_to_strain
from sweeps import SweepTest, tables

POINT_SECONDS = 0.15
KILLS = 10


class Kill(SweepTest):
    def finished(self, out):
        return len(list(out.glob("points/*/summary.json")))

    def test_ten_kills(self):
        seed = int.from_bytes(os.urandom(4), "little")
        chance = random.Random(seed)
        often = {"output__checkpoint_minutes": 0.001}
        strain = seconds_to_strain(self, POINT_SECONDS, **often)
        path = self.sweep_file(
            grid={"disks.elasticity": [1, 2, 4, 8, 16], "shear.strain_rate": [2.0**-6, 2.0**-7],
                  "disks.seed": [1, 2]},
            chain="shear.strain_rate", shear__strain=strain, **often,
        )
        whole, out = self.folder / "whole", self.folder / "out"
        self.sweep(path, whole, "--jobs", "2", "--quiet")
        with self.subTest(seed=seed):
            killed = 0
            for kill in range(KILLS):
                process = self.start("sweep", path, "--out", out, "--jobs", "2")
                # moments spread over the sweep, however fast the machine is just now
                self.wait_until(lambda: self.finished(out) >= 2 * kill - 1, process)
                time.sleep(chance.uniform(0.0, 2 * POINT_SECONDS))
                victims = self.children(out)
                if kill % 2 and victims:  # a point alone: the sweep goes on without it
                    with contextlib.suppress(ProcessLookupError):  # it ended by itself meanwhile
                        os.kill(chance.choice(victims), signal.SIGKILL)
                    time.sleep(chance.uniform(0.0, POINT_SECONDS / 2))
                process.kill()
                status, output = self.finish(process)
                self.assertIn(status, (-signal.SIGKILL, 0, 1), output)
                killed += status == -signal.SIGKILL
            self.assertGreaterEqual(killed, KILLS // 2, "the sweep was over too soon")
            self.sweep(path, out, "--jobs", "2")
            self.assertEqual(tables(out), tables(whole))
            logs = "".join((f / "log.txt").read_text() for f in self.points(out))
            self.assertIn("going on from step", logs)


if __name__ == "__main__":
    unittest.main()
