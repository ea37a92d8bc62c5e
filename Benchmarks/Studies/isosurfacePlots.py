# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runIsosurfaces.py; needs matplotlib."""

import statistics

import benchmarkPlots
import isosurfaceReport
from benchmarkPlots import pyplot

COLORS = {"layers": "#0072b2", "spatial": "#56b4e9", "zlib": "#e69f00", "raw": "#999999",
           "span": "#d55e00"}
SHORT = {"layers": "Gatun, layers", "spatial": "Gatun", "zlib": "zlib .vtu, 3DLinearGrid",
         "raw": "raw .vtu, 3DLinearGrid", "span": "zlib .vtu, SpanSpace"}


def _cold(results, folder, done):
    """Means over the isovalues."""
    meshes = results["meshes"]
    measures = (("seconds", "ms", lambda run: 1000 * run["seconds"]),
                ("bytes read", "MiB", lambda run: run["bytes"] / 2**20),
                ("memory", "MiB", lambda run: isosurfaceReport.memory(run) / 2**20))
    figure, grid = pyplot.subplots(1, 3, figsize=(11, 3.4))
    for axes, (name, unit, what) in zip(grid, measures):
        for i, (way, color) in enumerate(COLORS.items()):
            axes.bar([m + 0.16 * i for m in range(len(meshes))],
                     [statistics.fmean(what(run[way]) for run in mesh["cold"]) for mesh in meshes],
                     0.16, color=color, label=SHORT[way])
        axes.set_yscale("log")
        axes.set_xticks([m + 0.32 for m in range(len(meshes))],
                        [mesh["name"] for mesh in meshes], fontsize=7)
        axes.set_ylabel(unit, fontsize=8)
        axes.set_title(name, fontsize=9)
        axes.tick_params(labelsize=7)
    grid[0].legend(fontsize=6)
    benchmarkPlots.save(figure, folder, "cold", done)


def _layers(results, folder, done):
    figure, grid = pyplot.subplots(1, 3, figsize=(11, 3.4))
    for mesh, color in zip(results["meshes"], benchmarkPlots.STAGES):
        counts = [one["layers"] for one in mesh["sweep"]]
        series = ([one["bytes"] / mesh["bytes"]["spatial"] for one in mesh["sweep"]],
                  [100 * statistics.fmean(run["tetsUsed"] for run in one["runs"]) / mesh["tets"]
                   for one in mesh["sweep"]],
                  [1000 * statistics.fmean(run["seconds"] for run in one["runs"])
                   for one in mesh["sweep"]])
        for axes, values in zip(grid, series):
            axes.plot(counts, values, "o-", color=color, markersize=3, label=mesh["name"])
    for axes, title in zip(grid, ("size of the file / size without layers",
                                  "% of the tetrahedra decoded", "ms to the surface")):
        axes.set_xscale("log", base=2)
        axes.set_xlabel("layers", fontsize=8)
        axes.set_title(title, fontsize=9)
        axes.tick_params(labelsize=7)
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
    grid[0].legend(fontsize=7)
    benchmarkPlots.save(figure, folder, "layers", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    _cold(results, folder, done)
    _layers(results, folder, done)
    return done
