# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""An upstream with time steps."""

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline


class TimeSource(VTKPythonAlgorithmBase):
    """Makes its steps on request: make(index) returns a grid, or a surface
    where kind says so, or None to fail."""

    def __init__(self, make, times, kind="vtkUnstructuredGrid"):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=kind)
        self.make, self.times = make, times

    def RequestInformation(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        info.Set(pipeline.TIME_STEPS(), self.times, len(self.times))
        info.Set(pipeline.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        time = self.times[0]
        if info.Has(pipeline.UPDATE_TIME_STEP()):
            time = info.Get(pipeline.UPDATE_TIME_STEP())
        made = self.make(self.times.index(time))
        if made is None:
            return 0
        output = vtkDataObject.GetData(outInfo, 0)
        output.ShallowCopy(made)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


def connect(writer, source):
    """The Python half of a source must be kept alive by somebody."""
    writer.source = source
    writer.SetInputConnection(source.GetOutputPort())
