# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Pieces of a region of interest, with and without ghost cells, are together what the region gives
at once: each cell and each point is owned once, ghosts are cells of the region, and there are no
seams."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader

points, tets = gm.lattice(10)
middle = points[tets].mean(1)
# Eighths of the cube in two colors: those of one color touch at edges only, not at faces.
color = (np.floor(2 * middle).astype(int).sum(1) % 2).astype(np.int32)
grid = gm.make_grid(points, tets)
gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
gm.add_array(grid.GetPointData(), np.sin(5 * points), "wave")
gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
gm.add_array(grid.GetCellData(), color, "color")
path = gm.temporary("region_pieces.gtn")


def values(attributes, name):
    array = attributes.GetAbstractArray(name)
    return vtk_to_numpy(array) if array and array.GetNumberOfTuples() else np.zeros(0, np.int64)


def faces_of_one(cells):
    faces = np.concatenate([tets[cells][:, list(f)] for f in ((0, 1, 2), (0, 1, 3), (0, 2, 3),
                                                              (1, 2, 3))])
    _, count = np.unique(np.sort(faces, 1), axis=0, return_counts=True)
    return (count == 1).sum()


def skin_of(piece):
    """Owned cells of the surface."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(piece)
    surface.Update()
    shell = surface.GetOutput()
    if not shell.GetCellData().HasArray("vtkGhostType"):
        return shell.GetNumberOfCells()
    return (values(shell.GetCellData(), "vtkGhostType") == 0).sum()


REGIONS = [
    dict(Box=(0.05, 0.4, -1, 2, 0.3, 0.6)),
    dict(Box=(0.6, 2, 0.6, 2, 0.6, 2)),  # the lowest chunks are outside
    dict(ValueRangeArray="color", ValueRange=(1, 1)),
    dict(Box=(-1, 2, -1, 2, -1, 2)),
    dict(Box=(3, 4, 3, 4, 3, 4)),
]

for keep in (0, 7):
    gm.write(grid, path, KeepOrder=keep, ChunkSize=200)
    for region in REGIONS:
        reader = vtkGatunReader()
        reader.SetFileName(path)
        gm.set_options(reader, **region)
        reader.Update()
        chunks = reader.GetChunkTable().GetNumberOfRows()
        whole_points = values(reader.GetOutput().GetPointData(), "point").copy()
        whole_cells = values(reader.GetOutput().GetCellData(), "cell").copy()
        limited = 0 < len(whole_cells) < len(tets)
        assert limited or region["Box"] in ((-1, 2, -1, 2, -1, 2), (3, 4, 3, 4, 3, 4))
        assert np.array_equal(np.unique(tets[whole_cells]), np.sort(whole_points))
        inside = np.isin(np.arange(len(tets)), whole_cells)

        for pieces in (2, 3, 7, chunks):
            for ghosts in (0, 1, 2):
                owned_points, owned_cells, skin, ghost_cells = [], [], 0, 0
                for p in range(pieces):
                    reader.UpdatePiece(p, pieces, ghosts)
                    assert reader.GetErrorCode() == 0
                    piece = reader.GetOutput()
                    ids = values(piece.GetPointData(), "point")
                    cells = values(piece.GetCellData(), "cell")
                    # Values and corners are those of the whole.
                    assert np.array_equal(gm.coordinates(piece), points[ids])
                    if len(cells):
                        assert np.array_equal(values(piece.GetPointData(), "wave"),
                                              np.sin(5 * points)[ids])
                        assert np.array_equal(gm.turned(ids[gm.connectivity(piece)]),
                                              gm.turned(tets[cells]))
                    assert len(set(ids)) == len(ids) and len(set(cells)) == len(cells)
                    if not ghosts:
                        assert not piece.GetCellData().HasArray("vtkGhostType")
                        owned_cells.extend(cells)
                        owned_points.extend(ids)
                        continue
                    flags = values(piece.GetCellData(), "vtkGhostType")
                    mine = cells[flags == 0]
                    # Ghosts: layers around the piece, within the region.
                    layer = np.isin(np.arange(len(tets)), mine)
                    for _ in range(ghosts):
                        near = np.zeros(len(points), bool)
                        near[tets[layer]] = True
                        layer = near[tets].any(1) & inside
                    assert np.array_equal(np.flatnonzero(layer), np.sort(cells))
                    ghost_cells += (flags != 0).sum()
                    owned_cells.extend(mine)
                    owned_points.extend(ids[values(piece.GetPointData(), "vtkGhostType") == 0])
                    skin += skin_of(piece)
                assert sorted(owned_cells) == sorted(whole_cells)
                if ghosts:
                    assert sorted(owned_points) == sorted(whole_points), (region, pieces, ghosts)
                    assert len(whole_cells) == 0 or ghost_cells > 0
                    if len(whole_cells):
                        assert skin == faces_of_one(whole_cells)
                else:
                    assert set(owned_points) == set(whole_points)

# Another region may leave a piece as it is, but not its ghosts and owners.
reader = vtkGatunReader()
reader.SetFileName(path)
answers = {}
for box in ((0, 1, 0, 1, 0, 1), (0.6, 1, 0.6, 1, 0.6, 1)) * 2:
    reader.SetBox(box)
    reader.UpdatePiece(1, 2, 1)
    flags = values(reader.GetOutput().GetPointData(), "vtkGhostType")
    answer = len(flags), int((flags == 0).sum())
    assert answers.setdefault(box, answer) == answer
assert len(set(answers.values())) == 2
