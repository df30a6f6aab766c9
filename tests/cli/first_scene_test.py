# SPDX-License-Identifier: BSD-3-Clause
"""What helps to write a scene: `bagnold init`, `schema`, `units`."""

import importlib.util
import json
import math
import re
import shutil
import subprocess
import tomllib
import unittest

from bagnold import SCENE, SOURCE, CliTest, changed, scene_text

SCENES = sorted((SOURCE / "inputs").glob("*.toml"))
CUT = ("--set", "shear.strain=0.1", "--set", "disks.count=64", "--set", "output.plot=false")


class Init(CliTest):
    def test_each_protocol_is_written_and_runs(self):
        for protocol in ("steady", "cascade", "ramp", "sequence", "oscillate", "stress", "pressure"):
            with self.subTest(protocol=protocol):
                name = f"{protocol}.toml"
                result = self.bagnold("init", name, "--protocol", protocol)
                self.assertEqual((result.returncode, result.stdout), (0, f"{name}\n"))
                text = (self.folder / name).read_text()
                scene = tomllib.loads(text)
                self.assertEqual(scene["shear"]["protocol"], protocol)
                for line in text.splitlines():
                    if " = " in line and not line.startswith(("#", "title")):
                        self.assertRegex(line, r" # [\w\[]", "a key without its meaning")
                self.assertIn(f"bagnold run {name}", text)
                quick = {"ramp": (*CUT, "--set", "shear.ramp_rate=1e-2", "--set", "shear.ramp_window=20"), "sequence": (*CUT[2:], "--set", "shear.pieces=[[1e-3, 0.05]]"),
                         "oscillate": (*CUT[2:], "--set", "shear.cycles=2"), "stress": (*CUT[2:], "--set", "shear.time=2e3")}.get(protocol, CUT)
                self.run_scene(self.folder / name, self.folder / protocol, *quick)

    def test_what_is_there_is_kept(self):
        self.assertEqual(self.bagnold("init").returncode, 0)
        before = (self.folder / "scene.toml").read_bytes()
        self.assert_clean_error(self.bagnold("init", "--protocol", "ramp"), 2, "scene.toml: is there already", "other.toml")
        self.assertEqual((self.folder / "scene.toml").read_bytes(), before)


class Installed(CliTest):
    def test_a_scene_that_is_not_here_came_with_the_program(self):
        """As README names it, from any folder; what is here goes first."""
        title = tomllib.loads((SOURCE / "inputs/quickstart.toml").read_text())["title"]
        self.assertIn(title, self.bagnold("validate", "inputs/quickstart.toml").stdout)
        self.assertEqual(self.bagnold("validate", "./inputs/sweep_elasticity.toml").returncode, 0)
        self.scene(name="inputs/quickstart.toml")
        self.assertNotIn(title, self.bagnold("validate", "inputs/quickstart.toml").stdout)
        for name in ("inputs/none.toml", "quickstart.toml", self.folder / "inputs/band.toml"):
            self.assert_clean_error(self.bagnold("validate", name), 2, str(name), "cannot be read")


