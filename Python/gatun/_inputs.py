# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What can be written: data, algorithms of VTK, and series of data."""

from __future__ import annotations

from collections.abc import Iterable

from ._exceptions import Error
from ._mesh_data import take_members


def is_vtk(data, *kinds):
    """Whether an object is one of VTK, of a class or derived from it."""
    return callable(getattr(data, "IsA", None)) and any(bool(data.IsA(kind)) for kind in kinds)


def _is_algorithm(data):
    return is_vtk(data, "vtkAlgorithm", "vtkAlgorithmOutput")


def _has_members(data):
    return hasattr(data, "points") and (hasattr(data, "connectivity") or hasattr(data, "cells"))


def is_one(data):
    """Whether an object is one mesh or volume, and not a series of them."""
    return is_vtk(data, "vtkDataObject") or _is_algorithm(data) or _has_members(data)


def name_of(data):
    """The name of the class of an object."""
    return data.GetClassName() if is_vtk(data, "vtkObjectBase") else type(data).__name__


def _merge_blocks(data):
    try:
        from ._classes import get_class

        merge = get_class("vtkGatunMergeBlocks")()
    except ImportError:
        raise TypeError(
            f"data: a {data.GetClassName()} is a tree of blocks, which this package cannot merge without the modules "
            "of VTK; combine the blocks first, as vtkAppendDataSets and PyVista's combine() do"
        ) from None
    from ._errors import raising

    merge.SetInputData(data)
    with raising(merge):
        merge.Update()
    return merge.GetOutputDataObject(0)


def take(data, names=None):
    """A mesh for the library, as MeshData.

    Args:
        data: of VTK, or an object with the members of a ``gatun.Grid`` or a ``meshio.Mesh``.
        names: of the arrays to take, or None for all.
    """
    if is_vtk(data, "vtkDataObjectTree"):
        data = _merge_blocks(data)
    if is_vtk(data, "vtkUnstructuredGrid", "vtkPolyData"):
        from ._vtk_input import take_vtk

        return take_vtk(data, names)
    if is_vtk(data, "vtkObjectBase"):
        raise TypeError(f"data: a {data.GetClassName()} cannot be written as a .gtn file")
    if not _has_members(data):
        raise TypeError(f"{type(data).__name__} is the type of no data or algorithm of VTK, and no mesh")
    return take_members(data, names)


# ------------------------------------------------------------------------------
# Steps


class Steps:
    """The steps of a series, or the only one of what has no time.

    Attributes:
        times: of the steps, or None without time.
        is_made: whether the data are there, and not made by an algorithm.
    """

    def __init__(self, times, get, is_made=True):
        self.times = times
        self.is_made = is_made
        self._get = get

    def __len__(self):
        return 1 if self.times is None else len(self.times)

    def get(self, step):
        """The data of a step."""
        return self._get(step)


class Output:
    """An output of an algorithm of VTK."""

    def __init__(self, source):
        if is_vtk(source, "vtkAlgorithmOutput"):
            self._producer, self._port = source.GetProducer(), source.GetIndex()
        else:
            self._producer, self._port = source, 0

    def get_times(self):
        """The times of its steps, or None."""
        from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

        self._producer.UpdateInformation()
        key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        info = self._producer.GetOutputInformation(self._port)
        return list(info.Get(key)) if info.Has(key) and info.Length(key) > 0 else None

    def get(self, time=None):
        """Its data, at a time if one is given."""
        from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

        from ._errors import raising

        with raising(self._producer):
            self._producer.UpdateInformation()
            info = self._producer.GetOutputInformation(self._port)
            if time is not None:
                info.Set(pipeline.UPDATE_TIME_STEP(), time)
            info.Set(pipeline.UPDATE_PIECE_NUMBER(), 0)
            info.Set(pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
            info.Set(pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
            is_updated = self._producer.GetExecutive().Update(self._port)
        if not is_updated:
            raise Error(f"the output of {self._producer.GetClassName()} could not be updated")
        return self._producer.GetOutputDataObject(self._port)


def _list_times(times, count):
    times = [float(t) for t in (range(count) if times is None else times)]
    if len(times) != count:
        raise ValueError(f"times: there are {len(times)} for {count} meshes")
    if not all(a < b for a, b in zip(times, times[1:])) or times[0] != times[0]:
        raise ValueError("times: each has to be after the one before")
    return times


def _list_series(series, times):
    if not (hasattr(series, "__getitem__") and hasattr(series, "__len__")):
        if not isinstance(series, Iterable):
            take(series)  # which it is not
        series = list(series)
    if len(series) == 0:
        raise ValueError("data: the series has no meshes")
    times = _list_times(times, len(series))
    first = series[0]  # which may have been expensive
    return Steps(times, lambda step: first if step == 0 else series[step])


def list_steps(data, times):
    """The Steps of data, an algorithm or a series.

    Args:
        data, times: as of ``gatun.write``.
    """
    if not is_one(data):
        return _list_series(data, times)
    if times is not None and not isinstance(times, bool):
        raise ValueError("times: are for a series of meshes; an algorithm has times of its own")
    if not _is_algorithm(data):
        return Steps(None, lambda step: data)
    output = Output(data)
    found = output.get_times() if times else None
    return Steps(found, lambda step: output.get(None if found is None else found[step]), False)
