# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runSeries.py; needs matplotlib."""

import statistics

import benchmarkPlots
import seriesReport
from benchmarkPlots import pyplot


def draw(results, folder):
    """Writes all plots; returns their names."""
    series = results["series"]
    bars = [("bytes", "#0072b2", [seriesReport.smaller(one) for one in series])]
    bars += [("time, to the next step", "#56b4e9", [statistics.median(seriesReport.faster_later(one)) for one in series])]
    bars += [(f"time, {way}", color, [statistics.median(seriesReport.faster(one, way)) for one in series])
             for way, color in zip(seriesReport.WAYS, ("#009e73", "#e69f00"))]
    figure, axes = pyplot.subplots(figsize=(9, 0.9 + 0.95 * len(series)))
    for i, (name, color, values) in enumerate(bars):
        drawn = axes.barh([g + 0.2 * i for g in range(len(series))], values, 0.2, color=color, label=name)
        axes.bar_label(drawn, [f"{value:.2f}" for value in values], padding=2, fontsize=7,
                       bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})
    axes.axvline(1, color="black", linewidth=1)
    axes.set_xscale("log")
    axes.margins(x=0.1)
    axes.set_yticks([g + 0.3 for g in range(len(series))], [seriesReport.label(one) for one in series], fontsize=8)
    axes.invert_yaxis()
    axes.set_xlabel(".vtu (zlib) over ours; above 1: ours is smaller or faster")
    axes.legend(fontsize=8)
    done = set()
    benchmarkPlots.save(figure, folder, "series", done)
    return done
