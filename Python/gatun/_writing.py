# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writing of files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataObjectTree,
    vtkDataSet,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._classes import get_class
from ._errors import raising, set_property
from ._exceptions import Error
from ._targets import check_target, find_order, find_profile
from ._types import Names, Path, list_names

_TOLERANCES = {"abs": 1, "rel": 2, "pw": 3, "bits": 4}
_VOLUME_RATES = {
    "quality": ("Quality", 0),
    "rms_error": ("RMSError", 1),
    "psnr": ("PSNR", 2),
    "bits_per_voxel": ("BitsPerVoxel", 3),
}


# ------------------------------------------------------------------------------
# Input


def as_data(data):
    """Returns a data object of VTK for an object that has the members of a mesh of meshio."""
    if isinstance(data, vtkDataObject):
        return data
    if hasattr(data, "points") and hasattr(data, "cells"):
        from ._meshio import from_meshio

        return from_meshio(data)
    raise TypeError(f"{type(data).__name__} is the type of no data or algorithm of VTK, and no mesh")


def is_one(data):
    """Whether an object is one mesh or volume, and not a series of them."""
    single = (vtkDataObject, vtkAlgorithm, vtkAlgorithmOutput)
    return isinstance(data, single) or hasattr(data, "points")


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
            data = as_data(data)
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


def _connect_series(writer, series, times, arrays):
    """Makes a series of meshes the input of a writer. Returns the source."""
    from ._series import SeriesSource

    if not (hasattr(series, "__getitem__") and hasattr(series, "__len__")):
        if not isinstance(series, Iterable):
            as_data(series)  # which it is not
        series = list(series)
    if len(series) == 0:
        raise ValueError("data: the series has no meshes")
    times = [float(t) for t in (range(len(series)) if times is None else times)]
    if len(times) != len(series):
        raise ValueError(f"times: there are {len(times)} for {len(series)} meshes")
    if not all(a < b for a, b in zip(times, times[1:])) or times[0] != times[0]:
        raise ValueError("times: each has to be after the one before")
    first = as_data(series[0])
    if not isinstance(first, (vtkUnstructuredGrid, vtkPolyData)):
        raise TypeError(f"data: a series of {first.GetClassName()} cannot be written")
    kind = "vtkUnstructuredGrid" if isinstance(first, vtkUnstructuredGrid) else "vtkPolyData"
    _check_arrays(arrays, first)
    # The first mesh may have been expensive.
    source = SeriesSource(lambda i: first if i == 0 else as_data(series[i]), times, kind)
    writer.SetInputConnection(source.GetOutputPort())
    writer.WriteAllTimeStepsOn()
    return source


# ------------------------------------------------------------------------------
# Options


def _parse_tolerance(parameter, text, kinds):
    """Returns kind, value and whether zeros are kept, of a text such as "abs:0.1,zeros"."""
    bound, comma, zeros = text.partition(",") if isinstance(text, str) else (f"abs:{text}", "", "")
    kind, _, number = bound.partition(":")
    try:
        if kind not in kinds or (comma and zeros != "zeros"):
            raise ValueError
        return _TOLERANCES[kind], float(number), bool(comma)
    except ValueError:
        forms = ", ".join(f"'{k}:{'N' if k == 'bits' else 'E'}'" for k in kinds)
        raise ValueError(f"{parameter}: {text!r} is none of {forms}") from None


def _set_tolerances(writer, tolerances):
    bounds = {"*": tolerances} if isinstance(tolerances, str) else dict(tolerances or {})
    for name, bound in bounds.items():
        if not isinstance(bound, str):
            raise ValueError(
                f"tolerances: {bound!r} of {name!r} has to be a text such as 'rel:1e-3' or 'abs:0.1'"
            )
        writer.SetArrayTolerance(name, *_parse_tolerance("tolerances", bound, _TOLERANCES))


def _set_point_tolerance(writer, tolerance):
    if tolerance is not None:
        kinds = ("abs", "rel", "bits")
        kind, value, keeps_zeros = _parse_tolerance("point_tolerance", tolerance, kinds)
        if keeps_zeros:
            raise ValueError("point_tolerance: coordinates cannot keep zeros")
        writer.SetPointTolerance(kind, value)


def _set_layers(writer, layers):
    if layers is None:
        return
    name, number = (layers, 0) if isinstance(layers, str) else layers
    if not 0 <= number <= 4096:
        raise ValueError(f"layers: {number} is not from 0 to 4096")
    writer.SetLayers(name, -1, number)


