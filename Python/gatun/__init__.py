# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Losslessly compressed unstructured meshes, and compressed volumes, for VTK.

Convenience functions for files and images:

    >>> import gatun
    >>> mesh = gatun.read("mesh.gtn")                    # a vtkUnstructuredGrid
    >>> gatun.write(mesh, "copy.gtn", tolerances="rel:1e-3")
    >>> image = gatun.render("mesh.gtn", size=(800, 600))  # an array of 600 x 800 x 4 bytes

Every class can be had from the package, too, as in ``from gatun import vtkGatunReader``. A module of
classes is only loaded once one of its classes is used. Documentation/python.md is the guide.
"""

import importlib as _importlib
import os as _os

from vtkmodules.vtkCommonCore import vtkVersion as _vtkVersion

from ._build import modules as _modules
from ._build import version as __version__

# Wrapped modules fit one VTK. Those for ParaView's may be installed beside those for Python's own.
_folder = _os.path.join(__path__[0], "vtk" + _vtkVersion.GetVTKVersion(), "gatun")
if not _os.path.isdir(_folder):
    raise ImportError(f"gatun has no modules for VTK {_vtkVersion.GetVTKVersion()}: there is no {_folder}")
__path__.append(_folder)

# The public functions and types, and the module of each.
_members = {
    "Error": "_errors",
    "InputError": "_errors",
    "Mesh": "_arrays",
    "from_meshio": "_meshio",
    "from_numpy": "_arrays",
    "image_from_numpy": "_arrays",
    "image_to_numpy": "_arrays",
    "info": "_info",
    "read": "_reading",
    "render": "_rendering",
    "save_png": "_images",
    "steps": "_reading",
    "to_meshio": "_meshio",
    "to_numpy": "_arrays",
    "write": "_writing",
}


def __getattr__(name):
    found = None
    if name in _members:
        found = getattr(_importlib.import_module("." + _members[name], __name__), name)
    elif name in _modules:
        return _importlib.import_module("." + name, __name__)
    elif name.startswith("vtk"):
        found = _importlib.import_module("._classes", __name__).find_class(name)
    if found is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found


def __dir__():
    classes = _importlib.import_module("._classes", __name__).list_classes()
    return sorted({*globals(), *_members, *classes})
