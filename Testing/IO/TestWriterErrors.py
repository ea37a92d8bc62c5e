# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What cannot be written: a code, a message that names the trouble, and the file that was there
before as it was, without any other file left over."""

import os
import resource
import signal
import subprocess

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray, vtkIdList, vtkStringArray, vtkTypeInt64Array, vtkVariant, vtkVariantArray)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunWriter

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "writer-errors")
os.makedirs(folder, exist_ok=True)
for name in os.listdir(folder):
    os.remove(os.path.join(folder, name))
path = os.path.join(folder, "mesh.gtn")
points, tets = gm.lattice(3)
gm.write(gm.make_grid(points, tets), path)
before = open(path, "rb").read()


def refuse(grid, *texts, expected=vtkGatunErrorCode.InvalidInputError, to=path, **options):
    writer = vtkGatunWriter()
    errors = gm.Errors(writer)
    if grid is not None:
        writer.SetInputDataObject(grid)
    writer.SetFileName(to)
    gm.set_options(writer, **options)
    assert writer.Write() == 0
    assert writer.GetErrorCode() == expected, (writer.GetErrorCode(), str(errors))
    assert len(errors.messages) == 1, str(errors)
    for text in texts:
        assert text in str(errors), (text, str(errors))
    if to and grid is not None:
        assert to in str(errors), str(errors)
    assert open(path, "rb").read() == before
    assert os.listdir(folder) == ["mesh.gtn"], os.listdir(folder)


def cells_of(cell_type, size, count=2):
    grid = gm.make_grid(np.random.default_rng(0).random((50, 3)), [])
    grid.Allocate(count)
    for i in range(count):
        grid.InsertNextCell(cell_type, size, list(range(i, i + size)))
    return grid


good = gm.make_grid(points, tets)
refuse(None, "No input")
refuse(good, "FileName", to=None, expected=vtkErrorCode.NoFileNameError)
refuse(good, "FileName", to="", expected=vtkErrorCode.NoFileNameError)

# Cells.
for kind, size, right in ((c.VTK_HEXAHEDRON, 7, 8), (c.VTK_WEDGE, 8, 6), (c.VTK_PYRAMID, 4, 5),
                          (c.VTK_QUADRATIC_HEXAHEDRON, 19, 20), (c.VTK_TETRA, 5, 4)):
    refuse(cells_of(kind, size), "has %d points, not %d" % (size, right))
refuse(cells_of(99, 3), "2 of type 99", SplitCells=True)
# A polyhedron without points in a grid that has none.
nothing = vtkUnstructuredGrid()
nothing.Allocate(1)
faces = vtkIdList()
faces.InsertNextId(0)
nothing.InsertNextCell(42, faces)
nothing.SetPoints(None)
writer = vtkGatunWriter()
writer.AddObserver("WarningEvent", lambda *_: None)
writer.SetInputDataObject(nothing)
writer.SetFileName(gm.temporary("polyhedron-of-nothing.gtn"))
assert writer.Write() == 1

def one_polyhedron():
    grid = gm.make_grid(points, [])
    faces = vtkIdList()
    for number in (4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3):
        faces.InsertNextId(number)
    grid.Allocate(1)
    grid.InsertNextCell(42, faces)
    return grid


beyond = "faces beyond the end"
if hasattr(vtkUnstructuredGrid, "GetPolyhedronFaces"):  # since VTK 9.4
    for wrong in (len(points), -1):
        polyhedron = one_polyhedron()
        vtk_to_numpy(polyhedron.GetPolyhedronFaces().GetConnectivityArray())[0] = wrong
        refuse(polyhedron, "cell 0", "uses point %d" % wrong)
    for wrong in (4, -1, 2 ** 40):
        polyhedron = one_polyhedron()
        vtk_to_numpy(polyhedron.GetPolyhedronFaceLocations().GetConnectivityArray())[0] = wrong
        refuse(polyhedron, "names face %d of 4" % wrong)
else:
    for place, value, message in ((0, 5, beyond), (0, -1, "-1 faces"), (1, 400, beyond),
                                  (1, -3, "a face of -3 points"),
                                  (2, len(points), "uses point %d" % len(points)),
                                  (16, -1, "uses point -1"), (13, 2 ** 40, beyond)):
        polyhedron = one_polyhedron()
        polyhedron.GetFaces().SetValue(place, value)
        refuse(polyhedron, "cell 0", message)
        polyhedron.GetFaceLocations().SetValue(0, 100)
        refuse(polyhedron, "cell 0", beyond)
        polyhedron.GetFaceLocations().SetValue(0, -7)
        refuse(polyhedron, "cell 0", "a polyhedron without faces")
writer = vtkGatunWriter()
errors = gm.Errors(writer)
writer.SetInputDataObject(vtkTable())
writer.SetFileName(path)
assert writer.Write() == 0 and open(path, "rb").read() == before

# Ids out of range, in tetrahedra and in cells that would be split.
for wrong in (len(points), -1, 1 << 40, -(1 << 62)):
    bad = tets.copy()
    bad[7, 2] = wrong
    refuse(gm.make_grid(points, bad), str(wrong))
hexahedron = cells_of(c.VTK_HEXAHEDRON, 8)
vtk_to_numpy(hexahedron.GetCells().GetConnectivityArray())[3] = 50
refuse(hexahedron, "cell 0", "point 50 of 50")
ids = tets.astype(np.int32)
ids[3, 3] = -7
refuse(gm.make_grid(points, ids, wide=False), "-7")
no_points = gm.make_grid(np.zeros((0, 3)), [[0, 1, 2, 3]])
refuse(no_points, "point")

# A tetrahedron of five corners.
five = vtkUnstructuredGrid()
five.SetPoints(good.GetPoints())
cells, offsets, corners = vtkCellArray(), vtkTypeInt64Array(), vtkTypeInt64Array()
for value in (0, 4, 9):
    offsets.InsertNextValue(value)
for value in range(9):
    corners.InsertNextValue(value)
cells.SetData(offsets, corners)
five.SetCells(c.VTK_TETRA, cells)
refuse(five, "cell 1 (type 10, vtkTetra) has 5 points, not 4")


# Arrays.
def with_array(array, cell=False):
    grid = gm.make_grid(points, tets)
    (grid.GetCellData() if cell else grid.GetPointData()).AddArray(array)
    return grid


for cell, count in ((False, len(points)), (True, len(tets))):
    place = "cell" if cell else "point"
    texts = vtkStringArray()
    texts.SetName("labels")
    texts.SetNumberOfValues(count)
    refuse(with_array(texts, cell), place + " array 'labels'", "vtkStringArray", "deselect")
    variants = vtkVariantArray()
    variants.SetName("anything")
    variants.SetNumberOfValues(count)
    refuse(with_array(variants, cell), place + " array 'anything'")
    for length in (count - 1, count + 1, 0):
        short = vtkDoubleArray()
        short.SetName("short")
        short.SetNumberOfTuples(length)
        refuse(with_array(short, cell), place + " array 'short'", str(length), str(count))
    # Deselected, it does no harm.
    writer = vtkGatunWriter()
    writer.SetInputDataObject(with_array(texts, cell))
    other = os.path.join(folder, "other.gtn")
    writer.SetFileName(other)
    (writer.GetCellDataArraySelection() if cell else writer.GetPointDataArraySelection()) \
        .DisableArray("labels")
    assert writer.Write() == 1
    gm.assert_same_mesh(good, gm.read(other))
    os.remove(other)

# Integer coordinates that no double can hold.
huge = np.zeros((4, 3), np.int64)
huge[2, 1] = (1 << 53) + 1
refuse(gm.make_grid(huge, [[0, 1, 2, 3]]), "point 2", "2^53")

# Places to write to.
refuse(good, to=os.path.join(folder, "missing", "mesh.gtn"),
       expected=vtkErrorCode.CannotOpenFileError)
nested = os.path.join(os.environ["GATUN_TEST_TEMP"], "writer-is-a-folder.gtn")
os.makedirs(nested, exist_ok=True)
refuse(good, to=nested, expected=vtkErrorCode.CannotOpenFileError)
if os.geteuid() != 0:
    os.chmod(folder, 0o500)
    refuse(good, expected=vtkErrorCode.CannotOpenFileError)
    os.chmod(folder, 0o700)

os.chmod(path, 0o444)
refuse(good, "is read-only", expected=vtkErrorCode.CannotOpenFileError)
os.chmod(path, 0o644)

# No file may be that large.
points, tets = gm.lattice(12)
noise = gm.make_grid(points, tets)
rng = np.random.default_rng(0)
gm.add_array(noise.GetPointData(), rng.random((len(points), 30)), "noise")
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
limits = resource.getrlimit(resource.RLIMIT_FSIZE)
for size in (0, 1000, 100000):
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, limits[1]))
    try:
        refuse(noise, expected=vtkErrorCode.CannotOpenFileError)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)

# A disk that is full, where we may make a small one.
disk = os.path.join(os.environ["GATUN_TEST_TEMP"], "small-disk")
os.makedirs(disk, exist_ok=True)
mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", disk],
                         stderr=subprocess.DEVNULL, check=False).returncode == 0
if mounted:
    try:
        folder, path = disk, os.path.join(disk, "mesh.gtn")
        gm.write(good, path)
        before = open(path, "rb").read()
        refuse(noise, expected=vtkErrorCode.OutOfDiskSpaceError, to=path)
    finally:
        subprocess.run(["umount", disk], check=True)
