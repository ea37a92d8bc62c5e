# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Blocks: merged, split, and compared."""

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkUnstructuredGrid)

import gatunMeshes as gm
from gatun.vtk import vtkGatunMergeBlocks, vtkGatunSplitBlocks
from gatunCells import described

NAME = vtkMultiBlockDataSet.NAME()


def collect(named):
    """A vtkMultiBlockDataSet of these (name, grid)."""
    blocks = vtkMultiBlockDataSet()
    for i, (name, grid) in enumerate(named):
        blocks.SetBlock(i, grid)
        if name is not None:
            blocks.GetMetaData(i).Set(NAME, name)
    return blocks


def merge(data, **options):
    filter_ = vtkGatunMergeBlocks()
    filter_.AddInputDataObject(data)
    filter_.AddObserver("WarningEvent", lambda *_: None)
    for name, value in options.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    assert filter_.GetErrorCode() == 0
    return filter_.GetOutput()


def split(grid, warnings=0):
    filter_ = vtkGatunSplitBlocks()
    filter_.SetInputDataObject(grid)
    seen = []
    filter_.AddObserver("WarningEvent", lambda *_: seen.append(1))
    filter_.Update()
    assert filter_.GetErrorCode() == 0
    assert len(seen) == warnings, len(seen)
    return filter_.GetOutput()


def listed(collection):
    """(name, grid) of each block."""
    assert isinstance(collection, vtkPartitionedDataSetCollection)
    blocks = []
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        assert collection.GetNumberOfPartitions(i) == 1
        name = collection.GetMetaData(i).Get(NAME) if collection.HasMetaData(i) else None
        blocks.append((name, collection.GetPartition(i, 0)))
    return blocks


def assert_equal(block, other):
    """Bit by bit, but for field data, which the collection has."""
    copies = []
    for grid in (block, other):
        copy = vtkUnstructuredGrid()
        copy.ShallowCopy(grid)
        copy.GetFieldData().Initialize()
        copies.append(copy)
    gm.assert_equal(*copies)


def assert_same(block, other):
    """As sets of points and of cells, with their values."""
    for attributes in (vtkDataObject.POINT, vtkDataObject.CELL):
        one, two = block.GetAttributes(attributes), other.GetAttributes(attributes)
        assert sorted(map(gm.description, gm.arrays_of(one))) == \
            sorted(map(gm.description, gm.arrays_of(two)))
        assert gm.roles_of(one) == gm.roles_of(two)
    points = [gm.rows(gm.coordinates(grid), *[
        gm.values_of(grid.GetPointData().GetAbstractArray(a.GetName()))
        for a in gm.arrays_of(block.GetPointData())]) for grid in (block, other)]
    points = [p[np.lexsort(p.T)] for p in points]
    assert np.array_equal(*points)
    assert described(block) == described(other)
