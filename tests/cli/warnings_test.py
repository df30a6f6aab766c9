# SPDX-License-Identifier: BSD-3-Clause
"""What a finished run warns of: in summary.json, on the terminal, in the tables of a sweep."""

import json
import unittest

import h5py

from bagnold import SCENE, changed, read_summary
from sweeps import SweepTest, rows, sweep_text

JAMMED = {"disks__packing_fraction": 0.86, "disks__model": "CD"}


def names(summary, what="warnings"):
    return [warning["name"] for warning in summary[what]]


class Mechanism(SweepTest):
    def jammed(self, name, **changes):
        path = self.scene(**{**JAMMED, **changes})
        out = self.folder / name
        result = self.bagnold("run", path, "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        return read_summary(out), result.stderr

    def test_a_note_has_numbers_a_reason_and_a_remedy(self):
        """What no number is wrong by: above jamming B and eta have no limit."""
        summary, said = self.jammed("one")
        self.assertNotIn("above_jamming", names(summary))
        note = summary["notes"][0]
        self.assertEqual(set(note), {"name", "numbers", "reason", "remedy"})
        self.assertEqual(note["name"], "above_jamming")
        self.assertEqual(note["numbers"], {"packing_fraction": 0.86, "jamming_fraction": 0.84335})
        self.assertIn("0.86", note["reason"])
        self.assertTrue(note["remedy"])
        self.assertIn(f"note: above_jamming: {note['reason']}; {note['remedy']}\n", said)

    def test_a_warning_has_a_command(self):
        """Which, typed with the run's folder, does what it says."""
        summary, said = self.jammed("one")
        warning = summary["warnings"][0]
        self.assertEqual(set(warning), {"name", "numbers", "reason", "remedy", "command"})
        self.assertEqual(warning["name"], "error_bar")
        command = warning["command"].replace("DIR", str(self.folder / "one"))
        self.assertIn(f"warning: error_bar: {warning['reason']}; {warning['remedy']}: `{command}`\n",
                      said)
        words = command.split()
        self.assertEqual(words[:2] + words[3:4], ["bagnold", "resume", "--strain"])
        result = self.bagnold(*words[1:], "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        after = read_summary(self.folder / "one")
        self.assertEqual(after["scene"]["shear"]["strain"], float(words[4]))
        self.assertGreater(float(words[4]), summary["scene"]["shear"]["strain"])

    def test_every_warning_is_one_line_on_the_terminal(self):
        for changes in ({}, {"disks__replicas": 2}):
            summary, said = self.jammed(f"lines{len(changes)}", **changes)
            for what in ("warning", "note"):
                lines = [line for line in said.splitlines() if line.startswith(f"bagnold: {what}: ")]
                self.assertEqual([line.split(": ")[2] for line in lines], names(summary, what + "s"))

    def test_quiet_leaves_them_to_the_files(self):
        path = self.scene(**JAMMED)
        out = self.folder / "quiet"
        result = self.bagnold("run", path, "--out", out, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertIn("above_jamming", names(read_summary(out), "notes"))

    def test_cascades_have_them_for_each_rate(self):
        summary, said = self.jammed("cascade", shear__protocol="cascade", shear__strain_rate=None,
                                    shear__strain_rates=[2.0**-6, 2.0**-7])
        self.assertEqual(len(summary["points"]), 2)
        for point in summary["points"]:
            self.assertIn("above_jamming", names(point, "notes"))
            own = read_summary(self.folder / "cascade" / point["folder"])
            self.assertEqual(point["warnings"], own["warnings"])
            self.assertEqual(point["notes"], own["notes"])
        self.assertEqual(said.count("note: above_jamming"), 2)
        self.assertIn(f"resume {self.folder / 'cascade'} --strain", said)  # of the last rate
        self.assertNotIn(f"resume {self.folder / 'cascade'}/0", said)

    def test_ramps_have_them(self):
        summary, _ = self.jammed("ramp", shear__protocol="ramp", shear__strain_rate=2.0**-8,
                                 shear__strain_rate_high=2.0**-6, shear__ramp_rate=2.0**-8,
                                 shear__discard=None, shear__ramp_window=8.0, shear__strain=2.0**-5,
                                 output__sample_strain=None)
        self.assertEqual(names(summary, "notes"), ["above_jamming"])

    def test_sweeps_name_them_and_keep_their_columns(self):
        path = self.folder / "sweep.toml"
        path.write_text(sweep_text(changed(SCENE, disks__model="CD"),
                                   grid={"disks.packing_fraction": [0.7, 0.86]}))
        out = self.folder / "sweep"
        result = self.bagnold("sweep", path, "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r"note: \d of 2 points have notes: .*above_jamming \(1\)")
        with h5py.File(out / "sweep.h5") as file:
            listed, warned = ([text.split() for text in file[what].asstr()[:]]
                              for what in ("notes", "warnings"))
        folders = sorted((out / "points").iterdir())
        self.assertEqual(listed, [names(read_summary(folder), "notes") for folder in folders])
        self.assertEqual(warned, [names(read_summary(folder)) for folder in folders])
        self.assertIn("above_jamming", listed[1])
        self.assertNotIn("above_jamming", listed[0])
        self.assertEqual([row["notes"].split() for row in rows(out)], listed)

    def test_cascade_stages_without_the_key_are_taken(self):
        """Stages of a folder that an older version began."""
        summary, _ = self.jammed("old", shear__protocol="cascade", shear__strain_rate=None,
                                 shear__strain_rates=[2.0**-6, 2.0**-7])
        out = self.folder / "old"
        for point in summary["points"]:
            file = out / point["folder"] / "summary.json"
            old = json.loads(file.read_text())
            del old["warnings"]
            file.write_text(json.dumps(old))
        (out / "summary.json").unlink()
        self.assertEqual(self.bagnold("resume", out, "--quiet").returncode, 0)
        self.assertEqual([point["warnings"] for point in read_summary(out)["points"]], [[], []])


if __name__ == "__main__":
    unittest.main()
