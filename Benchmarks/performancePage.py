# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Documentation/performance.md, and the table of README.md."""

import statistics
import textwrap

MIB = 2**20


def number(value):
    """Three significant digits; fewer below 0.1."""
    digits = 0 if value >= 100 else 1 if value >= 10 else 2 if value >= 0.1 else 3
    return f"{value:,.{digits}f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def paragraph(text):
    return textwrap.fill(" ".join(text.split()), 110, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def medians(runs, key):
    return [run[key] for run in runs]


def advantage(own, peer, more_is_better=False):
    """Above 1 where Gatun is better, else bold; with the range over the rounds."""
    pairs = zip(own, peer) if more_is_better else zip(peer, own)
    ratios = [a / b for a, b in pairs]
    text = f"{statistics.median(ratios):.2f}"
    text = f"**{text}**" if float(text) < 1 else text
    least, most = f"{min(ratios):.2f}", f"{max(ratios):.2f}"
    return text + (f" ({least} to {most})" if least != most else "")


def row(what, unit, own, peer, more_is_better=False):
    """The cells of a row. own and peer are the rounds."""
    return [f"{what} ({unit})", number(statistics.median(own)), number(statistics.median(peer)),
            advantage(own, peer, more_is_better)]


def find(entries, name):
    return next((entry for entry in entries if entry["name"] == name), None)


def bits(entry, form):
    return 8 * entry["pack"]["files"][form]["bytes"] / entry["pack"]["tets"]


def rates(load, form):
    """Million cells per second."""
    return [load["cells"] / seconds / 1e6 for seconds in load["seconds"][form]]


def memory(runs):
    return [(run["peak"] - run["before"]) / MIB for run in runs]


def machine(results):
    """Where, when and how the results were measured."""
    known = results["machine"]
    text = paragraph(f"""*Machine:* {known["processor"]}, {known["processors"]} processors,
        {known["memory"] / 2**30:.1f} GiB; {known["compiler"]} ({known["build"]}); VTK {known["vtk"]}, threads
        by {known["backend"]}; Gatun {known["gatun"]}, commit {known["commit"]}; {known["date"]}, in
        {results["seconds"] / 60:.0f} minutes. The load average was {known["loadBefore"]:.1f} before and
        {known["loadAfter"]:.1f} after.""")
    if results["quick"]:
        text += "\n**Tiny meshes, one round: not to be quoted.**\n"
    return text


def loading(results, name, threads, form="gtn"):
    load = find(results["files"], name)[f"load{threads}"]
    return rates(load, form), rates(load, "vtu-zlib")


def images(results):
    return results["images"] or {"first": [], "later": []}


def first_images(results):
    """Rows of time and memory from a file to the first image."""
    for entry in images(results)["first"]:
        what = f"first, {entry['name']}, {entry['size']}"
        yield what, "s", medians(entry["gtn"], "seconds"), medians(entry["vtu-zlib"], "seconds")
        for form, budget in (("gtn", ""), ("gtn-0", ", `MemoryBudget` 0")):
            yield f"{what}{budget}", "MiB", memory(entry[form]), memory(entry["vtu-zlib"])


def later_images(results):
    for entry in images(results)["later"]:
        threads = ", one thread" if entry["threads"] == 1 else ""
        yield (f"later, {entry['name']}, {entry['size']}{threads}", "s",
               *(entry["mappers"][way]["seconds"] for way in ("gatun", "vtk")))


def contours(results):
    for entry in results["contours"]:
        peer = medians(entry["files"]["vtu-zlib"], "seconds")
        for form, text in (("gtn", "file"), ("layers", "file with layers")):
            yield f"{entry['name']}, {text}", "s", medians(entry["files"][form], "seconds"), peer
    for entry in results["contours"][:2]:
        yield f"{entry['name']}, in memory", "s", entry["memory"]["gatun"], entry["memory"]["vtk"]


def best_peer(surface):
    return min((size, way) for way, size in surface["bytes"].items() if way != "gtn")


def readme_rows(results):
    """Rows with the peer."""
    delaunay = find(results["files"], "delaunay")
    lzma, zlib = "`.vtu`, best LZMA", "`.vtu`, zlib"
    yield "File size, Delaunay mesh", "bits per tetrahedron", [bits(delaunay, "gtn")], [
        bits(delaunay, "vtu-lzma-best")], lzma, False
    yield "Loading it", "million tetrahedra per second", *loading(results, "delaunay", 0), zlib, True
    grid = find(images(results)["first"], "grid")
    caster = "VTK's ray caster"
    if grid:
        size = f"{grid['size']} x {grid['size']}"
        yield f"File to first image, grid, {size}", "s", medians(grid["gtn"], "seconds"), medians(
            grid["vtu-zlib"], "seconds"), f"{zlib}, and {caster}", False
        yield "Peak memory of that image", "MiB", memory(grid["gtn"]), memory(
            grid["vtu-zlib"]), f"{zlib}, and {caster}", False
        later = [entry for entry in images(results)["later"] if entry["name"] == "delaunay" and
                 entry["size"] == grid["size"]][0]
        yield f"Later frames, Delaunay mesh in memory, {size}", "s", later["mappers"]["gatun"][
            "seconds"], later["mappers"]["vtk"]["seconds"], caster, False
    files = find(results["contours"], "grid")["files"]
    yield "File to isosurface, grid", "s", medians(files["gtn"], "seconds"), medians(
        files["vtu-zlib"], "seconds"), f"{zlib}, and `vtkContour3DLinearGrid`", False
    part = find(results["simplification"], "delaunay")["parts"][0]
    if "peer" in part:
        yield ("Field error at 10 % of the Delaunay mesh", "RMS, 1/1000 of the range",
               [1000 * part["gatun"]["rms"]], [1000 * part["peer"]["rms"]],
               "`vtkUnstructuredGridQuadricDecimation`", False)
    head = find(results["volumes"], "head")
    if head["zfp"]:
        yield (f"Size of a volume at a PSNR of {head['zfp'][0]['psnr']:.0f} dB", "bits per voxel",
               [head["gatun"][0]["bits"]], [head["zfp"][0]["bits"]], "zfp", False)
    scan = find(results["surfaces"], "scan")
    size, way = best_peer(scan)
    yield ("Size of a scanned surface", "bits per triangle", [8 * scan["bytes"]["gtn"] / scan["triangles"]],
           [8 * size / scan["triangles"]], WAYS[way], False)


def readme_table(results):
    rows = []
    for what, unit, own, peer, name, more_is_better in readme_rows(results):
        cells = row(what, unit, own, peer, more_is_better)
        rows.append([*cells[:2], f"{cells[2]}: {name}", cells[3]])
    return table(["measurement", "Gatun", "peer", "advantage (range)"], rows)


WAYS = {"gtn": "`.gtn`", "draco": "Draco", "openctm": "OpenCTM", "meshopt": "meshoptimizer and zstd",
        "vtp-zlib": "zlib `.vtp`", "vtp-lzma": "LZMA `.vtp`"}
HEAD = ["measurement", "Gatun", "VTK", "advantage (range)"]


def _head(results):
    delaunay = find(results["files"], "delaunay")
    return f"""# Performance

`Utilities/setup.sh bench` measures Gatun and its peers and writes this page and [the dissertation,
repeated](dissertation.md) from [results.json](performance/results.json).

{machine(results)}
{paragraph(f'''Peers take turns with Gatun. Cells are medians of the rounds; *advantage* is the median of their ratios, with its
range: above 1 where Gatun is better, else bold. Gatun and `.vtu` files have default
settings (zlib, 64-bit ids); *LZMA* is level 9 with 32-bit ids and blocks of 32 MiB. Files are in the page cache.
All processors are used, unless stated.''')}
{paragraph(f'''*delaunay* is a {delaunay["about"]} ({delaunay["pack"]["tets"]:,} tetrahedra, one float array), *grid* a
synthetic structured grid around a nose (five tetrahedra per hexahedron, one array), *flow* a smaller one with
four arrays. Other meshes are real and not part of the project.''')}"""


def _files(results):
    rows = []
    for entry in results["files"]:
        load = entry["load0"]
        rows.append([entry["name"], f"{entry['pack']['tets']:,}",
                     *(number(bits(entry, form)) for form in ("gtn", "vtu-lzma-best")),
                     advantage([bits(entry, "gtn")], [bits(entry, "vtu-lzma-best")]),
                     *(number(statistics.median(rates(load, form))) for form in ("gtn", "vtu-zlib")),
                     advantage(rates(load, "gtn"), rates(load, "vtu-zlib"), True).split(" ")[0]])
    text = "## Files\n\n" + paragraph("""Bits per cell of whole files, and million cells per second from a file to
        `vtkUnstructuredGrid`. Points and cells of tetrahedral meshes are in random order, but for the grid. Files
        are packed with the small profile.""") + "\n" + table(
            ["mesh", "cells", "`.gtn`", "LZMA `.vtu`", "advantage", "loading `.gtn`", "zlib `.vtu`",
             "advantage"], rows)
    rows = [row("loading delaunay, one thread", "million/s", *loading(results, "delaunay", 1), True)]
    for name in ("delaunay", "grid"):
        entry = find(results["files"], name)
        own, peer = ([run["first"]] for run in (entry["memory"][form] for form in ("gtn", "vtu-zlib")))
        rows.append(row(f"peak memory of loading {name}", "MiB", memory(own), memory(peer)))
    for name in ("delaunay", "grid"):
        files = find(results["files"], name)["pack"]["files"]
        rows.append(row(f"packing {name}", "s", files["gtn"]["seconds"], files["vtu-zlib"]["seconds"]))
    return text + "\n" + table([*HEAD[:2], "zlib `.vtu`", HEAD[3]], rows)


def _images(results):
    if not results["images"]:
        return "## Images\n\nNot measured: there was no display.\n"
    return "## Images\n\n" + paragraph("""Volume rendering from a file to the *first* image, each in a separate process, and *later* images
        of a mesh in memory, by `vtkGatunVolumeMapper` and `vtkUnstructuredGridVolumeRayCastMapper` (with zlib
        `.vtu`), without a graphics card, by the width in pixels. MiB are the peak above an empty window. The
        order of meshes suits VTK's mapper.""") + "\n" + table(
            HEAD, [row(*one) for one in (*first_images(results), *later_images(results))])


def _contours(results):
    return "## Isosurfaces\n\n" + paragraph("""At the median of the array: from the file to the triangles, in a separate process,
        by `vtkGatunContour` from a `.gtn` file without and with layers, and by `vtkContour3DLinearGrid` from
        a zlib `.vtu` file; or from memory.""") + "\n" + table(
            HEAD, [row(*one) for one in contours(results)])


def _simplification(results):
    rows = []
    for entry in results["simplification"]:
        for part in entry["parts"]:
            own, peer = part["gatun"], part.get("peer")
            rows.append([entry["name"], f"{own['tets']:,}", number(1000 * own["rms"]),
                         number(1000 * peer["rms"]) if peer else "-",
                         advantage([own["rms"]], [peer["rms"]]) if peer else "-",
                         number(entry["buildSeconds"]), number(own["seconds"]),
                         number(peer["seconds"]) if peer else "-"])
    return "## Simplification\n\n" + paragraph("""To as many tetrahedra as `vtkUnstructuredGridQuadricDecimation` leaves when it
        is asked for a tenth, on one thread. The error of the field is the root mean square, in 1/1000 of its
        range. Gatun finds the *order* of merges once; *each* mesh then takes little.""") + "\n" + table(
            ["mesh", "tetrahedra", "error, Gatun", "error, VTK", "advantage", "s, order", "s, each", "s, VTK"], rows)


def _volumes(results):
    rows, views = [], []
    for entry in results["volumes"]:
        cells = [entry["name"], f"{entry['voxels']:,}"]
        for own, zfp in zip(entry["gatun"], entry["zfp"]):
            cells += [f"{zfp['psnr']:.1f}", number(own["bits"]), number(zfp["bits"]),
                      advantage([own["bits"]], [zfp["bits"]])]
        reversible = entry["reversible"]
        if entry["zfp"]:
            rows.append([*cells, number(entry["lossless"]["bits"]), number(entry["vtiBits"]),
                         number(reversible["bits"]) if reversible else "-"])
        ways = entry.get("views", {"ways": []})["ways"]
        for model in dict.fromkeys(way["model"] for way in ways):
            peer, *own = (way for way in ways if way["model"] == model)
            views.append([f"{entry['name']}, {model}", number(statistics.median(peer["seconds"])),
                          advantage([own[0]["first"]], [peer["first"]]),
                          *(advantage(way["seconds"], peer["seconds"]).split(" ")[0] for way in own)])
    text = "## Volumes\n\n" + paragraph("""Bits per voxel at the PSNR (dB) of two settings of zfp, and without loss, in blocks
        of 8. *head* is synthetic, *ct* and *mr* are scans.""") + "\n" + table(
            ["volume", "voxels", "PSNR", "`.ghv`", "zfp", "advantage", "PSNR", "`.ghv`", "zfp", "advantage",
             "lossless `.ghv`", "zlib `.vti`", "zfp"], rows)
    if views:
        text += "\n" + paragraph("""Views at 1 bit per voxel: seconds of a later view by
            `vtkFixedPointVolumeRayCastMapper` with voxels, and the advantage of drawing from coefficients: for
            the first view, in blocks of 8, and for later ones.""") + "\n" + table(
                ["view", "voxels, s", "first", "blocks of 8", "of 16", "of 32"], views)
    return text


def _surfaces(results):
    ways = [way for way in WAYS if way != "vtp-zlib" and any(way in entry["bytes"] for entry in results["surfaces"])]
    rows = []
    for entry in results["surfaces"]:
        rows.append([entry["name"], f"{entry['triangles']:,}",
                     *(number(8 * entry["bytes"][way] / entry["triangles"]) for way in ways),
                     advantage([entry["bytes"]["gtn"]], [best_peer(entry)[0]]),
                     *(number(entry["triangles"] / statistics.median(entry["seconds"][way]) / 1e6)
                       for way in ("gtn", "vtp-zlib"))])
    return "## Surfaces\n\n" + paragraph("""Bits per triangle without loss (advantage over the best peer), and million triangles
        per second from a file to `vtkPolyData`. Draco with `-cl 10 -qp 0`, OpenCTM with MG1 at level 9, zstd at
        level 19.""") + "\n" + table(
            ["surface", "triangles", *(WAYS[way] for way in ways), "advantage", "loading `.gtn`",
             "zlib `.vtp`"], rows)


def page(results):
    return "\n".join(part(results) for part in (
        _head, _files, _images, _contours, _simplification, _volumes, _surfaces))
