# SPDX-License-Identifier: BSD-3-Clause
"""Profiles, fields, rotation and trajectories in the files of a run, killed or not."""

import json
import re
import resource
import signal
import subprocess
import sys
import time
import tomllib
import unittest

import h5py
import numpy as np

from bagnold import PROGRAM, CliTest, environment, read_summary, seconds_to_strain

MEASURED = {"measure__profiles": True, "measure__rotation": True, "measure__fields": True,
            "disks__count": 128, "disks__packing_fraction": 0.82}
GROUPS = ("histograms", "profiles", "samples")


def tables(out):
    """Every dataset that frames made, as bytes, by path."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset) and name.split("/")[0] in GROUPS:
            found[name] = item[()].tobytes()

    with h5py.File(out / "result.h5", "r") as file:
        file.visititems(take)
    return found


class MeasuredTest(CliTest):
    def test_off_leaves_nothing(self):
        out = self.run_new("off")
        with h5py.File(out / "result.h5", "r") as file:
            for group in GROUPS:
                self.assertNotIn(group, file)
        self.assertEqual(list(out.glob("trajectory*")), [])

    def test_tables(self):
        out = self.run_new("on", shear__strain=4.0, measure__frame_strain=2.0**-6, **MEASURED)
        summary = read_summary(out)
        for name in ("band_fraction_phi", "band_fraction_gammadot"):
            self.assertTrue(0 < summary["observables"][name]["mean"] < 1)
            self.assertEqual(summary["observables"][name]["samples"], 129)  # 2.0 to 4.0, both ends
        with h5py.File(out / "result.h5", "r") as file:
            length = float(file.attrs["box_length"])
            profiles = {k: {d: g[d][()] for d in ("y", "value", "error")}
                        for k, g in file["profiles"].items()}
            spins = file["histograms/rotation"]
            edges, density = spins["edges"][()], spins["density"][()]
            local = file["histograms/local_phi"]
            phi_edges, phi_density = local["edges"][()], local["density"][()]
            disks = file["samples/fields"][()]
            self.assertEqual(file["samples/band_position"].shape, (129, 2))
        for name in ("v_x", "gammadot", "phi", "p", "p_el", "p_dis", "p_kin", "sigma", "Z", "T_g"):
            for which in (name, name + "_aligned"):
                profile = profiles[which]
                self.assertEqual(len(profile["y"]), max(8, int(length / 1.5)))
                np.testing.assert_allclose(np.diff(profile["y"]), length / len(profile["y"]))
                self.assertTrue(np.isfinite(profile["value"]).all(), which)
        # what must hold for the averages, whatever the profile
        self.assertAlmostEqual(profiles["phi"]["value"].mean(), 0.82, places=12)
        rate = 2.0**-7
        self.assertAlmostEqual(profiles["gammadot"]["value"].mean() / rate, 1.0, places=9)
        for name in ("p", "p_el", "sigma"):
            found = profiles[name]["value"].mean() / summary["observables"][name]["mean"]
            self.assertAlmostEqual(found, 1.0, delta=0.2, msg=name)  # other configurations
        self.assertAlmostEqual(float((density * np.diff(edges)).sum()), 1.0, places=9)
        middle = (edges[1:] + edges[:-1]) / 2
        self.assertAlmostEqual(float((density * np.diff(edges) * middle).sum()),
                               summary["observables"]["spin_mean"]["mean"], delta=0.1)
        mean_phi = float((phi_density * np.diff(phi_edges) * (phi_edges[1:] + phi_edges[:-1]) / 2).sum())
        self.assertAlmostEqual(mean_phi, 0.82, delta=0.03)
        self.assertEqual(disks.shape, (128, 5))

    def test_refusals(self):
        self.refused(self.scene(disks__model="CD", measure__rotation=True), "measure.rotation",
                     "CD_rot")
        self.refused(self.scene(disks__count=32, measure__fields=True), "measure.fields", "box")
        for value in (0.0, -1.0):
            self.refused(self.scene(measure__frame_strain=value), "measure.frame_strain")

    def test_pictures(self):
        out = self.run_new("pictures", output__plot=True, measure__frame_strain=2.0**-6, **MEASURED)
        for name in ("profiles.png", "fields.png"):
            self.assertEqual((out / name).read_bytes()[:4], b"\x89PNG")


class TrajectoryTest(CliTest):
    def trajectory(self, **changes):
        changes.setdefault("output__trajectory_strain", 2.0**-5)
        changes.setdefault("integration__engine", "many-contacts")  # stops at every step
        return self.run_new("trajectory", shear__strain=0.25, **changes)

    def test_h5md(self):
        """P. de Buyl, P. Colberg, F. Hoefling, Comput. Phys. Commun. 185, 1546 (2014), Sec. 3."""
        out = self.trajectory()
        with h5py.File(out / "trajectory.h5md", "r") as file:
            self.assertEqual(list(file["h5md"].attrs["version"]), [1, 1])
            for group in ("author", "creator"):
                self.assertIn("name", file["h5md"][group].attrs)
            self.assertEqual(file["h5md/creator"].attrs["name"].decode(), "Bagnold")
            self.assertIn("version", file["h5md/creator"].attrs)
            disks = file["particles/trajectory"]
            box = disks["box"]
            self.assertEqual(box.attrs["dimension"], 3)
            self.assertEqual(list(box.attrs["boundary"]), [b"periodic", b"periodic", b"none"])
            step, moment = disks["position/step"][()], disks["position/time"][()]
            self.assertEqual(list(step), [64 * k for k in range(9)])
            np.testing.assert_array_equal(moment, step * 2.0**-4)
            for name in ("velocity", "spin", "box/edges"):  # of one time: the same objects
                self.assertEqual(disks[name]["step"], disks["position/step"])
                self.assertEqual(disks[name]["time"], disks["position/time"])
            edges = box["edges/value"][()]
            self.assertEqual(edges.shape, (9, 3, 3))
            length = edges[0, 0, 0]
            tilt = (step * 2.0**-11 * length + length / 2) % length - length / 2
            np.testing.assert_allclose(edges[:, 1, 0], tilt, atol=1e-12)
            np.testing.assert_array_equal(edges[:, 1, 1], length)
            position, velocity = disks["position/value"][()], disks["velocity/value"][()]
            self.assertEqual(position.shape, (9, 64, 3))
            self.assertEqual(disks["spin/value"].shape, (9, 64))
            self.assertTrue((position[..., 2] == 0).all() and (velocity[..., 2] == 0).all())
            self.assertTrue((position[..., :2] >= 0).all() and (position[..., :2] <= length).all())
            self.assertEqual(sorted(set(disks["species"][()])), [0, 1])
            np.testing.assert_array_equal(disks["diameter"][()], 1 + 0.4 * disks["species"][()])
            np.testing.assert_array_equal(disks["mass"][()], 1.0)
            self.assertEqual(file["parameters"].attrs["length_unit"], b"d_s")
            scene = tomllib.loads(file["parameters"].attrs["scene"].decode())
            self.assertEqual(scene["disks"], read_summary(out)["scene"]["disks"])
            self.assertEqual(scene["shear"], {"strain_rate": 2.0**-7})
            for name, values in (("strain", step * 2.0**-11), ("strain_rate", np.full(9, 2.0**-7)),
                                 ("offset", step * 2.0**-11 * length % length)):
                element = file["observables/trajectory"][name]
                self.assertEqual((element["step"], element["time"]),
                                 (disks["position/step"], disks["position/time"]))
                np.testing.assert_allclose(element["value"], values, rtol=1e-12, atol=1e-12)
            image = disks["image/value"]
            self.assertEqual((image.shape, image.dtype), ((9, 64, 3), np.dtype("<i4")))
            self.assertTrue((image[0] == 0).all() and (image[..., 2] == 0).all())
            place = position + np.einsum("tnk,tka->tna", image, edges)
            strain = step[:, None] * 2.0**-11
            step_x = np.diff(place[..., 0], axis=0) - np.diff(strain, axis=0) * (place[1:, :, 1] + place[:-1, :, 1]) / 2
            self.assertLess(np.abs(np.diff(place[..., 1], axis=0)).max(), length / 2)
            self.assertLess(np.abs(step_x).max(), length / 2)
        with h5py.File(out / "state.h5", "r") as file:  # the last frame is the last state
            np.testing.assert_array_equal(file["state/position"][()], position[-1, :, :2])
            np.testing.assert_array_equal(file["state/velocity"][()], velocity[-1, :, :2])
        self.assertFalse((out / "trajectory.parts").exists())

    def test_no_spins_without_rotation(self):
        out = self.trajectory(disks__model="CD_n")
        with h5py.File(out / "trajectory.h5md", "r") as file:
            self.assertNotIn("spin", file["particles/trajectory"])

    def test_vtkhdf(self):
        """As VTK reads it: of each step the points and arrays behind its offsets are those of the frame."""
        out = self.trajectory()
        with h5py.File(out / "trajectory.h5md") as file, h5py.File(out / "trajectory.vtkhdf") as beside:
            disks, grid, steps = file["particles/trajectory"], beside["VTKHDF"], beside["VTKHDF/Steps"]
            self.assertEqual((grid.attrs["Type"], list(grid.attrs["Version"])), (b"UnstructuredGrid", [2, 0]))
            self.assertEqual(steps.attrs["NSteps"], 9)
            np.testing.assert_array_equal(steps["Values"], disks["position/time"])
            count, = grid["NumberOfPoints"]
            self.assertEqual([count, *grid["NumberOfCells"], *grid["NumberOfConnectivityIds"]], [64] * 3)
            np.testing.assert_array_equal(grid["Connectivity"], np.arange(64))
            np.testing.assert_array_equal(grid["Offsets"], np.arange(65))
            np.testing.assert_array_equal(grid["Types"], 1)  # VTK_VERTEX
            self.assertEqual(set(grid["PointData"]), {"velocity", "spin", "diameter", "species"})
            for frame in range(9):
                self.assertEqual((steps["PartOffsets"][frame], steps["NumberOfParts"][frame]), (0, 1))
                self.assertEqual((*steps["CellOffsets"][frame], *steps["ConnectivityIdOffsets"][frame]), (0, 0))
                first = steps["PointOffsets"][frame]
                np.testing.assert_array_equal(grid["Points"][first:first + count], disks["position/value"][frame])
                for name, values in grid["PointData"].items():
                    wanted = disks[name]["value"][frame] if name in ("velocity", "spin") else disks[name]
                    first = steps["PointDataOffsets"][name][frame]
                    np.testing.assert_array_equal(values[first:first + count], wanted)
                    self.assertTrue(values.is_virtual, name)
        (out / "trajectory.h5md").rename(out / "gone.h5md")
        with h5py.File(out / "trajectory.vtkhdf") as beside:
            self.assertTrue(np.isnan(beside["VTKHDF/Points"]).all())

    def other_program(self, module, program, out):
        """What a program prints as JSON about a trajectory, in a process of its own."""
        has = subprocess.run([sys.executable, "-c", f"import {module}"], capture_output=True)
        if has.returncode:
            self.skipTest(f"{module} is not installed")
        result = subprocess.run([sys.executable, "-c", program, out], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        said = json.loads(result.stdout.splitlines()[-1])
        if said is None:
            self.skipTest(f"{module} is of before VTKHDF over time")
        return said

    def test_paraview(self):
        """Opens by its name alone (ParaView 5.12 or later)."""
        out = self.trajectory()
        self.as_the_frames(out, *self.other_program("paraview.simple", """
