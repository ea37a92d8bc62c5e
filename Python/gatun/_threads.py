# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The threads of the library."""

from __future__ import annotations

from ._library import library


def set_threads(threads: int) -> None:
    """Sets the number of threads that files are read and written with, in the whole process.

    It is for what needs no VTK; VTK has threads of its own.

    Args:
        threads: their number; 0 for the default: one for each processor that the process may use.
    """
    if int(threads) != threads or not 0 <= threads <= 0x7FFFFFFF:
        raise ValueError(f"threads: {threads!r} is not 0 or more")
    library.gatun_set_threads(int(threads))


def get_threads() -> int:
    """Returns the number of threads that files are read and written with."""
    return library.gatun_threads()
