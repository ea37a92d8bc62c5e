#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs gatunBenchmarks, case by case, and writes the results as JSON, plots and a page.

Each case is a separate process, so that neither memory nor threads of one case affect the next.
"""

import json
import os
import pathlib
import shutil
import sys
import tempfile
import time

import benchmarkReport
import benchmarkRunner
import renderingCases
import renderingReport

# Tetrahedra of the generated meshes, rounds of timings, time steps; "big" is measured permuted only.
# TetGen makes more tetrahedra of the series mesh than requested, about 200000.
MODES = {
    "full": {"flow": 1000000, "delaunay": 1000000, "big": 5000000, "series": 158000,
             "steps": 50, "rounds": 7, "few": 3},
    "quick": {"flow": 150000, "delaunay": 150000, "big": 400000, "series": 50000,
              "steps": 10, "rounds": 5, "few": 2},
    "smoke": {"flow": 4000, "delaunay": 3000, "big": 6000, "series": 3000,
              "steps": 4, "rounds": 1, "few": 1},
}

DESCRIPTIONS = {
    "flow": "structured grid around a nose, five tetrahedra per hexahedron; Density, Momentum (3), "
            "Energy, Pressure (float, with solver noise of 1e-6)",
    "big": "the same kind of grid, larger, with Density only",
    "delaunay": "ball meshed by TetGen (Delaunay, quality); Density (float, smooth)",
}


def make_inputs(runner, sizes, delaunay):
    """Writes the meshes; returns those whose size and speed are measured."""
    kinds = ["flow"] + (["delaunay"] if delaunay else [])
    inputs = []
    for kind in kinds:
        natural = runner.path(f"{kind}.vtu")
        permuted = runner.path(f"{kind}-permuted.vtu")
        runner.case("make", kind, sizes[kind], natural)
        runner.case("prepare", natural, permuted, "--permute")
        inputs += [
            {"name": kind, "order": "natural", "file": natural, "timed": True},
            {"name": kind, "order": "permuted", "file": permuted, "timed": True}]
    big = runner.path("big-permuted.vtu")
    runner.case("make", "flow1", sizes["big"], big, "--permute")
    inputs.append({"name": "big", "order": "permuted", "file": big, "timed": True})
    for one in inputs:
        one["about"] = DESCRIPTIONS[one["name"]]
    return inputs


def as_vtu(runner, file):
    """A .vtu file of any file that gtn can read, in its original order."""
    if file.suffix == ".vtu":
        return file
    packed = runner.path("import", file.name + ".gtn")
    vtu = runner.path("import", file.name + ".vtu")
    runner.run("gtn", "pack", "-q", "-f", "--keep-order", "all", file, packed)
    runner.run("gtn", "unpack", "-q", "-f", packed, vtu)
    return vtu


def user_inputs(runner, files):
    inputs = []
    for file in files:
        vtu = as_vtu(runner, file)
        for order in "natural", "permuted":
            prepared = runner.path("user", f"{file.stem}-{order}.vtu")
            runner.case("prepare", vtu, prepared, *(["--permute"] if order == "permuted" else []))
            inputs.append({"name": file.name, "order": order, "file": prepared, "timed": True,
                           "about": "given by the user"})
    return inputs


def data_inputs(runner, folder):
    """Every .vtu file with all its arrays; the CFD meshes also with Density alone, permuted."""
    inputs = []
    for file in sorted(folder.glob("*.vtu")):
        prepared = runner.path("data", file.name)
        runner.case("prepare", file, prepared)
        inputs.append({"name": file.stem, "order": "natural", "file": prepared, "timed": False,
                       "about": "all arrays"})
        if file.name.startswith(("bluntfin", "comb")):
            prepared = runner.path("data", file.stem + "-density.vtu")
            runner.case("prepare", file, prepared, "--permute", "--array", "Density")
            inputs.append({"name": file.stem + "-density", "order": "permuted", "file": prepared,
                           "timed": False, "about": "Density only"})
    return inputs


def measure_input(runner, one, sizes):
    """All measurements of one mesh."""
    label = f"{one['name']}-{one['order']}"
    folder = runner.folder(label)
    result = {key: one[key] for key in ("name", "order", "about")}
    result["size"] = runner.case("size", one["file"], folder)
    if one["timed"]:
        result["load"] = [runner.case("load", folder, "--rounds", sizes["rounds"], threads=threads)
                          for threads in (1, 2, 4)]
        result["loadCold"] = [runner.case("load", folder, "--cold", "--rounds", sizes["few"],
                                          threads=threads) for threads in (1, 2, 4)]
    if one["timed"] and one["order"] == "permuted":
        result["write"] = [runner.case("write", one["file"], folder, "--rounds", sizes["few"],
                                       threads=threads) for threads in (1, 2)]
        result["peak"] = {name: runner.case("peak", folder / file, threads=2) for name, file in
                          (("gtn", "gtn.gtn"), ("vtu-raw", "vtu-raw.vtu"),
                           ("vtu-zlib", "vtu-zlib.vtu"))}
        result["peakWrite"] = runner.case("peak", folder / "vtu-raw.vtu", "--write",
                                          folder / "peak.gtn", threads=2)
        stages = runner.run("gatunBenchmarkStages", folder / "gtn.gtn", "--rounds", sizes["few"])
        result["stages"] = json.loads(stages)
    if one["name"] == "big":
        result["pieces"] = runner.case("pieces", folder / "gtn.gtn", "--rounds", sizes["few"],
                                       threads=2)
        result["roi"] = runner.case("roi", one["file"], folder / "roi.gtn", "--rounds",
                                    sizes["few"], threads=2)
    shutil.rmtree(folder)
    return result


def measure_series(runner, sizes, delaunay):
    mesh = runner.path("series.vtu")
    folder = runner.folder("series")
    kind = "delaunay" if delaunay else "lattice"
    runner.case("make", kind, sizes["series"], mesh, "--permute")
    result = runner.case("series", mesh, folder, "--steps", sizes["steps"], "--rounds",
                         sizes["few"], threads=2)
    result["mesh"] = kind
    shutil.rmtree(folder)
    return result


def measure_exodus(runner, file):
    """A file with time steps as one .gtn file and as one .vtu file per step."""
    packed = runner.path("exodus", "all.gtn")
    runner.run("gtn", "pack", "-q", "-f", file, packed)
    info = json.loads(runner.run("gtn", "info", "--json", packed))
    steps = 0
    size = 0
    for step in info["times"]:
        vtu = runner.path("exodus", "step.vtu")
        runner.run("gtn", "unpack", "-q", "-f", "--time", repr(step), packed, vtu)
        size += vtu.stat().st_size
        steps += 1
    return {"name": file.name, "steps": steps, "tets": info["tets"],
            "inputBytes": file.stat().st_size, "gtnBytes": packed.stat().st_size,
            "vtuBytes": size}


def measure(runner, options):
    sizes = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    delaunay = results["machine"]["tetgen"]
    inputs = make_inputs(runner, sizes, delaunay) + user_inputs(runner, options.files)
    data = os.environ.get("GATUN_DATA_DIR")
    data = pathlib.Path(data) if data and options.mode != "smoke" else None
    if data:
        inputs += data_inputs(runner, data)
    results["inputs"] = [measure_input(runner, one, sizes) for one in inputs]
    results["series"] = measure_series(runner, sizes, delaunay)
    if data:
        results["exodus"] = [measure_exodus(runner, file) for file in sorted(data.glob("*.e"))]
    rendering = renderingCases.measure(runner, options.mode, sizes, delaunay, data)
    if rendering:
        results["rendering"] = rendering
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, "benchmarks")
    parser.add_argument("files", type=pathlib.Path, nargs="*", metavar="FILE",
                        help="more meshes to measure, in any format that gtn reads")
    options = parser.parse_args()
    folder = options.out / "benchmarks"
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    if options.report:
        results = json.loads(raw.read_text(encoding="utf-8"))
    else:
        with tempfile.TemporaryDirectory(prefix="gatun-benchmarks-") as work:
            results = measure(benchmarkRunner.Runner(options.programs, pathlib.Path(work)), options)
        raw.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    benchmarkReport.write(results, options.out)
    rendering = results.get("rendering")
    if options.mode == "smoke" and rendering and renderingReport.differing(rendering):
        sys.exit("runBenchmarks: mappers draw different images")
    print(f"The results are in {options.out / 'benchmarks.md'} and {folder}")


if __name__ == "__main__":
    main()
