# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The rendering cases of runBenchmarks.py: mappers side by side, and from file to image.

A window needs a display. Without one, programs run under xvfb-run, if it is installed.
"""

import shutil

import displays
import scalingModel
import systemMemory

ARRAY = "Density"

# Sizes of images; rounds: later frames, those of slow mappers, first frames. hugeNeeds: the free
# memory in bytes that making the largest mesh takes. VTK's ZSweep mapper needs minutes for larger
# meshes or images.
MODES = {
    "full": {"sizes": (256, 512, 1024), "rounds": (6, 2, 2), "bigRounds": (4, 2, 2),
             "small": 512, "large": 1024, "zsweep": 256, "images": 3, "huge": 20000000,
             "hugeNeeds": 12 * 2**30, "zsweepMeshes": ("bluntfin", "comb")},
    "quick": {"sizes": (256, 512), "rounds": (3, 1, 1), "bigRounds": (2, 1, 1),
              "small": 256, "large": 512, "zsweep": 128, "images": 2, "huge": 1000000,
              "hugeNeeds": 2**30, "zsweepMeshes": ("bluntfin", "comb")},
    "smoke": {"sizes": (64,), "rounds": (1, 1, 1), "bigRounds": (1, 1, 1),
              "small": 64, "large": 64, "zsweep": 64, "images": 1, "huge": 8000,
              "hugeNeeds": 0, "zsweepMeshes": ("delaunay", "lattice")},
}

ABOUT = {
    "bluntfin": "NASA's blunt fin, in the order of its grid",
    "comb": "combustion chamber, in the order of its grid",
    "delaunay": "ball meshed by TetGen, sorted along a Morton curve",
    "big": "structured grid around a nose, in the order of the grid",
    "lattice": "body-centered lattice with jitter, sorted along a Morton curve",
}


def _write_flavours(runner, name, vtu, *options):
    """The mesh with one array, raw, with zlib and as .gtn."""
    files = {}
    for form, ending in ("vtu-raw", "raw.vtu"), ("vtu-zlib", "zlib.vtu"), ("gtn", "packed.gtn"):
        files[form] = runner.path("rendering", f"{name}-{ending}")
        runner.case("prepare", vtu, files[form], "--array", ARRAY, "--format", form, *options)
    return files


def _make_meshes(runner, sizes, delaunay, data):
    """Yields name and files of each mesh, and deletes the files afterwards."""
    sources = []
    if data:
        for name in "bluntfin", "comb":
            sources += [(name, file, ()) for file in
                        sorted(data.glob(f"{name}_tets*.vtu"))[:1]]
    kind = "delaunay" if delaunay else "lattice"
    sources.append((kind, None, ("--morton",)))
    sources.append(("big", None, ()))
    for name, source, options in sources:
        made = source
        if source is None:
            made = runner.path("rendering", f"{name}.vtu")
            tets = sizes["big"] if name == "big" else sizes["delaunay"]
            runner.case("make", "flow1" if name == "big" else name, tets, made)
        yield name, _write_flavours(runner, name, made, *options)
        shutil.rmtree(runner.folder("rendering"))


def _compare_mappers(runner, name, file, wanted):
    """Images of a mesh in memory by all mappers, which take turns."""
    rounds, slow, first = wanted["bigRounds"] if name == "big" else wanted["rounds"]
    every = ("--rounds", rounds, "--slow-rounds", slow, "--first-rounds", first, "--array", ARRAY)

    def render(size, threads, mappers, *options):
        return runner.case("render", file, "--size", size, "--mappers", mappers, *every, *options,
                           threads=threads, window=True)
    usual = "gatun,bunyk,projected"
    sizes = wanted["sizes"][-2:] if name == "big" else wanted["sizes"]
    cases = [render(size, threads, usual) for size in sizes for threads in (1, 2)]
    cases.append(render(wanted["small"], 1, usual, "--orthographic"))
    if name in wanted["zsweepMeshes"]:
        cases.append(render(wanted["zsweep"], 1, "gatun,bunyk,zsweep"))
    return cases


def _time_images(runner, name, files, wanted):
    """From a file to its first image; each run is a separate process, and the methods take turns."""
    size = wanted["large"] if name == "big" else wanted["small"]
    budgets = [("gtn", budget) for budget in (0, 32, 512)]
    ways = budgets + [("vtu-zlib", 0), ("vtu-raw", 0)]
    runs = [[] for _ in ways]
    for _ in range(wanted["images"]):
        for found, (form, budget) in zip(runs, ways):
            found.append(runner.case("picture", files[form], "--size", size, "--budget", budget,
                                     "--array", ARRAY, threads=2, window=True))
    return [{"format": form, "budget": budget, "runs": found}
            for found, (form, budget) in zip(runs, ways)]


def _measure_huge(runner, wanted, big):
    """Memory for an image of a mesh that few machines can hold."""
    if systemMemory.read("MemAvailable") < wanted["hugeNeeds"]:
        return []
    made = runner.path("rendering", "huge.vtu")
    runner.case("make", "flow1", wanted["huge"], made)
    found = []
    # The chunks of the big mesh, and the default for more than ten million tetrahedra.
    for chunk in scalingModel.chunk_limit(big), scalingModel.LARGE_CHUNK:
        packed = runner.path("rendering", f"huge-{chunk}.gtn")
        runner.run("gtn", "pack", "-q", "-f", "--chunk", chunk, made, packed)
        found.append({"chunkTets": chunk, "run": runner.case(
            "picture", packed, "--size", wanted["large"], "--budget", 0, "--array", ARRAY,
            threads=2, window=True)})
    shutil.rmtree(runner.folder("rendering"))
    return found


def measure(runner, mode, sizes, delaunay, data):
    """Measures everything, with the meshes of a data folder if there is one; None without a
    display."""
    if displays.prefix() is None:
        print("Without a display or xvfb-run, rendering is not measured.")
        return None
    wanted = MODES[mode]
    meshes = []
    for name, files in _make_meshes(runner, sizes, delaunay, data):
        cases = _compare_mappers(runner, name, files["vtu-raw"], wanted)
        meshes.append({"name": name, "about": ABOUT[name], "tets": cases[0]["tets"],
                       "render": cases,
                       "chunkTets": scalingModel.chunk_limit(cases[0]["tets"]),
                       "pictures": _time_images(runner, name, files, wanted)})
    return {"meshes": meshes, "hugeTets": wanted["huge"], "huge": _measure_huge(runner, wanted, meshes[-1]["tets"])}
