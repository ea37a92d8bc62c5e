#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the simplification study on tiny meshes and checks what must hold for any mesh.

Usage: testSimplification.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys


def require(condition, what):
    if not condition:
        sys.exit(f"testSimplification: {what}")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    script = pathlib.Path(__file__).parent / "runSimplification.py"
    environment = {name: value for name, value in os.environ.items() if name != "GATUN_DATA_DIR"}
    subprocess.run([sys.executable, script, "--smoke", "--programs", programs, "--out", out],
                   check=True, env=environment)
    folder = out / "simplification-study"
    results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    require(len(results["meshes"]) == 2, "a mesh is missing")
    for mesh in results["meshes"]:
        original = mesh["compared"]["original"]
        require(original["rms"] < 1e-6 and original["outside"] == 0 and
                original["boundaryLargest"] < 1e-6, f"{mesh['name']}: it differs from itself")
        errors = [original["rms"]]
        for quadric, gatun in zip(mesh["compared"]["quadric"], mesh["compared"]["gatun"]):
            require(0 < gatun["tets"] <= quadric["tets"], f"{mesh['name']}: too many tetrahedra")
            require(gatun["inverted"] == gatun["flat"] == 0, f"{mesh['name']}: inverted or flat")
            errors.append(gatun["rms"])
        require(errors == sorted(errors) and errors[-1] > 1e-3,
                f"{mesh['name']}: errors do not grow with what is left out: {errors}")
    shown = results["pictures"]
    require(shown["original"]["rms"] == 0 and shown["original"]["covered"] > 0.1,
            "the image of the original differs from itself or is empty")
    require(0 < shown["gatun"][0]["rms"] < shown["gatun"][-1]["rms"] < 0.2,
            "images do not become worse")
    for mesh in results["meshes"]:
        runs = mesh["integrated"]["runs"]
        require(len({run[way]["tets"] for run in runs[1:]
                     for way in ("staged", "integrated", "levels")}) == 1,
                f"{mesh['name']}: the methods draw different meshes")
        require(runs[1]["integrated"]["tets"] < 0.7 * runs[0]["integrated"]["tets"],
                f"{mesh['name']}: nothing is simplified on the way from the file")
        require(runs[1]["integrated"]["simplify"] > 0, f"{mesh['name']}: simplifying takes no time")
        drawn = [one["tets"] for one in mesh["drawn"]["meshes"]]
        require(drawn == sorted(drawn, reverse=True) and len(set(drawn)) == len(drawn),
                f"{mesh['name']}: the drawn meshes are not simpler and simpler: {drawn}")
    page = (out / "simplification-study.md").read_text(encoding="utf-8")
    for part in "Figure 17", "Figure 18", "Figure 19", "Gatun / VTK", "M tets/s":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
