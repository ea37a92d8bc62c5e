# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runParts.py."""

import benchmarkText
from benchmarkText import number, paragraph, ratio, table

PAGE = "parts-study"


def _head(results):
    return """# Meshes larger than memory

How long it takes and how much memory it needs to pack a mesh piece by piece
([guide](../large-meshes.md)), and to use the file afterwards. `Utilities/bench.sh --parts`
(Benchmarks/Studies/runParts.py) writes this page. All results are in
[results.json](parts-study/results.json).

""" + benchmarkText.machine(results)


def _large(results):
    rows = []
    for mesh in results["large"]:
        for step in mesh["steps"]:
            if "why" in step:
                rows.append([step["what"], "", "", "", step["why"]])
                continue
            rows.append([step["what"], number(step["seconds"]),
                         number(mesh["tets"] / 1e6 / step["seconds"]), number(step["peak"] / 2**20),
                         number(8 * mesh["bytes"] / mesh["tets"]) if step is mesh["steps"][0] else ""])
    return "## With little memory\n\n" + paragraph(f"""A box of jittered tetrahedra with a field of
        type `float` on its points, made piece by piece and never whole. Packing has
        {results["limits"][0]} MiB, in which the program that makes the pieces is included; the other
        commands of `gtn` have {results["limits"][1]} MiB (limited by {results["limiter"]}). *Verify*
        decodes everything. Images have 1024 x 768 pixels.""") + "\n" + table(
            ["step", "seconds", "M tets/s", "peak, MiB", "bits a tetrahedron"], rows)


def _compared(results):
    whole = results["compared"][0]
    rows = [[one["pieces"], one["chunks"], f"{8 * one['bytes'] / one['tets']:.3f}",
             ratio(one["bytes"] / whole["bytes"]), number(one["seconds"]), number(one["peak"] / 2**20)]
            for one in results["compared"]]
    return "## Beside packing as a whole\n\n" + paragraph(f"""The same of {whole["tets"]:,}
        tetrahedra. One piece is the whole mesh.""") + "\n" + table(
            ["pieces", "chunks", "bits a tetrahedron", "size / whole", "seconds", "peak, MiB"], rows)


def _divided(results):
    if "divided" not in results:
        return ""
    divided = results["divided"]
    rows = [[step["what"], "", "", step["why"]] if "why" in step else
            [step["what"], number(step["seconds"]), number(step["peak"] / 2**20),
             f"{8 * step['bytes'] / step['tets']:.3f}"] for step in divided["steps"]]
    return "## One file\n\n" + paragraph(f"""The same in one raw `.vtu` file of
        {number(divided["rawBytes"] / 2**20)} MiB, with points and cells in a scattered order, packed by
        `gtn pack --memory` in {results["limits"][0]} MiB and as a whole without a limit.""") + "\n" + table(
            ["packed", "seconds", "peak, MiB", "bits a tetrahedron"], rows)


def page(results, _):
    parts = (_head(results), _large(results), _compared(results), _divided(results))
    return "\n".join(part.rstrip() + "\n" for part in parts if part)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page)
