# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The contents of files."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any

from ._build import program
from ._errors import Error
from ._reading import is_volume, open_reader
from ._types import Path


def _find_program():
    """The gtn program that belongs to this package, or else the one in the path."""
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), program)
    found = os.environ.get("GATUN_GTN") or (program and shutil.which(beside)) or shutil.which("gtn")
    if not found:
        raise Error("the program gtn, which describes files, is not installed")
    return found


def info(path: Path) -> dict[str, Any]:
    """Describes a .gtn or .ghv file: what ``gtn info --json`` or ``gtn volume info --json`` prints.

    This runs the program gtn. Of the file, only the directory is read.

    Args:
        path: the file.

    Returns:
        A dictionary with, among others, ``"points"``, ``"cells"``, ``"bounds"``, ``"times"``,
        ``"arrays"`` and ``"sizes"``; of a volume ``"size"``, ``"range"`` and ``"bitsPerVoxel"``.

    Raises:
        OSError: the file cannot be opened.
        Error: the file is damaged, no file of Gatun, or there is no program gtn.
    """
    path = os.fsdecode(path)
    command = ["volume", "info"] if is_volume(open_reader(path)) else ["info"]
    # "./" keeps a name that begins with "-" from being an option.
    name = path if os.path.isabs(path) else os.path.join(os.curdir, path)
    result = subprocess.run(
        [_find_program(), *command, "--json", name], capture_output=True, check=False
    )
    if result.returncode:
        message = result.stderr.decode(errors="replace").strip()
        raise Error(message.removeprefix("gtn: ") or f"{path}: gtn failed")
    return json.loads(result.stdout)
