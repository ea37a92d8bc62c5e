# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""libgatun reads all golden files as VTK does: points, cells, arrays and field data at all steps, and volumes."""

import os
import unittest
import warnings

import gatun
import gatunMeshes as gm
import numpy as np
from gatunCube import require_equal
from gatunGrids import golden_files, require_same_bytes, sort_surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid


def list_cells(mesh):
    """Types, sizes and connectivity of all cells of a mesh of VTK.

    vtkPolyData tells no types of odd cells, such as vertices without a point.
    """
    if isinstance(mesh, vtkUnstructuredGrid):
        lists = [(mesh.GetCells(), None)] if mesh.GetNumberOfCells() else []
    else:
        kinds = ({1: 1, 0: 2}, {2: 3, 0: 4}, {3: 5, 4: 9, 0: 7}, {0: 6})
        lists = zip((mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips()), kinds)
    types, sizes, ids = [np.empty(0, np.uint8)], [np.empty(0, int)], [np.empty(0, int)]
    for cells, kinds in lists:
        sizes.append(np.diff(vtk_to_numpy(cells.GetOffsetsArray())))
        ids.append(vtk_to_numpy(cells.GetConnectivityArray()))
        own = gm.cell_types(mesh) if kinds is None else [kinds.get(size, kinds[0]) for size in sizes[-1]]
        types.append(np.array(own, np.uint8))
    return map(np.concatenate, (types, sizes, ids))


class LibraryGolden(unittest.TestCase):
    def require_same_cells(self, grid, mesh):
        types, sizes, ids = list_cells(mesh)
        np.testing.assert_array_equal(grid.types, types)
        np.testing.assert_array_equal(np.diff(grid.offsets), sizes)
        np.testing.assert_array_equal(grid.connectivity, ids)
        self.assertEqual(grid.offsets[0], 0)
        if isinstance(mesh, vtkUnstructuredGrid) and mesh.GetFaces():
            for i in range(mesh.GetNumberOfCells()):
                start = -1 if grid.face_locations is None else grid.face_locations[i]
                faces = [] if start < 0 else self.take_faces(grid.faces, start)
                self.assertEqual(gm.faces_of(mesh, i), faces)
        else:
            self.assertIsNone(grid.faces)

    @staticmethod
    def take_faces(numbers, start):
        end = start + 1
        for _ in range(numbers[start]):
            end += 1 + numbers[end]
        return numbers[start:end].tolist()

    def require_same_arrays(self, data, descriptions, attributes):
        arrays = gm.arrays_of(attributes)
        self.assertEqual(len(data), len(arrays))
        for values, description, array in zip(data.values(), descriptions, arrays):
            self.assertEqual(description.name, array.GetName() or "")
            self.assertEqual(description.components, array.GetNumberOfComponents())
            require_same_bytes(values, gm.values_of(array))

    def require_same_fields(self, fields, data):
        arrays = gm.arrays_of(data)
        self.assertEqual(len(fields), len(arrays))
        for (key, values), array in zip(fields.items(), arrays):
            self.assertTrue(key.startswith(array.GetName() or "array "))
            if isinstance(array, vtkStringArray):
                texts = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
                self.assertEqual(np.array(values, object).ravel().tolist(), texts)
            else:
                require_same_bytes(values, gm.values_of(array))

    def require_same(self, file, grid, mesh):
        if grid.is_surface:
            grid = sort_surface(grid)
        points = mesh.GetPoints()
        if points is None:
            self.assertEqual(len(grid.points), 0)
        else:
            require_equal(grid.points, vtk_to_numpy(points.GetData()))
        self.require_same_cells(grid, mesh)
        for is_cell, data in ((False, grid.point_data), (True, grid.cell_data)):
            descriptions = [array for array in file.arrays if array.is_cell == is_cell and array.key in data]
            attributes = mesh.GetCellData() if is_cell else mesh.GetPointData()
            self.require_same_arrays(data, descriptions, attributes)
        self.require_same_fields(grid.field_data, mesh.GetFieldData())

    def test_meshes(self):
        paths = golden_files(".gtn")
        self.assertGreater(len(paths), 80)
        for path in paths:
            with self.subTest(os.path.basename(path)), gatun.open(path) as file:
                self.assertEqual(file.times, gatun.steps(path))
                self.assertEqual({**file.info, "file": ""}, {**gatun.info(path), "file": ""})
                for step in range(max(len(file.times), 1)):
                    for restore in (True, False):
                        mesh = gatun.read(path, step=step, restore_order=restore)
                        self.require_same(file, file.read(step=step, restore_order=restore), mesh)
                self.require_same_descriptions(file)

    def require_same_descriptions(self, file):
        """Steps and levels are what is read."""
        for number, step in enumerate(file.steps):
            grid = file.read(step=number, arrays=[])
            self.assertEqual((step.points, step.cells), (len(grid.points), len(grid.types)))
            self.assertEqual(step.time, grid.time)
        for number, level in enumerate(file.levels, 1):
            grid = file.read(level=number)
            self.assertEqual((level.points, level.cells), (len(grid.points), len(grid.types)))

    def test_volumes(self):
        paths = golden_files(".ghv")
        self.assertGreater(len(paths), 8)
        for path in paths:
            with self.subTest(os.path.basename(path)), gatun.open(path) as volume:
                image = gatun.read(path)
                expected = gatun.image_to_numpy(image)
                require_equal(volume.read(), expected)
                self.assertEqual(volume.shape, expected.shape)
                self.assertEqual(volume.origin, image.GetOrigin())
                self.assertEqual(volume.spacing, image.GetSpacing())
                first = [size // 3 for size in volume.shape[::-1]]
                part = tuple(slice(start, None) for start in first[::-1])
                require_same_bytes(volume.read(first), expected[part])
                volume.verify()


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
