# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The surface of a machine part: a flanged bearing block with ribs and bolt holes.

The part is the set of points where a function of space is negative, put together from the
distances to boxes and cylinders; soft minima in place of plain ones make the fillets. Lengths are
in millimetres.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

HUB_RADIUS = 21.0
BORE_RADIUS = 13.0
TOP = 64.0
BOLTS = [(x, y) for x in (-46.0, 46.0) for y in (-28.0, 28.0)]
BOLT_RADIUS = 5.5
COUNTERBORE_RADIUS = 10.0
BASE_HEIGHT = 12.0
FLANGE_RADIUS = 31.0
FLANGE_HOLES = [(x, y) for x in (-17.5, 17.5) for y in (-17.5, 17.5)]
FLANGE_HOLE_RADIUS = 3.3


def _soft_min(a, b, radius):
    """The smaller of a and b, with a transition where they are less than radius apart."""
    h = np.maximum(radius - np.abs(a - b), 0.0) / radius
    return np.minimum(a, b) - 0.25 * radius * h * h


def _soft_max(a, b, radius):
    return -_soft_min(-a, -b, radius)


def _slab(v, low, high):
    return np.abs(v - 0.5 * (low + high)) - 0.5 * (high - low)


def _cylinder(p, center, radius):
    return np.hypot(p[0] - center[0], p[1] - center[1]) - radius


def _intersection(a, b):
    """Exact outside the corner, as a distance should be."""
    return np.minimum(np.maximum(a, b), 0.0) + np.hypot(np.maximum(a, 0.0), np.maximum(b, 0.0))


def _rib(p, along, across, reach):
    """A triangular plate from the hub's flange down to the base."""
    height = TOP - 14.0 - BASE_HEIGHT
    u = np.abs(along)
    slope = (height * (u - HUB_RADIUS) + (reach - HUB_RADIUS) * (p[2] - BASE_HEIGHT)) / np.hypot(
        height, reach - HUB_RADIUS
    ) - height * (reach - HUB_RADIUS) / np.hypot(height, reach - HUB_RADIUS)
    profile = np.maximum(slope, BASE_HEIGHT - 6.0 - p[2])
    return _soft_max(profile, np.abs(across) - 4.0, 2.0)


def distance(points):
    """The function itself: points is an array (n, 3), the result one of (n)."""
    p = points.T
    x, y = np.abs(p[0]), np.abs(p[1])
    corner = 13.0
    outline = (
        np.hypot(np.maximum(x - 60.0 + corner, 0.0), np.maximum(y - 42.0 + corner, 0.0))
        + np.minimum(np.maximum(x - 60.0 + corner, y - 42.0 + corner), 0.0)
        - corner
    )
    base = _soft_max(outline, _slab(p[2], 0.0, BASE_HEIGHT), 2.5)
    hub = _intersection(_cylinder(p, (0, 0), HUB_RADIUS), _slab(p[2], 2.0, TOP - 2.0))
    flange = _soft_max(
        _cylinder(p, (0, 0), FLANGE_RADIUS), _slab(p[2], TOP - 10.0, TOP), 2.0
    )
    body = _soft_min(base, hub, 9.0)
    body = _soft_min(body, _rib(p, p[0], p[1], 51.0), 7.0)
    body = _soft_min(body, _rib(p, p[1], p[0], 35.0), 7.0)
    body = _soft_min(body, flange, 9.0)
    # Fillets bulge where two surfaces meet at no angle: cut that off.
    body = _soft_max(body, _soft_max(outline, _slab(p[2], 0.0, TOP), 2.5), 2.5)

    body = _soft_max(body, -_cylinder(p, (0, 0), BORE_RADIUS), 2.0)
    for bolt in BOLTS:
        body = _soft_max(body, -_cylinder(p, bolt, BOLT_RADIUS), 1.5)
        sink = _intersection(
            _cylinder(p, bolt, COUNTERBORE_RADIUS), BASE_HEIGHT - 3.0 - p[2]
        )
        body = _soft_max(body, -sink, 1.2)
    for hole in FLANGE_HOLES:
        # Through the flange only, which begins 14 below the top, fillet included.
        drill = _intersection(_cylinder(p, hole, FLANGE_HOLE_RADIUS), TOP - 20.0 - p[2])
        body = _soft_max(body, -drill, 1.2)
    return body


def _gradient(points):
    step = 1e-4
    gradient = np.empty_like(points)
    for i in range(3):
        shift = np.zeros(3)
        shift[i] = step
        gradient[:, i] = (distance(points + shift) - distance(points - shift)) / (2 * step)
    return gradient


def _relax(points, triangles, rounds):
    """Evens out the triangles: points move towards their neighbors' mean, and back to the
    surface."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    count = np.bincount(edges[:, 0], minlength=len(points))[:, None]
    for _ in range(rounds):
        mean = np.stack(
            [
                np.bincount(edges[:, 0], points[edges[:, 1], i], minlength=len(points))
                for i in range(3)
            ],
            axis=1,
        ) / np.maximum(count, 1)
        gradient = _gradient(points)
        normal = gradient / np.maximum(np.linalg.norm(gradient, axis=1), 1e-9)[:, None]
        move = 0.6 * (mean - points)
        move -= np.sum(move * normal, axis=1)[:, None] * normal
        points = points + move
        points = points - np.clip(distance(points), -0.2, 0.2)[:, None] * normal
    return points


def make_surface(spacing):
    """The part's surface as a closed vtkPolyData of triangles of about this size."""
    # No plane of the part is one of the grid, where a surface would touch the samples.
    low = np.array([-62.0, -44.0, -2.0]) - 0.0137 * spacing
    high = np.array([62.0, 44.0, TOP + 2.0])
    size = np.ceil((high - low) / spacing).astype(int) + 1
    axes = [low[i] + spacing * np.arange(size[i]) for i in range(3)]
    values = np.empty(size[::-1], dtype=np.float32)
    yy, xx = np.meshgrid(axes[1], axes[0], indexing="ij")
    for k, z in enumerate(axes[2]):
        layer = np.stack([xx.ravel(), yy.ravel(), np.full(xx.size, z)], axis=1)
        values[k] = distance(layer).reshape(xx.shape)

    image = vtkImageData()
    image.SetDimensions(*(int(n) for n in size))
    image.SetOrigin(*low)
    image.SetSpacing(spacing, spacing, spacing)
    scalars = numpy_to_vtk(values.ravel(), deep=True)
    image.GetPointData().SetScalars(scalars)
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    contour.Update()

    surface = vtkPolyData()
    surface.DeepCopy(contour.GetOutput())
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float64)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = _relax(points, triangles, 25)
    surface.GetPoints().SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    return surface
