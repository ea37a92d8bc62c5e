# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes, as they are written to .ghv files."""

from __future__ import annotations

import ctypes
import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING, Optional

import numpy as np

from . import _library as _c
from ._inputs import AlgorithmOutput, is_vtk, name_of
from ._library import Call, encode, encode_text, library
from ._numbers import as_numbers
from ._piece import to_buffer
from ._targets import check_number

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

# The number of each rate control, and the range of its value.
_RATES = {
    "quality": (0, 1, 100),
    "rms_error": (1, 0, np.finfo(float).max),
    "psnr": (2, 1, 200),
    "bits_per_voxel": (3, 0.001, 64),
}
_DEFAULT_RATE = ("quality", 60.0)
_ONE_BLOCK = 0xFFFFFFFF


@dataclasses.dataclass
class Image:
    """A regular volume as a NumPy array.

    Attributes:
        values: the voxels as ``values[z, y, x]``.
        spacing: the distances of voxels along x, y and z.
        origin: the coordinates of the voxel with index 0.
        direction: a 3 x 3 matrix, whose columns are the directions of x, y and z. Default: those of the
            coordinates.
        first_index: the index of the first voxel in VTK, along x, y and z.
        name: of the array.
    """

    values: ArrayLike
    spacing: Sequence[float] = (1.0, 1.0, 1.0)
    origin: Sequence[float] = (0.0, 0.0, 0.0)
    direction: Optional[ArrayLike] = None
    first_index: Sequence[int] = (0, 0, 0)
    name: str = "values"


def _take_vtk(image, names):
    """A vtkImageData as an Image, and the type of its array in VTK."""
    from ._values import get_values

    if image.GetNumberOfPoints() == 0:
        raise ValueError("data: the volume is empty")
    points = image.GetPointData()
    array = points.GetAbstractArray(names[0]) if names else points.GetScalars()
    if array is None:
        raise ValueError(
            f"arrays: there is no point array {names[0]!r}" if names
            else "data: there are no active point scalars; select an array by its name"
        )
    title = f"data: the point array {array.GetName() or ''!r}"
    if not is_vtk(array, "vtkDataArray") or is_vtk(array, "vtkBitArray"):
        raise ValueError(f"{title} is a {array.GetClassName()}, which is not a numeric array")
    if array.GetNumberOfComponents() != 1:
        raise ValueError(f"{title} has {array.GetNumberOfComponents()} components, but a volume has one")
    if array.GetNumberOfTuples() != image.GetNumberOfPoints():
        raise ValueError(
            f"{title} has {array.GetNumberOfTuples()} values for {image.GetNumberOfPoints()} points"
        )
    matrix = image.GetDirectionMatrix()
    taken = Image(
        get_values(array).reshape(image.GetDimensions()[::-1]),
        image.GetSpacing(),
        image.GetOrigin(),
        [matrix.GetElement(i, j) for i in range(3) for j in range(3)],
        image.GetExtent()[::2],
        array.GetName() or "",
    )
    return taken, array.GetDataType()


def _take(data, names):
    """Data as an Image, and the type of its array in VTK, or 0."""
    if is_vtk(data, "vtkAlgorithm", "vtkAlgorithmOutput"):
        data = AlgorithmOutput(data).get()
    if is_vtk(data, "vtkImageData"):
        return _take_vtk(data, names)
    if is_vtk(data, "vtkObjectBase") or hasattr(data, "points"):
        raise TypeError(f"data: a {name_of(data)} cannot be written as a .ghv file")
    return data if isinstance(data, Image) else Image(data), 0


def _choose_rate(rates):
    """The number of a rate control, and its value."""
    chosen = [(name, value) for name, value in rates.items() if value is not None] or [_DEFAULT_RATE]
    if len(chosen) > 1:
        raise ValueError(f"{' and '.join(name for name, _ in chosen)} exclude each other")
    name, value = chosen[0]
    number, least, most = _RATES[name]
    return number, check_number(name, float(value), least, most)


def _describe(image, vtk_type):
    """The structure of an image, and its voxels."""
    values = np.ascontiguousarray(as_numbers(image.values, "values"))
    if values.ndim != 3 or values.dtype.kind == "U":
        raise ValueError(f"values: have to be numbers with 3 dimensions, and have {values.ndim}")
    volume = _c.VolumeInfo(
        type=_c.TYPES[values.dtype.name], name=encode_text(image.name, "name"), vtk_type=vtk_type
    )
    volume.dimensions[:] = values.shape[::-1]
    volume.spacing[:] = image.spacing
    volume.origin[:] = image.origin
    volume.first_index[:] = image.first_index
    if image.direction is not None:
        volume.direction[:] = np.asarray(image.direction, float).reshape(9)
    return volume, values


def write_voxels(data, path, rates, block_size, arrays, progress):
    """Writes a volume. Returns the size of the file.

    Args:
        data: a volume of VTK, an Image or an array.
        path: of the file.
        rates: the values of rate controls by name, one of which is not None at most.
        block_size, arrays, progress: as of ``gatun.write``.
    """
    rate, value = _choose_rate(rates)
    if block_size != 0:
        check_number("block_size", block_size, 2, 64)
    if arrays is not None and len(arrays) != 1:
        raise ValueError(f"arrays: a .ghv file has one array, not {len(arrays)}")
    volume, values = _describe(*_take(data, arrays))
    buffer, call, written = to_buffer(values), Call(progress), _c.VolumeInfo()
    status = library.gatun_write_volume(
        encode(path),
        ctypes.byref(volume),
        ctypes.byref(buffer),
        block_size or _ONE_BLOCK,
        rate,
        value,
        *call.arguments,
        ctypes.byref(written),
    )
    call.check(status, path)
    return written.file_bytes
