# SPDX-License-Identifier: BSD-3-Clause
"""A run that is stopped, killed or damaged and resumed ends bit for bit like one that was not."""

import os
import random
import shutil
import signal
import time
import tomllib
import unittest

from bagnold import LAWS, CliTest, files_of, read_summary, seconds_to_strain

OFTEN = {"output__checkpoint_minutes": 0.0005}  # 30 ms
KILLS = {"CD": 2, "CD_n": 2, "CD_rot": 4, "CD_nt": 2}  # ten


class Ended(AssertionError):
    """A run was done before it was stopped: too short for what a machine now does in the time."""


class ResumeTest(CliTest):
    def prepare(self, seconds, **changes):
        """A scene that lasts about so long here, and its uninterrupted run."""
        changes.setdefault("disks__packing_fraction", 0.82)
        strain = seconds_to_strain(self, 0.7 * seconds, shear__strain=1.0, **changes)
        path = self.scene(shear__strain=float(strain), output__sample_strain=float(strain / 256),
                          measure__every=10, **changes)
        whole = self.folder / "whole"
        started = time.monotonic()
        self.run_scene(path, whole, "--threads", 1, "--quiet")
        return path, whole, time.monotonic() - started

    def checkpoint_stamp(self, out):
        try:
            status = os.stat(out / "checkpoint.h5")
            return (status.st_ino, status.st_mtime_ns)
        except FileNotFoundError:
            return None

    def wait_for_checkpoint(self, process, out, since=None):
        """Waits for a checkpoint other than `since`; False if the run ended first."""
        return self.wait_until(lambda: self.checkpoint_stamp(out) not in (None, since), process)

    def resume(self, out, *arguments, code=0):
        result = self.bagnold("resume", out, *arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def stop_after_checkpoint(self, process, out, since=None, number=signal.SIGTERM, code=143):
        if not self.wait_for_checkpoint(process, out, since):
            raise Ended(self.finish(process))
        process.send_signal(number)
        status, output = self.finish(process)
        if status == 0:
            raise Ended(output)
        self.assertEqual(status, code, output)
        self.assertFalse((out / "summary.json").exists())
        self.assertFalse((out / "state.h5").exists())
        return output

    def stopped_run(self, path, name="stopped"):
        """A run stopped by SIGTERM soon after its second checkpoint."""
        out = self.folder / name
        process = self.start("run", path, "--out", out)
        self.wait_for_checkpoint(process, out)
        self.stop_after_checkpoint(process, out, self.checkpoint_stamp(out))
        return out


class Start(ResumeTest):
    def test_stopped_while_random_disks_are_relaxed(self):
        """Before there is a step to keep: the run begins anew, and ends as it would have."""
        path = self.scene(disks__count=20000, disks__packing_fraction=0.83, shear__strain_rate=0.01,
                          shear__strain=4e-3, output__sample_strain=2e-3)
        out, whole = self.folder / "out", self.folder / "whole"
        process = self.start("run", path, "--out", out)
        self.assertTrue(self.wait_until((out / "scene.toml").exists, process))
        process.send_signal(signal.SIGTERM)
        status, output = self.finish(process)
        self.assertEqual(status, 143, output)
        self.assertIn("before the first step", output)
        self.assertFalse((out / "checkpoint.h5").exists())
        self.resume(out)
        self.run_scene(path, whole, "--quiet")
        self.assert_same_results(whole, out)


class Chain(ResumeTest):
    def test_seven_resumes(self):
        for model in LAWS:
            with self.subTest(model=model):
                try:
                    self.check_chain(model, 3.0)
                except Ended:  # other programs had slowed down what the length was chosen by
                    self.check_chain(model, 12.0)

    def check_chain(self, model, seconds):
        whole, out = self.folder / "whole", self.folder / "chain"
        for folder in (whole, out):
            shutil.rmtree(folder, ignore_errors=True)
        path, _, _ = self.prepare(seconds, disks__model=model, **OFTEN)
        process = self.start("run", path, "--out", out)
        self.stop_after_checkpoint(process, out)
        for leg in range(6):
            stamp = self.checkpoint_stamp(out)
            process = self.start("resume", out, "--threads", str(1 + leg % 2))
            self.stop_after_checkpoint(process, out, stamp)
        self.resume(out)
        self.assert_same_results(whole, out)


class Kill(ResumeTest):
    def test_ten_kills(self):
        seed = int.from_bytes(os.urandom(4), "little")
        chance = random.Random(seed)
        for model, kills in KILLS.items():
            with self.subTest(model=model, seed=seed):
                path, whole, seconds = self.prepare(1.2, disks__model=model, **OFTEN)
                out = self.folder / "killed"
                command = ["run", str(path), "--out", str(out)]
                for kill in range(kills):
                    process = self.start(*command)
                    self.wait_until((out / "scene.toml").exists, process)
                    time.sleep(chance.uniform(0.0, 0.7 * seconds / kills))
                    process.kill()
                    status, output = self.finish(process)
                    self.assertIn(status, (-signal.SIGKILL, 0), output)
                    backend = chance.choice(["serial", "openmp"])
                    threads = str(chance.choice([1, 2, 3]) if backend == "openmp" else 1)
                    command = ["resume", str(out), "--backend", backend, "--threads", threads]
                self.resume(out)
                self.assert_same_results(whole, out)
                shutil.rmtree(whole)
                shutil.rmtree(out)


class Signals(ResumeTest):
    def test_signals(self):
        path, whole, _ = self.prepare(2.0, disks__model="CD_n", output__checkpoint_minutes=1e6)
        with self.subTest("USR1 writes a checkpoint and goes on"):
            out = self.folder / "usr1"
            process = self.start("run", path, "--out", out)
            self.wait_until((out / "scene.toml").exists, process)
            time.sleep(0.1)
            for _ in range(3):
                stamp = self.checkpoint_stamp(out)
                process.send_signal(signal.SIGUSR1)
                self.assertTrue(self.wait_for_checkpoint(process, out, stamp))
                self.assertIsNone(process.poll())
            self.assertEqual(self.finish(process)[0], 0)
            self.assert_same_results(whole, out)
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number=number):
                out = self.folder / f"stop{code}"
                process = self.start("run", path, "--out", out)
                self.wait_until((out / "scene.toml").exists, process)
                time.sleep(0.2)
                process.send_signal(number)
                status, output = self.finish(process)
                self.assertEqual(status, code, output)
                self.assertTrue((out / "checkpoint.h5").exists())
                self.resume(out, "--quiet")
                self.assert_same_results(whole, out)

    def test_signals_while_the_start_is_relaxed(self):
        path = self.scene(disks__count=3000, disks__packing_fraction=0.845)
        for number, code in ((signal.SIGUSR1, None), (signal.SIGTERM, 143), (signal.SIGINT, 130)):
            with self.subTest(number=number):
                out = self.folder / f"relax{number}"
                process = self.start("run", path, "--out", out)
                self.wait_until((out / "scene.toml").exists, process)
                process.send_signal(number)
                time.sleep(0.3)
                if code is None:
                    self.assertIsNone(process.poll(), "USR1 ended the run")
                    process.kill()
                    self.finish(process)
                else:
                    status, output = self.finish(process, timeout=30)
                    self.assertEqual(status, code, output)
                self.assertFalse((out / "summary.json").exists())

    def test_a_second_signal_quits_at_once(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.folder / "out"
        process = self.start("run", path, "--out", out)
        self.wait_for_checkpoint(process, out)
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGTERM):
            if process.poll() is None:
                process.send_signal(number)
        status, _ = self.finish(process, timeout=10)
        self.assertIn(status, (130, 143, -signal.SIGINT, -signal.SIGTERM))
        self.resume(out)
        self.assert_same_results(whole, out)


