# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold run` on a folder that holds a run: of the same scene it goes on or is left, of another it is refused."""

import os
import shutil
import unittest

from bagnold import SCENE, CliTest, Raw, changed, files_of, lattice_state, scene_text, write_state

CASCADE = {"shear__protocol": "cascade", "shear__strain_rate": None, "shear__strain_rates": Raw("[0.03125, 0.015625]")}


def without_lock(files):
    return {name: content for name, content in files.items() if not name.endswith(".lock")}


class GoingOn(CliTest):
    def assert_left(self, words, out):
        """The command has nothing to do, and says so."""
        before = without_lock(files_of(out))
        result = self.bagnold(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("is finished: the run of this scene is there, --force runs it again", result.stdout + result.stderr)
        self.assertTrue(without_lock(files_of(out)) == before, "a finished run was touched")

    def assert_refused(self, path, out, *words, arguments=()):
        before = without_lock(files_of(out))
        self.assert_clean_error(self.bagnold("run", path, "--out", out, *arguments), 2, "--force", "another --out", *words)
        self.assertTrue(without_lock(files_of(out)) == before, "a run of another scene was touched")

    def test_a_finished_run_is_left(self):
        path, out = self.scene(), self.folder / "out"
        self.run_scene(path, out)
        self.assert_left(["run", path, "--out", out], out)
        self.assert_left(["run", out / "scene.toml", "--out", out], out)  # the resolved scene is the same
        # so it is where a default is written out, in whatever way
        self.assert_left(["run", path, "--out", out, "--set", "disks.elasticity=1e0", "--set", "start.kind=random"], out)
        self.assertEqual(self.bagnold("run", path, "--out", out, "--quiet").stdout, "")

    def test_a_run_without_its_end_goes_on(self):
        """As a kill leaves it: at its last checkpoint, and before its first."""
        path, whole = self.scene(), self.folder / "whole"
        self.run_scene(path, whole, "--quiet")
        for lost in (("summary.json", "state.h5"), ("summary.json", "state.h5", "result.h5", "checkpoint.h5")):
            with self.subTest(lost=lost):
                out = self.folder / f"lost{len(lost)}"
                shutil.copytree(whole, out)
                for name in lost:
                    (out / name).unlink()
                self.run_scene(path, out)
                self.assert_same_results(whole, out)

    def test_another_scene_is_refused(self):
        path, out = self.scene(), self.folder / "out"
        self.run_scene(path, out, "--quiet")
        self.assert_refused(self.scene(name="seed.toml", disks__seed=2), out, "disks.seed = 2, there 1")
        self.assert_refused(path, out, "disks.elasticity = 2.0, there 1.0", "disks.mass = \"area\", there \"equal\"",
                            arguments=("--set", "disks.elasticity=2", "--set", "disks.mass=area"))
        self.assert_refused(path, out, "2 more", arguments=[word for key in ("elasticity=2", "seed=2", "mass=area", "count=66",
                            "packing_fraction=0.7") for word in ("--set", f"disks.{key}")])
        self.assert_refused(self.scene(name="cascade.toml", **CASCADE), out, "shear.protocol")
        self.run_scene(self.scene(name="seed.toml", disks__seed=2), out, "--quiet", "--force")

    def test_a_longer_one_is_told_how(self):
        path, out = self.scene(), self.folder / "out"
        self.run_scene(path, out, "--quiet")
        longer = self.scene(name="longer.toml", shear__strain=0.25)
        self.assert_refused(longer, out, "shear.strain = 0.25, there 0.125", f"`bagnold resume {out} --strain 0.25`")
        self.assertEqual(self.bagnold("resume", out, "--strain", "0.25").returncode, 0)
        self.assert_left(["run", longer, "--out", out], out)
        self.assert_refused(path, out, "shear.strain = 0.125, there 0.25")

    def test_a_run_without_its_scene_is_refused(self):
        path, out = self.scene(), self.folder / "out"
        self.run_scene(path, out, "--quiet")
        for what, text in (("[disks", "cannot be read"), (None, "without its scene.toml")):
            (out / "scene.toml").write_text(what) if what else (out / "scene.toml").unlink()
            self.assert_refused(path, out, text)

    def test_a_cascade(self):
        path, out = self.scene(**CASCADE), self.folder / "out"
        self.run_scene(path, out, "--quiet")
        self.assert_left(["run", path, "--out", out], out)
        stage = next(out.glob("0002*"))
        state = (stage / "state.h5").read_bytes()
        for file in (out / "summary.json", stage / "summary.json", stage / "state.h5"):
            file.unlink()
        self.run_scene(path, out, "--quiet")
        self.assertEqual((stage / "state.h5").read_bytes(), state)

    def test_a_start_from_a_file(self):
        """Named from where the scene lies, or whole."""
        write_state(self.folder / "state.h5", lattice_state())
        scene = changed(SCENE, disks__packing_fraction=0.1)
        path, out = self.folder / "scene.toml", self.folder / "out"
        path.write_text(scene_text({**scene, "start": {"kind": "state", "file": "state.h5"}}))
        self.run_scene(path, out, "--quiet")
        self.assert_left(["run", path, "--out", out], out)
        self.assert_left(["run", path, "--out", out, "--set", f"start.file={os.path.realpath(self.folder / 'state.h5')}"], out)


if __name__ == "__main__":
    unittest.main()
