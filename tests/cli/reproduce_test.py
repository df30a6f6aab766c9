# SPDX-License-Identifier: BSD-3-Clause
"""scripts/reproduce leaves out what is kept in tables."""

import importlib.machinery
import importlib.util
import pathlib
import tempfile
import time
import tomllib
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/reproduce"
SWEEP = """title = "tiny"
[disks]
count = 32
[shear]
strain_rates = [1e-3, 1e-4]
[sweep]
grid = { "disks.seed" = [1, 2], "disks.elasticity" = [0.1, 10] }
zip = { "disks.packing_fraction" = [0.6, 0.7], "shear.strain" = [1, 2] }
"""
CHAIN = """title = "tiny"
[sweep]
chain = "shear.strain_rate"
zip = { "shear.strain_rate" = [1e-5, 1e-4], "start.kind" = ["random", "state"] }
grid = { "disks.packing_fraction" = [0.6, 0.7] }
"""


def loaded():
    loader = importlib.machinery.SourceFileLoader("reproduce", str(SCRIPT))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("reproduce", loader))
    loader.exec_module(module)
    return module


class Rest(unittest.TestCase):
    def setUp(self):
        self.reproduce = loaded()
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.file = self.folder / "tiny.toml"
        self.file.write_text(SWEEP)
        self.all = self.reproduce.combinations(tomllib.loads(SWEEP)["sweep"])

    def table(self, without):
        """All rates of all combinations but those of `without`, (combination, rate)."""
        return [{"disks.count": "32", "disks.seed": str(one["disks.seed"]),
                 "disks.elasticity": f"{one['disks.elasticity']:g}",
                 "disks.packing_fraction": f"{one['disks.packing_fraction']:g}",
                 "shear.strain_rate": f"{rate:g}", "p": "1", "p_error": ""}
                for one in self.all for rate in (1e-3, 1e-4) if (one, rate) not in without]

    def rest(self, table):
        target = self.folder / "rest/tiny.toml"
        if not self.reproduce.write_rest(self.file, table, target):
            return None
        found = tomllib.loads(target.read_text())
        self.assertEqual(found["shear"], {"strain_rates": [1e-3, 1e-4]})
        return self.reproduce.combinations(found["sweep"])

    def test_all_combinations_are_asked_for(self):
        self.assertEqual(len(self.all), 8)
        self.assertIn({"disks.seed": 2, "disks.elasticity": 10, "disks.packing_fraction": 0.7, "shear.strain": 2},
                      self.all)

    def test_what_is_not_kept_is_left(self):
        self.assertIsNone(self.rest([]))
        gone = [(self.all[2], 1e-4), (self.all[5], 1e-3)]
        self.assertEqual(self.rest(self.table(gone)), [self.all[2], self.all[5]])
        self.assertEqual(self.rest(self.table([])), [])

    def test_first_seeds_alone(self):
        target = self.folder / "rest.toml"
        self.assertTrue(self.reproduce.write_rest(self.file, self.table([(self.all[0], 1e-3)]), target, seeds=1))
        found = self.reproduce.combinations(tomllib.loads(target.read_text())["sweep"])
        self.assertEqual(found, [self.all[0]])
        self.reproduce.write_rest(self.file, [], target, seeds=1)
        found = self.reproduce.combinations(tomllib.loads(target.read_text())["sweep"])
        self.assertEqual([one["disks.seed"] for one in found], [1] * 4)

    def test_another_size_is_not_kept(self):
        table = [row | {"disks.count": "64"} for row in self.table([])]
        self.assertIsNone(self.rest(table))

    def test_a_chain_is_left_whole(self):
        self.file.write_text(CHAIN)
        asked = self.reproduce.combinations(tomllib.loads(CHAIN)["sweep"])
        table = [{key: str(one[key]) for key in ("disks.packing_fraction", "shear.strain_rate")} for one in asked]
        target = self.folder / "rest.toml"
        self.assertTrue(self.reproduce.write_rest(self.file, table[:1] + table[2:], target))
        left = tomllib.loads(target.read_text())["sweep"]
        self.assertEqual(left["chain"], "shear.strain_rate")
        self.assertEqual(self.reproduce.combinations(left), asked[:2])
        self.reproduce.write_rest(self.file, table, target)
        self.assertEqual(self.reproduce.combinations(tomllib.loads(target.read_text())["sweep"]), [])

    def test_what_is_left_follows_the_tables_until_it_is_begun(self):
        tables = iter([self.table([(self.all[2], 1e-4)]), self.table([]), [], self.table([])])
        self.reproduce.table_of = lambda name: next(tables)
        folder = self.folder / "data/tiny"
        self.assertEqual(self.reproduce.Sweep(self.file, folder).line(), f"{'tiny':20}     1 of     8 cascades or runs not begun")
        self.assertEqual(self.reproduce.Sweep(self.file, folder).line(), f"{'tiny':20} kept")
        self.assertEqual(self.reproduce.Sweep(self.file, folder).file, self.file)
        folder.mkdir(parents=True)
        self.assertEqual(self.reproduce.Sweep(self.file, folder).file, self.file)

    def test_what_is_done_and_when_the_rest_will_be(self):
        folder = self.folder / "data/tiny"
        self.reproduce.table_of = lambda name: []
        for k in range(4):
            (folder / f"points/{k}").mkdir(parents=True)
        sweep = self.reproduce.Sweep(self.file, folder)
        self.assertEqual(sweep.line(), f"{'tiny':20}     0 of     4 points,   0.00 hours")
        (folder / "points/2/summary.json").write_text('{"wall_seconds": 3600}')
        self.assertRegex(sweep.line(), r"    1 of     4 points,   1\.00 hours,   3\.00 left: until \w+ \d\d:\d\d$")
        for k in (0, 1, 3):
            (folder / f"points/{k}/summary.json").write_text('{"wall_seconds": 3600}')
        self.assertEqual(sweep.line(), f"{'tiny':20}     4 of     4 points,   4.00 hours")

    def test_stopped_it_goes_on_where_it_was(self):
        """A program that writes a point, and waits where it is the first call."""
        program = self.folder / "bagnold"
        program.write_text("""#!/bin/sh
mkdir -p "$4/points/$(ls "$4/points" 2>/dev/null | wc -l)"
nice >> "$4/nice"
[ -e "$4/points/1" ] || exec sleep 60
""")
        program.chmod(0o755)
        sweep = self.reproduce.Sweep(self.file, self.folder / "data/tiny")
        began = time.monotonic()
        self.assertNotEqual(self.reproduce.run(sweep, str(program), None, began + 4), 0)
        self.assertLess(time.monotonic() - began, 30)
        self.assertEqual(self.reproduce.run(sweep, str(program), None, None), 0)
        self.assertEqual(len(sweep.points()), 2)
        self.assertEqual((sweep.folder / "nice").read_text(), "19\n19\n")


if __name__ == "__main__":
    unittest.main()
