# SPDX-License-Identifier: BSD-3-Clause
"""A full disk or an unwritable directory: exit 4, and the last good checkpoint still resumes."""

import os
import resource
import signal
import subprocess
import time
import unittest

from bagnold import PROGRAM, SCENE, CliTest, changed, environment, seconds_to_strain

LONG = {"disks__model": "CD_rot", "disks__count": 1024, "shear__strain_rate": 2.0**-7}


class DiskTest(CliTest):
    def small_disk(self, name, options):
        """A tmpfs of its own; skips the test where mounting is not allowed."""
        path = self.folder / name
        path.mkdir()
        try:
            subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", path], check=True,
                           capture_output=True)
        except (OSError, subprocess.CalledProcessError) as error:
            self.skipTest(f"cannot mount a small tmpfs ({error})")
        self.addCleanup(subprocess.run, ["umount", "-l", path], check=False)
        return path

    def fill(self, disk):
        """Takes all the space there is."""
        with open(disk / "filler", "wb", buffering=0) as file:
            for size in (65536, 4096, 1):
                try:
                    while True:
                        file.write(bytes(size))
                except OSError:
                    pass

    def timed_scene(self, seconds, **changes):
        strain = float(seconds_to_strain(self, seconds, **LONG))
        return self.scene(shear__strain=strain, output__sample_strain=strain / 64,
                          measure__every=10, **{**LONG, **changes})

    def check_full(self, minutes):
        """Fills the disk under a run, frees it, resumes, compares with a run on a large one."""
        path = self.timed_scene(1.0, output__checkpoint_minutes=minutes)
        whole = self.folder / "whole"
        self.run_scene(path, whole, "--quiet")
        disk = self.small_disk("disk", "size=8m")
        out = disk / "out"
        process = self.start("run", path, "--out", out)
        self.wait_until((out / "scene.toml").exists, process)
        if minutes > 1:
            time.sleep(0.1)
            process.send_signal(signal.SIGUSR1)
        self.assertTrue(self.wait_until((out / "checkpoint.h5").exists, process))
        self.fill(disk)
        status, output = self.finish(process)
        self.assertEqual(status, 4, output)
        self.assertRegex(output.lower(), "space|full")
        self.assertFalse((out / "summary.json").exists())
        self.assertFalse((out / "state.h5").exists())
        self.assert_clean_error(self.bagnold("resume", out, "--quiet"), 4)
        (disk / "filler").unlink()
        result = self.bagnold("resume", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotRegex(result.stdout + result.stderr, "again from")
        self.assert_same_results(whole, out)


class Full(DiskTest):
    def test_while_checkpoints_are_written(self):
        self.check_full(minutes=0.001)

    def test_when_results_are_written(self):
        self.check_full(minutes=1e6)

    def test_under_a_trajectory(self):
        changes = {**LONG, "shear__strain": 0.5, "output__trajectory_strain": 2.0**-8}
        path, whole = self.scene(**changes), self.folder / "whole"
        self.run_scene(path, whole, "--quiet")
        self.assertGreater((whole / "trajectory.h5md").stat().st_size, 7e6)
        disk = self.small_disk("disk", "size=3m")
        result = self.bagnold("run", path, "--out", disk / "out")
        self.assert_clean_error(result, 4, "trajectory", "space")
        subprocess.run(["mount", "-o", "remount,size=12m", disk], check=True)
        result = self.bagnold("resume", disk / "out")  # the parts fit, the whole beside them does not
        self.assert_clean_error(result, 4, "trajectory", "space")
        subprocess.run(["mount", "-o", "remount,size=60m", disk], check=True)
        result = self.bagnold("resume", disk / "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((whole / "trajectory.h5md").read_bytes(),
                         (disk / "out" / "trajectory.h5md").read_bytes())

    def test_from_the_start(self):
        disk = self.small_disk("disk", "size=16k")
        result = self.bagnold("run", self.scene(**LONG), "--out", disk / "out")
        self.assert_clean_error(result, 4)
        self.assertRegex(result.stderr.lower(), "space|full")
        for name in ("summary.json", "state.h5"):
            self.assertFalse((disk / "out" / name).exists())

    def test_before_anything_is_there(self):
        disk = self.small_disk("disk", "size=16k")
        (disk / "filler").write_bytes(bytes(12 << 10))
        result = self.bagnold("run", self.scene(**LONG), "--out", disk / "out")
        self.assert_clean_error(result, 4, "space", "give the same command again")
        self.assertNotIn("resume", result.stderr)
        (disk / "filler").unlink()
        subprocess.run(["mount", "-o", "remount,size=60m", disk], check=True)
        self.run_scene(self.scene(**LONG), disk / "out", "--quiet")

    def test_no_inodes(self):
        disk = self.small_disk("disk", "size=8m,nr_inodes=4")
        result = self.bagnold("run", self.scene(**LONG), "--out", disk / "out")
        self.assert_clean_error(result, 4)

    def test_file_size_limit(self):
        """ulimit -f: the signal SIGXFSZ must not kill the run without a word."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        scene, out = self.scene(**LONG), self.folder / "out"
        result = subprocess.run([PROGRAM, "run", scene, "--out", out], text=True, timeout=60,
                                capture_output=True, preexec_fn=limit, env=environment())
        self.assert_clean_error(result, 4)


class Unwritable(DiskTest):
    def test_parent_is_a_file(self):
        (self.folder / "file").write_text("mine")
        for out in (self.folder / "file" / "out", self.folder / "file"):
            result = self.bagnold("run", self.scene(), "--out", out)
            self.assert_clean_error(result, 4, str(out))
        self.assertEqual((self.folder / "file").read_text(), "mine")

    def test_a_place_that_takes_no_files(self):
        result = self.bagnold("run", self.scene(), "--out", "/proc/bagnold")
        self.assert_clean_error(result, 4, "/proc/bagnold")

    def test_read_only_disk(self):
        disk = self.small_disk("disk", "size=1m")
        (disk / "out").mkdir()
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        for out in (disk / "new", disk / "out"):
            result = self.bagnold("run", self.scene(), "--out", out)
            self.assert_clean_error(result, 4, str(out))

    def test_read_only_resume(self):
        disk = self.small_disk("disk", "size=8m")
        path = self.timed_scene(1.0, output__checkpoint_minutes=0.001)
        process = self.start("run", path, "--out", disk / "out")
        self.assertTrue(self.wait_until((disk / "out" / "checkpoint.h5").exists, process))
        process.terminate()
        self.assertEqual(self.finish(process)[0], 143)
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        self.assert_clean_error(self.bagnold("resume", disk / "out"), 4)

    def test_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        (self.folder / "locked").mkdir(mode=0o500)
        result = self.bagnold("run", self.scene(), "--out", self.folder / "locked" / "out")
        self.assert_clean_error(result, 4)

    def test_refused_input_comes_first(self):
        """A bad scene is exit 2 also where nothing could be written."""
        result = self.bagnold("run", self.scene(changed(SCENE, disks__count=63)),
                              "--out", "/proc/bagnold")
        self.assert_clean_error(result, 2, "disks.count")


if __name__ == "__main__":
    unittest.main()
