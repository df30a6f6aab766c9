# SPDX-License-Identifier: BSD-3-Clause
"""g(r), S(q), displacements and networks: against plain loops and made configurations."""

import dataclasses
import itertools
import unittest

import numpy as np

from contacts_test import random_frame
from made import bagnold

structure = bagnold.structure
NO_DAMPING = {"disks": {"model": "CD_n", "elasticity": 1.0}}


def contacts(frame):
    return bagnold.contacts_of(frame, NO_DAMPING)


def lattice(columns, rows, spacing, diameter=1.0, tilt=0.0, box=None):
    x, y = np.meshgrid(np.arange(columns) + 0.25, np.arange(rows) + 0.25)
    count = columns * rows
    frame = random_frame(count)
    return dataclasses.replace(
        frame, position=spacing * np.stack([x.ravel(), y.ravel()], axis=1), diameter=np.full(count, diameter),
        box=box or bagnold.Box(columns * spacing, rows * spacing, tilt))


class Configurations(unittest.TestCase):
    def test_g_of_an_ideal_gas_is_one(self):
        frames = [random_frame(400, 20.0, 18.0, 3.0, seed) for seed in range(20)]
        for species in (None, (0, 0), (0, 1)):
            r, g = structure.radial_distribution(frames, 5.0, 5, species)
            np.testing.assert_allclose(r, [0.5, 1.5, 2.5, 3.5, 4.5])
            np.testing.assert_allclose(g, 1, atol=0.08)

    def test_nothing_to_look_at(self):
        with self.assertRaisesRegex(bagnold.InputError, "no frame"):
            structure.nonaffine_msd([])
        with self.assertRaisesRegex(bagnold.InputError, "no frame"):
            structure.force_distribution([])

    def test_g_by_loops(self):
        frame = random_frame(30, 9.0, 8.0, 4.0)
        distances = []
        for i, j in itertools.combinations(range(30), 2):
            distances += [np.hypot(*(frame.position[i] - frame.position[j] - [9.0 * a + 4.0 * b, 8.0 * b]))
                          for a in range(-3, 4) for b in (-1, 0, 1)]
        edges = np.linspace(0, 4, 9)
        expected = np.histogram(distances, edges)[0] / (435 * np.pi * np.diff(edges**2) / 72)
        np.testing.assert_allclose(structure.radial_distribution(frame, 4.0, 8)[1], expected)

    def test_beyond_half_the_box_is_refused(self):
        with self.assertRaisesRegex(bagnold.InputError, r"r_max = 5 d_s .*4\)"):
            structure.radial_distribution(random_frame(30, 9.0, 8.0, 4.0), 5.0)

    def test_s_by_loops(self):
        frame = random_frame(20, 9.0, 8.0, 4.0)
        size, power = [], []
        for a, b in itertools.product(range(-9, 10), repeat=2):
            # q . (L, 0) = 2 pi a, q . (tilt, H) = 2 pi b
            q = np.array([2 * np.pi * a / 9.0, 2 * np.pi * (b - a * 4.0 / 9.0) / 8.0])
            if (a, b) != (0, 0) and np.hypot(*q) < 3:
                size.append(np.hypot(*q))
                power.append(abs(np.exp(-1j * frame.position @ q).sum())**2 / 20)
        edges = np.linspace(0, 3, 5)
        number = np.histogram(size, edges)[0]
        q, s = structure.structure_factor(frame, 3.0, 4)
        with np.errstate(invalid="ignore"):
            np.testing.assert_allclose(s, np.histogram(size, edges, weights=power)[0] / number, rtol=1e-9)
            np.testing.assert_allclose(q, np.histogram(size, edges, weights=size)[0] / number, rtol=1e-9)

    def test_s_of_a_lattice_has_its_peak(self):
        q, s = structure.structure_factor(lattice(8, 8, 1.0), 7.0, 700)
        self.assertAlmostEqual(q[np.nanargmax(s)], 2 * np.pi, delta=0.01)
        self.assertAlmostEqual(np.nanmax(s), 64)

    def test_velocities(self):
        frame = random_frame(900, 30.0, 30.0, 5.0)
        wave = np.sin(2 * np.pi * frame.position[:, 1] / 30.0)
        velocity = np.stack([0.3 * frame.position[:, 1] + wave, np.zeros(900)], axis=1)
        r, c = structure.velocity_correlation(dataclasses.replace(frame, velocity=velocity), 14.0, 14)
        from math import pi
        expected = [np.mean(np.cos(2 * pi * one / 30.0 * np.cos(np.linspace(0, 2 * pi, 1000)))) for one in r]
        np.testing.assert_allclose(c, expected, atol=0.07)
        np.testing.assert_allclose(frame.nonaffine_velocity,
                                   frame.velocity - np.outer(frame.position[:, 1], [0.3, 0]))


