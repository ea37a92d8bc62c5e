# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the study of arrays with a bounded error."""

import math
import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, ratio, span, table, verdict

PAGE = "errors-study"
QUOTED = (1e-2, 1e-3, 1e-4)
# What the project wants of geometric means of the best of SZ3 and zfp, by bound, of the worst component, and of
# rounding and xz at 1e-3: at least, and better.
GOALS = {1e-2: (2.8, 3.5), 1e-3: (2.2, 2.7), 1e-4: (2.0, 2.4)}
WORST_GOAL = (1.2, 1.4)
XZ_GOAL = (1.5, 1.9)


def components(results):
    """Each component with its mesh."""
    return [(mesh, row) for mesh in results["meshes"] for row in mesh["components"]]


def label(mesh, row):
    return f"{mesh['name']} {row['name']}" + (" (cells)" if row["where"] == "cell" else "")


def at(row, bound):
    return next(one for one in row["bounds"] if math.isclose(one["bound"], bound))


def bits(row, count):
    return 8 * count / row["values"]


def peer_bytes(one, *names):
    """The fewest bytes of some peers in any order, or None if none of them was there."""
    found = [peer["bytes"] for name, peer in one["peers"].items() if name.split(",")[0] in names]
    return min(found) if found else None


def peer_ratio(row, bound, *names):
    one = at(row, bound)
    best = peer_bytes(one, *names)
    return best / one["gtn"] if best else None


def ratios(results, bound, *names):
    """Sizes of the best of some peers over ours, with the names of the components."""
    found = [(peer_ratio(row, bound, *names), label(mesh, row)) for mesh, row in components(results)]
    return [one for one in found if one[0]]


def mean_ratio(results, bound, *names):
    values = [value for value, _ in ratios(results, bound, *names)]
    return statistics.geometric_mean(values) if values else None


def layer_ratios(results, fine):
    """The bytes of a coarse layer and a finer one over those of the fine bound alone."""
    return [one["layers"] / one["direct"] for mesh in results["meshes"] for one in mesh["layers"]
            if math.isclose(one["fine"], fine) and one["direct"] > 0]


def _power(bound):
    return f"1e{round(math.log10(bound))}"


def _head(results):
    return "# Arrays with a bounded error\n\n" + paragraph("""Bits a value of arrays whose error is at most a part of
        the range of their component ([guide](../array-errors.md)), beside those of other compressors.
        `Utilities/bench.sh --errors` (Benchmarks/Studies/runErrors.py) writes this page. All results are in
        [results.json](errors-study/results.json).""") + "\n" + benchmarkText.machine(results, "")


def _method():
    return "## What is measured\n\n" + paragraph("""Each component of each array of floating-point numbers, but
        constant ones and repetitions, is an array of its own. *Ours* are the bytes of the array in a `.gtn` file of
        the whole mesh with default settings: all its streams and its share of the tables. Connectivity and
        coordinates, from which Gatun predicts, are in that file anyway and do not count. `gtn verify` has proved
        the bounds of each file. Peers get the component as a one-dimensional array, in the order of the original
        file and in the order of the `.gtn` file, and the smaller result counts. SZ3 has its default algorithm and
        the absolute bound; zfp its fixed accuracy; *rounding* is to multiples of twice the bound, of which either the
        numbers or the values are compressed by xz (preset 9, extreme) or zlib (level 9), whichever is
        smaller. The orders of peers that are best are kept in no file of theirs: to have them in the order of
        the `.gtn` file takes Gatun first. `bluntfin_tets`, `comb_tets` and `fire_ug` were structured grids, on which
        SZ3 and zfp could predict along three axes; in an unstructured mesh they cannot know these.""")


def _goal_rows(results):
    rows = []

    def add(what, value, goal):
        if value:
            rows.append((what, ratio(value), ratio(goal[0]), ratio(goal[1]), verdict(value, goal)))
    for bound, goal in GOALS.items():
        add(f"best of SZ3 and zfp / ours at {_power(bound)}, geometric mean",
            mean_ratio(results, bound, "SZ3", "zfp"), goal)
    worst = [min(ratios(results, bound, "SZ3", "zfp"), default=None) for bound in GOALS]
    worst = [one for one in worst if one]
    if worst:
        add(f"the same, the worst component ({min(worst)[1]})", min(worst)[0], WORST_GOAL)
    add("rounding and xz / ours at 1e-3, geometric mean", mean_ratio(results, 1e-3, "xz"), XZ_GOAL)
    return rows


