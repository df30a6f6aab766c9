# SPDX-License-Identifier: BSD-3-Clause
"""Small runs for the tests of the Python package, made once a process by the program BAGNOLD."""

import contextlib
import errno
import functools
import os
import pathlib
import shutil
import stat
import sys
import tempfile
import unittest
import unittest.mock
import warnings

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(SOURCE / "python"))
os.environ["BAGNOLD_PROGRAM"] = os.environ.get("BAGNOLD", str(SOURCE / "build/openmp/bagnold"))
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

import bagnold  # noqa: E402

FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="bagnold-python-"))
STEP_STRAIN = 2.0**-11  # rate times step, powers of two
SCENE = {
    "disks": {"model": "CD_rot", "count": 64, "packing_fraction": 0.84, "elasticity": 1.0,
              "mass": "equal"},
    "shear": {"strain_rate": 2.0**-7, "strain": 1.0},
    "integration": {"time_step": 2.0**-4},
    "output": {"sample_strain": 2.0**-5, "plot": False},
}


@functools.cache
def made(**changes):
    """A run of SCENE with `table__key=value` changed."""
    return run(SCENE, FOLDER / f"run{len(list(FOLDER.iterdir()))}", **changes)


def run(scene, out, **changes):
    """A run, of which it is known that it is too short for its numbers to be trusted."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return bagnold.run(scene, out, progress=False, **changes)


def with_frames(**changes):
    """A run with 9 frames."""
    return made(output__trajectory_strain=2.0**-3, **changes)


class Folder(unittest.TestCase):
    """A test with a folder of its own."""

    def keeps_what_is_no_file(self, write, ending):
        """What writes a file replaces no pipe, device or folder, replaces what a link points to, and leaves no part."""
        pipe, link, through = (self.folder / f"{name}{ending}" for name in ("pipe", "link", "through"))
        os.mkfifo(pipe)
        through.symlink_to(pipe.name)
        refused = [pipe, through]
        if os.geteuid() == 0:
            device = self.folder / f"device{ending}"
            with contextlib.suppress(PermissionError):  # in containers
                os.mknod(device, stat.S_IFCHR | 0o600, os.makedev(1, 3))
                refused.append(device)
        circle = self.folder / f"circle{ending}"
        circle.symlink_to(circle.name)
        for path in (*refused, circle):
            before = path.lstat()
            with self.assertRaisesRegex(bagnold.FileError, f"{path} cannot be written: it is no regular file"):
                write(path)
            self.assertEqual((path.lstat().st_ino, path.lstat().st_mode), (before.st_ino, before.st_mode))
        whole = self.folder / f"whole{ending}"
        whole.write_text("old")
        link.symlink_to(whole.name)
        write(link)
        self.assertTrue(link.is_symlink())
        self.assertNotEqual(whole.read_bytes(), b"old")
        with unittest.mock.patch("os.replace", side_effect=OSError(errno.ENOSPC, "No space left on device")):
            with self.assertRaisesRegex(bagnold.FileError, "cannot be written: No space left"):
                write(whole)
        self.assertEqual([path for path in self.folder.rglob("*") if ".part" in path.name], [])

    @classmethod
    def tearDownClass(cls):
        made.cache_clear()
        for path in FOLDER.iterdir():
            shutil.rmtree(path)

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bagnold-python-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
