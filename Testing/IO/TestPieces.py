# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Pieces together are the whole; with ghosts they have no seams; two consumers of one reader do not
disturb each other; the chunk table says what is in the chunks."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader

UNUSED = 17
points, tets = gm.lattice(10)
rng = np.random.default_rng(2)
points = np.concatenate([points, rng.random((UNUSED, 3)).astype(np.float32)])
grid = gm.make_grid(points, tets)
gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
gm.add_array(grid.GetPointData(), np.sin(5 * points), "wave")
gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
path = gm.temporary("pieces.gtn")


def ids_of(data, name):
    array = data.GetAbstractArray(name)
    return vtk_to_numpy(array) if array and array.GetNumberOfTuples() else np.zeros(0, np.int64)


def piece_of(reader, piece, pieces, ghosts=0):
    reader.UpdatePiece(piece, pieces, ghosts)
    assert reader.GetErrorCode() == 0
    copy = vtkUnstructuredGrid()
    copy.DeepCopy(reader.GetOutput())
    return copy


def ghosts_of(data, count):
    array = data.GetArray(vtkDataSetAttributes.GhostArrayName())
    return vtk_to_numpy(array) if count else np.zeros(0, np.uint8)


def check_piece(piece, whole_points, cells_of_whole):
    """Every cell of the piece is that of the whole, values and all."""
    ids = ids_of(piece.GetPointData(), "point")
    assert np.array_equal(gm.coordinates(piece).view(np.uint32), points[ids].view(np.uint32))
    if len(ids):
        assert np.array_equal(ids_of(piece.GetPointData(), "wave"), np.sin(5 * points)[ids])
    cells = ids_of(piece.GetCellData(), "cell")
    corners = ids[gm.connectivity(piece)] if len(cells) else np.zeros((0, 4), int)
    assert np.array_equal(gm.turned(corners) if len(cells) else corners, cells_of_whole[cells])
    return ids, cells


def boundary(grid_or_tets):
    """Number of faces of only one tetrahedron."""
    faces = np.concatenate([grid_or_tets[:, list(f)] for f in ((0, 1, 2), (0, 1, 3), (0, 2, 3),
                                                               (1, 2, 3))])
    _, count = np.unique(np.sort(faces, 1), axis=0, return_counts=True)
    return (count == 1).sum()


