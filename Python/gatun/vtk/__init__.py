# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The classes of VTK: readers, writers, filters and mappers, as in ``from gatun.vtk import vtkGatunReader``.

They fit the VTK that they were built for only. A module of classes is loaded once one of its classes is used.
"""

import importlib as _importlib
import os as _os

from .._build import modules as _modules


def _find_folder():
    """The folder of the modules for the VTK of this Python. Those for several VTKs may be installed together."""
    root = _os.path.dirname(_os.path.abspath(__file__))
    there = sorted(name[3:] for name in _os.listdir(root) if name[:3] == "vtk" and name[3:4].isdigit())
    if not _modules or not there:
        raise ImportError("this package of gatun has no classes of VTK; gatun.read and the like do without them")
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
    except ModuleNotFoundError as error:
        raise ImportError(f"gatun.vtk needs VTK for Python, which is not installed ({error})") from None
    version = vtkVersion.GetVTKVersion()
    if version not in there:
        raise ImportError(f"gatun.vtk has no classes for VTK {version}, only for VTK {', '.join(there)}")
    return _os.path.join(root, "vtk" + version, "gatun", "vtk")


__path__.append(_find_folder())


def __getattr__(name):
    if name in _modules:
        return _importlib.import_module("." + name, __name__)
    if name.startswith("vtk"):
        for module in _modules:
            found = getattr(_importlib.import_module("." + module, __name__), name, None)
            if found is not None:
                globals()[name] = found
                return found
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    names = set(globals())
    for module in _modules:
        names.update(name for name in dir(_importlib.import_module("." + module, __name__)) if name.startswith("vtk"))
    return sorted(names)
