# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Blocks become one mesh with their names and numbers; pieces of a mesh become that mesh again."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkUnstructuredGrid)

import gatunMeshes as gm
from gatun.vtk import vtkGatunMergeBlocks, vtkGatunReader, vtkGatunWriter


def merged(*inputs, **options):
    merge = vtkGatunMergeBlocks()
    for data in inputs:
        merge.AddInputDataObject(data)
    for name, value in options.items():
        getattr(merge, "Set" + name)(value)
    merge.Update()
    return merge.GetOutput()


def part(seed, dtype=np.float32, wide=True):
    points, tets = gm.lattice(3, seed, dtype)
    grid = gm.make_grid(points + dtype(2 * seed), tets, wide)
    gm.add_array(grid.GetPointData(), (1 << 60) + seed + np.arange(len(points)), "big")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)) + 1000.0 * seed, "cell")
    return grid


def values(attributes, name):
    return vtk_to_numpy(attributes.GetAbstractArray(name))


# Blocks in blocks, with and without names, one missing, one empty.
one, two, three = part(1), part(2), part(3)
only = gm.add_array(two.GetPointData(), np.arange(two.GetNumberOfPoints()) * 1.5, "only two")
gm.add_array(three.GetCellData(), np.arange(three.GetNumberOfCells(), dtype=np.int16), "only three")
gm.add_array(one.GetFieldData(), np.arange(4), "of one")
inner = vtkMultiBlockDataSet()
inner.SetBlock(0, two)
inner.GetMetaData(0).Set(vtkMultiBlockDataSet.NAME(), "second")
inner.SetBlock(1, vtkUnstructuredGrid())
outer = vtkMultiBlockDataSet()
outer.SetNumberOfBlocks(4)
outer.SetBlock(0, one)
outer.GetMetaData(0).Set(vtkMultiBlockDataSet.NAME(), "first")
outer.SetBlock(2, inner)
outer.SetBlock(3, three)
gm.add_array(outer.GetFieldData(), np.arange(2), "of all")

grid = merged(outer)
blocks = [one, two, three]
ids = values(grid.GetCellData(), "BlockId")
assert ids.dtype == np.int32
names = grid.GetFieldData().GetAbstractArray("BlockNames")
assert [names.GetValue(i) for i in range(names.GetNumberOfValues())] == \
    ["first", "second", "Block 2", "Block 3"]
assert grid.GetFieldData().HasArray("of one") and grid.GetFieldData().HasArray("of all")
assert grid.GetPoints().GetDataType() == one.GetPoints().GetDataType()
start = 0
for block, number in zip(blocks, (0, 1, 3)):
    mine = ids == number
    corners = gm.connectivity(grid)[mine]
    assert np.array_equal(corners, gm.connectivity(block) + start)
    here = slice(start, start + block.GetNumberOfPoints())
    assert np.array_equal(gm.coordinates(grid)[here], gm.coordinates(block))
    assert np.array_equal(values(grid.GetPointData(), "big")[here],
                          values(block.GetPointData(), "big"))
    assert np.array_equal(values(grid.GetCellData(), "cell")[mine],
                          values(block.GetCellData(), "cell"))
    start = here.stop
    filled = values(grid.GetPointData(), "only two")[here]
    if block is two:
        assert np.array_equal(filled, vtk_to_numpy(only))
    else:
        assert np.isnan(filled).all()
    filled = values(grid.GetCellData(), "only three")[mine]
    assert filled.dtype == np.int16
    assert np.array_equal(filled, np.arange(len(filled)) if block is three else 0 * filled)
assert start == grid.GetNumberOfPoints() and len(ids) == grid.GetNumberOfCells()
# The blocks are as they were.
assert not one.GetCellData().HasArray("BlockId") and not one.GetPointData().HasArray("only two")
gm.assert_equal(grid, gm.round_trip(grid, "blocks.gtn", KeepOrder=7))

# float and double give double; images are blocks, too.
mixed = vtkMultiBlockDataSet()
mixed.SetBlock(0, part(1))
mixed.SetBlock(1, part(2, np.float64))
assert gm.coordinates(merged(mixed)).dtype == np.float64
image = vtkImageData()
image.SetDimensions(3, 3, 3)
mixed.SetBlock(2, image)
assert merged(mixed).GetNumberOfCells() == 2 * 162 + 8

# Nothing, or next to it.
assert merged(vtkMultiBlockDataSet()).GetNumberOfCells() == 0
gm.assert_equal(part(1), merged(part(1)))
assert merged(vtkUnstructuredGrid()).GetNumberOfPoints() == 0

# Pieces of a .gtn file: their points are merged by global ids, with ghosts or without. The mesh has
# points that coincide, which stay apart.
points, tets = gm.lattice(6)
whole = gm.make_grid(np.concatenate([points, points]), np.concatenate([tets, tets + len(points)]))
gm.add_array(whole.GetPointData(), np.arange(2 * len(points)), "point")
gm.add_array(whole.GetCellData(), np.arange(2 * len(tets)), "cell")
path = gm.temporary("pieces-to-merge.gtn")
gm.write(whole, path, ChunkSize=200)
for ghosts in (0, 1):
    pieces = []
    collection = vtkPartitionedDataSet()
    for i in range(5):
        reader = vtkGatunReader()
        reader.SetFileName(path)
        reader.UpdatePiece(i, 5, ghosts)
        pieces.append(reader.GetOutput())
        collection.SetPartition(i, reader.GetOutput())
    again = merged(*pieces)
    assert not again.GetCellData().HasArray("BlockId")
    gm.assert_same_mesh(whole, again, skip=["GlobalPointIds", "GlobalCellIds"])
    assert again.GetPointData().GetGlobalIds() and not again.GetCellData().HasArray("vtkGhostType")
    again = merged(collection)
    assert set(values(again.GetCellData(), "BlockId")) == {0}
    gm.assert_same_mesh(whole, again, skip=["GlobalPointIds", "GlobalCellIds", "BlockId"])
coincident = merged(*pieces, MergeCoincidentPoints=True)
assert coincident.GetNumberOfCells() == 2 * len(tets)

# One block twice: points that coincide are merged on request alone.
double = vtkMultiBlockDataSet()
double.SetBlock(0, gm.make_grid(points, tets))
double.SetBlock(1, gm.make_grid(points, tets))
assert merged(double).GetNumberOfPoints() == 2 * len(points)
assert merged(double, MergeCoincidentPoints=True).GetNumberOfPoints() == len(points)

# Hexahedra behind the merge are the writer's business.
grid = merged(mixed)
writer = vtkGatunWriter()
writer.SetInputDataObject(grid)
writer.SetFileName(gm.temporary("blocks.gtn"))
assert writer.Write() == 1
assert gm.read(writer.GetFileName()).GetNumberOfCells() == grid.GetNumberOfCells()
