# SPDX-License-Identifier: BSD-3-Clause
"""What the recipe of each figure draws, from data made by known laws: axes and values.

AXES is written from the papers: for each panel what goes to the right and upwards. A drawn point must
be a state that was made, at its values, or lie where the laws have what an analysis looks for."""

import json
import unittest

import numpy as np

import made_figures as made
import python_package  # noqa: F401  bagnold_package
from bagnold import SOURCE, CliTest, environment

from bagnold_package.plots import figure_page
from bagnold_package.plots.analysis_page import label

FIGURES = SOURCE / "inputs/figures/figures.toml"
PHI, Q, RATE = "disks.packing_fraction", "disks.elasticity", "shear.strain_rate"


class Found:
    """Points that an analysis finds: `near(x, y)` tells whether one is right."""

    def __init__(self, x, y, near):
        self.x, self.y, self.near = x, y, near


def close(one, other, relative):
    return abs(one - other) <= relative * abs(other)


def at(truth, relative):
    return lambda x, y: close(y, truth(x), relative)


def boundary(x, _):
    """A boundary of the coexistence region, or the contour of constant pressure, at (phi, rate)."""
    return min(abs(x - made.LOW), abs(x - made.HIGH)) < 0.003 or 0.73 < x < 0.83


def on_boundary(upwards):
    def near(x, y):
        for rate in (1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 3e-5, 2e-5, 1e-5):
            for phi in (made.LOW, made.HIGH):
                state = made.bands(phi, 1.0, rate)
                if close(x, state["p"], 0.8) and close(y, rate if upwards == "gammadot" else
                                                       state["sigma"], 0.9):
                    return True
        return False
    return near


def contour_rate(phi):
    return np.sqrt(2e-5 / made.bands(phi, 1.0, 1.0)["p"])


def on_contour(x, y):
    """(rate, mu): is there a phi of the sweep with both?"""
    return any(close(x, contour_rate(phi), 0.05)
               and close(y, made.bands(phi, 1.0, contour_rate(phi))["mu"], 0.02)
               for phi in (0.74, 0.76, 0.77, 0.776, 0.78, 0.784, 0.788, 0.792, 0.796, 0.798, 0.8, 0.802,
                           0.804, 0.808, 0.812, 0.82))


def transition(phi, q):
    return close(q, made.rot_q_c(phi), 0.15) or abs(phi - made.rot_phi_c(q)) < 0.004


p1_place = Found(PHI, "Q_star", at(made.p1_q_star, 0.05))
theta = [("theta", None)]
AXES = {
    "P1-1": [(Q, "B_p_el"), (Q, "B_sigma_el")],
    "P1-2": [(Q, "B_p_dis"), (Q, "B_sigma_dis")],
    "P1-3": [(Q, "B_p_kin"), (Q, "B_sigma_kin")],
    "P1-4": [(Q, "B_p_kin/B_p"), (Q, "|B_sigma_kin/B_sigma|")],
    "P1-5": [p1_place, Found(PHI, "q", lambda phi, q: close(q, 1.3, 0.05) or close(q, 0.9 * 1.3, 0.05))],
    "P1-6": [(PHI, "B_p"), (PHI, "B_sigma")],
    "P1-7": [("phi_J-phi", "B_p"), ("phi_J-phi", "B_sigma")],
    "P1-8": [(PHI, "mu")],
    "P1-11": [(Q, "tau_dur"), (Q, "nu_coll/shear.strain_rate")],
    "P1-12": [(Q, "Z")],
    "P1-13": [(RATE, "Z"), (Q, "Z/shear.strain_rate")],
    "P1-14": [("I", PHI), ("I", "phi_J-phi")],
    "P1-15": [("I", "mu")],
    "P1-16": [(Q, "delta_p/p")],
    "P1-17": [(Q, "sigma_dev/sigma-1")],
    "P2-1": [(Q, "p_el")],
    "P2-3": [Found(PHI, "Q_c", at(made.cd_q_c, 0.3))],
    "P2-4": [(Q, "Z")],
    "P2-10": [(Q, "p_el")],
    "P2-12": [(Q, "Z")],
    "P2-15": [(PHI, "p_el")],
    "P2-17": [Found(PHI, "Q_c", transition)],
    "P2-20": [(PHI, "spin_mean"), (PHI, "spin_var")],
    "P2-22": [(PHI, "p_el")],
    "P2-23": [(PHI, "mu")],
    "P2-24": [(PHI, "R_v")],
    "P2-25": [Found(PHI, "gammadot", lambda phi, rate: abs(phi - made.LOW) < 0.003
                    or abs(phi - made.HIGH) < 0.003 or close(rate, contour_rate(phi), 0.05))],
    "P2-26": [Found("p", "gammadot", on_boundary("gammadot"))],
    "P2-29": [Found("p", "sigma", on_boundary("sigma"))],
    "P2-30": [(RATE, "sigma")],
    "P2-34": [Found(PHI, "mu", lambda phi, mu: close(
        mu, made.bands(phi, 1.0, contour_rate(phi))["mu"], 0.02)), Found(RATE, "mu", on_contour)],
    "P2-32": [Found(Q, None, lambda x, y: True)] * 2,
    "P2-33": [Found(PHI, None, lambda x, y: True)] * 2,
    "P2-35": [Found(PHI, "gammadot", lambda phi, rate: min(
        abs(phi - made.LOW), abs(phi - made.HIGH), abs(phi - 0.809), abs(phi - 0.788)) < 0.004)],
    "P2-36": [(PHI, "R_v")],
}
for number, y in (("2", ("eta_p_el", "B_p_el")), ("6", ("tau_dur", "nu_coll/shear.strain_rate")),
                  ("11", ("eta_p_el", "B_p_el")), ("14", ("tau_dur", "nu_coll/shear.strain_rate"))):
    AXES[f"P2-{number}"] = [(Q, y[0]), (Q, y[1])] * 2