class Displacements(unittest.TestCase):
    def walk(self, flow, seed=3, count=50, frames=40, strain=0.35):
        """Disks in a sheared box with known steps: what they do beside the mean flow."""
        random = np.random.default_rng(seed)
        length, height = 8.0, 10.0
        place = random.uniform(0, 1, (count, 2)) * [length, height]
        made, walked = [], [np.zeros((count, 2))]
        total = 0.0
        for k in range(frames):
            gamma = strain * k
            tilt = gamma * height - length * np.floor(gamma * height / length + 0.5)
            rows = np.floor(place[:, 1] / height)
            x = place[:, 0] - rows * gamma * height  # of the image below
            x -= length * np.floor(x / length)
            image_x = place[:, 0] - x - rows * tilt
            made.append(dataclasses.replace(
                random_frame(count), step=k, strain=gamma, box=bagnold.Box(length, height, tilt),
                position=np.stack([x, place[:, 1] - rows * height], axis=1),
                image=np.stack([np.rint(image_x / length), rows], axis=1).astype(np.int64)))
            step = random.normal(scale=0.5, size=(count, 2))
            middle = place[:, 1] + step[:, 1] / 2
            place = place + step + flow * strain * np.outer(middle, [1, 0])
            walked.append(walked[-1] + step)
            total = max(total, np.abs(place[:, 1]).max())
        self.assertGreater(total, 1.4 * height)
        return made, np.array(walked[:-1])

    def test_displacements_beside_the_mean_flow(self):
        frames, walked = self.walk(1.0)
        strain, found = structure.nonaffine_displacement(frames)
        np.testing.assert_allclose(strain, 0.35 * np.arange(40))
        np.testing.assert_allclose(found, walked, atol=1e-9)
        lags, msd = structure.nonaffine_msd(frames)
        expected = np.mean((walked[7:] - walked[:-7])**2, axis=(0, 1))
        np.testing.assert_allclose(msd[7], expected)

    def test_frames_that_are_not_evenly_spaced(self):
        """Frames left out change which lags there are, not what is found at a lag."""
        frames, walked = self.walk(1.0, strain=0.125)
        for chosen in ([0, 1, 2, 4, 8, 16, 32], [0, 3, 4, 5, 9, 30, 31], [*range(10), *range(10, 40, 5)], [0, 39], [7, 8, 20]):
            some = [frames[k] for k in chosen]
            lags, msd = structure.nonaffine_msd(some)
            moved = structure.nonaffine_displacement(some)[1]
            np.testing.assert_allclose(moved[..., 1], (walked - walked[chosen[0]])[chosen][..., 1], atol=1e-9)
            expected = {}
            for (m, a), (n, b) in itertools.combinations(enumerate(chosen), 2):
                expected.setdefault(b - a, []).append((moved[n] - moved[m])**2)
            np.testing.assert_array_equal(lags, [0, *(0.125 * lag for lag in sorted(expected))])
            for k, lag in enumerate(sorted(expected)):
                np.testing.assert_allclose(msd[k + 1], np.mean(expected[lag], axis=(0, 1)), err_msg=f"{chosen}, lag {lag}")

    def test_frames_late_by_a_step(self):
        """As the program writes them: lag k is still that of k frames, its strain the mean."""
        frames, walked = self.walk(1.0, strain=0.125)
        late = [dataclasses.replace(frame, strain=frame.strain + 0.01 * (k % 2)) for k, frame in enumerate(frames)]
        lags, msd = structure.nonaffine_msd(late)
        self.assertEqual(len(lags), 40)
        np.testing.assert_allclose(lags[:5], [0, 0.125 + 0.01 / 39, 0.25, 0.375 + 0.01 / 37, 0.5])

    def test_frames_far_apart_in_scale(self):
        """Ballistic disks, at strains even in their logarithm: the square of the lag, within what 1% of it makes."""
        frames = [dataclasses.replace(random_frame(2), strain=gamma, box=bagnold.Box(100, 100, 0),
                                      position=np.array([[10, 10 + 3 * gamma], [20, 30 + 3 * gamma]]))
                  for gamma in np.geomspace(1e-3, 10, 60)]
        lags, msd = structure.nonaffine_msd(frames)
        np.testing.assert_allclose(msd[:, 1], (3 * lags)**2, rtol=1e-4)
        self.assertTrue((np.diff(lags) > 0).all())

    def test_frames_out_of_order(self):
        frames, _ = self.walk(1.0)
        for wrong in (frames[::-1], [frames[0], frames[1], frames[1]]):
            with self.assertRaisesRegex(bagnold.InputError, "strain goes from .*must grow.*of one way alone"):
                structure.nonaffine_msd(wrong)
        self.assertEqual(structure.nonaffine_msd(frames[:1])[0].tolist(), [0])

    def test_images_unwrap_likewise(self):
        frames, _ = self.walk(1.0)
        by_image = np.array([frame.unwrapped for frame in frames])
        np.testing.assert_allclose(structure.unwrapped(frames), by_image, atol=1e-9)
        without = [dataclasses.replace(frame, image=None) for frame in frames]
        np.testing.assert_allclose(structure.unwrapped(without), by_image, atol=1e-9)
        self.assertEqual(structure.unwrapped([]).shape, (0, 0, 2))

    def test_images_unwrap_likewise_in_a_box_that_changes(self):
        """Disks that the box takes along, and that flow and wander, many boxes up."""
        random, made = np.random.default_rng(4), []
        length, place = 9.0, random.uniform(0, 9.0, (20, 2))
        for k in range(30):
            box = bagnold.Box(length, length, 0.2 * k * length - length * np.round(0.2 * k))
            rows = np.floor(place[:, 1] / length)
            x = place[:, 0] - rows * 0.2 * k * length  # of the image below
            x -= length * np.floor(x / length)
            columns = np.rint((place[:, 0] - x - rows * box.tilt) / length)
            made.append(dataclasses.replace(random_frame(20), step=k, strain=0.2 * k, box=box,
                                            position=np.stack([x, place[:, 1] - rows * length], axis=1),
                                            image=np.stack([columns, rows], axis=1).astype(np.int64)))
            scale = 1 + 0.02 * np.sin(k)
            length, place = scale * length, scale * place
            up = random.normal(scale=0.5, size=20) + 0.5
            place = place + np.stack([0.2 * (place[:, 1] + up / 2) + random.normal(scale=0.3, size=20), up], axis=1)
        without = [dataclasses.replace(frame, image=None) for frame in made]
        by_image = structure.unwrapped(made)
        self.assertGreater(by_image[:, :, 1].max(), 2 * 9.0)
        np.testing.assert_allclose(structure.unwrapped(without), by_image, atol=1e-9)

    def test_images_unwrap_frames_far_apart(self):
        """Disks that went further than half the box from frame to frame, from any frame on."""
        frames, walked = self.walk(1.0)
        whole = structure.unwrapped(frames)
        for chosen in ([0, 39], [5, 38], [3, 20, 39]):
            some = structure.unwrapped([frames[k] for k in chosen])
            np.testing.assert_array_equal(some[0], frames[chosen[0]].position)
            moved = structure.nonaffine_displacement([frames[k] for k in chosen])[1]
            np.testing.assert_allclose(moved[..., 1], (walked[chosen] - walked[chosen[0]])[..., 1], atol=1e-9)
        self.assertGreater(np.abs(np.diff(whole[[0, 39], :, 1], axis=0)).max(), 5)

    def test_without_image_or_strain(self):
        frame = random_frame()
        with self.assertRaisesRegex(bagnold.InputError, "no image"):
            frame.unwrapped
        with self.assertRaisesRegex(bagnold.InputError, "strain of a frame is not known"):
            structure.nonaffine_msd([dataclasses.replace(frame, strain=np.nan)])


