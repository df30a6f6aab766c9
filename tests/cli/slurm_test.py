# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold sweep --emit-slurm` against a real Slurm: a controller, a node and munge of our own, in a
temporary folder and on free ports, as the user who runs the test. Two partitions: jobs of `high`
preempt those of `low`. Skipped (exit code 77) where slurm-wlm or munge is not installed;
scripts/check installs them on Debian."""

import getpass
import os
import re
import shutil
import socket
import subprocess
import sys
import time
import unittest

from bagnold import environment
from sweeps import SweepTest, catches_term, tables

DAEMONS = ("munged", "slurmctld", "slurmd")
COMMANDS = ("sbatch", "squeue", "srun", "sinfo", "scancel", "scontrol")
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin"

SLURM_CONF = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1{scheduler}
MaxArraySize={array}
PreemptType=preempt/partition_prio
PreemptMode={preempt}
ReturnToService=2
MailProg=/bin/true
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=low Nodes=ALL Default=YES MaxTime=INFINITE State=UP PriorityTier=1 GraceTime={grace}
PartitionName=high Nodes=ALL MaxTime=INFINITE State=UP PriorityTier=10 PreemptMode=OFF
"""
LONG = {"shear__strain": 2.0**20, "output__sample_strain": 2.0**10}


def skip(why):
    print(f"skipped: {why}")
    if os.environ.get("BAGNOLD_TESTS_SKIP") == "never":  # scripts/check has installed what it needs
        sys.exit(1)
    sys.exit(77)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class SlurmTest(SweepTest):
    def begin_slurm(self, grace=0, array=1001, scheduler="", preempt="REQUEUE"):
        """grace: seconds that a preempted job has; array: MaxArraySize; scheduler: more parameters."""
        self.cluster = self.folder / "cluster"
        for name in ("state", "spool"):
            (self.cluster / name).mkdir(parents=True)
        self.cluster.chmod(0o755)
        self.folder.chmod(0o755)
        conf = self.cluster / "slurm.conf"
        conf.write_text(SLURM_CONF.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(), ports=free_ports(2),
            folder=self.cluster, cores=len(os.sched_getaffinity(0)), grace=grace, array=array,
            scheduler=scheduler, preempt=preempt))
        self.env = environment(PATH=PATH, SLURM_CONF=str(conf))
        # Nothing asks for control groups, but slurmd looks for some where this names no plugin.
        (self.cluster / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        self.begin_munge()
        self.begin("slurmctld", "-D", "-i", "-f", str(conf))
        self.begin("slurmd", "-D", "-f", str(conf), "-N", socket.gethostname().split(".")[0])
        self.until(lambda: self.call("sinfo", "-h", "-p", "low", "-o", "%T").stdout.strip() == "idle", 60,
                   "no idle node")

    def begin_munge(self):
        key = self.cluster / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        files = [f"--{name}-file={self.cluster}/munge.{name}" for name in ("key", "pid", "log", "seed")]
        self.begin("munged", "--foreground", "--force", f"--socket={self.cluster}/munge.socket",
                   *files)
        self.until((self.cluster / "munge.socket").exists, 10, "munged gives no socket")

    def begin(self, name, *arguments):
        log = open(self.cluster / f"{name}.out", "w")
        self.addCleanup(log.close)
        process = subprocess.Popen([shutil.which(name, path=PATH), *arguments], env=self.env,
                                   stdout=log, stderr=log, stdin=subprocess.DEVNULL)

        def end():
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

        self.addCleanup(end)

    def until(self, condition, seconds, why):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                words = [f"{p.name}: {p.read_text()[-400:]}" for p in self.cluster.glob("*.out")]
                self.fail(f"Slurm cannot be started here ({why}): {words}")
            time.sleep(0.1)

    def call(self, name, *arguments):
        return subprocess.run([name, *map(str, arguments)], env=self.env, capture_output=True,
                              text=True, cwd=self.folder, timeout=60)

    def submit(self, *arguments):
        result = self.call("sbatch", "--parsable", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.strip()

    def logs(self, out):
        return "".join(log.read_text() for log in sorted((out / "slurm").iterdir()))

    def wait_for_jobs(self, out, seconds=120):
        end = time.monotonic() + seconds
        while self.call("squeue", "-h").stdout.strip():
            if time.monotonic() > end:
                self.fail(self.call("squeue").stdout + self.logs(out))
            time.sleep(0.2)

    def wait_for_points(self, out, count):
        """Until so many are at work, and know signals."""
        self.wait_until(lambda: len(self.children(out)) == count
                        and all(catches_term(pid) for pid in self.children(out)), seconds=90)


class Slurm(SlurmTest):
    def test_the_printed_commands_give_the_tables(self):
        self.begin_slurm()
        path = self.sweep_file(grid={"disks.elasticity": [1, 10]})
        whole, out = self.folder / "whole", self.folder / "my out"
        self.sweep(path, whole)
        said = self.sweep(path, out, "--emit-slurm").stdout
        commands = "\n".join(re.findall(r"^  (.*sbatch.*)$", said, re.M))
        result = subprocess.run(["bash", "-euc", commands], env=self.env, capture_output=True,
                                text=True, cwd="/")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.wait_for_jobs(out)
        self.assertTrue((out / "sweep.csv").exists(), self.logs(out))
        self.assertEqual(tables(out), tables(whole))
        self.assertEqual(len(list((out / "slurm").glob("[12].log"))), 2)

    def test_cancelled_tasks_write_checkpoints_and_go_on(self):
        self.begin_slurm()
        path = self.sweep_file(grid={"disks.elasticity": [1]}, **LONG)
        out = self.folder / "out"
        self.sweep(path, out, "--emit-slurm")
        job = self.submit(out / "points.slurm")
        self.wait_for_points(out, 1)
        self.call("scancel", job)
        self.wait_for_jobs(out)
        self.wait_until(lambda: self.children(out) == [], seconds=30)
        (point,) = self.points(out)
        self.assertTrue((point / "checkpoint.h5").exists())
        self.submit(out / "points.slurm")
        self.wait_until(lambda: "going on from step" in (point / "log.txt").read_text(), seconds=90)
        self.call("scancel", "--me")
        self.wait_for_jobs(out)


class Preemption(SlurmTest):
    def check(self, **settings):
        """A job of `high` takes the node: tasks stop with checkpoints, and go on behind it. What scancel
        ends then does not come back."""
        self.begin_slurm(**settings)
        seeds = list(range(1, 1 + min(2, len(os.sched_getaffinity(0)))))
        path, out = self.sweep_file(grid={"disks.seed": seeds}, **LONG), self.folder / "out"
        self.sweep(path, out, "--emit-slurm")
        job = self.submit("-p", "low", out / "points.slurm")
        self.wait_for_points(out, len(seeds))
        self.submit("-p", "high", "--exclusive", "--output", self.folder / "high.log", "--wrap", "echo it ran")
        self.wait_until((self.folder / "high.log").exists, seconds=90)
        self.wait_until(lambda: len(self.children(out)) == len(seeds), seconds=90)
        for point in self.points(out):
            with self.subTest(point=point.name):
                self.assertTrue((point / "checkpoint.h5").exists(), self.logs(out))
                self.wait_until(lambda: "going on from step" in (point / "log.txt").read_text(), seconds=30)
                self.assertRegex((point / "log.txt").read_text(), "(?s)stopped at step.*going on from step")
        self.wait_for_points(out, len(seeds))
        self.call("scancel", job)
        self.wait_for_jobs(out)
        self.wait_until(lambda: self.children(out) == [], seconds=30)
        time.sleep(3)  # for a task that would come back
        self.assertEqual(self.call("squeue", "-h").stdout.strip(), "")

    def test_at_once(self):
        self.check(grace=0)

    def test_with_a_grace_time(self):
        self.check(grace=60)

    def test_with_a_grace_time_where_the_queue_would_forget(self):
        self.check(grace=60, preempt="CANCEL")


class Arrays(SlurmTest):
    def setUp(self):
        super().setUp()
        self.seeds = {"disks.seed": list(range(1, 8))}

    def done(self, out):
        return [int(point.name[:4]) for point in self.points(out) if (point / "summary.json").exists()]

    def array_of(self, out):
        return re.search(r"^#SBATCH --array=(.*)$", (out / "points.slurm").read_text(), re.M)[1]

    def test_as_long_as_slurm_allows(self):
        self.begin_slurm(array=4)
        path, out = self.sweep_file(grid=self.seeds), self.folder / "out"
        environment_here = {**environment(), "SLURM_CONF": self.env["SLURM_CONF"]}
        said = self.sweep(path, out, "--emit-slurm", env=environment_here).stdout
        self.assertIn("7 points in 7 chains, 3 tasks", said)
        self.assertEqual(self.array_of(out), "1-3")
        self.submit(out / "points.slurm")
        self.wait_for_jobs(out)
        self.assertEqual(self.done(out), list(range(1, 8)), self.logs(out))

    def test_as_it_was_submitted(self):
        self.begin_slurm(scheduler=",max_array_tasks=6")
        path = self.sweep_file(grid=self.seeds)
        environment_here = {**environment(), "SLURM_CONF": self.env["SLURM_CONF"]}
        whole = list(range(1, 8))
        for array, tasks, done in (("1-2", None, whole), ("0-2", None, whole), ("1-6%2", None, whole),
                                   ("2,5", 7, [2, 5]), ("5-6", 7, [5, 6]), ("1,3", 4, [1, 3, 5, 7])):
            with self.subTest(array=array, tasks=tasks):
                out = self.folder / array.replace("%", "at")
                self.sweep(path, out, "--emit-slurm", *(("--tasks", tasks) if tasks else ()),
                           env=environment_here)
                self.assertEqual(self.array_of(out), f"1-{tasks or 6}")
                self.submit(f"--array={array}", out / "points.slurm")
                self.wait_for_jobs(out)
                self.assertEqual(self.done(out), done, self.logs(out))


if __name__ == "__main__":
    for name in (*DAEMONS, *COMMANDS):
        if shutil.which(name, path=PATH) is None:
            skip(f"{name} is not installed (Debian: slurm-wlm munge)")
    unittest.main()
