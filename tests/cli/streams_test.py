# SPDX-License-Identifier: BSD-3-Clause
"""Standard streams that are closed, full or gone, and signals that come early or from a terminal."""

import itertools
import os
import signal
import subprocess
import time
import unittest

import h5py

from bagnold import PROGRAM, SCENE, CliTest, environment, read_summary, scene_text

FULL = "/dev/full"


class StreamTest(CliTest):
    def shell(self, redirections, *arguments):
        """Runs the program with streams as sh has them: ">&-" closes one."""
        words = " ".join(f"'{word}'" for word in (PROGRAM, *map(str, arguments)))
        return subprocess.run(["sh", "-c", f"{words} {redirections}"], env=environment(), cwd=self.folder,
                              capture_output=True, text=True, timeout=120)


class ClosedStreams(StreamTest):
    def test_no_message_gets_into_a_result(self):
        """Every set of closed streams: a run, loud and over its edge, leaves whole files."""
        path = self.scene(shear__strain_rate=2.0**-5)
        for count in range(1, 4):
            for streams in itertools.combinations(("0<&-", "1>&-", "2>&-"), count):
                out = self.folder / f"out{len(list(self.folder.iterdir()))}"
                result = self.shell(" ".join(streams), "run", path, "--out", out)
                self.assertEqual(result.returncode, 0, (streams, result.stderr))
                read_summary(out)
                for name in ("state.h5", "result.h5", "checkpoint.h5"):
                    with h5py.File(out / name) as file:
                        self.assertTrue(len(file) + len(file.attrs) > 0)

    def test_a_refusal_without_stderr(self):
        result = self.shell("2>&-", "validate", self.scene(disks__count=63))
        self.assertEqual(result.returncode, 2)


class FullStreams(StreamTest):
    def test_output_that_cannot_be_written(self):
        path = self.scene()
        for arguments in (("info",), ("--help",), ("validate", path), ("figure",)):
            result = self.shell(f"> {FULL}", *arguments)
            self.assertEqual(result.returncode, 4, (arguments, result.stderr))
            self.assertIn("bagnold: ", result.stderr)

    def test_a_run_is_whole_all_the_same(self):
        out = self.folder / "out"
        result = self.shell(f"> {FULL}", "run", self.scene(), "--out", out)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertTrue((out / "summary.json").exists())

    def test_messages_that_nobody_reads(self):
        for streams in (f"2> {FULL}", f"> {FULL} 2> {FULL}"):
            result = self.shell(streams, "validate", self.scene(disks__count=63))
            self.assertEqual(result.returncode, 2, streams)
            out = self.folder / f"out{self.written}"
            self.shell(streams, "run", self.scene(), "--out", out)  # warns
            self.assertTrue((out / "summary.json").exists(), streams)


class Signals(StreamTest):
    def long_run(self, name, *before):
        out = self.folder / name
        path = self.scene(shear__strain=2.0**20, output__sample_strain=2.0**12)
        process = subprocess.Popen([*before, PROGRAM, "run", path, "--out", out], env=environment(),
                                   cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.wait_until((out / "scene.toml").exists, process)
        return process, out

    def test_a_closed_terminal_stops_with_a_checkpoint(self):
        process, out = self.long_run("out")
        for _ in range(3):  # from the terminal and from the shell
            process.send_signal(signal.SIGHUP)
        status, said = self.finish(process)
        self.assertEqual(status, 128 + signal.SIGHUP, said)
        self.assertTrue((out / "checkpoint.h5").exists())
        self.assertIn("bagnold resume", said)

    def test_and_a_batch_system_behind_it(self):
        process, out = self.long_run("out")
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGTERM)
        self.assertIn(self.finish(process)[0], (129, 143))
        self.assertTrue((out / "checkpoint.h5").exists())

    def test_nohup(self):
        process, out = self.long_run("out", "nohup")
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGUSR1)
        self.wait_until((out / "checkpoint.h5").exists, process)
        time.sleep(0.2)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGTERM)
        self.assertEqual(self.finish(process)[0], 143)

    def test_a_wish_for_a_checkpoint_before_there_is_a_run(self):
        """The scene is a pipe: the program has begun, and waits for it."""
        pipe, out = self.folder / "scene.toml", self.folder / "out"
        os.mkfifo(pipe)
        process = self.start("run", pipe, "--out", out)
        with open(pipe, "w") as file:  # returns when it is opened for reading
            process.send_signal(signal.SIGUSR1)
            time.sleep(0.1)
            self.assertIsNone(process.poll())
            file.write(scene_text(SCENE))
        status, said = self.finish(process)
        self.assertEqual(status, 0, said)


if __name__ == "__main__":
    unittest.main()
