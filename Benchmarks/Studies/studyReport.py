# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runStudy.py."""

import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, ratio, rounds_of, span, spread, table

WAYS = {"gatun": "while decompressing", "small": "while decompressing, small chunks",
        "generic": "decompress first", "vtu": ".vtu, load first"}

# Table 4 of the proposal: seconds, generic and Gatun with 160 MB, then with 80 MB; * where it paged.
PAPER = [
    ("Blunt-fin", "1024", "125.88", "97.36", "245.54*", "97.96"),
    ("Combustion Chamber", "1024", "141.28", "123.12", "601.17*", "176.15*"),
    ("Liquid Oxygen Post", "128", "18.51", "19.17", "705.67*", "19.26"),
    ("Liquid Oxygen Post", "256", "24.80", "23.40", "791.35*", "23.45"),
    ("Liquid Oxygen Post", "512", "54.06", "40.69", "964.70*", "40.73"),
    ("Liquid Oxygen Post", "1024", "284.95*", "122.16", "N/A", "3129.55*"),
    ("Delta Wing", "128", "2414.41*", "47.77", "N/A", "50.26"),
]


def failure(runs):
    """The reason why there is no image; None if there is one."""
    return next((run["why"] for run in runs if "why" in run), None)


def rounds(runs):
    return [run["seconds"] for run in runs]


def seconds(runs):
    return statistics.median(rounds(runs))


def memory(runs):
    """MiB above the idle process."""
    return max(run["peak"] - run["before"] for run in runs) / 2**20


def find_case(mesh, limit, size):
    return next(case for case in mesh["limits"] if case["limit"] == limit and case["size"] == size)


def sizes(mesh):
    return sorted({case["size"] for case in mesh["limits"]})


def limits(mesh):
    """From none (0) to the smallest."""
    return sorted({case["limit"] for case in mesh["limits"]}, key=lambda limit: limit or 1e9,
                  reverse=True)


def limit_text(limit):
    return f"{limit:,} MiB" if limit else "none"


def usual_size(mesh):
    """512 pixels, or the second largest there is."""
    return sizes(mesh)[-2]


def _head(results):
    text = """# The rendering study

C. Yang, *On-the-fly Processing of Compressed Volume Data*, dissertation proposal, Stony Brook,
2001, compares rendering a mesh while it is decompressed with a "generic" method that decompresses
it first (Figures 13 and 14, Table 4). It leaves open whether tetrahedra should be released from one
end of the rays or from both, and proposes a pre-filter (section 4.4). This page repeats the
evaluation with today's Gatun. `Utilities/bench.sh --study` (Benchmarks/Studies/runStudy.py) writes
it. All results are in [results.json](rendering-study/results.json).

""" + benchmarkText.machine(results)
    rows = [[mesh["name"], f"{mesh['tets']:,}", f"{mesh['fileBytes']['gtn']:,}",
             f"{mesh['fileBytes']['vtu-zlib']:,}", mesh["about"]] for mesh in results["meshes"]]
    text += """
## Methods

All methods use the same ray caster (`vtkGatunRayCaster`, without a window) on all processors. It
keeps nothing for the next image. Each image is drawn by a separate process.

- *While decompressing*: straight from the `.gtn` file, chunk by chunk from front to back, one chunk
  per thread at a time. Chunks have at most 65,536 tetrahedra, the default below one million; *small
  chunks* have at most 8,192.
- *Decompress first*, the generic method of the proposal: `vtkGatunReader` makes the whole grid
  without a cache, and then the grid is drawn.
- *.vtu, load first*: the same with VTK's file (zlib) and reader.

Each mesh has one float array. Points and cells were in random order before the files were written,
except for the mesh of more than 5 million tetrahedra. Colors and camera are those of the
[benchmarks](benchmarks.md).

""" + table(["mesh", "tetrahedra", ".gtn, bytes", ".vtu, bytes", "description"], rows)
    if not any(mesh["name"] == "bluntfin" for mesh in results["meshes"]):
        text += "\nThe meshes of the proposal are missing (`GATUN_DATA_DIR` was not set).\n"
    text += "\n" + (f"**The images of {', '.join(differing(results))} differ.**\n"
                    if differing(results) else
                    "All methods, with and without the pre-filter, drew the same images.\n")
    return text


def _peak(results, plots):
    rows = []
    ratios = []
    for mesh in results["meshes"]:
        ways = find_case(mesh, 0, usual_size(mesh))["ways"]
        found = {way: memory(ways[way]) for way in WAYS}
        ratios.append(found["generic"] / found["gatun"])
        rows.append([mesh["name"], f"{mesh['tets']:,}", *map(number, found.values()),
                     f"{ratios[-1]:.1f}", f"{found['generic'] / found['small']:.1f}"])
    size = usual_size(results["meshes"][0])
    return "## Peak memory (Figure 13)\n\n" + paragraph(f"""Peak memory from the file to an image of {size}
        x {size} pixels, in MiB above that of the new process. In the proposal, Gatun needs "usually
        less than half" of the memory of the generic method. Here the generic method needs
        {min(ratios):.1f} to {max(ratios):.1f} times as much as Gatun with its default chunks. Gatun's
        memory depends on the size of the chunks and of the image; that of the other methods
        depends on the size of the mesh.""") + "\n" + table(
            ["mesh", "tetrahedra", *WAYS.values(), "generic / Gatun", "generic / small chunks"],
            rows) + ("\n" + image(plots, "memory", "Peak memory by mesh", "rendering-study"))


