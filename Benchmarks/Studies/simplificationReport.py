# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runSimplification.py."""

import statistics

import benchmarkText
import simplificationTimes
from benchmarkText import image, number, paragraph, table

FOLDER = "simplification-study"


def did_nothing(mesh, i):
    """Whether VTK returned the mesh unchanged when it was asked for the i-th part."""
    return mesh["quadric"][i]["tets"] == mesh["compared"]["original"]["tets"]


def cases(mesh):
    """Percent, VTK and Gatun, for all parts for which VTK changed the mesh."""
    compared = mesh["compared"]
    return [(part, compared["quadric"][i], compared["gatun"][i])
            for i, part in enumerate(mesh["parts"]) if not did_nothing(mesh, i)]


def field_ratio(quadric, gatun):
    return gatun["rms"] / quadric["rms"]


def volume_error(mesh, compared):
    return abs(compared["volume"] / mesh["compared"]["original"]["volume"] - 1)


def _small(value):
    return "0" if value == 0 else f"{value:.1e}" if value < 1e-3 else f"{value:.4f}"


def _who_wins(results):
    ratios = [(field_ratio(quadric, gatun), mesh["name"], part) for mesh in results["meshes"]
              for part, quadric, gatun in cases(mesh)]
    lost = [f"{name} at {part} % ({value:.2f})" for value, name, part in ratios if value >= 1]
    text = f"""Gatun's root mean square error of the field is smaller in {len(ratios) - len(lost)} of
        {len(ratios)} cases. Its geometric mean is
        {statistics.geometric_mean(value for value, _, _ in ratios):.2f} times VTK's error."""
    if lost:
        text += f""" VTK is better for {", ".join(lost)}, where the field is smooth. VTK moves points to
            the place of the least error and gives them new values. An edge collapse of Gatun
            keeps points and values, so that it can be stored and undone. Linear interpolation
            between exact values of a smooth field errs in one direction over large regions, which
            new values compensate."""
    return paragraph(text)


def _head(results):
    text = """# The simplification study

The quality of the meshes that Gatun simplifies ([guide](../simplification.md)), compared with
`vtkUnstructuredGridQuadricDecimation`, VTK's own filter (Vo et al. 2007). The page also repeats
Figures 17, 18 and 19 of C. Yang, *On-the-fly Processing of Compressed Volume Data*, dissertation
proposal, Stony Brook, 2001. `Utilities/bench.sh --simplification`
(Benchmarks/Studies/runSimplification.py) writes it. All results are in
[results.json](simplification-study/results.json).

""" + benchmarkText.machine(results)
    rows = [[mesh["name"], f"{mesh['compared']['original']['tets']:,}",
             f"{mesh['compared']['original']['points']:,}", mesh["about"]]
            for mesh in results["meshes"]]
    return text + "\n" + table(["mesh", "tetrahedra", "points", "description"], rows)


def _field(results, plots):
    rows = []
    for mesh in results["meshes"]:
        for part, quadric, gatun in cases(mesh):
            rows.append([mesh["name"], part, f"{quadric['tets']:,}", f"{gatun['tets']:,}",
                         _small(quadric["rms"]), _small(gatun["rms"]),
                         f"**{field_ratio(quadric, gatun):.2f}**", _small(quadric["largest"]),
                         _small(gatun["largest"]), f"{quadric['outside']:,}",
                         f"{gatun['outside']:,}"])
    text = "## The field\n\n" + _who_wins(results) + "\n" + paragraph(f"""VTK is asked for a
        percentage of the tetrahedra. Gatun then merges until it has no more tetrahedra than VTK. The
        error is the difference from the original mesh at {results["samples"]:,} positions, evenly
        distributed over its volume, relative to the range of the field. A position outside of
        the coarser mesh takes the value of the nearest position on its boundary and is counted. If
        a position is in several tetrahedra, the first one counts.""") + "\n" + table(
            ["mesh", "%", "tets, VTK", "tets, Gatun", "RMS, VTK", "RMS, Gatun", "Gatun / VTK",
             "max, VTK", "max, Gatun", "outside, VTK", "outside, Gatun"], rows)
    nothing = [(mesh["name"], part, mesh["quadric"][i]["seconds"]) for mesh in results["meshes"]
               for i, part in enumerate(mesh["parts"]) if did_nothing(mesh, i)]
    if nothing:
        asked = ", ".join(f"{name} to {part} % ({number(seconds)} s)"
                          for name, part, seconds in nothing)
        text += "\n" + paragraph(f"""VTK returned the mesh unchanged, without a message, for these
            requests: {asked}.""") + "\n" + table(
                ["mesh", "%", "tets, Gatun", "RMS, Gatun", "max, Gatun"],
                [[mesh["name"], part, f"{gatun['tets']:,}", _small(gatun["rms"]),
                  _small(gatun["largest"])]
                 for mesh in results["meshes"]
                 for i, (part, gatun) in enumerate(zip(mesh["parts"], mesh["compared"]["gatun"]))
                 if did_nothing(mesh, i)])
    return text + "\n" + image(plots, "field", "Error of the field by remaining tetrahedra", FOLDER)


