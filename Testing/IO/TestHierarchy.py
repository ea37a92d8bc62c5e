# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files with a hierarchy: the reader gives what vtkGatunSimplify makes of the mesh, by any target, with
and without base meshes, in pieces, regions and time steps; and says what it cannot do."""

import numpy as np

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunSimplify

points, tets = gm.lattice(18, seed=3)  # 29,478 tetrahedra
grid = gm.make_grid(points, tets)
wave = np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2
gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
gm.add_array(grid.GetPointData(), np.arange(len(points)), "point id")
gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell id")
grid.GetPointData().SetActiveScalars("wave")

simplifier = vtkGatunSimplify()
simplifier.SetInputDataObject(grid)


def simplified(**options):
    simplifier.SetSimplificationNumberOfPoints(0)
    simplifier.SetSimplificationRMSError(0)
    gm.set_options(simplifier, **options)
    simplifier.Update()
    return simplifier.GetOutput()


def numbers(data, name):
    return gm.values_of(data.GetArray(name)).ravel()


kept = gm.temporary("kept.gtn")
plain = gm.temporary("plain.gtn")
levels = gm.temporary("levels.gtn")
gm.write(grid, kept, KeepOrder=7, ChunkSize=1000, Hierarchy=True)
gm.write(grid, plain, ChunkSize=1000, Hierarchy=True)
gm.write(grid, levels, ChunkSize=1000, Hierarchy=True, Levels=9)

# Dependencies between merges are stored if they are asked for.
assert gm.statistic(gm.write(grid, plain, ChunkSize=1000, Hierarchy=True), "DependencyBytes") == 0
writer = gm.write(grid, plain, ChunkSize=1000, Hierarchy=2)
assert gm.statistic(writer, "DependencyBytes") > 0
parts = ("Connectivity", "Geometry", "Order", "Array", "FieldData", "Hierarchy", "Dependency",
         "Level", "Boundary", "Directory")
assert sum(gm.statistic(writer, part + "Bytes") for part in parts) == gm.statistic(writer, "FileBytes")
alone = gm.temporary("alone.gtn")
assert gm.statistic(gm.write(grid, alone, ChunkSize=1000), "DependencyBytes") == 0  # there is no hierarchy

# The error goes before the number of points, and that before the ratio.
assert 600 < simplified(SimplificationRatio=0.9, SimplificationNumberOfPoints=700).GetNumberOfPoints() <= 700
by_error = simplified(SimplificationRMSError=0.004)
both = simplified(SimplificationRatio=0.9, SimplificationNumberOfPoints=700, SimplificationRMSError=0.004)
gm.assert_same_mesh(both, by_error)

# Every target, from every file; in the original order where the file keeps it.
TARGETS = (
    {"SimplificationRatio": 0.3}, {"SimplificationRatio": 0.9}, {"SimplificationRatio": 1},
    {"SimplificationNumberOfPoints": 700},
    {"SimplificationRMSError": 0.004},
)
for target in TARGETS:
    expected = simplified(**target)
    assert 0 < expected.GetNumberOfPoints() < len(points)
    got = gm.read(kept, **target)
    np.testing.assert_array_equal(gm.coordinates(got), gm.coordinates(expected))
    gm.assert_same_arrays(got.GetPointData(), expected.GetPointData())
    gm.assert_same_arrays(got.GetCellData(), expected.GetCellData())
    for path in (kept, plain, levels):
        gm.assert_same_mesh(gm.read(path, **target), expected)

# More points than there are, or nothing to do: the mesh.
for options in ({"SimplificationNumberOfPoints": 10 ** 9}, {"SimplificationRMSError": 1e-300}, {}):
    gm.assert_same_mesh(gm.read(plain, **options), grid)

# One reader, to and fro, reads no more than it must.
reader = vtkGatunReader()
reader.SetFileName(levels)
reader.UpdateInformation()
assert reader.GetHasHierarchy()
reader.SetSimplificationRatio(0.88)
reader.Update()
few = gm.statistic(reader, "DecodedChunks")
bytes_read = gm.statistic(reader, "BytesRead")
gm.assert_same_mesh(reader.GetOutput(), simplified(SimplificationRatio=0.88))
reader.SetSimplificationRatio(0.92)  # from the same base mesh, which is kept
reader.Update()
assert gm.statistic(reader, "DecodedChunks") == few
gm.assert_same_mesh(reader.GetOutput(), simplified(SimplificationRatio=0.92))
reader.SetSimplificationRatio(0)
reader.Update()
assert gm.statistic(reader, "DecodedChunks") > 2 * few and gm.statistic(reader, "BytesRead") > 2 * bytes_read
gm.assert_same_mesh(reader.GetOutput(), grid)

# Pieces fit together, with ghost cells around them.
ids = []
for piece in range(3):
    reader.SetSimplificationRatio(0.5)
    reader.SetFileName(plain)
    reader.UpdatePiece(piece, 3, 1)
    output = reader.GetOutput()
    ghosts = numbers(output.GetCellData(), "vtkGhostType")
    cells = numbers(output.GetCellData(), "cell id")
    assert ghosts.any() and not ghosts.all()
    ids.extend(cells[ghosts == 0])
expected = numbers(simplified(SimplificationRatio=0.5).GetCellData(), "cell id")
np.testing.assert_array_equal(np.sort(ids), np.sort(expected))

# A region: whole chunks, of the simplified mesh, all that touch it.
reader = vtkGatunReader()
reader.SetFileName(plain)
reader.SetSimplificationRatio(0.8)
reader.SetBox(0, 0.2, 0, 0.2, 0, 0.2)
reader.Update()
got = set(numbers(reader.GetOutput().GetCellData(), "cell id"))
whole = simplified(SimplificationRatio=0.8)
corners = gm.coordinates(whole)[gm.connectivity(whole).reshape(-1, 4)]
inside = (corners.min(1) <= 0.2).all(1)
wanted = set(numbers(whole.GetCellData(), "cell id")[inside])
assert wanted and wanted <= got

# Large meshes on demand, unless they are simplified enough.
reader = vtkGatunReader()
reader.SetFileName(plain)
reader.SetLargeMesh(10000)
reader.UpdateInformation()
assert reader.GetIsOnDemand()
reader.SetSimplificationRatio(0.9)
assert not reader.GetIsOnDemand()


def expect_error(path, words, **options):
    failing = vtkGatunReader()
    errors = gm.Errors(failing)
    failing.SetFileName(path)
    for name, value in options.items():
        getattr(failing, "Set" + name)(value)
    failing.Update()
    assert words in str(errors) and path in str(errors), (words, str(errors))
    assert failing.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
    assert failing.GetOutput().GetNumberOfCells() == 0
    # Asked for something else, the same reader works.
    errors.messages.clear()
    failing.SetSimplificationRMSError(0)
    failing.SetSimplificationRatio(0)
    failing.Update()
    assert failing.GetErrorCode() == 0 and not errors.messages
    gm.assert_same_mesh(failing.GetOutput(), grid)


without = gm.temporary("without.gtn")
gm.write(grid, without)
expect_error(without, "there is no hierarchy in the file; make one with gtn pack --hierarchy",
             SimplificationRatio=0.5)
expect_error(plain, "the ratio must be from 0 to 1", SimplificationRatio=float("nan"))
expect_error(plain, "the RMS error must be 0 or more",
             SimplificationRMSError=float("nan"))
reader = vtkGatunReader()
for name, value, clamped in (
        ("SimplificationRatio", -0.1, 0), ("SimplificationRatio", 1.5, 1),
        ("SimplificationNumberOfPoints", -5, 0), ("SimplificationRMSError", -1, 0)):
    getattr(reader, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    assert getattr(reader, "Get" + name)() == clamped, name

# Meshes that cannot be simplified have a hierarchy without merges.
one = gm.make_grid(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), [[0, 1, 2, 3]])
path = gm.temporary("one.gtn")
gm.write(one, path, Hierarchy=True, Levels=3)
gm.assert_same_mesh(gm.read(path, SimplificationRatio=1), one)
empty = gm.make_grid(np.zeros((0, 3), np.float32), np.zeros((0, 4)))
path = gm.temporary("nothing.gtn")
gm.write(empty, path, Hierarchy=True, Levels=3)
assert gm.read(path, SimplificationRatio=0.5).GetNumberOfPoints() == 0
