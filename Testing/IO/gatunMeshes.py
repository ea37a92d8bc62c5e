# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes, and ways to compare them that are not ours: numpy on what VTK hands out."""

import functools
import os
import subprocess
import sys

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_BIT, VTK_STRING, VTK_TETRA, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonCore import (
    vtkAbstractArray, vtkIdList, vtkPoints, vtkStringArray, vtkTypeInt32Array, vtkTypeInt64Array)
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON, vtkCellArray, vtkDataSetAttributes, vtkUnstructuredGrid)

from gatun.vtk import vtkGatunReader, vtkGatunWriter

SKIPPED = 125


def temporary(name):
    """A path to write to, where nothing is yet, in a folder of the test: others run at the same time."""
    folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ.get("GATUN_TEST_NAME", ""))
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name)
    if os.path.lexists(path) and not os.path.isdir(path):
        os.remove(path)
    return path


@functools.cache
def vtk_aborts():
    """Whether an array of VTK that cannot grow ends the process, as it does in a VTK with assertions. In others
    it throws std::bad_alloc, which nothing catches in Python."""
    code = """from vtkmodules.vtkCommonCore import vtkDoubleArray
array = vtkDoubleArray()
array.SetNumberOfTuples(1)
array.Resize(1 << 48)"""
    run = subprocess.run([sys.executable, "-c", code], stderr=subprocess.PIPE, check=False)
    return b"bad_alloc" not in run.stderr


def data_folder():
    """The folder of large meshes; skips the test if there is none."""
    folder = os.environ.get("GATUN_DATA_DIR")
    if not folder:
        print("GATUN_DATA_DIR is not set")
        sys.exit(SKIPPED)
    return folder


# --------------------------------------------------------------------------------------------------
# Making


def make_grid(points, tets, wide=True):
    """A grid of tetrahedra; connectivity with 64-bit ids if wide, else 32."""
    grid = vtkUnstructuredGrid()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points).reshape(-1, 3), deep=True))
    grid.SetPoints(coordinates)
    kind, array = (np.int64, vtkTypeInt64Array) if wide else (np.int32, vtkTypeInt32Array)
    tets = np.asarray(tets, kind).reshape(-1, 4)
    connectivity, offsets = array(), array()
    connectivity.SetNumberOfValues(tets.size)
    offsets.SetNumberOfValues(len(tets) + 1)
    if tets.size:
        vtk_to_numpy(connectivity)[:] = tets.ravel()
    vtk_to_numpy(offsets)[:] = 4 * np.arange(len(tets) + 1)
    cells = vtkCellArray()
    cells.SetData(offsets, connectivity)
    assert cells.GetNumberOfCells() == len(tets)
    if len(tets):
        grid.SetCells(VTK_TETRA, cells)
    else:
        grid.Allocate(1)  # cells of any types can be added; after SetCells, VTK 9.6 would take them for tetrahedra
    return grid


