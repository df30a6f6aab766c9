# SPDX-License-Identifier: BSD-3-Clause
"""Every script tells what it is for by --help, and does nothing else."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))


class Help(unittest.TestCase):
    def test_usage(self):
        scripts = [path for path in sorted((SOURCE / "scripts").iterdir()) if path.is_file() and os.access(path, os.X_OK)]
        self.assertGreater(len(scripts), 10)
        for script in scripts:
            with self.subTest(script=script.name), tempfile.TemporaryDirectory() as folder:
                by = [sys.executable] if "python" in script.read_text().split("\n", 1)[0] else []  # which has the packages
                done = subprocess.run([*by, script, "--help"], capture_output=True, text=True, cwd=folder, timeout=60)
                if "No module named 'PIL'" in done.stderr:
                    self.skipTest("needs pillow")
                self.assertEqual((done.returncode, os.listdir(folder)), (0, []), done.stderr)
                self.assertIn("usage", done.stdout.lower())


if __name__ == "__main__":
    unittest.main()
