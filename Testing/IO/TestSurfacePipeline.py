# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces in pieces, with ghost cells, in time, chosen arrays, regions and on demand."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunFileHandle, vtkGatunWriter
from gatunPieceSource import PieceSource, write_pieces
from gatunTimeSource import TimeSource, connect

surface = pd.add_arrays(pd.mixed(40))
path = gm.temporary("pipeline.gtn")
gm.write(surface, path, ChunkSize=100)
whole = pd.read(path, GenerateGlobalIds=True)

# Pieces without their ghosts are the whole; with ghosts, each has its neighbors around it.
PIECES = 5
seen, used = [], []
for piece in range(PIECES):
    reader = pd.reader_of(path)
    reader.UpdatePiece(piece, PIECES, 0)
    alone = reader.GetOutput()
    count = alone.GetNumberOfCells()
    seen += gm.values_of(alone.GetCellData().GetArray("cell")).ravel().tolist()
    reader.UpdatePiece(piece, PIECES, 1)
    output = reader.GetOutput()
    ghosts = gm.values_of(output.GetCellData().GetArray("vtkGhostType")).ravel()
    assert (ghosts & 1 == 0).sum() == count and (ghosts & 1).any(), piece
    cells = gm.values_of(output.GetCellData().GetArray("cell")).ravel()
    own = [ids for ids, ghost in zip(sum(pd.cells_of(output), []), ghosts) if not ghost & 1]
    names = gm.values_of(output.GetPointData().GetArray("point")).ravel()
    used.append((cells[ghosts & 1 == 0].tolist(), [names[ids].tolist() for ids in own]))
assert sorted(seen) == list(range(surface.GetNumberOfCells()))
# Cells of all lists have their own values: the number of each cell of the input tells its points.
# Triangles may begin with any of them.
listed = sum(pd.cells_of(surface), [])
before = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
triangles = {before + i for i, ids in enumerate(pd.cells_of(surface)[2]) if len(ids) == 3}
for cells, points in used:
    for cell, ids in zip(cells, points):
        turns = [listed[cell]]
        if cell in triangles:
            turns = [ids[i:] + ids[:i] for ids in turns for i in range(3)]
        assert ids in turns, cell
assert gm.roles_of(whole.GetCellData())[5] == "GlobalCellIds"

# Arrays.
reader = pd.reader_of(path)
reader.UpdateInformation()
assert reader.GetNumberOfPointArrays() == 4 and reader.GetNumberOfCellArrays() == 2
reader.SetPointArrayStatus("colors", 0)
reader.SetCellArrayStatus("cell", 0)
reader.Update()
output = reader.GetOutput()
assert not output.GetPointData().HasArray("colors") and output.GetPointData().GetNormals()
assert [a.GetName() for a in gm.arrays_of(output.GetCellData())] == ["of faces"]
decoded = gm.statistic(reader, "DecodedChunks")
assert decoded > 5 and output.GetPolys().GetNumberOfCells() == surface.GetNumberOfPolys()

# A region is made of the chunks that touch it.
part = pd.read(path, Box=(0, 5, 0, 5, -9, 9))
assert 0 < part.GetNumberOfCells() < surface.GetNumberOfCells()
part = pd.read(path, ValueRangeArray="point", ValueRange=(0, 10))
assert 0 < part.GetNumberOfCells() < surface.GetNumberOfCells()

# On demand, the output is an outline with the ranges of the arrays.
reader = pd.reader_of(path, LargeMesh=0)
reader.Update()
outline = reader.GetOutput()
assert isinstance(outline, vtkPolyData) and outline.GetNumberOfLines() == 12
assert outline.GetBounds() == surface.GetBounds() and reader.GetIsOnDemand()
assert outline.GetInformation().Has(reader.ON_DEMAND())
assert gm.statistic(reader, "DecodedChunks") == 0
for size, expected in ((10, True), (surface.GetNumberOfCells(), False), (-1, False)):
    reader.SetLargeMesh(size)
    reader.Update()
    assert reader.GetIsOnDemand() == expected, size
    assert (reader.GetOutput().GetNumberOfCells() == 12) == expected
handle = reader.GetOutputInformation(0).Get(vtkGatunFileHandle.FILE_HANDLE())
assert handle.GetIsOpen() and handle.GetNumberOfPoints() == surface.GetNumberOfPoints()

# Steps share their cells, and values move.
TIMES = [0.5, 1.0, 4.0]


def step(index):
    moved = vtkPolyData()
    moved.ShallowCopy(surface)
    number = np.arange(surface.GetNumberOfCells(), dtype=np.int64)
    gm.add_array(moved.GetCellData(), number * 2 + index, "rising")
    return moved


writer = vtkGatunWriter()
connect(writer, TimeSource(step, TIMES, "vtkPolyData"))
writer.SetFileName(path)
writer.SetWriteAllTimeSteps(True)
writer.SetKeepOrder(7)
assert writer.Write() == 1 and gm.statistic(writer, "TimeSteps") == 3
reader = pd.reader_of(path)
kept = None
for index in (1, 2, 0):
    reader.UpdateTimeStep(TIMES[index])
    output = reader.GetOutput()
    assert output.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == TIMES[index]
    pd.assert_equal(step(index), output)
    polygons = output.GetPolys()
    assert kept is None or kept is polygons
    kept = polygons

# Written in pieces, the surface is one again: points on boundaries are joined.
sheet = pd.wave(40)
sheet_points = gm.vtk_to_numpy(sheet.GetPoints().GetData())
polygons = pd.cells_of(sheet)[2]


def make_piece(piece, pieces, _step):
    chosen = polygons[piece * len(polygons) // pieces:(piece + 1) * len(polygons) // pieces]
    ids = sorted({i for cell in chosen for i in cell})
    place = {i: n for n, i in enumerate(ids)}
    made = pd.make(sheet_points[ids], Polys=[[place[i] for i in cell] for cell in chosen])
    gm.add_array(made.GetPointData(), sheet_points[ids, 2], "height")
    return made


messages = write_pieces(PieceSource(make_piece, (), "vtkPolyData"), path, 1, NumberOfPieces=4)
joined = pd.read(path)
sheet.GetPointData().Initialize()
gm.add_array(sheet.GetPointData(), np.ascontiguousarray(sheet_points[:, 2]), "height")
used = np.unique([i for cell in polygons for i in cell])
assert joined.GetNumberOfPoints() == len(used), (joined.GetNumberOfPoints(), len(used))
assert pd.canonical(joined)[1] == pd.canonical(sheet)[1]
