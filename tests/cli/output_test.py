# SPDX-License-Identifier: BSD-3-Clause
"""What a run leaves behind, and that its numbers agree with each other."""

import math
import re
import subprocess
import tomllib
import unittest

import h5py
import numpy as np

from bagnold import (
    LAWS, NAMES, PAPERS, SCENE, SOURCE, SPIN_NAMES, TWO_STAGE, CliTest, box_length,
    discarded_windows, files_of, lattice_state, read_series, read_state, read_summary, scene_text, write_state,
)


def names_of(model):
    return NAMES + (SPIN_NAMES if model in ("CD_rot", "CD_nt") else [])


class Files(CliTest):
    def test_every_file_is_there(self):
        out = self.run_new("out")
        self.assertLessEqual({"summary.json", "result.h5", "scene.toml", "checkpoint.h5",
                              "state.h5"}, {path.name for path in out.iterdir()})
        self.assertFalse([p for p in out.iterdir() if re.search(r"tmp|temp|part", p.name)])

    def test_picture(self):
        try:
            subprocess.run(["/usr/bin/python3", "-c", "import matplotlib, h5py"], check=True,
                           capture_output=True)
        except (OSError, subprocess.CalledProcessError):
            self.skipTest("no matplotlib")
        out = self.folder / "out"
        self.run_scene(self.scene(output__plot=True), out)
        picture = (out / "plot.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(len(picture), 20000)

    def test_summary_schema(self):
        for model in LAWS:
            with self.subTest(model=model):
                out = self.run_new(model, disks__model=model)
                summary = read_summary(out)
                self.assertEqual(summary["schema"], 1)
                self.assertEqual(set(summary["bagnold"]), {"version", "git"})
                self.assertTrue(summary["bagnold"]["version"])
                self.assertEqual(set(summary["strain"]), {"total", "measured"})
                self.assertEqual(summary["strain"]["total"], SCENE["shear"]["strain"])
                self.assertEqual(summary["strain"]["measured"], SCENE["shear"]["strain"] / 2)
                self.assertEqual(summary["steps"], 256)
                self.assertIsInstance(summary["steps"], int)
                self.assertGreater(summary["wall_seconds"], 0)
                self.assertGreater(summary["disk_steps_per_second"], 0)
                self.assertEqual(set(summary["observables"]), set(names_of(model)))
                for name, value in summary["observables"].items():
                    self.assert_observable(name, value)

    def assert_observable(self, name, value):
        self.assertEqual(set(value), {"mean", "error", "correlation_strain", "samples"}, name)
        self.assertIsInstance(value["samples"], int, name)
        for key in ("mean", "error", "correlation_strain"):
            self.assertIsInstance(value[key], (float, int, type(None)), f"{name} {key}")
        for key in ("error", "correlation_strain"):
            self.assertGreaterEqual(value[key] or 0, 0, f"{name} {key}")

    def test_summary_holds_the_resolved_scene(self):
        summary = read_summary(self.run_new("out"))
        for table in ("disks", "shear", "integration", "measure", "output"):
            for key, value in SCENE[table].items():
                self.assertEqual(summary["scene"][table][key], value, f"{table}.{key}")
        self.assertEqual(summary["scene"]["disks"]["seed"], 1)
        self.assertEqual(summary["scene"]["shear"]["protocol"], "steady")

    def test_series(self):
        for model in LAWS:
            with self.subTest(model=model):
                out = self.run_new(model, disks__model=model)
                series = read_series(out)
                self.assertLessEqual(set(names_of(model)) | {"strain", "time", "strain_rate"},
                                     set(series))
                self.assertEqual("spin_mean" in series, "spin_mean" in names_of(model))
                self.assertEqual({data.shape for data in series.values()}, {(8,)})
                self.assertEqual(discarded_windows(out), 4)
                self.assertTrue((series["strain_rate"] == SCENE["shear"]["strain_rate"]).all())
                self.assertTrue(np.allclose(np.diff(series["strain"]), 2.0**-6, rtol=1e-12))
                self.assertTrue(np.allclose(np.diff(series["time"]), 2.0, rtol=1e-12))
                with h5py.File(out / "result.h5") as file:
                    for name, data in file["series"].items():
                        self.assertIn("unit", data.attrs, name)

    def test_provenance(self):
        with h5py.File(self.run_new("out") / "result.h5") as file:
            text = [f"{key} {value}" for key, value in file.attrs.items()]
            file.visititems(lambda name, item: text.extend(
                f"{name} {key} {value}" for key, value in item.attrs.items()))
            file.visititems(lambda name, item: text.append(f"{name} {item[()]}")
                            if isinstance(item, h5py.Dataset) and not item.shape else None)
        text = "\n".join(text).lower()
        for word in ("version", "git", "seed", "backend", "compiler", "kokkos"):
            self.assertIn(word, text)

    def test_discard_rounds_up_to_whole_windows(self):
        out = self.run_new("odd", shear__strain=5 * 2.0**-6)  # half of five windows
        self.assertEqual(len(read_series(out)["p"]), 5)
        self.assertEqual(discarded_windows(out), 3)
        self.assertEqual(read_summary(out)["strain"]["measured"], 2 * 2.0**-6)
        out = self.run_new("all", shear__discard=0)
        self.assertEqual(discarded_windows(out), 0)
        self.assertEqual(read_summary(out)["strain"]["measured"], SCENE["shear"]["strain"])

    def test_window_rounds_up_to_whole_steps(self):
        out = self.run_new("out", output__sample_strain=2.5 * 2.0**-11, shear__strain=2.0**-7,
                           measure__every=1)
        steps = np.diff(read_series(out)["strain"]) / 2.0**-11
        self.assertTrue(np.allclose(steps[:-1], 3), steps)  # the last one is what is left

    def test_decimal_quotients_are_not_rounded_by_noise(self):
        """0.3 / 0.01 windows of 0.01 / (1e-2 * 0.05) steps are 30 of 20, not 31 of 21."""
        out = self.run_new("out", shear__strain=0.3, shear__strain_rate=1e-2,
                           integration__time_step=0.05, output__sample_strain=0.01)
        self.assertEqual(read_summary(out)["steps"], 600)
        self.assertEqual(len(read_series(out)["p"]), 30)
        self.assertEqual(discarded_windows(out), 15)

    def test_undefined_is_null(self):
        """Disks that never touch: no pressure, so neither mu nor I nor R_v."""
        state = lattice_state()
        state["velocity"][:, 0] = SCENE["shear"]["strain_rate"] * state["position"][:, 1]
        write_state(self.folder / "start.h5", state)
        out = self.run_new("out", disks__model="CD", disks__packing_fraction=0.1,
                           start__kind="state", start__file="start.h5", shear__strain=2.0**-5)
        observables = read_summary(out)["observables"]
        for name in ("p_el", "p_dis", "Z"):
            self.assertEqual(observables[name]["mean"], 0.0, name)
        if observables["p"]["mean"] == 0.0:
            self.assertIsNone(observables["mu"]["mean"])
            self.assertIsNone(observables["I"]["mean"])
        self.assertIsNone(observables["R_v"]["mean"])
        self.assertTrue(np.isnan(read_series(out)["R_v"]).all())

    def test_short_statistics_print_no_error(self):
        result = self.bagnold("run", self.scene(shear__strain=2.0**-5), "--out",
                              self.folder / "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        observables = read_summary(self.folder / "out")["observables"]
        self.assertIsNone(observables["p"]["error"])
        self.assertRegex((result.stdout + result.stderr).lower(), "too short|too few|short")

    def test_long_statistics_have_errors(self):
        out = self.run_new("out", shear__strain=64.0, disks__packing_fraction=0.6)
        for name in ("p", "sigma", "mu", "I", "sigma_dev", "Z"):
            value = read_summary(out)["observables"][name]
            self.assertIsNotNone(value["error"], name)
            self.assertGreater(value["error"], 0.0, name)
            self.assertLess(value["error"], value["mean"], name)

    def test_quiet(self):
        loud = self.bagnold("run", self.scene(), "--out", self.folder / "loud")
        quiet = self.bagnold("run", self.scene(), "--out", self.folder / "quiet", "--quiet")
        self.assertEqual((loud.returncode, quiet.returncode), (0, 0))
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))
        self.assertIn("sigma", loud.stdout)
        self.assert_same_results(self.folder / "loud", self.folder / "quiet")
        wrong = self.bagnold("run", self.scene(disks__count=63), "--out", self.folder / "wrong",
                             "--quiet")
        self.assert_clean_error(wrong, 2, "disks.count")

    def test_progress_in_a_pipe_is_plain(self):
        loud = self.bagnold("run", self.scene(shear__strain=1.0), "--out", self.folder / "loud")
        self.assertNotRegex(loud.stdout + loud.stderr, r"\r|\x1b")


