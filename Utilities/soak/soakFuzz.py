# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Fuzz targets in turn, each with the inputs that it has found before."""

import os
import re

from soakContext import ROOT, TIMEOUT, Finding, Task, describe, run_process

GOAL = 1000000  # executions of each parser
LARGE = {"File": 16384, "Sections": 16384, "HartleyFile": 8192}  # bytes of an input, else 2048


def targets():
    """The names of all targets, but for that which checks the harness."""
    names = (path.stem[len("fuzz"):] for path in (ROOT / "Testing" / "Fuzz").glob("fuzz*.cxx"))
    return sorted(name for name in names if (ROOT / "Testing/Fuzz/Corpus" / f"{name}.zip").exists()
                  and name != "Driver")


class Fuzz(Task):
    """One target. A slice is longer until the target has reached its goal."""

    kind = "fuzz"

    def __init__(self, context, target):
        super().__init__(context)
        self.target = target
        self.program = context.program("fuzz", f"fuzz-{target}")
        self.coverage = 0

    def name(self):
        return f"fuzz {self.target}"

    def find_missing(self):
        programs = (self.program, self.context.program("fuzz", "makeCorpus"))
        return next((program for program in programs if not program.exists()), None)

    def prepare(self):
        """Seeds of the present format, which makeCorpus writes for all targets at once."""
        seeds = self.context.scratch / "seeds"
        with self.context.lock:
            if not seeds.exists():
                run = run_process([self.context.program("fuzz", "makeCorpus"), seeds])
                if run.code != 0:
                    raise Finding(f"makeCorpus: {describe(run)}", log=run.output)
        self.seeds = seeds / self.target

    def run(self, seconds):
        if not self.context.is_short:
            seconds *= 1.5 if self.counts["executions"] < GOAL else 0.5
        corpus = self.context.build / "fuzz" / "Testing" / "Fuzz" / "Corpus" / self.target
        found = self.context.state / "found" / self.target
        found.mkdir(parents=True, exist_ok=True)
        crashes = self.context.folder(f"fuzz-{self.target}")
        folders = [folder for folder in (found, corpus, self.seeds) if folder.is_dir()]
        before = sum(len(os.listdir(folder)) for folder in folders)
        run = run_process(
            [self.program, f"-max_total_time={max(1, int(seconds))}",
             f"-max_len={LARGE.get(self.target, 2048)}", "-entropic=0", "-timeout=600",
             "-rss_limit_mb=2048", "-malloc_limit_mb=1024", "-print_final_stats=1", "-reload=0",
             f"-seed={self.random.randrange(1, 1 << 31)}", f"-artifact_prefix={crashes}/",
             *folders],
            environment={**os.environ, "ASAN_OPTIONS": "malloc_context_size=3:quarantine_size_mb=16"},
            timeout=4 * TIMEOUT)
        executed = re.search(r"stat::number_of_executed_units:\s*(\d+)", run.output)
        covered = re.findall(r"cov: (\d+)", run.output)
        # Inputs of before are executed again at the beginning of each slice.
        self.counts["executions"] += max(0, int(executed[1]) - before) if executed else 0
        self.coverage = max(self.coverage, int(covered[-1]) if covered else 0)
        if run.code != 0 or run.timeout:
            raise Finding(f"fuzz-{self.target}: {describe(run)}", sorted(crashes.iterdir()),
                          run.output[-20000:])

    def results(self):
        return {**super().results(), "coverage": self.coverage}
