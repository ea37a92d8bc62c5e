# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runBudget.py."""

import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, span, table

PAGE = "just-in-time-study"
NAMES = {"delaunay": "Delaunay mesh of a ball", "flow1": "structured grid around a nose",
         "lattice": "jittered lattice"}


def is_whole(mesh, track, i):
    return track["points"][i] in (0, mesh["points"]) and track["distances"][i] == 1


def frames(path):
    return path["fast"]["seconds"] + path["slow"]["seconds"]


def shares(mesh, path):
    """Of the frames in motion: those in time, and those in time that use the time they have."""
    budget, in_time, good, count = path["budget"], 0, 0, 0
    for track in path["fast"], path["slow"]:
        for i, seconds in enumerate(track["seconds"]):
            count += 1
            in_time += seconds <= 1.25 * budget
            good += seconds <= 1.25 * budget and (
                seconds >= 0.75 * budget or is_whole(mesh, track, i))
    return in_time / count, good / count


def _rows(results):
    for mesh in results["meshes"]:
        for way, text in (("simplified", "points, rays"), ("rays", "rays")):
            one = mesh[way]
            for path in one["paths"]:
                seconds = [1000 * s for s in frames(path)]
                in_time, good = shares(one, path)
                points = statistics.median(path["slow"]["points"])
                quarters = statistics.quantiles(seconds, n=4)
                yield [f"{NAMES[mesh['name']]}, {one['tets']:,}", text,
                       f"{1000 * path['budget']:.0f}",
                       f"{100 * in_time:.0f} %", f"{100 * good:.0f} %",
                       f"{statistics.median(seconds):.0f} ({quarters[0]:.0f} to {quarters[2]:.0f})",
                       f"{max(seconds):.0f}", f"{points:,.0f}" if points else "all",
                       f"{statistics.median(path['slow']['distances']):.1f}",
                       f"{path['rest']:.2f}", path["difference"]]


def _head(results):
    return """# The just-in-time study

How well `vtkGatunVolumeMapper` keeps a time budget with `JustInTime` on ([guide](../just-in-time.md)).
`Utilities/bench.sh --budget` (Benchmarks/Studies/runBudget.py) writes this page. All results,
including the time of each frame, are in [results.json](just-in-time-study/results.json).

""" + benchmarkText.machine(results, "")


def _table(results):
    path = results["meshes"][0]["simplified"]["paths"][0]
    count, size = len(path["fast"]["seconds"]), results["meshes"][0]["simplified"]["size"]
    head = ["mesh", "reduced", "budget, ms", "in time", "in time, not early", "median (quartiles), ms",
            "worst, ms", "points", "ray distance", "rest, s", "difference at rest"]
    text = "## Frames in time\n\n" + paragraph(f"""The camera path has {count} frames turned by 7 degrees
        each, {count} frames turned by 0.4 degrees each, and one frame at rest. Images have {size} x
        {size} pixels, and meshes are in memory. *In time*: at most 1.25 times the budget. *Not
        early*: at least 0.75 times the budget, unless nothing was reduced. *Points* and the *ray
        distance* in pixels are the medians of the slow part. Where only rays are reduced, the mapper
        works as it does without just-in-time rendering. *Rest* is the time from the last frame in
        motion to the full image. *Difference at rest* is the largest difference of that image from
        one of a mapper that never simplifies, of 255.""") + "\n"
    return text + table(head, _rows(results))


def _meshes(results, plots):
    parts = []
    for mesh in results["meshes"]:
        one = mesh["simplified"]
        parts.append(paragraph(f"""{NAMES[mesh['name']]}: the order of the merges was known
            {number(one['first'] + one['prepare'])} s after the mesh was set, computed in the background.
            The full image takes {one['whole']:.2f} s. With reduced points the frames took
            {span([1000 * s for path in one['paths'] for s in frames(path)])} ms over all
            budgets."""))
    return "\n".join(parts) + "\n" + image(plots, "times", "Times of the frames", PAGE)


def page(results, plots):
    parts = [_head(results), _table(results), _meshes(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "budgetPlots")
