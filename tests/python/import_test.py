# SPDX-License-Identifier: BSD-3-Clause
"""Imports: what was exported comes back, files written by hand and by ASE, what is refused, and runs that go on from
an imported state."""

import importlib.util
import os
import subprocess
import sys
import tomllib
import unittest

import h5py
import numpy as np

from made import SCENE, SOURCE, Folder, bagnold, run, with_frames

DATA = """LAMMPS data file, by hand

4 atoms
2 atom types

-10.0 10.0 xlo xhi
-5.0 5.0 ylo yhi
-0.5 0.5 zlo zhi
-4.0 0.0 0.0 xy xz yz

Atoms # sphere

3 2 2.8 0.5 9.0 4.0 0.0 0 0 0
1 1 2.0 1.0 -8.0 -4.0 0.0 1 0 0
4 2 2.8 0.5 11.0 0.0 0.0 0 0 0
2 1 2.0 1.0 0.0 1.0 0.0 0 0 0

Velocities

1 0.1 0.2 0.0 0.0 0.0 0.7
2 0.3 0.0 0.0 0.0 0.0 0.0
3 0.5 -0.1 0.0 0.0 0.0 -0.25
4 0.0 0.0 0.0 0.0 0.0 0.0
"""
XYZ = """4
Lattice="20.0 0.0 0.0 -4.0 10.0 0.0 0.0 0.0 1.0" Properties=species:S:1:pos:R:3:radius:R:1 pbc="T T F"
A 1.0 1.0 0.0 0.5
A 5.0 2.0 0.0 0.5
B 8.0 4.0 0.0 0.7
B 11.0 8.0 0.0 0.7
"""


class Import(Folder):
    def file(self, text, name="x.data"):
        path = self.folder / name
        path.write_text(text)
        return path

    def imported(self, path, **options):
        made = bagnold.import_state(path, self.folder / "state.h5", **options)
        self.assertEqual(list(self.folder.rglob("*.part")), [])
        (state,) = bagnold.frames.read_states(made.path)
        with h5py.File(made.path) as file:
            self.about = dict(file["state"].attrs)
        return made, state

    def refused(self, expected, path, **options):
        with self.assertRaisesRegex(bagnold.InputError, expected):
            bagnold.import_state(path, self.folder / "refused.h5", **options)
        self.assertFalse((self.folder / "refused.h5").exists())

    def refused_with(self, old, new, expected, text, kind, count=-1):
        """Where `new` stands for `old` in the text of a file, `count` times at most."""
        with self.subTest(new=new):
            self.assertIn(old, text)
            self.refused(expected, self.file(text.replace(old, new, count)), format=kind)


