# SPDX-License-Identifier: BSD-3-Clause
"""What the package reads, against the files as h5py and json have them."""

import csv
import importlib.util
import inspect
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import unittest
import warnings

import h5py
import matplotlib
import numpy as np

from made import SCENE, SOURCE, Folder, bagnold, made, run, with_frames

matplotlib.use("Agg")


class Results(Folder):
    def test_series_and_averages(self):
        r = made()
        self.assertIn(r.folder.name, repr(r))
        with h5py.File(r.folder / "result.h5") as file:
            self.assertEqual(set(r.series), set(file["series"]))
            for name in r.series:
                np.testing.assert_array_equal(r.series[name], file["series"][name])
            self.assertEqual(r.series.unit("p"), file["series/p"].attrs["unit"])
            self.assertIn("pressure", r.series.description("p"))
            discarded = file["series"].attrs["discarded_windows"]
        self.assertEqual(len(r.series.measured("Z")), len(r.series["Z"]) - discarded)
        found = json.loads((r.folder / "summary.json").read_text())
        self.assertEqual(set(r.observables), set(found["observables"]))
        for name, one in found["observables"].items():
            self.assertEqual(r[name].samples, one["samples"])
            for key in ("mean", "error", "correlation_strain"):
                value = getattr(r[name], key)
                self.assertTrue(value == one[key] or (one[key] is None and np.isnan(value)), (name, key))
        self.assertEqual(float(r["Z"]), found["observables"]["Z"]["mean"])
        self.assertEqual([w.name for w in r.warnings], [w["name"] for w in found["warnings"]])
        self.assertEqual(r.about["model"], "CD_rot")
        with self.assertRaisesRegex(KeyError, "B_q is not among the averages .*B_p"):
            r["B_q"]
        with self.assertRaisesRegex(KeyError, "B_q is not among the series"):
            r.series["B_q"]

    def test_frames_of_a_run_that_is_made_longer(self):
        """The trajectory of the shorter run stays until that of the longer one is whole."""
        source, made = with_frames(), self.folder / "longer"
        shutil.copytree(source.folder, made)
        whole = made / "trajectory.h5md"
        (made / "trajectory.parts").mkdir()
        self.assertEqual(len(bagnold.load(made).frames), len(source.frames))
        (made / "summary.json").unlink()  # it is being made longer
        for part in ("000000_a.h5md", "000001_b.h5md"):  # those of the shorter run, and as many new ones
            shutil.copy(whole, made / "trajectory.parts" / part)
        with h5py.File(made / "trajectory.parts/000001_b.h5md", "r+") as file:
            file["particles/trajectory/position/step"][...] += source.frames.steps[-1] + 1
        self.assertEqual(len(bagnold.load(made).frames), 2 * len(source.frames))

    def test_files_that_change_are_read_again(self):
        """A run that was looked at and is made longer is as one that is loaded afterwards."""
        out = self.folder / "longer"
        first = run(SCENE, out, output__trajectory_strain=2.0**-3, disks__count=128, measure__rotation=True)
        r, series = bagnold.load(first.folder), first.series
        self.assertIs(r.series, r.series)  # kept while nothing changes

        def known(one):
            return {"summary": one.summary, "discarded": one.series.discarded, "p": one["p"].mean,
                    "frames": len(one.frames), "strain": one.scene["shear.strain"],
                    "replicas": one.replicas[0]["p"].mean,
                    "rotation": list(one.histograms["rotation"].density)}

        short = known(r)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            bagnold.resume(out, strain=4.0, progress=False)
        fresh = bagnold.load(out)
        for name, value in known(fresh).items():
            np.testing.assert_equal(known(r)[name], value, name)
            self.assertNotEqual(value, short[name], name)
        for one in (r.series, series):  # one that was kept from before too
            self.assertEqual(one.discarded, fresh.series.discarded)
            np.testing.assert_array_equal(one.measured("p"), fresh.series.measured("p"))
            self.assertAlmostEqual(one.measured("p").mean() / fresh["p"].mean, 1, places=9)

    def test_a_cascade_names_its_rates(self):
        rates = {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 0.25}
        r = run({**SCENE, "shear": rates}, self.folder / "cascade")
        for what in ("series", "state", "frames"):
            with self.assertRaisesRegex(bagnold.FileError, "is a cascade, a run a rate: take one of r.points"):
                getattr(r, what)

    def test_states_of_replicas_at_given_stress(self):
        """Each has a strain of its own."""
        held = {"protocol": "stress", "stress": 2e-3, "time": 2048.0, "strain_rate": 2.0**-7}
        r = run({"disks": {**SCENE["disks"], "replicas": 3}, "shear": held, "output": SCENE["output"]}, self.folder / "held")
        ends = r.series["strain"][:, -1]
        self.assertEqual([state.strain for state in r.states], list(ends))
        self.assertGreater(np.ptp(ends), 0)

    def test_scene(self):
        scene = made().scene
        self.assertEqual(scene["disks"]["count"], 64)
        self.assertEqual(scene["disks.count"], 64)
        self.assertEqual(scene.get("disks.no"), None)
        self.assertEqual(scene.flat()["shear.strain_rate"], 2.0**-7)
        with self.assertRaisesRegex(KeyError, "disks.cuont is not in the scene.*disks.count"):
            scene["disks.cuont"]

    def test_scenes_as_text(self):
        from bagnold.scene import toml_text
        scene = {"title": 'a "quoted" \\ é\x7f\n', "disks": {"count": np.int64(4), "elasticity": np.float64(0.1)},
                 "shear.target_error": {"B_p": 0.02}, "shear.strain_rates": np.array([1e-3, 1e-4]),
                 "output": {"plot": True}, "sweep": {"grid": {"disks.seed": [1, 2]}}, "start.file": pathlib.Path("a")}
        self.assertEqual(tomllib.loads(toml_text(scene)), {
            "title": scene["title"], "disks": {"count": 4, "elasticity": 0.1},
            "shear": {"target_error": {"B_p": 0.02}, "strain_rates": [1e-3, 1e-4]}, "output": {"plot": True},
            "sweep": {"grid": {"disks.seed": [1, 2]}}, "start": {"file": "a"}})
        with self.assertRaisesRegex(TypeError, "has no form in a scene"):
            toml_text({"disks": {"count": object()}})

    def test_numbers_in_words(self):
        from bagnold.observables import rounded
        for mean, error, text in ((18873.4, 973, "1.89(10)e+04"), (0.51234, 0.0004, "0.5123(4)"),
                                  (17.3, 1.2, "17.3(1.2)"), (17.3, 25, "17(25)"), (1.5, np.nan, "1.5"),
                                  (np.nan, 1, "undefined"), (2.5526, 0.0997, "2.55(10)"),
                                  (-2.345e-7, 3e-9, "-2.35(3)e-07"), (0, 0.5, "0.0(5)")):
            self.assertEqual(rounded(mean, error), text)
        self.assertRegex(str(made()["p"]), r"^p = [\d.]+(\([\d.]+\))? m/tau_e\^2$")

    def test_what_else_is_measured(self):
        r = made(disks__count=128, measure__profiles=True, measure__rotation=True, measure__fields=True, measure__contacts=True,
                 measure__frame_strain=2.0**-4)
        with h5py.File(r.folder / "result.h5") as file:
            np.testing.assert_array_equal(r.profiles["v_x"].value, file["profiles/v_x/value"])
            np.testing.assert_array_equal(r.histograms["rotation"].density, file["histograms/rotation/density"])
            self.assertEqual(list(r.samples["fields"])[:3], ["x", "y", "diameter"])
            np.testing.assert_array_equal(r.samples["fields"]["y"], file["samples/fields"][:, 1])
        self.assertEqual(made().histograms, {})

    def test_replicas(self):
        r = with_frames(disks__replicas=3, disks__seed=5)
        self.assertEqual(r.seeds, [5, 6, 7])
        self.assertEqual(r.series["Z"].shape, (3, 32))
        self.assertEqual(len(r.replicas), 3)
        self.assertEqual(len(r.states), 3)
        alone = with_frames(disks__seed=6)
        self.assertEqual(r.replicas[1]["Z"].mean, alone["Z"].mean)
        np.testing.assert_array_equal(r.frames_of(6).positions, alone.frames.positions)
        np.testing.assert_array_equal(r.states[1].position, alone.state.position)
        with self.assertRaisesRegex(bagnold.InputError, "seed = 9 .*5 .. 7"):
            r.frames_of(9)

    def test_a_cascade(self):
        scene = {**SCENE, "shear": {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 1.0}}
        r = run(scene, self.folder / "cascade")
        self.assertEqual([point.scene["shear.strain_rate"] for point in r.points], [2.0**-6, 2.0**-7])
        table = bagnold.sweep(r.folder)
        np.testing.assert_array_equal(table["shear.strain_rate"], [2.0**-6, 2.0**-7])
        np.testing.assert_array_equal(table["Z"], [point["Z"].mean for point in r.points])
        np.testing.assert_array_equal(table.error("Z"), [point["Z"].error for point in r.points])
        self.assertEqual(table[1].load()["Z"], r.points[1]["Z"])
        with self.assertRaisesRegex(bagnold.FileError, "is a cascade.*r.points"):
            r["Z"]

    def test_a_ramp(self):
        scene = {**SCENE, "output": {"plot": False}, "shear": {"protocol": "ramp", "strain_rate": 2.0**-8, "strain_rate_high": 2.0**-6,
                                    "ramp_rate": 1e-2, "ramp_window": 4.0, "strain": 0.25}}
        r = run(scene, self.folder / "ramp")
        up = r.loop("sigma")["up"]
        self.assertEqual(up.strain_rate.shape, up.mean.shape)
        bins = r.summary["loop"]["up"]
        np.testing.assert_array_equal(up.mean, [one["observables"]["sigma"]["mean"] for one in bins])
        with self.assertRaisesRegex(bagnold.InputError, "is no ramp"):
            made().loop("sigma")

    def test_a_sequence(self):
        scene = {**SCENE, "output": {"plot": False, "sample_strain": 2.0**-6},
                 "shear": {"protocol": "sequence", "pieces": [[2.0**-7, 0.25], [-2.0**-7, 0.125], [0, 64.0]], "discard": 0.5}}
        r = run(scene, self.folder / "sequence", disks__replicas=3)
        self.assertEqual([one.strain_rate for one in r.pieces], [2.0**-7, -2.0**-7, 0])
        self.assertEqual([one.strain for one in r.pieces], [0.25, -0.125, 0])
        self.assertEqual([one.begin_time for one in r.pieces], [0, 32, 48])
        self.assertEqual(r.pieces[1].windows, 3 * 4)
        sigma = r.series["sigma"]
        for piece, windows in zip(r.pieces, (slice(8, 16), slice(20, 24))):  # the later half of each, windows alike
            self.assertAlmostEqual(piece.mean["sigma"] / sigma[:, windows].mean(), 1, places=10)
            each = sigma[:, windows].mean(axis=1)
            self.assertAlmostEqual(piece.error["sigma"] / (each.std(ddof=1) / np.sqrt(3)), 1, places=6)
        with self.assertRaisesRegex(KeyError, "p is not among .*see r.pieces"):
            r["p"]
        self.assertEqual(r.state.strain, 0.125)
        with self.assertRaisesRegex(bagnold.InputError, "is no sequence"):
            made().pieces
        self.assertEqual([hasattr(one, "pieces") for one in (r, made())], [True, False])
        with self.assertRaisesRegex(bagnold.FileError, "output.trajectory_time"):
            r.frames
        self.assertIn("<h2>Pictures</h2>", bagnold.report(r).read_text())

    def test_a_list_of_stresses(self):
        scene = {**SCENE, "output": {"plot": False, "sample_strain": 2.0**-4},
                 "shear": {"protocol": "stress", "strain_rate": 2.0**-9, "stress": [1e-3, 2e-3], "time": 2000.0, "discard": 0.5}}
        r = run(scene, self.folder / "stresses", disks__replicas=3)
        self.assertEqual([one.stress for one in r.stresses], [1e-3, 2e-3])
        with self.assertRaisesRegex(bagnold.InputError, "r.stresses"):
            r.series.measured("sigma")
        windows = r.series["sigma"].shape[1] // 2
        for k, held in enumerate(r.stresses):
            measured = slice(k * windows + windows - held.windows, (k + 1) * windows)
            for name in ("sigma", "strain_rate"):
                each = r.series[name][:, measured].mean(axis=1)
                self.assertAlmostEqual(held.mean[name] / each.mean(), 1, places=10)
                self.assertAlmostEqual(held.error[name] / (each.std(ddof=1) / np.sqrt(3)), 1, places=6)
            strains = r.series["strain"][:, [measured.start - 1, measured.stop - 1]]
            self.assertAlmostEqual(held.strain / np.diff(strains).mean(), 1, places=9)
        self.assertIn("<h2>Pictures</h2>", bagnold.report(r).read_text())

    def test_an_oscillation(self):
        scene = {**SCENE, "output": {"plot": False},
                 "shear": {"protocol": "oscillate", "amplitude": 0.125, "period": 64.0, "cycles": 6, "cycle_pieces": 16, "discard": 0.5}}
        r = run(scene, self.folder / "oscillation", disks__model="CD")
        found = r.oscillation
        self.assertEqual((found.amplitude, found.period, found.cycles, found.discarded_cycles), (0.125, 64.0, 6, 3))
        sigma = r.series["sigma"].reshape(6, 16)[3:]
        np.testing.assert_allclose(found.sigma, sigma.mean(axis=0), rtol=1e-10)
        np.testing.assert_allclose(found.sigma_error, sigma.std(axis=0, ddof=1) / np.sqrt(3), rtol=1e-6)
        self.assertEqual(found.p_error.shape, found.strain.shape)
        np.testing.assert_allclose(found.strain_rate, r.series["strain_rate"][:16], rtol=1e-10)
        self.assertTrue(np.isfinite(r["G_storage"].mean))
        with self.assertRaisesRegex(bagnold.InputError, "is no oscillation"):
            made().oscillation
        self.assertEqual([hasattr(one, "oscillation") for one in (r, made())], [True, False])
        cycles = r.samples["cycles"]
        np.testing.assert_array_equal(cycles["measured"], [0, 0, 0, 1, 1, 1])
        for name in ("G_storage", "G_loss", "sigma_drift"):
            self.assertAlmostEqual(cycles[name][3:].mean() / r[name].mean, 1, places=10)
        self.assertIn("<h2>Averages</h2>", bagnold.report(r).read_text())

    def test_what_is_no_run_says_what_it_is(self):
        for path, words in ((self.folder / "none", "the folder is not there"), (self.folder, "holds no run")):
            with self.assertRaisesRegex(bagnold.FileError, words):
                bagnold.load(path)
        begun = self.folder / "begun"
        begun.mkdir()
        shutil.copy(made().folder / "scene.toml", begun)
        r = bagnold.load(begun)
        self.assertEqual(r.scene["disks.count"], 64)
        self.assertFalse(r.complete)
        with self.assertRaisesRegex(bagnold.FileError, "not complete.*bagnold resume"):
            r["B_p"]
        with self.assertRaisesRegex(bagnold.FileError, "has not come that far"):
            r.series
        with self.assertRaisesRegex(bagnold.FileError, "output.trajectory_strain"):
            made().frames
        shutil.copy(with_frames().folder / "scene.toml", begun)
        with self.assertRaisesRegex(bagnold.FileError, "no frame is written yet"):
            r.frames
        (begun / "result.h5").write_text("no HDF5")
        with self.assertRaisesRegex(bagnold.FileError, "result.h5 cannot be read"):
            r.series


