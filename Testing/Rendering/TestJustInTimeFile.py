# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A file that has a hierarchy is drawn with any number of points: as the mapper, the ray caster or the
reader asks for it, straight from the file, with the picture of the simplified mesh in memory."""

import math

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunReader

AT_REST = 0.0001  # pictures a second
IN_MOTION = 20.0
N = 20
POINTS = (N + 1) ** 3


def make_reader(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    for name, value in options.items():
        getattr(reader, "Set" + name)(value)
    return reader


def make(source, **options):
    scene = gv.Scene(source, (200, 200), **options)
    scene.look(0.3, 0.4, distance=2)
    return scene


def listen(mapper):
    """Warnings of a mapper, from now on."""
    heard = []

    @calldata_type(VTK_STRING)
    def note(_object, _event, text):
        heard.append(text)

    mapper.AddObserver("WarningEvent", note)
    return heard


def at(scene, rate):
    scene.window.SetDesiredUpdateRate(rate)
    return scene.render()


mesh = gv.wave(N)
files = [gm.temporary(f"jit{i}.gtn") for i in range(3)]
gm.write(mesh, files[0], ChunkSize=1500, Hierarchy=True)
gm.write(mesh, files[1], ChunkSize=1500, Hierarchy=True, Levels=5)
gm.write(mesh, files[2], ChunkSize=1500)
full = at(make(mesh), AT_REST)

for path in files[:2]:
    for ratio in 0.3, 0.8, 0.97:
        simple = make_reader(path, SimplificationRatio=ratio)
        simple.Update()
        asked = POINTS - math.floor(POINTS * ratio)
        assert 0.9 * asked < simple.GetOutput().GetNumberOfPoints() <= asked
        expected = at(make(simple.GetOutput()), AT_REST)
        assert ratio < 0.9 or gv.difference(expected, full) > 0.005, gv.difference(expected, full)
        # By the mapper, with next to no memory for it and with enough.
        for budget in 0, 100:
            scene = make(make_reader(path, MemoryBudget=budget), SimplificationRatio=ratio)
            gv.require_same(at(scene, AT_REST), expected)
            assert gm.statistic(scene.mapper, "DrawnPoints") == POINTS - math.floor(POINTS * ratio)
        # By the reader, whose mesh is never made.
        reader = make_reader(path,
                             SimplificationNumberOfPoints=POINTS - math.floor(POINTS * ratio))
        scene = make(reader)
        gv.require_same(at(scene, AT_REST), expected)
        assert reader.GetOutput().GetNumberOfCells() == 0
        # The mapper may ask for less than the reader, which changes nothing, or for more.
        scene.mapper.GetDetailPolicy().SetSimplificationRatio(ratio / 2)
        gv.require_same(at(scene, AT_REST), expected)
        scene.mapper.GetDetailPolicy().SetSimplificationRatio(0.99)
        at(scene, AT_REST)
        assert gm.statistic(scene.mapper, "DrawnPoints") == POINTS - math.floor(POINTS * 0.99)
        # By the ray caster.
        camera = dict(Camera=scene.camera, Property=scene.volume.GetProperty(), Size=(90, 90))
        of_mesh = gv.draw(simple.GetOutput(), **camera)[0]
        for options in dict(SimplificationRatio=ratio), dict(source=reader):
            source = options.pop("source", make_reader(path))
            of_file = gv.draw(source, **options, **camera)[0]
            assert abs(of_file - of_mesh).max() <= 2 / 255

    # In motion and at rest.
    scene = make(make_reader(path), JustInTime=True, TimeBudget=1e-6, ViewDependent=False)
    assert gv.difference(at(scene, AT_REST), full) <= 2 / 255
    assert scene.mapper.PrepareSimplification()
    for _ in range(4):
        picture = at(scene, IN_MOTION)
        assert scene.mapper.PrepareSimplification()
    assert gm.statistic(scene.mapper, "DrawnPoints") == 500
    assert gv.difference(picture, full) > 0.02
    assert gv.difference(at(scene, AT_REST), full) <= 2 / 255

# What cannot be done is said; what can be is drawn.
scene = make(make_reader(files[2]), JustInTime=True)
heard = listen(scene.mapper)
assert gv.difference(at(scene, AT_REST), full) <= 2 / 255
at(scene, AT_REST)
assert "".join(heard).count("no hierarchy in the file; make one with gtn pack") == 1, heard
reader = make_reader(files[2], SimplificationRatio=0.5)
messages = gm.Errors(reader)
assert gv.difference(at(make(reader), AT_REST), full) > 0.02  # nothing is drawn
assert "there is no hierarchy" in str(messages)
for ratio, clamped in (-0.5, 0), (1.5, 1):
    scene = make(make_reader(files[0]), SimplificationRatio=ratio)
    assert scene.mapper.GetDetailPolicy().GetSimplificationRatio() == clamped
scene = make(make_reader(files[0]), SimplificationRatio=float("nan"))
messages = gm.Errors(scene.mapper)
at(scene, AT_REST)
assert "SimplificationRatio is not a number" in str(messages), str(messages)
