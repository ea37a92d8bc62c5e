# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells that are not tetrahedra, structured grids, blocks and pieces are made fit, with a message;
other things are refused, with one."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkConstants import VTK_FLOAT
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
    vtkXMLRectilinearGridWriter,
)

from gatunCli import enter_folder, gtn, read, standard_mesh, write

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

# Points of images and of coordinates along axes are as exact as their source: places of a map, a decimeter apart.
far = vtkImageData()
far.SetDimensions(5, 5, 5)
far.SetOrigin(500000, 4000000, 0)
far.SetSpacing(0.1, 0.1, 0.1)
axes = [500000 + 0.1 * np.arange(5), 4000000 + 0.1 * np.arange(5), 0.1 * np.arange(5)]
rectilinear = vtkRectilinearGrid()
rectilinear.SetDimensions(5, 5, 5)
for axis, values in zip("XYZ", axes):
    getattr(rectilinear, f"Set{axis}Coordinates")(numpy_to_vtk(values, deep=True))
write_with(vtkXMLImageDataWriter(), far, "far.vti")
write_with(vtkXMLRectilinearGridWriter(), rectilinear, "far.vtr")
for name, source in (("far.vti", far), ("far.vtr", rectilinear)):
    round_trip(name, "125 points")
    gtn("unpack", "-f", name + ".gtn", "far.vtu")
    back = read("far.vtu")
    places = {back.GetPoint(i) for i in range(back.GetNumberOfPoints())}
    assert places == {source.GetPoint(i) for i in range(125)} and len(places) == 125, name
single = vtkRectilinearGrid()
single.SetDimensions(5, 5, 5)
for axis, values in zip("XYZ", axes):
    getattr(single, f"Set{axis}Coordinates")(numpy_to_vtk(values.astype(np.float32), deep=True))
write_with(vtkXMLRectilinearGridWriter(), single, "single.vtr")
gtn("pack", "-f", "single.vtr", "single.gtn")
gtn("unpack", "-f", "single.gtn", "single.vtu")
assert read("single.vtu").GetPoints().GetDataType() == VTK_FLOAT

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