class RoundTrips(Import):
    def same(self, frame, state):
        self.assertEqual((state.box.length, state.box.height, state.box.tilt),
                         (frame.box.length, frame.box.height, frame.box.tilt))
        self.assertTrue(0 <= self.about["offset"] < frame.box.length)
        self.assertEqual((state.time, state.strain_rate), (frame.time, frame.strain_rate))
        np.testing.assert_array_equal(state.velocity, frame.velocity)
        np.testing.assert_array_equal(state.diameter, frame.diameter)
        np.testing.assert_array_equal(state.position[:, 1], frame.position[:, 1])
        # the cell's tilt moves some by L_x in the file, and back
        moved = np.abs(state.position[:, 0] - frame.position[:, 0])
        self.assertLess(moved.max(), 4 * np.spacing(frame.box.length))
        self.assertGreater(np.mean(moved == 0), 0.5)

    def test_dump_and_extxyz(self):
        source = with_frames()
        for to, name in (("lammps", "x.lammpstrj"), ("extxyz", "x.xyz")):
            path, *_ = bagnold.export(source, to, self.folder / name)
            for k in (-1, 3):
                with self.subTest(to=to, frame=k):
                    made, state = self.imported(path, frame=k)
                    self.same(source.frames[k], state)
                    np.testing.assert_array_equal(state.spin, source.frames[k].spin)
                    disks = made.scene["disks"]
                    self.assertEqual((disks["count"], disks["mass"]), (64, "equal"))
                    self.assertAlmostEqual(disks["packing_fraction"], 0.84, delta=1e-14)
                    self.assertNotIn("box_aspect", disks)

    def test_masses_by_area_a_long_box_and_no_spins(self):
        source = with_frames(disks__mass="area", disks__box_aspect=2.5, disks__model="CD_n")
        for to, name in (("lammps", "x.lammpstrj"), ("extxyz", "x.xyz")):
            path, *_ = bagnold.export(source, to, self.folder / name)
            made, state = self.imported(path)
            np.testing.assert_array_equal(state.velocity, source.frames[-1].velocity)
            self.assertAlmostEqual(state.box.tilt, source.frames[-1].box.tilt, delta=1e-14)
            self.assertIsNone(state.spin)
            self.assertIn("no spins", str(made))
            self.assertEqual(made.scene["disks"]["mass"], "area")
            self.assertAlmostEqual(made.scene["disks"]["box_aspect"], 2.5, delta=1e-13)

    def test_units(self):
        """Of a file in other units of length and time the state is the same."""
        path, *_ = bagnold.export(with_frames(), "extxyz", self.folder / "x.xyz", frames=slice(4, 5))
        _, state = self.imported(path)
        count, about, *rows = path.read_text().splitlines()
        words = [row.split() for row in rows]
        for row in words:  # species x y z vx vy vz radius mass px py pz spin image
            row[1:4] = [repr(float(word) / 256) for word in row[1:4]]
            row[4:7] = [repr(float(word) / 256 / 4) for word in row[4:7]]
            row[9:12] = [repr(float(word) / 256 / 4) for word in row[9:12]]
            row[7], row[12] = repr(float(row[7]) / 256), repr(float(row[12]) / 4)
        lattice = " ".join(repr(float(word) / 256) for word in about.split('"')[1].split())
        time, rate = (state.time * 4, state.strain_rate / 4)
        rest = f'Properties={about.split("Properties=")[1].split()[0]} pbc="T T F" time={time!r} strain_rate={rate!r}'
        other = self.file("\n".join([count, f'Lattice="{lattice}" {rest}', *map(" ".join, words)]) + "\n", "y.xyz")
        made, again = self.imported(other, time_unit=4)
        self.assertIn(f"d_s = {1 / 256!r} of the file", made.notes[0])
        for name in ("position", "velocity", "spin", "diameter"):
            np.testing.assert_array_equal(getattr(again, name), getattr(state, name), name)
        self.assertEqual((again.box, again.time, again.strain_rate), (state.box, state.time, state.strain_rate))


