# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Finds the wrapped modules, which fit one VTK, in the folder for the VTK of this Python."""

import importlib.machinery
import os
import sys


class Finder:
    """Finds modules of a package in a folder that depends on VTK's version.

    Those for ParaView's VTK may be installed beside those for Python's own. VTK is only asked for its
    version when one of them is imported, so that the package works without VTK.
    """

    def __init__(self, package, modules):
        self._package = package
        self._names = {f"{package}.{module}" for module in modules}

    def find_spec(self, name, path=None, _target=None):
        """The specification of a module, as importlib asks for it."""
        if name not in self._names or not path:
            return None
        folder = self._find_folder(os.path.dirname(sys.modules[self._package].__file__))
        return importlib.machinery.PathFinder.find_spec(name, [folder])

    def _find_folder(self, root):
        try:
            from vtkmodules.vtkCommonCore import vtkVersion
        except ModuleNotFoundError as error:
            raise ImportError(
                f"the classes of {self._package} need VTK for Python, which is not installed ({error})"
            ) from None
        version = vtkVersion.GetVTKVersion()
        folder = os.path.join(root, "vtk" + version, self._package)
        if not os.path.isdir(folder):
            raise ImportError(
                f"{self._package} has no modules for VTK {version}: there is no {folder}"
            )
        return folder


def install(package, modules):
    """Makes Python find the modules of the package."""
    sys.meta_path.append(Finder(package, modules))
