# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Losslessly compressed unstructured meshes, and compressed volumes.

Convenience functions for files and images:

    >>> import gatun
    >>> mesh = gatun.read("mesh.gtn")                    # a vtkUnstructuredGrid
    >>> gatun.write(mesh, "copy.gtn", tolerances="rel:1e-3")
    >>> image = gatun.render("mesh.gtn", size=(800, 600))  # an array of 600 x 800 x 4 bytes

These need VTK. Files are read and written as NumPy arrays without it, also from the web:

    >>> with gatun.open("mesh.gtn") as file:
    ...     grid = file.read(step=-1, arrays="pressure")
    >>> gatun.write(grid, "copy.gtn")

Every class of VTK can be had from the package, too, as in ``from gatun import vtkGatunReader``. A module of
classes is only loaded once one of its classes is used. Documentation/python.md is the guide.
"""

import importlib as _importlib

from ._build import modules as _modules
from ._build import version as __version__

# Modules of VTK classes are found once VTK is asked for.
_importlib.import_module("._finder", __name__).install(__name__, _modules)

# The public functions and types, and the module of each.
_members = {
    "Error": "_exceptions",
    "File": "_file",
    "Grid": "_grid",
    "HttpSource": "_http",
    "Image": "_voxels",
    "InputError": "_exceptions",
    "Mesh": "_cells",
    "NotHere": "_exceptions",
    "Volume": "_volume",
    "Writer": "_write",
    "from_meshio": "_meshio",
    "from_numpy": "_arrays",
    "get_threads": "_threads",
    "image_from_numpy": "_arrays",
    "image_to_numpy": "_arrays",
    "info": "_info",
    "open": "_open",
    "read": "_reading",
    "render": "_rendering",
    "save_png": "_images",
    "set_threads": "_threads",
    "steps": "_reading",
    "to_meshio": "_meshio",
    "to_numpy": "_arrays",
    "write": "_writing",
    "write_parts": "_parts",
}


def __getattr__(name):
    found = None
    if name in _members:
        found = getattr(_load(name), name)
    elif name in _modules:
        return _importlib.import_module("." + name, __name__)
    elif name.startswith("vtk"):
        if not _modules:
            raise ImportError(f"this package of gatun has no classes of VTK, as {name}")
        found = _importlib.import_module("._classes", __name__).find_class(name)
    if found is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found


def _load(name):
    """The module of a member. Some need VTK."""
    try:
        return _importlib.import_module("." + _members[name], __name__)
    except ModuleNotFoundError as error:
        if error.name.partition(".")[0] != "vtkmodules":
            raise
        raise ImportError(f"gatun.{name} needs VTK for Python, which is not installed ({error})") from None


def __dir__():
    try:
        classes = _importlib.import_module("._classes", __name__).list_classes()
    except ImportError:  # without VTK
        classes = ()
    return sorted({*globals(), *_members, *classes})
