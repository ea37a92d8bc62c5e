# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runStudy.py; needs matplotlib."""

import statistics

import benchmarkPlots
import studyReport
from benchmarkPlots import pyplot

COLORS = {"gatun": "#0072b2", "small": "#56b4e9", "generic": "#d55e00", "vtu": "#e69f00"}


def _memory(results, folder, done):
    """The paper's Figure 13."""
    meshes = results["meshes"]
    figure, axes = pyplot.subplots(figsize=(8, 4))
    width = 0.8 / len(COLORS)
    for i, (way, color) in enumerate(COLORS.items()):
        values = [studyReport.memory(studyReport.find_case(
            mesh, 0, studyReport.usual_size(mesh))["ways"][way]) for mesh in meshes]
        bars = axes.bar([m + i * width for m in range(len(meshes))], values, width, color=color,
                        label=studyReport.WAYS[way])
        axes.bar_label(bars, [f"{value:,.0f}" for value in values], fontsize=7)
    axes.set_xticks([m + 1.5 * width for m in range(len(meshes))],
                    [f"{mesh['name']}\n{mesh['tets']:,}" for mesh in meshes], fontsize=8)
    axes.set_yscale("log")
    axes.set_ylim(bottom=1)
    axes.set_ylabel("MiB above the idle process")
    axes.set_title("Peak memory from file to image (Figure 13)", fontsize=10)
    axes.legend(fontsize=8)
    benchmarkPlots.save(figure, folder, "memory", done)


def _time(results, folder, done):
    """The paper's Figure 14: a row a mesh, a column a limit."""
    meshes = results["meshes"]
    columns = max(len(studyReport.limits(mesh)) for mesh in meshes)
    figure, grid = pyplot.subplots(len(meshes), columns, squeeze=False, sharex=True,
                                   figsize=(2 + 1.9 * columns, 1 + 1.9 * len(meshes)))
    for row, mesh in zip(grid, meshes):
        limits = studyReport.limits(mesh)
        times = [studyReport.seconds(runs) for case in mesh["limits"]
                 for runs in case["ways"].values() if not studyReport.failure(runs)]
        for axes in row[len(limits):]:
            axes.set_axis_off()
        for axes, limit in zip(row, limits):
            for i, (way, color) in enumerate(COLORS.items()):
                # Crosses one above the other.
                _draw_line(axes, mesh, limit, way, color, 1.5 * max(times) * 1.4**i)
            axes.set_yscale("log")
            axes.set_ylim(0.7 * min(times), 6 * max(times))
            axes.set_xscale("log", base=2)
            axes.set_xticks(studyReport.sizes(mesh), studyReport.sizes(mesh), fontsize=6)
            axes.tick_params(axis="y", labelsize=6, which="both")
            axes.set_title(f"{mesh['name']}, {studyReport.limit_text(limit)}", fontsize=7)
            axes.grid(alpha=0.3)
        row[0].set_ylabel("seconds", fontsize=7)
    grid[0][0].legend(fontsize=6)
    figure.suptitle("Time from file to image by its width; a cross: no image (Figure 14)",
                    fontsize=10)
    benchmarkPlots.save(figure, folder, "time", done)


def _draw_line(axes, mesh, limit, way, color, top):
    """Times of a way by size; crosses at a height where it fails."""
    worked = []
    failed = []
    for size in studyReport.sizes(mesh):
        runs = studyReport.find_case(mesh, limit, size)["ways"][way]
        if studyReport.failure(runs):
            failed.append((size, top))
        else:
            worked.append((size, studyReport.seconds(runs)))
    axes.plot([x for x, _ in worked], [y for _, y in worked], "o-", color=color, markersize=3,
              linewidth=1, label=studyReport.WAYS[way])
    axes.plot([x for x, _ in failed], [y for _, y in failed], "x", color=color, markersize=5)


def _release(results, folder, done):
    """Both ends against the front only."""
    rows = []
    for mesh in results["meshes"]:
        for release in mesh.get("release", []):
            for light, ends, front, both in studyReport.release_cases(release):
                rows.append((f"{mesh['name']}, {release['chunks']} chunk"
                             f"{'s' if release['chunks'] > 1 else ''}, {light}, "
                             f"{'rays end' if ends else 'rays go on'}", front, both))
    if not rows:
        return
    series = [("waiting", "#0072b2", [both["mostWaiting"] / max(1, front["mostWaiting"])
                                      for _, front, both in rows]),
              ("fragments", "#e69f00", [both["mostFragments"] / front["mostFragments"]
                                        for _, front, both in rows]),
              ("time", "#d55e00", [statistics.median(
                  b / a for a, b in zip(front["seconds"], both["seconds"]))
                  for _, front, both in rows])]
    figure = benchmarkPlots.grouped([name for name, _, _ in rows], series,
                                    "Release from both ends against the front only",
                                    "times as much")
    figure.axes[0].axvline(1, color="black", linewidth=1)
    figure.axes[0].margins(y=0.01)
    benchmarkPlots.save(figure, folder, "release", done)


def _prefilter(results, folder, done):
    figure, axes = pyplot.subplots(figsize=(7, 4))
    for i, mesh in enumerate(mesh for mesh in results["meshes"] if "prefilter" in mesh):
        pairs = studyReport.prefilter_pairs(mesh)
        axes.plot([size for size, _, _ in pairs],
                  [studyReport.dropped(on) for _, on, _ in pairs], "o-",
                  color=benchmarkPlots.STAGES[i], label=mesh["name"])
        axes.set_xscale("log", base=2)
        axes.set_xticks([size for size, _, _ in pairs], [size for size, _, _ in pairs])
    axes.set_ylim(0, 100)
    axes.set_xlabel("width of the image, pixels")
    axes.set_ylabel("% of the tetrahedra")
    axes.set_title("Dropped by the pre-filter", fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    benchmarkPlots.save(figure, folder, "prefilter", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    for make in _memory, _time, _release, _prefilter:
        make(results, folder, done)
    return done