class Frames(Folder):
    def test_frames_are_those_of_the_file(self):
        r = with_frames()
        frames = r.frames
        self.assertEqual(len(frames), 9)
        with h5py.File(r.folder / "trajectory.h5md") as file:
            group = file["particles/trajectory"]
            np.testing.assert_array_equal(frames.positions, group["position/value"][..., :2])
            np.testing.assert_array_equal(frames.velocities, group["velocity/value"][..., :2])
            np.testing.assert_array_equal(frames.spins, group["spin/value"])
            np.testing.assert_array_equal(frames.steps, group["position/step"])
            for k, frame in enumerate(frames):
                np.testing.assert_array_equal(frame.position, group["position/value"][k, :, :2])
                np.testing.assert_array_equal(frame.spin, group["spin/value"][k])
                np.testing.assert_array_equal(frame.box.matrix, group["box/edges/value"][k])
                self.assertEqual(frame.time, group["position/time"][k])
                self.assertAlmostEqual(frame.strain, k * 2.0**-3, delta=1e-12)
                self.assertEqual(frame.strain_rate, 2.0**-7)
        self.assertEqual(len(frame), 64)
        np.testing.assert_array_equal(frame.species, frame.diameter > 1.2)
        self.assertAlmostEqual(frame.packing_fraction, 0.84)
        np.testing.assert_array_equal(frames[-1].position, frame.position)
        with self.assertRaises(IndexError):
            frames[9]

    def test_places_without_images(self):
        frames = with_frames(shear__strain=8.0, disks__packing_fraction=0.7).frames
        self.assertGreater(np.abs(frames[-1].image).max(), 1)
        places = np.array([frame.unwrapped for frame in frames])
        np.testing.assert_allclose(places, bagnold.structure.unwrapped(frames), atol=1e-8)

    def test_files_of_older_versions(self):
        r = with_frames()
        for name in ("scene.toml", "summary.json", "trajectory.h5md"):
            shutil.copy(r.folder / name, self.folder)
        with h5py.File(self.folder / "trajectory.h5md", "r+") as file:
            del file["observables"], file["particles/trajectory/image"]
        for old, frame in zip(bagnold.load(self.folder).frames, r.frames, strict=True):
            self.assertAlmostEqual(old.strain, frame.strain, delta=1e-12)
            self.assertEqual((old.strain_rate, old.image), (frame.strain_rate, None))
        with self.assertRaisesRegex(bagnold.InputError, "no image.*structure.unwrapped"):
            old.unwrapped

    def test_slices(self):
        frames = with_frames().frames
        some = frames[1:8:3]
        self.assertEqual(len(some), 3)
        np.testing.assert_array_equal(some.steps, frames.steps[1:8:3])
        np.testing.assert_array_equal(some[1:][0].position, frames[4].position)
        np.testing.assert_array_equal(frames[::-2].positions, frames.positions[::-2])
        np.testing.assert_array_equal(frames.strains, [frame.strain for frame in frames])

    def test_the_state_is_the_last_frame(self):
        r = with_frames()
        state, last = r.state, r.frames[-1]
        np.testing.assert_array_equal(state.position, last.position)
        np.testing.assert_array_equal(state.spin, last.spin)
        self.assertEqual((state.box, state.time, state.strain_rate), (last.box, last.time, last.strain_rate))

    def test_no_spins_without_rotation(self):
        frames = with_frames(disks__model="CD_n").frames
        self.assertIsNone(frames[0].spin)
        with self.assertRaisesRegex(bagnold.InputError, "does not rotate"):
            frames.spins

    def parts(self, *parts):
        """A run at work with these parts, (number, hash, frames) in the order of their times, and the whole one."""
        r = with_frames()
        out = self.folder / "begun"
        folder = out / "trajectory.parts"
        folder.mkdir(parents=True)
        shutil.copy(r.folder / "scene.toml", out)
        with h5py.File(r.folder / "trajectory.h5md") as whole:
            for age, (number, of, frames) in enumerate(parts):
                path = folder / f"{number:06}_{of:016x}.h5md"
                with h5py.File(path, "w") as part:
                    whole.copy("particles", part)
                    group = part["particles/trajectory"]
                    for name in ("position/step", "position/time"):
                        del group[name]
                        group[name] = whole["particles/trajectory"][name][frames]
                    for name in ("position", "velocity", "spin", "box/edges"):
                        del group[name]["value"]
                        group[name]["value"] = whole["particles/trajectory"][name]["value"][frames]
                os.utime(path, (1000 + age, 1000 + age))
        return out, r

    def test_parts_of_a_run_that_goes_on(self):
        """A frame each part; of two with one number the younger counts."""
        out, r = self.parts((0, 3, slice(3, 4)), (0, 0, slice(1)), (1, 1, slice(1, 2)), (2, 2, slice(2, 3)))
        frames = bagnold.load(out).frames
        self.assertEqual(len(frames), 3)
        np.testing.assert_array_equal(frames.positions, r.frames.positions[:3])
        np.testing.assert_array_equal([frame.position for frame in frames[::-1]], r.frames.positions[2::-1])

    def test_parts_left_from_before_a_kill(self):
        """Parts that the checkpoint does not count are no frames of the run, nor those that do not follow in steps."""
        high = (3 << 32) + 7  # a hash of two halves
        out, r = self.parts((0, high, slice(2)), (1, 1, slice(2, 4)), (2, 2, slice(6, 8)), (3, 3, slice(8, 9)),
                            (1, 4, slice(2, 5)), (2, 5, slice(4, 6)))
        loaded = bagnold.load(out)
        np.testing.assert_array_equal(loaded.frames.steps, r.frames.steps[:5])

        def counts(path, *hashes):
            file[path] = np.array([(one >> 32, one & 0xffffffff) for one in hashes], dtype=float).ravel()

        with h5py.File(out / "checkpoint.h5", "w") as file:
            counts("frames/trajectory_hashes", high, 4)
        np.testing.assert_array_equal(loaded.frames.steps, r.frames.steps[:5])
        with h5py.File(out / "checkpoint.h5", "w") as file:  # of replicas that of the folder
            counts("replicas/0/frames/trajectory_hashes", 9, 8)
            counts("replicas/1/frames/trajectory_hashes", high, 1)
        np.testing.assert_array_equal(loaded.frames.steps, r.frames.steps[:4])