def _entry(runs):
    return failure(runs) or f"{seconds(runs):.3f}"


def _relative(case):
    """The time of the generic method divided by that of Gatun, where both have an image."""
    ways = case["ways"]
    if failure(ways["generic"]) or failure(ways["gatun"]):
        return "-"
    return spread(rounds_of(zip(rounds(ways["generic"]), rounds(ways["gatun"]))), ratio)


def _least_limit(mesh, way, size):
    """The smallest limit under which there is an image; 0 if there is none."""
    works = [limit for limit in limits(mesh) if limit
             and not failure(find_case(mesh, limit, size)["ways"][way])]
    return min(works, default=0)


def _times(results, plots):
    if results["limiter"].startswith("cgroup"):
        how = ("a control group, which counts the heap and those pages of files and libraries that "
               "no other process has loaded before")
    else:
        how = ("`ulimit -v`, because no control group could be made: it counts all mapped memory, "
               "above all libraries and the stacks of threads")
    swap = (f"{results['swap'] / 2**30:.1f} GiB of swap" if results["swap"]
            else "no swap: *fails* marks the cases in which the proposal's program pages")
    text = "## End-to-end time under memory limits (Figure 14, Table 4)\n\n" + paragraph(
        f"""Seconds (medians) from the file to the image, including reading and decompressing,
        without the start of the program. The rows *ratio* are the time of decompressing first
        divided by that of drawing while decompressing. Memory was limited by {how}. The machine has
        {swap}. Files are in the page cache.""") + "\n"
    for mesh in results["meshes"]:
        all_sizes = sizes(mesh)
        rows = []
        for limit in limits(mesh):
            for way, name in WAYS.items():
                rows.append([limit_text(limit), name] + [
                    _entry(find_case(mesh, limit, size)["ways"][way]) for size in all_sizes])
            relative = [_relative(find_case(mesh, limit, size)) for size in all_sizes]
            if set(relative) != {"-"}:
                rows.append([limit_text(limit), "ratio", *relative])
        least = {way: _least_limit(mesh, way, usual_size(mesh)) for way in WAYS}
        text += f"### {mesh['name']}, {mesh['tets']:,} tetrahedra\n\n"
        text += table(["limit", "method"] + [f"{size} x {size}" for size in all_sizes], rows) + "\n"
        usual = usual_size(mesh)
        text += paragraph(f"The smallest of these limits with an image of {usual} x {usual} pixels: "
                          + "; ".join(f"{WAYS[way]}, {limit_text(limit)}"
                                      for way, limit in least.items()) + ".") + "\n"
    text += image(plots, "time", "Time by size and memory limit", "rendering-study")
    text += """
For comparison, Table 4 of the proposal: seconds on a Pentium II with 300 MHz and the given amount of
memory. An asterisk marks cases in which it paged.

""" + table(["mesh", "size", "generic, 160 MB", "Gatun, 160 MB", "generic, 80 MB", "Gatun, 80 MB"],
            PAPER)
    return text


def release_cases(release):
    """Pairs of cases that differ only in the ends of release: front, both."""
    found = {}
    for case in release["cases"]:
        found.setdefault((case["light"], case["opaque"] > 0), {})[case["bothEnds"]] = case
    return [(light, ends, pair[False], pair[True]) for (light, ends), pair in found.items()]


def differing(results):
    """Names of meshes whose images of one size differ by more than rounding. Their times must not
    be compared."""
    found = []
    for mesh in results["meshes"]:
        means = {}
        for case in mesh["limits"]:
            means.setdefault(case["size"], []).extend(
                run["mean"] for runs in case["ways"].values() for run in runs if "mean" in run)
        for case in mesh.get("prefilter", {}).get("cases", []):
            means.setdefault(case["size"], []).append(case["mean"])
        if any(max(each) - min(each) > 1e-4 for each in means.values()):
            found.append(mesh["name"])
    return found


def _percent(part, whole):
    return f"{100 * part / whole:.1f}" if whole else "-"


