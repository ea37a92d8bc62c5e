# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes of files as VTK has them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData

from ._description import Array
from ._types import Progress
from ._volume import Volume
from ._vtk_arrays import Filler


def read_volume(
    volume: Volume, first: Sequence[int] | None, end: Sequence[int] | None, progress: Progress | None
) -> vtkImageData:
    """Reads voxels of a volume.

    Args:
        volume: the volume.
        first, end, progress: as for ``Volume.read``.
    """
    fillers = []

    def allocate(name: str, dtype: np.dtype, shape: tuple[int, ...]) -> np.ndarray:
        array = Array(name, name, False, dtype, 1, vtk_type=volume.vtk_type)
        fillers.append(Filler(array, (int(np.prod(shape)),)))
        return fillers[0].values.reshape(shape)

    values = volume.read(first, end, allocate=allocate, progress=progress)
    image = vtkImageData()
    starts = [a + b for a, b in zip(volume.first_index, first or (0, 0, 0))]
    image.SetExtent([n for low, size in zip(starts, values.shape[::-1]) for n in (low, low + size - 1)])
    image.SetOrigin(volume.origin)
    image.SetSpacing(volume.spacing)
    image.SetDirectionMatrix(volume.direction.ravel().tolist())
    image.GetPointData().SetScalars(fillers[0].finish())
    return image
