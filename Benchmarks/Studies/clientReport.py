# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the study of ParaView's client."""

import statistics

import benchmarkText
from benchmarkText import number, paragraph, ratio, rounds_of, spread, table

PAGE = "client-study"
LABELS = {"vtu": "`.vtu`, zlib; \"Volume\"", "gtn": "`.gtn`; \"Gatun Volume\"",
          "gtn-boundary": "`.gtn` with its boundary; \"Gatun Volume\""}


def values(results, case, what):
    """By round."""
    return [measured[case][what] for measured in results["rounds"]]


def memory(results, case, what):
    """MiB above the client with an empty view, by round."""
    return [(measured[case][what] - measured["idle"]["idleBytes"]) / 2**20 for measured in results["rounds"]]


def ratios(results, case, what):
    return rounds_of(zip(values(results, "vtu", what), values(results, case, what)))


def memory_ratio(results, case):
    return statistics.median(memory(results, "vtu", "volumeBytes")) / statistics.median(
        memory(results, case, "volumeBytes"))


def _head(results):
    return "# ParaView's client\n\n" + paragraph("""Time from opening a file in ParaView's window to images, and the peak
        memory of the client ([guide](../guide/paraview.md)). `Utilities/bench.sh --client`
        (Benchmarks/Studies/runClient.py) writes this page. All results are in
        [results.json](client-study/results.json).""") + "\n" + benchmarkText.machine(results)


def _method(results):
    size = results["rounds"][0]["idle"]["viewSize"]
    loads = [measured["load"] for measured in results["rounds"]]
    return "## What is measured\n\n" + paragraph(f"""A structured grid of {results["tets"]:,} tetrahedra with one array. In
        each round, a client starts for each file, with ParaView's own settings, a view of {size[0]} x {size[1]} pixels and
        OpenGL in software. A script within the client does what File > Open and Apply do, and renders: the *first image*
        is what ParaView shows by itself. Then it chooses the representation of a volume and the array, and renders: the
        *first volume*. A *later image* is seen from another side, the median of three. Memory is the peak of the client
        above that of a client with an empty view. Files are in the page cache. The load average was
        {benchmarkText.span(loads)} when the rounds began.""")


def _table(results, what):
    cases = [case for case in LABELS if case in results["rounds"][0]]
    rows = []
    for case in cases:
        row = [LABELS[case], *(spread(values(results, case, name)) for name in what["seconds"]),
               *(spread(memory(results, case, name)) for name in what["bytes"])]
        for name in what["seconds"]:
            row.append("-" if case == "vtu" else spread(ratios(results, case, name), ratio))
        rows.append(row)
    return rows


def page(results, plots):
    del plots
    shown = ", ".join(f"{results['rounds'][0][case]['firstRepresentation']} for {case}" for case in LABELS
                      if case in results["rounds"][0])
    first = table(["file", "first image (s)", "peak memory (MiB)", "`.vtu` / ours"],
                  _table(results, {"seconds": ["firstSeconds"], "bytes": ["firstBytes"]}))
    volume = table(["file", "first volume (s)", "later images (s)", "peak memory (MiB)", "first volume, `.vtu` / ours",
                    "later images, `.vtu` / ours"],
                   _table(results, {"seconds": ["volumeSeconds", "laterSeconds"], "bytes": ["volumeBytes"]}))
    sizes = table(["file", "MB"], [(LABELS[case], f"{size / 1e6:,.1f}") for case, size in results["bytes"].items()])
    parts = (_head(results), _method(results),
             "## First image\n\n" + paragraph(f"""ParaView shows, by its names of representations: {shown}. A `.vtu` file is
                 read as a whole and its surface is extracted. A `.gtn` file of more than 5 million cells is read on
                 demand: without its boundary, the first image is an outline, which shows less.""") + "\n" + first,
             "## Volume\n\n" + paragraph("""ParaView's "Volume" and "Gatun Volume" interpret opacities differently, so the
                 images are alike, not equal.""") + "\n" + volume,
             "## Sizes\n\n" + sizes)
    return "\n".join(part.rstrip() + "\n" for part in parts)


def conclude(results):
    """The main result, for the page in front of the studies."""
    def middle(case, what):
        return statistics.median(ratios(results, case, what))
    return (f"From opening a file of {results['tets']:,} tetrahedra to the first volume, a `.gtn` file with its boundary takes "
            f"{number(statistics.median(values(results, 'gtn-boundary', 'volumeSeconds')))} s, "
            f"{ratio(middle('gtn-boundary', 'volumeSeconds'))} times as fast as a zlib `.vtu` file; the surface of the mesh "
            f"appears {ratio(middle('gtn-boundary', 'firstSeconds'))} times as fast. At its peak the client takes "
            f"{ratio(memory_ratio(results, 'gtn-boundary'))} times less memory.")


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page)