class Schema(CliTest):
    def setUp(self):
        super().setUp()
        self.schema = json.loads(self.bagnold("schema").stdout)

    def test_every_key_with_its_default(self):
        """Those of inputs/reference.toml, which a test holds against the code."""
        reference = tomllib.loads((SOURCE / "inputs/reference.toml").read_text())
        for table, keys in reference.items():
            if table == "title":
                continue
            known = self.schema["properties"][table]["properties"]
            for key, value in keys.items():
                self.assertIn(key, known)
                if "default" in known[key]:
                    self.assertEqual(known[key]["default"], value, f"{table}.{key}")
                self.assertTrue(known[key]["description"])
        self.assertEqual(self.schema["then"]["properties"]["disks"]["required"],
                         ["model", "count", "packing_fraction", "elasticity", "mass"])
        self.assertEqual(self.schema["properties"]["disks"]["properties"]["mass"]["enum"], ["equal", "area"])

    def test_the_file_of_the_inputs_is_this_one(self):
        """And each of them names it: `bagnold schema --out inputs/scene.schema.json` writes it again."""
        path = self.folder / "written.json"
        self.assertEqual(self.bagnold("schema", "--out", path).returncode, 0)
        self.assertEqual(path.read_text(), (SOURCE / "inputs/scene.schema.json").read_text())
        for scene in SCENES:
            self.assertTrue(scene.read_text().startswith("#:schema ./scene.schema.json\n"), scene)

    @unittest.skipUnless(importlib.util.find_spec("jsonschema"), "jsonschema is not installed")
    def test_scenes_and_mistakes(self):
        import jsonschema
        check = jsonschema.Draft7Validator(self.schema)
        for path in (*SCENES, *(SOURCE / "inputs/checks").glob("*.toml")):
            self.assertEqual([error.message for error in check.iter_errors(tomllib.loads(path.read_text()))], [], path)
        for change in ({"disks__colour": 1}, {"disks__model": "CD_q"}, {"disks__packing_fraction": 0.0}, {"disks__packing_fraction": 1.5},
                       {"disks__count": 10.5}, {"disks__mass": None}, {"shear__discard": "some"}, {"output__plot": 1},
                       {"integration__time_step": "long"}, {"disks__seed": -1}):
            self.assertTrue(list(check.iter_errors(tomllib.loads(scene_text(changed(SCENE, **change))))), change)

    @unittest.skipUnless(shutil.which("taplo"), "taplo is not installed")
    def test_taplo(self):
        """As an editor would look at them."""
        said = subprocess.run(["taplo", "lint", *map(str, SCENES)], cwd=SOURCE, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        shutil.copy(SOURCE / "inputs/scene.schema.json", self.folder)
        wrong = self.folder / "wrong.toml"
        wrong.write_text(SCENES[0].read_text().replace("[disks]", '[disks]\ncolour = "red"'))
        said = subprocess.run(["taplo", "lint", str(wrong)], cwd=self.folder, capture_output=True, text=True)
        self.assertNotEqual(said.returncode, 0)
        self.assertIn("colour", said.stderr)


GLASS = ("--diameter", "2mm", "--density", "2.5g/cm3", "--modulus", "65GPa", "--poisson", "0.22", "--restitution", "0.95",
         "--rate", "10")


class Units(CliTest):
    def numbers(self, *words):
        result = self.bagnold("units", *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = dict(re.findall(r"^# (\w[\w ]*?) {2,}([-+.\de]+)", result.stdout, re.M))
        return {name: float(value) for name, value in found.items()}, tomllib.loads(result.stdout)

    def test_glass_beads_of_the_manual(self):
        """The numbers of docs/units.md, by the formulas there."""
        found, scene = self.numbers(*GLASS)
        mass = 2500 * math.pi / 6 * 2e-3**3
        duration = 2.87 * ((mass / 2) ** 2 / (2e-3 / 4 * (65e9 / (2 * (1 - 0.22**2))) ** 2 * 0.1)) ** 0.2
        elasticity = math.sqrt(((math.pi / math.log(0.95)) ** 2 + 1) / 2)
        time = duration / (math.pi / math.sqrt(2 - 1 / elasticity**2))
        self.assertAlmostEqual(found["m"] / mass, 1, delta=0.005)
        self.assertAlmostEqual(found["tau_e"] / time, 1, delta=0.005)
        self.assertAlmostEqual(found["pressure 1"] / (mass / time**2), 1, delta=0.005)
        self.assertAlmostEqual(scene["disks"]["elasticity"], 43.3)
        self.assertAlmostEqual(scene["shear"]["strain_rate"] / (10 * time), 1, delta=0.005)
        self.assertEqual(scene["disks"]["mass"], "equal")

    def test_the_restitution_is_that_of_the_scene(self):
        """e = exp(-pi / (2 M Q^2 - 1)^(1/2)), M = 1 or pi/2."""
        for mass, disk in (("equal", 1), ("area", math.pi / 2)):
            _, scene = self.numbers(*GLASS, "--mass", mass)
            e = math.exp(-math.pi / math.sqrt(2 * disk * scene["disks"]["elasticity"] ** 2 - 1))
            self.assertAlmostEqual(e, 0.95, delta=0.001)

    def test_units_of_what_is_given(self):
        one = self.numbers("--diameter", "0.002", "--density", "2500 kg/m3", "--modulus", "6.5e10")
        self.assertEqual(one, self.numbers("--diameter", "2 mm", "--density", "2.5 g/cm^3", "--modulus", "65000MPa"))

    def test_mistakes(self):
        for words, told in ((("--diameter", "2 miles"), ("--diameter = 2 miles", "mm", "--diameter 2mm")),
                            (("--diameter", "-2mm"), ("above 0",)), (("--modulus", "hard"), ("GPa",)), (("--mass", "some"), ("area",))):
            given = dict(zip(GLASS[::2], GLASS[1::2])) | {words[0]: words[1]}
            self.assert_clean_error(self.bagnold("units", *[word for pair in given.items() for word in pair]), 2, *told)


if __name__ == "__main__":
    unittest.main()
