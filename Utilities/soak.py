#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Tries for a long time what may go wrong with files; setup.sh soak builds what it needs. Turns alternate:

    fuzz     a fuzz target goes on from its corpus and from what it has found before
    damage   damaged files go through gtn: it does its job, or says why it does not
    kill     gtn is killed while it replaces a file: the old one or the whole new one is there

The programs are those of the builds fuzz and asan-ubsan. A finding is kept with its input and what was said in
the folder soak/findings of the build, and makes the exit code 1."""

import argparse
import collections
import concurrent.futures
import functools
import itertools
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
TURN = 60  # seconds
TIMEOUT = 300  # of a command, in seconds: far more than any needs for these small files
LARGE_INPUTS = ("File", "HartleyFile", "Sections")

# Drivers of OpenGL leak; the tests look for leaks.
ENVIRONMENT = dict(os.environ, ASAN_OPTIONS="detect_leaks=0:max_allocation_size_mb=1024:hard_rss_limit_mb=2048")
REPORT = re.compile(r"Sanitizer|runtime error:")

COMMANDS = {".gtn": ("info -v IN", "verify -q IN", "unpack -q -f IN out.vtu", "render -q -f --size 24x24 IN out.png"),
            ".ghv": ("volume info --verify IN", "volume unpack -q -f IN out.vti",
                     "volume render -q -f --size 24x24 IN out.png")}
# Each writes another out.gtn; SAMPLES is the folder of inputs.
WRITERS = ("pack -q -f SAMPLES/mesh.vtu out.gtn", "pack -q -f --levels 3 SAMPLES/mesh.vtu out.gtn",
           "pack -q -f --pieces 4 --spill . SAMPLES/mesh.vtu out.gtn", "pack -q -f SAMPLES/run.pvd out.gtn")


def run(*command, **options):
    """Runs a command to its end; a timeout is an exception."""
    return subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", check=False, env=ENVIRONMENT,
                          **options)


class Soak:
    def __init__(self, build, folder):
        self.state, self.folder = build / "soak", folder
        self.gtn, self.damager = (build / "asan-ubsan" / "bin" / name for name in ("gtn", "damageFile"))
        self.fuzzers = [file for file in sorted((build / "fuzz" / "bin").glob("fuzz-*"))
                        if not re.match("fuzz-regression|fuzz-Driver", file.name)]
        self.corpora = build / "fuzz" / "Testing" / "Fuzz" / "Corpus"
        golden = (ROOT / "Testing" / "Data" / "Golden").rglob("*")
        self.seeds = [file for file in sorted(golden) if file.suffix in COMMANDS]
        self.counts = collections.Counter()
        self.lock = threading.Lock()

    def prepare(self):
        """Runs each writer undisturbed, for its file and the seconds that it takes."""
        for file in (self.gtn, self.damager, *(self.fuzzers or [self.corpora])):
            if not file.exists():
                sys.exit(f"soak: {file} is missing; Utilities/setup.sh soak builds it")
        run(sys.executable, "-B", ROOT / "Testing" / "CLI" / "gatunSamples.py", self.folder / "samples")
        self.written = {}
        for writer in WRITERS:
            start = time.monotonic()
            result = run(*self.gtn_command(writer), cwd=self.folder)
            seconds = time.monotonic() - start
            if result.returncode or run(self.gtn, "verify", "-q", "out.gtn", cwd=self.folder).returncode:
                sys.exit(f"soak: gtn {writer}: {result.stdout}")
            self.written[writer] = (self.folder / "out.gtn").read_bytes(), seconds

    def gtn_command(self, words, damaged=None):
        words = words.replace("SAMPLES", str(self.folder / "samples")).split()
        return [self.gtn, *(damaged if word == "IN" else word for word in words)]

    def count(self, what, number=1):
        with self.lock:
            self.counts[what] += number

    def keep(self, what, log, files):
        """Counts a finding, and keeps the first of its kind."""
        folder = self.state / "findings" / re.sub(r"\W+", "-", what)
        with self.lock:
            self.counts[f"findings: {what}"] += 1
            if folder.exists():
                return
            folder.mkdir(parents=True)
        print(f"FINDING: {what} ({folder})", flush=True)
        (folder / "log.txt").write_text(f"{what}\n\n{log}\n", encoding="utf-8")
        for file in files:
            shutil.copy(file, folder)

    def fuzz(self, program, folder, end):
        target = program.name[len("fuzz-"):]
        found = self.state / "corpus" / target
        found.mkdir(parents=True, exist_ok=True)
        seconds = max(1, int(end - time.monotonic()))
        result = run(program, f"-max_total_time={seconds}", f"-max_len={16384 if target in LARGE_INPUTS else 2048}",
                     f"-timeout={TIMEOUT}", "-rss_limit_mb=2048", "-malloc_limit_mb=1024", "-print_final_stats=1",
                     f"-artifact_prefix={folder}/", found, self.corpora / target)
        executed = re.search(r"number_of_executed_units: *(\d+)", result.stdout)
        self.count("runs of fuzz targets", int(executed[1]) if executed else 0)
        if result.returncode:
            self.keep(f"{program.name}: exit code {result.returncode}", result.stdout, folder.iterdir())

    def damage(self, folder, end):
        while time.monotonic() < end:
            seed = random.choice(self.seeds)
            damaged = folder / f"damaged{seed.suffix}"
            self.write_damaged(seed, damaged)
            for words in COMMANDS[seed.suffix]:
                self.try_command(words, damaged)

    def write_damaged(self, seed, damaged):
        """Truncated, with wrong bits, or changed with checksums that are right again."""
        if seed.suffix == ".gtn" and random.random() < 0.5:
            run(self.damager, seed, damaged, random.randrange(1 << 31)).check_returncode()
            return
        data = bytearray(seed.read_bytes())
        if random.random() < 0.3:
            del data[random.randrange(len(data)):]
        for _ in range(random.choice((1, 1, 4, 64)) if data else 0):
            data[random.randrange(len(data))] ^= 1 << random.randrange(8)
        damaged.write_bytes(data)

    def try_command(self, words, damaged):
        self.count("runs with a damaged file")
        try:
            result = run(*self.gtn_command(words, damaged.name), cwd=damaged.parent, timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            self.keep(f"gtn {words} hangs", "", [damaged])
            return
        message = re.search(rf"^gtn: {re.escape(damaged.name)}[:,] .", result.stdout, re.MULTILINE)
        if result.returncode not in (0, 1) or REPORT.search(result.stdout) or result.returncode == 1 and not message:
            self.keep(f"gtn {words}: exit code {result.returncode}", result.stdout, [damaged])
        self.count("of them refused", result.returncode == 1)

    def kill(self, folder, end):
        out = folder / "out.gtn"
        while time.monotonic() < end:
            before, writer = random.sample(WRITERS, 2)
            old, (new, seconds) = self.written[before][0], self.written[writer]
            out.write_bytes(old)
            process = subprocess.Popen(self.gtn_command(writer), cwd=folder, env=ENVIRONMENT,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(seconds * random.uniform(0, 1.1))
            process.kill()
            done = process.wait() == 0
            if not done and process.returncode != -signal.SIGKILL:
                self.keep(f"gtn {writer}: exit code {process.returncode}", "", [])
            self.count("writers killed", not done)
            if out.read_bytes() not in ((new,) if done else (old, new)):
                self.keep(f"gtn {writer}, killed: neither the old file nor the new one", "", [out])
            for other in set(folder.iterdir()) - {out}:
                # A complete file gets a name of its own before it replaces the old one.
                if not other.name.startswith("out.gtn.part-") or other.read_bytes() != new:
                    self.keep(f"gtn {writer}, killed: {other.name} is left over", "", [other])
                other.unlink()

    def work(self, turns, end):
        """Takes turns until the time is over."""
        while time.monotonic() < end:
            with self.lock:
                turn = next(turns)
            with tempfile.TemporaryDirectory(dir=self.folder) as folder:
                turn(pathlib.Path(folder), min(end, time.monotonic() + TURN))

    def run(self, seconds):
        turns = itertools.cycle([turn for program in self.fuzzers for turn in
                                 (self.damage, self.kill, functools.partial(self.fuzz, program))])
        end = time.monotonic() + seconds
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            workers = [pool.submit(self.work, turns, end) for _ in range(os.cpu_count())]
            for worker in workers:
                worker.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("minutes", nargs="?", type=float, default=120, help="how long to try (default: 120)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build",
                        help="the folder of the builds fuzz and asan-ubsan")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="soak-") as folder:
        soak = Soak(options.build.resolve(), pathlib.Path(folder))
        soak.prepare()
        soak.run(60 * options.minutes)
    for what, number in sorted(soak.counts.items()):
        print(f"{number:12,} {what}")
    return 1 if any(what.startswith("findings") for what in soak.counts) else 0


if __name__ == "__main__":
    sys.exit(main())
