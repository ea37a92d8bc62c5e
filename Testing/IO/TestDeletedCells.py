# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series in which cells die behind a moving front: one mesh is stored, and every step is the grid that
was written, with and without the points of dead cells, in all the ways of reading."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_WEDGE, vtkDataObject

import gatunMeshes as gm
from gatun.vtk import vtkGatunContour, vtkGatunReader, vtkGatunSimplify, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

POINTS, TETS = gm.lattice(8)
CENTERS = POINTS[TETS].mean(axis=1)
# The x behind which cells are dead; they come back at step 4, and are all there again at step 7.
FRONTS = [0, 0, 0.1, 0.3, 0.15, 0.45, 0.45, 0, 0.2]
TIMES = [0.5 * i - 1 for i in range(len(FRONTS))]
MASKS = 6  # meshes as the reader counts them: all cells, and five fronts


def places(step, moves):
    return (POINTS * (1 + 0.03 * step * moves)).astype(np.float32)


def fill(grid, step, point, cell):
    """Values that tell points and cells; dead ones must not be among them."""
    wave = np.sin(3 * POINTS[point].astype(float) + 0.2 * step).sum(axis=1).astype(np.float32)
    gm.add_array(grid.GetPointData(), wave, "wave")
    gm.add_array(grid.GetCellData(), cell * 10 + step, "cell")
    gm.add_array(grid.GetFieldData(), np.array([step * 1.0]), "index")
    return grid


def dying(step, drops=False, moves=False, points=POINTS, tets=TETS, centers=CENTERS):
    alive = np.flatnonzero(centers[:, 0] >= FRONTS[step] * points[:, 0].max())
    kept = np.unique(tets[alive]) if drops else np.arange(len(points))
    number = np.zeros(len(points), int)
    number[kept] = np.arange(len(kept))
    return fill(gm.make_grid(places(step, moves)[kept], number[tets[alive]]), step, kept, alive)


def write(path, make, times=TIMES, **options):
    writer = vtkGatunWriter()
    connect(writer, TimeSource(make, times))
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    for error in options.pop("errors", ()):
        gm.set_tolerance(writer, error)
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    assert gm.statistic(writer, "FileBytes") == os.path.getsize(path)
    return writer


