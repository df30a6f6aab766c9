# SPDX-License-Identifier: BSD-3-Clause
"""Sequences and oscillations, from the scene to the results: against the Hessian of a packing, closed forms, balances."""

import csv
import math
import unittest

import h5py
import numpy as np

from bagnold import LAWS, CliTest, read_series, read_state, read_summary, write_state

PACKING = {
    "disks": {"model": "CD", "count": 64, "packing_fraction": 0.86, "elasticity": 1.0, "mass": "equal"},
    "shear": {"protocol": "sequence"},
    "output": {"plot": False},
}


def pairs_of(state):
    """i, j, and r_ij of all pairs of a state that touch, by all pairs and the nearest image."""
    position, length, height = state["position"], state["box_length"], state["box_length"]
    i, j = np.triu_indices(len(position), 1)
    away = position[i] - position[j]
    up = np.rint(away[:, 1] / height)
    away[:, 1] -= up * height
    away[:, 0] -= up * state["offset"]
    away[:, 0] -= length * np.rint(away[:, 0] / length)
    both = (state["diameter"][i] + state["diameter"][j]) / 2
    near = np.hypot(*away.T) < both
    return i[near], j[near], away[near], both[near]


def elastic_forces(state):
    """On each disk, [N, 2]: (k_e/d_ij)(1 - r_ij/d_ij) along r_ij."""
    i, j, away, both = pairs_of(state)
    size = np.hypot(*away.T)
    force = ((1 - size / both) / both / size)[:, None] * away
    total = np.zeros_like(state["position"])
    np.add.at(total, i, force)
    np.add.at(total, j, -force)
    return total, force, away


def shear_modulus(state):
    """G of a packing in balance: (affine - non-affine)/area, from the second derivatives of the elastic energy."""
    i, j, away, both = pairs_of(state)
    count = len(state["position"])
    hessian, slope, affine = np.zeros((2 * count, 2 * count)), np.zeros(2 * count), 0.0
    for a, b, r, d in zip(i, j, away, both):
        size = math.hypot(*r)
        along = np.outer(r, r) / size**2
        stiffness = along / d**2 - (1 - size / d) / d / size * (np.eye(2) - along)
        at, of = slice(2 * a, 2 * a + 2), slice(2 * b, 2 * b + 2)
        hessian[at, at] += stiffness
        hessian[of, of] += stiffness
        hessian[at, of] -= stiffness
        hessian[of, at] -= stiffness
        pull = stiffness @ [r[1], 0.0]
        slope[at] += pull
        slope[of] -= pull
        affine += r[1] * pull[0]
    moved = np.linalg.lstsq(hessian, slope, rcond=1e-12)[0]
    return (affine - slope @ moved) / state["box_length"]**2


