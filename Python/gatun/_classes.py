# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The wrapped classes, found by name; a module is loaded once one of its classes is used."""

import importlib

from ._build import modules


def load_module(name):
    """Returns one of the wrapped modules."""
    return importlib.import_module("." + name, __package__)


def load_modules():
    """Yields the wrapped modules."""
    return map(load_module, modules)


def find_class(name):
    """Returns a wrapped class, or None if there is none of the name."""
    for module in load_modules():
        found = getattr(module, name, None)
        if found is not None:
            return found
    return None


def get_class(name):
    """Returns a wrapped class that is known to be there, as far as it was built.

    Raises:
        ImportError: the class belongs to a module that was not built.
    """
    found = find_class(name)
    if found is None:
        raise ImportError(f"this build of Gatun has no {name}")
    return found


def list_classes():
    """Returns the names of all wrapped classes."""
    return [
        name
        for module in load_modules()
        for name in vars(module)
        if name.startswith("vtk")
    ]
