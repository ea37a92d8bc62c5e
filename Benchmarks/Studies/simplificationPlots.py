# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runSimplification.py; needs matplotlib."""

import statistics

import benchmarkPlots
import simplificationReport
import simplificationTimes
from benchmarkPlots import pyplot

COLORS = {"quadric": "#d55e00", "gatun": "#0072b2"}
NAMES = {"quadric": "VTK", "gatun": "Gatun"}


def _percent(axes, parts, label):
    axes.set_xscale("log")
    axes.set_xticks(parts, parts)
    axes.minorticks_off()
    axes.invert_xaxis()
    axes.set_xlabel("% of the tetrahedra remaining", fontsize=8)
    axes.set_ylabel(label, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(alpha=0.3)


def _field(results, folder, done):
    meshes = [mesh for mesh in results["meshes"] if simplificationReport.cases(mesh)]
    if not meshes:
        return
    figure, grid = pyplot.subplots(1, len(meshes), squeeze=False,
                                   figsize=(2.3 * len(meshes) + 0.5, 3))
    for axes, mesh in zip(grid[0], meshes):
        for way, color in COLORS.items():
            axes.plot([part for part, _, _ in simplificationReport.cases(mesh)],
                      [{"quadric": quadric, "gatun": gatun}[way]["rms"]
                       for _, quadric, gatun in simplificationReport.cases(mesh)],
                      "o-", color=color, markersize=3, label=NAMES[way])
        axes.set_yscale("log")
        axes.set_title(mesh["name"], fontsize=9)
        _percent(axes, [part for part, _, _ in simplificationReport.cases(mesh)],
                 "RMS error / range")
    grid[0][0].legend(fontsize=8)
    benchmarkPlots.save(figure, folder, "field", done)


def _figure19(results, folder, done):
    shown = results["pictures"]
    figure, axes = pyplot.subplots(figsize=(5, 3.5))
    for way, color in COLORS.items():
        axes.plot(shown["parts"], [mesh["rms"] for mesh in shown[way]], "o-", color=color,
                  markersize=3, label=NAMES[way])
    axes.set_ylim(bottom=0)
    axes.set_title(f"{shown['name']}: RMS difference of images (Figure 19)", fontsize=9)
    axes.legend(fontsize=8)
    _percent(axes, shown["parts"], "of colors, 0 to 1")
    benchmarkPlots.save(figure, folder, "figure19", done)


def _for_each_mesh(results):
    """A row of diagrams, one a mesh."""
    meshes = results["meshes"]
    figure, grid = pyplot.subplots(1, len(meshes), squeeze=False,
                                   figsize=(2.3 * len(meshes) + 0.5, 3))
    return figure, list(zip(grid[0], meshes))


def _figure18(results, folder, done):
    figure, grid = _for_each_mesh(results)
    for axes, mesh in grid:
        for kind, color in (("volumeSeconds", "#0072b2"), ("areaSeconds", "#e69f00")):
            axes.plot(mesh["drawn"]["parts"],
                      [1000 * statistics.median(one[kind]) for one in mesh["drawn"]["meshes"]], "o-",
                      color=color, markersize=3, label=simplificationTimes.KINDS[kind])
        axes.set_ylim(bottom=0)
        axes.set_title(mesh["name"], fontsize=9)
        _percent(axes, mesh["drawn"]["parts"], "milliseconds")
    grid[0][0].legend(fontsize=8)
    benchmarkPlots.save(figure, folder, "figure18", done)


def _figure17(results, folder, done):
    figure, grid = _for_each_mesh(results)
    for axes, mesh in grid:
        runs = mesh["integrated"]["runs"]
        for way, color, name in (("staged", "#d55e00", "one after the other"),
                                  ("integrated", "#0072b2", "all in one"),
                                  ("levels", "#009e73", "with base meshes")):
            axes.plot([run["ratio"] for run in runs], [run[way]["seconds"] for run in runs], "o-",
                      color=color, markersize=3, label=name)
        axes.set_ylim(bottom=0)
        axes.set_title(mesh["name"], fontsize=9)
        axes.set_xlabel("fraction of points removed", fontsize=8)
        axes.set_ylabel("seconds", fontsize=8)
        axes.tick_params(labelsize=7)
        axes.grid(alpha=0.3)
    grid[0][0].legend(fontsize=8)
    benchmarkPlots.save(figure, folder, "figure17", done)


def _pictures(results, folder, done):
    """The original and some simplified meshes, Gatun above VTK; the single images are deleted."""
    shown = results["pictures"]
    parts = [part for part in (50, 10, 2) if part in shown["parts"]]
    if (folder / "original.png").exists():
        figure, grid = pyplot.subplots(2, 1 + len(parts), figsize=(3 * (1 + len(parts)), 6.4))
        for row, way in zip(grid, ("gatun", "quadric")):
            names = ["original", *(f"{way}-{part}" for part in parts)]
            titles = ["whole", *(f"{NAMES[way]}, {part} %" for part in parts)]
            for axes, name, title in zip(row, names, titles):
                axes.imshow(pyplot.imread(folder / f"{name}.png"), origin="upper")
                axes.set_title(title, fontsize=9)
                axes.set_axis_off()
        benchmarkPlots.save(figure, folder, "pictures", done)
        for part in shown["parts"]:
            for way in NAMES:
                (folder / f"{way}-{part}.png").unlink(missing_ok=True)
        (folder / "original.png").unlink()
    elif (folder / "pictures.png").exists():
        done.add("pictures")


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    for make in _field, _figure17, _figure18:
        make(results, folder, done)
    if "pictures" in results:
        for make in _figure19, _pictures:
            make(results, folder, done)
    return done
