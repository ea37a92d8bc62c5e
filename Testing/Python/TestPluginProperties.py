# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The properties of gatun_paraview.py are those of the compiled plugin: kinds, defaults, ranges, widgets and words.
What differs on purpose is listed here, and has to differ.

Argument: the folder of the compiled plugin.
"""

import glob
import os
import sys
import xml.etree.ElementTree as tree

from gatun import _paraview_xml

MESH = ("FileName FileNameInfo PrefetchTimeSteps SimplificationNumberOfPoints SimplificationRMSError",
        "Level ExactRegion", "MemoryBudget SimplificationRatio LargeMesh IsOnDemand")
# Names of the compiled plugin's proxies; properties that are missing here, or added, and those with another text.
# FileName is that of one file of a series.
PAIRS = {
    "GatunReaderCore GatunReader": (_paraview_xml.READER, *MESH),
    "GatunSurfaceReaderCore GatunSurfaceReader": (_paraview_xml.READER, MESH[0], MESH[1] + " SplitCells", MESH[2]),
    "GatunHartleyReader": (_paraview_xml.VOLUME_READER, "BitsPerVoxel", "", ""),
    "GatunWriter": (
        _paraview_xml.WRITER,
        "SplitCells NumberOfPieces LayerComponent LayerSpacing WriteTimeSteps MinTimeStep MaxTimeStep TimeStepStride",
        "",
        "Input ChunkSize Hierarchy WriteBoundary LayerArray PointTolerance",
    ),
}
# How VTK is called and asked.
IGNORED = {"command", "clean_command", "si_class", "information_property", "repeat_command", "number_of_elements",
           "number_of_elements_per_command"}


def list_properties(root):
    return {node.get("name"): node for node in root if node.tag.endswith("Property")}


def describe(node):
    """What people see of a property, without its text."""
    attributes = {name: value for name, value in node.attrib.items() if name not in IGNORED}
    parts = [tree.tostring(part) for part in node if not part.tag.endswith(("Documentation", "Helper"))]
    return node.tag, attributes, sorted(tree.canonicalize(part, strip_text=True) for part in parts)


def find_text(node):
    return " ".join(node.findtext("Documentation").split())


proxies = {}
for path in glob.glob(os.path.join(sys.argv[1], "*.xml")):
    for proxy in tree.parse(path).iterfind("ProxyGroup/*"):
        proxies[proxy.get("name")] = proxy
problems = []


def compare(what, found, expected):
    if sorted(found) != sorted(expected.split()):
        problems.append(f"{what} are {sorted(found)}")


for names, (text, missing, added, other) in PAIRS.items():
    theirs = {}
    for name in names.split():
        theirs.update(list_properties(proxies.get(proxies[name].get("base_proxyname"), ())))
        theirs.update(list_properties(proxies[name]))
    mine = list_properties(tree.fromstring(f"<Proxy>{text}</Proxy>"))
    both = sorted(set(mine) & set(theirs))
    compare(f"{name}: missing", set(theirs) - set(mine), missing)
    compare(f"{name}: added", set(mine) - set(theirs), added)
    compare(f"{name}: with other texts", [p for p in both if find_text(mine[p]) != find_text(theirs[p])], other)
    for prop in both:
        if describe(mine[prop]) != describe(theirs[prop]):
            problems.append(f"{name}.{prop}: {describe(mine[prop])}, not {describe(theirs[prop])}")
assert not problems, "\n" + "\n".join(problems)
