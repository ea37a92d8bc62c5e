# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page made of what runStudy.py has measured."""

import statistics

from benchmarkText import machine, number, paragraph, picture, table

WAYS = {"gatun": "while decompressing", "small": "the same, small chunks",
        "generic": "decompress first", "vtu": ".vtu, load first"}

# Table 4 of the proposal: seconds, generic and Gatun at 160 MB, then at 80 MB; * where it paged.
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
    """Why there is no picture; None if there is one."""
    return next((run["why"] for run in runs if "why" in run), None)


def seconds(runs):
    return statistics.median(run["seconds"] for run in runs)


def memory(runs):
    """MiB above the idle process."""
    return max(run["peak"] - run["before"] for run in runs) / 2**20


def find_case(mesh, limit, size):
    return next(case for case in mesh["limits"] if case["limit"] == limit and case["size"] == size)


def sizes(mesh):
    return sorted({case["size"] for case in mesh["limits"]})


def limits(mesh):
    """From none (0) to the least."""
    return sorted({case["limit"] for case in mesh["limits"]}, key=lambda limit: limit or 1e9,
                  reverse=True)


def limit_text(limit):
    return f"{limit:,} MiB" if limit else "none"


def usual_size(mesh):
    """512 pixels, or the second largest there is."""
    return sizes(mesh)[-2]


def _head(results):
    text = """# The dissertation's rendering study, redone

C. Yang, *On-the-fly Processing of Compressed Volume Data*, dissertation proposal, Stony Brook,
2001, measures rendering while a mesh is decompressed against a "generic" way that decompresses it
first (Figures 13 and 14, Table 4), leaves open whether tetrahedra are better released from one end
of the rays or from both, and proposes a pre-filter (section 4.4). This page does all of that with
today's Gatun. `Utilities/bench.sh --study` (Benchmarks/Studies/runStudy.py) made it; every figure
behind it is in [results.json](rendering-study/results.json).

""" + machine(results["machine"])
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small meshes: not to be quoted.**\n"
    rows = [[mesh["name"], f"{mesh['tets']:,}", f"{mesh['fileBytes']['gtn']:,}",
             f"{mesh['fileBytes']['vtu-zlib']:,}", mesh["about"]] for mesh in results["meshes"]]
    text += """
## What is compared

All ways use the same ray caster (`vtkGatunRayCaster`, no window), which keeps nothing for a
next picture, on all processors; each picture is made by a process of its own.

- *While decompressing*: straight from the `.gtn` file, chunk by chunk from front to back, one chunk
  for each thread at a time. Chunks are of at most 65,536 tetrahedra, which is the default below 10
  million; or, *small chunks*, of at most 8,192.
- *Decompress first*, the paper's generic way: `vtkGatunReader` makes the whole grid, without a
  cache, then it is drawn.
- *.vtu, load first*: the same with VTK's own file (zlib) and reader.

Meshes have one float array; points and cells were in random order before they were written, but for
those of more than 5 million tetrahedra. Colours and camera are those of the
[benchmarks](benchmarks.md).

""" + table(["mesh", "tetrahedra", ".gtn, bytes", ".vtu, bytes", "what"], rows)
    if not any(mesh["name"] == "bluntfin" for mesh in results["meshes"]):
        text += "\nThe paper's own meshes were not there (`GATUN_DATA_DIR` was not set).\n"
    text += "\n" + (f"**Pictures differ, of {', '.join(differing(results))}.**\n"
                    if differing(results) else
                    "All ways, with and without the pre-filter, drew the same pictures.\n")
    return text


