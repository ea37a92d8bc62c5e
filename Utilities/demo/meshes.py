# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The mesh that the demo shows: the part under load, or the user's own."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import elasticity
import part

# Size of the triangles in mm, largest tetrahedron in cubic mm.
SIZES = {"small": (3.0, 20.0), "full": (1.15, 0.8)}


def fill(spacing, volume, say):
    """The part as a vtkUnstructuredGrid, without any arrays."""
    try:
        from gatun import vtkGatunTetrahedralize
    except (AttributeError, ImportError):
        raise SystemExit("demo: this build has no TetGen; name a mesh of your own") from None

    surface = part.make_surface(spacing)
    mesher = vtkGatunTetrahedralize()
    mesher.SetInputData(surface)
    mesher.SetQuality(1.414)
    mesher.SetMaximumVolume(volume)
    mesher.PreserveSurfaceOn()
    mesher.Update()
    grid = mesher.GetOutput()
    if grid.GetNumberOfCells() == 0:
        raise SystemExit("demo: TetGen made no mesh")
    say(
        f"{surface.GetNumberOfPolys():,} triangles filled with "
        f"{grid.GetNumberOfCells():,} tetrahedra"
    )
    return grid


def make_part(size, say):
    """The loaded part as a vtkUnstructuredGrid with its stress and displacement."""
    coarse = fill(*SIZES["small"], say)
    say("bending it")
    displacement, stress = bend(coarse, None, say)
    if size == "small":
        add_arrays(coarse, displacement, stress)
        return coarse
    # The solution on few tetrahedra is where the search on many begins.
    grid = fill(*SIZES[size], say)
    say("bending it")
    start = carry_over(coarse, displacement, grid)
    displacement, stress = bend(grid, start, say)
    add_arrays(grid, displacement, stress)
    say(
        f"largest displacement {np.linalg.norm(displacement, axis=1).max():.3f} mm, "
        f"largest stress {stress.max():.0f} MPa"
    )
    return grid


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(np.float64)


def bend(grid, start, say):
    """Pushes the part's flange sideways while its bolts hold the base. Returns the displacement
    and the von Mises stress of the points."""
    points = points_of(grid)
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    solid = elasticity.Solid(points, tets)
    x, y, z = points.T

    # The heads of the bolts press on the rings at the bottom of the counterbores.
    fixed = np.zeros(len(points), dtype=bool)
    for bolt in part.BOLTS:
        distance = np.hypot(x - bolt[0], y - bolt[1])
        fixed |= (distance < part.COUNTERBORE_RADIUS) & (z < part.BASE_HEIGHT - 2)
    # The shaft pushes the upper part of the bore.
    pushed = (np.hypot(x, y) < part.BORE_RADIUS + 1.0) & (z > part.TOP - 14)
    load = np.zeros_like(points)
    load[pushed] = np.array([6000.0, 2500.0, -3000.0]) / pushed.sum()

    displacement = elasticity.solve(
        solid,
        fixed,
        load,
        start,
        tolerance=1e-3,
        report=lambda iteration, left: say(f"  iteration {iteration}, residual {left:.1e}"),
    )
    return displacement, solid.point_mean(elasticity.von_mises(solid.stress(displacement)))


def carry_over(coarse, values, fine):
    """Values at the points of one mesh as values at those of another of the same body."""
    source = vtkUnstructuredGrid()
    source.CopyStructure(coarse)
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName("values")
    source.GetPointData().AddArray(array)
    probe = vtkProbeFilter()
    probe.SetInputData(fine)
    probe.SetSourceData(source)
    probe.Update()
    carried = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("values")).copy()
    inside = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray(probe.GetValidPointMaskArrayName()))
    # Points a little outside take the value of the nearest point.
    locator = vtkStaticPointLocator()
    locator.SetDataSet(source)
    locator.BuildLocator()
    points = points_of(fine)
    for i in np.flatnonzero(inside == 0):
        carried[i] = values[locator.FindClosestPoint(points[i])]
    return carried


def add_arrays(grid, displacement, stress):
    for name, values in (
        ("von Mises stress [MPa]", stress),
        ("displacement [mm]", displacement),
    ):
        array = numpy_to_vtk(values.astype(np.float32), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    grid.GetPointData().SetActiveScalars("von Mises stress [MPa]")
    grid.GetPointData().SetActiveVectors("displacement [mm]")


def write(grid, name, compressor):
    """Writes a .vtu as small as VTK can, with one of its compressors or None."""
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetHeaderTypeToUInt64()
    getattr(writer, "SetCompressorTypeTo" + (compressor or "None"))()
    if not writer.Write():
        raise SystemExit(f"demo: {name} cannot be written")
