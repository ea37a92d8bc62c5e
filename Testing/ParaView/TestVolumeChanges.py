# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Volume through what people do in a session: other arrays and components, other
representations and back, filters behind a reader on demand, time, regions, states and screenshots."""

import numpy as np

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

simple = load_plugin()
rank, ranks = rank_and_ranks()
calculated = simple.Calculator(Input=sample.make_source(), ResultArrayName="vector",
                               Function="(coordsX - 6)*iHat + coordsY*jHat - 3*kHat")
path = sample.temporary("volume-changes.gtn")
simple.SaveData(path, proxy=calculated, ChunkSize=300)
view = drawing.make_view()
background = drawing.draw(view)
mesh = simple.GatunReader(FileNames=[path], LargeMesh=-1)
reader = simple.GatunReader(FileNames=[path], LargeMesh=0)
near = {"by": 2}


# Color maps are made for the same ranges.
for array, association in (("wave", "PointData"), ("point", "PointData"), ("vector", "PointData"),
                           ("cell", "CellData")):
    have, want = (drawing.ranges(one, array, association) for one in (reader, mesh))
    assert np.allclose(have, want, rtol=1e-6, atol=0), (array, have, want)


def both(change):
    """Pictures of the mesh and of the file after the same change to their representations."""
    made = []
    for source in (mesh, reader):
        shown = simple.Show(source, view)
        change(shown)
        made.append(drawing.draw(view))
        simple.Hide(source, view)
    drawing.require_other(made[0], background)
    drawing.require_same(*made, **near)
    return made[1]


def to_volume(shown):
    shown.SetRepresentationType("Gatun Volume")
    drawing.color(shown, view)
    shown.ScalarOpacityUnitDistance = 3


first = both(to_volume)


# Other arrays and components.
def by_array(name, low, high, association="POINTS", component=None):
    def change(shown):
        colors = [low, 0, 0, 1, high, 1, 1, 0]
        drawing.color(shown, view, name, colors, [low, 0, 0.5, 0, high, 1, 0.5, 0], association)
        table = simple.GetColorTransferFunction(name)
        if component is not None:
            table.VectorMode = "Component"
            table.VectorComponent = component
        else:
            table.VectorMode = "Magnitude"
    return change


seen = [first, both(by_array("point", 0, sample.POINTS)),
        both(by_array("vector", 0, 15)), both(by_array("vector", -6, 6, component=0)),
        both(by_array("vector", 0, 12, component=1)),
        both(by_array("cell", 0, sample.TETS, "CELLS"))]
for i, one in enumerate(seen):
    for other in seen[:i]:
        drawing.require_other(one, other)
drawing.require_same(both(to_volume), first)

# Negative values of an array with one component are not taken for lengths.
drawing.require_other(both(by_array("wave", -2.5, 0)), first)
both(to_volume)

# Other representations, and back.
shown = simple.Show(reader, view)
assert drawing.differing(drawing.draw(view), first) == 0
for representation in ("Outline", "Gatun Volume", "Surface", "Wireframe", "Points", "Gatun Volume"):
    shown.SetRepresentationType(representation)
    picture = drawing.draw(view)
    drawing.require_same(picture, first) if representation == "Gatun Volume" else \
        drawing.require_other(picture, first)
shown.Visibility = 0
drawing.require_same(drawing.draw(view), background)
shown.Visibility = 1
drawing.require_same(drawing.draw(view), first)

# Pictures while somebody interacts are coarser, and not others.
view.SMProxy.InteractiveRender()
drawing.require_same(drawing.draw(view), first)

# Also of a mesh in memory, of which ParaView makes much the same picture.
simple.Hide(reader, view)
in_memory = simple.Show(mesh, view)
in_memory.SetRepresentationType("Volume")
drawing.require_same(drawing.draw(view), first, by=25, pixels=0.02 * drawing.SIZE ** 2)
in_memory.SetRepresentationType("Gatun Volume")
drawing.require_same(drawing.draw(view), first, **near)
simple.Hide(mesh, view)
simple.Show(reader, view)

# A filter gets the outline, and its output is that, however it is shown.
simple.Hide(reader, view)
clip = simple.Clip(Input=reader, ClipType="Plane", Invert=1)
clip.ClipType.Origin = [sample.SIDE / 2] * 3
clip.ClipType.Normal = [1, 0, 0]
assert 0 < sample.counts(clip)[1] <= 12, sample.counts(clip)
cut = simple.Show(clip, view)
to_volume(cut)
lines = drawing.draw(view)
assert 0 < drawing.differing(lines, background) < 0.1 * drawing.SIZE ** 2
cut.SetRepresentationType("Surface")
drawing.draw(view)
simple.Delete(clip)

# The reader turned to the mesh and back: the filter then gets tetrahedra.
simple.Show(reader, view)
reader.LargeMesh = -1
drawing.require_same(drawing.draw(view), first, **near)
assert sample.owned(reader)[1] == sample.TETS
reader.LargeMesh = 0
drawing.require_same(drawing.draw(view), first)
assert sample.counts(reader) == (8, 12)

# A region of interest is a mesh.
reader.Box = [0, 2, 0, 12, 0, 12]
assert 12 < sample.counts(reader)[1] < sample.TETS
drawing.require_other(drawing.draw(view), first)
reader.Box = [1, -1, 1, -1, 1, -1]
drawing.require_same(drawing.draw(view), first)

# Two views; when one goes, the other stays as it was.
second = drawing.make_view()
other = drawing.show(reader, second)
drawing.require_same(drawing.draw(second), first)
simple.Delete(second)
drawing.require_same(drawing.draw(view), first)
simple.SetActiveView(view)

# Cells other than tetrahedra are split as everywhere.
wavelet = simple.Wavelet(WholeExtent=[0, 12, 0, 12, 0, 12])
voxels = simple.AppendDatasets(Input=wavelet)
tetrahedra = simple.Tetrahedralize(Input=wavelet)
simple.Hide(reader, view)
made = []
for source in (voxels, tetrahedra):
    source.UpdatePipeline()
    shown_source = simple.Show(source, view)
    shown_source.SetRepresentationType("Gatun Volume")
    drawing.color(shown_source, view, "RTData", [40, 0, 0, 1, 280, 1, 1, 0],
                   [40, 0, 0.5, 0, 280, 1, 0.5, 0])
    shown_source.ScalarOpacityUnitDistance = 3
    made.append(drawing.draw(view))
    simple.Hide(source, view)
drawing.require_other(made[0], background)
drawing.require_same(*made, **near)
for source in (voxels, tetrahedra, wavelet):
    simple.Delete(source)
simple.Show(reader, view)
drawing.require_same(drawing.draw(view), first)

# Screenshots, also larger than the view.
shot = sample.temporary("volume-changes.png")
simple.SaveScreenshot(shot, view, ImageResolution=[300, 300])
if rank == 0:
    png = vtkPNGReader()
    png.SetFileName(shot)
    png.Update()
    assert png.GetOutput().GetDimensions()[:2] == (300, 300)
    assert vtk_to_numpy(png.GetOutput().GetPointData().GetScalars()).std() > 20

# Time steps in one file, and series of files.
if ranks == 1:
    steps = sample.temporary("volume-steps.gtn")
    simple.SaveData(steps, proxy=sample.make_moving_source([0, 1, 2]), WriteAllTimeSteps=1)
    names = []
    for i in range(3):
        names.append(sample.temporary("volume-series_%d.gtn" % i))
        moved = simple.Calculator(Input=sample.make_source(), ResultArrayName="ramp",
                                  Function="coordsX * %d" % i)
        simple.SaveData(names[-1], proxy=moved)
    simple.Hide(reader, view)
    for files in ([steps], names):
        frames = []
        for large in -1, 0:
            moving = simple.GatunReader(FileNames=files, LargeMesh=large)
            assert list(moving.TimestepValues) == [0, 1, 2]
            shown_moving = simple.Show(moving, view)
            shown_moving.SetRepresentationType("Gatun Volume")
            drawing.color(shown_moving, view, "ramp", [0, 0, 0, 1, 24, 1, 1, 0],
                           [0, 0.02, 0.5, 0, 24, 1, 0.5, 0])
            shown_moving.ScalarOpacityUnitDistance = 3
            frames.append([])
            for time in (2, 0, 1):
                view.ViewTime = time
                frames[-1].append(drawing.draw(view))
            simple.Hide(moving, view)
            simple.Delete(moving)
        for one, other_one in zip(*frames):
            drawing.require_same(one, other_one)
        drawing.require_other(frames[0][0], frames[0][1])
        drawing.require_other(frames[0][0], frames[0][2])
    simple.Show(reader, view)
    drawing.require_same(drawing.draw(view), first)

# The file rewritten, and read again.
smaller = simple.Transform(Input=sample.make_source(), Transform="Transform")
smaller.Transform.Scale = [0.5, 0.5, 0.5]
simple.SaveData(path, proxy=smaller, ChunkSize=300)
simple.ReloadFiles(reader)
drawing.require_other(drawing.draw(view), first)
assert reader.GetDataInformation().GetBounds()[1] == sample.SIDE / 2
simple.SaveData(path, proxy=calculated, ChunkSize=300)
simple.ReloadFiles(reader)
drawing.require_same(drawing.draw(view), first)

# A state.
shown.BlendMode = 1
shown.MemoryBudget = 64
expected = drawing.draw(view)
state = sample.temporary("volume-changes.pvsm")
if ranks == 1:
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [drawing.SIZE, drawing.SIZE]
    drawing.require_same(drawing.draw(view), expected)
    readers = [s for s in simple.GetSources().values() if s.GetXMLName() == "GatunReader"]
    assert sorted(s.GetProperty("LargeMesh").GetData() for s in readers) == [-1, 0]
