# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The programs of Examples/Python make the pictures of the gallery, or print a table.

With --update, the pictures of the gallery become those that the programs make.
"""

import os
import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLES = os.path.join(ROOT, "Examples", "Python")
PICTURES = os.path.join(ROOT, "Documentation", "images", "gallery")
SHARED = {"shapes"}
LARGEST = 100 * 1024  # of a picture, in bytes


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[..., :3].astype(int)


def require_same(name, picture, wanted):
    assert picture.shape == wanted.shape, (name, picture.shape, wanted.shape)
    difference = np.abs(picture - wanted).max(axis=-1)
    # Edges of triangles differ between drivers, and nothing else may.
    assert difference.mean() < 1 and (difference > 32).mean() < 0.005, (
        name,
        difference.mean(),
        (difference > 32).mean(),
    )
    assert picture.std() > 10, name


folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
names = sorted(name[:-3] for name in os.listdir(EXAMPLES) if name.endswith(".py"))
names = [name for name in names if name not in SHARED]
assert len(names) == 10, names
with open(os.path.join(ROOT, "Documentation", "python-gallery.md"), encoding="ascii") as file:
    page = file.read()
made = set()
for name in names:
    result = subprocess.run(
        [sys.executable, "-W", "error", os.path.join(EXAMPLES, name + ".py"), folder],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    assert result.returncode == 0 and not result.stderr, (name, result.stderr)
    assert f"(../Examples/Python/{name}.py)" in page, name
    picture = os.path.join(folder, name + ".png")
    if not os.path.exists(picture):
        assert len(result.stdout.splitlines()) >= 2, (name, result.stdout)
        continue
    made.add(name + ".png")
    assert os.path.getsize(picture) <= LARGEST, (name, os.path.getsize(picture))
    assert f"(images/gallery/{name}.png)" in page, name
    if "--update" in sys.argv:
        shutil.copy(picture, PICTURES)
    require_same(name, read_picture(picture), read_picture(os.path.join(PICTURES, name + ".png")))
assert made == set(os.listdir(PICTURES)), made