import json, os, sys
from paraview import servermanager, simple
if servermanager.vtkSMProxyManager.GetVersionMajor() * 100 + servermanager.vtkSMProxyManager.GetVersionMinor() < 512:
    print("null", flush=True)
    os._exit(0)
reader = simple.OpenDataFile(sys.argv[1] + "/trajectory.vtkhdf")
simple.UpdatePipeline(proxy=reader)
times = list(reader.TimestepValues)
simple.UpdatePipeline(time=times[3], proxy=reader)
data = servermanager.Fetch(reader)
while data.IsA("vtkMultiBlockDataSet"):
    data = data.GetBlock(0)
arrays = {name: data.GetPointData().GetArray(name).GetTuple(5)
          for name in ("diameter", "species", "velocity", "spin")}
print()
print(json.dumps([times, [data.GetPoint(k) for k in range(data.GetNumberOfPoints())], arrays]),
      flush=True)
os._exit(0)
""", out))

    def test_vtk(self):
        """vtk of PyPI, 9.3 or later."""
        out = self.trajectory()
        self.as_the_frames(out, *self.other_program("vtkmodules.vtkIOHDF", """
import json, sys
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader
if vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() < 903:
    sys.exit(print("null"))
reader = vtkHDFReader()
reader.SetFileName(sys.argv[1] + "/trajectory.vtkhdf")
reader.UpdateInformation()
times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
reader.UpdateTimeStep(times[3])
data = reader.GetOutput()
arrays = {name: data.GetPointData().GetArray(name).GetTuple(5)
          for name in ("diameter", "species", "velocity", "spin")}
