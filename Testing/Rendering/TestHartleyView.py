# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A projection has the view of its camera and the colors of its property, and follows their
changes."""

import numpy as np
from vtkmodules.vtkCommonTransforms import vtkTransform

import gatunHartley as gh
import gatunMeshes as gm
import gatunRays as gr
from gatun.vtk import vtkGatunErrorCode, vtkGatunHartleyProjection

SIZE = (60, 44)
field = gh.blobs((14, 11, 17), seed=3, scale=100).astype(np.float32)
image = gh.make_volume(field, (0, 0, 0), (3, -2, 1), (0.5, 1.5, 2))
center = np.array(image.GetCenter())
colors = gr.make_property([(0, 0, 0, 1), (100, 1, 0.5, 0)], [(0, 0), (100, 0.3)], 2)


def draw(camera=None, **options):
    return gr.draw(image, camera, "RGBA", Size=SIZE, **options)


def same(one, other):
    return abs(one - other).max() < 1e-4


# The rays are those of the camera: sums against integrals by numpy.
direction, up = np.array((0.3, -0.5, -1)), np.array((0.1, 1, 0.2))
focus = center + (0.5, 1, -0.3)
camera = gr.make_camera(direction, up, focus, 12)
exact = gr.integrals(image, field, camera, SIZE)
sums = gr.draw(image, camera, "Sum", Size=SIZE, OpacityModel=0, SampleDistance=0.5, Method=1,
               **gr.LOSSLESS)
assert abs(0.5 * sums - exact).mean() < 2e-3 * exact.max()
expected = draw(camera, Property=colors)
assert expected[..., 3].max() > 0.1
# A magnification is a smaller scale.
wide = gr.make_camera(direction, up, focus, 24)
wide.Zoom(2)
assert same(draw(wide, Property=colors), expected)
# The focal point's depth does not matter, and the clipping range neither.
camera.SetClippingRange(1, 1.1)
assert same(draw(camera, Property=colors), expected)
away = gr.make_camera(direction, up, focus + 3 * direction, 12)
assert same(draw(away, Property=colors), expected)

# A window center moves the image by parts of its size.
camera.SetWindowCenter(2 * 10 / SIZE[0], 2 * -6 / SIZE[1])
moved = draw(camera, Property=colors)
assert same(moved[6:, :-10], expected[:-6, 10:]), abs(moved[6:, :-10] - expected[:-6, 10:]).max()
camera.SetWindowCenter(0, 0)

# A rigid transform of the user turns the view.
turn = vtkTransform()
turn.RotateZ(90)
camera.SetUserViewTransform(turn)
square = gr.make_projection(image, camera, Size=(50, 50), Property=colors)
square.Update()
turned = gr.array_of(square, "RGBA").copy()
camera.SetUserViewTransform(None)
square.Update()
assert same(turned, np.rot90(gr.array_of(square, "RGBA"), -1))  # rows run from below

# Others are refused, as is perspective; the next image is right.
projection = gr.make_projection(image, camera, Size=SIZE, Property=colors)


def refuse(text):
    errors = gm.Errors(projection)
    projection.Update()
    assert projection.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
    assert len(errors.messages) == 1 and text in str(errors), str(errors)
    assert projection.GetOutput().GetNumberOfPoints() == 0
    projection.RemoveAllObservers()


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
projection.Update()
assert projection.GetErrorCode() == 0 and same(gr.array_of(projection, "RGBA"), expected)

# Changes of the property's functions are followed, and a gray function stands for three. Null: the
# defaults.
colors.GetScalarOpacity().AddPoint(50, 0.9)
projection.Update()
assert not same(gr.array_of(projection, "RGBA"), expected)
gray = gr.make_property([], [(0, 0), (100, 0.3)], 2)
gray.SetColor(colors.GetScalarOpacity())
as_colors = gr.make_property([(0, 0, 0, 0), (50, 0.9, 0.9, 0.9), (100, 0.3, 0.3, 0.3)],
                             [(0, 0), (100, 0.3)], 2)
assert same(draw(camera, Property=gray), draw(camera, Property=as_colors))
projection.SetProperty(None)
projection.Update()
low, high = float(field.min()), float(field.max())
span = np.array(image.GetBounds()).reshape(3, 2)
ramp = gr.make_property([(low, 0, 0, 0), (high, 1, 1, 1)], [(low, 0), (high, 1)],
                        np.linalg.norm(span[:, 1] - span[:, 0]) / 30)
assert abs(gr.array_of(projection, "RGBA") - draw(camera, Property=ramp)).max() < 2e-3

# Without an input there is nothing that a camera could be moved to.
assert not vtkGatunHartleyProjection().ResetCamera(camera)
assert not projection.ResetCamera(None)