class Pictures(Folder):
    """By functions and by `python -m bagnold plot`; what they show is tested by tests/cli."""

    def test_of_a_run(self):
        from bagnold import plots
        r = made()
        for source in (r, r.folder, str(r.folder / "result.h5")):
            figure = plots.run(source)
            self.assertGreater(len(figure.axes), 5)
            plots.style.plt.close(figure)
        plots.save(r.plot(), self.folder / "x.svg")
        self.assertIn("<svg", (self.folder / "x.svg").read_text())
        with self.assertRaisesRegex(bagnold.InputError, "measure.profiles = true"):
            plots.profiles(r)
        with self.assertRaisesRegex(bagnold.FileError, "result.h5 is not there"):
            plots.run(self.folder)

    def test_of_frames(self):
        from bagnold import plots
        r = made(disks__count=128, measure__profiles=True, measure__fields=True, measure__frame_strain=2.0**-4)
        self.assertEqual(len([axes for axes in plots.profiles(r).axes if axes.lines]), 8)
        self.assertGreaterEqual(len(plots.fields(r).axes), 2)
        for target, names in ((self.folder, ["fields.png", "histograms.png", "profiles.png"]),
                              (self.folder / "any.pdf", ["fields.pdf", "histograms.pdf", "profiles.pdf"])):
            said = self.plot(r.folder, target, "--frames")
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            self.assertEqual(sorted(path.name for path in self.folder.glob(f"*{names[0][-4:]}")), names)

    def test_what_cannot_be_drawn_is_one_line(self):
        (self.folder / "x.drawn.csv").write_text("panel\n")
        for source in (self.folder / "none", self.folder, self.folder / "x.drawn.csv"):
            said = self.plot(source, self.folder / "x.png")
            self.assertEqual((said.returncode, len(said.stderr.splitlines())), (1, 1), said.stderr)
            self.assertFalse((self.folder / "x.png").exists())

    def plot(self, *words):
        return subprocess.run([sys.executable, "-m", "bagnold", "plot", *map(str, words)], capture_output=True,
                              text=True, env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})


