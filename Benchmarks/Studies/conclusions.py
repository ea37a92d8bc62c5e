# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page in front of the studies: a conclusion of each, with numbers from its results.json."""

import statistics

import benchmarkReport
import budgetReport
import cellsReport
import clientReport
import detailReport
import errorReport
import isosurfaceReport
import parallelReport
import partsReport
import renderingReport
import scalingModel
import scalingText
import seriesReport
import simplificationReport
import simplificationTimes
import speedReport
import studyReport
import surfaceReport
import volumeReport
from benchmarkText import number, paragraph, ratio, span


def _ratios_of_loads(results, threads):
    return [statistics.median(benchmarkReport.ratios(load, "vtu-zlib")) for one in results["inputs"]
            for load in one.get("load", []) if load["threads"] == threads]


def _benchmarks(results):
    best, arrays = [], []
    for one in results["inputs"]:
        files = benchmarkReport.by_format(one["size"])
        smaller = files["vtu-lzma-best"]["bytes"] / files["gtn"]["bytes"]
        (best if smaller >= 1 else arrays).append((smaller, benchmarkReport.label(one)))
    later = [renderingReport.later_ratio(case, "bunyk") for mesh in results["rendering"]["meshes"]
             for case in mesh["render"] if "bunyk" in renderingReport.by_mapper(case)]
    big = next(mesh for mesh in results["rendering"]["meshes"] if mesh["name"] == "big")
    images = renderingReport.image_ratios(renderingReport.find_images(big, "vtu-zlib"),
                                          renderingReport.find_images(big, "gtn", 512))
    memory = [renderingReport.most_memory(renderingReport.find_images(big, form, budget))
              for form, budget in (("gtn", 512), ("gtn", 0), ("vtu-zlib", 0))]
    lost = (" It is larger for " + ", ".join(name for _, name in arrays) + ".") if arrays else ""
    return f"""A `.gtn` file is {span([value for value, _ in best], ratio)} times smaller than the best LZMA
        `.vtu` file in {len(best)} of {len(best) + len(arrays)} cases.{lost} With 2 threads it loads
        {span(_ratios_of_loads(results, 2), ratio)} times as fast as a zlib `.vtu` file, with one
        thread {span(_ratios_of_loads(results, 1), ratio)} times. Later frames of
        `vtkGatunVolumeMapper` are {span(later, ratio)} times as fast as those of VTK's
        `vtkUnstructuredGridVolumeRayCastMapper`. From the file of {big["tets"]:,} tetrahedra to the
        first image it is {ratio(statistics.median(images))} times as fast and needs
        {number(memory[0])} MiB with default settings ({number(memory[1])} MiB with a `MemoryBudget` of
        0) instead of {number(memory[2])} MiB."""


def _speed(results):
    rows = speedReport.rows(results)
    missed = [row for row in rows if "not" in row["verdict"]]
    aimed = sum(row["verdict"] == "target met" for row in rows)
    if not missed:
        return f"All {len(rows)} goals are met, {aimed} of them with their target."
    return (f"{len(rows) - len(missed)} of {len(rows)} goals are met, {aimed} of them with their target. "
            "Not met: " + "; ".join(
                f"{row['what']}, {number(row['value'])} {row['unit']} instead of {number(row['must'])}"
                for row in missed) + ".")


def _rendering(results):
    usual = [studyReport.find_case(mesh, 0, studyReport.usual_size(mesh))["ways"]
             for mesh in results["meshes"]]
    factors = [studyReport.memory(ways["generic"]) / studyReport.memory(ways["gatun"])
               for ways in usual]
    small = [mesh["name"] for mesh, factor in zip(results["meshes"], factors) if factor < 1.5]
    times = [studyReport.seconds(ways["generic"]) / studyReport.seconds(ways["gatun"])
             for ways in usual]
    return f"""Decompressing a mesh before drawing it takes {span(factors, ratio)} times the memory of drawing
        it while it is decompressed, and {span(times, ratio)} times the time. The advantage in memory
        grows with the mesh; there is none on small meshes such as {" and ".join(small)}, whose few
        chunks are all at work at once. Release from both ends of the rays, which the proposal
        prefers, breaks rays into more fragments and takes longer in most cases; Gatun releases from
        the front. The pre-filter pays little."""


