# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runDetail.py; needs matplotlib."""

import benchmarkPlots
import detailReport
from benchmarkPlots import pyplot

WAYS = (("uniform", "#e69f00", "uniform"), ("view", "#0072b2", "for the view"))


def draw(results, folder):
    """Writes all plots; returns their names."""
    meshes = results["meshes"]
    columns = len(meshes[0]["pictures"]["places"])
    figure, grid = pyplot.subplots(len(meshes), columns, squeeze=False,
                                   figsize=(1 + 2.2 * columns, 0.7 + 2.4 * len(meshes)))
    for row, mesh in zip(grid, meshes):
        for place, axes in zip(mesh["pictures"]["places"], row):
            for way, color, text in WAYS:
                axes.loglog([one["tets"] for one in place[way]],
                            [max(one["rms"], 1e-3) for one in place[way]], "o-", color=color,
                            markersize=3, linewidth=1, label=text)
            axes.set_title(f"{detailReport.name_of(mesh)}, {place['part']:.2f}", fontsize=7)
            axes.tick_params(labelsize=7)
        row[0].set_ylabel("RMS, of 255", fontsize=8)
    grid[-1][0].set_xlabel("tetrahedra", fontsize=8)
    grid[0][0].legend(fontsize=7)
    done = set()
    benchmarkPlots.save(figure, folder, "errors", done)
    return done
