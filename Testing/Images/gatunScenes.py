# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes, views and the comparison of images with their baselines.

A test file defines scenes, functions that return an image, and ends with ``run(globals())``. Its
arguments are the name of a scene and the baseline; with the option --update the image is written to
the baseline in place of being compared with it.
"""

import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the window)
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  (volumes)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
    vtkVolume, vtkVolumeProperty, vtkWindowToImageFilter)

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunVolumeMapper

SIZE = 200
BACKGROUND = (0.10, 0.12, 0.20)

# Two renderings of a scene differ by rounding alone, that is, by a digit or two in most pixels.
# Drivers may place the edges of opaque triangles a pixel apart.
LARGE_DIFFERENCE = 16
LARGE_DIFFERENCES_ALLOWED = 0.004  # of the pixels
MEAN_DIFFERENCE_ALLOWED = 0.5  # of 255


# --------------------------------------------------------------------------------------------------
# Meshes


def ball(n=22):
    """A ball of radius 1 with a spherical void off its center; a smooth field "heat" from about 0
    to 1 on its points and the array "octant" on its cells."""
    points, tets = gm.lattice(n, seed=3)
    tets = tets[:, [0, 2, 1, 3]]  # so that volumes are positive by VTK's convention
    points = 2.2 * (points - 0.5)
    centers = points[tets].mean(axis=1)
    inside = np.linalg.norm(centers, axis=1) < 1
    inside &= np.linalg.norm(centers - [0.35, 0.2, 0.3], axis=1) > 0.4
    tets, centers = tets[inside], centers[inside]
    used, tets = np.unique(tets, return_inverse=True)
    points, tets = points[used], tets.reshape(-1, 4)
    grid = gm.make_grid(points, tets)
    x, y, z = points.T
    heat = 0.5 + 0.25 * np.sin(4 * x + y) * np.cos(3 * z) + 0.25 * z
    gm.add_array(grid.GetPointData(), heat.astype(np.float32), "heat")
    octant = (centers > 0) @ [1, 2, 4]
    gm.add_array(grid.GetCellData(), octant.astype(np.int32), "octant")
    grid.GetPointData().SetActiveScalars("heat")
    return grid


def ball_file(name, n=22, **options):
    """A reader of a file with the ball."""
    reader = vtkGatunReader()
    reader.SetFileName(gm.temporary(f"images-{name}.gtn"))
    gm.write(ball(n), reader.GetFileName(), **{"ChunkSize": 2048, **options})
    return reader


def connect(consumer, source):
    """The source is a data object or an algorithm."""
    if source.IsA("vtkAlgorithm"):
        consumer.SetInputConnection(source.GetOutputPort())
    else:
        consumer.SetInputDataObject(0, source)


# --------------------------------------------------------------------------------------------------
# Looks

COLORS = ((0.0, (0.15, 0.2, 0.85)), (0.4, (0.1, 0.8, 0.6)), (0.7, (0.95, 0.8, 0.1)),
          (1.0, (0.85, 0.1, 0.1)))
OPACITIES = ((0.0, 0.3), (0.35, 0.0), (0.6, 0.05), (0.8, 0.5), (1.0, 0.95))


def color_function():
    function = vtkColorTransferFunction()
    for value, color in COLORS:
        function.AddRGBPoint(value, *color)
    return function


def volume_property(unit=0.2, opacities=OPACITIES):
    function = vtkPiecewiseFunction()
    for value, opacity in opacities:
        function.AddPoint(value, opacity)
    made = vtkVolumeProperty()
    made.SetColor(color_function())
    made.SetScalarOpacity(function)
    made.SetScalarOpacityUnitDistance(unit)
    return made


def aim(camera, azimuth=35, elevation=25, distance=4.6, parallel=False):
    """Looks at the origin."""
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(0, 0, distance)
    camera.SetViewAngle(30)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(1.15)
    camera.SetClippingRange(0.01, 20)
    return camera


def make_camera(**options):
    return aim(vtkCamera(), **options)


def surface_actor(source, array=None, cells=False, edges=False, color=(0.85, 0.85, 0.8)):
    """The surface of a mesh, or polygons, in one color or by the values of an array."""
    surface = vtkDataSetSurfaceFilter()
    connect(surface, source)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    if array:
        mapper.SelectColorArray(array)
        (mapper.SetScalarModeToUseCellFieldData if cells
         else mapper.SetScalarModeToUsePointFieldData)()
        mapper.SetLookupTable(color_function())
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor(0.1, 0.1, 0.1)
    return actor


class View:
    """A window of SIZE x SIZE pixels."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(BACKGROUND)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.kept = []

    def add_volume(self, source, shade=False, prop=None, **options):
        mapper = vtkGatunVolumeMapper()
        connect(mapper, source)
        gm.set_options(mapper, **options)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(prop or volume_property())
        volume.GetProperty().SetShade(shade)
        self.renderer.AddVolume(volume)
        self.kept.append((mapper, source))
        return volume

    def add_surface(self, source, **options):
        actor = surface_actor(source, **options)
        self.renderer.AddActor(actor)
        self.kept.append(source)
        return actor

    def draw(self, **camera):
        """The image as rows from below, columns, red, green and blue of 0 to 255."""
        aim(self.renderer.GetActiveCamera(), **camera)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return to_array(grab.GetOutput())


# --------------------------------------------------------------------------------------------------
# Images


def to_array(image, name=None):
    """Rows from below, columns, components."""
    data = image.GetPointData()
    values = vtk_to_numpy(data.GetArray(name) if name else data.GetScalars())
    width, height, _ = image.GetDimensions()
    return values.reshape(height, width, -1)


def over_background(colors):
    """Floats with opacity, multiplied by it, over the background, as bytes."""
    colors = colors.astype(float)
    over = colors[..., :3] + (1 - colors[..., 3:]) * np.array(BACKGROUND)
    return np.rint(255 * np.clip(over, 0, 1)).astype(np.uint8)


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return to_array(reader.GetOutput())


def write_png(image, path):
    height, width, components = image.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(image.astype(np.uint8)).reshape(-1, components)
    data.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.Write()


def compare(image, baseline, name):
    """Fails if an image is neither that of the baseline nor of another one for other versions of VTK,
    whose name ends in _1, and leaves it where tests may write."""
    made = image[..., :3].astype(int)
    other = baseline.replace(".png", "_1.png")
    for path in [baseline, other] if os.path.exists(other) else [baseline]:
        expected = read_png(path)[..., :3].astype(int)
        assert made.shape == expected.shape, (made.shape, expected.shape)
        difference = np.abs(made - expected).max(axis=-1)
        large = np.mean(difference > LARGE_DIFFERENCE)
        mean = difference.mean()
        print(f"{name}: mean difference {mean:.3f} of 255, {100 * large:.2f} % of the pixels differ by "
              f"more than {LARGE_DIFFERENCE}")
        if large <= LARGE_DIFFERENCES_ALLOWED and mean <= MEAN_DIFFERENCE_ALLOWED:
            return
    path = os.path.join(os.environ["GATUN_TEST_TEMP"], f"{name}-failed.png")
    write_png(image, path)
    sys.exit(f"{name} differs from {baseline}; the image is {path}")


def run(scenes):
    """What a test file does."""
    arguments = [argument for argument in sys.argv[1:] if argument != "--update"]
    name, baseline = arguments
    image = scenes[name]()
    assert image.std() > 5, "the image is empty"
    if "--update" in sys.argv:
        write_png(image, baseline)
    else:
        compare(image, baseline, name)
