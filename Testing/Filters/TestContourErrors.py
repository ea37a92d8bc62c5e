# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunContour with input that is unusual or wrong: what can be done is done, and what cannot is told
in words that help; afterwards the filter works as before."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunContours as gc
import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunContour, vtkGatunReader, vtkGatunWriter

INVALID = vtkGatunErrorCode.InvalidInputError

points, tets = gm.lattice(8, seed=3)
wave = (np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2).astype(np.float32)
vector = points[:, ::-1].astype(np.float64) ** 2


def make_grid(cells=tets, values=wave):
    grid = gm.make_grid(points, cells)
    gm.add_array(grid.GetPointData(), values, "wave")
    gm.add_array(grid.GetPointData(), vector, "vector")
    gm.add_array(grid.GetCellData(), np.arange(len(cells)), "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def write(grid, name="contour-errors.gtn", **options):
    path = gm.temporary(name)
    gm.write(grid, path, ChunkSize=300, **options)
    return path


def expect_error(contour, *words, code=None):
    """One message, with these words; then nothing comes out."""
    errors = gm.Errors(contour)
    contour.Update()
    assert len(errors.messages) == 1, errors.messages
    for word in words:
        assert word in str(errors), (word, str(errors))
    assert "The isosurface cannot be made: " in str(errors) or ".gtn: " in str(errors)
    assert contour.GetErrorCode() == (code or contour.GetErrorCode()) != 0, contour.GetErrorCode()
    output = contour.GetOutput()
    assert output.GetNumberOfPoints() == output.GetNumberOfCells() == 0
    assert output.GetPointData().GetNumberOfArrays() == 0


grid = make_grid()
path = write(grid)
sources = lambda: (grid, gc.open_file(path))
expected = [gc.contour_of(source, 0.4, "wave") for source in sources()]
assert all(output.GetNumberOfCells() > 300 for output in expected)


def expect_recovery(contour, output):
    contour.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    contour.SetArrayComponent(-1)
    contour.SetNumberOfContours(1)
    contour.SetValue(0, 0.4)
    contour.Update()
    assert contour.GetErrorCode() == 0
    gc.assert_identical(contour.GetOutput(), output)


# Arrays and components that are not there, and isovalues that are no numbers; from both.
for source, output in zip(sources(), expected):
    contour = gc.make_contour(source, 0.4, "wave")
    contour.SetInputArrayToProcess(0, 0, 0, 0, "nothing")
    expect_error(contour, "there is no point array 'nothing'", code=INVALID)
    expect_recovery(contour, output)
    contour.SetInputArrayToProcess(0, 0, 0, 0, "cell")
    expect_error(contour, "there is no point array 'cell'", code=INVALID)
    for association in (1, 2, 4, 6):
        contour = gc.make_contour(source, 0.4)
        contour.SetInputArrayToProcess(0, 0, 0, association, "cell")
        expect_error(contour, "need an array on the points", "vtkCellDataToPointData", code=INVALID)
        expect_recovery(contour, output)
    contour = gc.make_contour(source, 0.4)
    contour.SetInputArrayToProcess(0, 0, 0, 0, 1)  # the active vectors, of which there are none
    expect_error(contour, "no active", code=INVALID)
    contour = gc.make_contour(source, 0.4, "wave", ArrayComponent=2)
    expect_error(contour, "array 'wave' has no component 2", code=INVALID)
    expect_recovery(contour, output)
    contour = gc.make_contour(source, 0.4, "vector", ArrayComponent=4)
    expect_error(contour, "array 'vector' has no component 4", code=INVALID)
    for bad in (float("nan"), float("inf"), -float("inf")):
        for values in ([bad], [0.1, bad, 0.4]):
            contour = gc.make_contour(source, values, "wave")
            expect_error(contour, "an isovalue is not a finite number", code=INVALID)
            expect_recovery(contour, output)

    # None at all, and very many.
    contour = gc.make_contour(source, [], "wave")
    contour.Update()
    assert contour.GetErrorCode() == 0 and contour.GetOutput().GetNumberOfCells() == 0
    many = np.linspace(wave.min() - 0.1, wave.max() + 0.1, 5000)
    contour = gc.make_contour(source, many, "wave")
    contour.Update()
    values = vtk_to_numpy(contour.GetOutput().GetPointData().GetArray("wave"))
    near = np.searchsorted(many, values).clip(1, len(many) - 1)
    assert np.minimum(abs(many[near] - values), abs(many[near - 1] - values)).max() < 1e-6
    mesh = grid if source is grid else gm.read(path)
    corners = np.sort(vtk_to_numpy(mesh.GetPointData().GetArray("wave"))[gm.connectivity(mesh)], axis=1)
    above = [np.searchsorted(many, corners[:, i].astype(float), "right") for i in range(4)]
    sections = (above[1] - above[0]) + 2 * (above[2] - above[1]) + (above[3] - above[2])
    assert 0.99 * sections.sum() < contour.GetOutput().GetNumberOfCells() <= sections.sum()
    expect_recovery(contour, output)

    # Below and above all.
    for value in (wave.min(), -1e300, 1e300, float(wave.max()) * 1.001):
        contour = gc.make_contour(source, float(value), "wave")
        contour.Update()
        assert contour.GetErrorCode() == 0 and contour.GetOutput().GetNumberOfCells() == 0

# No scalars are active, but an array is there.
plain = make_grid()
plain.GetPointData().SetActiveScalars(None)
for source in (plain, gc.open_file(write(plain, "contour-plain.gtn"))):
    expect_error(gc.make_contour(source, 0.4), "there are no active point scalars", code=INVALID)
    assert gc.contour_of(source, 0.4, "wave").GetPointData().GetScalars().GetName() == "wave"

# No arrays; nothing at all; a file without steps is one without arrays.
bare = gm.make_grid(points, tets)
for source in (bare, gc.open_file(write(bare, "contour-bare.gtn"))):
    expect_error(gc.make_contour(source, 0.4), "there are no active point scalars", code=INVALID)
    expect_error(gc.make_contour(source, 0.4, "wave"), "there is no point array 'wave'", code=INVALID)
for empty in (vtkUnstructuredGrid(), gm.make_grid(points, []), make_grid(cells=tets[:0])):
    contour = gc.make_contour(empty, 0.4, "wave")
    contour.Update()
    assert contour.GetErrorCode() == 0 and contour.GetOutput().GetNumberOfCells() == 0
contour = gc.make_contour(gc.open_file(write(make_grid(tets[:0]), "contour-empty.gtn")), 0.4, "wave")
contour.Update()
assert contour.GetErrorCode() == 0 and contour.GetOutput().GetNumberOfCells() == 0

# The array is not selected: as if it were not there.
reader = gc.open_file(path)
reader.UpdateInformation()
reader.SetPointArrayStatus("wave", 0)
contour = gc.make_contour(reader, 0.4, "wave")
expect_error(contour, "there is no point array 'wave'", code=INVALID)
reader.SetPointArrayStatus("wave", 1)
expect_recovery(contour, expected[1])

# A constant field at the isovalue, below and above it.
flat = make_grid(values=np.full(len(points), 2, np.float32))
for source in (flat, gc.open_file(write(flat, "contour-flat.gtn"))):
    for value in (2, 1.999, 2.001):
        assert gc.contour_of(source, value, "wave").GetNumberOfCells() == 0

# Values that are no numbers: the surface of the mesh without these tetrahedra.
for bad in (np.nan, np.inf, -np.inf):
    values = wave.copy()
    values[::23] = bad
    broken = make_grid(values=values)
    for source in (broken, gc.open_file(write(broken, "contour-nan.gtn"))):
        mesh = broken if source is broken else gm.read(source.GetFileName())
        numbers = vtk_to_numpy(mesh.GetPointData().GetArray("wave"))
        corners = gm.connectivity(mesh)
        good = np.isfinite(numbers[corners]).all(1)
        assert 0.5 < good.mean() < 0.99
        left = gm.make_grid(gm.coordinates(mesh), corners[good])
        for array in gm.arrays_of(mesh.GetPointData()):
            left.GetPointData().AddArray(array)
        gm.add_array(left.GetCellData(), vtk_to_numpy(mesh.GetCellData().GetArray("cell"))[good], "cell")
        for value in (0.4, [0.1, 0.2, float(numbers[np.isfinite(numbers)].max())]):
            output = gc.contour_of(source, value, "wave")
            assert gc.assert_same(output, gc.reference(left, value, "wave")) > 100
            assert np.isfinite(vtk_to_numpy(output.GetPointData().GetArray("wave"))).all()

# Huge values, whose differences are infinite.
huge = make_grid(values=np.where(points[:, 0] > 0.5, 1.5e308, -1.5e308))
for source in (huge, gc.open_file(write(huge, "contour-huge.gtn"))):
    middle = gc.points_of(gc.contour_of(source, 0.0, "wave"))
    assert len(middle) > 50 and np.isfinite(middle).all()
    assert (abs(middle[:, 0] - 0.5) < 0.25).all()

# Other cells are made tetrahedra as the writer makes them, to the last bit.
n = 3
axis = np.arange(n + 1)
x, y, z = (a.ravel() for a in np.meshgrid(axis[:-1], axis[:-1], axis[:-1], indexing="ij"))
at = lambda i, j, k: ((x + i) * (n + 1) + y + j) * (n + 1) + z + k
corners = np.stack([at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
                    at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)], 1)
places = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
mixed = gm.make_grid(places.astype(np.float32), [])
mixed.Allocate(len(corners))
for i, ids in enumerate(corners.tolist()):
    if i % 4 == 0:
        mixed.InsertNextCell(c.VTK_WEDGE, 6, [ids[j] for j in (0, 3, 1, 4, 7, 5)])
    elif i % 4 == 1:
        mixed.InsertNextCell(c.VTK_PYRAMID, 5, ids[:5])
    elif i % 4 == 2:
        mixed.InsertNextCell(c.VTK_VOXEL, 8, [ids[j] for j in (0, 1, 3, 2, 4, 5, 7, 6)])
    else:
        mixed.InsertNextCell(c.VTK_HEXAHEDRON, 8, ids)
mixed.InsertNextCell(c.VTK_TETRA, 4, corners[0, [0, 1, 3, 4]].tolist())
gm.add_array(mixed.GetPointData(), np.sin(places * [1.1, 1.7, 0.6]).sum(1), "wave")
gm.add_array(mixed.GetCellData(), np.arange(mixed.GetNumberOfCells()), "cell")
contour = gc.make_contour(mixed, [0.7, 1.2], "wave")
warnings = []
contour.AddObserver("WarningEvent", lambda *_: warnings.append(1))
contour.Update()
assert contour.GetErrorCode() == 0 and not warnings
gc.assert_whole(contour.GetOutput())
mixed_path = gm.temporary("contour-mixed.gtn")
writer = vtkGatunWriter()
writer.AddObserver("WarningEvent", lambda *_: None)
writer.SetInputDataObject(mixed)
writer.SetFileName(mixed_path)
writer.SetKeepOrderToAll()
assert writer.Write() == 1
written = gm.read(mixed_path, SplitCells=True)
assert gc.assert_same(contour.GetOutput(), gc.reference(written, [0.7, 1.2], "wave")) > 100

