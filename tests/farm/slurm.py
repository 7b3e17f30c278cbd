"""A cluster of one machine: munged, slurmctld and slurmd with a key, ports and folders of their own."""

import os
import re
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

import processes

CONFIGURATION = """
ClusterName=foredraw
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={control_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={socket},cred_expire={requeue_seconds}
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
MinJobAge=3600
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Slurm:
    # A requeued task is held back until the credentials of its first run are out of date: Slurm's default is 120.
    requeue_seconds = 6

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        for name in "state", "spool":
            (self.folder / name).mkdir(parents=True)
        self.folder.chmod(0o755)
        self.sockets = self.folder / "s"
        if len(str(self.sockets)) > 90:  # a socket's path may have 107 bytes
            self.sockets = Path(tempfile.mkdtemp(prefix="farm-"))
        self.sockets.mkdir(exist_ok=True)
        self.sockets.chmod(0o755)
        self.daemons = []

    def __enter__(self):
        try:
            self._begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        processes.end_all()
        for _, daemon in self.daemons:
            daemon.poll()
        shutil.rmtree(self.sockets, ignore_errors=True)

    def _begin(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        munge = self.sockets / "munge"
        control_port, node_port = free_ports(2)
        host = socket.gethostname().split(".")[0]
        self.configuration = self.folder / "slurm.conf"
        self.configuration.write_text(CONFIGURATION.format(
            host=host, folder=self.folder, socket=munge, control_port=control_port, node_port=node_port,
            user=self.run("id", "-un").strip(), requeue_seconds=self.requeue_seconds))
        self._daemon("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={munge}",
                     f"--pid-file={self.sockets}/pid", f"--log-file={self.folder}/munged.log",
                     f"--seed-file={self.folder}/munged.seed", "--num-threads=2")
        self.wait_until("munged answers", munge.exists)
        self._daemon("slurmctld", "-D", "-f", str(self.configuration))
        self._daemon("slurmd", "-D", "-f", str(self.configuration), "-N", host)
        self.wait_until("the node is up", lambda: "idle" in self.run("sinfo", "--noheader", "--format=%T", check=False))

    def _daemon(self, name, *arguments):
        self.daemons.append((name, processes.begin([name, *arguments], self.folder / f"{name}.out")))

    def run(self, *command, check=True, **more):
        environment = dict(os.environ)
        for name in list(environment):  # of a cluster that this test may run on
            if re.match("(SLURM|SBATCH|MUNGE)_", name):
                del environment[name]
        if hasattr(self, "configuration"):
            environment["SLURM_CONF"] = str(self.configuration)
        environment.update(more.pop("environment", {}))
        ended = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, **more)
        if check and ended.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: {ended.stderr or ended.stdout}")
        return ended.stdout

    def wait_until(self, what, holds, seconds=60):
        end = time.monotonic() + seconds
        while not holds():
            for name, daemon in self.daemons:
                if daemon.poll() is not None:
                    raise RuntimeError(f"{name} has ended: {self.last_words(name)}")
            if time.monotonic() > end:
                words = "\n".join(self.last_words(name) for name, _ in self.daemons)
                raise TimeoutError(f"after {seconds} s it is not so that {what}\n{self.run('squeue', check=False)}{words}")
            time.sleep(0.1)

    def last_words(self, name):
        return (self.folder / f"{name}.out").read_text(errors="replace")[-1500:]

    def job(self, number):
        """What Slurm tells of a job or of one task ("12_3"): "JobState", "ExitCode", "Restarts" and so on."""
        text = self.run("scontrol", "--oneliner", "show", "job", str(number), check=False)
        return dict(word.split("=", 1) for word in text.split() if "=" in word)
