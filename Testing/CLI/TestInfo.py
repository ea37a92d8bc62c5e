# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""info --json is JSON and agrees with the mesh; the text says the same."""

import json
import os
import re

from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter

from gatunCli import enter_folder, gtn, lattice, make_grid, standard_mesh, write

enter_folder("info")
grid = standard_mesh(6)
write(grid, "mesh.vtu")
gtn("pack", "-q", "--chunk-size", 200, "--keep-order", "cells", "mesh.vtu", "mesh.gtn")

info = json.loads(gtn("info", "--json", "-v", "mesh.gtn"))
assert info["tets"] == grid.GetNumberOfCells()
assert info["points"] == grid.GetNumberOfPoints()
assert info["coordinateType"] == "float32"
assert info["keptOrder"]["cells"] and not info["keptOrder"]["points"]
assert info["times"] == []
bounds = grid.GetBounds()
assert [x for pair in info["bounds"] for x in pair] == list(bounds)
assert [array["name"] for array in info["arrays"]] == [
    "pressure", "velocity", "mark", "material", "quality"
]
velocity = info["arrays"][1]
assert velocity["components"] == 3 and velocity["type"] == "float64"
for component in range(3):
    assert velocity["ranges"][component] == list(
        grid.GetPointData().GetArray("velocity").GetRange(component)
    )
assert info["chunks"] == len(info["chunkTable"]) > 1
assert sum(chunk["tets"] for chunk in info["chunkTable"]) == info["tets"]
sizes = info["sizes"]
parts = sum(part["bytes"] for name, part in sizes.items() if name != "file")
assert sizes["arrays"]["bytes"] == sum(array["bytes"] for array in info["arrays"])
assert parts == sizes["file"]["bytes"], (parts, sizes["file"]["bytes"])
with open("mesh.gtn", "rb") as file:
    assert len(file.read()) == sizes["file"]["bytes"]
assert abs(sizes["file"]["bitsPerCell"] - 8 * sizes["file"]["bytes"] / info["tets"]) < 1e-9
assert "chunkTable" not in json.loads(gtn("info", "--json", "mesh.gtn"))

text = gtn("info", "-v", "mesh.gtn")
for words in ("tetrahedra       1,296", "kept order       cells", "profile          fast", "\narrays\n", "\nchunks\n"):
    assert words in text, words

# What the file would take in the other profile. These are one piece.
for profile in "fast", "small":
    gtn("pack", "-q", "--profile", profile, "mesh.vtu", profile + ".gtn")
for name, other in ("fast.gtn", "small.gtn"), ("small.gtn", "fast.gtn"):
    info = json.loads(gtn("info", "-v", "--json", name))
    size = os.path.getsize(other)
    assert abs(info["otherProfileBytes"] - size) < 0.05 * size, (name, info["otherProfileBytes"], size)
assert json.loads(gtn("info", "--json", "small.gtn"))["profile"] == "small"

# A damaged file is described, but for what needs its values. The first streams are behind the header of 16 bytes.
with open("fast.gtn", "rb") as file:
    whole = bytearray(file.read())
whole[40:200] = bytes(160)
with open("damaged.gtn", "wb") as file:
    file.write(whole)
info = json.loads(gtn("info", "-v", "--json", "damaged.gtn"))
assert info["tets"] == grid.GetNumberOfCells() and info["otherProfileBytes"] is None, info
assert re.search(r"as small +unknown: .*damaged\.gtn", gtn("info", "-v", "damaged.gtn"))
assert re.search(r"\n  velocity +point  float64 +3 ", text), text

# Names with bytes that are no UTF-8, quotes and control characters: JSON all the same, in ASCII.
points, tets = lattice(2)
names = [b"p", b"quote\"back\\slash", b"tab\tbell\a", b"caf\xc3\xff"]
grid = make_grid(points, tets, {f"{i}": points[:, 0] / 3 for i in range(len(names))})
for i, name in enumerate(names):
    grid.GetPointData().GetArray(i).SetName(name)
writer = vtkUnstructuredGridWriter()
writer.SetInputData(grid)
writer.SetFileName("names.vtk")
writer.SetFileTypeToBinary()
assert writer.Write()
gtn("pack", "-q", "names.vtk", "names.gtn")
text = gtn("info", "--json", "names.gtn")
assert text.isascii()
arrays = json.loads(text)["arrays"]
assert len(arrays) == len(names) and arrays[1]["name"].encode() == names[1], arrays
# Numbers have all of their digits.
assert arrays[0]["ranges"] == [[float(x) for x in ((points[:, 0] / 3).min(), (points[:, 0] / 3).max())]]

# Members are sorted, so that the texts of two files can be compared line by line.
assert list(json.loads(text)) == sorted(json.loads(text))
