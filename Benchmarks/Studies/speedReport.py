# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runSpeed.py: what Gatun promises in speed and memory, and what it keeps."""

import statistics

import benchmarkGoals
import benchmarkReport
import benchmarkText
from benchmarkText import number, paragraph, ratio, rounds_of, span, spread, table

MIB = 2**20


def _row(what, unit, rounds, must, aim, peer="-", more_is_better=True, worst=None):
    """A goal with all its rounds. worst: the value that counts, if not the median of the rounds."""
    value = statistics.median(rounds) if worst is None else worst
    row = benchmarkGoals.goal(what, unit, peer, value, must, aim, more_is_better)
    return {**row, "rounds": list(rounds)}


def gains(case, other="bunyk"):
    """How many times as fast as another mapper later images are, round by round."""
    seconds = {one["mapper"]: one["seconds"] for one in case["mappers"]}
    return rounds_of(zip(seconds[other], seconds["gatun"]))


def slower_by(sets, name):
    """The median time with an instruction set, divided by that with the best one."""
    seconds = {one["name"]: one["seconds"] for one in sets["instructions"]}
    return statistics.median(rounds_of(zip(seconds[name], seconds["AVX-512"])))


def _mapper(results):
    cases = results.get("mapper")
    if not cases:
        return
    peer = "`vtkUnstructuredGridVolumeRayCastMapper`"
    for name, must, aim in ("AVX-512", 11, 15), ("AVX2", 9.5, 12):
        medians = [statistics.median(gains(case["mappers"])) / slower_by(case["instructions"], name)
                   for case in cases]
        yield _row(f"later images, one thread, {name}, slowest of {len(cases)} cases", "times as fast",
                   medians, must, aim, peer, worst=min(medians))
    yield _row(f"later images of {results['big']['tets']:,} tetrahedra, {results['big']['size']} pixels "
               "wide", "times as fast", gains(results["big"]), 11, 15, peer)


def _above_version(results, key):
    idle = statistics.median(one["peak"] for one in results["processes"]["version"])
    return [(one["peak"] - idle) / MIB for one in results["processes"][key]]


def _processes(results):
    runs = results.get("processes")
    if not runs:
        return
    pairs = zip((one["seconds"] for one in runs["bunyk"]), (one["seconds"] for one in runs["gtn"]))
    yield _row("`gtn render` of the Delaunay mesh, whole process", "times as fast", rounds_of(pairs),
               5.5, 8, "zlib `.vtu` and the first image of VTK's ray caster")
    yield _row("memory of that, above `gtn --version`", "MiB", _above_version(results, "gtn"), 70, 45,
               more_is_better=False)
    yield _row("memory of `gtn render` of the large grid, above `gtn --version`", "MiB",
               _above_version(results, "big"), 120, 80, more_is_better=False)


def _files(results):
    files = results["files"]
    goals = {1: (0.63, 0.75), 2: (1.25, 1.5), 4: (1.25, 1.5)}
    for key, what in ("load", "loading"), ("cold", "loading from the disk"):
        for load in files["delaunay"][key]:
            threads = load["threads"]
            yield _row(f"{what}, Delaunay mesh, {threads} thread{'s' if threads > 1 else ''}",
                       "times as fast", benchmarkReport.ratios(load, "vtu-zlib"), *goals[threads],
                       "zlib `.vtu`")
    for name, must, aim in ("delaunay", 1.4, 1.1), ("big", 1.1, 1.05):
        peak = files[name]["peak"]["gtn"]
        yield _row(f"peak memory while loading, {name}", "times the grid",
                   [(peak["peak"] - peak["before"]) / peak["gridBytes"]], must, aim, more_is_better=False)
    for write in files["delaunay"]["write"]:
        rounds = [write["tets"] / seconds / 1e6
                  for seconds in benchmarkReport.by_format(write)["gtn"]["seconds"]]
        threads = write["threads"]
        yield _row(f"packing, Delaunay mesh, {threads} thread{'s' if threads > 1 else ''}",
                   "million tetrahedra per second", rounds, 1.5, 2.5)


def _surfaces(results):
    peer = "zlib `.vtu` and `vtkContour3DLinearGrid`"
    costs = {
        "time": (lambda run: run["seconds"], 3, 8), "bytes read": (lambda run: run["bytes"], 20, 40),
        "memory": (lambda run: run["peak"] - run["before"], 5, 10)}
    for what, (cost, must, aim) in costs.items():
        medians = [statistics.median(rounds_of(zip(map(cost, one["zlib"]), map(cost, one["layers"]))))
                   for one in results["surfaces"]]
        yield _row(f"isosurface from a file with layers, {what}, median of {len(medians)} isovalues",
                   "times less", medians, must, aim, peer)


