# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runParallel.py."""

import benchmarkText
from benchmarkText import number, paragraph, ratio, spread, table

PAGE = "parallel-study"


def relative_memory(case):
    """The share and the memory beside it, relative to the share: of the process and round with most."""
    return max(1 + one["extra"] / one["share"]
               for measured in case["rounds"] for one in measured["gtn"]["processes"])


def sent(case):
    """The bytes that all processes have sent."""
    return sum(one["sent"] for one in case["rounds"][0]["gtn"]["processes"])


def share(case):
    """The largest share."""
    return max(one["share"] for one in case["rounds"][0]["gtn"]["processes"])


def time_ratios(case):
    return [measured["gtn"]["seconds"] / measured["pvtu"]["seconds"] for measured in case["rounds"]]


def size_ratio(case):
    last = case["rounds"][-1]
    return last["pvtu"]["bytes"] / last["gtn"]["bytes"]


def compact(results):
    return [case for case in results["cases"] if case["partition"] == "compact"]


def _head(results):
    return """# Several processes write one file

How many bytes processes send each other, how much memory they need and how long they take, when they write
their parts of a mesh to one file with `vtkGatunWriter` ([guide](../large-meshes.md#several-processes)).
`Utilities/bench.sh --parallel` (Benchmarks/Studies/runParallel.py) writes this page. All results are in
[results.json](parallel-study/results.json).

""" + benchmarkText.machine(results)


def _memory(results):
    rows = []
    for case in results["cases"]:
        rows.append([case["processes"], case["partition"], number(share(case) / 2**20),
                     ratio(relative_memory(case)), number(sent(case) / 2**20),
                     f"{100 * sent(case) / (share(case) * case['processes']):.1f} %",
                     ratio(case["rounds"][-1]["gtn"]["bytes"] / results["bytes"])])
    return "## Memory and messages\n\n" + paragraph(f"""A {results["kind"]} mesh of
        {results["tets"]:,} tetrahedra with a field on its points. *Compact* parts are halves of halves
        along the longest axis; *scattered* ones have cells at random, the worst case, in which nearly
        all points are on boundaries. The share of a process is what its part takes in VTK. Memory is
        the share and what the process takes beside it at its peak, relative to the share, of the process
        and the round with most; the goal is 1.5 for compact parts. Messages are those of all processes,
        in MiB and relative to the mesh. One process sends nothing. Some memory of each thread does not
        depend on the share. The size
        of the file is relative to that of `gtn pack`. Each file was verified against the mesh.""") + \
        "\n" + table(["processes", "parts", "share, MiB", "memory / share", "sent, MiB", "sent / mesh",
                      "size / whole"], rows)


def _times(results):
    rows = []
    for case in results["cases"]:
        gtn, pvtu = ([measured[form]["seconds"] for measured in case["rounds"]]
                     for form in ("gtn", "pvtu"))
        rows.append([case["processes"], case["partition"], case["rounds"][0]["gtn"]["threads"],
                     spread(gtn), spread(pvtu), spread(time_ratios(case), ratio), ratio(size_ratio(case))])
    return "## Time\n\n" + paragraph("""The seconds of writing, from the first process that begins to the last
        one that has written, beside `vtkXMLPUnstructuredGridWriter` with zlib, which writes a file for
        each process with one thread. The parts are in memory before. The ratio of sizes tells how many
        times larger the `.pvtu` files are. More processes than processors take turns.""") + "\n" + table(
            ["processes", "parts", "threads each", ".gtn, s", ".pvtu, s", ".gtn / .pvtu",
             "size .pvtu / .gtn"], rows)


def page(results, _):
    return "\n".join(part.rstrip() + "\n" for part in (
        _head(results), _memory(results), _times(results)))


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page)
