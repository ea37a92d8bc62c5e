# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The processes of a parallel ParaView, and meshes of which each has a piece."""

import contextlib
import gc
from collections.abc import Sequence

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from ._exceptions import Error
from ._join import join_pieces, prepare_piece

_TAG = 47710
_END = -1


@contextlib.contextmanager
def pause_collection():
    """Keeps Python from collecting garbage, for the requests of a pipeline.

    It may hold proxies of ParaView. One that is deleted on the first process tells all others, which do not listen
    while they carry out a request.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


class Ranks:
    """The processes. All of them have to call each method.

    Attributes:
        number: of this process, from 0.
        count: of all.
    """

    def __init__(self):
        self._controller = vtkMultiProcessController.GetGlobalController()
        self.number = self._controller.GetLocalProcessId() if self._controller else 0
        self.count = self._controller.GetNumberOfProcesses() if self._controller else 1

    def find_least(self, number):
        """The least of the numbers that the processes give."""
        if self.count == 1:
            return number
        mine, least = vtkIntArray(), vtkIntArray()
        mine.InsertNextValue(number)
        least.InsertNextValue(0)
        self._controller.AllReduce(mine, least, vtkCommunicator.MIN_OP)
        return least.GetValue(0)

    def share(self, number=0):
        """The number that the first process gives."""
        if self.count == 1:
            return number
        values = vtkIntArray()
        values.InsertNextValue(number)
        self._controller.Broadcast(values, 0)
        return values.GetValue(0)

    def find_text(self, text):
        """On the first process the text of the first one that has any, and that of each process on the others."""
        first = self.find_least(self.number if text else self.count)
        if first in (0, self.count):
            return text
        if self.number == first:
            self._controller.Send(numpy_to_vtk(np.frombuffer(text.encode(errors="replace"), np.uint8), deep=1), 0, _TAG)
        elif self.number == 0:
            values = vtkUnsignedCharArray()
            self._controller.Receive(values, first, _TAG)
            text = vtk_to_numpy(values).tobytes().decode()
        return text

    def gather(self, data):
        """The data of all processes on the first one, and None on the others."""
        if self.number > 0:
            self._controller.Send(data, 0, _TAG)
            return None
        return [data] + [self._controller.ReceiveDataObject(i, _TAG) for i in range(1, self.count)]


def _has_failed(executive):
    """Whether an algorithm, or one before it, is a reader that has failed. Filters go on with its empty mesh."""
    algorithm = executive.GetAlgorithm()
    before = (
        executive.GetInputExecutive(port, i)
        for port in range(algorithm.GetNumberOfInputPorts())
        for i in range(algorithm.GetNumberOfInputConnections(port))
    )
    return getattr(algorithm, "has_failed", False) or any(map(_has_failed, before))


class GatheredSeries(Sequence):
    """The meshes of an algorithm over time, each gathered on the first process when that one asks for it.

    Args:
        port: the output of the algorithm.
        has_all_times: whether all its time steps are wanted, if it has any, in place of the current one.

    Attributes:
        times: of the steps, or None for the current one.
    """

    def __init__(self, port, has_all_times):
        self._ranks = Ranks()
        self._executive = port.GetProducer().GetExecutive()
        self._port = port.GetIndex()
        port.GetProducer().UpdateInformation()
        info = self._get_info()
        key = Pipeline.TIME_STEPS()
        has_times = has_all_times and info.Has(key)
        self.times = [info.Get(key, i) for i in range(info.Length(key))] if has_times else None

    def __len__(self):
        return 1 if self.times is None else len(self.times)

    def __getitem__(self, number):
        number = range(len(self))[number]
        return self._collect(self._ranks.share(number))

    def run(self, work):
        """Calls a function with this series on the first process. The others serve it.

        Raises:
            Error: a process has no mesh to give.
        """
        if self._ranks.number > 0:
            self._serve()
            return
        try:
            work(self)
        finally:
            self._ranks.share(_END)

    def _serve(self):
        failure = None
        while True:
            number = self._ranks.share()
            if number == _END:
                break
            try:
                self._collect(number)
            except Exception as error:  # pylint: disable=broad-except
                # Not its frames, nor those that have called them: a proxy in one of them has to end with its script.
                failure = error.with_traceback(None)
        if failure:
            try:
                raise failure
            finally:
                del failure

    def _get_info(self):
        return self._executive.GetOutputInformation(self._port)

    def _collect(self, number):
        """The mesh of a step on the first process, and None on the others."""
        try:
            piece = self._update(number)
        except Exception:
            self._ranks.find_least(0)
            raise
        if not self._ranks.find_least(1):
            raise Error("another process cannot give its piece of the mesh")
        if self._ranks.count == 1:
            return piece
        pieces = self._ranks.gather(piece)
        return join_pieces(pieces) if pieces else None

    def _update(self, number):
        """The piece of this process."""
        info = self._get_info()
        info.Set(Pipeline.UPDATE_PIECE_NUMBER(), self._ranks.number)
        info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), self._ranks.count)
        info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
        if self.times is not None:
            info.Set(Pipeline.UPDATE_TIME_STEP(), self.times[number])
        if not self._executive.Update(self._port) or _has_failed(self._executive):
            raise Error("the filters before the writer have failed")
        data = info.Get(vtkDataObject.DATA_OBJECT())
        if not isinstance(data, (vtkUnstructuredGrid, vtkPolyData)):
            raise TypeError(f"a {data.GetClassName()} is neither a mesh nor a surface that can be written")
        piece = data.NewInstance()
        piece.ShallowCopy(data)
        return piece if self._ranks.count == 1 else prepare_piece(piece)
