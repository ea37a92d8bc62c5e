# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces of vtkGatunContour and of vtkContourGrid, made and compared."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkContourGrid

import gatunMeshes as gm
from gatun.vtk import vtkGatunContour, vtkGatunReader


def kinds_of_files(array):
    """How files may be organised: settings of the writer. What is asked of one is asked of all."""
    return {"spatial": {}, "layers": {"Layers": (array, -1, 6)}}


# The array that is made of a component or the length of another, for vtkContourGrid, and the one that
# tells whose volume is negative.
COMPUTED = "computed scalars"
LEFT_HANDED = "left-handed"


def connect(algorithm, source):
    if source.IsA("vtkDataObject"):
        algorithm.SetInputDataObject(source)
    else:
        algorithm.SetInputConnection(source.GetOutputPort())


def make_contour(source, values, array=None, **options):
    """A vtkGatunContour of a data object or an algorithm, not updated."""
    contour = vtkGatunContour()
    connect(contour, source)
    for i, value in enumerate(np.atleast_1d(values)):
        contour.SetValue(i, value)
    if array is not None:
        contour.SetInputArrayToProcess(0, 0, 0, 0, array)
    for name, value in options.items():
        getattr(contour, "Set" + name)(value)
    return contour


def contour_of(source, values, array=None, **options):
    contour = make_contour(source, values, array, **options)
    contour.Update()
    assert contour.GetErrorCode() == 0
    return contour.GetOutput()


