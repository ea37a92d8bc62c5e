# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gatun.read and gatun.write: the values of files, and what each parameter does."""

import json
import os
import pathlib
import subprocess

import gatun
import numpy as np
from gatunCube import find, make_cube, require_equal
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

points, tets = make_cube()
rng = np.random.default_rng(1)
noise = rng.standard_normal(len(points))
smooth = np.exp(-(points**2).sum(axis=1)).astype(np.float32)
mesh = gatun.from_numpy(
    points,
    tets,
    point_data={"noise": noise, "smooth": smooth},
    cell_data={"id": np.arange(len(tets)), "noise": np.arange(len(tets)) / 7},
)


def read_arrays(path, **options):
    return gatun.to_numpy(gatun.read(path, **options))


def write(name, data=mesh, **options):
    path = find(name)
    assert gatun.write(data, path, overwrite=True, **options) == os.path.getsize(path)
    return path


# Everything, in the order that was kept. A file has several kinds of names.
for name in (find("all.gtn"), pathlib.Path(find("all.gtn"))):
    gatun.write(mesh, name, keep_order=True, overwrite=True)
    back = read_arrays(name)
    require_equal(back.points, points)
    require_equal(back.cells_dict["tetra"], tets)
    require_equal(back.point_data["noise"], noise)
    require_equal(back.cell_data["noise"][0], np.arange(len(tets)) / 7)
unordered = read_arrays(find("all.gtn"), restore_order=False)
assert not np.array_equal(unordered.points, points)
require_equal(np.sort(unordered.point_data["noise"]), np.sort(noise))
back = read_arrays(write("points.gtn", keep_order="points"))
require_equal(back.points, points)
assert not np.array_equal(back.cells_dict["tetra"], tets)
back = read_arrays(write("both.gtn", keep_order=["points", "cells", "corners"]))
require_equal(back.cells_dict["tetra"], tets)

# A smaller file has the same arrays.
small = write("small.gtn", profile="small", keep_order=True)
assert os.path.getsize(small) < os.path.getsize(find("all.gtn"))
require_equal(read_arrays(small).point_data["smooth"], smooth)

# Arrays by name, of points and cells.
path = find("all.gtn")
assert list(read_arrays(path, arrays="smooth").point_data) == ["smooth"]
chosen = read_arrays(path, arrays=["noise"])
assert list(chosen.point_data) == list(chosen.cell_data) == ["noise"]
assert not read_arrays(path, arrays=[]).point_data
some = read_arrays(write("some.gtn", arrays=iter(["smooth", "id"])))
assert list(some.point_data) == ["smooth"] and list(some.cell_data) == ["id"]

# Errors hold for every value, and where none is allowed nothing changes.
span = np.ptp(noise)
back = read_arrays(write("error.gtn", tolerances={"noise": "rel:1e-3"}, keep_order=True))
error = np.abs(back.point_data["noise"] - noise).max()
assert 0 < error <= 1e-3 * span, error
require_equal(back.point_data["smooth"], smooth)
back = read_arrays(write("errors.gtn", tolerances="abs:0.01", keep_order=True))
assert 0 < np.abs(back.point_data["smooth"] - smooth).max() <= 0.01
require_equal(back.cell_data["id"][0], np.arange(len(tets)))
assert os.path.getsize(find("errors.gtn")) < os.path.getsize(find("all.gtn"))
shaken = points + 0.01 * rng.standard_normal(points.shape)
for bound, most in ((0.001, 0.001), ("abs:0.001", 0.001), ("rel:1e-3", 1.1e-3), ("bits:10", 1.1e-3)):
    other = gatun.from_numpy(shaken, tets)
    back = read_arrays(write("coordinates.gtn", other, point_tolerance=bound, keep_order=True))
    assert 0 < np.abs(back.points - shaken).max() <= most

# A hierarchy, base meshes, layers and a boundary.
path = write("levels.gtn", hierarchy=True)
coarse = gatun.read(path, ratio=0.75)
assert coarse.GetNumberOfPoints() == len(points) - int(0.75 * len(points))
assert gatun.read(path).GetNumberOfCells() == len(tets)
reader = gatun.vtk.vtkGatunReader()
reader.SetFileName(write("more.gtn", layers=("smooth", 2), boundary=True, chunk_size=256))
reader.SetLargeMesh(0)
reader.Update()
assert reader.GetOutput().GetInformation().Get(reader.ON_DEMAND()) == reader.ON_DEMAND_BOUNDARY
faces = gatun.to_numpy(reader.GetOutput()).cells_dict["triangle"]
assert len(faces) == 6 * 2 * 8**2

# A box: all cells that touch it are there, and not all of the mesh.
part = gatun.read(find("more.gtn"), box=(0, 0.2, 0, 0.2, 0, 0.2))
arrays = gatun.to_numpy(part)
lows = points[tets].min(axis=1)
inside = np.flatnonzero((lows <= 0.2).all(axis=1))
assert set(inside) <= set(arrays.cell_data["id"][0])
assert len(inside) <= part.GetNumberOfCells() < len(tets)
assert gatun.read(find("more.gtn"), box=[5, 6, 5, 6, 5, 6]).GetNumberOfCells() == 0


# Time: a generator, a sequence that makes its meshes when asked, and an algorithm.
def make_step(step):
    return gatun.from_numpy(points, tets, point_data={"noise": noise * (step + 1)})


