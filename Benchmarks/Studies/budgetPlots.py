# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runBudget.py; needs matplotlib."""

import benchmarkPlots
import budgetReport
from benchmarkPlots import pyplot

WAYS = (("rays", "#e69f00", "fewer rays"), ("simplified", "#0072b2", "fewer points and rays"))


def _draw_path(axes, mesh, i):
    for way, color, text in WAYS:
        path = mesh[way]["paths"][i]
        axes.plot([1000 * s for s in budgetReport.frames(path)], color=color, linewidth=1, label=text)
    budget = 1000 * path["budget"]
    axes.axhspan(0.75 * budget, 1.25 * budget, color="#009e73", alpha=0.2)
    axes.axvline(len(path["fast"]["seconds"]) - 0.5, color="#999999", linewidth=0.8)
    axes.set_ylim(0, 3 * budget)
    axes.set_title(f"{mesh['simplified']['tets']:,} tetrahedra, {budget:.0f} ms", fontsize=8)
    axes.tick_params(labelsize=7)


def draw(results, folder):
    """Writes all plots; returns their names."""
    meshes = results["meshes"]
    columns = len(meshes[0]["simplified"]["paths"])
    figure, grid = pyplot.subplots(len(meshes), columns, squeeze=False, sharex=True,
                                   figsize=(1 + 3.2 * columns, 0.7 + 2.4 * len(meshes)))
    for row, mesh in zip(grid, meshes):
        for i, axes in enumerate(row):
            _draw_path(axes, mesh, i)
        row[0].set_ylabel("ms", fontsize=8)
    grid[-1][0].set_xlabel("frame", fontsize=8)
    grid[0][0].legend(fontsize=7)
    done = set()
    benchmarkPlots.save(figure, folder, "times", done)
    return done
