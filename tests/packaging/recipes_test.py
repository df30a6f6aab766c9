# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of packaging/ against the repository: what they copy, call and depend on is there, and is all.

BAGNOLD_SOURCE is the root of the repository.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import types
import unittest

import yaml

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PACKAGING = SOURCE / "packaging"
LIBRARIES = (SOURCE / "cmake/libraries.cmake").read_text()
VERSION = re.search(r"project\(Bagnold VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]

# What CMake looks for, as conda-forge and Spack call it.
NAMES = {
    "Kokkos": ("kokkos", "kokkos"),
    "Eigen3": ("eigen", "eigen"),
    "HDF5": ("hdf5", "hdf5"),
    "fmt": ("fmt", "fmt"),
    "xxHash": ("xxhash", "xxhash"),
    "tomlplusplus": ("tomlplusplus", "tomlplusplus"),
    "CLI11": ("cli11", "cli11"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json"),
    "Random123": (None, "random123"),  # conda-forge lacks it
}


def spack_package():
    """The directives of the Spack package, as lists of their arguments."""
    said = {}

    class CMakePackage:
        pass

    def directive(name):
        return lambda *words, **keys: said.setdefault(name, []).append((words, keys))

    spack = types.ModuleType("spack.package")
    for name in ("depends_on", "version", "variant", "license", "conflicts", "generator"):
        setattr(spack, name, directive(name))
    cmake = types.ModuleType("spack_repo.builtin.build_systems.cmake")
    cmake.CMakePackage = CMakePackage
    made = {"spack": types.ModuleType("spack"), "spack.package": spack, cmake.__name__: cmake}
    parts = cmake.__name__.split(".")
    made.update({".".join(parts[:n]): types.ModuleType(".".join(parts[:n])) for n in range(1, len(parts))})
    path = PACKAGING / "spack/spack_repo/bagnold/packages/bagnold/package.py"
    before = dict(sys.modules)
    sys.modules.update(made)
    try:
        scope = {"__file__": str(path)}
        exec(compile(path.read_text(), str(path), "exec"), scope)
    finally:
        for name in made:
            sys.modules.pop(name, None)
        sys.modules.update(before)
    return scope["Bagnold"], said


class Recipes(unittest.TestCase):
    def test_the_names_are_all_that_cmake_looks_for(self):
        found = set(re.findall(r"find_package\((\w+) REQUIRED", LIBRARIES))
        found |= set(re.findall(r"^bagnold_library\((\w+)", LIBRARIES, re.M))
        found |= {{"XXHASH_LIBRARY": "xxHash", "RANDOM123_INCLUDE_DIR": "Random123"}[name]
                  for name in re.findall(r"find_(?:path|library)\((\w+)", LIBRARIES) if name != "XXHASH_INCLUDE_DIR"}
        self.assertEqual(found | {"Kokkos"}, set(NAMES))

    def test_conda_has_every_library_and_the_version(self):
        recipe = yaml.safe_load((PACKAGING / "conda/recipe.yaml").read_text())
        self.assertEqual(recipe["context"]["version"], VERSION)
        host = {word.split()[0] for word in recipe["requirements"]["host"]}
        self.assertEqual(host, {conda for conda, _ in NAMES.values() if conda})
        upstream = recipe["source"][1]
        self.assertIn(upstream["url"], LIBRARIES)
        self.assertIn(upstream["sha256"], LIBRARIES)
        self.assertTrue((PACKAGING / "conda" / recipe["source"][0]["path"] / "CMakeLists.txt").exists())
        self.assertTrue((SOURCE / recipe["about"]["license_file"]).exists())

    def test_spack_has_every_library_and_this_checkout(self):
        package, said = spack_package()
        needed = {words[0].split("@")[0].split()[0] for words, keys in said["depends_on"]
                  if keys.get("type") is None}
        self.assertEqual(needed, {spack for _, spack in NAMES.values()})
        self.assertEqual(package.git, SOURCE.resolve().as_uri())
        variants = {words[0] for words, _ in said["variant"]}
        self.assertEqual(variants, {"native", "python", "tests"})
        options = (SOURCE / "CMakeLists.txt").read_text()
        text = (PACKAGING / "spack/spack_repo/bagnold/packages/bagnold/package.py").read_text()
        for name in re.findall(r'"(BAGNOLD_(?!PYTHON)\w+)"', text):
            self.assertIn(name, options)

    def test_options_of_cmake_are_there(self):
        known = "".join(path.read_text() for path in [SOURCE / "CMakeLists.txt", *(SOURCE / "cmake").glob("*.cmake")])
        for path in (PACKAGING / "conda/recipe.yaml", PACKAGING / "README.md", SOURCE / "scripts/package"):
            for name in re.findall(r"-D(BAGNOLD_\w+|RANDOM123_\w+)", path.read_text()):
                self.assertIn(name, known, path)

    def test_containers_call_what_is_there(self):
        docker = (PACKAGING / "container/Dockerfile").read_text()
        apptainer = (PACKAGING / "container/bagnold.def").read_text()
        self.assertEqual(set(re.findall(r"^FROM (\S+)", docker, re.M)), {"debian:12"})
        self.assertEqual(re.findall(r"^From: (\S+)", apptainer, re.M), ["debian:12"] * 2)
        for text in (docker, apptainer):
            for path in re.findall(r"/bagnold/(scripts/\S+)", text):
                self.assertTrue(os.access(SOURCE / path, os.X_OK), path)
            self.assertIn("scripts/package", text)
            self.assertIn("build/package/bagnold_*.deb", text)  # CPack's name, as install.package finds it
        sections = set(re.findall(r"^%(\w+)", apptainer, re.M))
        self.assertEqual(sections, {"files", "post", "environment", "runscript", "test", "help"})
        shell = "\n".join(re.findall(r"^%(?:post|runscript|test|environment)\n((?:  .*\n|\n)+)", apptainer, re.M))
        subprocess.run(["sh", "-n"], input=shell, text=True, check=True)
        for line in docker.replace("\\\n", " ").splitlines():
            word, _, rest = line.partition(" ")
            self.assertIn(word, {"", "#", "FROM", "RUN", "COPY", "ENV", "WORKDIR", "ENTRYPOINT", "CMD"})
            if word == "RUN":
                self.assertTrue(shlex.split(rest))
                subprocess.run(["sh", "-n"], input=rest, text=True, check=True)

    def test_what_a_package_needs_is_what_the_scripts_install(self):
        """Pictures need the same packages of Python everywhere."""
        packages = (SOURCE / "scripts/lib/packages.sh").read_text()
        pictures = re.search(r"picture_packages=\((.*?)\)", packages)[1].split()
        for path in ("packaging/container/Dockerfile", "packaging/container/bagnold.def", "cmake/package.cmake"):
            for name in pictures:
                self.assertRegex((SOURCE / path).read_text(), rf"\b{name}\b", path)

    def test_what_is_downloaded_is_upstream(self):
        for path in PACKAGING.rglob("*"):
            if path.is_file():
                hosts = set(re.findall(r"https?://([\w.-]+)", path.read_text()))
                self.assertLessEqual(hosts, {"github.com", "doi.org"}, path)


if __name__ == "__main__":
    unittest.main()
