# SPDX-License-Identifier: BSD-3-Clause
"""Quasi-static steps against implicit damping and two stages, from common starts: runs of the program
itself, one after the other, with their seconds of CPU."""
import os
import resource
import tempfile
from dataclasses import replace
from statistics import mean, stdev

import implicit

OBSERVABLES = implicit.OBSERVABLES
COLUMNS = ("state", "method", "step_strain", "starts", "seconds_per_strain", "newton_iterations", "halved_steps",
           "energy_gap", "p_kin_share", *(f"{name}{end}" for name in OBSERVABLES for end in ("", "_err")))
REFERENCE = "implicit-damping"  # by its rule
RATES = (1e-5, 1e-6, 1e-7)
STRAINS = (1e-3, 3e-4, 2e-4, 1e-4)  # of a step; the first is the rule
SLOWEST_TWO_STAGE = 1e-5  # below, ten times the seconds a decade
STATES = [implicit.State(model, 0.82, 1.0, rate, ()) for rate in RATES for model in ("CD", "CD_rot")]


def measure(program, folder, tiny, say):
    """Rows of COLUMNS, state by state."""
    for state in STATES[:1] if tiny else STATES:
        say(f"quasi-static: {state.title}")
        files = [start(program, folder, state, seed, tiny) for seed in range(1, 3 if tiny else 5)]
        methods = [(REFERENCE, None), *(("quasi-static", strain) for strain in STRAINS)]
        if state.rate >= SLOWEST_TWO_STAGE:
            methods.append(("two-stage-leapfrog", None))
        found = {method: [stretch(program, state, file, method, tiny) for file in files] for method in methods}
        yield [row(state, method, found[method], found[REFERENCE, None]) for method in methods]


def row(state, method, found, reference):
    cells = [state.title, *method, len(found)]
    for name in ("seconds_per_strain", "newton_iterations", "halved_steps", "energy_gap", "p_kin_share"):
        cells.append(f"{mean(one[name] for one in found):.3g}")
    for name in OBSERVABLES:
        off = [100 * (one[name] / other[name] - 1) for one, other in zip(found, reference)]
        cells += [f"{mean(off):.3f}", f"{stdev(off) / len(off) ** 0.5:.3f}"]
    return cells


def start(program, folder, state, seed, tiny):
    """A state under way at the rate: at 1e-5 as for implicit damping, then by quasi-static steps."""
    first = implicit.start(program, folder, replace(state, rate=max(RATES)), seed, tiny)
    out = os.path.join(folder, f"creeping-{state.title.replace(' ', '-')}-{seed}")
    file = os.path.join(out, "state.h5")
    if not os.path.exists(file):
        implicit.run(program, settings_of(state, first, ("quasi-static", 1e-3), 0.02 if tiny else 0.3, tiny), out)
    return file


def settings_of(state, file, method, strain, tiny):
    name, step_strain = method
    settings = {"start.kind": "state", "start.file": file, "shear.strain_rate": state.rate, "shear.strain": strain,
                "shear.discard": 0, "output.sample_strain": strain / 4}
    if name == "quasi-static":
        settings |= {"integration.engine": name, "integration.time_step": step_strain / state.rate}
    else:
        settings |= {"integration.scheme": name, "integration.engine": "many-contacts"}
    return implicit.scene(state, settings, tiny)


def seconds_of(program, settings, out):
    """Of CPU that a run takes."""
    def spent():
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return children.ru_utime + children.ru_stime

    before = spent()
    implicit.run(program, settings, out)
    return spent() - before


def stretch(program, state, file, method, tiny):
    """Means over a stretch, and what it took."""
    import h5py

    strain = implicit.STRETCH
    with tempfile.TemporaryDirectory() as folder:
        started = seconds_of(program, settings_of(state, file, ("quasi-static", 1e-3), 1e-3, tiny), folder)  # a step
        seconds = seconds_of(program, settings_of(state, file, method, strain, tiny), folder) - started
        with h5py.File(os.path.join(folder, "result.h5")) as found:
            means = {name: float(found["series"][name][...].mean()) for name in (*OBSERVABLES, "energy_gap", "p_kin")}
            counted = {name: float(found.attrs.get(f"engine_{name}", 0)) for name in ("newton_iterations",
                                                                                         "halved_steps")}
    steps = strain / (method[1] or strain)
    return {**means, "p_kin_share": means["p_kin"] / means["p"], "seconds_per_strain": seconds / strain,
            "newton_iterations": counted["newton_iterations"] / steps, "halved_steps": counted["halved_steps"]}
