# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A picture of the boundary of the sample mesh."""

import gatunSample as sample
from paraview import simple, smtesting


def compare_picture(reader):
    """Draws the surface of what is read, colored by "wave", and compares it with the baseline."""
    view = simple.CreateRenderView()
    view.ViewSize = [200, 200]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.3, 0.4]
    # Without light, so that normals at the borders of parts play no role, and with edges, so that a
    # face too many shows.
    shown = simple.Show(reader, view)
    shown.SetRepresentationType("Surface With Edges")
    shown.Ambient, shown.Diffuse, shown.Specular = 1, 0, 0
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
