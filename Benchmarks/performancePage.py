# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Documentation/performance.md, and the table of README.md."""

import statistics
import textwrap

MIB = 2**20
PROFILES = {"gtn": "fast", "gtn-small": "small"}
FORMS = {"gtn": "fast", "gtn-small": "small", "vtu-raw": "raw `.vtu`", "vtu-lz4": "LZ4", "vtu-zlib": "zlib",
         "vtu-lzma-best": "LZMA", "zstd": "zstd", "zstd-shuffle": "zstd, shuffled"}


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
    return 8 * entry["pack"]["files"][form]["bytes"] / entry["pack"]["cells"]


def rates(load, form):
    """Million cells per second."""
    return [load["cells"] / seconds / 1e6 for seconds in load["seconds"][form]]


def both(what, unit, forms, peer, more_is_better=False):
    """The cells of a row of both profiles. forms: their rounds."""
    return [f"{what} ({unit})", *(number(statistics.median(own)) for own in (*forms, peer)),
            *(advantage(own, peer, more_is_better) for own in forms)]


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


def loading(results, name, form):
    """Of the fast profile and one peer, on one thread."""
    load = find(results["files"], name)["loads"][0]
    return rates(load, "gtn"), rates(load, form)


def pack_rates(entry, form):
    files, cells = entry["packing"]["files"], entry["packing"]["cells"]
    return [cells / seconds / 1e6 for seconds in files[form]["seconds"]]


def images(results):
    return results["images"] or {"first": [], "later": []}


def first_images(results):
    """Rows of time and memory from a file to the first image."""
    for entry in images(results)["first"]:
        what = f"first, {entry['name']}, {entry['size']}"
        yield what, "s", medians(entry["gtn"], "seconds"), medians(entry["vtu-zlib"], "seconds")
        if "gtn-small" in entry:
            yield f"{what}, small", "s", medians(entry["gtn-small"], "seconds"), medians(
                entry["vtu-zlib"], "seconds")
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
        for form, text in (("gtn", "file"), ("gtn-small", "small file"), ("layers", "file with layers")):
            if form in entry["files"]:
                yield f"{entry['name']}, {text}", "s", medians(entry["files"][form], "seconds"), peer
    for entry in results["contours"][:2]:
        yield f"{entry['name']}, in memory", "s", entry["memory"]["gatun"], entry["memory"]["vtk"]


def best_peer(surface):
    return min((size, way) for way, size in surface["bytes"].items() if way not in PROFILES)


def readme_rows(results):
    """Rows with the peer."""
    delaunay = find(results["files"], "delaunay")
    lzma, zlib = "`.vtu`, best LZMA", "`.vtu`, zlib"
    for form, profile in PROFILES.items():
        yield f"File size, Delaunay mesh, *{profile}*", "bits per tetrahedron", [bits(delaunay, form)], [
            bits(delaunay, "vtu-lzma-best")], lzma, False
    for form, profile in PROFILES.items():
        yield (f"Loading it on one thread, *{profile}*", "million tetrahedra per second",
               rates(delaunay["loads"][0], form), rates(delaunay["loads"][0], "vtu-zlib"), zlib, True)
    yield ("The same, *fast*", "million tetrahedra per second",
           *loading(results, "delaunay", "zstd-shuffle"), "zstd, shuffled arrays", True)
    for form, profile in PROFILES.items():
        yield (f"Packing it on one thread, *{profile}*", "million tetrahedra per second",
               pack_rates(delaunay, form), pack_rates(delaunay, "vtu-zlib"), zlib, True)
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
    for form, profile in PROFILES.items():
        yield (f"Size of a scanned surface, *{profile}*", "bits per triangle",
               [8 * scan["bytes"][form] / scan["triangles"]], [8 * size / scan["triangles"]], WAYS[way], False)
    if "draco" in scan["seconds"]:
        yield ("Loading it on one thread, *fast*", "million triangles per second",
               triangle_rates(scan, "gtn"), triangle_rates(scan, "draco"), "Draco", True)