AXES["P2-5"] = AXES["P2-13"] = [(Q, "Z")] * 2
AXES["P2-16"] = [(PHI, "eta_p_el"), (PHI, "B_p_el")] * 2
OTHERS = {  # panels that show more than averages: labels of their axes
    "P1-10": 6, "P2-8": 2, "P2-9": 2, "P2-18": 2, "P2-19": 2, "P2-21": 6, "P2-27": 4, "P2-28": 9, "P2-31": 2}


def value(state, name):
    """A quantity of a made state; the names of the figures, and three of their own."""
    if name.startswith("|"):
        return abs(value(state, name.strip("|")))
    if name == "sigma_dev/sigma-1":
        return state["sigma_dev"] / state["sigma"] - 1
    if name == "phi_J-phi":
        return 0.84335 - state[PHI]
    if "/" in name:
        above, below = name.split("/")
        return value(state, above) / value(state, below)
    return state[name]


def drawn(axes):
    """Points of an axes: (x, y) of all that is drawn with a marker."""
    points = []
    for line in axes.lines:
        is_place = line.get_markersize() == 9  # a kink or a peak, marked
        if line.get_marker() not in ("None", None, "", " ", "*", "_", "|", 2, 3) and not is_place:
            points += list(np.column_stack(line.get_data()))
    return [point for point in points if np.isfinite(point).all()]


