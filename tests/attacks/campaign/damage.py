# SPDX-License-Identifier: BSD-3-Clause
"""Damaged bytes: of checkpoints and states many a second within one process (damage.cpp), and of every
file of an interrupted run, which then goes on."""

import os
import re
import shutil
import subprocess

from injector import INJECTOR, counted, injected
from target import Targets

PROGRAM = os.environ.get("DAMAGE", os.path.join(os.path.dirname(INJECTOR), "damage"))
PART = 10  # of what is done within one process, [s]


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        folder.mkdir(parents=True, exist_ok=True)
        self.targets = Targets(folder, ("steady", "measured", "replicas"))
        self.renames = {}

    def trial(self):
        draw = self.random.random()
        if draw < 0.1:
            return self.within("checkpoint" if draw < 0.05 else "state")
        return self.of_a_run()

    def within(self, kind):
        seed = self.random.randint(1, 2**31)
        result = subprocess.run([PROGRAM, kind, str(PART), str(seed)], capture_output=True, text=True,
                                errors="replace", cwd=self.folder, timeout=10 * PART + 60)
        trials = re.search(r"trials (\d+)", result.stdout)
        wrong = "" if result.returncode == 0 else f"{result.returncode}: {result.stdout}{result.stderr}"
        return f"{kind}, seed {seed}", wrong, int(trials[1]) if trials else 1

    def of_a_run(self):
        random, target = self.random, self.targets.any(self.random)
        if target.kind not in self.renames:
            log = self.folder / f"{target.kind}.log"
            target.run(env=injected(target.out, log))
            self.renames[target.kind] = counted(log)["rename"]
        target.run(env=injected(target.out, call="rename", error="KILL",
                                at=random.randint(2, self.renames[target.kind])))
        files = sorted(path for path in target.out.rglob("*") if path.is_file() and path.stat().st_size > 0)
        if (target.out / "summary.json").exists():  # what is done is not looked at again
            files = [path for path in files if path.name.startswith("checkpoint") or ".parts" in path.parent.name]
        told = []
        for path in random.sample(files, min(len(files), random.randint(1, 3))):
            told.append(f"{path.relative_to(target.out)} {self.spoil(path)}")
        result = target.run(["resume", target.out, "--quiet"])
        wrong = target.wrong_end(result)
        if result.returncode == 0:
            wrong = wrong or target.wrong_content()
        return f"{target.kind}: {', '.join(told)}", wrong

    def spoil(self, path):
        content = bytearray(path.read_bytes())
        at, size = self.random.randrange(len(content)), self.random.choice((1, 1, 8, 64, 512))
        kind = self.random.choice(("flip", "random", "zeros", "ones", "cut", "gone"))
        if kind == "flip":
            content[at] ^= 1 << self.random.randrange(8)
        elif kind == "random":
            content[at:at + size] = self.random.randbytes(len(content[at:at + size]))
        elif kind in ("zeros", "ones"):
            content[at:at + size] = (b"\0" if kind == "zeros" else b"\xff") * len(content[at:at + size])
        elif kind == "cut":
            del content[at:]
        if kind == "gone":
            path.unlink()
        else:
            path.write_bytes(content)
        return f"{kind} at {at}, {size}"

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
