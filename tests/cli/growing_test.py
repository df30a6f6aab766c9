# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps whose file gains points or strain, and analyses that join sweeps: what is there is kept."""

import csv
import shutil
import unittest

import h5py

from bagnold import files_of, read_summary
from sweeps import SEEDS, SweepTest, rows

def untouched(before, after):
    """Files of finished points that were neither written nor replaced."""
    return [name for name in before if name in after and before[name] == after[name]]


class Growing(SweepTest):
    def grown(self, before, after, out="out"):
        """Runs both files into one folder; returns it, and what was said of the second."""
        out = self.folder / out
        self.sweep(self.sweep_file(**before), out, "--quiet")
        self.files = files_of(out / "points")
        return out, self.sweep(self.sweep_file(**after), out, "--quiet").stderr

    def assert_as_anew(self, out, after):
        """Each row is that of the sweep run into an empty folder."""
        whole = self.folder / "anew"
        self.sweep(self.sweep_file(**after), whole, "--quiet")
        one, two = rows(out), rows(whole)
        for row in one + two:
            del row["folder"]
        self.assertEqual(one, two)
        shutil.rmtree(whole)

    def test_new_points_are_run_and_those_there_kept(self):
        after = {"grid": {"disks.seed": [4, 1, 2, 3, 5]}}
        out, said = self.grown({"grid": SEEDS}, after)
        self.assertIn("3 points", said)
        self.assertIn("2 are new", said)
        now = files_of(out / "points")
        kept = set(self.files) - {name for name in self.files if name.endswith(".lock")}
        self.assertEqual(set(untouched(self.files, now)) & kept, kept)
        self.assertEqual([row["folder"] for row in rows(out)],
                         ["0004_seed=4", "0001_seed=1", "0002_seed=2", "0003_seed=3", "0005_seed=5"])
        self.assert_as_anew(out, after)

    def test_points_that_left_stay_and_are_found_when_they_return(self):
        out, said = self.grown({"grid": SEEDS}, {"grid": {"disks.seed": [1, 4]}})
        self.assertIn("2 that left the file stay", said)
        self.assertIn("0002_seed=2", said)
        self.assertEqual(len(rows(out)), 2)
        before = files_of(out / "points")
        said = self.sweep(self.sweep_file(grid={"disks.seed": [1, 2, 3, 4]}), out, "--quiet").stderr
        self.assertEqual(said, "")
        self.assertEqual([row["folder"][:4] for row in rows(out)], ["0001", "0002", "0003", "0004"])
        kept = [name for name in before if not name.endswith(".lock")]
        self.assertEqual(set(untouched(before, files_of(out / "points"))) & set(kept), set(kept))

    def test_another_file_is_refused(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out, "--quiet")
        before = files_of(out)
        result = self.bagnold("sweep", self.sweep_file(grid=SEEDS, disks__elasticity=2.0),
                              "--out", out)
        self.assert_clean_error(result, 2, "another file", "choose another folder",
                                "elasticity = 1.0", "elasticity = 2.0")
        after = files_of(out)
        self.assertEqual({k: v for k, v in after.items() if ".lock" not in k},
                         {k: v for k, v in before.items() if ".lock" not in k})

    def test_more_strain_makes_points_longer(self):
        after = {"grid": SEEDS, "shear__strain": 0.4507, "output__trajectory_strain": 0.05}
        before = {**after, "shear__strain": 0.2005}
        out, said = self.grown(before, after)
        self.assertIn("3 of those that are kept get more strain", said)
        self.assertEqual(len(self.points(out)), 3)
        self.assert_as_anew(out, after)
        anew = self.run_new("anew", shear__strain=0.4507, output__trajectory_strain=0.05)
        self.assert_same_results(anew, self.points(out)[0])

    def test_a_larger_strain_beside_those_there(self):
        """Wherever it stands in the list: a run is made longer only if its own strain is no longer there."""
        out, said = self.grown({"grid": {"shear.strain": [0.5, 0.25]}}, {"grid": {"shear.strain": [1.0, 0.5, 0.25]}})
        self.assertIn("2 points", said)
        self.assertIn("1 are new", said)
        self.assertEqual([row["folder"] for row in rows(out)], ["0003_strain=1", "0001_strain=0.5", "0002_strain=0.25"])
        self.assert_as_anew(out, {"grid": {"shear.strain": [1.0, 0.5, 0.25]}})

    def test_tables_of_a_file_that_asks_for_more_strain(self):
        """Collecting runs nothing, so it takes nothing away."""
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out, "--quiet")
        before = files_of(out)
        longer = self.sweep_file(grid=SEEDS, shear__strain=4.0)
        self.assert_clean_error(self.bagnold("sweep", longer, "--out", out, "--collect"), 2, "more strain than 3",
                                "goes on with them")
        after = files_of(out)
        self.assertEqual({k: v for k, v in after.items() if ".lock" not in k},
                         {k: v for k, v in before.items() if ".lock" not in k})

    def test_more_strain_at_given_pressure(self):
        after = {"grid": {"disks.seed": [1, 2]}, "shear__protocol": "pressure", "shear__pressure": 0.02,
                 "shear__strain": 2.0}
        out, said = self.grown({**after, "shear__strain": 1.0}, after)
        self.assertIn("2 of those that are kept get more strain", said)
        self.assertEqual(len(self.points(out)), 2)
        self.assert_as_anew(out, after)

    def test_chains_grow_at_their_end(self):
        """A longer point has another last state: what starts from the shorter one is kept as such."""
        before = {"chain": "shear.strain_rate",
                  "grid": {"shear.strain_rate": [2.0**-6, 2.0**-7], "disks.seed": [1, 2]}}
        after = {"chain": "shear.strain_rate",
                 "grid": {"shear.strain_rate": [2.0**-6, 2.0**-7, 2.0**-8], "disks.seed": [1, 2, 3]}}
        out, said = self.grown(before, after)
        self.assertIn("4 points", said)
        self.assertIn("5 are new", said)
        self.assert_as_anew(out, after)
        result = self.bagnold("sweep", self.sweep_file(shear__strain=0.25, **after), "--out", out)
        self.assert_clean_error(result, 2, "none of its 9 points", "chain")

    def test_more_strain_at_the_end_of_chains(self):
        def sweep(strains):
            return {"chain": "shear.strain_rate", "grid": {"disks.seed": [1, 2]},
                    "zip": {"shear.strain_rate": [2.0**-6, 2.0**-7], "shear.strain": strains}}
        out, said = self.grown(sweep([0.1, 0.1]), sweep([0.1, 0.3]))
        self.assertIn("2 of those that are kept get more strain", said)
        self.assertEqual(len(self.points(out)), 4)
        self.assert_as_anew(out, sweep([0.1, 0.3]))

    def test_a_point_made_longer_by_itself(self):
        out = self.folder / "out"
        path = self.sweep_file(grid=SEEDS, shear__strain=0.2)
        self.sweep(path, out, "--quiet")
        point = self.points(out)[1]
        self.assertEqual(self.bagnold("resume", point, "--strain", 0.5, "--quiet").returncode, 0)
        self.sweep(path, out, "--quiet")
        self.assertEqual([len(self.points(out)), read_summary(point)["scene"]["shear"]["strain"]],
                         [3, 0.5])
        with h5py.File(out / "sweep.h5") as file:
            scenes = list(file["points/scene"].asstr())
        self.assertEqual(["strain = 0.5\n" in scene for scene in scenes], [False, True, False])

    def test_a_point_from_which_another_starts_stays_as_long(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(chain="shear.strain_rate", grid={"shear.strain_rate": [2.0**-6, 2.0**-7]}), out, "--quiet")
        first, last = self.points(out)
        before = files_of(first)
        self.assert_clean_error(self.bagnold("resume", first, "--strain", 4.0), 2, last.name, "a folder of its own")
        self.assertEqual(untouched(before, files_of(first)), [name for name in before if not name.endswith(".lock")])
        self.assertEqual(self.bagnold("resume", last, "--strain", 4.0, "--quiet").returncode, 0)

    def test_strain_by_which_the_scheme_would_change(self):
        """The refusal names the key that lets the points go on."""
        out, usual = self.folder / "out", {"integration__time_step": None, "disks__count": 16, "measure__every": 10,
                                           "disks__packing_fraction": 0.5, "grid": {"disks.seed": [1, 2]}}
        self.sweep(self.sweep_file(shear__strain=3.0, **usual), out, "--quiet")
        longer = self.sweep_file(shear__strain=6.0, **usual)
        self.assert_clean_error(self.bagnold("sweep", longer, "--out", out), 2,
                                'integration.scheme = "two-stage-leapfrog" keeps theirs')
        longer = self.sweep_file(shear__strain=6.0, integration__scheme="two-stage-leapfrog", **usual)
        self.assertIn("2 of those that are kept get more strain", self.sweep(longer, out, "--quiet").stderr)

    def test_a_prepared_sweep_of_which_nothing_has_run_can_be_changed(self):
        chain = {"chain": "shear.strain_rate", "grid": {"shear.strain_rate": [2.0**-6, 2.0**-7]}}
        forms = ({"grid": SEEDS}, {"grid": SEEDS, "disks__elasticity": 2.0}, {"grid": {"disks.seed": [2, 9]}},
                 {"grid": {"disks.model": ["CD", "CD_n"]}}, chain, {**chain, "shear__strain": 0.25})
        out = self.folder / "out"
        for k, form in enumerate(forms):
            with self.subTest(form=form):
                path = self.sweep_file(**form)
                said = self.sweep(path, out, "--emit-slurm").stderr
                self.assertEqual("none had begun" in said, k > 0, said)
                whole = self.folder / f"whole{k}"
                self.sweep(path, whole, "--emit-slurm")
                self.assertEqual([point.name for point in self.points(out)],
                                 [point.name for point in self.points(whole)])
                for one, two in zip(self.points(out), self.points(whole)):
                    self.assertEqual((one / "scene.toml").read_text().replace(str(out), str(whole)),
                                     (two / "scene.toml").read_text())
                self.assertEqual(self.sweep(path, out, "--emit-slurm").stderr, "")
        self.sweep(path, out, "--quiet")
        self.assert_as_anew(out, forms[-1])

    def test_a_sweep_of_which_something_has_run_cannot(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out, "--emit-slurm")
        path = self.sweep_file(grid=SEEDS, disks__elasticity=2.0)
        point = self.points(out)[1]
        for name in ("log.txt", "checkpoint.h5", "notes"):
            (point / name).write_text("mine\n")
            before = files_of(out)
            for words in (("--emit-slurm",), (), ("--chain", 1)):
                self.assert_clean_error(self.bagnold("sweep", path, "--out", out, *words), 2, "another file")
            after = files_of(out)
            self.assertEqual({k: v for k, v in after.items() if ".lock" not in k},
                             {k: v for k, v in before.items() if ".lock" not in k})
            (point / name).unlink()
        self.assert_clean_error(self.bagnold("sweep", path, "--out", out, "--chain", 1), 2, "not prepared")
        self.sweep(path, out, "--emit-slurm")

    def test_slurm_tasks_refuse_a_file_that_gained_points(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid=SEEDS), out, "--emit-slurm")
        path = self.sweep_file(grid={"disks.seed": [1, 2, 3, 4]})
        self.assert_clean_error(self.bagnold("sweep", path, "--out", out, "--chain", 4), 2,
                                "--emit-slurm", "not prepared")
        self.sweep(path, out, "--emit-slurm")
        self.sweep(path, out, "--chain", 4, "--quiet")
        self.assertTrue((out / "points/0004_seed=4/summary.json").exists())

    def test_check_limit_goes_on_with_more_strain(self):
        scene, out = self.scene(shear__strain=0.2), self.folder / "limit"
        said = self.bagnold("check-limit", scene, "--out", out).stdout
        self.assertIn("shear.strain=", said)
        result = self.bagnold("check-limit", scene, "--out", out, "--set", "shear.strain=0.5")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(self.points(out)), 2)
        for point in self.points(out):
            self.assertEqual(read_summary(point)["scene"]["shear"]["strain"], 0.5)


