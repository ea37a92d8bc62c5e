# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The goals of the project, and whether the results meet them."""

import statistics

import benchmarkReport
import renderingReport


def _find(results, name, order="permuted"):
    return [one for one in results["inputs"] if one["name"] == name and one["order"] == order]


def _prefixed(results, prefix):
    return [one for one in results["inputs"]
            if one["name"].startswith(prefix) and one["name"].endswith("-density")]


def _bits(inputs, part="file"):
    """The most bits for each tetrahedron."""
    return max((8 * one["size"]["parts"][part] / one["size"]["tets"] for one in inputs),
               default=None)


def _vtu(inputs):
    """The sizes of zlib and of the best LZMA files, as text."""
    texts = []
    for one in inputs:
        files = benchmarkReport.by_format(one["size"])
        tets = one["size"]["tets"]
        texts.append(" / ".join(f"{8 * files[name]['bytes'] / tets:.0f}"
                                for name in ("vtu-zlib", "vtu-lzma-best")))
    return "zlib / best LZMA .vtu " + ", ".join(texts) if texts else "-"


def _load_ratio(results):
    ratios = [statistics.median(benchmarkReport.ratios(load, "vtu-zlib")) for one in results["inputs"]
              for load in one.get("load", []) if load["threads"] == 2]
    return min(ratios, default=None)


def _big_peer(results):
    memory = renderingReport.big_image_memory(results, "vtu-zlib")
    return "-" if memory is None else f"{memory:,.0f}, zlib .vtu and Bunyk's mapper"


def goal(what, unit, peer, value, must, moonshot, more_is_better=False):
    if value is None:
        verdict = "-"
    else:
        sign = -1 if more_is_better else 1
        if sign * value <= sign * moonshot:
            verdict = "target met"
        elif sign * value <= sign * must:
            verdict = "met"
        else:
            verdict = "**not met**"
    return {"what": what, "unit": unit, "peer": peer, "value": value, "must": must,
            "moonshot": moonshot, "verdict": verdict}


def judge(results):
    delaunay = _find(results, "delaunay")
    comb = _prefixed(results, "comb")
    fin = _prefixed(results, "bluntfin")
    split = _find(results, "flow") + _find(results, "big") + comb + fin
    literature = "published coders 1.7 to 2.4"
    return [
        goal("size, Delaunay mesh and one float array", "bits/tet", _vtu(delaunay),
             _bits(delaunay), 16.5, 14),
        goal("size, combustion chamber and Density", "bits/tet", _vtu(comb), _bits(comb), 14, 12),
        goal("size, blunt fin and Density", "bits/tet", _vtu(fin), _bits(fin), 6.5, 4.5),
        goal("connectivity, hexahedra split into five", "bits/tet", literature,
             _bits(split, "connectivity"), 0.25, 0.1),
        goal("connectivity, Delaunay mesh", "bits/tet", literature,
             _bits(delaunay, "connectivity"), 1.0, 0.6),
        goal("loading with 2 threads, speed relative to VTK's zlib .vtu reader", "times", "1",
             _load_ratio(results), 0.8, 1.5, more_is_better=True),
        goal("mapper, later frames, 512 and 1024 pixels wide, one thread, speed relative to "
             "Bunyk's mapper", "times", "1", renderingReport.slowest_later_ratio(results), 5, 10,
             more_is_better=True),
        goal("file to first image, Delaunay mesh, 512 pixels wide, 2 threads, speed relative to "
             ".vtu and Bunyk's mapper", "times", "1",
             renderingReport.delaunay_image_ratio(results), 8, 15, more_is_better=True),
        goal("memory above an idle process for an image of 5 million tetrahedra from their file, "
             "1024 pixels wide, MemoryBudget 0", "MiB", _big_peer(results),
             renderingReport.big_image_memory(results), 150, 64),
    ]