def _shape(results):
    rows = []
    for mesh in results["meshes"]:
        for part, *ways in cases(mesh):
            row = [mesh["name"], part]
            for key in ("boundaryMean", "boundaryLargest"):
                row += [_small(way[key]) for way in ways]
            row += [_small(volume_error(mesh, way)) for way in ways]
            for key in ("worst", "firstPercentile", "median"):
                row += [_small(way[key]) for way in ways]
            row += [f"{way['inverted']} / {way['flat']}" for way in ways]
            rows.append(row)
    return "## Boundary and shape\n\n" + paragraph("""Each pair is VTK, Gatun. The columns are: distance
        of the original boundary from the new one, mean and largest, relative to the diagonal; change of
        the volume, relative; mean ratio of the tetrahedra (1 is regular, 0 flat): the worst, the 1 %
        quantile, the median; number of inverted and of flat tetrahedra. Gatun's cost function does
        not ask for well-shaped tetrahedra, and the table shows it. Gatun inverts no
        tetrahedron.""") + "\n" + (
        table(
            ["mesh", "%", "mean", "", "largest", "", "volume", "", "worst", "", "1 %", "", "median",
             "", "inverted / flat", ""], rows))


def _speed(results):
    rows = []
    for mesh in results["meshes"]:
        tets = mesh["compared"]["original"]["tets"]
        build = statistics.median(mesh["build"]["seconds"])
        rows.append([mesh["name"], f"{tets:,}", number(build), f"{tets / build / 1e6:.3f}",
                     number(simplificationTimes.memory(mesh["build"])), number(mesh["gatun"]["seconds"]),
                     number(simplificationTimes.memory(mesh["gatun"])),
                     ", ".join(number(run["seconds"]) for run in mesh["gatun"]["meshes"]),
                     ", ".join(number(run["seconds"]) for run in mesh["quadric"]),
                     number(max(simplificationTimes.memory(run) for run in mesh["quadric"]))])
    return "## Time and memory\n\n" + paragraph("""One thread. Gatun finds the order of all merges once
        (`gatun::BuildMergeTree`; the filter `vtkGatunSimplify` also converts and copies the mesh); each
        mesh then takes one pass. VTK starts again for each mesh. Seconds, and peak MiB above those of the
        process with the mesh in it. The meshes are in the order of the table above: 50 %, and so
        on. Each case ran once.""") + (
            "\n" + table(["mesh", "tetrahedra", "merges, s", "M tets/s", "MiB", "filter, s", "MiB",
                          "each mesh, s", "VTK, each mesh, s", "MiB"], rows))


def _images(results, plots):
    if "pictures" not in results:
        return ""
    shown = results["pictures"]
    rows = []
    for part, gatun, quadric in zip(shown["parts"], shown["gatun"], shown["quadric"]):
        rows.append([part, f"{quadric['tets']:,}", f"{gatun['tets']:,}", _small(quadric["rms"]),
                     _small(gatun["rms"]), _small(quadric["largest"]), _small(gatun["largest"])])
    return f"## Images ({shown['name']}, Figure 19)\n\n" + image(
        plots, "pictures", "The original and simplified meshes, as volumes", FOLDER) + "\n" + (
            paragraph(f"""Root mean square and largest difference of the colors, 0 to 1, from the
        image of the whole mesh, {_size(results)} pixels, over the pixels that either mesh
        covers. The proposal shows this for its own method only, by the percentage of points
        merged, and finds the error "minimal" except for very aggressive ratios.""")) + "\n" + table(
            ["% of tets", "tets, VTK", "tets, Gatun", "RMS, VTK", "RMS, Gatun", "max, VTK",
             "max, Gatun"], rows) + "\n" + image(
                 plots, "figure19", "Difference of images", FOLDER)


def _size(results):
    return f"{results['size']} x {results['size']}"


def page(results, plots):
    parts = [_head(results), _field(results, plots), _shape(results), _speed(results),
             _images(results, plots), simplificationTimes.drawing(results, plots),
             simplificationTimes.integrated(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts if part)


def write(results, out):
    benchmarkText.write_page(results, out, "simplification-study", page, "simplificationPlots")