def open_reader(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


def check_pieces(reader, step, expected):
    """Pieces have each remaining cell once, and each point of the step once."""
    for ghosts in (0, 1):
        cells, points = [], []
        for piece in range(3):
            reader.UpdateTimeStep(TIMES[step], piece, 3, ghosts)
            assert reader.GetErrorCode() == 0
            part = reader.GetOutput()
            marks = part.GetCellData().GetArray("vtkGhostType")
            own = vtk_to_numpy(marks) == 0 if marks else np.ones(part.GetNumberOfCells(), bool)
            values = vtk_to_numpy(part.GetCellData().GetArray("cell"))
            cells.append(values[own])
            if ghosts:
                own = vtk_to_numpy(part.GetPointData().GetArray("vtkGhostType")) == 0
                points.append(gm.coordinates(part)[own])
                ids = gm.connectivity(part)
                assert set(values) <= set(vtk_to_numpy(expected.GetCellData().GetArray("cell")))
                for cell, corners in zip(values[:50], ids[:50]):
                    where = gm.coordinates(part)[corners]
                    assert {tuple(p) for p in where} == {
                        tuple(p) for p in places_of[step][TETS[(cell - step) // 10]]}
        found = np.sort(np.concatenate(cells))
        assert (found == np.sort(vtk_to_numpy(expected.GetCellData().GetArray("cell")))).all()
        if ghosts:
            found = np.concatenate(points)
            wanted = gm.coordinates(expected)
            assert len(found) == len(wanted), (step, len(found), len(wanted))
            assert (np.unique(found, axis=0) == np.unique(wanted, axis=0)).all()


path = gm.temporary("deleted_cells.gtn")
rng = np.random.default_rng(5)
sizes = {}
for drops, moves, keep, chunk in ((False, False, 7, 150), (True, False, 7, 150), (True, False, 0, 90),
                                  (False, True, 0, 0), (False, True, 7, 200)):
    places_of = [places(step, moves) for step in range(len(FRONTS))]
    steps = [dying(i, drops, moves) for i in range(len(FRONTS))]
    writer = write(path, lambda i: steps[i], KeepOrder=keep, ChunkSize=chunk)
    assert gm.statistic(writer, "Meshes") == 1 and gm.statistic(writer, "TimeSteps") == len(TIMES)
    assert gm.statistic(writer, "Cells") == len(TETS) and gm.statistic(writer, "OtherMeshBytes") == 0
    sizes[drops, moves, keep, chunk] = gm.statistic(writer, "FileBytes")
    for budget in (512, 0):
        reader = open_reader(path, MemoryBudget=budget)
        for step in [*range(len(FRONTS)), *rng.permutation(len(FRONTS))]:
            reader.UpdateTimeStep(TIMES[step])
            assert reader.GetErrorCode() == 0
            grid = reader.GetOutput()
            assert grid.GetNumberOfPoints() == steps[step].GetNumberOfPoints()
            assert grid.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == TIMES[step]
            (gm.assert_equal if keep else gm.assert_same_mesh)(steps[step], grid)
            gm.assert_same_field(steps[step].GetFieldData(), grid.GetFieldData())
            cells = vtk_to_numpy(reader.GetChunkTable().GetColumnByName("Cells"))
            assert cells.sum() == grid.GetNumberOfCells()
    reader = open_reader(path)
    for step in (5, 0, 2):
        check_pieces(reader, step, steps[step])

    # On demand, and in a program of filters.
    demand = open_reader(path, LargeMesh=0)
    for source in demand, open_reader(path):
        contour = vtkGatunContour()
        contour.SetInputConnection(source.GetOutputPort())
        contour.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        contour.SetValue(0, 0.8)
        for step in (0, 3, 5, 8):
            expected = vtkGatunContour()
            expected.SetInputData(steps[step])
            expected.SetInputArrayToProcess(0, 0, 0, 0, "wave")
            expected.SetValue(0, 0.8)
            expected.Update()
            contour.UpdateTimeStep(TIMES[step])
            surface, wanted = contour.GetOutput(), expected.GetOutput()
            assert surface.GetNumberOfCells() == wanted.GetNumberOfCells() > 0
            found, values = (np.sort(vtk_to_numpy(s.GetCellData().GetArray("cell")))
                             for s in (surface, wanted))
            assert (found == values).all()
            found, values = (np.sort(np.round(vtk_to_numpy(s.GetPoints().GetData()), 4), axis=0)
                             for s in (surface, wanted))
            assert np.abs(found - values).max() < 2e-4
    assert demand.GetIsOnDemand()

    # A region of interest has remaining cells only.
    reader.SetBox(0, 0.2, 0, 2, 0, 2)
    for step in (0, 2, 3):
        reader.UpdateTimeStep(TIMES[step])
        values = set(vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("cell")))
        assert values <= set(vtk_to_numpy(steps[step].GetCellData().GetArray("cell")))
        assert len(values) < len(TETS) or not chunk  # of one chunk
    reader.SetBox(1, -1, 1, -1, 1, -1)

    # What is left can be simplified.
    simplify = vtkGatunSimplify()
    reader = open_reader(path)
    simplify.SetInputConnection(reader.GetOutputPort())
    simplify.SetSimplificationRatio(0.5)
    for step in (0, 5):
        simplify.UpdateTimeStep(TIMES[step])
        assert simplify.GetErrorCode() == 0
        ratio = simplify.GetOutput().GetNumberOfPoints() / steps[step].GetNumberOfPoints()
        assert abs(ratio - 0.5) < 0.15

# Values have an error, the cells have not. Dead cells do not count for ranges.
write(path, lambda i: dying(i, True), errors=["wave=abs:0.01"], ChunkSize=150)
reader = open_reader(path, LargeMesh=0)
whole = open_reader(path)
for step in (0, 5, 4):
    whole.UpdateTimeStep(TIMES[step])
    grid, wanted = whole.GetOutput(), dying(step, True)
    assert (np.sort(vtk_to_numpy(grid.GetCellData().GetArray("cell"))) ==
            vtk_to_numpy(wanted.GetCellData().GetArray("cell"))).all()
    assert abs(np.sort(vtk_to_numpy(grid.GetPointData().GetArray("wave"))) - np.sort(
        vtk_to_numpy(wanted.GetPointData().GetArray("wave")))).max() <= 0.01
    reader.UpdateTimeStep(TIMES[step])
    outline = reader.GetOutput().GetCellData().GetArray("cell")
    if outline:
        assert outline.GetRange() == grid.GetCellData().GetArray("cell").GetRange()


# Cells of other types, as they are and as tetrahedra.
def other(step, drops=False):
    n = 6
    points = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), -1).reshape(-1, 3) * 1.1
    at = np.arange((n + 1) ** 3).reshape([n + 1] * 3)
    cells = []
    for number, (i, j, k) in enumerate(np.ndindex(n, n, n)):
        corners = [at[i, j, k], at[i + 1, j, k], at[i + 1, j + 1, k], at[i, j + 1, k]]
        corners += [c + 1 for c in corners]
        if k == 2:
            cells.append((number, VTK_WEDGE, [corners[c] for c in (0, 1, 2, 4, 5, 6)]))
        else:
            cells.append((number, VTK_HEXAHEDRON, corners))
    cells = [cell for cell in cells if cell[0] // (n * n) >= FRONTS[step] * n]
    kept = sorted({p for cell in cells for p in cell[2]}) if drops else list(range(len(points)))
    number = {p: i for i, p in enumerate(kept)}
    grid = gm.make_grid(points[kept], np.zeros((0, 4), int))
    grid.Allocate()
    for _, kind, corners in cells:
        grid.InsertNextCell(kind, len(corners), [number[c] for c in corners])
    gm.add_array(grid.GetPointData(), (points[kept, 0] * step).astype(np.float32), "wave")
    gm.add_array(grid.GetCellData(), np.array([c[0] for c in cells]), "cell")
    return grid


for drops in (False, True):
    for keep in (7, 0):
        writer = write(path, lambda i: other(i, drops), KeepOrder=keep, ChunkSize=100)
        assert gm.statistic(writer, "Meshes") == 1
        reader, split = open_reader(path), open_reader(path, SplitCells=True)
        for step in (0, 3, 8, 5, 7):
            reader.UpdateTimeStep(TIMES[step])
            found, expected = reader.GetOutput(), other(step, drops)
            if keep:
                gm.assert_equal(expected, found)
            assert found.GetNumberOfPoints() == expected.GetNumberOfPoints()
            values = [np.sort(vtk_to_numpy(grid.GetCellData().GetArray("cell")))
                      for grid in (found, expected)]
            assert (values[0] == values[1]).all()
            split.UpdateTimeStep(TIMES[step])
            values = vtk_to_numpy(split.GetOutput().GetCellData().GetArray("cell"))
            wanted = vtk_to_numpy(other(step, drops).GetCellData().GetArray("cell"))
            assert set(values) == set(wanted)
            # Five or six tetrahedra a hexahedron, three a wedge.
            counts = dict(zip(*np.unique(values, return_counts=True)))
            assert all(counts[c] == 3 if c % 6 == 2 else counts[c] in (5, 6) for c in wanted)

# A mesh that has some of the cells, but not in this way, is another mesh.
order = rng.permutation(len(TETS))


def shuffled(step):
    return dying(step, tets=TETS[order], centers=CENTERS[order]) if step % 2 else dying(step)


assert gm.statistic(write(path, shuffled), "Meshes") == 2  # each order has masks of its own
reader = open_reader(path)
for step in range(len(FRONTS)):
    reader.UpdateTimeStep(TIMES[step])
    assert reader.GetOutput().GetNumberOfCells() == dying(step).GetNumberOfCells()
assert gm.statistic(write(path, dying, Hierarchy=True), "Meshes") == 6
assert gm.statistic(write(path, dying, WriteBoundary=True), "Meshes") == 6
reader = open_reader(path)
for step in (0, 5, 4):
    reader.UpdateTimeStep(TIMES[step])
    gm.assert_same_mesh(dying(step), reader.GetOutput())
FRONTS[8] = 0.7  # fewer than half of the cells
assert gm.statistic(write(path, dying), "Meshes") == 2
reader = open_reader(path)
for step in (8, 0, 5):
    reader.UpdateTimeStep(TIMES[step])
    gm.assert_same_mesh(dying(step), reader.GetOutput())
FRONTS[8] = 0.2

# An application that changes its grid in place loses nothing.
grid = dying(0)


def in_place(step):
    new = dying(step)  # also step 0, which is asked for again when points have moved
    vtk_to_numpy(grid.GetPoints().GetData())[:] = places(step, True)
    grid.GetPoints().Modified()
    grid.SetCells(10, new.GetCells())
    for name in "GetPointData", "GetCellData", "GetFieldData":
        getattr(grid, name)().DeepCopy(getattr(new, name)())
    return grid


write(path, in_place, TIMES[:5])
reader = open_reader(path)
for step in (4, 0, 2):
    reader.UpdateTimeStep(TIMES[step])
    assert reader.GetErrorCode() == 0
    gm.assert_same_mesh(dying(step, moves=step > 0), reader.GetOutput())
