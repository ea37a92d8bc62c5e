# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The mesh that the demo makes: a bearing block of aluminum, held by its bolts and pushed by its shaft (mm, N, MPa)."""

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import gatun
from sheet import new, output_of

BOLT = (46, 28)  # in each quarter
DISPLACEMENT = "displacement [mm]"
YOUNG, POISSON = 70000.0, 0.33
SIZES = {"small": (3.0, 20.0), "full": (1.15, 0.8)}  # spacing of the surface, largest tetrahedron


def set_array(data, values, name):
    """Adds an array of points and makes it the active one."""
    array = numpy_to_vtk(np.ascontiguousarray(values, np.float32), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    data.GetPointData().SetActiveScalars(name)


def soft_max(a, b, radius):
    """The larger one, with a fillet where they are less than the radius apart."""
    return np.maximum(a, b) + np.maximum(radius - np.abs(a - b), 0) ** 2 / (4 * radius)


def soft_min(a, b, radius):
    return -soft_max(-a, -b, radius)


def part_function(x, y, z):
    """Negative within the part. Near its surface, about the distance to it."""
    x, y = np.abs(x), np.abs(y)  # the four quarters are alike
    radius, bolt, hole = np.hypot(x, y), np.hypot(x - BOLT[0], y - BOLT[1]), np.hypot(x - 17.5, y - 17.5)
    outline = np.hypot(np.maximum(x - 47, 0), np.maximum(y - 29, 0)) - 13
    body = soft_max(outline, np.abs(z - 6) - 6, 2.5)
    body = soft_min(body, np.maximum(radius - 21, np.abs(z - 32) - 30), 9)
    for along, across, reach in (x, y, 30), (y, x, 14):
        slope = (38 * (along - 21 - reach) + reach * (z - 12)) / np.hypot(38, reach)
        body = soft_min(body, soft_max(np.maximum(slope, 6 - z), across - 4, 2), 7)
    body = soft_min(body, soft_max(radius - 31, np.abs(z - 59) - 5, 2), 9)
    # Fillets bulge where two surfaces meet at no angle.
    body = soft_max(body, soft_max(outline, np.abs(z - 32) - 32, 2.5), 2.5)
    body = soft_max(body, 13 - radius, 2)
    body = soft_max(body, 5.5 - bolt, 1.5)
    body = soft_max(body, np.minimum(10 - bolt, z - 9), 1.2)
    return soft_max(body, np.minimum(3.3 - hole, z - 44), 1.2)


def make_mesh(spacing, volume):
    # No plane of the part is one of the grid, where a surface would touch the samples.
    low = np.array([-62, -44, -2]) - 0.0137 * spacing
    x, y, z = (np.arange(a, b + spacing, spacing) for a, b in zip(low, (62, 44, 66)))
    image = new(vtk.vtkImageData, Dimensions=(len(x), len(y), len(z)), Origin=low, Spacing=[spacing] * 3)
    set_array(image, part_function(x, y[:, None], z[:, None, None]).ravel(), "function")
    surface = output_of(new(vtk.vtkFlyingEdges3D, ComputeNormals=False, ComputeScalars=False), image)
    # Points move to where triangles are even, but stay on the surface.
    smooth = new(vtk.vtkSmoothPolyDataFilter, SourceData=surface, RelaxationFactor=0.5, NumberOfIterations=25)
    mesher = new(gatun.vtk.vtkGatunTetrahedralize, Quality=1.414, MaximumVolume=volume, PreserveSurface=True)
    return output_of(mesher, output_of(smooth, surface))


def bend(grid, displacement, count):
    """Improves a displacement by steps of conjugate gradients, and gives it and its stress to the grid."""
    print(f"Bending {grid.GetNumberOfCells():,} tetrahedra")
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    edges = points[tets[:, 1:]] - points[tets[:, :1]]
    # Of the functions that are 1 at a corner and 0 at the others.
    gradients = np.swapaxes(np.linalg.inv(edges), 1, 2)
    gradients = np.concatenate([-gradients.sum(1, keepdims=True), gradients], 1)
    volumes = np.abs(np.linalg.det(edges))[:, None, None] / 6

    def to_points(values):
        return np.stack([np.bincount(tets.ravel(), v.ravel(), len(points)) for v in np.moveaxis(values, 2, 0)], 1)

    def stress_of(displacement):
        slope = np.matmul(np.swapaxes(displacement[tets], 1, 2), gradients)
        trace = np.trace(slope, axis1=1, axis2=2)[:, None, None]
        return YOUNG / (1 + POISSON) * ((slope + np.swapaxes(slope, 1, 2)) / 2 +
                                        POISSON / (1 - 2 * POISSON) * trace * np.eye(3))

    def forces_of(displacement):
        return free * to_points(np.matmul(gradients, volumes * stress_of(displacement)))

    x, y, z = points.T
    # The heads of the bolts press on the rings at the bottom of the counterbores.
    free = ((np.hypot(np.abs(x) - BOLT[0], np.abs(y) - BOLT[1]) > 10) | (z > 10))[:, None]
    pushed = ((np.hypot(x, y) < 14) & (z > 50))[:, None]
    load = pushed * [6000.0, 2500.0, -3000.0] / pushed.sum()
    weight = free / to_points(volumes * np.sum(gradients ** 2, axis=2, keepdims=True))
    displacement = displacement * free
    residual = load - forces_of(displacement)
    step, product = 0, 1
    for _ in range(count):
        before, product = product, np.sum(residual * weight * residual)
        step = weight * residual + product / before * step
        response = forces_of(step)
        length = product / np.sum(step * response)
        displacement += length * step
        residual -= length * response

    stress = stress_of(displacement)
    stress -= np.eye(3) * np.trace(stress, axis1=1, axis2=2)[:, None, None] / 3
    mises = np.sqrt(1.5 * np.sum(stress ** 2, axis=(1, 2), keepdims=True))
    around = np.ones((1, 4, 1)) * volumes
    set_array(grid, displacement, DISPLACEMENT)
    set_array(grid, to_points(around * mises) / to_points(around), "von Mises stress [MPa]")


def make_part(size):
    """The loaded part with its stress and displacement."""
    grid = make_mesh(*SIZES["small"])
    bend(grid, np.zeros((grid.GetNumberOfPoints(), 3)), 500)
    if size != "small":
        coarse, grid = grid, make_mesh(*SIZES[size])
        kernel = new(vtk.vtkShepardKernel, KernelFootprint=vtk.vtkGeneralizedKernel.N_CLOSEST)
        carried = output_of(new(vtk.vtkPointInterpolator, SourceData=coarse, Kernel=kernel), grid)
        # From there, few steps suffice for a picture, though not for the largest stress.
        bend(grid, vtk_to_numpy(carried.GetPointData().GetArray(DISPLACEMENT)), 30)
    return grid
