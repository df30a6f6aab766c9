#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bagnold beside LAMMPS: the same packing, law, box and time step, one core, runs interleaved.

    lammps.py BAGNOLD                      every case: a table of speeds
    lammps.py BAGNOLD CASE... --physics    no timing: forces, stress and contacts of both
    lammps.py BAGNOLD CASE... --tune       LAMMPS alone, its settings against each other
    lammps.py BAGNOLD CASE... --bias       LAMMPS alone, how wrong it is with larger time steps
    lammps.py --list

Speeds are steps of a disk per second of CPU time inside the time loop, so that a machine shared with
others does not decide: what each program reports per second of wall time, divided by its share of a
core. LAMMPS evaluates forces once a step, Bagnold twice (PRE 95, 052903 (2017), Eqs. 21-24): both
ratios are printed. Bagnold samples its observables all along, LAMMPS prints nothing. What was tried
to make LAMMPS fast, and what it was worth: README.md.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import time
import tomllib
from dataclasses import dataclass, replace

import h5py
import numpy as np

import lammps_scene as peer

WINDOW = 1e-2  # strain over which stress and contacts are averaged for --physics


class LateList(SystemExit):
    """LAMMPS has missed pairs."""


@dataclass(frozen=True)
class Case:
    """A steady state: its file, its scene, and how LAMMPS runs it fastest."""

    name: str
    state: str
    count: int
    packing_fraction: float
    scene: peer.Scene
    tuning: peer.Tuning


FEW = {"newton": "off"}  # few contacts: computing a pair twice at a face costs less than sending forces

TUNINGS = {name: peer.Tuning(**tuning) for name, tuning in {
    "cd_rot82-1e-4-1024": {"skin": 0.2},
    "cd_rot82-1e-4-65536": {"skin": 0.25},
    "cd_n-q1-1e-4-1024": {"skin": 0.1, **FEW},
    "cd_n-q50-1e-4-1024": {"skin": 0.1, **FEW},
    "cd_n-q50-1e-5-1024": {"skin": 0.06, **FEW},
    "cd_n-q50-1e-4-65536": {"skin": 0.25, **FEW},
    "cd_n-q50-1e-5-65536": {"skin": 0.25, **FEW},
}.items()}


# The longest step that keeps p, sigma and Z within 1% (--bias, README.md); for large N that of 1024.
LONGEST = {name: 0.1 if name.startswith("cd_rot82") else 0.4 for name in TUNINGS if "-q1-" not in name}
TIME_STEPS = (0.5, 0.4, 0.3, 0.2, 0.15, 0.125, 0.1, 0.05)  # tried by --bias
EXACT_STEP = 0.005  # what they are held against
STRETCH = 20.0  # [tau_e], from common starts: long beside a collision, too short to come apart


def with_time_step(case, time_step):
    """Looks at the list as often in time, not in steps."""
    every = max(1, int(case.tuning.every * case.scene.time_step / time_step))
    return replace(case, scene=replace(case.scene, time_step=time_step),
                   tuning=replace(case.tuning, every=every))


def load(states, name):
    """The case whose state and scene are in the folder `states`, as `scripts/bench states` leaves it."""
    folder = os.path.join(states, name)
    try:
        with open(os.path.join(folder, "scene.toml"), "rb") as file:
            scene = tomllib.load(file)
    except FileNotFoundError:
        sys.exit(f"{folder} is missing: `scripts/bench states --rows {name} --states {states}` makes it")
    disks = scene["disks"]
    physics = peer.Scene(disks["model"], disks["elasticity"], scene["shear"]["strain_rate"], disks["mass"])
    return Case(name, os.path.join(folder, "state.h5"), disks["count"], disks["packing_fraction"],
                physics, TUNINGS[name])


