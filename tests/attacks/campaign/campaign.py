# SPDX-License-Identifier: BSD-3-Clause
"""Attacks for as long as one likes: scripts/attack, and a few minutes of each as tests.

An attack is a module with a class Attack(folder, random): trial() tries once and returns (what was
tried, what went wrong, "" if nothing), or a third part, how many it tried at once; why_not says why it
cannot be made here. Same seed, same trials, as far as they do not hang on time.
"""

import argparse
import importlib
import os
import pathlib
import random
import sys
import tempfile
import time
import traceback

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from target import memory  # noqa: E402

ATTACKS = ("faults", "kills", "masks", "flicker", "streams", "folders", "damage", "scene_files", "sweep_files", "importers")
SKIPPED = 77


def attack(name, seconds, seed, folder, say):
    """(trials, failures), or why there were none."""
    made = importlib.import_module(name).Attack(folder / name, random.Random(seed))
    trials = failures = 0
    end = time.monotonic() + seconds
    try:
        if why := getattr(made, "why_not", ""):
            return why
        while time.monotonic() < end:
            what, wrong, *many = made.trial()
            trials += many[0] if many else 1
            if wrong:
                failures += 1
                say(f"{name}, seed {seed}, trial {trials}: {what}\n    {wrong.strip()}")
    except Exception:
        failures += 1
        say(f"{name}, seed {seed}: the attack itself failed\n{traceback.format_exc()}")
    finally:
        made.close()
    return trials, failures


def table(rows):
    lines = [f"{'attack':12} {'trials':>10} {'failures':>9}"]
    for name, row in rows.items():
        lines.append(f"{name:12} {row}" if isinstance(row, str) else f"{name:12} {row[0]:10} {row[1]:9}")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("attacks", nargs="*", metavar="ATTACK", help=", ".join(ATTACKS))
    parser.add_argument("--seconds", type=float, default=120, help="of each attack [120]")
    parser.add_argument("--seed", type=int, help="of the first round [random]")
    parser.add_argument("--rounds", type=int, default=1, help="through all attacks [1]")
    options = parser.parse_args()
    names = options.attacks or ATTACKS
    if unknown := [name for name in names if name not in ATTACKS]:
        parser.error(f"no attack {unknown[0]} (there are {', '.join(ATTACKS)})")
    first = int.from_bytes(os.urandom(3), "little") if options.seed is None else options.seed
    rows = {}

    def say(text):
        print(text, flush=True)

    with tempfile.TemporaryDirectory(prefix="bagnold-attack-", dir=memory()) as folder:
        for seed in range(first, first + options.rounds):
            for name in names:
                done = attack(name, options.seconds, seed, pathlib.Path(folder), say)
                before = rows.get(name, (0, 0))
                rows[name] = done if isinstance(done, str) else tuple(
                    a + b for a, b in zip(before, done))
            if options.rounds > 1:
                say(f"after round {seed - first + 1}\n{table(rows)}")
    say(table(rows))
    if all(isinstance(row, str) for row in rows.values()):
        return SKIPPED
    return int(any(row[1] for row in rows.values() if not isinstance(row, str)))


if __name__ == "__main__":
    sys.exit(main())
