# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images of files and data."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._file import File
from ._open import is_source, opened
from ._pixels import require_solid


def _draw_by_vtk(source, options):
    try:
        from ._vtk_rendering import draw
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] != "vtkmodules":
            raise
        raise ImportError(f"only files of meshes with 3D cells are drawn without VTK for Python ({error})") from None
    return draw(source, **options)


def render(source: Any, **options: Any) -> np.ndarray:
    """Draws a mesh or a volume as a volume, or a surface, into an image.

    A file is drawn as it is, without reading more than what is seen. Meshes and volumes need no
    display and no graphics card. Files of meshes with 3D cells need no VTK; all else needs the classes of
    ``gatun.vtk``. Surfaces are drawn by OpenGL, which needs a display.

    Args:
        source: what ``gatun.open`` takes, such as a path, or data as ``write`` takes it, series excepted.
        options: those of ``gatun.File.render``, with these differences. ``blend`` of volumes is
            ``"composite"``, ``"exponential"`` or ``"xray"``, and their projection is parallel. With ``"mip"``,
            opacities grow with the values. Surfaces are opaque. ``level`` and ``progress`` are for files of
            meshes with 3D cells.

    Returns:
        An array of height x width x 4: red, green, blue and opacity, the top row first. Colors are not
        multiplied by the opacity.

    Raises:
        OSError: the file cannot be opened.
        ImportError: there are no classes of ``gatun.vtk``, and they are needed.
        ValueError: a parameter that does not fit, or data without cells or arrays.
        TypeError: data that cannot be drawn.
        Error: the file is damaged, no file of Gatun, or there is no display for a surface.
    """
    if not is_source(source):
        return _draw_by_vtk(source, options)
    with opened(source) as file:
        if not isinstance(file, File) or file.is_surface:
            return _draw_by_vtk(file, options)
        kinds = file.info.get("cellTypes", [])  # of tetrahedra alone, there are none
        require_solid(file.file_name, {(kind["name"], kind["dimension"]): kind["cells"] for kind in kinds})
        return file.render(**options)