# Quadratic tetrahedra become linear.
curved = gm.make_grid(np.random.default_rng(5).random((10, 3)), [])
curved.Allocate(1)
curved.InsertNextCell(c.VTK_QUADRATIC_TETRA, 10, list(range(10)))
gm.add_array(curved.GetPointData(), np.arange(10.0), "wave")
straight = gm.make_grid(gm.coordinates(curved)[:4], [0, 1, 2, 3])
gm.add_array(straight.GetPointData(), np.arange(4.0), "wave")
contour = gc.make_contour(curved, 1.5, "wave")
contour.AddObserver("WarningEvent", lambda *_: None)
contour.Update()
assert gc.assert_same(contour.GetOutput(), gc.reference(straight, 1.5, "wave")) == 2

# Ghost cells are left out, and their flags are not carried.
ghosts = make_grid()
flags = np.zeros(len(tets), np.uint8)
flags[::5] = 1
gm.add_array(ghosts.GetCellData(), flags, "vtkGhostType")
output = gc.contour_of(ghosts, 0.4, "wave")
left = make_grid(tets[flags == 0])
left.GetCellData().RemoveArray("cell")
gm.add_array(left.GetCellData(), np.flatnonzero(flags == 0), "cell")
assert gc.assert_same(output, gc.reference(left, 0.4, "wave")) > 300

