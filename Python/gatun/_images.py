# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images as arrays."""

from __future__ import annotations

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from ._pixels import to_bytes
from ._types import Path


def save_png(image: np.ndarray, path: Path) -> None:
    """Writes an image to a .png file.

    Args:
        image: height x width (gray), or height x width x 3 or 4 (RGB or RGBA, opacity not
            multiplied in), the top row first; bytes, or floats from 0 to 1.
        path: the file to write.

    Raises:
        OSError: the file cannot be written.
        ValueError: the array is no image.
    """
    from vtkmodules.vtkIOImage import vtkPNGWriter

    pixels = to_bytes(image)
    if pixels.ndim == 2:
        pixels = pixels[:, :, None]
    if pixels.ndim != 3 or pixels.shape[2] not in (1, 3, 4) or 0 in pixels.shape:
        raise ValueError(f"image: {np.shape(image)} is not the shape of an image")
    height, width, channels = pixels.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(pixels[::-1]).reshape(-1, channels)
    data.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(data)
    writer.WriteToMemoryOn()
    writer.Write()
    # VTK's own writing tells failures by messages only.
    with open(os.fsdecode(path), "wb") as file:
        file.write(bytes(memoryview(writer.GetResult())))
