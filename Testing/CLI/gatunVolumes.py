# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes and slices to give to gtn volume, and what comes back."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import (
    vtkMetaImageReader, vtkNIFTIImageReader, vtkPNGReader, vtkPNGWriter, vtkTIFFReader, vtkTIFFWriter)
from vtkmodules.vtkIOLegacy import vtkStructuredPointsReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

READERS = {".vti": vtkXMLImageDataReader, ".vtk": vtkStructuredPointsReader,
           ".nii": vtkNIFTIImageReader, ".gz": vtkNIFTIImageReader, ".mha": vtkMetaImageReader,
           ".png": vtkPNGReader, ".tif": vtkTIFFReader}


def field(shape=(12, 14, 18), seed=1, scale=1000):
    """Soft balls, as values[z, y, x]."""
    rng = np.random.default_rng(seed)
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), -1).astype(float)
    values = np.zeros(shape)
    for _ in range(4):
        values += np.exp(-(((grid - rng.uniform(0.2, 0.8, 3) * shape) / (0.2 * max(shape))) ** 2)
                         .sum(-1))
    return values * (scale / values.max())


def make_image(values, name="density", spacing=(1, 1, 1), origin=(0, 0, 0)):
    image = vtkImageData()
    image.SetDimensions(*values.shape[2::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    array = numpy_to_vtk(np.ascontiguousarray(values).reshape(image.GetNumberOfPoints(), -1)
                         .squeeze(), deep=True)
    if image.GetNumberOfPoints() == 1:
        array = numpy_to_vtk(np.ascontiguousarray(values).reshape(1), deep=True)
    array.SetName(name)
    image.GetPointData().SetScalars(array)
    return image


def write_image(image, name):
    writer = {"vti": vtkXMLImageDataWriter, "png": vtkPNGWriter,
              "tif": vtkTIFFWriter}[name.rsplit(".", 1)[1]]()
    writer.SetInputData(image)
    writer.SetFileName(name)
    writer.Write()


def read_image(name):
    reader = READERS[name[name.rindex("."):]]()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def values_of(image):
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
