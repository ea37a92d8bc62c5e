#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""View-dependent simplification on a flight into meshes in files: tetrahedra and errors beside meshes
that are simplified everywhere alike, frame times within a budget, bytes read and memory."""

import os
import sys
import time

import benchmarkRunner
import detailReport

MODES = {
    "full": {"meshes": {"delaunay": 1000000, "flow1": 5000000}, "size": 512, "frames": 60,
             "budgets": (0.033, 0.1, 0.5), "chunk": 4096, "levels": 8, "film": 16},
    "quick": {"meshes": {"delaunay": 200000}, "size": 256, "frames": 20, "budgets": (0.1,),
              "chunk": 4096, "levels": 8, "film": 12},
    "smoke": {"meshes": {"lattice": 20000}, "size": 64, "frames": 3, "budgets": (0.1,),
              "chunk": 500, "levels": 4, "film": 2},
}
MEMORY = 256
POINTS_OF_FILM = 5000


def find_file(runner, mode, kind, tets, given):
    """A .gtn file of a mesh with base meshes: a given one, or a new one."""
    if kind in given:
        return given[kind]
    source, file = runner.path(f"{kind}.vtu"), runner.path(f"{kind}.gtn")
    runner.case("make", kind, tets, source)
    runner.say(f"gtn pack --levels {mode['levels']} --chunk {mode['chunk']} {source.name}")
    runner.run("gtn", "pack", "-q", "--levels", mode["levels"], "--chunk", mode["chunk"], source, file)
    source.unlink()
    return file


def fly(runner, file, array, mode):
    """Flights within budgets: with fewer rays where that helps, and with a ray for each pixel."""
    flights = []
    for budget in mode["budgets"]:
        for options in ((), ("--only-points",), ("--uniform",)):
            flights.append(runner.case(
                "detail-flight", file, "--array", array, "--size", mode["size"], "--frames",
                mode["frames"], "--budget", budget, "--memory", MEMORY, *options, window=True))
    return flights


def film(runner, file, array, mode):
    """Makes the film of the page, where PIL is installed; returns its number of points."""
    try:
        import detailFilm  # pylint: disable=import-outside-toplevel
    except ImportError:
        print("Without PIL (python3-pil) there is no film.")
        return None
    folder = runner.folder("film")
    runner.case("detail-film", file, folder, "--array", array, "--frames", mode["film"],
                "--points", POINTS_OF_FILM)
    detailFilm.make(folder, mode["film"], runner.images / "flight.gif")
    return {"points": POINTS_OF_FILM, "frames": mode["film"]}


def measure(runner, options):
    runner.images = options.out / detailReport.PAGE
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "meshes": []}
    given = dict(pair.split("=", 1) for pair in options.mesh)
    arrays = dict(pair.split("=", 1) for pair in options.array)
    kinds = dict(mode["meshes"])
    if not results["machine"]["tetgen"] and "delaunay" not in given and "delaunay" in kinds:
        kinds["lattice"] = kinds.pop("delaunay")
    kinds.update((kind, None) for kind in given if kind not in kinds)
    for kind, tets in kinds.items():
        file = find_file(runner, mode, kind, tets, given)
        array = arrays.get(kind, "Density")
        results["meshes"].append({
            "name": kind,
            "pictures": runner.case("detail", file, "--array", array, "--size", mode["size"]),
            "flights": fly(runner, file, array, mode)})
        results["film"] = film(runner, file, array, mode)
        if kind not in given:
            file.unlink()
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, detailReport.PAGE)
    parser.add_argument("--mesh", action="append", default=[], metavar="NAME=FILE",
                        help="a .gtn file with base meshes, also instead of a generated one "
                             "(delaunay, flow1)")
    parser.add_argument("--array", action="append", default=[], metavar="NAME=ARRAY",
                        help="the array of a given mesh (default: Density)")
    benchmarkRunner.run_page(parser, detailReport.PAGE, measure, detailReport.write)


if __name__ == "__main__":
    sys.exit(main())
