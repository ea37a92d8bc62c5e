# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What PyVista reads and saves .gtn and .ghv files with, by the entry points of the package."""

from __future__ import annotations

from typing import Any

from ._reading import read as _read
from ._writing import write as _write


def read(path: str, **options: Any) -> Any:
    """Reads a file, also from its address, for ``pyvista.read``. The options are those of ``gatun.read``."""
    return _read(path, to="pyvista", **options)


def write(mesh: Any, path: str, **options: Any) -> None:
    """Writes a mesh or a volume for its method ``save``, which replaces a file. The options are those of
    ``gatun.write``."""
    _write(mesh, path, **{"overwrite": True, **options})
