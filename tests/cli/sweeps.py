# SPDX-License-Identifier: BSD-3-Clause
"""Sweep files, and what a sweep leaves, for the tests of `bagnold sweep`."""

import csv
import pathlib
import signal

from bagnold import CliTest, changed, scene_text

SEEDS = {"disks.seed": [1, 2, 3]}


def sweep_text(scene, grid=None, zip=None, chain=None):
    text = scene_text(scene) + "[sweep]\n"
    if chain:
        text += f'chain = "{chain}"\n'
    for name, lists in (("grid", grid), ("zip", zip)):
        if lists:
            inside = ", ".join(
                f'"{key}" = [{", ".join(values(one) for one in many)}]'
                for key, many in lists.items()
            )
            text += f"{name} = {{ {inside} }}\n"
    return text


def values(one):
    return f'"{one}"' if isinstance(one, str) else repr(one)


def rows(out):
    with open(pathlib.Path(out) / "sweep.csv", newline="") as file:
        return list(csv.DictReader(file))


def tables(out):
    """The tables as bytes."""
    return [(pathlib.Path(out) / name).read_bytes() for name in ("sweep.csv", "sweep.h5")]


def catches_term(pid):
    with open(f"/proc/{pid}/status") as file:
        caught = next(line for line in file if line.startswith("SigCgt:")).split()[1]
    return int(caught, 16) >> (signal.SIGTERM - 1) & 1 == 1


class SweepTest(CliTest):
    def sweep_file(self, grid=None, zip=None, chain=None, name="sweep.toml", **changes):
        path = self.folder / name
        path.write_text(sweep_text(changed(**changes), grid, zip, chain))
        return path

    def sweep(self, path, out, *arguments, code=0, **options):
        result = self.bagnold("sweep", path, "--out", out, *arguments, **options)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def points(self, out):
        return sorted((pathlib.Path(out) / "points").iterdir())

    def children(self, out):
        """Processes that work in the folder of a sweep, by id: their command lines name it."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    words = (entry / "cmdline").read_bytes().split(b"\0")
                    state = (entry / "stat").read_text().rpartition(")")[2].split()[0]
                except OSError:
                    continue
                inside = any(word.startswith(bytes(out / "points")) for word in words)
                if inside and state not in "ZX":
                    found.append(int(entry.name))
        return found
