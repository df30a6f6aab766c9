# SPDX-License-Identifier: BSD-3-Clause
"""Contacts and their forces: against all pairs in plain loops, and against what the program summed up."""

import itertools
import math
import unittest

import h5py
import numpy as np

from made import SCENE, Folder, bagnold, made, run, with_frames

def random_frame(count=60, length=9.0, height=7.0, tilt=-3.1, seed=1, box=None):
    random = np.random.default_rng(seed)
    return bagnold.Frame(
        step=0, time=0.0, strain=0.0, strain_rate=0.3, box=box or bagnold.Box(length, height, tilt),
        position=random.uniform(0, 1, (count, 2)) * [length, height], velocity=random.normal(size=(count, 2)),
        spin=random.normal(size=count), image=None, diameter=np.where(np.arange(count) % 2, 1.4, 1.0),
        mass=np.ones(count))


def plain_contacts(frame):
    """{(i, j): (r_ij, v_ij at the point of contact)} in loops over images, P2 Eqs. 5-7."""
    found = {}
    for i, j in itertools.combinations(range(len(frame)), 2):
        for row, column in itertools.product((-1, 0, 1), (-3, -2, -1, 0, 1, 2, 3)):
            r = frame.position[i] - frame.position[j] - [column * frame.box.length + row * frame.box.tilt,
                                                         row * frame.box.height]
            distance = math.hypot(*r)
            if distance >= (frame.diameter[i] + frame.diameter[j]) / 2:
                continue
            n = r / distance
            v = frame.velocity[i] - frame.velocity[j] - [frame.strain_rate * row * frame.box.height, 0]
            share = distance / (frame.diameter[i] + frame.diameter[j])
            for disk, side in ((i, -1), (j, 1)):  # spin x lever from the centre to the point of contact
                lever = side * share * frame.diameter[disk] * n
                v = v - side * frame.spin[disk] * np.array([-lever[1], lever[0]])
            found[i, j, row] = (r, v)
    return found


class AgainstLoops(unittest.TestCase):
    def check(self, frame):
        scene = {"disks": {"model": "CD_rot", "elasticity": 2.0}}
        contacts, plain = bagnold.contacts_of(frame, scene), plain_contacts(frame)
        self.assertEqual(len(contacts), len(plain))
        keys = list(zip(contacts.i.tolist(), contacts.j.tolist()))
        self.assertEqual(keys, sorted(keys))
        for k, (i, j) in enumerate(keys):
            here = contacts.normal[k] * contacts.separation[k]
            r, v = min((value for key, value in plain.items() if key[:2] == (i, j)),
                       key=lambda one: np.abs(one[0] - here).max())
            np.testing.assert_allclose(here, r, atol=1e-12)
            np.testing.assert_allclose(contacts.velocity[k], v, atol=1e-12)
        self.assertEqual(contacts.degree.sum(), 2 * len(contacts))

    def test_boxes_of_all_shapes(self):
        for seed, (count, length, height, tilt) in enumerate(
                ((60, 9.0, 7.0, -3.1), (60, 9.0, 7.0, 4.4), (60, 16.0, 4.3, 7.5), (60, 5.7, 12.0, 2.5),
                 (60, 8.0, 8.0, -4.0), (40, 8.0, 8.0, 0.0), (6, 3.0, 3.0, 1.2), (2, 2.9, 2.9, -1.0))):
            with self.subTest(length=length, height=height, tilt=tilt):
                self.check(random_frame(count, length, height, tilt, seed))

    def test_disks_outside_the_box(self):
        """A disk moved by a cell vector, with the velocity that it has there, meets the same."""
        frame = random_frame(100, 12.0, 11.0, 2.0)
        moved = random_frame(100, 12.0, 11.0, 2.0)
        for disk, (column, row) in ((3, (1, 0)), (4, (0, 1)), (5, (-1, -2))):
            moved.position[disk] += [column * 12.0 + row * 2.0, row * 11.0]
            moved.velocity[disk, 0] += row * 0.3 * 11.0
        one, other = (bagnold.contacts_of(f, {"disks": {"model": "CD_rot", "elasticity": 1.0}}) for f in (frame, moved))
        np.testing.assert_array_equal(one.j, other.j)
        np.testing.assert_allclose(one.force, other.force, atol=1e-12)


