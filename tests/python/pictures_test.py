# SPDX-License-Identifier: BSD-3-Clause
"""Pictures by what they draw: lines, labels with units, the scene on each, no text upon another."""

import itertools
import pathlib
import re
import shutil
import tempfile
import unittest
import warnings

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")

from matplotlib import pyplot as plt  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.collections import QuadMesh  # noqa: E402
from matplotlib.text import Text  # noqa: E402

from made import FOLDER, SCENE, SOURCE, Folder, bagnold, made, run  # noqa: E402
from bagnold import plots  # noqa: E402

RAMP = {**SCENE, "shear": {"protocol": "ramp", "strain_rate": 2.0**-9, "strain_rate_high": 2.0**-6, "ramp_rate": 2e-3,
                           "ramp_window": 16.0, "cycles": 3, "strain": 0.25},
        "output": {"plot": False}}


def texts(figure):
    """[(text, box in pixels)] of all that is written, ticks outside of their axes left out."""
    figure.canvas.draw()
    hidden = set()
    for axes in figure.findobj(Axes):
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            for tick in axis.get_major_ticks() + axis.get_minor_ticks():
                inside = low - 1e-9 * (high - low) <= tick.get_loc() <= high + 1e-9 * (high - low)
                if not (inside and axis.get_visible() and axes.axison):
                    hidden |= {tick.label1, tick.label2}
    found = []
    for one in figure.findobj(Text):
        if one.get_visible() and one.get_text().strip() and one not in hidden:
            found.append((one.get_text(), one.get_window_extent(figure.canvas.get_renderer())))
    return found


def scene_text(figure):
    return " ".join(one.get_text() for one in figure.texts)


class Pictures(Folder):
    def setUp(self):
        super().setUp()
        self.addCleanup(plt.close, "all")

    def readable(self, figure):
        """No text upon another, none outside of the page; both axes of each panel have a label and two ticks."""
        drawn = texts(figure)
        page = figure.bbox
        for text, box in drawn:
            self.assertTrue(box.x0 >= 0 and box.y0 >= 0 and box.x1 <= page.x1 and box.y1 <= page.y1, (text, box))
        for (one, a), (other, b) in itertools.combinations(drawn, 2):
            wide, high = min(a.x1, b.x1) - max(a.x0, b.x0), min(a.y1, b.y1) - max(a.y0, b.y0)
            self.assertFalse(wide > 1 and high > 1, (one, other))

    def has_scene(self, figure, *parts):
        said = scene_text(figure)
        for part in parts or ("model CD_rot", "$N = 64$", r"$\phi = 0.84$", "$Q = 1$", r"\dot\gamma\tau_e = ",
                              "equal masses", f"bagnold {bagnold.__version__}"):
            self.assertIn(part, said)

    def labels(self, figure):
        return [axes.get_ylabel() for axes in figure.axes]


class Runs(Pictures):
    def test_steady(self):
        figure = plots.run(made())
        self.readable(figure)
        self.has_scene(figure)
        self.assertIn("strain 1 ", scene_text(figure))
        for label in (r"stress  $[m/\tau_e^2]$", r"$T_g$  $[m\,d_s^2/\tau_e^2]$", "$Z$", r"$\mu$",
                      r"$\langle\dot\theta\rangle/\dot\gamma$"):
            self.assertIn(label, self.labels(figure))

    def test_only_files_are_replaced(self):
        self.keeps_what_is_no_file(lambda path: plots.draw_to(made().folder, path), ".png")

    def test_replicas(self):
        source = made(disks__replicas=3, disks__model="CD_n", output__sample_strain=2.0**-9)
        figure = plots.run(source)
        self.readable(figure)
        said = scene_text(figure)
        for part in ("3 replicas", "pale: each replica", "grey: not measured", "bold: running mean", "dashed: mean"):
            self.assertIn(part, said)
        stress, = [axes for axes in figure.axes if axes.get_ylabel().startswith("stress ")]
        self.assertEqual(list(stress.texts), [])  # nothing is written upon the curves

    def test_a_long_title_and_one_with_signs(self):
        for title in ("a $ and a _ of 80 letters " + 54 * "x", ""):
            figure = plots.run(made(title=title))
            self.readable(figure)
            self.assertIn(title.replace("$", r"\$"), scene_text(figure))


