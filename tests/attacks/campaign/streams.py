# SPDX-License-Identifier: BSD-3-Clause
"""Standard streams that are closed, full, or a pipe that nobody reads; environments that fit no one."""

import os
import shutil
import subprocess

from target import Targets

HOSTILE = {
    "OMP_NUM_THREADS": ("0", "-3", "100000", "two", ""),
    "OMP_DYNAMIC": ("true",),
    "OMP_THREAD_LIMIT": ("1", "0"),
    "KOKKOS_NUM_THREADS": ("7", "-1", "x"),
    "HDF5_USE_FILE_LOCKING": ("FALSE", "TRUE", "?"),
    "HDF5_DISABLE_VERSION_CHECK": ("2",),
    "LC_ALL": ("de_DE.UTF-8", "C", "nonsense"),
    "TMPDIR": ("/nowhere", ""),
    "HOME": ("/nowhere",),
    "PYTHONPATH": ("/nowhere",),
    "PATH": ("",),
}


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        self.targets = Targets(folder)

    def streams(self):
        """Arguments of Popen, in words, and whether nothing can be said on stderr."""
        closed = [fd for fd in (0, 1, 2) if self.random.random() < 0.4]
        options = {"stderr": subprocess.PIPE}
        full = self.random.random() < 0.3
        if full:
            options["stdout"] = open("/dev/full", "wb")
        if closed:
            def close_them():
                for fd in closed:
                    os.close(fd)
            options["preexec_fn"] = close_them
        return options, f"closed {closed}{', stdout full' if full else ''}", 2 in closed

    def trial(self):
        target = self.targets.any(self.random)
        options, what, mute = self.streams()
        env = {name: self.random.choice(values) for name, values in HOSTILE.items()
               if self.random.random() < 0.15}
        words = target.words()
        if self.random.random() < 0.5:
            words.remove("--quiet")
        target.clear()
        result = target.run(words, env=env, **options)
        if "stdout" in options:
            options["stdout"].close()
        if mute and result.returncode in (0, 1, 2, 4):
            result.stderr = result.stderr or "(closed)"
        return f"{target.kind}: {what}, {env}", target.wrong_after(result)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