def _choose_arrays(writer, arrays):
    if arrays is None:
        return
    for selection in writer.GetPointDataArraySelection(), writer.GetCellDataArraySelection():
        selection.SetUnknownArraySetting(0)
        for name in arrays:
            selection.EnableArray(name)


def _check_arrays(arrays, mesh):
    """Raises ValueError for an array that a mesh in memory does not have; VTK would say nothing."""
    if not isinstance(mesh, vtkDataSet):
        return
    for name in arrays or []:
        if not (mesh.GetPointData().HasArray(name) or mesh.GetCellData().HasArray(name)):
            raise ValueError(f"arrays: the mesh has no array {name!r}")


# ------------------------------------------------------------------------------
# Writers


def _connect(writer, data, times, arrays):
    """Makes data the input of a writer of meshes. Returns a list of the algorithms in between."""
    if not is_one(data):
        return [_connect_series(writer, data, times, arrays)]
    if times is not None and not isinstance(times, bool):
        raise ValueError("times: are for a series of meshes; an algorithm has times of its own")
    entry = Input(data)
    if not isinstance(entry.data, (vtkUnstructuredGrid, vtkPolyData, vtkDataObjectTree)):
        raise TypeError(f"data: a {entry.data.GetClassName()} cannot be written as a .gtn file")
    if not entry.algorithms and not isinstance(data, (vtkAlgorithm, vtkAlgorithmOutput)):
        _check_arrays(arrays, entry.data)
    entry.connect(writer)
    writer.SetWriteAllTimeSteps(bool(times))
    return entry.algorithms


def _run(writer, algorithms):
    try:
        with raising(*algorithms, writer):
            writer.Write()
    except Error:
        # What a mesh of a series has raised is the reason.
        failures = [getattr(algorithm, "failure", None) for algorithm in algorithms]
        if any(failures):
            raise failures[0] from None
        raise
    finally:
        # A source in Python must not outlive its Python object.
        writer.RemoveAllInputConnections(0)
    return os.path.getsize(writer.GetFileName())


def _write_volume(data, path, rates, block_size, arrays):
    writer = get_class("vtkGatunHartleyWriter")()
    writer.SetFileName(path)
    encoding = writer.GetEncoding()
    chosen = [name for name, value in rates.items() if value is not None]
    if len(chosen) > 1:
        raise ValueError(f"{' and '.join(chosen)} exclude each other")
    for name in chosen:
        prop, mode = _VOLUME_RATES[name]
        set_property(encoding, name, prop, float(rates[name]))
        encoding.SetRateControl(mode)
    set_property(encoding, "block_size", "BlockSize", block_size)
    entry = Input(data)
    if not isinstance(entry.data, vtkImageData):
        raise TypeError(f"data: a {entry.data.GetClassName()} cannot be written as a .ghv file")
    entry.connect(writer)
    if arrays is not None:
        if len(arrays) != 1:
            raise ValueError(f"arrays: a .ghv file has one array, not {len(arrays)}")
        writer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, arrays[0])
    return _run(writer, entry.algorithms)


