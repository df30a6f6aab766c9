# SPDX-License-Identifier: BSD-3-Clause
"""Files that are damaged, lost or moved under a run; file systems that lack something."""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

from bagnold import PROGRAM, SOURCE, CliTest, environment, read_state, write_state  # noqa: E402
from injector import injected  # noqa: E402

FRAMES = {"disks__count": 16, "shear__strain": 2.0**-6, "output__sample_strain": 2.0**-8,
          "output__trajectory_strain": 2.0**-9, "output__checkpoint_minutes": 1e-9}
ENDLESS = {**FRAMES, "shear__strain": 2.0**12, "output__sample_strain": 2.0**-6}
TRAJECTORY = ("trajectory.h5md", "trajectory.vtkhdf")


class Parts(CliTest):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        self.whole = self.run_new("whole", **FRAMES)

    def interrupted(self):
        """A run that was killed when it was over and all its parts but not its results were written."""
        fault = injected(self.out, call="rename", at=self.before_state(), error="KILL")
        with self.assertRaises(AssertionError):
            self.bagnold("run", self.scene(**FRAMES), "--out", self.out, env=environment(**fault))
        self.other, self.part = sorted((self.out / "trajectory.parts").iterdir())[:2]
        self.assertFalse((self.out / "state.h5").exists())

    def before_state(self):
        log = self.folder / "log"
        self.bagnold("run", self.scene(**FRAMES), "--out", self.out,
                     env=environment(**injected(self.out, log)))
        shutil.rmtree(self.out)
        renames = [line.split() for line in log.read_text().splitlines() if line.startswith("rename")]
        return next(int(number) for _, number, path in renames if path.endswith("/state.h5"))

    def check(self, spoil):
        """Everything else is there, and once the part is put back all is."""
        self.interrupted()
        content = self.part.read_bytes()
        spoil()
        result = self.bagnold("resume", self.out, "--quiet")
        self.assert_clean_error(result, 4, str(self.part), "put the part back")
        self.assert_same_results(self.whole, self.out)
        self.assertFalse((self.out / "trajectory.h5md").exists())
        self.assertEqual(self.bagnold("resume", self.out, "--quiet").returncode, 4)
        self.part.write_bytes(content)
        self.assertEqual(self.bagnold("resume", self.out, "--quiet").returncode, 0)
        for name in TRAJECTORY:
            self.assertEqual((self.out / name).read_bytes(), (self.whole / name).read_bytes())
        self.assertFalse(self.part.parent.exists())
        self.assertIn("nothing to resume", self.bagnold("resume", self.out).stdout)

    def test_lost(self):
        self.check(lambda: self.part.unlink())

    def test_damaged(self):
        content = bytearray()

        def spoil():
            content[:] = self.part.read_bytes()
            content[len(content) // 2] ^= 1
            self.part.write_bytes(content)
        self.check(spoil)

    def test_another(self):
        self.check(lambda: shutil.copy(self.other, self.part))

    def test_done_without(self):
        self.interrupted()
        self.part.unlink()
        self.assertEqual(self.bagnold("resume", self.out, "--quiet").returncode, 4)
        shutil.rmtree(self.part.parent)
        self.assertIn("nothing to resume", self.bagnold("resume", self.out).stdout)

    def test_links_are_not_followed(self):
        self.interrupted()
        mine = self.folder / "mine"
        mine.write_text("mine")
        for name in ("trajectory.h5md.tmp", "trajectory.vtkhdf.tmp", "state.h5.tmp"):
            (self.out / name).unlink(missing_ok=True)
            (self.out / name).symlink_to(mine)
        self.assertEqual(self.bagnold("resume", self.out, "--quiet").returncode, 0)
        self.assertEqual(mine.read_text(), "mine")


class Moved(CliTest):
    def begin(self):
        process = self.start("run", self.scene(**ENDLESS), "--out", self.folder / "out", "--quiet")
        parts = self.folder / "out/trajectory.parts"
        self.wait_until(lambda: len(list(parts.glob("*.h5md"))) > 2, process)
        return process

    def assert_ended(self, process):
        code, output = self.finish(process)
        self.assertEqual(code, 4, output)
        self.assertIn(str(self.folder / "out"), output)

    def test_away(self):
        process = self.begin()
        (self.folder / "out").rename(self.folder / "moved")
        self.assert_ended(process)
        self.assertFalse((self.folder / "out").exists())
        going_on = self.start("resume", self.folder / "moved")
        parts = self.folder / "moved/trajectory.parts"
        count = len(list(parts.iterdir()))
        self.wait_until(lambda: len(list(parts.iterdir())) > count + 1, going_on)

    def test_and_another_run_in_its_place(self):
        """Between two checkpoints; within one there is an instant in which nobody can tell."""
        out = self.folder / "out"
        scene = self.scene(**{**ENDLESS, "output__checkpoint_minutes": 1e6,
                              "output__trajectory_strain": 0.0})
        process = self.start("run", scene, "--out", out, "--quiet")
        self.wait_until((out / "scene.toml").exists, process)
        process.send_signal(signal.SIGUSR1)
        self.wait_until((out / "result.h5").exists, process)
        time.sleep(0.2)
        out.rename(self.folder / "moved")
        out.mkdir()
        process.send_signal(signal.SIGUSR1)
        self.assert_ended(process)
        self.assertEqual(list(out.iterdir()), [])


class Locks(CliTest):
    def run_without_locks(self, error, **more):
        fault = injected(self.folder / "out", call="flock", at=1, times="always", error=error)
        return self.bagnold("run", self.scene(**FRAMES), "--out", self.folder / "out", "--quiet",
                            env=environment(**fault, **more))

    def test_none_is_a_warning(self):
        whole = self.run_new("whole", **FRAMES)
        # EINVAL, ENOTTY, ENOSYS, of protocols and families, and the kernel's own ENOIOCTLCMD and ENOTSUPP
        for error in ("ENOLCK", "ENOTSUP", "22", "25", "38", "93", "94", "96", "97", "515", "524"):
            result = self.run_without_locks(error)
            self.assert_clean_error(result, 0, "warning", "without locks", "BAGNOLD_LOCKS=off")
            self.assert_same_results(whole, self.folder / "out")
            for name in TRAJECTORY:
                self.assertEqual((self.folder / "out" / name).read_bytes(), (whole / name).read_bytes())
            shutil.rmtree(self.folder / "out")

    def test_pictures_imports_and_the_package_do_without(self):
        """Each opens files with HDF5, which locks them if it is let."""
        state = self.folder / "packing.xyz"
        state.write_text('4\nLattice="6 0 0 0 6 0 0 0 1" Properties=radius:R:1:pos:R:2 pbc="T T F"\n'
                         "0.5 1 1\n0.5 4 1\n0.7 1 4\n0.7 4 4\n")
        for error in ("ENOLCK", "524"):
            with self.subTest(error=error):
                out = self.folder / f"out{error}"
                env = environment(**injected(self.folder, call="flock", at=1, times="always", error=error))
                sweep = self.folder / f"sweep{error}"

                def does(*words, told=""):
                    result = self.bagnold(*words, env=env)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    for line in result.stderr.splitlines():
                        self.assertRegex(line, told or "^$")
                    return result

                does("run", self.scene(**{**FRAMES, "output__plot": True, "measure__profiles": True}), "--out", out, "--quiet",
                     told="without locks|^bagnold: note: ")
                self.assertTrue((out / "plot.png").exists() and (out / "profiles.png").exists())
                (out / "plot.png").unlink()
                does("plot", out)
                self.assertTrue((out / "plot.png").exists())
                does("import", state, "--out", out / "imported.h5")
                does("export", out, "--to", "lammps")
                does("status", out)
                file = self.folder / "sweep.toml"
                file.write_text(self.scene(**FRAMES).read_text() + '[sweep]\ngrid = { "disks.packing_fraction" = [0.7, 0.75] }\n')
                does("sweep", file, "--out", sweep, "--quiet", told="without locks|^bagnold: (note|warning): ")
                does("plot", sweep, told="disks hardly met in them")  # of a strain of 2^-6
                program = (f"import sys; sys.path.insert(0, {str(SOURCE / 'python')!r}); import bagnold\n"
                           f"r = bagnold.load({str(out)!r}); print(len(r.frames), r['Z'].mean >= 0, len(r.series['Z']), r.state.box,\n"
                           f"r.contacts[-1].Z, bagnold.sweep({str(sweep)!r})['Z'])")
                said = subprocess.run(["/usr/bin/python3", "-c", program], capture_output=True, text=True, env=env)
                self.assertEqual((said.returncode, said.stderr), (0, ""))

    def test_none_wanted(self):
        result = self.run_without_locks("ENOLCK", BAGNOLD_LOCKS="off")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_a_broken_one_is_an_error(self):
        self.assert_clean_error(self.run_without_locks("EIO"), 4, ".lock", "Input/output error")


class Pipes(CliTest):
    """A file of a run or of a sweep is a pipe, which has no other end."""

    def setUp(self):
        super().setUp()
        self.film = {**FRAMES, "output__trajectory_strain": 2.0**-8}

    def assert_ends(self, *words):
        result = self.bagnold(*words, timeout=60)
        self.assertIn(result.returncode, (0, 2, 4), f"{words}: {result.stderr}")
        self.assertNotIn("Traceback", result.stderr)

    def test_of_a_run(self):
        out = self.run_new("whole", **self.film)
        for name in ("scene.toml", "state.h5", "result.h5", "summary.json", "checkpoint.h5", "trajectory.h5md"):
            file = out / name
            content = file.read_bytes()
            file.unlink()
            os.mkfifo(file)
            for words in (("run", self.scene(**self.film), "--out", out), ("resume", out), ("status", out),
                          ("watch", out), ("plot", out), ("report", out), ("movie", out, self.folder / "film.gif"),
                          ("export", out / "trajectory.h5md", self.folder / "film.xyz")):
                with self.subTest(pipe=name, command=words[0]):
                    self.assert_ends(*words)
            if file.is_fifo():
                file.unlink()
            file.write_bytes(content)

    def test_of_a_sweep(self):
        sweep = self.folder / "sweep.toml"
        sweep.write_text(self.scene(**FRAMES).read_text() + "[sweep]\ngrid = { \"disks.seed\" = [1, 2] }\n")
        out = self.folder / "out"
        self.bagnold("sweep", sweep, "--out", out, "--emit-slurm")
        log = next((out / "points").iterdir()) / "log.txt"
        for name in ("sweep.toml", "points.json", log.relative_to(out)):
            with self.subTest(pipe=name):
                (out / name).unlink(missing_ok=True)
                os.mkfifo(out / name)
                for words in (("status", out), ("sweep", sweep, "--out", out), ("plot", out), ("report", out)):
                    self.assert_ends(*words)
                (out / name).unlink()

    def test_in_memory(self):
        with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:  # its name begins as that of a device
            os.mkfifo(pathlib.Path(folder) / "scene.toml")
            self.assert_clean_error(self.bagnold("status", folder, timeout=60), 2, "is a pipe")

    def test_that_this_process_has_open_are_read(self):
        scene = self.scene(**FRAMES).read_text()
        result = subprocess.run([PROGRAM, "run", "/dev/stdin", "--out", self.folder / "out"], input=scene, text=True, capture_output=True,
                                timeout=60, env=environment())
        self.assertEqual(result.returncode, 0, result.stderr)


class State(CliTest):
    """A damaged state.h5 is refused; nothing crashes, and nothing is believed."""

    def setUp(self):
        super().setUp()
        self.path = self.folder / "start.h5"
        self.good = (self.run_new("first", disks__count=16) / "state.h5").read_bytes()
        self.path.write_bytes(self.good)
        self.state = read_state(self.path)
        self.begin = self.scene(disks__count=16, start__kind="state", start__file="start.h5",
                                shear__strain=2.0**-11, output__sample_strain=2.0**-11,
                                measure__every=1)

    def spoil(self, **places):
        content = bytearray(self.good)
        for place, byte in places.items():
            content[int(place[1:])] ^= byte
        self.path.write_bytes(content)

    def test_eight_bytes(self):
        self.path.write_bytes(self.good[:128] + b"\xff" * 8 + self.good[136:])
        self.refused(self.begin, "start.h5", "seal")
        self.path.write_bytes(self.good[:128] + b"\xff" * 8 + self.good[136:-64])  # and no seal
        self.refused(self.begin, "start.h5", "damaged")

    def test_one_bit_anywhere(self):
        chance = random.Random(5)
        for _ in range(20):
            with self.subTest():
                self.spoil(**{f"_{chance.randrange(len(self.good) - 64)}": 1 << chance.randrange(8)})
                self.refused(self.begin, "start.h5", "seal")

    def test_without_a_seal_bytes_are_read_or_refused(self):
        chance = random.Random(6)
        for _ in range(30):
            content = bytearray(self.good[:-64])
            for _ in range(3):
                content[chance.randrange(2500)] = chance.randrange(256)  # HDF5's tables
            self.path.write_bytes(content)
            result = self.bagnold("validate", self.begin)
            self.assertIn(result.returncode, (0, 2), result.stderr)

    def test_whole_and_written_anew(self):
        out = self.folder / "out"
        self.run_scene(self.begin, out, "--quiet")
        write_state(self.path, self.state)  # by h5py, no seal
        self.run_scene(self.begin, self.folder / "again", "--quiet")
        self.assert_same_state(out, self.folder / "again")


if __name__ == "__main__":
    unittest.main()
