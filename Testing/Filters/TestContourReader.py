# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunContour behind a vtkGatunReader: goes to the file by itself and leaves the reader alone; but
the surface is that of what the reader would give."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkContourGrid, vtkElevationFilter

import gatunContours as gc
import gatunMeshes as gm
import gatunTimeSource
from gatun.vtk import vtkGatunWriter

points, tets = gm.lattice(18, seed=3)


def wave_of(step=0.0):
    return (np.sin(4 * points[:, 0] + step) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2).astype(
        np.float32)


def make_grid(step=0.0):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), wave_of(step), "wave")
    gm.add_array(grid.GetPointData(), points * (1 + step), "place")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    gm.add_array(grid.GetCellData(), (np.arange(len(tets)) % 7).astype(np.int8), "material")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


grid = make_grid()
DECODED = {"RestoreOrder": False}  # so that corners come as they are in the file

for kind, options in gc.kinds_of_files("wave").items():
    path = gm.temporary("behind-%s.gtn" % kind)
    gm.write(grid, path, ChunkSize=500, **options)
    whole = gm.read(path)
    chunks = gc.open_file(path)
    chunks.UpdateInformation()
    chunks = chunks.GetChunkTable().GetNumberOfRows()
    assert chunks > 50

    # The reader decodes nothing; only some chunks of the file are looked at.
    reader = gc.open_file(path)
    contour = gc.make_contour(reader, 0.4, "wave")
    contour.Update()
    assert gc.assert_same(contour.GetOutput(), gc.reference(whole, 0.4, "wave")) > 1000
    assert gm.statistic(reader, "DecodedChunks") == 0 and reader.GetOutput().GetNumberOfCells() == 0
    assert gm.statistic(contour, "Chunks") == chunks
    used, few = gm.statistic(contour, "UsedChunks"), gm.statistic(contour, "BytesRead")
    assert 0 < used < chunks and 0 < gm.statistic(contour, "UsedTetrahedra") <= 500 * used
    everything = gc.open_file(path)
    everything.Update()
    assert few < gm.statistic(everything, "BytesRead")

    # The same sections as those of the mesh that was written.
    ours, theirs = gc.polygons(contour.GetOutput()), gc.polygons(gc.reference(grid, 0.4, "wave"))
    assert ours[0] == theirs[0] and len(ours[0]) > 1000
    np.testing.assert_array_equal(ours[1], theirs[1])

    # Other values read what they need more, the same ones nothing.
    contour.SetValue(0, 0.41)
    contour.Update()
    more = gm.statistic(contour, "BytesRead")
    assert few <= more < gm.statistic(everything, "BytesRead")
    contour.SetValue(0, 0.4)
    contour.Update()
    assert gm.statistic(contour, "BytesRead") == more and gm.statistic(contour, "UsedChunks") == used
    low, high = whole.GetPointData().GetArray("wave").GetRange()
    contour.SetValue(0, low)
    contour.Update()
    assert contour.GetOutput().GetNumberOfCells() == 0 and contour.GetErrorCode() == 0
    assert gm.statistic(contour, "UsedChunks") == gm.statistic(contour, "UsedTetrahedra") == 0
    contour.SetValue(0, high + 1)
    contour.Update()
    assert gm.statistic(contour, "UsedChunks") == 0 and gm.statistic(contour, "BytesRead") == more
    reader.SetMemoryBudget(0)  # for both, and at once
    contour.SetValue(0, 0.4)
    contour.Update()
    assert gm.statistic(contour, "BytesRead") > more
    gc.assert_same(contour.GetOutput(), gc.reference(whole, 0.4, "wave"))

    # The output of the reader stays as it is, and is not decoded again. The whole mesh is not kept
    # beside the output, so the first isosurface reads its chunks.
    reader = gc.open_file(path)
    reader.Update()
    held, bytes_read, decoded = reader.GetOutput(), gm.statistic(reader, "BytesRead"), gm.statistic(reader, "DecodedChunks")
    time = held.GetUpdateTime()
    contour = gc.make_contour(reader, 0.4, "wave")
    for isovalue in (0.4, 0.2):
        contour.SetValue(0, isovalue)
        contour.Update()
        gc.assert_same(contour.GetOutput(), gc.reference(whole, isovalue, "wave"))
        assert reader.GetOutput().GetNumberOfCells() == len(tets)
        assert reader.GetOutput().GetUpdateTime() == time
        assert gm.statistic(reader, "DecodedChunks") == decoded and gm.statistic(reader, "BytesRead") > bytes_read
    # A piece of it, too.
    reader.UpdatePiece(1, 4, 1)
    cells = reader.GetOutput().GetNumberOfCells()
    assert 0 < cells < len(tets)
    contour.SetValue(0, 0.3)
    contour.Update()
    assert contour.GetOutput().GetNumberOfCells() > 1000
    assert reader.GetOutput().GetNumberOfCells() == cells
    gc.assert_same(contour.GetOutput(), gc.reference(whole, 0.3, "wave"))
    # And the other way round: after the contour, whoever asks the reader gets the mesh. (Update of the
    # reader itself asks for what was asked for last, as in every pipeline, which is no piece at all.)
    reader = gc.open_file(path)
    contour = gc.make_contour(reader, 0.4, "wave")
    contour.Update()
    other = vtkContourGrid()
    other.SetInputConnection(reader.GetOutputPort())
    other.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    other.SetValue(0, 0.4)
    other.Update()
    # Of left-handed tetrahedra, those of vtkContourGrid have their fronts on the other side.
    gc.assert_same(contour.GetOutput(), other.GetOutput(), fronts=False)
    reader.UpdatePiece(0, 1, 0)
    gm.assert_same_mesh(reader.GetOutput(), grid)

    # Pieces: each triangle in one, whatever their number; points where they meet in both.
    one = gc.contour_of(gc.open_file(path), [0.2, 0.4], "wave", ComputeNormals=True)
    rows = gc.canonical(one)[1:]
    normals = {tuple(p): tuple(n) for p, n in zip(
        gc.points_of(one), vtk_to_numpy(one.GetPointData().GetNormals()))}
    for pieces in (2, 3, 8, 500):
        reader = gc.open_file(path)
        contour = gc.make_contour(reader, [0.2, 0.4], "wave", ComputeNormals=True)
        cells, count, largest = [], 0, 0
        for piece in range(pieces):
            contour.UpdatePiece(piece, pieces, 0)
            output = contour.GetOutput()
            if output.GetNumberOfCells() == 0:
                continue
            gc.assert_whole(output)
            count += output.GetNumberOfCells()
            largest = max(largest, output.GetNumberOfCells())
            for p, n in zip(gc.points_of(output), vtk_to_numpy(output.GetPointData().GetNormals())):
                assert normals[tuple(p)] == tuple(n)
            # Triangles by their places and cells.
            corners = gc.points_of(output)[gc.triangles_of(output)].reshape(-1, 9)
            cells.append(np.concatenate(
                [corners, vtk_to_numpy(output.GetCellData().GetArray("cell"))[:, None]], 1))
        assert gm.statistic(reader, "DecodedChunks") == 0
        assert count == one.GetNumberOfCells() and largest < 4 * count / min(pieces, 40)
        corners = gc.points_of(one)[gc.triangles_of(one)].reshape(-1, 9)
        expected = np.concatenate(
            [corners, vtk_to_numpy(one.GetCellData().GetArray("cell"))[:, None]], 1)
        found = np.concatenate(cells)
        np.testing.assert_array_equal(
            found[np.lexsort(found.T)], expected[np.lexsort(expected.T)])

    # Behind another filter, pieces come from memory. Ghost cells make the normals those of the whole.
    behind = vtkElevationFilter()
    reader = gc.open_file(path)
    behind.SetInputConnection(reader.GetOutputPort())
    contour = gc.make_contour(behind, [0.2, 0.4], "wave", ComputeNormals=True)
    count = 0
    for piece in range(3):
        contour.UpdatePiece(piece, 3, 0)
        output = contour.GetOutput()
        count += output.GetNumberOfCells()
        for p, n in zip(gc.points_of(output), vtk_to_numpy(output.GetPointData().GetNormals())):
            np.testing.assert_allclose(normals[tuple(p)], n, atol=1e-6)
    assert count == one.GetNumberOfCells()

    # A reader on demand, whose output is an outline.
    reader = gc.open_file(path, LargeMesh=0)
    gc.assert_same(gc.contour_of(reader, 0.4, "wave"), gc.reference(whole, 0.4, "wave"))
    assert gm.statistic(reader, "DecodedChunks") == 0

    # A region of interest: then the surface is that of what the reader gives.
    for limits in ({"Box": (0, 0.4, 0, 0.5, 0, 1)},
                   {"ValueRangeArray": "wave", "ValueRange": (0.1, 0.2)}):
        reader = gc.open_file(path, **limits)
        contour = gc.make_contour(reader, [0.15, 0.5], "wave")
        contour.Update()
        mesh = gm.read(path, **limits)
        assert 0 < mesh.GetNumberOfCells() < len(tets)
        assert gc.assert_same(contour.GetOutput(), gc.reference(mesh, [0.15, 0.5], "wave")) > 300
        assert reader.GetOutput().GetNumberOfCells() == mesh.GetNumberOfCells()
        assert gm.statistic(contour, "Chunks") == gm.statistic(contour, "UsedChunks") == 0
        assert gm.statistic(contour, "BytesRead") == 0
        # Without it, the file again.
        reader.SetBox(1, -1, 1, -1, 1, -1)
        reader.SetValueRangeArray(None)
        contour.Update()
        gc.assert_same(contour.GetOutput(), gc.reference(whole, [0.15, 0.5], "wave"))
        assert gm.statistic(contour, "Chunks") == chunks and gm.statistic(contour, "UsedChunks") > 0
        # And with it, in pieces, which are those of the reader; nothing is told of the file.
        gm.set_options(reader, **limits)
        count = 0
        for piece in range(3):
            contour.UpdatePiece(piece, 3, 0)
            count += contour.GetOutput().GetNumberOfCells()
            assert gm.statistic(contour, "UsedChunks") == gm.statistic(contour, "UsedTetrahedra") == 0
        assert count == gc.reference(mesh, [0.15, 0.5], "wave").GetNumberOfCells()

    # Arrays that the reader would leave out are not carried.
    reader = gc.open_file(path)
    reader.UpdateInformation()
    reader.SetPointArrayStatus("place", 0)
    reader.SetCellArrayStatus("material", 0)
    contour = gc.make_contour(reader, 0.4, "wave")
    contour.Update()
    output = contour.GetOutput()
    names = [[a.GetName() for a in gm.arrays_of(d)] for d in (output.GetPointData(), output.GetCellData())]
    assert names == [["wave"], ["cell"]], names
    gc.assert_same(output, gc.reference(whole, 0.4, "wave"), skip=("place", "material"))
    reader.SetPointArrayStatus("place", 1)
    contour.Update()
    assert contour.GetOutput().GetPointData().HasArray("place")

    # Another file under the same name; another name; another value.
    changed = gm.temporary("behind-changed.gtn")
    gm.write(grid, changed, ChunkSize=500, **options)
    reader = gc.open_file(changed)
    contour = gc.make_contour(reader, 0.4, "wave")
    contour.Update()
    gm.write(make_grid(0.5), changed, ChunkSize=700, **options)
    contour.SetValue(0, 0.3)
    contour.Update()
    expected = gc.reference(gm.read(changed), 0.3, "wave")
    assert gc.assert_same(contour.GetOutput(), expected) > 1000
    reader.SetFileName(path)
    contour.Update()
    gc.assert_same(contour.GetOutput(), gc.reference(whole, 0.3, "wave"))

    # Order that the file keeps makes no difference but to the corners that sections begin with.
    kept = gm.temporary("behind-kept.gtn")
    gm.write(grid, kept, ChunkSize=500, KeepOrder=7, **options)
    output = gc.contour_of(gc.open_file(kept), 0.4, "wave")
    gc.assert_same(output, gc.reference(gm.read(kept, **DECODED), 0.4, "wave"))
    assert gc.polygons(output)[0] == ours[0]

    # Simplified: by each target, with and without base meshes; to and fro with one filter.
    simple_bytes = []
    for levels in (0, 9):
        simple = gm.temporary("behind-simple.gtn")
        gm.write(grid, simple, ChunkSize=500, Hierarchy=True, Levels=levels, **options)
        reader = gc.open_file(simple)
        contour = gc.make_contour(reader, [0.1, 0.4], "wave", ComputeNormals=True)
        counts = []
        for target in ({"SimplificationRatio": 0.3}, {"SimplificationRatio": 0.9},
                       {"SimplificationRatio": 0.98}, {"SimplificationRatio": 0.6},
                       {"SimplificationNumberOfPoints": 700},
                       {"SimplificationRMSError": 0.004},
                       {"SimplificationRatio": 0.0}):
            no_others = {"SimplificationNumberOfPoints": 0, "SimplificationRMSError": 0}
            gm.set_options(reader, **{**no_others, **target})
            contour.Update()
            mesh = gm.read(simple, **target)
            output = contour.GetOutput()
            gc.assert_whole(output)
            assert gm.statistic(reader, "DecodedChunks") == 0
            counts.append(gc.assert_same(
                output, gc.reference(mesh, [0.1, 0.4], "wave"), skip=("Normals",)))
        assert counts[0] > 3 * counts[1] > 3 * counts[2] > 0 and counts[-1] > counts[0], counts
        # Pieces of it.
        reader.SetSimplificationRatio(0.5)
        contour.UpdatePiece(0, 1, 0)
        normals = {tuple(p): tuple(n) for p, n in zip(
            gc.points_of(contour.GetOutput()),
            vtk_to_numpy(contour.GetOutput().GetPointData().GetNormals()))}
        expected, found = contour.GetOutput().GetNumberOfCells(), 0
        for piece in range(5):
            contour.UpdatePiece(piece, 5, 0)
            output = contour.GetOutput()
            found += output.GetNumberOfCells()
            if output.GetNumberOfCells():
                for p, n in zip(gc.points_of(output), vtk_to_numpy(output.GetPointData().GetNormals())):
                    assert normals[tuple(p)] == tuple(n)
        assert found == expected and gm.statistic(reader, "DecodedChunks") == 0
        contour = gc.make_contour(gc.open_file(simple, SimplificationRatio=0.9), 0.4, "wave")
        contour.Update()
        simple_bytes.append(gm.statistic(contour, "BytesRead"))
    assert simple_bytes[1] < 0.8 * simple_bytes[0], simple_bytes  # base meshes save some

    # Time steps: that which is asked for, or the last one before.
    times = [0.0, 0.5, 2.0]
    stepped = gm.temporary("behind-time.gtn")
    writer = vtkGatunWriter()
    gatunTimeSource.connect(writer, gatunTimeSource.TimeSource(
        lambda index: make_grid(times[index]), times))
    writer.SetFileName(stepped)
    writer.SetWriteAllTimeSteps(True)
    writer.SetChunkSize(500)
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    reader = gc.open_file(stepped)
    contour = gc.make_contour(reader, 0.4, "wave")
    seen = set()
    for time, step in ((0.5, 1), (2.0, 2), (0.0, 0), (1.9, 1), (-5.0, 0), (7.0, 2), (0.5, 1)):
        contour.UpdateTimeStep(time)
        output = contour.GetOutput()
        assert output.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == times[step]
        decoded = gc.open_file(stepped)
        decoded.UpdateTimeStep(time)
        seen.add(gc.assert_same(output, gc.reference(decoded.GetOutput(), 0.4, "wave")))
        assert gm.statistic(reader, "DecodedChunks") == 0
    assert len(seen) == 3 and min(seen) > 1000
    # Without a time, the first.
    output = gc.contour_of(gc.open_file(stepped), 0.4, "wave")
    decoded = gm.read(stepped)
    gc.assert_same(output, gc.reference(decoded, 0.4, "wave"))
