"""A real Slurm of one node on loopback: munged, slurmctld and slurmd in a folder of their own, without accounting."""

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

DAEMONS = ("munged", "slurmctld", "slurmd")
SITE = Path("/etc/slurm/slurm.conf")
CPUS = 6

CONFIGURATION = """\
ClusterName=ci
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort={controller}
SlurmdPort={node}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.sock
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/backfill
SchedulerParameters=sched_min_interval=200000
SlurmdParameters=config_overrides
MpiDefault=none
ReturnToService=2
KillWait=2
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=1
JobAcctGatherParams=OverMemoryKill
AccountingStorageType=accounting_storage/none
MinJobAge=86400
NodeName=localhost NodeHostName=localhost NodeAddr=127.0.0.1 CPUs={cpus} RealMemory=8000 State=UNKNOWN
PartitionName=ci Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def reason_to_skip():
    """Why no Slurm can be started here; empty if one can."""
    missing = [name for name in DAEMONS if shutil.which(name) is None]
    if missing:
        return f"{', '.join(missing)} not installed (Debian: slurm-wlm and munge)"
    if os.geteuid() != 0:
        return "Slurm's daemons need root"
    if SITE.exists() and not SITE.is_symlink():
        return f"this machine has a Slurm of its own: {SITE}"
    return ""


def _free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


class Cluster:
    """A running Slurm."""

    def __init__(self, folder):
        self.folder = folder
        self.running = []

    def start(self):
        """Start the daemons and wait until the node is idle."""
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        self.folder.chmod(0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        controller, node = _free_ports(2)
        file = self.folder / "slurm.conf"
        file.write_text(CONFIGURATION.format(folder=self.folder, controller=controller, node=node, cpus=CPUS))
        SITE.parent.mkdir(exist_ok=True)
        SITE.unlink(missing_ok=True)
        SITE.symlink_to(file)

        munge = {"key-file": "key", "socket": "sock", "seed-file": "seed", "log-file": "log", "pid-file": "pid"}
        options = [f"--{option}={self.folder}/munge.{suffix}" for option, suffix in munge.items()]
        self._launch("munged", "--foreground", "--force", *options)
        self._await(lambda: (self.folder / "munge.sock").exists(), "munged")
        self._launch("slurmctld", "-D", "-f", file)
        self._launch("slurmd", "-D", "-f", file)
        self._await(lambda: self.ask("sinfo", "-h", "-o", "%T").strip() == "idle", "an idle node")

    def stop(self):
        """Cancel all jobs, end the daemons in reverse order, remove the link to the configuration."""
        if self.running:
            self.ask("scancel", "--user=root")
            with contextlib.suppress(TimeoutError):
                self._await(lambda: not self.jobs("pending,running,completing"), "the end of jobs")
        for process in reversed(self.running):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        if SITE.is_symlink() and SITE.readlink() == self.folder / "slurm.conf":
            SITE.unlink()

    def ask(self, *command):
        """Output of a command of Slurm; empty if it fails."""
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False).stdout

    def jobs(self, states="all"):
        """Job id to state, rule and wildcards of jobs in some states."""
        rows = self.ask("squeue", "-h", "--states", states, "-o", "%i|%T|%k").splitlines()
        return {row.split("|")[0]: tuple(row.split("|")[1:]) for row in rows}

    def facts(self, job):
        """What Slurm knows of a job, as its names say it: ``JobState``, ``TimeLimit``, ``ExitCode`` ..."""
        words = self.ask("scontrol", "show", "job", "-o", job).split()
        return dict(word.split("=", 1) for word in words if "=" in word)

    def _launch(self, *command):
        log = open(self.folder / f"{command[0]}.out", "wb")  # noqa: SIM115
        self.running.append(subprocess.Popen([*map(str, command)], stdout=log, stderr=log, start_new_session=True))
        log.close()

    def _await(self, holds, what, seconds=20):
        end = time.monotonic() + seconds
        while not holds():
            dead = [process.args[0] for process in self.running if process.poll() is not None]
            if dead or time.monotonic() > end:
                logs = "\n".join(
                    f"{path.name}: {path.read_text(errors='replace')[-1500:]}" for path in self.folder.glob("*.log")
                )
                raise TimeoutError(f"waited for {what}; {', '.join(dead) or 'nothing'} ended\n{logs}")
            time.sleep(0.1)