def readme_table(results):
    rows = []
    for what, unit, own, peer, name, more_is_better in readme_rows(results):
        cells = row(what, unit, own, peer, more_is_better)
        rows.append([*cells[:2], f"{cells[2]}: {name}", cells[3]])
    return table(["measurement", "Gatun", "peer", "advantage (range)"], rows)


def triangle_rates(surface, way):
    return [surface["triangles"] / seconds / 1e6 for seconds in surface["seconds"][way]]


WAYS = {"gtn": "fast", "gtn-small": "small", "draco": "Draco", "openctm": "OpenCTM",
        "meshopt": "meshoptimizer and zstd", "vtp-zlib": "zlib `.vtp`", "vtp-lzma": "LZMA `.vtp`"}
HEAD = ["measurement", "Gatun", "VTK", "advantage (range)"]


def _head(results):
    delaunay = find(results["files"], "delaunay")
    return f"""# Performance

`Utilities/setup.sh bench` measures Gatun and its peers and writes this page and [the dissertation,
repeated](dissertation.md) from [results.json](performance/results.json).

{machine(results)}
{paragraph(f'''Peers take turns with Gatun. Cells are medians of the rounds; *advantage* is the median of their ratios, with its
range: above 1 where Gatun is better, else bold. *fast* and *small* are the profiles of `.gtn` files; where none
is named, it is *fast*, the default. `.vtu` files have default settings (zlib, 64-bit ids); *LZMA* is level 9 with
32-bit ids and blocks of 32 MiB. *zstd* is level 3 over the raw arrays in blocks of 1 MiB, much like
a `.pv` file, also with the bytes of each block shuffled. Files are in the page cache. All processors are used,
unless stated.''')}
{paragraph(f'''*delaunay* is a {delaunay["about"]} ({delaunay["pack"]["cells"]:,} tetrahedra, one float array), *grid* a
synthetic structured grid around a nose (five tetrahedra per hexahedron, one array), *flow* a smaller one with
four arrays, *hexahedra* and *mixed* (also wedges, pyramids and polyhedra) are made alike. Other meshes are real
and not part of the project.''')}"""


def _sizes(results):
    rows = []
    for entry in results["files"]:
        rows.append([entry["name"], f"{entry['pack']['cells']:,}", *(number(bits(entry, form)) for form in FORMS),
                     *(advantage([bits(entry, form)], [bits(entry, peer)])
                       for form, peer in (("gtn", "vtu-zlib"), ("gtn-small", "vtu-lzma-best")))])
    return "## Files\n\n" + paragraph("""Bits per cell of whole files, with the advantage of *fast* over zlib, and of *small*
        over LZMA. Points and cells of tetrahedral meshes are in random order, but for the grid.""") + "\n" + table(
            ["mesh", "cells", *FORMS.values(), "fast, zlib", "small, LZMA"], rows)


def best_zstd(load):
    return min(("zstd", "zstd-shuffle"), key=lambda form: statistics.median(load["seconds"][form]))


def _loading(results):
    rows, forms = [], [form for form in FORMS if form != "vtu-lzma-best"]
    for entry in results["files"]:
        for load in entry["loads"]:
            threads = f", {load['threads']} threads" if load["threads"] > 1 else ""
            rows.append([entry["name"] + threads, *(number(statistics.median(rates(load, form))) for form in forms),
                         *(advantage(rates(load, form), rates(load, peer), True) for form, peer in (
                             ("gtn", "vtu-zlib"), ("gtn", best_zstd(load)), ("gtn-small", "vtu-zlib")))])
    return paragraph("""Million cells per second from a file to `vtkUnstructuredGrid`, on one thread unless stated, with the
        advantage of *fast* over zlib, of *fast* over the faster one of both zstd, and of *small* over zlib:""") + (
            "\n" + table(["mesh", *(FORMS[form] for form in forms), "fast, zlib", "fast, zstd", "small, zlib"], rows))


