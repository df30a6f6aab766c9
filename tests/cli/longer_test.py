# SPDX-License-Identifier: BSD-3-Clause
"""A finished run that is made longer ends bit for bit like one that was as long from its start."""

import itertools
import json
import re
import signal
import unittest

import h5py
import numpy as np
from bagnold import CliTest, Raw, read_summary, same_bits

# No number of windows or lookaheads goes into these strains.
SHORT, LONG = 0.2005, 0.4507
DILUTE = {"disks__packing_fraction": 0.4, "disks__model": "CD_n", "disks__count": 256,
          "shear__strain_rate": 2.0**-13}  # many steps at one go


def contents(path):
    """Every dataset and attribute of an HDF5 file by its name."""
    found = {}
    with h5py.File(path) as file:
        def take(name, item):
            for key, value in item.attrs.items():
                if key == "DIMENSION_LIST":  # references, which are places in a file
                    value = np.array([file[one].name for of_axis in value for one in of_axis], "S")
                elif key == "REFERENCE_LIST":
                    value = np.array([f"{file[one].name} {axis}" for one, axis in value], "S")
                found[f"{name}@{key}"] = value
            if isinstance(item, h5py.Dataset):
                found[name] = item[()]
        take("", file)
        file.visititems(take)
    return found


class LongerTest(CliTest):
    def assert_same_run(self, first, second):
        """state.h5, all of result.h5 but what engines count, trajectories and averages."""
        self.assert_same_results(first, second)
        names = ["state.h5", "result.h5"] + [p.name for p in first.glob("*.h5md")]
        for name in names:
            one, two = contents(first / name), contents(second / name)
            for all_of in (one, two):
                for key in [k for k in all_of if k.startswith("@engine_")]:
                    del all_of[key]
            self.assertEqual(one.keys(), two.keys())
            for key in one:
                self.assertTrue(same_bits(one[key], two[key]), f"{name}: {key} differs")
        for path in (first, second):
            self.assertEqual(list(path.glob("*.parts")), [])
        self.assertEqual((first / "scene.toml").read_text(), (second / "scene.toml").read_text())
        names = [sorted(p.name for p in path.iterdir()) for path in (first, second)]
        self.assertEqual(*[[n for n in each if n != "checkpoint.previous.h5"] for each in names])

    def wait_for_new_checkpoint(self, out, process):
        """One that was not there when it was called."""
        def stamp():
            try:
                return (out / "checkpoint.h5").stat().st_mtime_ns
            except FileNotFoundError:  # between two renames
                return None
        before = stamp()
        self.wait_until(lambda: stamp() not in (None, before), process)

    def longer(self, out, strain, *arguments, code=0):
        result = self.bagnold("resume", out, "--strain", strain, *arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def check(self, short=SHORT, long=LONG, name="case", **changes):
        out = self.run_new(f"{name}-short", shear__strain=short, **changes)
        text = self.longer(out, long)
        whole = self.run_new(f"{name}-whole", shear__strain=long, **changes)
        self.assert_same_run(whole, out)
        return text

    def test_twice_the_strain(self):
        """What is measured then begins with the last frame of before."""
        self.check(short=0.4, long=0.8, disks__count=300, shear__strain_rate=0.01,
                   output__sample_strain=0.05, measure__profiles=True, measure__fields=True,
                   measure__rotation=True, measure__contacts=True)

    def test_steps_and_lookaheads(self):
        """Dense and dilute, with either scheme, at lengths that no engine would stop at."""
        schemes = ("modified-velocity-verlet", "two-stage-leapfrog")
        for where, scheme in itertools.product(({}, DILUTE), schemes):
            with self.subTest(where=where, scheme=scheme):
                self.check(name=f"{bool(where)}{scheme}", integration__scheme=scheme, **where)

    def test_in_several_goes(self):
        out = self.run_new("out", shear__strain=SHORT, output__trajectory_strain=0.01, **DILUTE)
        for strain in (0.2507, 0.31, LONG):
            self.longer(out, strain)
        whole = self.run_new("whole", shear__strain=LONG, output__trajectory_strain=0.01, **DILUTE)
        self.assert_same_run(whole, out)

    def test_replicas_with_trajectories(self):
        self.check(disks__replicas=3, output__trajectory_strain=0.02, **DILUTE)

    def test_all_that_is_measured(self):
        """Frames and contacts that the longer run discards are forgotten."""
        for where in ({}, DILUTE):
            with self.subTest(where=where):
                more = {"measure__profiles": True, "measure__fields": True, "disks__count": 300,
                        "measure__rotation": not where, "measure__contacts": True,
                        "measure__correlations": True, "measure__frame_strain": 0.013}
                self.check(name=f"all{bool(where)}", **{**where, **more})

    def test_profiles_of_a_little_more(self):
        """Their frames are known one by one."""
        self.check(long=0.25, measure__profiles=True, measure__frame_strain=0.013)

    def test_mixed_frames_are_refused(self):
        out = self.run_new("out", shear__strain=SHORT, measure__contacts=True)
        before = (out / "summary.json").read_bytes()
        result = self.bagnold("resume", out, "--strain", 0.3)
        self.assert_clean_error(result, 2, "measure.contacts", "--strain 0.401")
        self.assertEqual((out / "summary.json").read_bytes(), before)

    def test_discard_auto_is_said(self):
        text = self.check(long=0.8, shear__discard="auto", output__sample_strain=2.0**-9)
        self.assertIn('shear.discard = "auto"', text)

    def test_target_error(self):
        """Met or not, a longer run ends where it would have from the start."""
        for target in (1e-9, 0.5):
            with self.subTest(target=target):
                for where in ({}, DILUTE):
                    self.check(short=1.0005, long=1.7, name=f"{bool(where)}{target}",
                               output__sample_strain=2.0**-9,
                               shear__target_error=Raw(f"{{ p = {target} }}"), **where)

    def test_a_trajectory_that_could_not_be_joined(self):
        """After the summary is written: the parts are all that holds the new frames, and resume joins them."""
        changes = {"output__trajectory_strain": 0.01, **DILUTE}
        out = self.run_new("out", shear__strain=SHORT, **changes)
        (out / "trajectory.h5md.tmp").mkdir()  # in the place of the file that is written first
        self.assertEqual(self.bagnold("resume", out, "--strain", LONG).returncode, 4)
        self.assertTrue((out / "summary.json").exists() and (out / "trajectory.h5md").exists())
        (out / "trajectory.h5md.tmp").rmdir()
        self.assertEqual(self.bagnold("resume", out).returncode, 0)
        whole = self.run_new("whole", shear__strain=LONG, **changes)
        self.assertEqual((out / "trajectory.h5md").read_bytes(), (whole / "trajectory.h5md").read_bytes())
        self.assertEqual(list(out.glob("*.parts")), [])

    def test_contacts_and_a_target(self):
        """No histograms are kept then, so nothing is in the way of any strain."""
        out = self.run_new("out", shear__strain=SHORT, measure__contacts=True, shear__target_error=Raw("{ p = 1e-9 }"))
        self.assertEqual(self.bagnold("resume", out, "--strain", 1.2 * SHORT).returncode, 0)

    def test_advice_on_strain_can_be_taken(self):
        """Where histograms discard a fifth, five times the strain is the least."""
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(shear__strain=0.5, shear__discard=0.2, measure__contacts=True), "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        strains = [float(one) for one in re.findall(r"--strain ([\d.]+)", result.stderr)]
        self.assertTrue(strains)
        self.assertGreaterEqual(min(strains), 2.5)
        self.assertEqual(self.bagnold("resume", out, "--strain", min(strains)).returncode, 0)

    def test_unfinished(self):
        """Stopped on its way, and stopped again when longer; the command may be typed again."""
        changes = {"output__checkpoint_minutes": 0.0005, "output__trajectory_strain": 0.05, **DILUTE}
        scene = self.scene(shear__strain=6.0, **changes)
        out = self.folder / "out"
        process = self.start("run", scene, "--out", out)
        for strain in (10.0, 10.0):
            self.wait_for_new_checkpoint(out, process)
            process.send_signal(signal.SIGTERM)
            self.assertIn(self.finish(process)[0], (143, 0))
            process = self.start("resume", out, "--strain", strain)
        self.assertEqual(self.finish(process)[0], 0)
        whole = self.run_new("whole", shear__strain=10.0, **changes)
        self.assert_same_run(whole, out)

    def test_killed_while_made_longer(self):
        """Also where its trajectory has become parts again and the old file is still there."""
        changes = {"output__checkpoint_minutes": 0.0003, "output__trajectory_strain": 0.02, **DILUTE}
        out = self.run_new("out", shear__strain=1.0, **changes)
        self.assertTrue((out / "trajectory.h5md").exists())
        process = self.start("resume", out, "--strain", 10)
        for _ in range(4):
            self.wait_for_new_checkpoint(out, process)
            process.kill()
            self.finish(process)
            process = self.start("resume", out)
        self.assertEqual(self.finish(process)[0], 0)
        whole = self.run_new("whole", shear__strain=10.0, **changes)
        self.assert_same_run(whole, out)

    def test_by_hand(self):
        """More strain in scene.toml says the same."""
        out = self.run_new("out", shear__strain=SHORT)
        scene = out / "scene.toml"
        scene.write_text(scene.read_text().replace(f"strain = {SHORT}", f"strain = {LONG}"))
        result = self.bagnold("resume", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_same_run(self.run_new("whole", shear__strain=LONG), out)

    def test_cascade(self):
        """Its last rate grows; the file of the stages is written anew."""
        changes = {"shear__protocol": "cascade", "shear__strain_rate": None,
                   "shear__strain_rates": [2.0**-7, 2.0**-8]}
        out = self.run_new("out", shear__strain=0.1, **changes)
        text = self.longer(out, 0.2)
        self.assertIn("last rate", text)
        scene = out / "scene.toml"  # and once more by hand
        before = scene.read_text()
        scene.write_text(before.replace("[0.1, 0.2]", "0.3"))  # the second rate started from the end of the first
        self.assert_clean_error(self.bagnold("resume", out), 2, "rate 1 of 2", "of which the last alone is more")
        self.assertTrue((out / "summary.json").exists())
        stage = out / "0001_strain_rate=0.0078125" / "scene.toml"
        text = stage.read_text()
        stage.write_text(text.replace("\nstrain = 0.1\n", "\nstrain = 0.3\n"))
        self.assert_clean_error(self.bagnold("resume", stage.parent), 2, "is a rate of the cascade")
        stage.write_text(text)
        scene.write_text(before.replace("0.2]", "0.3]"))
        self.assertEqual(self.bagnold("resume", out).returncode, 0)
        whole = self.run_new("whole", shear__strain=[0.1, 0.3], **changes)
        for stage in ("0001_strain_rate=0.0078125", "0002_strain_rate=0.00390625"):
            one, two = out / stage, whole / stage
            self.assert_same_state(one, two)
            self.assertEqual(read_summary(one)["observables"], read_summary(two)["observables"])
        self.assertEqual(json.loads((out / "summary.json").read_text()),
                         json.loads((whole / "summary.json").read_text()))
        self.assertEqual((out / "scene.toml").read_text(), (whole / "scene.toml").read_text())

    def test_further_rate_of_a_cascade(self):
        """Written after the last one: it starts from its end. Other rates are refused."""
        changes = {"shear__protocol": "cascade", "shear__strain_rate": None, "shear__strain": 0.1}
        out = self.run_new("out", shear__strain_rates=[2.0**-7, 2.0**-8], **changes)
        scene = out / "scene.toml"
        before = scene.read_text()
        self.assertIn("[0.0078125, 0.00390625]", before)
        for rates, number in (("[0.0078125, 0.005, 0.00390625]", 2), ("[0.01, 0.005]", 1), ("[0.0078125, 0.001]", 2),
                              ("[0.0078125]", 2)):
            scene.write_text(before.replace("[0.0078125, 0.00390625]", rates))
            self.assert_clean_error(self.bagnold("resume", out), 2, f"at rate {number}", "another --out")
            self.assertTrue((out / "summary.json").exists())
        scene.write_text(before.replace("0.00390625]", "0.00390625, 0.001953125, 0.001]"))
        self.assertEqual(self.bagnold("resume", out).returncode, 0)
        whole = self.run_new("whole", shear__strain_rates=[2.0**-7, 2.0**-8, 2.0**-9, 0.001], **changes)
        self.assert_same_state(out / "0004_strain_rate=0.001", whole / "0004_strain_rate=0.001")
        self.assertEqual(json.loads((out / "summary.json").read_text()), json.loads((whole / "summary.json").read_text()))
        self.assertIn("finished", self.longer(out, 0.1))

    def test_refusals(self):
        out = self.run_new("out", shear__strain=SHORT)
        self.assert_clean_error(self.bagnold("resume", out, "--strain", 0.1), 2, "0.2005", "must be")
        self.assertIn("finished", self.longer(out, SHORT))
        ramp = self.run_new("ramp", shear__protocol="ramp", shear__strain=0.01,
                            shear__ramp_rate=1e-3, shear__strain_rate_high=2.0**-6,
                            shear__discard=None, shear__ramp_window=100.0,
                            output__sample_strain=None)
        self.assert_clean_error(self.bagnold("resume", ramp, "--strain", 1), 2, "ramp", "cycles")
        for path in out.glob("checkpoint*"):
            path.unlink()
        self.assert_clean_error(self.bagnold("resume", out, "--strain", 1), 2, "no checkpoint")
        self.assertTrue((out / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
