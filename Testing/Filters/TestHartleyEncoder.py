# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunHartleyEncoder passes images on and publishes their coefficients. vtkGatunHartleyProjection
draws the coefficients of its direct input, and of no other algorithm."""

import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkRenderingCore import vtkCamera

import gatunHartley as gh
import gatunMeshes as gm
from gatun.vtk import (vtkGatunErrorCode, vtkGatunHartleyCoefficients, vtkGatunHartleyEncoder,
                   vtkGatunHartleyProjection)

KEY = vtkGatunHartleyCoefficients.COEFFICIENTS()
INVALID = 40007
field = gh.blobs((30, 26, 34), seed=6, scale=1000).astype(np.int16)
image = gh.make_volume(field, (2, 3, 4), (1, 2, 3), (0.5, 0.6, 0.7))
source = vtkTrivialProducer()
source.SetOutput(image)
source.SetWholeExtent(image.GetExtent())


def make(algorithm, upstream, **options):
    algorithm.SetInputConnection(upstream.GetOutputPort())
    gm.set_options(algorithm, **options)
    return algorithm


def encode(upstream, **options):
    return make(vtkGatunHartleyEncoder(), upstream, **options)


def project(upstream, **options):
    projection = make(vtkGatunHartleyProjection(), upstream, Size=(60, 50), **options)
    camera = vtkCamera()
    camera.SetFocalPoint(0.2, 0.3, -1)
    camera.SetPosition(0, 0, 0)
    if projection.ResetCamera(camera):
        projection.SetCamera(camera)
    return projection


def draw(projection):
    errors = gm.Errors(projection)
    projection.Update()
    assert projection.GetErrorCode() == 0, str(errors)
    return vtk_to_numpy(projection.GetOutput().GetPointData().GetScalars()).copy()


def coefficients_of(algorithm):
    return algorithm.GetOutputInformation(0).Get(KEY)


# The image is passed by reference, the coefficients come with it, and are those of a file.
path = gm.temporary("encoder.ghv")
for options in ({}, {"BlockSize": 16, "Quality": 30}, {"BlockSize": 0, **gh.LOSSLESS},
                {"BlockSize": 5, "RateControl": 3, "BitsPerVoxel": 2, "FrequencyWeight": 1}):
    encoder = encode(source, **options)
    encoder.Update()
    assert encoder.GetErrorCode() == 0 and gm.statistic(encoder, "Encodings") == 1
    assert encoder.GetOutput().GetPointData().GetScalars() is image.GetPointData().GetScalars()
    assert gh.place_of(encoder.GetOutput()) == gh.place_of(image)
    gh.write(image, path, **options)
    reader = gh.open_file(path)
    reader.UpdateInformation()
    one, other = coefficients_of(encoder), coefficients_of(reader)
    for name in ("ArrayName", "BlockSize", "NumberOfBlocks", "NumberOfChunks"):
        assert getattr(one, "Get" + name)() == getattr(other, "Get" + name)(), name
    assert one.GetArrayName() == "density" and one.GetBlockSize() == encoder.GetEncoding().GetBlockSize()
    assert gm.statistic(encoder, "Blocks") == reader.GetNumberOfBlocks() == one.GetNumberOfBlocks()
    assert 0 < gm.statistic(encoder, "Coefficients") <= 1.2 * field.size
    span = [0, 0]
    encoder.GetRange(span)
    assert span == [field.min(), field.max()]
    assert np.array_equal(draw(project(encoder)), draw(project(reader)))
    assert reader.GetOutput().GetNumberOfPoints() == 0

# The coefficients are shared by all consumers, and encoded again only when something has changed.
encoder = encode(source)
first, second = project(encoder), project(encoder, OpacityModel=0)
before = draw(first)
draw(second)
assert gm.statistic(encoder, "Encodings") == 1
first.GetCamera().Zoom(2)
assert (draw(first) != before).any() and gm.statistic(encoder, "Encodings") == 1
first.GetCamera().Zoom(0.5)
encoder.GetEncoding().SetQuality(10)
encoder.UpdateInformation()
assert coefficients_of(encoder) is None  # those of before are not valid any more
coarse = draw(first)
assert (coarse != before).any() and gm.statistic(encoder, "Encodings") == 2
assert gm.statistic(first, "Volumes") == 2
encoder.GetEncoding().SetQuality(60)
assert np.array_equal(draw(first), before) and gm.statistic(encoder, "Encodings") == 3

# A part of the output, and then the whole.
encoder = encode(source)
encoder.UpdateExtent((5, 10, 6, 6, 8, 20))
part = encoder.GetOutput()
assert part.GetExtent() == (5, 10, 6, 6, 8, 20)
assert (gh.values_of(part) == field[4:17, 3:4, 3:9]).all()
assert np.array_equal(draw(project(encoder)), before)
encoder.UpdateWholeExtent()
assert (gh.values_of(encoder.GetOutput()) == field).all() and gm.statistic(encoder, "Encodings") == 1
assert image.GetExtent() == encoder.GetOutput().GetExtent()

# Another filter does not pass the coefficients on: it may change the values.
reader = gh.open_file(path)
for upstream in (reader, encode(source)):
    calculator = make(vtkArrayCalculator(), upstream)
    calculator.SetAttributeTypeToPointData()
    calculator.AddScalarArrayName("density")
    calculator.SetResultArrayName("density")
    calculator.SetFunction("1000 - density")
    behind = project(calculator)
    picture = draw(behind)
    assert coefficients_of(upstream) is not None and coefficients_of(calculator) is None
    expected = vtkGatunHartleyProjection()
    expected.SetInputData(calculator.GetOutput())
    expected.SetSize(60, 50)
    expected.SetCamera(behind.GetCamera())
    assert np.array_equal(picture, draw(expected))
    assert (picture != draw(project(upstream))).any()

# The selected array counts: coefficients of another one are not drawn.
gm.add_array(image.GetPointData(), (1000 - field).ravel(), "other")
encoder = encode(source)
selected = project(encoder)
selected.SetInputArrayToProcess(0, 0, 0, 0, "other")
other = draw(selected)
selected.SetInputArrayToProcess(0, 0, 0, 0, "density")
assert np.array_equal(draw(selected), before) and (other != before).any()
encoder.SetInputArrayToProcess(0, 0, 0, 0, "other")
selected.SetInputArrayToProcess(0, 0, 0, 0, "other")
assert coefficients_of(encoder).GetArrayName() == "density"
assert np.array_equal(draw(selected), other) and coefficients_of(encoder).GetArrayName() == "other"

# What cannot be encoded is an error; there are no coefficients then, and the next update is right.
broken = field.astype(float)
broken[1, 2, 3] = np.nan
for bad, text in ((gh.make_volume(broken), "finite"), (vtkImageData(), "empty")):
    encoder = vtkGatunHartleyEncoder()
    encoder.SetInputData(bad)
    errors = gm.Errors(encoder)
    projection = project(encoder)
    projection.Update()
    projection.SetCamera(first.GetCamera())
    assert encoder.GetErrorCode() == INVALID and len(errors.messages) == 1, str(errors)
    assert text in str(errors) and coefficients_of(encoder) is None
    assert projection.GetErrorCode() != 0 and projection.GetOutput().GetNumberOfPoints() == 0
    assert encoder.GetOutput().GetNumberOfPoints() == 0
    encoder.SetInputConnection(source.GetOutputPort())
    assert np.array_equal(draw(projection), before) and encoder.GetErrorCode() == 0

# Aborted: no message, no coefficients; and then the right ones.
encoder = encode(source)
errors = gm.Errors(encoder)
tag = encoder.AddObserver("ProgressEvent", lambda *_: encoder.SetAbortExecute(1))
encoder.Update()
assert not errors.messages and encoder.GetErrorCode() == vtkGatunErrorCode.AbortedError
assert coefficients_of(encoder) is None
encoder.RemoveObserver(tag)
encoder.SetAbortExecute(0)
encoder.Modified()
assert np.array_equal(draw(project(encoder)), before)
assert str(encoder) and str(coefficients_of(encoder)) and str(project(encoder))

# Encoder, reader and writer need nothing of VTK's rendering.
script = f"""
from gatun.vtk import vtkGatunHartleyEncoder, vtkGatunHartleyReader, vtkGatunHartleyWriter
reader, encoder, writer = (
    make() for make in (vtkGatunHartleyReader, vtkGatunHartleyEncoder, vtkGatunHartleyWriter))
reader.SetFileName({path!r})
encoder.SetInputConnection(reader.GetOutputPort())
writer.SetInputConnection(encoder.GetOutputPort())
writer.SetFileName({gm.temporary("again.ghv")!r})
assert writer.Write() == 1
with open("/proc/self/maps", encoding="utf-8") as maps:
    assert "libvtkRendering" not in maps.read()
"""
subprocess.run([sys.executable, "-c", script], check=True)
