#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of 10^9 and 10^12 cells on up to 10,000 ranks, by a model. Measures what the other studies do not:
the tables of files with many chunks, and the messages of ranks that write a file. Needs Open MPI."""

import json
import os
import shutil
import subprocess
import sys
import time

import benchmarkRunner
import runParallel
import scalingReport

SKIPPED = 125

# Tetrahedra and chunk sizes of the files that are opened; tetrahedra, ranks and chunk sizes of those that
# several ranks write. 0: the usual chunks. Differences of the fine ones are what a chunk takes. many: cubes
# along an edge and pieces of a mesh in chunks of 64 tetrahedra.
MODES = {
    "full": {"tets": 6400000, "chunks": (64, 256, 1024, 0), "rounds": 5,
             "parallel": 2000000, "ranks": (2, 4, 8), "fine": (1024, 256), "fineRounds": 2,
             "many": (220, 16)},
    "quick": {"tets": 640000, "chunks": (64, 256, 1024, 0), "rounds": 3,
              "parallel": 640000, "ranks": (2, 4), "fine": (1024, 256), "fineRounds": 1,
              "many": (50, 4)},
    "smoke": {"tets": 20000, "chunks": (64, 256, 0), "rounds": 1,
              "parallel": 20000, "ranks": (2, 4), "fine": (256, 64), "fineRounds": 1,
              "many": (8, 2)},
}
LARGE = runParallel.PROGRAM.with_name("largeMesh.py")
VIEWS = {"close": ("--zoom", "40", "--opacity", "1000"), "whole": ("--opacity", "1000")}
TABLES = runParallel.PROGRAM.with_name("measureTables.py")


def ask_tables(*arguments):
    return json.loads(runParallel.run([sys.executable, TABLES, *arguments]))


def measure_tables(runner, mode):
    """Files of one mesh with chunks of several sizes."""
    mesh, file = runner.path("tables.vtu"), runner.path("tables.gtn")
    runner.run("gatunBenchmarks", "make", "lattice", mode["tets"], mesh)
    results = []
    for chunk in mode["chunks"]:
        runner.say(f"tables of chunks of {chunk or 'the usual number of'} tetrahedra")
        runner.run("gtn", "pack", "-q", "-f", *(["--chunk", chunk] if chunk else []), mesh, file)
        info = json.loads(runner.run("gtn", "info", "--json", file))
        results.append({"chunk": chunk, "chunks": info["chunks"], "tets": info["tets"],
                        "opened": [ask_tables("open", runner.programs, file) for _ in range(mode["rounds"])],
                        "sections": ask_tables("count", file), **ask_tables("groups", file)})
        file.unlink()
    mesh.unlink()
    return results


def measure_many(runner, mode):
    """A file of very many chunks, made in pieces: how it is opened and drawn."""
    cubes, pieces = mode["many"]
    file, out = runner.path("many.gtn"), runner.path("many.png")
    runner.say("a file of many chunks")
    runParallel.run([sys.executable, LARGE, runner.programs, file, cubes, pieces, 64])
    info = json.loads(runner.run("gtn", "info", "--json", file))
    result = {"chunks": info["chunks"], "tets": info["tets"], "bytes": file.stat().st_size,
              "opened": [ask_tables("open", runner.programs, file) for _ in range(mode["rounds"])],
              "images": {name: [ask_tables("image", runner.programs, file, out, *view)
                                for _ in range(mode["rounds"] if name == "close" else 1)]
                         for name, view in VIEWS.items()}}
    file.unlink()
    return result


def is_open_mpi():
    found = shutil.which("mpiexec") or shutil.which("mpirun")
    if not found:
        return False
    version = subprocess.run([found, "--version"], stdout=subprocess.PIPE, text=True, check=False).stdout
    return "Open MPI" in version or "OpenRTE" in version


def count_messages(path, ranks):
    """What Open MPI's monitoring has seen: for each rank the point-to-point messages to each one and their
    bytes, its broadcasts and their bytes to all of them, and its other collective calls."""
    counted = []
    if not path.with_name(f"{path.name}.0.prof").exists():
        sys.exit("runScaling: Open MPI has counted no messages; it has no component pml_monitoring")
    for rank in range(ranks):
        one = {"to": [0] * ranks, "bytes": [0] * ranks, "broadcasts": 0, "broadcastBytes": 0,
               "collectives": 0}
        for line in path.with_name(f"{path.name}.{rank}.prof").read_text(encoding="ascii").splitlines():
            parts = line.split("\t")
            if parts[0] == "E":
                one["to"][int(parts[2])] = int(parts[4].split()[0])
                one["bytes"][int(parts[2])] = int(parts[3].split()[0])
            elif parts[0] == "O2A":
                one["broadcastBytes"] += int(parts[2].split()[0])
                one["broadcasts"] += int(parts[3].split()[0])
            elif parts[0] == "A2A":
                one["collectives"] += int(parts[3].split()[0])
        counted.append(one)
    return counted


def write_once(runner, folder, ranks, chunk):
    out, seen = runner.path("written.gtn"), runner.path("seen", "messages")
    printed = runParallel.run([
        "env", "OMPI_MCA_mpi_yield_when_idle=1", "OMPI_MCA_pml_monitoring_enable=2",
        "OMPI_MCA_pml_monitoring_enable_output=3", f"OMPI_MCA_pml_monitoring_filename={seen}",
        *runParallel.launcher(ranks, 1), sys.executable, runParallel.PROGRAM, "write", runner.programs, folder,
        "gtn", out, chunk])
    line = next(line for line in printed.splitlines() if line.startswith("{"))
    info = json.loads(runner.run("gtn", "info", "--json", out))
    return {**json.loads(line), "ranks": ranks, "chunk": chunk, "chunks": info["chunks"],
            "tets": info["tets"], "messages": count_messages(seen, ranks)}


def measure_ranks(runner, mode):
    """One mesh, written by several ranks with the usual chunks and with small ones."""
    mesh = runner.path("parallel.vtu")
    runner.run("gatunBenchmarks", "make", "lattice", mode["parallel"], mesh)
    results = []
    for ranks in mode["ranks"]:
        folder = runner.folder(f"parts-{ranks}")
        runParallel.run([sys.executable, runParallel.PROGRAM, "split", mesh, folder, ranks, "compact"])
        for chunk in (0, *mode["fine"]):
            for number in range(mode["fineRounds"] if chunk else 1):
                runner.say(f"{ranks} ranks, chunks of {chunk or 'the usual number of'} tetrahedra, "
                           f"round {number + 1}")
                results.append(write_once(runner, folder, ranks, chunk))
        shutil.rmtree(folder)
    return results


def read_before(options):
    """The tables of an earlier version, which the page compares with, if the results have them."""
    raw = options.out / scalingReport.PAGE / "results.json"
    return json.loads(raw.read_text(encoding="utf-8")).get("before") if raw.exists() else None


def measure(runner, options):
    if not is_open_mpi():
        print("runScaling: messages are counted by the monitoring of Open MPI, which is missing")
        sys.exit(SKIPPED)
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    before = read_before(options)
    if options.before or before:
        results["before"] = before
    results["tables"] = measure_tables(runner, mode)
    if options.before:
        results["before"] = {"machine": results["machine"], "tables": results["tables"]}
    results["many"] = measure_many(runner, mode)
    results["ranks"] = measure_ranks(runner, mode)
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, scalingReport.PAGE)
    parser.add_argument("--before", action="store_true",
                        help="keep the tables of this version; later runs are compared with them")
    benchmarkRunner.run_page(parser, scalingReport.PAGE, measure, scalingReport.write)
    return 0


if __name__ == "__main__":
    sys.exit(main())
