# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The contents of files."""

from __future__ import annotations

from typing import Any

from ._open import opened
from ._types import Progress, Source
from ._volume import Volume


def info(source: Source) -> dict[str, Any]:
    """Describes a .gtn or .ghv file: what ``gtn info --json`` or ``gtn volume info --json`` prints.

    Of the file, only the directory is read.

    Args:
        source: as for ``read``.

    Returns:
        A dictionary with, among others, ``"points"``, ``"cells"``, ``"bounds"``, ``"times"``,
        ``"arrays"`` and ``"sizes"``; of a volume ``"size"``, ``"range"`` and ``"bitsPerVoxel"``.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, or no file of Gatun.
    """
    with opened(source) as file:
        return file.info


def steps(source: Source) -> list[float]:
    """Returns the times of the time steps of a file as a list, empty for a file without time.

    Args:
        source: as for ``read``.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, or no file of Gatun.
    """
    with opened(source) as file:
        return [] if isinstance(file, Volume) else file.times


def verify(source: Source, *, progress: Progress | None = None) -> None:
    """Checks all checksums of a file, and decodes everything.

    Args:
        source: as for ``read``.
        progress: a function of the fraction that is done; it may return False to stop.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, or no file of Gatun.
    """
    with opened(source) as file:
        file.verify(progress)