class Rerun(CliTest):
    def test_scene_of_a_run_reproduces_it(self):
        for model in LAWS:
            with self.subTest(model=model):
                first = self.run_new(f"{model}1", disks__model=model, disks__seed=7,
                                     integration__time_step="auto", shear__strain=0.05)
                taken = read_summary(first)["scene"]["integration"]
                self.assertEqual((taken["scheme"], taken["time_step"]), (TWO_STAGE, 0.2))
                with h5py.File(first / "result.h5") as file:
                    self.assertEqual((file.attrs["scheme"], file.attrs["time_step"]), (TWO_STAGE, 0.2))
                second = self.folder / f"{model}2"
                self.run_scene(first / "scene.toml", second)
                self.assert_same_results(first, second)
                self.assertEqual(tomllib.loads((first / "scene.toml").read_text()),
                                 tomllib.loads((second / "scene.toml").read_text()))

    def test_scene_with_a_difficult_title(self):
        title = 'quotes " and \\ and # [disks]\n count = 63, φ'
        path = self.folder / "title.toml"
        path.write_text(scene_text({"title": title, **SCENE}))
        out = self.folder / "out"
        self.run_scene(path, out)
        self.assertEqual(tomllib.loads((out / "scene.toml").read_text())["title"], title)
        self.assertEqual(read_summary(out)["scene"]["title"], title)
        self.assertEqual(self.bagnold("validate", out / "scene.toml").returncode, 0)

    def test_seeds_differ(self):
        one, two = (self.run_new(f"seed{seed}", disks__seed=seed) for seed in (1, 2))
        self.assertFalse((read_state(one)["position"] == read_state(two)["position"]).any())

    def test_an_existing_run_is_not_overwritten(self):
        out = self.run_new("out")
        before = files_of(out)
        result = self.bagnold("run", self.scene(disks__seed=2), "--out", out)
        self.assert_clean_error(result, 2, "--force")
        self.assertEqual(files_of(out), before)
        forced = self.bagnold("run", self.scene(disks__seed=2), "--out", out, "--force")
        self.assertEqual(forced.returncode, 0, forced.stderr)
        fresh = self.run_new("fresh", disks__seed=2)
        self.assert_same_results(out, fresh)

    def test_force_keeps_the_state_to_start_from(self):
        out = self.run_new("out")
        before = (out / "summary.json").read_bytes()
        path = self.scene(start__kind="state", start__file=str(out / "state.h5"))
        self.assert_clean_error(self.bagnold("run", path, "--out", out, "--force"), 2, "start.file", "elsewhere")
        self.assertEqual((out / "summary.json").read_bytes(), before)

    def test_a_finished_run_needs_its_start_no_more(self):
        first = self.run_new("first")
        path = self.scene(start__kind="state", start__file=str(first / "state.h5"))
        out = self.folder / "out"
        self.assertEqual(self.bagnold("run", path, "--out", out).returncode, 0)
        (first / "state.h5").unlink()
        self.assertEqual(self.bagnold("run", path, "--out", out).returncode, 0)

    def test_force_leaves_foreign_files(self):
        out = self.run_new("out")
        (out / "notes.txt").write_text("mine")
        result = self.bagnold("run", self.scene(), "--out", out, "--force")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((out / "notes.txt").read_text(), "mine")

    def test_an_empty_or_deep_directory_is_fine(self):
        (self.folder / "empty").mkdir()
        self.run_scene(self.scene(), self.folder / "empty")
        self.run_scene(self.scene(), self.folder / "a" / "b" / "c")


