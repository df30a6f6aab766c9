# SPDX-License-Identifier: BSD-3-Clause
"""One file call fails under a run, or under one that goes on, once, for a while or for good."""

import shutil

from injector import counted, injected
from target import Targets

ERRORS = {
    "open": ("EIO", "EACCES", "ENOSPC", "KILL"),
    "write": ("EIO", "ENOSPC", "EDQUOT", "HALF", "LOST", "KILL"),
    "pwrite": ("EIO", "ENOSPC", "EDQUOT", "HALF", "LOST", "KILL"),
    "read": ("EIO",),
    "pread": ("EIO",),
    "fsync": ("EIO", "KILL"),
    "ftruncate": ("EIO", "ENOSPC"),
    "close": ("EIO", "ENOSPC", "KILL"),
    "rename": ("EIO", "ENOSPC", "EACCES", "KILL"),
    "unlink": ("EIO", "EACCES", "KILL"),
    "mkdir": ("EIO", "ENOSPC", "EACCES"),
    "flock": ("EIO", "EINTR"),
}
TIMES = (1, 1, 1, 2, 5, 20, "always")


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        self.targets = Targets(folder)
        self.counts = {}

    def counts_of(self, target):
        if target.kind not in self.counts:
            log = self.folder / f"{target.kind}.log"
            target.run(env=injected(target.out, log))
            self.counts[target.kind] = counted(log)
        return self.counts[target.kind]

    def trial(self):
        random, target = self.random, self.targets.any(self.random)
        counts = self.counts_of(target)
        call = random.choice([name for name in ERRORS if counts[name]])
        at, error = random.randint(1, counts[call]), random.choice(ERRORS[call])
        times = 1 if error in ("KILL", "EINTR") else random.choice(TIMES)
        what = f"{target.kind}: {call} {at} of {counts[call]} {error}, times {times}"
        half = random.random() < 0.3 and target.kind != "sweep" and counts["rename"] > 1
        words = None
        if half:  # under one that goes on
            cut = random.randint(1, counts["rename"])
            target.run(env=injected(target.out, call="rename", at=cut, error="KILL"))
            words, what = ["resume", target.out, "--quiet"], f"{what}, after a kill at rename {cut}"
        result = target.run(words, env=injected(target.out, call=call, at=at, times=times, error=error))
        wrong = target.wrong_after(result, killed=result.returncode == -9 and error == "KILL")
        return what, wrong

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
