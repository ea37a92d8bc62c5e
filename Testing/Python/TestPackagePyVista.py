# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""PyVista reads and saves files by the entry points of the package, also one that stands in for it."""

import importlib.metadata
import os
import pathlib
import sys
import types

import gatun
import numpy as np
from gatunCube import make_cube, require_raises
from TestHttp import Server

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
os.makedirs(folder, exist_ok=True)
path = os.path.join(folder, "mesh.gtn")
points, tets = make_cube(4)
mesh = gatun.from_numpy(points, tets, point_data={"a": points[:, 0]})

try:
    import pyvista
except ImportError:
    pyvista = None
    stand_in = types.ModuleType("pyvista")
    stand_in.wrap = lambda data: ("wrapped", data)
    sys.modules["pyvista"] = stand_in

found = importlib.metadata.distribution("gatun")
assert found.version == gatun.__version__
entries = {(entry.group, entry.name): entry.load() for entry in found.entry_points}
assert sorted(entries) == [
    (group, name) for group in ("pyvista.readers", "pyvista.writers") for name in (".ghv", ".gtn")
]
read, write = entries["pyvista.readers", ".gtn"], entries["pyvista.writers", ".gtn"]
for _ in range(2):  # the second time replaces the file, as all methods of PyVista do
    write(mesh, path, keep_order="all")
result = read(path, arrays="a")
if pyvista is None:
    kind, result = result
    assert kind == "wrapped"
assert result.GetNumberOfCells() == len(tets) and result.GetPointData().GetArray("a").GetValue(63) == 1
require_raises(TypeError, "colour", read, path, colour=1)
with Server(pathlib.Path(path).read_bytes()) as server:
    remote = read(server.url)
assert (remote if pyvista else remote[1]).GetNumberOfCells() == len(tets)

if pyvista is not None:
    pyvista.wrap(mesh).save(path)
    again = pyvista.read(path)
    assert isinstance(again, pyvista.UnstructuredGrid) and again.n_cells == len(tets)
    volume = pyvista.ImageData(dimensions=(8, 8, 8))
    volume.point_data["v"] = np.arange(512.0)
    volume.save(os.path.join(folder, "volume.ghv"))
    assert pyvista.read(os.path.join(folder, "volume.ghv")).dimensions == (8, 8, 8)
