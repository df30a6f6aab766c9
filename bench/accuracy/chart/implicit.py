# SPDX-License-Identifier: BSD-3-Clause
"""Long steps of implicit damping against short ones of two stages, from common starts: runs of the
program itself. What a short stretch differs by is the scheme's, before chaos hides it."""
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from statistics import mean, stdev

OBSERVABLES = ("p", "sigma", "Z", "T_g")
COLUMNS = ("state", "scheme", "time_step", "starts", "energy_gap", "p_kin_share",
           *(f"{name}{end}" for name in OBSERVABLES for end in ("", "_err")))
REFERENCE = ("two-stage-leapfrog", 0.05)  # at Q = 0.1 its own rule, which is less
STRETCH = 0.04  # strain


@dataclass(frozen=True)
class State:
    model: str
    packing_fraction: float
    elasticity: float
    rate: float
    steps: tuple  # of implicit damping, [tau_e]
    count: int = 1024

    @property
    def title(self):
        size = "" if self.count == 1024 else f" N={self.count}"
        return f"{self.model} {self.packing_fraction} Q={self.elasticity:g} {self.rate:g}{size}"

    @property
    def reference(self):
        scheme, step = REFERENCE
        return scheme, min(step, 0.05 * self.elasticity)


def newtonian(model, rate, count=1024):
    steps = (0.8, 1.2, 1.6, 2.0, 2.4) if model == "CD" else (0.8, 1.4, 1.8, 2.0, 2.4)
    return State(model, 0.82, 1.0, rate, steps, count)


STATES = [
    *(newtonian(model, rate) for rate in (1e-3, 1e-4, 1e-5, 1e-6) for model in ("CD", "CD_rot")),
    newtonian("CD_nt", 1e-4),
    State("CD", 0.78, 1.0, 1e-4, (0.8, 1.2, 1.6, 2.0)),
    *(newtonian(model, rate, 16384) for rate in (1e-3, 1e-4) for model in ("CD", "CD_rot")),
    *(State(model, 0.84, 1.0, 1e-4, (0.8, 1.2, 1.6)) for model in ("CD", "CD_n")),
    State("CD_rot", 0.84, 1.0, 1e-4, (0.8, 1.4, 1.8, 2.0)),
    State("CD", 0.82, 0.1, 1e-4, (1.6, 3.0, 5.0, 10.0)),
    State("CD_rot", 0.82, 0.1, 1e-4, (1.4, 1.8, 3.0, 5.0, 10.0)),
    *(State(model, 0.82, 10.0, 1e-4, (0.2, 0.4, 0.8)) for model in ("CD", "CD_rot")),
    # where it must not be used, and says so
    State("CD_rot", 0.80, 1.0, 1e-4, (0.4, 0.8, 1.2)),
    State("CD", 0.82, 50.0, 1e-4, (0.2, 0.4, 0.8)),
    State("CD_rot", 0.76, 1.0, 1e-4, (0.4, 0.8, 1.2)),
]


def measure(program, folder, tiny, jobs, say):
    """Rows of COLUMNS, state by state."""
    for state in STATES[:1] if tiny else STATES:
        say(f"implicit: {state.title}")
        starts = range(1, 3 if tiny else 7)
        methods = [("two-stage-leapfrog", 0.2 * min(1, state.elasticity))]
        methods += [("implicit-damping", step) for step in state.steps]
        with ThreadPoolExecutor(jobs) as pool:
            files = list(pool.map(lambda seed: start(program, folder, state, seed, tiny), starts))
            tasks = [(file, method) for file in files for method in (state.reference, *methods)]
            found = list(pool.map(lambda task: stretch(program, state, *task, tiny), tasks))
        by_method = {method: [found[k] for k, task in enumerate(tasks) if task[1] == method]
                     for method in (state.reference, *methods)}
        yield [row(state, method, by_method[method], by_method[state.reference]) for method in methods]


