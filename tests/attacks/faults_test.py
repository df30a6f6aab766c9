# SPDX-License-Identifier: BSD-3-Clause
"""One file call fails under a run, or all from one on, and nothing comes out wrong.

Either the run ends with exit code 0 and its files are those of an undisturbed one; or it says what is
wrong with which file, and `bagnold resume` then ends with these files. Every call of every name that
the run makes is tried in turn, every 97th where nothing else is asked for:

    FAULTS_EVERY=1 tests/attacks/faults_test.py
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

from bagnold import PROGRAM, environment, scene_text  # noqa: E402
from injector import counted, injected  # noqa: E402

EVERY = int(os.environ.get("FAULTS_EVERY", "97"))

# A checkpoint wherever there can be one, each with a part of the trajectory, and no clock in it.
SCENE = {
    "disks": {"model": "CD_rot", "count": 16, "packing_fraction": 0.80, "elasticity": 1.0,
              "mass": "equal"},
    "shear": {"strain_rate": 2.0**-7, "strain": 2.0**-6, "discard": 0.5},
    "integration": {"time_step": 2.0**-4},
    "measure": {"every": 2},
    "output": {"sample_strain": 2.0**-8, "trajectory_strain": 2.0**-9,
               "checkpoint_minutes": 1e-9, "plot": False},
}
ONCE = (("read", "EIO"), ("pread", "EIO"), ("open", "EIO"), ("open", "EACCES"), ("write", "EIO"),
        ("write", "ENOSPC"), ("write", "HALF"), ("write", "LOST"), ("write", "KILL"),
        ("pwrite", "EIO"), ("pwrite", "ENOSPC"), ("pwrite", "LOST"), ("pwrite", "KILL"),
        ("fsync", "EIO"), ("close", "EIO"), ("close", "ENOSPC"), ("rename", "EIO"),
        ("rename", "KILL"), ("unlink", "EIO"), ("unlink", "KILL"), ("mkdir", "ENOSPC"),
        ("ftruncate", "EIO"))
FOR_GOOD = (("write", "ENOSPC"), ("pwrite", "ENOSPC"), ("fsync", "EIO"), ("rename", "EIO"),
            ("open", "EACCES"), ("read", "EIO"))
KILLED = -9


def files_of(folder):
    """What a run leaves, without what its clock says."""
    files = {str(path.relative_to(folder)): path.read_bytes()
             for path in sorted(folder.rglob("*")) if path.is_file()}
    for name in list(files):
        if name.startswith("checkpoint") or name == ".lock" or name.endswith(".tmp"):
            del files[name]
    if "summary.json" in files:
        summary = json.loads(files["summary.json"])
        del summary["wall_seconds"], summary["disk_steps_per_second"]
        files["summary.json"] = summary
    return files


class Faults(unittest.TestCase):
    def setUp(self):
        memory = pathlib.Path("/dev/shm")
        self.folder = pathlib.Path(tempfile.mkdtemp(
            prefix="bagnold-", dir=memory if memory.is_dir() else None))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.scene, self.out = self.folder / "scene.toml", self.folder / "out"
        self.scene.write_text(scene_text(SCENE))
        self.run_scene()
        self.expected = files_of(self.out)
        self.assertIn("trajectory.h5md", self.expected)

    def bagnold(self, *arguments, **fault):
        more = injected(self.out, **fault) if fault else {}
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                              timeout=60, env=environment(**more), stdin=subprocess.DEVNULL)

    def run_scene(self, **fault):
        shutil.rmtree(self.out, ignore_errors=True)
        return self.bagnold("run", self.scene, "--out", self.out, "--quiet", **fault)

    def resume(self, **fault):
        """From the same interrupted run each time."""
        shutil.rmtree(self.out, ignore_errors=True)
        shutil.copytree(self.folder / "cut", self.out)
        return self.bagnold("resume", self.out, "--quiet", **fault)

    def interrupt(self):
        self.run_scene(call="rename", at=10, error="KILL")
        self.assertTrue((self.out / "checkpoint.previous.h5").exists())
        self.assertFalse((self.out / "summary.json").exists())
        self.out.rename(self.folder / "cut")

    def assert_kept(self, result):
        """The promise."""
        if result.returncode == KILLED:
            pass
        elif result.returncode != 0:
            self.assertIn(result.returncode, (2, 4), result.stderr)
            self.assertIn("bagnold: ", result.stderr)
            self.assertIn(str(self.out), result.stderr)
            self.assertRegex(result.stderr, "Input/output error|No space left|Permission denied"
                             "|reads back different|not there|cannot be opened")
        if result.returncode != 0:
            again = self.bagnold("resume", self.out, "--quiet")
            if again.returncode == 2:  # nothing had been begun
                self.assertRegex(again.stderr, "holds no run|no such folder")
                again = self.bagnold("run", self.scene, "--out", self.out, "--quiet")
            self.assertEqual(again.returncode, 0, f"{result.stderr}\nthen: {again.stderr}")
        found = files_of(self.out)
        self.assertEqual(found.keys(), self.expected.keys())
        for name in found:
            self.assertTrue(found[name] == self.expected[name], f"{name} is another")

    def attack(self, program, faults, times):
        log = self.folder / "log"
        log.unlink(missing_ok=True)
        program(log=log)
        counts, tried = counted(log), 0
        for call, error in faults:
            for at in range(1 + (7 * tried) % EVERY, counts[call] + 1, EVERY):
                with self.subTest(call=call, error=error, at=at, times=times):
                    tried += 1
                    self.assert_kept(program(call=call, error=error, at=at, times=times))
        print(f"{self.id()}: {tried} faults", file=sys.stderr)

    def test_one_under_a_run(self):
        self.attack(self.run_scene, ONCE, times=1)

    def test_for_good_under_a_run(self):
        self.attack(self.run_scene, FOR_GOOD, times="always")

    def test_a_disk_that_flickers(self):
        self.attack(self.run_scene, (("write", "ENOSPC"), ("pwrite", "ENOSPC")), times=5)

    def test_one_under_a_resume(self):
        self.interrupt()
        self.attack(self.resume, ONCE, times=1)

    def test_for_good_under_a_resume(self):
        self.interrupt()
        self.attack(self.resume, FOR_GOOD, times="always")


if __name__ == "__main__":
    unittest.main()
