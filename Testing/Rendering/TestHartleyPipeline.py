# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunHartleyProjection repeats the work that a change requires, and nothing else; files are drawn
without voxels; errors are reported, and the next image is right."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray
from vtkmodules.vtkCommonDataModel import vtkImageData

import gatunHartley as gh
import gatunMeshes as gm
import gatunRays as gr
from gatun.vtk import vtkGatunErrorCode, vtkGatunHartleyProjection

INVALID = vtkGatunErrorCode.InvalidInputError
field = gh.blobs((30, 26, 34), seed=6, scale=1000).astype(np.int16)
image = gh.make_volume(field, (2, 3, 4), (1, 2, 3), (0.5, 0.6, 0.7))
camera = gr.make_camera((0.2, 0.3, -1), focus=image.GetCenter(), scale=15)
colors = gr.make_property([(0, 0, 0, 1), (1000, 1, 1, 0)], [(0, 0), (1000, 0.4)], 0.5)


def update(projection):
    projection.Update()
    assert projection.GetErrorCode() == 0
    return gr.array_of(projection).copy()


# A change of the view or the shading changes the image, but does not encode the volume again.
encoder = gr.make_encoder(image)
projection = gr.make_projection(encoder, camera, Size=(60, 50), Property=colors)
picture = update(projection)
assert gm.statistic(projection, "Volumes") == 1 and gm.statistic(projection, "Coefficients") > 0
assert gm.statistic(projection, "DrawnBlocks") > 0 and gm.statistic(projection, "Method") == 3
assert gm.statistic(encoder, "Encodings") == 1
time = projection.GetOutput().GetMTime()
assert (update(projection) == picture).all() and projection.GetOutput().GetMTime() == time


other = gr.make_camera((-0.2, 0.3, -1), focus=image.GetOrigin(), scale=15)
plain = gr.make_property([(0, 0, 0, 0), (1000, 1, 1, 1)], [(0, 0), (1000, 0.4)], 0.5)
for change in (lambda: camera.Azimuth(20), lambda: camera.Zoom(1.5), lambda: camera.Roll(30),
               lambda: projection.SetCamera(other), lambda: projection.SetCamera(camera),
               lambda: colors.GetScalarOpacity().AddPoint(500, 0.1),
               lambda: colors.GetRGBTransferFunction().AddRGBPoint(500, 0, 1, 0),
               lambda: colors.SetScalarOpacityUnitDistance(2),
               lambda: projection.SetProperty(plain), lambda: projection.SetProperty(None),
               projection.SetOpacityModelToExponential,
               lambda: projection.SetExtinction(0.01), lambda: projection.SetZero(300),
               lambda: projection.SetZero(np.nan), lambda: projection.SetBackground(0, 0, 0),
               lambda: projection.SetBackground(1, 0, 0), projection.SetOpacityModelToXRay,
               lambda: projection.SetWindow(0, 30000), lambda: projection.SetSize(50, 50)):
    change()
    changed = update(projection)
    assert changed.shape != picture.shape or (changed != picture).any()
    picture = changed
    assert gm.statistic(projection, "Volumes") == 1 and gm.statistic(encoder, "Encodings") == 1
for method in (1, 2, 0):
    projection.SetMethod(method)
    update(projection)
    assert gm.statistic(projection, "Method") == (method or 3) and gm.statistic(projection, "Volumes") == 1
count = 1
encoding = encoder.GetEncoding()
for change in (lambda: encoding.SetQuality(20), lambda: encoding.SetBlockSize(4),
               lambda: encoding.SetRateControl(3), lambda: encoding.SetBitsPerVoxel(0.5),
               lambda: encoding.SetFrequencyWeight(1), image.Modified):
    change()
    update(projection)
    count += 1
    assert gm.statistic(projection, "Volumes") == gm.statistic(encoder, "Encodings") == count, change

