# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A surface whose file has a hierarchy is read with fewer points as vtkGatunSimplify makes it in
memory, triangle for triangle: by every target, whole and in pieces, with seams, lines and vertices,
at every time; and vtkGatunSimplify behind the reader gives the same."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkCleanPolyData, vtkFeatureEdges, vtkTriangleFilter)

import gatunMeshes as gm
import gatunPolyData as pd
import gatunTimeSource
from gatun.vtk import vtkGatunErrorCode, vtkGatunSimplify, vtkGatunSurfaceReader, vtkGatunWriter

TIMES = [0.0, 0.5, 2.0]
GHOSTS = "vtkGhostType"


def make_torus(n, m, step=0.0):
    """A torus with two seams, where texture coordinates jump; a polyline, a line and vertices."""
    u, v = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, m + 1), indexing="ij")
    a, b = 2 * np.pi * (u % 1), 2 * np.pi * (v % 1)
    r = 1 + 0.4 * np.cos(b) + 0.05 * np.sin(5 * a)
    points = np.stack([r * np.cos(a), r * np.sin(a), 0.4 * np.sin(b)], -1).reshape(-1, 3)
    triangles = []
    for i in range(n):
        for j in range(m):
            p, q = i * (m + 1) + j, (i + 1) * (m + 1) + j
            triangles += [[p, q, q + 1], [p, q + 1, p + 1]]
    half = len(points) // 2
    surface = pd.make(points.astype(np.float32), Verts=[[3], [5, 9]],
                      Lines=[[half, half + 1, half + 2], [7, 8]], Polys=triangles)
    point = surface.GetPointData()
    point.SetTCoords(gm.add_array(point, np.stack([u, v], -1).reshape(-1, 2), "places"))
    wave = np.sin(3 * points[:, 0] + step) * np.cos(2 * points[:, 1]) + points[:, 2]
    point.SetScalars(gm.add_array(point, wave.astype(np.float32), "wave"))
    gm.add_array(surface.GetCellData(), np.arange(surface.GetNumberOfCells()), "cell")
    gm.add_array(surface.GetFieldData(), np.array([1.5, 2.5]), "field")
    return surface


def open_file(path, **options):
    return pd.reader_of(path, **options)


def simplifier_of(source, **options):
    simplifier = vtkGatunSimplify()
    if hasattr(source, "GetOutputPort"):
        simplifier.SetInputConnection(source.GetOutputPort())
    else:
        simplifier.SetInputDataObject(source)
    gm.set_options(simplifier, **options)
    return simplifier


def update(algorithm, piece=(0, 1, 0), time=None):
    if time is None:
        algorithm.UpdatePiece(*piece)
    else:
        algorithm.UpdateTimeStep(time, *piece)
    assert algorithm.GetErrorCode() == 0
    return algorithm.GetOutput()


def ids_of(surface):
    return vtk_to_numpy(surface.GetCellData().GetGlobalIds())


def write(surface, name, **options):
    path = gm.temporary(name)
    gm.write(surface, path, ChunkSize=300, Hierarchy=True, **options)
    return path


def count_border_edges(surface):
    """By places, as seams are no borders."""
    edges = vtkFeatureEdges()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    clean = vtkCleanPolyData()
    only = pd.make(vtk_to_numpy(surface.GetPoints().GetData()), Polys=pd.cells_of(surface)[2])
    clean.SetInputData(only)
    edges.SetInputConnection(clean.GetOutputPort())
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


# By every target, with base meshes and without, in the original order and not.
torus = make_torus(50, 24)
TARGETS = [{"SimplificationRatio": 0.3}, {"SimplificationRatio": 0.9}, {"SimplificationRatio": 1},
           {"SimplificationNumberOfPoints": 300},
           {"SimplificationRMSError": 0.01}]