print(json.dumps([times, [data.GetPoint(k) for k in range(data.GetNumberOfPoints())], arrays]))
""", out))

    def as_the_frames(self, out, times, points, arrays):
        with h5py.File(out / "trajectory.h5md", "r") as file:
            disks = file["particles/trajectory"]
            np.testing.assert_array_equal(times, disks["position/time"])
            np.testing.assert_allclose(points, disks["position/value"][3], rtol=1e-6)
            for name in ("velocity", "spin"):
                np.testing.assert_allclose(np.squeeze(arrays[name]), disks[name]["value"][3, 5],
                                           rtol=1e-6)
            self.assertEqual(arrays["diameter"], [disks["diameter"][5]])

    def test_mdanalysis(self):
        """Opens with no topology file (Debian: python3-mdanalysis)."""
        out = self.trajectory()
        count, frames = self.other_program("MDAnalysis", """
import json, sys, warnings
warnings.simplefilter("ignore")
import MDAnalysis
universe = MDAnalysis.Universe(sys.argv[1] + "/trajectory.h5md", n_atoms=64, convert_units=False)
frames = [[float(ts.time), *map(float, ts.positions[5]), *map(float, ts.velocities[5]),
           *map(float, ts.triclinic_dimensions.ravel())] for ts in universe.trajectory]
