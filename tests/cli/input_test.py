# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: one clear message, exit code 2, nothing written."""

import os
import re
import unittest

from bagnold import SCENE, CliTest, Raw, read_summary, scene_text


class BadValues(CliTest):
    def check(self, table, key, *values, words=()):
        for value in values:
            with self.subTest(key=f"{table}.{key}", value=value):
                path = self.scene(**{f"{table}__{key}": value})
                self.refused(path, f"{table}.{key}", *words)

    def test_out_of_range(self):
        self.check("disks", "model", "CD_x", "", words=("CD_rot",))
        self.check("disks", "packing_fraction", 0.0, -0.5, 2.0, Raw("nan"), Raw("inf"))
        self.check("disks", "elasticity", 0.0, -1.0, Raw("nan"), Raw("inf"))
        self.check("disks", "mass", "volume", words=("equal", "area"))
        self.check("disks", "force_exponent", 0.5, -2.0, Raw("nan"))
        self.check("shear", "strain_rate", 0.0, -1e-4, Raw("nan"), Raw("inf"))
        self.check("shear", "strain", 0.0, -1.0, Raw("inf"), Raw("nan"))
        self.check("shear", "discard", -0.1, 1.5, Raw("nan"))
        self.check("integration", "scheme", "leapfrog", words=("auto", "modified-velocity-verlet", "two-stage-leapfrog", "implicit-damping"))
        self.check("integration", "time_step", 0.0, -0.1, Raw("nan"), "fast")
        self.check("measure", "every", 0, -1)
        self.check("measure", "frame_strain", 0.0, -1.0, Raw("nan"))
        self.check("output", "sample_strain", 0.0, -1.0, Raw("nan"))
        self.check("output", "trajectory_strain", -1.0, Raw("nan"))
        self.check("output", "checkpoint_minutes", 0.0, -1.0, Raw("nan"))
        self.check("start", "kind", "lattice", words=("random", "state"))

    def test_the_message_names_the_value(self):
        self.check("disks", "packing_fraction", -0.5, words=("-0.5",))
        self.check("disks", "model", "CD_x", words=("CD_x",))
        self.check("measure", "every", -17, words=("-17",))

    def test_wrong_type(self):
        self.check("disks", "model", 1, True, ["CD"])
        self.check("disks", "count", 64.0, "64", True, [64], Raw("1979-05-27"), Raw("{ a = 1 }"))
        self.check("disks", "seed", 1.5, "one")
        self.check("disks", "packing_fraction", "0.8", True, [0.8])
        self.check("shear", "strain", "1", False)
        self.check("measure", "every", 2.5, 10.0, "10")
        self.check("output", "checkpoint_minutes", "10")
        self.check("integration", "time_step", True)

    def test_count(self):
        self.check("disks", "count", 63, words=("63", "even", "62", "64"))
        self.check("disks", "count", 0, -2)

    def test_absurd_count_is_refused_for_memory(self):
        self.check("disks", "count", 10**12, 2**62)
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        if memory < 30e9:  # positions, velocities, forces and lists take more than 150 bytes a disk
            self.refused(self.scene(disks__count=199999998), "disks.count", "memory")

    def test_not_there_yet(self):
        self.check("shear", "protocol", "ramp", "cascade", words=("steady",))

    def test_box_too_small(self):
        """A box must hold two contact distances and skins."""
        path = self.scene(disks__count=4, disks__packing_fraction=0.84)
        self.refused(path, "disks.count")

    def test_unstable_time_step(self):
        for model, elasticity, step in (
            ("CD", 1.0, 5.0), ("CD_n", 1.0, 5.0), ("CD_rot", 1.0, 5.0), ("CD_nt", 1.0, 5.0),
            ("CD", 0.05, 0.2), ("CD_n", 0.05, 0.2), ("CD_rot", 0.05, 0.2),
        ):
            with self.subTest(model=model, step=step):
                path = self.scene(disks__model=model, disks__elasticity=elasticity,
                                  integration__time_step=step)
                self.refused(path, "integration.time_step", "--allow-unstable")

    def test_automatic_time_step_is_stable(self):
        for model in ("CD", "CD_n", "CD_rot", "CD_nt"):
            for elasticity in (0.05, 0.3, 1.0, 50.0):
                for mass in ("equal", "area"):
                    with self.subTest(model=model, elasticity=elasticity, mass=mass):
                        path = self.scene(disks__model=model, disks__elasticity=elasticity,
                                          disks__mass=mass, integration__time_step="auto")
                        result = self.bagnold("validate", path)
                        self.assertEqual(result.returncode, 0, result.stderr)

    def test_state_start_without_file(self):
        self.refused(self.scene(start__kind="state"), "start.file")
        self.refused(self.scene(start__kind="state", start__file="nowhere.h5"), "nowhere.h5")