def run_bagnold(options, case, rate, strain, folder, window=WINDOW):
    """Runs Bagnold; its summary."""
    os.makedirs(folder, exist_ok=True)
    scene = case.scene
    path = os.path.join(folder, "bagnold.toml")
    with open(path, "w") as out:
        out.write(f"""[disks]
model = "{scene.model}"
count = {case.count}
packing_fraction = {case.packing_fraction}
elasticity = {scene.elasticity}
mass = "{scene.mass}"
[start]
kind = "state"
file = {json.dumps(case.state)}
[shear]
strain_rate = {rate}
strain = {strain:.12g}
discard = 0.0
[integration]
scheme = "modified-velocity-verlet"
time_step = {scene.time_step}
[output]
sample_strain = {min(window, strain / 4):.12g}
plot = false
""")
    results = os.path.join(folder, "bagnold")
    cpu, wall = os.times(), time.monotonic()
    subprocess.run([options.bagnold, "run", path, "--threads", "1", "--out", results, "--force",
                    "--quiet"], check=True, stdout=subprocess.DEVNULL)
    wall, now = time.monotonic() - wall, os.times()
    with open(os.path.join(results, "summary.json")) as file:
        summary = json.load(file)
    used = now.children_user + now.children_system - cpu.children_user - cpu.children_system
    summary["speed"] = summary["disk_steps_per_second"] / min(1.0, used / wall)
    return summary


