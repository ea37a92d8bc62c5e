# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What libgatun reads for VTK is what the readers of VTK give: all golden files, at all steps, in pieces."""

import unittest
import warnings

import gatun
import gatunMeshes as gm
import numpy as np
from gatun._vtk_mesh import read_mesh
from gatunGrids import golden_files
from gatunSameMesh import require_same_mesh
from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkQuadratureSchemeDefinition
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline


def read_by_vtk(path, time, *, piece=0, pieces=1, ghosts=0, restore=True, ratio=0.0):
    surface = gatun.vtkGatunSurfaceReader()
    reader = surface if surface.CanReadFile(path) else gatun.vtkGatunReader()
    reader.SetFileName(path)
    reader.SetRestoreOrder(restore)
    reader.SetSimplificationRatio(ratio)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    if time is not None:
        info.Set(Pipeline.UPDATE_TIME_STEP(), time)
    info.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
    info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
    info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), ghosts)
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


    def test_odd_arrays(self):
        """Names that repeat, are empty or no text, keys of all kinds, ghost flags in the file, and odd texts."""
        path = gm.temporary("odd.gtn")
        gm.write(make_odd_grid(), path)
        with gatun.open(path) as file:
            require_same_mesh(read_mesh(file), read_by_vtk(path, None), path)
            for ghosts in (0, 2):
                expected = read_by_vtk(path, None, piece=0, pieces=2, ghosts=ghosts)
                require_same_mesh(read_mesh(file, pieces=2, ghost_levels=ghosts), expected, path)


if __name__ == "__main__":
    warnings.simplefilter("error")
    unittest.main()
