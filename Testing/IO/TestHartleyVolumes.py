# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes are restored from .ghv files with their position and type, within the requested error, in
any parts."""

import os

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import gatunHartley as gh
import gatunMeshes as gm

path = gm.temporary("volume.ghv")
LOSSLESS = gh.LOSSLESS

# Every type, lossless: integers exactly, floating-point numbers up to rounding.
field = gh.blobs((19, 13, 22), seed=4)
types = {c.VTK_CHAR: np.int8, c.VTK_SIGNED_CHAR: np.int8, c.VTK_UNSIGNED_CHAR: np.uint8,
         c.VTK_SHORT: np.int16, c.VTK_UNSIGNED_SHORT: np.uint16, c.VTK_INT: np.int32,
         c.VTK_UNSIGNED_INT: np.uint32, c.VTK_LONG: np.int64, c.VTK_LONG_LONG: np.int64,
         c.VTK_UNSIGNED_LONG: np.uint64, c.VTK_ID_TYPE: np.int64, c.VTK_FLOAT: np.float32,
         c.VTK_DOUBLE: np.float64}
for vtk_type, kind in types.items():
    whole = np.issubdtype(kind, np.integer)
    values = np.rint(100 * field - (20 if np.iinfo(kind).min < 0 else 0)).astype(kind) if whole \
        else (3.5 * field - 1).astype(kind)
    image = gh.make_volume(values, name="some name", vtk_type=vtk_type)
    for size in (2, 8, 0):
        writer = gh.write(image, path, BlockSize=size, **LOSSLESS)
        again = gh.read(path)
        assert gh.describe(again.GetPointData().GetScalars()) == \
            gh.describe(image.GetPointData().GetScalars()), vtk_type
        error = abs(gh.values_of(again).astype(float) - values.astype(float)).max()
        assert error <= (0 if whole else 2e-6), (vtk_type, size, error)
        assert abs(error - gm.statistic(writer, "MaximumError")) <= 1e-12 + 1e-6 * error
        assert again.GetPointData().GetNumberOfArrays() == 1

# Where it was: extents, origins, spacings, directions; sizes that fit no block, flat ones and lines.
turn = np.array([[0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]])
rng = np.random.default_rng(2)
for shape, first, origin, spacing, direction in (
    ((5, 6, 7), (-3, 100, 2147483000), (1.5, -2, 1e9), (0.5, 2, 3), turn),
    ((1, 1, 1), (7, 8, 9), (1, 2, 3), (1, 1, 1), None),
    ((1, 9, 70), (0, 0, 0), (0, 0, 0), (-1, 1, 1), [[0, 1, 0], [0, 0, 1], [1, 0, 0]]),
    ((66, 1, 1), (0, -5, 0), (0, 0, 0), (0, 1, 1), None),
    ((129, 2, 3), (0, 0, 0), (0.1, 0.2, 0.3), (1e-9, 1, 1e9), -np.eye(3)),
):
    values = rng.integers(0, 200, shape).astype(np.uint8)
    image = gh.make_volume(values, first, origin, spacing, direction)
    gh.write(image, path, **LOSSLESS)
    again = gh.read(path)
    assert gh.place_of(again) == gh.place_of(image)
    assert (gh.values_of(again) == values).all()

# Parts: the same values, from fewer bytes, and only what was asked for.
values = rng.integers(0, 4000, (70, 130, 140)).astype(np.int16)
image = gh.make_volume(values, (10, 20, 30), (1, 2, 3), (1, 2, 3), turn)
gh.write(image, path, **LOSSLESS)
reader = gh.open_file(path)
reader.UpdateInformation()
key = vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()
assert reader.GetOutputInformation(0).Get(key) == image.GetExtent()
assert reader.GetNumberOfChunks() == 3 * 3 * 2, reader.GetNumberOfChunks()
assert reader.GetBlockSize() == 8 and reader.GetLossless() and reader.GetRateControl() == 1
assert reader.GetFileBytes() == os.path.getsize(path)
assert abs(reader.GetBitsPerVoxel() - 8 * os.path.getsize(path) / values.size) < 1e-9
span = [0, 0]
reader.GetRange(span)
assert span == [values.min(), values.max()], span
opened = gm.statistic(reader, "BytesRead")
assert opened < 0.1 * reader.GetFileBytes()
for part in ((10, 12, 20, 21, 30, 30), (70, 75, 80, 90, 40, 99), (149, 149, 149, 149, 99, 99),
             (10, 149, 50, 50, 30, 99)):
    reader.UpdateExtent(part)
    output = reader.GetOutput()
    assert output.GetExtent() == part
    x0, x1, y0, y1, z0, z1 = part
    expected = values[z0 - 30:z1 - 29, y0 - 20:y1 - 19, x0 - 10:x1 - 9]
    assert (gh.values_of(output) == expected).all()
    assert output.GetOrigin() == image.GetOrigin() and output.GetSpacing() == image.GetSpacing()
one = gh.open_file(path)
one.UpdateExtent((10, 12, 20, 21, 30, 30))
assert gm.statistic(one, "BytesRead") - opened < 0.2 * one.GetFileBytes()
one.UpdateExtent((0, -1, 0, -1, 0, -1))
assert one.GetErrorCode() == 0

# Rate control: each bound is met, and smaller errors take more bits.
values = (1000 * gh.blobs((40, 50, 60), seed=7) + rng.normal(0, 10, (40, 50, 60))).astype(np.int16)
image = gh.make_volume(values)
span = float(values.max()) - float(values.min())


def pack(**options):
    """Bits a voxel and root mean square error."""
    writer = gh.write(image, path, **options)
    error = gh.values_of(gh.read(path)).astype(float) - values
    rms = np.sqrt((error ** 2).mean())
    assert abs(rms - gm.statistic(writer, "RMSError")) < 1e-6 * rms + 1e-9, (rms, writer)
    assert abs(error).max() == gm.statistic(writer, "MaximumError")
    assert gm.statistic(writer, "FileBytes") == os.path.getsize(path)
    return 8 * os.path.getsize(path) / values.size, rms


for name, mode, settings in (("Quality", 0, (30, 50, 70)), ("RMSError", 1, (20, 5, 1)),
                             ("PSNR", 2, (35, 45, 60)), ("BitsPerVoxel", 3, (0.5, 1, 3))):
    results = [pack(RateControl=mode, **{name: value}) for value in settings]
    bits, errors = zip(*results)
    print(name, *("%g: %.3f bits, rms %.3f;" % (value, *one) for value, one in zip(settings, results)))
    assert bits[0] < bits[1] < bits[2] and errors[0] > errors[1] > errors[2], results
    for value, (taken, rms) in zip(settings, results):
        met = {0: True, 1: rms <= value, 2: 20 * np.log10(span / rms) >= value, 3: abs(taken / value - 1) <= 0.01}
        assert met[mode], (name, value, taken, rms)
# Within the range of before, whatever the error.
pack(RateControl=0, Quality=10)
coarse = gh.values_of(gh.read(path))
assert values.min() <= coarse.min() and coarse.max() <= values.max()

# The array is the one that is asked for.
other = gm.add_array(image.GetPointData(), np.arange(values.size, dtype=np.float32), "other")
writer = gh.vtkGatunHartleyWriter()
writer.SetInputData(image)
writer.SetFileName(path)
writer.SetInputArrayToProcess(0, 0, 0, 0, "other")
assert writer.Write() == 1
assert gh.describe(gh.read(path).GetPointData().GetScalars())[0] == "other"

# A file that is written anew is read anew, by the same reader.
reader = gh.open_file(path)
reader.Update()
gh.write(gh.make_volume(np.full((4, 4, 4), 7, np.uint8)), path)
reader.Update()
assert reader.GetOutput().GetDimensions() == (4, 4, 4)
assert (vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()) == 7).all()
assert reader.CanReadFile(path) == 1 and reader.CanReadFile(__file__) == 0
assert reader.CanReadFile(path + "no") == 0 and str(reader) and str(writer)
