# SPDX-License-Identifier: BSD-3-Clause
"""What scheme = "auto" does, state by state, beside two stages from the same starts: which method it takes
for which share of the steps, what that saves with all its pairs of stretches, and what comes out."""
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from statistics import mean, stdev

import implicit
from implicit import State

OBSERVABLES = ("p", "sigma", "Z", "T_g")
COLUMNS = ("state", "N", "strain", "starts", "methods", "share", "pairs", "p_kin_share", "gain",
           *(f"{name}{end}" for name in OBSERVABLES for end in ("", "_err")))


@dataclass(frozen=True)
class Case:
    state: State
    strain: float
    starts: int


def case(model, packing_fraction, elasticity, rate, count=1024):
    """Four starts, the slowest one; 24 and 40 where four were seen to tell a bias by chance."""
    many = {("CD", 0.82, 10.0, 1e-4, 1024): 24, ("CD_rot", 0.82, 1.0, 1e-4, 1024): 24, ("CD", 0.82, 1.0, 1e-3, 1024): 40}
    few = 1 if rate < 5e-6 or count > 1024 else 4
    starts = many.get((model, packing_fraction, elasticity, rate, count), few)
    return Case(State(model, packing_fraction, elasticity, rate, (), count), 4.0, starts)


CASES = [
    *(case(model, 0.82, 1.0, rate) for rate in (1e-3, 1e-4) for model in ("CD", "CD_rot")),
    case("CD_nt", 0.82, 1.0, 1e-4),
    *(case(model, 0.84, 1.0, 1e-4) for model in ("CD", "CD_rot")),
    *(case("CD", 0.82, elasticity, 1e-4) for elasticity in (0.1, 10.0, 50.0, 200.0)),
    case("CD_rot", 0.82, 10.0, 1e-4),
    # near the transition, and beyond it
    *(case("CD_rot", 0.80, 1.0, rate) for rate in (1e-4, 1e-5)),
    case("CD_rot", 0.76, 1.0, 1e-4),
    case("CD", 0.70, 1.0, 1e-5),
    # gases
    case("CD_n", 0.60, 50.0, 1e-4),
    case("CD_rot", 0.60, 1.0, 1e-4),
    # what takes long
    *(case(model, 0.82, 1.0, 1e-4, 65536) for model in ("CD", "CD_rot")),
    *(case(model, 0.82, 1.0, rate) for rate in (1e-5, 1e-6) for model in ("CD", "CD_rot")),
    *(case("CD", 0.82, 1.0, rate) for rate in (4e-7, 1e-7)),
]


def measure(program, folder, tiny, jobs, say):
    """Rows of COLUMNS."""
    for one in CASES[2:3] if tiny else CASES:
        say(f"auto: {one.state.title}")
        seeds = range(1, 3 if tiny else one.starts + 1)
        with ThreadPoolExecutor(jobs) as pool:
            files = list(pool.map(lambda seed: implicit.start(program, folder, one.state, seed, tiny), seeds))
        strain = 1.0 if tiny else one.strain
        pairs = [[stretch(program, one.state, file, scheme, strain, tiny)
                  for scheme in ("two-stage-leapfrog", "auto")] for file in files]
        yield [row(one, strain, pairs)]


def row(one, strain, pairs):
    found = [auto for _, auto in pairs]
    cells = [one.state.title, one.state.count, f"{strain:g}", len(pairs)]
    cells += [" or ".join(sorted({run["method"] for run in found})), f"{mean(run['share'] for run in found):.2f}",
              f"{mean(run['pairs'] for run in found):.1f}",
              f"{mean(run['p_kin'] / run['p'] for run in found):.2g}",
              f"{sum(plain['seconds'] for plain, _ in pairs) / sum(run['seconds'] for run in found):.2f}"]
    for name in OBSERVABLES:
        off = [100 * (run[name] / plain[name] - 1) for plain, run in pairs]
        cells += [f"{mean(off):.2f}", f"{stdev(off) / len(off) ** 0.5:.2f}" if len(off) > 1 else ""]
    return cells


def stretch(program, state, start, scheme, strain, tiny):
    """Means over a run, its seconds of CPU and what it counted."""
    import h5py

    settings = {"start.kind": "state", "start.file": start, "shear.strain_rate": state.rate,
                "shear.strain": strain, "shear.discard": 0, "integration.scheme": scheme}
    with tempfile.TemporaryDirectory() as folder:
        seconds = timed(program, implicit.scene(state, settings, tiny), folder)
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            told = json.load(file)
        with h5py.File(os.path.join(folder, "result.h5")) as found:
            means = {name: float(found["series"][name][...].mean()) for name in (*OBSERVABLES, "p_kin")}
            counted = {name: float(value) for name, value in found.attrs.items() if name.startswith("engine_")}
    bias = told.get("bias", {"method": {"scheme": scheme, "time_step": told["scene"]["integration"]["time_step"]}, "pairs": 0})
    pairs = bias["pairs"] + sum(trial["pairs"] for trial in bias.get("tried", []))
    return {**means, "seconds": seconds, "method": "{scheme} {time_step:.4g}".format(**bias["method"]), "pairs": pairs,
            "share": sum(counted.get(f"engine_steps_by_{method}", 0.0)
                         for method in ("implicit_damping", "quasi_static")) / told["steps"]}


def timed(program, settings, out):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        implicit.write_scene(file, settings)
        child = subprocess.Popen([program, "run", file.name, "--out", out, "--force", "--quiet", "--threads", "1"],
                                 stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
    if status:
        raise SystemExit(f"{settings} failed")
    return usage.ru_utime + usage.ru_stime
