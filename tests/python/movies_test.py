# SPDX-License-Identifier: BSD-3-Clause
"""bagnold.plots.packing by what it draws, and bagnold.movie by the frames that are in the film."""

import dataclasses
import os
import shutil
import subprocess
import unittest

import numpy as np

from made import SOURCE, Folder, bagnold, made, with_frames

import matplotlib  # noqa: E402

matplotlib.use("Agg")
from matplotlib.collections import EllipseCollection, LineCollection  # noqa: E402
from PIL import Image  # noqa: E402

from bagnold.plots import packing_page  # noqa: E402


def drawn(figure, kind):
    found = [one for one in figure.axes[0].collections if isinstance(one, kind)]
    return found[0] if found else None


class Packing(Folder):
    def test_every_disk_and_its_images_are_where_they_belong(self):
        r = with_frames()
        frame = r.frames[-1]
        figure = bagnold.plots.packing(r)
        disks, box = drawn(figure, EllipseCollection), frame.box
        places = np.asarray(disks.get_offsets())
        inside = (places >= 0).all(1) & (places < [box.length, box.height]).all(1)
        self.assertEqual(inside.sum(), len(frame))
        self.assertGreater(len(places), len(frame), "no images at the edges")
        kinds = np.unique(np.round(disks._widths * 2, 6))  # half widths
        np.testing.assert_allclose(kinds, [1, 1.4], rtol=1e-6)
        # each image is a disk moved by cell vectors
        for place in places[~inside]:
            away, _ = box.nearest(frame.position - place)
            self.assertLess(np.hypot(*away.T).min(), 1e-9)

    def test_a_picture_that_is_covered_as_the_packing_is(self):
        """Share of the area that is not white is the packing fraction, at the images too."""
        r = with_frames()
        figure = bagnold.plots.packing(r, color=np.ones(64), forces=False)
        disks = drawn(figure, EllipseCollection)
        disks.set_linewidth(0)
        disks.set_array(None)
        disks.set_facecolor("black")
        axes = figure.axes[0]
        for spine in axes.spines.values():
            spine.set_visible(False)
        figure.savefig(self.folder / "a.png", dpi=150)
        box = axes.get_window_extent()
        scale = 150 / figure.dpi
        picture = np.asarray(Image.open(self.folder / "a.png").convert("L"), dtype=float) / 255
        rows = slice(int(picture.shape[0] - box.y1 * scale) + 1, int(picture.shape[0] - box.y0 * scale) - 1)
        part = picture[rows, int(box.x0 * scale) + 1:int(box.x1 * scale) - 1]
        overlaps = np.sum(r.contacts[-1].overlap)  # hardly any area
        self.assertLess(overlaps / 64, 0.2)
        self.assertAlmostEqual(1 - part.mean(), 0.84, delta=0.02)

    def test_forces_join_disks_that_touch(self):
        r = with_frames()
        frame, contacts = r.frames[-1], r.contacts[-1]
        lines = drawn(bagnold.plots.packing(r), LineCollection)
        lengths = [np.hypot(*np.diff(one, axis=0)[0]) for one in lines.get_segments()]
        self.assertGreaterEqual(len(lengths), len(contacts))
        self.assertTrue(all(np.abs(contacts.separation - one).min() < 1e-9 for one in lengths))
        for one in lines.get_segments():
            for end in one:
                away, _ = frame.box.nearest(frame.position - end)
                self.assertLess(np.hypot(*away.T).min(), 1e-9, "a line that ends beside a disk")
        self.assertIsNone(drawn(bagnold.plots.packing(r, forces=False), LineCollection))

    def test_colours(self):
        r = with_frames()
        frame, contacts = r.frames[-1], r.contacts[-1]
        for color, wanted in (("contacts", contacts.degree), ("spin", frame.spin / frame.strain_rate),
                              ("velocity", frame.nonaffine_velocity[:, 0] / frame.strain_rate)):
            values = drawn(bagnold.plots.packing(r, color=color), EllipseCollection).get_array()
            self.assertTrue(set(np.round(np.asarray(wanted, float), 9)) >= set(np.round(values, 9)), color)
        with self.assertRaisesRegex(bagnold.InputError, "color = 'red'.*velocity, speed, rate"):
            bagnold.plots.packing(r, color="red")
        with self.assertRaisesRegex(bagnold.InputError, r"shape \(3,\)"):
            bagnold.plots.packing(r, color=[1, 2, 3])
        bagnold.plots.packing(made(disks__model="CD"), color="speed")  # the last state, without a trajectory
        with self.assertRaisesRegex(bagnold.InputError, "no spins"):
            bagnold.plots.packing(made(disks__model="CD"), color="spin")

    def test_speeds_are_positive_where_the_shear_turns(self):
        r = with_frames()
        frame = dataclasses.replace(r.frames[-1], strain_rate=-r.frames[-1].strain_rate)
        self.assertGreaterEqual(packing_page.values_of(frame, "speed", r.contacts[-1]).min(), 0)

    def test_the_box_of_each_frame(self):
        """A held pressure changes it."""
        r = with_frames()
        frame, contacts = r.frames[-1], r.contacts[-1]
        figure, axes = packing_page.plt.subplots()
        packing = packing_page.Packing(axes, frame, contacts)
        box = dataclasses.replace(frame.box, length=1.1 * frame.box.length, height=1.1 * frame.box.height)
        packing.show(dataclasses.replace(frame, box=box, position=1.1 * frame.position), contacts)
        self.assertEqual(axes.get_xlim(), (0, box.length))
        self.assertEqual(axes.get_ylim(), (0, box.height))
        packing_page.plt.close(figure)

    def test_the_local_rate_is_that_of_a_band(self):
        """Of a flow whose upper half shears three times as fast as its lower one."""
        from bagnold.plots.packing_page import local_rate
        rng = np.random.default_rng(1)
        n, height = 20000, 40.0
        position = rng.uniform(0, height, (n, 2))
        y = position[:, 1]
        v_x = np.where(y < 20, 0.5 * y, 10 + 1.5 * (y - 20))
        box = bagnold.Box(height, height, 0.0)
        frame = bagnold.Frame(0, 0.0, 1.0, 1.0, box, position, np.stack([v_x, 0 * y], 1), None, None, np.ones(n), np.ones(n))
        rate = local_rate(frame)
        self.assertAlmostEqual(np.median(rate[(y > 5) & (y < 15)]), 0.5, delta=0.05)
        self.assertAlmostEqual(np.median(rate[(y > 25) & (y < 35)]), 1.5, delta=0.05)


