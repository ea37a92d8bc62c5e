#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Repeats the evaluation of on-the-fly rendering in Yang's dissertation proposal (2001).

Memory and time of rendering while decompressing, compared with decompressing first (Figures 13 and
14, Table 4); release of tetrahedra from one end or from both (section 4.4); the pre-filter.
"""

import json
import os
import pathlib
import shutil
import sys
import tempfile
import time

import benchmarkRunner
import memoryLimit
import studyReport
import systemMemory

ARRAY = "Density"
SIZES = (128, 256, 512, 1024)
GIB = 1024

# Tetrahedra; memory limits in MiB besides none; rounds. The blunt fin and the combustion chamber are
# meshes of the proposal; they must be in GATUN_DATA_DIR.
MODES = {
    "full": {
        "meshes": {"bluntfin": {"limits": (64, 32), "rounds": 3},
                   "comb": {"limits": (64, 32), "rounds": 3},
                   "delaunay": {"tets": 1000000, "limits": (128, 64), "rounds": 3},
                   "big": {"tets": 5000000, "limits": (512, 256, 128, 64), "rounds": 2},
                   "huge": {"tets": 20000000, "limits": (2 * GIB, 1 * GIB, 512, 256, 128),
                            "rounds": 1, "sizes": SIZES[2:], "needs": 12 * 2**30}},
        "sizes": SIZES, "rayRounds": 3},
    "quick": {
        "meshes": {"bluntfin": {"limits": (64, 32), "rounds": 1},
                   "comb": {"limits": (64, 32), "rounds": 1},
                   "delaunay": {"tets": 100000, "limits": (64, 32), "rounds": 1},
                   "big": {"tets": 1000000, "limits": (128, 64), "rounds": 1}},
        "sizes": SIZES[:3], "rayRounds": 1},
    "smoke": {
        "meshes": {"delaunay": {"tets": 3000, "limits": (4 * GIB, 16), "rounds": 1},
                   "big": {"tets": 6000, "limits": (4 * GIB,), "rounds": 1}},
        "sizes": (32, 64), "rayRounds": 1},
}

ABOUT = {
    "bluntfin": "NASA's blunt fin, the paper's Blunt",
    "comb": "combustion chamber, the paper's Combustion",
    "delaunay": "ball meshed by TetGen",
    "lattice": "body-centered lattice with jitter",
    "big": "structured grid around a nose, five tetrahedra per hexahedron",
    "huge": "the same, larger",
}

# The methods: name, file, options.
WAYS = (("gatun", "gtn", ()), ("small", "small", ()), ("generic", "gtn", ("--whole",)),
        ("vtu", "vtu-zlib", ("--whole",)))

# Tetrahedra in a chunk, at most, of each .gtn file.
CHUNKS = {"gtn": 65536, "small": 8192, "one": 1048576}
TIMEOUT = 300


def make_source(runner, name, tets, delaunay, data):
    """The mesh; None if it is not available."""
    if name in ("bluntfin", "comb"):
        found = sorted(data.glob(f"{name}_tets*.vtu")) if data else []
        return found[0] if found else None
    made = runner.path("study", f"{name}.vtu")
    kind = ("delaunay" if delaunay else "lattice") if name == "delaunay" else "flow1"
    runner.case("make", kind, tets, made)
    return made


def make_files(runner, name, source, wanted):
    """One array, in random order: .vtu with zlib, and .gtn in chunks of several sizes."""
    order = () if wanted.get("tets", 0) > 5000000 else ("--permute",)
    files = {form: runner.path("study", f"{name}-{ending}") for form, ending in
             (("vtu", "raw.vtu"), ("vtu-zlib", "zlib.vtu"), ("gtn", "usual.gtn"),
              ("small", "small.gtn"), ("one", "one.gtn"))}
    runner.case("prepare", source, files["vtu"], "--array", ARRAY, *order)
    runner.case("prepare", files["vtu"], files["vtu-zlib"], "--format", "vtu-zlib")
    for form, chunk in CHUNKS.items():
        if form != "one" or name in ("bluntfin", "comb", "delaunay"):
            runner.say(f"pack {name} in chunks of {chunk}")
            runner.run("gtn", "pack", "-q", "-f", "--chunk", chunk, files["vtu"], files[form])
    return files


def draw(runner, way, limiter, file, options, size, limit):
    """Draws one image in a separate process; returns its output, or the reason of its failure."""
    threads = len(os.sched_getaffinity(0))
    command = runner.command("gatunBenchmarks", "--threads", threads, "study-picture", file,
                             "--array", ARRAY, "--size", size, *options)
    runner.say(f"{way} {file.name} {size}" + (f", {limit} MiB" if limit else ""))
    out, why = (limiter.run(command, limit * 2**20, TIMEOUT) if limit
                else memoryLimit.unlimited(command, TIMEOUT))
    return {"why": why} if out is None else json.loads(out)


def measure_limits(runner, files, wanted, sizes, limiter):
    """Images of all sizes under all limits with all methods, which take turns."""
    cases = []
    for limit in (0, *wanted["limits"]):
        for size in sizes:
            found = {way: [] for way, _, _ in WAYS}
            for _ in range(wanted["rounds"]):
                for way, form, options in WAYS:
                    if not (found[way] and "why" in found[way][-1]):
                        found[way].append(draw(runner, way, limiter, files[form], options, size,
                                               limit))
            cases.append({"limit": limit, "size": size, "ways": found})
    return cases


def measure_mesh(runner, name, wanted, mode, limiter, delaunay, data):
    source = make_source(runner, name, wanted.get("tets"), delaunay, data)
    if source is None:
        return None
    files = make_files(runner, name, source, wanted)
    sizes = mode["sizes"]
    rounds = ("--rounds", mode["rayRounds"], "--array", ARRAY)
    about = "lattice" if name == "delaunay" and not delaunay else name
    result = {"name": about, "about": ABOUT[about],
              "fileBytes": {form: files[form].stat().st_size for form in ("vtu-zlib", "gtn")},
              "limits": measure_limits(runner, files, wanted, wanted.get("sizes", sizes), limiter)}
    if name != "huge":
        result["prefilter"] = runner.case("study-prefilter", files["gtn"], "--size",
                                          ",".join(map(str, sizes)), *rounds, threads=1)
    if name in ("bluntfin", "comb", "delaunay"):
        result["release"] = [runner.case("study-release", files[form], "--size", sizes[-2],
                                         *rounds, threads=1) for form in ("gtn", "one")]
    result["tets"] = json.loads(runner.run("gtn", "info", "--json", files["gtn"]))["tets"]
    shutil.rmtree(runner.folder("study"))
    return result


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    limiter = memoryLimit.address_space() if options.mode == "smoke" else memoryLimit.best()
    results["limiter"] = limiter.name
    results["swap"] = systemMemory.read("SwapTotal")
    data = os.environ.get("GATUN_DATA_DIR")
    data = pathlib.Path(data) if data else None
    results["meshes"] = []
    for name, wanted in mode["meshes"].items():
        if systemMemory.read("MemAvailable") < wanted.get("needs", 0):
            runner.say(f"{name} is left out: it needs more memory than is free")
            continue
        mesh = measure_mesh(runner, name, wanted, mode, limiter, results["machine"]["tetgen"], data)
        if mesh:
            results["meshes"].append(mesh)
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, "rendering-study")
    options = parser.parse_args()
    folder = options.out / "rendering-study"
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    if options.report:
        results = json.loads(raw.read_text(encoding="utf-8"))
    else:
        with tempfile.TemporaryDirectory(prefix="gatun-study-") as work:
            results = measure(benchmarkRunner.Runner(options.programs, pathlib.Path(work)), options)
        raw.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    studyReport.write(results, options.out)
    print(f"The results are in {options.out / 'rendering-study.md'} and {folder}")


if __name__ == "__main__":
    sys.exit(main())
