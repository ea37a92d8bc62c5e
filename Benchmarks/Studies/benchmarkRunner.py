# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the programs that measure, and records where and when."""

import argparse
import datetime
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import displays


def make_parser(description, page):
    """The arguments that all programs that write a page have in common."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--programs", type=pathlib.Path, required=True,
                        help="the folder of gatunBenchmarks and gtn")
    parser.add_argument("--out", type=pathlib.Path, required=True,
                        help=f"the folder for {page}.md and the folder {page}")
    modes = parser.add_mutually_exclusive_group()
    modes.add_argument("--quick", dest="mode", action="store_const", const="quick",
                       help="small meshes, few rounds")
    modes.add_argument("--smoke", dest="mode", action="store_const", const="smoke",
                       help="tiny meshes, to check that everything runs")
    parser.add_argument("--report", action="store_true",
                        help="measure nothing, write the page and its plots again")
    parser.set_defaults(mode="full")
    return parser


def run_page(parser, page, measure, write):
    """Measures, or with --report reads the results again, and writes a page. measure(runner, options)
    returns the results, and write(results, folder) writes the page. Returns the options."""
    options = parser.parse_args()
    folder = options.out / page
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    if options.report:
        results = json.loads(raw.read_text(encoding="utf-8"))
    else:
        with tempfile.TemporaryDirectory(prefix=f"gatun-{page}-") as work:
            results = measure(Runner(options.programs, pathlib.Path(work)), options)
        raw.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    write(results, options.out)
    print(f"The results are in {options.out / page}.md and {folder}")
    return options


class Runner:
    """Runs the programs and prints what it does."""

    def __init__(self, programs, work, images=None):
        """work: a scratch folder; images: the folder for the images of the page."""
        self.programs = programs
        self.work = work
        self.images = images
        self.start = time.monotonic()

    def path(self, *parts):
        path = self.work.joinpath(*parts)
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def folder(self, name):
        path = self.work / name
        path.mkdir(parents=True, exist_ok=True)
        return path

    def command(self, program, *arguments):
        return [str(self.programs / program), *map(str, arguments)]

    def run(self, program, *arguments, prefix=(), environment=None):
        command = [*prefix, *self.command(program, *arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False,
                              env={**os.environ, **(environment or {})})
        if done.returncode != 0:
            sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {' '.join(command)} failed")
        return done.stdout

    def say(self, text):
        print(f"{time.monotonic() - self.start:7.1f} s  {text}", flush=True)

    def case(self, *arguments, threads=0, window=False):
        """Runs a case of gatunBenchmarks. A case with a window gets a display. Mesa's software
        rasterizer gets as many threads as the case (0: none but its own)."""
        self.say(" ".join(map(str, arguments)) + (f" ({threads} threads)" if threads else ""))
        environment = {"LP_NUM_THREADS": str(threads if threads > 1 else 0)} if window else None
        out = self.run("gatunBenchmarks", "--threads", threads, *arguments,
                       prefix=displays.prefix() if window else (), environment=environment)
        return json.loads(out) if out else None


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown"


def commit():
    """The commit of the source tree; "unknown" outside of a clone, or without git."""
    try:
        done = subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=7"],
                              cwd=pathlib.Path(__file__).parent, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True, check=False)
    except FileNotFoundError:
        return "unknown"
    return done.stdout.strip() or "unknown"


def machine(runner):
    known = runner.case("machine")
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    known.update(processor=processor(), processors=len(os.sched_getaffinity(0)),
                 memory=memory, system=f"{os.uname().sysname} {os.uname().release}",
                 python=sys.version.split()[0], loadBefore=os.getloadavg(),
                 date=datetime.date.today().isoformat(), commit=commit())
    return known
