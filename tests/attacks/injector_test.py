# SPDX-License-Identifier: BSD-3-Clause
"""The fault injector does what it says: else the attacks that use it would prove nothing."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from injector import counted, injected, logged

WRITER = """
import os, sys
file = os.open(sys.argv[1], os.O_CREAT | os.O_WRONLY)
for _ in range(4):
    try:
        print(os.write(file, b"1234"))
    except OSError as error:
        print(error.strerror)
os.fsync(file)
os.close(file)
os.rename(sys.argv[1], sys.argv[1] + ".new")
"""


class Injector(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="bagnold-")
        self.addCleanup(holder.cleanup)
        self.folder, self.log = pathlib.Path(holder.name) / "out", pathlib.Path(holder.name) / "log"
        self.folder.mkdir()

    def write(self, **fault):
        result = subprocess.run([sys.executable, "-c", WRITER, self.folder / "a"], text=True,
                                capture_output=True, env=os.environ | injected(
                                    self.folder, self.log, **fault))
        return result.returncode, result.stdout.split("\n")[:-1]

    def content(self):
        return (self.folder / "a.new").read_text()

    def test_without_a_fault_calls_are_logged(self):
        self.assertEqual(self.write(), (0, ["4"] * 4))
        self.assertEqual(counted(self.log), {"open": 1, "write": 4, "fsync": 1, "close": 1, "rename": 1})
        self.assertIn(("write", 3, str(self.folder / "a")), logged(self.log))

    def test_one_write(self):
        self.assertEqual(self.write(call="write", at=2), (0, ["4", "Input/output error", "4", "4"]))
        self.assertEqual(self.content(), "1234" * 3)

    def test_a_disk_that_flickers(self):
        full = "No space left on device"
        self.assertEqual(self.write(call="write", at=2, times=2, error="ENOSPC"),
                         (0, ["4", full, full, "4"]))

    def test_for_good(self):
        self.assertEqual(self.write(call="write", at=3, times="always", error="EDQUOT"),
                         (0, ["4", "4"] + ["Disk quota exceeded"] * 2))

    def test_half_and_lost(self):
        self.assertEqual(self.write(call="write", at=4, error="HALF"), (0, ["4", "4", "4", "2"]))
        self.assertEqual(self.content(), "1234" * 3 + "12")
        self.write(call="write", at=1, error="LOST")
        self.assertEqual(self.content(), "1234" * 3)

    def test_killed(self):
        self.assertEqual(self.write(call="fsync", at=1, error="KILL")[0], -9)
        self.assertEqual((self.folder / "a").read_text(), "1234" * 4)

    def test_the_other_calls(self):
        for call in ("open", "fsync", "close", "rename"):
            self.assertEqual(self.write(call=call, at=1)[0], 1, call)

    def test_other_folders_are_left_alone(self):
        self.folder = self.folder.parent
        variables = injected(self.folder / "out", self.log, call="write", at=1)
        subprocess.run([sys.executable, "-c", WRITER, self.folder / "a"], check=True,
                       capture_output=True, env=os.environ | variables)
        self.assertEqual((self.content(), logged(self.log)), ("1234" * 4, []))


if __name__ == "__main__":
    unittest.main()
