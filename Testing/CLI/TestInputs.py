# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells that are not tetrahedra, structured grids, blocks and pieces are made fit, with a message;
other things are refused, with one."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_TETRA,
    VTK_QUAD,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkRectilinearGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
)

from gatunCli import enter_folder, gtn, standard_mesh, write

enter_folder("inputs")


def write_with(writer, data, name):
    writer.SetInputData(data)
    writer.SetFileName(name)
    assert writer.Write()


def round_trip(name, says, *options):
    gtn("pack", "-f", *options, name, name + ".gtn", says=says)
    gtn("verify", *options, name + ".gtn", name, says="identical")


image = vtkImageData()
image.SetDimensions(6, 5, 4)
heat = numpy_to_vtk(np.arange(120, dtype=np.float32), deep=True)
heat.SetName("heat")
image.GetPointData().SetScalars(heat)
write_with(vtkXMLImageDataWriter(), image, "image.vti")
round_trip("image.vti", "60 cells (60 vtkVoxel)")
round_trip("image.vti", "60 vtkVoxel were split", "--split-cells")

append = vtkAppendFilter()
append.AddInputData(image)
append.Update()
write(append.GetOutput(), "voxels.vtu")
round_trip("voxels.vtu", "60 cells (60 vtkVoxel)")

blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, standard_mesh(3))
blocks.SetBlock(1, standard_mesh(2))
write_with(vtkXMLMultiBlockDataWriter(), blocks, "blocks.vtm")
round_trip("blocks.vtm", "2 blocks were merged")

writer = vtkXMLPUnstructuredGridWriter()
writer.SetNumberOfPieces(1)
write_with(writer, standard_mesh(4), "pieces.pvtu")
round_trip("pieces.pvtu", "384 tetrahedra")


def grid_of(cell_type, points):
    grid = vtkUnstructuredGrid()
    vtk_points = vtkPoints()
    for point in points:
        vtk_points.InsertNextPoint(point)
    grid.SetPoints(vtk_points)
    grid.InsertNextCell(cell_type, len(points), range(len(points)))
    return grid


corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
middles = [(corners[i] + corners[j]) / 2 for i, j in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
write(grid_of(VTK_QUADRATIC_TETRA, [*corners, *middles]), "quadratic.vtu")
round_trip("quadratic.vtu", "1 cells (1 vtkQuadraticTetra)")
round_trip("quadratic.vtu", "without mid-edge points", "--split-cells")

write(grid_of(VTK_QUAD, corners), "quad.vtu")
round_trip("quad.vtu", "1 cells (1 vtkQuad)")
round_trip("quad.vtu", "1 vtkQuad are left out", "--split-cells")
sphere = vtkSphereSource()
sphere.Update()
write_with(vtkXMLPolyDataWriter(), sphere.GetOutput(), "sphere.vtp")
gtn("pack", "sphere.vtp", "sphere.gtn", says="vtkTriangle")
os.rename("sphere.vtp", "sphere.xyz")
gtn("pack", "sphere.xyz", "new.gtn", code=1, says="gtn: sphere.xyz: no reader")

# A point that does not exist.
wrong = standard_mesh(2)
wrong.GetCells().GetConnectivityArray().SetValue(5, 10**6)
write(wrong, "wrong.vtu")
gtn("pack", "wrong.vtu", "new.gtn", code=1, says="gtn: wrong.vtu: ")

# Offsets that lead beyond the connectivity, which VTK reads without a word.
LEGACY = """# vtk DataFile Version 5.1
offsets
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 float
0 0 0 1 0 0 0 1 0 0 0 1
CELLS {} 4
OFFSETS vtktypeint64
{}
CONNECTIVITY vtktypeint64
0 1 2 3
CELL_TYPES {}
{}
"""
for offsets, cell_type in (("4 8", 10), ("0 4 8", 10), ("0 -4", 10), ("0 800000000", 12)):
    cells = offsets.count(" ")
    with open("offsets.vtk", "w") as file:
        file.write(LEGACY.format(cells + 1, offsets, cells, f"{cell_type} " * cells))
    gtn("pack", "offsets.vtk", "new.gtn", code=1,
        says="gtn: offsets.vtk: the offsets of the cells do not fit")
