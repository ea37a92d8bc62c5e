# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images as numbers."""

import numpy as np

_MOST_PIXELS = 32000


def check_size(size):
    width, height = size
    for pixels in (width, height):
        if pixels != int(pixels) or not 1 <= pixels <= _MOST_PIXELS:
            raise ValueError(f"size: {tuple(size)} is not width and height, 1 to {_MOST_PIXELS}")
    return (int(width), int(height))


def check_type(dtype):
    """Raises ValueError unless images can have the type."""
    if dtype not in (np.uint8, np.float32):
        raise ValueError(f"dtype: {dtype!r} is neither uint8 nor float32")


def to_bytes(image):
    """Returns an image of floats from 0 to 1 as one of bytes."""
    image = np.asarray(image)
    if image.dtype == np.uint8:
        return image
    return np.rint(np.clip(np.nan_to_num(image), 0, 1) * 255).astype(np.uint8)


def finish_image(pixels, background, dtype):
    """Puts colors that are multiplied by their opacity over a background, or divides them."""
    opacity = pixels[..., 3:]
    if background is None:
        with np.errstate(divide="ignore", invalid="ignore"):
            colors = np.where(opacity > 0, pixels[..., :3] / opacity, 0)
    else:
        colors = pixels[..., :3] + (1 - opacity) * np.asarray(background, np.float32)
        opacity = np.ones_like(opacity)
    image = np.clip(np.concatenate([colors, opacity], axis=-1), 0, 1).astype(np.float32)
    return to_bytes(image) if dtype == np.uint8 else image


def require_solid(name, counts):
    """Raises ValueError for a mesh without 3D cells, in which rays meet nothing.

    Args:
        name: of the mesh.
        counts: the numbers of cells by name and dimension of their type.
    """
    if counts and all(dimension < 3 for _, dimension in counts):
        there = ", ".join(f"{count} {cell}" for (cell, _), count in counts.items())
        raise ValueError(
            f"{name}: has no 3D cells, only {there}; vtkGeometryFilter makes a surface of 2D cells, "
            "which can be drawn"
        )
