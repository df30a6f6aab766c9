# SPDX-License-Identifier: BSD-3-Clause
"""`bagnold sweep --emit-slurm` against a real Slurm: a controller, a node and munge of our own, in a
temporary folder and on free ports, as the user who runs the test. Skipped (exit code 77) where
slurm-wlm is not installed or cannot be started."""

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
from sweeps import SweepTest, tables

DAEMONS = ("munged", "slurmctld", "slurmd")
COMMANDS = ("sbatch", "squeue", "srun", "sinfo", "scancel")
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin"

SLURM_CONF = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
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
SchedulerParameters=sched_interval=1
ReturnToService=2
MailProg=/bin/true
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Slurm(SweepTest):
    def setUp(self):
        super().setUp()
        self.cluster = self.folder / "cluster"
        for name in ("state", "spool"):
            (self.cluster / name).mkdir(parents=True)
        self.cluster.chmod(0o755)
        self.folder.chmod(0o755)
        conf = self.cluster / "slurm.conf"
        conf.write_text(SLURM_CONF.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(),
            ports=free_ports(2), folder=self.cluster, cores=os.cpu_count()))
        self.env = environment(PATH=PATH, SLURM_CONF=str(conf))
        self.begin_munge()
        self.begin("slurmctld", "-D", "-i", "-f", str(conf))
        self.begin("slurmd", "-D", "-f", str(conf), "-N", socket.gethostname().split(".")[0])
        self.until(lambda: self.call("sinfo", "-h", "-o", "%T").stdout.strip() == "idle", 30,
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
                self.skipTest(f"Slurm cannot be started here ({why}): {words}")
            time.sleep(0.1)

    def call(self, name, *arguments):
        return subprocess.run([name, *map(str, arguments)], env=self.env, capture_output=True,
                              text=True, cwd=self.folder, timeout=60)

    def submit(self, *arguments):
        result = self.call("sbatch", "--parsable", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.strip()

    def wait_for_jobs(self, out, seconds=90):
        end = time.monotonic() + seconds
        while self.call("squeue", "-h").stdout.strip():
            if time.monotonic() > end:
                logs = [log.read_text() for log in (out / "slurm").iterdir()]
                self.fail(self.call("squeue").stdout + "\n".join(logs))
            time.sleep(0.2)

    def test_the_printed_commands_give_the_tables(self):
        path = self.sweep_file(grid={"disks.elasticity": [1, 10]})
        whole, out = self.folder / "whole", self.folder / "my out"
        self.sweep(path, whole)
        said = self.sweep(path, out, "--emit-slurm").stdout
        commands = "\n".join(re.findall(r"^  (.*sbatch.*)$", said, re.M))
        result = subprocess.run(["bash", "-euc", commands], env=self.env, capture_output=True,
                                text=True, cwd="/")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.wait_for_jobs(out)
        logs = "".join(log.read_text() for log in (out / "slurm").iterdir())
        self.assertTrue((out / "sweep.csv").exists(), logs)
        self.assertEqual(tables(out), tables(whole))
        self.assertEqual(len(list((out / "slurm").glob("[12].log"))), 2)

    def test_cancelled_tasks_write_checkpoints_and_go_on(self):
        path = self.sweep_file(grid={"disks.elasticity": [1]}, shear__strain=2.0**20,
                               output__sample_strain=2.0**10)
        out = self.folder / "out"
        self.sweep(path, out, "--emit-slurm")
        job = self.submit(out / "points.slurm")
        self.wait_until(lambda: self.children(out) != [], seconds=60)
        time.sleep(1)
        self.call("scancel", job)
        self.wait_for_jobs(out)
        self.wait_until(lambda: self.children(out) == [], seconds=30)
        (point,) = self.points(out)
        self.assertTrue((point / "checkpoint.h5").exists())
        self.submit(out / "points.slurm")
        self.wait_until(lambda: "going on from step" in (point / "log.txt").read_text()
                        or self.children(out) != [], seconds=60)
        time.sleep(1)
        self.call("scancel", "--me")
        self.wait_for_jobs(out)
        self.assertIn("going on from step", (point / "log.txt").read_text())


if __name__ == "__main__":
    for name in (*DAEMONS, *COMMANDS):
        if shutil.which(name, path=PATH) is None:
            skip(f"{name} is not installed (Debian: slurm-wlm munge)")
    program = unittest.main(exit=False)
    if not program.result.wasSuccessful():
        sys.exit(1)
    if program.result.skipped:
        skip(program.result.skipped[0][1])
