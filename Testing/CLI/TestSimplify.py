# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""simplify writes what vtkGatunSimplify makes, of any mesh, to any degree; and says what it cannot do."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from gatun.vtk import vtkGatunSimplify
from gatunCli import enter_folder, gtn, read, standard_mesh, write

enter_folder("simplify")
write(standard_mesh(8), "mesh.vtu")
gtn("pack", "-q", "--keep-order", "all", "mesh.vtu", "mesh.gtn")
grid = read("mesh.vtu")
points = grid.GetNumberOfPoints()


def check(name, prepare):
    """The file has what the filter makes when it is prepared so."""
    simplifier = vtkGatunSimplify()
    simplifier.SetInputDataObject(grid)
    prepare(simplifier)
    simplifier.Update()
    expected, got = simplifier.GetOutput(), read(name)
    assert expected.GetNumberOfCells() > 0
    for of in (lambda g: g.GetPoints().GetData(), lambda g: g.GetCells().GetConnectivityArray()):
        np.testing.assert_array_equal(vtk_to_numpy(of(got)), vtk_to_numpy(of(expected)))
    for i in range(expected.GetPointData().GetNumberOfArrays()):
        array = expected.GetPointData().GetArray(i)
        if array:
            np.testing.assert_array_equal(
                vtk_to_numpy(got.GetPointData().GetArray(array.GetName())), vtk_to_numpy(array))
    return got.GetNumberOfPoints()


gtn("simplify", "-q", "mesh.vtu", "half.vtu")
assert check("half.vtu", lambda s: None) == points - points // 2
gtn("simplify", "-q", "--ratio", 0.8, "mesh.gtn", "fifth.vtu")
assert check("fifth.vtu", lambda s: s.SetSimplificationRatio(0.8)) < 0.21 * points
out = gtn("simplify", "--ratio", 0.6, "mesh.vtu", "ratio.vtu", says="tetrahedra")
assert f"of {points:,} points" in out, out
check("ratio.vtu", lambda s: s.SetSimplificationRatio(0.6))


def number(s):
    s.SetSimplificationNumberOfPoints(150)
    s.SetMetric(s.METRIC_DENSITY)
    s.SetBoundaryWeight(0.25)
    s.SetArrayWeight("velocity", 2)
    s.SetArrayWeight("pressure", 1)


gtn("simplify", "-q", "--points", 150, "--metric", "density", "--boundary-weight", 0.25,
    "--weight", "velocity=2", "--weight", "pressure", "mesh.vtu", "number.vtu")
assert check("number.vtu", number) == 150


def error(s):
    s.SetSimplificationRMSError(0.02)


gtn("simplify", "-q", "--rms-error", "0.02", "mesh.vtu", "error.vtu")
assert check("error.vtu", error) < points

# The other formats: the same mesh.
for name in ("half.gtn", "half.vtk"):
    gtn("simplify", "-q", "mesh.vtu", name)
gtn("verify", "-q", "half.gtn", "half.vtu")
gtn("verify", "-q", "half.gtn", "half.vtk")

# Surfaces.
ball = vtkSphereSource()
ball.SetThetaResolution(40)
ball.SetPhiResolution(40)
writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(ball.GetOutputPort())
writer.SetFileName("ball.vtp")
assert writer.Write()
simplifier = vtkGatunSimplify()
simplifier.SetInputConnection(ball.GetOutputPort())
simplifier.SetSimplificationRatio(0.8)
simplifier.SetFeatureAngle(60)
simplifier.Update()
out = gtn("simplify", "--ratio", 0.8, "--feature-angle", 60, "ball.vtp", "few.vtp", says="triangles")
assert f"of {ball.GetOutput().GetNumberOfPoints():,} points" in out, out
reader = vtkXMLPolyDataReader()
reader.SetFileName("few.vtp")
reader.Update()
expected, got = simplifier.GetOutput(), reader.GetOutput()
assert expected.GetNumberOfPoints() < 0.21 * ball.GetOutput().GetNumberOfPoints()
for of in (lambda g: g.GetPoints().GetData(), lambda g: g.GetPolys().GetConnectivityArray()):
    np.testing.assert_array_equal(vtk_to_numpy(of(got)), vtk_to_numpy(of(expected)))
gtn("simplify", "-q", "--points", 100, "ball.vtp", "few.stl")
# Surfaces in .gtn files.
gtn("pack", "-q", "ball.vtp", "ball.gtn")
gtn("simplify", "-q", "--points", 100, "ball.gtn", "few.gtn")
gtn("unpack", "-q", "few.gtn", "again.vtp")
gtn("simplify", "-q", "--points", 100, "ball.vtp", "same.vtp")
surfaces = []
for name in ("again.vtp", "same.vtp"):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    surfaces.append((reader.GetOutput().GetNumberOfPoints(), reader.GetOutput().GetNumberOfPolys()))
assert surfaces[0] == surfaces[1] and surfaces[0][0] == 100, surfaces
gtn("simplify", "ball.gtn", "few.vtu", code=1, says="is a surface")

# Usage and failures; what is there stays.
gtn("simplify", "mesh.vtu", "half.vtu", code=1, says="exists")
gtn("simplify", "-f", "-q", "mesh.vtu", "half.vtu")
for arguments in (
        ("--ratio", "1.5"), ("--ratio", "-1"), ("--percent", "40"), ("--points", "-3"),
        ("--rms-error", "-1"), ("--ratio", "0.5", "--points", "5"), ("--metric", "color"),
        ("--boundary-weight", "2"), ("--weight", "velocity=much"), ("--weight", "velocity=-1")):
    gtn("simplify", *arguments, "mesh.vtu", "new.vtu", code=2)
gtn("simplify", "mesh.vtu", "new.foo", code=2, says=".gtn, .vtu or .vtk")
gtn("simplify", "mesh.vtu", "new.vtp", code=1, says="is no surface")
gtn("simplify", "--feature-angle", "200", "ball.vtp", "new.vtp", code=2)
gtn("simplify", "ball.vtp", "few.vtp", code=1, says="exists")
gtn("simplify", "--weight", "nothing", "mesh.vtu", "new.vtu", code=1, says="nothing")
gtn("simplify", "missing.vtu", "new.vtu", code=1, says="missing.vtu")
