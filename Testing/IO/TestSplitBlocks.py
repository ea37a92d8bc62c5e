# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Merged blocks come back as they were, also from a file, in pieces and with ghost cells."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON, vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet,
    vtkUnstructuredGrid)
from vtkmodules.vtkFiltersSources import vtkSphereSource

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunSplitBlocks
from gatunBlocks import assert_equal, assert_same, collect, listed, merge, split
from gatunCells import CURVED, LINEAR, polyhedron, zoo

def check(named, expected=None):
    """Merged and split; and with a file in between."""
    grid = merge(collect(named))
    expected = expected or [(name or "Block %d" % i, block) for i, (name, block) in enumerate(named)]
    keep = gm.round_trip(grid, "split.gtn", KeepOrder=7)
    for merged in (grid, keep):
        back = listed(split(merged))
        assert [name for name, _ in back] == [name for name, _ in expected]
        for (_, one), (_, other) in zip(expected, back):
            assert_equal(one, other)
    back = listed(split(gm.round_trip(grid, "split-free.gtn", ChunkSize=100)))
    assert [name for name, _ in back] == [name for name, _ in expected]
    for (_, one), (_, other) in zip(expected, back):
        assert_same(one, other)
    return grid


def with_arrays(grid, number):
    """Arrays of the same names that differ in type, size and role from block to block."""
    points, cells = grid.GetNumberOfPoints(), grid.GetNumberOfCells()
    data = grid.GetPointData()
    gm.add_array(data, np.arange(points, dtype=(np.int32, np.float64, np.uint8)[number]), "mixed")
    gm.add_array(data, np.arange(3.0 * points).reshape(-1, 3), "of %d" % number,
                 components=["u", "v", "w"])
    data.SetActiveAttribute("of %d" % number, vtkDataSetAttributes.VECTORS)
    if number != 1:
        gm.add_array(data, np.arange(points, dtype=np.float32), "not in 1")
        data.SetActiveScalars("not in 1" if number == 0 else "mixed")
    data = grid.GetCellData()
    gm.add_array(data, np.arange(cells) % 5, "BlockId")
    gm.add_array(data, np.arange(cells * (number + 1.0)).reshape(cells, -1), "size")
    return grid


# Cells of all types, arrays of all kinds, an empty block, points without cells.
volumes = with_arrays(zoo(LINEAR + list(CURVED), 2), 0)
surface = with_arrays(zoo([c.VTK_TRIANGLE, c.VTK_QUAD, c.VTK_POLYGON], 20), 1)
vertices = with_arrays(zoo([c.VTK_VERTEX], 30), 2)
cloud = gm.make_grid(np.random.default_rng(3).random((50, 3)), [])
gm.add_array(cloud.GetPointData(), np.arange(50.0), "of the cloud")
grid = check([("volumes", volumes), ("a surface", surface), (None, vertices), ("cloud", cloud)])
names = [a.GetName() for a in gm.arrays_of(grid.GetCellData())]
assert {"BlockId", "BlockId (2)", "size", "size (2)", "size (3)"} <= set(names), names
assert grid.GetPointData().HasArray("BlockId")
only = with_arrays(zoo([VTK_POLYHEDRON, c.VTK_TETRA], 5), 0)
check([("only one", only)])
empty = listed(split(merge(collect([("one", only), ("nothing", vtkUnstructuredGrid())]))))
assert [name for name, _ in empty] == ["one", "nothing"]
assert empty[1][1].GetNumberOfPoints() == empty[1][1].GetNumberOfCells() == 0
assert listed(split(merge(vtkMultiBlockDataSet()))) == []

# Surfaces and images come back as unstructured grids.
sphere = vtkSphereSource()
sphere.Update()
image = vtkImageData()
image.SetDimensions(3, 4, 5)
gm.add_array(image.GetCellData(), np.arange(24), "voxel")
back = listed(split(merge(collect([("sphere", sphere.GetOutput()), ("image", image)]))))
assert [name for name, _ in back] == ["sphere", "image"]
for original, (_, block) in zip((sphere.GetOutput(), image), back):
    assert block.GetNumberOfPoints() == original.GetNumberOfPoints()
    assert block.GetNumberOfCells() == original.GetNumberOfCells()
    for attributes in (vtkDataObject.POINT, vtkDataObject.CELL):
        gm.assert_same_arrays(original.GetAttributes(attributes), block.GetAttributes(attributes))