class Sequences(Pictures):
    def drawn(self, **changes):
        scene = {**SCENE, "output": {"plot": False, "sample_strain": 2.0**-6},
                 "shear": {"protocol": "sequence", "pieces": [[2.0**-7, 0.25], [-2.0**-7, 0.125], [0, 128.0]]}}
        return run(scene, self.folder / "sequence", **changes)

    def lines(self, axes):
        """Those of pieces: with more than one point, not level."""
        return [line for line in axes.get_lines() if len(line.get_xdata()) > 2 and line.get_linestyle() == "-"]

    def test_pieces_are_told_apart(self):
        source = self.drawn(disks__replicas=3)
        figure = plots.run(source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "3 pieces", "strain 0.375", "3 replicas", "standard error over replicas")
        names = [text.get_text() for text in figure.legends[0].get_texts()]
        self.assertEqual(names[0], r"1: $\dot\gamma\tau_e = $$7.812\times 10^{-3}$, strain 0.25")
        self.assertIn("= -$", names[1])
        self.assertIn("3: stop", names[2])
        sigma, strain = source.series["sigma"].mean(axis=0), source.series["strain"][0]
        against, _, _, since, pressure, _ = figure.axes
        for axes, sign in ((against, -1), (since, 1)):
            forth, back = self.lines(axes)
            self.assertNotEqual(forth.get_color(), back.get_color())
            np.testing.assert_allclose(forth.get_ydata(), sigma[:16])
            np.testing.assert_allclose(back.get_ydata(), -sign * sigma[16:24])
        np.testing.assert_allclose(self.lines(against)[1].get_xdata(), strain[16:24] + 2.0**-7)
        np.testing.assert_allclose(self.lines(since)[1].get_xdata(), (np.arange(8) + 0.5) * 2.0**-6)
        stop, = self.lines(pressure)
        np.testing.assert_allclose(stop.get_ydata(), source.series["p"].mean(axis=0)[24:])
        ends = source.series["time"][0][24:] - 48
        np.testing.assert_allclose(stop.get_xdata(), (ends + np.append(0, ends[:-1])) / 2)
        self.assertEqual(pressure.get_xscale(), "log")
        bands = [path for axes in figure.axes if axes.get_yscale() == "log" for one in axes.collections
                 for path in one.get_paths() if one.get_alpha() == 0.25]
        self.assertTrue(bands and all((path.vertices[:, 1] > 0).all() for path in bands))

    def test_from_a_state_and_again_and_again(self):
        first = self.drawn()
        state = str(first.folder / "state.h5")
        scene = {**SCENE, "output": {"plot": False, "sample_strain": 2.0**-6}, "start": {"kind": "state", "file": state},
                 "shear": {"protocol": "sequence", "cycles": 3, "pieces": [[0, 16.0], [2.0**-7, 0.0625]]}}
        source = run(scene, self.folder / "again")
        self.assertGreater(source.series["time"][0], 100)  # it goes on from the state's
        figure = plots.run(source)
        self.readable(figure)
        flows, stops = self.lines(figure.axes[0]), self.lines(figure.axes[4])
        self.assertEqual([len(line.get_xdata()) for line in flows], [4, 4, 4])
        self.assertEqual(len(stops), 3)
        self.assertEqual(len({line.get_color() for line in flows}), 1)
        for line in stops[1:]:
            np.testing.assert_allclose(line.get_xdata(), stops[0].get_xdata())
        self.assertIn("3 times", scene_text(figure))

    def test_stops_alone_and_flows_alone(self):
        for pieces, panels in (([[0, 64.0]], 3), ([[2.0**-7, 0.25]], 6)):
            source = run({**SCENE, "output": {"plot": False, "sample_strain": 2.0**-6},
                          "shear": {"protocol": "sequence", "pieces": pieces}}, self.folder / str(panels))
            figure = plots.run(source)
            self.readable(figure)
            self.assertEqual(len(figure.axes), panels)


