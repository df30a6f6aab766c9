# SPDX-License-Identifier: BSD-3-Clause
"""Runs and sweeps in masks of a few cores, under what binds OpenMP to some: nothing leaves its mask,
no point of a sweep and no replica is bound to less, and the files are those of an undisturbed run."""

import os
import pathlib
import shutil
import subprocess
import time

from target import Targets

CORES = sorted(os.sched_getaffinity(0))
BINDING = {
    "OMP_PROC_BIND": ("true", "false", "spread", "close", "master", "spread,close", "x"),
    "OMP_PLACES": ("cores", "threads", "sockets", "{0}", "{0}:1", "{0,1}", "{99}", "x"),
    "GOMP_CPU_AFFINITY": ("0", "0-1", "1 0", "99", "x"),
    "OMP_NUM_THREADS": ("1", "2", "7"),
}
UNBOUND = ("replicas", "sweep")  # kinds whose threads and points are their own


def tasks_below(pid):
    """(process, thread) of all processes that descend from one, but for those that are not yet what they
    will be: a child of a sweep before its exec() has the command line of the sweep."""
    children, words = {}, {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
                words[int(entry.name)] = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            children.setdefault(parent, []).append(int(entry.name))
    found, waiting = [], [child for child in children.get(pid, []) if b"resume" in words[child]]
    while waiting:
        one = waiting.pop()
        waiting += children.get(one, [])
        try:
            found += [(one, int(task.name)) for task in pathlib.Path(f"/proc/{one}/task").iterdir()]
        except OSError:
            pass
    return found


def mask_of(task):
    try:
        return sorted(os.sched_getaffinity(task))
    except OSError:
        return None


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        self.targets = Targets(folder)

    def strays(self, process, kind, mask, placed):
        """Looks at all tasks of a run until it ends; the first that is elsewhere than it may be. Where the
        environment names places, OpenMP puts the first thread there before main()."""
        wrong = ""
        while process.poll() is None:
            for pid, task in tasks_below(process.pid):
                found = mask_of(task)
                if not found or wrong:
                    continue
                if not set(found) <= set(mask) or (kind in UNBOUND and found != mask):
                    wrong = f"task {task} of process {pid} is on {found}"
            own = mask_of(process.pid)
            if own and not placed and not set(own) <= set(mask):
                wrong = wrong or f"the process is on {own}"
            time.sleep(0.002)
        return wrong

    def trial(self):
        random, target = self.random, self.targets.any(self.random)
        mask = sorted(random.sample(CORES, random.randint(1, len(CORES))))
        env = {name: random.choice(values) for name, values in BINDING.items() if random.random() < 0.4}
        words = target.words()
        if target.kind == "replicas" and random.random() < 0.5:  # of others the backend is in their files
            words += ["--threads", str(random.choice((1, 2, 3)))]
        if target.kind == "sweep":
            words[words.index("--jobs") + 1] = str(random.choice((1, 2)))
        what = f"{target.kind}: cores {mask}, {env}, {words[4:]}"
        target.clear()
        process = target.start(words, env=env, preexec_fn=lambda: os.sched_setaffinity(0, mask))
        wrong = self.strays(process, target.kind, mask, env.keys() & {"OMP_PLACES", "GOMP_CPU_AFFINITY"})
        _, errors = process.communicate()
        result = subprocess.CompletedProcess([], process.returncode, "", errors.decode(errors="replace"))
        return what, wrong or target.wrong_after(result)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
