#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the rendering study on tiny meshes and checks what must hold for any mesh.

Usage: testStudy.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys

import studyReport


def require(condition, what):
    if not condition:
        sys.exit(f"testStudy: {what}")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    script = pathlib.Path(__file__).parent / "runStudy.py"
    environment = {name: value for name, value in os.environ.items() if name != "GATUN_DATA_DIR"}
    subprocess.run([sys.executable, script, "--smoke", "--programs", programs, "--out", out],
                   check=True, env=environment)
    results = json.loads((out / "rendering-study" / "results.json").read_text(encoding="utf-8"))
    require(len(results["meshes"]) == 2, "a mesh is missing")
    require(not studyReport.differing(results), "the images differ")
    for mesh in results["meshes"]:
        for case in mesh["limits"]:
            works = [not studyReport.failure(runs) for runs in case["ways"].values()]
            # No program of this size can begin within 16 MiB of addresses.
            require(works == [case["limit"] != 16] * 4,
                    f"{mesh['name']}: unexpected result under {case['limit']} MiB")
        for size, on, off in studyReport.prefilter_pairs(mesh):
            require(0 < on["seenTets"] < off["seenTets"] == off["tets"],
                    f"{mesh['name']}: the pre-filter drops nothing, or all, at {size}")
    releases = [release for mesh in results["meshes"] for release in mesh.get("release", [])]
    require(len(releases) == 2, "the study of release is missing")
    for release in releases:
        pairs = studyReport.release_cases(release)
        require(len(pairs) == 4, "a case of release is missing")
        for light, _, front, both in pairs:
            require(both["mostWaiting"] < front["mostWaiting"],
                    f"{light}: more tetrahedra wait when released from both ends")
            require(abs(both["mean"] - front["mean"]) < 2e-3,
                    f"{light}: another image when released from both ends")
    page = (out / "rendering-study.md").read_text(encoding="utf-8")
    for part in "Figure 13", "Figure 14", "section 4.4", "pre-filter", "fails":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
