# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runCells.py."""

import benchmarkText
from benchmarkText import paragraph, ratio, spread, table

PAGE = "cells-study"


def label(mesh):
    name = mesh["name"]
    if name.startswith("hexes-"):
        return "grid of hexahedra"
    return f"`{name}`"


def kinds(mesh):
    """The types of cells, most frequent first."""
    types = sorted(mesh["info"]["cellTypes"], key=lambda one: -one["cells"])
    return ", ".join(one["name"].replace("vtk", "") for one in types)


def sizes_of(mesh):
    return {part: one["bitsPerCell"] for part, one in mesh["info"]["sizes"].items()}


def is_bare(mesh):
    return not mesh["info"]["arrays"]


def file_size(mesh, form):
    return next(one["bytes"] for one in mesh["files"] if one["format"] == form)


def load_ratios(mesh, threads, form="vtu-zlib"):
    """The time of a file of VTK over ours, for each round."""
    def seconds(wanted):
        return next(one["seconds"] for one in mesh["loads"]
                    if one["format"] == wanted and one["threads"] == threads)
    return benchmarkText.rounds_of(zip(seconds(form), seconds("gtn")))


def _head(results):
    return """# Cells of all types

How large `.gtn` files of cells of all types are, by part, and how fast they are loaded, beside VTK's
files ([guide](../cells.md)). `Utilities/bench.sh --cells` (Benchmarks/Studies/runCells.py) writes
this page. All results are in [results.json](cells-study/results.json).

""" + benchmarkText.machine(results)


def _sizes(results):
    head = ["mesh", "cells", "types", "chunks", "connectivity", "coordinates", "shared points", "arrays",
            "other", "file", "zlib `.vtu` / ours", "LZMA `.vtu` / ours"]
    rows = []
    for mesh in results["meshes"]:
        bits = sizes_of(mesh)
        known = sum(bits[part] for part in ("connectivity", "geometry", "sharedGeometry", "arrays"))
        ours = file_size(mesh, "gtn")
        rows.append([
            label(mesh), f"{mesh['info']['cells']:,}", kinds(mesh), mesh["info"]["chunks"],
            *(f"{bits[part]:.2f}" for part in ("connectivity", "geometry", "sharedGeometry", "arrays")),
            f"{bits['file'] - known:.2f}", f"{bits['file']:.2f}",
            ratio(file_size(mesh, "vtu-zlib") / ours), ratio(file_size(mesh, "vtu-lzma") / ours)])
    return "## Sizes in bits a cell\n\n" + paragraph("""With default settings, in the order of the file.
        *Connectivity* includes the order of the corners within a cell and the types of the cells. The
        sizes in front are those of the file with all time steps; those of `.vtu` files and the ratios
        are for the first step.""") + "\n" + table(head, rows)


def _loads(results):
    threads = sorted({one["threads"] for mesh in results["meshes"] for one in mesh["loads"]})
    head = ["mesh", "cells"]
    for count in threads:
        plural = "s" if count > 1 else ""
        head += [f"ours, M cells/s, {count} thread{plural}", f"zlib / ours, {count} thread{plural}",
                 f"LZMA / ours, {count} thread{plural}"]
    rows = []
    for mesh in results["meshes"]:
        row = [label(mesh), f"{mesh['info']['cells']:,}"]
        for count in threads:
            ours = next(one["seconds"] for one in mesh["loads"]
                        if one["format"] == "gtn" and one["threads"] == count)
            row += [spread([mesh["info"]["cells"] / 1e6 / s for s in ours]),
                    spread(load_ratios(mesh, count), ratio),
                    spread(load_ratios(mesh, count, "vtu-lzma"), ratio)]
        rows.append(row)
    return "## Loading\n\n" + paragraph("""From the page cache into a `vtkUnstructuredGrid`, with all arrays
        of the first step. Ratios above 1: ours is faster. VTK's readers use one
        thread.""") + "\n" + table(head, rows)


def page(results, _):
    return "\n".join(part.rstrip() + "\n" for part in (_head(results), _sizes(results), _loads(results)))


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page)