class Packing(CliTest):
    def packing(self):
        """A packing that was sheared and let go."""
        return self.run_new("packing", **self.of(shear__pieces=[[1e-3, 1.0], [1e-5, 0.01], [0, 3e5]]))

    def of(self, **more):
        flat = {f"{table}__{key}": value for table, keys in PACKING.items() for key, value in keys.items()}
        return {**flat, "shear__strain_rate": None, "shear__strain": None, "shear__discard": None,
                "integration__time_step": None, "measure__every": 10, "output__sample_strain": None, **more}

    def oscillation(self, name, start, **more):
        return self.run_new(name, **self.of(**{
            "start__kind": "state", "start__file": str(start / "state.h5"), "shear__protocol": "oscillate",
            "shear__amplitude": 1e-6, "shear__period": 40000, "shear__cycles": 4, **more}))

    def test_a_stop_relaxes_to_a_packing_in_balance(self):
        out = self.packing()
        state = read_state(out)
        total, force, away = elastic_forces(state)
        self.assertLess(np.abs(total).max(), 1e-9)
        static = np.sum(force * away) / 2 / state["box_length"]**2
        stop = read_summary(out)["pieces"][2]
        self.assertEqual((stop["strain_rate"], stop["strain"], stop["time"]), (0, 0, 3e5))
        self.assertAlmostEqual(stop["observables"]["p"]["mean"] / static, 1, places=5)
        series = read_series(out)
        ends = series["time"][series["strain_rate"] == 0]
        self.assertTrue((np.diff(ends - 1000 - 1000 - 1e-6) > 0).all())
        last = np.diff(np.log10(ends[-40:] - (ends[-1] - 3e5)))
        np.testing.assert_allclose(last[:-1], 0.05, atol=0.01)  # twenty windows a decade of the time since the stop

    def test_storage_modulus_is_that_of_the_hessian(self):
        packing = self.packing()
        out = self.oscillation("slow", packing)
        found = read_summary(out)["observables"]
        modulus = shear_modulus(read_state(packing))
        self.assertLess(abs(found["G_storage"]["mean"] / modulus - 1), 0.01)
        for name in ("G_storage_2", "G_loss_2", "G_storage_3", "G_loss_3"):
            self.assertLess(abs(found[name]["mean"]), 1e-5 * modulus, name)
        quicker = read_summary(self.oscillation("quick", packing, shear__period=4000))["observables"]
        off = [abs(one["G_storage"]["mean"] / modulus - 1) for one in (found, quicker)]
        self.assertLess(off[0], off[1] / 3)  # it is the limit of slow oscillations
        self.assertGreater(quicker["G_loss"]["mean"], 3 * found["G_loss"]["mean"])

    def test_a_packing_that_still_relaxes(self):
        """Its drift is no modulus: G' is that of the packing at rest where it would be off by more, and it is warned of."""
        loose = {"disks__packing_fraction": 0.845}
        begun = [[1e-3, 1.0], [1e-5, 0.01]]
        answers = {}
        for name, stop in (("early", 1e4), ("late", 1e6)):
            packing = self.run_new(name, **self.of(**loose, shear__pieces=[*begun, [0, stop]]))
            for amplitude in (1e-4, 1e-5):
                out = self.oscillation(f"{name}-{amplitude}", packing, **loose, shear__amplitude=amplitude, shear__period=1000,
                                       shear__cycles=8, shear__discard=0.5)
                answers[name, amplitude] = read_summary(out)
        for amplitude, off, naive, warned in ((1e-4, 0.01, 0.02, False), (1e-5, 0.04, 0.2, True)):
            early, late = (answers[name, amplitude] for name in ("early", "late"))
            found, wanted = (one["observables"]["G_storage"]["mean"] for one in (early, late))
            drift = early["observables"]["sigma_drift"]["mean"]
            self.assertLess(abs(found / wanted - 1), off, amplitude)
            self.assertGreater(abs((found - drift / (math.pi * amplitude)) / wanted - 1), naive, amplitude)
            self.assertEqual("stress_drift" in [one["name"] for one in early["warnings"]], warned, amplitude)
            self.assertEqual(late["warnings"], [])

    def test_reversible_packings_come_back_each_cycle(self):
        out = self.oscillation("film", self.packing(), shear__amplitude=1e-5, output__trajectory_time=40000.0)
        with h5py.File(out / "trajectory.h5md") as file:
            place = file["particles/trajectory/position/value"][:]
        self.assertEqual(len(place), 5)
        self.assertGreater(np.abs(place[1] - place[0]).max(), 0)
        self.assertLess(np.abs(place[4] - place[3]).max(), 1e-8)

    def test_a_cycle_dissipates_the_work_that_is_done(self):
        out = self.oscillation("work", self.packing(), shear__amplitude=1e-5, shear__period=4000, shear__cycles=8,
                               measure__every=1)
        summary = read_summary(out)
        wave = summary["oscillation"]["waveform"]
        time = 4000 / len(wave["sigma"])
        work = np.sum(np.multiply(wave["sigma"], wave["strain_rate"])) * time
        found = {name: one["mean"] for name, one in summary["observables"].items()}
        self.assertAlmostEqual(work / (math.pi * 1e-5**2 * found["G_loss"]), 1, delta=1e-3)
        self.assertAlmostEqual(found["dissipation"] * 4000 / work, 1, delta=0.01)


