# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runSurfaces.py; needs matplotlib."""

import benchmarkPlots
from benchmarkPlots import pyplot

WAYS = {"gtn": ("#0072b2", ".gtn, just in time"), "vtp": ("#d55e00", ".vtp, ParaView's LOD")}


def _motion(motion, folder, done):
    """Times of frames above, and points below."""
    paths = motion["paths"]
    figure, grid = pyplot.subplots(2, len(paths), squeeze=False, sharex=True,
                                   figsize=(1 + 4 * len(paths), 4.6))
    for (times, points), path in zip(zip(*grid), paths):
        budget = 1000 * path["budget"]
        for way, (color, text) in WAYS.items():
            times.plot([1000 * s for s in path[way]["frames"]], color=color, linewidth=1, label=text)
            points.plot(path[way]["points"], color=color, linewidth=1)
        times.axhspan(0, 1.25 * budget, color="#009e73", alpha=0.2)
        times.set_ylim(0, 3 * budget)
        times.set_title(f"{budget:.0f} ms", fontsize=9)
        points.set_ylim(bottom=0)
        points.set_xlabel("frame", fontsize=8)
        for axes in times, points:
            axes.tick_params(labelsize=7)
            axes.grid(alpha=0.3)
    grid[0][0].set_ylabel("ms", fontsize=8)
    grid[1][0].set_ylabel("points drawn", fontsize=8)
    grid[0][0].legend(fontsize=7)
    benchmarkPlots.save(figure, folder, "motion", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    if "motion" in results:
        _motion(results["motion"], folder, done)
    return done
