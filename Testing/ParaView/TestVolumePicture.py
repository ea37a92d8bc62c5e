# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Volume shows the same of a mesh in memory and of a file on demand, on any number of ranks: the
picture that vtkGatunRayCaster made. On demand, only what is seen is read.

Arguments: the picture, of the mesh of gatunSample.py with the camera and the transfer function of gatunVolume.py.
"""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
# Among several ranks, the volume is rounded before it is blended over the background.
among_ranks = {"by": 2 if ranks == 1 else 3, "pixels": 0}

path = sample.temporary("volume.gtn")
simple.SaveData(path, proxy=sample.make_source(), ChunkSize=300)
view = drawing.make_view()
background = drawing.draw(view)
# A large mesh is the second by itself.
readers = [simple.GatunReader(FileNames=[path]),
           simple.GatunReader(FileNames=[path], LargeMesh=1000)]
shown = []
for reader, is_outline in zip(readers, (0, 1)):
    reader.UpdatePipeline()
    reader.UpdatePropertyInformation()
    assert reader.GetProperty("IsOnDemand").GetData() == is_outline
    shown.append(drawing.show(reader, view))
    simple.Hide(reader, view)
assert sample.counts(readers[0])[1] >= sample.TETS
assert sample.counts(readers[1]) == (8, 12)
assert "Gatun Volume" in shown[0].GetProperty("Representation").GetAvailable()


def pictures():
    made = []
    for reader in readers:
        simple.Show(reader, view)
        made.append(drawing.draw(view))
        simple.Hide(reader, view)
    drawing.require_other(made[0], background)
    return made


def set_both(**properties):
    for one in shown:
        for name, value in properties.items():
            setattr(one, name, value)


# What was drawn without ParaView.
file = vtkPNGReader()
file.SetFileName(sys.argv[1])
file.Update()
expected = vtk_to_numpy(file.GetOutput().GetPointData().GetScalars())
expected = expected.reshape(drawing.SIZE, drawing.SIZE, -1)[:, :, :3].astype(int)
first = pictures()
if drawing.differing(expected, first[1], among_ranks["by"]) > among_ranks["pixels"]:
    simple.Show(readers[1], view)
    simple.SaveScreenshot(os.path.join(os.environ["GATUN_TEST_TEMP"], "TestVolumePicture.png"), view)
    simple.Hide(readers[1], view)
drawing.require_same(expected, first[1], **among_ranks)


def require_both_same():
    made = pictures()
    drawing.require_same(*made)
    return made[1]


require_both_same()

# Modes.
for mode in (1, 101):
    set_both(BlendMode=mode)
    drawing.require_other(require_both_same(), first[1])
set_both(BlendMode=0)
drawing.require_same(pictures()[1], first[1])

# From inside the mesh, and in a parallel projection.
drawing.look(view, 0.52, 0.2, 0.61)
require_both_same()
drawing.look(view, 2.9, 2.2, 2.6)
view.CameraParallelProjection = 1
view.CameraParallelScale = 1.1 * sample.SIDE
require_both_same()
view.CameraParallelProjection = 0

# Moved, turned and stretched.
place = drawing.place_name(shown[0])
set_both(**{place: [3, 0, -2]}, Orientation=[20, 30, 10], Scale=[0.7, 1, 1.2])
drawing.require_other(require_both_same(), first[1])
set_both(**{place: [0, 0, 0]}, Orientation=[0, 0, 0], Scale=[1, 1, 1])
drawing.require_same(pictures()[1], first[1])

# Opaque geometry inside hides what is behind it, and only that.
ball = simple.Sphere(Center=[sample.SIDE * 0.6] * 3, Radius=3, ThetaResolution=32,
                     PhiResolution=32)
geometry = simple.Show(ball, view)
geometry.DiffuseColor = geometry.AmbientColor = [0, 1, 0]
geometry.Ambient, geometry.Diffuse, geometry.Specular = 1, 0, 0
with_ball = require_both_same()
drawing.require_other(with_ball, first[1])
simple.Hide(ball, view)
green = drawing.differing(with_ball, first[1])
assert green < 0.3 * drawing.SIZE ** 2, green

# The unit distance.
set_both(ScalarOpacityUnitDistance=30)
drawing.require_other(require_both_same(), first[1])
set_both(ScalarOpacityUnitDistance=3)

# What ParaView takes by itself is that of the cells, which an outline has few of.
fresh = []
for reader in readers:
    other = simple.CreateRenderView()
    other.ViewSize = [drawing.SIZE, drawing.SIZE]
    new = simple.Show(reader, other)
    fresh.append(new.ScalarOpacityUnitDistance)
    simple.Delete(other)
assert fresh[1] > 5 * fresh[0], fresh
if ranks == 1:
    for one, distance in zip(shown, fresh):
        one.ScalarOpacityUnitDistance = distance
    drawing.require_same(*pictures())
set_both(ScalarOpacityUnitDistance=3)

# Only what is seen is read, and once.
size = os.path.getsize(path)
one = simple.GatunReader(FileNames=[path], LargeMesh=0)
part = drawing.show(one, view)
drawing.look(view, -3, 0.05, 0.05)
view.CameraFocalPoint = [0, 0.05 * sample.SIDE, 0.05 * sample.SIDE]
view.CameraViewAngle = 1


def bytes_read():
    drawing.draw(view)
    part.UpdatePropertyInformation()
    return part.GetProperty("BytesRead").GetElement(0)


few = bytes_read()
assert 0 < few < 0.7 * size, (few, size)
assert bytes_read() == few
drawing.look(view, 2.9, 2.2, 2.6)
many = bytes_read()
assert few < many < size, (few, many, size)
one.MemoryBudget = 0
assert bytes_read() > many
drawing.require_same(drawing.draw(view), first[1])