class Damage(ResumeTest):
    def test_finished_run(self):
        out = self.run_new("out")
        before = files_of(out)
        text = self.resume(out)
        self.assertRegex(text.lower(), "finished|complete|done|nothing")
        after = files_of(out)
        for files in (before, after):
            files.pop(".lock", None)  # taken again for the moment
        self.assertTrue(after == before, "a finished run was touched")
        shutil.copytree(out, self.folder / "moved")
        self.resume(self.folder / "moved")

    def test_damaged_checkpoints(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD_rot", **OFTEN)
        stopped = self.stopped_run(path)
        checkpoints = sorted(p.name for p in stopped.glob("checkpoint*"))
        self.assertGreaterEqual(len(checkpoints), 2, f"two are kept: {checkpoints}")
        whole_bytes = (stopped / "checkpoint.h5").read_bytes()
        chance = random.Random(7)

        def flipped():
            data = bytearray(whole_bytes)
            for _ in range(20):
                data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
            return bytes(data)

        def one_flipped():
            data = bytearray(whole_bytes)
            data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
            return bytes(data)

        cases = {"cut": whole_bytes[: len(whole_bytes) // 2], "empty": b"",
                 "noise": bytes(chance.randrange(256) for _ in range(4000)),
                 "zeroed end": whole_bytes[:-2000] + bytes(2000),
                 "flipped": flipped(), "one bit 1": one_flipped(), "one bit 2": one_flipped()}
        for name, data in cases.items():
            with self.subTest(name=name):
                out = self.folder / "damaged"
                shutil.copytree(stopped, out)
                (out / "checkpoint.h5").write_bytes(data)
                text = self.resume(out)
                self.assertNotRegex(text.lower(), "from the (start|beginning)", name)
                self.assert_same_results(whole, out)
                shutil.rmtree(out)

    def test_no_checkpoint_verifies(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD_rot", **OFTEN)
        stopped = self.stopped_run(path)
        for name in ("none", "garbage", "temporary"):
            with self.subTest(name=name):
                out = self.folder / name
                shutil.copytree(stopped, out)
                for checkpoint in out.glob("checkpoint*"):
                    if name == "garbage":
                        checkpoint.write_bytes(checkpoint.read_bytes()[:3000])
                    else:
                        checkpoint.unlink()
                if name == "temporary":
                    (out / "checkpoint.h5.tmp").write_bytes(b"half a checkpoint")
                text = self.resume(out)
                self.assertRegex(text.lower(), "again|restart|start|beginning")
                self.assertIn("scene.toml", text)
                self.assert_same_results(whole, out)

    def test_scene_removed_between(self):
        """The checkpoint has it too: it is written again."""
        path, whole, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.stopped_run(path)
        (out / "scene.toml").unlink()
        self.resume(out)
        self.assert_same_results(whole, out)
        self.assertEqual((out / "scene.toml").read_text(), (whole / "scene.toml").read_text())

    def test_scene_edited_between(self):
        """resume goes on with the run that was started, or says no; never with a mixture."""
        path, whole, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.stopped_run(path)
        scene = (out / "scene.toml").read_text()
        (out / "scene.toml").write_text(scene.replace("0.82", "0.83"))
        self.assert_no_mixture(out, whole)

    def assert_no_mixture(self, out, whole):
        """resume refused, or went on as `whole`; then scene.toml is the scene of the summary."""
        result = self.bagnold("resume", out)
        if result.returncode:
            self.assert_clean_error(result, 2)
            return
        scene = tomllib.loads((out / "scene.toml").read_text())
        self.assertEqual(scene["disks"], read_summary(out)["scene"]["disks"])
        self.assert_same_state(whole, out)


    def test_killed_while_results_were_written(self):
        whole = self.run_new("whole")
        for missing in (["summary.json"], ["summary.json", "state.h5"],
                        ["summary.json", "state.h5", "result.h5"]):
            with self.subTest(missing=missing):
                out = self.folder / f"without{len(missing)}"
                shutil.copytree(whole, out)
                for name in missing:
                    (out / name).unlink()
                self.resume(out)
                self.assert_same_results(whole, out)

    def test_checkpoint_of_another_run(self):
        """Never a mixture: it is refused, or the run starts again."""
        path, whole, _ = self.prepare(1.0, disks__model="CD_rot", **OFTEN)
        out = self.stopped_run(path)
        text = path.read_text().replace("[shear]", "seed = 2\n[shear]")
        other_path = self.folder / "other.toml"
        other_path.write_text(text)
        other = self.stopped_run(other_path, "other")
        for checkpoint in out.glob("checkpoint*"):
            checkpoint.unlink()
        shutil.copy(other / "checkpoint.h5", out / "checkpoint.h5")
        self.assert_no_mixture(out, whole)


class Force(ResumeTest):
    def test_a_stopped_run_is_not_overwritten(self):
        path, _, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.stopped_run(path)
        before = files_of(out)
        self.assert_clean_error(self.bagnold("run", path, "--out", out, "--set", "disks.seed=2"), 2, "--force")
        after = files_of(out)
        for files in (before, after):
            files.pop(".lock", None)
        self.assertTrue(after == before, "the stopped run was touched")

    def test_nothing_of_the_old_run_is_left(self):
        """Forced over a finished and a stopped run, killed before its first checkpoint."""
        path, finished, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        stopped = self.stopped_run(path)
        text = path.read_text().replace("checkpoint_minutes = 0.0005", "checkpoint_minutes = 1e6")
        path = self.folder / "new.toml"
        path.write_text(text.replace("[shear]", "seed = 2\n[shear]"))
        whole = self.folder / "new"
        self.run_scene(path, whole, "--quiet")
        for out in (finished, stopped):
            with self.subTest(out=out.name):
                process = self.start("run", path, "--out", out, "--force")
                self.wait_until(lambda: "seed = 2" in self.scene_of(out), process)
                process.kill()
                self.finish(process)
                self.resume(out)
                self.assert_same_results(whole, out)

    def scene_of(self, out):
        try:
            return (out / "scene.toml").read_text()
        except FileNotFoundError:
            return ""


class Lock(ResumeTest):
    def test_two_processes_on_one_directory(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.folder / "out"
        process = self.start("run", path, "--out", out)
        self.assertTrue(self.wait_for_checkpoint(process, out))
        process.send_signal(signal.SIGSTOP)
        try:
            for arguments in (("resume", out), ("run", path, "--out", out),
                              ("run", path, "--out", out, "--force")):
                with self.subTest(arguments=arguments[0], force=len(arguments) == 5):
                    before = files_of(out)
                    self.assert_clean_error(self.bagnold(*arguments), 2)
                    self.assertTrue(files_of(out) == before, "the other run was touched")
            error = self.bagnold("resume", out).stderr
            self.assertRegex(error.lower(), f"lock|in use|another|running|{process.pid}")
        finally:
            process.send_signal(signal.SIGCONT)
        self.assertEqual(self.finish(process)[0], 0)
        self.assert_same_results(whole, out)

    def test_the_lock_dies_with_its_process(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD", **OFTEN)
        out = self.folder / "out"
        process = self.start("run", path, "--out", out)
        self.assertTrue(self.wait_for_checkpoint(process, out))
        process.kill()
        self.finish(process)
        self.resume(out)
        self.assert_same_results(whole, out)


class Options(ResumeTest):
    def test_resume_takes_threads_backend_and_quiet(self):
        path, whole, _ = self.prepare(1.0, disks__model="CD_rot", **OFTEN)
        out = self.stopped_run(path)
        result = self.bagnold("resume", out, "--threads", "2", "--backend", "openmp", "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assert_same_results(whole, out)
        summary = read_summary(out)
        self.assertGreater(summary["wall_seconds"], 0)

    def test_a_state_start_resumes_without_its_file(self):
        """The checkpoint holds all that is needed."""
        first = self.run_new("first")
        (self.folder / "start.h5").write_bytes((first / "state.h5").read_bytes())
        path, whole, _ = self.prepare(1.0, disks__packing_fraction=0.80, start__kind="state",
                                      start__file="start.h5", **OFTEN)
        out = self.stopped_run(path)
        (self.folder / "start.h5").unlink()
        self.resume(out)
        self.assert_same_results(whole, out)


if __name__ == "__main__":
    unittest.main()