class Movies(Folder):
    def test_a_gif_has_every_frame(self):
        r, shares = with_frames(), []
        path = bagnold.movie(r, self.folder / "film.gif", frames=slice(0, None, 3), dpi=50, progress=shares.append)
        with Image.open(path) as film:
            self.assertEqual(film.n_frames, 3)
            film.seek(0)
            first = np.asarray(film.convert("RGB"), dtype=int)
            film.seek(2)
            self.assertGreater(np.abs(np.asarray(film.convert("RGB"), dtype=int) - first).max(), 50)
        self.assertEqual(shares[-1], 1)
        self.assertEqual([one.name for one in self.folder.iterdir()], ["film.gif"])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_mp4(self):
        path = bagnold.movie(with_frames(), self.folder / "film.mp4", frames=slice(0, 4), color="rate", dpi=50)
        self.assertIn(b"ftyp", path.read_bytes()[:16])

    def test_only_files_are_replaced(self):
        self.keeps_what_is_no_file(lambda path: bagnold.movie(with_frames(), path, frames=slice(2), dpi=40), ".gif")

    def test_mistakes(self):
        with self.assertRaisesRegex(bagnold.InputError, "must end with .gif or .mp4"):
            bagnold.movie(with_frames(), self.folder / "film.avi")
        with self.assertRaisesRegex(bagnold.InputError, "none of the 9 frames"):
            bagnold.movie(with_frames(), self.folder / "film.gif", frames=slice(20, 30))
        with self.assertRaisesRegex(bagnold.InputError, "series = 'colour'"):
            bagnold.movie(with_frames(), self.folder / "film.gif", series="colour")
        with self.assertRaisesRegex(bagnold.FileError, "output.trajectory_strain"):
            bagnold.movie(made(), self.folder / "film.gif")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_by_the_program(self):
        done = subprocess.run([os.environ["BAGNOLD_PROGRAM"], "movie", with_frames().folder, "film.gif", "--frames", "0:2", "--no-forces"],
                              cwd=self.folder, capture_output=True, text=True,
                              env={**os.environ, "BAGNOLD_PYTHON_PACKAGE": str(SOURCE / "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with Image.open(self.folder / "film.gif") as film:
            self.assertEqual(film.n_frames, 2)


if __name__ == "__main__":
    unittest.main()
