# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runBenchmarks.py."""

import statistics

import benchmarkGoals
import benchmarkText
import renderingReport
from benchmarkText import image, number, ratio, spread, table

FORMATS = {
    "gtn": ".gtn",
    "vtu-raw": ".vtu raw",
    "vtu-zlib": ".vtu zlib",
    "vtu-zlib-best": ".vtu zlib, best",
    "vtu-lzma": ".vtu LZMA",
    "vtu-lzma-best": ".vtu LZMA, best",
}


def label(one):
    return one["name"] + (", permuted" if one["order"] == "permuted" else "")


def bits(size, tets):
    return 8 * size / tets


def seconds_of(timed):
    """The rounds, or the only run where there was one."""
    return timed["seconds"] or [timed["first"]]


def median(timed):
    return statistics.median(seconds_of(timed))


def by_format(measured):
    return {one["format"]: one for one in measured["files"]}


def ratios(measured, other, own="gtn"):
    """The time of another format divided by that of .gtn, in each round."""
    files = by_format(measured)
    return benchmarkText.rounds_of(zip(files[other]["seconds"], files[own]["seconds"]))


# --------------------------------------------------------------------------------------------------
# Parts of the page


def head(results):
    return """# Benchmarks

`Utilities/setup.sh bench` (Benchmarks/Studies/runBenchmarks.py) writes this page. All results,
including each round of each timing, are in [results.json](benchmarks/results.json).

""" + benchmarkText.machine(results)


def goals(results):
    rows = [[goal["what"], goal["unit"], goal["peer"], number(goal["must"]),
             number(goal["moonshot"]),
             "not measured" if goal["value"] is None else number(goal["value"]), goal["verdict"]]
            for goal in benchmarkGoals.judge(results)]
    return """## Goals

The goals of the project and the current state. *Required* is the value that the project promises;
*target* is the value that it aims for. Where a goal covers several meshes, the worst mesh counts.

""" + table(["goal", "unit", "others, measured here", "required", "target", "now", "verdict"], rows)


def inputs(results):
    rows = []
    for one in results["inputs"]:
        size = one["size"]
        rows.append([label(one), f"{size['tets']:,}", f"{size['points']:,}", size["chunks"],
                     one["about"]])
    return """## Meshes

The benchmark generates flow, delaunay and big. The points and tetrahedra of *permuted* meshes are
in random order (with a fixed seed), so that no format benefits from the order in which a mesh was
generated. The other meshes come from the data folder `GATUN_DATA_DIR` or from the command line.

""" + table(["mesh", "tetrahedra", "points", "chunks", "description"], rows)


def sizes(results, plots):
    rows = []
    for one in results["inputs"]:
        size = one["size"]
        files = by_format(size)
        rows.append([label(one)] + [number(bits(files[name]["bytes"], size["tets"]))
                                    for name in FORMATS if name in files]
                    + [number(bits(size["rawBytes"], size["tets"]))])
    parts = []
    for one in results["inputs"]:
        size = one["size"]
        part = size["parts"]
        arrays = ", ".join(f"{array['name']} {number(bits(array['bytes'], size['tets']))}"
                           for array in size["arrays"])
        own = size["points"] - size["sharedPoints"]
        geometry = f"{8 * part['geometry'] / own:.1f}" if own else "-"
        shared = (f"{8 * part['sharedGeometry'] / size['sharedPoints']:.1f}"
                  if size["sharedPoints"] else "-")
        parts.append([label(one)] + [f"{bits(part[name], size['tets']):.3f}" for name in
                                     ("connectivity", "geometry", "sharedGeometry")]
                     + [arrays or "none", f"{bits(part['directory'], size['tets']):.3f}",
                        geometry, shared])
    return """## Size

Bits per tetrahedron of the whole file. *.vtu* files are written with VTK's default settings (64-bit
ids, blocks of 32 KiB). *Best* means level 9, 32-bit ids and blocks of 32 MiB. *Raw memory* is the
size of coordinates, 32-bit connectivity and arrays. The `.gtn` files have the default settings:
they do not keep the order of points and cells.

""" + table(["mesh", *FORMATS.values(), "raw memory"], rows) + "\n" + image(
        plots, "sizes", "Bits per tetrahedron by format") + """
Bits per tetrahedron of each part of the `.gtn` files. The last two columns are bits per point that
only one chunk uses, and bits per point that several chunks share.

""" + table(["mesh", "connectivity", "own points", "shared points", "arrays", "directory",
             "bits/own point", "bits/shared point"], parts) + "\n" + image(
                 plots, "parts", "Bits per tetrahedron by part")


