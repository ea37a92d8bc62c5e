# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the programs that measure, and says where."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

import displays


def make_parser(description, page):
    """Arguments that all programs which write a page have in common."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--programs", type=pathlib.Path, required=True,
                        help="the folder of gatunBenchmarks and gtn")
    parser.add_argument("--out", type=pathlib.Path, required=True,
                        help=f"where {page}.md and the folder {page} go")
    modes = parser.add_mutually_exclusive_group()
    modes.add_argument("--quick", dest="mode", action="store_const", const="quick",
                       help="small meshes, few rounds")
    modes.add_argument("--smoke", dest="mode", action="store_const", const="smoke",
                       help="tiny meshes, to see whether it runs at all")
    parser.add_argument("--report", action="store_true",
                        help="measure nothing, make the page and its pictures anew")
    parser.set_defaults(mode="full")
    return parser


class Runner:
    """Runs the programs and prints what it does."""

    def __init__(self, programs, work, pictures=None):
        """Work: a folder for what is not kept; pictures: one for those of the page."""
        self.programs = programs
        self.work = work
        self.pictures = pictures
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
        """A case of gatunBenchmarks. One with a window is given a display, and Mesa's rasterizer,
        where OpenGL is software, as many threads as the case (0: none besides its own)."""
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


def machine(runner):
    known = runner.case("machine")
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    known.update(processor=processor(), processors=len(os.sched_getaffinity(0)),
                 memory=memory, system=f"{os.uname().sysname} {os.uname().release}",
                 python=sys.version.split()[0], loadBefore=os.getloadavg())
    return known
