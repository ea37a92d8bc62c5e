# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunSimplify behind a reader whose file has a hierarchy gives what the reader's own
simplification gives: whole, in pieces, with ghost cells, at every time. Elsewhere it works as on any
mesh, and keeps the points that pieces have in common."""

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkElevationFilter

import gatunMeshes as gm
import gatunTimeSource
from gatun.vtk import vtkGatunReader, vtkGatunSimplify, vtkGatunWriter

points, tets = gm.lattice(10, seed=3)
TIMES = [0.0, 0.5, 2.0]


def make_grid(step=0.0):
    grid = gm.make_grid(points, tets)
    wave = np.sin(4 * points[:, 0] + step) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    gm.add_array(grid.GetPointData(), points * (1 + step), "place")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def open_file(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


def simplify(source, **options):
    simplifier = vtkGatunSimplify()
    simplifier.SetInputConnection(source.GetOutputPort())
    gm.set_options(simplifier, **options)
    simplifier.AddObserver("WarningEvent", lambda *_: None)
    return simplifier


def compare(simplifier, reader, **request):
    """Both are asked for the same part, and must give the same."""
    piece, pieces, ghosts = request.get("piece", (0, 1, 0))
    for algorithm in (simplifier, reader):
        if "time" in request:
            algorithm.UpdateTimeStep(request["time"], piece, pieces, ghosts)
        else:
            algorithm.UpdatePiece(piece, pieces, ghosts)
        assert algorithm.GetErrorCode() == 0
    gm.assert_equal(reader.GetOutput(), simplifier.GetOutput())
    assert simplifier.GetOutput().GetNumberOfCells() < len(tets)
    return simplifier.GetOutput().GetNumberOfCells()


def write(name, **options):
    path = gm.temporary(name)
    gm.write(make_grid(), path, ChunkSize=400, **options)
    return path


# By every target, whole and in pieces; with base meshes and without; in the original order and not.
TARGETS = [{"SimplificationRatio": 0.6},
           {"SimplificationNumberOfPoints": 300},
           {"SimplificationRMSError": 0.004}]
for options in ({}, {"Levels": 5}, {"Levels": 5, "KeepOrder": 7}):
    path = write("simplify-reader.gtn", Hierarchy=True, **options)
    reader = open_file(path)
    for target in TARGETS:
        simplifier, twin = simplify(reader, **target), open_file(path, **target)
        whole = compare(simplifier, twin)
        assert gm.statistic(reader, "DecodedChunks") == 0 and reader.GetOutput().GetNumberOfCells() == 0
        assert simplifier.GetMostMerges() > 0
        assert simplifier.GetOutputRMSError() > 0
        count = 0
        for piece in range(4):
            count += compare(simplifier, twin, piece=(piece, 4, 0))
        assert count == whole, "the pieces together are the mesh"
        ghosts = compare(simplifier, twin, piece=(1, 4, 1))
        assert ghosts > compare(simplifier, twin, piece=(1, 4, 0))

# Of 60 %, half: 80 %. The reader's arrays and settings count.
path = write("simplify-reader.gtn", Hierarchy=True, Levels=4)
reader = open_file(path, SimplificationRatio=0.6, GenerateGlobalIds=True)
reader.UpdateInformation()
reader.SetPointArrayStatus("place", 0)
left = len(points) - int(len(points) * 0.6)
left -= int(left * 0.5)
twin = open_file(path, SimplificationNumberOfPoints=left, GenerateGlobalIds=True)
twin.UpdateInformation()
twin.SetPointArrayStatus("place", 0)
simplifier = simplify(reader, SimplificationRatio=0.5)
compare(simplifier, twin)
assert simplifier.GetOutput().GetNumberOfPoints() == left
assert not simplifier.GetOutput().GetPointData().HasArray("place")
# An error is that of the whole mesh: one that the reader exceeds changes nothing.
simplifier = simplify(reader, SimplificationRMSError=1e-300)
twin.SetSimplificationNumberOfPoints(0)
twin.SetSimplificationRatio(0.6)
compare(simplifier, twin)

# On demand, the reader gives an outline, and the filter the mesh.
reader = open_file(path, LargeMesh=0)
compare(simplify(reader, SimplificationRatio=0.7), open_file(path, SimplificationRatio=0.7))
assert gm.statistic(reader, "DecodedChunks") == 0

# Times, which consumers ask for in turn.
stepped = gm.temporary("simplify-time.gtn")
writer = vtkGatunWriter()
gatunTimeSource.connect(writer, gatunTimeSource.TimeSource(lambda i: make_grid(TIMES[i]), TIMES))
writer.SetFileName(stepped)
writer.WriteAllTimeStepsOn()
writer.SetHierarchy(True)
writer.SetChunkSize(400)
assert writer.Write() == 1
reader = open_file(stepped)
first, second = simplify(reader, SimplificationRatio=0.5), simplify(reader, SimplificationRatio=0.8)
twins = [open_file(stepped, SimplificationRatio=ratio) for ratio in (0.5, 0.8)]
for time, other in ((0.5, 2.0), (2.0, 0.0), (0.0, 0.7), (9.0, -1.0)):
    compare(first, twins[0], time=time, piece=(1, 3, 1))
    compare(second, twins[1], time=other)
    compare(first, twins[0], time=time)
    held = first.GetOutput().GetInformation().Get(vtkDataObject.DATA_TIME_STEP())
    assert held == twins[0].GetOutput().GetInformation().Get(vtkDataObject.DATA_TIME_STEP())
assert gm.statistic(reader, "DecodedChunks") == 0

# A region of interest, another filter in between, a file without a hierarchy, or none wanted: an order
# of its own, found on what the reader gives.
plain = write("simplify-plain.gtn")


def heard_of(simplifier):
    messages = []

    @calldata_type(VTK_STRING)
    def note(_object, _event, text):
        messages.append(text)

    simplifier.AddObserver("WarningEvent", note)
    return messages


def elevated(reader):
    between = vtkElevationFilter()
    between.SetInputConnection(reader.GetOutputPort())
    return between




def outside(grids):
    """The faces that one tetrahedron of some grids has, by the places of their corners."""
    met = {}
    for grid in grids:
        places = [tuple(p) for p in vtk_to_numpy(grid.GetPoints().GetData()).tolist()]
        tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
        for tet in tets.tolist():
            for left_out in range(4):
                face = frozenset(places[c] for i, c in enumerate(tet) if i != left_out)
                met[face] = met.get(face, 0) + 1
    return [face for face, times in met.items() if times == 1]


kept = open_file(path)
for source, options in ((open_file(plain), {}), (elevated(open_file(path)), {}),
                        (open_file(path, Box=(0, 2, 0, 2, 0, 2)), {}),
                        (kept, {"UseFileHierarchy": False})):
    simplifier = simplify(source, SimplificationRatio=0.6, **options)
    warnings = heard_of(simplifier)
    simplifier.Update()
    assert source.GetOutput().GetNumberOfCells() == len(tets), "asked for the mesh"
    assert simplifier.GetOutput().GetNumberOfPoints() == len(points) - int(len(points) * 0.6)
    assert not warnings
    # Pieces fit together: what is outside is outside of the whole. Points between them are kept.
    source.UpdatePiece(0, 1, 0)
    rim = {corner for face in outside([source.GetOutput()]) for corner in face}
    pieces = []
    for piece in range(3):
        simplifier.UpdatePiece(piece, 3, 0)
        pieces.append(simplifier.GetOutput().NewInstance())
        pieces[-1].DeepCopy(simplifier.GetOutput())
    assert all(corner in rim for face in outside(pieces) for corner in face)
    assert sum(p.GetNumberOfCells() for p in pieces) < 0.8 * source.GetOutput().GetNumberOfCells()
    assert not warnings

# To and fro with one filter. The order that it finds for the mesh is not that of the file, which was
# found for the mesh in the order of the input, but gives as many points.
simplifier = simplify(kept, SimplificationRatio=0.6)
twin = open_file(path, SimplificationRatio=0.6)
for hierarchy in (True, False, True):
    simplifier.SetUseFileHierarchy(hierarchy)
    simplifier.UpdatePiece(0, 1, 0)
    assert simplifier.GetOutput().GetNumberOfPoints() == len(points) - int(len(points) * 0.6)
    if hierarchy:
        compare(simplifier, twin)
assert "UseFileHierarchy: On" in str(simplifier) and vtkGatunSimplify().GetUseFileHierarchy()

# The pieces of a file with a hierarchy fit together: no point of the whole is between two of them.
simplifier = simplify(open_file(path), SimplificationRatio=0.6)
simplifier.Update()
together = vtkAppendFilter()
together.MergePointsOn()
copies = []
for piece in range(5):
    simplifier.UpdatePiece(piece, 5, 0)
    copies.append(simplifier.GetOutput().NewInstance())
    copies[-1].DeepCopy(simplifier.GetOutput())
    copies[-1].GetPointData().Initialize()
    copies[-1].GetCellData().Initialize()
    together.AddInputDataObject(copies[-1])
together.Update()
simplifier.UpdatePiece(0, 1, 0)
assert together.GetOutput().GetNumberOfPoints() == simplifier.GetOutput().GetNumberOfPoints()
assert together.GetOutput().GetNumberOfCells() == simplifier.GetOutput().GetNumberOfCells()

# Errors: a target that makes no sense, and a damaged file; then all is well again.
simplifier = simplify(open_file(path), SimplificationRatio=float("nan"))
errors = gm.Errors(simplifier)
simplifier.Update()
assert "the ratio must be from 0 to 1" in str(errors) and simplifier.GetErrorCode() != 0
assert simplifier.GetOutput().GetNumberOfPoints() == 0
simplifier.SetSimplificationRatio(0.5)
compare(simplifier, open_file(path, SimplificationRatio=0.5))
with open(path, "rb") as file:
    content = file.read()
damaged = bytearray(content)
for at in range(len(content) // 4, len(content) // 4 * 3, 40):
    damaged[at] ^= 255
reader = open_file(path)
simplifier = simplify(reader, SimplificationRatio=0.6)
both = [gm.Errors(reader), gm.Errors(simplifier)]
with open(path, "wb") as file:
    file.write(damaged)
simplifier.Update()
assert path in "".join(map(str, both)), both
assert simplifier.GetOutput().GetNumberOfPoints() == 0
with open(path, "wb") as file:
    file.write(content)
simplifier.Modified()
compare(simplifier, open_file(path, SimplificationRatio=0.6))
assert vtk_to_numpy(simplifier.GetOutput().GetPoints().GetData()).shape[1] == 3