# Blocks that touch share points by their global ids. The values of those that have an array win,
# in whatever order the blocks come.
points, tets = gm.lattice(4)
left, right = tets[points[tets].mean(1)[:, 0] < 0.5], tets[points[tets].mean(1)[:, 0] >= 0.5]
for order in (1, -1):
    halves = []
    for i, part in enumerate((left, right)):
        mine = np.unique(part)
        half = gm.make_grid(points[mine], np.searchsorted(mine, part))
        gm.add_array(half.GetPointData(), mine, "ids")
        half.GetPointData().SetActiveGlobalIds("ids")
        if i == 0:
            gm.add_array(half.GetPointData(), mine * 0.5, "only left")
        halves.append(("half %d" % i, half))
    grid = merge(collect(halves[::order]))
    assert grid.GetNumberOfPoints() == len(points)
    for (name, half), (back, other) in zip(halves[::order], listed(split(grid))):
        assert name == back
        assert_same(half, other)

# The field data is that of the collection, without what describes the blocks.
data = collect([("first", only), ("second", vertices)])
gm.add_array(data.GetFieldData(), np.arange(3), "of all")
back = split(merge(data))
assert [a.GetName() for a in gm.arrays_of(back.GetFieldData())] == ["of all"]

# In pieces, with ghost cells and global ids: each process has all blocks, which together are whole.
n = 6
points, tets = gm.lattice(n)
blocks = []
for i in range(3):
    block = gm.make_grid(points + np.float32(2 * i), tets)
    gm.add_array(block.GetCellData(), 1000 * i + np.arange(len(tets)), "number")
    if i == 1:
        gm.add_array(block.GetPointData(), np.arange(len(points)), "second only")
    blocks.append(("part %d" % i, block))
path = gm.temporary("split-pieces.gtn")
gm.write(merge(collect(blocks)), path, ChunkSize=200)
for ghosts in (0, 1):
    seen = [[], [], []]
    for piece in range(4):
        reader = vtkGatunReader()
        reader.SetFileName(path)
        reader.GenerateGlobalIdsOn()
        filter_ = vtkGatunSplitBlocks()
        filter_.SetInputConnection(reader.GetOutputPort())
        filter_.UpdatePiece(piece, 4, ghosts)
        back = listed(filter_.GetOutput())
        assert [name for name, _ in back] == [name for name, _ in blocks]
        marked = 0
        for i, (_, part) in enumerate(back):
            assert part.GetPointData().GetGlobalIds() and part.GetCellData().GetGlobalIds()
            assert part.GetPointData().HasArray("second only") == (i == 1)
            if not part.GetNumberOfCells():
                continue
            number = vtk_to_numpy(part.GetCellData().GetArray("number"))
            ghost = part.GetCellData().GetArray("vtkGhostType")
            ghost = vtk_to_numpy(ghost) if ghost else 0 * number
            marked += np.count_nonzero(ghost)
            seen[i] += list(number[ghost == 0])
            assert number.min() >= 1000 * i and number.max() < 1000 * i + len(tets)
        assert (marked > 0) == (ghosts > 0)
    for i, numbers in enumerate(seen):
        assert sorted(numbers) == list(range(1000 * i, 1000 * i + len(tets)))


# Without BlockId: one block, with all points and arrays.
plain = gm.block()
gm.add_array(plain.GetFieldData(), np.arange(2), "field")
((name, whole),) = listed(split(plain))
assert name is None
assert_equal(plain, whole)
assert listed(split(vtkUnstructuredGrid()))[0][1].GetNumberOfCells() == 0


def with_ids(ids, names=None, vtk_type=None):
    grid = gm.make_grid(*gm.lattice(2))
    tets = grid.GetNumberOfCells()
    gm.add_array(grid.GetCellData(), np.arange(tets), "number")
    gm.add_array(grid.GetCellData(), np.resize(ids, (tets,) + np.shape(ids)[1:]), "BlockId", vtk_type)
    if names is not None:
        array = vtkStringArray()
        array.SetName("BlockNames")
        for name in names:
            array.InsertNextValue(name)
        grid.GetFieldData().AddArray(array)
    return grid


