# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Helpers for tests of what libgatun reads."""

import dataclasses
import glob
import os

import numpy as np

FOLDER = os.path.join(os.environ["GATUN_TEST_DATA"], "Golden")

# The list of vtkPolyData that cells of a type are in.
_LISTS = np.zeros(256, int)
_LISTS[[3, 4]] = 1
_LISTS[[5, 7, 9]] = 2
_LISTS[6] = 3


def golden_files(ending):
    """The paths of all golden files with an ending."""
    return sorted(glob.glob(os.path.join(FOLDER, "*" + ending)))


def sort_surface(grid):
    """A grid of a surface with its cells in the order of vtkPolyData."""
    order = np.argsort(_LISTS[grid.types], kind="stable")
    cells = np.split(grid.connectivity, grid.offsets[1:-1]) if len(grid.types) else []
    return dataclasses.replace(
        grid,
        connectivity=np.concatenate([grid.connectivity[:0]] + [cells[i] for i in order]),
        offsets=np.cumsum(np.concatenate([[0], np.diff(grid.offsets)[order]])).astype(grid.offsets.dtype),
        types=grid.types[order],
        cell_data={key: values[order] for key, values in grid.cell_data.items()},
    )


def require_same_bytes(one, other):
    """Two arrays have the same bytes, whatever their types."""
    one, other = np.ascontiguousarray(one), np.ascontiguousarray(other)
    assert one.nbytes == other.nbytes and one.tobytes() == other.tobytes(), (one, other)


def require_same_fields(one, other):
    """The same field data."""
    assert list(one) == list(other), (list(one), list(other))
    for key, values in one.items():
        if isinstance(values, list):
            assert values == other[key], (key, values, other[key])
        else:
            require_same_bytes(values, other[key])


def require_same_grids(one, other):
    """Two grids have the same points, cells, arrays and field data, bit for bit."""
    for name in ("points", "connectivity", "offsets", "types"):
        a, b = getattr(one, name), getattr(other, name)
        assert a.dtype == b.dtype and a.shape == b.shape, (name, a.dtype, b.dtype, a.shape, b.shape)
        require_same_bytes(a, b)
    assert (one.faces is None) == (other.faces is None)
    if one.faces is not None:
        require_same_bytes(one.faces, other.faces)
        require_same_bytes(one.face_locations, other.face_locations)
    for name in ("point_data", "cell_data"):
        a, b = getattr(one, name), getattr(other, name)
        assert list(a) == list(b), (name, list(a), list(b))
        for key, values in a.items():
            assert values.dtype == b[key].dtype and values.shape == b[key].shape, key
            require_same_bytes(values, b[key])
    require_same_fields(one.field_data, other.field_data)
    assert one.time == other.time