def lattice(n, seed=1, dtype=np.float32, permute=True):
    """Points and tetrahedra of n^3 jittered cubes of the unit cube, six each, in random order."""
    rng = np.random.default_rng(seed)
    axis = np.arange(n + 1)
    x, y, z = np.meshgrid(axis, axis, axis, indexing="ij")
    points = np.stack([x, y, z], -1).reshape(-1, 3).astype(np.float64)
    inner = ((points > 0) & (points < n)).all(1)
    points[inner] += rng.uniform(-0.2, 0.2, (inner.sum(), 3))
    corner = lambda i, j, k: ((x + i) * (n + 1) + (y + j)) * (n + 1) + (z + k)
    box = [corner(i, j, k)[:n, :n, :n].ravel() for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    paths = [(1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)]
    tets = np.concatenate([np.stack([box[0], box[a], box[b], box[7]], 1) for a, b in paths])
    if permute:
        order = rng.permutation(len(points))
        place = np.empty_like(order)
        place[order] = np.arange(len(order))
        points, tets = points[order], place[tets]
        tets = tets[rng.permutation(len(tets))]
        # Even permutations of the corners.
        turns = np.array([[0, 1, 2, 3], [1, 2, 0, 3], [1, 0, 3, 2], [3, 2, 1, 0]])
        tets = np.take_along_axis(tets, turns[rng.integers(0, 4, len(tets))], 1)
    return (points / n).astype(dtype), tets


def add_array(attributes, values, name, vtk_type=None, components=None):
    """Adds values (tuples, components) as an array of a VTK type and returns it."""
    values = np.ascontiguousarray(values)
    if vtk_type is None:
        array = numpy_to_vtk(values, deep=True)
    else:
        array = vtkAbstractArray.CreateArray(vtk_type)
        array.SetNumberOfComponents(1 if values.ndim == 1 else values.shape[1])
        array.SetNumberOfTuples(len(values))
        if vtk_type == VTK_BIT:
            for i, value in enumerate(values.ravel()):
                array.SetValue(i, int(value))
        elif values.size:
            raw = vtk_to_numpy(array)
            raw.reshape(-1)[:] = values.ravel().view(raw.dtype)
    array.SetName(name)
    for i, text in enumerate(components or []):
        array.SetComponentName(i, text)
    attributes.AddArray(array)
    return array


def block(rng=None, n=4, dtype=np.float32):
    """A small grid with a few usual arrays: ids of points and cells, a field, a vector."""
    points, tets = lattice(n, dtype=dtype)
    grid = make_grid(points, tets)
    add_array(grid.GetPointData(), np.arange(len(points), dtype=np.int32), "point")
    add_array(grid.GetPointData(), np.sin(3 * points).sum(1).astype(np.float32), "wave")
    add_array(grid.GetPointData(), (points[:, ::-1] ** 2).astype(np.float64), "vector")
    add_array(grid.GetCellData(), np.arange(len(tets), dtype=np.int64), "cell")
    return grid


# --------------------------------------------------------------------------------------------------
# Writing and reading


class Errors:
    """Collects error messages of an algorithm and its executive, which then are not printed."""

    def __init__(self, algorithm):
        self.messages = []

        @calldata_type(VTK_STRING)
        def note(_object, _event, text):
            self.messages.append(text)

        algorithm.AddObserver("ErrorEvent", note)
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)

    def __str__(self):
        return "\n".join(self.messages)


def set_options(algorithm, **options):
    """Sets properties of an algorithm, or of its detail policy or encoding where they are there."""
    owners = [algorithm]
    owners += [getattr(algorithm, get)() for get in ("GetDetailPolicy", "GetEncoding")
               if hasattr(algorithm, get)]
    for name, value in options.items():
        owner = next(owner for owner in owners if hasattr(owner, "Set" + name))
        getattr(owner, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))


KINDS = {"abs": 1, "rel": 2, "pw": 3, "bits": 4}


def set_tolerance(writer, text):
    """Sets the tolerance of an array, "NAME=KIND:E" or "NAME=KIND:E,zeros"."""
    name, bound = text.rsplit("=", 1)
    bound, comma, _ = bound.partition(",")
    kind, value = bound.split(":")
    writer.SetArrayTolerance(name, KINDS[kind], float(value), bool(comma))


def statistic(algorithm, name):
    """A number of GetStatistics."""
    return algorithm.GetStatistics().GetColumnByName(name).GetValue(0)


def write(grid, path, **options):
    """Writes by vtkGatunWriter with these options; must succeed. Returns the writer."""
    writer = vtkGatunWriter()
    writer.SetInputDataObject(grid)
    writer.SetFileName(path)
    set_options(writer, **options)
    assert writer.Write() == 1, path
    assert writer.GetErrorCode() == 0
    assert statistic(writer, "FileBytes") == os.path.getsize(path)
    return writer


def read(path, **options):
    """Reads by vtkGatunReader with these options."""
    reader = vtkGatunReader()
    reader.SetFileName(path)
    set_options(reader, **options)
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def round_trip(grid, name, **options):
    path = temporary(name)
    write(grid, path, **options)
    return read(path)


