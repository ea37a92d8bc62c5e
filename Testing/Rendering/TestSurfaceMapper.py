# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A surface that is drawn chunk by chunk from its file looks like the whole one in VTK's mapper: in all
views, representations, colors and transparencies, wherever it is in space."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkRenderingCore import vtkTexture

import gatunMeshes as gm
import gatunPolyData as pd
from gatunSurfaceScene import VIEWS, Scene, ball, pair, require_equal

CHUNK = 1000
path = gm.temporary("surface.gtn")
surface = ball(40)
gm.write(surface, path, ChunkSize=CHUNK)
both = ours, theirs = pair(path)


def of_both(*calls):
    """Calls a method of the object that is found in each scene."""
    for scene in both:
        for find, name, *values in calls:
            getattr(find(scene), name)(*values)


def mapper(scene):
    return scene.mapper


def look(scene):
    return scene.actor.GetProperty()


def same(what, share=0.0, views=VIEWS):
    pictures = []
    for view in views:
        for scene in both:
            scene.look(*view)
        pictures.append(require_equal(ours, theirs, (what, view), share))
    return pictures


# The reader decodes nothing, and bounds and ranges are there.
assert ours.actor.GetBounds() == theirs.actor.GetBounds()
plain = same("plain")
assert ours.mapper.GetIsDrawingFile() and ours.mapper.GetErrorCode() == 0
assert gm.statistic(ours.source, "DecodedChunks") == 0 and ours.source.GetOutput().GetNumberOfCells() == 12
assert gm.statistic(ours.mapper, "DrawnChunks") > 5

# Colors.
of_both((mapper, "SetScalarRange", -1, 2))
scalars = same("point scalars")
assert np.abs(scalars[0] - plain[0]).max() > 50
of_both((mapper, "SetInterpolateScalarsBeforeMapping", 1))
same("interpolated scalars")
of_both((mapper, "SetInterpolateScalarsBeforeMapping", 0), (mapper, "SetScalarModeToUseCellData"),
        (mapper, "SetScalarRange", 0, 50))
same("cell scalars")
of_both((mapper, "SetScalarModeToUsePointFieldData"), (mapper, "SelectColorArray", "direction"),
        (mapper, "SetScalarRange", -1, 1))
table = vtkLookupTable()
table.SetVectorModeToComponent()
table.SetVectorComponent(1)
table.Build()
of_both((mapper, "SetLookupTable", table), (mapper, "SetUseLookupTableScalarRange", 1))
table.SetRange(-1, 1)
same("component")
of_both((mapper, "ColorByArrayComponent", 0, 0))
same("array by number")
of_both((mapper, "SetScalarModeToUseCellFieldData"), (mapper, "SelectColorArray", "colors"),
        (mapper, "SetColorModeToDirectScalars"))
# Transparent, in the order of cells without peeling.
of_both((mapper, "ScalarVisibilityOff",))
uncolored = same("no scalars")

# Properties.
for name, value in (("Interpolation", 0), ("EdgeVisibility", 1), ("Representation", 1),
                    ("LineWidth", 5), ("Representation", 0), ("PointSize", 6),
                    ("RenderPointsAsSpheres", 1)):
    of_both((look, "Set" + name, value))
    same(name)
    for scene in both:
        scene.look(0, 0, 5)
    require_equal(ours, theirs, (name, "close"))
of_both((look, "SetRepresentationToSurface",), (look, "EdgeVisibilityOff",),
        (look, "SetInterpolationToGouraud",))
for name in "BackfaceCullingOn", "FrontfaceCullingOn", "BackfaceCullingOff", "FrontfaceCullingOff":
    of_both((look, name))
    if name == "BackfaceCullingOff":
        inside = same(name)
        assert np.abs(inside[0] - uncolored[0]).max() > 20
    elif name != "FrontfaceCullingOn":
        same(name)

# Clipping planes, transformations, parallel projection.
plane = vtkPlane()
plane.SetNormal(1, 2, 3)
of_both((mapper, "AddClippingPlane", plane))
assert np.abs(same("clipped")[0] - uncolored[0]).max() > 20
of_both((mapper, "RemoveAllClippingPlanes",))
of_both((lambda scene: scene.actor, "SetScale", -1, 2, 0.5),
        (lambda scene: scene.actor, "RotateX", 40), (lambda scene: scene.camera, "ParallelProjectionOn"))
same("transformed")
of_both((look, "BackfaceCullingOn",))
same("mirrored")
of_both((look, "BackfaceCullingOff",), (lambda scene: scene.camera, "ParallelProjectionOff"))

# Transparency, peeled so that the order of cells does not matter.
for scene in both:
    scene.renderer.SetUseDepthPeeling(1)
    scene.renderer.SetMaximumNumberOfPeels(20)
    scene.renderer.SetOcclusionRatio(0)
    scene.window.SetAlphaBitPlanes(1)
of_both((look, "SetOpacity", 0.4))
clear = same("transparent", 0.002)
assert np.abs(clear[0] - uncolored[0]).max() > 20
of_both((look, "SetOpacity", 1), (mapper, "ScalarVisibilityOn"))
same("transparent colors", 0.002)
of_both((mapper, "ScalarVisibilityOff"))

# A texture.
canvas = vtkImageCanvasSource2D()
canvas.SetExtent(0, 63, 0, 63, 0, 0)
canvas.SetScalarTypeToUnsignedChar()
canvas.SetNumberOfScalarComponents(3)
for i in range(8):
    canvas.SetDrawColor(32 * i, 255 - 20 * i, 100)
    canvas.FillBox(8 * i, 8 * i + 7, 0, 63)
for scene in both:  # VTK 9.6 does not move a texture from one window to another
    texture = vtkTexture()
    texture.SetInputConnection(canvas.GetOutputPort())
    scene.actor.SetTexture(texture)
# At equal depth, as at the poles, the order of chunks decides.
textured = same("texture", 0.001)
assert np.abs(textured[0] - uncolored[0]).max() > 50
ours.window.Finalize()
theirs.window.Finalize()

# Far from the origin, small and large: chunks fit together.
for place, radius, kind in (((1e6, -2e6, 5e5), 1, np.float64), ((0, 0, 0), 1e-3, np.float32),
                            ((3e7, 0, 0), 1e4, np.float64)):
    gm.write(ball(30, radius, place, kind), path, ChunkSize=CHUNK)
    both = ours, theirs = pair(path)
    same(("place", place, radius), 0.0005)

# Cells of all lists, and without any.
for what in pd.add_arrays(pd.mixed(30)), pd.make(np.zeros((0, 3))), pd.odd():
    gm.write(what, path, ChunkSize=100)
    both = ours, theirs = pair(path)
    if what.GetNumberOfPoints() > 100:
        same("mixed")
    else:
        ours.render()
        assert ours.mapper.GetErrorCode() == 0

# Any other input is drawn as VTK's mapper draws it; so is a reader that is not on demand.
for source in surface, pd.reader_of(path):
    both = ours, theirs = Scene(source), Scene(source, False)
    if source is surface:
        same("data")
    else:
        assert np.array_equal(ours.render(), theirs.render())
    assert not ours.mapper.GetIsDrawingFile() and gm.statistic(ours.mapper, "DecodedChunks") == 0
    for scene in both:
        scene.window.Finalize()