class Relations(CliTest):
    def assert_near(self, one, two, what, relative=1e-12, scale=None):
        bound = relative * max(abs(one), abs(two), scale or 0.0)
        self.assertLessEqual(abs(one - two), bound, f"{what}: {one} {two}")

    def test_values_agree_with_each_other(self):
        for model, mass in zip(LAWS, ("equal", "area", "equal", "area")):
            with self.subTest(model=model):
                out = self.run_new(model, disks__model=model, disks__mass=mass,
                                   disks__elasticity=0.7, shear__strain=0.5)
                mean = {k: v["mean"] for k, v in read_summary(out)["observables"].items()}
                self.assertFalse([name for name, value in mean.items() if value is None])
                self.check(mean, 0.7)

    def check(self, mean, elasticity):
        rate, count = SCENE["shear"]["strain_rate"], SCENE["disks"]["count"]
        for name in ("p", "sigma"):
            parts = [mean[f"{name}_{part}"] for part in ("el", "dis", "kin")]
            self.assert_near(mean[name], sum(parts), name, scale=max(map(abs, parts)))
            for part in ("", "_el", "_dis", "_kin"):
                self.assert_near(mean[f"B_{name}{part}"], mean[name + part] / rate**2, name + part)
            for part in ("", "_el"):
                self.assert_near(mean[f"eta_{name}{part}"],
                                 elasticity * mean[name + part] / rate, name + part)
        self.assert_near(mean["mu"], mean["sigma"] / mean["p"], "mu")
        self.assert_near(mean["I"], rate / math.sqrt(mean["p"]), "I")
        self.assert_near(mean["sigma_dev"], math.hypot(mean["delta_p"], mean["sigma"]), "dev")
        density = count / box_length(count, SCENE["disks"]["packing_fraction"]) ** 2
        self.assert_near(mean["p_kin"], density * mean["T_g"], "p_kin = n T_g")
        self.assertGreater(mean["sigma"], 0.0)
        self.assertGreater(mean["p_el"], 0.0)
        self.assertGreater(mean["Z"], 0.0)

    def test_mean_is_the_mean_of_the_measured_windows(self):
        out = self.run_new("out", shear__strain=0.5)
        series, first = read_series(out), discarded_windows(out)
        observables = read_summary(out)["observables"]
        mean = {name: float(np.mean(values[first:])) for name, values in series.items()}
        linear = set(observables) - {"sigma_dev", "mu", "I", "R_v", "energy_gap", "p_dis_share", "spin_var",
                                     "torque_power"}
        for name in linear:
            scale = float(np.max(np.abs(series[name][first:])))
            self.assert_near(observables[name]["mean"], mean[name], name, scale=scale)
        for name in ("p", "sigma"):
            total = sum(series[f"{name}_{part}"] for part in ("el", "dis", "kin"))
            self.assertTrue(np.allclose(series[name], total, rtol=1e-12, atol=1e-18))

    def test_disks_turn_with_half_the_rate(self):
        for model, bound in (("CD_rot", 0.1), ("CD_nt", 0.1)):
            with self.subTest(model=model):
                out = self.run_new(model, disks__model=model, shear__strain=4.0)
                value = read_summary(out)["observables"]["spin_mean"]
                self.assert_near(value["mean"], -0.5, "spin_mean", relative=2 * bound)
                self.assertGreater(read_summary(out)["observables"]["spin_var"]["mean"], 0.0)

    def test_last_window_follows_from_the_last_state(self):
        """A window of one step: its values, once more from a state.h5 with all pairs.

        A window holds the states before its steps or after them; either is right, a mixture not. With
        the papers' scheme: two stages sample what the damping does within the step as well.
        """
        for model in ("CD", "CD_n", "CD_rot"):
            for mass, aspect in (("equal", 1), ("area", 1), ("area", 4), ("equal", 0.25)):
                with self.subTest(model=model, mass=mass, aspect=aspect):
                    changes = {"disks__model": model, "disks__mass": mass, "measure__every": 1,
                               "disks__packing_fraction": 0.86, "integration__scheme": PAPERS,
                               "integration__skin": 0.2, "disks__box_aspect": float(aspect),
                               "output__sample_strain": 2.0**-11}
                    name = f"{model}-{mass}-{aspect}"
                    out = self.run_new(name, **changes)
                    before = self.run_new(f"{name}-before", shear__strain=255 * 2.0**-11, **changes)
                    self.assertEqual(len(read_series(out)["p"]), 256)
                    last = {name: values[-1] for name, values in read_series(out).items()}
                    states = [observe(read_state(o), model, mass, 2.0**-7) for o in (before, out)]
                    expected = min(states, key=lambda state: abs(state["p_el"] - last["p_el"]))
                    for name, value in expected.items():
                        self.assert_near(last[name], value, name, relative=1e-9,
                                         scale=abs(expected["p_el"]) if "_" in name else None)