print(json.dumps([len(universe.atoms), frames]))
""", out)
        self.assertEqual((count, len(frames)), (64, 9))
        with h5py.File(out / "trajectory.h5md", "r") as file:
            disks = file["particles/trajectory"]
            for k, frame in enumerate(frames):
                expected = [disks["position/time"][k], *disks["position/value"][k, 5],
                            *disks["velocity/value"][k, 5], *disks["box/edges/value"][k].ravel()]
                np.testing.assert_allclose(frame, expected, rtol=1e-5, atol=1e-5)


class ReplicasTest(CliTest):
    CHANGES = {**MEASURED, "shear__strain": 1.0, "measure__frame_strain": 2.0**-6,
               "output__trajectory_strain": 2.0**-5}
    SEEDS = (5, 6, 7)

    def run_seeds(self):
        """Three replicas, and each of their seeds alone."""
        out = self.run_new("out", "--threads", 2, disks__seed=5, disks__replicas=3, **self.CHANGES)
        return out, [self.run_new(f"seed{seed}", disks__seed=seed, **self.CHANGES)
                     for seed in self.SEEDS]

    def test_are_their_seeds_together(self):
        out, alone = self.run_seeds()
        for seed, one in zip(self.SEEDS, alone):
            self.assertEqual((out / f"trajectory_{seed}.h5md").read_bytes(),
                             (one / "trajectory.h5md").read_bytes())
            with h5py.File(out / f"trajectory_{seed}.h5md") as file, h5py.File(out / f"trajectory_{seed}.vtkhdf") as beside:
                np.testing.assert_array_equal(np.ravel(beside["VTKHDF/Points"]),
                                              np.ravel(file["particles/trajectory/position/value"]))
        self.assertEqual(len(list(out.glob("trajectory*"))), 6)
        with h5py.File(out / "result.h5") as file:
            each = [h5py.File(one / "result.h5") for one in alone]

            def of_each(path):
                return np.array([one[path][()] for one in each])

            for name in ("phi", "p_el", "sigma_dis", "phi_aligned"):  # no ratios of averages
                profile, values = file[f"profiles/{name}"], of_each(f"profiles/{name}/value")
                np.testing.assert_allclose(profile["value"], values.mean(axis=0), rtol=1e-9)
                np.testing.assert_allclose(profile["error"],
                                           values.std(axis=0, ddof=1) / np.sqrt(3), rtol=1e-6)
            for name in ("rotation", "local_phi", "local_gammadot"):  # as many values in each
                np.testing.assert_allclose(file[f"histograms/{name}/density"][()],
                                           of_each(f"histograms/{name}/density").mean(axis=0))
            np.testing.assert_array_equal(file["samples/fields"][()], each[0]["samples/fields"][()])
            np.testing.assert_array_equal(file["samples/band_position"][()],
                                          np.concatenate(of_each("samples/band_position")))

    def test_band_fractions(self):
        out, alone = self.run_seeds()
        summary = read_summary(out)
        for replica, one in zip(summary["replicas"], alone):
            self.assertEqual(replica["observables"], read_summary(one)["observables"])
        for name in ("band_fraction_phi", "band_fraction_gammadot"):
            found = summary["observables"][name]
            self.assertEqual(found["samples"], 3 * 33)
            self.assertTrue(0 < found["mean"] < 1)
            self.assertTrue(0 < found["error"] < 1)

    def test_force_takes_the_old_trajectories_away(self):
        out, _ = self.folder / "out", self.run_new("out", disks__replicas=3, **self.CHANGES)
        (out / "trajectory_2.parts").mkdir()
        (out / "trajectory_of_mine.h5md").write_text("kept")
        (out / "scene.toml").unlink()
        self.run_scene(self.scene(), out, "--quiet", "--force")
        self.assertEqual([path.name for path in out.glob("trajectory*")],
                         ["trajectory_of_mine.h5md"])

    def test_trajectories_of_too_many_are_refused(self):
        self.refused(self.scene(disks__replicas=257, output__trajectory_strain=0.5),
                     "output.trajectory_strain = 0.5", "disks.replicas = 257", "256")

    def test_size_of_all_is_told(self):
        def megabytes(**changes):
            path = self.scene(output__trajectory_strain=2.0**-7, **changes)
            return float(re.search(r"frames, ([\d.e+-]+) MB", self.bagnold("validate", path).stdout)[1])

        self.assertAlmostEqual(megabytes(disks__replicas=10) / megabytes(), 10, delta=0.1)

    def test_a_full_disk_is_told_without_noise(self):
        """HDF5 keeps its errors, and whether it prints them, for each thread."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (300000, 300000))

        path = self.scene(disks__count=1024, disks__replicas=3, output__trajectory_strain=2.0**-9)
        result = subprocess.run([PROGRAM, "run", path, "--out", self.folder / "out", "--threads", "2"],
                                text=True, timeout=100, capture_output=True, preexec_fn=limit,
                                env=environment())
        self.assertNotIn("HDF5-DIAG", result.stderr)
        self.assert_clean_error(result, 4, "trajectory_")


