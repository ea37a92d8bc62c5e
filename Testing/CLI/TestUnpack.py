# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""unpack writes .vtu with each compressor, and .vtk, with the arrays asked for."""

import os

from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

from gatunCli import enter_folder, gtn, read, standard_mesh, write

enter_folder("unpack")
write(standard_mesh(8), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")

sizes = {}
for compressor in ("none", "zlib", "lz4", "lzma"):
    name = compressor + ".vtu"
    gtn("unpack", "--compressor", compressor, "mesh.gtn", name, says="3,072 tetrahedra")
    gtn("verify", "mesh.gtn", name, says="identical")
    sizes[compressor] = os.path.getsize(name)
assert sizes["lzma"] < sizes["zlib"] < sizes["none"], sizes

gtn("unpack", "--arrays", "velocity,material", "mesh.gtn", "some.vtu")
grid = read("some.vtu")
assert grid.GetPointData().GetNumberOfArrays() == 1 and grid.GetPointData().HasArray("velocity")
assert grid.GetCellData().GetNumberOfArrays() == 1 and grid.GetCellData().HasArray("material")

assert gtn("unpack", "-q", "mesh.gtn", "mesh.vtk") == ""
reader = vtkUnstructuredGridReader()
reader.SetFileName("mesh.vtk")
reader.Update()
assert reader.GetOutput().GetNumberOfCells() == 3072

# Another format may be packed and compared as well.
gtn("pack", "-q", "mesh.vtk", "legacy.gtn")
gtn("verify", "legacy.gtn", "mesh.vtk", says="identical")
assert not [name for name in os.listdir(".") if name.count(".") > 1], "temporary files are left"
