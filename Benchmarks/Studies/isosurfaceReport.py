# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page made of what runIsosurfaces.py has measured."""

import statistics

from benchmarkText import machine, number, paragraph, picture, table

FOLDER = "isosurface-study"
NAMES = {"layers": "Gatun, layers", "spatial": "Gatun, spatial",
         "zlib": ".vtu (zlib), vtkContour3DLinearGrid", "raw": ".vtu (raw), vtkContour3DLinearGrid",
         "span": ".vtu (zlib), vtkContourGrid and vtkSpanSpace"}
MIB = 2**20


def memory(run):
    return run["peak"] - run["before"]


def ratio(mesh, what, peer="zlib", own="layers"):
    """How many times less than the peer, of each value."""
    return [what(run[peer]) / what(run[own]) for run in mesh["cold"]]


def spread(values):
    return f"{number(min(values))} to {number(max(values))}"


def repeated(mesh, way):
    """Seconds: to open; the values for the first and for the second time; a step of a slider."""
    runs = mesh["repeated"][way]
    half = len(runs["sweep"]["seconds"]) // 2
    return [runs["sweep"]["open"],
            *(statistics.median(part) for part in (runs["sweep"]["seconds"][:half],
                                                   runs["sweep"]["seconds"][half:],
                                                   runs["slider"]["seconds"][1:]))]


def _head(results):
    text = """# The study of isosurfaces

What it takes to get an isosurface of a file with Gatun ([how](../isosurfaces.md)) and with VTK's own classes.
`Utilities/bench.sh --isosurfaces` (Benchmarks/Studies/runIsosurfaces.py) made this page; every figure
behind it is in [results.json](isosurface-study/results.json). Isovalues are the quantiles 10, 30, 50,
70 and 90 % of the values at the points. Files are in the system's cache; all processors are used.

""" + machine(results["machine"])
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small meshes: not to be quoted.**\n"
    rows = [[mesh["name"], f"{mesh['tets']:,}", f"{mesh['points']:,}",
             *(number(mesh["bytes"][kind] / MIB)
               for kind in ("vtu-raw", "vtu-zlib", "spatial", "layers")), mesh["about"]]
            for mesh in results["meshes"]]
    return text + "\n" + table(["mesh", "tetrahedra", "points", "MiB, raw .vtu", "zlib .vtu",
                                "Gatun, spatial", "Gatun, layers", "what"], rows)


def _cold(results, pictures):
    text = "## From a file to the surface\n\n" + paragraph("""A process of its own for each surface: from
        opening the file to the triangles, with merged points and the array interpolated. Bytes are all
        that the process reads meanwhile; memory is the peak above what the process had before.
        Medians.""")
    for mesh in results["meshes"]:
        rows = []
        for run in mesh["cold"]:
            for way, name in NAMES.items():
                one = run[way]
                used = (f"{one['chunksUsed']:.0f} of {one['chunks']:.0f}, "
                        f"{100 * one['tetsUsed'] / mesh['tets']:.1f} %" if "chunks" in one else "")
                rows.append([f"{run['value']:.4g}", f"{one['triangles']:,.0f}", name,
                             number(1000 * one["seconds"]), f"{one['bytes'] / MIB:.2f}",
                             number(memory(one) / MIB), used])
        text += f"\n### {mesh['name']}\n\n" + table(
            ["isovalue", "triangles", "way", "ms", "MiB read", "MiB at most",
             "chunks, tetrahedra decoded"], rows)
        text += "\n" + paragraph(f"""Layers against zlib and vtkContour3DLinearGrid, over the isovalues:
            time {spread(ratio(mesh, lambda run: run["seconds"]))} times less, bytes
            {spread(ratio(mesh, lambda run: run["bytes"]))} times fewer, memory
            {spread(ratio(mesh, memory))} times less. Against the raw file: time
            {spread(ratio(mesh, lambda run: run["seconds"], "raw"))}, bytes
            {spread(ratio(mesh, lambda run: run["bytes"], "raw"))}, memory
            {spread(ratio(mesh, memory, "raw"))}. Without layers, against zlib: time
            {spread(ratio(mesh, lambda run: run["seconds"], "zlib", "spatial"))}, bytes
            {spread(ratio(mesh, lambda run: run["bytes"], "zlib", "spatial"))}, memory
            {spread(ratio(mesh, memory, "zlib", "spatial"))}.""")
    return text + "\n" + picture(pictures, "cold", "Time, bytes and memory of each way", FOLDER)


