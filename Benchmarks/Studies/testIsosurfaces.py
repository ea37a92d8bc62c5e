#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the isosurface study on tiny meshes and checks what must hold for any mesh.

Usage: testIsosurfaces.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys


def require(condition, what):
    if not condition:
        sys.exit(f"testIsosurfaces: {what}")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    script = pathlib.Path(__file__).parent / "runIsosurfaces.py"
    environment = {name: value for name, value in os.environ.items() if name != "GATUN_DATA_DIR"}
    subprocess.run([sys.executable, script, "--smoke", "--programs", programs, "--out", out],
                   check=True, env=environment)
    results = json.loads((out / "isosurface-study" / "results.json").read_text(encoding="utf-8"))
    require(len(results["meshes"]) == 2, "a mesh is missing")
    for mesh in results["meshes"]:
        for run in mesh["cold"]:
            counts = {run[way]["triangles"] for way in ("layers", "spatial", "span")}
            require(len(counts) == 1 and counts.pop() > 0, "the methods make different surfaces")
            require(run["layers"]["bytes"] < run["raw"]["bytes"], "more is read than there is")
        for run in mesh["memory"]:
            require(run["ways"][0]["triangles"] == run["ways"][2]["triangles"],
                    "in memory there is another surface")
        for run in mesh["strips"].values():
            require(run["gatun"]["corners"] - 2 * run["gatun"]["strips"] == run["triangles"],
                    "strips have another number of triangles")
    page = (out / "isosurface-study.md").read_text(encoding="utf-8")
    for part in "MiB read", "slider", "layers / spatial", "triangles per strip", "Number of layers":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
