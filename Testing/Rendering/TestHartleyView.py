# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunHartleyView sets a projection from a camera and a property as plain parameters do."""

import numpy as np
from vtkmodules.vtkCommonTransforms import vtkTransform

import gatunHartley as gh
import gatunMeshes as gm
import gatunRays as gr
from gatun import vtkGatunHartleyProjection, vtkGatunHartleyView

SIZE = (60, 44)
field = gh.blobs((14, 11, 17), seed=3, scale=100).astype(np.float32)
image = gh.make_volume(field, (0, 0, 0), (3, -2, 1), (0.5, 1.5, 2))
center = np.array(image.GetCenter())
colors = gr.make_property([(0, 0, 0, 1), (100, 1, 0.5, 0)], [(0, 0), (100, 0.3)], 2)


def draw(camera=None, **options):
    return gr.draw(image, camera, "RGBA", Size=SIZE, **options)


def same(one, other):
    return abs(one - other).max() < 1e-4


# Camera and property against the parameters that they stand for.
direction, up = np.array((0.3, -0.5, -1)), np.array((0.1, 1, 0.2))
camera = gr.make_camera(direction, up, center + (0.5, 1, -0.3), 12)
expected = draw(ViewDirection=tuple(7 * direction), ViewUp=tuple(up), UseFocalPoint=True,
                FocalPoint=tuple(center + (0.5, 1, -0.3)), ParallelScale=24, Zoom=2,
                ColorTransferFunction=colors.GetRGBTransferFunction(),
                ScalarOpacity=colors.GetScalarOpacity(), ScalarOpacityUnitDistance=2)
picture = draw(camera, Property=colors)
assert same(picture, expected) and picture[..., 3].max() > 0.1
# The focal point's depth does not matter, and the clipping range neither.
camera.SetClippingRange(1, 1.1)
assert same(draw(camera, Property=colors), expected)
away = center + (0.5, 1, -0.3) + 3 * direction
assert same(draw(gr.make_camera(direction, up, away, 12), Property=colors), expected)

# A window center moves the image by parts of its size.
camera.SetWindowCenter(2 * 10 / SIZE[0], 2 * -6 / SIZE[1])
moved = draw(camera, Property=colors)
assert same(moved[6:, :-10], expected[:-6, 10:]), abs(moved[6:, :-10] - expected[:-6, 10:]).max()
camera.SetWindowCenter(0, 0)

# A rigid transform of the user turns the view; others are refused, and change nothing.
turn = vtkTransform()
turn.RotateZ(90)
camera.SetUserViewTransform(turn)
square = gr.make_projection(image, camera, Size=(50, 50), Property=colors)
square.Update()
turned = gr.array_of(square, "RGBA").copy()
camera.SetUserViewTransform(None)
assert vtkGatunHartleyView.SetView(square, camera)
square.Update()
assert same(turned, np.rot90(gr.array_of(square, "RGBA"), -1))  # rows run from below
projection = gr.make_projection(image, camera, Size=SIZE)



def refuse(text):
    errors = gm.Errors(projection)
    assert not vtkGatunHartleyView.SetView(projection, camera)
    assert len(errors.messages) == 1 and text in str(errors), str(errors)
    projection.RemoveAllObservers()
    assert projection.GetViewDirection() == kept


kept = projection.GetViewDirection()
uneven = vtkTransform()
uneven.Scale(1, 2, 1)
camera.SetUserViewTransform(uneven)
refuse("unevenly")
camera.SetUserViewTransform(None)
camera.SetViewShear(0.3, 0.2, 0)
refuse("sheared")
camera.SetViewShear(0, 0, 1)
camera.ParallelProjectionOff()
refuse("perspective")
camera.ParallelProjectionOn()
assert vtkGatunHartleyView.SetView(projection, camera)
assert not vtkGatunHartleyView.SetView(projection, None)
assert not vtkGatunHartleyView.SetView(None, camera)

# Changes of the property's functions are followed. A gray function is copied. Null: the defaults.
projection = gr.make_projection(image, camera, Size=SIZE, Property=colors)
projection.Update()
colors.GetScalarOpacity().AddPoint(50, 0.9)
projection.Update()
assert not same(gr.array_of(projection, "RGBA"), expected)
gray = gr.make_property([], [(0, 0), (100, 0.3)], 2)
gray.SetColor(colors.GetScalarOpacity())
as_colors = gr.make_property([(0, 0, 0, 0), (50, 0.9, 0.9, 0.9), (100, 0.3, 0.3, 0.3)],
                             [(0, 0), (100, 0.3)], 2)
assert same(draw(camera, Property=gray), draw(camera, Property=as_colors))
vtkGatunHartleyView.SetProperty(projection, None)
projection.Update()
assert same(gr.array_of(projection, "RGBA"), draw(camera))
assert projection.GetColorTransferFunction() is None and projection.GetScalarOpacity() is None

# Without an input there is nothing that a camera could be moved to.
assert not vtkGatunHartleyView.ResetCamera(vtkGatunHartleyProjection(), camera)
assert str(vtkGatunHartleyView())