# --------------------------------------------------------------------------------------------------
# Comparing


def connectivity(grid):
    cells = grid.GetCells()
    if not cells or not cells.GetNumberOfCells():
        return np.zeros((0, 4), np.int64)
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    assert (offsets == 4 * np.arange(len(offsets))).all()
    assert (cell_types(grid) == VTK_TETRA).all()
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 4)


def coordinates(grid):
    if not grid.GetNumberOfPoints():
        return np.zeros((0, 3), np.float32)
    return vtk_to_numpy(grid.GetPoints().GetData())


def values_of(array):
    """The values as (tuples, components), of an unsigned type, so that NaN equals itself."""
    tuples, components = array.GetNumberOfTuples(), array.GetNumberOfComponents()
    if array.GetDataType() == VTK_BIT:
        flat = [array.GetValue(i) for i in range(tuples * components)]
        return np.array(flat, np.uint8).reshape(tuples, components)
    if tuples == 0:
        return np.zeros((0, components), np.uint8)
    values = vtk_to_numpy(array)
    return values.reshape(tuples, components).view("u%d" % values.dtype.itemsize)


def description(array):
    names = [array.GetComponentName(i) or "" for i in range(array.GetNumberOfComponents())]
    return array.GetName(), array.GetDataType(), array.GetNumberOfComponents(), names


def arrays_of(attributes):
    return [attributes.GetAbstractArray(i) for i in range(attributes.GetNumberOfArrays())]


def roles_of(attributes):
    roles = []
    for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES):
        array = attributes.GetAbstractAttribute(kind)
        roles.append(array.GetName() if array else None)
    return roles


def assert_same_arrays(one, other):
    assert list(map(description, arrays_of(one))) == list(map(description, arrays_of(other)))
    for a, b in zip(arrays_of(one), arrays_of(other)):
        assert np.array_equal(values_of(a), values_of(b)), a.GetName()
    assert roles_of(one) == roles_of(other)


def assert_same_field(one, other):
    assert list(map(description, arrays_of(one))) == list(map(description, arrays_of(other)))
    for a, b in zip(arrays_of(one), arrays_of(other)):
        assert a.GetNumberOfTuples() == b.GetNumberOfTuples()
        if isinstance(a, vtkStringArray):
            texts = [[x.GetValue(i) for i in range(x.GetNumberOfValues())] for x in (a, b)]
            assert texts[0] == texts[1], a.GetName()
        else:
            assert np.array_equal(values_of(a), values_of(b)), a.GetName()


def cell_types(grid):
    """The types of cells, which VTK 9.6 may keep in a vtkConstantArray."""
    new = hasattr(grid, "GetDistinctCellTypes")
    return vtk_to_numpy(grid.GetCellTypes() if new else grid.GetCellTypesArray())


def set_cell_type(grid, cell, kind):
    types = cell_types(grid).copy()
    types[cell] = kind
    grid.SetCells(numpy_to_vtk(types, deep=True, array_type=VTK_UNSIGNED_CHAR), grid.GetCells())


def has_wide_ids(cells):
    """Whether these are 64-bit ids, whatever the storage."""
    return cells.GetConnectivityArray().GetDataTypeSize() == 8


def assert_same_types(one, other):
    """Number types of points and ids."""
    if one.GetNumberOfPoints():
        assert one.GetPoints().GetDataType() == other.GetPoints().GetDataType()
    if one.GetNumberOfCells():
        assert has_wide_ids(one.GetCells()) == has_wide_ids(other.GetCells())


def faces_of(grid, cell):
    """The list of faces of a polyhedron: the number of faces, and for each its points."""
    if grid.GetCellType(cell) != VTK_POLYHEDRON:
        return []
    stream = vtkIdList()
    grid.GetFaceStream(cell, stream)
    return [stream.GetId(i) for i in range(stream.GetNumberOfIds())]


