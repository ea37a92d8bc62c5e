#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""How well just-in-time rendering keeps a time budget along a recorded camera path: fast, slow, and at
rest."""

import json
import os
import pathlib
import sys
import time

import benchmarkRunner
import budgetReport

MODES = {
    "full": {"meshes": {"delaunay": 1000000, "flow1": 5000000}, "frames": 60,
             "budgets": (0.033, 0.1, 0.5), "size": 512},
    "quick": {"meshes": {"delaunay": 100000}, "frames": 30, "budgets": (0.033, 0.1), "size": 256},
    "smoke": {"meshes": {"lattice": 5000}, "frames": 3, "budgets": (0.1,), "size": 64},
}


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "meshes": []}
    given = dict(pair.split("=", 1) for pair in options.mesh)
    for kind, tets in mode["meshes"].items():
        if kind == "delaunay" and not results["machine"]["tetgen"] and kind not in given:
            kind = "lattice"
        file = given.get(kind)
        if file is None:
            file = runner.path(f"{kind}.vtu")
            runner.case("make", kind, tets, file)
        budgets = ",".join(map(str, mode["budgets"]))
        case = ("budget", file, "--frames", mode["frames"], "--size", mode["size"],
                "--budgets", budgets)
        results["meshes"].append({
            "name": kind, "simplified": runner.case(*case, window=True),
            "rays": runner.case(*case, "--only-rays", window=True)})
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    worst = max(path["difference"] for mesh in results["meshes"]
                for way in ("simplified", "rays") for path in mesh[way]["paths"])
    if worst:
        sys.exit(f"runBudget.py: an image at rest differs from the full one by {worst} of 255")
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, budgetReport.PAGE)
    parser.add_argument("--mesh", action="append", default=[], metavar="KIND=FILE",
                        help="a file to use instead of a generated mesh (delaunay, flow1)")
    benchmarkRunner.run_page(parser, budgetReport.PAGE, measure, budgetReport.write)


if __name__ == "__main__":
    sys.exit(main())
