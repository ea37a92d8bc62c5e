# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""However VTK stores types, cells, points and arrays, a grid is written and read back, handed to numpy,
contoured, simplified, merged and split as blocks, and drawn. A VTK without a storage leaves it out."""

import numpy as np
import vtkmodules.vtkCommonCore as core
import vtkmodules.vtkFiltersCore as filters
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import (
    VTK_HEXAHEDRON, VTK_TETRA, VTK_UNSIGNED_CHAR, VTK_WEDGE)
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON, vtkCellArray, vtkImageData, vtkPlane, vtkPolyData,
    vtkUnstructuredGrid)
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

import gatun
import gatunMeshes as gm
import gatunPolyData as pd
import gatunSurfaceScene
import gatunVolumes
from gatun.vtk import vtkGatunContour, vtkGatunSimplify
from gatunBlocks import collect, listed, merge, split
from gatunCells import polyhedron

POINTS, TETS = gm.lattice(5)
FIXED = hasattr(vtkCellArray, "IsStorageFixedSize")
GENERIC = hasattr(vtkCellArray, "IsStorageGeneric")
IMPLICIT = hasattr(core, "vtkConstantTypeFloat64Array")


def integers(values, name):
    """A VTK array of the class vtk<name>Array."""
    array = getattr(core, "vtk%sArray" % name)()
    array.SetNumberOfValues(np.size(values))
    for i, value in enumerate(np.ravel(values).tolist()):
        array.SetValue(i, value)
    return array


def add_arrays(data):
    gm.add_array(data.GetPointData(), gm.coordinates(data).sum(1).astype(np.float32), "heat")
    data.GetPointData().SetActiveScalars("heat")
    gm.add_array(data.GetCellData(), np.arange(data.GetNumberOfCells()) % 7, "material")
    return data


def grid_of(cells, kind, count=None):
    """kind: of all cells, or an array of types for count cells."""
    grid = gm.make_grid(POINTS, [])
    if count:
        kind = numpy_to_vtk(np.full(count, kind, np.uint8), True, VTK_UNSIGNED_CHAR)
    grid.SetCells(kind, cells)
    return add_arrays(grid)


def listed_cells(ids, name, offsets=None):
    ids = np.asarray(ids)
    cells = vtkCellArray()
    assert cells.SetData(integers(np.arange(len(ids) + 1) * ids.shape[1], offsets or name),
                         integers(ids, name)) is not False
    return cells


def fixed_cells(ids, name):
    cells = vtkCellArray()
    assert cells.SetData(np.shape(ids)[1], integers(ids, name)) and cells.IsStorageFixedSize()
    return cells


def boxes(n=5):
    """The points of cubes and of prisms of a lattice in order."""
    id_of = lambda i, j, k: (i * (n + 1) + j) * (n + 1) + k
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    return np.array([[id_of(i + a, j + b, k + c) for a, b, c in corners]
                     for i, j, k in np.ndindex(n, n, n)])


def in_order(make):
    """With the points of the lattice in order."""
    global POINTS
    before, POINTS = POINTS, gm.lattice(5, permute=False)[0]
    try:
        return make()
    finally:
        POINTS = before


def of_polyhedra():
    grid = gm.make_grid(POINTS, [])
    grid.Allocate(1)
    for ids in boxes()[::3]:
        polyhedron(grid, ids.tolist())
    return grid


def mixed():
    grid = of_polyhedra()
    for number, ids in enumerate(boxes()):
        if number % 3 == 1:
            grid.InsertNextCell(VTK_HEXAHEDRON, 8, ids.tolist())
        elif number % 3 == 2:
            grid.InsertNextCell(VTK_WEDGE, 6, ids[[0, 2, 1, 4, 6, 5]].tolist())
    return add_arrays(grid)


def fixed_faces():
    """All faces have four points and all polyhedra six faces."""
    grid = of_polyhedra()
    arrays = [vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size) for cells, size in (
        (grid.GetCells(), 8), (grid.GetPolyhedronFaceLocations(), 6), (grid.GetPolyhedronFaces(), 4))]
    cells, lists, faces = (fixed_cells(ids, "TypeInt64") for ids in arrays)
    types = numpy_to_vtk(np.full(len(arrays[0]), VTK_POLYHEDRON, np.uint8), True, VTK_UNSIGNED_CHAR)
    grid.SetPolyhedralCells(types, cells, lists, faces)
    return add_arrays(grid)


def with_implicit(kind):
    grid = grid_of(listed_cells(TETS, "TypeInt64"), VTK_TETRA, len(TETS))
    for where, count in (("PointData", len(POINTS)), ("CellData", len(TETS)), ("FieldData", 5)):
        array = getattr(core, "vtk%sTypeFloat64Array" % kind)()
        array.SetName("implicit")
        array.SetNumberOfTuples(count)
        if kind == "Constant":
            array.ConstructBackend(2.5)
        else:
            array.ConstructBackend(0.5, -3)
        getattr(grid, "Get" + where)().AddArray(array)
    return grid


def soa(values):
    array = core.vtkSOADataArrayTemplate[values.dtype.name]()
    array.SetNumberOfComponents(3)
    array.SetNumberOfTuples(len(values))
    for i, value in enumerate(values.tolist()):
        array.SetTuple(i, value)
    return array


def with_soa(points):
    grid = grid_of(listed_cells(TETS, "TypeInt64"), VTK_TETRA, len(TETS))
    if points:
        grid.GetPoints().SetData(soa(POINTS))
    else:
        array = soa(POINTS.astype(np.float64))
        array.SetName("soa")
        grid.GetPointData().AddArray(array)
    return grid


def image():
    data = vtkImageData()
    data.SetDimensions(12, 12, 12)
    ball = np.linalg.norm(np.indices((12, 12, 12)).reshape(3, -1) - 5.5, axis=0)
    gm.add_array(data.GetPointData(), ball, "ball")
    data.GetPointData().SetActiveScalars("ball")
    return data


def output_of(name, source, value=None):
    if not hasattr(filters, name):
        return None
    algorithm = getattr(filters, name)()
    algorithm.SetInputDataObject(source)
    if value is not None:
        algorithm.SetValue(0, value)
    else:
        plane = vtkPlane()
        plane.SetOrigin(0.5, 0.5, 0.52)
        plane.SetNormal(0, 0.2, 1)
        (algorithm.SetCutFunction if name == "vtkCutter" else algorithm.SetPlane)(plane)
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0)
    surface = output if output.IsA("vtkPolyData") else output.GetPartition(0)
    fresh = vtkPolyData()
    fresh.CopyStructure(surface)
    return add_arrays(fresh)


def outer():
    algorithm = vtkGeometryFilter()
    algorithm.SetInputDataObject(grid_of(listed_cells(TETS, "TypeInt64"), VTK_TETRA))
    algorithm.Update()
    return algorithm.GetOutput()


def tets_with_heat():
    return grid_of(listed_cells(TETS, "TypeInt64"), VTK_TETRA)


WEDGES = lambda: boxes()[:, [0, 2, 1, 4, 6, 5]]
VOLUMES = {}
for ids_name in ("TypeInt64", "TypeInt32", "IdType"):
    VOLUMES["types array, " + ids_name] = (
        lambda n=ids_name: grid_of(listed_cells(TETS, n), VTK_TETRA, len(TETS)))
    VOLUMES["one type, " + ids_name] = lambda n=ids_name: grid_of(listed_cells(TETS, n), VTK_TETRA)
for count in (None, 125):
    for kind, make in ((VTK_HEXAHEDRON, boxes), (VTK_WEDGE, WEDGES)):
        VOLUMES["type %d, %s" % (kind, "array" if count else "one")] = lambda k=kind, m=make, c=count: (
            in_order(lambda: grid_of(listed_cells(m(), "TypeInt64"), k, c)))
VOLUMES["mixed"] = lambda: in_order(mixed)
VOLUMES["polyhedra"] = lambda: in_order(lambda: add_arrays(of_polyhedra()))
if FIXED:
    for ids_name in ("TypeInt64", "TypeInt32"):
        VOLUMES["fixed size, types array, " + ids_name] = (
            lambda n=ids_name: grid_of(fixed_cells(TETS, n), VTK_TETRA, len(TETS)))
        VOLUMES["fixed size, one type, " + ids_name] = (
            lambda n=ids_name: grid_of(fixed_cells(TETS, n), VTK_TETRA))
    VOLUMES["fixed size, hexahedra"] = lambda: in_order(
        lambda: grid_of(fixed_cells(boxes(), "TypeInt32"), VTK_HEXAHEDRON))
    VOLUMES["fixed faces"] = lambda: in_order(fixed_faces)
if GENERIC:
    for ids_name, offsets_name in (("UnsignedInt", None), ("Short", None), ("Long", None),
                                   ("UnsignedLongLong", None), ("Int", "TypeInt64")):
        VOLUMES["generic %s, %s" % (ids_name, offsets_name)] = (
            lambda n=ids_name, o=offsets_name: grid_of(listed_cells(TETS, n, o), VTK_TETRA, len(TETS)))
if IMPLICIT:
    VOLUMES["constant arrays"] = lambda: with_implicit("Constant")
    VOLUMES["affine arrays"] = lambda: with_implicit("Affine")
VOLUMES["SOA array"] = lambda: with_soa(False)
VOLUMES["SOA points"] = lambda: with_soa(True)
SURFACES = {
    "flying edges": lambda: output_of("vtkFlyingEdges3D", image(), 4.0),
    "contour of an image": lambda: output_of("vtkContourFilter", image(), 4.0),
    "contour of tetrahedra": lambda: output_of("vtkContourFilter", tets_with_heat(), 1.6),
    "linear contour": lambda: output_of("vtkContour3DLinearGrid", tets_with_heat(), 1.6),
    "cut": lambda: output_of("vtkCutter", tets_with_heat()),
    "plane cut": lambda: output_of("vtkPlaneCutter", tets_with_heat()),
    "outer surface": outer,
}


def as_stored(grid):
    """Ids of other types come back with 32 bits, or 64 where these may not do."""
    cells = grid.GetCells()
    if not (GENERIC and cells.IsStorageGeneric()):
        return grid
    arrays = cells.GetOffsetsArray(), cells.GetConnectivityArray()
    wide = any(array.GetDataTypeMax() > 2 ** 31 - 1 for array in arrays)
    plain = vtkUnstructuredGrid()
    plain.ShallowCopy(grid)
    ids = vtk_to_numpy(arrays[1]).reshape(-1, 4)
    plain.SetCells(VTK_TETRA, listed_cells(ids, "TypeInt64" if wide else "TypeInt32"))
    return plain


def is_tetrahedral(grid):
    return (gm.cell_types(grid) == VTK_TETRA).all()


def check_picture(scene):
    """Something other than the background is seen."""
    scene.look()
    picture = scene.render()
    assert (picture != picture[0, 0]).any(-1).sum() > 300


def simplified(data):
    algorithm = vtkGatunSimplify()
    algorithm.SetInputDataObject(data)
    algorithm.SetSimplificationRatio(0.5)
    algorithm.Update()
    assert algorithm.GetErrorCode() == 0
    return algorithm.GetOutput()


def check_blocks(data):
    moved = data.NewInstance()
    moved.ShallowCopy(data)
    back = listed(split(merge(collect([("one", data), ("two", moved)]))))
    assert [name for name, _ in back] == ["one", "two"]
    for _, block in back:
        assert block.GetNumberOfCells() == data.GetNumberOfCells()


def check_contour(grid):
    contour = vtkGatunContour()
    contour.SetInputDataObject(grid)
    contour.SetValue(0, 1.6)
    contour.Update()
    assert contour.GetErrorCode() == 0
    triangles = contour.GetOutput().GetNumberOfPolys()
    if is_tetrahedral(grid):
        # VTK's filter knows only what it makes itself, so it gets the plainest storage.
        plain = grid_of(listed_cells(vtk_to_numpy(
            grid.GetCells().GetConnectivityArray()).reshape(-1, 4), "TypeInt64"), VTK_TETRA)
        expected = filters.vtkContourGrid()
        expected.SetInputDataObject(plain)
        expected.SetValue(0, 1.6)
        expected.Update()
        assert triangles == expected.GetOutput().GetNumberOfPolys()
    assert triangles > 20


for name, make in VOLUMES.items():
    grid = make()
    print(name, flush=True)
    gm.assert_equal(as_stored(grid), gm.round_trip(grid, "storage.gtn", KeepOrder=7))
    if VTK_POLYHEDRON not in gm.cell_types(grid):
        assert sum(len(block[1]) for block in gatun.to_numpy(grid).cells) == grid.GetNumberOfCells()
    check_contour(grid)
    assert 0 < simplified(grid).GetNumberOfCells()
    check_blocks(grid)
    check_picture(gatunVolumes.Scene(grid))
for name, make in SURFACES.items():
    surface = make()
    print(name, surface is not None, flush=True)
    if surface is not None:
        path = gm.temporary("storage-surface.gtn")
        gm.write(surface, path, KeepOrder=7)
        pd.assert_equal(surface, pd.read(path))
        assert sum(len(b[1]) for b in gatun.to_numpy(surface).cells) == surface.GetNumberOfCells()
        assert 0 < simplified(surface).GetNumberOfCells() < surface.GetNumberOfCells()
        check_blocks(surface)
        check_picture(gatunSurfaceScene.Scene(surface))
