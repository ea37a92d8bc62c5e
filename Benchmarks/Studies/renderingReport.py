# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The part of the page that is about rendering, and the figures its pictures and goals use."""

import statistics

from benchmarkText import number, picture, table

MAPPERS = {
    "gatun": "Gatun",
    "bunyk": "Bunyk",
    "projected": "projected",
    "zsweep": "ZSweep",
}
FILES = {"gtn": ".gtn, Gatun", "vtu-zlib": ".vtu zlib, Bunyk", "vtu-raw": ".vtu raw, Bunyk"}


def by_mapper(case):
    return {one["mapper"]: one for one in case["mappers"]}


def later_ratio(case, other):
    """How many times longer another mapper takes than Gatun's, the median over the rounds."""
    mappers = by_mapper(case)
    return statistics.median(a / b for a, b in zip(mappers[other]["seconds"],
                                                   mappers["gatun"]["seconds"]))


def first_ratio(case, other):
    mappers = by_mapper(case)
    return statistics.median(a / b for a, b in zip(mappers[other]["firstFrames"],
                                                   mappers["gatun"]["firstFrames"]))


def describe(mesh, case):
    return (f"{mesh['name']}, {case['size']} x {case['size']}, {case['threads']} "
            f"thread{'s' if case['threads'] > 1 else ''}"
            + (", orthographic" if case["orthographic"] else ""))


def differing(rendering):
    """Descriptions of pictures that are not what Gatun's are: mappers differ at the outline of the
    mesh, by up to a pixel, and in what an opacity is, but not by so much."""
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


def find_pictures(mesh, form, budget=0):
    """The runs from a file of a form to a picture."""
    return next(one["runs"] for one in mesh["pictures"]
                if one["format"] == form and one["budget"] == budget)


def picture_ratio(mesh, form, budget):
    pairs = zip(find_pictures(mesh, form), find_pictures(mesh, "gtn", budget))
    return statistics.median(a["seconds"] / b["seconds"] for a, b in pairs)


def most_memory(runs):
    """MiB above the idle process."""
    return max(above_idle(run) for run in runs)


def _cells(case, name, key):
    """Milliseconds of a mapper, or a dash."""
    mapper = by_mapper(case).get(name)
    return number(1000 * statistics.median(mapper[key])) if mapper else "-"


def _ratios(case, name, ratio):
    return f"{ratio(case, name):.2f}" if name in by_mapper(case) else "-"


def _mappers(rendering, pictures):
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
                         + [_ratios(case, name, later_ratio) for name in others]
                         + [number(1e9 * own / case["tets"]), number(1e9 * own / case["hits"])])
            first.append([describe(mesh, case)] + [_cells(case, name, "firstFrames")
                                                   for name in MAPPERS]
                         + [_ratios(case, name, first_ratio) for name in others])
            seen.append([describe(mesh, case), f"{case['hits']:,}"]
                        + [f"{100 * mappers[name]['covered']:.1f} / {mappers[name]['mean']:.4f}"
                           if name in mappers else "-" for name in MAPPERS])
    names = list(MAPPERS.values())
    others = [f"{name} / Gatun" for name in names[1:]]
    meshes = [[mesh["name"], f"{mesh['tets']:,}", mesh["about"]] for mesh in rendering["meshes"]]
    return """## Rendering

Pictures of meshes in memory, in a window that nobody sees, by `vtkGatunVolumeMapper` and VTK's
mappers for unstructured grids: `vtkUnstructuredGridVolumeRayCastMapper` (*Bunyk*),
`vtkProjectedTetrahedraMapper` (*projected*) and `vtkUnstructuredGridVolumeZSweepMapper` (*ZSweep*,
where it does not take minutes). All show the whole mesh with the same colours and opacities (from 0
to 0.3 over a hundredth of the diagonal), one ray a pixel, in orders of points and cells that suit
VTK's mappers. They take turns, picture by picture, forwards and backwards; medians, ratios within
each round (more than 1: Gatun is faster).

Gatun takes samples as far apart as pixels are; Bunyk and ZSweep integrate from face to face, and
take opacities for densities, which lowers them a little. Projected tetrahedra are drawn by OpenGL,
here by Mesa in software on as many threads as are allowed to the others; ZSweep has one thread
only.

""" + table(["mesh", "tetrahedra", "what"], meshes) + """
*Later pictures*, the camera 7 degrees farther each time, milliseconds. In the last two columns
nanoseconds of Gatun's for each tetrahedron of the mesh, and for each pair of a tetrahedron and a
ray through it (counted independently, in the first view).

""" + table(["mesh, picture", *names, *others, "ns/tet", "ns/hit"], later) + "\n" + picture(
        pictures, "render", "How many times longer other mappers take") + """
*First pictures*: mapper and window anew, milliseconds from the grid in memory to the picture.

""" + table(["mesh, picture", *names, *others], first) + """
What was seen in the first picture, to show that all draw the same: pixels that are not black, in
percent, and the mean of all colours.

""" + table(["mesh, picture", "rays through tetrahedra", *names], seen) + (
    "\n**Means are more than 15 % from Gatun's:** " + "; ".join(differing(rendering)) + ".\n"
    if differing(rendering) else "\nNo mean is more than 15 % from Gatun's.\n")


