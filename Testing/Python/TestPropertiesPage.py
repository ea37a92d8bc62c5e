# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Documentation/properties.md agrees with the classes, the Python functions, gtn and the plugin's XML.

Usage: TestPropertiesPage.py SOURCES GTN
"""

import glob
import inspect
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as tree

import gatun

sources, gtn = sys.argv[1:]
problems = []

IGNORED = {"Input", "InputConnection", "InputData"}  # no properties
# Tables whose objects have no single Get for a property.
METHODS = {"PointArrayStatus", "CellArrayStatus", "ArrayTolerance", "PointTolerance", "ArrayWeight",
           "Layers", "Value", "NumberOfContours", "DetailPolicy"}
MOST = {"vtkGatunReader": 15, "vtkGatunWriter": 18, "vtkGatunVolumeMapper": 13, "vtkGatunRayCaster": 13,
        "vtkGatunHartleyProjection": 13}


def tables():
    """(classes, rows) of each heading."""
    with open(os.path.join(sources, "Documentation", "properties.md"), encoding="utf-8") as file:
        parts = re.split(r"^## ", file.read(), flags=re.M)[1:]
    for part in parts:
        heading, body = part.split("\n", 1)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in body.splitlines() if line.startswith("|")]
        yield heading.split(", "), rows[2:]


def settable(kind):
    """Names of the properties that a class and its superclasses of Gatun have setters of."""
    names = set()
    for base in kind.__mro__:
        if base.__name__.startswith("vtkGatun"):
            names |= {name[3:] for name in vars(base) if name.startswith("Set")}
    names = {name for name in names if not re.search(r"To[A-Z]", name)
             or not any(name.startswith(other + "To") for other in names)}
    return {name for name in names if hasattr(kind, "Get" + name) or name in METHODS}


def parse(text, thing):
    """A default of the page as Python has it."""
    words = {"on": True, "off": False, "none": None}
    if text in words:
        return words[text]
    if text.isupper():
        return getattr(thing, text)
    numbers = tuple(float(word) for word in text.split(", "))
    return numbers if len(numbers) > 1 else numbers[0]


def options_of(*command):
    return set(re.findall(r"--[a-z-]+", subprocess.run(
        [gtn, *command, "--help"], capture_output=True, text=True, check=True).stdout))


options = set().union(*(options_of(*command.split()) for command in (
    "pack", "unpack", "render", "simplify", "contour", "mesh", "volume pack", "volume render", "info")))
parameters = {}
for function in gatun.read, gatun.write, gatun.File.read, gatun.File.render:
    parameters.update(inspect.signature(function).parameters)
xml = {}  # defaults by name
for path in glob.glob(os.path.join(sources, "paraview_plugin", "*.xml")):
    for node in tree.parse(path).iter():
        if node.tag.endswith("VectorProperty"):
            xml.setdefault(node.get("name"), set()).add(node.get("default_values"))


def check_default(where, thing, name, text):
    if text in ("all", "equal", "own", "global") or name in METHODS:
        return
    found = getattr(thing, "Get" + name)()
    wanted = parse(text, thing)
    found = found or None if wanted is None else found
    if isinstance(wanted, tuple) and isinstance(found, (tuple, list)):
        found = tuple(found)
    if found != wanted and (found == found or wanted == wanted):  # NaN
        problems.append(f"{where}: the default is {found}, not {text}")


def check_plugin(where, name, text, default):
    word, _, other = text.partition(" (")
    node = name if word == "same" else word
    if node not in xml:
        problems.append(f"{where}: ParaView has no {node}")
    elif other:
        wanted = {"on": "1", "off": "0"}.get(other[:-1], other[:-1])
        if wanted not in xml[node]:
            problems.append(f"{where}: ParaView has {xml[node]}, not {wanted}")
    elif default in ("on", "off") and not {"on": "1", "off": "0"}[default] in xml[node]:
        problems.append(f"{where}: ParaView has {xml[node]}, not {default}")


for classes, rows in tables():
    for name in classes:
        kind = getattr(gatun.vtk, name)
        listed = set()
        for names, values, default, python, program, plugin in rows:
            properties = names.split(", ")
            defaults = default.split(", ") if len(properties) > 1 and ", " in default else \
                [default] * len(properties)
            if "(grids)" in values and name != classes[0]:
                continue
            for one, its in zip(properties, defaults):
                where = f"{name}.{one}"
                listed.add(one)
                if not hasattr(kind, "Set" + one):
                    problems.append(f"{where}: there is none")
                    continue
                check_default(where, kind(), one, its)
                if python and python not in parameters:
                    problems.append(f"{where}: no parameter {python}")
                for option in re.findall(r"--[a-z-]+", program):
                    if option not in options:
                        problems.append(f"{where}: no option {option}")
                if plugin:
                    check_plugin(where, one, plugin, its)
        for one in sorted(settable(kind) - listed - IGNORED):
            problems.append(f"{name}.{one}: not in the table")
        if len(listed) > MOST.get(name, 99):
            problems.append(f"{name}: has {len(listed)} properties, more than {MOST[name]}")
assert not problems, "\n" + "\n".join(problems)
