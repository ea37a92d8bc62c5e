# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page made of what runBenchmarks.py has measured."""

import statistics

import benchmarkGoals
import benchmarkText
import renderingReport
from benchmarkText import number, picture, table

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


def median(timed):
    """Of the rounds, or of the only run where there was one."""
    return statistics.median(timed["seconds"] or [timed["first"]])


def by_format(measured):
    return {one["format"]: one for one in measured["files"]}


def ratio(measured, other, own="gtn"):
    """How many times longer another format takes: the median over the rounds of both."""
    files = by_format(measured)
    pairs = list(zip(files[other]["seconds"], files[own]["seconds"]))
    return statistics.median(a / b for a, b in pairs)


# --------------------------------------------------------------------------------------------------
# Parts of the page


def head(results):
    text = """# Benchmarks

Made by `Utilities/setup.sh bench` (Benchmarks/Studies/runBenchmarks.py); all figures behind this
page, each round of each timing, are in [results.json](benchmarks/results.json).

""" + benchmarkText.machine(results["machine"])
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small meshes: not to be quoted.**\n"
    return text


def goals(results):
    rows = [[goal["what"], goal["unit"], goal["peer"], number(goal["must"]),
             number(goal["moonshot"]),
             "not measured" if goal["value"] is None else number(goal["value"]), goal["verdict"]]
            for goal in benchmarkGoals.judge(results)]
    return """## Goals

What the project set out to reach, and how far it has come. *Must* is what it promises, *aim* is
what it would like. Where several meshes speak to one goal, the worst one counts.

""" + table(["what", "unit", "others, measured here", "must", "aim", "now", "verdict"], rows)


def inputs(results):
    rows = []
    for one in results["inputs"]:
        size = one["size"]
        rows.append([label(one), f"{size['tets']:,}", f"{size['points']:,}", size["chunks"],
                     one["about"]])
    return """## Meshes

*Permuted* meshes have their points and tetrahedra in random order, made with a fixed seed, so that
nobody gains from the order in which a mesh was made; *natural* is that order. Meshes of a data
folder (`GATUN_DATA_DIR`) and meshes given on the command line appear here too.

""" + table(["mesh", "tetrahedra", "points", "chunks", "what"], rows)


def sizes(results, pictures):
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

Bits for each tetrahedron, whole files. *.vtu* as VTK writes it when told nothing else (64-bit ids,
blocks of 32 KiB), *best*: level 9, 32-bit ids, blocks of 32 MiB. *Raw memory*: coordinates, 32-bit
connectivity and arrays, nothing else. `.gtn` files do not keep the order of points and cells here.

""" + table(["mesh", *FORMATS.values(), "raw memory"], rows) + "\n" + picture(
        pictures, "sizes", "Bits for each tetrahedron by format") + """
Where the bits of the `.gtn` files are, for each tetrahedron; the last two columns are bits for each
point of one chunk only, and for each point that several chunks share.

""" + table(["mesh", "connectivity", "own points", "shared points", "arrays", "directory",
             "bits/own point", "bits/shared point"], parts) + "\n" + picture(
                 pictures, "parts", "Bits for each tetrahedron by part")


def loading(results, pictures):
    rows = []
    for one in results["inputs"]:
        for load in one.get("load", []):
            files = by_format(load)
            rows.append([label(one), load["threads"]]
                        + [number(load["tets"] / median(files[name]) / 1e6) for name in files]
                        + [f"{ratio(load, name):.2f}" for name in files if name != "gtn"])
    memory = []
    for one in results["inputs"]:
        peak = one.get("peak")
        if peak:
            grid = peak["gtn"]["gridBytes"]
            memory.append([label(one), f"{grid / 2**20:,.0f}"] + [
                f"{(peak[name]['peak'] - peak[name]['before']) / grid:.2f}" for name in peak])
    return """## Loading

From file to `vtkUnstructuredGrid` in memory, by `vtkGatunReader` and by
`vtkXMLUnstructuredGridReader`: million tetrahedra a second, and how many times longer VTK's reader
takes than Gatun's (more than 1: Gatun is faster). Each number of threads is a process of its own;
after one round to warm up, all formats take turns round by round, forwards and backwards; medians,
ratios within each round. The files are in the page cache, so the disk does not count; where it
does, the smaller file gains.

""" + table(["mesh", "threads", ".gtn", "raw", "zlib", "LZMA", "raw / .gtn", "zlib / .gtn",
             "LZMA / .gtn"], rows) + "\n" + picture(
                 pictures, "load", "Million tetrahedra a second by format") + """
Most memory in use while loading, over what the process had before, as a multiple of the grid
loaded (1 is the grid itself); each in a process of its own, 2 threads.

""" + table(["mesh", "grid, MiB", ".gtn", ".vtu raw", ".vtu zlib"], memory)


def stage_seconds(measured):
    """Median seconds of each stage; "rest" is what the whole takes beyond the others."""
    seconds = {stage["stage"]: median(stage) for stage in measured["stages"]}
    check = seconds.pop("check alone")
    whole = seconds.pop("all at once")
    seconds["checksum"] = check
    seconds["read"] = max(0.0, seconds.pop("read and check") - check)
    rest = whole + seconds["directory"] - sum(seconds.values())
    seconds["hand over"] = max(0.0, rest)
    return seconds


def stages(results, pictures):
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

Decoding by the core, without VTK, on one thread: nanoseconds for each tetrahedron by stage, taken
one after the other over all chunks. *Hand over* is what decoding all at once takes beyond the sum:
writing points, connectivity and values to their places in the caller's memory, and making that
memory.

""" + table(["mesh", *(names or []), "all"], rows) + "\n" + picture(
        pictures, "stages", "Nanoseconds for each tetrahedron by stage")


