# SPDX-License-Identifier: BSD-3-Clause
"""The program as a black box: write a scene, run it, read what came out.

The tests in this folder are written from the contract, not from the code.
BAGNOLD is the program, BAGNOLD_SOURCE the root of the repository.
"""

import copy
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

import h5py
import numpy as np

SOURCE = pathlib.Path(
    os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2])
)
PROGRAM = os.environ.get("BAGNOLD", str(SOURCE / "build/openmp/bagnold"))

STRESSES = "p p_el p_dis p_kin sigma sigma_el sigma_dis sigma_kin"
NAMES = (
    f"{STRESSES} delta_p delta_p_el delta_p_dis delta_p_kin sigma_dev "
    + " ".join("B_" + name for name in STRESSES.split())
    + " eta_p eta_p_el eta_sigma eta_sigma_el mu I T_g Z R_v energy_gap p_dis_share"
).split()
SPIN_NAMES = ["spin_mean", "spin_var", "torque_power"]
PAPERS, TWO_STAGE = "modified-velocity-verlet", "two-stage-leapfrog"
LAWS = ("CD", "CD_n", "CD_rot", "CD_nt")

# Rate, step, window and strain are powers of two, so that no quotient of them has to be rounded.
STEP_STRAIN = 2.0**-11
SCENE = {
    "disks": {
        "model": "CD_rot",
        "count": 64,
        "packing_fraction": 0.80,
        "elasticity": 1.0,
        "mass": "equal",
    },
    "shear": {"strain_rate": 2.0**-7, "strain": 2.0**-3, "discard": 0.5},
    "integration": {"time_step": 2.0**-4},
    "measure": {"every": 2},
    "output": {"sample_strain": 2.0**-6, "plot": False},
}


class Raw(str):
    """A value written into the scene as it is, not as a TOML string."""


def toml_value(value):
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, (bool, str, list)):
        return json.dumps(value)
    return repr(value)


def scene_text(scene):
    """TOML of {"title": ..., "table": {"key": value}}."""
    lines = [f"{key} = {toml_value(v)}" for key, v in scene.items() if not isinstance(v, dict)]
    for table, keys in scene.items():
        if isinstance(keys, dict):
            lines += [f"[{table}]"] + [f"{key} = {toml_value(v)}" for key, v in keys.items()]
    return "\n".join(lines) + "\n"


def changed(scene=None, /, **changes):
    """The scene (default SCENE) with `table__key=value` changed; None takes the key away."""
    result = copy.deepcopy(SCENE if scene is None else scene)
    for name, value in changes.items():
        table, key = name.split("__")
        keys = result.setdefault(table, {})
        if value is None:
            keys.pop(key, None)
        else:
            keys[key] = value
    return result


def environment(**more):
    env = {k: v for k, v in os.environ.items() if not k.startswith(("OMP_", "KOKKOS_"))}
    return {"OMP_WAIT_POLICY": "passive", **env, **more}  # no spinning beside other tests


class CliTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bagnold-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.written = 0

    def scene(self, scene=None, /, name=None, **changes):
        """Writes a scene file, returns its path."""
        self.written += 1
        path = self.folder / (name or f"scene{self.written}.toml")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(scene_text(changed(scene, **changes)))
        return path

    def bagnold(self, *arguments, timeout=300, env=None, cwd=None):
        """Runs to the end; a signal or a run beyond the timeout fails the test."""
        result = subprocess.run(
            [PROGRAM, *map(str, arguments)],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=timeout,
            env=environment() if env is None else env,
            cwd=cwd or self.folder,
            stdin=subprocess.DEVNULL,
        )
        self.assertGreaterEqual(result.returncode, 0, f"killed by a signal\n{result.stderr}")
        for word in ("terminate called", "what():", "Traceback", "Sanitizer", "HDF5-DIAG"):
            self.assertNotIn(word, result.stderr)
        return result

    def start(self, *arguments, env=None):
        """Starts the program and returns at once."""
        process = subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env=environment() if env is None else env,
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
        )
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def kill_and_resume(self, scene, out, most):
        """Runs a scene, killed after a checkpoint and resumed at most so often. Returns how often it was."""
        def stamp():
            try:
                return (out / "checkpoint.h5").stat().st_mtime_ns
            except FileNotFoundError:
                return None
        process = self.start("run", scene, "--out", out)
        kills = 0
        while kills < most:
            before = stamp()
            if not self.wait_until(lambda before=before: stamp() not in (None, before), process):
                break
            process.kill()
            process.wait()
            kills += 1
            process = self.start("resume", out)
        self.assertEqual(self.finish(process)[0], 0)
        return kills

    def finish(self, process, timeout=300):
        """Waits; returns (exit code, all output)."""
        output, _ = process.communicate(timeout=timeout)
        return process.returncode, output

    def wait_until(self, condition, process=None, seconds=60):
        """Polls; False if the process ended first."""
        end = time.monotonic() + seconds
        while not condition():
            if process is not None and process.poll() is not None:
                return bool(condition())
            if time.monotonic() > end:
                self.fail("waited in vain")
            time.sleep(0.002)
        return True

    def run_scene(self, scene, out, *arguments, **options):
        """A run that must succeed; returns the completed process."""
        result = self.bagnold("run", scene, "--out", out, *arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def run_new(self, name, *arguments, **changes):
        """Writes SCENE with changes, runs it into folder/name, returns that folder."""
        out = self.folder / name
        self.run_scene(self.scene(**changes), out, "--quiet", *arguments)
        return out

    def assert_clean_error(self, result, code, *words):
        """One short message on stderr that holds all words."""
        self.assertEqual(result.returncode, code, f"{result.stdout}\n{result.stderr}")
        lines = [line for line in result.stderr.splitlines() if line.strip()]
        self.assertTrue(1 <= len(lines) <= 4, f"not one message:\n{result.stderr}")
        self.assertLess(len(result.stderr), 1200)
        self.assertTrue(all(c.isprintable() for line in lines for c in line), result.stderr)
        for word in words:
            self.assertIn(word.lower(), result.stderr.lower())

    def refused(self, scene, *words, arguments=()):
        """`validate` and `run` both say no with exit code 2, and nothing is written."""
        out = self.folder / "refused"
        self.assert_clean_error(self.bagnold("validate", scene, *arguments), 2, *words)
        self.assert_clean_error(self.bagnold("run", scene, *arguments, "--out", out), 2, *words)
        self.assertFalse(out.exists(), "a refused scene left an output directory")

    def assert_same_state(self, first, second):
        """The state.h5 of two folders, bit for bit."""
        one, two = read_state(first), read_state(second)
        self.assertEqual(one.keys(), two.keys())
        for name in one:
            self.assertTrue(same_bits(one[name], two[name]), f"{name} differs: {first} {second}")

    def assert_same_results(self, first, second):
        """State, series and averages of two folders, bit for bit."""
        self.assert_same_state(first, second)
        one, two = read_series(first), read_series(second)
        self.assertEqual(one.keys(), two.keys())
        for name in one:
            self.assertTrue(same_bits(one[name], two[name]), f"/series/{name} differs")
        one, two = read_summary(first), read_summary(second)
        for name in ("observables", "strain", "steps", "scene", "warnings"):
            self.assertEqual(one[name], two[name])


def same_bits(one, two):
    one, two = np.asarray(one), np.asarray(two)
    return one.dtype == two.dtype and one.shape == two.shape and one.tobytes() == two.tobytes()


def refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


def read_summary(out):
    text = (pathlib.Path(out) / "summary.json").read_text()
    return json.loads(text, parse_constant=refuse_constant)


def read_state(path):
    """Datasets and attributes of /state as a dictionary."""
    path = pathlib.Path(path)
    with h5py.File(path / "state.h5" if path.is_dir() else path, "r") as file:
        group = file["state"]
        return {**{k: d[()] for k, d in group.items()}, **{k: a for k, a in group.attrs.items()}}


def read_series(out):
    with h5py.File(pathlib.Path(out) / "result.h5", "r") as file:
        return {name: data[()] for name, data in file["series"].items()}


def discarded_windows(out):
    with h5py.File(pathlib.Path(out) / "result.h5", "r") as file:
        return int(file["series"].attrs["discarded_windows"])


def write_state(path, state):
    """The inverse of read_state."""
    with h5py.File(path, "w") as file:
        group = file.create_group("state")
        for name, value in state.items():
            if np.ndim(value):
                group[name] = value
            else:
                group.attrs[name] = value


def box_length(count, packing_fraction):
    """phi L^2 = (N/2) (pi/4) (1 + 1.4^2)   P1 Eq. 8, P2 Eq. 11"""
    return np.sqrt(count / 2 * np.pi / 4 * (1 + 1.4**2) / packing_fraction)


def lattice_state(count=64, packing_fraction=0.1, small_first=True):
    """Disks at rest on a square lattice, far from touching: nothing happens to them."""
    side = int(np.ceil(np.sqrt(count)))
    length = box_length(count, packing_fraction)
    index = np.arange(count)
    position = np.stack([index % side + 0.5, index // side + 0.5], axis=1) * (length / side)
    diameter = np.where(index < count // 2, 1.0, 1.4)
    return {
        "position": position,
        "velocity": np.zeros((count, 2)),
        "diameter": diameter if small_first else diameter[::-1].copy(),
        "box_length": length,
        "offset": 0.0,
        "time": 0.0,
    }


def without_mean_motion(state, rate, by_area=False):
    """The state as a run at this rate begins with it: sum m (v - gammadot y x^) = 0, of each replica."""
    mass = (state["diameter"] ** 2 if by_area else np.ones_like(state["diameter"]))[..., None]
    own = state["velocity"] - rate * state["position"][..., 1:] * [1.0, 0.0]
    mean = (mass * own).sum(-2, keepdims=True) / mass.sum(-2, keepdims=True)
    return {**state, "velocity": state["velocity"] - mean}


def files_of(folder):
    """Every file of a folder with its bytes and times: equal when nothing was touched."""
    return {
        str(path.relative_to(folder)): (path.read_bytes(), path.stat().st_mtime_ns)
        for path in sorted(pathlib.Path(folder).rglob("*"))
        if path.is_file()
    }


def seconds_to_strain(test, seconds, **changes):
    """Strain (a power of two) whose run lasts about this long here, from a short trial run."""
    out = test.run_new("calibration", **changes)
    summary = read_summary(out)
    shutil.rmtree(out)
    step_strain = summary["strain"]["total"] / summary["steps"]
    steps = seconds * summary["disk_steps_per_second"] / summary["scene"]["disks"]["count"]
    return 2.0 ** np.round(np.log2(max(steps * step_strain, 2.0**-3)))

