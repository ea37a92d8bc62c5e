# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What is no volume to write or no .ghv file to read is told in words that help; nothing is left over,
and files that were there stay."""

import os

import numpy as np
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunHartley as gh
import gatunMeshes as gm
from gatun.vtk import (
    vtkGatunErrorCode, vtkGatunHartleyEncoder, vtkGatunHartleyReader, vtkGatunHartleyWriter)

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "hartley-errors")
os.makedirs(folder, exist_ok=True)
for name in os.listdir(folder):
    os.chmod(os.path.join(folder, name), 0o600)
    os.remove(os.path.join(folder, name))
path = os.path.join(folder, "volume.ghv")
values = (200 * gh.blobs((9, 8, 10))).astype(np.float32)
good = gh.make_volume(values)
gh.write(good, path)
before = open(path, "rb").read()


def refuse(image, *texts, expected=vtkGatunErrorCode.InvalidInputError, to=path, array=None,
           **options):
    writer = vtkGatunHartleyWriter()
    errors = gm.Errors(writer)
    if image is not None:
        writer.SetInputDataObject(image)
    writer.SetFileName(to)
    if array is not None:
        writer.SetInputArrayToProcess(0, 0, 0, *array)
    gm.set_options(writer, **options)
    assert writer.Write() == 0
    assert writer.GetErrorCode() == expected, (writer.GetErrorCode(), str(errors))
    assert len(errors.messages) == 1, str(errors)
    for text in texts:
        assert text in str(errors), (text, str(errors))
    if to and image is not None:
        assert str(errors).count(to) == 1, str(errors)
    assert open(path, "rb").read() == before
    assert os.listdir(folder) == ["volume.ghv"], os.listdir(folder)


def with_array(array, name="array"):
    image = gh.make_volume(values)
    array.SetName(name)
    image.GetPointData().AddArray(array)
    return image


# What is no volume.
refuse(None, "No input")
refuse(vtkImageData(), "the volume is empty")
bare = gh.make_volume(values)
bare.GetPointData().SetScalars(None)
while bare.GetPointData().GetNumberOfArrays():
    bare.GetPointData().RemoveArray(0)
refuse(bare, "there are no active point")
refuse(bare, "there is no point array 'density'", array=(0, "density"))
cells = gh.make_volume(values)
gm.add_array(cells.GetCellData(), np.zeros(cells.GetNumberOfCells()), "cell")
refuse(cells, "needs a point array", "vtkCellDataToPointData", array=(1, "cell"))
vectors = gh.make_volume(values)
gm.add_array(vectors.GetPointData(), np.zeros((values.size, 3)), "velocity")
refuse(vectors, "'velocity' has 3 components", "vtkImageExtractComponents", array=(0, "velocity"))
texts = vtkStringArray()
texts.SetNumberOfValues(values.size)
refuse(with_array(texts), "'array' is a vtkStringArray", array=(0, "array"))
bits = vtkBitArray()
bits.SetNumberOfValues(values.size)
refuse(with_array(bits), "'array' is a vtkBitArray", array=(0, "array"))
short = gh.make_volume(values)
gm.add_array(short.GetPointData(), np.zeros(5), "short")
refuse(short, "'short' has 5 values for 720 points", array=(0, "short"))
for bad in (np.nan, np.inf, -np.inf):
    broken = values.copy()
    broken[3, 4, 5] = bad
    refuse(gh.make_volume(broken), "finite")
for wide in ([-1e300, 1e300], [-1e308, 1e308], [0, 1e40], [0, 5e-324]):
    refuse(gh.make_volume(np.array([[wide]])), "beyond single precision")
refuse(gh.make_volume(np.array([[[-2 ** 63, 2 ** 63 - 1]]], np.int64)), "beyond 2^53")

# Properties are clamped to their range; what is not a number is an error.
for owner in (vtkGatunHartleyWriter().GetEncoding(), vtkGatunHartleyEncoder().GetEncoding()):
    for name, values_, expected_ in (
        ("BlockSize", (-1, 1, 65, 2147483647, -2147483648), (0, 2, 64, 64, 0)),
        ("RateControl", (-1, 4), (0, 3)), ("Quality", (0, 101), (1, 100)), ("RMSError", (-1,), (0,)),
        ("PSNR", (0, 201), (1, 200)), ("BitsPerVoxel", (0, -1, 65), (0.001, 0.001, 64)),
        ("FrequencyWeight", (-0.5, 5), (0, 4)),
    ):
        for value, clamped in zip(values_, expected_):
            getattr(owner, "Set" + name)(value)
            assert getattr(owner, "Get" + name)() == clamped, (name, value)
for options in ({"Quality": np.nan}, {"RateControl": 1, "RMSError": np.nan},
                {"RateControl": 2, "PSNR": np.nan}, {"RateControl": 3, "BitsPerVoxel": np.nan},
                {"FrequencyWeight": np.nan}):
    refuse(good, **options)

# Where it cannot be written.
refuse(good, "No FileName", expected=vtkErrorCode.NoFileNameError, to=None)
refuse(good, expected=vtkErrorCode.CannotOpenFileError, to=os.path.join(folder, "no", "volume.ghv"))
refuse(good, expected=vtkErrorCode.CannotOpenFileError, to=folder)
os.chmod(path, 0o400)
refuse(good, expected=vtkErrorCode.CannotOpenFileError)
assert open(path, "rb").read() == before
os.chmod(path, 0o600)
gh.write(good, path)
assert open(path, "rb").read() == before

# Encodings: each writer and encoder has one and never none, which may be shared.
for make in (vtkGatunHartleyWriter, vtkGatunHartleyEncoder):
    one, other = make(), make()
    own = one.GetEncoding()
    assert own and own is one.GetEncoding() and own is not other.GetEncoding()
    one.SetEncoding(other.GetEncoding())
    assert one.GetEncoding() is other.GetEncoding()
    for change in (lambda: other.GetEncoding().SetQuality(33), lambda: one.SetEncoding(None)):
        time = one.GetMTime()
        change()
        assert one.GetMTime() > time, make
    assert one.GetEncoding() not in (None, own, other.GetEncoding())
    assert one.GetEncoding().GetQuality() == 60 and "Quality: 33" in str(other)

# An abort.
writer = vtkGatunHartleyWriter()
writer.SetInputData(good)
writer.SetFileName(path)
writer.AddObserver("ProgressEvent", lambda *_: writer.SetAbortExecute(1))
errors = gm.Errors(writer)
assert writer.Write() == 0 and writer.GetErrorCode() == vtkGatunErrorCode.AbortedError
assert not errors.messages and open(path, "rb").read() == before
assert os.listdir(folder) == ["volume.ghv"]

# Special volumes that are all right.
extra = os.path.join(folder, "extra.ghv")
for fine in (np.full((5, 5, 5), -3.25), np.array([[[1e300]]]), np.array([[[-1e20, 1e20]]]),
             np.array([[[1e-20, 0]]]), np.array([[[-2 ** 52, 2 ** 52]]], np.int64),
             np.zeros((1, 1, 1), np.uint8)):
    for block in (0, 8):
        writer = gh.write(gh.make_volume(fine), extra, BlockSize=block)
        back = gh.values_of(gh.read(extra)).astype(float)
        spread = fine.max().astype(float) - fine.min().astype(float)
        assert np.isfinite(back).all()
        assert (abs(back - fine.astype(float)) <= 0.05 * spread).all(), (fine, back)
os.remove(extra)


# Files.
def fail(name, *texts, expected=None):
    reader = vtkGatunHartleyReader()
    errors = gm.Errors(reader)
    reader.SetFileName(name)
    reader.Update()
    assert reader.GetErrorCode() == (expected or reader.GetErrorCode()) != 0, reader.GetErrorCode()
    assert len(errors.messages) == 1, (name, str(errors))
    for text in texts:
        assert text in str(errors), (text, str(errors))
    assert name is None or str(errors).count(name) == 1, str(errors)
    assert reader.GetOutput().GetNumberOfPoints() == 0
    assert reader.GetOutput().GetPointData().GetNumberOfArrays() == 0
    return reader


fail(None, "No FileName", expected=vtkErrorCode.NoFileNameError)
fail(os.path.join(folder, "missing.ghv"), expected=vtkErrorCode.FileNotFoundError)
fail(folder, expected=vtkErrorCode.CannotOpenFileError)
damaged = os.path.join(folder, "damaged.ghv")
for content in (b"", b"text", b"\0" * 1000, bytes(range(256)) * 50):
    with open(damaged, "wb") as file:
        file.write(content)
    fail(damaged)
mesh = os.path.join(folder, "mesh.gtn")
gm.write(gm.block(), mesh)
fail(mesh, expected=vtkErrorCode.UnrecognizedFileTypeError)

# Truncated anywhere, or with a byte changed anywhere: right, or a message.
told = set()
for length in range(0, len(before), 37):
    with open(damaged, "wb") as file:
        file.write(before[:length])
    fail(damaged)
expected = gh.values_of(gh.read(path)).copy()
for place in range(0, len(before), 11):
    with open(damaged, "wb") as file:
        file.write(before[:place] + bytes([before[place] ^ 0x41]) + before[place + 1:])
    reader = vtkGatunHartleyReader()
    errors = gm.Errors(reader)
    reader.SetFileName(damaged)
    reader.Update()
    if reader.GetErrorCode():
        assert len(errors.messages) == 1 and reader.GetOutput().GetNumberOfPoints() == 0
        told.add(reader.GetErrorCode())
    else:
        assert not errors.messages and (gh.values_of(reader.GetOutput()) == expected).all(), place
assert vtkErrorCode.FileFormatError in told, told

# It then reads another file, and the same one once it is repaired.
reader = fail(damaged) if reader.GetErrorCode() else reader
with open(damaged, "wb") as file:
    file.write(before)
reader.Update()
assert reader.GetErrorCode() == 0 and (gh.values_of(reader.GetOutput()) == expected).all()

# Aborted: no message, nothing kept; the next update is whole.
reader = gh.open_file(path)
tag = reader.AddObserver("ProgressEvent", lambda *_: reader.SetAbortExecute(1))
errors = gm.Errors(reader)
reader.Update()
assert not errors.messages and reader.GetErrorCode() == vtkGatunErrorCode.AbortedError
reader.RemoveObserver(tag)
reader.SetAbortExecute(0)
reader.Update()
assert reader.GetErrorCode() == 0 and (gh.values_of(reader.GetOutput()) == expected).all()
