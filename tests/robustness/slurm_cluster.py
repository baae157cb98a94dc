"""A SLURM of its own for a test: a controller and virtual nodes on this machine, in a temporary folder, as any user, without
systemd, cgroups, accounting, and without touching what is configured in /etc. Debian's packages: slurm_packages in tools/setup.sh.
"""

import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time

CONTROLLER, DAEMON, MUNGE = "/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/sbin/munged"
LONGEST = 60  # s that anything but a job may take

# Between the virtual nodes TCP over the loopback. Not shared memory: the segments of two nodes would have the same names.
OPEN_MPI = {"OMPI_MCA_btl_tcp_if_include": "lo", "OMPI_MCA_oob_tcp_if_include": "lo", "OMPI_MCA_btl": "self,tcp"}

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=120
InactiveLimit=0
KillWait=5
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
PartitionName=debug Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def is_available():
    return all(os.path.exists(path) for path in (CONTROLLER, DAEMON, MUNGE)) and shutil.which("sbatch")


def free_ports(count):
    """Ports that nobody listens on now."""
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


class Cluster:
    """With so many nodes of `cpus` processors each; all processes end with the block."""

    def __init__(self, nodes=2, cpus=2):
        self.names = [f"n{k + 1}" for k in range(nodes)]
        self.cpus = cpus
        self.folder = tempfile.mkdtemp(prefix="slurm")
        self.configuration = os.path.join(self.folder, "slurm.conf")
        self.env = {**os.environ, **OPEN_MPI, "SLURM_CONF": self.configuration}
        self.daemons = []

    def __enter__(self):
        try:
            self.configure()
            self.start_munge()
            self.start(CONTROLLER, "-D", "-c", "-f", self.configuration)
            for name in self.names:
                self.start(DAEMON, "-D", "-c", "-N", name, "-f", self.configuration)
            self.wait(lambda: self.say("sinfo", "-h", "-o", "%D %t").split() == [str(len(self.names)), "idle"])
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def configure(self):
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        controller, *ports = free_ports(1 + len(self.names))
        os.mkdir(os.path.join(self.folder, "state"))
        with open(self.configuration, "w") as file:
            file.write(CONFIGURATION.format(host=host, user=user, port=controller, folder=self.folder))
            for name, port in zip(self.names, ports):
                os.mkdir(os.path.join(self.folder, f"spool.{name}"))
                file.write(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs={self.cpus} State=UNKNOWN\n")

    def start_munge(self):
        key = os.path.join(self.folder, "munge.key")
        with open(os.open(key, os.O_WRONLY | os.O_CREAT, 0o400), "wb") as file:
            file.write(os.urandom(1024))
        self.start(MUNGE, "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                   f"--pid-file={self.folder}/munge.pid", f"--log-file={self.folder}/munge.log",
                   f"--seed-file={self.folder}/munge.seed")
        self.wait(lambda: os.path.exists(f"{self.folder}/munge.socket"))

    def start(self, *command):
        self.daemons.append(subprocess.Popen(command, env=self.env, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL))

    def stop(self):
        """Jobs first: their processes are children of the nodes' daemons."""
        if len(self.daemons) > 1:
            subprocess.run(["scancel", "--me"], env=self.env, capture_output=True, timeout=LONGEST)
            end = time.monotonic() + LONGEST
            while self.say("squeue", "-h") and time.monotonic() < end:
                time.sleep(0.2)
        for daemon in reversed(self.daemons):
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def say(self, *command):
        """What a command of SLURM prints, which is nothing while the controller is not there."""
        done = subprocess.run(command, env=self.env, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=LONGEST)
        return done.stdout.strip()

    def wait(self, condition, seconds=LONGEST):
        end = time.monotonic() + seconds
        while not condition():
            assert all(daemon.poll() is None for daemon in self.daemons), f"a daemon has ended:\n{self.logs()}"
            assert time.monotonic() < end, f"waited too long:\n{self.say('squeue')}\n{self.logs()}"
            time.sleep(0.1)

    def logs(self):
        text = ""
        for name in sorted(os.listdir(self.folder)):
            if name.endswith(".log"):
                with open(os.path.join(self.folder, name), errors="replace") as file:
                    text += f"== {name}\n" + "".join(file.readlines()[-15:])
        return text

    def submit(self, folder, script, *arguments, options=(), env=None):
        """The number of the job; it runs in the folder, the log is job.log there."""
        done = subprocess.run(
            ["sbatch", "--parsable", "--partition=debug", "--account=test", "--output=job.log", *options, script, *arguments],
            cwd=folder, env={**self.env, **(env or {})}, capture_output=True, text=True, timeout=LONGEST)
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def job(self, number):
        """State, exit code and so on of a job, as scontrol shows them."""
        return dict(re.findall(r"(\S+?)=(\S*)", self.say("scontrol", "show", "job", number)))

    def signal_script(self, number):
        """The signal that #SBATCH --signal=B:USR1@120 asks for, at once."""
        subprocess.run(["scancel", "--batch", "--signal=USR1", number], env=self.env, check=True, timeout=LONGEST)

    def wait_for_end(self, number, seconds=300):
        done = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY")
        self.wait(lambda: self.job(number).get("JobState") in done, seconds)
        return self.job(number)