class BadKeys(CliTest):
    def test_nearest_key_is_suggested(self):
        for table, wrong, right in (
            ("disks", "packing_fracton", "packing_fraction"),
            ("disks", "cuont", "count"),
            ("shear", "strain_rat", "strain_rate"),
            ("integration", "timestep", "time_step"),
            ("measure", "evry", "every"),
            ("output", "checkpoint_minute", "checkpoint_minutes"),
            ("start", "knd", "kind"),
        ):
            with self.subTest(key=wrong):
                path = self.scene(**{f"{table}__{wrong}": 1})
                self.refused(path, f"{table}.{wrong}", right)

    def test_unknown_table(self):
        self.refused(self.scene(disk__count=64), "disk", "disks")
        self.refused(self.scene(lasers__power=64), "lasers")

    def test_unknown_top_level_key(self):
        self.refused(self.scene({"titel": "a", **SCENE}), "titel", "title")

    def test_where_it_stands(self):
        """File and line are named."""
        path = self.scene({"title": "a", "disks": {"model": "CD", "cuont": 64}})
        error = self.bagnold("validate", path).stderr
        self.assertIn(path.name, error)
        self.assertRegex(error, r"(?<!\d)4(?!\d)")

    def test_required_keys(self):
        for name in ("disks__model", "disks__count", "disks__packing_fraction",
                     "disks__elasticity", "disks__mass", "shear__strain_rate", "shear__strain"):
            with self.subTest(key=name):
                self.refused(self.scene(**{name: None}), name.replace("__", "."))

    def test_everything_else_has_a_default(self):
        required = {
            "disks": {k: SCENE["disks"][k] for k in
                      ("model", "count", "packing_fraction", "elasticity", "mass")},
            "shear": {"strain_rate": 1e-4, "strain": 20.0},
        }
        result = self.bagnold("validate", self.scene(required))
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_table_is_a_table(self):
        self.refused(self.scene({"disks": 3}), "disks")
        array = scene_text(SCENE).replace("[disks]", "[[disks]]")
        self.refused(self.text(array), "disks")

    def text(self, text, name="text.toml"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path


class BadFiles(CliTest):
    def text(self, text, name="bad.toml"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def test_missing(self):
        self.refused(self.folder / "nowhere.toml", "nowhere.toml")
        self.refused(self.folder)  # a folder is no scene

    def test_malformed_says_line_and_column(self):
        for text, line in (
            ("[disks]\ncount = = 64\n", 2),
            ("[disks]\n\n\nmodel = \"CD\n", 4),
            ("[disks\ncount = 64\n", 1),
            ("[disks]\ncount = 64\ncount = 66\n", 3),
            ("[disks]\ncount = 99999999999999999999\n", 2),
        ):
            with self.subTest(text=text):
                path = self.text(text)
                self.refused(path, path.name)
                error = self.bagnold("validate", path).stderr
                self.assertRegex(error, rf"line {line}\b.*column \d+|:{line}:\d+")

    def test_bytes_that_are_no_text(self):
        valid = scene_text(SCENE).encode()
        for text in (b"\xff\xfe" + valid, b"# \xc3\x28\n" + valid, b"# \x07\n" + valid,
                     b"title = \"\x1b[31m\"\n" + valid, b"\x00" * 64, valid + b"\x00",
                     b"\x89HDF\r\n\x1a\n" + bytes(range(256)), b"titl\xc3\xa9 = 1\n" + valid):
            with self.subTest(text=text[:20]):
                self.refused(self.text(text))

    def test_text_in_other_languages_is_welcome(self):
        scene = {"title": "Scherzellen à 0.82, φ", **SCENE}
        path = self.text("# größer\n" + scene_text(scene).replace("\\u00e0", "à"))
        self.assertEqual(self.bagnold("validate", path).returncode, 0)

    def test_empty(self):
        self.refused(self.text(""), "disks.")

    def test_huge(self):
        path = self.folder / "huge.toml"
        with open(path, "wb") as file:
            file.write(scene_text(SCENE).encode() + b"#")
            file.truncate(3 * 10**9)
        self.refused(path)
        self.refused("/dev/zero")

    def test_deeply_nested(self):
        for text in ("a = " + "[" * 50000, "a = " + "{a=" * 50000, "[" + "a." * 50000 + "a]\n",
                     "a." * 50000 + "a = 1\n", "a = " + "[" * 500 + "]" * 500 + "\n"):
            with self.subTest(text=text[:8]):
                self.refused(self.text(text))


class Messages(CliTest):
    """Short, and all that is wrong in one go."""

    def text(self, text):
        path = self.folder / "bad.toml"
        path.write_text(text)
        return path

    def said(self, *arguments):
        result = self.bagnold(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def test_all_mistakes_in_one_go(self):
        path = self.scene(disks__model="CD_x", disks__count=63, disks__cuont=64, shear__strain=-1.0,
                          output__plot="yes", shear__strain_rate=None)
        said = self.said("validate", path)
        for word in ("disks.model", "must be even", "disks.cuont", "shear.strain = -1", "output.plot",
                     "shear.strain_rate is missing"):
            self.assertIn(word, said)
        self.assertEqual(len(said.splitlines()), 6, said)

    def test_one_mistake_is_told_once(self):
        for changes in ({"disks__cuont": 64, "disks__count": None}, {"shear__protocol": "shaken"},
                        {"start__kind": "lattice", "start__file": "x.h5"}):
            said = self.said("validate", self.scene(**changes))
            self.assertEqual(len(said.splitlines()), 1, said)

    def test_very_many_mistakes(self):
        lines = "".join(f"wrong{k} = 1\n" for k in range(10000))
        said = self.said("validate", self.text(lines + scene_text(SCENE)))
        self.assertLess(len(said), 4000)
        self.assertIn("and 9980 more", said)

    def test_words_of_a_megabyte(self):
        long = "x" * 900000
        valid = scene_text(SCENE)
        for text in (f"{long} = 1\n" + valid, f"[{long}]\n" + valid, f'title = 3\n{long}.y = 1\n' + valid,
                     valid.replace('"CD_rot"', f'"{long}"'), f'title = "{long}" x\n' + valid,
                     f"{long} = 1\n{long} = 2\n" + valid, f"title = {long}\n" + valid,
                     valid + f'[start]\nfile = "{long}"\n', valid + f'[sweep]\n{long} = 1\n',
                     valid + f'[sweep]\ngrid = {{ "{long}" = [1] }}\n',
                     valid + f'[sweep]\ngrid = {{ "disks.model" = ["{long}", "CD"] }}\n',
                     valid + f'[sweep]\nchain = "{long}"\ngrid = {{ "disks.count" = [64] }}\n'):
            with self.subTest(text=text[:20]):
                self.assertLess(len(self.said("validate", self.text(text))), 2000)
        for word in (long[:100000], long[:100000] + "=1", "disks." + long[:100000] + "=1"):
            self.assertLess(len(self.said("validate", self.text(valid), "--set", word)), 2000)
        self.assertLess(len(self.said(long[:100000])), 2000)

    def test_letters_that_a_terminal_obeys(self):
        path = self.text(scene_text(SCENE).replace('"CD_rot"', '"\\u001b[31m"'))
        self.assert_clean_error(self.bagnold("validate", path), 2, "disks.model")

    def test_texts_stand_in_quotes(self):
        valid = scene_text(SCENE)
        for text in (valid.replace('"CD_rot"', "CD_rot"), valid.replace('"CD_rot"', '"CD_rot'),
                     valid + "[start]\nfile = /tmp/state.h5\n", valid + "[start]\nfile = states/a.h5\n",
                     valid + '[sweep]\ngrid = { "disks.model" = [CD, CD_n] }\n'):
            self.assertIn("texts stand in quotes", self.said("validate", self.text(text)))
        self.assertNotIn("quotes", self.said("validate", self.text(valid + "[start]\noverlap = 1e-\n")))

    def test_a_long_list_is_not_deeply_nested(self):
        rates = ", ".join(f"{0.5 * 0.99**k:.9f}" for k in range(300))
        path = self.scene(shear__protocol="cascade", shear__strain_rate=None,
                          shear__strain_rates=Raw(f"[{rates}]"), integration__time_step=2.0**-7)
        self.assertEqual(self.bagnold("validate", path).returncode, 0)

    def test_less_than_a_window_is_refused(self):
        path = self.scene(shear__strain=2.0**-7)
        self.refused(path, "shear.strain", "output.sample_strain")
        self.assertEqual(self.bagnold("validate", self.scene(shear__strain=2.0**-6)).returncode, 0)

    def test_the_nearest_command(self):
        for word, meant in (("rum", "run"), ("resmue", "resume"), ("analyze", "analyse"),
                            ("check_limit", "check-limit"), ("Sweep", "sweep")):
            self.assertIn(f"did you mean {meant}?", self.said(word, "scene.toml"))


class CommandLine(CliTest):
    def test_version_and_help(self):
        self.assertRegex(self.bagnold("--version").stdout, r"^bagnold \d+\.\d+")
        for arguments, words in ((("help",), ("run", "sweep", "Exit codes")), (("help", "sweep"), ("--jobs",)),
                                 (("--help",), ("run",)), (("run", "--help"), ("--force",))):
            result = self.bagnold(*arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
            for word in words:
                self.assertIn(word, result.stdout)

    def test_the_nearest_option(self):
        for words, meant in ((("run", "scene.toml", "--otu", "x"), "--out"),
                             (("resume", "x", "--strian=4"), "--strain"),
                             (("sweep", "x", "--job", "2"), "--jobs"),
                             (("status", "x", "--hlep"), "--help")):
            result = self.bagnold(*words)
            self.assert_clean_error(result, 2, "unknown option", f"did you mean {meant}?")

    def test_what_people_come_with(self):
        path = self.scene()
        for option, meant in (("--dt", "--set integration.time_step=VALUE"), ("--seed", "--set disks.seed=VALUE"),
                              ("-N", "--set disks.count=VALUE"), ("--friction", "no friction"),
                              ("--steps", "shear.strain"), ("--output", "did you mean --out?"),
                              ("--nthreads", "did you mean --threads?")):
            result = self.bagnold("run", path, option, "1")
            self.assert_clean_error(result, 2, f"unknown option {option}", meant)
        for word, meant in (("list", "status"), ("restart", "resume"), ("check", "validate"), ("start", "run")):
            self.assertIn(f"did you mean {meant}?", self.bagnold(word).stderr)
        said = self.bagnold("frobnicate").stderr
        self.assertNotIn("did you mean", said)
        self.assertIn("bagnold --help", said)
        for word in ("friction=0.3", "xyzzy=1"):
            self.assertNotIn("did you mean", self.bagnold("validate", path, "--set", word).stderr)
        self.assertIn("shear.strain_rate, in its file",
                      self.bagnold("sweep", path, "--gammadot", "1e-3").stderr)

    def test_integers_are_decimal_digits(self):
        for words in (("run", "x", "--threads"), ("sweep", "x", "--jobs"), ("sweep", "x", "--chain"),
                      ("check-limit", "x", "--jobs"), ("analyse", "kink", "x", "--seed"),
                      ("analyse", "kink", "x", "--resamples"), ("analyse", "kink", "x", "--first"),
                      ("analyse", "kink", "x", "--kinks"), ("figure", "P2-4", "--jobs")):
            for number in ("0x10", "1e1", "2.0", " 2", "2 ", "1_0", "+2", "two", "0b1", "\u0662",
                           "99999999999999999999999"):
                with self.subTest(words=words, number=number):
                    result = self.bagnold(*words, number)
                    self.assert_clean_error(result, 2, words[-1], "whole number in decimal digits")

    def test_leading_zeros_mean_nothing(self):
        """010 is ten, as job arrays may write it, and no octal 8."""
        out = self.folder / "out"
        path = self.folder / "sweep.toml"
        path.write_text(scene_text(SCENE) + '[sweep]\ngrid = { "disks.seed" = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11] }\n')
        self.assertEqual(self.bagnold("sweep", path, "--out", out, "--emit-slurm").returncode, 0)
        for chain, point in (("010", "0010"), ("007", "0007"), ("09", "0009")):
            self.assertEqual(self.bagnold("sweep", path, "--out", out, "--chain", chain, "--quiet").returncode, 0)
            self.assertTrue((out / f"points/{point}_seed={int(chain)}/summary.json").exists())
        self.assertEqual(len(list(out.glob("points/*/summary.json"))), 3)
        for chain in ("0", "00", "012", "-1"):
            result = self.bagnold("sweep", path, "--out", out, "--chain", chain)
            self.assert_clean_error(result, 2, f"--chain {int(chain)}", "from 1 to 11")

    def test_numbers_are_decimal(self):
        for words in (("resume", "x", "--strain"), ("check-limit", "x", "--tolerance"),
                      ("analyse", "kink", "x", "--phi-j"), ("analyse", "kink", "x", "--split")):
            for number in ("0x10", "1,5", "nan", "ten", "1 "):
                with self.subTest(words=words, number=number):
                    self.assert_clean_error(self.bagnold(*words, number), 2, words[-1], "decimal number")
        result = self.bagnold("analyse", "kink", "x", "--fix", "x=0x10")
        self.assert_clean_error(result, 2, "--fix x=0x10", "number")

    def test_empty_words_are_refused(self):
        """A variable of a shell that is not set: each option of each command."""
        said = self.bagnold("--help").stdout
        commands = re.findall(r"^  ([a-z-]+) ", said[said.index("Subcommands:"):], re.M)
        self.assertGreater(len(commands), 8)
        tried = 0
        for command in commands:
            options = re.findall(r"^  (--[a-z-]+) (?:TEXT|INT|UINT|FLOAT|\[)(.*)$",
                                 self.bagnold(command, "--help").stdout, re.M)
            for option, more in options:
                values = ("", "") if "FLOAT]" in more or "x 2" in more else ("",)
                for words in ((option, *values), (option + "=",)):
                    with self.subTest(command=command, words=words):
                        result = self.bagnold(command, "x", "y", *words)
                        self.assert_clean_error(result, 2, option, "empty")
                        tried += 1
        self.assertGreater(tried, 60)
        for words in (("run", ""), ("resume", ""), ("sweep", ""), ("status", ""), ("analyse", "kink", "")):
            self.assert_clean_error(self.bagnold(*words), 2, "empty")

    def test_all_mistakes_at_once(self):
        """Of the form of the file and of the command line; of what a run of it would come to."""
        path = self.scene(disks__elasticity=-1.0, disks__count=63)
        result = self.bagnold("validate", path, "--set", "disks.mass=[", "--set", "disks.model=CD_x")
        self.assertEqual(result.returncode, 2)
        for word in ("disks.elasticity", "disks.count", "disks.mass", "disks.model"):
            self.assertIn(word, result.stderr)
        path = self.scene(integration__time_step=8.0, shear__strain=2.0**-8)
        result = self.bagnold("validate", path, "--set", "shear.target_error={ Bp = 0.1 }",
                              "--set", "output.sample_strain=1")
        self.assertEqual(result.returncode, 2)
        for word in ("integration.time_step", "output.sample_strain", "did you mean B_p"):
            self.assertIn(word, result.stderr)

    def test_less_than_a_window(self):
        """Of a given stress or pressure too; it would be made up to a window without a word."""
        held = {"shear__strain": None, "shear__discard": None, "integration__time_step": None, "output__sample_strain": 0.01,
                "shear__strain_rate": 1e-3}
        for changes, key, good in (
                ({"shear__protocol": "stress", "shear__stress": 1e-3, "shear__time": 5.0}, "shear.time", 10),
                ({"shear__protocol": "pressure", "shear__pressure": 1e-3, "shear__strain": 0.005}, "shear.strain", 0.01)):
            path = self.scene(**{**held, **changes})
            self.assert_clean_error(self.bagnold("validate", path), 2, key, "output.sample_strain", "raise")
            self.assertEqual(self.bagnold("validate", path, "--set", f"{key}={good}").returncode, 0)

    def test_velocities_in_contact_and_a_target(self):
        path = self.scene(shear__target_error=Raw("{ B_p = 0.1 }"), measure__contacts=True)
        self.assertEqual(self.bagnold("validate", path).returncode, 0)
        self.assert_clean_error(self.bagnold("validate", path, "--set", "measure.correlations=true"), 2,
                                "shear.target_error", "measure.correlations", "shear.strain alone")

    def test_the_table_is_short_and_whole_with_all(self):
        """Digits by the error, 1.89(10)e4; what is left out is in summary.json."""
        path = self.scene(shear__strain=16.0, output__sample_strain=2.0**-6)
        short = self.run_scene(path, self.folder / "short").stdout
        whole = self.run_scene(path, self.folder / "whole", "--all").stdout
        first = lambda said: {line.split(" ")[0] for line in said.splitlines()}
        self.assertLessEqual({"p", "sigma", "mu", "Z", "T_g", "B_p", "eta_p"}, first(short))
        self.assertNotIn("p_kin", first(short))
        self.assertLessEqual(set(read_summary(self.folder / "whole")["observables"]), first(whole))
        self.assertIn("--all", short)
        self.assertNotIn("--all", whole)
        self.assertRegex(short, r"\nZ +\d\.\d+\(\d+\) ")

    def test_set_proposes_the_key(self):
        path = self.scene()
        for text, meant in (("count=64", "disks.count"), ("strainrate=1", "shear.strain_rate"),
                            ("disks.strain=1", "shear.strain"), ("shear.target_error={ Bp = 0.1 }", "B_p")):
            said = self.bagnold("validate", path, "--set", text).stderr
            self.assertIn(f"did you mean {meant}?", said)

    def test_set_takes_a_path_as_it_is(self):
        """A cascade's own folders have a = in their names."""
        for name in ("0002_strain_rate=0.0001/state.h5", "a [1]/state.h5", "a#b/state.h5"):
            path = self.scene(start__kind="state")
            self.refused(path, f"{name} is not there", arguments=("--set", f"start.file={name}"))

    def test_set_with_bad_key_or_value(self):
        path = self.scene()
        for text, *words in (
            ("disks.cuont=64", "disks.cuont", "disks.count"),
            ("disk.count=64", "disk"),
            ("disks.count=63", "disks.count", "63", "even"),
            ("disks.count=64.0", "disks.count"),
            ("disks.count=sixty", "disks.count"),
            ("disks.count=", "disks.count"),
            ("disks.count=[", "disks.count"),
            ("disks.count", "disks.count"),
            ("disks=1", "disks"),
            ("=3",), ("",), (".=1",), ("disks..count=64",), ("disks.count=64 # x\n[output]",),
            ("title=\"a\"\n[disks]",),
        ):
            with self.subTest(text=text):
                self.refused(path, *words, arguments=("--set", text))

    def test_set_is_toml_and_a_bare_word_is_a_string(self):
        path, out = self.scene(), self.folder / "out"
        self.run_scene(path, out, "--set", "disks.model=CD_n", "--set", "disks.count=128",
                       "--set", "shear.strain=2e-2", "--set", 'disks.mass="area"',
                       "--set", "title=bare")
        scene = read_summary(out)["scene"]
        self.assertEqual(scene["disks"]["model"], "CD_n")
        self.assertEqual(scene["disks"]["mass"], "area")
        self.assertEqual(scene["disks"]["count"], 128)
        self.assertEqual(scene["title"], "bare")

    def test_set_can_give_a_required_key(self):
        path = self.scene(disks__model=None)
        result = self.bagnold("validate", path, "--set", "disks.model=CD")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_integers_are_numbers(self):
        path = self.scene(disks__elasticity=1, shear__strain=1, shear__discard=0,
                          output__checkpoint_minutes=10, output__trajectory_strain=0)
        result = self.bagnold("validate", path)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_bad_options(self):
        path, out = self.scene(), self.folder / "out"
        for arguments in (
            ("run", path, "--out", out, "--threads", "0"),
            ("run", path, "--out", out, "--threads", "-1"),
            ("run", path, "--out", out, "--threads", "two"),
            ("run", path, "--out", out, "--threads", "100000000"),
            ("run", path, "--out", out, "--backend", "vulkan"),
            ("run", path, "--out", out, "--thread", "2"),
            ("run", path, "--out", ""),
            ("run", "--out", out),
            ("run", path, path, "--out", out),
            ("simulate", path),
            ("validate",),
            ("validate", path, "--nonsense"),
            ("resume",),
            ("resume", self.folder / "nowhere"),
            ("resume", self.folder / "nowhere", "--threads", "0"),
        ):
            with self.subTest(arguments=arguments):
                self.assert_clean_error(self.bagnold(*arguments), 2)
                self.assertFalse(out.exists())

    def test_resume_of_a_folder_that_is_no_run(self):
        (self.folder / "empty").mkdir()
        self.assert_clean_error(self.bagnold("resume", self.folder / "empty"), 2)
        self.assertEqual(list((self.folder / "empty").glob("*.h5")), [])

    def test_backend_that_is_not_built(self):
        info = self.bagnold("info").stdout.lower()
        if "cuda" in info.split("backend")[-1]:
            self.skipTest("cuda may be built")
        result = self.bagnold("run", self.scene(), "--out", self.folder / "out",
                              "--backend", "cuda")
        self.assert_clean_error(result, 2, "cuda")
        self.assertFalse((self.folder / "out").exists())

    def test_a_refused_scene_leaves_a_forced_folder_alone(self):
        out = self.folder / "out"
        out.mkdir()
        (out / "summary.json").write_text("{}")
        result = self.bagnold("run", self.scene(disks__count=63), "--out", out, "--force")
        self.assert_clean_error(result, 2, "disks.count")
        self.assertEqual((out / "summary.json").read_text(), "{}")


if __name__ == "__main__":
    unittest.main()