class ByHand(Import):
    def test_data_file(self):
        made, state = self.imported(self.file(DATA))
        self.assertNotIn("mass", made.scene["disks"])
        self.assertIn("1.372 times the mass", str(made))  # balls: 0.5 x 1.4^3
        np.testing.assert_array_equal(state.diameter, [1, 1, 1.4, 1.4])
        self.assertEqual((state.box.length, state.box.height, state.box.tilt), (10, 5, -2))
        self.assertEqual((self.about["offset"], self.about["box_aspect"]), (8, 0.5))
        self.assertNotIn("strain_rate", self.about)
        np.testing.assert_array_equal(state.position, [[1, 0.5], [5, 3], [9.5, 4.5], [0.5, 2.5]])
        np.testing.assert_array_equal(state.velocity, np.array([[0.1, 0.2], [0.3, 0], [0.5, -0.1], [0, 0]]) / 2)
        np.testing.assert_array_equal(state.spin, [0.7, 0, -0.25, 0])

    def test_text_of_the_scene(self):
        made, _ = self.imported(self.file(DATA))
        scene = tomllib.loads(str(made))
        self.assertEqual(scene["start"], {"kind": "state", "file": str(made.path)})
        self.assertEqual(scene["disks"], made.scene["disks"])
        self.assertAlmostEqual(scene["disks"]["packing_fraction"], np.pi / 4 * (2 + 2 * 1.4**2) / 50, delta=1e-15)

    def test_rates_and_images(self):
        """The rate says the velocity of an image; the mean beside the flow, which stays, is taken off."""
        text = DATA.replace("9.0 4.0", "9.0 14.0")  # a height above: x by the tilt, v_x by the rate
        self.refused("1 disks, as atom 3, are above or below the box", self.file(text))
        made, state = self.imported(self.file(text), strain_rate=0.01, time_unit=2)
        np.testing.assert_allclose(state.position[2], [(19 + 4) / 2 % 10, 4.5])
        self.assertEqual(self.about["strain_rate"], 0.02)
        self.assertIn("taken off", str(made))
        excess = state.velocity - np.outer(state.position[:, 1], [0.02, 0])
        np.testing.assert_allclose(np.average(excess, axis=0, weights=[1, 1, 1.372, 1.372]), 0, atol=1e-15)
        before = np.array([[0.1, 0.2], [0.3, 0], [0.5 - 0.1, -0.1], [0, 0]])
        np.testing.assert_allclose(np.diff(state.velocity, axis=0), np.diff(before, axis=0), atol=1e-15)

    def test_atomic_with_masses_and_diameters_by_type(self):
        rows = "".join(f"{k} {k} {2 - (k < 3)} {x}.5 2.0 0.0\n".replace(f"{k} {k} ", f"{k} ", 1)
                       for k, x in ((2, 4), (1, 1), (4, 9), (3, 6)))
        head = "title\n\n4 atoms\n0 20 xlo xhi\n0 10 ylo yhi\n\nMasses\n\n1 1.0 # small\n2 1.96\n\n"
        velocities = "\nVelocities\n\n" + "".join(f"{k} 0.0 {k}.0 0.0\n" for k in (1, 2, 3, 4))
        path = self.file(f"{head}Atoms\n\n{rows}{velocities}")
        self.refused("Atoms without the hint .*--atom-style", path)
        self.refused("no diameters; say them by type, --diameters 1=D,2=D", path, atom_style="atomic")
        self.refused("none of type 2", path, atom_style="atomic", diameters={1: 1})
        self.refused("atom style ellipsoid", path, atom_style="ellipsoid")
        made, state = self.imported(path, atom_style="atomic", diameters={1: 1, 2: 1.4})
        self.assertEqual(made.scene["disks"]["mass"], "area")
        np.testing.assert_array_equal(state.position[:, 0], [1.5, 4.5, 6.5, 9.5])
        np.testing.assert_array_equal(state.velocity[:, 1], [1, 2, 3, 4])
        self.assertIsNone(state.spin)

    def test_no_velocities(self):
        path = self.file(XYZ, "x.xyz")
        made, state = self.imported(path)
        np.testing.assert_array_equal(state.velocity, 0)
        self.assertIn("no velocities: 0", str(made))
        made, state = self.imported(path, strain_rate=0.5)
        np.testing.assert_array_equal(state.velocity, np.outer(state.position[:, 1], [0.5, 0]))
        self.assertIn("v_x = 0.5 y", str(made))

    def test_overlaps_ask_for_relaxation(self):
        made, _ = self.imported(self.file(XYZ, "x.xyz"))
        self.assertNotIn("relax", made.scene["start"])
        made, _ = self.imported(self.file(XYZ.replace("A 5.0 2.0", "A 1.6 1.0"), "x.xyz"))
        self.assertIs(made.scene["start"]["relax"], True)
        self.assertIn("largest relative overlap: 0.4, above 0.2", str(made))

    def test_dumps_of_lammps(self):
        """Scaled places, in any order, of boxes that are not tilted; diameters by type."""
        head = "ITEM: UNITS\nlj\nITEM: TIME\n2.5\n"
        one = ("ITEM: TIMESTEP\n{}\n" + head + "ITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n-5 5\n0 4\n-0.1 0.1\n"
               "ITEM: ATOMS id type xs ys zs\n2 2 0.75 {} 0.5\n1 1 0.25 0.5 0.5\n")
        path = self.file(one.format(0, 0.5) + one.format(100, 0.25), "x.dump")
        _, state = self.imported(path, diameters={1: 1, 2: 1.4})
        np.testing.assert_array_equal(state.position, [[2.5, 2], [7.5, 1]])
        self.assertEqual(state.time, 2.5)
        _, state = self.imported(path, frame=0, diameters={1: 1, 2: 1.4})
        np.testing.assert_array_equal(state.position, [[2.5, 2], [7.5, 2]])
        unwrapped = self.file(one.format(0, 5).replace("xs ys zs", "xu yu zu"), "y.dump")
        _, state = self.imported(unwrapped, diameters={1: 1, 2: 1.4})
        np.testing.assert_array_equal(state.position, [[5.25, 0.5], [5.75, 1]])


