# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""info --json is JSON and agrees with the mesh; the text says the same."""

import json

from gatunCli import enter_folder, gtn, standard_mesh, write

enter_folder("info")
grid = standard_mesh(6)
write(grid, "mesh.vtu")
gtn("pack", "-q", "--chunk", 200, "--keep-order", "cells", "mesh.vtu", "mesh.gtn")

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
parts += sum(array["bytes"] for array in info["arrays"])
assert parts == sizes["file"]["bytes"], (parts, sizes["file"]["bytes"])
with open("mesh.gtn", "rb") as file:
    assert len(file.read()) == sizes["file"]["bytes"]
assert abs(sizes["file"]["bitsPerTet"] - 8 * sizes["file"]["bytes"] / info["tets"]) < 1e-9
assert "chunkTable" not in json.loads(gtn("info", "--json", "mesh.gtn"))

text = gtn("info", "-v", "mesh.gtn")
for words in ("tetrahedra       1,296", "kept order       cells", "point velocity float64(3)", "chunks"):
    assert words in text, words