class RecipesTest(CliTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        figure_page.plt.rcParams.update({"figure.max_open_warning": 0})

    def setUp(self):
        super().setUp()
        folder = self.folder / "figures"
        folder.mkdir()
        for path in FIGURES.parent.glob("*.toml"):
            (folder / path.name).write_text(path.read_text())
        for kind in ("crossover", "divergence", "exponents", "friction-law", "jump", "kink", "transition",
                     "constant-pressure", "peak"):  # no bootstrap: values are looked at
            text = (folder / FIGURES.name).read_text()
            (folder / FIGURES.name).write_text(text.replace(f'= "{kind} ', f'= "{kind} --resamples 0 '))
        self.figures = folder / FIGURES.name
        self.data = self.folder / "data"
        self.data.mkdir()
        self.made = made.write_tables(FIGURES, self.data)

    def draw(self, name):
        result = self.bagnold("figure", name, "--figures", self.figures, "--data", self.data, "--out", "out",
                              env=environment() | {"BAGNOLD_PYTHON": "/bin/true"})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        folder = self.folder / "out" / name
        recipe = json.loads((folder / "recipe.json").read_text())
        figure = figure_page.draw(recipe, str(folder))
        axes = [a for a in figure.axes if a.axison and a.get_label() != "<colorbar>"]
        for one in axes:
            for text in one.texts:
                self.assertNotIn("no data", text.get_text(), name)
                self.assertNotIn("nothing found", text.get_text(), name)
        states = [state for panel in recipe["panel"] for data in panel["data"] for state in self.made[data]]
        # N L_y/L_x goes as L_y^2, the length that bands feel
        sizes = {state["disks.count"] * state.get("disks.box_aspect", 1) for state in states}
        self.assertEqual(len(sizes), 2 if name == "P2-36" else 1, f"{name} mixes sizes {sizes}")
        stated = folder / "stated.csv"
        if stated.exists():
            lines = [line for line in stated.read_text().splitlines() if "phi_N at 5e-6" not in line]
            self.assertNotIn("not found", "\n".join(lines), name)
        figure_page.plt.close(figure)
        return axes, states

    def check(self, axes, wanted, states, name):
        if isinstance(wanted, Found):
            x, y = wanted.x, wanted.y
        else:
            x, y = wanted
            pairs = np.array([(value(s, x), value(s, y)) for s in states], float)
        if y and "/" not in y and "|" not in y and "," not in axes.get_ylabel():
            self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), (label(x), label(y)), name)
        points = drawn(axes)
        self.assertGreaterEqual(len(points), 4, name)
        for point in points:
            if isinstance(wanted, Found):
                self.assertTrue(wanted.near(*point), (name, x, y, point))
            else:
                off = np.abs(pairs - point) / (1e-300 + np.abs(point))
                self.assertLess(off.max(axis=1).min(), 2e-3, (name, x, y, point))

    def test_axes_and_values(self):
        for name, panels in AXES.items():
            with self.subTest(figure=name):
                axes, states = self.draw(name)
                self.assertEqual(len(axes), len(panels))
                for one, wanted in zip(axes, panels):
                    self.check(one, wanted, states, name)

    def test_those_that_show_more_than_averages(self):
        for name, count in OTHERS.items():
            with self.subTest(figure=name):
                axes, _ = self.draw(name)
                self.assertEqual(len(axes), count)

    def test_local_fields_fill_their_box(self):
        axes = self.draw("P2-27")[0]  # made 100 wide
        self.assertEqual([(one.get_xlim(), one.get_ylim()) for one in axes],
                         2 * [((0, 100), (0, 100))] + 2 * [((0, 100), (0, 800))])

    def test_what_the_papers_draw_over_the_points(self):
        def black(axes):
            return [line.get_data() for line in axes.lines if line.get_color() == "black"]

        def upright(axes):
            return [line.get_xdata()[0] for line in axes.lines if list(line.get_ydata()) == [0, 1]]

        (kinks,), _ = self.draw("P2-22")
        for (x, _), truth in zip(black(kinks), (made.LOW, made.HIGH), strict=True):
            np.testing.assert_allclose(x, truth, atol=1e-3)
        for name, rates in (("P2-22", 5), ("P2-23", 5)):
            (axes,), _ = self.draw(name)
            marks = [line.get_xdata()[0] for line in axes.lines if line.get_markersize() == 9]
            self.assertGreaterEqual(len(marks), 2 * rates)
            np.testing.assert_allclose(sorted(marks), [made.LOW] * (len(marks) // 2) + [made.HIGH] * (len(marks) // 2),
                                       atol=1e-3)
        (phases,), _ = self.draw("P2-25")
        names = [name.split(", ")[-1] for name in phases.get_legend_handles_labels()[1]]
        self.assertEqual(set(names[:-1]), {"$\\phi$$_{B}$", "$\\phi$$_{N}$"})
        ((x,), (y,)), = [line.get_data() for line in phases.lines if line.get_marker() == "*"]
        self.assertAlmostEqual(x, (made.LOW + made.HIGH) / 2, 2)
        self.assertAlmostEqual(y, 1.4e-3)
        for ramp in self.draw("P2-31")[0]:
            np.testing.assert_allclose(upright(ramp), [1.1e-5, 6e-5], rtol=0.02)
        for axes in self.draw("P1-7")[0]:
            slopes = [np.polyfit(np.log(x), np.log(y), 1)[0] for x, y in black(axes)]
            self.assertEqual(len(slopes), 2)  # of the smallest and the largest Q
            self.assertLess(slopes[0], slopes[1])
        for axes in self.draw("P1-14")[0][1:]:
            self.assertEqual(len(black(axes)), 2)
        (against_rate, against_q), _ = self.draw("P1-13")
        (x, y), = black(against_rate)
        self.assertAlmostEqual(np.log(y[1] / y[0]) / np.log(x[1] / x[0]), 1.0)
        arrows = sorted(text.xy[0] for text in against_q.texts)
        np.testing.assert_allclose(arrows, [made.p1_q_star(phi) for phi in (0.60, 0.70, 0.78, 0.82, 0.835)],
                                   rtol=0.05)

    def test_every_figure_is_looked_at(self):
        wanted = {line.split()[0] for line in
                  self.bagnold("figure", "--figures", FIGURES).stdout.splitlines()}
        self.assertEqual(wanted, set(AXES) | set(OTHERS))


if __name__ == "__main__":
    unittest.main()