def _repeated(results):
    rows = [[mesh["name"], NAMES[way], *(number(1000 * s) for s in repeated(mesh, way))]
            for mesh in results["meshes"] for way in mesh["repeated"]]
    return "## One value after the other\n\n" + paragraph("""The file stays open, the mesh (VTK) or the
        decoded chunks (Gatun, up to 256 MiB) in memory. Milliseconds: to open, or to load the mesh; one of
        the five values for the first time, and for the second time; one step of a slider, of half a percent
        of the range of the values. Medians.""") + "\n" + table(
            ["mesh", "way", "open", "first time", "again", "slider"], rows)


def _memory(results):
    rows = []
    for mesh in results["meshes"]:
        for run in mesh["memory"]:
            own, linear, span = (statistics.median(way["seconds"]) for way in run["ways"])
            rows.append([mesh["name"], f"{run['value']:.4g}", f"{run['ways'][0]['triangles']:,}",
                         *(number(1000 * s) for s in (own, linear, span)),
                         f"**{number(linear / own)}**", number(mesh["tets"] / own / 1e6)])
    return "## A mesh in memory\n\n" + paragraph("""The same filter on a vtkUnstructuredGrid, next to
        vtkContour3DLinearGrid (merged points) and to vtkContourGrid with vtkSpanSpace, whose tree is made
        before. Milliseconds, medians of interleaved runs.""") + "\n" + table(
            ["mesh", "isovalue", "triangles", "Gatun", "3DLinearGrid", "SpanSpace",
             "3DLinearGrid / Gatun", "M tets/s, Gatun"], rows)


def _strips(results):
    rows = []
    for mesh in results["meshes"]:
        for kind, run in mesh["strips"].items():
            corners = 3 * run["triangles"]
            for name, way in (("walk order", "gatun"), ("vtkStripper", "vtkStripper")):
                strips = run[way]["strips"] + run[way]["loose"]
                named = run[way]["corners"] + 3 * run[way]["loose"]
                rows.append([mesh["name"], kind, name, f"{run['triangles']:,}", f"{strips:,}",
                             number(run["triangles"] / strips),
                             f"{100 * (1 - named / corners):.0f} %"])
    return "## Strips\n\n" + paragraph("""Triangle strips at the median: those that vtkGatunContour makes
        of the triangles in the order in which the walk through the mesh yields them, and those that
        vtkStripper finds afterwards, which may take any triangle next. Saved: of the points that single
        triangles name.""") + "\n" + table(
            ["mesh", "file", "strips", "triangles", "strips", "triangles a strip", "saved"], rows)


def _sweep(results, pictures):
    rows = []
    for mesh in results["meshes"]:
        spatial = mesh["bytes"]["spatial"]
        for one in mesh["sweep"]:
            mean = {key: statistics.fmean(run[key] for run in one["runs"])
                    for key in ("seconds", "bytes", "tetsUsed", "chunks")}
            rows.append([mesh["name"], one["layers"], f"{mean['chunks']:.0f}",
                         f"{one['bytes'] / MIB:.2f}", f"{100 * (one['bytes'] / spatial - 1):+.0f} %",
                         f"{100 * mean['tetsUsed'] / mesh['tets']:.1f} %",
                         f"{mean['bytes'] / MIB:.2f}", number(1000 * mean["seconds"])])
    return "## How many layers\n\n" + paragraph("""What layers cost in bytes, against the file without
        any, and what a surface then takes: means over the five isovalues.""") + "\n" + table(
            ["mesh", "layers", "chunks", "MiB", "cost", "tetrahedra decoded", "MiB read", "ms"],
            rows) + "\n" + picture(pictures, "layers", "Cost and use of layers", FOLDER)


def write(results, out):
    """Writes isosurface-study.md, and plots where matplotlib is there."""
    try:
        import isosurfacePlots
        pictures = isosurfacePlots.draw(results, out / FOLDER)
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no plots.")
        pictures = set()
    page = [_head(results), _cold(results, pictures), _repeated(results), _memory(results),
            _strips(results), _sweep(results, pictures)]
    (out / "isosurface-study.md").write_text(
        "\n".join(part.rstrip() + "\n" for part in page if part), encoding="utf-8")