class Checkerboard(CliTest):
    """Small and big disks in turns on a square lattice: shear moves them affinely, so that of CD

        sigma = -(f/a) gamma + k_d gammadot,   k_d = 1/Q,  f: the force of two,  a: their distance."""

    def lattice(self, rows=8, overlap=1e-4):
        d = 1.2
        apart = d * (1 - overlap)
        x, y = np.meshgrid(np.arange(rows) + 0.5, np.arange(rows) + 0.5)
        big = (np.add.outer(np.arange(rows), np.arange(rows)) % 2).ravel() == 1
        state = {"position": apart * np.stack([x.ravel(), y.ravel()], axis=1), "velocity": np.zeros((rows**2, 2)),
                 "diameter": np.where(big, 1.4, 1.0), "box_length": rows * apart, "offset": 0.0, "strain_rate": 0.0,
                 "time": 0.0}
        order = np.argsort(big, kind="stable")
        for name in ("position", "velocity", "diameter"):
            state[name] = state[name][order]
        path = self.folder / "lattice.h5"
        write_state(path, state)
        return path, np.pi / 4 * np.mean(state["diameter"]**2) / apart**2, overlap / d / apart

    def moduli(self, model, **more):
        path, packing_fraction, tension = self.lattice()
        out = self.run_new(f"{model}-{more.get('shear__cycle_pieces')}", **{
            "disks__model": model, "disks__packing_fraction": packing_fraction, "disks__elasticity": 4.0,
            "start__kind": "state", "start__file": str(path), "shear__strain_rate": None, "shear__strain": None,
            "shear__discard": 0.0, "shear__protocol": "oscillate", "shear__amplitude": 1e-5, "shear__period": 200.0, "shear__cycles": 1,
            "integration__time_step": None, "measure__every": 1, "output__sample_strain": None, **more})
        return read_summary(out), tension

    def test_moduli_in_closed_form(self):
        omega = 2 * math.pi / 200
        for pieces in (8, 128):
            with self.subTest(pieces=pieces):
                summary, tension = self.moduli("CD", shear__cycle_pieces=pieces)
                found = {name: one["mean"] for name, one in summary["observables"].items()}
                self.assertAlmostEqual(found["G_loss"] / (omega / 4.0), 1, places=6)
                self.assertAlmostEqual(found["G_storage"] / -tension, 1, places=3)
                for name in ("G_storage_3", "G_loss_3"):
                    self.assertLess(abs(found[name]), 1e-6 * omega)

    def test_without_damping_across_there_is_no_loss(self):
        summary, _ = self.moduli("CD_n")
        self.assertLess(abs(summary["observables"]["G_loss"]["mean"]), 1e-6)