def _release(results, plots):
    text = """## Release from one end or from both (section 4.4)

A tetrahedron is ready to be drawn when all of its faces toward the eye are processed. If rays may also
grow from their far ends, it is ready as well when all of its faces away from the eye are
processed. The proposal does both, so that fewer tetrahedra wait. However, samples from the far end may
turn out to be hidden, and rays consist of more fragments. The proposal expects that release from the
front alone needs more memory, and less time if rays end early.

*Waiting* is the largest number of tetrahedra that had arrived and had to wait, in one chunk, and
its share of the largest chunk. *Fragments* is the largest number in all pixels together. *Memory* is
that of the image and the chunk at work. A chunk is in memory as a whole while it is drawn, so fewer
waiting tetrahedra do not make it smaller. Chunks are drawn from front to back, one at a time, so the
chunk limits the number that waits. Each mesh was therefore also stored in one chunk (of at most
1,048,576 tetrahedra), where the question of the proposal applies in full. *Ends* states whether
everything behind an opaque fragment is left out (a transmittance below 1/1000). One thread, decoding
included; milliseconds by stage and in total.

"""
    head = ["light", "ends", "from", "waiting", "%", "fragments", "memory, MiB", "decode", "order",
            "set-up", "draw", "finish", "all"]
    for mesh in results["meshes"]:
        for release in mesh.get("release", []):
            rows = []
            for light, ends, *pair in release_cases(release):
                for case in pair:
                    rows.append([light, "yes" if ends else "no",
                                 "both" if case["bothEnds"] else "front",
                                 f"{case['mostWaiting']:,}",
                                 _percent(case["mostWaiting"], release["largestChunk"]),
                                 f"{case['mostFragments']:,}",
                                 number(case["mostBytes"] / 2**20)] + [
                                     number(1000 * case[stage]) for stage in
                                     ("fetch", "order", "setUp", "draw", "finish")]
                                + [number(1000 * statistics.median(case["seconds"]))])
            size = release["cases"][0]["size"]
            text += (f"### {mesh['name']}, {release['chunks']} chunk"
                     f"{'s' if release['chunks'] > 1 else ''} of at most "
                     f"{release['largestChunk']:,} tetrahedra, {size} x {size}\n\n")
            text += table(head, rows) + "\n"
    return text + _release_summary(results) + "\n" + image(
        plots, "release", "Waiting tetrahedra, fragments and time", "rendering-study")


def _release_summary(results):
    """Cost and benefit of release from both ends, as ratios over all of the tables."""
    pairs = [pair for mesh in results["meshes"] for release in mesh.get("release", [])
             for pair in release_cases(release)]
    if not pairs:
        return ""

    def factors(key, chosen):
        return [both[key] / front[key] for _, _, front, both in chosen if front[key]]

    def times(chosen):
        return [statistics.median(b / a for a, b in zip(front["seconds"], both["seconds"]))
                for _, _, front, both in chosen]
    ending = [pair for pair in pairs if pair[0] == "nearly opaque" and pair[1]]
    others = [pair for pair in pairs if pair not in ending]
    return paragraph(f"""Both ends relative to the front only, over all of the tables above: waiting
        tetrahedra {span(factors("mostWaiting", pairs), ratio)}, fragments
        {span(factors("mostFragments", pairs), ratio)}, memory
        {span(factors("mostBytes", pairs), ratio)}; time {span(times(ending), ratio)} where rays end
        early at something nearly opaque, and {span(times(others), ratio)} in all other cases.""")


def prefilter_pairs(mesh):
    """For each size: the case with the pre-filter and the case without."""
    found = {}
    for case in mesh["prefilter"]["cases"]:
        found.setdefault(case["size"], {})[case["prefilter"]] = case
    return [(size, pair[True], pair[False]) for size, pair in sorted(found.items())]


def dropped(case):
    """The share of the tetrahedra that were dropped, in percent."""
    return 100 * (1 - case["seenTets"] / case["tets"]) if case["tets"] else 0


def _prefilter(results, plots):
    rows = []
    gains = []
    for mesh in results["meshes"]:
        if "prefilter" not in mesh:
            continue
        for size, on, off in prefilter_pairs(mesh):
            work = [case["order"] + case["setUp"] + case["draw"] for case in (on, off)]
            relative = rounds_of(zip(off["seconds"], on["seconds"]))
            gains.append(statistics.median(relative))
            rows.append([mesh["name"], f"{size} x {size}", f"{dropped(on):.1f}",
                         number(1000 * work[0]), number(1000 * work[1]),
                         number(1000 * statistics.median(on["seconds"])),
                         number(1000 * statistics.median(off["seconds"])), spread(relative, ratio)])
    return "## The pre-filter (section 4.4)\n\n" + paragraph(
        f"""Tetrahedra whose bounding box in the image contains no ray or no sample contribute nothing.
        The pre-filter drops them before their planes are set up; their faces still count as
        processed. The proposal suggests it as a remedy for costs that do not fall with the size of
        the image. The table has the share of the tetrahedra that are dropped, and milliseconds on
        one thread with and without the filter: for ordering, set-up and drawing, and in total with
        decoding. Without it, an image takes {span(gains, ratio)} times as long.""") + (
            "\n" + table(["mesh", "image", "dropped, %", "work, with", "work, without", "all, with",
                          "all, without", "without / with"], rows) + "\n" + image(
                 plots, "prefilter", "Tetrahedra dropped by the pre-filter", "rendering-study"))


def page(results, plots):
    parts = [_head(results), _peak(results, plots), _times(results, plots),
             _release(results, plots), _prefilter(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, "rendering-study", page, "studyPlots")
