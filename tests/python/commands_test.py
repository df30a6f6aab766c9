# SPDX-License-Identifier: BSD-3-Clause
"""Commands of the program as functions: validate, status, analyse, check_limit; what a notebook shows."""

import importlib.util
import math
import sys
import types
import unittest
import warnings
from unittest import mock

import h5py
import numpy as np

from made import FOLDER, SCENE, Folder, bagnold, made, run

GRID = {"disks.elasticity": [1, 10], "disks.seed": [1, 2]}


def many():
    """A sweep of four points."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return bagnold.sweep_file({**SCENE, "sweep": {"grid": GRID}}, out=FOLDER / "many", jobs=2, progress=False)


class Commands(Folder):
    def test_validate(self):
        found = bagnold.validate(SCENE, disks__elasticity=4)
        self.assertEqual(found.scene["disks.elasticity"], 4)
        self.assertEqual(found.scene["integration.time_step"], 2.0**-4)
        self.assertIn("2048", found.remarks["steps"])
        self.assertIn("MB", found.remarks["memory"])
        self.assertIn("one core", found.remarks["estimated time"])
        self.assertIn("[disks]", str(found))
        with self.assertRaisesRegex(bagnold.InputError, r"^scene:\d+:\d+: disks.elasticity = -1 \(must be"):
            bagnold.validate(SCENE, disks__elasticity=-1)
        swept = bagnold.validate({**SCENE, "sweep": {"grid": GRID}})
        self.assertIn("4 in 4 chains", swept.remarks["points"])

    def test_status_of_a_run(self):
        r = made()
        found = bagnold.status(r.folder)
        self.assertEqual((found.kind, found.state, found.share, found.strain), ("run", "done", 1, 1))
        self.assertEqual(set(found.notes), {note.name for note in r.notes})
        self.assertEqual(set(found.warnings), {one.name for one in r.warnings})
        run(SCENE, self.folder / "cut")
        for name in ("summary.json", "state.h5", "result.h5"):
            (self.folder / "cut" / name).unlink()
        found = bagnold.status(self.folder / "cut")
        self.assertEqual((found.state, found.holder), ("stopped", ""))
        self.assertTrue(0 < found.strain <= 1)
        with self.assertRaisesRegex(bagnold.InputError, "holds no run"):
            bagnold.status(self.folder)

    def test_status_of_many(self):
        found = bagnold.status(many().folder)
        self.assertEqual((found.kind, found.state, found.share, len(found.points)), ("sweep", "done", 1, 4))
        self.assertEqual({point.state for point in found.points}, {"done"})
        self.assertTrue(all(point.folder.is_dir() for point in found.points))
        rates = {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 0.25}
        cascade = bagnold.status(run({**SCENE, "shear": rates}, self.folder / "cascade").folder)
        self.assertEqual((cascade.kind, cascade.state, [point.state for point in cascade.points]), ("cascade", "done", ["done"] * 2))
        self.assertEqual((cascade.share, [(point.folder / "result.h5").exists() for point in cascade.points]), (1, [True] * 2))
        self.assertTrue(np.isnan(cascade.strain))

    def test_analyse(self):
        s = many()
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            found = bagnold.analyse("exponents", s.folder, x="disks.elasticity", y="Z", window=2, out=self.folder / "found")
        self.assertEqual(found.path, self.folder / "found.csv")
        self.assertEqual(len(found), 2)
        self.assertTrue(all(isinstance(row, dict) for row in found))
        self.assertTrue(all("UserWarning" in str(one.category) for one in said))
        with self.assertRaisesRegex(bagnold.InputError, "colour"):
            bagnold.analyse("exponents", s.folder, x="disks.colour", y="Z")

    def test_check_limit(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = bagnold.check_limit(SCENE, self.folder / "limit", jobs=2, progress=False)
        self.assertIn(found.verdict, ("Bagnold", "Newton", "neither", "undecided"))
        self.assertEqual(found.found["strain_rates"], [2.0**-7, 2.0**-8])
        self.assertEqual(bagnold.status(self.folder / "limit").kind, "sweep")


class Shown(Folder):
    def test_a_run(self):
        r = made()
        shown = r._repr_html_()
        self.assertIn("<td>Z</td>", shown)
        self.assertIn(str(r["Z"]).split(" = ")[1].split()[0], shown)
        for note in r.notes:
            self.assertIn(f"<b>note {note.name}</b>", shown)
        (self.folder / "scene.toml").write_text("")
        self.assertIn("not complete", bagnold.Run(self.folder)._repr_html_())

    def test_a_title_is_a_text(self):
        r = run({**SCENE, "title": "<b>& 'mine'"}, self.folder / "one")
        self.assertIn("&lt;b&gt;&amp;", r._repr_html_())

    def test_a_sweep(self):
        s = many()
        shown = s._repr_html_()
        self.assertEqual(shown.count("<tr>"), 5)
        self.assertIn("<th>elasticity</th>", shown)
        self.assertIn(f'data-value="{float(s["Z"][0])!r}"', shown)

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "pandas is not installed")
    def test_series_for_pandas(self):
        r = made()
        frame = r.to_pandas()
        np.testing.assert_array_equal(frame["Z"], r.series["Z"])
        self.assertEqual(frame.attrs["units"]["p"], "m/tau_e^2")
        two = made(disks__replicas=2)
        np.testing.assert_array_equal(two.to_pandas().loc[2]["Z"], two.series["Z"][1])

    @unittest.skipUnless(importlib.util.find_spec("xarray"), "xarray is not installed")
    def test_series_and_sweeps_for_xarray(self):
        r = made()
        data = r.to_xarray()
        np.testing.assert_array_equal(data["Z"], r.series["Z"])
        np.testing.assert_array_equal(data["strain"], r.series["strain"])
        self.assertEqual(data["p"].attrs["units"], "m/tau_e^2")
        turning = run({**SCENE, "shear": {"protocol": "sequence", "pieces": [[2.0**-7, 0.125], [-2.0**-7, 0.125]]}}, self.folder / "turning")
        along = turning.to_xarray()  # the strain comes back, so it is over the time
        self.assertEqual(along["sigma"].dims, ("time",))
        self.assertTrue((np.diff(along["time"]) > 0).all())
        np.testing.assert_array_equal(along["strain"], turning.series["strain"])
        two = made(disks__replicas=2).to_xarray()
        self.assertEqual(two["Z"].dims, ("seed", "strain"))
        s = many()
        grid = s.to_xarray()
        for k, point in enumerate(s):
            one = grid.sel({"disks.elasticity": point.scene["disks.elasticity"], "disks.seed": point.scene["disks.seed"]})
            self.assertEqual(float(one["Z"]), float(s["Z"][k]))

    @unittest.skipUnless(importlib.util.find_spec("h5netcdf"), "h5netcdf is not installed")
    def test_series_have_named_axes(self):
        """Dimension scales of result.h5, as h5py and, with h5netcdf, xarray read them."""
        import xarray
        for r, names in ((made(), ("strain",)), (made(disks__replicas=2), ("seed", "window"))):
            with h5py.File(r.folder / "result.h5") as file:
                for name in set(r.series) - set(names):
                    for axis, scale in enumerate(names):
                        self.assertEqual(file["series"][name].dims[axis].keys(), [scale])
                        self.assertEqual(file["series"][name].dims[axis][0].shape, file["series"][name].shape[axis:axis + 1])
                if len(names) == 2:
                    self.assertEqual(list(file["seed"]), r.seeds)
            with xarray.open_dataset(r.folder / "result.h5", group="series", engine="h5netcdf") as data:
                self.assertEqual(data["Z"].dims, names)
                np.testing.assert_array_equal(data["Z"], r.series["Z"])
                np.testing.assert_array_equal(data["strain"], r.series["strain"])

    def test_the_names_of_the_package(self):
        self.assertEqual(set(dir(bagnold)), {*bagnold.__all__, "__doc__", "__version__"})

    def test_numbers_are_pythons(self):
        """What is printed as a number has no type of NumPy about it."""
        r = made(output__trajectory_strain=2.0**-3)
        frame, contacts = r.frames[-1], r.contacts[-1]
        for value in (r["Z"].mean, r["Z"].error, frame.strain, frame.time, frame.packing_fraction, frame.box.length, frame.box.area,
                      contacts.Z, *bagnold.structure.percolates(contacts), *r.about.values(), r.series.discarded):
            self.assertNotIsInstance(value, np.generic)


class Bar(Folder):
    def test_in_a_notebook(self):
        """A bar of tqdm, where that is installed."""
        class Tqdm:
            made = []

            def __init__(self, **words):
                self.words, self.n, self.seen, self.closed = words, 0, [], False
                Tqdm.made.append(self)

            def refresh(self):
                self.seen.append(self.n)

            def close(self):
                self.closed = True

        tqdm = types.ModuleType("tqdm.auto")
        tqdm.tqdm = Tqdm
        fake = {"ipykernel": types.ModuleType("ipykernel"), "tqdm": types.ModuleType("tqdm"), "tqdm.auto": tqdm}
        with mock.patch.dict(sys.modules, fake), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            bagnold.run(SCENE, self.folder / "one")
            bagnold.sweep_file({**SCENE, "sweep": {"grid": GRID}}, out=self.folder / "many", jobs=2)
        self.assertEqual(len(Tqdm.made), 2)
        for bar in Tqdm.made:
            self.assertTrue(bar.closed and bar.seen)
            self.assertTrue(all(0 <= share <= 100 for share in bar.seen))
        self.assertEqual(Tqdm.made[1].seen[-1], 100)
        self.assertTrue(math.isclose(Tqdm.made[0].words["total"], 100))


if __name__ == "__main__":
    unittest.main()
