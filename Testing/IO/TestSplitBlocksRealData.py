# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Exodus files with all of their blocks, side sets and node sets, packed and split: every block comes
back with its cells, points and arrays, at all time steps."""

import glob
import os

from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
from vtkmodules.vtkIOExodus import vtkExodusIIReader

import gatunMeshes as gm
from gatun.vtk import vtkGatunMergeBlocks, vtkGatunReader, vtkGatunSplitBlocks, vtkGatunWriter
from gatunBlocks import NAME, assert_equal, assert_same, listed

SETS = (vtkExodusIIReader.ELEM_BLOCK, vtkExodusIIReader.SIDE_SET, vtkExodusIIReader.NODE_SET)


def open_exodus(path):
    source = vtkExodusIIReader()
    source.SetFileName(path)
    source.UpdateInformation()
    source.SetApplyDisplacements(0)
    for kind in SETS:
        for i in range(source.GetNumberOfObjects(kind)):
            source.SetObjectStatus(kind, i, 1)
    for kind in SETS + (vtkExodusIIReader.NODAL,):
        for i in range(source.GetNumberOfObjectArrays(kind)):
            source.SetObjectArrayStatus(kind, source.GetObjectArrayName(kind, i), 1)
    return source


def leaves(tree):
    """(name, copy) of each grid."""
    found = []
    iterator = tree.NewTreeIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        copy = vtkUnstructuredGrid()
        copy.ShallowCopy(iterator.GetCurrentDataObject())
        found.append((iterator.GetCurrentMetaData().Get(NAME), copy))
        iterator.GoToNextItem()
    return found


paths = [path for variable in ("GATUN_DATA_DIR", "GATUN_CELLS_DIR") if os.environ.get(variable)
         for pattern in ("*.e", "*.exo")
         for path in sorted(glob.glob(os.path.join(os.environ[variable], pattern)))]
if not paths:
    print("no Exodus files in GATUN_DATA_DIR and GATUN_CELLS_DIR")
    raise SystemExit(gm.SKIPPED)

sets = 0
for path in paths:
    source = open_exodus(path)
    sets += sum(source.GetNumberOfObjects(kind) for kind in SETS[1:])
    merge = vtkGatunMergeBlocks()
    merge.SetInputConnection(source.GetOutputPort())
    merge.AddObserver("WarningEvent", lambda *_: None)
    for keep in (0, 7):
        packed = gm.temporary("exodus-blocks.gtn")
        writer = vtkGatunWriter()
        writer.SetInputConnection(merge.GetOutputPort())
        writer.SetFileName(packed)
        writer.SetKeepOrder(keep)
        writer.WriteAllTimeStepsOn()
        assert writer.Write() == 1
        reader = vtkGatunReader()
        reader.SetFileName(packed)
        split = vtkGatunSplitBlocks()
        split.SetInputConnection(reader.GetOutputPort())
        split.AddObserver("WarningEvent", lambda *_: 1 / 0)
        info = source.GetOutputInformation(0)
        times = info.Get(pipeline.TIME_STEPS()) if info.Has(pipeline.TIME_STEPS()) else [None]
        for time in times[::5] if keep == 0 else times:
            for algorithm in (source, split):
                algorithm.Update() if time is None else algorithm.UpdateTimeStep(time)
            before, after = leaves(source.GetOutput()), listed(split.GetOutput())
            assert [name for name, _ in before] == [name for name, _ in after]
            for (_, one), (_, other) in zip(before, after):
                (assert_equal if keep else assert_same)(one, other)
    print(os.path.basename(path), len(before), "blocks")
assert sets > 0