def run_lammps(program, case, folder, tail, arguments=()):
    """Runs LAMMPS; steps of a disk per CPU second in its last loop."""
    peer.write_scene(folder, peer.read_state(case.state, case.scene.rate), case.scene, case.tuning, tail)
    subprocess.run([program, "-in", "in.scene", "-screen", "none", *arguments],
                   cwd=folder, check=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    with open(os.path.join(folder, "log.lammps")) as log:
        lines = log.read().splitlines()
    loop = [line.split() for line in lines if line.startswith("Loop time")][-1]
    dangerous = [int(line.split()[-1]) for line in lines if line.startswith("Dangerous builds")]
    if sum(dangerous) > 0:
        raise LateList(f"{case.name}: LAMMPS reports dangerous builds: its list came too late; lower --every")
    share = [float(line.split("%")[0]) / 100 for line in lines if "CPU use" in line][-1]
    seconds = float(loop[3]) * min(1.0, share)
    return case.count * int(loop[8]) / seconds if seconds > 0 else np.inf


def lammps_with(options, case, folder, tail):
    return run_lammps(options.lammps, case, folder, tail, options.lammps_argument)


def spread(values, form):
    return f"{statistics.median(values):{form}} ({min(values):{form}}-{max(values):{form}})"


def compare_speed(options, case):
    """One row of the table."""
    folder = os.path.join(options.work, case.name)
    step_strain = case.scene.rate * case.scene.time_step

    def lammps(steps):
        return lammps_with(options, case, folder, peer.timed_tail(steps, steps // 10))

    def bagnold(steps):
        return run_bagnold(options, case, case.scene.rate, steps * step_strain, folder)["speed"]

    def steps_for(speed):
        return max(1000, round(options.seconds * speed / case.count, -2))

    guess = int(2e7 / case.count) + 1000  # about a second: how many steps last long enough
    steps = {run: int(steps_for(run(guess))) for run in (lammps, bagnold)}
    steps[bagnold] = int(steps_for(bagnold(steps[bagnold])))  # the first was short beside its start
    pairs = []
    for n in range(options.rounds):
        order = (lammps, bagnold) if n % 2 == 0 else (bagnold, lammps)
        speed = {run: run(steps[run]) for run in order}
        pairs.append((speed[lammps] / 1e6, speed[bagnold] / 1e6))
    ratios = [mine / theirs for theirs, mine in pairs]
    print(f"| {case.name} | {spread([a for a, b in pairs], '.1f')} | "
          f"{spread([b for a, b in pairs], '.1f')} | {spread(ratios, '.2f')} | "
          f"{2 * statistics.median(ratios):.1f} | {steps[lammps]} | {steps[bagnold]} |", flush=True)


def compare_tunings(options, case):
    """LAMMPS alone: the case's settings, and each of them changed, in turn."""
    folder = os.path.join(options.work, case.name)
    other = [{}, *({"skin": round(case.tuning.skin * factor, 3)} for factor in (0.5, 0.7, 1.4, 2)),
             {"every": 1}, {"every": 10}, {"newton": "on"}, {"newton": "off"}, {"centred": False},
             {"order": "blocks"}, {"order": "given"}, {"style": "granular"}, {"style": "single"}]
    other = [change for change in other
             if not change or replace(case.tuning, **change) != case.tuning]
    speeds = [[] for _ in other]
    for _ in range(options.rounds):
        for change, mine in zip(other, speeds):
            one = replace(case, tuning=replace(case.tuning, **change))
            steps = int(options.seconds * 2e7 / case.count)
            mine.append(lammps_with(options, one, folder, peer.timed_tail(steps, steps // 10)) / 1e6)
    print(f"{case.name}: {case.tuning}")
    for change, mine in zip(other, speeds):
        print(f"    {spread(mine, '.1f')} {change or 'as it is'}", flush=True)


def blocks(series):
    """Mean and standard error from blocks, the largest error over block lengths that leave 8."""
    values, error = np.asarray(series), 0.0
    while len(values) >= 8:
        error = max(error, values.std(ddof=1) / np.sqrt(len(values)))
        values = 0.5 * (values[: len(values) // 2 * 2 : 2] + values[1 : len(values) // 2 * 2 : 2])
    return np.mean(series), error


def stretch_means(options, case, time_step):
    """p, sigma and Z of the forces, means over a stretch; NaN where disks fly apart."""
    steps = round(STRETCH / time_step)
    folder = os.path.join(options.work, case.name)
    try:
        lammps_with(options, with_time_step(case, time_step), folder, peer.sample_tail(steps, steps, steps))
    except (subprocess.CalledProcessError, LateList):
        return np.full(3, np.nan)
    xx, yy, xy, contacts = np.loadtxt(os.path.join(folder, "stress.txt"), ndmin=2)[-1][1:]
    return np.array([0.5 * (xx + yy), -xy, contacts])


def compare_time_steps(options, case):
    """Bias of LAMMPS' means over a stretch for each time step, from common starts along the flow."""
    found = {time_step: [] for time_step in (EXACT_STEP, *TIME_STEPS)}
    start = case
    for k in range(options.starts):
        folder = os.path.join(options.work, f"{case.name}-start-{k}")
        run_bagnold(options, start, case.scene.rate, 10 * STRETCH * case.scene.rate, folder)
        start = replace(case, state=os.path.join(folder, "bagnold", "state.h5"))
        for time_step, means in found.items():
            means.append(stretch_means(options, start, time_step))
    exact = np.array(found[EXACT_STEP])
    for time_step in TIME_STEPS:
        change = 100 * (np.array(found[time_step]) - exact) / exact.mean(0)
        error = change.std(0, ddof=1) / np.sqrt(len(change))
        cells = (f"{a:+.2f} ({b:.2f})" for a, b in zip(change.mean(0), error))
        print(f"| {case.name} | {time_step:g} | {' | '.join(cells)} |", flush=True)


def compare_physics(options, case):
    """Forces of the first step, then pressure, shear stress and contacts over a strain."""
    folder = os.path.join(options.work, case.name)
    print(f"{case.name}, strain {options.strain}")
    if case.count <= 10000:  # all pairs
        lammps_with(options, case, folder, peer.FORCE_TAIL)
        peer.check_forces(folder, peer.read_state(case.state, case.scene.rate), case.scene)
    run_bagnold(options, case, case.scene.rate, options.strain, folder)
    window = min(WINDOW, options.strain / 4)
    steps = round(options.strain / (case.scene.rate * case.scene.time_step))
    every = max(10, round(window * steps / options.strain) // 100)
    lammps_with(options, case, folder, peer.sample_tail(steps, every))
    rows = np.loadtxt(os.path.join(folder, "stress.txt"))[1:]
    per_window = round(window * steps / options.strain / every)
    rows = rows[: len(rows) // per_window * per_window].reshape(-1, per_window, rows.shape[1]).mean(1)
    theirs = {"p": 0.5 * (rows[:, 1] + rows[:, 2]), "sigma": -rows[:, 3], "Z": rows[:, 4]}
    with h5py.File(os.path.join(folder, "bagnold", "result.h5")) as file:
        series = {name: file["series/" + name][:] for name in ("p_el", "p_dis", "sigma_el", "sigma_dis", "Z")}
    ours = {"p": series["p_el"] + series["p_dis"], "sigma": series["sigma_el"] + series["sigma_dis"],
            "Z": series["Z"]}  # LAMMPS' stress of the forces, without the kinetic part
    for name in theirs:
        (a, da), (b, db) = blocks(theirs[name]), blocks(ours[name])
        first = theirs[name][0] / ours[name][0] - 1
        error = np.hypot(da, db)  # 0: too few windows to tell
        apart = f"{(a - b) / error:+.1f} standard errors" if error else f"{100 * (a / b - 1):+.2f}%"
        print(f"    {name:5} LAMMPS {a:.5g} +- {da:.1g}   Bagnold {b:.5g} +- {db:.1g}   "
              f"difference {apart}; first window {100 * first:+.2f}%")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bagnold", nargs="?", help="the program")
    parser.add_argument("cases", nargs="*", help="by default all")
    parser.add_argument("--list", action="store_true", help="the names of the cases")
    parser.add_argument("--physics", action="store_true", help="compare results, not speed")
    parser.add_argument("--tune", action="store_true", help="compare settings of LAMMPS")
    parser.add_argument("--bias", action="store_true", help="LAMMPS with larger time steps")
    parser.add_argument("--strain", type=float, default=1.0, help="for --physics")
    parser.add_argument("--starts", type=int, default=16, help="for --bias")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=3.0, help="of each timed run")
    parser.add_argument("--states", default="results/bench-states",
                        help="folder that `scripts/bench states` made")
    parser.add_argument("--work", default="peer-work", help="folder for the runs")
    parser.add_argument("--lammps", default="lmp", help="the program")
    parser.add_argument("--lammps-argument", action="append", default=[],
                        help="passed on, as --lammps-argument=-sf --lammps-argument=omp")
    parser.add_argument("--style", choices=["hybrid", "granular", "single"])
    options = parser.parse_args()
    if options.list:
        print("\n".join(TUNINGS))
        return
    if not options.bagnold:
        parser.error("which program? lammps.py build/openmp/bagnold")
    unknown = set(options.cases) - set(TUNINGS)
    if unknown:
        parser.error(f"no such case: {', '.join(sorted(unknown))}; see --list")
    for name in ("work", "states", "bagnold"):
        setattr(options, name, os.path.abspath(getattr(options, name)))
    chosen = [load(options.states, name) for name in options.cases or TUNINGS]
    if options.style:
        chosen = [replace(case, tuning=replace(case.tuning, style=options.style)) for case in chosen]
    if options.bias:
        print("Per cent, standard errors in brackets\n\n| case | dt | p | sigma | Z |\n"
              "| --- | --- | --- | --- | --- |", flush=True)
        for one in chosen:
            compare_time_steps(options, one)
        return
    if options.physics or options.tune:
        for one in chosen:
            (compare_physics if options.physics else compare_tunings)(options, one)
        return
    print("Million steps of a disk per second, median (least-most) of "
          f"{options.rounds} interleaved rounds, one core\n")
    print("| case | LAMMPS | Bagnold | ratio per step | per force evaluation | steps timed, LAMMPS "
          "| Bagnold |\n| --- | --- | --- | --- | --- | --- | --- |", flush=True)
    for one in chosen:
        compare_speed(options, one)


if __name__ == "__main__":
    main()
