#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the surface study on tiny surfaces and checks what must hold for any surface.

Usage: testSurfaces.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import pathlib
import subprocess
import sys


def require(condition, what):
    if not condition:
        sys.exit(f"testSurfaces: {what}")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    script = pathlib.Path(__file__).parent / "runSurfaces.py"
    subprocess.run([sys.executable, script, "--smoke", "--programs", programs, "--out", out], check=True)
    results = json.loads((out / "surface-study" / "results.json").read_text(encoding="utf-8"))
    require(len(results["surfaces"]) == 4, "a surface is missing")
    for surface in results["surfaces"]:
        name = surface["name"]
        require(surface["bytes"]["gtn"] == surface["parts"]["file"], f"{name}: two sizes of a file")
        require(surface["bytes"]["gtn"] < surface["bytes"]["vtp-zlib"], f"{name}: larger than zlib")
        require(surface["parts"]["file"] < surface["kept"]["file"], f"{name}: the order is free")
        require(not name.startswith("scan") or
                surface["rounded"]["gtn"]["file"] < surface["parts"]["file"],
                f"{name}: rounding does not pay")
    motion = results["motion"]
    require(motion["bytes"]["gtn"] < motion["bytes"]["vtp"], "the file with base meshes is large")
    for path in motion["paths"]:
        for way in "gtn", "vtp":
            one = path[way]
            require(len(one["frames"]) == len(one["points"]) == 6, f"{way}: a frame is missing")
            require(0 < one["medianPoints"] <= motion["points"], f"{way}: a wrong number of points")
    require(len(motion["cuts"]) == 2, "a place of the flight is missing")
    for place in motion["cuts"]:
        require(len(place["uniform"]) == 8, "a uniform surface is missing")
        require(all(0 <= cut["points"] < motion["points"] for cut in place["cuts"]), "too many points")
    page = (out / "surface-study.md").read_text(encoding="utf-8")
    for part in "connectivity", "ours / best peer", "coordinates of 14 bits", "M triangles/s", "Images in motion",\
            "Simplified for the view":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
