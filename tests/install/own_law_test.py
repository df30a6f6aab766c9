# SPDX-License-Identifier: BSD-3-Clause
"""A program with a law of its own, PROGRAM: runs, is interrupted and goes on, with the bits of a run that was not,
and with those of the program BAGNOLD under CD_nt without damping along the normal, which is the same law."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import h5py
import numpy

own_law, bagnold, scene = sys.argv[1:4]
work = pathlib.Path(sys.argv[4])
work.mkdir()


def numbers(folder):
    """All series and the last state."""
    found = {}
    for name in ("result.h5", "state.h5"):
        with h5py.File(folder / name) as file:
            def keep(key, item):
                if isinstance(item, h5py.Dataset) and key.split("/")[0] in ("series", "state"):
                    found[key] = item[()]
            file.visititems(keep)
    assert any(key.startswith("series/") for key in found) and "state/position" in found, found.keys()
    return found


def expect_same(a, b):
    assert a.keys() == b.keys(), (a.keys(), b.keys())
    for key in a:
        assert numpy.array_equal(a[key], b[key], equal_nan=True), key


text = pathlib.Path(scene).read_text().replace("strain_rate = 1e-3", "strain_rate = 2e-4")
text = text.replace("strain = 5.0", "strain = 2.0")
assert 'model = "CD_t"' in text
(work / "own.toml").write_text(text + "\n[output]\nplot = false\n")
listed = text.replace('model = "CD_t"', 'model = "CD_nt"\ndamping_normal = 0.0')
(work / "listed.toml").write_text(listed + "\n[output]\nplot = false\n")

subprocess.run([own_law, work / "own.toml", work / "whole"], check=True)
whole = numbers(work / "whole")
assert 'model = "CD_t"' in (work / "whole/scene.toml").read_text()
assert "warnings" in json.loads((work / "whole/summary.json").read_text())

cut = subprocess.Popen([own_law, work / "own.toml", work / "cut"], stderr=subprocess.PIPE, text=True)
while not (work / "cut/scene.toml").exists():
    assert cut.poll() is None
    time.sleep(0.01)
time.sleep(0.1)
cut.send_signal(signal.SIGINT)
said = cut.communicate()[1]
assert cut.returncode == 130, (cut.returncode, said)
assert "the same program" in said and "bagnold resume" not in said, said  # which does not know the law
assert not (work / "cut/summary.json").exists()
subprocess.run([own_law, work / "own.toml", work / "cut"], check=True)
expect_same(numbers(work / "cut"), whole)

subprocess.run([bagnold, "run", work / "listed.toml", "--out", work / "listed", "--quiet"], check=True)
expect_same(numbers(work / "listed"), whole)

# The drive: what it gives and takes is all that is missing, and it takes more than the drag alone.
driven = text + '\n[drive]\nkind = "cubic"\ndrag = 0.02\n[output]\nplot = false\n'
(work / "driven.toml").write_text(driven)
subprocess.run([own_law, work / "driven.toml", work / "driven"], check=True)
powers = json.loads((work / "driven/summary.json").read_text())["observables"]
assert powers["drag_power"]["mean"] > 0.01 and powers["push_power"]["mean"] < 0, powers
gap = powers["energy_gap"]
assert abs(gap["mean"]) < 0.02 + 4 * (gap["error"] or 0), gap

# Pictures: the package is found by the bagnold in PATH.
drawn = {**os.environ, "PATH": f"{pathlib.Path(bagnold).parent}:{os.environ['PATH']}"}
(work / "drawn.toml").write_text(text.replace("strain = 2.0", "strain = 0.5"))
subprocess.run([own_law, work / "drawn.toml", work / "drawn"], check=True, env=drawn)
assert (work / "drawn/plot.png").exists()

refused = subprocess.run([bagnold, "run", work / "own.toml", "--out", work / "none"], stderr=subprocess.PIPE, text=True)
assert refused.returncode == 2 and "CD_t" in refused.stderr, refused
