#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces straight from files, compared with VTK: time, bytes and memory from a new process to the
surface, one value after the other, meshes in memory, triangle strips, and the number of layers."""

import statistics

import isosurfaceReport
import meshStudy

PARTS = (0.1, 0.3, 0.5, 0.7, 0.9)

MODES = {
    "full": {
        "meshes": {"delaunay": {"tets": 1000000}, "big": {"tets": 5000000},
                   "bluntfin": {"array": "Density"}, "comb": {"array": "Density"}},
        "rounds": 3, "layers": (1, 2, 4, 8, 16, 32, 64, 128)},
    "quick": {
        "meshes": {"delaunay": {"tets": 100000}, "bluntfin": {"array": "Density"},
                   "comb": {"array": "Density"}},
        "rounds": 1, "layers": (1, 4, 16, 64)},
    "smoke": {"meshes": {"delaunay": {"tets": 3000}, "big": {"tets": 5000}},
              "rounds": 1, "layers": (1, 4)},
}

# For each method: the file that it starts from, and its name in gatunBenchmarks.
WAYS = {"layers": ("layers", "file"), "spatial": ("spatial", "file"),
        "zlib": ("vtu-zlib", "linear"), "raw": ("vtu-raw", "linear"), "span": ("vtu-zlib", "span")}


def median(runs):
    """The medians of the runs of one case, with the seconds of each round."""
    return {**{key: statistics.median(run[key] for run in runs) for key in runs[0]},
            "rounds": [run["seconds"] for run in runs]}


def pack(runner, source, file, *options):
    runner.say(f"gtn pack {' '.join(map(str, options))}")
    runner.run("gtn", "pack", "-q", *options, source, file)
    return file


def make_files(runner, name, source, array):
    """The mesh with one array, in all the formats."""
    files = {}
    for kind in ("vtu-raw", "vtu-zlib"):
        files[kind] = runner.path("isosurfaces", f"{name}-{kind}.vtu")
        runner.case("prepare", source, files[kind], "--array", array, "--format", kind)
    for kind, options in (("spatial", ()), ("layers", ("--layers", array))):
        files[kind] = pack(runner, files["vtu-raw"],
                           runner.path("isosurfaces", f"{name}-{kind}.gtn"), *options)
    return files


def measure_cold(runner, files, array, values, ways, rounds):
    """For each value: the methods take turns, each in a separate process, for several rounds."""
    cold = []
    for value in values:
        runs = {way: [] for way in ways}
        for _ in range(rounds):
            for way in ways:
                file, kind = WAYS[way]
                runs[way].append(runner.case("surface", files[file], "--array", array, "--way",
                                             kind, "--values", value))
        cold.append({"value": value, **{way: median(runs[way]) for way in ways}})
    return cold


def measure_repeated(runner, files, array, values):
    """The values up and down again; then small steps around the middle value, as of a slider."""
    middle = values[len(values) // 2]
    step = (values[-1] - values[0]) / 200
    slider = [middle + i * step for i in range(10)]
    result = {}
    for way, cache in (("layers", 256), ("spatial", 256), ("zlib", 0), ("span", 0)):
        file, kind = WAYS[way]
        runs = {name: runner.case("surface-repeat", files[file], "--array", array, "--way", kind,
                                  "--cache", cache, "--values", *asked)
                for name, asked in (("sweep", [*values, *reversed(values)]), ("slider", slider))}
        result[way] = runs
    return result


def measure_layers(runner, source, array, values, counts, rounds):
    """The file by the number of layers."""
    sweep = []
    for count in counts:
        file = pack(runner, source, runner.path("isosurfaces", f"layers{count}.gtn"), "--layers",
                    f"{array}:{count}")
        runs = [median([runner.case("surface", file, "--array", array, "--values", value)
                        for _ in range(rounds)]) for value in values]
        sweep.append({"layers": count, "bytes": file.stat().st_size, "runs": runs})
        file.unlink()
    return sweep


WHOLE = ("layers", "spatial", "vtu-zlib")


def measure_whole(runner, files, rounds):
    """The whole mesh from the file into memory, for each number of threads."""
    return [runner.case("load-files", *(files[kind] for kind in WHOLE), "--rounds", rounds,
                        threads=threads) for threads in (1, 2)]


def measure_mesh(runner, name, source, wanted, mode, _):
    array = wanted.get("array", "Density")
    files = make_files(runner, name, source, array)
    known = runner.case("surface-values", files["vtu-raw"], "--array", array, "--parts", *PARTS)
    values = known["values"]
    result = {
        "tets": known["tets"], "points": known["points"], "array": array,
        "bytes": {kind: file.stat().st_size for kind, file in files.items()},
        "cold": measure_cold(runner, files, array, values, WAYS, mode["rounds"]),
        "repeated": measure_repeated(runner, files, array, values),
        "whole": measure_whole(runner, files, 3 * mode["rounds"]),
        "memory": [{"value": value, **runner.case(
            "surface-memory", files["vtu-raw"], "--array", array, "--values", value, "--rounds",
            3 * mode["rounds"])} for value in values],
        "strips": {kind: runner.case("surface-strips", files[kind], "--array", array, "--values",
                                     values[2]) for kind in ("spatial", "layers")},
        "sweep": measure_layers(runner, files["vtu-raw"], array, values, mode["layers"],
                                mode["rounds"]),
    }
    for file in files.values():
        file.unlink()
    return result


if __name__ == "__main__":
    meshStudy.run("isosurface-study", __doc__, MODES, measure_mesh, isosurfaceReport.write)
