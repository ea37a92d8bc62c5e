# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Each program of the gallery runs without a warning, and draws a picture or prints a table."""

import os
import pathlib
import shutil
import subprocess
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = (ROOT / "Documentation" / "python-gallery.md").read_text(encoding="ascii")
FOLDER = pathlib.Path(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])


def run(program):
    result = subprocess.run([sys.executable, "-W", "error", program, FOLDER], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, check=False)
    assert result.returncode == 0 and not result.stderr, (program.name, result.stderr)
    return result.stdout


def is_empty(picture):
    """Whether a picture has hardly more than one color."""
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].std() < 10


shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
programs = [file for file in sorted((ROOT / "Examples" / "Python").glob("*.py")) if file.stem != "shapes"]
assert programs
for program in programs:
    table = run(program)
    assert f"(../Examples/Python/{program.name})" in PAGE, program.name
    picture = FOLDER / f"{program.stem}.png"
    if f"(images/gallery/{picture.name})" in PAGE:
        assert not is_empty(picture), picture.name
    else:
        assert len(table.splitlines()) >= 2, (program.name, table)
