# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The contents of files."""

from __future__ import annotations

import json
from typing import Any

from ._classes import get_class
from ._errors import raising
from ._reading import open_reader
from ._types import Path


def info(path: Path) -> dict[str, Any]:
    """Describes a .gtn or .ghv file: what ``gtn info --json`` or ``gtn volume info --json`` prints.

    Of the file, only the directory is read.

    Args:
        path: the file.

    Returns:
        A dictionary with, among others, ``"points"``, ``"cells"``, ``"bounds"``, ``"times"``,
        ``"arrays"`` and ``"sizes"``; of a volume ``"size"``, ``"range"`` and ``"bitsPerVoxel"``.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, or no file of Gatun.
    """
    reader = open_reader(path)
    description = get_class("vtkGatunFileDescription")()
    description.SetFileName(reader.GetFileName())
    with raising(description):
        text = description.ReadJSON()
    return json.loads(text)
