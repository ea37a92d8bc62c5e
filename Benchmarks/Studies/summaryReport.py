# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runSummary.py, and the table of README.md, which has the same rows."""

import statistics

import benchmarkText
from benchmarkText import number, paragraph, ratio, span, table

MIB = 2**20


def _row(what, unit, own, peer, name, more_is_better=False):
    """own and peer are the rounds; advantage is above 1 where Gatun is better."""
    pairs = zip(own, peer) if more_is_better else zip(peer, own)
    return {"what": what, "unit": unit, "own": own, "peer": peer, "name": name,
            "advantage": benchmarkText.rounds_of(pairs)}


def _files(results):
    size, load = results["files"]["size"], results["files"]["load"]
    tets = size["tets"]
    sizes = {one["format"]: 8 * one["bytes"] / tets for one in size["files"]}
    own, fast, peer = ([tets / seconds / 1e6 for seconds in one["seconds"]] for one in load["files"])
    yield _row("File size, Delaunay mesh", "bits per tetrahedron", [sizes["gtn"]],
               [sizes["vtu-lzma-best"]], "`.vtu`, best LZMA")
    yield _row("The same, packed with `--fast-arrays`", "bits per tetrahedron",
               [8 * results["files"]["fastBytes"] / tets], [sizes["vtu-lzma-best"]],
               "`.vtu`, best LZMA")
    speed = "million tetrahedra per second"
    yield _row("Loading the first file", speed, own, peer, "`.vtu`, zlib", more_is_better=True)
    yield _row("Loading the second one", speed, fast, peer, "`.vtu`, zlib", more_is_better=True)


def _images(results):
    if "images" not in results:
        return
    runs = results["images"]
    size = runs["gtn"][0]["size"]
    seconds = {form: [run["seconds"] for run in found] for form, found in runs.items()}
    memory = {form: [(run["peak"] - run["before"]) / MIB for run in found]
              for form, found in runs.items()}
    peer = "`.vtu`, zlib, and VTK's ray caster"
    yield _row(f"File to first image, grid, {size} x {size}", "s", seconds["gtn"],
               seconds["vtu-zlib"], peer)
    yield _row("Peak memory of that image", "MiB", memory["gtn"], memory["vtu-zlib"], peer)
    frames = {one["mapper"]: one["seconds"] for one in results["frames"]["mappers"]}
    yield _row(f"Later frames, Delaunay mesh in memory, {size} x {size}", "s", frames["gatun"],
               frames["bunyk"], "VTK's ray caster")


def _surfaces(results):
    runs = results["surfaces"]
    yield _row("File to isosurface, grid", "s", [run["seconds"] for run in runs["gtn"]],
               [run["seconds"] for run in runs["vtu-zlib"]],
               "`.vtu`, zlib, and `vtkContour3DLinearGrid`")


def _simplification(results):
    quadric, gatun = (1000 * one["rms"] for one in results["simplification"]["compared"]["meshes"])
    yield _row("Field error at 10 % of the Delaunay mesh", "RMS, 1/1000 of the range", [gatun],
               [quadric], "`vtkUnstructuredGridQuadricDecimation`")


def _volume(results):
    volume = results["volume"]
    if volume:
        yield _row(f"Size of a volume at a PSNR of {volume['zfp']['psnr']:.0f} dB", "bits per voxel",
                   [volume["gatun"]["bits"]], [volume["zfp"]["bits"]], "zfp")


def rows(results):
    return [row for part in (_files, _images, _surfaces, _simplification, _volume)
            for row in part(results)]


def _advantage(row):
    text = ratio(statistics.median(row["advantage"]))
    text = f"**{text}**" if float(text.strip("*")) < 1 else text
    if len(row["advantage"]) > 1:
        text += f" ({span(row['advantage'], ratio)})"
    return text


def readme_table(results):
    """Ten rows; an advantage below 1 is bold."""
    return table(["measurement", "Gatun", "peer", "advantage (range)"],
                 [[f"{row['what']} ({row['unit']})", number(statistics.median(row["own"])),
                   f"{number(statistics.median(row['peer']))}: {row['name']}", _advantage(row)]
                  for row in rows(results)])


def _kind(results):
    return ("a Delaunay mesh of a ball by TetGen" if results["machine"]["tetgen"]
            else "a jittered lattice, as TetGen is missing")


def page(results, _):
    size = results["files"]["size"]
    volume = results["volume"]
    parts = ["""# The summary

The rows of the table in [README.md](../../README.md). `Utilities/bench.sh --readme`
(Benchmarks/Studies/runSummary.py) writes this page and that table. All results are in
[results.json](summary/results.json).
""", benchmarkText.machine(results), paragraph(f"""Each cell has the median of the rounds with its range.
        *Advantage* is above 1 where Gatun is better: faster, smaller or more accurate. It is bold
        where Gatun is worse.""")]
    rounds = [[row["what"], row["unit"], benchmarkText.spread(row["own"]),
               benchmarkText.spread(row["peer"]), _advantage(row), len(row["advantage"]), row["name"]]
              for row in rows(results)]
    parts.append(table(["measurement", "unit", "Gatun", "peer", "advantage", "rounds", "peer is"],
                       rounds))
    text = f"""- *Settings*: all properties of Gatun have their default values, for files, too, except
  that the second file is packed with `--fast-arrays`. `.vtu` files have VTK's default settings (zlib,
  64-bit ids), except in the rows of sizes: there it is the smallest file (LZMA level 9, 32-bit ids,
  blocks of 32 MiB). All {results["machine"]["processors"]} processors are used;
  simplification runs on one thread.
- *Delaunay mesh*: {_kind(results)}, {size["tets"]:,} tetrahedra, {size["points"]:,} points, one float
  array. For files and loading, points and cells are in random order. For frames and simplification
  they are sorted along a Morton curve, which suits VTK's mapper.
- *Grid*: a synthetic structured grid around a nose, five tetrahedra per hexahedron,
  {results["gridTets"]:,} tetrahedra, one float array, in the order of the grid.
- *Images* are drawn by `vtkGatunVolumeMapper` straight from the file, and by
  `vtkUnstructuredGridVolumeRayCastMapper`, without a graphics card. Each first image is drawn by a
  separate process; the memory is that above a process with an empty window.
- *Isosurfaces* have the median of the array as isovalue. Each one is extracted by a separate process,
  from opening the file to the triangles. The `.gtn` file has no layers.
- *Simplification*: the root mean square error of the field, relative to its range, at the number of
  tetrahedra that VTK's filter leaves when it is asked for a tenth.
"""
    if volume:
        text += f"""- *Volume*: a synthetic head of {volume["voxels"]:,} voxels, blocks of 8, at a PSNR of
  {volume["gatun"]["psnr"]:.1f} dB (Gatun) and {volume["zfp"]["psnr"]:.1f} dB (zfp).
"""
    parts.append(text)
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, "summary", page)
