# SPDX-License-Identifier: BSD-3-Clause
"""Small runs for the tests of the Python package, made once a process by the program BAGNOLD."""

import functools
import os
import pathlib
import shutil
import sys
import tempfile
import unittest
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

    @classmethod
    def tearDownClass(cls):
        made.cache_clear()
        for path in FOLDER.iterdir():
            shutil.rmtree(path)

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bagnold-python-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
