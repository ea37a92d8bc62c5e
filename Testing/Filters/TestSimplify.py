# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunSimplify: targets, what comes out, what is kept for the next target, and errors."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_EDGE, vtkUnstructuredGrid
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkFiltersCore import vtkAppendFilter

import gatunMeshes as gm
from gatun.vtk import vtkGatunSimplify


def make_box(n=8, dtype=np.float32):
    points, tets = gm.lattice(n, seed=3, dtype=dtype)
    grid = gm.make_grid(points, tets)
    wave = np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    gm.add_array(grid.GetPointData(), np.arange(len(points)), "point id")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell id")
    grid.GetPointData().SetActiveScalars("wave")
    return grid, points, tets, wave


def simplify(grid, **options):
    simplifier = vtkGatunSimplify()
    simplifier.SetInputDataObject(grid)
    gm.set_options(simplifier, **options)
    simplifier.Update()
    return simplifier


def arrays_of(output):
    points = vtk_to_numpy(output.GetPoints().GetData())
    tets = vtk_to_numpy(output.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return points, tets


def volumes(points, tets):
    p = points.astype(float)[tets]
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def expect_error(simplifier, words):
    errors = gm.Errors(simplifier)
    simplifier.Update()
    assert words in str(errors), (words, str(errors))
    assert simplifier.GetErrorCode() != 0
    assert simplifier.GetOutput().GetNumberOfPoints() == 0


grid, points, tets, wave = make_box()
whole = volumes(points, tets).sum()

# Nothing to do: the mesh as it is.
output = simplify(grid, SimplificationRatio=0).GetOutput()
assert output.GetNumberOfPoints() == len(points) and output.GetNumberOfCells() == len(tets)

# Each target; all tell the same in their own way.
for left in (600, 200, 50):
    ratio = 1 - left / len(points)
    counts = set()
    for options in (
            {"SimplificationRatio": ratio + 1e-12},
            {"SimplificationNumberOfPoints": left}):
        simplifier = simplify(grid, **options)
        output = simplifier.GetOutput()
        new_points, new_tets = arrays_of(output)
        assert len(new_points) == left, (len(new_points), options)
        counts.add(output.GetNumberOfCells())

        # Points are those of before, with their values; every tetrahedron is one of before, moved.
        ids = vtk_to_numpy(output.GetPointData().GetArray("point id"))
        assert (np.diff(ids) > 0).all()
        np.testing.assert_array_equal(new_points, points[ids])
        np.testing.assert_array_equal(
            vtk_to_numpy(output.GetPointData().GetArray("wave")), wave[ids].astype(np.float32))
        assert output.GetPointData().GetScalars().GetName() == "wave"
        cells = vtk_to_numpy(output.GetCellData().GetArray("cell id"))
        moved = ids[new_tets]
        stay = np.isin(tets[cells], ids)
        np.testing.assert_array_equal(moved[stay], tets[cells][stay])
        before = volumes(points, tets[cells])
        after = volumes(new_points, new_tets)
        assert (before * after > 0).all()
        assert abs(np.abs(after).sum() - np.abs(before).sum()) < 1  # both below the whole box
        assert abs(np.abs(after).sum() - abs(whole)) < 0.02 * abs(whole)
        assert len(np.unique(np.sort(new_tets, axis=1), axis=0)) == len(new_tets)
    assert len(counts) == 1, counts

    # The error that was reached, as a target, leads to the same mesh or to a coarser one of that error.
    again = simplify(
        grid, SimplificationRMSError=simplifier.GetOutputRMSError())
    assert again.GetOutput().GetNumberOfPoints() <= left
    assert again.GetOutputRMSError() == simplifier.GetOutputRMSError()
    less = simplify(grid,
                    SimplificationRMSError=0.999 * simplifier.GetOutputRMSError())
    assert less.GetOutput().GetNumberOfPoints() > again.GetOutput().GetNumberOfPoints()

# More points than there are: all. As far as possible: few.
output = simplify(grid, SimplificationNumberOfPoints=10 ** 9).GetOutput()
assert output.GetNumberOfPoints() == len(points)
simplifier = simplify(grid, SimplificationRatio=1)
assert simplifier.GetOutput().GetNumberOfPoints() == len(points) - simplifier.GetMostMerges() < 20
assert simplifier.GetOutput().GetNumberOfCells() > 0

# Another target is a matter of one pass; other arrays, metrics or input are not.
steps = []
simplifier = vtkGatunSimplify()
simplifier.AddObserver("ProgressEvent", lambda source, event: steps.append(source.GetProgress()))
simplifier.SetInputDataObject(grid)


def was_built():
    steps.clear()
    simplifier.Update()
    return any(0 < step < 0.95 for step in steps)


assert was_built()
sizes = []
for ratio in (0.1, 0.9, 0.5):
    simplifier.SetSimplificationRatio(ratio)
    assert not was_built()
    sizes.append(simplifier.GetOutput().GetNumberOfCells())
assert sizes[0] > sizes[2] > sizes[1]
simplifier.SetMetric(simplifier.METRIC_DENSITY)
assert was_built()
simplifier.SetBoundaryWeight(0.1)
assert was_built()
simplifier.SetArrayWeight("wave", 2)
assert was_built()
simplifier.SetArrayWeight("point id", 1)
assert was_built()
assert simplifier.GetArrayWeight("wave") == 2 and simplifier.GetArrayWeight("nothing") == 0
simplifier.ClearArrayWeights()
assert was_built()
grid.GetPointData().GetArray("wave").Modified()
grid.Modified()
assert was_built()

# What counts is what has a weight: where the one array changes, points stay.
step = np.where(points[:, 0] > 0.5, 1.0, 0.0)
other = np.where(points[:, 2] > 0.5, 1.0, 0.0)
gm.add_array(grid.GetPointData(), step, "step x")
gm.add_array(grid.GetPointData(), other, "step z")


def spread(name, axis):
    result = vtkGatunSimplify()
    result.SetInputDataObject(grid)
    result.SetArrayWeight(name, 1)
    result.SetSimplificationNumberOfPoints(120)
    result.Update()
    left = vtk_to_numpy(result.GetOutput().GetPoints().GetData())
    return np.median(np.abs(left[:, axis] - 0.5))


assert spread("step x", 0) < spread("step z", 0)
assert spread("step z", 2) < spread("step x", 2)

# What makes no sense, and a good update afterwards.
simplifier = vtkGatunSimplify()
simplifier.SetInputDataObject(grid)
for name, value, clamped in (
        ("SimplificationRatio", -0.1, 0), ("SimplificationRatio", 1.1, 1),
        ("SimplificationNumberOfPoints", -1, 0), ("SimplificationRMSError", -1, 0),
        ("BoundaryWeight", 2, 1), ("BoundaryWeight", -2, 0)):
    getattr(simplifier, "Set" + name)(value)
    assert getattr(simplifier, "Get" + name)() == clamped, name
simplifier.SetArrayWeight("wave", -1)
assert simplifier.GetArrayWeight("wave") == 0
simplifier.ClearArrayWeights()
for name, good, words in (
        ("SimplificationRatio", 0.5, "ratio"), ("SimplificationRMSError", 0, "error"),
        ("BoundaryWeight", 0.5, "weight")):
    getattr(simplifier, "Set" + name)(float("nan"))
    expect_error(simplifier, words)
    getattr(simplifier, "Set" + name)(good)
    simplifier.Update()
    assert simplifier.GetOutput().GetNumberOfCells() > 0, name
simplifier.SetArrayWeight("nothing", 1)
expect_error(simplifier, "nothing")
simplifier.ClearArrayWeights()
simplifier.SetArrayWeight("wave", float("nan"))
expect_error(simplifier, "weight")
simplifier.ClearArrayWeights()

# Cells that have no volume are nothing, and unknown ones an error.
edges = vtkUnstructuredGrid()
edges.SetPoints(grid.GetPoints())
edges.InsertNextCell(VTK_QUADRATIC_EDGE, 3, (0, 1, 2))
bad = vtkGatunSimplify()
bad.SetInputDataObject(edges)
warnings = []
bad.AddObserver("WarningEvent", lambda *_: warnings.append(1))
bad.Update()
assert bad.GetErrorCode() == 0 and bad.GetOutput().GetNumberOfCells() == 0 and warnings
gm.set_cell_type(edges, 0, 99)
edges.Modified()
expect_error(bad, "type 99")

# An input that fails leaves nothing of its own behind: back to the one before, all is as it was.
small, small_points, small_tets, _ = make_box(3)
broken = gm.make_grid(small_points, np.where(small_tets == 5, 10 ** 6, small_tets))
simplifier = simplify(grid, SimplificationRatio=0.5)
before = arrays_of(simplifier.GetOutput())
simplifier.SetInputDataObject(broken)
expect_error(simplifier, "but the mesh has only")
simplifier.SetInputDataObject(grid)
simplifier.Update()
for one, other in zip(before, arrays_of(simplifier.GetOutput())):
    np.testing.assert_array_equal(one, other)

# Nothing, other cells, and no arrays at all.
assert simplify(vtkUnstructuredGrid()).GetOutput().GetNumberOfCells() == 0
image = vtkRTAnalyticSource()
image.SetWholeExtent(-4, 4, -4, 4, -4, 4)
voxels = vtkAppendFilter()
voxels.AddInputConnection(image.GetOutputPort())
voxels.Update()
simplifier = vtkGatunSimplify()
warnings = []
simplifier.AddObserver("WarningEvent", lambda *_: warnings.append(1))
simplifier.SetInputConnection(voxels.GetOutputPort())
simplifier.Update()
assert simplifier.GetOutput().GetNumberOfPoints() == 365, simplifier.GetOutput().GetNumberOfPoints()
assert not warnings
bare = gm.make_grid(points, tets)
assert simplify(bare, SimplificationRatio=0.5).GetOutput().GetNumberOfPoints() == len(points) - len(points) // 2

# Stopped, and then not.
simplifier = vtkGatunSimplify()
simplifier.SetInputDataObject(grid)
tag = simplifier.AddObserver("ProgressEvent", lambda source, event: source.SetAbortExecute(1))
simplifier.Update()
assert simplifier.GetOutput().GetNumberOfPoints() == 0
simplifier.RemoveObserver(tag)
simplifier.SetAbortExecute(0)
simplifier.Modified()
simplifier.Update()
assert simplifier.GetOutput().GetNumberOfPoints() > 0