class Refusals(Import):
    def test_files(self):
        with self.assertRaisesRegex(bagnold.FileError, "not there"):
            bagnold.import_state(self.folder / "none.data", self.folder / "x.h5")
        with self.assertRaisesRegex(bagnold.FileError, "is a folder"):
            bagnold.import_state(self.folder, self.folder / "x.h5")
        with self.assertRaisesRegex(bagnold.FileError, "no text"):
            path = self.folder / "x.data"
            path.write_bytes(b"\x1f\x8b\xff\xff")
            bagnold.import_state(path, self.folder / "x.h5")
        with self.assertRaisesRegex(bagnold.FileError, "is no folder"):
            bagnold.import_state(self.file(DATA), self.folder / "none/x.h5")
        self.refused("by its first lines", self.file("hello\n", "x.txt"))
        self.refused("--from pdb", self.file(DATA), format="pdb")

    def test_only_files_are_replaced(self):
        source = self.file(DATA)
        self.keeps_what_is_no_file(lambda path: bagnold.import_state(source, path), ".h5")

    def test_data_files(self):
        for old, new, expected in (
                ("2.8 0.5 9.0", "2.5 0.5 9.0", r"diameter of atom 3 = 1.25 d_s \(must be 1.0 or 1.4"),
                ("2.8 0.5 9.0", "2.0 0.5 9.0", "3 of 4 disks are small"),
                ("1 1 2.0 1.0 -8.0", "1 1 0.0 1.0 -8.0", "diameter of atom 1 = 0.0 .*above 0"),
                ("4 atoms", "four atoms", "'four' is no number"),
                ("4 atoms", "4.5 atoms", "4.5 .must be a whole number"),
                ("# sphere", "# line", "atom style line"),
                ("9.0 4.0", "9.0 nan", "must be finite"),
                ("9.0 4.0", "9.0 four", "'four' is no number"),
                ("9.0 4.0 0.0", "9.0 4.0 1.0", "move in a plane"),
                ("-4.0 0.0 0.0 xy", "-4.0 1.0 0.0 xy", "xz and yz 0"),
                ("-10.0 10.0 xlo xhi", "", "has no xlo xhi"),
                ("-10.0 10.0 xlo", "10.0 -10.0 xlo", "the second above the first"),
                ("4 atoms", "5 atoms", "the header says 5 atoms; the file is cut short"),
                ("4 atoms", "3 atoms", "4 rows in Atoms, the header says 3 atoms; mend the header"),
                ("\n3 2 2.8", "\n1 2 2.8", "atom 1 is there twice"),
                ("3 0.5 -0.1", "7 0.5 -0.1", "none of atom 3"),
                ("0.0 -0.25", "-0.25", "several lengths"),
                ("9.0 4.0 0.0 0 0 0", "9.0 4.0 0.0 0 0", "9 columns"),
                ("2.8 0.5 9.0 4.0 0.0 0 0 0", "2.8 0.5", "4 columns"),
                ("Atoms # sphere", "Bodies", "no section Atoms")):
            self.refused_with(old, new, expected, DATA, "lammps")
        self.refused("--frame 3", self.file(DATA), frame=3)
        for name in ("unit", "time_unit", "tolerance"):
            self.refused(f"--{name.replace('_', '-')} 0", self.file(DATA), **{name: 0})

    def test_rounded_diameters(self):
        path = self.file(DATA.replace("2.8 0.5 9.0", "2.801 0.5 9.0"))
        self.refused("diameter of atom 3 = 1.4005", path)
        _, state = self.imported(path, tolerance=1e-3)
        np.testing.assert_array_equal(state.diameter, [1, 1, 1.4, 1.4])

    def test_extxyz(self):
        for old, new, expected in (
                ('Lattice="20.0 0.0 0.0 -4.0 10.0 0.0 0.0 0.0 1.0"', "", "has no Lattice"),
                ("20.0 0.0 0.0", "20.0 1.0 0.0", "flow along x"),
                ("0.0 0.0 1.0\"", "0.0 1.0\"", "8 numbers"),
                ('pbc="T T F"', 'pbc="T F F"', "boundary along y is F"),
                ("pos:R:3", "pos:R", "must be name:type:columns"),
                ("pos:R:3", "place:R:3", "has no pos"),
                ("radius:R:1", "momenta:R:1", "momenta without masses"),
                ("radius:R:1", "size:R:1", "no diameters"),
                ("B 11.0 8.0 0.0 0.7\n", "", "ends within a frame"),
                ("4\n", "4 disks\n", "must be the number of disks"),
                ("B 8.0 4.0 0.0 0.7", "B 8.0 4.0 0.0", "4 columns")):
            self.refused_with(old, new, expected, XYZ, "extxyz", 1)
        self.refused("has 1 disks", self.file(XYZ.replace("4\n", "1\n", 1).split("A 5.0")[0], "x.xyz"))
        self.refused("--frame 1 .*has 1 frame\\); use 0", self.file(XYZ, "x.xyz"), frame=1)

    def test_dumps(self):
        path, told = bagnold.export(with_frames(), "lammps", self.folder / "x.lammpstrj", frames=slice(0, 1))
        text = path.read_text()
        for old, new, expected in (
                ("pp pp pp", "pp ff pp", "boundary along y is ff"),
                ("xy xz yz pp", "abc origin pp", "cell by its vectors"),
                ("id type x y z", "id type a b c", "has no positions"),
                ("NUMBER OF ATOMS\n64", "NUMBER OF ATOMS\n65", "64 of 65 atoms"),
                ("ITEM: TIMESTEP\n0\n", "ITEM: TIMESTEP\n", "TIMESTEP: nothing .must be a whole number"),
                ("ITEM: NUMBER OF ATOMS", "ITEM: ENTRIES", "no ITEM: NUMBER OF ATOMS"),
                ("ITEM: TIMESTEP", "ITEM: STEP", "has no ITEM: TIMESTEP")):
            self.refused_with(old, new, expected, text, "dump")