def load_table(results, key):
    """Speeds of all formats, and ratios to Gatun's."""
    rows = []
    for one in results["inputs"]:
        for load in one.get(key, []):
            files = by_format(load)
            rows.append([label(one), load["threads"]]
                        + [number(load["tets"] / median(files[name]) / 1e6) for name in files]
                        + [spread(ratios(load, name), ratio) for name in files if name != "gtn"])
    return table(["mesh", "threads", ".gtn", "raw", "zlib", "LZMA", "raw / .gtn", "zlib / .gtn",
                  "LZMA / .gtn"], rows)


def cold_loading(results):
    """Nothing for results from before this was measured."""
    if not any("loadCold" in one for one in results["inputs"]):
        return ""
    return """
The same, with each file removed from the page cache before it is read, so that it comes from the
disk.

""" + load_table(results, "loadCold") + "\n"


def loading(results, plots):
    memory = []
    for one in results["inputs"]:
        peak = one.get("peak")
        if peak:
            grid = peak["gtn"]["gridBytes"]
            memory.append([label(one), f"{grid / 2**20:,.0f}"] + [
                f"{(peak[name]['peak'] - peak[name]['before']) / grid:.2f}" for name in peak])
    return """## Loading

Loading a file into a `vtkUnstructuredGrid`, by `vtkGatunReader` and by
`vtkXMLUnstructuredGridReader`. The speed is in million tetrahedra per second (median). The ratios
are the time of VTK's reader divided by Gatun's time: above 1, Gatun is faster. Each number of threads
runs in a separate process. After one warm-up round the formats take turns, in alternating
directions. The files are in the page cache, so the speed of the disk does not matter; from a slow
disk, a smaller file has an advantage.

""" + load_table(results, "load") + "\n" + image(
        plots, "load", "Million tetrahedra per second by format") + cold_loading(results) + """
Peak memory while loading, above that of the process before, as a multiple of the size of the grid
(1 is the grid itself). Each file is loaded in a separate process with 2 threads.

""" + table(["mesh", "grid, MiB", ".gtn", ".vtu raw", ".vtu zlib"], memory)


def stage_seconds(measured):
    """Median seconds of each stage; "hand over" is the rest of the whole."""
    seconds = {stage["stage"].replace("neighbor", "neighbor"): median(stage)
               for stage in measured["stages"]}
    check = seconds.pop("check alone")
    whole = seconds.pop("all at once")
    seconds["checksum"] = check
    seconds["read"] = max(0.0, seconds.pop("read and check") - check)
    rest = whole + seconds["directory"] - sum(seconds.values())
    seconds["hand over"] = max(0.0, rest)
    return seconds


def stages(results, plots):
    names = None
    rows = []
    for one in results["inputs"]:
        if "stages" in one:
            seconds = stage_seconds(one["stages"])
            names = names or list(seconds)
            scale = 1e9 / one["stages"]["tets"]
            rows.append([label(one)] + [f"{scale * seconds[name]:.1f}" for name in names]
                        + [f"{scale * sum(seconds.values()):.1f}"])
    return """## Where the time goes

Decoding by the core, without VTK, on one thread: nanoseconds per tetrahedron by stage. Each stage is
timed separately over all chunks. *Hand over* is the time that complete decoding takes beyond the sum
of the other stages: allocating the caller's memory and writing points, connectivity and values to it.

""" + table(["mesh", *(names or []), "all"], rows) + "\n" + image(
        plots, "stages", "Nanoseconds per tetrahedron by stage")


def writing(results):
    rows = []
    for one in results["inputs"]:
        lzma = by_format(one["size"])["vtu-lzma"]["seconds"]
        for write in one.get("write", []):
            files = by_format(write)
            rows.append([label(one), write["threads"]]
                        + [number(write["tets"] / median(files[name]) / 1e6) for name in files]
                        + [number(write["tets"] / lzma / 1e6),
                           spread(ratios(write, "vtu-zlib"), ratio)])
    memory = []
    for one in results["inputs"]:
        peak = one.get("peakWrite")
        if peak:
            memory.append([label(one), f"{peak['gridBytes'] / 2**20:,.0f}",
                           f"{(peak['peak'] - peak['before']) / peak['gridBytes']:.2f}"])
    return """## Writing

Million tetrahedra per second (median). The LZMA file is written only once.

""" + table(["mesh", "threads", ".gtn", "raw", "zlib", "LZMA", "zlib / .gtn"], rows) + """
Peak memory while writing `.gtn` with 2 threads, above the input, as a multiple of the input.

""" + table(["mesh", "input, MiB", ".gtn"], memory)


