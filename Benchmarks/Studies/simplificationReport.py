# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page made of what runSimplification.py has measured."""

import statistics

from benchmarkText import machine, number, paragraph, picture, table

FOLDER = "simplification-study"


def did_nothing(mesh, i):
    """Whether VTK left the mesh as it was when it was asked for the i-th part."""
    return mesh["quadric"][i]["tets"] == mesh["compared"]["original"]["tets"]


def cases(mesh):
    """Percent, VTK and Gatun, of all parts for which VTK did something."""
    compared = mesh["compared"]
    return [(part, compared["quadric"][i], compared["gatun"][i])
            for i, part in enumerate(mesh["parts"]) if not did_nothing(mesh, i)]


def field_ratio(quadric, gatun):
    return gatun["rms"] / quadric["rms"]


def volume_error(mesh, compared):
    return abs(compared["volume"] / mesh["compared"]["original"]["volume"] - 1)


def memory(run):
    """MiB above the process with the mesh in it."""
    return (run["peak"] - run["before"]) / 2**20


def _small(value):
    return "0" if value == 0 else f"{value:.1e}" if value < 1e-3 else f"{value:.4f}"


def _who_wins(results):
    ratios = [(field_ratio(quadric, gatun), mesh["name"], part) for mesh in results["meshes"]
              for part, quadric, gatun in cases(mesh)]
    lost = [f"{name} at {part} % ({ratio:.2f})" for ratio, name, part in ratios if ratio >= 1]
    text = f"""By the root mean square error of the field, Gatun's meshes are better in
        {len(ratios) - len(lost)} of {len(ratios)} cases; on the geometric mean its error is
        {statistics.geometric_mean(ratio for ratio, _, _ in ratios):.2f} times VTK's."""
    if lost:
        text += f""" It is worse for {", ".join(lost)}. That is where the field is smooth. VTK
            moves points to where the error is least, and gives them new values; a merge leaves
            points and values as they are, which is why it can be stored and undone. Linear
            interpolation between the values of a smooth field is wrong in one direction over
            large parts, which new values even out."""
    return paragraph(text)


def _head(results):
    text = """# The study of simplification

How good the meshes are that Gatun makes coarser ([how](../simplification.md)), next to
`vtkUnstructuredGridQuadricDecimation`, VTK's own way (Vo et al. 2007), and Figures 18 and 19 of
C. Yang, *On-the-fly Processing of Compressed Volume Data*, dissertation proposal, Stony Brook, 2001, redone.
`Utilities/bench.sh --simplification` (Benchmarks/Studies/runSimplification.py) made this page;
every figure behind it is in [results.json](simplification-study/results.json).

""" + machine(results["machine"])
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small meshes: not to be quoted.**\n"
    rows = [[mesh["name"], f"{mesh['compared']['original']['tets']:,}",
             f"{mesh['compared']['original']['points']:,}", mesh["about"]]
            for mesh in results["meshes"]]
    return text + "\n" + table(["mesh", "tetrahedra", "points", "what"], rows)


def _field(results, pictures):
    rows = []
    for mesh in results["meshes"]:
        for part, quadric, gatun in cases(mesh):
            rows.append([mesh["name"], part, f"{quadric['tets']:,}", f"{gatun['tets']:,}",
                         _small(quadric["rms"]), _small(gatun["rms"]),
                         f"**{field_ratio(quadric, gatun):.2f}**", _small(quadric["largest"]),
                         _small(gatun["largest"]), f"{quadric['outside']:,}",
                         f"{gatun['outside']:,}"])
    text = "## The field\n\n" + _who_wins(results) + "\n" + paragraph(f"""VTK is asked for a part of
        the tetrahedra, Gatun then merges until there are as many as VTK left, or fewer. The error
        is that against the original mesh at {results["samples"]:,} places, evenly over its volume,
        as a part of the field's range. Places that are outside of the coarser mesh take the
        value of the nearest place on its boundary, and are counted. Of places in several
        tetrahedra, the first one counts.""") + "\n" + table(
            ["mesh", "%", "tets, VTK", "tets, Gatun", "RMS, VTK", "RMS, Gatun", "Gatun / VTK",
             "max, VTK", "max, Gatun", "outside, VTK", "outside, Gatun"], rows)
    nothing = [(mesh["name"], part, mesh["quadric"][i]["seconds"]) for mesh in results["meshes"]
               for i, part in enumerate(mesh["parts"]) if did_nothing(mesh, i)]
    if nothing:
        asked = ", ".join(f"{name} to {part} % ({number(seconds)} s)"
                          for name, part, seconds in nothing)
        text += "\n" + paragraph(f"""Asked for these, VTK gave back the mesh as it was, without
            a word: {asked}.""") + "\n" + table(
                ["mesh", "%", "tets, Gatun", "RMS, Gatun", "max, Gatun"],
                [[mesh["name"], part, f"{gatun['tets']:,}", _small(gatun["rms"]),
                  _small(gatun["largest"])]
                 for mesh in results["meshes"]
                 for i, (part, gatun) in enumerate(zip(mesh["parts"], mesh["compared"]["gatun"]))
                 if did_nothing(mesh, i)])
    return text + "\n" + picture(pictures, "field", "Error of the field by tetrahedra left", FOLDER)


