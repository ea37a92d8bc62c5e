# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runVolumes.py; needs matplotlib."""

import pathlib

import benchmarkPlots
import volumeReport
from benchmarkPlots import pyplot

COLORS = benchmarkPlots.STAGES


def _style(axes, title, across, up):
    axes.set_title(title, fontsize=9)
    axes.set_xlabel(across, fontsize=8)
    axes.set_ylabel(up, fontsize=8)
    axes.tick_params(labelsize=7)
    axes.grid(alpha=0.3)


def _ticks(axes, blocks):
    axes.set_xscale("log", base=2)
    axes.set_xticks(blocks, blocks)


def _tables(results, folder, done):
    """Tables 1 and 2, of the fourth view, which is along no axis."""
    figure, grid = pyplot.subplots(1, 2, figsize=(10, 4))
    for axes, paper, column in ((grid[0], volumeReport.PAPER1, 3), (grid[1], volumeReport.PAPER2, 1)):
        axes.plot(list(paper), [row[column] for row in paper.values()], "k^--", markersize=4,
                  label="paper")
        axes.set_yscale("log")
    least = 1e-3
    for one, color in zip(results["volumes"], COLORS):
        runs = [run for run in one["blocks"] if run["rate"] == 0 and run["block"]]
        blocks = [run["block"] for run in runs]
        for way, what, style, name in (("gatun", "samples", "o-", "ours, sums"),
                                       ("gatun", "lines", "o:", "ours, lines"),
                                       ("trilinear-2", "samples", "x--", "paper's kernel, padded")):
            values = [volumeReport.find(run["ways"], way=way)["views"][3][what] for run in runs]
            grid[0].plot(blocks, [max(least, value) for value in values], style, color=color,
                         markersize=4, linewidth=1, label=f"{one['name']}: {name}")
        for run, style in zip(one["pictures"], ("o-", "s--")):
            values = [block["views"][3]["exponential"]["mse"] for block in run["blocks"]
                      if block["rate"] == 0 and block["block"]]
            grid[1].plot(blocks, [max(least, value) for value in values], style, color=color,
                         markersize=4, linewidth=1,
                         label=f"{one['name']}, opacity {run['opacity']:g}")
    for axes, title in zip(grid, ("Table 1: blocks, turns 0.48 0.1 0.95",
                                  "Table 2: exponential model, turns 0.48 0.1 0.95")):
        _style(axes, title, "voxels along a block", "mean square error (at least 0.001)")
        _ticks(axes, [2, 4, 8, 16, 32, 64])
        axes.legend(fontsize=6)
    benchmarkPlots.save(figure, folder, "tables", done)


def _series(axes, points, *arguments, **options):
    """Points of finite error only."""
    points = sorted((point["bits"], point["psnr"]) for point in points if point["psnr"] is not None)
    if points:
        axes.plot(*zip(*points), *arguments, markersize=3, linewidth=1, **options)


def _rates(results, folder, done):
    volumes = results["volumes"]
    figure, grid = pyplot.subplots(1, len(volumes), figsize=(4.2 * len(volumes), 4), squeeze=False)
    for axes, one in zip(grid[0], volumes):
        rates = one["rates"]
        for series, color in zip(rates["gatun"], COLORS):
            _series(axes, series["points"], "o-", color=color,
                    label=f"Gatun, blocks of {volumeReport.size(series['block'])}")
        for name, style in (("accuracy", "k^--"), ("precision", "kv:"), ("integers", "ks-.")):
            _series(axes, rates.get("zfp", {}).get(name, []), style, label=f"zfp, {name}")
        axes.axvline(rates["vti"], color="#999999", linewidth=1, label=".vti, zlib, lossless")
        axes.set_xscale("log")
        _style(axes, one["name"], "bits per voxel", "PSNR, dB")
    grid[0][0].legend(fontsize=6)
    benchmarkPlots.save(figure, folder, "rates", done)