def _peak(results, pictures):
    rows = []
    ratios = []
    for mesh in results["meshes"]:
        ways = find_case(mesh, 0, usual_size(mesh))["ways"]
        found = {way: memory(ways[way]) for way in WAYS}
        ratios.append(found["generic"] / found["gatun"])
        rows.append([mesh["name"], f"{mesh['tets']:,}", *map(number, found.values()),
                     f"{ratios[-1]:.1f}", f"{found['generic'] / found['small']:.1f}"])
    size = usual_size(results["meshes"][0])
    return "## Peak memory (Figure 13)\n\n" + paragraph(f"""Most memory in use from file to picture
        ({size} x {size}), above that of the process before it does anything, in MiB. In the paper,
        Gatun needs "usually less than half" of what the generic way needs. Here the generic way
        needs {min(ratios):.1f} to {max(ratios):.1f} times as much as Gatun with its usual chunks.
        What Gatun needs depends on the chunks and on the picture, what the others need on the
        mesh.""") + "\n" + table(
            ["mesh", "tetrahedra", *WAYS.values(), "generic / Gatun", "generic / small chunks"],
            rows) + ("\n" + picture(pictures, "memory", "Peak memory by mesh", "rendering-study"))


def _entry(runs):
    return failure(runs) or f"{seconds(runs):.3f}"


def _least_limit(mesh, way, size):
    """The least limit under which there is a picture; 0 if it needs none."""
    works = [limit for limit in limits(mesh) if limit
             and not failure(find_case(mesh, limit, size)["ways"][way])]
    return min(works, default=0)


def _times(results, pictures):
    if results["limiter"].startswith("cgroup"):
        how = ("a control group, which counts the heap and those pages of files and libraries that "
               "nobody has brought in before")
    else:
        how = ("`ulimit -v`, as no control group could be made here: it counts all that is mapped, "
               "libraries and the stacks of threads above all")
    swap = (f"{results['swap'] / 2**30:.1f} GiB of swap" if results["swap"]
            else "no swap: *fails* is where the paper's program pages")
    text = "## End-to-end time under limits of memory (Figure 14, Table 4)\n\n" + paragraph(
        f"""Seconds from file to picture, reading and decompressing included, without the start of
        the program; medians. Memory was limited by {how}. The machine has {swap}. Files are in
        the page cache.""") + "\n"
    for mesh in results["meshes"]:
        all_sizes = sizes(mesh)
        rows = []
        for limit in limits(mesh):
            for way, name in WAYS.items():
                rows.append([limit_text(limit), name] + [
                    _entry(find_case(mesh, limit, size)["ways"][way]) for size in all_sizes])
        least = {way: _least_limit(mesh, way, usual_size(mesh)) for way in WAYS}
        text += f"### {mesh['name']}, {mesh['tets']:,} tetrahedra\n\n"
        text += table(["limit", "way"] + [f"{size} x {size}" for size in all_sizes], rows) + "\n"
        usual = usual_size(mesh)
        text += paragraph(f"The least of these limits with a picture, {usual} x {usual}: "
                          + "; ".join(f"{WAYS[way]}, {limit_text(limit)}"
                                      for way, limit in least.items()) + ".") + "\n"
    text += picture(pictures, "time", "Time by size and limit of memory", "rendering-study")
    text += """
For comparison, Table 4 of the proposal: seconds on a Pentium II of 300 MHz with so much memory, *
where it paged.

""" + table(["mesh", "size", "generic, 160 MB", "Gatun, 160 MB", "generic, 80 MB", "Gatun, 80 MB"],
            PAPER)
    return text


def release_cases(release):
    """Pairs of cases that differ in the end of release only: front, both."""
    found = {}
    for case in release["cases"]:
        found.setdefault((case["light"], case["opaque"] > 0), {})[case["bothEnds"]] = case
    return [(light, ends, pair[False], pair[True]) for (light, ends), pair in found.items()]


def differing(results):
    """Names of meshes of which not all pictures of a size are the same but for rounding, in which
    case nothing can be compared."""
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