def _cells(results):
    meshes = results["meshes"]
    smaller = [cellsReport.file_size(mesh, "vtu-lzma") / cellsReport.file_size(mesh, "gtn")
               for mesh in meshes]
    loads = {threads: [statistics.median(cellsReport.load_ratios(mesh, threads)) for mesh in meshes]
             for threads in (1, 2)}
    return f"""Files of {len(meshes)} meshes of hexahedra, wedges, pyramids, polyhedra, nonlinear cells and
        surfaces are {span(smaller, ratio)} times smaller than `.vtu` files with LZMA. They are loaded
        {span(loads[2], ratio)} times as fast as `.vtu` files with zlib by two threads, and
        {span(loads[1], ratio)} times by one."""


def _parts(results):
    largest = [mesh for mesh in results["large"] if "tets" in mesh][-1]
    packing, *uses = largest["steps"]
    uses = [use for use in uses if "peak" in use]
    whole, *pieces = results["compared"]
    sizes = [one["bytes"] / whole["bytes"] for one in pieces]
    return f"""A mesh of {largest["tets"]:,} tetrahedra was packed in {largest["pieces"]} pieces with
        {number(packing["peak"] / 2**20)} MiB, in {number(packing["seconds"])} s. To {", ".join(use["what"] for use in uses)}
        the file took {span([use["peak"] / 2**20 for use in uses])} MiB. Files packed in
        pieces are {span(sizes, ratio)} times as large as those packed as a whole."""


def _parallel(results):
    several = [case for case in parallelReport.compact(results) if case["processes"] > 1]
    memory = [parallelReport.relative_memory(case) for case in several]
    sent = [100 * parallelReport.sent(case) / (parallelReport.share(case) * case["processes"])
            for case in several]
    times = [value for case in several for value in parallelReport.time_ratios(case)]
    return f"""{several[0]["processes"]} to {several[-1]["processes"]} processes write a mesh of
        {results["tets"]:,} tetrahedra to one file. At its peak each one has {span(memory, ratio)} times
        its share of the mesh in memory, the share included, and all together send
        {span(sent, lambda value: f"{value:.1f}")} % of the mesh, if parts are compact. That takes
        {span(times, ratio)} times as long as to write `.pvtu` files with zlib, which are
        {span([parallelReport.size_ratio(case) for case in several], ratio)} times larger."""


def _scaling(results):
    k = scalingModel.constants(results)
    cells, ranks = scalingModel.CELLS[-1], scalingModel.RANKS
    few, many = (scalingModel.predict(k, cells, count) for count in ranks[-2:])
    opened = scalingModel.predict_opening(k.tables, many.chunks)
    return f"""A model with measured constants, which is compared with measurements: {few.ranks:,} ranks write
        {scalingText.power(cells)} cells in {scalingText.duration(few.seconds)}, {many.ranks:,} in
        {scalingText.duration(many.seconds)}, of which {100 * few.efficiency:.0f} and
        {100 * many.efficiency:.0f} % are encoding. Each rank then takes {scalingText.size(many.tables)} for
        the tables of all chunks. To open the file takes {scalingText.size(opened.memory)} and
        {scalingText.duration(opened.seconds)}. The page says what is in the way."""


def _budget(results):
    shares, rays = [], []
    for mesh in results["meshes"]:
        for way, found in (("simplified", shares), ("rays", rays)):
            found += [100 * budgetReport.shares(mesh[way], path)[0] for path in mesh[way]["paths"]]

    def percent(value):
        return f"{value:.0f}"
    return f"""With fewer points and fewer rays, {span(shares, percent)} % of the frames are in time, depending
        on mesh and budget; with fewer rays alone, {span(rays, percent)} %. At tight budgets the
        images are coarse: the page has the numbers of points and the distances of rays. The meshes are
        in memory; files were not measured."""