class Control(Pictures):
    def drawn(self, name, **shear):
        scene = {**SCENE, "output": {"plot": False, "sample_strain": 2.0**-4},
                 "shear": {"protocol": name, "strain_rate": 2.0**-9, **shear}}
        return run(scene, self.folder / name, disks__replicas=3)

    def line(self, figure, label):
        """Axes whose label begins so, and the line of the mean."""
        axes, = [one for one in figure.axes if one.get_ylabel().startswith(label)]
        return [line for line in axes.get_lines() if line.get_label()[0] == "$" or label.startswith("strain")][0]

    def test_a_rate_that_follows_a_stress(self):
        source = self.drawn("stress", stress=[1e-3, 2e-3], time=2000.0)
        figure = plots.run(source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", r"$\sigma$ = 0.001, 0.002", "3 replicas", "dotted: held")
        rate = self.line(figure, r"$\dot\gamma$")
        np.testing.assert_allclose(rate.get_ydata(), source.series["strain_rate"].mean(axis=0))
        np.testing.assert_allclose(rate.get_xdata(), source.series["time"][0])
        strain = self.line(figure, "strain")
        np.testing.assert_allclose(strain.get_ydata(), source.series["strain"][0])
        wanted = [line for line in figure.axes[0].get_lines() if line.get_color() == "black"
                  and set(line.get_ydata()) == {1e-3, 2e-3}]
        self.assertEqual(len(wanted), 1)
        half = len(wanted[0].get_ydata()) // 2
        self.assertEqual(set(wanted[0].get_ydata()[:half]), {1e-3})

    def test_a_box_that_follows_a_pressure(self):
        source = self.drawn("pressure", pressure=5e-3, strain=4.0)
        figure = plots.run(source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "$p$ = 0.005", "3 replicas")
        phi = self.line(figure, r"$\phi$")
        np.testing.assert_allclose(phi.get_ydata(), source.series["packing_fraction"].mean(axis=0))
        self.assertNotIn(r"\phi = 0.8", figure.texts[0].get_text())


class Oscillations(Pictures):
    def drawn(self, **changes):
        scene = {**SCENE, "output": {"plot": False},
                 "shear": {"protocol": "oscillate", "amplitude": 0.125, "period": 64.0, "cycles": 6, "cycle_pieces": 32,
                           "discard": 0.5}}
        return run(scene, self.folder / "oscillation", **{"disks__model": "CD", **changes})

    def test_the_mean_cycle_is_that_of_the_program(self):
        for replicas in (1, 3):
            source = self.drawn(disks__replicas=replicas, disks__seed=replicas)
            figure = plots.run(source)
            self.readable(figure)
            self.has_scene(figure, "model CD", r"$\gamma_0 = 0.125$", "T = $64", "6 cycles", "grey: not measured")
            wave = source.oscillation
            for axes, x in ((figure.axes[0], wave.strain), (figure.axes[1], wave.strain_rate * 64 / (2 * np.pi * 0.125))):
                mean = [line for line in axes.get_lines() if line.get_label() == "their mean"][0]
                np.testing.assert_allclose(mean.get_ydata()[:-1], wave.sigma, rtol=1e-9)
                np.testing.assert_allclose(mean.get_xdata()[:-1], x, rtol=1e-9, atol=1e-9 * np.abs(x).max())
                self.assertEqual(mean.get_xdata()[0], mean.get_xdata()[-1])
            moduli, = [axes for axes in figure.axes if axes.get_ylabel().startswith("$G'$")]
            labelled = {line.get_label()[:5]: line.get_ydata() for line in moduli.get_lines() if line.get_label()[0] == "$"}
            self.assertEqual(set(labelled), {"$G''$", "$G'$ "})
            for label, name in (("$G'$ ", "G_storage"), ("$G''$", "G_loss")):
                self.assertEqual(len(labelled[label]), 6)
                self.assertAlmostEqual(labelled[label][3:].mean() / source[name].mean, 1, delta=0.02)
            shutil.rmtree(source.folder)

    def test_strain_and_phase_are_those_of_the_samples(self):
        """With a sample a window, which is not at its middle."""
        source = self.drawn(shear__cycle_pieces=16, measure__every=64)
        figure = plots.run(source)
        wave = source.oscillation
        mean, = [line for line in figure.axes[0].get_lines() if line.get_label() == "their mean"]
        strain, sigma = mean.get_xdata(), mean.get_ydata()
        np.testing.assert_allclose(strain[:-1], wave.strain, rtol=1e-9)
        area = np.sum(np.diff(strain) * (sigma[1:] + sigma[:-1]) / 2)
        self.assertAlmostEqual(area / (np.pi * 0.125**2) / source["G_loss"].mean, 1, delta=0.1)
        stress, = [axes for axes in figure.axes if axes.get_ylabel().startswith(r"$\sigma$") and axes.get_xlim() == (0, 1)]
        phase = stress.get_lines()[0].get_xdata()
        ends = np.arange(17) / 16
        np.testing.assert_allclose(np.interp(phase, ends, 0.125 * np.sin(2 * np.pi * ends)), wave.strain, atol=1e-9)

    def test_while_it_runs(self):
        source = self.drawn()
        shutil.copytree(source.folder, self.folder / "begun")
        (self.folder / "begun/summary.json").unlink()
        for windows, words in ((80, "harmonics come with the end of the run"), (20, "no cycle is finished yet")):
            with h5py.File(self.folder / "begun/result.h5", "r+") as file:
                for name in list(file["series"]):
                    values, attributes = file["series"][name][:windows], dict(file["series"][name].attrs)
                    del file["series"][name]
                    file["series"][name] = values
                    file["series"][name].attrs["unit"] = attributes["unit"]
            figure = plots.run(self.folder / "begun")
            self.readable(figure)
            self.assertIn(words, [text.get_text() for axes in figure.axes for text in axes.texts])

    def test_for_a_journal(self):
        figure = plots.run(self.drawn(), style="paper", panels="ah")
        self.assertEqual(len(figure.axes), 2)


class Ramps(Pictures):
    @classmethod
    def setUpClass(cls):
        cls.source = run(RAMP, FOLDER / "ramp")

    def lines(self, axes):
        """Of passes: those that have a point of the series."""
        return [line for line in axes.get_lines() if line.get_marker() == "o"]

    def test_a_line_a_pass_and_one_colour_a_cycle(self):
        figure = plots.run(self.source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "3 cycles", " to ")
        for axes in figure.axes:
            lines = self.lines(axes)
            self.assertEqual(len(lines), 6)
            colours = [line.get_color() for line in lines]
            self.assertEqual(colours[::2], colours[1::2])
            self.assertEqual(len(set(colours)), 3)
            for line, way in zip(lines, itertools.cycle((1, -1))):
                rate = line.get_xdata()
                self.assertTrue((way * np.diff(rate) > 0).all(), rate)
                self.assertEqual(line.get_linestyle() == "-", way > 0)
        direction, sigma = self.source.series["direction"], self.source.series["sigma"]
        drawn = np.concatenate([line.get_ydata() for line in self.lines(figure.axes[0])])
        wanted = sigma[direction != 0]
        np.testing.assert_array_equal(drawn[np.isfinite(drawn)], wanted[wanted > 0])
        legend = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
        self.assertEqual(legend[:5], ["cycle 1", "cycle 2", "cycle 3", "up", "down"])
        self.assertEqual([axes.get_legend() for axes in figure.axes[1:]], [None] * 4)
        self.assertEqual(figure.axes[0].get_ylabel(), r"$\sigma$  $[m/\tau_e^2]$")

    def test_many_cycles_and_an_end_on_the_way(self):
        """Of a made series: twelve cycles, the last without its way down; two replicas."""
        folder = self.folder / "made"
        folder.mkdir()
        way = np.concatenate([np.zeros(3), *(np.full(8, sign) for sign in [1, -1] * 11 + [1])])
        rate = np.exp(np.cumsum(0.3 * way))
        with h5py.File(folder / "result.h5", "w") as file:
            for name in ("direction", "strain_rate", "strain", "sigma", "p", "B_p", "eta_p", "Z", "R_v"):
                values = {"direction": way, "strain_rate": rate, "strain": np.arange(float(len(way)))}.get(name, rate**1.5)
                file[f"series/{name}"] = np.stack([values, values])
            file["series"].attrs["discarded_windows"] = 3
            file.attrs["model"] = "CD"
        figure = plots.run(folder)
        self.readable(figure)
        lines = self.lines(figure.axes[0])
        self.assertEqual(len(lines), 2 * 23)
        self.assertEqual(len({line.get_color() for line in lines}), 12)
        legend = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
        self.assertEqual(legend[:4], ["cycle 1", "cycle 12", "up", "down"])
        self.assertIn("12 cycles", scene_text(figure))


class Frames(Pictures):
    @classmethod
    def setUpClass(cls):
        cls.source = run(SCENE, FOLDER / "frames", disks__count=200, measure={
            "contacts": True, "rotation": True, "profiles": True, "fields": True, "frame_strain": 2.0**-5})

    def test_histograms(self):
        figure = plots.histograms(self.source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "$N = 200$", "equal masses")
        self.assertEqual([axes.get_xlabel() for axes in figure.axes],
                         [r"collision angle $\theta$  [degrees]", r"duration of contacts $\tau_{dur}$  $[\tau_e]$",
                          "disks in the cluster where a contact begins", r"spin $\dot\theta/\dot\gamma$",
                          r"$\phi$ within $4\,d_s$", r"$\dot\gamma$ within $4\,d_s$ over that of the box"])
        found = self.source.histograms
        for patch, name in zip(figure.axes[0].patches, ("theta_begin", "theta_end")):
            np.testing.assert_array_equal(patch.get_data().values, found[name].density)
        durations, = figure.axes[1].patches
        values, edges, _ = durations.get_data()
        self.assertAlmostEqual(np.sum(values * np.diff(np.log10(edges))), 1)
        self.assertIn("mean ", figure.axes[1].get_legend().get_texts()[0].get_text())
        spins, = figure.axes[3].patches
        values, edges, _ = spins.get_data()
        self.assertAlmostEqual(np.sum(values * np.diff(edges)), 1)  # joined bins keep their share
        self.assertEqual(figure.axes[3].get_lines()[0].get_xdata()[0], -0.5)

    def test_only_what_is_there(self):
        source = made(disks__model="CD_n", measure__contacts=True)
        figure = plots.histograms(source)
        self.readable(figure)
        self.assertEqual(len(figure.axes), 3)
        with self.assertRaisesRegex(bagnold.InputError, "has no /histograms: set measure.contacts"):
            plots.histograms(made())
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        plots.draw_to(source.folder, self.folder, frames=True)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["histograms.png"])

    def test_profiles_and_fields(self):
        for draw in (plots.profiles, plots.fields):
            figure = draw(self.source)
            self.readable(figure)
            self.has_scene(figure, "model CD_rot", "$N = 200$", r"\dot\gamma\tau_e = ", "equal masses")
        self.assertIn("last frame", scene_text(figure))
        self.assertIn("strain 1 ", scene_text(figure))


    def test_boxes_that_are_not_square(self):
        """Boxes are drawn in their shape, and nothing is written upon anything."""
        for aspect in (0.3, 3.0):
            source = made(disks__box_aspect=aspect, disks__count=1024, shear__strain=2.0**-4, measure__fields=True,
                          measure__frame_strain=2.0**-6, output__sample_strain=2.0**-6)
            self.readable(plots.run(source))
            figure = plots.fields(source)
            self.readable(figure)
            boxes = [axes.get_window_extent() for axes in figure.axes if axes.get_xlabel().startswith("$x$")]
            self.assertEqual(len(boxes), 2)
            for box in boxes:
                self.assertAlmostEqual(box.height / box.width, aspect, delta=1e-6 * aspect)


