# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A cube of tetrahedra as arrays, and what tests of the package's functions share."""

import os

import numpy as np

N = 9


def make_cube(n=N):
    """Points from 0 to 1 and tetrahedra, six for each of the cells."""
    x = np.linspace(0, 1, n)
    points = np.stack(np.meshgrid(x, x, x, indexing="ij"), axis=-1).reshape(-1, 3)
    ids = np.arange(n**3).reshape(n, n, n)
    ends = (slice(None, -1), slice(1, None))
    corners = [ids[a, b, c].ravel() for a in ends for b in ends for c in ends]
    around = [(1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)]
    tets = [np.stack([corners[i] for i in (0, p, q, 7)], axis=1) for p, q in around]
    return points, np.concatenate(tets)


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