def _shape(results):
    rows = []
    for mesh in results["meshes"]:
        for part, *ways in cases(mesh):
            row = [mesh["name"], part]
            for key in ("boundaryMean", "boundaryLargest"):
                row += [_small(way[key]) for way in ways]
            row += [_small(volume_error(mesh, way)) for way in ways]
            for key in ("worst", "firstPercentile", "median"):
                row += [_small(way[key]) for way in ways]
            row += [f"{way['inverted']} / {way['flat']}" for way in ways]
            rows.append(row)
    return "## Boundary and shape\n\n" + paragraph("""Pairs are VTK, Gatun. Distance of the
        original's boundary from the new one, mean and largest, as parts of the diagonal; change of the volume,
        as a part of it; mean ratio of the tetrahedra (1 is regular, 0 flat): the worst, that which
        1 % are below, the median; how many are inverted and how many flat. Gatun's cost
        function does not ask for good shapes, which shows; it turns nothing over.""") + "\n" + (
        table(
            ["mesh", "%", "mean", "", "largest", "", "volume", "", "worst", "", "1 %", "", "median",
             "", "inverted / flat", ""], rows))


def _speed(results):
    rows = []
    for mesh in results["meshes"]:
        tets = mesh["compared"]["original"]["tets"]
        build = statistics.median(mesh["build"]["seconds"])
        rows.append([mesh["name"], f"{tets:,}", number(build), f"{tets / build / 1e6:.3f}",
                     number(memory(mesh["build"])), number(mesh["gatun"]["seconds"]),
                     number(memory(mesh["gatun"])),
                     ", ".join(number(run["seconds"]) for run in mesh["gatun"]["meshes"]),
                     ", ".join(number(run["seconds"]) for run in mesh["quadric"]),
                     number(max(memory(run) for run in mesh["quadric"]))])
    return "## Time and memory\n\n" + paragraph("""One thread. Gatun finds all merges once
        (`gatun::BuildMergeTree`; the filter `vtkGatunSimplify` converts and copies besides); then
        each mesh is a matter of one pass. VTK starts anew for each. Seconds, and MiB above those of the
        process with the mesh in it. Meshes in the order of the table above: 50 %, and so
        on.""") + (
            "\n" + table(["mesh", "tetrahedra", "merges, s", "M tets/s", "MiB", "filter, s", "MiB",
                          "then each mesh, s", "VTK, each mesh, s", "MiB"], rows))