def _packing(results):
    rows, forms = [], (*PROFILES, "vtu-zlib")
    for entry in results["files"]:
        if "packing" in entry:
            *own, peer = (pack_rates(entry, form) for form in forms)
            rows.append(both(f"packing {entry['name']}", "million/s", own, peer, True))
    for entry in results["files"]:
        if "memory" in entry:
            *own, peer = ([(run["first"]["peak"] - run["first"]["before"]) / run["gridBytes"]]
                          for run in (entry["memory"][form] for form in forms))
            rows.append(both(f"peak memory of loading {entry['name']}", "times the grid", own, peer))
    for entry in results["steps"]:
        *own, peer = (rates(entry, form) for form in forms)
        rows.append(both(f"{entry['steps']} time steps, {entry['name']}", "million/s", own, peer, True))
        rows.append(both("their size", "bits per cell of each step", *split(
            [8 * entry["bytes"][form] / entry["cells"]] for form in forms)))
    return paragraph("""Packing, and going forward through time steps, are on one thread. Those of *delaunay* have one smooth array,
        those of *flow* four with noise; the peer is a `.vtu` file each. Memory is above that of the new process, the
        grid included:""") + "\n" + table(
            ["measurement", "fast", "small", "zlib `.vtu`", "advantage of fast (range)", "of small"], rows)


def split(values):
    *own, peer = values
    return own, peer


def _branches(results):
    """Whether the loop that decodes has branches that cannot be predicted."""
    counts = [(entry["name"], entry["loads"][0]["branchMisses"]) for entry in results["files"]]
    if any(count["gtn"] is None for _, count in counts):
        found = [f"{number(entry['simulatedMisses'])} ({entry['name']})" for entry in results["files"]
                 if "simulatedMisses" in entry]
        return paragraph("This machine does not tell how many branches are mispredicted." + (f"""
            Cachegrind's simple predictor misses so many per cell while loading *fast* files: {', '.join(found)}."""
            if found else ""))
    return paragraph("Mispredicted branches per cell while loading:") + "\n" + table(
        ["mesh", "fast", "small", "zlib `.vtu`"],
        [[name, *(number(count[form]) for form in (*PROFILES, "vtu-zlib"))] for name, count in counts])


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
        by `vtkGatunContour` from a `.gtn` file (*fast*, or *small*) without and with layers, and by `vtkContour3DLinearGrid` from
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
    found = results["surfaces"]
    ways = [way for way in WAYS if any(way in entry["bytes"] for entry in found)]
    timed = [way for way in WAYS if any(way in entry["seconds"] for entry in found)]
    rows, times = [], []
    for entry in found:
        rows.append([entry["name"], f"{entry['triangles']:,}",
                     *(number(8 * entry["bytes"][way] / entry["triangles"]) for way in ways),
                     *(advantage([entry["bytes"][form]], [best_peer(entry)[0]]) for form in PROFILES)])
        times.append([entry["name"], *(number(statistics.median(triangle_rates(entry, way))) for way in timed),
                      *(advantage(triangle_rates(entry, "gtn"), triangle_rates(entry, way), True)
                        for way in timed if way not in PROFILES)])
    return "## Surfaces\n\n" + paragraph("""Bits per triangle without loss, with the advantages of both profiles over the best peer.
        Draco with `-qp 0`, OpenCTM with MG1 at level 9, zstd at level 19.""") + "\n" + table(
            ["surface", "triangles", *(WAYS[way] for way in ways), "fast", "small"], rows) + "\n" + paragraph(
                """Million triangles per second on one thread, with the advantage of *fast*: from a file to `vtkPolyData`, but
                Draco and meshoptimizer from memory to memory, with 32-bit ids.""") + "\n" + table(
                    ["surface", *(WAYS[way] for way in timed),
                     *(f"over {WAYS[way]}" for way in timed if way not in PROFILES)], times)


def page(results):
    return "\n".join(part(results) for part in (
        _head, _sizes, _loading, _packing, _branches, _images, _contours, _simplification, _volumes, _surfaces))
