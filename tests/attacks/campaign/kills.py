# SPDX-License-Identifier: BSD-3-Clause
"""Runs of every protocol are killed at random moments, and go on, and are killed again."""

import shutil
import signal
import subprocess
import time

from target import Targets

SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGUSR1)
MOST_KILLS = 4


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
            sent = random.choice(SIGNALS)
            process.send_signal(sent)
            try:
                _, errors = process.communicate(timeout=60)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                return f"{target.kind}: {sent.name}", "hangs"
            told.append(f"{sent.name} {process.returncode}")
            errors = errors.decode(errors="replace")
            # 2: killed before there was anything to go on with
            allowed = (0, 2, -sent, 128 + sent)
            if process.returncode not in allowed:
                return f"{target.kind}: {', '.join(told)}", f"exit code {process.returncode}: {errors}"
            if process.returncode == 2 and "holds no run" not in errors and "no such folder" not in errors:
                return f"{target.kind}: {', '.join(told)}", errors
        what = f"{target.kind}: {', '.join(told)}"
        return what, target.wrong_after(subprocess.CompletedProcess([], 0, "", ""), killed=True)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
