# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Pictures that gtn render makes, as arrays whose first row is the lowest."""

import subprocess

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from gatunCli import skip


def to_array(image, name=None):
    """An array of a vtkImageData, as rows, columns, components."""
    data = image.GetPointData()
    values = vtk_to_numpy(data.GetArray(name) if name else data.GetScalars())
    width, height, _ = image.GetDimensions()
    return values.reshape(height, width, -1)


def read_png(name):
    """Values of 0 to 255."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    return to_array(reader.GetOutput()).astype(int)


def run_oiiotool(*arguments):
    try:
        run = subprocess.run(
            ["oiiotool", *arguments],
            stdout=subprocess.PIPE,
            check=True,
            timeout=60,
            universal_newlines=True,
        )
    except FileNotFoundError:
        skip("there is no oiiotool")
    return run.stdout


def read_exr(name, width, height):
    """Values of all channels."""
    values = []
    for line in run_oiiotool("--dumpdata", name).splitlines():
        if "Pixel (" in line:
            values.append([float(value) for value in line.split("):")[1].split()])
    return np.array(values).reshape(height, width, -1)[::-1]
