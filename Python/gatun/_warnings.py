# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Warnings of the package."""

import sys
import warnings


def _count_own_frames():
    """The number of calls from the user's to that of this function."""
    frame, count = sys._getframe(1), 1
    while frame.f_back and frame.f_globals["__name__"].split(".")[0] in (__package__, "contextlib"):
        frame, count = frame.f_back, count + 1
    return count


def warn(text):
    """Warns of the line of the user that is run."""
    warnings.warn(text, stacklevel=_count_own_frames())