for options in ({}, {"KeepOrder": 7}, {"KeepOrder": 1}):
    path = write(torus, "surface-hierarchy.gtn", **options)
    pd.assert_same_surface(torus, pd.read(path))
    for target in TARGETS:
        expected = simplifier_of(torus, **target)
        left = update(expected)
        assert left.GetNumberOfPolys() < 2400 and left.GetNumberOfLines() == 2
        reader = open_file(path, **target)
        got = update(reader)
        assert reader.GetHasHierarchy()
        pd.assert_same_surface(left, got)
        if options.get("KeepOrder") == 7:
            assert np.array_equal(pd.coordinates(left), pd.coordinates(got))
            gm.assert_same_arrays(left.GetCellData(), got.GetCellData())
            gm.assert_same_arrays(left.GetPointData(), got.GetPointData())
        assert count_border_edges(got) == 0, "seams are closed"
        # The filter behind the reader reads the file, and the reader nothing.
        whole = open_file(path)
        behind = simplifier_of(whole, **target)
        pd.assert_equal(got, update(behind))
        assert gm.statistic(whole, "DecodedChunks") == 0 and whole.GetOutput().GetNumberOfCells() == 0
        assert behind.GetMostMerges() == expected.GetMostMerges() > 0
        assert abs(behind.GetOutputRMSError() - expected.GetOutputRMSError()) < 1e-12

# Any number of points: none opens a seam, and the error is that of the merges that are made.
path = write(torus, "surface-hierarchy.gtn")
reader = open_file(path)
behind = simplifier_of(open_file(path))
memory = simplifier_of(torus)
fewer = 0
for count in range(420, 330, -1):
    for algorithm in (reader, behind, memory):
        algorithm.SetSimplificationNumberOfPoints(count)
    got, left = update(reader), update(memory)
    assert got.GetNumberOfPoints() == left.GetNumberOfPoints() <= count
    fewer += got.GetNumberOfPoints() < count
    assert pd.canonical(got) == pd.canonical(left) == pd.canonical(update(behind))
    assert behind.GetOutputRMSError() == memory.GetOutputRMSError()
    assert count_border_edges(got) == 0
assert fewer > 0

# Pieces make up the whole, and ghost cells are those of other pieces.
whole = update(open_file(path, SimplificationRatio=0.8, GenerateGlobalIds=True))
pieces = open_file(path, SimplificationRatio=0.8)
for ghosts in (0, 1, 2):
    found, points, around = [], 0, 0
    for piece in range(4):
        part = update(pieces, (piece, 4, ghosts))
        marks = part.GetCellData().GetArray(GHOSTS)
        owned = np.ones(part.GetNumberOfCells(), bool)
        if marks is not None:
            owned = vtk_to_numpy(marks) == 0
            points += (vtk_to_numpy(part.GetPointData().GetArray(GHOSTS)) == 0).sum()
        found += ids_of(part)[owned].tolist()
        around += (~owned).sum()
    assert sorted(found) == sorted(ids_of(whole).tolist())
    assert (around > 0) == (ghosts > 0)
    assert ghosts == 0 or points == whole.GetNumberOfPoints()
joined = vtkAppendPolyData()
parts = []
for piece in range(3):
    parts.append(type(whole)())
    parts[-1].ShallowCopy(update(pieces, (piece, 3, 0)))
    joined.AddInputData(parts[-1])
joined.Update()
assert count_border_edges(joined.GetOutput()) == 0, "pieces fit together"

# A region of interest, selected arrays, and weights.
boxed = open_file(path, SimplificationRatio=0.8, Box=(0, 2, 0, 2, -1, 1))
part = update(boxed)
assert 0 < part.GetNumberOfPolys() < whole.GetNumberOfPolys()
chosen = open_file(path, SimplificationRatio=0.8)
chosen.UpdateInformation()
chosen.SetPointArrayStatus("places", 0)
assert not update(chosen).GetPointData().HasArray("places")
writer = vtkGatunWriter()
writer.SetInputDataObject(torus)
writer.SetFileName(path)
writer.HierarchyOn()
writer.SetArrayWeight("places", 1)
assert writer.Write() == 1
other = simplifier_of(torus, SimplificationRatio=0.8)
other.SetArrayWeight("places", 1)
got = update(open_file(path, SimplificationRatio=0.8))
assert pd.canonical(update(other)) == pd.canonical(got) != pd.canonical(whole)