# Other flags than those of ghosts stay with the mesh, also in a file, but are nothing for a surface.
hidden = make_grid()
flags = np.zeros(len(tets), np.uint8)
flags[::7] = 32
gm.add_array(hidden.GetCellData(), flags, "vtkGhostType")
flags = np.zeros(len(points), np.uint8)
flags[::3] = 2
gm.add_array(hidden.GetPointData(), flags, "vtkGhostType")
hidden_path = write(hidden, "contour-hidden.gtn")
assert gm.read(hidden_path).GetPointData().HasArray("vtkGhostType")
for source, output in ((hidden, expected[0]), (gc.open_file(hidden_path), expected[1])):
    made = gc.contour_of(source, 0.4, "wave")
    assert not made.GetPointData().HasArray("vtkGhostType")
    assert not made.GetCellData().HasArray("vtkGhostType")
    gc.assert_identical(made, output)

# Cells that have no volume, unknown ones, and points that do not exist.
faces = gm.make_grid(points, [])
faces.Allocate(1)
faces.InsertNextCell(c.VTK_TRIANGLE, 3, [0, 1, 2])
gm.add_array(faces.GetPointData(), wave, "wave")
contour = gc.make_contour(faces, 0.4, "wave")
warnings = []
contour.AddObserver("WarningEvent", lambda *_: warnings.append(1))
contour.Update()
assert contour.GetErrorCode() == 0 and contour.GetOutput().GetNumberOfCells() == 0 and warnings
gm.set_cell_type(faces, 0, 99)
expect_error(gc.make_contour(faces, 0.4, "wave"), "type 99", code=INVALID)
for bad in (len(points), -1, 2 ** 40):
    wrong = tets.copy()
    wrong[17, 2] = bad
    contour = gc.make_contour(make_grid(wrong), 0.4, "wave")
    expect_error(contour, "point that does not exist", "17", code=INVALID)
    contour.SetInputDataObject(grid)
    expect_recovery(contour, expected[0])
short = make_grid()
gm.add_array(short.GetPointData(), wave[:-1], "short")
for name in ("short", "wave"):
    expect_error(gc.make_contour(short, 0.4, name), "short", code=INVALID)

