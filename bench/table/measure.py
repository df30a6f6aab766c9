# SPDX-License-Identifier: BSD-3-Clause
"""Rounds: every row with every engine once, then all again, so that what the machine does meanwhile
falls on all alike."""
import json
import os
import subprocess
import sys
from dataclasses import dataclass

import levels
import states
import targets

sys.path.insert(1, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "peers"))
import lammps  # noqa: E402


@dataclass
class Setup:
    benchmark: str  # bagnold_bench
    states: str
    work: str  # folder for LAMMPS
    shorter: float  # divides what is timed
    lammps: str  # "": is not installed


def say(text):
    print(text, file=sys.stderr, flush=True)


def runs_of(setup, rows, engines):
    """(row, engine) for all that can be timed here; says what cannot."""
    runs, missing = [], []
    for row in rows:
        if not states.is_there(setup.states, targets.state_of(row)):
            missing.append(row)
            continue
        runs += [(row, engine) for engine in engines]
        if setup.lammps and row in targets.PEER_ROWS:
            runs += [(row, targets.LAMMPS), (row, targets.DEFAULT), (row, targets.LAMMPS_LONGEST)]
    for row in missing:
        say(f"skipped: {row}: no state {targets.state_of(row)} in {setup.states}; `scripts/bench states` makes it")
    return runs


def rounds(setup, runs, repeats):
    """A dictionary {(row, engine): {quantity: value}} for each round."""
    found = []
    for n in range(repeats):
        clock = ask(setup, "clock_rate", 1)["cycles_per_second"]
        times = {}
        for row, engine in runs if n % 2 == 0 else reversed(runs):
            times[row, engine] = once(setup, row, engine, clock)
            say(f"round {n + 1}/{repeats}: {row} {engine}: "
                f"{times[row, engine][targets.SPEED] / 1e6:.4g} million disk-steps/s")
        found.append(times)
    return found


def once(setup, row, engine, clock):
    if engine in (targets.LAMMPS, targets.LAMMPS_LONGEST):
        return peer(setup, row, engine == targets.LAMMPS_LONGEST)
    level = engine if engine in levels.NAMES else ""
    times = ask(setup, targets.benchmark_of(row, "auto" if level else engine), targets.threads_of(row), level)
    speed = times[targets.SPEED]
    times[targets.WALL] = speed * times["real_time"] / times["wall_seconds"]
    times[targets.CYCLES] = clock / speed
    times["clock"] = clock
    return times


def ask(setup, name, threads, level=""):
    """The counters of one benchmark, run by itself, at a level of instructions if one is named."""
    command = [setup.benchmark, f"--benchmark_filter=^{name}/iterations:", "--benchmark_format=json",
               "--states", setup.states, "--shorter", str(setup.shorter), "--threads", str(threads)]
    environment = {**os.environ, levels.VARIABLE: level} if level else None
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    if done.returncode != 0 or not done.stdout.strip():
        raise SystemExit(f"error: {' '.join(command)} failed:\n{done.stderr}")
    found = json.loads(done.stdout)["benchmarks"]
    if len(found) != 1:
        raise SystemExit(f"error: {len(found)} benchmarks are called {name}")
    if found[0].get("error_occurred"):
        raise SystemExit(f"error: {name}: {found[0]['error_message']}")
    return found[0]


def peer(setup, row, longest):
    case = lammps.load(setup.states, row)
    if longest:
        case = lammps.with_time_step(case, lammps.LONGEST[row])
    steps = max(100, round(targets.PEER_ROWS[row] / setup.shorter / case.count))
    speed = lammps.run_lammps(setup.lammps, case, os.path.join(setup.work, row),
                              lammps.peer.timed_tail(steps, steps // 10))
    scene = case.scene
    return {targets.SPEED: speed,
            targets.SECONDS: case.count / (speed * scene.rate * scene.time_step)}
