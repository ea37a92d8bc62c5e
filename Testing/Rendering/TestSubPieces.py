# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkPolyDataMapper with sub-pieces draws an isosurface that VTK makes of a file piece by piece: the
image is that of the whole surface, and takes a part of the memory."""

import json
import os
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkContourGrid
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # pylint: disable=unused-import

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader

N = 56
PIECES = 24
SIZE = 200


def peak_memory():
    """The most memory that was ever resident, in MiB."""
    with open("/proc/self/status", encoding="ascii") as file:
        lines = dict(line.split(":", 1) for line in file)
    return int(lines["VmHWM"].split()[0]) / 1024


class Scene:
    """A window with an isosurface of a file."""

    def __init__(self, pieces):
        self.reader, self.surface = vtkGatunReader(), vtkContourGrid()
        self.reader.SetMemoryBudget(8)
        self.surface.SetInputConnection(self.reader.GetOutputPort())
        self.surface.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        self.surface.SetValue(0, 0.4)
        self.surface.ComputeNormalsOff()
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputConnection(self.surface.GetOutputPort())
        self.mapper.SetScalarVisibility(0)
        self.mapper.SetNumberOfSubPieces(pieces)
        actor = vtkActor()
        actor.SetMapper(self.mapper)
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.AddActor(actor)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(2.5, 1.9, 3.1)
        camera.SetFocalPoint(0.5, 0.5, 0.5)
        camera.SetClippingRange(0.5, 10)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)

    def draw(self, path):
        """The image of a file."""
        self.reader.SetFileName(path)
        self.window.Render()
        assert self.reader.GetErrorCode() == 0
        pixels = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels)
        return vtk_to_numpy(pixels).reshape(SIZE, SIZE, 4)[..., :3].astype(int)


def run(path, small, pieces, image):
    """In a process of its own: draws, and prints the memory that it took."""
    scene = Scene(pieces)
    scene.draw(small)  # libraries, threads, window
    before = peak_memory()
    np.save(image, scene.draw(path))
    print("RESULT " + json.dumps(peak_memory() - before))


def draw(path, small, pieces):
    image = gm.temporary("sub-pieces-%d.npy" % pieces)
    made = subprocess.run([sys.executable, __file__, path, small, str(pieces), image], check=True,
                          stdout=subprocess.PIPE, encoding="utf-8")
    line = next(line for line in made.stdout.splitlines() if line.startswith("RESULT "))
    return np.load(image), json.loads(line[7:])


def write(n, name):
    points, tets = gm.lattice(n)
    path = gm.temporary(name)
    grid = gm.make_grid(points, tets)
    wave = np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    gm.write(grid, path, ChunkSize=8192)
    return path


def main():
    if not os.path.exists("/proc/self/status"):
        sys.exit(gm.SKIPPED)
    path, small = write(N, "sub-pieces.gtn"), write(3, "sub-pieces-small.gtn")
    whole, taken = draw(path, small, 1)
    pieces, taken_by_pieces = draw(path, small, PIECES)
    print("memory of the whole surface: %.0f MiB, of pieces: %.0f MiB" % (taken, taken_by_pieces))
    covered = (whole.sum(2) > 0).mean()
    assert whole.max() > 150 and 0.05 < covered < 0.9, covered
    # Edges between pieces may be drawn by either.
    assert (abs(whole - pieces).max(2) > 8).mean() < 0.002, abs(whole - pieces).max()
    assert taken > 50 and taken_by_pieces < taken / 2, (taken, taken_by_pieces)


if len(sys.argv) > 1:
    run(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4])
else:
    main()