class Sweeps(Pictures):
    def curves(self, axes):
        """Of curves with points: (x, y)."""
        return [container.lines[0].get_data() for container in axes.containers]

    def test_a_cascade_is_a_flow_curve(self):
        rates = [2.0**-6, 2.0**-7, 2.0**-8]
        source = run({**SCENE, "shear": {"protocol": "cascade", "strain_rates": rates, "strain": 0.5}}, FOLDER / "cascade")
        figure = plots.sweep(source.folder)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "$N = 64$", r"$\phi = 0.84$", "$Q = 1$", "equal masses", "3 of 3 points")
        self.assertEqual(self.labels(figure), [r"$\sigma$  $[m/\tau_e^2]$", r"$p$  $[m/\tau_e^2]$", "$B_p$", r"$\eta_p$",
                                               r"$\mu = \sigma/p$", "$Z$"])
        table = bagnold.sweep(source.folder)
        for axes, name in zip(figure.axes, ("sigma", "p", "B_p", "eta_p", "mu", "Z")):
            (x, y), = self.curves(axes)
            np.testing.assert_array_equal(x, rates[::-1])
            np.testing.assert_array_equal(y, table[name][::-1])
            self.assertEqual(axes.get_xscale(), "log")
            self.assertEqual(axes.get_xlabel(), r"strain rate $\dot\gamma\tau_e$")
        plots.draw_to(source.folder, self.folder / "x.png")
        self.assertTrue((self.folder / "x.png").exists())

    def made_sweep(self, keys, points):
        """A table as of a sweep without its points' folders; p = 3 times the first key, of two of one seed apart by 1."""
        with h5py.File(self.folder / "sweep.h5", "w") as file:
            text = h5py.string_dtype()
            for name in ("folder", "scene"):
                file[f"points/{name}"] = np.array(["x", '[disks]\nmodel = "CD_n"\n'][name == "scene"], dtype=object
                                                  ).repeat(len(points)).astype(text)
            file["status"] = np.array(["done"] * len(points), dtype=object).astype(text)
            file["warnings"] = np.array([""] * len(points), dtype=object).astype(text)
            for k, key in enumerate(keys):
                column = [point[k] for point in points]
                file[f"points/{key}"] = column if isinstance(column[0], float) else np.array(column, dtype=object).astype(text)
            seeds = [point[keys.index("disks.seed")] if "disks.seed" in keys else 1.0 for point in points]
            numbers = [point[0] if isinstance(point[0], float) else float(len(point[0])) for point in points]
            for name in ("p", "mu"):
                file[f"observables/{name}"] = 3 * np.array(numbers) + np.array(seeds)
                file[f"observables/{name}_error"] = np.full(len(points), np.nan)
        return plots.sweep(self.folder)

    def test_a_curve_for_the_other_keys_and_a_mean_over_seeds(self):
        points = list(itertools.product([1.0, 10.0, 100.0], [0.7, 0.8], [1.0, 2.0]))
        figure = self.made_sweep(["disks.elasticity", "disks.packing_fraction", "disks.seed"], points)
        self.readable(figure)
        self.has_scene(figure, "model CD_n", "12 of 12 points")
        self.assertEqual([axes.get_ylabel() for axes in figure.axes], [r"$p$  $[m/\tau_e^2]$", r"$\mu = \sigma/p$"])
        self.assertEqual([text.get_text() for text in figure.legends[0].get_texts()], [r"$\phi = 0.7$", r"$\phi = 0.8$"])
        for x, y in self.curves(figure.axes[0]):
            np.testing.assert_array_equal(x, [1, 10, 100])
            np.testing.assert_array_equal(y, [4.5, 31.5, 301.5])
        bars = figure.axes[0].containers[0].lines[2][0].get_segments()
        np.testing.assert_allclose([bar[1, 1] - bar[0, 1] for bar in bars], 1)  # twice 0.5, the error of two that differ by 1

    def test_a_key_that_follows_tells_no_curves_apart(self):
        rates, tied = [1.0, 0.1, 0.01, 0.001], ["shear.strain_rate", "shear.strain", "disks.packing_fraction"]
        for strains in ([20.0, 21.0, 22.0, 23.0], [20.0, 20.0, 10.0, 10.0]):
            points = [(rate, strain, phi) for rate, strain in zip(rates, strains) for phi in (0.8, 0.82)]
            figure = self.made_sweep(tied, points)
            self.readable(figure)
            names = [text.get_text() for text in figure.legends[0].get_texts()]
            self.assertEqual(names, [r"$\phi = 0.8$", r"$\phi = 0.82$"])
            for x, _ in self.curves(figure.axes[0]):
                np.testing.assert_array_equal(x, rates[::-1])
        for fractions, curves in (([0.8, 0.81, 0.82, 0.83], [4]), ([0.8, 0.8, 0.82, 0.82], [2, 2])):  # physics: one to one
            figure = self.made_sweep(tied[::2], list(zip(rates, fractions)))
            self.assertEqual([len(x) for x, _ in self.curves(figure.axes[0])], curves)

    def test_keys_of_physics_are_those_of_analyse(self):
        text = (SOURCE / "src/analysis/sweep_table.cpp").read_text(encoding="utf-8")
        named, = re.findall(r"of_shear\[\] = \{(.*?)\}", text, re.S)
        self.assertEqual(sorted(re.findall(r'"(\w+)"', named)), sorted(plots.sweep_page.OF_PHYSICS))

    def test_many_curves_have_two_names(self):
        points = [(float(q), phi) for phi in np.linspace(0.6, 0.8, 20).tolist() for q in range(1, 31)]
        figure = self.made_sweep(["disks.elasticity", "disks.packing_fraction"], points)
        self.readable(figure)
        self.assertEqual([text.get_text() for text in figure.legends[0].get_texts()], [r"$\phi = 0.6$", r"$\phi = 0.8$"])

    def test_texts_and_seeds_alone(self):
        figure = self.made_sweep(["disks.model"], [("CD",), ("CD_n",), ("CD_rot",)])
        self.readable(figure)
        self.assertEqual([text.get_text() for text in figure.axes[0].get_xticklabels()], ["CD", "CD_n", "CD_rot"])
        figure = self.made_sweep(["disks.seed"], [(1.0,), (2.0,), (3.0,)])
        self.readable(figure)
        self.assertEqual(figure.axes[0].get_xlabel(), "disks.seed")

    def test_a_real_one(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            source = bagnold.sweep_file({**SCENE, "sweep": {"grid": {"disks.packing_fraction": [0.8, 0.82], "disks.seed": [1, 2]}}},
                                        self.folder / "sweep", progress=False, jobs=1)
        figure = plots.sweep(source)
        self.readable(figure)
        self.has_scene(figure, "model CD_rot", "$N = 64$", "$Q = 1$", "4 of 4 points", f"bagnold {bagnold.__version__}")
        self.assertEqual({axes.get_xlabel() for axes in figure.axes}, {r"$\phi$"})
        self.assertEqual(len(figure.axes), 6)


class Analyses(unittest.TestCase):
    def setUp(self):
        self.figure, self.axes = plt.subplots()
        self.addCleanup(plt.close, "all")

    def rows(self, y, what="data", curve="", x=None):
        x = range(1, len(y) + 1) if x is None else x
        return [{"curve": curve, "what": what, "x": float(at), "x_error": np.nan, "y": float(value), "y_error": np.nan,
                 "x_scale": "log", "y_scale": "log", "x_name": "Q", "y_name": "mu"} for at, value in zip(x, y)]

    def test_limits_are_those_of_the_axes_not_of_the_table(self):
        from bagnold.plots.analysis_page import keep_in_view
        rows = self.rows([-2.0, -1.0, 0.5, 4.0])
        keep_in_view(self.axes, rows)
        low, high = self.axes.get_ylim()
        self.assertTrue(-2.5 < low < -2 and 4 < high < 4.5, (low, high))
        self.axes.set_yscale("log")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            keep_in_view(self.axes, [row | {"y_scale": "linear"} for row in rows])
        low, high = self.axes.get_ylim()
        self.assertTrue(0.4 < low < 0.5 and 4 < high < 5, (low, high))

    def test_marks_are_in_view(self):
        from bagnold.plots.analysis_page import keep_in_view
        keep_in_view(self.axes, self.rows([1.0, 2.0, 3.0]) + self.rows([3.5, 400.0], "mark"))
        self.assertTrue(3.5 < self.axes.get_ylim()[1] < 6)

    def test_two_points_are_no_curve(self):
        from bagnold.plots.analysis_page import draw_curve
        styles = []
        for count, joined in ((3, None), (2, None), (2, True), (3, False)):
            draw_curve(self.axes, self.rows(range(1, count + 1)), "black", "o", None, joined=joined)
            styles.append(self.axes.lines[-1].get_linestyle())
        self.assertEqual(styles, ["-", "None", "-", "None"])


class PaperFigures(unittest.TestCase):
    """What bagnold.plots.figure_page does of its own."""

    def rows(self, names, what="data"):
        return [{"curve": name, "what": what, "x": float(x), "x_error": np.nan, "y": float(y), "y_error": np.nan,
                 "x_scale": "log", "y_scale": "log", "x_name": "Q", "y_name": "mu"}
                for name in names for x, y in ((1, 1), (10, 0.1), (100, 0.01))]

    def drawn(self, panel, rows, before=()):
        from bagnold.plots import figure_page
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        figure_page.draw_analysis(axes, {"rows": rows, "number": 1 if before else 0, "before": list(before)} | panel, [])
        return axes

    def test_curves_stand_by_their_numbers(self):
        from bagnold.plots.figure_page import curves_in
        rows = self.rows(["phi = 0.78", "phi = 0.6", "phi = 0.835", "phi = 0.7"])
        self.assertEqual(curves_in(rows), ["phi = 0.6", "phi = 0.7", "phi = 0.78", "phi = 0.835"])
        falling = ["gammadot = 0.001", "gammadot = 1e-05"]
        self.assertEqual(curves_in(self.rows(falling)), falling)
        mixed = ["phi_up", "N = 3", "N = 1"]
        self.assertEqual(curves_in(self.rows(mixed)), mixed)

    def test_one_curve_has_one_colour(self):
        before = self.rows(["phi = 0.6", "phi = 0.7", "phi = 0.8"])
        colours = [line.get_color() for line in self.drawn({}, before).lines if line.get_marker() == "D"]
        other = self.drawn({"over": True}, self.rows(["phi = 0.6", "phi = 0.8"]), before)
        self.assertIn(colours[0], [line.get_color() for line in other.lines])

    def test_boundaries_have_the_names_of_the_papers(self):
        names = {self.drawn({}, self.rows([name])).get_legend_handles_labels()[1][0]
                 for name in ("phi_up", "phi_1")}
        self.assertEqual(names, {r"$\phi$$_{B}$"})
        axes = self.drawn({"name": "1e-6"}, self.rows(["Q_down"]))
        self.assertEqual(axes.get_legend_handles_labels()[1], ["1e-6"])

    def test_numbers_of_curves_have_few_digits(self):
        from bagnold.plots.analysis_page import pretty
        self.assertTrue(pretty("Q = 5, gammadot = 2.1544346900318822e-06").endswith("= 2.154e-06"))
        self.assertTrue(pretty("phi = 0.79845").endswith("= 0.79845"))
        self.assertTrue(pretty("law = constant_pressure").endswith("= constant_pressure"))

    def test_slopes_are_written(self):
        axes = self.drawn({"only": ["fit"], "slope": "above", "dashed": True}, self.rows([""], "fit"))
        self.assertEqual([text.get_text() for text in axes.texts], ["1.0"])
        self.assertTrue(axes.lines[0].is_dashed())

    def test_a_panel_without_data_says_so(self):
        from bagnold.plots import figure_page
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "none.csv").write_text("")
            figure = figure_page.draw({"name": "P", "panel": [
                {"series": "sigma", "folder": ["nowhere"]}, {"analyse": "kink", "drawn": "none.csv"}]}, folder)
        self.addCleanup(plt.close, figure)
        self.assertEqual([[text.get_text() for text in axes.texts] for axes in figure.axes],
                         [["no data yet"], ["nothing found: kink"]])

    def test_marks_are_joined_kink_by_kink(self):
        from bagnold.plots.figure_page import join_marks
        rows = [{"what": "mark", "curve": curve, "x": x, "y": y} for curve, places in
                (("a", ((1, 1), (2, 2))), ("b", ((np.nan, np.nan), (2.5, 3)))) for x, y in places]
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        join_marks(axes, rows)
        self.assertEqual([list(line.get_xdata()) for line in axes.lines], [[1], [2, 2.5]])

    def test_edges_of_bands(self):
        from bagnold.plots.figure_data import band_edges
        y = np.arange(0.5, 300, 1.5)
        fast = np.abs(y - 150) < 60
        noise = 0.4 * np.sin(1.7 * y) + np.where(np.abs(y - 20) < 4, 0.4, 0)
        for sign in (1, -1):
            edges = band_edges(y, sign * (np.where(fast, 1.5, -0.6) + noise), 0.0)
            np.testing.assert_allclose(edges, [90, 210], atol=6)
        self.assertEqual(len(band_edges(y, np.ones_like(y), 0.0)), 0)


