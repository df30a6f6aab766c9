# SPDX-License-Identifier: BSD-3-Clause
"""What the recipe of each figure draws, from data made by known laws: axes and values.

AXES is written from the papers: for each panel what goes to the right and upwards. A drawn point must
be a state that was made, at its values, or lie where the laws have what an analysis looks for. ALSO is
what a recipe could leave out and still show enough: its states must be drawn."""

import csv
import json
import pathlib
import shutil
import tempfile
import tomllib
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


def difference(y, **at):
    """Points of y at 1e-6 less y at 1e-5, CD_rot, against what of phi and q is not given."""
    def near(x, found):
        slow, fast = (value(made.cd_rot(rate=rate, **{"phi": x, "q": x} | at) | {RATE: rate}, y)
                      for rate in (1e-6, 1e-5))
        return abs(found - (slow - fast)) < 1e-3 * slow
    return Found(PHI if "q" in at else Q, f"difference of {y}", near)


p1_place = Found(PHI, "Q_star", at(made.p1_q_star, 0.05))
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
    "P2-32": [difference("Z/shear.strain_rate", phi=0.82), difference("Z/shear.strain_rate", phi=0.76)],
    "P2-33": [difference("B_p_el", q=1), difference("B_p_el", q=20)],
    "P2-35": [Found(PHI, "gammadot", lambda phi, rate: min(
        abs(phi - made.LOW), abs(phi - made.HIGH), abs(phi - made.FAST[0]), abs(phi - made.SLOW[0])) < 0.004)],
    "P2-36": [(PHI, "R_v")],
}
for number, y in (("2", ("eta_p_el", "B_p_el")), ("6", ("tau_dur", "nu_coll/shear.strain_rate")),
                  ("11", ("eta_p_el", "B_p_el")), ("14", ("tau_dur", "nu_coll/shear.strain_rate"))):
    AXES[f"P2-{number}"] = [(Q, y[0]), (Q, y[1])] * 2
AXES["P2-5"] = AXES["P2-13"] = [(Q, "Z")] * 2
AXES["P2-16"] = [(PHI, "eta_p_el"), (PHI, "B_p_el")] * 2
OWN_LABELS = {  # that recipes write themselves
    "$|B_\\sigma^{kin}|/B_\\sigma$", "$\\nu_{coll}/\\dot\\gamma$", "$Z$, $2\\tau_{dur}\\nu_{coll}$",
    "$(\\sigma_{dev} - \\sigma)/\\sigma$"}
ALSO = {f"P1-{n}": ("cd_n_contacts", [{RATE: [1e-6], PHI: [0.60, 0.835]}] * 2) for n in range(1, 5)}
ALSO |= {f"P2-{n}": ("cd_rot_inelastic", [{RATE: [1e-5]}]) for n in (10, 12)}
for data, numbers in (("cd_slowest", (2, 5, 6)), ("cd_rot_slowest", (11, 13, 14))):
    for number in numbers:
        half = len(AXES[f"P2-{number}"]) // 2
        ALSO[f"P2-{number}"] = data, [{RATE: [1e-7], PHI: [phi]} for phi in half * [0.82] + half * [0.76]]
ALSO["P2-16"] = "cd_rot_slowest", [{RATE: [1e-7], Q: [q]} for q in (1, 1, 20, 20)]
angles, velocities = ("\\vartheta$", "(\\vartheta)"), ("$V^R_{ij}$", "$V_{ij,T}$", "$V^C_{ij,T}$", "$V_{ij,N}$")
OTHERS = {  # panels that show more than averages: what labels of their axes say
    "P1-10": [angles] * 6, "P2-8": [angles] * 2, "P2-18": [angles] * 2,
    "P2-9": [("$Q$", "(\\vartheta = 90")] * 2, "P2-19": [("$Q$", "(\\vartheta = 90")] * 2,
    "P2-21": [velocities[:2]] * 2 + [velocities[:3:2]] * 2 + [velocities[2:]] * 2,
    "P2-27": [("$x/d_s$", "$y/d_s$")] * 4,
    "P2-28": [("$y/d_s$", name) for name in ("v_x", "\\dot\\gamma(y)", "\\phi(y)") for _ in range(3)],
    "P2-31": [(label(RATE), label("sigma"))] * 2}


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
        is_place = line.get_markersize() in (9, 11)  # a kink or a peak, or an end, marked
        if line.get_marker() not in ("None", None, "", " ", "_", "|", 2, 3) and not is_place:
            points += list(np.column_stack(line.get_data()))
    return [point for point in points if np.isfinite(point).all()]


def off(pairs, point):
    """Distance of a point from the nearest pair, relative."""
    return (np.abs(pairs - point) / (1e-300 + np.abs(point))).max(axis=1).min()