class Steps:
    asked = []

    def __len__(self):
        return 3

    def __getitem__(self, step):
        self.asked.append(step)
        return make_step(step)


for series in (map(make_step, range(3)), Steps(), [make_step(0), make_step(1), make_step(2)]):
    path = write("series.gtn", series, times=[0.5, 1, 4], keep_order="points")
    assert gatun.steps(path) == [0.5, 1, 4]
    for options, factor in (
        ({}, 1),
        ({"step": 1}, 2),
        ({"step": -1}, 3),
        ({"time": 3.9}, 2),
        ({"time": 0}, 1),
        ({"time": 9}, 3),
    ):
        back = read_arrays(path, **options)
        require_equal(back.point_data["noise"], noise * factor)
assert set(Steps.asked) == {0, 1, 2}
assert gatun.steps(write("counted.gtn", [make_step(0), make_step(1)])) == [0, 1]
assert gatun.steps(write("one.gtn", make_step(0))) == []
reader = gatun.vtk.vtkGatunReader()
reader.SetFileName(path)
assert gatun.steps(write("copied.gtn", reader, times=True)) == [0.5, 1, 4]

# Moving points.
moved = (gatun.from_numpy(points + [t, 0, 0], tets) for t in (0, 1))
back = read_arrays(write("moving.gtn", moved, keep_order="points"), step=1)
require_equal(back.points, points + [1, 0, 0])

# Surfaces, blocks, and objects with the members of a mesh of meshio.
sphere = vtkSphereSource()
triangles = vtkTriangleFilter()
triangles.SetInputConnection(sphere.GetOutputPort())
for data in (triangles, triangles.GetOutputPort()):
    surface = gatun.read(write("surface.gtn", data))
    assert surface.IsA("vtkPolyData")
    assert surface.GetNumberOfCells() == triangles.GetOutput().GetNumberOfCells() > 0
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, make_step(0))
blocks.SetBlock(1, gatun.from_numpy(points + [5, 0, 0], tets, point_data={"noise": noise}))
assert gatun.read(write("blocks.gtn", blocks)).GetNumberOfCells() == 2 * len(tets)
again = gatun.read(write("object.gtn", gatun.to_numpy(mesh)))
assert again.GetNumberOfCells() == len(tets)

# Hexahedra stay, unless they are to be split.
corners = [[0, 1, 10, 9, 81, 82, 91, 90]]
hexahedron = gatun.from_numpy(points, {"hexahedron": corners})
assert gatun.read(write("hexahedron.gtn", hexahedron)).GetCellType(0) == 12

# Volumes: without loss, with a bound, in boxes.
x = np.linspace(-1, 1, 20)
values = np.add.outer(np.add.outer(x[:12] ** 2, x[:16]), x) * 1000
values = (values + rng.integers(0, 9, values.shape)).astype(np.int16)
volume = gatun.image_from_numpy(values, spacing=(0.5, 1, 2), origin=(3, 4, 5), name="density")
path = write("volume.ghv", volume, rms_error=0)
back = gatun.read(path)
require_equal(gatun.image_to_numpy(back, "density"), values)
assert back.GetSpacing() == (0.5, 1, 2) and back.GetOrigin() == (3, 4, 5)
box = gatun.read(path, box=(4, 6.2, 5.5, 7, 0, 9))
assert box.GetExtent() == (2, 7, 1, 3, 0, 2)
require_equal(gatun.image_to_numpy(box), values[0:3, 1:4, 2:8])
gatun.write(volume, path, overwrite=True, psnr=40, block_size=16)
lossy = gatun.image_to_numpy(gatun.read(path)).astype(float)
assert 0 < np.sqrt(((lossy - values) ** 2).mean()) <= np.ptp(values) / 100
for mode, (name, value) in enumerate(
    [("Quality", 30), ("RMSError", 9), ("PSNR", 30), ("BitsPerVoxel", 3)]
):
    writer = gatun.vtk.vtkGatunHartleyWriter()
    writer.SetInputData(volume)
    writer.SetFileName(find("reference.ghv"))
    writer.GetEncoding().SetRateControl(mode)
    getattr(writer.GetEncoding(), "Set" + name)(value)
    writer.Write()
    option = ("quality", "rms_error", "psnr", "bits_per_voxel")[mode]
    gatun.write(volume, path, overwrite=True, **{option: value})
    with open(path, "rb") as a, open(find("reference.ghv"), "rb") as b:
        assert a.read() == b.read(), option

# gatun.info says what the program says, and does not run it.
def refuse(*_, **__):
    raise AssertionError("a program is run")


for name, command in (
    ("all.gtn", ["info"]),
    ("error.gtn", ["info"]),
    ("levels.gtn", ["info"]),
    ("more.gtn", ["info"]),
    ("moving.gtn", ["info"]),
    ("surface.gtn", ["info"]),
    ("volume.ghv", ["volume", "info"]),
):
    told = subprocess.run(
        [os.environ["GATUN_TEST_GTN"], *command, "--json", find(name)],
        stdout=subprocess.PIPE,
        check=True,
    )
    run, subprocess.Popen = subprocess.Popen, refuse
    contents = gatun.info(find(name))
    subprocess.Popen = run
    assert contents == json.loads(told.stdout), name
contents = gatun.info(find("all.gtn"))
assert contents["points"] == len(points) and contents["tets"] == len(tets)
