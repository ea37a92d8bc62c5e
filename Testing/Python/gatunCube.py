# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A cube of tetrahedra as arrays, and what tests of the package's functions share."""

import os
import pathlib
import sys

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Python"))

import shapes  # noqa: E402  (in the folder just added)

N = 9


def make_cube(n=N):
    """The cube of the examples, with points from 0 to 1."""
    points, tets = shapes.make_cube(n)
    return (points + 1) / 2, tets


def find(name):
    """The path of a file in a folder of this test alone."""
    folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name)


def require_equal(a, b):
    """The arrays have the same type, shape and bytes."""
    a, b = np.asarray(a), np.asarray(b)
    assert a.dtype == b.dtype and a.shape == b.shape, (a.dtype, b.dtype, a.shape, b.shape)
    assert a.tobytes() == b.tobytes()


def require_raises(kind, text, function, *args, **kwargs):
    """The call raises an exception of the kind, exactly, whose text has the given one."""
    try:
        function(*args, **kwargs)
    except Exception as error:
        assert type(error) is kind, (type(error), error)
        assert text in str(error), (text, str(error))
        return error
    raise AssertionError(f"nothing raised: {args} {kwargs}")
