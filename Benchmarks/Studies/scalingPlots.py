# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the model of scalingModel.py; needs matplotlib."""

import benchmarkPlots
import scalingModel as model
import scalingText
from benchmarkPlots import pyplot

COLORS = ("#0072b2", "#56b4e9", "#e69f00", "#d55e00", "#009e73", "#cc79a7")
RANKS = 1000


def _stages(k, folder, done):
    """The time of each stage by ranks, for each number of cells."""
    figure, grid = pyplot.subplots(1, len(model.CELLS), figsize=(9, 3.6))
    for axes, cells in zip(grid, model.CELLS):
        ones = [model.predict(k, cells, ranks) for ranks in model.RANKS]
        for color, name in zip(COLORS, ones[0].stages):
            axes.plot(model.RANKS, [one.stages[name] or None for one in ones], "o-", color=color,
                      markersize=3, label=name)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("ranks", fontsize=8)
        axes.set_title(f"{scalingText.power(cells)} cells", fontsize=9)
        axes.tick_params(labelsize=7)
        axes.grid(alpha=0.3)
    grid[0].set_ylabel("seconds", fontsize=8)
    grid[0].legend(fontsize=6)
    benchmarkPlots.save(figure, folder, "stages", done)


def _memory(k, folder, done):
    """Memory by cells, on a fixed number of ranks."""
    cells = [10**e for e in range(7, 14)]
    ones = [model.predict(k, n, RANKS) for n in cells]
    lines = [("share of a rank", [one.share for one in ones], "-"),
             ("tables of a rank", [one.tables for one in ones], "-"),
             ("tables of rank 0", [one.first for one in ones], "-"),
             ("opening", [model.predict_opening(k.tables, one.chunks).memory for one in ones], "-")]
    if scalingText.is_paged(k):
        lines.append(("opening, tables read as a whole",
                      [model.predict_opening(k.before, one.chunks).memory for one in ones], "--"))
    figure, axes = pyplot.subplots(figsize=(6, 3.6))
    for color, (name, values, style) in zip(COLORS, lines):
        axes.plot(cells, [value / 2**20 or None for value in values], style, color=color, label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("cells", fontsize=8)
    axes.set_ylabel("MiB", fontsize=8)
    axes.set_title(f"Memory of a process, {RANKS:,} ranks write", fontsize=9)
    axes.tick_params(labelsize=7)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7)
    benchmarkPlots.save(figure, folder, "memory", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    k = model.constants(results)
    done = set()
    _stages(k, folder, done)
    _memory(k, folder, done)
    return done
