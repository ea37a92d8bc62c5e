# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""contour writes the isosurfaces that VTK makes of the same mesh, in every format; of a .gtn file from
those chunks only that they pass through."""

import os
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkContourGrid

from gatun.vtk import vtkGatunContour, vtkGatunReader
from gatunCli import enter_folder, gtn, lattice, make_grid, read, waves, write
from gatunSurfaces import (
    area_of, holes_of, is_closed, places_of, points_of, read_surface, triangles_of)

enter_folder("contour")
SIDE = 14


def make_mesh(center, dtype=np.float32):
    """Spheres around a point are where "distance" is the same."""
    points, tets = lattice(SIDE, dtype=dtype)
    distance = np.linalg.norm(points - center, axis=1).astype(np.float32)
    data = {"distance": distance, **waves(points)}
    cells = {"material": (np.arange(len(tets)) // 100).astype(np.int32)}
    grid = make_grid(points, tets, data, cells)
    grid.GetPointData().SetActiveScalars("distance")
    return grid


CENTER = np.array([7.1, 6.9, 7.2])
write(make_mesh(CENTER), "mesh.vtu")
gtn("pack", "-q", "--chunk-size", 500, "mesh.vtu", "mesh.gtn")
grid = read("mesh.vtu")
distances = vtk_to_numpy(grid.GetPointData().GetArray("distance"))


def contour_of(source, values, prepare=lambda contour: None, array="distance"):
    contour = vtkGatunContour()
    if isinstance(source, str):
        reader = vtkGatunReader()
        reader.SetFileName(source)
        contour.SetInputConnection(reader.GetOutputPort())
        contour.reader = reader
    else:
        contour.SetInputDataObject(source)
    contour.SetInputArrayToProcess(0, 0, 0, 0, array)
    for i, value in enumerate(values):
        contour.SetValue(i, value)
    prepare(contour)
    contour.Update()
    return contour.GetOutput()


def arrays_of(surface):
    return [{data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
            for data in (surface.GetPointData(), surface.GetCellData())]


def assert_same(got, expected):
    """The same points, triangles or strips, and arrays, in the same order."""
    assert expected.GetNumberOfCells() > 0
    np.testing.assert_array_equal(points_of(got), points_of(expected))
    np.testing.assert_array_equal(triangles_of(got), triangles_of(expected))
    assert got.GetNumberOfStrips() == expected.GetNumberOfStrips()
    assert arrays_of(got) == arrays_of(expected), arrays_of(got)
    for one, other in ((got.GetPointData(), expected.GetPointData()),
                       (got.GetCellData(), expected.GetCellData())):
        for i in range(other.GetNumberOfArrays()):
            array = other.GetArray(i)
            np.testing.assert_array_equal(
                vtk_to_numpy(one.GetArray(array.GetName())), vtk_to_numpy(array))


def contour(*arguments, source="mesh.gtn", out="out.vtp"):
    gtn("contour", "-q", "-f", *arguments, source, out)
    return read_surface(out)


# A sphere, as VTK makes it, from the file and from memory.
expected = vtkContourGrid()
expected.SetInputData(grid)
expected.SetInputArrayToProcess(0, 0, 0, 0, "distance")
expected.SetValue(0, 5)
expected.Update()
for source, same in (("mesh.gtn", contour_of("mesh.gtn", [5])), ("mesh.vtu", contour_of(grid, [5]))):
    sphere = contour("--value", 5, source=source)
    assert_same(sphere, same)
    assert is_closed(sphere) and holes_of(sphere) == 2
    assert sphere.GetNumberOfPolys() == expected.GetOutput().GetNumberOfPolys()
    assert abs(area_of(sphere) / area_of(expected.GetOutput()) - 1) < 1e-6
    assert sphere.GetPointData().GetScalars().GetName() == "distance"
    assert set(vtk_to_numpy(sphere.GetPointData().GetScalars())) == {np.float32(5)}

# What is to be in it.
assert_same(contour("--value", 5, "--normals"),
            contour_of("mesh.gtn", [5], lambda c: c.ComputeNormalsOn()))
assert_same(contour("--value", 5, "--strips"),
            contour_of("mesh.gtn", [5], lambda c: c.OutputStripsOn()))
double = contour("--value", 5, "--precision", "double")
assert points_of(double).dtype == np.float64
assert_same(double, contour_of(
    "mesh.gtn", [5], lambda c: c.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)))
write(make_mesh(CENTER, np.float64), "double.vtu")
assert points_of(contour("--value", 5, source="double.vtu")).dtype == np.float64
assert points_of(contour("--value", 5, "--precision", "single", source="double.vtu")).dtype == np.float32
for source in ("mesh.gtn", "mesh.vtu"):
    everything = contour("--value", 5, source=source)
    for names in ([], ["pressure"], ["material", "velocity"], ["distance"]):
        some = contour("--value", 5, "--arrays", ",".join(names or ["mark"]), source=source)
        assert set.union(*arrays_of(some)) == set(names or ["mark"]), arrays_of(some)
        np.testing.assert_array_equal(points_of(some), points_of(everything))

# Which values.
assert_same(contour("--value", 5, "--value", "3,4.5"), contour_of("mesh.gtn", [3, 4.5, 5]))
middle = (np.float64(distances.min()) + np.float64(distances.max())) / 2
assert_same(contour("--number", 1), contour_of("mesh.gtn", [middle]))
steps = np.linspace(np.float64(distances.min()), np.float64(distances.max()), 5)[1:-1]
assert_same(contour("--number", 3, source="mesh.vtu"), contour_of(grid, steps))
for component, value in ((0, 2.5), (1, -2.5), ("magnitude", 6)):
    for source, of in (("mesh.gtn", "mesh.gtn"), ("mesh.vtu", grid)):
        number = -1 if component == "magnitude" else component
        same = contour_of(of, [value], lambda c, n=number: c.SetArrayComponent(n), "velocity")
        assert_same(contour("--array", "velocity", "--component", component, "--value", value,
                            source=source), same)
assert_same(contour("--array", "mark", "--value", 2.5), contour_of("mesh.gtn", [2.5], array="mark"))

# The other formats have the same triangles; those of single precision, rounded.
for source in ("mesh.gtn", "double.vtu"):
    sphere = contour("--value", 5, "--normals", source=source)
    normals = vtk_to_numpy(sphere.GetPointData().GetNormals())
    stl = contour("--value", 5, source=source, out="out.stl")
    assert os.path.getsize("out.stl") == 84 + 50 * len(triangles_of(sphere))
    np.testing.assert_array_equal(places_of(stl), places_of(sphere).astype(np.float32))
    for name in ("out.ply", "out.obj"):
        for with_normals in (True, False):
            other = contour("--value", 5, *(["--normals"] if with_normals else []), source=source,
                            out=name)
            # VTK 9.3 reads the numbers of a text to within a unit in the last place. See below.
            np.testing.assert_allclose(points_of(other), points_of(sphere).astype(np.float32),
                                       rtol=1.2e-7 if name == "out.obj" else 0)
            np.testing.assert_array_equal(triangles_of(other), triangles_of(sphere))
            assert is_closed(other)
            found = other.GetPointData().GetNormals()
            assert bool(found) == with_normals
            if found:
                np.testing.assert_array_equal(vtk_to_numpy(found), normals)
# A text has all digits of double precision.
with open("out.obj") as file:
    texts = [line.split()[1:] for line in file if line.startswith("v ")]
np.testing.assert_array_equal(np.array(texts, np.float64), points_of(sphere))

# The simplified mesh: as the file tells, or found out.
gtn("pack", "-q", "--chunk-size", 500, "--hierarchy", "mesh.vtu", "any.gtn")
for option, value, least, most in (("--ratio", 0.8, 0.25, 0.7),
                                   ("--points", 600, 0.2, 0.7), ("--rms-error", 0.02, 0.01, 0.99)):
    for source in ("any.gtn", "mesh.gtn", "mesh.vtu"):
        gtn("simplify", "-q", "-f", option, value, source, "coarse.vtu")
        coarse = contour(option, value, "--value", 5, source=source)
        same = contour_of(read("coarse.vtu"), [5])
        assert len(triangles_of(coarse)) == len(triangles_of(same)), (option, source)
        assert abs(area_of(coarse) / area_of(same) - 1) < 1e-5
        part = len(triangles_of(coarse)) / len(triangles_of(everything))
        assert least < part < most, (option, part)
        assert is_closed(coarse)

# Time steps.
for step in range(3):
    write(make_mesh(CENTER - step), f"run{step}.vtu")
gtn("pack", "-q", "--chunk-size", 500, *(f"run{step}.vtu" for step in range(3)), "run.gtn")
for asked in ("--step", "--time"):
    for step in (1, 2):
        assert_same(contour(asked, step, "--value", 4, source="run.gtn"),
                    contour_of("run.gtn", [4], lambda c, s=step: c.UpdateTimeStep(s)))
        moved = points_of(contour(asked, step, "--value", 4, source="run.gtn")).mean(axis=0)
        assert np.abs(moved - CENTER + step).max() < 0.3, moved
gtn("contour", "--value", 4, "run.gtn", "first.vtp", says="run.gtn: has 3 time steps; using the first one")


# What it takes.
def statistics(*arguments, source="mesh.gtn", out="stats.vtp"):
    """What --stats prints, by its titles; "of" goes with the row before."""
    told = {}
    last = None
    for line in gtn("contour", "-f", "--stats", *arguments, source, out).splitlines()[1:]:
        title, value = re.split(r"\s{2,}", line.strip())
        last = (last if title == "of" else title) + (" of" if title == "of" else "")
        told[last] = value
    return told


def number(text):
    return float(text.replace(",", "").split()[0])


small, middle = (statistics("--value", value, out="stats.stl") for value in (0.9, 5))
large = statistics("--value", 0.9, "--value", 5, "--strips")
assert int(small["chunks passed through"]) < int(small["chunks passed through of"]) / 4, small
assert number(small["tetrahedra in these"]) < grid.GetNumberOfCells() / 4
assert "KiB" in small["read"] and number(small["read"]) < number(small["read of"]) / 2, small
assert number(small["read"]) < 0.7 * number(middle["read"]), (small, middle)
# Arrays that the surface does not have are not read.
assert number(middle["read"]) < 0.7 * number(large["read"]), (middle, large)
assert number(large["isovalues"]) == 2 and number(small["isovalues"]) == 1
strips = read_surface("stats.vtp")
assert number(large["triangles"]) == len(triangles_of(strips))
assert number(large["strips"]) == strips.GetNumberOfStrips()
corners = strips.GetStrips().GetNumberOfConnectivityIds()
saved = 100 * (1 - corners / (3 * len(triangles_of(strips))))
assert abs(number(large["corners that they save"]) - saved) < 0.06, (large, saved)
each = len(triangles_of(strips)) / strips.GetNumberOfStrips()
assert abs(number(large["triangles in each, mean"]) - each) < 0.006
assert "chunks passed through" not in statistics("--value", 5, source="mesh.vtu")

# No surface: the range, and no file.
for source in ("mesh.gtn", "mesh.vtu"):
    for value in (-1, 100):
        for name in ("none.vtp", "none.stl", "none.ply", "none.obj"):
            has = f"{source}: no surface at {value}: array 'distance' has values from "
            gtn("contour", "-q", "--value", value, source, name, code=1, says=has)
            assert not os.path.exists(name)
    gtn("contour", "-f", "--value", "5,100", source, "some.vtp", says=f"{source}: no surface at 100: ")
    assert len(triangles_of(read_surface("some.vtp"))) == len(triangles_of(everything))
run = gtn("contour", "-f", "-q", "--value", "5,100", "mesh.gtn", "some.vtp")
assert run == "", run

# A file that is organized by layers of the array is told from one that is not.
gtn("pack", "-q", "--chunk-size", 500, "--layers", "distance:6", "mesh.vtu", "layers.gtn")
told = "not organized by layers of 'distance'"
assert told in gtn("contour", "-f", "-v", "--value", 5, "mesh.gtn", "layers.vtp")
assert told not in gtn("contour", "-f", "-v", "--value", 5, "layers.gtn", "layers.vtp")
assert told not in gtn("contour", "-f", "-v", "--value", 5, "mesh.vtu", "layers.vtp")
assert told not in gtn("contour", "-f", "--value", 5, "mesh.gtn", "layers.vtp")
assert statistics("--value", 5)["layers of the array"] == "no"
assert statistics("--value", 5, source="layers.gtn")["layers of the array"] == "yes"
