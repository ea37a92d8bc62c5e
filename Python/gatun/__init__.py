# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Losslessly compressed unstructured meshes, and compressed volumes.

    >>> import gatun
    >>> mesh = gatun.read("mesh.gtn")                    # a vtkUnstructuredGrid
    >>> grid = gatun.read("mesh.gtn", to="numpy")        # NumPy arrays, which need no VTK
    >>> part = gatun.read("https://example.org/mesh.gtn", box=(0, 1, 0, 1, 0, 1))
    >>> gatun.write(mesh, "copy.gtn", tolerances="rel:1e-3")
    >>> image = gatun.render("mesh.gtn", size=(800, 600))  # an array of 600 x 800 x 4 bytes

An open file tells what it has, and is read in parts:

    >>> with gatun.open("mesh.gtn") as file:
    ...     grid = file.read(step=-1, arrays="pressure")
    >>> gatun.write(grid, "copy.gtn")

Files are read and written by a library that needs no VTK. The classes of VTK are in ``gatun.vtk``, where the package
was built for the VTK of this Python. Documentation/python.md is the guide.
"""

import importlib as _importlib

from ._build import version as __version__

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
    "contour": "_reading",
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
    "slice": "_reading",
    "steps": "_info",
    "to_meshio": "_meshio",
    "to_numpy": "_arrays",
    "verify": "_info",
    "write": "_writing",
    "write_parts": "_parts",
}


def __getattr__(name):
    if name == "vtk":
        return _importlib.import_module(".vtk", __name__)
    if name not in _members:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = globals()[name] = getattr(_load(name), name)
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
    return sorted({*globals(), *_members, "vtk"})