def _times(results, folder, done):
    if "times" not in results:
        return
    runs = results["times"]["runs"]
    figure, grid = pyplot.subplots(1, 3, figsize=(11, 3.6))
    laws = (("xray", "#0072b2"), ("exponential", "#d55e00"))

    def peers(axes, run):
        for way, style in (("plain", "-"), ("fixed-point", "--")):
            for law, color in laws:
                one = volumeReport.find(run["ways"], way=way, law=law)
                if one:
                    axes.axhline(1000 * volumeReport.median(one), color=color, linestyle=style,
                                 linewidth=0.8, label=f"{way}, {law}")
    for law, color in laws:
        own = [one for one in runs["blocks"]["ways"] if one["way"] == "gatun" and one["law"] == law]
        places = [one["block"] or 128 for one in own]
        grid[0].plot(places, [1000 * volumeReport.median(one) for one in own], "o-", color=color,
                     markersize=3, label=f"Gatun, {law}")
        own = [one for one in runs["rates"]["ways"] if one["way"] == "gatun" and one["law"] == law]
        terms = [volumeReport.find(runs["rates"]["sources"], block=one["block"],
                                   rate=one["rate"])["terms"] / 1e6 for one in own]
        grid[1].plot(*zip(*sorted(zip(terms, (1000 * volumeReport.median(one) for one in own)))),
                     "o-", color=color, markersize=3)
        for way, block, style in (("gatun", 8, "o-"), ("plain", 0, "x-"), ("fixed-point", 0, "^--")):
            found = [(run["pixels"], one) for run in runs["pixels"] for one in run["ways"]
                     if one["way"] == way and one["law"] == law and one.get("block", 0) == block]
            if found:
                grid[2].plot([pixels for pixels, _ in found],
                             [1000 * volumeReport.median(one) for _, one in found], style,
                             color=color, markersize=3, label=f"{way}, {law}")
    peers(grid[0], runs["blocks"])
    peers(grid[1], runs["rates"])
    places = sorted({one["block"] or 128 for one in runs["blocks"]["ways"] if one["way"] == "gatun"})
    _style(grid[0], "one bit per voxel", "voxels along a block", "ms per view")
    grid[0].set_xscale("log", base=2)
    grid[0].set_xticks(places, ["whole" if place == 128 else place for place in places])
    _style(grid[1], "blocks of 8", "million nonzero coefficients", "ms per view")
    _style(grid[2], "blocks of 8, one bit per voxel", "pixels along the image", "ms per view")
    for axes in grid:
        axes.set_yscale("log")
    grid[0].legend(fontsize=5)
    grid[2].legend(fontsize=5)
    benchmarkPlots.save(figure, folder, "times", done)


def _title(run):
    if run["plate"] == "voxels":
        return "from voxels"
    if run["plate"] == "sizes":
        return f"blocks of {volumeReport.size(run['block'])}"
    error = f"{run['psnr']:.1f} dB" if run["psnr"] is not None else "lossless"
    return f"{run['bits']:.2f} bits, {error}"


def _plates(results, folder, done):
    """Only while the images exist; otherwise the previous plates stay."""
    runs = results.get("plate", {}).get("runs", [])
    for plate in "qualities", "sizes":
        if runs and all("file" in run and pathlib.Path(run["file"]).exists() for run in runs):
            _plate([run for run in runs if run["plate"] in ("voxels", plate)], folder, plate)
        if (folder / f"{plate}.png").exists():
            done.add(plate)


def _plate(runs, folder, name):
    laws = list(dict.fromkeys(run["law"] for run in runs))
    columns = len(runs) // len(laws)
    images = [pyplot.imread(run["file"])[:, :, :3] for run in runs]
    # The black margin that all of them share is cut off.
    seen = sum(image.sum(axis=2) for image in images) > 0.1 * len(images)
    rows, across = seen.any(axis=1).nonzero()[0], seen.any(axis=0).nonzero()[0]
    cut = (slice(rows[0], rows[-1] + 1), slice(across[0], across[-1] + 1))
    height, width = images[0][cut].shape[:2]
    dots = 100
    figure, grid = pyplot.subplots(len(laws), columns, squeeze=False, figsize=(
        columns * width / dots, (len(laws) * height + 24) / dots))
    for axes, run, image in zip(grid.flat, runs, images):
        axes.imshow(image[cut])
        axes.set_axis_off()
        if run["law"] == laws[0]:
            axes.set_title(_title(run), fontsize=10, pad=4)
    figure.subplots_adjust(0, 0, 1, 1 - 24 / (len(laws) * height + 24), 0.01, 0.01)
    figure.savefig(folder / f"{name}.png", dpi=dots, metadata={"Software": None})
    pyplot.close(figure)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    for make in _tables, _rates, _times, _plates:
        make(results, folder, done)
    return done
