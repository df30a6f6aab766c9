# SPDX-License-Identifier: BSD-3-Clause
"""Runs and sweeps by the package: results, progress, messages as exceptions, interruptions."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from unittest import mock

import h5py
import numpy as np

from made import SCENE, SOURCE, Folder, bagnold, made, run
from bagnold.scene import toml_text


class Runs(Folder):
    def scene_file(self, name="first.toml", **tables):
        path = self.folder / name
        path.write_text(toml_text({**SCENE, **tables}))
        return path

    def test_a_file_and_a_dictionary_are_the_same_run(self):
        path = self.scene_file()
        one = run(path, self.folder / "one", disks__elasticity=4, **{"disks.seed": 3})
        other = run(SCENE, self.folder / "other", disks__elasticity=4.0, disks__seed=3)
        self.assertEqual(one.scene, other.scene)
        self.assertEqual(one.scene["disks.elasticity"], 4)
        np.testing.assert_array_equal(one.state.position, other.state.position)
        self.assertEqual(one["Z"], other["Z"])

    def test_the_folder_is_the_programs_where_none_is_given(self):
        self.scene_file()
        here = os.getcwd()
        try:
            os.chdir(self.folder)
            self.assertEqual(run("first.toml", None).folder, pathlib.Path("results/first"))
        finally:
            os.chdir(here)
        self.assertTrue((self.folder / "results/first/summary.json").exists())
        with self.assertRaisesRegex(bagnold.InputError, "out is not given"):
            bagnold.run(SCENE)

    def test_a_start_from_a_state_of_this_folder(self):
        first = made()
        here = os.getcwd()
        try:
            os.chdir(first.folder)
            second = run({**SCENE, "start": {"kind": "state", "file": "state.h5"}}, self.folder / "second")
        finally:
            os.chdir(here)
        self.assertEqual(pathlib.Path(second.scene["start.file"]).resolve(), (first.folder / "state.h5").resolve())

    def test_the_same_scene_is_loaded_or_goes_on(self):
        one = run(SCENE, self.folder / "one")
        before = (one.folder / "result.h5").stat().st_mtime_ns, (one.folder / "state.h5").read_bytes()
        again = run(SCENE, self.folder / "one")
        self.assertEqual(((again.folder / "result.h5").stat().st_mtime_ns, (again.folder / "state.h5").read_bytes()), before)
        self.assertEqual(again["Z"], one["Z"])
        for name in ("summary.json", "state.h5"):
            (one.folder / name).unlink()
        self.assertEqual(run(SCENE, self.folder / "one")["Z"], one["Z"])
        self.assertEqual((one.folder / "state.h5").read_bytes(), before[1])

    def test_another_scene_is_refused_and_force_replaces(self):
        run(SCENE, self.folder / "one")
        with self.assertRaisesRegex(bagnold.InputError, "one.*--force"):
            bagnold.run(SCENE, self.folder / "one", progress=False, disks__seed=2)
        self.assertEqual(run(SCENE, self.folder / "one", force=True, disks__seed=2).scene["disks.seed"], 2)

    def test_mistakes_are_exceptions_with_the_programs_message(self):
        with self.assertRaisesRegex(bagnold.InputError, r"^scene:\d+:\d+: disks.elasticity = -1 \(must be"):
            bagnold.run(SCENE, self.folder / "bad", progress=False, disks__elasticity=-1)
        with self.assertRaisesRegex(bagnold.InputError, "disks.elasticitiy.*elasticity"):
            bagnold.run(SCENE, self.folder / "bad", progress=False, disks__elasticitiy=1)
        with self.assertRaisesRegex(ValueError, "none.toml"):
            bagnold.run(self.folder / "none.toml", self.folder / "bad", progress=False)
        self.assertFalse((self.folder / "bad").exists())
        (self.folder / "file").write_text("")
        with self.assertRaises(bagnold.FileError):
            bagnold.run(SCENE, self.folder / "file/below", progress=False)
        with self.assertRaisesRegex(bagnold.InternalError, "ended with code 9"):
            self.fake("exit 9")
            bagnold.run(SCENE, self.folder / "bad", program=self.folder / "fake", progress=False)

    def fake(self, words):
        path = self.folder / "fake"
        path.write_text(f"#!/bin/sh\n{words}\n")
        path.chmod(0o755)

    def test_warnings(self):
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            r = bagnold.run(SCENE, self.folder / "one", progress=False)
        said = [str(one.message) for one in said]
        self.assertEqual(len(said), len(r.warnings))
        for one in r.warnings:
            self.assertIn(one.reason, " ".join(said))

    def test_progress_is_called(self):
        shares = []
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            bagnold.run(SCENE, self.folder / "one", progress=shares.append, shear__strain=64.0)
            stages = []
            bagnold.run({**SCENE, "shear": {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 32.0}},
                        self.folder / "cascade", progress=stages.append)
            counts = []
            bagnold.sweep_file({**SCENE, "sweep": {"grid": {"disks.seed": [1, 2]}}}, self.folder / "many",
                               progress=counts.append)
        self.assertEqual(shares[0], 0)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1)
        again = []
        bagnold.run(SCENE, self.folder / "one", progress=again.append, shear__strain=64.0)
        bagnold.resume(self.folder / "one", progress=again.append)
        self.assertEqual(again, [1, 1])
        self.assertEqual(stages, sorted(stages))
        self.assertGreaterEqual(stages[-2], 1 / 3, stages)  # the second rate begins there
        self.assertEqual(counts[-1], 1)

    def test_progress_is_a_line_on_stderr(self):
        program = (f"import sys, warnings; sys.path.insert(0, {str(SOURCE / 'python')!r}); import bagnold\n"
                   f"warnings.simplefilter('ignore')\nbagnold.run({SCENE!r}, {str(self.folder / 'one')!r})")
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout, "")
        self.assertRegex(said.stderr, r"one: \d+%")

    def test_ctrl_c_leaves_a_checkpoint_that_resume_goes_on_from(self):
        out = self.folder / "long"
        long = {**SCENE, "shear": {**SCENE["shear"], "strain": 8192.0}}

        def interrupt():
            while not list(out.glob("scene.toml")):
                time.sleep(0.01)
            time.sleep(0.3)
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=interrupt).start()
        with self.assertRaises(KeyboardInterrupt):
            bagnold.run(long, out, progress=False)
        self.assertTrue((out / "checkpoint.h5").exists())
        self.assertFalse(bagnold.load(out).complete)

    def test_sigterm_leaves_a_checkpoint_and_no_program_behind(self):
        out = self.folder / "long"
        long = {**SCENE, "shear": {**SCENE["shear"], "strain": 8192.0}}
        program = f"import sys; sys.path.insert(0, {str(SOURCE / 'python')!r}); import bagnold; bagnold.run({long!r}, {str(out)!r}, progress=False)"
        with subprocess.Popen([sys.executable, "-c", program], stderr=subprocess.PIPE, text=True) as python:
            while not (out / "scene.toml").exists() and python.poll() is None:
                time.sleep(0.01)
            time.sleep(0.3)
            python.terminate()
            _, said = python.communicate(timeout=60)
        self.assertEqual(python.returncode, 143, said)
        self.assertNotIn("Traceback", said)
        self.assertTrue((out / "checkpoint.h5").exists())
        self.assertEqual(bagnold.status(out).state, "stopped")

    def test_warnings_name_no_file_that_is_gone(self):
        """Those of a dictionary speak of the copy in the folder, those of a file of the file; what they tell to type works."""
        short = {**SCENE, "shear": {**SCENE["shear"], "strain": 0.5}}
        sweep = {**short, "sweep": {"grid": {"disks.seed": [1, 2]}}}
        path = self.scene_file("sweep.toml", **{key: value for key, value in sweep.items() if key != "disks"})
        for given, named in ((sweep, self.folder / "many/sweep.toml"), (path, path)):
            out = self.folder / ("many" if given is sweep else "others")
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                bagnold.run(short, self.folder / f"one{out.name}", progress=False)
                bagnold.sweep_file(given, out, progress=False)
            texts = [str(one.message) for one in told]
            self.assertTrue(any(f"in {named}, and `bagnold sweep {named} --out {out}` goes on" in text for text in texts), texts)
            for text in texts:
                self.assertNotIn(f"{tempfile.gettempdir()}/bagnold-", text.replace(str(self.folder), ""))
        copy = self.folder / "many/sweep.toml"
        copy.write_text(copy.read_text().replace("strain = 0.5\n", "strain = 0.625\n"))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            longer = bagnold.sweep_file(copy, self.folder / "many", progress=False)
        self.assertEqual([point.load().scene["shear.strain"] for point in longer], [0.625, 0.625])

    def test_resume(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            r = bagnold.resume(made().folder, progress=False)
        self.assertEqual(r["Z"], made()["Z"])
        with self.assertRaises(bagnold.InputError):
            bagnold.resume(self.folder / "none", progress=False)

    def test_points_that_fail(self):
        shutil.copy(made().folder / "state.h5", self.folder / "good.h5")
        shutil.copy(made().folder / "state.h5", self.folder / "fast.h5")
        with h5py.File(self.folder / "fast.h5", "r+") as file:
            file["state/velocity"][5] = [0, 1e3]
        sweep = {**SCENE, "start": {"kind": "state"}, "sweep": {"grid": {"start.file": ["fast.h5", "good.h5"]}}}
        here = os.getcwd()
        try:
            os.chdir(self.folder)
            with self.assertRaisesRegex(bagnold.SweepError, r"^point 1 of 2 \(start.file = .*fast.h5"):
                bagnold.sweep_file(sweep, "many", progress=False)
        finally:
            os.chdir(here)
        table = bagnold.sweep(self.folder / "many")
        self.assertEqual([point.status for point in table], ["failed", "done"])
        self.assertTrue(np.isnan(table["Z"][0]) and np.isfinite(table["Z"][1]))


class Programs(Folder):
    def test_where_it_is_looked_for(self):
        program = os.environ["BAGNOLD_PROGRAM"]
        self.assertEqual(bagnold.find_program(), os.path.abspath(program))
        with mock.patch.dict(os.environ, {"PATH": os.path.dirname(program)}):
            self.assertEqual(bagnold.find_program("bagnold"), os.path.abspath(program))
            del os.environ["BAGNOLD_PROGRAM"]
            self.assertEqual(bagnold.find_program(), os.path.abspath(program))
        with mock.patch.dict(os.environ, {"PATH": str(self.folder)}):
            del os.environ["BAGNOLD_PROGRAM"]
            with self.assertRaisesRegex(bagnold.FileError, "not in PATH.*BAGNOLD_PROGRAM"):
                bagnold.find_program()
            os.environ["BAGNOLD_PROGRAM"] = "no/such"
            with self.assertRaisesRegex(bagnold.FileError, "BAGNOLD_PROGRAM = no/such"):
                bagnold.find_program()


if __name__ == "__main__":
    unittest.main()
