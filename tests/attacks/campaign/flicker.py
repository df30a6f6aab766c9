# SPDX-License-Identifier: BSD-3-Clause
"""A small disk that is full for milliseconds now and then, under runs of every protocol."""

import shutil
import subprocess
import threading
import time

from target import Targets


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        folder.mkdir(parents=True, exist_ok=True)
        self.mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=24m", "tmpfs", folder],
                                      capture_output=True).returncode == 0
        self.why_not = "" if self.mounted else "may not mount a tmpfs"
        self.targets = Targets(folder)

    def flicker(self, over, moments):
        """Fills the disk for a moment, again and again."""
        for quiet, full in moments:
            if over.wait(quiet):
                return
            with open(self.folder / "filler", "wb", buffering=0) as file:
                for size in (1 << 20, 4096):
                    try:
                        while file.write(bytes(size)) == size:
                            pass
                    except OSError:
                        pass
                time.sleep(full)
            (self.folder / "filler").unlink()

    def trial(self):
        target = self.targets.any(self.random)
        moments = [(self.random.uniform(0, 0.05), self.random.choice((0.001, 0.003, 0.01, 0.1)))
                   for _ in range(self.random.randint(1, 40))]
        over = threading.Event()
        thread = threading.Thread(target=self.flicker, args=(over, moments))
        thread.start()
        result = target.run()
        over.set()
        thread.join()
        return f"{target.kind}: full {len(moments)} times", target.wrong_after(result)

    def close(self):
        if self.mounted:
            subprocess.run(["umount", "-l", self.folder], check=False)
        shutil.rmtree(self.folder, ignore_errors=True)
