# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Data of VTK that are drawn."""

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataObjectTree
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._classes import get_class


def _as_data(data):
    """Returns a data object of VTK for an object that has the members of a mesh of meshio."""
    if isinstance(data, vtkDataObject):
        return data
    if hasattr(data, "points") and hasattr(data, "cells"):
        from ._meshio import from_meshio

        return from_meshio(data)
    raise TypeError(f"{type(data).__name__} is the type of no data or algorithm of VTK, and no mesh")


class Input:
    """Data of VTK, an algorithm or its output, or an object with the members of a mesh of meshio.

    Attributes:
        data: the data, which an algorithm may not have made yet.
        algorithms: those in between that may report an error.
    """

    def __init__(self, data):
        self._port = None
        self.algorithms = []
        if isinstance(data, vtkAlgorithm):
            self._port = data.GetOutputPort()
        elif isinstance(data, vtkAlgorithmOutput):
            self._port = data
        else:
            data = _as_data(data)
            if isinstance(data, vtkDataObjectTree):
                self._merge(data)
        self.data = data
        if self._port:
            producer = self._port.GetProducer()
            producer.UpdateInformation()
            self.data = producer.GetOutputDataObject(self._port.GetIndex())

    def _merge(self, blocks):
        merge = get_class("vtkGatunMergeBlocks")()
        merge.SetInputData(blocks)
        self.algorithms.append(merge)
        self._port = merge.GetOutputPort()

    def connect(self, algorithm):
        """Makes this the input of an algorithm."""
        if self._port:
            algorithm.SetInputConnection(self._port)
        else:
            algorithm.SetInputData(self.data)
