# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plots of the results of runBenchmarks.py; needs matplotlib."""

import matplotlib

import benchmarkReport
import benchmarkText
import renderingReport

matplotlib.use("Agg")
from matplotlib import pyplot

COLORS = {"gtn": "#0072b2", "vtu-raw": "#999999", "vtu-zlib": "#e69f00", "vtu-lzma": "#cc79a7",
           "vtu-zlib-best": "#d55e00", "vtu-lzma-best": "#7b3294"}
STAGES = ["#0072b2", "#56b4e9", "#009e73", "#e69f00", "#d55e00", "#cc79a7", "#999999", "#f0e442"]


def save(figure, folder, name, done):
    figure.tight_layout()
    # Without metadata, so that the same results make the same file.
    figure.savefig(folder / f"{name}.png", dpi=100, metadata={"Software": None})
    pyplot.close(figure)
    done.add(name)


def grouped(groups, series, title, unit):
    """Horizontal bars: series is a list of (name, color, one value a group)."""
    figure, axes = pyplot.subplots(figsize=(9, 1 + 0.17 * len(groups) * (len(series) + 1)))
    height = 0.8 / len(series)
    for i, (name, color, values) in enumerate(series):
        places = [g + i * height for g in range(len(groups))]
        bars = axes.barh(places, values, height, color=color, label=name)
        axes.bar_label(bars, [benchmarkText.number(v) for v in values], padding=2, fontsize=7)
    axes.set_yticks([g + 0.4 - height / 2 for g in range(len(groups))], groups, fontsize=8)
    axes.invert_yaxis()
    axes.margins(x=0.1)
    axes.set_xlabel(unit)
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))
    return figure


def _stacked(groups, series, title, unit):
    figure, axes = pyplot.subplots(figsize=(9, 1.4 + 0.4 * len(groups)))
    left = [0.0] * len(groups)
    for i, (name, values) in enumerate(series):
        axes.barh(groups, values, left=left, color=STAGES[i % len(STAGES)], label=name)
        left = [a + b for a, b in zip(left, values)]
    axes.invert_yaxis()
    axes.tick_params(labelsize=8)
    axes.set_xlabel(unit)
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))
    return figure


def _sizes(results, folder, done):
    inputs = results["inputs"]
    series = [(text, COLORS[name],
               [benchmarkReport.bits(benchmarkReport.by_format(one["size"])[name]["bytes"],
                                     one["size"]["tets"]) for one in inputs])
              for name, text in benchmarkReport.FORMATS.items()]
    save(grouped([benchmarkReport.label(one) for one in inputs], series, "File size",
                   "bits per tetrahedron"), folder, "sizes", done)


def _parts(results, folder, done):
    inputs = results["inputs"]

    def part(name):
        return [benchmarkReport.bits(one["size"]["parts"][name], one["size"]["tets"])
                for one in inputs]
    arrays = [sum(benchmarkReport.bits(array["bytes"], one["size"]["tets"])
                  for array in one["size"]["arrays"]) for one in inputs]
    series = [("connectivity", part("connectivity")), ("own points", part("geometry")),
              ("shared points", part("sharedGeometry")), ("arrays", arrays),
              ("directory", part("directory")), ("field data", part("fieldData"))]
    save(_stacked([benchmarkReport.label(one) for one in inputs], series, "Parts of .gtn files",
                   "bits per tetrahedron"), folder, "parts", done)


def _load(results, folder, done):
    loads = [(f"{benchmarkReport.label(one)}, {load['threads']} threads", load)
             for one in results["inputs"] for load in one.get("load", [])]
    names = [one["format"] for one in loads[0][1]["files"]]
    series = [(benchmarkReport.FORMATS[name], COLORS[name],
               [load["tets"] / 1e6
                / benchmarkReport.median(benchmarkReport.by_format(load)[name])
                for _, load in loads]) for name in names]
    save(grouped([text for text, _ in loads], series, "Loading to vtkUnstructuredGrid",
                   "million tetrahedra per second"), folder, "load", done)


def _stages(results, folder, done):
    inputs = [one for one in results["inputs"] if "stages" in one]
    seconds = [benchmarkReport.stage_seconds(one["stages"]) for one in inputs]
    series = [(name, [1e9 * each[name] / one["stages"]["tets"]
                      for each, one in zip(seconds, inputs)]) for name in seconds[0]]
    save(_stacked([benchmarkReport.label(one) for one in inputs], series,
                   "Decoding on one thread", "nanoseconds per tetrahedron"),
          folder, "stages", done)


def _regions(results, folder, done):
    for one in results["inputs"]:
        files = one.get("roi", {}).get("files", [])
        if files:
            groups = [region["region"] for region in files[0]["regions"]]
            series = [(f"chunks of {file['chunkTets']:,}", STAGES[i],
                       [100 * region["bytesRead"] / file["fileBytes"]
                        for region in file["regions"]]) for i, file in enumerate(files)]
            save(grouped(groups, series, f"Bytes read, {benchmarkReport.label(one)}",
                           "% of the file"), folder, "roi", done)


def _render(results, folder, done):
    rendering = results.get("rendering")
    if not rendering:
        return
    cases = [(mesh, case) for mesh in rendering["meshes"] for case in mesh["render"]
             if "projected" in renderingReport.by_mapper(case)]
    series = [(renderingReport.MAPPERS[name], color,
               [renderingReport.later_ratio(case, name) for _, case in cases])
              for name, color in (("bunyk", "#e69f00"), ("projected", "#56b4e9"))]
    figure = grouped([renderingReport.describe(mesh, case) for mesh, case in cases], series,
                      "Later frames: time relative to Gatun's mapper", "times as long")
    figure.axes[0].axvline(1, color="#0072b2", linewidth=1)
    save(figure, folder, "render", done)


def _memory(results, folder, done):
    rendering = results.get("rendering")
    if not rendering:
        return
    meshes = sorted(rendering["meshes"], key=lambda mesh: mesh["tets"])
    figure, axes = pyplot.subplots(figsize=(7, 4))
    for form, color in ("gtn", COLORS["gtn"]), ("vtu-zlib", COLORS["vtu-zlib"]):
        places = [(mesh["tets"], renderingReport.most_memory(
            renderingReport.find_images(mesh, form))) for mesh in meshes]
        if form == "gtn":
            places += [(rendering["hugeTets"], renderingReport.above_idle(one["run"]))
                       for one in rendering["huge"] if one["chunkTets"] == meshes[-1]["chunkTets"]]
        axes.loglog(*zip(*places), "o-", color=color, label=renderingReport.FILES[form])
    axes.set_xlabel("tetrahedra")
    axes.set_ylabel("MiB above the idle process")
    axes.set_title("Memory from file to image, MemoryBudget 0", fontsize=10)
    axes.grid(which="major", alpha=0.3)
    axes.legend(fontsize=8)
    save(figure, folder, "memory", done)


def draw(results, folder):
    """Writes all plots; returns their names."""
    done = set()
    for make in _sizes, _parts, _load, _stages, _regions, _render, _memory:
        make(results, folder, done)
    return done
