# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page reliability.md, from the results of Utilities/soak/soak.py."""

import collections

from benchmarkText import paragraph, table

GOAL = 1000000  # executions of each parser

KINDS = {
    "mutations": ("Damaged files", """Valid files of all kinds are damaged: their bytes, or what is in their
        sections and streams, with checksums that are right again. Some commands of `gtn` and the readers of
        a VTK program then get them, with limited memory. There must be a result, or a message."""),
    "kill": ("Killed while writing", """`gtn` is killed at a random time while it writes a file: whole, with
        levels, layers and a boundary, with bounded errors, in pieces, with moving points, with changing
        meshes, a surface, a volume, a `.vtu`. The file of before, if any, must still be there, or the new one
        must be whole. If an old file is replaced, the whole new one can be left under the name
        `NAME.part-XXXXXX`. The unfinished file of a VTK writer can be left under a temporary name."""),
    "full disk": ("No room, no permission", """The same on small file systems and with few files, with
        limits of the size of a file (a write that fails, or the signal SIGXFSZ), and in a folder of another
        user. What was there must stay, and nothing else may be left."""),
    "two writers": ("Two writers", """Two processes write different files of one name at the same time, while
        another one reads it. The file must be one of the two or the one of before at all times, and nothing
        else may be left."""),
    "changed while open": ("Changed while open", """A process truncates, overwrites, replaces and deletes a
        file while another one reads it whole, in pieces, step by step and simplified, draws it, contours it
        and unpacks it. Each result must be that of one of the whole files, or there must be an error; once
        the file is whole again, so must be the result."""),
    "opens": ("Many opens", """One process opens good and damaged files ten thousand times and reads some of
        each. It must have as many open descriptors and about as much memory at the end as after the first
        tenth."""),
    "asan-ubsan": ("AddressSanitizer and UndefinedBehaviorSanitizer", "All tests of the build with these."),
    "tsan": ("ThreadSanitizer", """All tests of the build with it, but those of the core
        that damage thousands of files."""),
}


def add_up(runs):
    """Counts by kind and name, over all runs. Largest values are not sums."""
    total = {}
    for run in runs:
        for kind, parts in run["kinds"].items():
            for name, counts in parts.items():
                sums = total.setdefault(kind, {}).setdefault(name, collections.Counter())
                for key, count in counts.items():
                    is_largest = key == "coverage" or key.startswith("growth")
                    sums[key] = max(sums[key], count) if is_largest else sums[key] + count
    return total


def runs_table(runs):
    return table(
        ["run", "started", "commit", "minutes", "processes", "load, mean (range)", "findings"],
        [[number, run["date"], run["commit"], f"{run['minutes']:.0f}", run["jobs"],
          "{mean:.1f} ({least:.1f} to {most:.1f})".format(**run["load"]) if run["load"] else "-",
          len(run["findings"])] for number, run in enumerate(runs, 1)])


def fuzz_part(targets):
    slow = [name for name, counts in targets.items() if counts["executions"] < GOAL]
    total = sum(counts["executions"] for counts in targets.values())
    yield "## Fuzzing\n"
    yield paragraph(f"""libFuzzer with AddressSanitizer and UndefinedBehaviorSanitizer
        ([targets](testing.md#fuzzing)), {total:,} executions in all. Inputs that are executed again at the
        beginning of a slice of time are not counted. """ + (
            f"Not at a million executions: {', '.join(slow)}." if slow else
            "Every target has reached a million."))
    yield table(["target", "executions", "seconds", "executions per second", "coverage (edges)"],
                [[name, f"{counts['executions']:,}", f"{counts['seconds']:,.0f}",
                  f"{counts['executions'] / max(counts['seconds'], 1):,.0f}", counts["coverage"]]
                 for name, counts in sorted(targets.items())])


def kind_part(kind, counts):
    title, text = KINDS[kind]
    yield f"## {title}\n"
    yield paragraph(text)
    rows = [[name, f"{count:,}"] for name, count in counts.items() if name != "seconds"]
    yield table(["what", "count"], [*rows, ["seconds", f"{counts['seconds']:,.0f}"]])


def findings_part(results):
    found = [(number, finding) for number, run in enumerate(results["runs"], 1)
             for finding in run["findings"]]
    known = results.get("repairs", [])
    if not found and not known:
        return
    yield "## Findings\n"
    if found:
        yield table(["run", "kind", "finding"],
                    [[number, one["kind"], " ".join(one["what"].split())] for number, one in found])
    for one in known:
        yield paragraph(f"*{one['what']}* {one['repair']}")


def page(results):
    runs = results["runs"]
    last = runs[-1]
    minutes = sum(run["minutes"] for run in runs)
    findings = sum(len(run["findings"]) for run in runs)
    parts = ["""# Reliability

The last results of `Utilities/setup.sh soak` (Utilities/soak), which tries everything that may go wrong with
a file: damage, lack of memory, room and permission, sudden ends, and other programs. `soak` replaces these
results, and `soak --add` adds to them. All counts are in [results.json](reliability/results.json).
""", paragraph(f"""*Machine:* {last["processor"]}, {last["processors"]} processors,
        {last["memory"] / 2**30:.1f} GiB; {last["system"]}, Linux {last["kernel"]}; {last["gcc"]};
        {last["clang"]}; {last["gatun"]}."""),
             paragraph(f"""{minutes:.0f} minutes in {len(runs)} run{"s" if len(runs) > 1 else ""},
        {findings or "no"} finding{"" if findings == 1 else "s"}.""" + "".join(
            " " + note for note in results.get("notes", []))), runs_table(runs)]
    total = add_up(runs)
    parts += findings_part(results)
    if "fuzz" in total:
        parts += fuzz_part(total["fuzz"])
    for kind in KINDS:
        if kind in total:
            parts += kind_part(kind, total[kind]["all"])
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    (out / "reliability.md").write_text(page(results), encoding="utf-8")
