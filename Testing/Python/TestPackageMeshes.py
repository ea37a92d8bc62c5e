# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What libgatun reads for VTK is what the readers of VTK give: all golden files, at all steps, in pieces."""

import importlib.util
import pathlib
import unittest
import warnings

import gatun
import gatunMeshes as gm
import numpy as np
from gatun._vtk_mesh import read_mesh
from gatunGrids import golden_files, require_same_bytes, require_same_grids
from gatunSameMesh import describe_attributes, require_same_mesh
from vtkmodules import vtkCommonCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkQuadratureSchemeDefinition
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline


def read_by_vtk(path, time, *, piece=0, pieces=1, ghosts=0, restore=True, ratio=0.0, box=None):
    surface = gatun.vtk.vtkGatunSurfaceReader()
    reader = surface if surface.CanReadFile(path) else gatun.vtk.vtkGatunReader()
    reader.SetFileName(path)
    reader.SetRestoreOrder(restore)
    reader.SetSimplificationRatio(ratio)
    if box is not None:
        reader.SetBox(box)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    if time is not None:
        info.Set(Pipeline.UPDATE_TIME_STEP(), time)
    info.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
    info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
    info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), ghosts)
    reader.Update()
    return reader.GetOutput()


def read_volume_by_vtk(path, extent=None):
    reader = gatun.vtk.vtkGatunHartleyReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    if extent:
        reader.UpdateExtent(extent)
    else:
        reader.Update()
    return reader.GetOutput()


def make_keys(info):
    """Sets keys of all kinds, with values at the ends of their ranges."""
    scheme = vtkQuadratureSchemeDefinition()
    scheme.Initialize(10, 4, 2, [0.25, 0.125, 0.5, 0.125, 1 / 3, 0.0, 0.5, 1 / 6], [1 / 3, 2 / 3])
    vtkQuadratureSchemeDefinition.DICTIONARY().Set(info, scheme, 10)
    make = lambda kind: getattr(vtkCommonCore, f"vtkInformation{kind}Key").MakeKey(kind, "TestPackageMeshes")
    for kind, value in (
        ("Integer", -(2**31)), ("Double", 0.1), ("IdType", -(2**63)), ("UnsignedLong", 2**64 - 1), ("String", b"\xff")
    ):
        make(kind).Set(info, value)
    for kind, values in (("IntegerVector", (1, -2)), ("DoubleVector", (0.5, -0.0)), ("StringVector", ("a", ""))):
        key = make(kind)
        for value in values:
            key.Append(info, value)


def make_odd_grid():
    grid = gm.block()
    data, count = grid.GetPointData(), grid.GetNumberOfPoints()
    for name in ("point", "twice", "twice", "", None, b"\xfe"):
        array = gm.add_array(data, np.arange(count, dtype=np.int16), "placeholder")
        array.SetName(name)
    make_keys(data.GetArray(0).GetInformation())
    ghosts = np.zeros(count, np.uint8)
    ghosts[::3] = vtkDataSetAttributes.HIDDENPOINT
    gm.add_array(data, ghosts, vtkDataSetAttributes.GhostArrayName())
    texts = vtkStringArray()
    texts.SetName("texts")
    texts.SetNumberOfComponents(2)
    for i, text in enumerate((b"", b"zero\0inside", b"\xff", "\u00e4".encode())):
        texts.InsertValue(i, text)
    make_keys(texts.GetInformation())
    grid.GetFieldData().AddArray(texts)
    for name in ("same", "same"):
        gm.add_array(grid.GetFieldData(), np.arange(6.0).reshape(2, 3), "placeholder").SetName(name)
    return grid


