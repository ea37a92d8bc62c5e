#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes larger than memory: packed piece by piece, verified, drawn and contoured with little memory."""

import json
import os
import pathlib
import subprocess
import sys
import time

import benchmarkRunner
import memoryLimit
import partsReport
import scalingModel

NONE = 1 << 20

# Cubes along each axis, of six tetrahedra each, and pieces. The mesh to compare is also packed as a whole.
# The limits in MiB are for packing and for using the file.
MODES = {
    "full": {"large": ((203, 50), (322, 200)), "compared": (94, (2, 10, 47)), "limits": (1024, 512),
             "divided": 203},
    "quick": {"large": ((60, 10),), "compared": (30, (2, 10)), "limits": (1024, 512), "divided": 60},
    "smoke": {"large": ((8, 4),), "compared": (6, (2, 3)), "limits": (NONE, NONE), "divided": 8},
}
FOLDER = pathlib.Path(__file__).parent
TIMEOUT = 3600
CHUNK = scalingModel.USUAL_CHUNK  # tetrahedra, at most: that of small meshes, in all files, so that they can be compared

# Runs a command and tells the seconds and the peak memory.
MEASURE = """
import json, resource, subprocess, sys, time
start = time.monotonic()
done = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
print(json.dumps({"seconds": time.monotonic() - start,
                  "peak": resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024}))
sys.exit(done.returncode)
"""


def limited(runner, limiter, what, command, limit):
    runner.say(f"{what}, {limit} MiB")
    out, why = limiter.run([str(part) for part in command], limit * 2**20, TIMEOUT)
    return {"what": what, "why": why} if out is None else {"what": what, **json.loads(out)}


def write_command(runner, file, cubes, pieces):
    return [sys.executable, FOLDER / "largeMesh.py", runner.programs, file, cubes, pieces, CHUNK]


def describe(runner, file):
    info = json.loads(runner.run("gtn", "info", "--json", file))
    return {"tets": info["tets"], "chunks": info["chunks"], "bytes": file.stat().st_size}


def measure_large(runner, limiter, limits, cubes, pieces):
    file = runner.path("large.gtn")
    steps = [limited(runner, limiter, f"pack {6 * cubes**3:,} tetrahedra in {pieces} pieces",
                     write_command(runner, file, cubes, pieces), limits[0])]
    if "why" in steps[0]:
        return {"pieces": pieces, "steps": steps}
    for what, *arguments in (("verify", "verify", "-q", file),
                             ("render", "render", "-q", "-f", file, runner.path("large.png")),
                             ("contour", "contour", "-q", "-f", "--value", 0.5, file,
                              runner.path("large.vtp"))):
        command = [sys.executable, "-c", MEASURE, *runner.command("gtn", *arguments)]
        steps.append(limited(runner, limiter, what, command, limits[1]))
    result = {"pieces": pieces, "steps": steps, **describe(runner, file)}
    file.unlink()
    return result


def measure_compared(runner, cubes, numbers):
    results = []
    for pieces in (1, *numbers):
        file = runner.path("compared.gtn")
        step = limited(runner, memoryLimit.address_space(), f"pack in {pieces} pieces",
                       write_command(runner, file, cubes, pieces), NONE)
        if "why" in step:
            sys.exit(f"runParts: the writer {step['why']}")
        results.append({"pieces": pieces, **step, **describe(runner, file)})
        file.unlink()
    return results


def measure_divided(runner, limiter, limit, cubes):
    """One .vtu file, in pieces with a limit and as a whole without."""
    file, packed = runner.path("large.vtu"), runner.path("divided.gtn")
    runner.say(f"one file of {6 * cubes**3:,} tetrahedra")
    subprocess.run([sys.executable, FOLDER / "largeFile.py", file, str(cubes)], check=True)
    result = {"rawBytes": file.stat().st_size, "steps": []}
    for what, way, most, arguments in (
            ("in pieces on the disk", limiter, limit, ["--memory", limit, "--pieces", 4]),
            ("as a whole", memoryLimit.address_space(), NONE, [])):
        command = [sys.executable, "-c", MEASURE,
                   *runner.command("gtn", "pack", "-q", "-f", *arguments, file, packed)]
        step = limited(runner, way, what, command, most)
        if "why" not in step:
            step |= describe(runner, packed)
        result["steps"].append(step)
    file.unlink()
    return result


def measure(runner, options):
    mode = MODES[options.mode]
    limiter = memoryLimit.address_space() if options.mode == "smoke" else memoryLimit.best()
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "limiter": limiter.name,
               "limits": mode["limits"]}
    results["compared"] = measure_compared(runner, *mode["compared"])
    results["large"] = [measure_large(runner, limiter, mode["limits"], *one) for one in mode["large"]]
    results["divided"] = measure_divided(runner, limiter, mode["limits"][0], mode["divided"])
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


if __name__ == "__main__":
    sys.exit(0 if benchmarkRunner.run_page(
        benchmarkRunner.make_parser(__doc__, partsReport.PAGE), partsReport.PAGE, measure,
        partsReport.write) else 1)
