#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Compares the hierarchy of a mesh that is packed in pieces with that of the whole mesh.

    PYTHONPATH=build/release/lib/python3/dist-packages Benchmarks/hierarchy.py --gtn build/release/bin/gtn
    Benchmarks/hierarchy.py --edge 149 --pieces 64      20 million tetrahedra

The mesh is a cube of jittered cubes, six tetrahedra each, with waves and a thin curved front. Prints what packing
takes, without and with a hierarchy, as medians of interleaved rounds; and the root mean square error of the field at
the points of the mesh with a part of the points left out, by both hierarchies.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "Examples" / "Python"))

import gatun  # noqa: E402
import numpy as np  # noqa: E402
from shapes import make_cube  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkProbeFilter  # noqa: E402

RATIOS = (0.5, 0.9, 0.98, 0.995)


def make_mesh(edge):
    points, tets = make_cube(edge)
    low, high = points.min(axis=0), points.max(axis=0)
    inside = ((points > low) & (points < high)).astype(float)  # the cube stays one
    jitter = np.random.default_rng(1).uniform(-0.25, 0.25, points.shape)
    points = (points + jitter * inside * (high - low) / edge).astype(np.float32)
    x, y, z = ((points - low) / (high - low)).T
    field = np.sin(7 * x) * np.cos(5 * y) + np.tanh(20 * (z - 0.5 - 0.2 * np.sin(4 * x)))
    return gatun.Mesh(points, tets, {"field": field.astype(np.float32)})


def run(*command):
    """Wall and CPU seconds, and the most memory in MiB."""
    start = time.perf_counter()
    process = subprocess.Popen(list(map(str, command)))
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(process.returncode)
    return time.perf_counter() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measure(mesh, path, ratio):
    """The number of tetrahedra, and the error of the field."""
    less = gatun.read(path, ratio=ratio)
    probe = vtkProbeFilter()
    probe.SetInputData(mesh)
    probe.SetSourceData(less)
    probe.PassPointArraysOff()
    probe.Update()
    found = probe.GetOutput().GetPointData()
    is_inside = vtk_to_numpy(found.GetArray("vtkValidPointMask")) > 0
    difference = vtk_to_numpy(found.GetArray("field")) - vtk_to_numpy(mesh.GetPointData().GetArray("field"))
    return less.GetNumberOfCells(), float(np.sqrt(np.mean(difference[is_inside] ** 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--edge", type=int, default=94, help="cubes along an edge (default: 94, 5 million tetrahedra)")
    parser.add_argument("--pieces", type=int, default=16)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--gtn", default="gtn", help="the program (default: that in PATH)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        plain, mesh = (os.path.join(folder, name) for name in ("plain.gtn", "mesh.vtu"))
        print(f"{gatun.write(make_mesh(arguments.edge), plain):,} bytes without a hierarchy")
        run(arguments.gtn, "unpack", "-q", plain, mesh)
        ways = {
            "whole": [],
            "whole, hierarchy": ["--hierarchy"],
            "pieces": ["--pieces", arguments.pieces],
            "pieces, hierarchy": ["--pieces", arguments.pieces, "--hierarchy"],
        }
        paths = {name: os.path.join(folder, f"{i}.gtn") for i, name in enumerate(ways)}
        taken = {name: [] for name in ways}
        for _ in range(arguments.rounds):
            for name, options in ways.items():
                taken[name].append(run(arguments.gtn, "pack", "-qf", *options, mesh, paths[name]))
        print(f"{'':20}{'seconds':>10}{'CPU':>8}{'MiB':>8}{'bytes':>14}")
        for name, rounds in taken.items():
            wall, cpu, memory = (statistics.median(column) for column in zip(*rounds))
            print(f"{name:20}{wall:10.2f}{cpu:8.2f}{memory:8.0f}{os.path.getsize(paths[name]):14,}")
        source = gatun.read(plain)
        print(f"{'left out':10}{'tetrahedra':>24}{'RMS error':>24}{'ratio':>8}")
        for ratio in RATIOS:
            (tets, error), (part_tets, part_error) = (
                measure(source, paths[name], ratio) for name in ("whole, hierarchy", "pieces, hierarchy")
            )
            print(f"{ratio:<10}{tets:12,}{part_tets:12,}{error:12.3e}{part_error:12.3e}{part_error / error:8.3f}")


if __name__ == "__main__":
    main()
