# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A box with a field in it, who looks at it, and pictures."""

import os

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkCamera, vtkColorTransferFunction, vtkVolumeProperty
from vtkmodules.util.numpy_support import vtk_to_numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, factories of cameras
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

import gatunMeshes as gm
from gatun import vtkGatunReader, vtkGatunRayCaster, vtkGatunWriter

TEMP = os.environ["GATUN_TEST_TEMP"]
WIDTH, HEIGHT = 120, 90


def field(points):
    return (np.sin(points[:, 0] * 0.7) * np.cos(points[:, 1]) + points[:, 2] / 8).astype(np.float32)


def make_grid(n=10, order=None):
    points, tets = gm.lattice(n, permute=False)
    points = points * 10
    if order is not None:
        tets = tets[order.permutation(len(tets))]
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), field(points), "wave")
    gm.add_array(grid.GetPointData(), np.stack([points[:, 0]] * 3, 1), "vector")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)) % 7, "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def make_camera(parallel=False, azimuth=30, away=30):
    camera = vtkCamera()
    camera.SetFocalPoint(5, 5, 5)
    camera.SetPosition(5, 5, 5 + away)
    camera.Azimuth(azimuth)
    camera.Elevation(20)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(8)
    return camera


def make_property(low=-1, high=2.3, opacity=0.3):
    colours = vtkColorTransferFunction()
    colours.AddRGBPoint(low, 0.1, 0.2, 0.9)
    colours.AddRGBPoint(high, 0.9, 0.3, 0.1)
    opacities = vtkPiecewiseFunction()
    opacities.AddPoint(low, 0)
    opacities.AddPoint(high, opacity)
    result = vtkVolumeProperty()
    result.SetColor(colours)
    result.SetScalarOpacity(opacities)
    return result


def make_caster(source, **options):
    caster = vtkGatunRayCaster()
    if isinstance(source, vtkUnstructuredGrid):
        caster.SetInputData(source)
    else:
        caster.SetInputConnection(source.GetOutputPort())
    caster.SetCamera(make_camera())
    caster.SetProperty(make_property())
    caster.SetSize(WIDTH, HEIGHT)
    for name, value in options.items():
        getattr(caster, "Set" + name)(value)
    return caster


def picture_of(caster):
    caster.Update()
    data = caster.GetOutput().GetPointData()
    assert caster.GetOutput().GetDimensions() == (WIDTH, HEIGHT, 1)
    assert data.GetScalars().GetName() == "RGBA"
    return vtk_to_numpy(data.GetScalars()).copy(), vtk_to_numpy(data.GetArray("Depth")).copy()


def draw(source, **options):
    return picture_of(make_caster(source, **options))


def write(grid, name, chunk):
    writer = vtkGatunWriter()
    writer.SetInputData(grid)
    writer.SetFileName(os.path.join(TEMP, name))
    writer.SetChunkTets(chunk)
    assert writer.Write() == 1
    reader = vtkGatunReader()
    reader.SetFileName(os.path.join(TEMP, name))
    return reader


def check_same(a, b, bound=1 / 255):
    assert np.abs(a[0] - b[0]).max() <= bound, np.abs(a[0] - b[0]).max()
