# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files that are organised by layers of values: read whole, in pieces, simplified and at any time they
give what the mesh is; what cannot be layers is told."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

points, tets = gm.lattice(14, seed=5)  # 16,464 tetrahedra
wave = (np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2).astype(np.float32)


def make(step=0):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), wave + np.float32(0.5 * step), "wave")
    gm.add_array(grid.GetPointData(), points * (1 + step), "vector")
    gm.add_array(grid.GetPointData(), np.arange(len(points)), "point id")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell id")
    return grid


grid = make()
defaults = vtkGatunWriter()
assert defaults.GetLayerArray() is None and defaults.GetLayerComponent() == -1
assert defaults.GetNumberOfLayers() == 0
assert defaults.GetLayerSpacing() == vtkGatunWriter.LAYERS_HISTOGRAM

# Whole: bit for bit what was written.
path = gm.temporary("io-layers.gtn")
plain = gm.temporary("io-layers-plain.gtn")
gm.write(grid, plain, ChunkSize=800)
for spacing in (1, 2, 3):
    for layers in (("wave", -1, 6, spacing), ("vector", 1, 0, spacing)):
        options = {"Layers": layers, "ChunkSize": 800}
        gm.write(grid, path, KeepOrder=7, **options)
        gm.assert_equal(gm.read(path), grid)
        gm.write(grid, path, **options)
        gm.assert_same_mesh(gm.read(path), grid)
        with open(path, "rb") as one, open(plain, "rb") as other:
            assert one.read() != other.read()

# An empty name is none: the very bytes of a file without.
gm.write(grid, path, Layers="", ChunkSize=800)
with open(path, "rb") as one, open(plain, "rb") as other:
    assert one.read() == other.read()


def values_in_piece(name, piece, pieces, ghosts):
    """Ids of cells and points that a piece owns, those of all its cells, and the piece."""
    reader = vtkGatunReader()
    reader.SetFileName(name)
    reader.UpdatePiece(piece, pieces, ghosts)
    data = reader.GetOutput()
    ids = [gm.values_of(attributes.GetArray(array)).ravel()
           for attributes, array in ((data.GetCellData(), "cell id"),
                                     (data.GetPointData(), "point id"))]
    owned = []
    for attributes, all_ids in zip((data.GetCellData(), data.GetPointData()), ids):
        kinds = attributes.GetArray("vtkGhostType")
        kinds = np.zeros(len(all_ids)) if kinds is None else vtk_to_numpy(kinds)
        owned.append(all_ids[kinds == 0])
    return owned[0], owned[1], ids[0]


# In pieces, with ghosts: each cell and point owned once, and around each piece all that touches it.
gm.write(grid, path, Layers=("wave", -1, 6), ChunkSize=800)
cells, nodes = [], []
for piece in range(5):
    owned_cells, owned_points, all_cells = values_in_piece(path, piece, 5, 1)
    cells.append(owned_cells)
    nodes.append(owned_points)
    touched = np.isin(tets, tets[owned_cells]).any(axis=1)
    np.testing.assert_array_equal(np.sort(all_cells), np.flatnonzero(touched))
np.testing.assert_array_equal(np.sort(np.concatenate(cells)), np.arange(len(tets)))
np.testing.assert_array_equal(np.sort(np.concatenate(nodes)), np.arange(len(points)))
# A piece has but some of the values, as pieces are runs of chunks.
of_first = wave[tets[cells[0]]]
assert of_first.max() - of_first.min() < 0.75 * (wave.max() - wave.min())

# Simplified: the very mesh of the file without layers, base meshes or not.
for levels in (0, 3):
    for options, name in (({"Layers": "wave"}, path), ({}, plain)):
        gm.write(grid, name, KeepOrder=7, ChunkSize=800, Hierarchy=True, Levels=levels, **options)
    for ratio in (0.3, 0.8):
        one, other = (gm.read(name, SimplificationRatio=ratio) for name in (path, plain))
        assert 0 < one.GetNumberOfPoints() < 0.71 * len(points)
        gm.assert_same_mesh(one, other)

# Time steps, of which the first makes the layers.
TIMES = [0.0, 1.0, 2.0]
writer = vtkGatunWriter()
connect(writer, TimeSource(make, TIMES))
writer.SetFileName(path)
writer.WriteAllTimeStepsOn()
writer.SetKeepOrder(7)
writer.SetChunkSize(800)
writer.SetLayers("wave")
assert writer.Write() == 1
reader = vtkGatunReader()
reader.SetFileName(path)
for step in (2, 0, 1):
    reader.UpdateInformation()
    reader.GetOutputInformation(0).Set(pipeline.UPDATE_TIME_STEP(), TIMES[step])
    reader.Update()
    np.testing.assert_array_equal(
        vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("wave")),
        wave + np.float32(0.5 * step))


def expect_error(text, **options):
    writer = vtkGatunWriter()
    writer.SetInputDataObject(grid)
    writer.SetFileName(gm.temporary("io-layers-never.gtn"))
    writer.GetPointDataArraySelection().SetUnknownArraySetting(options.pop("unlisted", 1))
    gm.set_options(writer, **options)
    errors = gm.Errors(writer)
    assert writer.Write() == 0
    assert writer.GetErrorCode() == vtkGatunErrorCode.InvalidInputError != vtkErrorCode.NoError
    assert len(errors.messages) == 1 and text in str(errors), str(errors)
    assert not os.path.exists(writer.GetFileName())


expect_error("there is no point array 'waves' to make layers of", Layers="waves")
expect_error("layers need a point array, and 'cell id' is one of cells", Layers="cell id")
expect_error("array 'wave' has no component 1 to make layers of", Layers=("wave", 1))
expect_error("array 'vector' has no component 3", Layers=("vector", 3))
# Those that are not written cannot be layers either.
expect_error("there is no point array 'wave'", Layers="wave", unlisted=0)