def _detail(results):
    near, far = [], []
    for mesh in results["meshes"]:
        for place in mesh["pictures"]["places"]:
            for one in place["view"]:
                same = detailReport.tets_at(place["uniform"], one["rms"])
                if same and place["part"] in (0, 1):
                    (near if place["part"] == 1 else far).append(one["tets"] / same)
    flights = [flight for mesh in results["meshes"] for flight in mesh["flights"]
               if not flight["uniform"]]
    in_time = [100 * detailReport.in_time(flight) for flight in flights]
    read = [100 * flight["bytesRead"][min(9, len(flight["bytesRead"]) - 1)] / flight["fileBytes"]
            for flight in flights]

    def percent(value):
        return f"{value:.0f}"
    return f"""For the same error of the image, a mesh that is simplified for the view takes
        {span(near, ratio)} times the tetrahedra of one that is simplified everywhere alike where the
        camera is closest, and {span(far, ratio)} times from afar. {span(in_time, percent)} % of the
        frames of flights are in time, and {span(read, percent)} % of the file are read for the first
        ten."""


def _simplification(results):
    cases = [(simplificationReport.field_ratio(quadric, gatun), f"{mesh['name']} at {part} %")
             for mesh in results["meshes"]
             for part, quadric, gatun in simplificationReport.cases(mesh)]
    better = [value for value, _ in cases if value < 1]
    worse = [value for value, _ in cases if value >= 1]
    names = ", ".join(name for value, name in cases if value >= 1)
    builds = [1e6 * statistics.median(mesh["build"]["seconds"])
              / mesh["compared"]["original"]["tets"] for mesh in results["meshes"]]
    shares = [100 * simplificationTimes.simplify_share(run, way) for mesh in results["meshes"]
              for run in mesh["integrated"]["runs"] if run["ratio"] > 0
              for way in ("integrated", "levels")]
    return f"""The RMS error of the field is {span(better, ratio)} times that of
        `vtkUnstructuredGridQuadricDecimation` at equal numbers of tetrahedra in {len(better)} of
        {len(cases)} cases, and {span(worse, ratio)} times in the others, which have smooth
        fields ({names}). Finding the order of the merges takes {span(builds)} seconds per million
        tetrahedra, once; each mesh then takes one pass, where VTK starts again. Simplifying from a
        file takes {span(shares)} % of the time to the image, where the proposal reports less than
        5 %."""


def _isosurfaces(results):
    parts = []
    for mesh in results["meshes"]:
        layers = span(isosurfaceReport.time_ratios(mesh), ratio)
        plain = span(isosurfaceReport.time_ratios(mesh, "zlib", "spatial"), ratio)
        parts.append(f"{mesh['name']} {layers} ({plain} without layers)")
    raw = [value for mesh in results["meshes"]
           for value in isosurfaceReport.time_ratios(mesh, "raw")]
    return f"""From a file with layers to an isosurface, relative to a zlib `.vtu` file and
        `vtkContour3DLinearGrid`: {"; ".join(parts)} times as fast. Small meshes gain no time. A raw
        `.vtu` file in the page cache takes {span(raw, ratio)} times the time of a file with layers,
        and reads many times the bytes. A file with layers is larger than one without."""


