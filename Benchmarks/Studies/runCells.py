#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sizes by part and times of loading of meshes of all types of cells, beside VTK's files.

Measures the meshes of the folders GATUN_CELLS_DIR and GATUN_DATA_DIR, where they exist, and grids of
hexahedra that it makes.
"""

import json
import os
import pathlib
import sys
import time

import benchmarkRunner
import cellsReport

# Hexahedra of the grids that are made; rounds, and those of files of more than MANY bytes.
MODES = {
    "full": {"hexes": (1000000, 5000000), "rounds": 5, "few": 1},
    "quick": {"hexes": (100000,), "rounds": 3, "few": 1},
    "smoke": {"hexes": (1000,), "rounds": 1, "few": 1},
}
MANY = 100 << 20
REAL = {
    "GATUN_CELLS_DIR": ("bunny_hex.vtu", "comb_hex.vtu", "bluntfin_hex.vtu", "ac_room.vtu", "brick_prism.vtu",
                        "brick_pyra.vtu", "notch_disp.vtu", "cylinder_quadratic.vtk", "blow.vtk"),
    "GATUN_DATA_DIR": ("fire_ug.vtu", "can.vtu", "mug.e"),
}


def find_meshes(runner, mode):
    """The names and files of the meshes."""
    meshes = {}
    for variable, names in REAL.items() if mode is not MODES["smoke"] else ():
        folder = os.environ.get(variable)
        for name in names:
            file = pathlib.Path(folder) / name if folder else None
            if file and file.exists():
                meshes[file.stem] = file
    for count in mode["hexes"]:
        name = f"hexes-{count}"
        meshes[name] = runner.path(f"{name}.vtu")
        runner.case("make", "hexes", count, meshes[name])
    return meshes


def measure_mesh(runner, name, file, mode):
    rounds = mode["few" if file.stat().st_size > MANY else "rounds"]
    packed = runner.path(f"{name}.gtn")
    runner.say(f"gtn pack, bench: {name}")
    runner.run("gtn", "pack", "-q", file, packed)
    runner.run("gtn", "verify", "-q", packed, file)
    info = json.loads(runner.run("gtn", "info", "--json", packed))
    packed.unlink()
    bench = json.loads(runner.run("gtn", "bench", "-q", "--json", "--repeat", rounds, file))
    return {"name": name, "info": {key: info[key] for key in
                                   ("arrays", "cells", "cellTypes", "chunks", "points", "sizes", "times")},
            "files": bench["files"], "loads": bench["loads"]}


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "meshes": []}
    for name, file in find_meshes(runner, mode).items():
        results["meshes"].append(measure_mesh(runner, name, file, mode))
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


if __name__ == "__main__":
    sys.exit(0 if benchmarkRunner.run_page(
        benchmarkRunner.make_parser(__doc__, cellsReport.PAGE), cellsReport.PAGE, measure,
        cellsReport.write) else 1)
