# SPDX-License-Identifier: BSD-3-Clause
"""The same scene gives the same bits: any thread count, either backend, outputs on or off."""

import unittest

from bagnold import LAWS, CliTest, environment

WAYS = [("openmp", 1), ("openmp", 2), ("openmp", 3), ("serial", 1)]


class SameBits(CliTest):
    def backends(self):
        info = self.bagnold("info").stdout.lower()
        ways = [(backend, threads) for backend, threads in WAYS if backend in info]
        self.assertTrue(ways)
        return ways

    def check(self, name, **changes):
        outs = []
        for backend, threads in self.backends():
            outs.append(self.run_new(f"{name}-{backend}-{threads}", "--backend", backend,
                                     "--threads", threads, **changes))
            self.assert_same_results(outs[0], outs[-1])

    def test_every_law(self):
        for model in LAWS:
            for mass in ("equal", "area"):
                with self.subTest(model=model, mass=mass):
                    self.check(f"{model}-{mass}", disks__model=model, disks__mass=mass,
                               disks__count=256, disks__packing_fraction=0.81)

    def test_many_disks(self):
        """Enough of them for several blocks a sum and several list rebuilds."""
        self.check("many", disks__count=3000, disks__packing_fraction=0.81,
                   shear__strain=2.0**-4, shear__strain_rate=2.0**-5)

    def test_few_disks(self):
        self.check("few", disks__count=30, disks__packing_fraction=0.6)

    def test_outputs_never_change_the_trajectory(self):
        for model in ("CD_n", "CD_rot"):
            plain = self.run_new(f"{model}-plain", disks__model=model, measure__every=1000)
            for name, changes in {
                "every": {"measure__every": 1},
                "windows": {"output__sample_strain": 2.0**-10, "measure__every": 1},
                "one window": {"output__sample_strain": 2.0**-3},
                "checkpoints": {"output__checkpoint_minutes": 1e-9},
                "rare checkpoints": {"output__checkpoint_minutes": 1e9},
                "discard": {"shear__discard": 0.0},
            }.items():
                with self.subTest(model=model, name=name):
                    out = self.run_new(f"{model}-{name}", disks__model=model, **changes)
                    self.assert_same_state(plain, out)

    def test_progress_never_changes_the_results(self):
        scene = self.scene(shear__strain=1.0)
        outs = [self.folder / name for name in ("loud", "quiet")]
        self.run_scene(scene, outs[0])
        self.run_scene(scene, outs[1], "--quiet")
        self.assert_same_results(*outs)


class OtherThreads(CliTest):
    """What the environment or an option says of threads is borne or told, and changes no bit."""

    def few(self, name, *arguments, **variables):
        out = self.folder / name
        result = self.run_scene(self.scene(), out, "--backend", "openmp", *arguments,
                                env=environment(**variables))
        return out, [line for line in result.stderr.splitlines() if "--threads" in line]

    def test_the_environment(self):
        plain, said = self.few("plain", "--threads", 2)
        self.assertEqual(said, [])
        for variables in ({"OMP_DYNAMIC": "true"}, {"OMP_MAX_ACTIVE_LEVELS": "0"}, {"OMP_NUM_THREADS": "1"},
                          {"OMP_NUM_THREADS": "100000"},
                          {"KOKKOS_NUM_THREADS": "3"}, {"KOKKOS_NUM_THREADS": "x"},
                          {"KOKKOS_DISABLE_WARNINGS": "x"}, {"OMP_THREAD_LIMIT": "2"}):
            name = "-".join(variables)
            with self.subTest(variables=variables):
                out, said = self.few(name + "".join(variables.values()), "--threads", 2, **variables)
                self.assertEqual(said, [])
                self.assert_same_results(plain, out)

    def test_a_limit_of_openmp(self):
        plain, _ = self.few("plain", "--threads", 2)
        out, said = self.few("limited", "--threads", 3, OMP_THREAD_LIMIT="1")
        self.assertEqual(len(said), 1, said)
        for word in ("--threads 3", "OMP_THREAD_LIMIT", "1"):
            self.assertIn(word, said[0])
        self.assert_same_results(plain, out)

    def test_more_than_kokkos_bears(self):
        out = self.folder / "many"
        result = self.run_scene(self.scene(shear__strain=2.0**-6, disks__count=64), out, "--threads", 600)
        (said,) = [line for line in result.stderr.splitlines() if "--threads" in line]
        for word in ("600", "512"):
            self.assertIn(word, said)


if __name__ == "__main__":
    unittest.main()
