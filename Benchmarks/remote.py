#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Counts the requests and bytes by which a part of a file on a web server is read.

    PYTHONPATH=build/release/lib/python3/dist-packages Benchmarks/remote.py --gtn build/release/bin/gtn
    Benchmarks/remote.py --edge 80 --steps 16 --file /tmp/large.gtn      some 1 GB

The server has the loopback address. The file is made unless it is there: a cube of tetrahedra with a hierarchy,
two coarser meshes and noise, which is the hardest to compress. Prints a table.
"""

import argparse
import mmap
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(ROOT / "Testing" / "Python"), str(ROOT / "Examples" / "Python")]
os.environ["no_proxy"] = "*"

import gatun  # noqa: E402
import numpy as np  # noqa: E402
from gatunServer import Server  # noqa: E402
from shapes import make_cube  # noqa: E402

ARRAYS = 16


def make_file(path, edge, steps):
    points, tets = make_cube(edge)
    random = np.random.default_rng(1)
    with gatun.Writer(path, levels=2) as writer:
        writer.add_mesh(points, tets)
        for step in range(steps):
            arrays = {f"noise{i}": random.normal(size=len(points)) for i in range(ARRAYS - 1)}
            arrays["x"] = points[:, 0] + 0.01 * step
            writer.write_step(point_data=arrays, time=float(step))


def count(server, work):
    """Requests, bytes, seconds."""
    log = server.http.log
    log.clear()
    start = time.perf_counter()
    work(server.url)
    seconds = time.perf_counter() - start
    size = len(server.http.data)
    ranges = [tuple(map(int, headers["Range"][6:].split("-"))) for _, headers in log]
    return len(log), sum(min(last + 1, size) - first for first, last in ranges), seconds


def with_file(work):
    """A function of an address that works with the file there."""

    def run(address):
        with gatun.open(address) as file:
            work(file)

    return run


def list_python():
    box = (-1, -0.9) * 3
    return [
        ("description", lambda file: (file.info, file.arrays, file.times)),
        ("coarsest mesh", lambda file: file.read(level=2, arrays=[])),
        ("coarsest mesh, one array", lambda file: file.read(level=2, arrays="noise0")),
        ("box of 1/8000, one array", lambda file: file.read(box=box, arrays="noise0")),
        ("isosurface", lambda file: file.contour("x", 0.9, arrays=[])),
        ("mesh, one array", lambda file: file.read(arrays="noise0")),
    ]


def list_gtn(program, folder):
    def run(*arguments):
        return lambda address: subprocess.run(
            [program, *(address if part == "IN" else part for part in arguments)],
            stdout=subprocess.DEVNULL, check=True)

    def out(name):
        return os.path.join(folder, name)

    return [
        ("description", run("info", "IN")),
        ("coarsest mesh, all arrays", run("simplify", "-q", "-f", "--ratio", "0.97", "IN", out("a.vtu"))),
        ("isosurface", run("contour", "-q", "-f", "--array", "x", "--value", "0.9", "IN", out("a.vtp"))),
        ("isosurface of the coarsest mesh", run("contour", "-q", "-f", "--array", "x", "--value", "0.9",
                                                "--ratio", "0.97", "IN", out("a.vtp"))),
        ("image of one array", run("render", "-q", "-f", "--array", "x", "--size", "320x240", "IN", out("a.png"))),
        ("mesh, one array", run("unpack", "-q", "-f", "--arrays", "noise0", "--compressor", "none", "IN",
                                out("a.vtu"))),
    ]


def report(server, program, work):
    print("| what | by | requests | bytes | part of the file | seconds |\n|---|---|---|---|---|---|")
    size = len(server.http.data)
    cases = [(name, "Python", with_file(case)) for name, case in list_python()]
    cases += [(name, "gtn", case) for name, case in list_gtn(program, work)] if program else []
    for name, by, case in cases:
        requests, amount, seconds = count(server, case)
        print(f"| {name} | {by} | {requests} | {amount:,} | {100 * amount / size:.2f} % | {seconds:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--edge", type=int, default=40, help="points along an edge of the cube")
    parser.add_argument("--steps", type=int, default=2, help="number of time steps")
    parser.add_argument("--file", help="the file to make, or to use if it is there")
    parser.add_argument("--gtn", help="the program gtn, to count what it does, too")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        path = options.file or os.path.join(work, "remote.gtn")
        if not os.path.exists(path):
            make_file(path, options.edge, options.steps)
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            print(f"file of {len(data):,} bytes\n")
            with Server(data, name="remote.gtn") as server:
                report(server, options.gtn and os.path.abspath(options.gtn), work)


if __name__ == "__main__":
    main()
