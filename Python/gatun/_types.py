# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Types of parameters."""

import os
from collections.abc import Callable, Iterable
from typing import Any, Union

import numpy as np

#: The path of a file.
Path = Union[str, "os.PathLike[str]"]

#: A path, an address, the bytes of a file, or an object with ``size`` and ``read(offset, length)``.
Source = Union[Path, bytes, bytearray, memoryview, Any]

#: A function of the fraction from 0 to 1 that is done, which may return False to stop.
Progress = Callable[[float], Any]

#: A function that makes an array of a name, type and shape.
Allocate = Callable[[str, np.dtype, "tuple[int, ...]"], np.ndarray]

#: Names of arrays, or one of them.
Names = Union[str, Iterable[str]]


def list_names(names):
    """Returns names as a list, or None for None."""
    if names is None:
        return None
    return [names] if isinstance(names, str) else list(names)