def pieces(results):
    text = """## Pieces

All pieces are read one after the other, each by a separate reader, as the ranks of a parallel
program would do. The times are the sum over all pieces and the time of the slowest piece, with 2
threads. VTK's `.vtu` reader cannot read a piece of a file, so there is no comparison.

"""
    for one in results["inputs"]:
        if "pieces" in one:
            measured = one["pieces"]
            rows = [[case["pieces"], case["ghostLevels"], f"{case['tets']:,}",
                     f"{case['bytesRead']:,}",
                     f"{100 * case['bytesRead'] / measured['fileBytes']:.1f}",
                     milliseconds(seconds_of(case)), milliseconds(case["slowestPiece"])]
                    for case in measured["cases"]]
            text += table(["pieces", "ghost levels", "tetrahedra", "bytes read", "% of file",
                           "all, ms", "slowest, ms"], rows)
    return text


def milliseconds(seconds):
    return spread([1000 * one for one in seconds])


def regions(results, plots):
    text = """## Parts of a mesh

The bytes that the reader reads for a box or for a range of values of Density. The reader returns
whole chunks. Smaller chunks fit a region better but make the file larger.

"""
    for one in results["inputs"]:
        for file in one.get("roi", {}).get("files", []):
            rows = [[region["region"], f"{region['tets']:,}", f"{region['bytesRead']:,}",
                     f"{100 * region['bytesRead'] / file['fileBytes']:.1f}",
                     milliseconds(seconds_of(region))] for region in file["regions"]]
            text += (f"Mesh {label(one)}, {file['chunks']} chunks of at most {file['chunkTets']:,} "
                     f"tetrahedra, {file['fileBytes']:,} bytes:\n\n")
            text += table(["requested", "tetrahedra", "bytes read", "% of file", "ms"], rows) + "\n"
    return text + image(plots, "roi", "Bytes read for parts of a mesh")


def series(results):
    measured = results["series"]
    seconds = {case["case"]: seconds_of(case) for case in measured["cases"]}
    steps = measured["steps"]
    rows = [["all in one .gtn", f"{measured['gtnBytes']:,}"],
            ["of these, the mesh", f"{measured['gtnMeshBytes']:,}"],
            [".vtu zlib, one per step, and a .pvd", f"{measured['vtuBytes']:,}"],
            [".vtu / .gtn", f"{measured['vtuBytes'] / measured['gtnBytes']:.1f}"]]
    timed = []
    for order in "forward", "at random":
        own, other = seconds[f"gtn {order}"], seconds[f"vtu-zlib {order}"]
        timed.append([order, number(1000 * statistics.median(own) / steps),
                      number(1000 * statistics.median(other) / steps),
                      spread(benchmarkText.rounds_of(zip(other, own)), ratio)])
    text = f"""## Time series

{steps} time steps of one float array on one mesh ({measured["mesh"]}, {measured["tets"]:,}
tetrahedra). Every value changes from step to step.

""" + table(["files", "bytes"], rows) + """
Milliseconds per step for reading all steps, including opening, with 2 threads:

""" + table(["order", ".gtn", ".vtu zlib", ".vtu / .gtn"], timed)
    rows = [[one["name"], one["steps"], f"{one['tets']:,}", f"{one['inputBytes']:,}",
             f"{one['gtnBytes']:,}", f"{one['vtuBytes']:,}"] for one in results.get("exodus", [])]
    if rows:
        text += "\nFiles with time steps of the data folder, in bytes (with their cells split into "
        text += "tetrahedra, except for the input):\n\n"
        text += table(["file", "steps", "tetrahedra", "input", ".gtn", ".vtu zlib, all steps"],
                      rows)
    return text


def page(results, plots):
    parts = [head(results), goals(results), inputs(results), sizes(results, plots),
             loading(results, plots), stages(results, plots), writing(results),
             pieces(results), regions(results, plots), series(results),
             *renderingReport.sections(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, "benchmarks", page, "benchmarkPlots")
