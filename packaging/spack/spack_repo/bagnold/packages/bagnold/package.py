# SPDX-License-Identifier: BSD-3-Clause
"""Bagnold, from the checkout in which this file lies (Spack 1.0 or newer)."""

import pathlib

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Bagnold(CMakePackage):
    """A simulator of dense granular flow at vanishing shear rate: soft, frictionless, bidisperse disks in two
    dimensions under Lees-Edwards shear."""

    homepage = "https://doi.org/10.1103/PhysRevE.95.012902"
    git = pathlib.Path(__file__).resolve().parents[6].as_uri()

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("native", default=False, description="All instructions of the machine that builds; else chosen at start")
    variant("python", default=True, description="Python that draws the pictures")
    variant("tests", default=False, description="Build the tests")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("help2man", type="build")

    depends_on("kokkos@3.4:5 +serial+openmp cxxstd=20")
    depends_on("eigen@3.4:")
    depends_on("hdf5@1.10: ~mpi")
    depends_on("fmt@9:")
    depends_on("xxhash@0.8:")
    depends_on("nlohmann-json@3.11:")
    depends_on("cli11@2.1:")
    depends_on("tomlplusplus@3.3:")
    depends_on("random123")
    depends_on("py-h5py@3.5:", when="+python", type="run")
    depends_on("py-matplotlib", when="+python", type="run")
    depends_on("googletest@1.12:", when="+tests", type="build")

    conflicts("%gcc@:11", msg="C++20 is needed as of GCC 12")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("BAGNOLD_NATIVE", "native"),
            self.define_from_variant("BAGNOLD_TESTS", "tests"),
        ]

    def setup_run_environment(self, env):
        if self.spec.satisfies("+python"):
            env.set("BAGNOLD_PYTHON", self.spec["python"].command.path)
