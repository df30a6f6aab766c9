# SPDX-License-Identifier: BSD-3-Clause
"""Tools of PyPI, in environments that are kept in BAGNOLD_CACHE (~/.cache/bagnold)."""

import os
import pathlib
import subprocess
import sys

CANNOT = 77  # exit status where they cannot be installed


def provide(name, packages):
    """The folder of programs of an environment with these packages and the system's; made where it is not there.

    What they need comes from PyPI too, even where the system has it: an older one may not do, and a cache may be
    shared with a system that lacks it.
    """
    cache = pathlib.Path(os.environ.get("BAGNOLD_CACHE") or pathlib.Path(
        os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "bagnold")
    place = cache / name
    if not (place / "complete").exists():
        print(f"== Installing {', '.join(packages)} from PyPI", flush=True)
        python = "/usr/bin/python3" if pathlib.Path("/usr/bin/python3").exists() else sys.executable
        for words in ([python, "-m", "venv", "--clear", "--system-site-packages", place],
                      [place / "bin/pip", "install", "--quiet", "--disable-pip-version-check", "--ignore-installed",
                       *packages]):
            if subprocess.run(list(map(str, words))).returncode:
                sys.exit(CANNOT)
        (place / "complete").touch()
    return place / "bin"
