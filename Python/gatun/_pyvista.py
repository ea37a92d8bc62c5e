# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What PyVista reads and saves .gtn and .ghv files with, by the entry points of the package."""

from __future__ import annotations

import os
from typing import Any

from ._reading import read as _read
from ._writing import write as _write


def read(path: str, **options: Any) -> Any:
    """Reads a file for ``pyvista.read``. The options are those of ``gatun.read``."""
    import pyvista

    path = os.fsdecode(path)
    if "://" in path:
        raise pyvista.LocalFileRequiredError  # PyVista downloads the file then
    return pyvista.wrap(_read(path, **options))


def write(mesh: Any, path: str, **options: Any) -> None:
    """Writes a mesh or a volume for its method ``save``, which replaces a file. The options are those of
    ``gatun.write``."""
    _write(mesh, path, **{"overwrite": True, **options})