class Sweeps(Folder):
    def test_table(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            sweep = bagnold.sweep_file({**SCENE, "sweep": {"grid": {"disks.elasticity": [1, 4], "disks.seed": [1, 2]}}},
                                       self.folder / "many", jobs=2, progress=False)
        self.assertEqual(len(sweep), 4)
        with open(self.folder / "many/sweep.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        np.testing.assert_array_equal(sweep["disks.elasticity"], [1, 1, 4, 4])
        for name in sweep.names:
            for column, values in ((name, sweep[name]), (f"{name}_error", sweep.error(name))):
                np.testing.assert_array_equal(values, [float(row[column] or "nan") for row in rows])
        point = sweep[2]
        self.assertEqual((point.status, point.scene["disks.elasticity"], point.scene["disks.seed"]), ("done", 4, 1))
        self.assertEqual(point.load()["Z"].mean, sweep["Z"][2])
        self.assertEqual(point.warnings, tuple(warning.name for warning in point.load().warnings))
        with self.assertRaisesRegex(KeyError, "neither a varied key.*disks.seed.*observable"):
            sweep["Q"]
        with self.assertRaisesRegex(bagnold.FileError, "bagnold.sweep"):
            bagnold.load(self.folder / "many")
        with self.assertRaisesRegex(bagnold.FileError, "bagnold.load"):
            bagnold.sweep(made().folder)
        try:
            import pandas  # noqa: F401
        except ImportError:
            with self.assertRaisesRegex(bagnold.MissingLibrary, "pandas"):
                sweep.to_pandas()
            return
        table = sweep.to_pandas()
        np.testing.assert_array_equal(table["Z"], sweep["Z"])
        self.assertEqual(list(table["disks.seed"]), [1, 2, 1, 2])


class Package(unittest.TestCase):
    def test_version_is_that_of_the_program(self):
        version = re.search(r"project\(Bagnold VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        project = tomllib.loads((SOURCE / "python/pyproject.toml").read_text())["project"]
        self.assertEqual(project["version"], version)
        self.assertEqual(bagnold.__version__, version)

    def test_all_that_is_public_is_documented(self):
        for name in bagnold.__all__:
            value = getattr(bagnold, name)
            self.assertTrue(inspect.getdoc(value), name)
            if inspect.isclass(value):
                for member, what in vars(value).items():
                    if not member.startswith("_") and (callable(what) or isinstance(what, property)):
                        self.assertTrue(inspect.getdoc(getattr(value, member)), f"{name}.{member}")

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
    def test_types(self):
        said = subprocess.run([sys.executable, "-m", "mypy", "--config-file", "pyproject.toml", "--cache-dir",
                               "/dev/null", "-p", "bagnold"], cwd=SOURCE / "python", capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stdout)

    def test_imports_neither_matplotlib_nor_pandas(self):
        program = (f"import sys; sys.path.insert(0, {str(SOURCE / 'python')!r}); import bagnold; "
                   "print([name for name in ('matplotlib', 'pandas', 'gsd') if name in sys.modules])")
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.strip(), "[]")


if __name__ == "__main__":
    unittest.main()
