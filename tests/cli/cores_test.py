# SPDX-License-Identifier: BSD-3-Clause
"""Cores that a process may use: its affinity mask, its quota, whatever OpenMP binds."""

import os
import pathlib
import re
import resource
import subprocess
import unittest

from bagnold import PROGRAM, CliTest, environment
from sweeps import SweepTest, catches_term

CORES = sorted(os.sched_getaffinity(0))
BINDINGS = ({"OMP_PROC_BIND": "true"}, {"OMP_PROC_BIND": "spread"}, {"OMP_PROC_BIND": "close"},
            {"OMP_PLACES": "cores"}, {"OMP_PLACES": "{0}", "OMP_PROC_BIND": "true"},
            {"GOMP_CPU_AFFINITY": str(CORES[0])}, {"OMP_PROC_BIND": "spread", "OMP_PLACES": "threads"})
LONG = {"shear__strain": 2.0**20, "output__sample_strain": 2.0**10}
SEEDS = {"disks.seed": list(range(1, 7))}
GROUPS = pathlib.Path("/sys/fs/cgroup/cpu")


def allowed(task):
    """Cores that a process or a thread may use, of /proc."""
    return sorted(os.sched_getaffinity(task))


def threads_of(pid):
    return [int(path.name) for path in pathlib.Path(f"/proc/{pid}/task").iterdir()]


class Cores(SweepTest):
    def started(self, *arguments, cores=None, **variables):
        def narrow():
            if cores is not None:
                os.sched_setaffinity(0, cores)
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], env=environment(**variables),
                                   cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, preexec_fn=narrow)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def told(self, **options):
        """Threads that `bagnold info` counts."""
        said, _ = self.started("info", **options).communicate()
        return int(re.search(r"CPU .* (\d+) threads", said)[1])

    def at_work(self, name, count, *arguments, **options):
        """The points of a sweep once so many are at work, and its process."""
        out = self.folder / name
        process = self.started("sweep", self.sweep_file(grid=SEEDS, **LONG), "--out", out, *arguments, **options)
        self.wait_until(lambda: len(self.children(out)) == count
                        and all(catches_term(pid) for pid in self.children(out)), process)
        return process, self.children(out)

    def test_info_counts_the_mask(self):
        self.assertEqual(self.told(), len(CORES))
        self.assertEqual(self.told(cores=CORES[:1]), 1)
        self.assertEqual(self.told(cores=CORES[-1:]), 1)
        for binding in BINDINGS:
            with self.subTest(**binding):
                self.assertEqual(self.told(**binding), len(CORES))

    def test_as_many_points_as_the_mask_has_cores(self):
        for cores in (CORES[:1], CORES[-1:], CORES):
            with self.subTest(cores=cores):
                process, points = self.at_work(f"mask{cores}", len(cores), cores=cores)
                for point in points:
                    self.assertEqual(allowed(point), cores)
                process.kill()

    @unittest.skipUnless(len(CORES) > 1, "one core")
    def test_points_are_bound_to_no_core(self):
        for k, binding in enumerate(BINDINGS):
            for threads in (1, 2):
                with self.subTest(**binding, threads=threads):
                    process, points = self.at_work(f"bound{k}.{threads}", 2, "--jobs", 2, "--threads", threads,
                                                   **binding)
                    for point in points:
                        for thread in threads_of(point):
                            self.assertEqual(allowed(thread), CORES)
                    process.kill()

    @unittest.skipUnless(len(CORES) > 1, "one core")
    def test_replicas_and_a_lone_thread_are_bound_to_no_core(self):
        for k, binding in enumerate(BINDINGS):
            for replicas in (1, 3):
                with self.subTest(**binding, replicas=replicas):
                    out = self.folder / f"run{k}.{replicas}"
                    process = self.started("run", self.scene(disks__replicas=replicas, **LONG), "--out", out,
                                           **binding)
                    wanted = 1 if replicas == 1 else 1 + min(replicas, len(CORES))
                    self.wait_until(lambda: (out / "scene.toml").exists() and catches_term(process.pid)
                                    and len(threads_of(process.pid)) >= wanted, process)
                    process.send_signal(10)
                    self.wait_until((out / "checkpoint.h5").exists, process)
                    for thread in threads_of(process.pid):
                        self.assertEqual(allowed(thread), CORES)
                    process.kill()

    def test_replicas_in_a_mask(self):
        out = self.folder / "run"
        process = self.started("run", self.scene(disks__replicas=3, **LONG), "--out", out, cores=CORES[:1])
        self.wait_until((out / "scene.toml").exists, process)
        process.send_signal(10)
        self.wait_until((out / "checkpoint.h5").exists, process)
        self.assertEqual([allowed(thread) for thread in threads_of(process.pid)], [CORES[:1]])

    @unittest.skipUnless(os.access(GROUPS, os.W_OK) and len(CORES) > 1, "no control groups to make here")
    def test_a_quota(self):
        group = GROUPS / f"bagnold-test-{os.getpid()}"
        group.mkdir()
        try:
            inner = group / "inner"
            inner.mkdir()
            (group / "cpu.cfs_quota_us").write_text("100000")
            code = f"echo $$ > {inner}/tasks && exec {PROGRAM} info"
            said = subprocess.run(["sh", "-c", code], capture_output=True, text=True, env=environment()).stdout
            self.assertRegex(said, r"CPU .* 1 threads")
            (group / "cpu.cfs_quota_us").write_text("-1")
            said = subprocess.run(["sh", "-c", code], capture_output=True, text=True, env=environment()).stdout
            self.assertRegex(said, rf"CPU .* {len(CORES)} threads")
        finally:
            for path in (group / "inner", group):
                if path.exists():
                    path.rmdir()


