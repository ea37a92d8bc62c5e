#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Tries Gatun for a long time: fuzzers, damaged files, writers that are killed or run out of room, files
that change while they are read, and tests with sanitizers, in turn until the time is over.

setup.sh soak builds what this needs. A finding is kept in the folder soak/findings of the build, with its
input and what was said, and makes the exit code 1. Counts go to reliability/results.json, from which the
page reliability.md is written. Kinds: fuzz, mutations, kill, full disk, two writers, changed while open,
opens, asan-ubsan, tsan.
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import platform
import shutil
import signal
import subprocess
import sys
import threading
import time

from soakContext import ROOT, Context, Finding, running
from soakFuzz import Fuzz, targets
from soakMutations import Mutations
from soakReading import Changes, Opens
from soakSanitizers import Sanitizer
from soakWriting import FullDisk, Kill, TwoWriters

sys.path.insert(0, str(ROOT / "Benchmarks" / "Studies"))
import reliabilityReport  # pylint: disable=wrong-import-position

KINDS = ("fuzz", "mutations", "kill", "full disk", "two writers", "changed while open", "opens",
         "asan-ubsan", "tsan")
LONGEST_SLICE = 180
MOST_FINDINGS = 10  # of a task, which ends then


def make_tasks(context, kinds, chosen):
    """All tasks of these kinds; others are among the many fuzz targets, so that kinds take turns."""
    single = [Mutations(context), Kill(context), FullDisk(context), TwoWriters(context),
              Changes(context), Opens(context)]
    fuzz = [Fuzz(context, target) for target in chosen]
    tests = [Sanitizer(context, preset) for preset in ("asan-ubsan", "tsan")]
    step = -(-len(fuzz) // len(single))
    mixed = []
    for number, task in enumerate(single):
        mixed += [task, *fuzz[number * step:(number + 1) * step]]
    return [task for task in mixed + tests if task.kind in kinds]


def read_line(path, start):
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    return next((line.split(":", 1)[-1].split("=", 1)[-1].strip().strip('"')
                 for line in lines if line.startswith(start)), "unknown")


def output_of(*command, folder=ROOT):
    try:
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                             cwd=folder, check=False)
    except OSError:
        return "unknown"
    return run.stdout.splitlines()[0].strip() if run.returncode == 0 and run.stdout else "unknown"


def describe_machine(context):
    memory = int(read_line("/proc/meminfo", "MemTotal").split()[0])
    # Not those of earlier runs.
    results = (":(exclude)Documentation/reliability.md", ":(exclude)Documentation/reliability")
    changed = output_of("git", "status", "--porcelain", "--untracked-files=no", "--", ".", *results)
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "commit": output_of("git", "rev-parse", "--short=12", "HEAD")
                  + ("" if changed == "unknown" else " with changes"),
        "processor": read_line("/proc/cpuinfo", "model name"), "processors": os.cpu_count(),
        "memory": 1024 * memory, "system": read_line("/etc/os-release", "PRETTY_NAME"),
        "kernel": platform.release(), "gatun": output_of(context.gtn, "--version", folder=context.scratch),
        "clang": output_of("clang", "--version"), "gcc": output_of("g++", "--version")}


