# SPDX-License-Identifier: BSD-3-Clause
"""Exports read back: by plain readers written here, and by MDAnalysis, ASE, gsd, VTK and OVITO where they
are installed."""

import base64
import csv
import dataclasses
import importlib.util
import math
import os
import pathlib
import struct
import subprocess
import sys
import unittest
import unittest.mock
import xml.etree.ElementTree

import numpy as np

from made import SOURCE, Folder, bagnold, with_frames


def needs(*modules):
    missing = [name for name in modules if not importlib.util.find_spec(name)]
    return unittest.skipIf(missing, f"{', '.join(missing)} is not installed")


def lammps_frames(path):
    """[(step, bounds [3][3], {column: values})] of a dump."""
    lines, out, at = path.read_text().splitlines(), [], 0
    while at < len(lines):
        assert lines[at] == "ITEM: TIMESTEP", lines[at]
        step, count = int(lines[at + 1]), int(lines[at + 3])
        assert lines[at + 2] in ("ITEM: NUMBER OF ATOMS", "ITEM: NUMBER OF ENTRIES")
        assert lines[at + 4] == "ITEM: BOX BOUNDS xy xz yz pp pp pp"
        bounds = [[float(word) for word in line.split()] for line in lines[at + 5:at + 8]]
        names = lines[at + 8].split()[2:]
        rows = np.array([line.split() for line in lines[at + 9:at + 9 + count]], dtype=float).reshape(count, len(names))
        out.append((step, bounds, dict(zip(names, rows.T))))
        at += 9 + count
    return out


def extxyz_frames(path):
    """[(words of the second line, {property: [N, k]})]."""
    lines, out, at = path.read_text().splitlines(), [], 0
    while at < len(lines):
        count = int(lines[at])
        words, rest = {}, lines[at + 1]
        while rest:
            key, _, rest = rest.partition("=")
            value, _, rest = rest[1:].partition('" ') if rest.startswith('"') else rest.partition(" ")
            words[key] = value.strip('"')
        rows = [line.split() for line in lines[at + 2:at + 2 + count]]
        columns, first = {}, 0
        properties = words["Properties"].split(":")
        for name, kind, number in zip(properties[::3], properties[1::3], map(int, properties[2::3])):
            part = [row[first:first + number] for row in rows]
            columns[name] = np.array(part, dtype={"S": str, "R": float, "I": int}[kind])
            first += number
        out.append((words, columns))
        at += 2 + count
    return out


def vtp(path):
    """{section: {array: values}} of a PolyData file."""
    out = {}
    piece = xml.etree.ElementTree.parse(path).getroot().find("PolyData")
    for section in ("FieldData", "PointData", "CellData", "Points", "Verts", "Lines"):
        for array in piece.iter(section):
            for one in array.findall("DataArray"):
                values = np.zeros(0)
                if one.get("format") == "binary":
                    raw = base64.b64decode(one.text)
                    length, = struct.unpack("<Q", raw[:8])
                    assert length == len(raw) - 8
                    values = np.frombuffer(raw[8:], {"Float64": "<f8", "Int64": "<i8"}[one.get("type")])
                    if one.get("NumberOfComponents"):
                        values = values.reshape(-1, int(one.get("NumberOfComponents")))
                out.setdefault(section, {})[one.get("Name")] = values
    return out


