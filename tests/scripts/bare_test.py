# SPDX-License-Identifier: BSD-3-Clause
"""README's two commands, and where they are followed: scripts/check-bare, .ci/run, and what scripts ask for.

In a copy of the scripts beside programs that stand for the system's: they write down how they were called.
BAGNOLD_SOURCE is the root of the repository.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
SYSTEM = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
UNAVAILABLE = 77
RELEASE = pathlib.Path("/etc/os-release")
IS_DEBIAN_12 = RELEASE.exists() and {"ID=debian", 'VERSION_ID="12"'} <= set(RELEASE.read_text().splitlines())
on_debian_12 = unittest.skipUnless(IS_DEBIAN_12, "elsewhere the scripts install nothing")


def array(name):
    """Words of an array of scripts/lib/packages.sh."""
    told = subprocess.run(["bash", "-euc", f'. scripts/lib/packages.sh; echo "${{{name}[@]}}"'], cwd=SOURCE,
                          capture_output=True, text=True, check=True)
    return told.stdout.split()


class Scripts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.tree, self.bin, self.log = (self.folder / name for name in ("tree", "bin", "log"))
        self.tree.mkdir()
        self.bin.mkdir()
        for name in ("scripts", ".ci"):
            shutil.copytree(SOURCE / name, self.tree / name)
        shutil.copy(SOURCE / "README.md", self.tree)

    def program(self, path, text):
        path.write_text(f"#!/bin/bash\necho \"{path.name} $*\" >>'{self.log}'\n{text}\n")
        path.chmod(0o755)

    def call(self, *words, **variables):
        env = {"PATH": f"{self.bin}:{SYSTEM}", "HOME": str(self.folder), "BAGNOLD_CACHE": str(self.folder / "cache")}
        return subprocess.run(["bash", *words], cwd=self.tree, env=env | variables, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=100)

    def calls(self):
        return self.log.read_text().splitlines() if self.log.exists() else []


class Continuous(Scripts):
    """.ci/run: the bare system's word counts; without one it is the check's."""

    def ends(self, bare, check):
        self.log.unlink(missing_ok=True)
        self.program(self.tree / "scripts/check-bare", f"exit {bare}")
        self.program(self.tree / "scripts/check", f"exit {check}")
        return self.call(".ci/run", CI="true").returncode, [line.split()[0] for line in self.calls()]

    def test_status(self):
        self.assertEqual(self.ends(bare=0, check=1), (0, ["check-bare"]))
        self.assertEqual(self.ends(bare=8, check=0), (8, ["check-bare"]))
        self.assertEqual(self.ends(bare=UNAVAILABLE, check=0), (0, ["check-bare", "check"]))
        self.assertEqual(self.ends(bare=UNAVAILABLE, check=8), (8, ["check-bare", "check"]))


@on_debian_12
class Bare(Scripts):
    def refused(self, why):
        said = self.call("scripts/check-bare")
        self.assertEqual(said.returncode, UNAVAILABLE, said.stderr)
        self.assertRegex(said.stderr, why)

    def test_without_root(self):
        self.program(self.bin / "id", "echo 1000")
        self.refused("needs root on Debian 12")

    def test_without_mounts(self):
        self.program(self.bin / "id", "echo 0")
        self.program(self.bin / "unshare", "echo 'unshare: Operation not permitted' >&2; exit 1")
        self.refused("mounts are refused: unshare: Operation not permitted")

    def test_without_debootstrap(self):
        """apt has none, or it fails: refused in words, and no half of a base is kept."""
        self.program(self.bin / "id", "echo 0")
        self.program(self.bin / "unshare", "case $* in *debootstrap*) echo 'no such release' >&2; exit 1;; esac")
        self.program(self.bin / "dpkg-query", "echo missing")
        self.program(self.bin / "apt-get", "case $* in *indextargets*) echo 'deb http://a.b/c bookworm main';; esac")
        self.refused("(?s)no such release.*debootstrap failed")
        self.assertTrue(any(line.startswith("apt-get") and "debootstrap" in line for line in self.calls()))
        self.assertEqual(list((self.folder / "cache").iterdir()), [])
        self.program(self.bin / "apt-get", "case $* in *install*) exit 100;; esac")
        self.refused("debootstrap cannot be installed")

    def test_a_bare_system(self):
        """The real one, where its base is kept: what is in it, and that the last command's status is that of all."""
        cache = pathlib.Path(os.environ.get("BAGNOLD_CACHE", pathlib.Path.home() / ".cache/bagnold"))
        if not list(cache.glob("debian-12-*.tar")):
            self.skipTest("no scripts/check-bare was run here")
        shows = "test ! -e /usr/bin/python3 && test -x scripts/quickstart && test ! -e build && pwd"
        said = self.call("scripts/check-bare", shows, "exit 5", "echo unreached", BAGNOLD_CACHE=str(cache))
        if said.returncode == UNAVAILABLE:
            self.skipTest(said.stderr)
        self.assertEqual(said.returncode, 5, said.stderr)
        self.assertIn("\n/root/bagnold\n", said.stdout)
        self.assertNotIn("\nunreached\n", said.stdout)
        self.assertIn("exit 5: exit status 5", said.stderr)


