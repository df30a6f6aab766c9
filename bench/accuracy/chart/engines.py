# SPDX-License-Identifier: BSD-3-Clause
"""CPU time of a unit of strain, by engine and scheme: runs of the program itself."""
import os
import subprocess
import tempfile
from dataclasses import dataclass
from statistics import median

ENGINES = ("steps", "few-contacts", "many-contacts", "lookahead", "reference")
METHODS = {"two-stage-leapfrog": "auto", "modified-velocity-verlet": "paper"}  # scheme, its step
COLUMNS = ("state", "engine", "scheme", "time_step", "seconds", "least", "most", "rounds")


@dataclass(frozen=True)
class Row:
    """`strain` from the steady state takes the slowest engine but the reference a few seconds."""

    state: str
    title: str
    strain: float
    rate: float


ROWS = [
    Row("cd_rot82-1e-4-1024", "CD_rot 0.82, Q = 1, 1e-4", 0.5, 1e-4),
    Row("cd82-1e-4-1024", "CD 0.82, Q = 1, 1e-4", 0.5, 1e-4),
    Row("cd_rot76-1e-4-1024", "CD_rot 0.76, Q = 1, 1e-4", 0.5, 1e-4),
    Row("cd_rot76-1e-5-1024", "CD_rot 0.76, Q = 1, 1e-5", 0.1, 1e-5),
    Row("cd_n-q1-1e-4-1024", "CD_n 0.78, Q = 1, 1e-4", 1, 1e-4),
    Row("cd_n-q1-1e-5-1024", "CD_n 0.78, Q = 1, 1e-5", 0.3, 1e-5),
    Row("cd_n-q50-1e-4-1024", "CD_n 0.78, Q = 50, 1e-4", 1, 1e-4),
    Row("cd_n-q50-1e-5-1024", "CD_n 0.78, Q = 50, 1e-5", 1, 1e-5),
    Row("cd_n-q50-1e-6-1024", "CD_n 0.78, Q = 50, 1e-6", 1, 1e-6),
]


def measure(program, states, rounds, strain_factor, say):
    """Rows of COLUMNS, state by state; what is compared is run in turn within a round."""
    for row in ROWS:
        say(f"engines: {row.title}")
        cells = [(engine, scheme) for engine in ENGINES for scheme in METHODS if affordable(engine, row)]
        seconds = {cell: [] for cell in cells}
        for _ in range(rounds):
            for cell in cells:
                seconds[cell].append(a_strain(program, os.path.join(states, row.state), cell,
                                              row.strain * strain_factor))
        yield [summary(row, cell, times) for cell, times in seconds.items()]


def summary(row, cell, times):
    values = [value for value, _ in times]
    return (row.state, *cell, times[0][1], f"{median(values):.4g}", f"{min(values):.4g}",
            f"{max(values):.4g}", len(values))


def affordable(engine, row):
    """Whether it would be done in a minute."""
    return engine in ("steps", "lookahead") or (engine == "few-contacts" and row.rate >= 1e-5) or row.rate >= 1e-4


def a_strain(program, state, cell, strain):
    """CPU time of a unit of strain, starts left out, [s]; and the time step."""
    short, step = run(program, state, cell, strain / 5)
    long, _ = run(program, state, cell, strain)
    return (long - short) / (strain * 4 / 5), step


def run(program, state, cell, strain):
    engine, scheme = cell
    settings = {"start.kind": "state", "start.file": os.path.abspath(os.path.join(state, "state.h5")),
                "shear.strain": strain, "shear.discard": 0,
                "output.sample_strain": min(0.01, strain), "integration.engine": engine,
                "integration.scheme": scheme, "integration.time_step": METHODS[scheme],
                "output.plot": "false"}
    with tempfile.TemporaryDirectory() as folder:
        arguments = [program, "run", os.path.join(state, "scene.toml"), "--out", folder, "--force",
                     "--quiet", "--threads", "1"]
        for key, value in settings.items():
            arguments += ["--set", f"{key}={value}"]
        with subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            said = process.stderr.read().decode()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if status != 0:
            raise SystemExit(f"{' '.join(arguments)}\n{said.strip()}")
        with open(os.path.join(folder, "scene.toml")) as file:
            step = next(line.split("=")[1].strip() for line in file if line.startswith("time_step"))
    return used.ru_utime + used.ru_stime, step