class LocalStrain(unittest.TestCase):
    """D^2_min between frames of a packing that has moved by hand."""

    def frames(self, strain, kicks=None, gradient=None):
        first = dataclasses.replace(random_frame(60, 9.0, 8.0, 0.0), strain=0.0)
        place = first.position.copy()
        if gradient is not None:
            place = place @ np.asarray(gradient).T
        place[:, 0] += strain * first.position[:, 1]
        if kicks is not None:
            place += kicks
        box = bagnold.Box(9.0, 8.0, strain * 8.0)
        return [first, dataclasses.replace(first, position=place, image=np.zeros((60, 2), int), strain=strain, box=box)]

    def two(self, *given, **more):
        first, last = self.frames(*given, **more)
        return [dataclasses.replace(first, image=np.zeros((60, 2), int)), last]

    def test_the_mean_flow_leaves_nothing(self):
        d2, gradient = structure.d2_min(self.two(0.3), 2.5)
        np.testing.assert_allclose(d2, 0, atol=1e-12)
        np.testing.assert_allclose(gradient, np.broadcast_to([[1, 0.3], [0, 1]], (60, 2, 2)), atol=1e-9)

    def test_a_box_that_changed_leaves_nothing(self):
        first, last = self.two(0.3)
        last = dataclasses.replace(last, position=1.1 * last.position, box=bagnold.Box(9.9, 8.8, 0.3 * 8.8))
        d2, gradient = structure.d2_min([first, last], 2.5)
        np.testing.assert_allclose(d2, 0, atol=1e-12)
        np.testing.assert_allclose(gradient, np.broadcast_to(1.1 * np.array([[1, 0.3], [0, 1]]), (60, 2, 2)), atol=1e-9)
        np.testing.assert_allclose(structure.nonaffine_displacement([first, last])[1][1], 0, atol=1e-12)
        up = last.position[:, 1] >= 4.4
        moved = last.position - np.where(up[:, None], [0.3 * 8.8, 8.8], 0)
        images = np.zeros((60, 2), int)
        images[up, 1] = 1
        other = dataclasses.replace(last, position=moved, image=images)
        np.testing.assert_allclose(structure.d2_min([first, other])[0], 0, atol=1e-12)

    def test_by_least_squares_of_each_disk(self):
        kicks = np.random.default_rng(5).normal(0, 0.1, (60, 2))
        first, last = self.two(0.2, kicks)
        d2, gradient = structure.d2_min([first, last], 2.5)
        for i in range(60):
            before, after = [], []
            for j, a, b in itertools.product(range(60), (-1, 0, 1), (-1, 0, 1)):
                start = first.position[j] + [9.0 * a, 8.0 * b] - first.position[i]
                if (j, a, b) != (i, 0, 0) and np.hypot(*start) < 2.5:
                    before.append(start)
                    after.append(last.position[j] + [9.0 * a + 0.2 * 8.0 * b, 8.0 * b] - last.position[i])
            fit, *_ = np.linalg.lstsq(before, after, rcond=None)
            np.testing.assert_allclose(gradient[i], fit.T, atol=1e-9)
            left = np.array(after) - np.array(before) @ fit
            self.assertAlmostEqual(d2[i], np.sum(left**2) / len(before), places=10)

    def test_disks_across_an_edge_go_by_their_images(self):
        kicks = np.random.default_rng(6).normal(0, 0.05, (60, 2))
        first, last = self.two(0.2, kicks)
        up = last.position[:, 1] >= 4.0  # as if they had left the box: by another image of the same disk
        moved = last.position - np.where(up[:, None], [0.2 * 8.0, 8.0], 0)
        images = np.zeros((60, 2), int)
        images[up, 1] = 1
        other = dataclasses.replace(last, position=moved, image=images)
        np.testing.assert_allclose(structure.d2_min([first, other])[0], structure.d2_min([first, last])[0], atol=1e-10)

    def test_what_cannot_be_told(self):
        first, last = self.two(0.2)
        with self.assertRaisesRegex(bagnold.InputError, "1 frame .*a last one"):
            structure.d2_min([first])
        with self.assertRaisesRegex(bagnold.InputError, "strain of a frame is not known"):
            structure.d2_min([first, dataclasses.replace(last, strain=np.nan)])
        d2, gradient = structure.d2_min([first, last], 0.05)  # nobody has a neighbour
        self.assertTrue(np.isnan(d2).all() and np.isnan(gradient).all())


