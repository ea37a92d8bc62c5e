# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Reading of files."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Sequence

from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkCommonMisc import vtkErrorCode

from ._classes import get_class
from ._errors import raising, set_property
from ._exceptions import Error
from ._numbers import check_box
from ._types import Names, Path, list_names


def open_reader(path):
    """Returns the reader of a file, by its contents.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError.
        Error: it is neither a .gtn file nor a .ghv file.
    """
    path = os.fsdecode(path)
    with open(path, "rb"):
        pass
    for name in ("vtkGatunReader", "vtkGatunSurfaceReader", "vtkGatunHartleyReader"):
        reader = get_class(name)()
        if reader.CanReadFile(path):
            reader.SetFileName(path)
            with raising(reader):
                reader.UpdateInformation()
            return reader
    raise Error(
        f"{path}: is neither a .gtn nor a .ghv file", vtkErrorCode.UnrecognizedFileTypeError
    )


def is_volume(reader):
    """Whether a reader is one of .ghv files."""
    return isinstance(reader, get_class("vtkGatunHartleyReader"))


def get_times(reader):
    """Returns the times of the steps of a file as a list, empty without time."""
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    info = reader.GetOutputInformation(0)
    return [info.Get(key, i) for i in range(info.Length(key))] if info.Has(key) else []


def choose_time(reader, step, time):
    """Returns the time to request, or None if the file has none."""
    path = reader.GetFileName()
    times = get_times(reader)
    if step is not None and time is not None:
        raise ValueError("step and time exclude each other")
    if time is not None:
        if math.isnan(time) or not times:
            raise ValueError(f"{path}: has no time steps" if not times else "time: is not a number")
        return float(time)
    if not times:
        if step not in (None, 0, -1):
            raise ValueError(f"{path}: has no time steps")
        return None
    index = 0 if step is None else step
    if not -len(times) <= index < len(times):
        raise ValueError(f"{path}: has no step {step}; they are numbered 0 to {len(times) - 1}")
    return times[index]


def _choose_arrays(reader, arrays):
    """Selects arrays of a mesh by name."""
    if arrays is None:
        return
    wanted = list_names(arrays)
    selections = (reader.GetPointDataArraySelection(), reader.GetCellDataArraySelection())
    known = [
        selection.GetArrayName(i)
        for selection in selections
        for i in range(selection.GetNumberOfArrays())
    ]
    for name in wanted:
        if name not in known:
            there = ", ".join(map(repr, known)) or "none"
            raise ValueError(f"{reader.GetFileName()}: has no array {name!r}; there are {there}")
    for selection in selections:
        selection.DisableAllArrays()
        for name in wanted:
            if selection.ArrayExists(name):
                selection.EnableArray(name)


def _find_extent(info, box):
    """The voxels of a volume that a box in world coordinates touches."""
    grid = vtkImageData()
    whole = info.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
    grid.SetExtent(whole)
    grid.SetOrigin(info.Get(vtkDataObject.ORIGIN()))
    grid.SetSpacing(info.Get(vtkDataObject.SPACING()))
    if info.Has(vtkDataObject.DIRECTION()):
        grid.SetDirectionMatrix(info.Get(vtkDataObject.DIRECTION()))
    corners = []
    for corner in itertools.product(box[:2], box[2:4], box[4:]):
        index = [0.0] * 3
        grid.TransformPhysicalPointToContinuousIndex(corner, index)
        corners.append(index)
    extent = []
    for axis, values in enumerate(zip(*corners)):
        low = max(min(values), whole[2 * axis])
        high = min(max(values), whole[2 * axis + 1])
        if not low <= high:
            raise ValueError(f"box: {box} has no voxels")
        extent += [math.floor(low), math.ceil(high)]
    return extent


def _read_volume(reader, options):
    for name in ("arrays", "step", "time", "ratio"):
        if options[name] not in (None, 0):
            raise ValueError(f"{name}: is for meshes, and {reader.GetFileName()} is a volume")
    with raising(reader):
        if options["box"] is None:
            reader.Update()
        else:
            info = reader.GetOutputInformation(0)
            reader.UpdateExtent(_find_extent(info, check_box(options["box"])))
    return reader.GetOutput()


def read(
    path: Path,
    *,
    arrays: Names | None = None,
    step: int | None = None,
    time: float | None = None,
    box: Sequence[float] | None = None,
    ratio: float = 0.0,
    restore_order: bool = True,
) -> vtkUnstructuredGrid | vtkPolyData | vtkImageData:
    """Reads a .gtn or .ghv file into memory.

    Args:
        path: the file. Its contents tell what it is, not its name.
        arrays: names of the point and cell arrays to read, or one name; None for all. Other arrays
            are not read from the file.
        step: index of the time step, from 0; negative ones count from the end. Default: the first.
        time: a time in place of a step: the last step that is not later, or else the first.
        box: xmin, xmax, ymin, ymax, zmin, zmax: only the chunks of the mesh that touch this box,
            which have cells outside of it, or the voxels of a volume that lie in it and those around.
        ratio: fraction of points to remove, 0 to 1. Above 0, the file must have a hierarchy (see
            ``write``).
        restore_order: whether points and cells come in the order of the mesh that was written, as
            far as the file keeps it.

    Returns:
        A vtkUnstructuredGrid, a vtkPolyData for the file of a surface, or a vtkImageData for a
        .ghv file.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError or PermissionError.
        ValueError: a parameter that does not fit, as an array or a step that the file does not have.
        Error: the file is damaged, or no file of Gatun.
    """
    reader = open_reader(path)
    if is_volume(reader):
        options = {"arrays": arrays, "step": step, "time": time, "box": box, "ratio": ratio}
        return _read_volume(reader, options)
    _choose_arrays(reader, arrays)
    moment = choose_time(reader, step, time)
    if box is not None:
        reader.SetBox(check_box(box))
    set_property(reader, "ratio", "SimplificationRatio", ratio)
    reader.SetRestoreOrder(bool(restore_order))
    with raising(reader):
        if moment is None:
            reader.Update()
        else:
            reader.UpdateTimeStep(moment)
    return reader.GetOutput()


def steps(path: Path) -> list[float]:
    """Returns the times of the time steps of a file as a list, empty for a file without time.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, or no file of Gatun.
    """
    return get_times(open_reader(path))