class AgainstTheProgram(Folder):
    """Windows of one evaluation, so a value of a series is that of a configuration."""

    def check(self, **changes):
        step = 2.0**-11
        r = made(shear__strain=64 * step, shear__discard=0.0, measure__every=1, output__sample_strain=step,
                 output__trajectory_strain=8 * step, integration__scheme="modified-velocity-verlet",
                 integration__time_step=2.0**-4, **changes)
        checked = 0
        for frame, found in zip(r.frames, r.contacts):
            if frame.step in (0, 64):  # the last one is in no window
                continue
            window = int(np.argmin(np.abs(r.series["strain"] - frame.strain)))
            for name, value in (("Z", found.Z),
                                ("p_el", -np.trace(found.stress("elastic")) / 2),
                                ("p_dis", -np.trace(found.stress("dissipative")) / 2),
                                ("sigma_el", found.stress("elastic")[0, 1]),
                                ("sigma_dis", found.stress("dissipative")[0, 1])):
                near = r.series[name][max(0, window - 2):window + 3]
                scale = max(abs(near).max(), 1e-300)
                self.assertLess(np.abs(near - value).min(), 1e-9 * scale, (name, frame.step, value, near))
            checked += len(found)
        self.assertGreater(checked, 50)

    def test_laws(self):
        for law in ("CD", "CD_n", "CD_rot"):
            with self.subTest(law=law):
                self.check(disks__model=law)
        self.check(disks__model="CD_nt", disks__damping_normal=0.7, disks__damping_tangential=0.2)

    def test_hertz_and_elasticity(self):
        self.check(disks__force_exponent=2.5, disks__elasticity=3.0, disks__mass="area")

    def test_a_law_of_ones_own_has_no_dissipation_here(self):
        frame = with_frames().frames[-1]
        found = bagnold.contacts_of(frame, {"disks": {"model": "CD_t", "elasticity": 1.0}})
        self.assertTrue(np.isnan(found.dissipative_force).all() and np.isfinite(found.elastic_force).all())

    def test_slices(self):
        r = with_frames()
        self.assertEqual(len(r.contacts), 9)
        self.assertEqual([len(one) for one in r.contacts[2:5]], [len(r.contacts[k]) for k in (2, 3, 4)])


class AsWritten(Folder):
    """measure.contact_frames: what the program writes of contacts, against what is worked out from frames."""

    def check(self, spacing, **changes):
        r = made(measure__contacts=True, measure__contact_frames=True, output__trajectory_strain=spacing, **changes)
        worked_out = [bagnold.contacts_of(frame, r.scene) for frame in r.frames]
        self.assertGreater(sum(map(len, worked_out)), 50)
        for written, plain in zip(r.contacts, worked_out):
            np.testing.assert_array_equal(np.stack([written.i, written.j]), np.stack([plain.i, plain.j]))
            for name in ("separation", "normal", "velocity", "elastic_force", "dissipative_force"):
                np.testing.assert_allclose(getattr(written, name), getattr(plain, name), atol=1e-11, err_msg=name)
        return r

    def followed(self, steps, **changes):
        """A run with a frame of every step, and since when each pair of each has been in contact, {step: {(i, j): step}}."""
        step = 2.0**-11
        r = made(measure__contacts=True, measure__contact_frames=True, output__trajectory_strain=step,
                 shear__strain=steps * step, output__sample_strain=2.0**-5, **changes)
        self.assertEqual(len(r.frames), steps + 1)
        begun, since, ended, young = {}, {}, 0, 0
        for frame, contacts in zip(r.frames, r.contacts):
            pairs = list(zip(contacts.i.tolist(), contacts.j.tolist()))
            ended += len(set(begun) - set(pairs))
            begun = {pair: begun.get(pair, frame.step) for pair in pairs}
            young += sum(0 < step < frame.step for step in begun.values())
            since[frame.step] = begun
        self.assertGreater(ended, 5)
        self.assertGreater(young, 100)
        return r, since

    def check_ages(self, r, since):
        for frame, contacts in zip(r.frames, r.contacts):
            begun = since[frame.step]
            expected = [math.nan if begun[pair] == 0 else 2.0**-4 * (frame.step - begun[pair])
                        for pair in zip(contacts.i.tolist(), contacts.j.tolist())]
            np.testing.assert_allclose(contacts.age, expected, rtol=1e-12, err_msg=str(frame.step))

    def test_ages_in_thick_flow(self):
        self.check_ages(*self.followed(256))

    def test_ages_of_collisions(self):
        """By lookaheads, many steps at one go."""
        dilute = {"disks__packing_fraction": 0.6, "disks__elasticity": 8.0, "disks__count": 256}
        r, since = self.followed(1024, integration__engine="reference", **dilute)
        self.check_ages(r, since)
        ahead = self.check(2.0**-6, shear__strain=0.5, output__sample_strain=2.0**-5,
                           integration__engine="lookahead", **dilute)
        self.check_ages(ahead, since)

    def test_every_law(self):
        for law in ("CD", "CD_n", "CD_nt"):
            with self.subTest(law=law):
                self.check(2.0**-3, disks__model=law)
        self.check(2.0**-3, disks__force_exponent=2.5)

    def test_a_run_that_was_made_longer(self):
        """Ages go on beyond the end; trajectories are those of a run of that length, bit for bit."""
        keys = {"measure__contacts": True, "measure__contact_frames": True, "output__trajectory_strain": 2.0**-3}
        whole = made(shear__strain=2.0, **keys)
        short = run(SCENE, self.folder / "short", shear__strain=1.0, **keys)
        longer = bagnold.resume(short.folder, strain=2.0, progress=False)
        self.assertEqual(len(longer.frames), len(whole.frames))
        with h5py.File(longer.folder / "trajectory.h5md") as a, h5py.File(whole.folder / "trajectory.h5md") as b:
            for name in b["contacts"]:
                np.testing.assert_array_equal(a["contacts"][name][()], b["contacts"][name][()])

    def test_it_needs_ages_and_frames(self):
        for missing in ({"measure__contacts": True}, {"output__trajectory_strain": 0.1}):
            with self.assertRaisesRegex(bagnold.InputError, "measure.contact_frames"):
                run(SCENE, self.folder / "refused", measure__contact_frames=True, **missing)


