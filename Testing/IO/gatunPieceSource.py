# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sources of meshes in pieces, and vtkGatunWriter with its messages."""

from vtkmodules.util import vtkConstants as c
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm, vtkStreamingDemandDrivenPipeline as pipeline)

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter


class PieceSource(VTKPythonAlgorithmBase):
    """Makes pieces and steps on request: make(piece, pieces, step) returns a grid."""

    def __init__(self, make, times=(), kind="vtkUnstructuredGrid"):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=kind)
        self.make, self.times = make, list(times)
        self.asked = []

    def RequestInformation(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        info.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        if self.times:
            info.Set(pipeline.TIME_STEPS(), self.times, len(self.times))
            info.Set(pipeline.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        piece = info.Get(pipeline.UPDATE_PIECE_NUMBER())
        pieces = info.Get(pipeline.UPDATE_NUMBER_OF_PIECES())
        step = 0
        if self.times and info.Has(pipeline.UPDATE_TIME_STEP()):
            step = self.times.index(info.Get(pipeline.UPDATE_TIME_STEP()))
        self.asked.append((piece, step))
        output = vtkDataObject.GetData(outInfo, 0)
        output.ShallowCopy(self.make(piece, pieces, step))
        if self.times:
            output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), self.times[step])
        return 1


def mark_ghosts(grid, ghosts):
    """Marks cells as ghosts, and every other point as one that another piece owns."""
    for data, flags, kind in (
            (grid.GetCellData(), ghosts, vtkDataSetAttributes.DUPLICATECELL),
            (grid.GetPointData(), [i % 2 for i in range(grid.GetNumberOfPoints())],
             vtkDataSetAttributes.DUPLICATEPOINT)):
        marks = vtkUnsignedCharArray()
        marks.SetName(vtkDataSetAttributes.GhostArrayName())
        for flag in flags:
            marks.InsertNextValue(kind if flag else 0)
        data.AddArray(marks)
    return grid


def write_pieces(source, path, expected, **options):
    """Writes what a source has. Returns the writer and its messages."""
    writer = vtkGatunWriter()
    writer.source = source
    messages = []

    @gm.calldata_type(c.VTK_STRING)
    def note(_object, _event, text):
        messages.append(text)

    writer.AddObserver("WarningEvent", note)
    writer.AddObserver("ErrorEvent", note)
    writer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(path)
    writer.SetChunkSize(200)
    for key, value in options.items():
        getattr(writer, "Set" + key)(value)
    assert writer.Write() == expected, messages
    return writer, messages