class Networks(unittest.TestCase):
    def test_forces_integrate_to_one(self):
        found = [contacts(random_frame(seed=seed)) for seed in range(5)]
        f, density = structure.force_distribution(found, 40, 10.0)
        self.assertAlmostEqual(density.sum() * (f[1] - f[0]), 1)
        all_forces = np.concatenate([one.elastic_force for one in found])
        self.assertAlmostEqual(density[3], np.mean((all_forces / all_forces.mean() >= 0.75)
                                                   & (all_forces / all_forces.mean() < 1)) / 0.25)
        with self.assertRaisesRegex(bagnold.InputError, "no frame has a contact"):
            structure.force_distribution(contacts(lattice(4, 4, 1.5)))

    def test_fabric(self):
        columns = lattice(6, 6, 1.1, box=bagnold.Box(6.6, 6.6, 0.0))
        touching = dataclasses.replace(columns, position=columns.position * [0.85, 1.0],
                                       box=bagnold.Box(6.6 * 0.85, 6.6, 0.0))
        np.testing.assert_allclose(structure.fabric_tensor(contacts(touching)), [[1, 0], [0, 0]], atol=1e-12)
        many = [contacts(random_frame(400, 20.0, 18.0, 3.0, seed)) for seed in range(20)]
        np.testing.assert_allclose(structure.fabric_tensor(many), np.eye(2) / 2, atol=0.02)

    def test_rattlers(self):
        """A chain stands on a slab that closes on itself along x: no disk of it is held."""
        slab = lattice(6, 3, 0.95, box=bagnold.Box(6 * 0.95, 20.0, 0.0))
        chain = slab.position[-1] + [[0, 0.9], [0, 1.8], [0, 2.7]]
        frame = dataclasses.replace(random_frame(21), position=np.concatenate([slab.position, chain]),
                                    diameter=np.ones(21), box=slab.box)
        found = contacts(frame)
        self.assertEqual(found.degree[17:].tolist(), [4, 2, 2, 1])
        self.assertEqual(np.nonzero(structure.rattlers(found))[0].tolist(), [18, 19, 20])
        self.assertTrue(structure.rattlers(found, needed=5).all())

    def test_clusters(self):
        frame = lattice(6, 4, 1.5)
        frame = dataclasses.replace(frame, diameter=np.where(np.arange(24) < 6, 1.6, 1.0))
        found = contacts(frame)
        self.assertEqual(structure.cluster_sizes(found).tolist(), [6] + [1] * 18)
        self.assertEqual(structure.clusters(found)[:7].tolist(), [0] * 6 + [6])

    def test_percolation(self):
        rows = lattice(6, 4, 1.5)
        touching = {"none": rows, "x": dataclasses.replace(rows, diameter=np.where(np.arange(24) < 6, 1.6, 1.0)),
                    "y": dataclasses.replace(rows, diameter=np.where(np.arange(24) % 6 == 2, 1.6, 1.0)),
                    "both": dataclasses.replace(rows, diameter=np.full(24, 1.6))}
        expected = {"none": (False, False), "x": (True, False), "y": (False, True), "both": (True, True)}
        for name, frame in touching.items():
            self.assertEqual(structure.percolates(contacts(frame)), expected[name], name)
        # a chain once around in x and y: it never closes straight along x
        place = (np.arange(12) + 0.2) * 12.0 / 12
        diagonal = dataclasses.replace(random_frame(12), position=np.stack([place, place], axis=1),
                                       diameter=np.full(12, 1.5), box=bagnold.Box(12.0, 12.0, 0.0))
        self.assertEqual(structure.percolates(contacts(diagonal)), (False, True))
        # the same in a box whose image above is shifted by a whole length is one
        shifted = dataclasses.replace(diagonal, box=bagnold.Box(12.0, 12.0, -12.0))
        self.assertEqual(structure.percolates(contacts(shifted)), (False, True))


if __name__ == "__main__":
    unittest.main()