def _pictures(rendering, pictures):
    rows = []
    for mesh in rendering["meshes"]:
        for one in mesh["pictures"]:
            runs = one["runs"]
            own = one["format"] == "gtn"
            seconds = statistics.median(run["seconds"] for run in runs)
            ratio = "1" if own and one["budget"] == 512 else "{:.2f}".format(
                statistics.median(run["seconds"] / gatun["seconds"] for run, gatun in
                                  zip(runs, find_pictures(mesh, "gtn", 512))))
            rows.append([f"{mesh['name']}, {runs[0]['size']} x "
                         f"{runs[0]['size']}", FILES[one["format"]],
                         one["budget"] if own else "-", number(1000 * seconds), ratio,
                         number(most_memory(runs))])
    flat = [[mesh["name"], f"{mesh['tets']:,}", "65,536",
             number(most_memory(find_pictures(mesh, "gtn")))] for mesh in rendering["meshes"]]
    flat += [["the same, larger", f"{rendering['hugeTets']:,}", f"{one['chunkTets']:,}",
              number(above_idle(one["run"]))] for one in rendering["huge"]]
    text = """## From file to picture

From the file to the first picture in a window that is open already, each in a process of its own, 2
threads: `.gtn` by `vtkGatunReader` and `vtkGatunVolumeMapper`, which draws straight from the file;
`.vtu` by `vtkXMLUnstructuredGridReader` and `vtkUnstructuredGridVolumeRayCastMapper`. *Budget* is
how much the mapper may keep for the next picture, in MiB. *Memory* is the most in use, over that of
the process with its window open and no data, in MiB.

""" + table(["mesh, picture", "file, mapper", "budget", "ms", "time, Gatun 512 = 1", "memory"],
            rows) + """
Memory against the size of the mesh, budget 0. It depends on the size of the chunks at work, one for
each thread, and on that of the picture, and not on the size of the mesh:

""" + table(["mesh", "tetrahedra", "in a chunk, at most", "memory, MiB"], flat) + "\n" + picture(
        pictures, "memory", "Memory above the idle process against tetrahedra")
    if not rendering["huge"]:
        text += "\nThe largest mesh was left out: this machine has not enough memory to make it.\n"
    return text


def sections(results, pictures):
    rendering = results.get("rendering")
    if not rendering:
        return []
    return [_mappers(rendering, pictures), _pictures(rendering, pictures)]


# --------------------------------------------------------------------------------------------------
# For the goals: each None where it was not measured.


def slowest_later_ratio(results):
    """Against Bunyk, on one thread, 512 and 1024 pixels: the worst one."""
    rendering = results.get("rendering") or {"meshes": []}
    return min((later_ratio(case, "bunyk") for mesh in rendering["meshes"]
                for case in mesh["render"] if case["threads"] == 1 and case["size"] in (512, 1024)
                and "bunyk" in by_mapper(case)), default=None)


def _find_mesh(results, name, size):
    rendering = results.get("rendering") or {"meshes": []}
    return next((mesh for mesh in rendering["meshes"] if mesh["name"] == name
                 and find_pictures(mesh, "gtn")[0]["size"] == size), None)


def delaunay_picture_ratio(results):
    mesh = _find_mesh(results, "delaunay", 512)
    return min(picture_ratio(mesh, form, 512) for form in ("vtu-zlib", "vtu-raw")) if mesh else None


def big_picture_memory(results, form="gtn"):
    mesh = _find_mesh(results, "big", 1024)
    return most_memory(find_pictures(mesh, form)) if mesh else None