def writing(results):
    rows = []
    for one in results["inputs"]:
        lzma = by_format(one["size"])["vtu-lzma"]["seconds"]
        for write in one.get("write", []):
            files = by_format(write)
            rows.append([label(one), write["threads"]]
                        + [number(write["tets"] / median(files[name]) / 1e6) for name in files]
                        + [number(write["tets"] / lzma / 1e6), f"{ratio(write, 'vtu-zlib'):.2f}"])
    memory = []
    for one in results["inputs"]:
        peak = one.get("peakWrite")
        if peak:
            memory.append([label(one), f"{peak['gridBytes'] / 2**20:,.0f}",
                           f"{(peak['peak'] - peak['before']) / peak['gridBytes']:.2f}"])
    return """## Writing

Million tetrahedra a second; LZMA was written once only.

""" + table(["mesh", "threads", ".gtn", "raw", "zlib", "LZMA", "zlib / .gtn"], rows) + """
Memory that writing `.gtn` takes beyond the input, as a multiple of it, 2 threads.

""" + table(["mesh", "input, MiB", ".gtn"], memory)


def pieces(results):
    text = """## Pieces

All pieces read one after the other, each by a reader of its own as the ranks of a parallel program
would; time is the sum, then that of the slowest piece, which is what a parallel program waits for.
2 threads. VTK's `.vtu` reader cannot divide a file: there is nothing to compare with.

"""
    for one in results["inputs"]:
        if "pieces" in one:
            measured = one["pieces"]
            rows = [[case["pieces"], case["ghostLevels"], f"{case['tets']:,}",
                     f"{case['bytesRead']:,}",
                     f"{100 * case['bytesRead'] / measured['fileBytes']:.1f}",
                     number(1000 * median(case)),
                     number(1000 * statistics.median(case["slowestPiece"]))]
                    for case in measured["cases"]]
            text += table(["pieces", "ghost levels", "tetrahedra", "bytes read", "% of file",
                           "all, ms", "slowest, ms"], rows)
    return text


def regions(results, pictures):
    text = """## Parts of a mesh

What the reader reads from the file when it is asked for a box, or for values of Density. What it
gives are whole chunks: small chunks fit better, and cost some file size.

"""
    for one in results["inputs"]:
        for file in one.get("roi", {}).get("files", []):
            rows = [[region["region"], f"{region['tets']:,}", f"{region['bytesRead']:,}",
                     f"{100 * region['bytesRead'] / file['fileBytes']:.1f}",
                     number(1000 * median(region))] for region in file["regions"]]
            text += (f"Mesh {label(one)}, {file['chunks']} chunks of at most {file['chunkTets']:,} "
                     f"tetrahedra, {file['fileBytes']:,} bytes:\n\n")
            text += table(["asked for", "tetrahedra", "bytes read", "% of file", "ms"], rows) + "\n"
    return text + picture(pictures, "roi", "Bytes read for parts of a mesh")


def series(results):
    measured = results["series"]
    seconds = {case["case"]: median(case) for case in measured["cases"]}
    steps = measured["steps"]
    rows = [["all in one .gtn", f"{measured['gtnBytes']:,}"],
            ["of that the mesh", f"{measured['gtnMeshBytes']:,}"],
            [".vtu zlib, one a step, and a .pvd", f"{measured['vtuBytes']:,}"],
            [".vtu / .gtn", f"{measured['vtuBytes'] / measured['gtnBytes']:.1f}"]]
    timed = [[order, number(1000 * seconds[f"gtn {order}"] / steps),
              number(1000 * seconds[f"vtu-zlib {order}"] / steps),
              f"{seconds[f'vtu-zlib {order}'] / seconds[f'gtn {order}']:.2f}"]
             for order in ("forward", "at random")]
    text = f"""## Time series

{steps} steps of one float array, which changes everywhere from step to step, over one mesh
({measured["mesh"]}, {measured["tets"]:,} tetrahedra).

""" + table(["files", "bytes"], rows) + """
Milliseconds a step, through all steps, opening included, 2 threads:

""" + table(["order", ".gtn", ".vtu zlib", ".vtu / .gtn"], timed)
    rows = [[one["name"], one["steps"], f"{one['tets']:,}", f"{one['inputBytes']:,}",
             f"{one['gtnBytes']:,}", f"{one['vtuBytes']:,}"] for one in results.get("exodus", [])]
    if rows:
        text += "\nFiles with time steps of the data folder, bytes (their cells cut into "
        text += "tetrahedra, but for the input):\n\n"
        text += table(["file", "steps", "tetrahedra", "input", ".gtn", ".vtu zlib, all steps"],
                      rows)
    return text


def write(results, out):
    """Writes benchmarks.md, and pictures into benchmarks/ where matplotlib is there."""
    try:
        import benchmarkPlots
        pictures = benchmarkPlots.draw(results, out / "benchmarks")
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no pictures.")
        pictures = set()
    page = [head(results), goals(results), inputs(results), sizes(results, pictures),
            loading(results, pictures), stages(results, pictures), writing(results),
            pieces(results), regions(results, pictures), series(results),
            *renderingReport.sections(results, pictures)]
    (out / "benchmarks.md").write_text("\n".join(part.rstrip() + "\n" for part in page),
                                       encoding="utf-8")