def open_file(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


def left_handed(grid):
    """Whether the volume of each tetrahedron is negative."""
    corners = gm.coordinates(grid).astype(float)[gm.connectivity(grid)]
    a, b, c = (corners[:, i] - corners[:, 0] for i in (1, 2, 3))
    return (a * np.cross(b, c)).sum(1) < 0


def turn_left_handed(output):
    """Turns over the triangles of left-handed tetrahedra, whose fronts face higher values."""
    turn = output.GetCellData().GetArray(LEFT_HANDED)
    if turn and turn.GetNumberOfTuples():
        triangles = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        turn = vtk_to_numpy(turn) != 0
        triangles[turn] = triangles[turn][:, [0, 2, 1]]
    output.GetCellData().RemoveArray(LEFT_HANDED)


def reference(grid, values, array, component=-1, **options):
    """The same of vtkContourGrid, with all fronts towards lower values; a component or the length by
    an array that is added."""
    whole = vtkUnstructuredGrid()
    whole.ShallowCopy(grid)
    gm.add_array(whole.GetCellData(), left_handed(grid).astype(np.uint8), LEFT_HANDED)
    scalars = grid.GetPointData().GetArray(array)
    if scalars.GetNumberOfComponents() > 1:
        tuples = vtk_to_numpy(scalars).astype(np.float64)
        # The squares are summed up from the first to the last, as one writes it down.
        sums = np.zeros(len(tuples))
        for i in range(tuples.shape[1]):
            sums += tuples[:, i] * tuples[:, i]
        made = np.sqrt(sums) if component < 0 else tuples[:, component]
        gm.add_array(whole.GetPointData(), made, COMPUTED)
        array = COMPUTED
    contour = vtkContourGrid()
    contour.SetInputDataObject(whole)
    contour.SetInputArrayToProcess(0, 0, 0, 0, array)
    for i, value in enumerate(np.atleast_1d(values)):
        contour.SetValue(i, value)
    for name, value in options.items():
        getattr(contour, "Set" + name)(value)
    contour.Update()
    output = contour.GetOutput()
    output.GetPointData().RemoveArray(COMPUTED)
    turn_left_handed(output)
    return output


def points_of(output):
    if output.GetNumberOfPoints() == 0:
        return np.zeros((0, 3), np.float32)
    return vtk_to_numpy(output.GetPoints().GetData())


def triangles_of(output):
    """Point ids of the triangles, those of strips with their fronts where they belong."""
    if output.GetNumberOfStrips():
        strips = output.GetStrips()
        offsets = vtk_to_numpy(strips.GetOffsetsArray())
        ids = vtk_to_numpy(strips.GetConnectivityArray())
        triangles = []
        for begin, end in zip(offsets[:-1], offsets[1:]):
            for i in range(begin, end - 2):
                a, b, c = ids[i:i + 3]
                triangles.append((a, b, c) if (i - begin) % 2 == 0 else (b, a, c))
        return np.array(triangles)
    polys = output.GetPolys()
    if output.GetNumberOfPolys() == 0:
        return np.zeros((0, 3), np.int64)
    assert (np.diff(vtk_to_numpy(polys.GetOffsetsArray())) == 3).all()
    return vtk_to_numpy(polys.GetConnectivityArray()).reshape(-1, 3)


def arrays_by_name(attributes, skip):
    arrays = [a for a in gm.arrays_of(attributes) if a.GetName() not in skip]
    return sorted(arrays, key=lambda a: a.GetName())


def turned(triangles):
    """Each beginning with its smallest id."""
    first = triangles.argmin(1)
    return np.take_along_axis(triangles, (first[:, None] + np.arange(3)) % 3, 1)


def snap(output, vertices):
    """Points and triangles, with points that are almost one of these vertices moved there, and
    without the triangles that lose a corner. vtkContourGrid computes the end of an edge as its begin
    and the way to the end, which need not arrive there to the last bit."""
    points, triangles = points_of(output).copy(), triangles_of(output)
    for vertex in vertices:
        points[(np.abs(points - vertex) <= 4 * np.spacing(np.abs(vertex) + 1)).all(1)] = vertex
    return points, triangles


def canonical(output, skip=(), cells=True, vertices=(), fronts=True):
    """Triangles with all they have as sorted rows of bytes, whatever their order, that of the points
    and the corner that they begin with; and the description of the arrays."""
    points, triangles = snap(output, vertices)
    point_arrays = arrays_by_name(output.GetPointData(), skip)
    cell_arrays = arrays_by_name(output.GetCellData(), skip) if cells else []
    kinds = [gm.description(a) for a in point_arrays], [gm.description(a) for a in cell_arrays]
    rows = gm.rows(points + points.dtype.type(0), *[gm.values_of(a) for a in point_arrays])
    kept = np.ones(len(triangles), bool)
    if len(vertices) and len(triangles):
        corners = points[triangles]
        kept = ~np.any([(corners[:, i] == corners[:, i - 1]).all(1) for i in range(3)], 0)
    used = np.unique(triangles[kept])
    rows, ids = np.unique(rows[used], axis=0, return_inverse=True)
    place = np.zeros(output.GetNumberOfPoints(), np.int64)
    place[used] = np.asarray(ids).reshape(-1)
    if len(triangles):
        faces = turned(place[triangles[kept]]) if fronts else np.sort(place[triangles[kept]], 1)
    else:
        faces = triangles
    faces = gm.rows(faces, *[gm.values_of(a)[kept] for a in cell_arrays])
    return kinds, rows, faces[np.lexsort(faces.T[::-1])] if len(faces) else faces


def assert_same(output, expected, skip=(), cells=True, vertices=(), fronts=True):
    """The same triangles with the same fronts, if these count, places and arrays, to the last bit."""
    one = canonical(output, skip, cells, vertices, fronts)
    other = canonical(expected, skip, cells, vertices, fronts)
    if not len(other[2]):
        assert not len(one[2]), len(one[2])
        return 0
    assert one[0] == other[0], (one[0], other[0])
    for a, b in zip(one[1:], other[1:]):
        assert a.shape == b.shape, (a.shape, b.shape)
        np.testing.assert_array_equal(a, b)
    return len(other[2])


def polygons(output):
    """The sides around the section of each cell, whatever its diagonal; places to the last bit."""
    places, triangles = points_of(output), triangles_of(output)
    cells = vtk_to_numpy(output.GetCellData().GetArray("cell")).astype(np.int64)
    _, ids = np.unique(places, axis=0, return_inverse=True)
    triangles = np.asarray(ids).reshape(-1)[triangles]
    sides = set()
    for i in range(3):
        sides.update(zip(cells, triangles[:, i], triangles[:, (i + 1) % 3]))
    return sorted((c, a, b) for c, a, b in sides if (c, b, a) not in sides), np.unique(places, axis=0)


def assert_whole(output):
    """What every surface has: points at different places, each used; no triangle without a side."""
    points, triangles = points_of(output), triangles_of(output)
    assert len(np.unique(points + 0, axis=0)) == len(points)
    np.testing.assert_array_equal(np.unique(triangles), np.arange(len(points)))
    assert (triangles != np.roll(triangles, 1, axis=1)).all()
    for array in gm.arrays_of(output.GetPointData()):
        assert array.GetNumberOfTuples() == len(points)
    for array in gm.arrays_of(output.GetCellData()):
        assert array.GetNumberOfTuples() == len(triangles)


def assert_identical(one, other):
    """The same in the same order."""
    np.testing.assert_array_equal(points_of(one), points_of(other))
    np.testing.assert_array_equal(triangles_of(one), triangles_of(other))
    gm.assert_same_arrays(one.GetPointData(), other.GetPointData())
    gm.assert_same_arrays(one.GetCellData(), other.GetCellData())
