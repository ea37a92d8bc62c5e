# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runIsosurfaces.py."""

import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, rounds_of, span, spread, table

FOLDER = "isosurface-study"
NAMES = {"layers": "Gatun, layers", "spatial": "Gatun, spatial",
         "zlib": ".vtu (zlib), vtkContour3DLinearGrid", "raw": ".vtu (raw), vtkContour3DLinearGrid",
         "span": ".vtu (zlib), vtkContourGrid and vtkSpanSpace"}
MIB = 2**20


def memory(run):
    return run["peak"] - run["before"]


def seconds(run):
    """The rounds of a way; only their median where they were not kept."""
    return run.get("rounds", [run["seconds"]])


def ratios(mesh, what, peer="zlib", own="layers"):
    """The amount of the peer divided by ours, for each value."""
    return [what(run[peer]) / what(run[own]) for run in mesh["cold"]]


def time_ratios(mesh, peer="zlib", own="layers"):
    """The time of the peer divided by ours, in each round of each value."""
    return [value for run in mesh["cold"]
            for value in rounds_of(zip(seconds(run[peer]), seconds(run[own])))]


def read_bytes(run):
    return run["bytes"]


def repeated(mesh, way):
    """Seconds: opening; the values for the first and for the second time; a step of a slider."""
    runs = mesh["repeated"][way]
    half = len(runs["sweep"]["seconds"]) // 2
    return [runs["sweep"]["open"],
            *(statistics.median(part) for part in (runs["sweep"]["seconds"][:half],
                                                   runs["sweep"]["seconds"][half:],
                                                   runs["slider"]["seconds"][1:]))]


def _head(results):
    text = """# The isosurface study

The cost of extracting an isosurface from a file with Gatun ([guide](../isosurfaces.md)) and with
VTK's own classes. `Utilities/bench.sh --isosurfaces` (Benchmarks/Studies/runIsosurfaces.py) writes
this page. All results are in [results.json](isosurface-study/results.json). The isovalues are the 10,
30, 50, 70 and 90 % quantiles of the values at the points. Files are in the page cache, and all
processors are used.

""" + benchmarkText.machine(results)
    rows = [[mesh["name"], f"{mesh['tets']:,}", f"{mesh['points']:,}",
             *(number(mesh["bytes"][kind] / MIB)
               for kind in ("vtu-raw", "vtu-zlib", "spatial", "layers")), mesh["about"]]
            for mesh in results["meshes"]]
    return text + "\n" + table(["mesh", "tetrahedra", "points", "MiB, raw .vtu", "zlib .vtu",
                                "Gatun, spatial", "Gatun, layers", "description"], rows)


def _comparison(mesh, peer, own):
    return f"""time {span(time_ratios(mesh, peer, own))}, bytes
        {span(ratios(mesh, read_bytes, peer, own))}, memory
        {span(ratios(mesh, memory, peer, own))}"""


def _cold(results, plots):
    text = "## From a file to the surface\n\n" + paragraph("""Each surface is extracted by a separate
        process. The time is that from opening the file to the triangles, with merged points and the
        array interpolated. The bytes are all that the process reads in that time. The memory is
        the peak above that of the process before.""")
    for mesh in results["meshes"]:
        rows = []
        for run in mesh["cold"]:
            for way, name in NAMES.items():
                one = run[way]
                used = (f"{one['chunksUsed']:.0f} of {one['chunks']:.0f}, "
                        f"{100 * one['tetsUsed'] / mesh['tets']:.1f} %" if "chunks" in one else "")
                rows.append([f"{run['value']:.4g}", f"{one['triangles']:,.0f}", name,
                             spread(1000 * s for s in seconds(one)), f"{one['bytes'] / MIB:.2f}",
                             number(memory(one) / MIB), used])
        text += f"\n### {mesh['name']}\n\n" + table(
            ["isovalue", "triangles", "method", "ms", "MiB read", "peak, MiB",
             "chunks, tetrahedra decoded"], rows)
        text += "\n" + paragraph(f"""Ratios over the isovalues and their rounds (above 1: Gatun needs less). Zlib .vtu
            to Gatun with layers: {_comparison(mesh, "zlib", "layers")}. Raw .vtu to Gatun with
            layers: {_comparison(mesh, "raw", "layers")}. Zlib .vtu to Gatun without layers:
            {_comparison(mesh, "zlib", "spatial")}.""")
    return text + "\n" + image(plots, "cold", "Time, bytes and memory of each method", FOLDER)


