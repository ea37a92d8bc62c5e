# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What all kinds of a soak need: programs, folders, processes with limits, and a place for findings."""

import collections
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[2]
MIB = 1 << 20

# Of one process, in seconds. What hangs uses up its time of the processor. A process that waits for
# ever is stopped much later, as all others may have to wait under load.
PROCESSOR_TIME = 300
TIMEOUT = 3600

Run = collections.namedtuple("Run", "code output peak timeout")

running = set()  # processes to end if the soak is interrupted


class Finding(Exception):
    """What should not have happened; files: the inputs that show it, log: what was said."""

    def __init__(self, what, files=(), log=""):
        super().__init__(what)
        self.what, self.files, self.log = what, files, log


class Context:
    """Where the programs are, where to write, and what was found."""

    def __init__(self, options):
        self.build = options.build
        self.gtn = options.gtn or self.build / "release" / "bin" / "gtn"
        self.jobs = options.jobs
        self.is_short = options.seconds < 300
        self.random = random.Random(options.seed)
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="soak-", dir=options.scratch))
        self.state = self.build / "soak"
        self.findings = []
        self.known = {}  # results of writers that nothing disturbs
        self.lock = threading.Lock()
        self.state.mkdir(parents=True, exist_ok=True)

    def program(self, preset, name):
        return self.build / preset / "bin" / name

    def folder(self, *parts):
        """An empty folder to work in."""
        path = self.scratch.joinpath(*parts)
        shutil.rmtree(path, ignore_errors=True)
        path.mkdir(parents=True)
        return path

    def new_random(self):
        return random.Random(self.random.getrandbits(64))

    def note(self, kind, finding):
        """Keeps a finding with its files and what was said, and goes on."""
        with self.lock:
            number = 1
            while (folder := self.state / "findings" / f"{kind.replace(' ', '-')}-{number}").exists():
                number += 1
            folder.mkdir(parents=True)
        for file in finding.files:
            if pathlib.Path(file).exists():
                shutil.copy(file, folder)
        (folder / "log.txt").write_text(f"{finding.what}\n\n{finding.log}\n", encoding="utf-8")
        self.findings.append({"kind": kind, "what": finding.what})
        print(f"FINDING: {kind}: {finding.what} ({folder})", flush=True)

    def environment(self, **more):
        """For programs in Python: the package and the helpers of the tests."""
        paths = [str(path) for path in self.gtn.parents[1].glob("lib/python3*/*-packages")]
        paths += [os.environ["PYTHONPATH"]] if "PYTHONPATH" in os.environ else []
        paths += [str(ROOT / "Testing" / folder) for folder in ("IO", "Python", "CLI")]
        return {**os.environ, "PYTHONPATH": ":".join(paths), "PYTHONDONTWRITEBYTECODE": "1",
                "GATUN_TEST_GTN": str(self.gtn), "GATUN_TEST_TEMP": str(self.scratch),
                **{name: str(value) for name, value in more.items()}}

    def python(self, program, *arguments, timeout=TIMEOUT, **more):
        """Runs a program of this folder; returns what it prints last, which is JSON."""
        command = [sys.executable, ROOT / "Utilities" / "soak" / program, *arguments]
        run = run_process(command, environment=self.environment(**more), timeout=timeout,
                          processor_time=4 * PROCESSOR_TIME)
        if run.code != 0 or run.timeout:
            raise Finding(f"{program} ended with {describe(run)}", log=run.output)
        return json.loads(run.output.strip().splitlines()[-1])


def describe(run):
    """How a process ended, in words."""
    if run.timeout or run.code == -signal.SIGXCPU:
        return "no end in time"
    return f"signal {-run.code}" if run.code < 0 else f"exit code {run.code}"


def run_process(command, environment=None, folder=None, timeout=TIMEOUT, address_space=None,
                file_size=None, processor_time=None, restore_signals=True):
    """Runs a command to its end. Limits are in bytes and seconds. Returns its exit code (negative: a
    signal), all that it said, the most memory that it had resident, and whether it was stopped."""
    limits = [f"--cpu={processor_time}:{processor_time + 30}"] if processor_time else []
    limits += [f"--as={address_space}"] if address_space else []
    limits += [f"--fsize={file_size}"] if file_size is not None else []
    command = [*(["prlimit", *limits] if limits else []), *map(str, command)]
    with tempfile.TemporaryFile() as output:
        # Whoever looks at the process waits for it, so Popen must not.
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                   env=environment, cwd=folder, restore_signals=restore_signals)
        stopped = []
        running.add(process)
        timer = threading.Timer(timeout, lambda: (stopped.append(True), process.kill()))
        timer.start()
        try:
            _, status, usage = os.wait4(process.pid, 0)
        finally:
            timer.cancel()
            running.discard(process)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read().decode("utf-8", "replace")
    return Run(process.returncode, text, 1024 * usage.ru_maxrss, bool(stopped))


class Task:
    """Something to do in turn with others. A task repeats its rounds until its time is over."""

    kind = ""

    def __init__(self, context):
        self.context = context
        self.random = context.new_random()
        self.seconds = 0.0
        self.counts = collections.Counter()
        self.is_done = False  # whether it need not be called again

    def name(self):
        return self.kind

    def find_missing(self):
        """A file that the task needs and that is not there, or None."""
        return None if self.context.gtn.exists() else self.context.gtn

    def prepare(self):
        """Before the first round."""

    def run(self, seconds):
        """Works for so long, but for one round at least. Raises Finding, and can be called again."""
        raise NotImplementedError

    def results(self):
        return {"seconds": round(self.seconds, 1), **self.counts}
