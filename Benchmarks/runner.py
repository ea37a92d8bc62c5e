# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the programs that measure, with a display or a memory limit, and records where and when."""

import datetime
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time


class Runner:
    """Runs the programs and prints what it does."""

    def __init__(self, programs, work):
        self.programs = programs
        self.work = work
        self.start = time.monotonic()
        self.limiter = MemoryLimit.find()
        # The beginning of a command with a window; None if no display is available.
        self.display = ([] if os.environ.get("DISPLAY")
                        else ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset"]
                        if shutil.which("xvfb-run") else None)

    def path(self, *parts):
        path = self.work.joinpath(*map(str, parts))
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def folder(self, name):
        path = self.path(name)
        path.mkdir(exist_ok=True)
        return path

    def say(self, text):
        print(f"{time.monotonic() - self.start:7.1f} s  {text}", flush=True)

    def run(self, *command, **options):
        """The output of a command."""
        done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, text=True,
                              check=False, **options)
        if done.returncode != 0:
            sys.exit(f"report: {' '.join(map(str, command))} failed")
        return done.stdout

    def gtn(self, *arguments):
        return self.run(self.programs / "gtn", *arguments)

    def info(self, file):
        return json.loads(self.gtn("info", "--json", file))

    def command(self, threads, *arguments):
        return [self.programs / "gatunBenchmarks", "--threads", threads, *arguments]

    def case(self, *arguments, threads=0, window=False):
        """Runs a case of gatunBenchmarks. A case with a window gets a display. Mesa's software
        rasterizer gets as many threads as the case (0: none but its own)."""
        self.say(" ".join(map(str, arguments)) + (f" ({threads} threads)" if threads else ""))
        environment = {**os.environ, "LP_NUM_THREADS": str(threads if threads > 1 else 0)}
        out = self.run(*(self.display if window else ()), *self.command(threads, *arguments),
                       env=environment)
        return json.loads(out) if out else None

    def limited(self, limit, *arguments):
        """The same with a memory limit in MiB; None if that is too little."""
        self.say(" ".join(map(str, arguments)) + f" ({limit} MiB)")
        out = self.limiter.run(list(map(str, self.command(0, *arguments))), limit * 2**20)
        return json.loads(out) if out else None


class MemoryLimit:
    """A control group of its own for a command: below that of this process (version 1) or next to it
    (version 2). It counts resident memory: the heap, and pages of files that no other group uses."""

    def __init__(self, parent, limit):
        self.parent = parent
        self.limit = limit

    @staticmethod
    def find():
        """None if this process may not make groups."""
        root = pathlib.Path("/sys/fs/cgroup")
        try:
            lines = pathlib.Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines()
        except OSError:
            return None
        for line in lines:
            _, controllers, path = line.split(":", 2)
            own = root / path.lstrip("/")
            if controllers == "memory":
                way = MemoryLimit(root / "memory" / path.lstrip("/"), "memory.limit_in_bytes")
            elif controllers == "" and (root / "cgroup.controllers").exists():
                way = MemoryLimit(own if own == root else own.parent, "memory.max")
            else:
                continue
            try:
                if way.run(["echo", "works"], 2**30):
                    return way
            except OSError:
                pass
        return None

    def run(self, command, limit):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="gatun-", dir=self.parent))
        try:
            (folder / self.limit).write_text(str(limit), encoding="utf-8")

            def enter():
                (folder / "cgroup.procs").write_text("0", encoding="utf-8")
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  check=False, timeout=300, preexec_fn=enter)
            return done.stdout if done.returncode == 0 else None
        except subprocess.TimeoutExpired:
            return None
        finally:
            # The kernel may take a moment to let go of a process that has ended.
            for _ in range(100):
                try:
                    folder.rmdir()
                    break
                except OSError:
                    time.sleep(0.05)


def machine(runner):
    known = runner.case("machine")
    cpu = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    try:
        commit = subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=7"],
                                cwd=pathlib.Path(__file__).parent, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True, check=False).stdout.strip()
    except FileNotFoundError:
        commit = ""
    known.update(processor=cpu[1] if cpu else "unknown", processors=len(os.sched_getaffinity(0)),
                 memory=os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"),
                 loadBefore=os.getloadavg()[0], date=datetime.date.today().isoformat(),
                 commit=commit or "unknown")
    return known
