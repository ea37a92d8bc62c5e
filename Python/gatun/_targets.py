# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What writers of files are told."""

import errno
import os

from ._types import list_names

_PROFILES = ("small", "fast")
_ORDERS = {"none": 0, "points": 1, "cells": 2, "corners": 4, "all": 7}


def check_target(path, overwrite, *endings):
    """Raises the exceptions of open() where a file cannot be put, without touching it, and for other formats."""
    path = os.fsdecode(path)
    folder = os.path.dirname(path) or "."
    if os.path.isdir(path):
        raise IsADirectoryError(errno.EISDIR, "Is a directory", path)
    try:
        os.stat(os.path.join(folder, "."))
    except OSError as error:  # FileNotFoundError, NotADirectoryError
        error.filename = folder
        raise
    if os.path.splitext(path)[1].lower() not in endings:
        raise ValueError(
            f"{path}: meshes are written to .gtn files, and volumes to .ghv files; other formats have writers "
            "of VTK and meshio"
        )
    if not overwrite and os.path.lexists(path):
        raise FileExistsError(errno.EEXIST, "File exists; overwrite=True replaces it", path)


def find_order(order):
    if isinstance(order, bool) or order is None:
        return _ORDERS["all" if order else "none"]
    names = list_names(order)
    unknown = [name for name in names if name not in _ORDERS]
    if unknown:
        there = ", ".join(map(repr, _ORDERS))
        raise ValueError(f"keep_order: {unknown[0]!r} is not known; there are {there}")
    flags = 0
    for name in names:
        flags |= _ORDERS[name]
    return flags


def find_profile(profile):
    if profile not in _PROFILES:
        there = ", ".join(map(repr, _PROFILES))
        raise ValueError(f"profile: {profile!r} is not known; there are {there}")
    return _PROFILES.index(profile)


def check_number(parameter, value, least, most):
    """Raises ValueError for a number out of its range. Returns it."""
    if not least <= value <= most:
        raise ValueError(f"{parameter}: {value!r} is not allowed; the range is {least} to {most}")
    return value


def check_bound(parameter, text, kinds):
    """Raises ValueError for a text that is none such as "abs:0.1,zeros". Returns whether zeros are kept."""
    bound, comma, zeros = text.partition(",")
    kind, _, number = bound.partition(":")
    try:
        if kind not in kinds or (comma and zeros != "zeros"):
            raise ValueError
        float(number)
    except ValueError:
        forms = ", ".join(f"'{k}:{'N' if k == 'bits' else 'E'}'" for k in kinds)
        raise ValueError(f"{parameter}: {text!r} is none of {forms}") from None
    return bool(comma)
