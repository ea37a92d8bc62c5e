#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the volume study on tiny volumes and checks what must hold for any volume.

Usage: testVolumes.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys


def require(condition, what):
    if not condition:
        sys.exit(f"testVolumes: {what}")


def check_blocks(run):
    for way in run["ways"]:
        for view in way["views"]:
            require(view["rays"] > 0 and view["largest"] > 0, "no ray meets a block")
    if run["rate"] != 0:
        return
    ways = {way["way"]: way["views"] for way in run["ways"]}
    for i, own in enumerate(ways["gatun"]):
        require(own["lines"] < 0.2, f"blocks of {run['block']}: {own['lines']} in view {i}")
        # Where the references agree, so do the errors.
        require(abs(own["samples"] - own["lines"]) <= 0.001 + 2.5 * own["between"],
                "the sums disagree with the integrals")
    require(ways["trilinear-2"][3]["lines"] > 10 * ways["gatun"][3]["lines"],
            "the paper's kernel is as good as ours")


def check_pictures(run):
    errors = {}
    for block in run["blocks"]:
        for view in block["views"]:
            require(view["met"] > 0, "no ray meets the volume")
            if block["rate"] == 0:
                require(view["xrayLines"]["mse"] < 0.3, "X-rays are wrong")
                require(view["equation6"]["mse"] < 0.5, "equation 6 does not hold")
        if block["rate"] == 0:
            errors[block["block"]] = block["views"][1]["exponential"]["mse"]
    require(errors[4] < errors[16], "smaller blocks are no better")


def check_rates(rates):
    for series in rates["gatun"]:
        points = sorted(series["points"], key=lambda point: point["wanted"] or 1000)
        require(points[-1]["wanted"] == 0 and points[-1]["worst"] < 0.01, "lossless is not")
        for point in points[:-1]:
            require(point["psnr"] > point["wanted"] - 0.5, "a file has a larger error than was wanted")
        for point, finer in zip(points, points[1:]):
            require(point["bits"] < finer["bits"], "a smaller error takes fewer bits")
    for point in rates.get("zfp", {}).get("reversible", []):
        require(point["psnr"] is None, "zfp's lossless mode is not")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    script = pathlib.Path(__file__).parent / "runVolumes.py"
    environment = {name: value for name, value in os.environ.items() if name != "GATUN_DATA_DIR"}
    subprocess.run([sys.executable, script, "--smoke", "--programs", programs, "--out", out],
                   check=True, env=environment)
    results = json.loads((out / "volume-study" / "results.json").read_text(encoding="utf-8"))
    require(len(results["volumes"]) == 2, "a volume is missing")
    for one in results["volumes"]:
        for run in one["blocks"]:
            check_blocks(run)
        for run in one["pictures"]:
            check_pictures(run)
        check_rates(one["rates"])
    ways = {one["way"] for one in results["times"]["runs"]["blocks"]["ways"]}
    require(ways >= {"gatun", "plain"}, "a renderer was not timed")
    require(len(results["plate"]["runs"]) == 15, "an image is missing")
    page = (out / "volume-study.md").read_text(encoding="utf-8")
    for part in "Table 1", "Table 2", "Bits by error", "Time for a view":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