def _layers(results):
    layers = results["layers"]
    plain, layered = (one["seconds"] for one in layers["load"]["files"])
    yield _row("whole read of a file with layers", "times as long", rounds_of(zip(layered, plain)), 1.15,
               1, "the same without layers", more_is_better=False)
    if "image" in layers:
        plain, layered = ([one["seconds"] for one in layers["image"][key]] for key in ("plain", "layered"))
        yield _row("first image of a file with layers", "times as long", rounds_of(zip(layered, plain)),
                   1.15, 1, "the same without layers", more_is_better=False)


def _hierarchy(results):
    build = results["hierarchy"]
    for run in build["threads"]:
        threads = run["threads"]
        yield _row(f"building a hierarchy, Delaunay mesh, {threads} thread{'s' if threads > 1 else ''}",
                   "million tetrahedra per second",
                   [build["tets"] / seconds / 1e6 for seconds in run["seconds"]], 0.3, 0.5)


def _later(way, plain):
    """How many times as fast as the sum of voxels along rays, view by view."""
    return rounds_of(zip(plain["later"], way["later"]))


def _volumes(results):
    volumes = results["volumes"]
    pairs = []
    for run in volumes["blocks"], volumes["whole"]:
        plain = next(way for way in run["ways"] if way["way"] == "plain")
        pairs += [(way, plain) for way in run["ways"] if way["way"] == "gatun"]
    peer = "sum of voxels along rays"
    for law, what, must, aim in ("xray", "X-rays", 10, 16), ("exponential", "opacity model", 1.3, 3):
        medians = [statistics.median(_later(way, plain)) for way, plain in pairs if way["law"] == law]
        yield _row(f"volume, {what}, slowest of {len(medians)} sizes of blocks", "times as fast", medians,
                   must, aim, peer, worst=min(medians))
    whole = pairs[-1][0]
    yield _row("first X-ray of a whole volume from its file", "s", [whole["seconds"]], 0.8, 0.4,
               more_is_better=False)
    yield _row("first X-ray along another axis", "times a later one",
               [whole["otherAxis"] / statistics.median(whole["later"])], 1.2, 1, more_is_better=False)
    errors = [one["mse"] for one in volumes["errors"]]
    yield _row(f"mean square error of X-rays of lossless files, largest of {len(errors)}", "of 255 squared", errors, 0.02,
               0.01, "exact integrals", more_is_better=False, worst=max(errors))


PARTS = (_mapper, _processes, _files, _surfaces, _layers, _hierarchy, _volumes)


def rows(results):
    return [row for part in PARTS for row in part(results)]


def _goal_table(results):
    return table(["goal", "unit", "peer", "required", "target", "now (range)", "verdict"],
                 [[row["what"], row["unit"], row["peer"], number(row["must"]), number(row["moonshot"]),
                   number(row["value"]) + (f" ({span(row['rounds'])})" if len(row["rounds"]) > 1 else ""),
                   row["verdict"]] for row in rows(results)])


def _mapper_table(results):
    lines = []
    for case in results.get("mapper", []):
        seconds = {one["mapper"]: one["seconds"] for one in case["mappers"]["mappers"]}
        lines.append([case["mesh"], f"{case['mappers']['tets']:,}", case["size"],
                      spread(seconds["gatun"]), spread(seconds["bunyk"]), spread(gains(case["mappers"])),
                      *(ratio(slower_by(case["instructions"], name)) for name in ("AVX2", "portable"))])
    return table(["mesh", "tetrahedra", "pixels", "Gatun, s", "VTK, s", "times as fast",
                  "AVX2: time / AVX-512", "portable: time / AVX-512"], lines)


def page(results, _):
    parts = ["""# Speed and memory

What the project promises in speed and memory beside its peers, and the current state.
`Utilities/bench.sh --speed` (Benchmarks/Studies/runSpeed.py) writes this page. All results are in
[results.json](speed/results.json).
""", benchmarkText.machine(results), paragraph("""*Required* is the value that the project promises;
        *target* is the value that it aims for. *Now* is the median of the rounds or cases, or their worst
        value where the goal says so. All settings have their default values. Where no number of threads
        is given, all processors are used."""), _goal_table(results)]
    if results.get("mapper"):
        parts += ["## Later images on one thread\n", paragraph("""The camera turns by 7 degrees from image to
            image. An instruction set that the processor does not have is replaced by the next simpler
            one."""), _mapper_table(results)]
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, "speed", page)
