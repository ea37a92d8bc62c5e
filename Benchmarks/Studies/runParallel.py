#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Several processes write one file: the bytes that they send, their memory, and the time beside .pvtu files."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import benchmarkRunner
import parallelReport

MODES = {
    "full": {"tets": 4000000, "processes": (1, 2, 4), "rounds": 5},
    "quick": {"tets": 400000, "processes": (1, 2, 4), "rounds": 2},
    "smoke": {"tets": 3000, "processes": (1, 2), "rounds": 1},
}
PROGRAM = pathlib.Path(__file__).parent / "parallelWrite.py"
TIMEOUT = 900


def launcher(processes, threads):
    """Starts a program in so many processes. Open MPI would bind each one to a core."""
    found = shutil.which("mpiexec") or shutil.which("mpirun")
    version = subprocess.run([found, "--version"], stdout=subprocess.PIPE, text=True, check=False).stdout
    if "Open MPI" not in version and "OpenRTE" not in version:
        return ["env", f"VTK_SMP_MAX_THREADS={threads}", found, "-n", str(processes)]
    return ["env", f"VTK_SMP_MAX_THREADS={threads}", "OMPI_ALLOW_RUN_AS_ROOT=1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "OMPI_MCA_btl_vader_single_copy_mechanism=none",
            found, "--oversubscribe", "--bind-to", "none", "-n", str(processes)]


def run(command):
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, text=True,
                          timeout=TIMEOUT, check=False)
    if done.returncode != 0:
        sys.exit(f"runParallel: {' '.join(map(str, command))} failed")
    return done.stdout


def size_of(path, processes):
    """The bytes of a file and of those that belong to it."""
    if path.suffix == ".gtn":
        return path.stat().st_size
    parts = [path.with_name(f"{path.stem}_{process}.vtu") for process in range(processes)]
    return sum(file.stat().st_size for file in [path, *parts])


def write_once(runner, folder, form, processes):
    threads = max(1, len(os.sched_getaffinity(0)) // processes)
    out = runner.path(f"out-{processes}.{form}")
    printed = run([*launcher(processes, threads), sys.executable, PROGRAM, "write", runner.programs,
                   folder, form, out])
    line = next(line for line in printed.splitlines() if line.startswith("{"))
    return {**json.loads(line), "threads": threads, "bytes": size_of(out, processes)}


def measure_partition(runner, mesh, mode, processes, partition):
    folder = runner.folder(f"parts-{processes}-{partition}")
    run([sys.executable, PROGRAM, "split", mesh, folder, processes, partition])
    rounds = []
    for number in range(mode["rounds"] if partition == "compact" else 1):
        runner.say(f"{processes} processes, {partition} parts, round {number + 1}")
        rounds.append({form: write_once(runner, folder, form, processes) for form in ("gtn", "pvtu")})
    runner.run("gtn", "verify", "-q", runner.path(f"out-{processes}.gtn"), mesh)
    shutil.rmtree(folder)
    return {"processes": processes, "partition": partition, "rounds": rounds}


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    mesh = runner.path("mesh.vtu")
    kind = "delaunay" if results["machine"]["tetgen"] else "lattice"
    runner.run("gatunBenchmarks", "make", kind, mode["tets"], mesh)
    file = runner.path("whole.gtn")
    runner.run("gtn", "pack", "-q", "-f", mesh, file)
    results["kind"] = kind
    results["tets"] = json.loads(runner.run("gtn", "info", "--json", file))["tets"]
    results["bytes"] = file.stat().st_size
    results["cases"] = [measure_partition(runner, mesh, mode, processes, partition)
                        for processes in mode["processes"] for partition in ("compact", "scattered")
                        if processes > 1 or partition == "compact"]
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


if __name__ == "__main__":
    sys.exit(0 if benchmarkRunner.run_page(
        benchmarkRunner.make_parser(__doc__, parallelReport.PAGE), parallelReport.PAGE, measure,
        parallelReport.write) else 1)