# Base meshes: less is decoded of them, and the result is the same.
large = make_torus(180, 90)
path = write(large, "surface-levels.gtn", Levels=3)
for ratio in (0.5, 0.6, 0.97):
    reader = open_file(path, SimplificationRatio=ratio)
    pd.assert_same_surface(update(simplifier_of(large, SimplificationRatio=ratio)), update(reader))
assert gm.statistic(reader, "BytesRead") < 0.5 * os.path.getsize(path)

# Times, which consumers ask for in turn.
stepped = gm.temporary("surface-time.gtn")
writer = vtkGatunWriter()
gatunTimeSource.connect(writer, gatunTimeSource.TimeSource(
    lambda i: make_torus(30, 20, TIMES[i]), TIMES, "vtkPolyData"))
writer.SetFileName(stepped)
writer.WriteAllTimeStepsOn()
writer.HierarchyOn()
writer.SetChunkSize(200)
assert writer.Write() == 1
reader = open_file(stepped, SimplificationRatio=0.7)
behind = simplifier_of(open_file(stepped), SimplificationRatio=0.7)
cells = None
for step, time in enumerate(TIMES):
    got = update(reader, time=time)
    pd.assert_equal(got, update(behind, time=time))
    wave = vtk_to_numpy(got.GetPointData().GetArray("wave"))
    points = vtk_to_numpy(got.GetPoints().GetData())
    assert np.allclose(wave, np.sin(3 * points[:, 0] + time) * np.cos(2 * points[:, 1])
                       + points[:, 2], atol=1e-5)
    cells = cells or pd.cells_of(got)
    assert cells == pd.cells_of(got), "the order is that of the first step"

# A hierarchy is one of triangles.
squares = pd.wave(20)
for surface, what in ((squares, "polygon with 4 points"),
                      (pd.make(np.eye(3), Strips=[[0, 1, 2]]), "triangle strip"),
                      (pd.make(np.eye(3), Polys=[[0, 1]]), "polygon with 2 points")):
    writer = vtkGatunWriter()
    errors = gm.Errors(writer)
    writer.SetInputDataObject(surface)
    writer.SetFileName(gm.temporary("refused.gtn"))
    writer.HierarchyOn()
    assert writer.Write() == 0
    assert writer.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
    for text in (what, "gtn pack --triangles", "vtkTriangleFilter"):
        assert text in str(errors), str(errors)
    assert not os.path.exists(writer.GetFileName())
divide = vtkTriangleFilter()
divide.SetInputData(squares)
divide.Update()
path = write(divide.GetOutput(), "divided.gtn")
pd.assert_same_surface(update(simplifier_of(divide.GetOutput(), SimplificationRatio=0.5)),
                       update(open_file(path, SimplificationRatio=0.5)))

# Without a hierarchy in the file.
path = gm.temporary("plain.gtn")
gm.write(torus, path)
reader = open_file(path, SimplificationRatio=0.5)
errors = gm.Errors(reader)
reader.Update()
assert "there is no hierarchy in the file" in str(errors)
assert reader.GetOutput().GetNumberOfCells() == 0
pd.assert_same_surface(update(simplifier_of(torus)), update(simplifier_of(open_file(path))))
# Nothing at all.
for empty in (pd.make(np.zeros((0, 3), np.float32)), pd.make(np.eye(3, dtype=np.float32)),
              pd.make(np.eye(3, dtype=np.float32), Polys=[[0, 1, 2]])):
    path = write(empty, "empty.gtn")
    assert pd.canonical(update(open_file(path, SimplificationRatio=0.5))) == pd.canonical(empty)
assert isinstance(reader, vtkGatunSurfaceReader)
