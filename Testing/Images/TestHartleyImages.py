# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes drawn from their Hartley coefficients, by each opacity model and method."""

import numpy as np

import gatunHartley as gh
import gatunMeshes as gm
import gatunScenes as gs
from gatun.vtk import (vtkGatunHartleyEncoder, vtkGatunHartleyEncoding, vtkGatunHartleyProjection,
                   vtkGatunHartleyReader)


def phantom(n=40):
    """Two shells and a rod, with values from 0 to 1."""
    x, y, z = np.meshgrid(*[np.linspace(-1, 1, n)] * 3, indexing="ij")
    radius = np.sqrt(x ** 2 + y ** 2 + z ** 2)
    field = 0.45 * ((radius > 0.75) & (radius < 0.9)) + 0.7 * (np.abs(radius - 0.4) < 0.12)
    field = np.maximum(field, 1.0 * ((x - 0.1) ** 2 + z ** 2 < 0.02) * (np.abs(y) < 0.7))
    smooth = field.astype(float)
    for axis in range(3):  # the trilinear volume of a smooth field has no steps
        smooth = (np.roll(smooth, 1, axis) + 2 * smooth + np.roll(smooth, -1, axis)) / 4
    return gh.make_volume(smooth.astype(np.float32), origin=(-1, -1, -1),
                          spacing=(2 / (n - 1),) * 3)


def draw(source=None, block=8, **options):
    source = source or phantom()
    encoder = None
    if not source.IsA("vtkAlgorithm"):
        encoder = vtkGatunHartleyEncoder()
        encoder.SetInputData(source)
        encoder.GetEncoding().SetBlockSize(block)
        encoder.GetEncoding().SetRateControlToPSNR()
        encoder.GetEncoding().SetPSNR(50)
    projection = vtkGatunHartleyProjection()
    projection.SetInputConnection((encoder or source).GetOutputPort())
    projection.SetSize(gs.SIZE, gs.SIZE)
    projection.SetBackground(*gs.BACKGROUND)
    opacities = ((0.1, 0), (0.3, 0.15), (0.5, 0.1), (0.7, 0.5), (1, 0.95))
    projection.SetProperty(gs.volume_property(unit=0.2, opacities=opacities))
    projection.SetCamera(gs.make_camera(parallel=True))
    for name, value in options.items():
        getattr(projection, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    projection.Update()
    assert projection.GetErrorCode() == 0
    return gs.to_array(projection.GetOutput(), "Color")


def HartleyTransferFunction():
    return draw(OpacityModel=vtkGatunHartleyProjection.OPACITY_MODEL_TRANSFER_FUNCTION)


def HartleyExponential():
    return draw(OpacityModel=vtkGatunHartleyProjection.OPACITY_MODEL_EXPONENTIAL, Extinction=1.5)


def HartleyXRay():
    return draw(OpacityModel=vtkGatunHartleyProjection.OPACITY_MODEL_XRAY)


def HartleySlices():
    """Blocks of 32 voxels by slices of their spectra."""
    return draw(block=32, OpacityModel=vtkGatunHartleyProjection.OPACITY_MODEL_EXPONENTIAL,
                Extinction=1.5, Method=vtkGatunHartleyProjection.METHOD_SLICE)


def HartleyFile():
    """A file of which no voxel is decoded. The baseline is the one of HartleyTransferFunction."""
    path = gm.temporary("images-phantom.ghv")
    gh.write(phantom(), path, BlockSize=8, RateControl=vtkGatunHartleyEncoding.RATE_CONTROL_PSNR,
             PSNR=50)
    reader = vtkGatunHartleyReader()
    reader.SetFileName(path)
    return draw(reader)


gs.run(globals())
