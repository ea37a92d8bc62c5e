# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunContour makes the triangles of vtkContourGrid, with all arrays, from memory and from files;
and what only it has: normals, strips, one surface whatever the number of threads."""

import os

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools, vtkStringArray

import gatunContours as gc
import gatunMeshes as gm
from gatun.vtk import vtkGatunContour


def wave_of(points):
    x = points.astype(np.float64)
    return np.sin(5 * x[:, 0]) * np.cos(4 * x[:, 1]) + x[:, 2] ** 2


def make_box(n=9, dtype=np.float32, wide=True, wave_type=np.float32):
    points, tets = gm.lattice(n, seed=5, dtype=dtype)
    tets = tets.copy()
    tets[::3] = tets[::3][:, [1, 0, 2, 3]]  # of both orientations
    grid = gm.make_grid(points, tets, wide)
    rng = np.random.default_rng(7)
    wave = wave_of(points).astype(wave_type)
    on_points, on_cells = grid.GetPointData(), grid.GetCellData()
    gm.add_array(on_points, wave, "wave")
    gm.add_array(on_points, rng.random((len(points), 3)) - 0.5, "vector")
    gm.add_array(on_points, np.round(20 * wave_of(points)).astype(np.int16), "steps")
    gm.add_array(on_points, rng.integers(0, 255, len(points)).astype(np.uint8), "byte")
    gm.add_array(on_points, rng.integers(-9, 9, (len(points), 2)), "pair")
    gm.add_array(on_points, np.arange(len(points)), "ids", c.VTK_ID_TYPE)
    gm.add_array(on_points, np.where(wave > 0.7, np.nan, wave).astype(np.float32), "holes")
    gm.add_array(on_cells, np.arange(len(tets)), "cell")
    gm.add_array(on_cells, rng.random((len(tets), 3)).astype(np.float32), "cell vector")
    on_points.SetActiveScalars("wave")
    return grid


def quantiles(grid, array, component, parts):
    values = vtk_to_numpy(grid.GetPointData().GetArray(array)).astype(np.float64)
    if values.ndim > 1:
        values = np.sqrt((values ** 2).sum(1)) if component < 0 else values[:, component]
    return [float(v) for v in np.quantile(values, parts)]


# Against vtkContourGrid, for each number type of points, values and ids, from memory and from files.
compared = 0
for dtype, wide, wave_type in ((np.float32, True, np.float32), (np.float32, False, np.float64),
                               (np.float64, True, np.float64), (np.float64, False, np.float32)):
    grid = make_box(7, dtype, wide, wave_type)
    sources = [(grid, grid)]
    for kind, options in gc.kinds_of_files("wave").items():
        path = gm.temporary("contour-%s.gtn" % kind)
        gm.write(grid, path, ChunkSize=200, **options)
        sources.append((gc.open_file(path), gm.read(path)))
    for array, component in (("wave", -1), ("wave", 0), ("vector", -1), ("vector", 0), ("vector", 2),
                             ("steps", -1), ("byte", 0), ("pair", -1), ("pair", 1)):
        values = quantiles(grid, array, component, np.linspace(0, 1, 8))
        values[2] += 1e-9
        lists = [[v] for v in values] + [values[1:4], values[::-1], [values[0] - 1, values[-1] + 1]]
        for isovalues in lists if array == "wave" else lists[2:9]:
            for source, whole in sources:
                output = gc.contour_of(source, isovalues, array, ArrayComponent=component)
                expected = gc.reference(whole, isovalues, array, component)
                # Of points of type double that are met exactly, vtkContourGrid's may be beside them:
                # two of one, with values of two edges, which differ if one begins at a NaN.
                vertices = ()
                if dtype == np.float64:
                    scalars = vtk_to_numpy(whole.GetPointData().GetArray(array)).astype(np.float64)
                    if scalars.ndim > 1:
                        scalars = np.sqrt((scalars * scalars).sum(1)) if component < 0 \
                            else scalars[:, component]
                    vertices = gm.coordinates(whole)[np.isin(scalars, isovalues)]
                skip = ("holes",) if len(vertices) else ()
                compared += gc.assert_same(output, expected, skip, vertices=vertices)
                if output.GetNumberOfPoints():
                    gc.assert_whole(output)
                    assert output.GetPointData().GetScalars().GetName() == array
                    assert output.GetPoints().GetDataType() == whole.GetPoints().GetDataType()
assert compared > 10 ** 5, compared

# The scalars: by name, the active ones, and those of another name than the active ones.
grid = make_box()
path = gm.temporary("contour.gtn")
gm.write(grid, path, ChunkSize=300)
file = gc.open_file(path)
whole = gm.read(path)
for source in (grid, file):
    by_role = gc.contour_of(source, 0.4)
    gc.assert_identical(by_role, gc.contour_of(source, 0.4, "wave"))
    assert by_role.GetPointData().GetScalars().GetName() == "wave"
    other = gc.contour_of(source, 5.5, "steps")
    assert other.GetPointData().GetScalars().GetName() == "steps"
    assert other.GetPointData().HasArray("wave")
    either = vtkGatunContour()
    gc.connect(either, source)
    either.SetValue(0, 0.4)
    either.SetInputArrayToProcess(0, 0, 0, 3, "wave")  # points, then cells
    either.Update()
    gc.assert_identical(either.GetOutput(), by_role)

# Without the scalars; all else stays.
for source, mesh in ((grid, grid), (file, whole)):
    for array, component in (("wave", -1), ("vector", 1)):
        output = gc.contour_of(source, 0.1, array, ArrayComponent=component, ComputeScalars=False)
        assert output.GetPointData().GetScalars() is None
        assert not output.GetPointData().HasArray(array)
        expected = gc.reference(mesh, 0.1, array, component)
        expected.GetPointData().RemoveArray(array)
        assert gc.assert_same(output, expected) > 300

# Roles are kept, ids are not carried.
ids = make_box(5)
for attributes in (ids.GetPointData(), ids.GetCellData()):
    count = ids.GetNumberOfPoints() if attributes is ids.GetPointData() else ids.GetNumberOfCells()
    for name in ("global", "pedigree"):
        gm.add_array(attributes, np.arange(count, dtype=np.int32), name)
    attributes.SetActiveGlobalIds("global")
    attributes.SetPedigreeIds(attributes.GetArray("pedigree"))
ids.GetPointData().SetActiveVectors("vector")
ids.GetCellData().SetActiveVectors("cell vector")
texts = vtkStringArray()
texts.SetName("texts")
texts.SetNumberOfValues(ids.GetNumberOfPoints())
id_path = gm.temporary("contour-ids.gtn")
gm.write(ids, id_path, ChunkSize=300)
ids.GetPointData().AddArray(texts)
for source in (ids, gc.open_file(id_path)):
    mesh = ids if source is ids else gm.read(id_path)
    output = gc.contour_of(source, 0.3, "wave")
    for name in ("global", "pedigree", "ids", "texts"):
        assert not output.GetPointData().HasArray(name), name
    assert not output.GetCellData().HasArray("global") and output.GetCellData().HasArray("pedigree")
    assert output.GetPointData().GetVectors().GetName() == "vector"
    assert output.GetCellData().GetVectors().GetName() == "cell vector"
    assert gc.assert_same(output, gc.reference(mesh, 0.3, "wave"), skip=("texts",)) > 100

# Every number type, interpolated and rounded as VTK does it, from memory and from a file. Far from
# what a double can tell apart, as vtkMath rounds there by adding a half.
TYPES = {c.VTK_CHAR: np.int8, c.VTK_SIGNED_CHAR: np.int8, c.VTK_UNSIGNED_CHAR: np.uint8,
         c.VTK_SHORT: np.int16, c.VTK_UNSIGNED_SHORT: np.uint16, c.VTK_INT: np.int32,
         c.VTK_UNSIGNED_INT: np.uint32, c.VTK_LONG: np.int64, c.VTK_UNSIGNED_LONG: np.uint64,
         c.VTK_LONG_LONG: np.int64, c.VTK_UNSIGNED_LONG_LONG: np.uint64, c.VTK_FLOAT: np.float32,
         c.VTK_DOUBLE: np.float64}
points, tets = gm.lattice(5, seed=8)
typed = gm.make_grid(points, tets)
rng = np.random.default_rng(9)
for kind, dtype in TYPES.items():
    if np.issubdtype(dtype, np.integer):
        limits = np.iinfo(dtype)
        numbers = rng.integers(max(limits.min, -2 ** 50), min(limits.max, 2 ** 50), (len(points), 2))
        numbers[::7] = np.minimum(np.abs(numbers[::7]), 3)
        numbers = numbers.astype(dtype)
    else:
        numbers = (rng.random((len(points), 2)) * 10.0 ** rng.integers(-30, 30, (len(points), 1)))
        numbers = numbers.astype(dtype)
    gm.add_array(typed.GetPointData(), numbers, "type %d" % kind, kind, components=["a", "b"])
    gm.add_array(typed.GetCellData(), np.resize(numbers, (len(tets), 3)), "cell %d" % kind, kind)
    gm.add_array(typed.GetPointData(), np.resize(np.arange(100, dtype=dtype), len(points)),
                 "scalars %d" % kind, kind)
type_path = gm.temporary("contour-types.gtn")
gm.write(typed, type_path, ChunkSize=100)
type_file, type_mesh = gc.open_file(type_path), gm.read(type_path)
for kind in TYPES:
    for isovalue in (10.5, 60):
        name = "scalars %d" % kind
        expected = gc.reference(typed, isovalue, name)
        assert gc.assert_same(gc.contour_of(typed, isovalue, name), expected) > 300
        expected = gc.reference(type_mesh, isovalue, name)
        assert gc.assert_same(gc.contour_of(type_file, isovalue, name), expected) > 300

# One surface, whatever the number of threads; also of a mesh of several parts in memory.
large = make_box(24)
expected = {}
backend = vtkSMPTools.GetBackend()
assert vtkSMPTools.SetBackend("STDThread")
for threads in (1, 2, 3, 8):
    vtkSMPTools.Initialize(threads)
    assert vtkSMPTools.GetEstimatedNumberOfThreads() == min(threads, os.cpu_count())
    for key, source in (("grid", large), ("file", gc.open_file(path, MemoryBudget=0))):
        output = gc.contour_of(source, [0.1, 0.4], "wave", ComputeNormals=True)
        gc.assert_whole(output)
        gc.assert_identical(output, expected.setdefault(key, output))
vtkSMPTools.Initialize(0)
vtkSMPTools.SetBackend(backend)
assert expected["grid"].GetNumberOfCells() > 5000
output = gc.contour_of(large, [0.1, 0.4], "wave")
gc.assert_same(output, gc.reference(large, [0.1, 0.4], "wave"))

# The order and the repetition of isovalues do not matter.
for source in (grid, file):
    ordered = gc.contour_of(source, [0.25, 0.5, 0.75], "wave")
    gc.assert_identical(gc.contour_of(source, [0.75, 0.25, 0.5, 0.25, 0.75], "wave"), ordered)
    generated = vtkGatunContour()
    gc.connect(generated, source)
    generated.GenerateValues(3, 0.25, 0.75)
    generated.Update()
    assert [generated.GetValue(i) for i in range(generated.GetNumberOfContours())] == \
        [0.25, 0.5, 0.75]
    gc.assert_identical(generated.GetOutput(), ordered)
    parts = sum(gc.contour_of(source, v, "wave").GetNumberOfCells() for v in (0.25, 0.5, 0.75))
    assert parts == ordered.GetNumberOfCells()

# The precision of points.
doubles = make_box(dtype=np.float64)
double_path = gm.temporary("contour-double.gtn")
gm.write(doubles, double_path, ChunkSize=300)
for mesh, one_path in ((grid, path), (doubles, double_path)):
    for source, decoded in ((mesh, mesh), (gc.open_file(one_path), gm.read(one_path))):
        for precision, kind in ((0, c.VTK_FLOAT), (1, c.VTK_DOUBLE)):
            output = gc.contour_of(source, 0.4, "wave", OutputPointsPrecision=precision)
            assert output.GetPoints().GetDataType() == kind
            expected = gc.reference(decoded, 0.4, "wave", OutputPointsPrecision=precision)
            assert gc.assert_same(output, expected) > 300

# Normals: of length one, towards lower values, in the file as in memory; points stay as they are.
# Fronts look the same way, whatever the orientation of the tetrahedra: here there are both.
assert 0.1 < gc.left_handed(grid).mean() < 0.9
for array, component in (("wave", -1), ("vector", 0)):
    outputs = []
    for source in (whole, file):
        plain = gc.contour_of(source, 0.2, array, ArrayComponent=component)
        output = gc.contour_of(source, 0.2, array, ArrayComponent=component, ComputeNormals=True)
        array_of_normals = output.GetPointData().GetNormals()
        assert array_of_normals.GetName() == "Normals"
        assert array_of_normals.GetDataType() == c.VTK_FLOAT
        normals = vtk_to_numpy(array_of_normals)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
        output.GetPointData().RemoveArray("Normals")
        gc.assert_identical(output, plain)
        corners = gc.points_of(output).astype(float)[gc.triangles_of(output)]
        front = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        agree = (front * normals[gc.triangles_of(output)].mean(1)).sum(1)
        if array == "wave":  # the other is noise
            assert (agree > 0).mean() > 0.99
        outputs.append((gc.points_of(output), normals))
    orders = [np.lexsort(points.T) for points, _ in outputs]
    np.testing.assert_array_equal(outputs[0][0][orders[0]], outputs[1][0][orders[1]])
    np.testing.assert_allclose(outputs[0][1][orders[0]], outputs[1][1][orders[1]], atol=1e-6)
points = gc.points_of(gc.contour_of(grid, 0.2, "wave")).astype(float)
true = -np.stack([5 * np.cos(5 * points[:, 0]) * np.cos(4 * points[:, 1]),
                  -4 * np.sin(5 * points[:, 0]) * np.sin(4 * points[:, 1]), 2 * points[:, 2]], 1)
steep = np.linalg.norm(true, axis=1) > 1
true /= np.linalg.norm(true, axis=1)[:, None]
normals = vtk_to_numpy(gc.contour_of(grid, 0.2, "wave", ComputeNormals=True).GetPointData().GetNormals())
assert np.median((true * normals).sum(1)[steep]) > 0.98

# Strips: the same triangles, without the arrays of the cells.
for source in (grid, file):
    plain = gc.contour_of(source, [0.1, 0.4], "wave", ComputeNormals=True)
    output = gc.contour_of(source, [0.1, 0.4], "wave", ComputeNormals=True, OutputStrips=True)
    assert output.GetNumberOfPolys() == 0
    assert 0 < output.GetNumberOfStrips() < plain.GetNumberOfPolys() / 2
    assert output.GetCellData().GetNumberOfArrays() == 0
    plain_cells = plain.GetCellData()
    while plain_cells.GetNumberOfArrays():
        plain_cells.RemoveArray(0)
    gm.assert_same_arrays(output.GetPointData(), plain.GetPointData())
    gc.assert_same(output, plain)

output = gc.contour_of(grid, 0.4, "wave", OutputStrips=True)
assert output.GetNumberOfStrips() and output.GetCellData().GetNumberOfArrays() == 0

# Nothing runs again when nothing has changed.
contour = gc.make_contour(grid, 0.4, "wave")
runs = []
contour.AddObserver("StartEvent", lambda *_: runs.append(1))
contour.Update()
contour.Update()
assert len(runs) == 1
for change in (lambda: contour.SetValue(0, 0.5), lambda: contour.SetValue(1, 0.6),
               lambda: contour.SetNumberOfContours(1), lambda: contour.SetArrayComponent(0),
               lambda: contour.ComputeNormalsOn(), lambda: contour.ComputeScalarsOff(),
               lambda: contour.OutputStripsOn(), lambda: contour.SetOutputPointsPrecision(1),
               lambda: contour.GenerateValues(2, 0.1, 0.2), lambda: grid.Modified()):
    before = len(runs)
    change()
    contour.Update()
    assert len(runs) == before + 1
    contour.SetNumberOfContours(contour.GetNumberOfContours())
    contour.SetValue(0, contour.GetValue(0))
    contour.Update()
    assert len(runs) == before + 1

# Defaults, limits, and what it says of itself.
contour = vtkGatunContour()
assert contour.GetNumberOfContours() == 0 and contour.GetArrayComponent() == -1
assert not contour.GetComputeNormals() and contour.GetComputeScalars()
assert not contour.GetOutputStrips()
assert contour.GetOutputPointsPrecision() == vtkGatunContour.DEFAULT_PRECISION
contour.SetArrayComponent(-5)
assert contour.GetArrayComponent() == -1
contour.SetOutputPointsPrecision(7)
assert contour.GetOutputPointsPrecision() == vtkGatunContour.DEFAULT_PRECISION
for name in "Chunks", "UsedChunks", "UsedTetrahedra", "BytesRead":
    assert gm.statistic(contour, name) == 0, name
contour.SetValue(2, 7.25)
text = str(contour)
for name in ("Values:", "7.25", "ArrayComponent: -1", "ComputeNormals: Off", "ComputeScalars: On",
             "OutputStrips: Off", "OutputPointsPrecision: 2"):
    assert name in text, name
assert contour.IsA("vtkPolyDataAlgorithm")
