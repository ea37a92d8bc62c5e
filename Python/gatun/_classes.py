# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The wrapped classes that functions of the package use."""


def get_class(name):
    """Returns a wrapped class.

    Raises:
        ImportError: there are no wrapped classes for the VTK of this Python, or this one was not built.
    """
    from . import vtk

    try:
        return getattr(vtk, name)
    except AttributeError:
        raise ImportError(f"this build of Gatun has no {name}") from None
