#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks which folders include which, and that no files include each other in a circle.

    Utilities/check_includes.py            prints what is wrong; exit code 1 if anything is
    Utilities/check_includes.py --graph    also prints the number of includes between folders

The folders of the core name what they may include in Module/<folder>/files.cmake. The other folders
are listed here. A header, its source and the header of its internals
count as one file.
"""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The order of the libraries and programs; each may include those before it that it names. CORE
# stands for all folders of the core.
CORE = "core"
LAYERS = {
    "IO/Bridge": [CORE],
    "Library": [CORE],
    "IO": [CORE, "IO/Bridge"],
    "Filters/TetGen": [CORE, "IO/Bridge"],
    "Filters": [CORE, "IO/Bridge", "IO"],
    "Rendering": [CORE, "IO/Bridge", "IO", "Filters"],
    "Programs/Text": [CORE],
    "Programs/Web": [CORE, "Programs/Text"],
    "Programs/Output": [CORE, "IO/Bridge", "IO", "Filters", "Rendering", "Programs/Text"],
    "Programs/Ranges": [CORE, "IO/Bridge", "IO", "Programs/Text"],
    "Programs/Input": [CORE, "IO/Bridge", "IO", "Filters", "Rendering", "Programs/Text",
                       "Programs/Output", "Programs/Ranges"],
    "Programs/Options": [CORE, "IO/Bridge", "IO", "Filters", "Rendering", "Programs/Text",
                         "Programs/Output", "Programs/Ranges", "Programs/Input"],
    "Programs/Compare": [CORE, "IO/Bridge", "IO", "Programs/Text"],
    "Programs": [CORE, "IO/Bridge", "IO", "Filters", "Filters/TetGen",
                 "Rendering",
                 "Programs/Text", "Programs/Web", "Programs/Output", "Programs/Ranges",
                 "Programs/Input", "Programs/Options", "Programs/Compare"],
    "paraview_plugin/Representations": [CORE, "IO/Bridge", "IO", "Filters", "Rendering"],
}

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def core_folders():
    """The folders of the core in order, each with those that it may include."""
    order = re.search(r"^foreach \(name IN ITEMS\s+([\w ]+)\)",
                      (ROOT / "Module/core.cmake").read_text(), re.MULTILINE).group(1).split()
    folders = {}
    for name in order:
        text = (ROOT / "Module" / name / "files.cmake").read_text()
        found = re.search(r"^  INCLUDES\n((?:    \w+\n)*)", text, re.MULTILINE)
        named = found.group(1).split() if found else []
        for other in named:
            if other not in folders:
                sys.exit(f"Module/{name}/files.cmake: {other} does not come before {name} "
                         "in Module/core.cmake")
        folders[name] = named
    return folders


def allowed_includes():
    """For each folder with sources, the set of folders that it may include."""
    core = core_folders()
    allowed = {f"Module/{name}": {f"Module/{other}" for other in named}
               for name, named in core.items()}
    before = set()
    for folder, named in LAYERS.items():
        allowed[folder] = set()
        for other in named:
            if other == CORE:
                allowed[folder] |= {f"Module/{name}" for name in core}
            elif other in before:
                allowed[folder].add(other)
            else:
                sys.exit(f"check_includes.py: {other} does not come before {folder}")
        before.add(folder)
    return allowed


def read_includes(folders):
    """For each source file below the folders, the files of ours that it includes."""
    files = {}
    for folder in folders:
        for path in sorted((ROOT / folder).glob("*")):
            if path.suffix in (".h", ".cxx", ".txx"):
                if path.name in files:
                    sys.exit(f"two files are called {path.name}: {path} and {files[path.name]}")
                files[path.name] = path
    return {path: [files[name] for name in INCLUDE.findall(path.read_text()) if name in files]
            for path in files.values()}


def unit_of(path):
    """The name that a header, its source and the header of its internals share."""
    return path.stem.removesuffix("Internals")


def find_circles(graph):
    """The strongly connected components of more than one node (Tarjan)."""
    index, low, stack, circles = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in graph.get(node, ()):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            circle = []
            while True:
                circle.append(stack.pop())
                if circle[-1] == node:
                    break
            if len(circle) > 1:
                circles.append(sorted(circle))

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return circles


def main():
    sys.setrecursionlimit(10000)
    allowed = allowed_includes()
    includes = read_includes(allowed)
    problems = []
    counts = collections.Counter()
    units = collections.defaultdict(set)
    for path, others in includes.items():
        folder = str(path.parent.relative_to(ROOT))
        for other in others:
            target = str(other.parent.relative_to(ROOT))
            if target != folder:
                counts[folder, target] += 1
                if target not in allowed[folder]:
                    problems.append(f"{path.relative_to(ROOT)}: {folder} must not include "
                                    f"{target} ({other.name})")
            unit, used = unit_of(path), unit_of(other)
            if unit != used:
                units[unit].add(used)
    for circle in find_circles(units):
        problems.append("these files include each other in a circle: " + ", ".join(circle))

    if "--graph" in sys.argv[1:]:
        for (folder, target), count in sorted(counts.items()):
            print(f"{folder} -> {target}: {count}")
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{len(includes)} files in {len(allowed)} folders, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