class PackageMeshes(unittest.TestCase):
    def visit_steps(self):
        """All golden files that are open, with their paths, numbers of steps and times."""
        paths = golden_files(".gtn")
        self.assertGreater(len(paths), 80)
        for path in paths:
            with gatun.open(path) as file:
                for step, time in enumerate(file.times or [None]):
                    yield file, path, step, time

    def test_golden_files(self):
        for file, path, step, time in self.visit_steps():
            for restore in (True, False):
                expected = read_by_vtk(path, time, restore=restore)
                require_same_mesh(read_mesh(file, step=step, restore_order=restore), expected, path)

    def test_pieces_with_ghosts(self):
        for file, path, step, time in self.visit_steps():
            for piece in (0, 1):
                for ghosts in (0, 1):
                    expected = read_by_vtk(path, time, piece=piece, pieces=3, ghosts=ghosts)
                    found = read_mesh(file, step=step, piece=piece, pieces=3, ghost_levels=ghosts)
                    require_same_mesh(found, expected, path)


    def test_boxes_and_ratios(self):
        """Parts of a mesh have the cells that the reader gives."""
        path = gm.temporary("parts.gtn")
        gm.write(gm.block(n=8), path, ChunkSize=128, Hierarchy=True)
        for ratio in (0.0, 0.4):
            for box in (None, (0, 0.2, 0, 0.3, 0, 1), (5, 6, 5, 6, 5, 6)):
                for restore in (True, False):
                    expected = read_by_vtk(path, None, ratio=ratio, box=box, restore=restore)
                    found = gatun.read(path, ratio=ratio, box=box, restore_order=restore)
                    require_same_mesh(found, expected, (ratio, box, restore))
        self.assertLess(gatun.read(path, box=(0, 0.2, 0, 0.3, 0, 1)).GetNumberOfCells(), 6 * 8**3)

    def test_sources_and_targets(self):
        """What is read does not depend on where the file is, and is the same as NumPy arrays and in VTK."""
        path = gm.temporary("source.gtn")
        gm.write(gm.block(), path)
        expected = read_by_vtk(path, None)
        data = pathlib.Path(path).read_bytes()
        with gatun.open(path) as file:
            for source in (path, pathlib.Path(path), data, memoryview(data), file):
                require_same_mesh(gatun.read(source), expected, source)
                self.assertEqual(gatun.steps(source), [])
                self.assertEqual(gatun.info(source)["points"], expected.GetNumberOfPoints())
                gatun.verify(source)
            grid = gatun.read(file, to="numpy", arrays="wave")
            require_same_grids(grid, file.read(arrays="wave"))
        self.assertEqual(list(grid.point_data), ["wave"])
        if importlib.util.find_spec("meshio"):
            self.assertEqual(len(gatun.read(path, to="meshio").points), expected.GetNumberOfPoints())
        with self.assertRaisesRegex(ValueError, "'vtu' is not known; there are 'vtk'"):
            gatun.read(path, to="vtu")

    def test_surfaces_from_meshes(self):
        """Contours and slices of VTK have the triangles and values of the arrays of NumPy."""
        path = gm.temporary("surfaces.gtn")
        gm.write(gm.block(), path)
        for function, arguments, options in (
            (gatun.contour, ("wave", [1.0, 1.5]), {"normals": True}),
            (gatun.slice, ((0.5, 0.5, 0.5), (1, 2, 3)), {"arrays": ["wave", "cell"]}),
        ):
            surface, grid = (function(path, *arguments, to=to, **options) for to in ("vtk", "numpy"))
            self.assertTrue(surface.IsA("vtkPolyData") and grid.is_surface and len(grid.types) > 10)
            triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
            self.assertEqual(triangles.tolist(), grid.connectivity.tolist())
            require_same_bytes(gm.coordinates(surface), grid.points)
            for data, attributes in ((grid.point_data, surface.GetPointData()), (grid.cell_data, surface.GetCellData())):
                for name, values in data.items():
                    require_same_bytes(gm.values_of(attributes.GetArray(name)), values)
            if "normals" in options:
                require_same_bytes(vtk_to_numpy(surface.GetPointData().GetNormals()), grid.normals)
        with self.assertRaisesRegex(ValueError, "is a volume, and no mesh"):
            gatun.slice(golden_files(".ghv")[0], (0, 0, 0), (1, 0, 0))

    def test_volumes(self):
        """All golden files, whole and in a box."""
        for path in golden_files(".ghv"):
            image = read_volume_by_vtk(path)
            self.require_same_volume(gatun.read(path), image)
            bounds, third = np.reshape(image.GetBounds(), (3, 2)), 1 / 3
            box = np.column_stack([bounds.mean(axis=1), bounds @ [third, 1 - third]])
            box.sort(axis=1)
            part = gatun.read(path, box=box.ravel())
            extent = part.GetExtent()
            self.assertTrue(all(extent[i] <= extent[i + 1] for i in (0, 2, 4)))
            self.require_same_volume(part, read_volume_by_vtk(path, extent))

    def require_same_volume(self, one, other):
        for name in ("Extent", "Origin", "Spacing", "Bounds"):
            self.assertEqual(getattr(one, "Get" + name)(), getattr(other, "Get" + name)())
        attributes = [describe_attributes(image.GetPointData()) for image in (one, other)]
        self.assertEqual(*attributes)

    def test_odd_arrays(self):
        """Names that repeat, are empty or no text, keys of all kinds, ghost flags in the file, and odd texts."""
        path = gm.temporary("odd.gtn")
        gm.write(make_odd_grid(), path, ChunkSize=64)
        with gatun.open(path) as file:
            require_same_mesh(read_mesh(file), read_by_vtk(path, None), path)
            for ghosts in (0, 2):
                expected = read_by_vtk(path, None, piece=0, pieces=2, ghosts=ghosts)
                require_same_mesh(read_mesh(file, pieces=2, ghost_levels=ghosts), expected, path)


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