def _volumes(results):
    own, between, lines = 0, 0, 0
    for one in results["volumes"]:
        for run in one["blocks"]:
            for view in run["ways"][0]["views"] if run["rate"] == 0 else []:
                lines = max(lines, view["lines"])
                if view["samples"] > own:
                    own, between = view["samples"], view["between"]
    worst6 = max(view["equation6"]["worst"] for one in results["volumes"] for run in one["pictures"]
                 for block in run["blocks"] if block["rate"] == 0 for view in block["views"])
    better, worse = 0, 0
    for one in results["volumes"]:
        counts = volumeReport.count_against_paper(one)
        better, worse = better + counts[0], worse + counts[1]
    runs = results["times"]["runs"]["blocks"]
    peer = volumeReport.median(volumeReport.find(runs["ways"], way="fixed-point", law="xray"))
    times = [volumeReport.median(way) / peer for way in runs["ways"]
             if way["way"] == "gatun" and way["law"] == "xray"]
    return f"""Before quantization, images of blocks differ from exact line integrals by a mean square error of
        at most {lines:.4f}, where the largest sum along a ray is 255. They differ from the dissertation's
        reference, sums of samples, by at most {own:.2f}; the error of that reference itself is
        {between:.2f} there. Whole images are closer to the
        reference than the dissertation's in {better} cases and farther from it in {worse}; its opacity
        scale is unknown. The opacity of a whole ray under the exponential model, which is exact for
        each block, is up to {worst6:.1f} of 255 off at a pixel. An X-ray view at
        {runs["pixels"]} x {runs["pixels"]} pixels takes {span(times, ratio)} times the time of
        `vtkFixedPointVolumeRayCastMapper` with voxels, depending on the size of the blocks: drawing
        from coefficients makes files smaller, not images faster. Fewer coefficients hardly save
        time."""


SECTIONS = (
    ("benchmarks", "Benchmarks", "Sizes, loading, writing, pieces, rendering", _benchmarks),
    ("speed", "Speed and memory", "What the project promises beside its peers, and what it keeps", _speed),
    ("cells-study", "Cells of all types", "Sizes by part and loading", _cells),
    ("parts-study", "Meshes larger than memory", "Packing piece by piece, with little memory", _parts),
    ("parallel-study", "Several processes", "One file, its messages, memory and time", _parallel),
    ("scaling", "Scaling", "10^9 and 10^12 cells on 1 to 10,000 ranks, by a model", _scaling),
    ("rendering-study", "Rendering", "Drawing while decompressing, after the dissertation proposal",
     _rendering),
    ("just-in-time-study", "Just-in-time rendering", "Keeping a time budget", _budget),
    ("detail-study", "View-dependent simplification", "Fine where the eye is, from files", _detail),
    ("simplification-study", "Simplification", "Errors, time and memory, compared with VTK's filter",
     _simplification),
    ("isosurface-study", "Isosurfaces", "From files and in memory, compared with VTK's filters",
     _isosurfaces),
    ("surface-study", "Surfaces", "Sizes by part and decoding, beside Draco and other formats",
     surfaceReport.conclude),
    ("volume-study", "Volumes", "Hartley coefficients, compared with voxels and zfp", _volumes),
    ("errors-study", "Arrays with bounded errors", "Bits a value, beside SZ3 and zfp", errorReport.conclude),
    ("series-study", "Time series", "Sizes and steps, beside a .vtu file for each step", seriesReport.conclude),
    ("client-study", "ParaView's client", "File to first image and memory in the window", clientReport.conclude),
)


def page(all_results):
    parts = ["""# The studies

Each page here is written by a program from a file results.json next to it, and states the machine,
the date, the commit and the spread of its rounds. This page, written by
Benchmarks/Studies/conclusions.py, has the main conclusion of each. The [summary](summary.md) has the
rows of the table in README.md.
"""]
    for name, title, about, conclude in SECTIONS:
        parts.append(f"## [{title}]({name}.md)\n\n"
                     + paragraph(f"*{about}.* {conclude(all_results[name])}"))
    parts.append("""## Measuring again

`Utilities/bench.sh` lists the commands. `--report` writes a page again from its results.json, and
`Benchmarks/Studies/generatedParts.py --update` writes all pages, this one and the table in README.md.
A test compares all of them with their results.

The studies use meshes that the benchmark generates. They also use the blunt fin, the combustion
chamber and other files if `GATUN_DATA_DIR` names a folder with them. Those files are not part of
the project; rows about them cannot be repeated without them.
""")
    return "\n".join(part.rstrip() + "\n" for part in parts)