class Threads(CliTest):
    def no_threads(self):
        """Stacks of a size that no address space holds: pthread_create() says EAGAIN, as it does where
        `ulimit -u` is reached."""
        return lambda: resource.setrlimit(resource.RLIMIT_STACK, (1 << 60, resource.RLIM_INFINITY))

    def run_with(self, path, name, *arguments, preexec=None, **variables):
        return subprocess.run([PROGRAM, "run", str(path), "--out", str(self.folder / name), *arguments],
                              capture_output=True, text=True, env=environment(**variables), cwd=self.folder,
                              preexec_fn=preexec, timeout=120)

    def assert_words(self, result):
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("bagnold: ", result.stderr)
        for word in ("threads cannot be started", "--threads", "ulimit -u"):
            self.assertIn(word, result.stderr)
        self.assertNotIn("terminate", result.stderr)

    def test_of_openmp(self):
        path = self.scene()
        result = self.run_with(path, "stacks", "--backend", "openmp", "--threads", "2",
                               OMP_STACKSIZE="900000G")
        self.assert_words(result)

    def test_more_than_cores_are_told(self):
        """Of 16 disks, which end before the wait for each other is felt."""
        few = self.scene(disks__count=16, shear__strain=2.0**-5)
        many = 3 * len(os.sched_getaffinity(0))
        result = self.run_with(few, "many", "--backend", "openmp", "--threads", str(many), OMP_WAIT_POLICY="passive")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, rf"warning: --threads {many} \(more than the .* that this process may use.*; use --threads \d+")

    def test_of_replicas(self):
        _, hard = resource.getrlimit(resource.RLIMIT_STACK)
        if hard != resource.RLIM_INFINITY:
            self.skipTest("stacks are limited here")
        path = self.scene(disks__replicas=4)
        self.assert_words(self.run_with(path, "replicas", "--threads", "4", preexec=self.no_threads()))
        self.assertEqual(self.run_with(path, "one", "--threads", "1", preexec=self.no_threads()).returncode, 0)

    def test_of_a_user_with_too_many_processes(self):
        """As another user than root, whom the limit does not bind."""
        if os.getuid() == 0 and not self.others_may_run():
            self.skipTest("the program is in a folder of root's")
        self.folder.chmod(0o777)
        path = self.scene(disks__replicas=4)

        def limit():
            if os.getuid() == 0:
                os.setgid(65534)
                os.setuid(65534)
            resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))

        for name, arguments in (("openmp", ("--set", "disks.replicas=1", "--backend", "openmp")), ("replicas", ())):
            with self.subTest(name):
                self.assert_words(self.run_with(path, name, "--threads", "4", *arguments, preexec=limit))

    def others_may_run(self):
        return all(path.stat().st_mode & 0o005 == 0o005 for path in (
            pathlib.Path(PROGRAM).resolve(), *pathlib.Path(PROGRAM).resolve().parents))


if __name__ == "__main__":
    unittest.main()
