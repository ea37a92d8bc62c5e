# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runSurfaces.py."""

import benchmarkText
import surfaceMotionReport
from benchmarkText import paragraph, ratio, span, spread, table

PAGE = "surface-study"
WAYS = {"gtn": "`.gtn`", "draco": "Draco", "openctm": "OpenCTM", "meshopt": "meshoptimizer + zstd",
        "vtp-zlib": "zlib `.vtp`", "vtp-lzma": "LZMA `.vtp`"}
PARTS = {"connectivity": "connectivity", "geometry": "points", "sharedGeometry": "shared points",
         "arrays": "arrays"}


def bits(surface, size):
    return 8 * size / surface["triangles"]


def peers(surface):
    """The sizes of the other formats."""
    return {way: size for way, size in surface["bytes"].items() if way != "gtn"}


def best_ratio(surface):
    """Our size over that of the smallest peer."""
    return surface["bytes"]["gtn"] / min(peers(surface).values())


def order_bits(surface):
    """What the original order of points, cells and corners takes."""
    return bits(surface, surface["kept"]["file"] - surface["parts"]["file"])


def rounded_ratio(surface):
    known = surface["rounded"]
    return known["gtn"]["file"] / known["draco"] if "draco" in known else None


def load_ratios(surface, way):
    return benchmarkText.rounds_of(zip(surface["seconds"][way], surface["seconds"]["gtn"]))


def text(value, write=ratio):
    return "-" if value is None else write(value)


def _head(results):
    return """# Surfaces

How large `.gtn` files of triangles are, by part, and how fast they are decoded, beside Draco, OpenCTM,
meshoptimizer and `.vtp` files; and images of them in motion ([guide](../surfaces.md)). `Utilities/bench.sh --surfaces`
(Benchmarks/Studies/runSurfaces.py) writes this page. All results are in
[results.json](surface-study/results.json).

""" + benchmarkText.machine(results)


def _parts(results):
    head = ["surface", "what", "triangles", *PARTS.values(), "other", "file", "order, on request"]
    rows = []
    for surface in results["surfaces"]:
        sizes = surface["parts"]
        known = [bits(surface, sizes.get(part, 0)) for part in PARTS]
        whole = bits(surface, sizes["file"])
        rows.append([surface["name"], surface["what"], f"{surface['triangles']:,}",
                     *map(ratio, known), ratio(whole - sum(known)), ratio(whole),
                     ratio(order_bits(surface))])
    return "## Bits a triangle by part\n\n" + paragraph("""Without loss, with default settings, where a triangle
        may begin with any of its corners, as it may with Draco, OpenCTM and meshoptimizer. *Order* is what
        `--keep-order all` adds: the original order of points and triangles and the first corner of each
        triangle.""") + "\n" + table(head, rows)


def _sizes(results):
    head = ["surface", *WAYS.values(), "ours / best peer"]
    rows = [[surface["name"],
             *(text(surface["bytes"].get(way), lambda size, s=surface: ratio(bits(s, size)))
               for way in WAYS), ratio(best_ratio(surface))] for surface in results["surfaces"]]
    return "## Bits a triangle without loss\n\n" + paragraph("""Whole files. Only the textured surface has arrays,
        normals and texture coordinates. Draco with `-qp 0 -qt 0 -qn 0 -cl 10`, OpenCTM with MG1 at level
        9, zstd at level 19.""") + "\n" + table(head, rows)


def _rounded(results):
    head = ["surface", "ours, connectivity", "ours, points", "ours, file", "Draco", "ours / Draco"]
    rows = []
    for surface in results["surfaces"]:
        ours = surface["rounded"]["gtn"]
        rows.append([
            surface["name"], ratio(bits(surface, ours["connectivity"])),
            ratio(bits(surface, ours["geometry"] + ours.get("sharedGeometry", 0))),
            ratio(bits(surface, ours["file"])),
            text(surface["rounded"].get("draco"), lambda size, s=surface: ratio(bits(s, size))),
            text(rounded_ratio(surface))])
    return "## Bits a triangle with coordinates of 14 bits\n\n" + paragraph("""`--point-error bits:14` beside
        Draco's `-qp 14 -qt 0 -qn 0 -cl 10`.""") + "\n" + table(head, rows)


def _loads(results):
    others = [way for way in WAYS if way != "gtn"]
    head = ["surface", "ours, M triangles/s", *(f"{WAYS[way]} / ours" for way in others)]
    rows = []
    for surface in results["surfaces"]:
        ours = surface["seconds"]["gtn"]
        rows.append([surface["name"], spread([surface["triangles"] / 1e6 / s for s in ours]),
                     *(spread(load_ratios(surface, way), ratio) if way in surface["seconds"] else "-"
                       for way in others)])
    return "## Decoding\n\n" + paragraph("""From the page cache into a `vtkPolyData`, with two threads; VTK's
        readers use one. Ratios above 1: ours is faster. Draco and OpenCTM as their programs tell,
        by one thread; meshoptimizer and zstd from memory to memory.""") + "\n" + table(head, rows)


def conclude(results):
    surfaces = results["surfaces"]
    rounded = [value for value in map(rounded_ratio, surfaces) if value is not None]
    connectivity = [bits(surface, surface["parts"]["connectivity"]) for surface in surfaces]
    sentence = f"""Files of {len(surfaces)} surfaces take {span(map_list(best_ratio, surfaces), ratio)} times the
        bytes of the best peer without loss, with {span(connectivity, ratio)} bits a triangle of
        connectivity."""
    if rounded:
        sentence += f" With coordinates of 14 bits they are {span(rounded, ratio)} times as large as Draco's."
    return sentence + surfaceMotionReport.conclude(results)


def map_list(function, values):
    return [function(value) for value in values]


def page(results, plots):
    return "\n".join(part.rstrip() + "\n" for part in (
        _head(results), paragraph(conclude(results)), _parts(results), _sizes(results),
        _rounded(results), _loads(results), surfaceMotionReport.section(results, plots))).rstrip() + "\n"


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "surfacePlots")
