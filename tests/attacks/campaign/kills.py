# SPDX-License-Identifier: BSD-3-Clause
"""Runs of every protocol are killed at random moments, and go on, and are killed again. Many signals
come in pairs, as Slurm, `timeout`, terminals and users send them."""

import shutil
import signal
import subprocess
import time

from target import Targets

SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGUSR1)
STOPS = (signal.SIGTERM, signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
MOST_KILLS = 4
ONE_WISH = 0.03  # [s] within which two signals are one


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        self.targets = Targets(folder)
        self.seconds = {}

    def usual(self, target):
        """How long a run takes just now, [s]."""
        if target.kind not in self.seconds:
            begun = time.monotonic()
            target.run()
            self.seconds[target.kind] = time.monotonic() - begun
        return self.seconds[target.kind]

    def send(self, process):
        """Signals at this moment: which, and whether the run has to stop with a checkpoint."""
        random = self.random
        if random.random() < 0.5:
            process.send_signal(sent := random.choice(SIGNALS))
            return (sent,), True
        pair, pause = (random.choice(STOPS), random.choice(STOPS)), random.choice(
            (random.uniform(0, ONE_WISH), random.uniform(0, 1.5)))
        begun = time.monotonic()
        process.send_signal(pair[0])
        time.sleep(pause)
        process.send_signal(pair[1])
        return pair, time.monotonic() - begun < ONE_WISH

    def trial(self):
        random, target = self.random, self.targets.any(self.random)
        usual = self.usual(target)
        target.clear()
        told = []
        for _ in range(random.randint(1, MOST_KILLS)):
            begun_before = target.out.exists()
            words = ["resume", target.out, "--quiet"] if begun_before and target.kind != "sweep" else None
            process = target.start(words, stderr=subprocess.PIPE)
            time.sleep(random.uniform(0, usual))
            sent, patient = self.send(process)
            try:
                _, errors = process.communicate(timeout=60)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                return f"{target.kind}: {sent}", "hangs"
            told.append(f"{' '.join(one.name for one in sent)} {process.returncode}")
            errors = errors.decode(errors="replace")
            # 2: killed before there was anything to go on with
            allowed = (0, 2, *(-one for one in sent), *(128 + one for one in sent))
            if patient and process.returncode > 128 and "stopped" not in errors:
                return f"{target.kind}: {', '.join(told)}", f"quit without a checkpoint: {errors}"
            if process.returncode not in allowed:
                return f"{target.kind}: {', '.join(told)}", f"exit code {process.returncode}: {errors}"
            if process.returncode == 2 and "holds no run" not in errors and "no such folder" not in errors:
                return f"{target.kind}: {', '.join(told)}", errors
        what = f"{target.kind}: {', '.join(told)}"
        return what, target.wrong_after(subprocess.CompletedProcess([], 0, "", ""), killed=True)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
