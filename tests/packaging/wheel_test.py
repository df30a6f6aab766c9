# SPDX-License-Identifier: BSD-3-Clause
"""What pip installs. Metadata: the two packages say the same, the source distribution has all that the build reads.
Wheel (slow): scripts/wheel makes one, or BAGNOLD_WHEEL names one; it is installed into a bare virtual environment,
with libraries from where pip finds them, and runs there. scripts/aarch64 wheel does so under qemu-user.

BAGNOLD_SOURCE is the root of the repository.
"""

import os
import pathlib
import platform
import re
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import unittest
import zipfile

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PROJECT = tomllib.loads((SOURCE / "pyproject.toml").read_text())
LARGEST = 25e6  # bytes


class Metadata(unittest.TestCase):
    def test_both_packages_say_the_same(self):
        alone = tomllib.loads((SOURCE / "python/pyproject.toml").read_text())["project"]
        for key in ("name", "version", "requires-python", "license", "dependencies", "optional-dependencies"):
            self.assertEqual(PROJECT["project"][key], alone[key], key)
        version = re.search(r"project\(Bagnold VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        self.assertEqual(PROJECT["project"]["version"], version)

    def test_what_cmake_reads_goes_along(self):
        """Folders that scripts/lib/wheel.sh copies and the source distribution does not leave out."""
        script = (SOURCE / "scripts/lib/wheel.sh").read_text()
        copied = re.search(r"git ls-files -z -- (.*?)\)", script.replace("\\\n", ""), re.S)[1].split()
        for path in copied:
            self.assertTrue((SOURCE / path).exists(), path)
        left_out = set(PROJECT["tool"]["scikit-build"]["sdist"]["exclude"])
        self.assertFalse({path.split("/")[0] for path in copied} & left_out)
        texts = [SOURCE / "CMakeLists.txt", *(SOURCE / "cmake" / f"{name}.cmake" for name in ("wheel", "shell", "third_party")),
                 SOURCE / "src/CMakeLists.txt"]
        for text in texts:
            for path in re.findall(r"\$\{PROJECT_SOURCE_DIR\}/([\w./-]+)", text.read_text()):
                if path not in ("third_party", "README.md") and (SOURCE / path).exists():
                    self.assertTrue(any(path == one or path.startswith(one + "/") for one in copied), f"{text}: {path}")
        for option in PROJECT["tool"]["scikit-build"]["cmake"]["define"]:
            self.assertIn(option, texts[0].read_text())

    def test_the_scripts_are_shell(self):
        for path in ("scripts/wheel", "scripts/lib/wheel.sh", "scripts/aarch64", "scripts/lib/aarch64.sh"):
            subprocess.run(["bash", "-n", SOURCE / path], check=True)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if "BAGNOLD_WHEEL" in os.environ:
            cls.wheel = pathlib.Path(os.environ["BAGNOLD_WHEEL"]).resolve()
        else:
            subprocess.run([SOURCE / "scripts/wheel"], check=True)
            cls.wheel, = (SOURCE / "build/wheel").glob(f"*_{platform.machine()}.whl")
        place = tempfile.TemporaryDirectory(prefix="bagnold-wheel-")
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.bin = cls.folder / "environment/bin"
        subprocess.run(["/usr/bin/python3", "-m", "venv", cls.bin.parent], check=True)
        subprocess.run([cls.bin / "pip", "install", "--quiet", f"{cls.wheel}[plots,tables]"], check=True)

    def call(self, name, *words):
        """From a folder of nobody's, with nothing of this process' environment."""
        done = subprocess.run([self.bin / name, *map(str, words)], cwd=self.folder, capture_output=True, text=True,
                              env={"PATH": "/usr/bin:/bin", "HOME": str(self.folder)}, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_it_is_for_many_systems_and_small(self):
        self.assertRegex(self.wheel.name, r"^bagnold-[\d.]+-py3-none-manylinux_2_\d\d_(x86_64|aarch64)\.whl$")
        self.assertLess(self.wheel.stat().st_size, LARGEST)
        with zipfile.ZipFile(self.wheel) as file:
            self.assertFalse([name for name in file.namelist() if name.endswith(".so") or ".libs/" in name])

    def test_the_program_needs_the_c_library_alone(self):
        said = subprocess.run(["objdump", "-p", self.bin / "bagnold"], capture_output=True, text=True, check=True).stdout
        needed = set(re.findall(r"NEEDED +(\S+)", said))
        self.assertLessEqual({name.split(".so")[0] for name in needed}, {"libc", "libm", "libpthread", "libdl", "ld-linux-x86-64", "ld-linux-aarch64"})

    def test_a_run_with_its_picture(self):
        scene = self.bin.parent / "share/bagnold/quickstart.toml"
        self.call("bagnold", "run", scene, "--set", "shear.strain=0.5", "--set", "disks.count=64", "--out", "run", "--threads", "2")
        for name in ("summary.json", "plot.png", "result.h5"):
            self.assertTrue((self.folder / "run" / name).exists(), name)
        self.call("bagnold", "report", "run")
        self.assertIn("<svg", (self.folder / "run/report.html").read_text())
        self.assertIn("P1-1", self.call("bagnold", "figure"))
        information = self.call("bagnold", "info")
        self.assertIn("openmp", information)
        self.assertNotIn("unknown", information)

    def test_the_package_finds_its_program(self):
        said = self.call("python", "-c", "import bagnold; print(bagnold.find_program()); print(bagnold.__file__)").splitlines()
        self.assertEqual(said[0], str(self.bin / "bagnold"))
        self.assertTrue(said[1].startswith(str(self.bin.parent)))
        self.call("python", "-c", """import bagnold
scene = {"disks": {"model": "CD", "count": 64, "packing_fraction": 0.8, "elasticity": 1, "mass": "equal"},
         "shear": {"strain_rate": 1e-2, "strain": 1}, "output": {"plot": False}}
r = bagnold.run(scene, out="mine", progress=False)
assert r.to_pandas()["Z"].mean() > 0 and r.to_xarray()["p"].size""")

    def test_the_source_distribution(self):
        """Beside a wheel that scripts/wheel made: it has the libraries and their licences, and no tests."""
        files = list(self.wheel.parent.glob("bagnold-*.tar.gz"))
        if not files:
            self.skipTest("no source distribution beside the wheel")
        with tarfile.open(files[0]) as archive:
            names = {name.partition("/")[2] for name in archive.getnames()}
        for path in ("CMakeLists.txt", "src/cli/main.cpp", "python/bagnold/__init__.py", "third_party/kokkos/CMakeLists.txt",
                     "third_party/kokkos/LICENSE", "third_party/hdf5/COPYING", "third_party/fmt/LICENSE.rst",
                     "third_party/licences/libeigen3-dev", "third_party/git_hash"):
            self.assertIn(path, names)
        self.assertFalse([name for name in names if name.startswith(("tests/", "docs/"))])


if __name__ == "__main__":
    sys.exit(unittest.main())
