# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runErrors.py; needs matplotlib."""

import benchmarkPlots
import errorReport
from benchmarkPlots import pyplot

PEERS = {"SZ3": "#d55e00", "zfp": "#e69f00", "xz": "#009e73", "zlib": "#999999"}


def _draw_panel(axes, mesh, row):
    bounds = [one["bound"] for one in row["bounds"]]
    axes.plot(bounds, [errorReport.bits(row, one["gtn"]) for one in row["bounds"]], "o-", color="#0072b2",
              markersize=3, label="ours")
    for name, color in PEERS.items():
        sizes = [errorReport.peer_bytes(one, name) for one in row["bounds"]]
        if all(sizes):
            axes.plot(bounds, [errorReport.bits(row, size) for size in sizes], ".-", color=color, markersize=3,
                      linewidth=1, label=name if name in ("SZ3", "zfp") else f"rounding, {name}")
    axes.axhline(errorReport.bits(row, row["exact"]), color="black", linewidth=0.7, linestyle=":", label="ours, exact")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.invert_xaxis()
    axes.set_title(errorReport.label(mesh, row), fontsize=7)
    axes.tick_params(labelsize=6)
    axes.grid(alpha=0.3)


def _rates(results, folder, done):
    panels = errorReport.components(results)
    columns = 4
    lines = -(-len(panels) // columns)
    figure, grid = pyplot.subplots(lines, columns, squeeze=False, figsize=(12, 0.8 + 2.1 * lines))
    for axes, (mesh, row) in zip(grid.flat, panels):
        _draw_panel(axes, mesh, row)
    for axes in grid.flat[len(panels):]:
        axes.set_axis_off()
    for line in grid:
        line[0].set_ylabel("bits a value", fontsize=7)
    figure.legend(*grid[0][0].get_legend_handles_labels(), fontsize=8, ncol=6, loc="lower center")
    height = 0.8 + 2.1 * lines
    figure.suptitle("Bits a value by the bound, relative to the range", fontsize=10, y=1 - 0.15 / height)
    figure.tight_layout(rect=(0, 0.4 / height, 1, 1 - 0.25 / height))
    figure.savefig(folder / "rates.png", dpi=100, metadata={"Software": None})
    pyplot.close(figure)
    done.add("rates")


def _ratios(results, folder, done):
    panels = errorReport.components(results)
    bounds = [bound for bound in errorReport.QUOTED
              if errorReport.ratios(results, bound, "SZ3", "zfp")]
    if not bounds:
        return
    figure, axes = pyplot.subplots(figsize=(9, 1 + 0.22 * len(panels)))
    for bound, color in zip(bounds, ("#56b4e9", "#0072b2", "#003f66")):
        axes.plot([errorReport.peer_ratio(row, bound, "SZ3", "zfp") for _, row in panels], range(len(panels)), "o",
                  color=color, label=f"{bound:g}")
    axes.axvline(1, color="black", linewidth=1)
    axes.set_xscale("log")
    ticks = (0.7, 1, 1.5, 2, 3, 5, 8, 12)
    axes.set_xticks(ticks, ticks)
    axes.minorticks_off()
    axes.set_yticks(range(len(panels)), [errorReport.label(*panel) for panel in panels], fontsize=7)
    axes.invert_yaxis()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, title="bound")
    axes.set_xlabel("bytes of the best of SZ3 and zfp over ours; above 1: ours is smaller")
    benchmarkPlots.save(figure, folder, "ratios", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    for make in _rates, _ratios:
        make(results, folder, done)
    return done
