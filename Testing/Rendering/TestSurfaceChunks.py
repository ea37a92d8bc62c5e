# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Which chunks of a surface's file are decoded, drawn and kept; selections; damaged and changed files;
time, pieces, aborts and progress."""

import re

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkSelectionNode
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkHardwareSelector

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunWriter
from gatunSurfaceScene import Scene, ball, covered, pair, require_equal
from gatunTimeSource import TimeSource, connect

path = gm.temporary("chunks.gtn")
surface = ball(120)
gm.write(surface, path, ChunkSize=500)


def chunks_of(scene):
    return scene.source.GetChunkTable().GetNumberOfRows()


# Chunks outside of the view are not decoded, and each is decoded once.
ours, theirs = pair(path)
for scene in ours, theirs:
    scene.look(30, 20, zoom=8)
require_equal(ours, theirs, "close")
total = chunks_of(ours)
few = gm.statistic(ours.mapper, "DecodedChunks")
assert total > 25 and 0 < few < total / 3, (few, total)
assert gm.statistic(ours.mapper, "DrawnChunks") == few
before = gm.statistic(ours.source, "BytesRead")
ours.render()
assert gm.statistic(ours.mapper, "DecodedChunks") == few and gm.statistic(ours.source, "BytesRead") == before
for scene in ours, theirs:
    scene.look(30, 20)
require_equal(ours, theirs, "all")
assert gm.statistic(ours.mapper, "DecodedChunks") == total == gm.statistic(ours.mapper, "DrawnChunks")

# Those behind the camera neither.
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.look()
scene.camera.SetPosition(0, 0, 0)
scene.camera.SetFocalPoint(1, 0, 0)
scene.renderer.ResetCameraClippingRange()
scene.render()
assert 0 < gm.statistic(scene.mapper, "DecodedChunks") < total / 2

# Of what is culled nothing is drawn, in all positions, and nothing is missing.
ours, theirs = pair(path)
culled = []
for face in "Back", "Front":
    for scene in ours, theirs:
        scene.actor.GetProperty().SetBackfaceCulling(face == "Back")
        scene.actor.GetProperty().SetFrontfaceCulling(face == "Front")
    for parallel in 0, 1:
        for scale in (1, 1, 1), (-1, 1, 1), (3, -0.5, -1):
            for view in (0, 0), (70, 10), (150, -40):
                for scene in ours, theirs:
                    scene.actor.SetScale(*scale)
                    scene.camera.SetParallelProjection(parallel)
                    scene.look(*view)
                ours.render()
                require_equal(ours, theirs, (face, parallel, scale, view))
                culled.append(gm.statistic(ours.mapper, "CulledChunks"))
assert min(culled) > total / 20 and max(culled) < total * 0.8, culled
ours.actor.GetProperty().SetFrontfaceCulling(0)
ours.render()
assert gm.statistic(ours.mapper, "CulledChunks") == 0

# Buffers keep to the budget, and pictures do not depend on it.
ours, theirs = pair(path)
for scene in ours, theirs:
    scene.look(20, 30)
whole = require_equal(ours, theirs, "budget")
needed = gm.statistic(ours.mapper, "BufferBytes")
assert needed > 500000, needed
ours.mapper.SetMemoryBudget(0)
assert np.array_equal(ours.render(), whole) and gm.statistic(ours.mapper, "BufferBytes") == 0
decoded = gm.statistic(ours.mapper, "DecodedChunks")
assert np.array_equal(ours.render(), whole)
assert gm.statistic(ours.mapper, "DecodedChunks") == decoded + total
large = ball(250)
gm.write(large, path, ChunkSize=5000)
whole = pd.read(path)
budgets = []
for budget in 1, 4, 512:
    ours = Scene(pd.reader_of(path, LargeMesh=0))
    ours.mapper.SetMemoryBudget(budget)
    ours.look(20, 30)
    first = ours.render()
    kept = gm.statistic(ours.mapper, "BufferBytes")
    assert 0 < kept <= budget << 20, (kept, budget)
    many = gm.statistic(ours.mapper, "DecodedChunks")
    assert np.array_equal(first, ours.render())
    budgets.append(gm.statistic(ours.mapper, "DecodedChunks") - many)
    # Another view drives out what is not seen any more.
    ours.look(20, 30, zoom=6)
    ours.render()
    assert gm.statistic(ours.mapper, "BufferBytes") <= budget << 20
    # Changes of the mapper and of properties need the meshes again.
    theirs = Scene(whole, False)
    for scene in ours, theirs:
        scene.look(20, 30, zoom=3)
        scene.mapper.ScalarVisibilityOff()
    require_equal(ours, theirs, (budget, "hidden"))
    for scene in ours, theirs:
        scene.actor.GetProperty().SetColor(1, 0, 0)
        scene.actor.GetProperty().SetInterpolationToFlat()
    require_equal(ours, theirs, (budget, "red"))
    for scene in ours, theirs:
        scene.actor.GetProperty().SetRepresentationToWireframe()
    require_equal(ours, theirs, (budget, "wires"))
    ours.window.Finalize()
assert budgets[0] > budgets[1] > 0 == budgets[2], budgets

# Nothing stays in the cache of the reader.
assert gm.statistic(ours.source, "CachedBytes") < 1 << 20


# Ids of a selection are those of the reader's output.
def select(scene, association):
    selector = vtkHardwareSelector()
    selector.SetRenderer(scene.renderer)
    selector.SetArea(20, 20, 150, 120)
    selector.SetFieldAssociation(association)
    selection = selector.Select()
    ids = set()
    for i in range(selection.GetNumberOfNodes()):
        node = selection.GetNode(i)
        assert node.GetProperties().Get(vtkSelectionNode.PROP()) is scene.actor
        ids |= set(gm.values_of(node.GetSelectionList()).ravel().tolist())
    return ids


# Where points are close on the screen, the order of chunks decides which one is seen.
for order in 0, 7:
    gm.write(ball(16), path, ChunkSize=100, KeepOrder=order)
    ours, theirs = pair(path)
    for scene in ours, theirs:
        scene.look(20, 30, zoom=1.5)
        scene.render()
    for association, least, off in ((vtkDataObject.FIELD_ASSOCIATION_CELLS, 300, 0.01),
                                    (vtkDataObject.FIELD_ASSOCIATION_POINTS, 150, 0.1)):
        one, other = select(ours, association), select(theirs, association)
        assert len(other) > least and len(one ^ other) <= off * len(other), (
            order, association, len(one), len(other), len(one ^ other))
    # A picture after a selection.
    require_equal(ours, theirs, "selected")
gm.write(surface, path, ChunkSize=500)

# Pieces are parts of the chunks.
pictures = []
for piece in range(3):
    ours = Scene(pd.reader_of(path, LargeMesh=0))
    ours.mapper.SetNumberOfPieces(3)
    ours.mapper.SetPiece(piece)
    assert ours.actor.GetBounds() == surface.GetBounds()
    ours.look(20, 30)
    pictures.append(covered(ours.render()))
    assert 0 < gm.statistic(ours.mapper, "DrawnChunks") <= total / 3 + 1
assert all(0.01 < share < 0.4 for share in pictures), pictures

# Arrays that are not read are no colors, and time is that of the pipeline.
TIMES = [1.0, 3.0]


def step(index):
    moved = vtkPolyData()
    moved.ShallowCopy(surface)
    values = gm.values_of(surface.GetPointData().GetArray("height"))
    moved.GetPointData().SetScalars(gm.add_array(moved.GetPointData(), values * (1 - index), "height"))
    return moved


writer = vtkGatunWriter()
connect(writer, TimeSource(step, TIMES, "vtkPolyData"))
writer.SetFileName(path)
writer.SetWriteAllTimeSteps(True)
writer.SetChunkSize(500)
assert writer.Write() == 1
ours = Scene(pd.reader_of(path, LargeMesh=0))
seen = []
for time in (None, 3.0, 1.0):
    if time is not None:
        ours.mapper.GetInputInformation().Set(Pipeline.UPDATE_TIME_STEP(), time)
    theirs = Scene(pd.read(path) if time != 3.0 else step(1), False)
    for scene in ours, theirs:
        scene.mapper.SetScalarRange(-1, 2)
        scene.look()
    seen.append(require_equal(ours, theirs, time))
assert np.abs(seen[0] - seen[1]).max() > 50
ours.source.SetPointArrayStatus("height", 0)
assert np.abs(ours.render() - seen[2]).max() > 50

# The same name, another file.
gm.write(ball(20, 2), path, ChunkSize=500)
theirs = Scene(pd.read(path), False)
for scene in ours, theirs:
    scene.mapper.ScalarVisibilityOff()
    scene.look(bounds=(-2, 2, -2, 2, -2, 2))
require_equal(ours, theirs, "changed")

# A damaged chunk is told once, and the others are drawn.
gm.write(surface, path, ChunkSize=500)
with open(path, "rb") as file:
    good = bytearray(file.read())
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.ScalarVisibilityOff()
scene.look()
whole = scene.render()
damaged = bytearray(good)
meshes = [match.start() for match in re.finditer(b"MESH", good)]
at = meshes[len(meshes) // 4] + 40  # of the directory is the second half
damaged[at:at + 8] = bytes(255 - b for b in damaged[at:at + 8])
with open(path, "wb") as file:
    file.write(damaged)
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.ScalarVisibilityOff()
errors = gm.Errors(scene.mapper)
scene.look()
part = scene.render()
assert scene.mapper.GetErrorCode() != 0 and len(errors.messages) == 1 and path in str(errors)
assert 0.3 * covered(whole) < covered(part)
assert total - 3 <= gm.statistic(scene.mapper, "DrawnChunks") < total
scene.render()
assert len(errors.messages) == 1 and scene.mapper.GetErrorCode() != 0
with open(path, "wb") as file:
    file.write(good)
assert np.array_equal(scene.render(), whole) and scene.mapper.GetErrorCode() == 0

# An abort ends an image, and the next one is whole; progress is reported.
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.ScalarVisibilityOff()
scene.look()
scene.progress = []


def note(*_):
    scene.progress.append(scene.mapper.GetProgress())
    if len(scene.progress) == 3:
        scene.window.SetAbortRender(1)


scene.mapper.AddObserver("ProgressEvent", note)
scene.render()
assert 0 < gm.statistic(scene.mapper, "DrawnChunks") < total / 2
assert np.array_equal(scene.render(), whole)
assert scene.progress[-1] == 1 and len(scene.progress) > 5
