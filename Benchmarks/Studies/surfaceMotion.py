# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images of a large surface in motion: measurements for runSurfaces.py."""

import json
import os
import statistics

import benchmarkRunner

MODES = {
    "full": {"triangles": 10000000, "levels": 8, "budgets": (0.05, 0.1), "frames": 200, "size": 1000,
             "view": 400, "places": 4, "errors": (1, 2, 4, 8)},
    "quick": {"triangles": 1000000, "levels": 6, "budgets": (0.05, 0.1), "frames": 100, "size": 500,
              "view": 300, "places": 4, "errors": (1, 2, 4)},
    "smoke": {"triangles": 40000, "levels": 2, "budgets": (0.05,), "frames": 6, "size": 100,
              "view": 60, "places": 2, "errors": (1,)},
}


def _draw(runner, *arguments):
    return runner.case(*arguments, threads=2, window=True)


def _draw_path(runner, file, points, *arguments):
    """The frames of a camera path."""
    one = _draw(runner, "surface-frames", file, *arguments)
    one["points"] = [count or points for count in one["points"]]  # 0: not simplified
    one["medianPoints"] = statistics.median(one["points"])
    return one


def measure(runner, name):
    """The results for a mode."""
    mode = MODES[name]
    size = ("--size", mode["size"])
    vtp, gtn = runner.path("motion.vtp"), runner.path("motion.gtn")
    machine = benchmarkRunner.machine(runner)
    runner.case("make-surface", "scan", vtp, "--triangles", mode["triangles"])
    runner.say("the hierarchy and base meshes of a scan")
    runner.run("gtn", "pack", "-q", "-f", "--levels", mode["levels"], vtp, gtn)
    info = json.loads(runner.run("gtn", "info", "--json", gtn))
    files = {"gtn": gtn, "vtp": vtp}
    result = {"triangles": info["cells"], "points": info["points"], "size": mode["size"],
              "bytes": {way: file.stat().st_size for way, file in files.items()},
              "first": {"gtn": _draw(runner, "surface-draw", gtn, "--moving", "--frames", 0, *size),
                        "vtp": _draw(runner, "surface-draw", vtp, "--frames", 0, *size)},
              "paths": [{"budget": budget, **{
                  way: _draw_path(runner, file, info["points"], "--budget", budget, "--frames",
                                  mode["frames"], *size) for way, file in files.items()}}
                        for budget in mode["budgets"]]}
    errors = [str(error) for error in mode["errors"]]
    cuts = _draw(runner, "surface-cuts", gtn, "--size", mode["view"], "--places", mode["places"],
                 "--memory", 2048, "--errors", *errors)
    machine["loadAfter"] = os.getloadavg()
    return {"mode": name, "machine": machine, "view": mode["view"], "cuts": cuts["places"], **result}