class Columns(SweepTest):
    def test_folder_and_warnings(self):
        out = self.folder / "out"
        self.sweep(self.sweep_file(grid={"disks.packing_fraction": [0.7, 0.86]}), out, "--quiet")
        for row, folder in zip(rows(out), self.points(out)):
            self.assertEqual(row["folder"], folder.name)
            for what in ("warnings", "notes"):
                names = [one["name"] for one in read_summary(folder)[what]]
                self.assertEqual(row[what].split(), names)
        self.assertIn("above_jamming", rows(out)[1]["notes"])


class Joined(SweepTest):
    def test_two_sweeps_are_one_table(self):
        """Also where they differ in a key that neither varies, and read from sweep.csv."""
        one, two = self.folder / "one", self.folder / "two"
        long = {"shear__strain": 8.0}  # so long that disks meet
        self.sweep(self.sweep_file(grid={"disks.packing_fraction": [0.7, 0.72]}, **long), one, "--quiet")
        self.sweep(self.sweep_file(grid={"disks.packing_fraction": [0.72, 0.74]}, **long,
                                   disks__elasticity=2.0), two, "--quiet")
        result = self.bagnold("analyse", "table", one, two, "--out", self.folder / "joined")
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.folder / "joined.csv", newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual({(row["disks.packing_fraction"], row["disks.elasticity"]) for row in table},
                         {("0.7", "1"), ("0.72", "1"), ("0.72", "2"), ("0.74", "2")})
        values = {(row["disks.packing_fraction"], row["disks.elasticity"]): float(row["p"])
                  for row in table}
        for folder, elasticity in ((one, "1"), (two, "2")):
            for row in rows(folder):
                self.assertEqual(values[row["disks.packing_fraction"], elasticity], float(row["p"]))
        result = self.bagnold("analyse", "table", one)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((one / "table.csv").exists())

    def test_a_point_in_both_is_refused(self):
        one, two = self.folder / "one", self.folder / "two"
        for out in (one, two):
            self.sweep(self.sweep_file(grid=SEEDS), out, "--quiet")
        self.assert_clean_error(self.bagnold("analyse", "table", one, two), 2, "is in both")


if __name__ == "__main__":
    unittest.main()
