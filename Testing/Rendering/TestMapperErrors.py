# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What cannot be drawn is told once, nothing is drawn, and the next picture that can be is right; so
it is after a picture that was stopped."""

import os

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.util.vtkConstants import VTK_TRIANGLE

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader

USE_FIELD_DATA = 5  # VTK_SCALAR_MODE_USE_FIELD_DATA

MESH = gv.wave()
RIGHT = gv.Scene(MESH).render()
NOTHING = np.broadcast_to(np.rint(255 * np.array(gv.BACKGROUND)) / 255, RIGHT[..., :3].shape)


def is_empty(picture):
    return gv.difference(picture[..., :3], NOTHING) < 0.01


def refuse(change, back, *texts, source=MESH, **options):
    """After a change there is a message with these texts, once, and no picture; then all is well."""
    scene = gv.Scene(source, **options)
    errors = gv.gm.Errors(scene.mapper)
    gv.require_same(scene.render(), RIGHT)
    change(scene)
    for _ in range(3):
        assert is_empty(scene.render()), texts
    assert scene.mapper.GetErrorCode() != 0
    assert len(errors.messages) == 1, str(errors)
    assert errors.messages[0].count("\n") <= 4
    for text in texts:
        assert text in str(errors), str(errors)
    back(scene)
    gv.require_same(scene.render(), RIGHT)
    assert scene.mapper.GetErrorCode() == 0
    assert len(errors.messages) == 1, str(errors)
    change(scene)  # the cause is back, and is told again
    assert is_empty(scene.render())
    assert len(errors.messages) == 2, str(errors)
    back(scene)


def give(grid):
    return lambda scene: scene.mapper.SetInputDataObject(0, grid)


def refuse_grid(grid, *texts):
    refuse(give(grid), give(MESH), *texts)


def refuse_setting(name, bad, good, *texts, **options):
    refuse(
        lambda scene: scene.set(**{name: bad}), lambda scene: scene.set(**{name: good}),
        *texts, **options)


def is_nothing(grid):
    """Neither a picture nor a message."""
    scene = gv.Scene(grid)
    errors = gv.gm.Errors(scene.mapper)
    assert is_empty(scene.render()), grid
    assert not errors.messages, str(errors)
    give(MESH)(scene)
    gv.require_same(scene.render(), RIGHT)


# Meshes.
points, tets = gv.gm.lattice(3)
bare = gv.gm.make_grid(points, tets)
refuse_grid(bare, "no scalars to draw")
triangles = gv.gm.make_grid(points, [])
triangles.Allocate(1)
triangles.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
gv.gm.add_array(triangles.GetPointData(), points[:, 0], "x")
triangles.GetPointData().SetActiveScalars("x")
is_nothing(triangles)
gv.gm.set_cell_type(triangles, 0, 99)
refuse_grid(triangles, "type 99")
broken = gv.gm.make_grid(points, [[0, 1, 2, len(points)]])
gv.gm.add_array(broken.GetPointData(), points[:, 0], "x")
broken.GetPointData().SetActiveScalars("x")
refuse_grid(broken, "point")

is_nothing(vtkUnstructuredGrid())
is_nothing(gv.gm.make_grid(points, []))


def with_values(values):
    grid = gv.gm.make_grid(points, tets)
    gv.gm.add_array(grid.GetPointData(), np.full(len(points), values, np.float32), "values")
    grid.GetPointData().SetActiveScalars("values")
    return grid


is_nothing(with_values(np.nan))
is_nothing(with_values(np.inf))
scene = gv.Scene(gv.constant())
gv.require_same(scene.render()[..., :3], gv.over(gv.cast(scene, gv.constant(), (160, 120))))
one = gv.gm.make_grid(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]), [[0, 1, 2, 3]])
gv.gm.add_array(one.GetPointData(), np.array([0.2, 0.9, 0.9, 0.5]), "values")
one.GetPointData().SetActiveScalars("values")
scene = gv.Scene(one)
gv.require_same(scene.render()[..., :3], gv.over(gv.cast(scene, one, (160, 120))))

# Settings.
MAPPER = gv.Scene(MESH).mapper
for name, low in (("OpacityLimit", 0), ("ImageSampleDistance", 1)):
    getattr(MAPPER, "Set" + name)(-0.1)
    assert getattr(MAPPER, "Get" + name)() == low, name
for name, good in (("OpacityLimit", 0.001), ("TimeBudget", 0), ("ImageSampleDistance", 1),
                   ("MinimumImageSampleDistance", 1), ("MaximumImageSampleDistance", 10)):
    refuse_setting(name, np.nan, good, name + " is not a number")
refuse_setting("ArrayComponent", 3, -1, "has no component 3")
refuse_setting("ScalarMode", USE_FIELD_DATA, 0, "of points and of cells")


def select(mode, array):
    def change(scene):
        getattr(scene.mapper, "SetScalarModeToUse" + mode)()
        if array is not None:
            scene.mapper.SelectScalarArray(array)

    return change


refuse(select("CellData", None), select("PointData", None), "there are no cell scalars")
refuse(
    select("PointFieldData", "vawe"), select("PointFieldData", "wave"),
    "there is no point array 'vawe'")
refuse(select("CellFieldData", 7), select("PointFieldData", 0), "there is no cell array 7")
refuse(select("PointFieldData", -1), select("PointFieldData", 0), "there is no point array -1")
refuse(
    lambda scene: scene.volume.GetProperty().SetScalarOpacityUnitDistance(0),
    lambda scene: scene.volume.GetProperty().SetScalarOpacityUnitDistance(0.2),
    "unit distance")
refuse(
    lambda scene: scene.volume.SetScale(1, 0, 1), lambda scene: scene.volume.SetScale(1),
    "no inverse")

# A camera that looks nowhere draws nothing or something, but goes on.
scene = gv.Scene(MESH)
errors = gv.gm.Errors(scene.mapper)
scene.camera.SetPosition(scene.camera.GetFocalPoint())
scene.render()
scene.camera.SetViewUp(0, 0, 0)
scene.render()
scene.look(1.2, 0.7)
gv.require_same(scene.render(), RIGHT)

# A window or viewport without pixels.
scene = gv.Scene(MESH, viewport=(0.5, 0.5, 0.5, 0.5))
scene.render()
scene.renderer.SetViewport(0, 0, 1, 1)
gv.require_same(scene.render(), RIGHT)

# Nothing connected, in or out of a window.
scene = gv.Scene(MESH)
scene.mapper.RemoveAllInputs()
assert is_empty(scene.render())
assert scene.mapper.GetDataSetInput() is None
scene.mapper.Update()
assert scene.mapper.GetBounds()[0] > scene.mapper.GetBounds()[1]
give(MESH)(scene)
gv.require_same(scene.render(), RIGHT)

# Files that are not there, are none, or are damaged: at their beginning, and in a chunk.
path = gv.gm.temporary("mapper-errors.gtn")
gv.gm.write(MESH, path, ChunkSize=1024)
with open(path, "rb") as file:
    good = file.read()


def put(data):
    def change(_scene):
        os.remove(path)
        with open(path, "wb") as file:
            file.write(data)

    return change


def in_file(change, *texts):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    refuse(change, put(good), *texts, source=reader)


def flip(place):
    damaged = bytearray(good)
    damaged[place] ^= 0xFF
    return put(bytes(damaged))


in_file(put(b""), path)
in_file(put(b"no mesh at all" * 100), path)
in_file(put(good[: len(good) // 2]), path)
for place in (0, len(good) // 3, len(good) // 2):
    in_file(flip(place), path)
reader = vtkGatunReader()
reader.SetFileName(path)
refuse(
    lambda _: reader.SetFileName("/no/such/file.gtn"), lambda _: reader.SetFileName(path),
    "/no/such/file.gtn", source=reader)

# A pipeline that fails in one of its pieces.
elevation = vtkElevationFilter()
elevation.SetInputConnection(reader.GetOutputPort())
reader_errors = gv.gm.Errors(reader)
scene = gv.Scene(elevation, NumberOfPieces=3)
errors = gv.gm.Errors(scene.mapper)
elevation.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
picture = scene.render()
flip(len(good) // 2)(None)
for _ in range(3):
    assert is_empty(scene.render())
assert reader_errors.messages and len(errors.messages) == 1, str(errors)
put(good)(None)
gv.require_same(scene.render(), picture)


# Stopped in the middle of a picture, and before it begins.
class Stopper:
    """Notes progress, and stops at the n-th sign of it."""

    def __init__(self, scene):
        self.window, self.after, self.progress = scene.window, None, []
        scene.mapper.AddObserver("ProgressEvent", self.note)

    def note(self, mapper, _event):
        self.progress.append(mapper.GetProgress())
        if self.after is not None and len(self.progress) > self.after:
            self.window.SetAbortRender(1)

    def render(self, scene, after=None):
        self.progress, self.after = [], after
        return scene.render()


big = gv.wave(34)
gv.gm.write(big, path, ChunkSize=8192)
elevation = vtkElevationFilter()
elevation.SetInputDataObject(big)
elevation.SetLowPoint(0, 0, 0)
reader = vtkGatunReader()
reader.SetFileName(path)
piecewise = vtkElevationFilter()
piecewise.SetInputConnection(reader.GetOutputPort())
for source, pieces in ((big, 1), (reader, 1), (elevation, 1), (piecewise, 4)):
    whole = gv.Scene(source, NumberOfPieces=pieces).render()
    scene = gv.Scene(source, NumberOfPieces=pieces)
    errors = gv.gm.Errors(scene.mapper)
    stopper = Stopper(scene)
    gv.require_same(stopper.render(scene), whole)
    progress = stopper.progress
    assert progress[-1] == 1 and len(progress) > 4, progress
    assert scene.mapper.GetTimeToDraw() > 0
    for after in (0, len(progress) // 2):
        scene.look(0.3, 0.3)
        stopper.render(scene, after)
        assert len(stopper.progress) == after + 1
        assert scene.mapper.GetTimeToDraw() == 0
        scene.look(1.2, 0.7)
        gv.require_same(stopper.render(scene), whole)
        # Stopped before there is anything.
        fresh = gv.Scene(source, NumberOfPieces=pieces)
        other = Stopper(fresh)
        other.render(fresh, after)
        assert len(other.progress) == after + 1
        gv.require_same(other.render(fresh), whole)
    assert not errors.messages, str(errors)

# A window that goes, and another one with the same mapper.
scene = gv.Scene(MESH)
scene.render()
scene.window.Finalize()
other = gv.Scene(MESH)
other.volume.SetMapper(scene.mapper)
gv.require_same(other.render(), RIGHT)
assert "NumberOfPieces: 1" in str(other.mapper)