class Readme(Scripts):
    def test_two_commands(self):
        """One sets up and runs, one sets up and tests; and no other script stands there as a command."""
        shown = re.findall(r"^    (scripts/\S+)", (SOURCE / "README.md").read_text(), re.M)
        self.assertEqual(shown, ["scripts/quickstart", "scripts/check"])

    @on_debian_12
    def test_they_are_what_is_followed(self):
        """In a base of empty folders, by an unshare that enters nothing."""
        base, cache = self.folder / "base", self.folder / "cache"
        for name in ("etc/apt/apt.conf.d", "etc/dpkg/dpkg.cfg.d", "usr/sbin"):
            (base / name).mkdir(parents=True)
        cache.mkdir()
        machine = subprocess.run(["dpkg", "--print-architecture"], capture_output=True, text=True, check=True).stdout
        subprocess.run(["tar", "-C", base, "-cf", cache / f"debian-12-{machine.strip()}.tar", "."], check=True)
        self.program(self.bin / "id", "echo 0")
        self.program(self.bin / "unshare", "")
        said = self.call("scripts/check-bare")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertEqual(re.findall(r"== In a bare Debian 12: (.*)", said.stdout), ["scripts/quickstart", "scripts/check"])


@on_debian_12
class Packages(Scripts):
    def installed(self, script, *words):
        """What a script asks apt for where nothing is there."""
        self.log.unlink(missing_ok=True)
        self.program(self.bin / "dpkg-query", "echo missing")
        self.program(self.bin / "id", "echo 0")
        self.program(self.bin / "apt-get", "case $* in *install*) exit 100;; esac")
        self.call(f"scripts/{script}", *words)
        (line,) = [line for line in self.calls() if " install " in line]
        return line.split()

    def test_what_makes_packages(self):
        """cpack wants `file`, and dpkg-shlibdeps of dpkg-dev; a test makes packages."""
        for script in ("check", "package"):
            for name in ("file", "dpkg-dev", "help2man"):
                self.assertIn(name, self.installed(script), script)

    def test_modules_of_tests(self):
        """Each module without which a test is left out is of a package that is installed for the tests. But for
        OVITO and signac, of which there is none, VTK, which is a hundred more, and MDAnalysis, which is too old."""
        packages = {"ase": "python3-ase", "gsd": "python3-gsd", "mypy": "mypy", "nbclient": "python3-nbclient",
                    "nbformat": "python3-nbclient", "ipykernel": "python3-ipykernel", "pandas": "python3-pandas",
                    "xarray": "python3-xarray", "h5netcdf": "python3-h5netcdf",
                    "jsonschema": "python3-jsonschema"}
        text = "".join(path.read_text() for path in (SOURCE / "tests").rglob("*_test.py"))
        named = set(re.findall(r'(?:find_spec|needs|other_program)\("(\w+)"', text))
        self.assertIn("gsd", named)
        for module in named - {"ovito", "signac", "vtk", "MDAnalysis"}:
            self.assertIn(packages[module], array("test_packages"))


@on_debian_12
class Attack(Scripts):
    def test_the_fuzzers_are_built_by_ninja(self):
        """There is no make in a bare system."""
        (self.tree / "tests/attacks/campaign").mkdir(parents=True)
        (self.tree / "tests/attacks/campaign/campaign.py").write_text("")
        self.program(self.bin / "dpkg-query", "echo installed")
        self.program(self.bin / "cmake", "case $* in --version) echo 'cmake version 3.25.1';; esac")
        self.program(self.bin / "clang++", "")
        self.program(self.bin / "ninja", "")
        said = self.call("scripts/attack", "scene_files")
        self.assertEqual(said.returncode, 0, said.stderr)
        (made,) = [line for line in self.calls() if "-S" in line and "attacks/fuzz" in line]
        self.assertIn("-G Ninja", made)
        self.assertIn("clang", array("fuzz_packages"))


if __name__ == "__main__":
    unittest.main()