class Sequence(CliTest):
    REVERSAL = {"disks__packing_fraction": 0.82, "shear__strain_rate": None, "shear__strain": None,
                "shear__discard": 0.5, "shear__protocol": "sequence",
                "shear__pieces": [[2.0**-7, 0.25], [-2.0**-7, 0.25]], "integration__time_step": None,
                "output__sample_strain": 2.0**-6}

    def test_stress_turns_with_the_shear(self):
        out = self.run_new("out", **self.REVERSAL, disks__replicas=4)
        forth, back = read_summary(out)["pieces"]
        self.assertEqual((forth["strain"], back["strain"], back["begin_strain"]), (0.25, -0.25, 0.25))
        sigma = [piece["observables"]["sigma"] for piece in (forth, back)]
        self.assertGreater(sigma[0]["mean"], 5 * sigma[0]["error"])
        self.assertLess(sigma[1]["mean"], -5 * sigma[1]["error"])
        self.assertAlmostEqual(read_series(out)["strain"][0][-1], 0, places=12)
        self.assertEqual(read_summary(out)["strain"]["total"], 0.5)
        self.assertNotIn("B_p", read_summary(out)["pieces"][0]["observables"])

    def test_every_law_oscillates(self):
        for model in LAWS:
            with self.subTest(model=model):
                out = self.folder / model
                oscillation = {**self.REVERSAL, "disks__model": model, "shear__protocol": "oscillate", "shear__pieces": None,
                               "shear__amplitude": 2.0**-5, "shear__period": 64.0, "shear__cycles": 3,
                               "shear__cycle_pieces": 16, "output__sample_strain": None, "disks__replicas": 3}
                result = self.run_scene(self.scene(**oscillation), out, "--all")
                self.assertIn("G_loss", result.stdout)
                self.assertGreater(read_summary(out)["observables"]["G_loss"]["error"], 0)
                wave = read_summary(out)["oscillation"]["waveform"]
                self.assertEqual(len(wave["sigma"]), 16)
                self.assertGreater(min(wave["sigma_error"]), 0)

    def test_bits_do_not_depend_on_threads_or_on_where_it_is_cut(self):
        one = self.run_new("one", "--threads", "1", **self.REVERSAL)
        two = self.run_new("two", "--threads", "2", **self.REVERSAL, output__checkpoint_minutes=1e-9)
        self.assert_same_state(one, two)
        a, b = read_series(one), read_series(two)
        for name in a:
            np.testing.assert_array_equal(a[name], b[name], name)

    def test_strains_are_those_asked_for(self):
        """Also where a piece is no whole number of steps: rates fit, and nothing is left after the cycles."""
        out = self.run_new("out", **{**self.REVERSAL, "shear__pieces": [[1e-2, 0.1234], [-2e-2, 0.1234]], "shear__cycles": 5})
        forth, back = read_summary(out)["pieces"]
        self.assertAlmostEqual(forth["strain"], 0.1234, places=15)
        self.assertAlmostEqual(back["strain"], -0.1234, places=15)
        self.assertAlmostEqual(forth["strain_rate"] / 1e-2, 1, delta=0.01)
        self.assertAlmostEqual(read_series(out)["strain"][-1], 0, places=14)
        self.refused(self.scene(**{**self.REVERSAL, "shear__pieces": [[1e-2, 0.005], [-5e-3, 0.005]]}), "shear.pieces", "longer piece")

    def test_a_stop_is_averaged_over_time(self):
        """Its first windows have a configuration each, of a step, its last ones many of hundreds."""
        out = self.run_new("out", **{**self.REVERSAL, "shear__pieces": [[2.0**-7, 0.25], [0, 64.0]], "shear__discard": 0.0})
        stop, series = read_summary(out)["pieces"][1], read_series(out)
        of_stop = series["strain_rate"] == 0
        duration = np.diff(series["time"], prepend=0.0)[of_stop]
        self.assertAlmostEqual(duration.sum(), 64)
        for name in ("p", "Z"):
            wanted = np.average(series[name][of_stop], weights=duration)
            self.assertAlmostEqual(stop["observables"][name]["mean"] / wanted, 1, places=12)
            other = np.average(series[name][of_stop], weights=series["evaluations"][of_stop])
            self.assertGreater(abs(other / wanted - 1), 1e-3, "else the test tells nothing")

    def test_windows_of_each_piece_are_told(self):
        out = self.run_new("out", **{**self.REVERSAL, "shear__pieces": [[2.0**-7, 0.25], [0, 16.0]], "shear__cycles": 2})
        series = read_series(out)
        with h5py.File(out / "result.h5") as file:
            data = file["samples/pieces"]
            table = dict(zip([one.split(" [")[0] for one in data.attrs["columns"].split(", ")], data[:].T))
            self.assertEqual(file["series/p"].dims[0].keys(), ["time"])
        np.testing.assert_array_equal(table["cycle"], [1, 1, 2, 2])
        np.testing.assert_array_equal(table["piece"], [1, 2, 1, 2])
        np.testing.assert_allclose(table["end_time"], [32, 48, 80, 96])
        np.testing.assert_allclose(table["begin_strain"], [0, 0.25, 0.25, 0.5])
        np.testing.assert_array_equal(table["first_window"][1:], table["end_window"][:-1])
        self.assertEqual(table["end_window"][-1], len(series["time"]))
        for end, last in zip(table["end_time"], table["end_window"]):
            self.assertAlmostEqual(series["time"][int(last) - 1], end)

    def test_sweeps_have_a_row_a_piece(self):
        path = self.scene(**{**self.REVERSAL, "shear__pieces": None})
        path.write_text(path.read_text() + '[sweep]\ngrid = { "disks.seed" = [1, 2], "shear.pieces" = [[[0.0078125, 0.125], '
                        '[0, 16]], [[0.0078125, 0.25]]] }\n')
        out = self.folder / "sweep"
        result = self.bagnold("sweep", path, "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("table of 6 pieces", result.stdout)
        self.assertIn("0001_seed=1_pieces=0.0078125+0.125+0+16", [one.name for one in (out / "points").iterdir()])
        with open(out / "pieces.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["disks.seed"], row["piece"]) for row in rows],
                         [("1", "1"), ("1", "2"), ("1", "1"), ("2", "1"), ("2", "2"), ("2", "1")])
        for row in rows:
            piece = read_summary(out / "points" / row["folder"])["pieces"][int(row["piece"]) - 1]
            self.assertEqual(float(row["p"]), piece["observables"]["p"]["mean"])
            self.assertEqual(float(row["strain"]), piece["strain"])
        with h5py.File(out / "sweep.h5") as file:
            np.testing.assert_array_equal(file["pieces/point"][:], [0, 0, 1, 2, 2, 3])
            np.testing.assert_array_equal(file["pieces/sigma"][:], [float(row["sigma"]) for row in rows])
        refused = self.bagnold("analyse", "kink", out, "--out", self.folder / "kink")
        self.assert_clean_error(refused, 2, "pieces.csv")
        result = self.bagnold("analyse", "table", out / "pieces.csv", "--x", "piece", "--y", "p", "--out", self.folder / "t")
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.folder / "t.csv", newline="") as file:
            self.assertEqual({row["piece"] for row in csv.DictReader(file)}, {"1", "2"})
        path.write_text(path.read_text().replace("discard = 0.5", "discard = 0.25"))
        self.assert_clean_error(self.bagnold("sweep", path, "--out", out), 2, "only a steady run can be made longer")

    def test_sweeps_of_oscillations_have_moduli(self):
        path = self.scene(**{**self.REVERSAL, "shear__protocol": "oscillate", "shear__pieces": None, "shear__period": 64.0,
                             "shear__cycles": 2, "shear__cycle_pieces": 16, "output__sample_strain": None})
        path.write_text(path.read_text() + '[sweep]\ngrid = { "shear.amplitude" = [0.01, 0.1] }\n')
        out = self.folder / "sweep"
        self.assertEqual(self.bagnold("sweep", path, "--out", out).returncode, 0)
        with open(out / "sweep.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            found = read_summary(out / "points" / row["folder"])["observables"]
            self.assertEqual(float(row["G_storage"]), found["G_storage"]["mean"])
        self.assertFalse((out / "pieces.csv").exists())

    def test_what_cannot_be_is_refused(self):
        scene = {**self.REVERSAL}
        self.refused(self.scene(**{**scene, "shear__pieces": [[1e-3, -1.0]]}), "shear.pieces", "above 0")
        self.refused(self.scene(**{**scene, "shear__pieces": [[1e-3]]}), "shear.pieces", "[rate, strain]")
        self.refused(self.scene(**scene, integration__engine="events"), "events", "shear.protocol = \"sequence\"")
        self.refused(self.scene(**scene, integration__engine="quasi-static", integration__scheme=None),
                     "quasi-static", "goes by time")
        self.refused(self.scene(**{**scene, "shear__discard": "auto"}), "shear.discard", "steady state")
        self.refused(self.scene(**{**scene, "shear__protocol": "oscillate", "shear__pieces": None,
                                   "shear__amplitude": 0.1, "shear__cycles": 1}), "shear.period", "give one of them")


if __name__ == "__main__":
    unittest.main()
