# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A pipeline that is drawn in pieces shows what it shows as a whole; pieces are asked for one at a
time, and no more of them than necessary."""

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersCore import vtkElevationFilter, vtkPointDataToCellData

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader

PIECES = 4


class Watched:
    """Notes which pieces a filter is executed for."""

    def __init__(self, algorithm, path):
        self.reader = vtkGatunReader()
        self.reader.SetFileName(path)
        self.algorithm = algorithm
        algorithm.SetInputConnection(self.reader.GetOutputPort())
        self.pulled = []
        algorithm.AddObserver("StartEvent", self.note)

    def note(self, *_):
        info = self.algorithm.GetOutputInformation(0)
        assert info.Get(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS()) == 0
        self.pulled.append(
            (info.Get(Pipeline.UPDATE_PIECE_NUMBER()), info.Get(Pipeline.UPDATE_NUMBER_OF_PIECES())))

    def take(self):
        """What was asked for since the last time."""
        pulled, self.pulled = self.pulled, []
        return pulled

    def forget(self):
        """Makes something else: a piece that is there already need not be made again."""
        self.algorithm.UpdatePiece(0, 1, 0)
        self.take()

    def scene(self, **options):
        scene = gv.Scene(self.algorithm, **options)
        scene.watched = self  # VTK's reference to it does not count for Python
        return scene


def elevation():
    made = vtkElevationFilter()
    made.SetLowPoint(0, 0, 0)
    made.SetHighPoint(1, 1, 0.5)
    return made


mesh = gv.wave(24)
path = gv.gm.temporary("mapper-pieces.gtn")
gv.gm.write(mesh, path, ChunkSize=8192)
all_pieces = [(piece, PIECES) for piece in range(PIECES)]

for make in elevation, vtkPointDataToCellData:
    whole = Watched(make(), path).scene()
    watched = Watched(make(), path)
    scene = watched.scene(NumberOfPieces=PIECES)
    assert np.allclose(scene.volume.GetBounds(), (0, 1, 0, 1, 0, 1))
    for name in "Composite", "MaximumIntensity", "XRay":
        for one in (whole, scene):
            getattr(one.mapper, "SetBlendModeTo" + name)()
            one.look(1, 0.5)
        gv.require_same(scene.render(), whole.render())
    # Each piece once, as all of it is kept.
    assert watched.take() == all_pieces, make
    assert scene.mapper.GetDataSetInput() is None

# Nothing is kept: those that are seen again for each picture, the nearest first.
whole = Watched(elevation(), path).scene(OpacityLimit=0)
watched = Watched(elevation(), path)
scene = watched.scene(NumberOfPieces=PIECES, MemoryBudget=0, OpacityLimit=0)
gv.require_same(scene.render(), whole.render())
assert watched.take()[:PIECES] == all_pieces
bounds = {}
for piece in range(PIECES):
    watched.algorithm.UpdatePiece(piece, PIECES, 0)
    bounds[piece] = np.array(watched.algorithm.GetOutput().GetBounds()).reshape(3, 2)
for direction in (0, np.pi):
    for one in (whole, scene):
        one.look(direction, 0.1)
    watched.forget()
    gv.require_same(scene.render(), whole.render())
    pulled = [piece for piece, _ in watched.take()]
    assert sorted(pulled) == list(range(PIECES)), pulled
    sight = np.array([np.sin(direction), 0.1, np.cos(direction)])
    depths = [-sight @ bounds[piece].mean(1) for piece in pulled]
    assert depths == sorted(depths), depths

# Those out of sight are not asked for: a corner of the mesh.
for one in (whole, scene):
    one.camera.SetFocalPoint(0.05, 0.05, 0.05)
    one.camera.SetPosition(-0.3, 0.05, 0.05)
    one.camera.SetClippingRange(0.01, 0.6)
    one.camera.SetViewAngle(15)
watched.forget()
gv.require_same(scene.render(), whole.render())
assert 1 <= len(watched.take()) < PIECES
# Nor those hidden: by what is opaque in front.
for one in (whole, scene):
    one.set(OpacityLimit=0.001)
    one.volume.SetProperty(gv.make_property(((0, 1), (1, 1)), 0.001))
    one.look(0.1, 0.1, 0.6)
    one.camera.SetViewAngle(30)
watched.forget()
gv.require_same(scene.render(), whole.render(), contrast=0.01)
assert 1 <= len(watched.take()) < PIECES
# Nor those that are transparent.
scene.volume.SetProperty(gv.make_property(((0, 0), (1, 0))))
picture = scene.render()
assert gv.difference(picture[..., :3], np.broadcast_to(gv.BACKGROUND, (120, 160, 3))) < 1 / 255
assert watched.take() == []

# A change of the pipeline is seen, and so is another number of pieces; more than there are cells.
for one in (whole, scene):
    one.volume.SetProperty(gv.make_property())
    one.set(MemoryBudget=64)
gv.require_same(scene.render(), whole.render())
whole.mapper.GetInputAlgorithm().SetHighPoint(0.2, 1, 1)
watched.algorithm.SetHighPoint(0.2, 1, 1)
gv.require_same(scene.render(), whole.render())
for pieces in (1, 3, 500, 1):
    scene.set(NumberOfPieces=pieces)
    gv.require_same(scene.render(), whole.render())
assert scene.mapper.GetDataSetInput().GetNumberOfCells() == mesh.GetNumberOfCells()

# A region of interest of a reader, in pieces; a grid in memory is in one.
reader = vtkGatunReader()
reader.SetFileName(path)
reader.SetBox(0, 0.1, 0, 0.1, 0, 0.1)
part = gv.Scene(reader, NumberOfPieces=2)
picture = part.render()
assert reader.GetOutputInformation(0).Get(Pipeline.UPDATE_NUMBER_OF_PIECES()) == 2
part.set(NumberOfPieces=1)
gv.require_same(picture, part.render())
gv.require_same(gv.Scene(mesh, NumberOfPieces=3).render(), gv.Scene(mesh).render())
