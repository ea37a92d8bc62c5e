# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The rendering part of the page, and the numbers that plots and goals use."""

import statistics

from benchmarkText import image, number, ratio, rounds_of, spread, table

MAPPERS = {
    "gatun": "Gatun",
    "bunyk": "Bunyk",
    "projected": "projected",
    "zsweep": "ZSweep",
}
FILES = {"gtn": ".gtn, Gatun", "vtu-zlib": ".vtu zlib, Bunyk", "vtu-raw": ".vtu raw, Bunyk"}


def by_mapper(case):
    return {one["mapper"]: one for one in case["mappers"]}


def frame_ratios(case, other, key):
    """The time of another mapper divided by Gatun's, in each round."""
    mappers = by_mapper(case)
    return rounds_of(zip(mappers[other][key], mappers["gatun"][key]))


def later_ratio(case, other):
    return statistics.median(frame_ratios(case, other, "seconds"))


def describe(mesh, case):
    return (f"{mesh['name']}, {case['size']} x {case['size']}, {case['threads']} "
            f"thread{'s' if case['threads'] > 1 else ''}"
            + (", orthographic" if case["orthographic"] else ""))


def differing(rendering):
    """Descriptions of images that differ from Gatun's: mappers differ at the outline of the mesh, by
    up to a pixel, and in the meaning of an opacity, but not by as much as this."""
    found = []
    for mesh in rendering["meshes"]:
        for case in mesh["render"]:
            mappers = by_mapper(case)
            own = mappers["gatun"]["mean"]
            found += [f"{describe(mesh, case)}, {MAPPERS[name]}" for name, one in mappers.items()
                      if abs(one["mean"] - own) > 0.15 * own]
    return found


def above_idle(run):
    return (run["peak"] - run["before"]) / 2**20


def find_images(mesh, form, budget=0):
    """The runs from a file of a format to an image."""
    return next(one["runs"] for one in mesh["pictures"]
                if one["format"] == form and one["budget"] == budget)


def image_ratios(runs, gatun):
    """The time of a way divided by that of Gatun's way, in each round."""
    return rounds_of((a["seconds"], b["seconds"]) for a, b in zip(runs, gatun))


def most_memory(runs):
    """MiB above the idle process."""
    return max(above_idle(run) for run in runs)


def _cells(case, name, key):
    """Milliseconds of a mapper, or a dash."""
    mapper = by_mapper(case).get(name)
    return number(1000 * statistics.median(mapper[key])) if mapper else "-"


def _ratios(case, name, key):
    return spread(frame_ratios(case, name, key), ratio) if name in by_mapper(case) else "-"


def _mappers(rendering, plots):
    later = []
    first = []
    seen = []
    for mesh in rendering["meshes"]:
        for case in mesh["render"]:
            mappers = by_mapper(case)
            own = statistics.median(mappers["gatun"]["seconds"])
            others = [name for name in MAPPERS if name != "gatun"]
            later.append([describe(mesh, case)] + [_cells(case, name, "seconds")
                                                   for name in MAPPERS]
                         + [_ratios(case, name, "seconds") for name in others]
                         + [number(1e9 * own / case["tets"]), number(1e9 * own / case["hits"])])
            first.append([describe(mesh, case)] + [_cells(case, name, "firstFrames")
                                                   for name in MAPPERS]
                         + [_ratios(case, name, "firstFrames") for name in others])
            seen.append([describe(mesh, case), f"{case['hits']:,}"]
                        + [f"{100 * mappers[name]['covered']:.1f} / {mappers[name]['mean']:.4f}"
                           if name in mappers else "-" for name in MAPPERS])
    names = list(MAPPERS.values())
    others = [f"{name} / Gatun" for name in names[1:]]
    meshes = [[mesh["name"], f"{mesh['tets']:,}", mesh["about"]] for mesh in rendering["meshes"]]
    return """## Rendering

Rendering meshes in memory into an offscreen window with `vtkGatunVolumeMapper` and with VTK's
mappers for unstructured grids: `vtkUnstructuredGridVolumeRayCastMapper` (*Bunyk*),
`vtkProjectedTetrahedraMapper` (*projected*) and `vtkUnstructuredGridVolumeZSweepMapper` (*ZSweep*,
where it does not take minutes). All mappers draw the whole mesh with the same colors and opacities
(from 0 to 0.3 per hundredth of the diagonal) and with one ray per pixel. Points and cells are in an
order that suits VTK's mappers. The mappers take turns, frame by frame, in alternating directions.
Times are medians in milliseconds. Ratios are the time of another mapper divided by Gatun's: above
1, Gatun is faster.

Gatun takes samples at distances of a pixel. Bunyk and ZSweep integrate from face to face and
interpret opacities as densities, which lowers them a little. OpenGL draws projected tetrahedra; on
this machine that is Mesa's software rasterizer, with as many threads as the other mappers have.
ZSweep has only one thread.

""" + table(["mesh", "tetrahedra", "description"], meshes) + """
*Later frames*: the camera turns by 7 degrees from frame to frame. The last two columns are
nanoseconds of Gatun's mapper per tetrahedron of the mesh, and per pair of a tetrahedron and a ray
through it (counted independently, in the first view).

""" + table(["mesh, image", *names, *others, "ns/tet", "ns/hit"], later) + "\n" + image(
        plots, "render", "Times of other mappers relative to Gatun's") + """
*First frames*: a new mapper in a new window, from the grid in memory to the image.

""" + table(["mesh, image", *names, *others], first) + """
A check that all mappers draw the same: the percentage of pixels that are not black and the mean of
all colors, in the first frame.

""" + table(["mesh, image", "tetrahedron-ray pairs", *names], seen) + (
    "\n**These means differ from Gatun's by more than 15 %:** "
    + "; ".join(differing(rendering)) + ".\n"
    if differing(rendering) else "\nNo mean differs from Gatun's by more than 15 %.\n")


