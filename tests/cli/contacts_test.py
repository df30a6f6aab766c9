# SPDX-License-Identifier: BSD-3-Clause
"""What measure.contacts adds to the files of a run, killed or not."""

import signal
import unittest

import h5py
import numpy as np

from bagnold import LAWS, STEP_STRAIN, CliTest, read_summary, seconds_to_strain

SCALARS = ("tau_dur", "nu_coll", "nu_end", "v_N_rms", "v_T_rms", "v_C_T_rms", "v_R_rms",
           "contact_rotation_correlation", "cluster_binary_share")
HISTOGRAMS = ("cluster_disks", "tau_dur", "theta", "theta_begin", "theta_end")
ENGINES = ("reference", "few-contacts", "many-contacts", "lookahead")
ON = {"measure__contacts": True, "measure__correlations": True}


def histograms(out):
    """{name: (edges, density)}"""
    with h5py.File(out / "result.h5", "r") as file:
        return {k: (g["edges"][()], g["density"][()]) for k, g in file["histograms"].items()}


def velocities(out):
    """{name: rows} of /samples/contact_velocities* and collision_velocities*"""
    with h5py.File(out / "result.h5", "r") as file:
        return {k: d[()] for k, d in file["samples"].items()}


def touching(place, edges, reach):
    """Which pairs overlap in one configuration, by the nearest of all images about."""
    apart = place[:, None] - place
    nearest = np.full(reach.shape, np.inf)
    for n in (-1, 0, 1):
        for m in (-2, -1, 0, 1, 2):
            nearest = np.minimum(nearest, np.linalg.norm(apart + n * edges[1, :2] + m * edges[0, :2], axis=2))
    return (nearest < reach) & ~np.eye(len(place), dtype=bool)


def connected(touch, disk):
    """Which disks are connected to one."""
    found = np.arange(len(touch)) == disk
    while True:
        more = found | touch[found].any(axis=0)
        if (more == found).all():
            return found
        found = more