class Runs(Import):
    def test_a_run_goes_on_from_its_last_frame(self):
        """As the run does that is longer by a strain of an eighth."""
        source = with_frames()
        longer = run(SCENE, self.folder / "longer", shear__strain=1.125)
        for to, name in (("lammps", "x.lammpstrj"), ("extxyz", "x.xyz")):
            with self.subTest(to=to):
                path, *_ = bagnold.export(source, to, self.folder / name)
                made, state = self.imported(path)
                scene = {table: {**keys, **made.scene.get(table, {})} for table, keys in SCENE.items()}
                scene["start"] = made.scene["start"]
                after = run(scene, self.folder / f"on_{to}", shear__strain=0.125)
                away, _ = longer.state.box.nearest(after.state.position - longer.state.position)
                moved, _ = longer.state.box.nearest(longer.state.position - state.position)
                self.assertGreater(np.abs(moved).max(), 0.1)
                np.testing.assert_allclose(away, 0, atol=1e-9)
                np.testing.assert_allclose(after.state.velocity, longer.state.velocity, atol=1e-10)
                np.testing.assert_allclose(after.state.spin, longer.state.spin, atol=1e-10)
                self.assertAlmostEqual(after.state.box.tilt, longer.state.box.tilt, delta=1e-9)

    def test_a_state_that_is_relaxed(self):
        rng = np.random.default_rng(7)
        rows = "".join(f"{'AB'[k % 2]} {x!r} {y!r} 0.0 {(0.5, 0.7)[k % 2]}\n"
                       for k, (x, y) in enumerate((10 * rng.random((64, 2))).tolist()))
        text = f'64\nLattice="10 0 0 0 10 0 0 0 1" Properties=species:S:1:pos:R:3:radius:R:1\n{rows}'
        made, _ = self.imported(self.file(text, "x.xyz"), strain_rate=2.0**-7)
        scene = {table: {**keys, **made.scene.get(table, {})} for table, keys in SCENE.items()}
        self.assertNotIn("relax", made.scene["start"])  # at random: as in a box that is another
        after = run({**scene, "start": {**made.scene["start"], "relax": True}}, self.folder / "relaxed", shear__strain=0.125)
        self.assertTrue(after.complete)


@unittest.skipIf(not importlib.util.find_spec("ase"), "ase is not installed")
class Ase(Import):
    def test_what_ase_writes(self):
        import ase
        import ase.io
        frame = with_frames().frames[-1]
        atoms = ase.Atoms(["H" if one < 1.2 else "He" for one in frame.diameter], pbc=(True, True, False), cell=frame.box.matrix,
                          positions=np.column_stack([frame.position, np.zeros(64)]), masses=frame.mass)
        atoms.set_velocities(np.column_stack([frame.velocity, np.zeros(64)]))
        path = self.folder / "x.xyz"
        ase.io.write(path, [atoms], format="extxyz", columns=["symbols", "positions", "momenta", "masses"])
        _, state = self.imported(path, diameters={"H": 1, "He": 1.4}, strain_rate=frame.strain_rate)
        away, _ = frame.box.nearest(state.position - frame.position)
        np.testing.assert_allclose(away, 0, atol=1e-7)  # ASE writes 8 digits
        np.testing.assert_allclose(state.velocity, frame.velocity, atol=1e-7)
        np.testing.assert_array_equal(state.diameter, frame.diameter)


