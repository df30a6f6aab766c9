# SPDX-License-Identifier: BSD-3-Clause
"""Makes sweep.h5 files of known content: laws of the papers with normal noise of known size."""

import itertools

import h5py
import numpy as np


def write_sweep(path, points, observables, errors):
    """points: {key: [P] numbers or texts}; observables and errors: {name: [P]}."""
    with h5py.File(path, "w") as file:
        for key, values in points.items():
            values = np.asarray(values)
            if values.dtype.kind == "U":
                values = np.char.encode(values, "utf-8")
            file[f"points/{key}"] = values
        count = len(next(iter(points.values())))
        file["points/folder"] = np.array([f"{i:04d}".encode() for i in range(count)])
        for name, values in observables.items():
            file[f"observables/{name}"] = np.asarray(values, float)
            file[f"observables/{name}_error"] = np.asarray(errors[name], float)
        file["status"] = np.array([b"done"] * count)


def grid(**axes):
    """{key: [P]} of all combinations, the last key fastest; `__` in a name is a dot."""
    rows = list(itertools.product(*axes.values()))
    return {name.replace("__", "."): np.array([row[k] for row in rows])
            for k, name in enumerate(axes)}


def noisy(value, relative, random):
    """The values with normal noise of that relative size, and their errors."""
    error = np.abs(value) * relative
    return value + error * random.standard_normal(len(value)), error


def q_star(phi, q0=1.89, c=0.05, phi_j=0.84335, x=1.65):
    return q0 + c * (phi_j - phi) ** -x


def crossover(q, middle, c=40.0, s=3.0, power=1.3):
    return c * (1 + (q / middle) ** s) ** (power / s)
