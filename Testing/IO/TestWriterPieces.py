# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A writer that asks its input for one piece after the other writes the mesh that the whole input
is: of sources that know pieces, of parallel files, of a reader, and of sources that know none."""

import os

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridWriter

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunWriter
from gatunPieceSource import PieceSource, mark_ghosts, write_pieces

PIECES = 6
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "writer-pieces")
os.makedirs(folder, exist_ok=True)
for name in os.listdir(folder):
    os.remove(os.path.join(folder, name))
path = os.path.join(folder, "pieces.gtn")


whole = gm.block(n=7)
owner = np.random.default_rng(5).integers(0, PIECES - 1, whole.GetNumberOfCells())  # one is empty


def piece_of(grid, piece, pieces):
    return gm.part_of(grid, owner == piece) if pieces > 1 else grid


def write(source, expected=1, **options):
    return write_pieces(source, path, expected, **{"NumberOfPieces": PIECES, **options})


# The mesh of the whole, with each piece asked for twice, and none after it was left.
source = PieceSource(lambda piece, pieces, step: piece_of(whole, piece, pieces))
writer, messages = write(source)
assert not messages, messages
assert source.asked == 2 * [(piece, 0) for piece in range(PIECES)], source.asked
gm.assert_same_mesh(gm.read(path), whole)
assert gm.statistic(writer, "Points") == whole.GetNumberOfPoints()
assert gm.statistic(writer, "Cells") == whole.GetNumberOfCells()
assert gm.statistic(writer, "FileBytes") == os.path.getsize(path)

# The boundary is that of the whole.
_, messages = write(source, WriteBoundary=True)
assert not messages, messages
boundary = gm.read(path, LargeMesh=1)
surface = vtkDataSetSurfaceFilter()
surface.SetInputData(whole)
surface.Update()
assert boundary.GetNumberOfCells() == surface.GetOutput().GetNumberOfCells() > 0

# The points to join by an array of numbers: a number of -1 is that of a point of this piece alone.
numbered = gm.block(n=7)
gm.add_array(numbered.GetPointData(), np.arange(numbered.GetNumberOfPoints()), "number")
apart = gm.block(n=7)
gm.add_array(apart.GetPointData(), np.full(apart.GetNumberOfPoints(), -1), "number")
for grid, joined in ((numbered, True), (apart, False)):
    def marked(piece, pieces, step, grid=grid):
        part = piece_of(grid, piece, pieces)
        part.GetPointData().GetArray("number").GetInformation().Set(vtkGatunWriter.JOIN_POINTS(), 1)
        return part

    writer, messages = write(PieceSource(marked))
    assert not messages, messages
    assert (gm.statistic(writer, "Points") == whole.GetNumberOfPoints()) == joined
    assert gm.statistic(writer, "Cells") == whole.GetNumberOfCells()
    assert not gm.read(path).GetPointData().HasArray("number")
    if joined:
        gm.assert_same_mesh(gm.read(path), whole)
# Numbers that are none, and pieces that differ.
for name, marked, says in (("wave", range(PIECES), "array 'wave' of piece 0 has no integers"),
                           ("number", [0], "piece 1 has no point array to join by"),
                           ("number", [1, 2], "piece 1 has a point array to join by")):
    def make(piece, pieces, step):
        grid = piece_of(numbered, piece, pieces)
        for i in range(grid.GetPointData().GetNumberOfArrays()):
            array = grid.GetPointData().GetArray(i)
            key = vtkGatunWriter.JOIN_POINTS()
            array.GetInformation().Set(key, int(array.GetName() == name and piece in marked))
        return grid

    messages = write(PieceSource(make), 0)[1]
    assert says in messages[0], messages

# Time steps: those of a piece follow each other.
steps = [gm.block(n=7) for _ in range(3)]
for step, grid in enumerate(steps):
    gm.add_array(grid.GetPointData(), gm.coordinates(grid)[:, 0] * step, "moving")
source = PieceSource(lambda piece, pieces, step: piece_of(steps[step], piece, pieces), [0., .5, 2.])
writer, messages = write(source, WriteAllTimeSteps=True)
assert not messages, messages
assert source.asked == 2 * [(p, s) for p in range(PIECES) for s in range(3)], source.asked
assert gm.statistic(writer, "TimeSteps") == 3
reader = vtkGatunReader()
reader.SetFileName(path)
for step, time in enumerate([0., .5, 2.]):
    reader.UpdateTimeStep(time)
    gm.assert_same_mesh(reader.GetOutput(), steps[step])

# Ghost cells and marks of points that other pieces own are not written, and the number is told.


def with_ghosts(piece, pieces):
    """The piece with a third of the cells of the next one as ghosts."""
    extra = (owner == (piece + 1) % (PIECES - 1)) & (np.arange(len(owner)) % 3 == 0)
    wanted = (owner == piece) | extra
    return mark_ghosts(gm.part_of(whole, wanted), extra[wanted])


_, messages = write(PieceSource(lambda piece, pieces, step: with_ghosts(piece, pieces)))
ghosts = sum(np.count_nonzero((owner == (piece + 1) % (PIECES - 1)) & (np.arange(len(owner)) % 3 == 0))
             for piece in range(PIECES))
assert len(messages) == 1 and f"{ghosts} ghost cells are left out" in messages[0], messages
gm.assert_same_mesh(gm.read(path), whole)

# Points with other values stay apart, with a warning; global ids decide.


def with_owner(piece, pieces, step):
    grid = piece_of(whole, piece, pieces)
    gm.add_array(grid.GetPointData(), np.full(grid.GetNumberOfPoints(), piece), "piece")
    return grid


_, messages = write(PieceSource(with_owner))
assert len(messages) == 1 and "are kept apart" in messages[0], messages
assert gm.read(path).GetNumberOfPoints() > whole.GetNumberOfPoints()


def with_ids(piece, pieces, step):
    grid = vtkUnstructuredGrid()
    grid.ShallowCopy(piece_of(whole, piece, pieces))
    ids = gm.values_of(grid.GetPointData().GetArray("point")).ravel()
    gm.add_array(grid.GetPointData(), ids.astype(np.int64), "ids", c.VTK_ID_TYPE)
    grid.GetPointData().SetActiveGlobalIds("ids")
    return grid


_, messages = write(PieceSource(with_ids))
assert not messages, messages
gm.assert_same_mesh(gm.read(path), with_ids(0, 1, 0))

# Arrays in another order are the same arrays; missing and additional ones are errors.


def turned_around(piece, pieces, step):
    grid = piece_of(whole, piece, pieces)
    if piece % 2:
        arrays = gm.arrays_of(grid.GetPointData())
        grid.GetPointData().Initialize()
        for array in reversed(arrays):
            grid.GetPointData().AddArray(array)
    return grid


write(PieceSource(turned_around))
gm.assert_same_mesh(gm.read(path), whole)
before = open(path, "rb").read()


def refuse(make, text, times=(), **options):
    writer, messages = write(PieceSource(make, times), 0, **options)
    assert writer.GetErrorCode() == vtkGatunErrorCode.InvalidInputError, messages
    assert len(messages) == 1 and text in messages[0] and path in messages[0], messages
    assert open(path, "rb").read() == before
    assert os.listdir(folder) == ["pieces.gtn"], os.listdir(folder)


def without_wave(piece, pieces, step):
    grid = piece_of(whole, piece, pieces)
    if piece == 2:
        grid.GetPointData().RemoveArray("wave")
    return grid


def with_other(piece, pieces, step):
    grid = piece_of(whole, piece, pieces)
    if piece == 3:
        gm.add_array(grid.GetCellData(), np.zeros(grid.GetNumberOfCells()), "other")
    return grid


calls = []


def changing(piece, pieces, step):
    calls.append(piece)
    grid = piece_of(whole, piece, pieces)
    if len(calls) > PIECES and piece == 1:
        gm.values_of(grid.GetPointData().GetArray("wave"))[3] += 1
        grid.GetPointData().GetArray("wave").SetValue(3, -7)
    return grid


refuse(without_wave, "piece 2 has no point array 'wave'")
refuse(with_other, "piece 3 has an array 'other'")
refuse(changing, "the values of part 1 have changed")
refuse(lambda piece, pieces, step: piece_of(whole, (piece + step) % 2, pieces),
       "of piece 0 change with time", [0., 1.], WriteAllTimeSteps=True)
refuse(lambda *_: whole, "need the whole mesh", Layers="wave")

# A reader of the same kind of file, and parallel files of VTK.
gm.write(whole, os.path.join(folder, "whole.gtn"), ChunkSize=300)
reader = vtkGatunReader()
reader.SetFileName(os.path.join(folder, "whole.gtn"))
_, messages = write(reader)
assert not messages, messages
made = ("GlobalPointIds", "GlobalCellIds")  # by the reader, for pieces
gm.assert_same_mesh(gm.read(path), whole, made)

names = []
for piece in range(PIECES - 1):
    xml = vtkXMLUnstructuredGridWriter()
    xml.SetInputDataObject(piece_of(whole, piece, PIECES))
    names.append(f"part{piece}.vtu")
    xml.SetFileName(os.path.join(folder, names[-1]))
    xml.Write()
declare = "".join(
    f'<PDataArray type="{kind}" Name="{name}" NumberOfComponents="{n}"/>'
    for kind, name, n in (("Int32", "point", 1), ("Float32", "wave", 1), ("Float64", "vector", 3)))
parallel = os.path.join(folder, "parts.pvtu")
with open(parallel, "w", encoding="ascii") as file:
    file.write(f"""<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"
 header_type="UInt32" compressor="vtkZLibDataCompressor"><PUnstructuredGrid GhostLevel="0">
<PPointData>{declare}</PPointData>
<PCellData><PDataArray type="Int64" Name="cell" NumberOfComponents="1"/></PCellData>
<PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="3"/></PPoints>
{"".join(f'<Piece Source="{name}"/>' for name in names)}
</PUnstructuredGrid></VTKFile>""")
reader = vtkXMLPUnstructuredGridReader()
reader.SetFileName(parallel)
for pieces in (PIECES - 1, 9):
    _, messages = write(reader, NumberOfPieces=pieces)
    assert not messages, messages
    gm.assert_same_mesh(gm.read(path), whole)
# The points of two files in one piece are not joined by the reader, and are no cracks.
_, messages = write(reader, NumberOfPieces=2)
assert len(messages) == 1 and "with global ids they would be joined" in messages[0], messages
assert gm.read(path).GetNumberOfCells() == whole.GetNumberOfCells()

# Nothing at all in any piece.
write(PieceSource(lambda *_: vtkUnstructuredGrid()))
assert gm.read(path).GetNumberOfPoints() == 0