class CommandLine(Import):
    def call(self, *words):
        return subprocess.run([sys.executable, "-m", "bagnold", "import", *map(str, words)], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "python")}, cwd=self.folder)

    def test_of_the_package(self):
        self.file(DATA)
        said = self.call("x.data", "--out", "s.h5", "--strain-rate=-1e-2", "--time-unit", "2")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertEqual(tomllib.loads(said.stdout)["start"], {"kind": "state", "file": "s.h5"})
        quiet = self.call("x.data", "--out", "s.h5", "--quiet", "--from", "lammps", "--frame", "0", "--unit", "2",
                          "--diameters", "1=2,2=2.8", "--atom-style", "sphere", "--tolerance", "1e-5")
        self.assertEqual((quiet.returncode, quiet.stdout, quiet.stderr), (0, "", ""))
        for words, code, expected in ((("no.data",), 4, "not there"), (("x.data", "--from", "pdb"), 2, "must be one of"),
                                      (("x.data", "--unit", "x"), 2, "--unit x (must be a number)"),
                                      (("x.data", "--frame", "1.5"), 2, "whole number"),
                                      (("x.data", "--frame", "0x1"), 2, "whole number"),
                                      (("x.data", "--frame", "1_0"), 2, "whole number"),
                                      (("x.data", "--frame", ""), 2, "whole number"),
                                      (("x.data", "--diameters", "1"), 2, "TYPE=D"),
                                      (("x.data", "--diameters", "1=0"), 2, "above 0")):
            said = self.call(*words, "--out", "t.h5")
            self.assertEqual(said.returncode, code, said.stderr)
            self.assertIn(expected, said.stderr)
            self.assertEqual(len(said.stderr.splitlines()), 1, said.stderr)

    def test_output_that_cannot_be_written(self):
        """Standard output is full, or nobody reads it: one line or none, and the state is there."""
        self.file(DATA)
        command = f"{sys.executable} -m bagnold import x.data --out"
        for sink, code, lines in (("s.h5 >/dev/full", 4, 1), ("t.h5 | exec true", 141, 0)):
            said = subprocess.run(["bash", "-o", "pipefail", "-c", f"{command} {sink}"], stderr=subprocess.PIPE, text=True,
                                  env={**os.environ, "PYTHONPATH": str(SOURCE / "python")}, cwd=self.folder)
            self.assertEqual((said.returncode, len(said.stderr.splitlines())), (code, lines), said.stderr)
            self.assertTrue((self.folder / sink.split()[0]).exists())

    def test_of_the_program(self):
        """As of the package, whatever the folder is; its exit codes."""
        def program(*words):
            return subprocess.run([os.environ["BAGNOLD_PROGRAM"], "import", *map(str, words)], capture_output=True, text=True,
                                  cwd=self.folder)

        self.file(DATA)
        said = program("x.data", "--out", "s.h5", "--strain-rate=-1e-2")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertEqual(tomllib.loads(said.stdout)["disks"]["count"], 4)
        self.assertTrue((self.folder / "s.h5").exists())
        self.file("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 6 2\n0 6 0\n0 1 0\n"
                  "ITEM: ATOMS id x y radius\n1 5.5 1 0.5\n2 7 4 0.7\n", "x.dump")
        self.assertEqual(program("x.dump", "--out", "b.h5").returncode, 2)
        for bounds, length in (("edges", 6), ("outer", 4)):
            self.assertEqual(program("x.dump", "--out", "b.h5", "--bounds", bounds).returncode, 0)
            self.assertEqual(bagnold.frames.read_states(self.folder / "b.h5")[0].box.length, length)
        self.assertEqual(program("x.dump", "--out", "b.h5", "--bounds", "inner").returncode, 2)
        self.assertEqual(program("no.data", "--out", "t.h5").returncode, 4)
        wrong = program("x.data", "--out", "t.h5", "--diameters", "1=x")
        self.assertEqual((wrong.returncode, len(wrong.stderr.splitlines())), (2, 1))


if __name__ == "__main__":
    unittest.main()