def _repeated(results):
    rows = [[mesh["name"], NAMES[way], *(number(1000 * s) for s in repeated(mesh, way))]
            for mesh in results["meshes"] for way in mesh["repeated"]]
    return "## One value after the other\n\n" + paragraph("""The file stays open, and the mesh (VTK) or
        the decoded chunks (Gatun, up to 256 MiB) stay in memory. Milliseconds (medians) for opening
        the file or loading the mesh, for one of the five values the first time and the second
        time, and for one step of a slider of half a percent of the range of values.""") + (
            "\n" + table(["mesh", "method", "open", "first time", "again", "slider"], rows))


def _whole(results):
    rows = []
    for mesh in results["meshes"]:
        for run in mesh.get("whole", []):
            layers, spatial, peer = (one["seconds"] for one in run["files"])
            rows.append([mesh["name"], run["threads"],
                         *(number(1000 * statistics.median(s)) for s in (layers, spatial, peer)),
                         spread(rounds_of(zip(layers, spatial))),
                         spread(rounds_of(zip(peer, layers)))])
    if not rows:
        return ""  # results from before this was measured
    return "## The whole file\n\n" + paragraph("""Milliseconds for reading the whole mesh into a
        vtkUnstructuredGrid, medians of interleaved rounds.""") + "\n" + table(
            ["mesh", "threads", "Gatun, layers", "Gatun, spatial", ".vtu (zlib)",
             "layers / spatial", ".vtu (zlib) / layers"], rows)


def _memory(results):
    rows = []
    for mesh in results["meshes"]:
        for run in mesh["memory"]:
            own, linear, tree = (statistics.median(way["seconds"]) for way in run["ways"])
            relative = rounds_of(zip(run["ways"][1]["seconds"], run["ways"][0]["seconds"]))
            rows.append([mesh["name"], f"{run['value']:.4g}", f"{run['ways'][0]['triangles']:,}",
                         *(number(1000 * s) for s in (own, linear, tree)),
                         f"**{spread(relative)}**", number(mesh["tets"] / own / 1e6)])
    return "## A mesh in memory\n\n" + paragraph("""The same filter on a vtkUnstructuredGrid, compared with
        vtkContour3DLinearGrid (merged points) and with vtkContourGrid and vtkSpanSpace, whose tree is
        built before. Milliseconds, medians of interleaved rounds.""") + "\n" + table(
            ["mesh", "isovalue", "triangles", "Gatun", "3DLinearGrid", "SpanSpace",
             "3DLinearGrid / Gatun", "M tets/s, Gatun"], rows)


def _strips(results):
    rows = []
    for mesh in results["meshes"]:
        for kind, run in mesh["strips"].items():
            corners = 3 * run["triangles"]
            for name, way in (("vtkGatunContour", "gatun"), ("vtkStripper", "vtkStripper")):
                strips = run[way]["strips"] + run[way]["loose"]
                named = run[way]["corners"] + 3 * run[way]["loose"]
                rows.append([mesh["name"], kind, name, f"{run['triangles']:,}", f"{strips:,}",
                             number(run["triangles"] / strips),
                             f"{100 * (1 - named / corners):.0f} %"])
    return "## Strips\n\n" + paragraph("""Triangle strips at the median value. vtkGatunContour takes the
        triangles in the order in which the walk through the mesh yields them. vtkStripper works on
        the finished surface and may continue a strip with any triangle. *Saved* is relative to the
        point ids of single triangles.""") + "\n" + table(
            ["mesh", "file", "made by", "triangles", "strips", "triangles per strip", "saved"], rows)


def _sweep(results, plots):
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
    return "## Number of layers\n\n" + paragraph("""The size of a file by its number of layers, relative to
        the file without layers, and the cost of a surface: means over the five isovalues.""") + (
            "\n" + table(["mesh", "layers", "chunks", "MiB", "size", "tetrahedra decoded", "MiB read",
                          "ms"], rows) + "\n" + image(plots, "layers", "Cost and benefit of layers",
                                                      FOLDER))


def page(results, plots):
    parts = [_head(results), _cold(results, plots), _repeated(results), _whole(results),
             _memory(results), _strips(results), _sweep(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts if part)


def write(results, out):
    benchmarkText.write_page(results, out, "isosurface-study", page, "isosurfacePlots")