def _release(results, pictures):
    text = """## Released from one end or from both (section 4.4)

A tetrahedron can be drawn when all its faces towards the eye are processed; or, if rays may also
grow from their far ends, when all those away from it are. The paper does both, so that tetrahedra
wait less; but what comes from behind may be hidden in the end, and then was drawn in vain, and rays
are in more fragments. It expected more memory for release from the front alone, and better times if
rays end early.

*Waiting*: how many tetrahedra at most had arrived and had to wait, in one chunk, and what share of
the largest chunk that is. *Fragments*: at most in all pixels together. *Memory*: picture and chunk
at work; a chunk is in memory as a whole while it is drawn, whatever waits in it, so that fewer
waiting tetrahedra do not make it smaller. Chunks are drawn from front to back, one at a time here,
so what waits is bounded by the chunk; each mesh was therefore also stored in one chunk (of at most
1,048,576 tetrahedra), where the paper's question applies in full. *Ends*: whether what is behind an
opaque fragment is left out (less than 1/1000 shines through). One thread, decoding included;
milliseconds by stage, and of all.

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
    return text + _release_summary(results) + "\n" + picture(
        pictures, "release", "Waiting tetrahedra, fragments and time", "rendering-study")


def _span(values):
    return f"{min(values):.2f} to {max(values):.2f}"


def _release_summary(results):
    """What release from both ends costs and saves, as factors over all of the tables."""
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
    return paragraph(f"""With both ends, against the front only, over all of the above:
        {_span(factors("mostWaiting", pairs))} times as many tetrahedra wait, there are
        {_span(factors("mostFragments", pairs))} times as many fragments, and memory is
        {_span(factors("mostBytes", pairs))} times as large. Pictures take {_span(times(ending))}
        times as long where rays end early at something nearly opaque, and {_span(times(others))}
        times as long in all other cases.""")


def prefilter_pairs(mesh):
    """For each size: with the pre-filter, without."""
    found = {}
    for case in mesh["prefilter"]["cases"]:
        found.setdefault(case["size"], {})[case["prefilter"]] = case
    return [(size, pair[True], pair[False]) for size, pair in sorted(found.items())]


def dropped(case):
    """Share of the tetrahedra that were left out, in percent."""
    return 100 * (1 - case["seenTets"] / case["tets"]) if case["tets"] else 0


def _prefilter(results, pictures):
    rows = []
    gains = []
    for mesh in results["meshes"]:
        if "prefilter" not in mesh:
            continue
        for size, on, off in prefilter_pairs(mesh):
            work = [case["order"] + case["setUp"] + case["draw"] for case in (on, off)]
            gains.append(statistics.median(b / a for a, b in zip(on["seconds"], off["seconds"])))
            rows.append([mesh["name"], f"{size} x {size}", f"{dropped(on):.1f}",
                         number(1000 * work[0]), number(1000 * work[1]),
                         number(1000 * statistics.median(on["seconds"])),
                         number(1000 * statistics.median(off["seconds"])), f"{gains[-1]:.2f}"])
    return "## The pre-filter (section 4.4)\n\n" + paragraph(
        f"""Tetrahedra whose box in the picture has no ray, or no sample, own nothing of it.
        They are dropped before their planes are set up; their faces still count as processed. The
        paper proposes this, as a cure for costs that do not fall with the size of the picture.
        Share of the tetrahedra that it drops, and milliseconds with and without it on one thread:
        ordering, set-up and drawing, and all with decoding. Without it, pictures take
        {_span(gains)} times as long.""") + "\n" + table(
            ["mesh", "picture", "dropped, %", "work, with", "work, without", "all, with",
             "all, without", "without / with"], rows) + "\n" + picture(
                 pictures, "prefilter", "Tetrahedra dropped by the pre-filter", "rendering-study")


def write(results, out):
    """Writes rendering-study.md, and pictures where matplotlib is there."""
    try:
        import studyPlots
        pictures = studyPlots.draw(results, out / "rendering-study")
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no pictures.")
        pictures = set()
    page = [_head(results), _peak(results, pictures), _times(results, pictures),
            _release(results, pictures), _prefilter(results, pictures)]
    (out / "rendering-study.md").write_text("\n".join(part.rstrip() + "\n" for part in page),
                                            encoding="utf-8")
