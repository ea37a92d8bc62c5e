#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Measures the rows of README.md's table: default settings, synthetic meshes, peers in turns.

Writes summary.md, the folder summary, and, if they go to Documentation/studies, the table in README.md.
"""

import json
import os
import pathlib
import sys
import time

import benchmarkRunner
import displays
import generatedParts
import summaryReport

PAGE = "summary"
ARRAY = "Density"

# Tetrahedra, pixels, voxels along an edge, rounds.
MODES = {
    "full": {"delaunay": 1000000, "grid": 5000000, "size": 1024, "voxels": 128, "rounds": 7, "few": 3,
             "samples": 200000},
    "quick": {"delaunay": 100000, "grid": 400000, "size": 512, "voxels": 64, "rounds": 5, "few": 2,
              "samples": 50000},
    "smoke": {"delaunay": 3000, "grid": 5000, "size": 64, "voxels": 24, "rounds": 1, "few": 1,
              "samples": 2000},
}


def measure_files(runner, mesh, mode):
    """Sizes of all formats, and loading in turns."""
    folder = runner.folder("files")
    size = runner.case("size", mesh, folder)
    fast = runner.path("fast.gtn")
    runner.run("gtn", "pack", "--quiet", "--force", "--fast-arrays", mesh, fast)
    load = runner.case("load-files", f"{folder}/gtn.gtn", fast, f"{folder}/vtu-zlib.vtu", "--rounds",
                       mode["rounds"])
    return {"size": size, "fastBytes": os.path.getsize(fast), "load": load}


def measure_images(runner, files, mode):
    """From a file to the first image, each run a separate process, in turns."""
    runs = {"gtn": [], "vtu-zlib": []}
    for _ in range(mode["few"]):
        for form, found in runs.items():
            found.append(runner.case("picture", files[form], "--size", mode["size"], "--array", ARRAY,
                                     window=True, threads=runner.threads))
    return runs


def measure_frames(runner, file, mode):
    return runner.case("render", file, "--size", mode["size"], "--mappers", "gatun,bunyk",
                       "--rounds", mode["rounds"], "--slow-rounds", mode["rounds"], "--first-rounds", 1,
                       "--array", ARRAY, window=True, threads=runner.threads)


def measure_surfaces(runner, files, mode):
    """An isosurface at the median, each run a separate process, in turns."""
    value = runner.case("surface-values", files["vtu-zlib"], "--array", ARRAY, "--parts",
                        0.5)["values"][0]
    runs = {"gtn": [], "vtu-zlib": []}
    for _ in range(mode["rounds"]):
        for form, found in runs.items():
            found.append(runner.case("surface", files[form], "--array", ARRAY, "--values", value,
                                     "--way", "file" if form == "gtn" else "linear"))
    return {"value": value, **runs}


def measure_simplification(runner, file, mode):
    """To a tenth of the tetrahedra."""
    out = {way: runner.path("simplified", f"{way}.vtu") for way in ("quadric", "gatun")}
    quadric = runner.case("simplify-quadric", file, "--array", ARRAY, "--part", 0.1, "--out",
                          out["quadric"], threads=1)
    gatun = runner.case("simplify-gatun", file, "--array", ARRAY, "--tets", quadric["tets"], "--out",
                        out["gatun"], threads=1)
    compared = runner.case("simplify-compare", file, out["quadric"], out["gatun"], "--array", ARRAY,
                           "--samples", mode["samples"])
    return {"quadric": quadric, "gatun": gatun, "compared": compared}


def measure_volume(runner, mode):
    """The rate of zfp's setting nearest to 40 dB, and Gatun's rate at the same error."""
    volume, scratch = f"head:{mode['voxels']}", runner.path("volume", "rates.ghv")
    first = runner.case("volume-rates", volume, scratch, "--blocks", 8, "--psnr", 40, "--weights", 0)
    points = [point for way in ("accuracy", "precision") for point in first.get("zfp", {}).get(way, [])
              if point["psnr"] is not None]
    if not points:
        return None
    zfp = min(points, key=lambda point: abs(point["psnr"] - 40))
    own = runner.case("volume-rates", volume, scratch, "--blocks", 8, "--psnr", zfp["psnr"],
                      "--weights", 0)["gatun"][0]["points"][0]
    return {"voxels": first["voxels"], "zfp": zfp, "gatun": own}


def prepare(runner, mesh, name, *options):
    """The mesh as .vtu with zlib, which is VTK's default, raw, and .gtn, all with default settings."""
    files = {}
    for form, ending in ("vtu-raw", "raw.vtu"), ("vtu-zlib", "zlib.vtu"), ("gtn", "packed.gtn"):
        files[form] = runner.path(name, f"{name}-{ending}")
        runner.case("prepare", mesh, files[form], "--format", form, *options)
    return files


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    runner.threads = results["machine"]["processors"]
    kind = "delaunay" if results["machine"]["tetgen"] else "lattice"
    mesh = runner.path("delaunay.vtu")
    runner.case("make", kind, mode["delaunay"], mesh)
    permuted = runner.path("delaunay-permuted.vtu")
    runner.case("prepare", mesh, permuted, "--permute")
    results["files"] = measure_files(runner, permuted, mode)
    # VTK's mapper is faster with a mesh in a good order.
    sorted_files = prepare(runner, mesh, "sorted", "--morton")
    results["simplification"] = measure_simplification(runner, sorted_files["vtu-raw"], mode)
    grid = runner.path("grid.vtu")
    runner.case("make", "flow1", mode["grid"], grid)
    files = prepare(runner, grid, "grid")
    results["gridTets"] = json.loads(runner.run("gtn", "info", "--json", files["gtn"]))["tets"]
    results["surfaces"] = measure_surfaces(runner, files, mode)
    if displays.prefix() is not None:
        results["frames"] = measure_frames(runner, sorted_files["vtu-raw"], mode)
        results["images"] = measure_images(runner, files, mode)
    results["volume"] = measure_volume(runner, mode)
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    options = benchmarkRunner.run_page(benchmarkRunner.make_parser(__doc__, PAGE), PAGE, measure,
                                       summaryReport.write)
    if options.out.resolve() == generatedParts.STUDIES:
        generatedParts.update()


if __name__ == "__main__":
    sys.exit(main())
