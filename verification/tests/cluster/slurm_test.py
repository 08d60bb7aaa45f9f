#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs a map as a job array of SLURM, and compares its bytes with those of one run.

  slurm_test.py PROGRAM MANUAL

PROGRAM is the command line. The job script is the one of MANUAL, the user guide, with a smaller map. The test starts munged,
slurmctld and slurmd on this machine in a folder of its own, kills one task while it works, requeues it, and joins the shards. The
packages slurmctld, slurmd, slurm-client and munge are needed.
"""

import os
import pwd
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
MANUAL = Path(sys.argv[2])
AXES = "--x frequency=1:120:40 --y length=1:2:200"
SHARDS = 4
PATIENCE = 120  # s

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={port}
SlurmdPort={daemon_port}
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MailProg=/bin/true
SelectType=select/cons_tres
NodeName={host} CPUs={processors}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def output_of(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}: {done.stdout}{done.stderr}")
    return done.stdout


def wait_for(description, condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"after {PATIENCE} s: not {description}")
        time.sleep(0.05)


def job_script():
    """The first script of the manual that starts with a line for sbatch, with the axes of this test."""
    scripts = re.findall(r"```bash\n(#!/bin/bash\n#SBATCH.*?)```", MANUAL.read_text(encoding="utf-8"), re.DOTALL)
    script = re.sub(r"--array=1-\d+", f"--array=1-{SHARDS}", scripts[0])
    return re.sub(r"--x \S+ --y \S+", AXES, script)


class JobArray(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="stickslip-slurm-")))
        self.enterContext(self.cluster())

    def cluster(self):
        """munged, slurmctld and slurmd, which end with the test."""
        folder, host = self.folder, socket.gethostname().split(".")[0]
        configuration = folder / "slurm.conf"
        configuration.write_text(
            CONFIGURATION.format(folder=folder, host=host, port=free_port(), daemon_port=free_port(),
                                 processors=os.cpu_count(), user=pwd.getpwuid(os.getuid()).pw_name),
            encoding="utf-8")
        self.environment = os.environ | {"SLURM_CONF": str(configuration), "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}:/usr/sbin"}
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        commands = [
            ["munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
             f"--pid-file={folder}/munge.pid", f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed"],
            ["slurmctld", "-D"], ["slurmd", "-D", "-N", host]]
        return Daemons(commands, folder, self.environment)

    def slurm(self, *command):
        return output_of(*command, env=self.environment, cwd=self.folder)

    def state_of(self, task):
        return self.slurm("scontrol", "--oneliner", "show", "job", task).split("JobState=")[1].split()[0]

    def test_killed_task_is_run_again_and_the_shards_have_the_bytes_of_one_run(self):
        wait_for("ready", lambda: "idle" in subprocess.run(
            ["sinfo", "--noheader", "--format=%T"], env=self.environment, capture_output=True, text=True).stdout)
        script = self.folder / "map.sbatch"
        script.write_text(job_script(), encoding="utf-8")
        job = self.slurm("sbatch", "--parsable", str(script)).strip()
        tasks = [f"{job}_{number}" for number in range(1, SHARDS + 1)]
        killed, shard = tasks[1], self.folder / "shard-2"

        wait_for("shard 2 at work", lambda: self.state_of(killed) == "RUNNING")
        self.slurm("scancel", "--signal=KILL", killed)
        wait_for("shard 2 killed", lambda: self.state_of(killed) in ("FAILED", "CANCELLED", "COMPLETING"))
        self.assertFalse(shard.exists())
        wait_for("shard 2 ended", lambda: self.state_of(killed) != "COMPLETING")
        self.slurm("scontrol", "requeue", killed)
        wait_for("all done", lambda: all(self.state_of(task) == "COMPLETED" for task in tasks))

        joined = b"".join((self.folder / f"shard-{number}").read_bytes() for number in range(1, SHARDS + 1))
        self.slurm(PROGRAM, "map", "paper", "--method", "fe", *AXES.split(), "--output", "one.csv", "--quiet")
        self.assertEqual(joined, (self.folder / "one.csv").read_bytes())


class Daemons:
    """Processes in the foreground of their own, ended in the opposite order."""

    def __init__(self, commands, folder, environment):
        self.commands, self.folder, self.environment, self.running = commands, folder, environment, []

    def __enter__(self):
        for command in self.commands:
            with (self.folder / f"{command[0]}.out").open("w") as log:
                self.running.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))
            if command[0] == "munged":
                wait_for("munged at work", (self.folder / "munge.socket").exists)

    def __exit__(self, *_):
        for process in reversed(self.running):
            process.terminate()
            process.wait(timeout=30)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