class RecipesTest(CliTest):
    """Data are made, and each figure is drawn, once for all tests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        figure_page.plt.rcParams.update({"figure.max_open_warning": 0})
        cls.place = pathlib.Path(tempfile.mkdtemp(prefix="bagnold-"))
        cls.addClassCleanup(shutil.rmtree, cls.place, ignore_errors=True)
        shutil.copytree(FIGURES.parent, cls.place / "figures")
        cls.figures = cls.place / "figures" / FIGURES.name
        text = FIGURES.read_text()
        for kind in ("crossover", "divergence", "exponents", "friction-law", "jump", "kink", "transition",
                     "constant-pressure", "peak"):  # no bootstrap: values are looked at
            text = text.replace(f'= "{kind} ', f'= "{kind} --resamples 0 ')
        cls.figures.write_text(text)
        cls.data = cls.place / "data"
        cls.data.mkdir()
        cls.made = made.write_tables(FIGURES, cls.data)
        cls.drawings = {}

    def draw(self, name):
        """Its axes, and the states that were made for it."""
        if name not in self.drawings:
            self.drawings[name] = self.draw_once(name)
        return self.drawings[name]

    def draw_once(self, name):
        out = self.place / "out"
        result = self.bagnold("figure", name, "--figures", self.figures, "--data", self.data, "--out", out,
                              env=environment() | {"BAGNOLD_PYTHON": "/bin/true"})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        folder = out / name
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

    def test_quick_figures_state_what_their_data_can_tell(self):
        """A number is found for each that a quick figure states, and no other analysis lacks its points."""
        listed = tomllib.loads(FIGURES.read_text())
        names = [name for name, figure in listed.items() if "quick" in figure]
        self.assertIn("P2-4", names)
        for name in names:
            with self.subTest(figure=name):
                out = self.place / "quick"
                result = self.bagnold("figure", name, "--quick", "--figures", self.figures, "--data", self.data,
                                      "--out", out, env=environment() | {"BAGNOLD_PYTHON": "/bin/true"})
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertNotIn("not found", result.stdout)
                self.assertNotRegex(result.stderr, "leaves no point|not varied|no table")

    def check(self, axes, wanted, states, name):
        if isinstance(wanted, Found):
            x, y = wanted.x, wanted.y
        else:
            x, y = wanted
            pairs = np.array([(value(s, x), value(s, y)) for s in states], float)
        self.assertEqual(axes.get_xlabel(), label(x), name)
        self.assertIn(axes.get_ylabel(), OWN_LABELS | {label(y)}, name)
        points = drawn(axes)
        self.assertGreaterEqual(len(points), 4, name)
        for point in points:
            if isinstance(wanted, Found):
                self.assertTrue(wanted.near(*point), (name, x, y, point))
            else:
                self.assertLess(off(pairs, point), 2e-3, (name, x, y, point))

    def check_drawn(self, axes, wanted, data, chosen, name):
        """Finds every state of a data set that has the chosen values among the points."""
        states = [s for s in self.made[data] if all(s[key] in values for key, values in chosen.items())]
        self.assertTrue(states, name)
        for state in states:
            pair = [value(state, quantity) for quantity in wanted]
            self.assertLess(off(np.array(drawn(axes)), pair), 2e-3, (name, wanted, data, pair))

    def test_axes_and_values(self):
        for name, panels in AXES.items():
            with self.subTest(figure=name):
                axes, states = self.draw(name)
                self.assertEqual(len(axes), len(panels))
                for one, wanted in zip(axes, panels):
                    self.check(one, wanted, states, name)

    def test_nothing_is_left_out(self):
        for name, (data, panels) in ALSO.items():
            with self.subTest(figure=name):
                for one, wanted, chosen in zip(self.draw(name)[0], AXES[name], panels):
                    self.check_drawn(one, wanted, data, chosen, name)

    def test_those_that_show_more_than_averages(self):
        for name, labels in OTHERS.items():
            with self.subTest(figure=name):
                for one, (right, up) in zip(self.draw(name)[0], labels, strict=True):
                    self.assertIn(right, one.get_xlabel())
                    self.assertIn(up, one.get_ylabel())

    def test_local_fields_fill_their_box(self):
        axes = self.draw("P2-27")[0]  # made 100 wide
        self.assertEqual([(one.get_xlim(), one.get_ylim()) for one in axes],
                         2 * [((0, 100), (0, 100))] + 2 * [((0, 100), (0, 800))])
        self.assertEqual([list(one.collections[0].get_array()) for one in axes], 2 * [[0.79, 0.81], [6e-5, 4e-6]])

    def test_phase_diagrams_of_bands_show_all_boundaries_and_where_they_end(self):
        """R_v, on the way up too, where phi_N alone is looked for; P^el and mu."""
        wanted = {"$R_v$": 2, "$R_v$, rate rising": 1, "$P^{el}$": 2, "$\\mu$": 2}
        begin, end = (made.bands(phi, 1.0, 1e-3) for phi in (made.LOW, made.HIGH))
        for name, x_range, y_range in (("P2-25", (made.LOW, made.HIGH), (1e-3, 2e-3)),
                                       ("P2-26", (begin["p"], end["p"]), (0.9e-3, 1.1e-3)),
                                       ("P2-29", (begin["p"], end["p"]), (begin["sigma"], end["sigma"]))):
            with self.subTest(figure=name):
                (axes,), _ = self.draw(name)
                names = [text.rpartition(", ")[0] for text in axes.get_legend_handles_labels()[1]]
                self.assertEqual({by: names.count(by) for by in wanted}, wanted)
                ((x,), (y,)), = [line.get_data() for line in axes.lines if line.get_marker() == "*"]
                for place, (low, high) in ((x, x_range), (y, y_range)):
                    self.assertTrue(low < place < high, (place, low, high))

    def test_bands_lie_beside_the_boundaries(self):
        """Of both sizes of boxes."""
        (axes,), _ = self.draw("P2-35")
        points = np.array(drawn(axes))
        for band in (made.FAST, made.SLOW):
            self.assertGreaterEqual((np.abs(points / band - 1) < 1e-6).all(axis=1).sum(), 6, band)

    def test_parts_of_the_anisotropy_are_compared(self):
        self.draw("P1-16")
        with open(self.place / "out/P1-16/stated.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        for part, truth in (("delta_p_el/delta_p_kin", 2.0), ("delta_p_dis/delta_p", 0.0)):
            found = [float(row["ours"].split()[0]) for row in rows if row["what"].startswith(part)]
            self.assertTrue(found, part)
            np.testing.assert_allclose(found, truth, rtol=1e-3)

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
