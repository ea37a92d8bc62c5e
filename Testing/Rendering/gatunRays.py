# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images of regular volumes, and integrals along rays by numpy alone."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkCamera, vtkColorTransferFunction, vtkVolumeProperty

import gatunMeshes as gm
from gatun.vtk import vtkGatunHartleyEncoder, vtkGatunHartleyProjection
from gatunHartley import LOSSLESS


def make_camera(direction, up=(0, 1, 0), focus=(0, 0, 0), scale=10.0):
    """One in a parallel projection."""
    camera = vtkCamera()
    camera.SetFocalPoint(focus)
    camera.SetPosition(np.asarray(focus) - 5 * np.asarray(direction, float))
    camera.SetViewUp(up)
    camera.SetParallelScale(scale)
    camera.ParallelProjectionOn()
    return camera


def make_property(colors, opacities, distance=1.0):
    """From (value, red, green, blue) and (value, opacity)."""
    transfer = vtkColorTransferFunction()
    for point in colors:
        transfer.AddRGBPoint(*point)
    opacity = vtkPiecewiseFunction()
    for point in opacities:
        opacity.AddPoint(*point)
    made = vtkVolumeProperty()
    made.SetColor(transfer)
    made.SetScalarOpacity(opacity)
    made.SetScalarOpacityUnitDistance(distance)
    return made


ENCODING = ("BlockSize", "RateControl", "Quality", "RMSError", "PSNR", "BitsPerVoxel",
            "FrequencyWeight")


def connect(source, algorithm):
    """source: an image, or an algorithm."""
    if source.IsA("vtkAlgorithm"):
        algorithm.SetInputConnection(source.GetOutputPort())
    else:
        algorithm.SetInputData(source)
    return algorithm


def make_encoder(source, **options):
    encoder = connect(source, vtkGatunHartleyEncoder())
    gm.set_options(encoder, **options)
    return encoder


def make_projection(source, camera=None, **options):
    """source: an image, or an algorithm. Options: of the projection, or those of an encoding, which an
    encoder in between then has."""
    encoding = {name: value for name, value in options.items() if name in ENCODING}
    drawing = {name: value for name, value in options.items() if name not in ENCODING}
    projection = vtkGatunHartleyProjection()
    projection.Encoder = make_encoder(source, **encoding) if encoding else None
    connect(projection.Encoder or source, projection)
    projection.OutputFloatsOn()
    gm.set_options(projection, Camera=camera, **drawing)
    return projection


def array_of(projection, name="Color"):
    """Of the current image, by rows from below."""
    image = projection.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return values.reshape(height, width, -1).squeeze(-1) if values.ndim == 1 else \
        values.reshape(height, width, -1)


def draw(source, camera=None, name="Color", **options):
    projection = make_projection(source, camera, **options)
    errors = gm.Errors(projection)
    projection.Update()
    assert projection.GetErrorCode() == 0, str(errors)
    return array_of(projection, name).copy()


def rays_of(camera, size):
    """A point on the ray of each pixel, by rows from below, and the direction: of a plain parallel
    camera, from what it was given."""
    focus, position = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
    forward = (focus - position) / np.linalg.norm(focus - position)
    right = np.cross(forward, camera.GetViewUp())
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    width, height = size
    pixel = 2 * camera.GetParallelScale() / height
    x = (np.arange(width) + 0.5 - width / 2) * pixel
    y = (np.arange(height) + 0.5 - height / 2) * pixel
    points = focus + x[None, :, None] * right + y[:, None, None] * up
    return points, forward


def trilinear(values, index):
    """The trilinear volume of values[z, y, x] at indices (x, y, z); beyond it falls to 0 within a
    voxel."""
    padded = np.pad(values.astype(float), 2)
    shape = np.array(padded.shape[::-1])
    place = np.clip(index + 2, 0, shape - 1 - 1e-9)
    low = place.astype(int)
    part = place - low
    total = 0.0
    for corner in np.ndindex(2, 2, 2):
        at = low + corner
        weight = np.prod(np.where(corner, part, 1 - part), axis=-1)
        total = total + weight * padded[at[..., 2], at[..., 1], at[..., 0]]
    return total


def integrals(image, values, camera, size, step=0.02):
    """Of a function that is values at voxels, along the rays, in world units."""
    direction = np.array([[image.GetDirectionMatrix().GetElement(i, j) for j in range(3)]
                          for i in range(3)])
    matrix = direction * np.array(image.GetSpacing())
    first = np.array(image.GetExtent()[::2])
    points, forward = rays_of(camera, size)
    inverse = np.linalg.inv(matrix)
    start = (points - np.array(image.GetOrigin())) @ inverse.T - first
    way = inverse @ forward
    # As far as any ray is in the volume.
    middle = (np.array(values.shape[::-1]) - 1) / 2
    radius = np.linalg.norm(middle) + 3
    along = ((middle - start) @ way) / (way @ way)
    reach = radius / np.linalg.norm(way)
    count = int(np.ceil(2 * reach * np.linalg.norm(way) / step))
    apart = 2 * reach / count
    total = np.zeros(points.shape[:2])
    for i in range(count):
        t = along - reach + (i + 0.5) * apart
        total += trilinear(values, start + t[..., None] * way)
    return total * apart
