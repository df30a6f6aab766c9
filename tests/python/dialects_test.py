# SPDX-License-Identifier: BSD-3-Clause
"""Imports of what other programs write a little differently: read where it can mean one thing alone, which is said, and
refused with what was found where it can mean more."""

import collections
import random as randomness
import unittest

import numpy as np

import writers
from import_test import DATA, XYZ, Import
from made import bagnold

PLACES = [[1, 1], [4, 1], [1, 4], [4, 4]]


def dump(rows, columns, bounds="0 6\n0 6\n-0.5 0.5", words="pp pp pp", before="", step="0", count=4):
    return (f"{before}ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{count}\nITEM: BOX BOUNDS {words}\n{bounds}\n"
            f"ITEM: ATOMS {columns}\n" + "".join(f"{row}\n" for row in rows))


def disks(places, *more):
    """Rows of id, type, x, y and what else each has."""
    return [" ".join(map(str, (k + 1, 1 + k // 2, *place, *(one[k] for one in more)))) for k, place in enumerate(places)]


RADII = (0.5, 0.5, 0.7, 0.7)


class Cells(Import):
    """The lines below ITEM: BOX BOUNDS."""

    def read(self, places, lines, words, columns="id type x y radius", **options):
        path = self.file(dump(disks(places, RADII), columns, lines, words), "x.lammpstrj")
        return self.imported(path, **options)

    def is_box(self, state, length, height, tilt):
        self.assertEqual((state.box.length, state.box.height, state.box.tilt), (length, height, tilt))

    def test_a_third_number_that_nothing_names_is_the_tilt(self):
        places = [[1, 1], [4, 1], [2, 4], [5, 4]]
        for tilt in (2, -2):
            low, high = min(0, tilt), 6 + max(0, tilt)
            for words in ("pp pp pp", "", "p p p", "PP PP FF", "xz xy yz pp pp pp", "xy xz yz", "pp pp pp xy xz yz", "XY XZ YZ pp pp pp"):
                with self.subTest(words=words, tilt=tilt):
                    rows = f"{low} {high} {tilt}\n0 6 0\n-0.5 0.5 0"
                    if words.startswith("xz"):  # in the order of the names
                        rows = f"{low} {high} 0\n0 6 {tilt}\n-0.5 0.5 0"
                    made, state = self.read(places if tilt > 0 else [[1, 1], [4, 1], [0, 4], [3, 4]], rows, words)
                    self.is_box(state, 6, 6, tilt)
                    self.assertEqual("read as tilt" in str(made), "xy" not in words.lower())

    def test_third_numbers_that_are_no_tilt(self):
        for bounds in ("0 6 6\n0 6 6\n-0.5 0.5 1", "0 6 1\n0 6 1\n-0.5 0.5 0"):
            with self.assertRaisesRegex(bagnold.InputError, r"xz = \d.*three numbers.*no xy xz yz"):
                self.read(PLACES, bounds, "pp pp pp")
        made, state = self.read(PLACES, "0 6 0\n0 6 0\n-0.5 0.5 0", "pp pp pp")
        self.is_box(state, 6, 6, 0)

    def test_lines_and_words_that_say_nothing_known(self):
        for bounds, words, expected in (
                ("0 6\n0 6\n-0.5 0.5", "xy xz yz pp pp pp", "lines of 2 numbers .must be 3 each"),
                ("0 8 2\n0 6\n-0.5 0.5", "pp pp pp", "lines of 2 and 3 numbers"),
                ("0 6 0 0\n0 6 0 0\n-0.5 0.5 0 0", "pp pp pp", "lines of 4 numbers"),
                ("0 8 2\n0 6 0\n-0.5 0.5 0", "tilt pp pp pp", "BOX BOUNDS 'tilt pp pp pp'"),
                ("0 8 2\n0 6 0\n-0.5 0.5 0", "xy pp pp pp", "BOX BOUNDS 'xy pp pp pp'"),
                ("0 8 2\n0 6 0\n-0.5 0.5 0", "xy xz yz pp", "BOX BOUNDS 'xy xz yz pp'"),
                ("0 6\n0 6\n-0.5 0.5", "0 6 0 6 -0.5 0.5", "BOX BOUNDS '0 6"),
                ("0 6 wide\n0 6\n-0.5 0.5", "pp pp pp", "'wide' is not known behind the bounds of x"),
                ("0 6 ylo yhi\n0 6 xlo xhi\n-0.5 0.5", "pp pp pp", "'ylo' is not known behind the bounds of x"),
                ("0 6\n0 6\n-0.5 0.5", "pp fs pp", "boundary along y is fs"),
                ("0 six\n0 6\n-0.5 0.5", "pp pp pp", "'six' is no number"),
                ("6\n6\n1", "pp pp pp", "must be two numbers"),
                ("0 6\n", "pp pp pp", "1 lines"),
                ("0 6\n0 6\n0 1\n0 1", "pp pp pp", "4 lines"),
                ("6 0\n0 6\n0 1", "pp pp pp", "must be above 0")):
            with self.subTest(bounds=bounds, words=words), self.assertRaisesRegex(bagnold.InputError, expected):
                self.read(PLACES, bounds, words)

    def test_bounds_that_are_xlo_and_xhi_are_not_taken_for_those_of_lammps(self):
        """Both cells are told, and an option says which."""
        for tilt, places in ((2, [[1, 1], [5.5, 1], [2, 4], [7, 4]]), (-2, [[0, 1], [5, 1], [-1, 4], [4, 4]])):
            bounds = f"0 6 {tilt}\n0 6 0\n-0.5 0.5 0"
            for words in ("xy xz yz pp pp pp", "pp pp pp"):
                with self.subTest(tilt=tilt, words=words):
                    with self.assertRaisesRegex(bagnold.InputError, "L_x = 4.*L_x = 6.*--bounds outer or --bounds edges"):
                        self.read(places, bounds, words)
                    _, state = self.read(places, bounds, words, bounds="edges")
                    self.is_box(state, 6, 6, tilt)
                    _, state = self.read(places, bounds, words, bounds="outer")
                    self.is_box(state, 4, 6, -2)  # 2 of 4 is half a width

    def test_disks_in_the_rectangle_of_the_lengths(self):
        """As codes that move images have them: as LAMMPS' bounds those of a narrower box."""
        bounds = "0 6 2\n0 6 0\n-0.5 0.5 0"
        with self.assertRaisesRegex(bagnold.InputError, "L_x = 4.*L_x = 6"):
            self.read([[1, 1], [5.5, 1], [0.2, 4], [4, 4]], bounds, "xy xz yz pp pp pp")
        _, state = self.read([[1, 1], [3.5, 1], [0.2, 4], [2.5, 4]], bounds, "xy xz yz pp pp pp")
        self.is_box(state, 4, 6, -2)

    def test_disks_that_left_the_cell_between_two_lists(self):
        """By less than LAMMPS lets them, on either side: both cells are told."""
        bounds = "0 8 2\n0 6 0\n-0.5 0.5 0"
        for places in ([[0.2, 1], [3, 1.5], [4.5, -0.1], [7.5, 4]], [[0.2, 1], [3, 1.5], [4.5, 0.1], [7.45, 4]]):
            made, state = self.read(places, bounds, "xy xz yz pp pp pp", strain_rate=0)
            self.is_box(state, 6, 6, 2)
            self.assertIn("outside the cell by up to 0.2, as LAMMPS lets them between two lists; --bounds edges", str(made))
        with self.assertRaisesRegex(bagnold.InputError, "L_x = 6.*L_x = 8"):  # farther
            self.read([[0.2, 1], [3, 1.5], [4.5, 0.1], [7.6, 4]], bounds, "xy xz yz pp pp pp")
        with self.assertRaisesRegex(bagnold.InputError, "L_x = 5.9.*L_x = 6"):  # as far as another box were wider
            self.read([[1, 1], [5.97, 1], [2, 4], [4, 4]], "0 6 0.1\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")

    def test_bounds_that_cannot_hold_the_tilt(self):
        made, state = self.read([[1, 1], [4, 1], [6, 4], [9, 4]], "0 6 7\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")
        self.is_box(state, 6, 6, 1)
        self.assertIn("read as xlo and xhi", str(made))
        with self.assertRaisesRegex(bagnold.InputError, "say --bounds edges"):
            self.read(PLACES, "0 6 7\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp", bounds="outer")

    def test_positions_that_are_scaled_or_unwrapped_tell_by_overlaps(self):
        """Disks that lie on each other in one of the two cells alone."""
        rows = disks([[0.05, 0.1], [0.6, 0.1], [0.05, 0.6], [0.6, 0.6]], RADII)
        text = dump(rows, "id type xs ys radius", "0 6 2\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")
        made, state = self.imported(self.file(text, "x.dump"))
        self.is_box(state, 4, 6, -2)
        self.assertIn("L_x = 4.0; --bounds edges reads them as xlo and xhi, L_x = 6.0: positions of this kind do not tell", str(made))
        near = self.file(text.replace(" 0.6 0.1", " 0.9 0.1"), "x.dump")
        self.refused("relative overlap 0.4 with L_x = 4, 0.1 with L_x = 6 .*--bounds edges", near)
        rows = disks([[0.05, 0.1], [0.5, 0.1], [0.05, 0.6], [0.25, 0.6]], RADII)  # beside each other within the box
        near = self.file(dump(rows, "id type xs ys radius", "0 6 2\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp"), "x.dump")
        self.refused("relative overlap 0.42.* with L_x = 4, 0.14.* with L_x = 6 .*--bounds edges", near)
        rows = disks([[1, 1], [5.3, 1], [2, 4], [6.2, 4]], RADII)
        text = dump(rows, "id type xu yu radius", "0 6 2\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")
        self.refused("relative overlap 0.8.* with L_x = 4, 0 with L_x = 6 .*--bounds edges", self.file(text, "x.dump"))
        _, state = self.imported(self.file(text, "x.dump"), bounds="edges")
        self.is_box(state, 6, 6, 2)

    def test_masses_that_differ_within_a_size(self):
        text = dump([f"{row} {mass}" for row, mass in zip(disks(PLACES, RADII), (0.1, 1.9, 1, 1))], "id type x y radius mass")
        made, _ = self.imported(self.file(text, "x.dump"))
        self.assertIn("masses of disks of one size differ by up to 1.8", str(made))
        self.assertNotIn("mass", made.scene["disks"])

    def test_more_rows_than_atoms(self):
        self.refused("has 4 of 3 atoms; mend ITEM: NUMBER OF ATOMS", self.file(dump(disks(PLACES, RADII), "id type x y radius", count=3), "x.dump"))

    def test_words_behind_the_numbers(self):
        for bounds in ("0 6 xlo xhi\n0 6 ylo yhi\n-0.5 0.5 zlo zhi", "0 6 XLO XHI\n0 6\n-0.5 0.5"):
            _, state = self.read(PLACES, bounds, "pp pp pp")
            self.is_box(state, 6, 6, 0)
        with self.assertRaisesRegex(bagnold.InputError, "L_x = 4.*L_x = 6.*say xlo xhi"):
            self.read([[1, 1], [3, 1], [2, 4], [4, 4]], "0 6 2 xlo xhi xy\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")
        _, state = self.read([[1, 1], [3, 1], [2, 4], [4, 4]], "0 6 2 xlo_bound xhi_bound xy\n0 6 0\n-0.5 0.5 0", "xy xz yz pp pp pp")
        self.is_box(state, 4, 6, -2)

    def test_vectors(self):
        """A general triclinic cell is read where its vectors lie as they must; LAMMPS turns others, by its own words."""
        bounds = "6 0 0 -3\n2 6 0 -3\n0 0 1 -0.5"
        _, state = self.read([[-2, -2], [1, -2], [0, 1], [3, 1]], bounds, "abc origin pp pp pp")
        self.is_box(state, 6, 6, 2)
        np.testing.assert_array_equal(state.position, [[1, 1], [4, 1], [3, 4], [0, 4]])
        for wrong in ("6 2 0 -3\n0 6 0 -3\n0 0 1 -0.5", "6 0 0\n2 6 0\n0 0 1"):
            with self.assertRaisesRegex(bagnold.InputError, "`dump_modify ID triclinic/general no`"):
                self.read(PLACES, wrong, "abc origin pp pp pp")

    def test_two_lines_are_a_plane(self):
        _, state = self.read(PLACES, "0 6\n0 6", "pp pp")
        self.is_box(state, 6, 6, 0)

    def test_cells_of_data_files(self):
        for new, expected in (("-4.0 0.0 0.0 xy", "'-4.0 0.0 0.0 xy' in the header"), ("-4.0 tilt", "'-4.0 tilt' in the header"),
                              ("xy xz yz -4.0 0.0 0.0", "in the header"), ("-4.0 0.0 xy xz yz", "must be three"),
                              ("1 0 0 avec", "three numbers each of avec, bvec, cvec, abc origin.*`write_data FILE`, without")):
            self.refused_with("-4.0 0.0 0.0 xy xz yz", new, expected, DATA, "lammps")
        self.refused_with("-10.0 10.0 xlo xhi", "-10.0 10.0 -4.0 xlo xhi xy", "in the header", DATA, "lammps")
        edges = DATA[DATA.index("-10.0 10.0"):DATA.index("\nAtoms")]
        vectors = "20 0 0 avec\n-4 10 0 bvec\n0 0 1 cvec\n-10 -5 -0.5 abc origin\n"
        _, state = self.imported(self.file(DATA.replace(edges, vectors)))
        _, expected = self.imported(self.file(DATA))
        self.assertEqual(state.box, expected.box)
        np.testing.assert_array_equal(state.position, expected.position)
        self.refused_with(edges, vectors.replace("20 0 0", "20 1 0"), "LAMMPS turns it so by `write_data FILE`", DATA, "lammps")
        _, state = self.imported(self.file(DATA.replace("xlo xhi", "XLO XHI").replace("Atoms # sphere", "ATOMS # Sphere")))
        self.assertEqual(state.box, expected.box)

    def test_deep_overlaps_are_not_to_be_relaxed(self):
        """Above one half the box is another, as a rule."""
        made, _ = self.read([[1, 1], [1.4, 1], [2, 4], [5, 4]], "0 6\n0 6\n-0.5 0.5", "pp pp pp")
        self.assertIn("largest relative overlap: 0.6, above 0.5: no packing has such (the box, L_x = 6", str(made))
        self.assertNotIn("relax", str(made))


class Rows(Import):
    """As many words as names, in every format and section."""

    def test_dumps(self):
        rows = disks(PLACES, RADII)
        for names, count in (("id type x y", 5), ("id type x y radius vx", 5), ("id type x", 5)):
            self.refused(f"line 10: {count} columns .must be {len(names.split())}, {names}", self.file(dump(rows, names), "x.dump"))
        rows[2] += " 0.1"
        self.refused("line 12: 6 columns", self.file(dump(rows, "id type x y radius"), "x.dump"))

    def test_extended_xyz(self):
        for old, new in (("B 8.0 4.0 0.0 0.7", "B 8.0 4.0 0.0 0.7 1"), (":radius:R:1", ""), ("pos:R:3", "pos:R:2"),
                         ("Properties=species:S:1:pos:R:3:radius:R:1 ", "")):
            self.refused_with(old, new, r"line \d: [56] columns .must be [45], ", XYZ, "extxyz")

    def test_data_files(self):
        for old, new, expected in (
                ("9.0 4.0 0.0 0 0 0", "9.0 4.0 0.0", "row 2: 10 columns .must be 7"),  # one without images
                ("11.0 0.0 0.0 0 0 0", "11.0 0.0 0.0", "row 3: 7 columns .must be 10"),
                ("9.0 4.0 0.0 0 0 0", "9.0 4.0 0.0 0 0 0 0", "row 1: 11 columns"),
                ("3 0.5 -0.1 0.0 0.0 0.0 -0.25", "3 0.5 -0.1 0.0", "row 3: 4 columns .must be 7"),
                ("4 0.0 0.0 0.0 0.0 0.0 0.0\n", "4 0.0 0.0 0.0 0.0 0.0 0.0\n4 0.0 0.0 0.0 0.0 0.0 0.0\n", "5 rows .must be 4"),
                ("4 0.0 0.0 0.0 0.0 0.0 0.0\n", "3 0.0 0.0 0.0 0.0 0.0 0.0\n", "none of atom 4"),
                ("4 atoms", "4 5 atoms", "4 5 .must be a whole number"),
                (DATA[DATA.index("Velocities\n") + 11:], "\n", "Velocities has none of atom 3"),
                ("Velocities", "Masses\n\n1 1.0 2.0\n\nVelocities", "Masses, row 1: 3 columns"),
                ("Velocities", "Masses\n\n1 1.0\n1 2.0\n2 1\n\nVelocities", "a type twice"),
                ("Velocities", "Atoms # sphere", "section Atoms is there twice"),
                ("4 atoms\n", "4 atoms\n2 0 0\n", "'2 0 0' in the header has no name .*xy xz yz"),
                ("4 atoms\n", "4 atoms\n0 9 xlo xhi\n", "two lines of the header end with xlo xhi"),
                ("4 atoms\n", "4 atoms\n5 atoms\n", "two lines of the header end with atoms")):
            self.refused_with(old, new, expected, DATA, "lammps")

    def test_header_of_a_frame(self):
        good = dump(disks(PLACES, RADII), "id type x y radius")
        for old, new, expected in (("ATOMS\n4\n", "ATOMS\n4 4\n", "NUMBER OF ATOMS: 4 4 .must be a whole number"),
                                   ("TIMESTEP\n0\n", "TIMESTEP\n0 1\n", "TIMESTEP: 0 1 .must be"),
                                   ("TIMESTEP\n0\n", "TIMESTEP\n0\nITEM: TIME\n1 2\n", "TIME: 1 2 .must be a number"),
                                   ("ATOMS\n4\n", "ATOMS\n0\n", "4 of 0 atoms"),
                                   ("0\nITEM: NUMBER", "0x\nITEM: NUMBER", "'0x' is no number"),
                                   ("1 1 1 1 0.5", "1 1 1_0 1 0.5", "'1_0' is no number"),
                                   ("1 1 1 1 0.5", "1 1 1 1 1,0", "'1,0' is no number")):
            self.refused_with(old, new, expected, good, "dump", 1)

    def test_the_table_beside_a_dump(self):
        path = self.file(dump(disks(PLACES, RADII), "id type x y radius"), "x.lammpstrj")
        table = "step,time,strain,strain_rate,tilt\n0,2.5,0.1,0.01,0.0\n"
        self.file(table, "x.frames.csv")
        made, state = self.imported(path)
        self.assertEqual((state.time, state.strain_rate), (2.5, 0.01))
        self.assertIn("strain rate of x.frames.csv", str(made))
        for old, new, expected in (("0.01,0.0", "0.01,1.0", "tilt 1.0 at step 0 .must be that of x.lammpstrj, 0.0"),
                                   ("0,2.5,0.1", "0,2.5", "must have the columns step,time"), ("0.01,0.0\n", "0.01,0.0", "no end of line")):
            self.assertIn(old, table)
            self.file(table.replace(old, new), "x.frames.csv")
            self.refused(expected, path)
        self.file(table.replace("\n0,", "\n7,"), "x.frames.csv")
        self.assertIsNone(self.imported(path)[0].scene.get("shear"))

    def test_numbers_of_fortran(self):
        rows = [row.replace("0.5", "5.0D-1").replace("0.7", "0.7d+00") for row in disks(PLACES, RADII)]
        _, state = self.imported(self.file(dump(rows, "id type x y radius"), "x.dump"))
        np.testing.assert_array_equal(state.diameter, [1, 1, 1.4, 1.4])


class Ends(Import):
    """Files that are cut, orders, times."""

    def test_cut_within_the_last_number(self):
        """Every cut is refused, or leaves what was whole."""
        texts = {"x.dump": dump(disks(PLACES, RADII, [0.25] * 4), "id type x y radius vx").replace("radius vx", "radius vx vy").replace(
            " 0.25\n", " 0.25 0.125\n"), "x.xyz": XYZ.replace("R:1", "R:1:velo:R:2").replace("0.5\n", "0.5 0.1 0.25\n").replace(
                "0.7\n", "0.7 0.1 0.25\n"), "x.data": DATA}
        for name, text in texts.items():
            _, whole = self.imported(self.file(text, name))
            for end in range(1, 12):
                with self.subTest(name=name, end=end):
                    self.refused("no end of line|columns|ends within a frame|of 4 atoms|none of atom|no number", self.file(text[:-end], name))
            two = self.file(text[:0] + text + text[:-1], name)
            if name == "x.data":
                continue
            self.refused("no end of line", two)
            _, first = self.imported(two, frame=0)
            np.testing.assert_array_equal(first.velocity, whole.velocity)

    def test_ids_order_extended_xyz(self):
        head = '4\nLattice="6 0 0 0 6 0 0 0 1" Properties={}:I:1:species:S:1:radius:R:1:pos:R:2 pbc="T T F"\n'
        rows = "3 He 0.7 1 4\n1 H 0.5 1 1\n4 He 0.7 4 4\n2 H 0.5 4 1\n"
        for name in ("id", "ID", "ParticleIdentifier", "identifier"):
            with self.subTest(name=name):
                _, state = self.imported(self.file(head.format(name) + rows, "x.xyz"))
                np.testing.assert_array_equal(state.position, PLACES)
                np.testing.assert_array_equal(state.diameter, [1, 1, 1.4, 1.4])
        self.refused("disk 3 is there twice", self.file(head.format("id") + rows.replace("4 He", "3 He"), "x.xyz"))
        self.refused("id: 1.5 .must be a whole", self.file(head.format("id") + rows.replace("1 H", "1.5 H"), "x.xyz"))
        self.refused("id: 1.5 .must be a whole", self.file(dump(["1.5 1 1 1 0.5", *disks(PLACES, RADII)[1:]], "id type x y radius"), "x.dump"))

    def test_times_before_and_behind_the_step(self):
        def frames(order):
            text = ""
            for k in (1, 2, 3):
                items = {"UNITS": "ITEM: UNITS\nlj\n" if k == 1 else "", "TIME": f"ITEM: TIME\n{11 * k}\n", "STEP": ""}
                one = dump(disks([[1 + 0.1 * k, 1], *PLACES[1:]], RADII), "id type x y radius", step=str(100 * k))
                step, rest = one.split("ITEM: NUMBER")
                items["STEP"] = step
                text += "".join(items[name] for name in order) + "ITEM: NUMBER" + rest
            return self.file(text, "x.lammpstrj")

        for order in (("UNITS", "TIME", "STEP"), ("TIME", "UNITS", "STEP"), ("STEP", "UNITS", "TIME"), ("UNITS", "STEP", "TIME")):
            path = frames(order)
            for frame in (0, 1, 2, -1):
                with self.subTest(order=order, frame=frame):
                    _, state = self.imported(path, frame=frame)
                    k = frame % 3 + 1
                    self.assertEqual((state.time, state.position[0, 0]), (11 * k, 1 + 0.1 * k))

    def test_a_frame_that_was_cut_before_its_atoms(self):
        """As of a run that was killed and goes on in the same file: refused alone."""
        one = dump(disks(PLACES, RADII), "id type x y radius")
        for end in ("ITEM: ATOMS", "ITEM: BOX", "ITEM: NUMBER"):
            path = self.file("ITEM: TIME\n1\n" + one[:one.index(end)] + "ITEM: TIME\n2\n" + one, "x.dump")
            _, state = self.imported(path)
            self.assertEqual(state.time, 2)
            self.refused("has no ITEM: ", path, frame=0)

    def test_a_step_that_is_a_time(self):
        text = dump(disks(PLACES, RADII), "id type x y radius", step="0.500000")
        made, state = self.imported(self.file(text, "x.dump"))
        self.assertEqual(state.time, 0.5)
        self.assertIn("TIMESTEP 0.5 is written as no whole number: read as the time", str(made))
        for word, time in (("5.0", 5), ("1e2", 100), ("100", 0)):
            _, state = self.imported(self.file(text.replace("0.500000", word), "x.dump"))
            self.assertEqual(state.time, time, word)
        _, state = self.imported(self.file("ITEM: TIME\n7\n" + text, "x.dump"))
        self.assertEqual(state.time, 7)


class Words(Import):
    """Names, marks and truths."""

    def xyz(self, old, new, **options):
        self.assertIn(old, XYZ)
        return self.imported(self.file(XYZ.replace(old, new), "x.xyz"), **options)

    def test_boundaries_of_extended_xyz(self):
        for value in ('"1 1 0"', "[T, T, F]", "[True, True, False]", '"T T T"', "{T T F}", "T,T,F", '"t t f"', '"true true false"', "'T T F'",
                      "TTF", "[1,1,0]", "T", '"p p f"', "T T F", '"[T, T, F]"', '"T T"', '".true. .true. .false."', "(1 1 0)"):
            for key in ("pbc=", "PBC=", "pbc = "):
                with self.subTest(value=value, key=key):
                    self.xyz('pbc="T T F"', key + value)
        for value, expected in (('"0 1 0"', "along x is F"), ("[T, F, F]", "along y is F"), ("T F F", "along y is F"), ("F", "along x is F"),
                                ('"False True True"', "along x is F"), ("F T", "along x is F")):
            self.refused_with('pbc="T T F"', "pbc=" + value, expected, XYZ, "extxyz")
        for value in ('"yes yes no"', '"2 2 0"', '""', '"T T F F"', '"T ? F"'):
            self.refused_with('pbc="T T F"', "pbc=" + value, "pbc = .*must be T or F of each axis", XYZ, "extxyz")
        self.refused_with('pbc="T T F"', "pbc=[T, T, F", r"'\[T, T, F' .must end with \]", XYZ, "extxyz")
        self.assertIn("no pbc: periodic", str(self.xyz('pbc="T T F"', "")[0]))

    def test_lattices(self):
        full = 'Lattice="20.0 0.0 0.0 -4.0 10.0 0.0 0.0 0.0 1.0"'
        _, expected = self.imported(self.file(XYZ, "x.xyz"))
        for value in ('Lattice="20 0 -4 10"', 'Lattice="20 0 0 -4 10 0"', 'Lattice="20 10 1 -4 0 0"', 'LATTICE="20 0 0 -4 10 0 0 0 1"',
                      "Lattice=[[20, 0, 0], [-4, 10, 0], [0, 0, 1]]", "lattice={20 0 0 -4 10 0 0 0 1}", 'Lattice="20, 0, 0, -4, 10, 0, 0, 0, 1"',
                      'Lattice="20 0 -4 10 0 0"', "Lattice=20 0 0 -4 10 0 0 0 1", 'Lattice = "20 0 0 -4 10 0 0 0 1"'):
            with self.subTest(value=value):
                made, state = self.xyz(full, value)
                self.assertEqual(state.box, expected.box)
                np.testing.assert_array_equal(state.position, expected.position)
                found = [word for word in value.replace(",", " ").split("=")[1].strip(' "{[').replace("[", "").split() if word[0].isdigit() or word[0] == "-"]
                self.assertEqual("read as" in str(made), len(found) in (4, 6))
        _, state = self.xyz(full, 'Lattice="20 10 1 90 90 60"')
        np.testing.assert_allclose((state.box.length, state.box.height, state.box.tilt), (10 * 2, 10 * 3**0.5 / 2, 5), rtol=1e-14)
        for numbers in ("20 10 1", "20 -4 0 10", "20 10 0 0", "0 20 0 10", "20 10 1 0 0 -4", "0 20 0 10 0 1", "-10 10 -5 5 0 1", "20 10 1 4 2 0",
                        "20 0 0 -4 10", "20", "1 1 1 1 1 1", "0 0 0 0"):
            self.refused_with(full, f'Lattice="{numbers}"', f"Lattice has {len(numbers.split())} numbers, {numbers} ", XYZ, "extxyz")

    def test_names(self):
        """As LAMMPS, OVITO, ASE and QUIP call them, in capitals or not."""
        rows = "".join(f"{k} {kind} {x} {y} 0 {r} 2 0.25 {v} 0 0.125\n" for k, kind, x, y, r, v in (
            (1, "A", 1, 1, 0.5, -1), (2, "A", 5, 2, 0.5, 1), (3, "B", 8, 4, 0.7, 2), (4, "B", 11, 8, 0.7, 3)))
        head = '4\nLattice="20 0 0 -4 10 0 0 0 1" Properties={}:I:1:{}:S:1:{}:R:3:{}:R:1:{}:R:1:{}:R:3:{}:R:1 pbc="T T F"\n'
        for names in (("id", "species", "pos", "radius", "mass", "velo", "spin"), ("ID", "Species", "Pos", "RADIUS", "Mass", "VELO", "Omega"),
                      ("ParticleIdentifier", "ParticleType", "Position", "Radius", "Mass", "Velocity", "AngularVelocity"),
                      ("id", "element", "positions", "radii", "masses", "vel", "angular_velocity"),
                      ("id", "symbols", "positions", "Radius", "masses", "velocities", "omega")):
            with self.subTest(names=names):
                made, state = self.imported(self.file(head.format(*names) + rows, "x.xyz"))
                np.testing.assert_array_equal(state.velocity, [[0.25, -1], [0.25, 1], [0.25, 2], [0.25, 3]])
                np.testing.assert_array_equal(state.spin, [0.125] * 4)
                np.testing.assert_array_equal(state.diameter, [1, 1, 1.4, 1.4])
                self.assertEqual(made.scene["disks"]["mass"], "equal")
        for names in ("ID TYPE X Y Z RADIUS MASS VX VY VZ OMEGAZ", "id Particle_Type Position.X Position.Y Position.Z Radius Mass Velocity.X "
                      "Velocity.Y Velocity.Z AngularVelocityZ", "id type x y z radius mass vel_x vel_y vel_z omega_z",
                      "id element PositionX PositionY PositionZ radius mass v_x v_y v_z spinz"):
            with self.subTest(names=names):
                made, state = self.imported(self.file(dump(rows.splitlines(), names, "0 20\n0 10\n-0.5 0.5"), "x.dump"))
                np.testing.assert_array_equal(state.velocity, [[0.25, -1], [0.25, 1], [0.25, 2], [0.25, 3]])
                np.testing.assert_array_equal(state.spin, [0.125] * 4)
        lower = dump(disks(PLACES, RADII), "id type x y radius").lower().replace("item: ", "ITEM:")
        self.assertEqual(self.imported(self.file(lower, "x.dump"))[1].box.length, 6)

    def test_what_is_not_read_is_told(self):
        rows = disks(PLACES, RADII, range(4), range(4))
        made, _ = self.imported(self.file(dump(rows, "id type x y radius c_v[1] fx"), "x.dump"))
        self.assertIn("columns that are not read: c_v[1] fx", str(made))
        made, _ = self.imported(self.file(dump(disks(PLACES, RADII, RADII), "id type x y radius \u202ered"), "x.dump"))
        self.assertIn("columns that are not read: ?red", str(made))
        self.refused(r"no diameters .columns that are not read: size", self.file(dump(disks(PLACES, RADII), "id type x y size"), "x.dump"))

    def test_one_quantity_twice(self):
        """As in `id type type` of LIGGGHTS: where both say the same."""
        rows = [" ".join((row.split()[0], row)) for row in disks(PLACES, RADII, np.multiply(RADII, 2))]
        _, state = self.imported(self.file(dump(rows, "id id type x y radius diameter"), "x.dump"))
        np.testing.assert_array_equal(state.position, PLACES)
        rows = disks(PLACES, [2, 2, 1, 1], RADII)
        self.imported(self.file(dump(rows, "id type x y type radius"), "x.dump"))
        for names, expected in (("id type x y x radius", "x and x differ"), ("id type x y diameter radius", "2 radius and diameter differ"),
                                ("id type x y id radius", "id and id differ")):
            self.refused(expected, self.file(dump(rows, names), "x.dump"))
        about = XYZ.replace("radius:R:1", "radius:R:1:masses:R:1:velo:R:2:momenta:R:2")
        rows = [row + f" 2 0.5 {k} 1 {2 * k}" for k, row in enumerate(about.splitlines()[2:])]
        text = "\n".join(about.splitlines()[:2] + rows) + "\n"
        _, state = self.imported(self.file(text, "x.xyz"))
        np.testing.assert_array_equal(state.velocity, [[0.5, k] for k in range(4)])
        slow = text.replace(" 2 0.5 0 1 0\n", " 2 0.00001234 0 0.00002467 0\n")  # rounded each for itself
        slow = slow.replace("2 0.5 1 1 2", "2 0 0 0 0").replace("2 0.5 2 1 4", "2 0 0 0 0").replace("2 0.5 3 1 6", "2 0 0 0 0")
        self.assertEqual(self.imported(self.file(slow, "x.xyz"))[1].velocity.tolist()[0], [1.234e-5, 0])
        self.refused("velocities and momenta over masses differ", self.file(text.replace(" 1 6\n", " 1 5\n"), "x.xyz"))

    def test_widths_and_axes(self):
        for names in ("id type x z radius", "id type xu z radius"):
            self.refused("and no y", self.file(dump(disks(PLACES, RADII), names), "x.dump"))
        self.refused("has vx and no vy", self.file(dump(disks(PLACES, RADII, RADII), "id type x y radius vx"), "x.dump"))
        for new in ("radius:R:1:velo:R:1", "radius:R:1:spin:R:2", "pos:R:2:mass:R:2"):
            count = sum(map(int, new.split(":")[2::3]))
            text = "\n".join(XYZ.replace("pos:R:3:radius:R:1", new if "pos" in new else "pos:R:3:" + new).splitlines()[:2])
            rows = "".join("A " + "1 " * (count + 3 * ("pos" not in new)) + "\n" for _ in range(4))
            self.refused("columns .must be 1|columns .must be 2 or 3|columns .must be 1 or 3", self.file(f"{text}\n{rows}", "x.xyz"))
        self.refused(r"xs ys from 1 to 4 .must be within 0 and 1", self.file(dump(disks(PLACES, RADII), "id type xs ys radius"), "x.dump"))
        self.refused("mass of atom 1 = 0.0", self.file(dump(disks(PLACES, RADII, [0] * 4), "id type x y radius mass"), "x.dump"))

    def test_encodings(self):
        texts = {"x.data": DATA, "x.xyz": XYZ, "x.dump": dump(disks(PLACES, RADII), "id type x y radius")}
        for name, text in texts.items():
            for format in (None, {"x.data": "lammps", "x.xyz": "extxyz", "x.dump": "dump"}[name]):
                path = self.file(text, name)
                _, expected = self.imported(path, format=format)
                for encoding in ("utf-8-sig", "utf-16", "utf-16-le"):
                    with self.subTest(name=name, encoding=encoding, format=format):
                        path.write_bytes((text if encoding != "utf-16-le" else "\ufeff" + text).replace("\n", "\r\n").encode(encoding))
                        _, state = self.imported(path, format=format)
                        np.testing.assert_array_equal(state.position, expected.position)
                        self.assertEqual(state.box, expected.box)
        path = self.folder / "y.data"
        path.write_bytes("Körner\n".encode("latin-1") + DATA.split("\n", 1)[1].encode())
        self.imported(path)
        path.write_bytes(DATA.encode() + b"\xe9" * 3 + b"\x00\x01")
        with self.assertRaisesRegex(bagnold.FileError, "no text"):
            bagnold.import_state(path, self.folder / "z.h5")

    def test_the_corner_that_ovito_writes(self):
        rows = "A -9 -4 0 0.5\nA -5 -3 0 0.5\nB -2 -1 0 0.7\nB 1 3 0 0.7\n"
        head = '4\nLattice="20 0 0 -4 10 0 0 0 1" {}="-10 -5 -0.5" Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3 pbc="T T F"\n'
        rows = rows.replace("5\n", "5 1 0 0\n").replace("7\n", "7 2 0 0\n")
        _, expected = self.imported(self.file(XYZ, "x.xyz"))
        for key in ("Origin", "cell_origin"):
            _, state = self.imported(self.file(head.format(key) + rows, "x.xyz"))
            np.testing.assert_array_equal(state.position, expected.position)
            np.testing.assert_array_equal(state.velocity, [[1, 0], [1, 0], [2, 0], [2, 0]])

    def test_the_line_of_keys(self):
        for text in ('comment="two words" ', "energy=1.5 ", "step=3 time=2 ", 'note={a b} ', '"quoted key"=1 ', "alone "):
            self.xyz('pbc="T T F"', text + 'pbc="T T F"')
        for text, expected in (("time=2 time=3 ", "time is there twice"), ('="x" ', "must be KEY=VALUE"), ("time=soon ", "'soon' is no number")):
            self.refused_with('pbc="T T F"', text + 'pbc="T T F"', expected, XYZ, "extxyz")
        _, state = self.xyz('pbc="T T F"', 'Time=2.5 pbc="T T F"')
        self.assertEqual(state.time, 2.5)


class AtRandom(Import):
    """Made configurations as many programs write them, spoiled now and then: what scripts/attack does for longer."""

    def test_files_are_read_as_they_were_written_or_refused(self):
        done = collections.Counter()
        for seed in range(400):
            random = randomness.Random(seed)
            truth = writers.made(random)
            written = random.choice(writers.WRITERS)(random, truth)
            path = self.folder / "x.txt"
            path.write_bytes(written.data)
            with self.subTest(seed=seed, file=written.data):
                try:
                    made = bagnold.import_state(path, self.folder / "state.h5", tolerance=1e-4, **written.options)
                except bagnold.Error as error:
                    done["refused"] += 1
                    self.assertTrue(written.spoiled or written.unclear, error)
                    continue
                done["read"] += 1
                self.assertEqual(written.spoiled, "")
                (state,) = bagnold.frames.read_states(made.path)
                self.assertEqual(writers.wrong(truth, written, made, state), "", made)
        self.assertGreater(min(done.values()), 100, done)


if __name__ == "__main__":
    unittest.main()