turned = gm.turned(tets)
for keep in (0, 7):
    writer = gm.write(grid, path, KeepOrder=keep, ChunkSize=300)
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    table = info.Get(vtkGatunReader.CHUNK_TABLE())
    assert table is reader.GetChunkTable()
    chunks = table.GetNumberOfRows()
    assert chunks >= 20

    # The whole has no ids of ours unless asked for.
    reader.Update()
    whole = vtkUnstructuredGrid()
    whole.DeepCopy(reader.GetOutput())
    assert not whole.GetPointData().HasArray("GlobalPointIds")
    reader.GenerateGlobalIdsOn()
    reader.Update()
    assert reader.GetOutput().GetPointData().GetGlobalIds().GetName() == "GlobalPointIds"
    whole_global = ids_of(reader.GetOutput().GetPointData(), "GlobalPointIds")
    expected = ids_of(whole.GetPointData(), "point") if keep else np.arange(len(points))
    assert np.array_equal(whole_global, expected)
    whole_cells = ids_of(reader.GetOutput().GetCellData(), "GlobalCellIds")
    expected = ids_of(whole.GetCellData(), "cell") if keep else np.arange(len(tets))
    assert np.array_equal(whole_cells, expected)
    reader.GenerateGlobalIdsOff()
    global_of_point = dict(zip(ids_of(whole.GetPointData(), "point"), whole_global))
    global_of_cell = dict(zip(ids_of(whole.GetCellData(), "cell"), whole_cells))

    for pieces in (1, 2, 3, 7, chunks, chunks + 5):
        for ghosts in (0, 1, 2):
            seen_points, seen_cells, owned_points, surface = [], [], 0, 0
            for p in range(pieces):
                piece = piece_of(reader, p, pieces, ghosts)
                ids, cells = check_piece(piece, points, turned)
                if pieces > 1:
                    # Global ids are the same for everyone.
                    own = ids_of(piece.GetPointData(), "GlobalPointIds")
                    assert np.array_equal(own, [global_of_point[i] for i in ids])
                    own = ids_of(piece.GetCellData(), "GlobalCellIds")
                    assert np.array_equal(own, [global_of_cell[i] for i in cells])
                if ghosts and pieces > 1:
                    cell_ghosts = ghosts_of(piece.GetCellData(), len(cells))
                    point_ghosts = ghosts_of(piece.GetPointData(), len(ids))
                    assert set(cell_ghosts) | set(point_ghosts) <= {0, 1}
                    mine = cells[cell_ghosts == 0]
                    # Ghosts: those that share a point with a cell of the layer within.
                    layer = np.isin(np.arange(len(tets)), mine)
                    for _ in range(ghosts):
                        near = np.zeros(len(points), bool)
                        near[tets[layer]] = True
                        layer = near[tets].any(1)
                    if len(mine):
                        assert set(cells) == set(np.flatnonzero(layer))
                    owned_points += (point_ghosts == 0).sum()
                    surface_filter = vtkDataSetSurfaceFilter()
                    surface_filter.SetInputData(piece)
                    surface_filter.Update()
                    shell = surface_filter.GetOutput()
                    skin = ghosts_of(shell.GetCellData(), shell.GetNumberOfCells()) \
                        if shell.GetCellData().HasArray("vtkGhostType") \
                        else np.zeros(shell.GetNumberOfCells(), np.uint8)
                    surface += (skin == 0).sum()
                    cells = mine
                else:
                    assert not piece.GetCellData().HasArray("vtkGhostType")
                seen_cells.extend(cells)
                seen_points.extend(ids)
            assert sorted(seen_cells) == list(range(len(tets)))
            assert set(seen_points) == set(range(len(points)))
            if pieces == 1:
                assert len(seen_points) == len(points)
            elif ghosts:
                assert owned_points == len(points)
                assert surface == boundary(tets), (surface, boundary(tets))
            else:
                # Without ghosts the seams are open: the check above can fail.
                skin = boundary(tets)
                assert len(seen_points) > len(points) and skin > 0

    # One piece with more and fewer ghosts in turn.
    sizes = []
    for ghosts in (0, 1, 2, 1, 0):
        sizes.append(piece_of(reader, 2, 7, ghosts).GetNumberOfCells())
    assert sizes[0] == sizes[4] < sizes[1] == sizes[3] < sizes[2], sizes

    # Unused points are in piece 0 alone.
    unused = set(range(len(points) - UNUSED, len(points)))
    assert unused <= set(ids_of(piece_of(reader, 0, 5).GetPointData(), "point"))
    assert not unused & set(ids_of(piece_of(reader, 1, 5).GetPointData(), "point"))
    # There is no piece 5 of 5.
    assert piece_of(reader, 5, 5).GetNumberOfPoints() == 0

    # The table.
    cells = vtk_to_numpy(table.GetColumnByName("Cells"))
    first = vtk_to_numpy(table.GetColumnByName("FirstCell"))
    counts = vtk_to_numpy(table.GetColumnByName("Points"))
    bounds = vtk_to_numpy(table.GetColumnByName("Bounds"))
    wave = vtk_to_numpy(table.GetColumnByName("Point:wave"))
    numbers = vtk_to_numpy(table.GetColumnByName("Cell:cell")).reshape(-1)
    assert cells.sum() == len(tets) and (first == np.cumsum(cells) - cells).all()
    assert wave.shape == (chunks, 8)
    for c in range(chunks):
        piece = piece_of(reader, c, chunks)
        at = gm.coordinates(piece)
        used = np.unique(gm.connectivity(piece))
        at = at[used]
        assert piece.GetNumberOfCells() == cells[c] and len(used) == counts[c]
        assert np.array_equal(bounds[c], np.stack([at.min(0), at.max(0)], 1).ravel())
        values = ids_of(piece.GetPointData(), "wave")[used].astype(np.float64)
        length = np.sqrt((values ** 2).sum(1))
        expected = np.stack([values.min(0), values.max(0)], 1).ravel()
        assert np.allclose(wave[c], [*expected, length.min(), length.max()], rtol=1e-15)
        own = ids_of(piece.GetCellData(), "cell")
        assert tuple(numbers.reshape(chunks, -1)[c]) == (own.min(), own.max())
    box = info.Get(pipeline.BOUNDS())
    assert np.array_equal(box, np.stack([points.min(0), points.max(0)], 1).ravel())

    # Two consumers on one port, asking for different parts in turn.
    class Consumer:
        def __init__(self, piece, pieces, ghosts):
            self.filter = vtkDataSetSurfaceFilter()
            self.filter.SetInputConnection(reader.GetOutputPort())
            self.filter.PassThroughCellIdsOn()
            self.request = piece, pieces, ghosts

        def ask(self):
            self.filter.Modified()
            self.filter.UpdatePiece(*self.request)
            return self.filter.GetOutput().GetNumberOfCells(), \
                reader.GetOutput().GetNumberOfCells()

    part, all_of_it = Consumer(0, 4, 0), Consumer(0, 1, 0)
    ghosted = Consumer(1, 4, 1)
    answers = {}
    for turn in range(4):
        for name, consumer in (("part", part), ("whole", all_of_it), ("ghosts", ghosted)):
            answer = consumer.ask()
            assert answers.setdefault(name, answer) == answer
    assert answers["whole"] == (boundary(tets), len(tets))
    assert 0 < answers["part"][1] < answers["ghosts"][1] < len(tets)
    reader.Modified()
    assert [part.ask(), all_of_it.ask(), part.ask()] == \
        [answers["part"], answers["whole"], answers["part"]]

# Flags that the file holds stay: a hidden cell and a hidden point.
flags = np.zeros(len(tets), np.uint8)
flags[5] = vtkDataSetAttributes.HIDDENCELL
gm.add_array(grid.GetCellData(), flags, "vtkGhostType")
flags = np.zeros(len(points), np.uint8)
flags[9] = vtkDataSetAttributes.HIDDENPOINT
gm.add_array(grid.GetPointData(), flags, "vtkGhostType")
gm.write(grid, path, ChunkSize=300)
gm.assert_same_mesh(grid, gm.read(path))
reader = vtkGatunReader()
reader.SetFileName(path)
hidden = 0
for p in range(3):
    piece = piece_of(reader, p, 3, 1)
    cell_flags = ghosts_of(piece.GetCellData(), 1)
    names = ids_of(piece.GetCellData(), "cell")
    assert (names[(cell_flags & vtkDataSetAttributes.HIDDENCELL) > 0] == 5).all()
    hidden += ((cell_flags & 33) == 32).sum()
    assert (cell_flags & 1).any()
assert hidden == 1
