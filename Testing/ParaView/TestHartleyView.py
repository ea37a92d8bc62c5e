# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Hartley draws a volume from its coefficients as ParaView's own Volume does from its voxels: seen
by the camera of the view, colored by the color map, behind and in front of other geometry. Argument: the
picture, with a ball behind the volume."""

import os
import sys

import gatunSample as sample
import gatunVolume as drawing
import numpy as np
from gatunParaView import load_plugin
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

simple = load_plugin()
# Another origin than zero, and edges of different lengths.
wavelet = simple.Wavelet(WholeExtent=[0, 31, -9, 14, -12, 11])
path = sample.temporary("view.ghv")
simple.SaveData(path, proxy=wavelet, RateControl="RMS Error", RMSError=0, BlockSize=4)
reader = simple.OpenDataFile(path)
reader.UpdatePipeline()

view = drawing.make_view()
view.CameraPosition, view.CameraFocalPoint = [80, 50, 60], [15.5, 2.5, -0.5]
background = drawing.draw(view)
shown = simple.Show(reader, view)
assert not shown.ColorArrayName[1], shown.ColorArrayName
shown.SetRepresentationType("Gatun Hartley")
assert list(shown.ColorArrayName) == ["POINTS", "RTData"], shown.ColorArrayName
assert view.CameraParallelProjection == 1
# As much as before: the sine of half the view angle of 30 degrees.
distance = np.linalg.norm(np.subtract(view.CameraPosition, view.CameraFocalPoint))
assert abs(view.CameraParallelScale - distance * np.tan(np.radians(15))) < 1e-6
shown.SetScalarBarVisibility(view, False)
low, high = reader.PointData["RTData"].GetRange()
colors = simple.GetColorTransferFunction("RTData")
colors.ColorSpace = "RGB"
colors.RGBPoints = [low, 0.1, 0.1, 0.9, (low + high) / 2, 0.9, 0.9, 0.2, high, 0.9, 0.1, 0.1]
opacities = simple.GetOpacityTransferFunction("RTData")
opacities.Points = [low, 0, 0.5, 0, 0.5 * (low + high), 0.02, 0.5, 0, high, 0.3, 0.5, 0]
shown.ScalarOpacityUnitDistance = 2
hartley = drawing.draw(view)
drawing.require_other(hartley, background)


# ParaView's picture of the voxels is close: a block of the projection has one value along a ray.
def compare_to_volume():
    have = drawing.draw(view)
    shown.SetRepresentationType("Volume")
    volume = drawing.draw(view)
    shown.SetRepresentationType("Gatun Hartley")
    drawing.require_other(volume, background)
    # At that place, and nowhere else.
    off = np.abs(have - volume).mean()
    for wrong in (volume[::-1], volume[:, ::-1], np.roll(volume, 16, 0), np.roll(volume, 16, 1),
                  np.roll(volume, -16, 0), np.roll(volume, -16, 1), background):
        assert off < 0.5 * np.abs(have - wrong).mean(), (off, np.abs(have - wrong).mean())


compare_to_volume()
# From another side, and with another color map.
view.CameraPosition = [-60, -70, 30]
compare_to_volume()
drawing.require_other(drawing.draw(view), hartley)
view.CameraPosition = [80, 50, 60]
# Moved, turned and scaled.
place = "Translation" if hasattr(shown, "Translation") else "Position"
setattr(shown, place, [4, -3, 2])
shown.Orientation, shown.Scale = [20, 30, 10], [0.8, 0.8, 0.8]
drawing.require_other(drawing.draw(view), hartley)
compare_to_volume()
setattr(shown, place, [0, 0, 0])
shown.Orientation, shown.Scale = [0, 0, 0], [1, 1, 1]
drawing.require_same(drawing.draw(view), hartley)

# The Color Map Editor, the models, and the interaction.
points = list(opacities.Points)
opacities.Points = [low, 0.3, 0.5, 0, high, 0, 0.5, 0]
drawing.require_other(drawing.draw(view), hartley)
opacities.Points = points
for model in ("X-Ray", "Exponential"):
    shown.HartleyOpacityModel = model
    drawing.require_other(drawing.draw(view), hartley)
shown.HartleyOpacityModel = "Transfer Function"
view.SMProxy.InteractiveRender()
drawing.require_same(drawing.draw(view), hartley)

# A ball in front of the center hides what is behind it; one behind it is seen through the volume.
pictures = []
for side in (1, -1):
    ball = simple.Sphere(Radius=6, ThetaResolution=32, PhiResolution=32,
                         Center=[15.5 + 16 * side, 2.5 + 12 * side, -0.5 + 15 * side])
    geometry = simple.Show(ball, view)
    geometry.DiffuseColor = geometry.AmbientColor = [0, 1, 0]
    geometry.Ambient, geometry.Diffuse, geometry.Specular = 1, 0, 0
    pictures.append(drawing.draw(view))
    simple.Hide(ball, view)
green = [int(((p == [0, 255, 0]).all(2)).sum()) for p in pictures]
assert green[0] > 500 and green[1] < green[0] / 4, green
drawing.require_other(pictures[1], hartley)

simple.Show(ball, view)
simple.SaveScreenshot(os.path.join(os.environ["GATUN_TEST_TEMP"], "TestHartleyView.png"), view)
have = drawing.draw(view)
file = vtkPNGReader()
file.SetFileName(sys.argv[1])
file.Update()
expected = vtk_to_numpy(file.GetOutput().GetPointData().GetScalars())
expected = expected.reshape(drawing.SIZE, drawing.SIZE, -1)[:, :, :3].astype(int)
drawing.require_same(expected, have, by=3)