# The projection encodes an image that comes without coefficients, once for each of its versions.
values = vtk_to_numpy(image.GetPointData().GetScalars())
direct = gr.make_projection(image, camera, Size=(60, 50))
picture = update(direct)
camera.Azimuth(1)
assert (update(direct) != picture).any() and gm.statistic(direct, "Volumes") == 1
values[:] = field.ravel() // 2
image.GetPointData().GetScalars().Modified()
update(direct)
assert gm.statistic(direct, "Volumes") == 2
found = [0, 0]
direct.GetRange(found)
assert found == [(field // 2).min(), (field // 2).max()], found
values[:] = field.ravel()
image.GetPointData().GetScalars().Modified()
by_defaults = gr.make_projection(gr.make_encoder(image), camera, Size=(60, 50))
assert (update(direct) == update(by_defaults)).all()

# A part of the image.
whole = gr.make_projection(image, camera, Size=(60, 50), OpacityModel=0)
picture = update(whole)
part = gr.make_projection(image, camera, Size=(60, 50), OpacityModel=0)
part.UpdateExtent((10, 29, 5, 5, 0, 0))
assert part.GetOutput().GetExtent() == (10, 29, 5, 5, 0, 0)
assert (gr.array_of(part) == picture[5:6, 10:30]).all()
assert part.GetOutput().GetSpacing() == whole.GetOutput().GetSpacing()
assert part.GetOutput().GetOrigin() == whole.GetOutput().GetOrigin()
assert part.GetOutput().GetNumberOfPoints() == 20
assert whole.GetOutputInformation(0).Get(vtkImageData.SPACING()) == whole.GetOutput().GetSpacing()
scale = 2 * camera.GetParallelScale() / 50
assert np.allclose(whole.GetOutput().GetSpacing()[:2], scale)
assert np.allclose(whole.GetOutput().GetOrigin()[:2], (-29.5 * scale, -24.5 * scale))
names = lambda p: [p.GetOutput().GetPointData().GetArrayName(i)
                   for i in range(p.GetOutput().GetPointData().GetNumberOfArrays())]
assert names(whole) == ["Color", "RGBA", "Sum", "Samples"]
assert whole.GetOutput().GetPointData().GetScalars().GetName() == "Color"
whole.OutputFloatsOff()
assert (update(whole) == picture).all() and names(whole) == ["Color"]

# A file is drawn like the image from which it was written, without voxels.
path = gm.temporary("projection.ghv")
for size, options in ((8, {}), (16, {"Quality": 30}), (0, gr.LOSSLESS), (5, {"RateControl": 3, "BitsPerVoxel": 2})):
    gh.write(image, path, BlockSize=size, **options)
    reader = gh.open_file(path)
    for model in (0, 1, 2):
        settings = dict(Size=(60, 50), Property=colors, OpacityModel=model)
        of_image = gr.draw(image, camera, "RGBA", BlockSize=size, **options, **settings)
        projection = gr.make_projection(reader, camera, **settings)
        update(projection)
        assert abs(gr.array_of(projection, "RGBA") - of_image).max() < 1e-4, (size, model)
        assert reader.GetOutput().GetNumberOfPoints() == 0
        assert 0 < gm.statistic(reader, "BytesRead") and gm.statistic(projection, "Volumes") == 1
    read = gm.statistic(reader, "BytesRead")
    camera.Azimuth(5)
    update(projection)
    assert gm.statistic(reader, "BytesRead") == read  # the coefficients fit into the memory budget
    assert gm.statistic(projection, "Volumes") == 1 and reader.GetOutput().GetNumberOfPoints() == 0

# Voxels that the reader has, or that another consumer requests, remain.
reader = gh.open_file(path)
reader.Update()
assert reader.GetOutput().GetNumberOfPoints() == field.size
projection = gr.make_projection(reader, camera, Size=(60, 50))
update(projection)
assert reader.GetOutput().GetNumberOfPoints() == field.size
camera.Azimuth(5)
update(projection)
assert reader.GetOutput().GetNumberOfPoints() == field.size
reader = gh.open_file(path)
projection = gr.make_projection(reader, camera, Size=(60, 50))
picture = update(projection)
reader.UpdateWholeExtent()
assert reader.GetOutput().GetNumberOfPoints() == field.size
assert (update(projection) == picture).all()

# Another file of the same name is another volume.
gh.write(gh.make_volume(field[::-1].copy(), (2, 3, 4), (1, 2, 3), (0.5, 0.6, 0.7)), path)
assert (update(projection) != picture).any() and gm.statistic(projection, "Volumes") == 2


# Errors.
def refuse(projection, *texts, code=INVALID):
    errors = gm.Errors(projection)
    projection.Update()
    assert projection.GetErrorCode() == (code or projection.GetErrorCode()) != 0, str(errors)
    assert len(errors.messages) == 1, errors.messages
    for text in texts:
        assert text in str(errors), (text, str(errors))
    assert projection.GetOutput().GetNumberOfPoints() == 0
    assert projection.GetOutput().GetPointData().GetNumberOfArrays() == 0
    projection.RemoveAllObservers()


expected = gr.draw(image, camera, Size=(20, 20))
# Properties are clamped to their range; what is not a number is an error, and can be repaired.
projection = vtkGatunHartleyProjection()
for name, value, clamped in (
    ("Size", (0, 5), (1, 5)), ("Size", (32001, 2147483647), (32000, 32000)),
    ("SampleDistance", -1, 0), ("Extinction", -1, 0),
    ("MemoryBudget", -1, 0), ("OpacityModel", 3, 2), ("Method", -1, 0),
    ("Background", (-2, 2, 0.5), (-1, 1, 0.5)),
):
    gm.set_options(projection, **{name: value})
    assert getattr(projection, "Get" + name)() == clamped, (name, value)
bad = {
    "SampleDistance": (np.nan,), "Window": ((np.nan, 1), (0, np.inf)), "Zero": (np.inf, -np.inf),
    "Extinction": (np.nan,),
    "Property": [gr.make_property([], [], unit) for unit in (np.nan, 0, -1, np.inf)],
}
for name, values in bad.items():
    for value in values:
        projection = gr.make_projection(image, camera, **{"Size": (20, 20), name: value})
        refuse(projection)
        kept = getattr(vtkGatunHartleyProjection(), "Get" + name)()
        gm.set_options(projection, **{name: kept})
        assert np.array_equal(update(projection), expected), (name, value)
for options in (dict(up=(0, 0, 3)), dict(direction=(np.nan, 0, 1)), dict(focus=(0, np.nan, 0))):
    wrong = gr.make_camera(**{"direction": (0, 0, -1), **options})
    refuse(gr.make_projection(image, wrong), "do not define a view")
refuse(gr.make_projection(image, gr.make_camera((0, 0, -1), scale=np.nan)))

small = field[:6, :7, :8].astype(float)
for spacing in ((0, 1, 1), (1, 1, 0), (np.nan, 1, 1), (1, np.inf, 1)):
    refuse(gr.make_projection(gh.make_volume(small, spacing=spacing), camera), "the spacing along")
for direction in (np.zeros((3, 3)), np.ones((3, 3)), np.full((3, 3), np.nan),
                  [[1, 0, 0], [0, 1, 1], [0, 0, 0]]):
    refuse(gr.make_projection(gh.make_volume(small, direction=direction), camera))
refuse(gr.make_projection(gh.make_volume(small, origin=(np.nan, 0, 0)), camera), "finite")
refuse(gr.make_projection(vtkImageData(), camera), "empty")
for value in (np.nan, np.inf):
    broken = small.copy()
    broken[1, 2, 3] = value
    refuse(gr.make_projection(gh.make_volume(broken), camera), "finite")
refuse(gr.make_projection(gh.make_volume(small * 1e100), camera), "beyond single precision")
vectors = gh.make_volume(small)
gm.add_array(vectors.GetPointData(), np.zeros((small.size, 3)), "velocity")
gm.add_array(vectors.GetCellData(), np.zeros(vectors.GetNumberOfCells()), "cell")
bits = vtkBitArray()
bits.SetName("bits")
bits.SetNumberOfValues(small.size)
vectors.GetPointData().AddArray(bits)
for where, name, text in ((0, "velocity", "has 3 components"), (0, "bits", "vtkBitArray"),
                          (0, "nothing", "there is no point array 'nothing'"),
                          (1, "cell", "needs a point array")):
    projection = gr.make_projection(vectors, camera, Size=(20, 20))
    projection.SetInputArrayToProcess(0, 0, 0, where, name)
    refuse(projection, text)
    projection.SetInputArrayToProcess(0, 0, 0, 0, "density")
    update(projection)

# One voxel, one layer, constant values and huge ranges can be drawn.
for fine in (np.ones((1, 1, 1)), np.arange(40.0).reshape(1, 5, 8), np.full((9, 9, 9), -5.0),
             np.array([[[-1e20, 1e20]]]), np.full((3, 3, 3), 1e30, np.float32)):
    for model in (0, 1, 2):
        for block in (0, 8):
            rgba = gr.draw(gh.make_volume(fine), None, "RGBA", OpacityModel=model, BlockSize=block,
                           Size=(9, 9))
            assert np.isfinite(rgba).all() and rgba.min() >= 0 and rgba.max() <= 1.00001, (fine, model)

# Damaged files and missing ones.
with open(path, "rb") as file:
    content = file.read()
told = 0
for place in range(0, len(content), max(1, len(content) // 60)):
    with open(path, "wb") as file:
        file.write(content[:place] + bytes([content[place] ^ 0x55]) + content[place + 1:])
    reader = gh.open_file(path)
    projection = gr.make_projection(reader, camera, Size=(20, 20))
    heard = [gm.Errors(reader), gm.Errors(projection)]
    projection.Update()
    if projection.GetErrorCode():
        assert sum(len(errors.messages) for errors in heard) == 1, [str(errors) for errors in heard]
        assert projection.GetOutput().GetNumberOfPoints() == 0
        told += 1
assert told > 50, told
with open(path, "wb") as file:
    file.write(content)
update(projection)
os.remove(path)
reader = gh.open_file(path)
heard = gm.Errors(reader)
projection = gr.make_projection(reader, camera)
errors = gm.Errors(projection)
projection.Update()
assert len(heard.messages) == 1 and projection.GetErrorCode() != 0
assert projection.GetOutput().GetNumberOfPoints() == 0

# After an abort there is no message and no image; the next image is right.
projection = gr.make_projection(image, camera, Size=(20, 20))
errors = gm.Errors(projection)
tag = projection.AddObserver("ProgressEvent", lambda *_: projection.SetAbortExecute(1))
projection.Update()
assert not errors.messages and projection.GetErrorCode() == vtkGatunErrorCode.AbortedError
assert projection.GetOutput().GetNumberOfPoints() == 0
projection.RemoveObserver(tag)
projection.SetAbortExecute(0)
projection.Modified()
assert np.array_equal(update(projection), expected)
assert str(projection)