class Soak:
    """Gives slices of time to tasks in turn, until the time is over and each has had one."""

    def __init__(self, context, tasks, seconds, save):
        self.context, self.seconds, self.save = context, seconds, save
        self.waiting = collections.deque(tasks)
        self.first = set(tasks)  # those that have not had a slice
        self.tasks = tasks
        self.loads = []
        self.is_stopped = False  # from outside, which is no finding
        self.lock = threading.Lock()
        self.start = time.monotonic()
        self.slice = min(LONGEST_SLICE, seconds / (3 * max(1, len(tasks))))

    def left(self):
        return self.seconds - (time.monotonic() - self.start)

    def next_task(self):
        """The next one in the queue that still has to do something, or None."""
        with self.lock:
            while self.waiting:
                task = self.waiting.popleft()
                if task in self.first or self.left() > 0:
                    return task
            return None

    def give_slice(self, task):
        start = time.monotonic()
        try:
            if task in self.first:
                task.prepare()
            task.run(self.slice)
        except Finding as finding:
            if self.is_stopped:
                return
            self.context.note(task.name(), finding)
            task.counts["findings"] += 1
            task.is_done = task.is_done or task.counts["findings"] >= MOST_FINDINGS
        task.seconds += time.monotonic() - start
        self.loads.append(os.getloadavg()[0])
        print(f"{(time.monotonic() - self.start) / 60:6.1f} min  {task.name()}: "
              f"{json.dumps(task.results())}", flush=True)
        with self.lock:
            self.first.discard(task)
            if not task.is_done:
                self.waiting.append(task)
            self.save(self)

    def work(self):
        while task := self.next_task():
            self.give_slice(task)

    def run(self, jobs):
        workers = [threading.Thread(target=self.work, daemon=True) for _ in range(jobs)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()

    def results(self):
        kinds = {}
        for task in self.tasks:
            if task not in self.first:
                name = task.name().removeprefix(task.kind).strip() or "all"
                kinds.setdefault(task.kind, {})[name] = task.results()
        return {"minutes": round((time.monotonic() - self.start) / 60, 1), "jobs": self.context.jobs,
                "load": {"least": min(self.loads), "mean": sum(self.loads) / len(self.loads),
                         "most": max(self.loads)} if self.loads else {},
                "findings": self.context.findings, "kinds": kinds}


def parse():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    time_to_run = parser.add_mutually_exclusive_group()
    time_to_run.add_argument("minutes", nargs="?", type=float, default=120,
                             help="how long to try; each kind has a turn at least (default: 120)")
    time_to_run.add_argument("--seconds", type=float, help="the same in seconds")
    parser.add_argument("--kinds", default=",".join(KINDS), metavar="KIND,...",
                        help="what to try (default: all kinds)")
    parser.add_argument("--targets", default=",".join(targets()), metavar="TARGET,...",
                        help="what to fuzz (default: all targets)")
    parser.add_argument("--add", action="store_true",
                        help="add to the results of runs before, in place of replacing them")
    parser.add_argument("--seed", type=int, default=time.time_ns(),
                        help="of random numbers (default: another one each time)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        help="tasks at the same time (default: number of processors)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build",
                        help="the folder of the builds release, fuzz, asan-ubsan and tsan")
    parser.add_argument("--gtn", type=pathlib.Path,
                        help="the program (default: that of the build release)")
    parser.add_argument("--scratch", type=pathlib.Path, help="a folder for temporary files")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "Documentation",
                        help="the folder of reliability.md and reliability/results.json")
    options = parser.parse_args()
    options.seconds = options.seconds or 60 * options.minutes
    options.kinds = options.kinds.split(",")
    options.targets = options.targets.split(",")
    for name in "build", "gtn", "scratch", "out":
        path = getattr(options, name)
        setattr(options, name, path and path.resolve())
    for kind in options.kinds:
        if kind not in KINDS:
            parser.error(f"no such kind: {kind}")
    for target in options.targets:
        if target not in targets():
            parser.error(f"no such target: {target}")
    return options


def main():
    options = parse()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    context = Context(options)
    tasks = make_tasks(context, options.kinds, options.targets)
    for task in tasks:
        if missing := task.find_missing():
            sys.exit(f"soak: {task.name()} needs {missing}; Utilities/setup.sh soak builds it")
    file = options.out / "reliability" / "results.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    results = {"runs": []}
    if options.add and file.exists():
        results = json.loads(file.read_text(encoding="utf-8"))
    machine = describe_machine(context)

    def save(soak):
        now = {**results, "runs": [*results["runs"], {**machine, **soak.results()}]}
        beside = file.with_suffix(".new")
        beside.write_text(json.dumps(now, indent=1) + "\n", encoding="utf-8")
        os.replace(beside, file)
        reliabilityReport.write(now, options.out)

    soak = Soak(context, tasks, options.seconds, save)
    try:
        soak.run(options.jobs)
    finally:
        soak.is_stopped = True
        for process in list(running):
            process.kill()
        shutil.rmtree(context.scratch, ignore_errors=True)
    print(f"{len(context.findings)} findings; the counts are in {options.out / 'reliability.md'}")
    return 1 if context.findings else 0


if __name__ == "__main__":
    sys.exit(main())