def assert_same_cells(one, other):
    """The same cells of any type, in the same order."""
    if not one.GetNumberOfCells():
        return
    types = cell_types(one)
    assert np.array_equal(types, cell_types(other))
    for part in ("OffsetsArray", "ConnectivityArray"):
        a, b = (vtk_to_numpy(getattr(grid.GetCells(), "Get" + part)()) for grid in (one, other))
        assert np.array_equal(a, b), part
    for cell in np.flatnonzero(types == VTK_POLYHEDRON):
        assert faces_of(one, cell) == faces_of(other, cell), cell


def assert_equal(one, other):
    """Everything in the same order, bit for bit."""
    assert one.GetNumberOfPoints() == other.GetNumberOfPoints()
    assert one.GetNumberOfCells() == other.GetNumberOfCells()
    assert_same_types(one, other)
    a, b = coordinates(one), coordinates(other)
    assert np.array_equal(a.view("u%d" % a.dtype.itemsize), b.view("u%d" % b.dtype.itemsize))
    assert_same_cells(one, other)
    assert_same_arrays(one.GetPointData(), other.GetPointData())
    assert_same_arrays(one.GetCellData(), other.GetCellData())
    assert_same_field(one.GetFieldData(), other.GetFieldData())


def rows(*parts):
    """Joins arrays of equally many rows to one of bytes."""
    return np.concatenate(
        [np.ascontiguousarray(p).reshape(len(p), np.prod(p.shape[1:], dtype=int)).view(np.uint8)
         for p in parts], axis=1)


def turned(tets):
    """Corners as an even permutation that begins with the smallest id, and then the next smallest
    that an even permutation allows: the same for all tetrahedra that differ by one."""
    tets = np.array(tets)
    even = np.array([
        p for p in np.array(np.meshgrid(*[range(4)] * 4)).T.reshape(-1, 4)
        if len(set(p)) == 4 and np.linalg.det(np.eye(4)[p]) > 0])
    best = tets[:, even[0]]
    for p in even[1:]:
        other = tets[:, p]
        differ = other != best
        first = differ.argmax(1)
        at = np.arange(len(tets))
        less = differ.any(1) & (other[at, first] < best[at, first])
        best[less] = other[less]
    return best


def part_of(grid, wanted):
    """The cells of a grid that are wanted, with their points and arrays."""
    tets = connectivity(grid)[wanted]
    used = np.unique(tets)
    place = np.full(grid.GetNumberOfPoints(), -1)
    place[used] = np.arange(len(used))
    result = make_grid(coordinates(grid)[used], place[tets].reshape(-1, 4))
    for attributes, to, chosen in (
            (grid.GetPointData(), result.GetPointData(), used),
            (grid.GetCellData(), result.GetCellData(), np.flatnonzero(wanted))):
        for array in arrays_of(attributes):
            add_array(to, values_of(array)[chosen], array.GetName(), array.GetDataType())
    return result


def canonical(grid, skip=()):
    """Points and cells with their data as sorted rows of bytes, whatever the order and the turn of
    the corners. Points that are equal in all data are one to the cells."""
    points = rows(coordinates(grid), *[values_of(a) for a in arrays_of(grid.GetPointData())
                                       if a.GetName() not in skip])
    kinds, ids = np.unique(points, axis=0, return_inverse=True)
    ids = np.asarray(ids).reshape(-1)
    count = np.bincount(ids, minlength=len(kinds))
    tets = turned(ids[connectivity(grid)]) if grid.GetNumberOfCells() else np.zeros((0, 4), np.int64)
    cells = rows(tets, *[values_of(a) for a in arrays_of(grid.GetCellData())
                         if a.GetName() not in skip])
    cells = cells[np.lexsort(cells.T[::-1])] if len(cells) else cells
    return kinds, count, cells


def assert_same_mesh(one, other, skip=()):
    """The same but for the order of points, cells and (evenly) corners."""
    assert_same_types(one, other)
    for a, b in zip(canonical(one, skip), canonical(other, skip)):
        assert a.shape == b.shape and np.array_equal(a, b)
