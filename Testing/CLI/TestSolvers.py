# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of solvers, with cells of several types and boundaries: OpenFOAM, CGNS, EnSight. What VTK
reads from them is packed and comes back, and is what was written here."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

import gatunSolverFiles
from gatun.vtk import vtkGatunReader
from gatunCli import enter_folder, gtn, skip

try:
    import h5py  # pylint: disable=unused-import
except ImportError:
    skip("there is no h5py to write CGNS files with")

enter_folder("solvers")

# A lattice of bricks, the corners of each one as VTK has them.
SIZE = (4, 3, 2)
AXES = [np.arange(n + 1, dtype=float) for n in SIZE]
POINTS = np.stack([a.ravel() for a in np.meshgrid(*AXES[::-1], indexing="ij")[::-1]], axis=1)
POINTS[:, 0] += 0.1 * np.sin(POINTS[:, 1])
CELLS = int(np.prod(SIZE))


def point(i, j, k):
    return (k * (SIZE[1] + 1) + j) * (SIZE[0] + 1) + i


BRICKS = np.array([
    [point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k), point(i, j + 1, k),
     point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1)]
    for k in range(SIZE[2]) for j in range(SIZE[1]) for i in range(SIZE[0])])
PRESSURE = 100.0 + np.arange(CELLS) ** 2


def read(name):
    reader = vtkGatunReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def check(name, sets_says):
    """Packs a file with and without its boundaries. Returns both grids."""
    gtn("pack", name, name + ".gtn")
    gtn("verify", "--no-sets", name + ".gtn", name, says="identical")
    gtn("pack", "--sets", name, name + "-sets.gtn")
    gtn("verify", name + "-sets.gtn", name, says="identical")
    gtn("info", name + "-sets.gtn", says=sets_says)
    return read(name + ".gtn"), read(name + "-sets.gtn")


def check_bricks(grid):
    assert grid.GetNumberOfCells() == CELLS and grid.GetNumberOfPoints() == len(POINTS)
    assert np.allclose(grid.GetBounds(), np.stack([POINTS.min(0), POINTS.max(0)], 1).ravel())
    pressure = vtk_to_numpy(grid.GetCellData().GetArray("p"))
    locator = vtkStaticCellLocator()
    locator.SetDataSet(grid)
    locator.BuildLocator()
    for brick, value in zip(BRICKS, PRESSURE):
        cell = locator.FindCell(POINTS[brick].mean(axis=0))
        assert cell >= 0 and pressure[cell] == np.float32(value), (brick, value)


# OpenFOAM.
outer_faces = gatunSolverFiles.write_foam("foam", POINTS, BRICKS, PRESSURE)
inside, everything = check("foam/case.foam", "vtkQuad")
check_bricks(inside)
assert everything.GetNumberOfCells() == CELLS + outer_faces
names = everything.GetFieldData().GetAbstractArray("BlockNames")
assert set(gatunSolverFiles.PATCHES) <= {
    names.GetValue(i).split("/")[-1] for i in range(names.GetNumberOfValues())}

# CGNS.
gatunSolverFiles.write_cgns("case.cgns", POINTS, BRICKS, PRESSURE)
gtn("pack", "case.cgns", "case.cgns.gtn")
gtn("verify", "case.cgns.gtn", "case.cgns", says="identical")
check_bricks(read("case.cgns.gtn"))

# EnSight Gold, which holds float.
gatunSolverFiles.write_ensight("gold", read("case.cgns.gtn"))
gtn("pack", "gold.case", "gold.gtn")
gtn("verify", "gold.gtn", "gold.case", says="identical")
check_bricks(read("gold.gtn"))

# SLC volumes: a header of text, an icon, then a plane of bytes after the other.
voxels = np.random.default_rng(1).integers(0, 256, (4, 5, 6), dtype=np.uint8)
with open("volume.slc", "wb") as file:
    file.write(b"11111\n6 5 4\n8\n1.0 2.0 0.5\n0 1 0\n0\n1 1 X" + bytes(3))
    file.write(voxels.tobytes())
gtn("volume", "pack", "volume.slc", "volume.ghv", says="6 x 5 x 4")

# Damaged files are errors.
with open("bad.cgns", "wb") as file:
    file.write(b"CGNS" + bytes(100))
gtn("pack", "bad.cgns", "bad.gtn", code=1, says="is not a CGNS file")
os.makedirs("empty")
with open("empty/case.foam", "wb"):
    pass
gtn("pack", "empty/case.foam", "bad.gtn", code=1)
assert not os.path.exists("bad.gtn")
