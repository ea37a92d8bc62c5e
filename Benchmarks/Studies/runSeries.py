#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sizes of time series and the time to step through them, beside a .vtu file for each step: values that
change on a mesh that stands still, and points that move, without loss and with bounded errors."""

import os
import sys
import time

import benchmarkRunner
import seriesReport

MODES = {
    "full": {"tets": 1000000, "steps": 50, "rounds": 3},
    "quick": {"tets": 100000, "steps": 20, "rounds": 2},
    "smoke": {"tets": 3000, "steps": 3, "rounds": 1},
}
ERRORS = (0, 1e-4)


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "series": []}
    mesh = runner.path("mesh.vtu")
    kind = "delaunay" if results["machine"]["tetgen"] else "lattice"
    runner.case("make", kind, mode["tets"], mesh)
    for moving in False, True:
        for error in ERRORS:
            extra = (["--moving"] if moving else []) + (["--error", error] if error else [])
            folder = runner.folder("series")
            measured = runner.case("series", mesh, folder, "--steps", mode["steps"],
                                   "--rounds", mode["rounds"], *extra)
            results["series"].append({"mesh": kind, "moving": moving, "error": error, **measured})
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, seriesReport.PAGE)
    benchmarkRunner.run_page(parser, seriesReport.PAGE, measure, seriesReport.write)


if __name__ == "__main__":
    sys.exit(main())