def _pictures(results, pictures):
    if "pictures" not in results:
        return ""
    shown = results["pictures"]
    rows = []
    for part, gatun, quadric in zip(shown["parts"], shown["gatun"], shown["quadric"]):
        rows.append([part, f"{quadric['tets']:,}", f"{gatun['tets']:,}", _small(quadric["rms"]),
                     _small(gatun["rms"]), _small(quadric["largest"]), _small(gatun["largest"])])
    times = [["100", f"{shown['original']['tets']:,}",
              *(number(1000 * statistics.median(shown["original"][kind]))
                for kind in ("volumeSeconds", "areaSeconds"))]]
    for part, gatun in zip(shown["parts"], shown["gatun"]):
        times.append([part, f"{gatun['tets']:,}",
                      *(number(1000 * statistics.median(gatun[kind]))
                        for kind in ("volumeSeconds", "areaSeconds"))])
    size = f"{shown['size']} x {shown['size']}"
    gain = {kind: statistics.median(shown["original"][kind]) /
            statistics.median(shown["gatun"][-1][kind])
            for kind in ("volumeSeconds", "areaSeconds")}
    return f"## Pictures ({shown['name']})\n\n" + picture(
        pictures, "pictures", "The original and simplified meshes, as volumes", FOLDER) + "\n" + (
            "### How far from the picture of the original (Figure 19)\n\n") + paragraph(f"""Root
        mean square and largest difference of the colours, 0 to 1, from the picture of the whole mesh,
        {size}, over the pixels that either covers. The paper has this for Gatun's way only, by
        points merged, and finds it "minimal" but for very aggressive ratios.""") + "\n" + table(
            ["% of tets", "tets, VTK", "tets, Gatun", "RMS, VTK", "RMS, Gatun", "max, VTK",
             "max, Gatun"], rows) + "\n" + picture(
                 pictures, "figure19", "Difference of pictures", FOLDER) + (
            "\n### Samples in volumes or at areas (Figure 18)\n\n") + paragraph(f"""The paper draws
        with samples at even distances ("volume-based") and with one for all that a tetrahedron has
        of a ray ("area-based"), and is surprised that the first gains from simplification too. So it
        does here: at {shown["parts"][-1]} % of the tetrahedra, volumes are drawn
        {gain["volumeSeconds"]:.1f} times as fast as the whole mesh, areas {gain["areaSeconds"]:.1f}
        times. `vtkGatunRayCaster`, all processors, {size}; milliseconds, everything included,
        medians.""") + "\n" + table(
            ["% of tets", "tetrahedra", "volume, ms", "area, ms"], times) + "\n" + picture(
                pictures, "figure18", "Time to draw by tetrahedra left", FOLDER)


def simplify_share(run):
    """How much of the time, from file to picture, goes into simplifying."""
    staged = run["staged"]
    return staged["simplify"] / staged["seconds"]


def _integrated(results, pictures):
    if "integrated" not in results:
        return ""
    shown = results["integrated"]
    rows = []
    for run in shown["runs"]:
        ways = [run[way] for way in ("staged", "integrated", "levels")]
        rows.append([f"{run['ratio']:g}", f"{run['integrated']['tets']:,.0f}",
                     *(number(run["staged"][stage]) for stage in ("decompress", "simplify", "render")),
                     *(number(way["seconds"]) for way in ways),
                     *(number(memory(way)) for way in ways)])
    shares = [f"{100 * simplify_share(run):.0f}" for run in shown["runs"] if run["ratio"] > 0]
    plain = shown["runs"][0]["integrated"]["seconds"]
    size = f"{shown['size']} x {shown['size']}"
    return f"## All in one ({shown['name']}, Figure 17)\n\n" + paragraph(f"""From a `.gtn` file with a
        hierarchy to the picture of a simplified mesh, {size}, all processors, in a process of its own: seconds,
        and MiB at most above those before. *Staged*: the mesh is decompressed into a grid
        (`vtkGatunReader`), simplified by the file's merges, and drawn. *Integrated*: chunks are
        simplified as they are decoded, and freed once they are drawn (`vtkGatunRayCaster`), with nothing
        kept. *With base meshes*: the same of a file that has them
        ({shown['bytes']['levels'] / 2**20:.1f} MiB in place of
        {shown['bytes']['tree'] / 2**20:.1f}).""") + "\n" + table(
            ["ratio", "tetrahedra", "decompress", "simplify", "draw", "staged", "integrated",
             "with base meshes", "MiB, staged", "integrated", "with base meshes"], rows) + "\n" + (
            paragraph(f"""Simplifying takes {", ".join(shares)} % of the staged time; the paper says less
        than 5 %. Without any simplification the integrated way takes {number(plain)} s.""")) + (
            "\n" + picture(pictures, "figure17", "Seconds from file to picture", FOLDER))


def write(results, out):
    """Writes simplification-study.md, and plots where matplotlib is there."""
    try:
        import simplificationPlots
        pictures = simplificationPlots.draw(results, out / FOLDER)
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no plots.")
        pictures = set()
    page = [_head(results), _field(results, pictures), _shape(results), _speed(results),
            _pictures(results, pictures), _integrated(results, pictures)]
    (out / "simplification-study.md").write_text(
        "\n".join(part.rstrip() + "\n" for part in page if part), encoding="utf-8")
