# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The memory of the system."""

import pathlib


def read(name):
    """An entry of /proc/meminfo, such as MemAvailable, in bytes; 0 if it is missing."""
    for line in pathlib.Path("/proc/meminfo").read_text(encoding="utf-8").splitlines():
        if line.startswith(name + ":"):
            return 1024 * int(line.split()[1])
    return 0