def row(state, method, found, reference):
    cells = [state.title, *method]
    whole = [(one, other) for one, other in zip(found, reference) if one and other]
    cells.append(len(whole))
    if not whole:  # no step of it held
        return cells + [""] * (len(COLUMNS) - len(cells))
    cells += [f"{mean(one[name] for one, _ in whole):.2g}" for name in ("energy_gap", "p_kin_share")]
    for name in OBSERVABLES:
        off = [100 * (one[name] / other[name] - 1) for one, other in whole]
        cells += [f"{mean(off):.3f}", f"{stdev(off) / len(off) ** 0.5:.3f}" if len(off) > 1 else ""]
    return cells


def scene(state, settings, tiny):
    common = {"disks.model": state.model, "disks.count": 64 if tiny else state.count,
              "disks.mass": "equal", "disks.packing_fraction": state.packing_fraction,
              "disks.elasticity": state.elasticity, "output.plot": "false"}
    if state.model == "CD_nt":
        common |= {"disks.damping_normal": 1.0, "disks.damping_tangential": 0.5}
    return {**common, **settings}


def start(program, folder, state, seed, tiny):
    """A state under way at the rate: by the higher ones."""
    rates = [rate for rate in (1e-3, 1e-4, 1e-5, 1e-6) if rate >= 0.99 * state.rate]
    out = os.path.abspath(os.path.join(folder, f"implicit-{state.title.replace(' ', '-')}-{seed}"))
    names = sorted(os.listdir(out)) if os.path.isdir(out) else []
    last = [name for name in names if name.startswith(f"{len(rates):04d}_")]
    if not last or not os.path.exists(os.path.join(out, last[0], "summary.json")):
        strains = [0.1] if tiny else [1.0, 0.6, 0.3, 0.1][:len(rates)]
        settings = {"disks.seed": seed, "shear.discard": 0, "output.sample_strain": 0.05}
        if len(rates) == 1:
            settings |= {"shear.strain_rate": rates[0], "shear.strain": strains[0]}
        else:
            settings |= {"shear.protocol": "cascade", "shear.strain_rates": rates,
                         "shear.strain": strains}
        run(program, scene(state, settings, tiny), out)
    for name in [""] + sorted(os.listdir(out), reverse=True):
        file = os.path.join(out, name, "state.h5")
        if os.path.exists(file):
            return file
    raise SystemExit(f"{out} has no state.h5")


def stretch(program, state, file, method, tiny):
    """Means over a stretch; None where the scheme does not get through it."""
    import h5py

    scheme, step = method
    steps = round(STRETCH / state.rate / step)
    settings = {"start.kind": "state", "start.file": file, "shear.strain_rate": state.rate,
                "shear.strain": steps * step * state.rate, "shear.discard": 0,
                "output.sample_strain": STRETCH / 4, "integration.scheme": scheme,
                "integration.time_step": step, "measure.every": max(1, round(2 / step))}
    with tempfile.TemporaryDirectory() as folder:
        if not run(program, scene(state, settings, tiny), folder, must=False):
            return None
        with h5py.File(os.path.join(folder, "result.h5")) as found:
            means = {name: float(found["series"][name][...].mean())
                     for name in (*OBSERVABLES, "energy_gap", "p_kin")}
    return {**means, "p_kin_share": means["p_kin"] / means["p"]}


def write_scene(file, settings):
    tables = {}
    for key, value in settings.items():
        table, name = key.split(".")
        text = value if value in ("true", "false") else f'"{value}"' if isinstance(value, str) else value
        tables.setdefault(table, []).append(f"{name} = {text}")
    for table, lines in tables.items():
        file.write("\n".join([f"[{table}]", *lines, ""]))
    file.flush()


def run(program, settings, out, must=True):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        write_scene(file, settings)
        done = subprocess.run([program, "run", file.name, "--out", out, "--force", "--quiet",
                               "--threads", "1", "--allow-unstable"], capture_output=True, text=True)
    if must and done.returncode != 0:
        raise SystemExit(f"{settings}\n{done.stderr.strip()}")
    return done.returncode == 0
