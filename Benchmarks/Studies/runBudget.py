#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""How well just-in-time rendering keeps to a time along a recorded camera path: fast, slowly, and at
rest. Puts a table into just-in-time.md, between its marks, and figures and a plot into the folder
just-in-time."""

import json
import os
import pathlib
import statistics
import sys
import tempfile
import time

import benchmarkRunner
import benchmarkText

MODES = {
    "full": {"meshes": {"delaunay": 1000000, "flow1": 5000000}, "frames": 60,
             "budgets": (0.033, 0.1, 0.5), "size": 512},
    "quick": {"meshes": {"delaunay": 100000}, "frames": 30, "budgets": (0.033, 0.1), "size": 256},
    "smoke": {"meshes": {"lattice": 5000}, "frames": 3, "budgets": (0.1,), "size": 64},
}
NAMES = {"delaunay": "Delaunay mesh of a ball", "flow1": "structured grid around a nose",
         "lattice": "jittered lattice"}
BEGIN, END = "<!-- measured -->\n", "<!-- end of what was measured -->\n"


# --------------------------------------------------------------------------------------------------
# Measuring


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
        sys.exit(f"runBudget.py: a picture at rest differs from the full one by {worst} of 255")
    return results


# --------------------------------------------------------------------------------------------------
# The page


def is_whole(mesh, track, i):
    return track["points"][i] in (0, mesh["points"]) and track["distances"][i] == 1


def shares(mesh, path, phases=("fast", "slow")):
    """Of the pictures in motion: in time, and in time without being simpler than need be."""
    budget, in_time, good, count = path["budget"], 0, 0, 0
    for phase in phases:
        track = path[phase]
        for i, seconds in enumerate(track["seconds"]):
            count += 1
            in_time += seconds <= 1.25 * budget
            good += seconds <= 1.25 * budget and (
                seconds >= 0.75 * budget or is_whole(mesh, track, i))
    return in_time / count, good / count


def rows(results):
    for mesh in results["meshes"]:
        for way, text in (("simplified", "points, rays"), ("rays", "rays")):
            one = mesh[way]
            for path in one["paths"]:
                seconds = path["fast"]["seconds"] + path["slow"]["seconds"]
                in_time, good = shares(one, path)
                points = statistics.median(path["slow"]["points"])
                yield [f"{NAMES[mesh['name']]}, {one['tets']:,}", text,
                       f"{1000 * path['budget']:.0f}",
                       f"{100 * in_time:.0f} %", f"{100 * good:.0f} %",
                       f"{1000 * statistics.median(seconds):.0f}", f"{1000 * max(seconds):.0f}",
                       f"{points:,.0f}" if points else "all",
                       f"{statistics.median(path['slow']['distances']):.1f}",
                       f"{path['rest']:.2f}", path["difference"]]


def text_of(results, plots):
    mode = MODES[results["mode"]]
    head = ["mesh", "what gets fewer", "budget, ms", "in time", "and not too early", "median, ms",
            "worst, ms", "points", "distance of rays", "rest, s", "difference at rest"]
    parts = [benchmarkText.machine(results["machine"]),
             benchmarkText.paragraph(f"""A path of {mode['frames']} pictures turned by 7 degrees each
and as many by 0.4 degrees, then one at rest; {mode['size']} by {mode['size']} pixels. *In time*: at
most 1.25 times the budget; *not too early*: at least 0.75 times, unless nothing was simplified.
Points and distances of rays (in pixels) are those of the slow part, in the median. Where only rays
get fewer, the mapper is as it is without just-in-time rendering. *Rest*: from the last picture in
motion to the full one, whose largest difference from that of a mapper that simplifies nothing is told
last, of 255."""), benchmarkText.table(head, rows(results))]
    for mesh in results["meshes"]:
        one = mesh["simplified"]
        parts.append(benchmarkText.paragraph(f"""{NAMES[mesh['name']]}: how to simplify it was known
{one['first'] + one['prepare']:.0f} s after it was there, in the background; the whole picture takes
{one['whole']:.2f} s."""))
    if "times" in plots:
        parts.append("![Times of the pictures](just-in-time/times.png)\n")
    return "\n".join(parts)


def plot(results, folder):
    """Where matplotlib is."""
    try:
        import benchmarkPlots  # pylint: disable=import-outside-toplevel
    except ImportError:
        return set()
    pyplot = benchmarkPlots.pyplot
    columns = len(results["meshes"][0]["simplified"]["paths"])
    figure, grid = pyplot.subplots(len(results["meshes"]), columns, squeeze=False, sharex=True,
                                   figsize=(1 + 3.2 * columns, 0.7 + 2.4 * len(results["meshes"])))
    for row, mesh in zip(grid, results["meshes"]):
        for i, axes in enumerate(row):
            for way, colour, text in (("rays", "#e69f00", "fewer rays"),
                                      ("simplified", "#0072b2", "fewer points and rays")):
                path = mesh[way]["paths"][i]
                times = [1000 * s for phase in ("fast", "slow") for s in path[phase]["seconds"]]
                axes.plot(times, color=colour, linewidth=1, label=text)
            budget = 1000 * path["budget"]
            axes.axhspan(0.75 * budget, 1.25 * budget, color="#009e73", alpha=0.2)
            axes.axvline(len(path["fast"]["seconds"]) - 0.5, color="#999999", linewidth=0.8)
            axes.set_ylim(0, 3 * budget)
            axes.set_title(f"{mesh['simplified']['tets']:,} tetrahedra, {budget:.0f} ms",
                           fontsize=8)
            axes.tick_params(labelsize=7)
        row[0].set_ylabel("ms", fontsize=8)
    grid[-1][0].set_xlabel("picture", fontsize=8)
    grid[0][0].legend(fontsize=7)
    done = set()
    benchmarkPlots.save(figure, folder, "times", done)
    return done


def write(results, out, folder):
    text = text_of(results, plot(results, folder))
    page = out / "just-in-time.md"
    old = page.read_text(encoding="utf-8") if page.exists() else BEGIN + END
    before, rest = old.split(BEGIN, 1)
    page.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END, 1)[1],
                    encoding="utf-8")
    return page


def main():
    parser = benchmarkRunner.make_parser(__doc__, "just-in-time")
    parser.add_argument("--mesh", action="append", default=[], metavar="KIND=FILE",
                        help="a file to take for a mesh that would be made (delaunay, flow1)")
    options = parser.parse_args()
    folder = options.out / "just-in-time"
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    if options.report:
        results = json.loads(raw.read_text(encoding="utf-8"))
    else:
        with tempfile.TemporaryDirectory(prefix="gatun-budget-") as work:
            results = measure(benchmarkRunner.Runner(options.programs, pathlib.Path(work)), options)
        raw.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print(f"The results are in {write(results, options.out, folder)} and {folder}")


if __name__ == "__main__":
    sys.exit(main())
