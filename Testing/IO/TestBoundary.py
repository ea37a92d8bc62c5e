# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The boundary in a file is that which vtkDataSetSurfaceFilter finds in the mesh, with the values of
its points and of the cells behind its faces at all time steps. On demand, the reader gives it without
reading the mesh, in pieces, too, as simplified as the mesh, or as the memory budget asks for."""

import collections
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_LINE
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkCutter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import gatunCells as gc
import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect


def write(name, grid, **options):
    path = gm.temporary(name)
    gm.write(grid, path, WriteBoundary=True, **options)
    return path


def read(path, large=0, piece=0, pieces=1, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.SetLargeMesh(large)
    for option, value in options.items():
        getattr(reader, "Set" + option)(value)
    reader.UpdatePiece(piece, pieces, 0)
    assert reader.GetErrorCode() == 0
    return reader


def faces(data, arrays=True):
    """How often there is each cell, by the coordinates and values of its points and its values."""
    points = vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else []
    names = lambda of: sorted(
        of.GetArrayName(i) for i in range(of.GetNumberOfArrays() if arrays else 0))
    of_points, of_cells = (
        [vtk_to_numpy(of.GetArray(name)) for name in names(of)]
        for of in (data.GetPointData(), data.GetCellData()))
    keys = [tuple(value.tobytes() for value in [p] + [array[i] for array in of_points])
            for i, p in enumerate(points)]
    count = collections.Counter()
    for cell in range(data.GetNumberOfCells()):
        ids = data.GetCell(cell).GetPointIds()
        corners = [keys[ids.GetId(i)] for i in range(ids.GetNumberOfIds())]
        first = corners.index(min(corners)) if corners else 0
        corners = corners[first:] + corners[:first]  # the order shows what is outside
        count[tuple(corners), tuple(array[cell].tobytes() for array in of_cells)] += 1
    return count


def surface_of(grid):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def check(name, grid, **options):
    path = write(name, grid, **options)
    reader = read(path)
    output = reader.GetOutput()
    assert output.GetInformation().Get(key) == vtkGatunReader.ON_DEMAND_BOUNDARY
    expected = faces(surface_of(grid))
    assert faces(output) == expected, (name, output.GetNumberOfCells(), expected.total())
    together = collections.Counter()
    for piece in range(3):
        together += faces(read(path, piece=piece, pieces=3).GetOutput())
    assert together == expected, name
    assert read(path, -1).GetOutput().GetNumberOfCells() == grid.GetNumberOfCells()
    return path


key = vtkGatunReader.ON_DEMAND()

# Tetrahedra, in one chunk and in many, with a crack and a hole.
grid = gm.block(n=6)
path = check("boundary-tets.gtn", grid)
many = check("boundary-chunks.gtn", grid, ChunkSize=64, KeepOrder=7)
points, tets = gm.lattice(6)
centers = points[tets].mean(1)
crack = np.vstack([points, points])
upper = (centers[:, 2] > 0.5)[:, None] * len(points)
check("boundary-crack.gtn", gm.make_grid(crack, tets + upper), ChunkSize=100)
check("boundary-hole.gtn", gm.make_grid(points, tets[np.abs(centers - 0.5).max(1) > 0.2]),
      ChunkSize=64)
# Three cells at one face: it is no boundary.
check("boundary-fan.gtn", gm.make_grid(
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, -1], [1, 1, 2]], np.float32),
    [[0, 1, 2, 3], [0, 2, 1, 4], [0, 1, 2, 5]]))
# The same with cells in different chunks.
twice = np.random.default_rng(3).integers(0, len(tets), 300)
check("boundary-twice.gtn", gm.make_grid(points, np.concatenate([tets, tets[twice]])), ChunkSize=64)
check("boundary-nothing.gtn", vtkUnstructuredGrid())

# Cells of all linear types, of all dimensions, in chunks.
linear = [1, 2, 3, 4, 5, 7, 9, 10, 12, 13, 14, 42]
check("boundary-zoo.gtn", gc.zoo(linear, 20), ChunkSize=64)

# Its ranges are those of the mesh. What is selected is there. Global ids are ordinary arrays.
output = read(path).GetOutput()
whole = read(path, -1).GetOutput()
for name in ("point", "wave"):
    assert output.GetPointData().GetArray(name).GetRange() == \
        whole.GetPointData().GetArray(name).GetRange(), name
assert output.GetBounds() == whole.GetBounds()
reader = vtkGatunReader()
reader.SetFileName(path)
reader.SetLargeMesh(0)
reader.UpdateInformation()
reader.SetPointArrayStatus("wave", 0)
reader.Update()
assert not reader.GetOutput().GetPointData().HasArray("wave")
assert reader.GetOutput().GetPointData().HasArray("point")

# Nothing of the mesh is decoded; the budget decides.
big = gm.block(n=24)
path = write("boundary-big.gtn", big)
reader = read(path)
assert gm.statistic(reader, "BytesRead") < gm.statistic(read(path, -1), "BytesRead") / 2
small = read(path, MemoryBudget=0).GetOutput()
assert small.GetCellType(0) == VTK_LINE and small.GetNumberOfCells() == 12
assert small.GetInformation().Get(vtkGatunReader.ON_DEMAND()) == vtkGatunReader.ON_DEMAND_OUTLINE
reader.SetLargeMesh(-1)
reader.Update()
assert reader.GetOutput().GetNumberOfCells() == big.GetNumberOfCells()
reader.SetLargeMesh(0)
reader.Update()
assert reader.GetOutput().GetNumberOfCells() == 6 * 24 * 24 * 2

# With a hierarchy, the boundary is simplified as the mesh is: it is that of the simplified mesh. The cell
# behind a face may be another one.
points, tets = gm.lattice(12)
curved = gm.make_grid(points * (1 + 0.2 * np.sin(3 * points[:, [1, 2, 0]])), tets)
gm.add_array(curved.GetPointData(), np.sin(5 * points).sum(1), "wave")
path = write("boundary-tree.gtn", curved, Hierarchy=True, ChunkSize=300)
last = points_of_boundary = read(path).GetOutput().GetNumberOfPoints()
for error in (1e-4, 0.003, 0.02, 0.05):
    options = {"SimplificationRMSError": error}
    simple = read(path, -1, **options).GetOutput()
    output = read(path, **options).GetOutput()
    assert output.GetNumberOfPoints() < last, error
    last = output.GetNumberOfPoints()
    expected = surface_of(simple)
    for data in (output, expected):
        data.GetCellData().Initialize()
    assert faces(output) == faces(expected), (error, output.GetNumberOfCells())
    together = collections.Counter()
    for piece in range(2):
        part = read(path, piece=piece, pieces=2, **options).GetOutput()
        part.GetCellData().Initialize()
        together += faces(part)
    assert together == faces(expected), error
assert last < points_of_boundary / 4

# If the memory budget is too small for the boundary, it is simplified until it fits.
points, tets = gm.lattice(64)
path = write("boundary-budget.gtn", gm.make_grid(points, tets), Hierarchy=True)
assert read(path).GetOutput().GetNumberOfCells() == 12 * 64 * 64
limited = read(path, MemoryBudget=1).GetOutput()
assert limited.GetInformation().Get(key) == vtkGatunReader.ON_DEMAND_BOUNDARY
assert limited.GetActualMemorySize() <= 1.1 * 1024, limited.GetActualMemorySize()
assert limited.GetNumberOfCells() > 4000
assert limited.GetBounds() == (0, 1, 0, 1, 0, 1)
assert read(path, MemoryBudget=0).GetOutput().GetNumberOfCells() == 12

# Filters of VTK have something to show.
plane = vtkPlane()
plane.SetOrigin(0.5, 0.5, 0.52)
for stock in (vtkCutter(), vtkContourFilter()):
    stock.SetInputConnection(reader.GetOutputPort())
    if isinstance(stock, vtkCutter):
        stock.SetCutFunction(plane)
    else:
        stock.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        stock.SetValue(0, 1.5)
    stock.Update()
    assert stock.GetOutput().GetNumberOfLines() > 90, stock

# Time steps.
made = []
for step in range(3):
    grid = gm.make_grid(*gm.lattice(4))
    gm.add_array(grid.GetPointData(), np.sin(np.arange(125) + step), "moving")
    gm.add_array(grid.GetCellData(), np.arange(384) * (step + 1), "growing")
    made.append(grid)
path = gm.temporary("boundary-steps.gtn")
writer = vtkGatunWriter()
connect(writer, TimeSource(made.__getitem__, [0.0, 1.0, 2.5]))
writer.WriteAllTimeStepsOn()
writer.WriteBoundaryOn()
writer.SetFileName(path)
assert writer.Write() == 1
assert gm.statistic(writer, "BoundaryBytes") > 0
reader = read(path)
for step, time in [(0, 0.0), (2, 2.5), (1, 1.0)]:
    reader.UpdateTimeStep(time)
    assert faces(reader.GetOutput()) == faces(surface_of(made[step])), step

# What has none is refused, and nothing is left behind.
vtkObject.GlobalWarningDisplayOff()
writer = vtkGatunWriter()
writer.SetInputData(surface_of(made[0]))
writer.WriteBoundaryOn()
path = gm.temporary("boundary-refused.gtn")
writer.SetFileName(path)
assert writer.Write() == 0
assert not os.path.exists(path)