def observe(state, model, mass, rate, damping=1.0):
    """The observables of one state, all pairs, written from the papers (Q = 1)."""
    r, v, d, length = (state[k] for k in ("position", "velocity", "diameter", "box_length"))
    height = state.get("box_aspect", 1) * length
    area = length * height
    m = np.ones(len(d)) if mass == "equal" else (np.pi / 2) * d**2
    rows = np.rint((r[:, None, 1] - r[None, :, 1]) / height)
    x = r[:, None, 0] - r[None, :, 0] - rows * state["offset"]
    x -= length * np.rint(x / length)
    y = r[:, None, 1] - r[None, :, 1] - rows * height
    v_x = v[:, None, 0] - v[None, :, 0] - rows * rate * height
    v_y = v[:, None, 1] - v[None, :, 1]
    contact = (d[:, None] + d[None, :]) / 2
    distance = np.hypot(x, y)
    i, j = np.nonzero(np.triu(distance < contact, 1))
    x, y, v_x, v_y, distance, contact = (a[i, j] for a in (x, y, v_x, v_y, distance, contact))
    n_x, n_y = x / distance, y / distance
    if model == "CD_n":
        normal = v_x * n_x + v_y * n_y
        v_x, v_y = normal * n_x, normal * n_y
    if model == "CD_rot":  # arms s_ji = r_ji d_i / (d_i + d_j), P2 Eq. 6
        turn = (state["spin"][i] * d[i] + state["spin"][j] * d[j]) / (d[i] + d[j])
        v_x, v_y = v_x + turn * y, v_y - turn * x
        torque_power = damping * np.sum((v_y * x - v_x * y) * turn)  # P2 Eq. 7
    f = (1 - distance / contact) / contact
    dv = v - rate * r[:, 1:] * [1, 0]
    result = {
        "p_el": np.sum(f * distance) / (2 * area),
        "p_dis": -damping * np.sum(v_x * x + v_y * y) / (2 * area),
        "p_kin": np.sum(m[:, None] * dv**2) / (2 * area),
        "sigma_el": -np.sum(f * n_x * y) / area,
        "sigma_dis": damping * np.sum(v_x * y) / area,
        "sigma_kin": -np.sum(m * dv[:, 0] * dv[:, 1]) / area,
        "T_g": np.sum(m[:, None] * dv**2) / (2 * len(d)),
        "Z": 2 * len(i) / len(d),
        "R_v": np.mean(dv[:, 0] ** 2) / np.mean(dv[:, 1] ** 2),
    }
    if model == "CD_rot":
        result["spin_mean"] = np.mean(state["spin"]) / rate
        result["spin_var"] = np.var(state["spin"]) / rate**2
        sigma = result["sigma_el"] + result["sigma_dis"] + result["sigma_kin"]
        result["torque_power"] = torque_power / (sigma * rate * area)
    return result


