# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces of a file that is read on demand look the same on any number of ranks, with smooth light
across the borders of what each of them made."""

import gatunSample as sample
from gatunParaView import load_plugin
from paraview import smtesting

smtesting.ProcessCommandLineArguments()
simple = load_plugin()
path = sample.temporary("contour-picture.gtn")
mesh = sample.make_source()
mesh.UpdatePipeline()
simple.SaveData(path, proxy=mesh, ChunkSize=300)
reader = simple.OpenDataFile(path)
reader.LargeMesh = 0
reader.UpdatePipeline()
surface = simple.GatunContour(Input=reader)
surface.ContourBy = ["POINTS", "wave"]
surface.Isosurfaces = [0, 1.1, 2.3]

view = simple.CreateRenderView()
view.ViewSize = [300, 300]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.2, 0.3, 0.4]
outline = simple.Show(reader, view)
outline.SetRepresentationType("Wireframe")
outline.AmbientColor = outline.DiffuseColor = [0.9, 0.9, 0.9]
shown = simple.Show(surface, view)
shown.SetRepresentationType("Surface")
shown.Specular = 0.6
simple.ColorBy(shown, ("POINTS", "wave"))
shown.SetScalarBarVisibility(view, False)
table = simple.GetColorTransferFunction("wave")
table.ApplyPreset("Cool to Warm", True)
table.RescaleTransferFunction(-1.5, 3)
view.CameraPosition = [sample.SIDE * f for f in (2.4, 1.9, 2.2)]
view.CameraFocalPoint = [sample.SIDE * f for f in (0.5, 0.5, 0.5)]
view.CameraViewUp = [0, 0, 1]
view.ResetCamera()
simple.Render(view)
if not smtesting.DoRegressionTesting(view.SMProxy):
    raise smtesting.TestError("the picture differs")