def _goals(results):
    rows = _goal_rows(results)
    return "## Goals\n\n" + table(["quantity", "measured", "goal", "target", "verdict"], rows)


def _rates(results, plots):
    text = "## Bits a value\n\n"
    text += image(plots, "rates", "Bits a value by bound", PAGE)
    text += "\n" + image(plots, "ratios", "Size of the best peer over ours, by component", PAGE)
    for bound in QUOTED:
        head = ["component", "values", "exact", "ours", "SZ3", "zfp", "rounding, xz", "rounding, zlib",
                "best of SZ3, zfp / ours", "rounding, xz / ours"]
        rows = []
        for mesh, row in components(results):
            one = at(row, bound)
            peers = [peer_bytes(one, name) for name in ("SZ3", "zfp", "xz", "zlib")]
            factors = [peer_ratio(row, bound, *names) for names in (("SZ3", "zfp"), ("xz",))]
            rows.append([f"`{label(mesh, row)}`", f"{row['values']:,}", number(bits(row, row["exact"])),
                         f"{bits(row, one['gtn']):.3f}"]
                        + [f"{bits(row, peer):.3f}" if peer else "-" for peer in peers]
                        + [ratio(factor) if factor else "-" for factor in factors])
        text += f"\n### Bound {_power(bound)}\n\n" + table(head, rows)
    return text


def _errors(results):
    """How much of their bounds peers take."""
    over = {}
    for _, row in components(results):
        for one in row["bounds"]:
            for name, peer in one["peers"].items():
                known = over.setdefault(name.split(",")[0], [0, 0.0, 0])
                known[0] += 1
                known[1] = max(known[1], peer["error"])
                known[2] += peer["error"] > 1
    rows = [(name, f"{worst:.6f}", f"{count} of {all_runs}") for name, (all_runs, worst, count) in over.items()]
    return "## Errors of the peers\n\n" + paragraph("""The largest error as a part of the bound, and the runs in
        which it is above 1: rounding to binary32 adds to it where the peer does not check. Results of such runs
        count all the same.""") + "\n" + table(["peer", "largest error", "runs above the bound"], rows)


def _layers(results):
    rows = [(f"{_power(coarse)}, then {_power(fine)}", ratio(statistics.geometric_mean(values)), span(values, ratio))
            for coarse, fine in sorted({(one["coarse"], one["fine"]) for mesh in results["meshes"]
                                        for one in mesh["layers"]})
            for values in [layer_ratios(results, fine)]]
    return "## Coarse values first\n\n" + paragraph("""A file whose values could be read first with a coarse bound and
        then refined would have to store two layers. Here the second one is an array of what the first one has
        left, with the fine bound. The table has the bytes of both layers over those of the fine bound
        alone.""") + "\n" + table(["bounds", "geometric mean", "range"], rows) + "\n" + paragraph(
            "So files have no coarse values first: that would cost more than a tenth of all bytes of the array."
            if all(statistics.geometric_mean(layer_ratios(results, fine)) > 1.1 for fine in (1e-3, 1e-4))
            else "Layers of that kind cost at most a tenth.")


def conclude(results):
    """The main result, for the page in front of the studies."""
    rows = _goal_rows(results)
    missed = [row[0] for row in rows if row[-1] == "not met"]
    means = "; ".join(f"{ratio(mean)} times at {_power(bound)}" for bound in QUOTED
                      for mean in [mean_ratio(results, bound, "SZ3", "zfp")] if mean)
    return (f"With a bound relative to the range, the best of SZ3 and zfp takes, on average over "
            f"{len(components(results))} components, {means} the bytes of a `.gtn` file; rounding and xz take "
            f"{ratio(mean_ratio(results, 1e-3, 'xz'))} times at 1e-3. "
            + ("All goals are met." if not missed else f"Goals that are not met: {', '.join(missed)}.")
            + " Layers of growing precision take "
            + f"{ratio(statistics.geometric_mean(layer_ratios(results, 1e-3)))} times the bytes of the finest one "
            + "alone, so there are none.")


def page(results, plots):
    parts = (_head(results), _method(), _goals(results), _rates(results, plots), _errors(results), _layers(results))
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "errorPlots")