class Inputs(CliTest):
    def test_every_input_validates(self):
        paths = sorted((SOURCE / "inputs").glob("*.toml")) + sorted((SOURCE / "inputs/checks").glob("*.toml"))
        self.assertIn("reference.toml", [path.name for path in paths])
        self.assertIn("quickstart.toml", [path.name for path in paths])
        for path in paths:
            with self.subTest(path=path.name):
                result = self.bagnold("validate", path, "--no-time")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("steps", result.stdout)
                self.assertNotIn("estimated time", result.stdout)

    def test_reference_equals_the_defaults(self):
        reference = tomllib.loads((SOURCE / "inputs/reference.toml").read_text())
        for table, keys in SCENE.items():
            for key in keys:
                self.assertIn(key, reference.get(table, {}), f"{table}.{key}")
        required = {
            "disks": {k: reference["disks"][k] for k in
                      ("model", "count", "packing_fraction", "elasticity", "mass")},
            "shear": {k: reference["shear"][k] for k in ("strain_rate", "strain")},
        }
        bare = self.scene(required)
        short = ("--set", "disks.count=64", "--set", "shear.strain=0.01")
        outs = []
        for name, path in (("full", SOURCE / "inputs/reference.toml"), ("bare", bare)):
            outs.append(self.folder / name)
            self.run_scene(path, outs[-1], *short)
        scenes = [tomllib.loads((out / "scene.toml").read_text()) for out in outs]
        for scene in scenes:
            scene.pop("title", None)
        self.assertEqual(*scenes)
        self.assert_same_state(*outs)

    def test_the_example_of_the_contract(self):
        """The scene with every key spelled out, as in the guide."""
        path = self.folder / "full.toml"
        path.write_text('''
title = "CD_rot, Newtonian side"

[disks]
model = "CD_rot"            # "CD" | "CD_n" | "CD_rot" | "CD_nt"
count = 1024                # even
packing_fraction = 0.82
elasticity = 1.0            # Q
mass = "equal"              # "equal" | "area"
seed = 1

[shear]
protocol = "steady"         # later also "ramp", "cascade"
strain_rate = 1e-4          # in 1/tau_e
strain = 20.0               # total
discard = 0.5               # share of the strain not measured

[integration]
scheme = "modified-velocity-verlet"
time_step = "auto"          # or a number, in tau_e

[measure]
every = 10                  # steps between evaluations inside a window

[output]
sample_strain = 1e-2        # window whose averages are recorded
trajectory_strain = 0.0     # 0: none
checkpoint_minutes = 10
''')
        result = self.bagnold("validate", path)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("4000000", re.sub(r"[ ,_']", "", result.stdout))  # 20 / (1e-4 * 0.05)


if __name__ == "__main__":
    unittest.main()