class Ticks(unittest.TestCase):
    def test_logarithmic_axes_have_two_numbers(self):
        from bagnold.plots.labels import log_ticks
        for low, high in ((1.0, 1.3), (3.1, 4.9), (1.0, 2.5), (0.6, 3.0), (1e-5, 3e-4), (2e-3, 9e-1), (1e-8, 1e3)):
            figure, axes = plt.subplots()
            axes.set_yscale("log")
            axes.set_ylim(low, high)
            log_ticks(axes.yaxis)
            figure.canvas.draw()
            shown = [text for text, place in zip(axes.get_yticklabels(), axes.get_yticks())
                     if low <= place <= high and text.get_text()]
            self.assertTrue(2 <= len(shown) <= 12, (low, high, [text.get_text() for text in shown]))
            plt.close(figure)


class RampMaps(Pictures):
    """Profiles and histograms of a ramp: a column for each frame."""

    def test_profiles_and_histograms(self):
        r = run(RAMP, self.folder / "ramp", measure__profiles=True, measure__rotation=True, measure__contacts=True,
                measure__frame_decades=0.0625)
        frames = len(r.samples["ramp_frames"]["strain"])
        self.assertGreater(frames, 50)
        for draw, wanted in ((plots.profiles, (r"$\phi(y)$", r"$\sigma(y)$ over its mean")),
                             (plots.histograms, (r"$\tau_{dur}$  $[\tau_e]$", r"$\dot\theta/\dot\gamma$"))):
            figure = draw(r)
            self.readable(figure)
            self.has_scene(figure, "model CD_rot", "$N = 64$", " to ", "and back")
            for label in wanted:
                self.assertIn(label, self.labels(figure))
            maps = [mesh for axes in figure.axes for mesh in axes.collections if isinstance(mesh, QuadMesh)
                    and mesh.get_array().size % frames == 0]
            self.assertGreaterEqual(len(maps), 3)


