# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files that cannot be read: the right code, a message with the file's name, an empty output, and
a reader that works again once the file does. What changes on disk is noticed."""

import os
import shutil

import numpy as np
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader

NOT_FOUND, CANNOT_OPEN = vtkErrorCode.FileNotFoundError, vtkErrorCode.CannotOpenFileError
UNRECOGNIZED, PREMATURE = vtkErrorCode.UnrecognizedFileTypeError, vtkErrorCode.PrematureEndOfFileError
FORMAT, NO_NAME = vtkErrorCode.FileFormatError, vtkErrorCode.NoFileNameError

good = gm.temporary("good.gtn")
grid = gm.block(n=3)
gm.write(grid, good, ChunkSize=64)
content = open(good, "rb").read()
bad = gm.temporary("bad.gtn")


def put(data):
    with open(bad, "wb") as file:
        file.write(data)


reader = vtkGatunReader()
errors = gm.Errors(reader)


def expect_good():
    errors.messages.clear()
    reader.SetFileName(good)
    reader.Update()
    assert reader.GetErrorCode() == 0 and not errors.messages
    gm.assert_same_mesh(grid, reader.GetOutput())


def expect_error(path, *codes, or_right=False):
    """Reads a bad file after a good one; or_right: unless it reads as the good one."""
    expect_good()
    reader.SetFileName(path)
    reader.Update()
    if or_right and reader.GetErrorCode() == 0:
        gm.assert_same_mesh(grid, reader.GetOutput())
        return None
    assert reader.GetErrorCode() in codes, (reader.GetErrorCode(), codes, str(errors))
    assert len(errors.messages) == 1, str(errors)
    if path:
        assert path in str(errors), str(errors)
    output = reader.GetOutput()
    assert output.GetNumberOfPoints() == 0 and output.GetNumberOfCells() == 0
    assert output.GetPointData().GetNumberOfArrays() == 0
    assert output.GetFieldData().GetNumberOfArrays() == 0
    assert not reader.GetErrorCode() == 0
    text = str(errors)
    expect_good()
    return text


expect_error(None, NO_NAME)
expect_error(bad, NOT_FOUND)
expect_error(os.path.join(bad, "in no folder.gtn"), NOT_FOUND)
folder = gm.temporary("folder.gtn")
os.makedirs(folder, exist_ok=True)
expect_error(folder, CANNOT_OPEN)
if os.geteuid() != 0:
    put(content)
    os.chmod(bad, 0)
    expect_error(bad, CANNOT_OPEN)
    os.remove(bad)
put(b"")
expect_error(bad, UNRECOGNIZED, PREMATURE)
put(b"<?xml version='1.0'?><VTKFile/>" * 20)
expect_error(bad, UNRECOGNIZED)
put(np.random.default_rng(1).bytes(100000))
expect_error(bad, UNRECOGNIZED)

# CanReadFile looks at the beginning alone.
assert reader.CanReadFile(good) == 1
for path in (bad, folder, "no such file", ""):
    assert reader.CanReadFile(path) == 0, path
put(content[:len(content) // 2])
assert reader.CanReadFile(bad) == 1
assert reader.GetFileExtensions() == ".gtn" and reader.GetDescriptiveName()

# Cut short, at places all over the file.
for length in sorted({*range(1, 40), *range(40, len(content), 97), len(content) - 1}):
    put(content[:length])
    expect_error(bad, UNRECOGNIZED, PREMATURE, FORMAT)

# A byte of another value is noticed, in the directory as in the data, unless it is one that nobody
# needs, such as a section's length, which the directory has too.
harmless = []
for place in range(0, len(content), 61):
    changed = bytearray(content)
    changed[place] ^= 0x5A
    put(changed)
    if expect_error(bad, UNRECOGNIZED, PREMATURE, FORMAT, vtkGatunErrorCode.UnsupportedVersionError,
                    or_right=True) is None:
        harmless.append(place)
assert len(harmless) < 0.1 * len(range(0, len(content), 61)), (harmless, len(content))
put(content + b"more")
expect_error(bad, UNRECOGNIZED, PREMATURE, FORMAT)

# Only what is asked for is read: a damaged array does no harm to one who does not want it.
changed_arrays = 0
for place in range(0, len(content), 61):
    changed = bytearray(content)
    changed[place] ^= 0x5A
    put(changed)
    other = vtkGatunReader()
    gm.Errors(other)
    other.SetFileName(bad)
    other.UpdateInformation()
    if other.GetErrorCode() == 0:
        other.GetPointDataArraySelection().DisableAllArrays()
        other.GetCellDataArraySelection().DisableAllArrays()
        other.Update()
        changed_arrays += other.GetErrorCode() == 0
assert changed_arrays > 0

# A file that changes is read anew at the next update; one that does not is not read again.
changing = gm.temporary("changing.gtn")
gm.write(grid, changing)
reader = vtkGatunReader()
reader.SetFileName(changing)
reader.Update()
first = reader.GetOutput().GetPoints()
size = gm.statistic(reader, "BytesRead")
reader.Update()
assert gm.statistic(reader, "BytesRead") == size
other = gm.block(n=2)
gm.write(other, changing)
reader.Update()
gm.assert_same_mesh(other, reader.GetOutput())
# In place, too.
shutil.copyfile(good, changing)
reader.Update()
gm.assert_same_mesh(grid, reader.GetOutput())
# Gone, and back.
errors = gm.Errors(reader)
os.remove(changing)
reader.Update()
assert reader.GetErrorCode() == NOT_FOUND and reader.GetOutput().GetNumberOfCells() == 0
assert reader.GetChunkTable() is None and gm.statistic(reader, "BytesRead") == 0
shutil.copyfile(good, changing)
reader.Update()
assert reader.GetErrorCode() == 0
gm.assert_same_mesh(grid, reader.GetOutput())
# Through a filter, as well.
from vtkmodules.vtkFiltersCore import vtkAppendFilter

append = vtkAppendFilter()
append.SetInputConnection(reader.GetOutputPort())
append.Update()
gm.write(other, changing)
append.Update()
assert append.GetOutput().GetNumberOfCells() == other.GetNumberOfCells()