# Names without cells, ids without a name, of any type, negative ones and very large ones.
for dtype in (np.int8, np.uint16, np.int32, np.int64):
    back = listed(split(with_ids(np.array([2, 0, 2], dtype), ["a", "b", "c"])))
    assert [name for name, _ in back] == ["a", "b", "c"]
    assert [block.GetNumberOfCells() for _, block in back] == [16, 0, 32]
    assert list(vtk_to_numpy(back[0][1].GetCellData().GetArray("number"))) == list(range(1, 48, 3))
for ids, names, expected in (
        ([5, -3, 1 << 50], None, ["Block -3", "Block 5", "Block 1125899906842624"]),
        ([0, -1, 7], ["zero"], ["zero", "Block -1", "Block 7"])):
    back = listed(split(with_ids(np.array(ids), names), warnings=int(names is not None)))
    assert [name for name, _ in back] == expected
    assert [block.GetNumberOfCells() for _, block in back] == [16, 16, 16]

# Names without ids.
grid = with_ids([0], ["a", "b"])
grid.GetCellData().RemoveArray("BlockId")
assert len(listed(split(grid, warnings=1))) == 1

# Lists that are not lists are ignored with a warning.
grid = with_ids([0, 1])
gm.add_array(grid.GetFieldData(), np.arange(2), "BlockNames")
assert [name for name, _ in listed(split(grid, warnings=1))] == ["Block 0", "Block 1"]
for texts, components in ((["0"], 1), (["x", "Point", "", "number", "number"], 5),
                          (["0", "Edge", "", "number", "number"], 5)):
    grid = with_ids([0, 1], ["a", "b"])
    array = vtkStringArray()
    array.SetName("BlockArrays")
    array.SetNumberOfComponents(components)
    for text in texts:
        array.InsertNextValue(text)
    grid.GetFieldData().AddArray(array)
    for _, block in listed(split(grid, warnings=1)):
        assert [a.GetName() for a in gm.arrays_of(block.GetCellData())] == ["number"]


def refused(grid, text):
    filter_ = vtkGatunSplitBlocks()
    filter_.SetInputDataObject(grid)
    errors = gm.Errors(filter_)
    filter_.Update()
    assert filter_.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
    assert len(errors.messages) == 1 and text in str(errors), str(errors)
    assert filter_.GetOutput().GetNumberOfPartitionedDataSets() == 0


refused(with_ids([0.0, 1.0]), "one integer for each cell")
refused(with_ids(np.zeros((48, 2), int)), "one integer for each cell")
grid = with_ids([0, 1])
grid.GetCellData().GetArray("BlockId").SetNumberOfTuples(7)
refused(grid, "BlockId")
grid = with_ids([0, 1])
grid.GetCellData().RemoveArray("BlockId")
texts = vtkStringArray()
texts.SetName("BlockId")
texts.SetNumberOfValues(48)
grid.GetCellData().AddArray(texts)
refused(grid, "one integer for each cell")
grid = with_ids([0, 1])
vtk_to_numpy(grid.GetCells().GetConnectivityArray())[5] = 1000
refused(grid, "names point 1000")
grid = gm.make_grid(np.random.default_rng(1).random((20, 3)), [])
grid.Allocate(1)
polyhedron(grid, list(range(8)))
polyhedron(grid, list(range(8, 16)))
gm.add_array(grid.GetCellData(), np.arange(2), "BlockId")
if hasattr(grid, "GetPolyhedronFaces"):  # since VTK 9.4
    vtk_to_numpy(grid.GetPolyhedronFaces().GetConnectivityArray())[1] = 12
    refused(grid, "which the cell does not have")
else:
    grid.GetFaces().SetValue(3, 12)
    refused(grid, "which the cell does not have")
    grid.GetFaces().SetValue(3, 1)
    grid.GetFaces().SetNumberOfValues(grid.GetFaces().GetNumberOfValues() - 3)
    refused(grid, "incomplete")

# Progress grows to 1; an abort leaves nothing behind.
filter_ = vtkGatunSplitBlocks()
filter_.SetInputDataObject(with_ids(range(12)))
progress = []
filter_.AddObserver("ProgressEvent", lambda *_: progress.append(filter_.GetProgress()))
filter_.Update()
assert progress == sorted(progress) and progress[-1] == 1 and len(progress) >= 12
filter_.AddObserver("ProgressEvent", lambda *_: filter_.SetAbortExecute(1))
filter_.Modified()
filter_.Update()
assert filter_.GetErrorCode() == vtkGatunErrorCode.AbortedError
assert filter_.GetOutput().GetNumberOfPartitionedDataSets() == 0