class Papers(Pictures):
    """style="paper": the width of a column, letters of 6 points and more, panels with letters, no heading."""

    def smallest(self, figure):
        return min(one.get_fontsize() for one in figure.findobj(Text) if one.get_visible() and one.get_text().strip())

    def test_a_run(self):
        figure = plots.run(made(), style="paper")
        self.assertEqual(figure.get_figwidth(), 7.0)  # of more than three panels
        self.assertEqual(figure.texts, [])
        self.readable(figure)
        self.assertGreaterEqual(self.smallest(figure), 6)

    def test_some_panels(self):
        figure = plots.run(made(), style="paper", panels="ac")
        self.assertEqual((figure.get_figwidth(), len(figure.axes)), (3.375, 2))
        self.readable(figure)
        self.assertEqual([axes.get_xlabel() for axes in figure.axes], [r"strain $\gamma$"] * 2)
        self.assertEqual(figure.axes[0].get_ylabel(), r"stress  $[\mathrm{m/\tau_e^2}]$")
        self.assertEqual([axes.texts[-1].get_text() for axes in figure.axes], ["(a)", "(b)"])
        for wrong in ({"style": "poster"}, {"style": "paper", "panels": "az"}, {"panels": "a"}):
            with self.assertRaises(bagnold.InputError):
                plots.run(made(), **wrong)

    def test_fonts_of_a_pdf_are_truetype(self):
        plots.save(plots.run(made(), style="paper", panels="a"), self.folder / "one.pdf")
        content = (self.folder / "one.pdf").read_bytes()
        self.assertIn(b"/FontFile2", content)
        self.assertNotIn(b"/Type3", content)

    def test_a_packing(self):
        figure = plots.packing(made(), style="paper")
        self.assertEqual(figure.get_figwidth(), 3.375)


if __name__ == "__main__":
    unittest.main()
