# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Large meshes of others, where there are any: every array comes back, whole, in pieces and in time."""

import glob
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import gatunMeshes as gm
from gatun.vtk import vtkGatunMergeBlocks, vtkGatunReader, vtkGatunWriter

folder = gm.data_folder()
path = gm.temporary("real.gtn")
done = 0
for name in sorted(glob.glob(os.path.join(folder, "*.vtu"))):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    done += 1
    isTets = (gm.cell_types(grid) == gm.VTK_TETRA).all()
    for chunk in (0, 1000):
        gm.assert_equal(grid, gm.round_trip(grid, "real.gtn", KeepOrder=7, ChunkSize=chunk))
        back = gm.round_trip(grid, "real.gtn", ChunkSize=chunk)
        gm.assert_same_field(grid.GetFieldData(), back.GetFieldData())
        if isTets:
            gm.assert_same_mesh(grid, back)

    # Pieces.
    whole = gm.read(path)
    reader = vtkGatunReader()
    reader.SetFileName(path)
    cells = 0
    for piece in range(3):
        reader.UpdatePiece(piece, 3, 0)
        cells += reader.GetOutput().GetNumberOfCells()
    assert cells == whole.GetNumberOfCells()

# All time steps of an Exodus file, its blocks merged, in one file.
for name in sorted(glob.glob(os.path.join(folder, "*.e"))):
    from vtkmodules.vtkIOExodus import vtkExodusIIReader

    done += 1
    source = vtkExodusIIReader()
    source.SetFileName(name)
    source.UpdateInformation()
    source.SetApplyDisplacements(0)
    for kind in (vtkExodusIIReader.NODAL, vtkExodusIIReader.ELEM_BLOCK):
        for i in range(source.GetNumberOfObjectArrays(kind)):
            source.SetObjectArrayStatus(kind, source.GetObjectArrayName(kind, i), 1)
    merge = vtkGatunMergeBlocks()
    merge.SetInputConnection(source.GetOutputPort())
    writer = vtkGatunWriter()
    writer.SetInputConnection(merge.GetOutputPort())
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    writer.SetKeepOrderToAll()
    assert writer.Write() == 1
    times = source.GetOutputInformation(0).Get(pipeline.TIME_STEPS())
    assert gm.statistic(writer, "TimeSteps") == len(times)
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    assert reader.GetOutputInformation(0).Get(pipeline.TIME_STEPS()) == times
    for time in times[::-1]:
        reader.UpdateTimeStep(time)
        merge.UpdateTimeStep(time)
        gm.assert_same_arrays(merge.GetOutput().GetPointData(), reader.GetOutput().GetPointData())
        names = reader.GetOutput().GetFieldData().GetAbstractArray("BlockNames")
        assert names.GetNumberOfValues() == len(
            set(vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("BlockId"))))
if not done:
    raise SystemExit(gm.SKIPPED)
