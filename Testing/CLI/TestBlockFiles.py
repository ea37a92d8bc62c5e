# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Blocks in files of their own are packed block by block, and the file is that of all blocks at once:
the same points, cells and values, and the same blocks when it is split."""

import json
import os
import shutil

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, vtkCompositeDataSet, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSet, vtkPartitionedDataSetCollection,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPartitionedDataSetCollectionWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

from gatun.vtk import vtkGatunReader, vtkGatunSplitBlocks
from gatunCli import add_text, enter_folder, gtn, lattice, make_grid, write

enter_folder("block-files")
NAME = vtkCompositeDataSet.NAME()


def cube(n, at, dtype=np.float32, **arrays):
    """A cube of tetrahedra with arrays of points by name."""
    points, tets = lattice(n, dtype=dtype)
    points = points + np.array([at, 0, 0], dtype)
    grid = make_grid(points, tets, {name: make(points) for name, make in arrays.items()},
                     {"volume": np.arange(len(tets), dtype=np.float32)})
    return grid


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)
    return array


first = cube(3, 0, pressure=lambda p: p[:, 0], place=lambda p: p)
first.GetPointData().SetActiveScalars("pressure")
add_text(first, "remark", ["of the first"])
second = cube(4, 3, np.float64, pressure=lambda p: p[:, 0].astype(np.int32))  # another type
third = cube(2, 7, place=lambda p: p)
loose = vtkUnstructuredGrid()  # with points that no cell uses
points = vtkPoints()
points.SetData(numpy_to_vtk(np.random.default_rng(1).random((20, 3)).astype(np.float32), deep=True))
loose.SetPoints(points)
loose.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
add(loose.GetPointData(), "pressure", np.arange(20, dtype=np.float32))
add(loose.GetCellData(), "BlockId", np.array([7], np.int16))  # a name that has a meaning
sphere = vtkSphereSource()
sphere.Update()
empty = make_grid(np.zeros((0, 3), np.float32), np.zeros((0, 4), np.int64), {"gone": np.zeros(0)})

nested = vtkMultiBlockDataSet()
nested.SetBlock(0, second)
nested.GetMetaData(0).Set(NAME, "wing")
nested.SetBlock(3, sphere.GetOutput())
nested.SetBlock(4, empty)
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, first)
blocks.GetMetaData(0).Set(NAME, "body")
blocks.SetBlock(1, nested)
blocks.SetBlock(2, third)
blocks.SetBlock(3, loose)


def write_blocks(data, name):
    writer = vtkXMLMultiBlockDataWriter() if name.endswith("vtm") else \
        vtkXMLPartitionedDataSetCollectionWriter()
    writer.SetInputData(data)
    writer.SetFileName(name)
    assert writer.Write()


def described(file):
    """What the file is, and what the blocks are that it is split into."""
    reader = vtkGatunReader()
    reader.SetFileName(file)
    split = vtkGatunSplitBlocks()
    split.SetInputConnection(reader.GetOutputPort())
    split.Update()
    grid, parts = reader.GetOutput(), split.GetOutput()
    text = []
    for data in (grid.GetPointData(), grid.GetCellData()):
        text += sorted((data.GetArray(i).GetName(), data.GetArray(i).GetDataTypeAsString(),
                        data.GetArray(i).GetNumberOfComponents())
                       for i in range(data.GetNumberOfArrays()))
    text.append(grid.GetPoints().GetData().GetDataTypeAsString())
    field = grid.GetFieldData()
    text += sorted((field.GetAbstractArray(i).GetName(),
                    str([field.GetAbstractArray(i).GetVariantValue(k).ToString()
                         for k in range(field.GetAbstractArray(i).GetNumberOfValues())]))
                   for i in range(field.GetNumberOfArrays()))
    for i in range(parts.GetNumberOfPartitionedDataSets()):
        block = parts.GetPartition(i, 0)
        scalars = block.GetPointData().GetScalars()
        text.append((parts.GetMetaData(i).Get(NAME), block.GetNumberOfPoints(),
                     block.GetNumberOfCells(), scalars.GetName() if scalars else None,
                     [np.round(np.sort(vtk_to_numpy(block.GetPointData().GetArray(k)), axis=None), 5)
                      .tolist() for k in range(block.GetPointData().GetNumberOfArrays())]))
    return text


def compare(name, *options, pieces=None):
    gtn("pack", "-q", "-f", *options, name, "whole.gtn")
    gtn("pack", "-q", "-f", *options, *(("--pieces", pieces) if pieces else ("--memory", 1000)), name,
        "parts.gtn")
    gtn("verify", "parts.gtn", "whole.gtn", says="identical")
    gtn("verify", *options, "parts.gtn", name, says="identical")
    for one, other in zip(described("parts.gtn"), described("whole.gtn"), strict=True):
        assert str(one) == str(other), f"{one}\n{other}"  # NaN equals NaN
    return json.loads(gtn("info", "--json", "parts.gtn"))


write_blocks(blocks, "blocks.vtm")
info = compare("blocks.vtm")
assert info["unusedPoints"] == 12 and info["chunks"] >= 5, info
compare("blocks.vtm", pieces=2)
compare("blocks.vtm", "--arrays", "pressure", "--arrays", "BlockId")

# Partitions are one block.
collection = vtkPartitionedDataSetCollection()
for number, grids in enumerate(((first, third), (second,), (loose, cube(2, 9)))):
    parts = vtkPartitionedDataSet()
    for i, grid in enumerate(grids):
        parts.SetPartition(i, grid)
    collection.SetPartitionedDataSet(number, parts)
    collection.GetMetaData(number).Set(NAME, f"part {number}")
write_blocks(collection, "blocks.vtpc")
compare("blocks.vtpc")
compare("blocks.vtpc", pieces=3)

# Global ids join the points of blocks.
joined = vtkMultiBlockDataSet()
points, tets = lattice(6)
whole_points = len(points)
for i in range(3):
    ids, local = np.unique(tets[i::3], return_inverse=True)
    grid = make_grid(points[ids], local.reshape(-1, 4), {"pressure": points[ids][:, 0]})
    grid.GetPointData().SetGlobalIds(add(grid.GetPointData(), "ids", ids.astype(np.int64) * 10**9))
    joined.SetBlock(i, grid)
write_blocks(joined, "joined.vtm")
assert compare("joined.vtm")["points"] == whole_points

# Time steps.
for step in range(2):
    moving = vtkMultiBlockDataSet()
    for i in range(3):
        moving.SetBlock(i, cube(3, 4 * i, pressure=lambda p, s=step: np.sin(p[:, 0] + s)))
    write_blocks(moving, f"step{step}.vtm")
with open("steps.pvd", "w", encoding="ascii") as file:
    file.write('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="step0.vtm"/>'
               '<DataSet timestep="2.5" file="step1.vtm"/></Collection></VTKFile>')
assert len(compare("steps.pvd")["times"]) == 2
gtn("pack", "-q", "-f", "--memory", 1000, "step0.vtm", "step1.vtm", "parts.gtn")
gtn("verify", "parts.gtn", "step0.vtm", "step1.vtm", says="identical")


# The blocks of an Exodus file, with different cells and arrays, and time steps.
solver = vtkMultiBlockDataSet()
hexes = vtkUnstructuredGrid()
corners = vtkPoints()
corners.SetData(numpy_to_vtk(np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in range(5)],
                                      np.float64) - 9, deep=True))
hexes.SetPoints(corners)
for i in range(4):
    a, b, c, d = i, i + 5, i + 10, i + 15
    hexes.InsertNextCell(VTK_HEXAHEDRON, 8, [a, a + 1, b + 1, b, c, c + 1, d + 1, d])
add(hexes.GetCellData(), "heat", np.arange(4.))
for number, grid in enumerate((cube(3, 0, np.float64, pressure=lambda p: p[:, 0]), hexes,
                               cube(2, 5, np.float64, speed=lambda p: p))):
    solver.SetBlock(number, grid)


def write_exodus(source, name):
    writer = vtkExodusIIWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(name)
    writer.WriteAllTimeStepsOn()
    writer.WriteOutBlockIdArrayOff()
    writer.WriteOutGlobalElementIdArrayOff()
    writer.WriteOutGlobalNodeIdArrayOff()
    assert writer.Write()


producer = vtkTrivialProducer()
producer.SetOutput(solver)
write_exodus(producer, "solver.e")
info = compare("solver.e")
assert info["chunks"] >= 3 and info["cells"] == 6 * (27 + 8) + 4, info
compare("solver.e", pieces=2)
gtn("pack", "-q", "-f", "steps.pvd", "steps.gtn")
reader = vtkGatunReader()
reader.SetFileName("steps.gtn")
steps = vtkGatunSplitBlocks()
steps.SetInputConnection(reader.GetOutputPort())
write_exodus(steps, "steps.e")
info = compare("steps.e")
assert info["times"] == [0, 2.5] and info["chunks"] == 3, info
gtn("pack", "-q", "--memory", 100, "solver.e", "never.gtn", code=1, says="--memory allows 100")


# What cannot be done leaves nothing behind.
def refuse(*arguments, says):
    files = sorted(os.listdir("."))
    gtn("pack", "-q", "--memory", 1000, *arguments, "never.gtn", code=1, says=says)
    assert sorted(os.listdir(".")) == files


with open("blocks.vtm", encoding="ascii") as file:
    text = file.read()


def damage(old, new, says):
    assert old in text
    with open("damaged.vtm", "w", encoding="ascii") as damaged:
        damaged.write(text.replace(old, new, 1))
    refuse("damaged.vtm", says=says)


damage("blocks/blocks_0.vtu", "blocks/lost.vtu", "lost.vtu")
damage('index="2"', 'index="0"', "several blocks with the same index")
damage('index="2"', 'index="-2"', "the index -2")
damage('index="2"', 'index="2000000000"', "the index 2000000000")
damage("<vtkMultiBlockDataSet>", "<vtkOther>", "damaged.vtm")
shutil.copy("blocks/blocks_0.vtu", "kept.vtu")
with open("blocks/blocks_0.vtu", "r+b") as file:
    file.truncate(3000)
refuse("blocks.vtm", says="blocks_0.vtu")
shutil.copy("kept.vtu", "blocks/blocks_0.vtu")
refuse("--layers", "pressure", "blocks.vtm", says="need the whole mesh")
gtn("pack", "-q", "--memory", 100, "blocks.vtm", "never.gtn", code=1, says="--memory allows 100")

# Lines of one file that end at points inside the mesh of another one keep points of their own.
points, tets = lattice(6)
write(make_grid(points, tets), "solid.vtu")
lines = vtkUnstructuredGrid()
ends = vtkPoints()
ends.SetData(numpy_to_vtk(points[[114, 115, 122]], deep=True))
lines.SetPoints(ends)
lines.InsertNextCell(3, 2, [0, 1])
lines.InsertNextCell(3, 2, [1, 2])
write(lines, "lines.vtu")
with open("both.pvtu", "w", encoding="ascii") as file:
    file.write("""<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"
 header_type="UInt32" compressor="vtkZLibDataCompressor"><PUnstructuredGrid GhostLevel="0">
<PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="3"/></PPoints>
<Piece Source="solid.vtu"/><Piece Source="lines.vtu"/></PUnstructuredGrid></VTKFile>""")
gtn("pack", "-q", "-f", "--pieces", 2, "both.pvtu", "parts.gtn")
assert json.loads(gtn("info", "--json", "parts.gtn"))["points"] == len(points) + 3
