# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes as volumes: in a window, and as vtkGatunRayCaster makes the same picture without one."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws)
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  (draws volumes)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkVolume, vtkVolumeProperty)

import gatunMeshes as gm
from gatun.vtk import vtkGatunRayCaster, vtkGatunReader, vtkGatunVolumeMapper

BACKGROUND = (0.1, 0.2, 0.4)
WIDTH, HEIGHT = 120, 90  # of pictures without a window


# --------------------------------------------------------------------------------------------------
# What there is to see


def wave(n=8, dtype=np.float32, seed=1):
    """The unit cube with a field from 0 to 1 that changes in all directions."""
    points, tets = gm.lattice(n, seed=seed, dtype=dtype)
    grid = gm.make_grid(points, tets)
    x, y, z = points.T
    field = (0.5 + 0.5 * np.sin(6 * x + 2 * y) * np.cos(5 * z - y)).astype(np.float32)
    gm.add_array(grid.GetPointData(), field, "wave")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def constant(n=2, value=0.5):
    """The unit cube with one value."""
    points, tets = gm.lattice(n)
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), np.full(len(points), value, np.float32), "constant")
    grid.GetPointData().SetActiveScalars("constant")
    return grid


def box(n=10, order=None):
    """A box of 10 with arrays of points and cells; its cells in another order if a generator of
    random numbers is given."""
    points, tets = gm.lattice(n, permute=False)
    points = points * 10
    if order is not None:
        tets = tets[order.permutation(len(tets))]
    grid = gm.make_grid(points, tets)
    x, y, z = points.T
    field = np.sin(x * 0.7) * np.cos(y) + z / 8
    gm.add_array(grid.GetPointData(), field.astype(np.float32), "wave")
    gm.add_array(grid.GetPointData(), np.stack([x] * 3, 1), "vector")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)) % 7, "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def write(grid, name, chunk):
    """Into a file; returns a reader of it."""
    reader = vtkGatunReader()
    reader.SetFileName(gm.temporary(name))
    gm.write(grid, reader.GetFileName(), ChunkSize=chunk)
    return reader


def cube(bounds=(0, 1, 0, 1, 0, 1), color=(1, 1, 1)):
    """An opaque actor that has no shades."""
    source = vtkCubeSource()
    source.SetBounds(*bounds)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(*color)
    return actor


# --------------------------------------------------------------------------------------------------
# How it looks, and from where

RAINBOW = ((0, (0, 0.2, 1)), (0.5, (0.2, 1, 0.2)), (1, (1, 0.3, 0)))


def make_property(opacity=((0, 0.0), (0.3, 0.1), (1, 0.9)), unit=0.2, colors=RAINBOW):
    """Colors at some values, by default blue to red, and opacities over a unit of length."""
    prop = vtkVolumeProperty()
    color_function = vtkColorTransferFunction()
    for value, color in colors:
        color_function.AddRGBPoint(value, *color)
    opacities = vtkPiecewiseFunction()
    for value, amount in opacity:
        opacities.AddPoint(value, amount)
    prop.SetColor(color_function)
    prop.SetScalarOpacity(opacities)
    prop.SetScalarOpacityUnitDistance(unit)
    return prop


def box_property(unit=1):
    """For the field "wave" of the box."""
    colors = (-1, (0.1, 0.2, 0.9)), (2.3, (0.9, 0.3, 0.1))
    return make_property(((-1, 0), (2.3, 0.3)), unit, colors)


def box_camera(azimuth=30):
    """Looks at the box."""
    camera = vtkCamera()
    camera.SetFocalPoint(5, 5, 5)
    camera.SetPosition(5, 5, 35)
    camera.Azimuth(azimuth)
    camera.Elevation(20)
    return camera


# --------------------------------------------------------------------------------------------------
# Pictures


def connect(consumer, source):
    """Of a grid or of an algorithm."""
    if hasattr(source, "GetOutputPort"):
        consumer.SetInputConnection(source.GetOutputPort())
    else:
        consumer.SetInputDataObject(0, source)


class Scene:
    """A window with a volume in it."""

    def __init__(self, source, size=(160, 120), prop=None, viewport=None, **options):
        self.mapper = vtkGatunVolumeMapper()
        connect(self.mapper, source)
        self.source = source  # the Python half of a source must be kept alive by somebody
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.SetProperty(prop or make_property())
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(BACKGROUND)
        if viewport:
            self.renderer.SetViewport(*viewport)
        self.renderer.AddVolume(self.volume)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.set(**options)
        self.camera = self.renderer.GetActiveCamera()
        self.look(1.2, 0.7)

    def set(self, **options):
        """Of the mapper."""
        gm.set_options(self.mapper, **options)

    def look(self, azimuth=0.0, elevation=0.0, distance=3.0, parallel=False):
        """From a direction, at the middle of the unit cube."""
        direction = np.array([
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
            np.cos(elevation) * np.cos(azimuth)])
        middle = np.array([0.5, 0.5, 0.5])
        self.camera.SetFocalPoint(*middle)
        self.camera.SetPosition(*(middle + distance * direction))
        self.camera.SetViewUp(0, 1, 0)
        self.camera.SetParallelProjection(parallel)
        self.camera.SetParallelScale(0.9)
        self.camera.SetClippingRange(0.01, 100)

    def render(self):
        self.window.Render()
        return self.pixels()

    def pixels(self):
        """Red, green, blue and alpha of the window, 0 to 1, row by row from below."""
        width, height = self.window.GetSize()
        data = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, data)
        return vtk_to_numpy(data).reshape(height, width, 4).astype(float) / 255


def make_caster(source, **options):
    """vtkGatunRayCaster that looks at the box."""
    caster = vtkGatunRayCaster()
    connect(caster, source)
    caster.SetCamera(box_camera())
    caster.SetProperty(box_property())
    caster.SetSize(WIDTH, HEIGHT)
    gm.set_options(caster, **options)
    return caster


def picture_of(caster):
    """What it draws."""
    caster.Update()
    return made_by(caster)


def made_by(caster):
    """Colors as (height, width, 4) and depths as (height, width) of what it has drawn."""
    image = caster.GetOutput()
    width, height, _ = image.GetDimensions()
    assert (width, height) == caster.GetSize()
    data = image.GetPointData()
    assert data.GetScalars().GetName() == "RGBA"
    colors = vtk_to_numpy(data.GetScalars()).reshape(height, width, 4).astype(float)
    return colors, vtk_to_numpy(data.GetArray("Depth")).reshape(height, width).copy()


def draw(source, **options):
    return picture_of(make_caster(source, **options))


def cast(scene, source, size, **options):
    """What vtkGatunRayCaster makes of a scene, as (height, width, 4)."""
    return draw(
        source, Camera=scene.camera, Property=scene.volume.GetProperty(),
        VolumeMatrix=scene.volume.GetMatrix(), Size=tuple(size), **options)[0]


def over(rgba, background=BACKGROUND):
    """A picture in front of a color: red, green and blue."""
    return rgba[..., :3] + (1 - rgba[..., 3:]) * np.array(background)


def difference(a, b):
    return float(np.abs(a - b).max())


def require_same(a, b, tolerance=2 / 255, contrast=0.02):
    """Of pictures that show something."""
    assert a.shape == b.shape, (a.shape, b.shape)
    assert a.reshape(-1, a.shape[-1]).std(0).max() > contrast, "there is nothing to be seen"
    assert difference(a, b) <= tolerance + 1e-9, 255 * difference(a, b)