# A damaged chunk: no surface where it is needed; where it is not, nobody looks at it.
bytes_of = open(path, "rb").read()
damaged = gm.temporary("contour-damaged.gtn")
wrong, right = 0, 0
low, high = (float(np.quantile(wave, q)) for q in (0.02, 0.999))
for at in range(100, len(bytes_of) - 2000, len(bytes_of) // 40):
    with open(damaged, "wb") as file:
        file.write(bytes_of[:at] + bytes([bytes_of[at] ^ 0x55]) + bytes_of[at + 1:])
    reader = gc.open_file(damaged)
    reader_errors = gm.Errors(reader)
    contour = gc.make_contour(reader, high, "wave")
    errors = gm.Errors(contour)
    contour.Update()
    if contour.GetErrorCode() or reader.GetErrorCode():
        wrong += 1
        assert contour.GetOutput().GetNumberOfCells() == 0
        assert damaged in str(errors) + str(reader_errors)
        if contour.GetErrorCode():
            assert contour.GetErrorCode() == vtkErrorCode.FileFormatError, contour.GetErrorCode()
            # The file is sound again: so is the surface.
            with open(damaged, "wb") as file:
                file.write(bytes_of)
            contour.Modified()
            contour.Update()
            assert contour.GetErrorCode() == 0
            gc.assert_identical(contour.GetOutput(), gc.contour_of(gc.open_file(path), high, "wave"))
    else:
        right += 1
        gc.assert_identical(contour.GetOutput(), gc.contour_of(gc.open_file(path), high, "wave"))
assert wrong > 5 and right > 5, (wrong, right)

# Cut off, gone, or something else, once a surface was made: the reader, which looks first, tells.
for content, code in ((bytes_of[:len(bytes_of) // 2], vtkErrorCode.PrematureEndOfFileError),
                      (b"no such file", vtkErrorCode.UnrecognizedFileTypeError),
                      (b"", vtkErrorCode.UnrecognizedFileTypeError),
                      (None, vtkErrorCode.FileNotFoundError)):
    with open(damaged, "wb") as file:
        file.write(bytes_of)
    reader = gc.open_file(damaged)
    contour = gc.make_contour(reader, 0.4, "wave")
    contour.Update()
    gc.assert_identical(contour.GetOutput(), expected[1])
    assert gm.temporary("contour-damaged.gtn") == damaged  # which removes it
    if content is not None:
        with open(damaged, "wb") as file:
            file.write(content)
    errors = gm.Errors(reader), gm.Errors(contour)
    contour.SetValue(0, 0.41)
    contour.Update()
    assert len(errors[0].messages) + len(errors[1].messages) == 1
    assert damaged in str(errors[0]) + str(errors[1])
    assert code in (reader.GetErrorCode(), contour.GetErrorCode())
    with open(damaged, "wb") as file:
        file.write(bytes_of)
    contour.Modified()
    expect_recovery(contour, expected[1])

# More simplification than a file can do is what the reader tells.
reader = gc.open_file(path, SimplificationRatio=0.5)
errors = gm.Errors(reader)
contour = gc.make_contour(reader, 0.4, "wave")
more = gm.Errors(contour)
contour.Update()
assert path in str(errors), str(errors)
assert contour.GetOutput().GetNumberOfCells() == 0
reader.SetSimplificationRatio(0)
expect_recovery(contour, expected[1])

# A reader without a file, and no input.
reader = vtkGatunReader()
errors = gm.Errors(reader)
contour = gc.make_contour(reader, 0.4, "wave")
more = gm.Errors(contour)
contour.Update()
assert str(errors) and contour.GetOutput().GetNumberOfCells() == 0
contour = vtkGatunContour()
errors = gm.Errors(contour)
contour.SetValue(0, 1)
contour.Update()

# Stopped, and then not.
for source, output in zip(sources(), expected):
    contour = gc.make_contour(source, 0.4, "wave")
    errors = gm.Errors(contour)
    tag = contour.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
    contour.Update()
    assert contour.GetOutput().GetNumberOfPoints() == 0
    assert contour.GetErrorCode() == vtkGatunErrorCode.AbortedError and not str(errors)
    contour.RemoveObserver(tag)
    contour.SetAbortExecute(0)
    contour.Modified()
    expect_recovery(contour, output)
    # Progress goes from 0 to 1.
    steps = []
    contour.AddObserver("ProgressEvent", lambda caller, _: steps.append(caller.GetProgress()))
    contour.SetValue(0, 0.3)
    contour.Update()
    assert steps == sorted(steps) and steps[-1] == 1, steps