def write(
    data: Any,
    path: Path,
    *,
    overwrite: bool = False,
    arrays: Names | None = None,
    tolerances: str | Mapping[str, str] | None = None,
    profile: str = "fast",
    point_tolerance: float | str | None = None,
    keep_order: bool | Names = "none",
    hierarchy: bool = False,
    levels: int = 0,
    layers: str | tuple[str, int] | None = None,
    boundary: bool = False,
    split_cells: bool = False,
    append: bool = False,
    fill_missing: bool = False,
    times: Iterable[float] | bool | None = None,
    chunk_size: int = 0,
    key_step_interval: int = 8,
    quality: float | None = None,
    rms_error: float | None = None,
    psnr: float | None = None,
    bits_per_voxel: float | None = None,
    block_size: int = 8,
) -> int:
    """Writes a mesh or a series of meshes to a .gtn file, or a volume to a .ghv file.

    The file appears under its name once it is complete. Meshes are stored without loss unless
    ``tolerances`` or ``point_tolerance`` are given.

    Args:
        data: a vtkUnstructuredGrid or vtkPolyData; a tree of blocks, which become one mesh; an
            object with the members of a ``meshio.Mesh``, as ``gatun.Mesh``; an algorithm of VTK or
            its output port; a vtkImageData, for a .ghv file. Or an iterable of meshes, for a file
            with time steps: a sequence is asked for one mesh at a time, in place of others a list
            is made.
        path: the file to write, with the extension .gtn or .ghv.
        overwrite: whether to replace a file that is there.
        arrays: names of the point and cell arrays to write, or one name; None for all (of a
            volume: the active scalars).
        tolerances: how much arrays may change: a dictionary from names, or ``"*"`` for all others,
            to ``"abs:E"``, ``"rel:E"``, ``"pw:E"`` or ``"bits:N"``, with ``",zeros"`` at the end if
            values of 0 have to stay; or one of these texts for all arrays. See
            ``vtkGatunWriter.SetArrayTolerance``.
        profile: ``"fast"`` optimizes the file for reading speed, ``"small"`` for size: down to half
            the space, and read several times slower.
        point_tolerance: how much coordinates may change: a number in their units, or ``"abs:E"``,
            ``"rel:E"`` (of the longest side of the bounds) or ``"bits:N"``.
        keep_order: the original order that the file keeps: ``"none"``, ``"points"``, ``"cells"``,
            ``"corners"`` or ``"all"``, or a list of these. True is ``"all"``.
        hierarchy: whether the mesh can be read and drawn with any number of points.
        levels: largest number of base meshes to store with the hierarchy, 0 to 64. A number above 0
            includes the hierarchy.
        layers: a point array by whose values the file is organized, for isosurfaces; or a pair of it
            and the largest number of layers, 0 (automatic) to 4096.
        boundary: whether to store the boundary of the mesh, too.
        split_cells: whether to write tetrahedra in place of other cells.
        append: whether to add the time steps to the file, if it exists. They come after those of the
            file, and have the same arrays.
        fill_missing: whether arrays of a series may come and go: a mesh without an array of another
            one gets it, with NaN, or 0 if it is of integers.
        times: for a series, the times of its meshes, ascending (default: 0, 1, 2, ...); for an
            algorithm that has time steps, True to write all of them.
        chunk_size: largest number of cells in a chunk, 64 to 1048576, or 0 (automatic).
        key_step_interval: number of time steps from one that needs no other step to the next.
        quality, rms_error, psnr, bits_per_voxel: for volumes, one of these: quality from 1 to 100
            (default: 60), largest root mean square error (0: lossless), least peak signal-to-noise
            ratio in dB, or size.
        block_size: for volumes, voxels of a block along each axis: 2 to 64, or 0 for one block.

    Returns:
        The size of the file in bytes.

    Raises:
        OSError: there is no such folder, or the path is one; FileExistsError: there is a file.
        ValueError: a parameter or data that do not fit; ``gatun.InputError`` if VTK has found out.
        TypeError: data of a kind that cannot be written.
        Error: the file cannot be written.
    """
    path = os.fsdecode(path)
    arrays = list_names(arrays)
    check_target(path, overwrite or append, ".gtn", ".ghv")
    rates = {
        "quality": quality,
        "rms_error": rms_error,
        "psnr": psnr,
        "bits_per_voxel": bits_per_voxel,
    }
    if path.lower().endswith(".ghv"):
        if append:
            raise ValueError("append: a volume has no time steps")
        return _write_volume(data, path, rates, block_size, arrays)
    for name, value in rates.items():
        if value is not None:
            raise ValueError(f"{name}: is for volumes; meshes have tolerances")
    writer = get_class("vtkGatunWriter")()
    writer.SetFileName(path)
    _choose_arrays(writer, arrays)
    _set_tolerances(writer, tolerances)
    writer.SetProfile(find_profile(profile))
    writer.SetFillMissingArrays(bool(fill_missing))
    writer.SetAppend(bool(append))
    _set_point_tolerance(writer, point_tolerance)
    writer.SetKeepOrder(find_order(keep_order))
    writer.SetHierarchy(bool(hierarchy or levels))
    set_property(writer, "levels", "Levels", levels)
    _set_layers(writer, layers)
    writer.SetWriteBoundary(bool(boundary))
    writer.SetSplitCells(bool(split_cells))
    set_property(writer, "chunk_size", "ChunkSize", chunk_size)
    set_property(writer, "key_step_interval", "KeyStepInterval", key_step_interval)
    return _run(writer, _connect(writer, data, times, arrays))
