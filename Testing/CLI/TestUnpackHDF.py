# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""unpack --all writes a VTKHDF file where VTK can: it comes back whole, and what it does not hold is named."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkCellTypeSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from gatunCli import add_text, enter_folder, gtn, lattice, make_grid, write

try:
    from vtkmodules.vtkIOHDF import vtkHDFWriter
except ImportError:
    vtkHDFWriter = None

POLYHEDRON = 42

enter_folder("unpackhdf")
points, tets = lattice(6)
FIELD = points.sum(axis=1)


def named(values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


def series(name, step_of, steps=4):
    files = [f"{name}{step}.vtu" for step in range(steps)]
    for step, file in enumerate(files):
        write(step_of(step), file)
    gtn("pack", "-q", "-f", "--keep-order", "all", *files, name + ".gtn")
    return name + ".gtn"


def still(step):
    grid = make_grid(points, tets, {"u": np.random.default_rng(step).random(len(points), np.float32)}, {"id": np.arange(len(tets), dtype=np.int16)})
    grid.GetFieldData().AddArray(named(np.array([0.1 * step]), "residual"))
    add_text(grid, "case", ["run", f"step {step}"])
    return grid


def moving(step):
    return make_grid((points * (1 + 0.1 * (step // 2))).astype(np.float32), tets, {"u": FIELD})


def of_other_cells(step):
    kept = tets[: len(tets) - step]
    return make_grid(points, kept, {"u": FIELD})


source = series("still", still)
gtn("unpack", "--all", source, "never.vtu", code=2, says="must end in .pvd or .vtkhdf")
gtn("unpack", source, "never.vtkhdf", code=2, says="which --all writes")
if not vtkHDFWriter:
    gtn("unpack", "--all", source, "never.vtkhdf", code=1, says="9.4 and later do")
    assert not os.path.exists("never.vtkhdf")
    raise SystemExit

for file in (source, series("moving", moving)):
    back = file + ".vtkhdf"
    gtn("unpack", "--all", file, back, says="4 time steps")
    gtn("verify", file, back, says="identical")
    gtn("unpack", "-q", "-f", "--all", "--steps", "1:3:2", file, "some.vtkhdf")
    gtn("verify", file, "some.vtkhdf", code=1, says="4 time steps, not 2")
gtn("unpack", "--all", source, "still.gtn.vtkhdf", code=1, says="exists; use -f")
gtn("unpack", "-q", "-f", "--all", "--compressor", "none", source, "raw.vtkhdf")
assert os.path.getsize("raw.vtkhdf") > os.path.getsize("still.gtn.vtkhdf")
gtn("unpack", "--all", "--compressor", "lzma", source, "never.vtkhdf", code=2, says="takes none or zlib")

sphere = vtkSphereSource()
for step in range(3):
    sphere.SetRadius(1 + step)
    sphere.Update()
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(sphere.GetOutput())
    writer.SetFileName(f"sphere{step}.vtp")
    writer.Write()
gtn("pack", "-q", "sphere0.vtp", "sphere1.vtp", "sphere2.vtp", "sphere.gtn")
gtn("unpack", "--all", "sphere.gtn", "sphere.vtkhdf", says="which arrays are active left out")
gtn("verify", "sphere.gtn", "sphere.vtkhdf", code=1, says="active Normals")


# What the format has no place for is told.
def rich(step):
    grid = still(step)
    vectors = named(np.zeros((len(points), 3), np.float32), "flow.x/y")
    vectors.SetComponentName(0, "east")
    grid.GetPointData().SetVectors(vectors)
    return grid


lost = "the component names of array 'flow.x/y', the name of array 'flow.x/y' (flow_x_y), which arrays are active"
gtn("unpack", "--all", series("rich", rich), "rich.vtkhdf", says=lost + " left out")


def polyhedra(step):
    cells = vtkCellTypeSource()
    cells.SetCellType(POLYHEDRON)
    cells.Update()
    cells.GetOutput().GetPointData().Initialize()
    cells.GetOutput().GetCellData().Initialize()
    return cells.GetOutput()


def alike(step):
    return make_grid(points, tets, {"a.b": FIELD, "a_b": FIELD})


with open("kept.vtkhdf", "w", encoding="ascii") as file:
    file.write("kept")
for refused, says in ((polyhedra, "has polyhedra"), (of_other_cells, "has other cells at a later time step"), (alike, "without a name of its own")):
    gtn("unpack", "-f", "--all", series(refused.__name__, refused, 2), "kept.vtkhdf", code=1, says=says)
    assert open("kept.vtkhdf", encoding="ascii").read() == "kept"
with open(source, "rb") as file:
    damaged = bytearray(file.read())
damaged[len(damaged) * 3 // 4] ^= 1  # in the values of a later step
with open("damaged.gtn", "wb") as file:
    file.write(damaged)
gtn("unpack", "-f", "--all", "damaged.gtn", "kept.vtkhdf", code=1, says="checksum")
assert open("kept.vtkhdf", encoding="ascii").read() == "kept"
assert not [name for name in os.listdir(".") if name.startswith(".")], "temporary files are left"