def _images(rendering, plots):
    rows = []
    for mesh in rendering["meshes"]:
        for one in mesh["pictures"]:
            runs = one["runs"]
            own = one["format"] == "gtn"
            seconds = statistics.median(run["seconds"] for run in runs)
            relative = "1" if own and one["budget"] == 512 else spread(
                image_ratios(runs, find_images(mesh, "gtn", 512)), ratio)
            rows.append([f"{mesh['name']}, {runs[0]['size']} x "
                         f"{runs[0]['size']}", FILES[one["format"]],
                         one["budget"] if own else "-", number(1000 * seconds), relative,
                         number(most_memory(runs))])
    flat = [[mesh["name"], f"{mesh['tets']:,}", f"{mesh['chunkTets']:,}",
             number(most_memory(find_images(mesh, "gtn")))] for mesh in rendering["meshes"]]
    flat += [["big, larger", f"{rendering['hugeTets']:,}", f"{one['chunkTets']:,}",
              number(above_idle(one["run"]))] for one in rendering["huge"]]
    text = """## From file to image

From a file to the first image in a window that is already open. Each run is a separate process with
2 threads. `.gtn` files are drawn by `vtkGatunReader` and `vtkGatunVolumeMapper`, which draws
straight from the file; `.vtu` files by `vtkXMLUnstructuredGridReader` and
`vtkUnstructuredGridVolumeRayCastMapper`. *MemoryBudget* is the amount of decoded data that the
mapper may keep for the next frame, in MiB; the default is 512. *Memory* is the peak in MiB above
that of the process with an empty window.

""" + table(["mesh, image", "file, mapper", "MemoryBudget", "ms",
             "time relative to .gtn with the default", "memory"], rows) + """
Memory by the size of the mesh, with MemoryBudget 0. It depends on the size of the chunks at work,
one per thread, and on the size of the image, but not on the size of the mesh:

""" + table(["mesh", "tetrahedra", "tetrahedra per chunk, at most", "memory, MiB"], flat) + "\n" + (
        image(plots, "memory", "Memory above the idle process by tetrahedra"))
    if not rendering["huge"]:
        text += "\nThe largest mesh was left out: this machine has too little memory to make it.\n"
    return text


def sections(results, plots):
    rendering = results.get("rendering")
    if not rendering:
        return []
    return [_mappers(rendering, plots), _images(rendering, plots)]


# --------------------------------------------------------------------------------------------------
# Numbers for the goals; None where they were not measured.


def slowest_later_ratio(results):
    """Relative to Bunyk's mapper, on one thread, 512 and 1024 pixels: the worst case."""
    rendering = results.get("rendering") or {"meshes": []}
    return min((later_ratio(case, "bunyk") for mesh in rendering["meshes"]
                for case in mesh["render"] if case["threads"] == 1 and case["size"] in (512, 1024)
                and "bunyk" in by_mapper(case)), default=None)


def _find_mesh(results, name, size):
    rendering = results.get("rendering") or {"meshes": []}
    return next((mesh for mesh in rendering["meshes"] if mesh["name"] == name
                 and find_images(mesh, "gtn")[0]["size"] == size), None)


def delaunay_image_ratio(results):
    mesh = _find_mesh(results, "delaunay", 512)
    return min(statistics.median(image_ratios(find_images(mesh, form),
                                              find_images(mesh, "gtn", 512)))
               for form in ("vtu-zlib", "vtu-raw")) if mesh else None


def big_image_memory(results, form="gtn"):
    mesh = _find_mesh(results, "big", 1024)
    return most_memory(find_images(mesh, form)) if mesh else None
