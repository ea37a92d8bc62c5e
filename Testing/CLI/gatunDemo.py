# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the demo, and looks at its pictures."""

import os
import shutil
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from gatunCli import PROGRAM, enter_folder, skip


def shown_part(picture):
    """How much of a picture, scale and caption left out, is not its background, which is the same
    all along each line. Thin meshes fill a twentieth."""
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    pixels = pixels[height // 7 :, : 5 * width // 6]
    different = np.abs(pixels.astype(int) - pixels[:, :1].astype(int)).max(axis=2) > 8
    return different.mean()


def run_demo(name, files):
    """Runs the demo on files, or on a small part of its own making for None."""
    if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
        skip("there is no display, nor xvfb-run")
    enter_folder(name)
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    environment = dict(os.environ)
    environment["GATUN_BUILD"] = os.path.dirname(os.path.dirname(PROGRAM))
    environment["GATUN_PYTHON"] = sys.executable
    for file in files:
        output = os.path.basename(file or "part")
        command = [os.path.join(root, "Utilities", "demo.sh"), "--size", "small", "--output", output]
        run = subprocess.run(
            command + ([file] if file else []),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            universal_newlines=True,
            check=False,
            env=environment,
            timeout=600,
        )
        print(run.stdout)
        assert run.returncode == 0, output
        assert "identical to" in run.stdout and "times .gtn" in run.stdout
        names = ["surface", "cut", "pieces", "volume"]
        # Of a mesh with an array of its points that is not the same everywhere, as the part's.
        if file is None or "isosurfaces.png" in run.stdout:
            names.append("isosurfaces")
        for name in names:
            picture = os.path.join(output, name + ".png")
            assert picture in run.stdout
            assert shown_part(picture) > 0.03, picture
