# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A source of VTK that has time steps."""

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

_STEPS = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
_RANGE = vtkStreamingDemandDrivenPipeline.TIME_RANGE()
_REQUESTED = vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()


class SeriesSource(VTKPythonAlgorithmBase):
    """Gives one mesh of a sequence for each time.

    Args:
        get_mesh: returns the mesh of a step.
        times: the times of all steps, ascending.
        kind: the name of the class of the meshes.

    Attributes:
        failure: the exception that ``get_mesh`` raised, or None. No exception may leave a request.
    """

    def __init__(self, get_mesh, times, kind):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=kind)
        self.failure = None
        self._get_mesh = get_mesh
        self._times = times
        self._kind = kind

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(_STEPS, self._times, len(self._times))
        info.Set(_RANGE, [self._times[0], self._times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(_REQUESTED) if info.Has(_REQUESTED) else self._times[0]
        step = max((i for i, t in enumerate(self._times) if t <= time), default=0)
        try:
            mesh = self._get_mesh(step)
            if not mesh.IsA(self._kind):
                raise TypeError(f"step {step} is a {mesh.GetClassName()}, not a {self._kind}")
        except Exception as failure:  # told by whoever has called Update
            self.failure = failure
            return 0
        output = vtkDataObject.GetData(info)
        output.ShallowCopy(mesh)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), self._times[step])
        return 1