class OfARamp(Folder):
    """Frames of a ramp, where each stands for itself."""

    def ramp(self, **changes):
        scene = {**SCENE, "shear": {"protocol": "ramp", "strain_rate": 2.0**-9, "strain_rate_high": 2.0**-6,
                                    "ramp_rate": 2.0**-9, "ramp_window": 4.0, "ramp_every": 1.0, "strain": 0.5,
                                    "cycles": 2},
                 "output": {"plot": False, "trajectory_decades": 0.0625}}
        return run(scene, self.folder / "ramp", measure__rotation=True, measure__frame_decades=0.0625,
                   measure__profiles=True, measure__contacts=True, **changes)

    def test_rows_are_those_of_its_frames(self):
        r = self.ramp(measure__contact_frames=True)
        rows = np.stack(list(r.samples["ramp_frames"].values()), axis=1)
        rotation = r.histograms["rotation"]
        frames = [f for f in r.frames if f.strain >= rows[0][0] * (1 - 1e-12)]
        self.assertEqual(len(frames), len(rows))
        self.assertGreater(len(rows), 50)
        for frame, (strain, rate, direction), density in zip(frames, rows, rotation.density):
            self.assertAlmostEqual(frame.strain, strain, delta=1e-9 * strain)
            self.assertEqual(frame.strain_rate, rate)
            counts, _ = np.histogram(frame.spin / rate, rotation.edges)
            np.testing.assert_allclose(density, counts / len(frame) / np.diff(rotation.edges), atol=1e-12)
        self.assertEqual(set(rows[:, 2]), {-1.0, 1.0})
        on_one_leg = rows[:-1, 2] == rows[1:, 2]
        np.testing.assert_array_equal((np.diff(rows[:, 1]) > 0)[on_one_leg], rows[:-1, 2][on_one_leg] > 0)
        for contacts, frame in zip(r.contacts, r.frames):
            plain = bagnold.contacts_of(frame, r.scene)
            np.testing.assert_allclose(contacts.velocity, plain.velocity, atol=1e-11)
        self.assertEqual(r.histograms["tau_dur"].density.shape[0], len(rows))
        self.assertEqual(r.profiles["gammadot"].value.shape[0], len(rows))
        self.assertIn("tau_dur", {name for one in r.summary["loop"]["up"] for name in one["observables"]})


if __name__ == "__main__":
    unittest.main()