class Exports(Folder):
    def export(self, to, run=None, name="x", **options):
        run = run or with_frames()
        target = self.folder / (name + {"lammps": ".lammpstrj", "extxyz": ".xyz", "gsd": ".gsd", "vtk": ".pvd"}[to])
        written = bagnold.export(run, to, target, **options)
        self.assertEqual(written[0], target)
        self.assertTrue(all(path.exists() for path in written))
        self.assertEqual([path for path in self.folder.rglob("*.part")], [])
        return run, written

    def same_places(self, box, found, position):
        """[N, 2], the same up to cell vectors, and in the cell."""
        away, _ = box.nearest(found - position)
        np.testing.assert_allclose(away, 0, atol=1e-12)
        share = found @ np.linalg.inv(box.matrix[:2, :2])
        self.assertTrue(((share > -1e-12) & (share < 1 + 1e-12)).all())

    def test_lammps(self):
        run, (dump, told) = self.export("lammps")
        found = lammps_frames(dump)
        self.assertEqual(len(found), 9)
        for frame, (step, bounds, columns) in zip(run.frames, found):
            tilt = frame.box.tilt
            self.assertEqual(step, frame.step)
            self.assertEqual(bounds[0], [min(0, tilt), frame.box.length + max(0, tilt), tilt])
            self.assertEqual(bounds[1], [0, frame.box.height, 0])
            self.same_places(frame.box, np.stack([columns["x"], columns["y"]], axis=1), frame.position)
            np.testing.assert_array_equal(columns["vx"], frame.velocity[:, 0])
            np.testing.assert_array_equal(columns["omegaz"], frame.spin)
            np.testing.assert_array_equal(columns["radius"] * 2, frame.diameter)
            np.testing.assert_array_equal(columns["type"], frame.species + 1)
            np.testing.assert_array_equal(columns["id"], np.arange(1, 65))
            if frame.image is not None:
                place = np.stack([columns["x"] + columns["ix"] * frame.box.length + columns["iy"] * tilt,
                                  columns["y"] + columns["iy"] * frame.box.height], axis=1)
                np.testing.assert_allclose(place, frame.unwrapped, atol=1e-12)
        with open(told, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["strain"]) for row in rows], [frame.strain for frame in run.frames])
        self.assertEqual([float(row["time"]) for row in rows], [frame.time for frame in run.frames])

    def test_contacts_in_lammps(self):
        run, (_, _, pairs) = self.export("lammps", contacts=True)
        for contacts, (_, _, columns) in zip(run.contacts, lammps_frames(pairs)):
            np.testing.assert_array_equal(columns["id1"], contacts.i + 1)
            np.testing.assert_array_equal(columns["id2"], contacts.j + 1)
            np.testing.assert_array_equal(columns["overlap"], contacts.overlap)
            np.testing.assert_array_equal(columns["normal_force"], contacts.normal_force)
            np.testing.assert_array_equal(columns["tangential_force"], contacts.tangential_force)

    def test_extxyz(self):
        run, (path,) = self.export("extxyz")
        found = extxyz_frames(path)
        self.assertEqual(len(found), 9)
        for frame, (words, columns) in zip(run.frames, found):
            lattice = np.array(words["Lattice"].split(), dtype=float).reshape(3, 3)
            np.testing.assert_array_equal(lattice, frame.box.matrix)
            self.assertEqual((int(words["step"]), float(words["time"]), float(words["strain"])),
                             (frame.step, frame.time, frame.strain))
            self.assertEqual(words["pbc"], "T T F")
            self.same_places(frame.box, columns["pos"][:, :2], frame.position)
            np.testing.assert_array_equal(columns["velo"][:, :2], frame.velocity)
            np.testing.assert_array_equal(columns["momenta"][:, :2], frame.mass[:, None] * frame.velocity)  # what ASE reads
            np.testing.assert_array_equal(columns["spin"][:, 0], frame.spin)
            np.testing.assert_array_equal(columns["species"][:, 0] == "He", frame.species == 1)
            np.testing.assert_array_equal(columns["masses"][:, 0], frame.mass)

    def test_vtk(self):
        run, (pvd, pairs) = self.export("vtk", contacts=True)
        for collection in (pvd, pairs):
            listed = xml.etree.ElementTree.parse(collection).findall(".//DataSet")
            self.assertEqual([float(one.get("timestep")) for one in listed], [frame.time for frame in run.frames])
            files = [vtp(self.folder / one.get("file")) for one in listed]
            if collection == pvd:
                disks = files
        for frame, contacts, one, other in zip(run.frames, run.contacts, disks, files):
            self.same_places(frame.box, one["Points"]["Points"][:, :2], frame.position)
            np.testing.assert_array_equal(one["PointData"]["velocity"][:, :2], frame.velocity)
            np.testing.assert_array_equal(one["PointData"]["diameter"], frame.diameter)
            np.testing.assert_array_equal(one["PointData"]["species"], frame.species)
            self.assertEqual(one["FieldData"]["strain"][0], frame.strain)
            np.testing.assert_array_equal(one["Verts"]["connectivity"], np.arange(64))
            np.testing.assert_array_equal(other["CellData"]["overlap"], contacts.overlap)
            ends = other["Points"]["Points"][:, :2].reshape(-1, 2, 2)
            np.testing.assert_allclose(np.hypot(*(ends[:, 0] - ends[:, 1]).T), contacts.separation)
            self.same_places(frame.box, ends[:, 0], frame.position[contacts.i])
            np.testing.assert_allclose(frame.box.nearest(ends[:, 1] - frame.position[contacts.j])[0], 0, atol=1e-9)

    def test_names_with_dots(self):
        """"phi0.80" and "phi0.v2" have no file in common."""
        run = with_frames()
        for to in ("vtk", "lammps"):
            one, two = (set(bagnold.export(run, to, self.folder / name, contacts=True)) for name in ("phi0.80", "phi0.v2"))
            self.assertFalse(one & two)
        self.assertTrue((self.folder / "phi0.80_vtk" / "000000.vtp").exists())
        self.assertTrue((self.folder / "phi0.v2_vtk" / "000000.vtp").exists())
        self.assertTrue((self.folder / "phi0.80.frames.csv").exists())

    def test_frames_are_chosen(self):
        from bagnold.exports import parse_frames
        for text, chosen in (("2:5", [2, 3, 4]), (":3", [0, 1, 2]), ("-1:", [8]), ("::4", [0, 4, 8]), ("7", [7]),
                             ("-1", [8]), (":", list(range(9))), ("02:05", [2, 3, 4])):
            self.assertEqual(list(range(9))[parse_frames(text)], chosen, text)
        for text in ("a:b", "", "1:2:3:4", "::0", "1.5:", "0x1:", "1_0", "+1", " 1", "\u0663:"):
            with self.assertRaisesRegex(bagnold.InputError, "--frames .*must be A:B"):
                parse_frames(text)
        _, (path,) = self.export("extxyz", frames=slice(2, 8, 3))
        self.assertEqual([int(words["step"]) for words, _ in extxyz_frames(path)],
                         with_frames().frames.steps[2:8:3].tolist())

    def test_no_spins_without_rotation(self):
        run, (path,) = self.export("extxyz", with_frames(disks__model="CD_n"))
        self.assertNotIn("spin", extxyz_frames(path)[0][1])
        _, (dump, _) = self.export("lammps", run)
        self.assertNotIn("omegaz", lammps_frames(dump)[0][2])

    def test_replicas(self):
        run = with_frames(disks__replicas=2)
        written = bagnold.export(run, "extxyz")
        self.assertEqual([path.name for path in written], ["trajectory_1.xyz", "trajectory_2.xyz"])
        for seed, path in zip(run.seeds, written):
            np.testing.assert_array_equal(extxyz_frames(path)[3][1]["velo"][:, :2], run.frames_of(seed)[3].velocity)
        with self.assertRaisesRegex(bagnold.InputError, "out with 2 replicas"):
            bagnold.export(run, "extxyz", self.folder / "x.xyz")

    def test_refusals(self):
        run = with_frames()
        for words, arguments, options in (
                ("must be one of lammps, extxyz, gsd, vtk", (run, "pdb"), {}),
                ("no place for pairs", (run, "extxyz"), {"contacts": True}),
                ("chooses none of the 9", (run, "extxyz"), {"frames": slice(20, 30)})):
            with self.assertRaisesRegex(bagnold.InputError, words):
                bagnold.export(*arguments, **options)
        with self.assertRaisesRegex(bagnold.FileError, "is no folder; make it first"):
            bagnold.export(run, "extxyz", self.folder / "no/x.xyz")
        (self.folder / "x.xyz").mkdir()
        with self.assertRaisesRegex(bagnold.FileError, "x.xyz cannot be written"):
            bagnold.export(run, "extxyz", self.folder / "x.xyz")

    def test_only_files_are_replaced(self):
        run = with_frames()
        for to, ending in (("extxyz", ".xyz"), ("lammps", ".dump"), ("vtk", ".pvd")):
            with self.subTest(to):
                self.keeps_what_is_no_file(lambda path: bagnold.export(run, to, path), ending)

    # ---------------------------------------------------------------------------- other programs

    @needs("gsd")
    def test_only_files_are_replaced_by_gsd(self):
        self.keeps_what_is_no_file(lambda path: bagnold.export(with_frames(), "gsd", path), ".gsd")

    def test_gsd_without_its_library(self):
        with unittest.mock.patch.dict(sys.modules, {"gsd": None, "gsd.hoomd": None}):
            with self.assertRaisesRegex(bagnold.MissingLibrary, "pip install gsd.*BAGNOLD_PYTHON"):
                self.export("gsd")
        self.assertEqual(list(self.folder.iterdir()), [])

    @needs("gsd")
    def test_gsd(self):
        import gsd.hoomd
        run, (path,) = self.export("gsd", contacts=True)
        with gsd.hoomd.open(str(path)) as file:
            self.assertEqual(len(file), 9)
            for frame, contacts, one in zip(run.frames, run.contacts, file):
                box = frame.box
                self.assertEqual(one.configuration.step, frame.step)
                self.assertEqual(one.configuration.dimensions, 2)
                np.testing.assert_allclose(one.configuration.box[[0, 1, 3]],
                                           [box.length, box.height, box.tilt / box.height], rtol=1e-6)
                middle = np.array([box.length + box.tilt, box.height]) / 2
                away, _ = box.nearest(one.particles.position[:, :2] + middle - frame.position)
                np.testing.assert_allclose(away, 0, atol=1e-5)
                np.testing.assert_allclose(one.particles.velocity[:, :2], frame.velocity, rtol=1e-6)
                np.testing.assert_array_equal(one.particles.typeid, frame.species)
                np.testing.assert_array_equal(one.log["particles/spin"], frame.spin)
                self.assertEqual(one.log["strain"][0], frame.strain)
                np.testing.assert_array_equal(one.bonds.group, np.stack([contacts.i, contacts.j], axis=1))
                np.testing.assert_array_equal(one.log["bonds/overlap"], contacts.overlap)

    @needs("gsd")
    def test_gsd_frames_without_contacts(self):
        """They have none, and not those of the first."""
        import gsd.hoomd
        from bagnold.contacts import contacts_of
        from bagnold.exports.gsd_file import write
        run = with_frames()
        far = dataclasses.replace(run.frames[1], position=run.frames[1].box.length * np.stack(
            [np.arange(len(run.frames[1])) / len(run.frames[1]), np.zeros(len(run.frames[1]))], axis=1),
            diameter=np.full(len(run.frames[1]), 1e-3))
        frames = [run.frames[0], far]
        write(frames, [contacts_of(frame, run.scene) for frame in frames], self.folder / "x.gsd")
        with gsd.hoomd.open(str(self.folder / "x.gsd")) as file:
            self.assertGreater(file[0].bonds.N, 0)
            self.assertEqual([(frame.bonds.N, len(frame.log["bonds/overlap"])) for frame in file][1], (0, 0))

    @needs("ase")
    def test_ase(self):
        import ase.io
        run, (path,) = self.export("extxyz")
        for frame, atoms in zip(run.frames, ase.io.read(path, ":"), strict=True):
            np.testing.assert_allclose(atoms.cell[:], frame.box.matrix)
            self.assertEqual(list(atoms.pbc), [True, True, False])
            self.same_places(frame.box, atoms.positions[:, :2], frame.position)
            np.testing.assert_array_equal(atoms.arrays["velo"][:, :2], frame.velocity)
            np.testing.assert_allclose(atoms.get_velocities()[:, :2], frame.velocity, rtol=1e-14)
            np.testing.assert_array_equal(atoms.get_masses(), frame.mass)
            self.assertEqual(atoms.info["strain"], frame.strain)
        _, (dump, _) = self.export("lammps", name="y")
        for frame, atoms in zip(run.frames, ase.io.read(dump, ":", format="lammps-dump-text"), strict=True):
            np.testing.assert_allclose(atoms.cell[:2, :2], frame.box.matrix[:2, :2], atol=1e-12)
            self.same_places(frame.box, atoms.positions[:, :2] - atoms.get_celldisp().ravel()[:2], frame.position)
            scale = ase.units.Ang / ase.units.fs / 1000  # a dump has no units: ASE takes them for Angstrom and picoseconds
            np.testing.assert_allclose(atoms.get_velocities()[:, :2] / scale, frame.velocity, rtol=1e-12)

    @needs("MDAnalysis")
    def test_mdanalysis(self):
        import MDAnalysis
        run, (dump, _) = self.export("lammps")
        universe = MDAnalysis.Universe(str(dump), format="LAMMPSDUMP", topology_format="LAMMPSDUMP",
                                       convert_units=False)
        self.assertEqual(len(universe.trajectory), 9)
        for frame, step in zip(run.frames, universe.trajectory, strict=True):
            self.assertEqual(step.data["step"], frame.step)
            away, _ = frame.box.nearest(step.positions[:, :2] - frame.position)
            np.testing.assert_allclose(away - away[0], 0, atol=1e-4)  # it may move the origin
            edges = step.triclinic_dimensions
            self.assertAlmostEqual(abs(edges[0, 0]), frame.box.length, places=4)
            self.assertAlmostEqual(math.hypot(*edges[1, :2]), math.hypot(frame.box.tilt, frame.box.height), places=4)

    @needs("vtk")
    def test_vtk_itself(self):
        program = """
import sys, json, vtk
from vtk.util.numpy_support import vtk_to_numpy
out = []
for path in sys.argv[1:]:
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    arrays = {}
    for part in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
        for k in range(part.GetNumberOfArrays()):
            array = part.GetArray(k)
            arrays[array.GetName()] = vtk_to_numpy(array).tolist()
    points = vtk_to_numpy(data.GetPoints().GetData()).tolist() if data.GetNumberOfPoints() else []
    out.append([points, arrays, data.GetNumberOfVerts(), data.GetNumberOfLines()])
print(json.dumps(out))
"""
        import json
        run, _ = self.export("vtk", contacts=True)
        said = subprocess.run([sys.executable, "-c", program, self.folder / "x_vtk/000003.vtp",
                               self.folder / "x_vtk/contacts_000003.vtp"], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        (points, arrays, verts, _), (_, pairs, _, lines) = json.loads(said.stdout)
        frame, contacts = run.frames[3], run.contacts[3]
        self.same_places(frame.box, np.array(points)[:, :2], frame.position)
        np.testing.assert_array_equal(np.array(arrays["velocity"])[:, :2], frame.velocity)
        self.assertEqual((verts, lines), (64, len(contacts)))
        self.assertEqual(arrays["TimeValue"], [frame.time])
        np.testing.assert_array_equal(pairs["normal_force"], contacts.normal_force)

    @needs("ovito")
    def test_ovito(self):
        """In a process of its own: it starts an application."""
        program = """
import json, sys
from ovito.io import import_file
out = []
for path in sys.argv[1:]:
    pipeline = import_file(path)
    data = pipeline.compute(3)
    p = data.particles
    radius = "Radius" if "Radius" in p else None
    out.append([pipeline.source.num_frames, p.positions[...].tolist(), p["Velocity"][...].tolist(),
                p[radius][...].tolist() if radius else None, data.cell[...].tolist(), list(data.cell.pbc)])
print(json.dumps(out))
"""
        import json
        run, (dump, _) = self.export("lammps")
        _, (path,) = self.export("extxyz")
        said = subprocess.run([sys.executable, "-c", program, dump, path], capture_output=True, text=True,
                              env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
        self.assertEqual(said.returncode, 0, said.stderr)
        frame = run.frames[3]
        for frames, positions, velocity, radius, cell, pbc in json.loads(said.stdout.splitlines()[-1]):
            self.assertEqual(frames, 9)
            away, _ = frame.box.nearest(np.array(positions)[:, :2] - frame.position)
            np.testing.assert_allclose(away, 0, atol=1e-9)
            np.testing.assert_allclose(np.array(velocity)[:, :2], frame.velocity)
            np.testing.assert_allclose(np.array(radius) * 2, frame.diameter)
            np.testing.assert_allclose(np.array(cell)[:2, :2].T, frame.box.matrix[:2, :2], atol=1e-9)
            self.assertEqual([bool(one) for one in pbc][:2], [True, True])


class CommandLine(Folder):
    def call(self, *words, **more):
        return subprocess.run([sys.executable, "-m", "bagnold", *map(str, words)], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(SOURCE / "python"), **more}, cwd=self.folder)

    def test_of_the_package(self):
        run = with_frames()
        said = self.call("export", run.folder, "--to", "lammps", "--frames", "2:4", "--out", "x.dump", "--contacts")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertEqual(said.stdout.split(), ["x.dump", "x.frames.csv", "x.contacts.dump"])
        self.assertEqual(len(lammps_frames(self.folder / "x.dump")), 2)
        for words, code, expected in (((self.folder, "--to", "vtk"), 4, "holds no run"),
                                      ((run.folder, "--to", "pdb"), 2, "must be one of lammps"),
                                      ((run.folder, "--to", "vtk", "--frames", "x"), 2, "must be A:B")):
            said = self.call("export", *words)
            self.assertEqual(said.returncode, code, said.stderr)
            self.assertIn(expected, said.stderr)
            self.assertEqual(len(said.stderr.splitlines()), 1)

    def program(self, *words, **more):
        return subprocess.run([os.environ["BAGNOLD_PROGRAM"], *map(str, words)], capture_output=True, text=True,
                              env={**os.environ, **more}, cwd=self.folder)

    def test_of_the_program(self):
        run = with_frames()
        said = self.program("export", run.folder, "--to", "extxyz", "--frames", "-2:", "--out", "here.xyz")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertIn("here.xyz", said.stdout)
        self.assertEqual(len(extxyz_frames(self.folder / "here.xyz")), 2)
        np.testing.assert_array_equal(extxyz_frames(self.folder / "here.xyz")[1][1]["velo"][:, :2],
                                      run.frames[-1].velocity)
        quiet = self.program("export", run.folder, "--to", "vtk", "--contacts", "--out", "v.pvd", "--quiet")
        self.assertEqual((quiet.returncode, quiet.stdout, quiet.stderr), (0, "", ""))
        self.assertEqual(len(list((self.folder / "v_vtk").iterdir())), 18)

    def test_the_programs_mistakes(self):
        run = with_frames()
        for words, code, expected in (
                (("export", self.folder, "--to", "vtk"), 4, "holds no run"),
                (("export", run.folder, "--to", "pdb"), 2, "lammps"),
                (("export", run.folder), 2, "--to"),
                (("export", run.folder, "--to", "vtk", "--frames", "x"), 2, "must be A:B")):
            said = self.program(*words)
            self.assertEqual(said.returncode, code, said.stderr)
            self.assertIn(expected, said.stderr)
            self.assertTrue(said.stderr.startswith("bagnold: "), said.stderr)
            self.assertEqual(len(said.stderr.splitlines()), 1, said.stderr)
        said = self.program("export", run.folder, "--to", "vtk", BAGNOLD_PYTHON="/bin/no-python")
        self.assertEqual(said.returncode, 4)
        self.assertIn("BAGNOLD_PYTHON", said.stderr)
        said = self.program("export", run.folder, "--to", "vtk", BAGNOLD_PYTHON_PACKAGE="here")
        self.assertEqual(said.returncode, 4)
        self.assertIn("BAGNOLD_PYTHON_PACKAGE = here", said.stderr)

    def test_nothing_of_this_folder_is_run(self):
        mark = self.folder / "mark"
        for name in ("bagnold", "numpy", "h5py", "argparse", "gsd"):
            (self.folder / f"{name}.py").write_text(f"open({str(mark)!r}, 'w')\n")
        said = self.program("export", with_frames().folder, "--to", "lammps", "--out", "x.dump", PYTHONPATH=".")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertFalse(mark.exists())


if __name__ == "__main__":
    unittest.main()