class ContactsTest(CliTest):
    def test_velocities(self):
        for law in LAWS:
            out = self.run_new(law, disks__model=law, shear__strain=2.0, **ON)
            found = velocities(out)
            rotates = law not in ("CD", "CD_n")
            for name in ("contact_velocities", "collision_velocities"):
                rows, mean = found[name], found[f"{name}_mean"][0]
                covariance = found[f"{name}_covariance"]
                self.assertGreater(len(rows), 50)
                off = np.abs(mean - rows.mean(axis=0)) / np.sqrt(np.diag(covariance) / len(rows))
                self.assertLess(off.max(), 5, name)
                np.testing.assert_allclose(np.diag(covariance), rows.var(axis=0), rtol=0.3)
                self.assertEqual(rows.shape[1], 4 if rotates else 2)
                if rotates:
                    np.testing.assert_allclose(rows[:, 0] + rows[:, 1], rows[:, 2], atol=1e-9)
            rows = found["collision_velocities"]
            np.testing.assert_allclose(found["collision_velocities_mean"][0], rows.mean(axis=0), rtol=1e-9)
            np.testing.assert_allclose(found["collision_velocities_covariance"], np.cov(rows.T, ddof=0), rtol=1e-9)
            if rotates:
                found_by_sums = found["contact_velocities_covariance"]
                correlation = found_by_sums[1, 2] / np.sqrt(found_by_sums[1, 1] * found_by_sums[2, 2])
                means = {k: v["mean"] for k, v in read_summary(out)["observables"].items()}
                self.assertAlmostEqual(means["contact_rotation_correlation"], correlation, places=9)

    def test_velocities_at_the_contact_do_not_go_with_the_rotation(self):
        """P2 Fig. 21 (d), an identity of contacts in time; each collision once they do."""
        out = self.run_new("few-contacts", disks__packing_fraction=0.84, shear__strain=4.0, **ON)
        correlation = {}
        for name in ("contact_velocities", "collision_velocities"):
            covariance = velocities(out)[f"{name}_covariance"]
            correlation[name] = covariance[1, 2] / np.sqrt(covariance[1, 1] * covariance[2, 2])
        self.assertLess(abs(correlation["contact_velocities"]), 0.02, correlation)
        self.assertGreater(correlation["collision_velocities"], 0.05, correlation)

    def test_clusters_in_which_contacts_end(self):
        """Against all pairs of every configuration; the tables add up to velocities of all collisions."""
        out = self.run_new("clusters", disks__packing_fraction=0.76, shear__strain=1.0, measure__clusters=True,
                           output__trajectory_strain=STEP_STRAIN, integration__engine="many-contacts", **ON)
        with h5py.File(out / "trajectory.h5md") as file:
            disks = file["particles/trajectory"]
            place, edges = disks["position/value"][:, :, :2], disks["box/edges/value"][()]
            reach = (disks["diameter"][()][:, None] + disks["diameter"][()]) / 2
        touch = np.array([touching(r, e, reach) for r, e in zip(place, edges)])
        sizes = {}
        for step in range(len(touch) // 2, len(touch)):
            for a, b in np.argwhere(np.triu(touch[step - 1] & ~touch[step])):
                if not touch[:step, a, b].all():
                    size = min(connected(touch[step - 1], a).sum(), 64)
                    sizes[size] = sizes.get(size, 0) + 1
        total = sum(sizes.values())
        self.assertGreater(total, 100)
        edges, density = histograms(out)["cluster_disks_end"]
        counts = {int(edge + 0.5): round(value * total) for edge, value in zip(edges, density) if value > 0}
        self.assertEqual(counts, sizes)
        self.assertGreater(len(sizes), 5)
        found = velocities(out)
        self.assertEqual(found["collision_clusters"][:, 1].sum(), total)
        square = np.nan_to_num(found["collision_clusters"][:, [4, 5, 6, 3]])**2
        rows = found["collision_velocities"]
        self.assertEqual(len(rows), total)
        np.testing.assert_allclose(found["collision_clusters"][:, 2] @ square, (rows**2).mean(axis=0), rtol=1e-12)
        self.assertAlmostEqual(found["contact_clusters"][:, 2].sum(), 1.0, places=12)
        self.assertEqual(found["contact_clusters"][:, 1].sum(), total)

    def test_clusters_need_velocities(self):
        self.refused(self.scene(measure__contacts=True, measure__clusters=True), "measure.correlations = true")

    def test_durations_cut_short_by_the_run_are_warned_of(self):
        """Newtonian contacts outlast a strain of 1/8; dilute ones are short beside one of 8."""
        for name, fraction, strain, expected in (("cut", 0.84, 0.125, True), ("fine", 0.6, 8.0, False)):
            out = self.run_new(name, disks__model="CD", disks__packing_fraction=fraction,
                               shear__strain=strain, **ON)
            found = [w["name"] for w in read_summary(out)["warnings"]]
            self.assertEqual("contact_durations" in found, expected, found)

    def test_implicit_damping_is_warned_of(self):
        """Long steps take v_N up, and miss short contacts (docs/long_steps.md)."""
        for model, step, expected in (("CD", 0.5, True), ("CD_rot", 0.5, True), ("CD_rot", 0.0625, False)):
            out = self.run_new(f"{model}{step}", disks__model=model, disks__packing_fraction=0.82,
                               integration__scheme="implicit-damping", integration__time_step=step, **ON)
            found = {w["name"]: w["reason"] for w in read_summary(out)["warnings"]}
            self.assertEqual("implicit_contacts" in found, expected, found)
            if expected:
                self.assertIn("v_N_rms {}% too large".format({"CD": 21, "CD_rot": 36}[model]), found["implicit_contacts"])

    def test_velocities_need_contacts(self):
        self.refused(self.scene(measure__correlations=True), "measure.contacts = true")

    def test_off_leaves_nothing_and_on_changes_nothing(self):
        off, on = self.run_new("off"), self.run_new("on", **ON)
        means = [{k: v["mean"] for k, v in read_summary(out)["observables"].items()}
                 for out in (off, on)]
        for name in SCALARS:
            self.assertNotIn(name, means[0])
            self.assertIsNotNone(means[1].pop(name), name)
        self.assertEqual(*means)
        self.assert_same_state(off, on)
        with h5py.File(off / "result.h5", "r") as file:
            self.assertNotIn("histograms", file)

    def test_counts_agree_in_every_engine(self):
        """Z = 2 tau_dur nu_coll, three quantities measured independently."""
        for engine in ENGINES:
            for fraction in (0.6, 0.82):
                with self.subTest(engine=engine, fraction=fraction):
                    out = self.run_new(f"{engine}{fraction}", integration__engine=engine,
                                       disks__packing_fraction=fraction, shear__strain=32.0,
                                       disks__replicas=4,
                                       output__sample_strain=2.0**-5, **ON)
                    found = read_summary(out)["observables"]
                    z, tau, nu = (found[k] for k in ("Z", "tau_dur", "nu_coll"))
                    product = 2 * tau["mean"] * nu["mean"]
                    error = product * sum((k["error"] / k["mean"]) ** 2 for k in (tau, nu)) ** 0.5
                    self.assertLess(abs(z["mean"] - product), 4 * np.hypot(error, z["error"]))
                    self.assertLess(abs(z["mean"] - product) / product, 0.05)

    def test_histograms(self):
        for law in LAWS:
            out = self.run_new(law, disks__model=law, shear__strain=2.0, **ON)
            found = histograms(out)
            self.assertEqual(sorted(found), sorted(HISTOGRAMS))
            edges, density = found["theta"]
            self.assertEqual(len(density), 100)
            np.testing.assert_allclose(edges, np.linspace(-181.8, 178.2, 101), atol=1e-9)
            for name in HISTOGRAMS:
                edges, density = found[name]
                self.assertAlmostEqual(float((density * np.diff(edges)).sum()), 1.0, places=9, msg=name)
            middle = (found["theta"][0][1:] + found["theta"][0][:-1]) / 2
            for name, where in (("theta_begin", np.abs(middle) > 86), ("theta_end", np.abs(middle) < 94)):
                share = float((found[name][1] * 3.6)[where].sum())  # they come together, and part
                self.assertGreater(share, 0.97, name)
            edges, density = found["tau_dur"]
            mean = float((density * np.diff(edges) * (edges[1:] + edges[:-1]) / 2).sum())
            tau = read_summary(out)["observables"]["tau_dur"]["mean"]
            self.assertLess(abs(mean / tau - 1), 0.05)

    def test_replicas_are_taken_together(self):
        both = self.run_new("both", disks__replicas=2, disks__seed=5, **ON)
        alone = [self.run_new(f"alone{s}", disks__seed=s, **ON) for s in (5, 6)]
        for name, value in histograms(both).items():
            parts = [histograms(out)[name] for out in alone]
            for other in parts:
                np.testing.assert_array_equal(value[0], other[0])
            low, high = (f(*(p[1] for p in parts)) for f in (np.minimum, np.maximum))
            self.assertTrue((value[1] >= low * (1 - 1e-12)).all() and (value[1] <= high * (1 + 1e-12)).all())
        for seed, out in zip((0, 1), alone):
            one = read_summary(both)["replicas"][seed]["observables"]["tau_dur"]["mean"]
            self.assertEqual(one, read_summary(out)["observables"]["tau_dur"]["mean"])

    def test_kill_and_resume_change_nothing(self):
        for engine in ENGINES:
            for replicas in (1, 2) if engine == "few-contacts" else (1,):
                with self.subTest(engine=engine, replicas=replicas):
                    self.check_killed(engine, replicas)

    def check_killed(self, engine, replicas):
        changes = {**ON, "measure__clusters": True, "integration__engine": engine, "disks__replicas": replicas,
                   "disks__packing_fraction": 0.8, "output__checkpoint_minutes": 0.0005}
        strain = float(seconds_to_strain(self, 1.5, shear__strain=1.0, **changes))
        path = self.scene(shear__strain=strain, output__sample_strain=strain / 64, **changes)
        whole, cut = (self.folder / f"{name}_{engine}_{replicas}" for name in ("whole", "cut"))
        self.run_scene(path, whole, "--quiet")
        process, kills = self.start("run", path, "--out", cut), 0
        while kills < 3:
            stamp = self.stamp(cut)
            if not self.wait_until(lambda: self.stamp(cut) not in (None, stamp), process):
                break
            process.send_signal(signal.SIGKILL)
            self.finish(process)
            kills += 1
            process = self.start("resume", cut)
        self.finish(process)
        self.assertGreater(kills, 0)
        self.assert_same_state(whole, cut)
        self.assert_same_results(whole, cut)
        for name, pair in histograms(whole).items():
            for one, two in zip(pair, histograms(cut)[name]):
                self.assertEqual(one.tobytes(), two.tobytes(), name)
        for name, rows in velocities(whole).items():
            self.assertEqual(rows.tobytes(), velocities(cut)[name].tobytes(), name)

    @staticmethod
    def stamp(out):
        try:
            return (out / "checkpoint.h5").stat().st_mtime_ns
        except FileNotFoundError:
            return None


if __name__ == "__main__":
    unittest.main()
