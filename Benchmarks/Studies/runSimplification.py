#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Simplification compared with VTK's: errors of field, shape and images, time and memory.

Also repeats Figures 17, 18 and 19 of Yang's dissertation proposal (2001).
"""

import statistics

import meshStudy
import simplificationReport

PARTS = (50, 25, 10, 2)

# Synthetic meshes name the number of tetrahedra, meshes of GATUN_DATA_DIR the array; parts are the
# remaining tetrahedra in percent.
MODES = {
    "full": {
        "meshes": {"bluntfin": {"array": "Density"}, "comb": {"array": "Density"},
                   "kiefer_bracket": {"array": "vonMises_psi_pt"},
                   "delaunay": {"tets": 500000}, "flow": {"tets": 400000},
                   "big": {"tets": 5000000, "parts": (50, 2)}},
        "samples": 200000, "rounds": 5, "size": 512, "pictures": "bluntfin",
        "drawn": (50, 25, 10, 5, 2), "ratios": (0, 0.5, 0.75, 0.9, 0.98)},
    "quick": {
        "meshes": {"bluntfin": {"array": "Density"}, "comb": {"array": "Density"},
                   "delaunay": {"tets": 100000}, "flow": {"tets": 100000}},
        "samples": 50000, "rounds": 1, "size": 256, "pictures": "bluntfin", "drawn": (50, 10, 2),
        "ratios": (0, 0.5, 0.9)},
    "smoke": {
        "meshes": {"delaunay": {"tets": 3000}, "flow": {"tets": 6000}},
        "samples": 2000, "rounds": 1, "size": 64, "pictures": "flow", "drawn": (50, 10),
        "ratios": (0, 0.5)},
}


def simplify_both(runner, name, source, array, parts):
    """VTK simplifies to each percentage, Gatun to at most as many tetrahedra as VTK left; where VTK
    does nothing, to the number that was asked for."""
    files = {way: [runner.path("simplification", f"{name}-{way}{part}.vtu") for part in parts]
             for way in ("quadric", "gatun")}
    quadric = [runner.case("simplify-quadric", source, "--array", array, "--part", part / 100,
                           "--out", file, threads=1)
               for part, file in zip(parts, files["quadric"])]
    before = runner.case("simplify-build", source, "--array", array, threads=1)
    tets = [run["tets"] if run["tets"] < before["tets"] else before["tets"] * part // 100
            for part, run in zip(parts, quadric)]
    gatun = runner.case("simplify-gatun", source, "--array", array, "--tets",
                        ",".join(map(str, tets)), "--out", *files["gatun"], threads=1)
    return files, {"quadric": quadric, "gatun": gatun, "build": before}


def compare(runner, source, files, array, mode):
    compared = runner.case("simplify-compare", source, *files["quadric"], *files["gatun"],
                           "--array", array, "--samples", mode["samples"])
    count = len(files["quadric"])
    return {"original": compared["original"], "quadric": compared["meshes"][:count],
            "gatun": compared["meshes"][count:]}


def measure_mesh(runner, name, source, wanted, mode, results):
    parts = wanted.get("parts", PARTS)
    array = wanted.get("array", "Density")
    files, result = simplify_both(runner, name, source, array, parts)
    result.update(parts=parts, compared=compare(runner, source, files, array, mode))
    results["samples"] = mode["samples"]
    results["size"] = mode["size"]
    if name == mode["pictures"]:
        results["pictures"] = measure_pictures(runner, name, source, array, mode)
    result["drawn"] = measure_drawing(runner, name, source, array, mode)
    result["integrated"] = measure_integrated(runner, name, source, array, mode)
    return result


def draw(runner, shown, array, mode, *options):
    return runner.case("simplify-picture", *shown, "--array", array, "--size", mode["size"], "--rounds",
                       mode["rounds"], *options)["sizes"][0]["meshes"]


def measure_pictures(runner, name, source, array, mode):
    """Figure 19: images of the original and of both simplifications."""
    parts = mode["drawn"]
    files, _ = simplify_both(runner, name, source, array, parts)
    shown = [source, *files["gatun"], *files["quadric"]]
    pictures = [runner.images / f"{way}.png" for way in
                ("original", *(f"{way}-{part}" for way in ("gatun", "quadric") for part in parts))]
    drawn = draw(runner, shown, array, mode, "--out", *pictures)
    return {"name": name, "parts": parts, "original": drawn[0], "gatun": drawn[1:len(parts) + 1],
            "quadric": drawn[len(parts) + 1:]}


def measure_drawing(runner, name, source, array, mode):
    """Figure 18: the times of images of simplified meshes."""
    parts = mode["drawn"]
    files = [runner.path("simplification", f"{name}-drawn{part}.vtu") for part in parts]
    tets = runner.case("simplify-build", source, "--array", array, threads=1)["tets"]
    runner.case("simplify-gatun", source, "--array", array, "--tets",
                ",".join(str(tets * part // 100) for part in parts), "--out", *files, threads=1)
    return {"parts": (100, *parts), "meshes": draw(runner, (source, *files), array, mode)}


def _median(rounds):
    """The medians of the rounds of one case, with the seconds of each."""
    return {**{key: statistics.median(one[key] for one in rounds)
               for key in rounds[0] if key != "whole"},
            "rounds": [one["seconds"] for one in rounds]}


def measure_integrated(runner, name, source, array, mode):
    """Figure 17: from a file to the image of a simplified mesh; staged, integrated, and integrated
    with base meshes. The methods take turns."""
    files = {way: runner.path("simplification", f"{name}-{way}.gtn") for way in ("tree", "levels")}
    for way, options in (("tree", ("--hierarchy",)), ("levels", ("--levels", 16))):
        runner.say(f"gtn pack {' '.join(map(str, options))}")
        runner.run("gtn", "pack", "-q", *options, "--weight", array, source, files[way])
    runs = []
    for ratio in mode["ratios"]:
        ways = (("staged", "tree", ("--whole",)), ("integrated", "tree", ()), ("levels", "levels", ()))
        rounds = {way: [] for way, _, _ in ways}
        for _ in range(mode["rounds"]):
            for way, file, options in ways:
                rounds[way].append(runner.case("simplify-integrated", files[file], "--array", array,
                                               "--size", mode["size"], "--ratio", ratio, *options))
        runs.append({"ratio": ratio, **{way: _median(found) for way, found in rounds.items()}})
    return {"runs": runs,
            "bytes": {way: file.stat().st_size for way, file in files.items()}}


if __name__ == "__main__":
    meshStudy.run("simplification-study", __doc__, MODES, measure_mesh, simplificationReport.write)
