# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the study of time series."""

import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, ratio, rounds_of, spread, table, verdict

PAGE = "series-study"
# What the project wants of points that move: bytes of .vtu files over ours by error, and their time to step over
# ours: at least, and better.
SIZE_GOALS = {0: (5, 8), 1e-4: (20, 40)}
STEP_GOAL = (5, 10)
WAYS = ("forward", "at random")


def label(one):
    what = "points that move" if one["moving"] else "points that stand still"
    return f"{what}, {'rel:%g' % one['error'] if one['error'] else 'lossless'}"


def seconds(one, case):
    return next(found["seconds"] for found in one["cases"] if found["case"] == case)


def smaller(one):
    return one["vtuBytes"] / one["gtnBytes"]


def faster(one, way):
    """By round."""
    return rounds_of(zip(seconds(one, f"vtu-zlib {way}"), seconds(one, f"gtn {way}")))


def later_seconds(one, name):
    """Seconds a step after the first one, forward, by round."""
    return [max(whole - first, 1e-9) / (one["steps"] - 1)
            for whole, first in zip(seconds(one, f"{name} forward"), seconds(one, f"{name} first"))]


def faster_later(one):
    """By round, at steps after the first one."""
    return rounds_of(zip(later_seconds(one, "vtu-zlib"), later_seconds(one, "gtn")))


def _head(results):
    return "# Time series\n\n" + paragraph("""Sizes of a `.gtn` file with many time steps ([guide](../time-series.md))
        and the time to step through it, beside a zlib `.vtu` file for each step. `Utilities/bench.sh --series`
        (Benchmarks/Studies/runSeries.py) writes this page. All results are in
        [results.json](series-study/results.json).""") + "\n" + benchmarkText.machine(results)


def _method(results):
    one = results["series"][0]
    return "## What is measured\n\n" + paragraph(f"""The mesh ({one["mesh"]}) has {one["tets"]:,} tetrahedra and an
        array of one number a point, a warm blob that wanders and grows and a wave that passes by, in binary32. Where
        points move, the mesh bends, twists and swells smoothly, too. There are {one["steps"]} steps. With
        *rel:0.0001*, the array has an error of at most 1e-4 of its range, and coordinates one of at most 1e-4 of the
        longest side; `.vtu` files have all values without loss. A *step* is an update of vtkGatunReader, or of
        vtkXMLUnstructuredGridReader with the next file, to a whole vtkUnstructuredGrid in memory. Times *forward* and
        *at random* include the first step, at which the mesh is read, too; *to the next step* is the time forward
        without that of the first step, by the number of other steps. Files are in the page cache. Prefetching, which hides part of the time
        in an interactive session, is off.""")


def _goal_rows(results):
    rows = []

    def add(what, value, goal):
        rows.append((what, ratio(value), goal[0], goal[1], verdict(value, goal)))
    for one in results["series"]:
        if one["moving"]:
            add(f"bytes of .vtu / ours, {label(one)}", smaller(one), SIZE_GOALS[one["error"]])
            add(f"time of .vtu / ours, to the next step, {label(one)}", statistics.median(faster_later(one)), STEP_GOAL)
            add(f"time of .vtu / ours, forward with the first step, {label(one)}",
                statistics.median(faster(one, "forward")), STEP_GOAL)
    return rows


def _sizes(results, plots):
    rows = [(label(one), f"{one['vtuBytes'] / 1e6:,.1f}", f"{one['gtnBytes'] / 1e6:,.1f}", ratio(smaller(one)))
            for one in results["series"]]
    return ("## Sizes\n\n" + image(plots, "series", "Bytes and time of .vtu files over ours", PAGE) + "\n"
            + table(["series", ".vtu, zlib (MB)", "ours (MB)", ".vtu / ours"], rows))


def _steps(results):
    rows = []
    for one in results["series"]:
        cells = [spread([1000 * s for s in later_seconds(one, name)], number) for name in ("vtu-zlib", "gtn")]
        rows.append((label(one), "to the next step", *cells, spread(faster_later(one), ratio)))
        for way in WAYS:
            cells = [spread([1000 * s / one["steps"] for s in seconds(one, f"{name} {way}")], number)
                     for name in ("vtu-zlib", "gtn")]
            rows.append((label(one), way, *cells, spread(faster(one, way), ratio)))
    return "## Steps\n\n" + table(["series", "order", ".vtu, zlib (ms a step)", "ours (ms a step)", ".vtu / ours"],
                                  rows) + "\n" + paragraph("""A step at random also decodes the steps from the last
        key step on. Every eighth step is a key step.""")


def conclude(results):
    """The main result, for the page in front of the studies."""
    parts = [f"{label(one)}: {ratio(smaller(one))} times smaller and, step by step, "
             f"{ratio(statistics.median(faster_later(one)))} times as fast" for one in results["series"]]
    missed = [row[0] for row in _goal_rows(results) if row[-1] == "not met"]
    return ("A `.gtn` file of a whole series, beside a zlib `.vtu` file for each step: " + "; ".join(parts) + ". "
            + ("All goals are met." if not missed else f"Goals that are not met: {'; '.join(missed)}."))


def page(results, plots):
    goals = "## Goals\n\n" + table(["quantity", "measured", "goal", "target", "verdict"], _goal_rows(results))
    parts = (_head(results), _method(results), goals, _sizes(results, plots), _steps(results))
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "seriesPlots")
