# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Regular volumes, and what the tests of their Hartley coefficients share."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray
from vtkmodules.vtkCommonDataModel import vtkImageData

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunHartleyEncoding, vtkGatunHartleyReader, vtkGatunHartleyWriter

LOSSLESS = {"RateControl": vtkGatunHartleyEncoding.RATE_CONTROL_RMS_ERROR, "RMSError": 0}
INVALID = vtkGatunErrorCode.InvalidInputError


def make_volume(values, first=(0, 0, 0), origin=(0, 0, 0), spacing=(1, 1, 1), direction=None,
                name="density", vtk_type=None):
    """A vtkImageData of values[z, y, x]."""
    image = vtkImageData()
    sizes = values.shape[::-1]
    image.SetExtent(*(end for low, size in zip(first, sizes) for end in (low, low + size - 1)))
    image.SetOrigin(origin)
    image.SetSpacing(spacing)
    if direction is not None:
        image.SetDirectionMatrix(np.asarray(direction, float).ravel())
    array = gm.add_array(image.GetPointData(), values.ravel(), name, vtk_type)
    image.GetPointData().SetScalars(array)
    return image


def values_of(image):
    """The active scalars, as values[z, y, x]."""
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def place_of(image):
    """Extent, origin, spacing and direction."""
    matrix = image.GetDirectionMatrix()
    return (image.GetExtent(), image.GetOrigin(), image.GetSpacing(),
            tuple(matrix.GetElement(i, j) for i in range(3) for j in range(3)))


def blobs(shape, seed=1, scale=1.0):
    """A smooth field of soft balls, 0 to about scale, as values[z, y, x]."""
    rng = np.random.default_rng(seed)
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), -1).astype(float)
    field = np.zeros(shape)
    for _ in range(5):
        center = rng.uniform(0.2, 0.8, 3) * shape
        width = rng.uniform(0.1, 0.25) * max(shape)
        field += rng.uniform(0.3, 1) * np.exp(-(((grid - center) / width) ** 2).sum(-1))
    return field * (scale / field.max())


def write(image, path, **options):
    """Writes by vtkGatunHartleyWriter; must succeed. Returns the writer."""
    writer = vtkGatunHartleyWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    gm.set_options(writer, **options)
    errors = gm.Errors(writer)
    assert writer.Write() == 1, (path, str(errors))
    assert writer.GetErrorCode() == 0
    return writer


def open_file(path):
    reader = vtkGatunHartleyReader()
    reader.SetFileName(path)
    return reader


def read(path):
    reader = open_file(path)
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


def describe(array):
    assert isinstance(array, vtkAbstractArray)
    return array.GetName(), array.GetClassName(), array.GetNumberOfComponents()
