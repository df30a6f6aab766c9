# SPDX-License-Identifier: BSD-3-Clause
"""The steady states that rows start from: which runs of Bagnold make them.

FOLDER/NAME holds the state.h5 and scene.toml of a run; any folder of `bagnold run` with the physics
that NAME says will do, a link too.
"""
import math
import os
import re
import subprocess
from dataclasses import dataclass

import h5py
import numpy as np

NEWTONIAN = {"model": "CD_rot", "packing_fraction": 0.82, "elasticity": 1.0, "mass": "equal"}
BAGNOLDIAN = {"model": "CD_n", "packing_fraction": 0.78, "elasticity": 50.0, "mass": "area"}
QUICK_COUNT = {1024: 64, 16384: 128, 65536: 256}
QUICK_STEPS = 1000
SCHEME = "modified-velocity-verlet"  # what rows are timed with
TIME_STEP = 0.05  # [tau_e]


@dataclass(frozen=True)
class State:
    """A run for `strain` at `rate` from the state `start`, or from a random one."""

    name: str
    disks: dict
    rate: float
    strain: float
    start: str = ""
    tiles: int = 0  # instead of a run: this many copies of `start` along each side


def chain(stem, disks, end, *steps):
    """States STEM-RATE-END, each from the one before."""
    names = [f"{stem}-{rate}-{end}" for rate, strain in steps]
    return [State(name, disks, float(rate), strain, start)
            for name, (rate, strain), start in zip(names, steps, ["", *names])]


def newtonian(count, *steps, end="", **more):
    return chain("cd_rot82", {**NEWTONIAN, "count": count, **more}, end or str(count), *steps)


def bagnoldian(count, *steps):
    return chain("cd_n-q50", {**BAGNOLDIAN, "count": count}, str(count), *steps)


STATES = {state.name: state for state in [
    *newtonian(1024, ("1e-3", 5), ("1e-4", 5)),
    *newtonian(1024, ("1e-3", 5), ("1e-4", 2), end="1024x2", replicas=2),
    *newtonian(16384, ("1e-3", 1), ("1e-4", 0.2)),
    State("cd_rot82-1e-4-1048576", {**NEWTONIAN, "count": 16384}, 1e-4, 0, "cd_rot82-1e-4-16384", 8),
    *newtonian(65536, ("1e-3", 1), ("1e-4", 0.1)),
    *bagnoldian(1024, ("1e-3", 10), ("1e-4", 10), ("1e-5", 5), ("1e-6", 3)),
    *bagnoldian(65536, ("1e-3", 2), ("1e-4", 1), ("1e-5", 1), ("1e-6", 0.5)),
    *chain("cd_n-q1", {**BAGNOLDIAN, "elasticity": 1.0, "count": 1024}, "1024",
           ("1e-3", 10), ("1e-4", 10), ("1e-5", 3)),
    *chain("cd_rot76", {**NEWTONIAN, "packing_fraction": 0.76, "count": 1024}, "1024",
           ("1e-3", 10), ("1e-4", 5), ("1e-5", 2)),
]}


def is_there(folder, name):
    return all(os.path.exists(os.path.join(folder, name, file)) for file in ("state.h5", "scene.toml"))


def make(program, folder, names, quick, say):
    """Makes those of the states that the folder lacks, and what they start from."""
    for name in names:
        if is_there(folder, name):
            continue
        state = STATES[name]
        if state.start:
            make(program, folder, [state.start], quick, say)
        if state.tiles:
            say(f"{name}: copies of {state.start}")
            tile(os.path.join(folder, state.start), os.path.join(folder, name),
                 2 if quick else state.tiles)
        else:
            run(program, folder, state, quick, say)


def run(program, folder, state, quick, say):
    disks, strain = dict(state.disks), state.strain
    if quick:
        disks["count"] = QUICK_COUNT[disks["count"]]
        strain = min(strain, QUICK_STEPS * TIME_STEP * state.rate)
    start = {"kind": "random"}
    if state.start:
        start = {"kind": "state", "file": os.path.abspath(os.path.join(folder, state.start, "state.h5"))}
    say(f"{state.name}: strain {strain:g} at {state.rate:g} from {state.start or 'random positions'}")
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, state.name + ".toml")
    scene = {"disks": disks, "start": start, "shear": {"strain_rate": state.rate, "strain": strain},
             "integration": {"scheme": SCHEME, "time_step": TIME_STEP},
             "output": {"plot": False, "sample_strain": min(0.01, strain)}}
    with open(path, "w") as out:
        out.write("".join(f"[{table}]\n" + "".join(f"{key} = {toml(value)}\n" for key, value in keys.items())
                          for table, keys in scene.items()))
    # One thread a system: two that share cores with others mostly wait for each other.
    subprocess.run([program, "run", path, "--out", os.path.join(folder, state.name), "--force", "--quiet",
                    "--threads", str(disks.get("replicas", 1))], check=True, stdout=subprocess.DEVNULL)
    os.remove(path)


def toml(value):
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return str(value).lower() if isinstance(value, bool) else repr(value)


def tile(source, target, tiles):
    """The same state in a box `tiles` times as wide and high: the copy in row k is the image there,
    k offsets further in x and k gammadot L faster. It is as steady as the one it was made of."""
    os.makedirs(target, exist_ok=True)
    with h5py.File(os.path.join(source, "state.h5")) as file:
        group = file["state"]
        at = dict(group.attrs)
        data = {name: np.asarray(group[name]) for name in group}
    with open(os.path.join(source, "scene.toml")) as file:
        scene = file.read()
    length, offset, rate = at["box_length"], at["offset"], at["strain_rate"]
    column, row = (index.ravel()[:, None] for index in np.meshgrid(np.arange(tiles), np.arange(tiles)))
    big = {name: np.tile(values, (tiles**2,) + (1,) * (values.ndim - 1)) for name, values in data.items()}
    count = len(data["diameter"])
    x, y = (np.repeat(shift, count) for shift in (column * length + row * offset, row * length))
    big["position"] += np.stack([x % (tiles * length), y], 1)
    big["velocity"][:, 0] += rate * y
    at["box_length"], at["offset"] = tiles * length, tiles * offset % (tiles * length)
    # The box of the scene comes from its count: N tiles^2 disks at the same packing fraction.
    scene, found = re.subn(r"(?m)^count = \d+$", f"count = {count * tiles**2}", scene)
    if found != 1 or not math.isclose(rate, float(re.search(r"(?m)^strain_rate = (\S+)", scene)[1])):
        raise SystemExit(f"error: {source}/scene.toml is not the scene of the state beside it")
    with open(os.path.join(target, "scene.toml"), "w") as out:
        out.write(scene)
    with h5py.File(os.path.join(target, "state.h5"), "w") as file:
        group = file.create_group("state")
        for name, values in big.items():
            group[name] = values
        group.attrs.update(at)