class KilledTest(CliTest):
    def test_kill_and_resume_change_nothing(self):
        for engine in ("many-contacts", "lookahead"):
            with self.subTest(engine=engine):
                self.check_killed(engine, 1)

    def test_of_replicas(self):
        self.check_killed("many-contacts", 2, disks__replicas=2)

    def checkpoint_stamp(self, out):
        try:
            status = (out / "checkpoint.h5").stat()
            return (status.st_ino, status.st_mtime_ns)
        except FileNotFoundError:
            return None

    def check_killed(self, engine, threads, **more):
        changes = {**MEASURED, "disks__model": "CD_rot", "integration__engine": engine,
                   "output__checkpoint_minutes": 0.0005, "shear__discard": 0.25, **more}
        strain = seconds_to_strain(self, 1.5, shear__strain=1.0, **changes)
        path = self.scene(shear__strain=float(strain), output__sample_strain=float(strain / 64),
                          measure__frame_strain=float(strain / 50),
                          output__trajectory_strain=float(strain / 37), **changes)
        whole, cut = self.folder / f"whole-{engine}", self.folder / f"cut-{engine}"
        options = ("--quiet", "--threads", threads)
        self.run_scene(path, whole, *options)
        process, kills = self.start("run", path, "--out", cut, *map(str, options)), 0
        stamp = None
        for pause in (0.0, 0.03, 0.1, 0.002, 0.06, 0.3, 0.01):
            new = lambda: self.checkpoint_stamp(cut) not in (None, stamp)  # noqa: B023
            if not self.wait_until(new, process):
                break
            time.sleep(pause)
            process.send_signal(signal.SIGKILL)
            if process.wait() == 0:
                break
            kills += 1
            stamp = self.checkpoint_stamp(cut)
            for part in sorted(cut.glob("trajectory*.parts/*.h5md")):
                with h5py.File(part, "r") as file:  # whole, after a kill at any moment
                    self.assertGreater(len(file["particles/trajectory/position/step"]), 0)
            process = self.start("resume", cut, *map(str, options))
        code, output = self.finish(process)
        self.assertEqual(code, 0, output)
        self.assertGreater(kills, 0)
        self.assert_same_results(whole, cut)
        self.assertEqual(tables(whole), tables(cut))
        self.assertGreater(len(tables(whole)), 60)
        written = sorted(path.name for path in whole.glob("trajectory*"))
        self.assertEqual(written, sorted(path.name for path in cut.glob("trajectory*")))
        self.assertEqual(len(written), 2 * more.get("disks__replicas", 1))
        for name in written:
            self.assertEqual((whole / name).read_bytes(), (cut / name).read_bytes(), name)

    def test_killed_right_at_the_end(self):
        out = self.run_new("done", output__trajectory_strain=2.0**-5)
        (out / "trajectory.parts").mkdir()
        (out / "trajectory.parts" / "000000.h5md").write_bytes(b"joined already")
        whole = (out / "trajectory.h5md").read_bytes()
        self.assertEqual(self.bagnold("resume", out).returncode, 0)
        self.assertFalse((out / "trajectory.parts").exists())
        self.assertEqual((out / "trajectory.h5md").read_bytes(), whole)


if __name__ == "__main__":
    unittest.main()
