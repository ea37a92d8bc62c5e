# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The parts of the simplification study on the time to an image: Figures 17 and 18."""

import statistics

from benchmarkText import image, number, paragraph, ratio, rounds_of, spread, table

FOLDER = "simplification-study"
KINDS = {"volumeSeconds": "volume-based", "areaSeconds": "area-based"}


def memory(run):
    """MiB above the process before the work."""
    return (run["peak"] - run["before"]) / 2**20


def gain(mesh, kind):
    """How many times as fast the simplest mesh is drawn as the whole one."""
    drawn = mesh["drawn"]["meshes"]
    return statistics.median(drawn[0][kind]) / statistics.median(drawn[-1][kind])


def simplify_share(run, way="integrated"):
    """The share of simplification in the time from file to image."""
    return run[way]["simplify"] / run[way]["seconds"]


def _size(results):
    return f"{results['size']} x {results['size']}"


def drawing(results, plots):
    rows = []
    for mesh in results["meshes"]:
        for part, drawn in zip(mesh["drawn"]["parts"], mesh["drawn"]["meshes"]):
            rows.append([mesh["name"], part, f"{drawn['tets']:,}",
                         *(spread(1000 * s for s in drawn[kind]) for kind in KINDS),
                         spread(rounds_of(zip(drawn["areaSeconds"], drawn["volumeSeconds"])), ratio)])
    least = results["meshes"][0]["drawn"]["parts"][-1]
    gains = {kind: [gain(mesh, kind) for mesh in results["meshes"]] for kind in KINDS}
    return "## Volume-based or area-based samples (Figure 18)\n\n" + paragraph(f"""The proposal
        draws with samples at even distances ("volume-based") and with one sample per tetrahedron and
        ray ("area-based"), and is surprised that the first gains from simplification, too. Here,
        at {least} % of the tetrahedra, volume-based images are drawn
        {min(gains["volumeSeconds"]):.1f} to {max(gains["volumeSeconds"]):.1f} times as fast as those of
        the whole mesh, area-based images {min(gains["areaSeconds"]):.1f} to
        {max(gains["areaSeconds"]):.1f} times. Above 1 in the last column, area-based sampling takes
        longer. `vtkGatunRayCaster`, all processors, {_size(results)}; milliseconds in total.""") + (
            "\n" + table(["mesh", "% of tets", "tetrahedra", "volume, ms", "area, ms",
                          "area / volume"], rows) + "\n" +
            image(plots, "figure18", "Time to draw by remaining tetrahedra", FOLDER))


def _seconds(run):
    return spread(run.get("rounds", [run["seconds"]]))


def _percent(run, way):
    return f"{100 * simplify_share(run, way):.1f}" if run["ratio"] > 0 else "-"


def _bytes(mesh):
    return (f"{mesh['name']} ({mesh['integrated']['bytes']['tree'] / 2**20:.1f} and "
            f"{mesh['integrated']['bytes']['levels'] / 2**20:.1f} MiB)")


def _shares(results):
    """A sentence about the shares of the integrated way."""
    shares = [(simplify_share(run, way), mesh["name"], run["ratio"]) for mesh in results["meshes"]
              for run in mesh["integrated"]["runs"] if run["ratio"] > 0
              for way in ("integrated", "levels")]
    within = sum(share <= 0.05 for share, _, _ in shares)
    worst, name, removed = max(shares)
    return f"""On the way from the file, simplification takes at most 5 % of the time in {within} of
        {len(shares)} cases, and {100 * worst:.1f} % at worst ({name} at {removed:g}). The proposal
        reports less than 5 %."""


def integrated(results, plots):
    rows = []
    for mesh in results["meshes"]:
        for run in mesh["integrated"]["runs"]:
            ways = [run[way] for way in ("staged", "integrated", "levels")]
            rows.append([mesh["name"], f"{run['ratio']:g}", f"{run['integrated']['tets']:,.0f}",
                         *map(_seconds, ways),
                         *(_percent(run, way) for way in ("staged", "integrated", "levels")),
                         *(number(memory(way)) for way in ways)])
    return "## Integrated simplification (Figure 17)\n\n" + paragraph(f"""From a `.gtn` file with a
        hierarchy to the image of a simplified mesh, {_size(results)} pixels, all processors, in a separate
        process: seconds, and peak MiB above those of the new process. The ratio is the fraction of
        points removed. *Staged*: the mesh is decompressed into a grid (`vtkGatunReader`), simplified
        with the merges of the file, and drawn. *Integrated*: chunks are simplified as they are
        decoded, and freed once they are drawn (`vtkGatunRayCaster` with MemoryBudget 0). *With base
        meshes*: the same with a file that has levels of detail. *Simplifying*: its percentage of the
        time, with reading the merges and distributing them to the chunks. Sizes of the files without
        and with base meshes: {", ".join(map(_bytes, results["meshes"]))}.""") + "\n" + table(
            ["mesh", "ratio", "tetrahedra", "staged, s", "integrated, s", "with base meshes, s",
             "simplifying, %, staged", "integrated", "with base meshes", "MiB, staged", "integrated",
             "with base meshes"], rows) + "\n" + paragraph(_shares(results)) + (
            "\n" + image(plots, "figure17", "Seconds from file to image", FOLDER))
