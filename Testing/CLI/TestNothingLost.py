# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What a mesh has beside its cells and values comes back, or a message tells that it does not: ghost
cells, information keys, names of points, texts, times, sets, numbers and variables of Exodus files.
verify tells what a file lacks, all of it."""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDataArray, vtkDoubleArray, vtkInformationIntegerVectorKey, vtkStringArray)
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkQuadratureSchemeDefinition)
from vtkmodules.vtkIOExodus import vtkExodusIIReader, vtkExodusIIWriter
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter

from gatunCli import enter_folder, gtn, make_grid, lattice, read, standard_mesh, write

enter_folder("nothing-lost")
points, tets = lattice(3)
GHOSTS = np.zeros(len(tets), np.uint8)
GHOSTS[points[tets].mean(1)[:, 0] > 0.7] = 1
COUNT = np.count_nonzero(GHOSTS)
REGION = vtkInformationIntegerVectorKey.MakeKey("REGION", "TestNothingLost")


def full():
    """A mesh with one of everything."""
    grid = make_grid(points, tets, {"u": points[:, 0]}, {"vtkGhostType": GHOSTS, "number": np.arange(len(tets))})
    grid.GetPoints().GetData().SetName("Position")
    info = grid.GetPointData().GetArray("u").GetInformation()
    info.Set(vtkDataArray.UNITS_LABEL(), "m/s")
    for number in (3, -4):
        info.Append(REGION, number)
    inlet = numpy_to_vtk(np.array([2, 5]), deep=True)
    inlet.SetName("inlet")
    grid.GetFieldData().AddArray(inlet)
    inlet.GetInformation().Set(vtkDataArray.UNITS_LABEL(), "1")
    time = vtkDoubleArray()
    time.SetName("TimeValue")
    time.InsertNextValue(2.5)
    grid.GetFieldData().AddArray(time)
    return grid


def unpacked(name, *options):
    gtn("unpack", "-f", *options, name, "back.vtu")
    return read("back.vtu")


# All of it comes back.
write(full(), "full.vtu")
for order in ("none", "all"):
    assert "ghost" not in gtn("pack", "-f", "--keep-order", order, "full.vtu", "full.gtn")
    gtn("verify", "full.gtn", "full.vtu", says="identical")
back = unpacked("full.gtn")
assert back.GetNumberOfCells() == len(tets) and back.GetNumberOfPoints() == len(points)
assert np.array_equal(vtk_to_numpy(back.GetCellData().GetArray("vtkGhostType")), GHOSTS)
assert back.GetPoints().GetData().GetName() == "Position"
information = back.GetPointData().GetArray("u").GetInformation()
assert information.Get(vtkDataArray.UNITS_LABEL()) == "m/s"
assert [REGION.Get(information, i) for i in range(REGION.Length(information))] == [3, -4]
assert back.GetFieldData().GetArray("inlet").GetInformation().Get(vtkDataArray.UNITS_LABEL()) == "1"


# Each thing that is missing is told.
def without_ghost(grid):
    flags = vtk_to_numpy(grid.GetCellData().GetArray("vtkGhostType"))
    flags[np.flatnonzero(flags)[0]] = 0


def without_time(grid):
    grid.GetFieldData().RemoveArray("TimeValue")


CHANGES = {
    "array": (lambda grid: grid.GetCellData().RemoveArray("number"), "cell array 'number' is in full.vtu only"),
    "set": (lambda grid: grid.GetFieldData().RemoveArray("inlet"), "field array 'inlet' is in full.vtu only"),
    "ghost": (without_ghost, "cell array 'vtkGhostType' of cell"),
    "time": (without_time, "no time, not 2.5 as in full.vtu"),
    "key": (lambda grid: grid.GetPointData().GetArray("u").GetInformation().Remove(vtkDataArray.UNITS_LABEL()),
            "point array 'u': the key vtkDataArray::UNITS_LABEL = m/s is in full.vtu only"),
    "region": (lambda grid: grid.GetPointData().GetArray("u").GetInformation().Remove(REGION),
               "the key TestNothingLost::REGION = 3, -4 is in full.vtu only"),
    "name": (lambda grid: grid.GetPoints().GetData().SetName("Points"), "the coordinates"),
}
everything = full()
for name, (change, says) in CHANGES.items():
    poor = full()
    for one in (poor, everything):
        change(one)
    write(poor, name + ".vtu")
    gtn("pack", "-q", name + ".vtu", name + ".gtn")
    gtn("verify", name + ".gtn", "full.vtu", code=1, says=says)
write(everything, "poor.vtu")
gtn("pack", "-q", "poor.vtu", "poor.gtn")
for name, (_, says) in CHANGES.items():
    if name != "ghost":
        gtn("verify", "poor.gtn", "full.vtu", code=1, says=says)

# Ghost cells are left out where that is asked for, or pieces are put together.
gtn("pack", "--no-ghosts", "full.vtu", "own.gtn", says=f"{COUNT} ghost cells are left out")
gtn("verify", "own.gtn", "full.vtu", code=1, says=f"{COUNT} ghost cells of full.vtu are missing")
gtn("verify", "--no-ghosts", "own.gtn", "full.vtu", says="identical")
assert unpacked("own.gtn").GetNumberOfCells() == len(tets) - COUNT
other = full()
other.GetCellData().GetArray("vtkGhostType").DeepCopy(numpy_to_vtk(1 - GHOSTS, deep=True))
other.GetCellData().GetArray(0).SetName("vtkGhostType")
write(other, "other.vtu")
with open("run.pvtu", "w", encoding="ascii") as file:
    file.write('<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="1"><PPoints>'
               '<PDataArray type="Float32" Name="Position" NumberOfComponents="3"/></PPoints>'
               '<PPointData><PDataArray type="Float32" Name="u"/></PPointData><PCellData>'
               '<PDataArray type="UInt8" Name="vtkGhostType"/><PDataArray type="Int64" Name="number"/>'
               '</PCellData><Piece Source="full.vtu"/><Piece Source="other.vtu"/>'
               '</PUnstructuredGrid></VTKFile>')
gtn("pack", "--pieces", 2, "run.pvtu", "run.gtn", says=f"{len(tets)} ghost cells are left out")
assert unpacked("run.gtn").GetNumberOfCells() == len(tets)
gtn("verify", "run.gtn", "run.pvtu", code=1, says=f"{len(tets)} ghost cells of run.pvtu are missing")
gtn("verify", "--no-ghosts", "run.gtn", "run.pvtu", says="identical")
gtn("pack", "-q", "run.pvtu", "whole.gtn")
gtn("verify", "whole.gtn", "run.pvtu", says="identical")
assert unpacked("whole.gtn").GetNumberOfCells() == 2 * len(tets)

# Texts at points are left out with a message; other arrays can be, without one.
texts = standard_mesh(3)
label = vtkStringArray()
label.SetName("label")
label.SetNumberOfValues(texts.GetNumberOfPoints())
texts.GetPointData().AddArray(label)
write(texts, "texts.vtu")
gtn("pack", "texts.vtu", "texts.gtn", says="the point array 'label' is left out")
gtn("pack", "-f", "texts.vtu", "texts.gtn", says="--skip 'label'")
gtn("verify", "texts.gtn", "texts.vtu", code=1, says="the point array 'label' is left out")
assert "label" not in gtn("pack", "-f", "--skip", "label,quality", "texts.vtu", "texts.gtn")
gtn("verify", "--skip", "label,quality", "texts.gtn", "texts.vtu", says="identical")
gtn("verify", "--skip", "label", "texts.gtn", "texts.vtu", code=1, says="cell array 'quality' is in texts.vtu only")
gtn("pack", "--skip", "labels", "texts.vtu", "never.gtn", code=1, says="has no array 'labels'")

# A legacy file has no time, and an array with the time of the data stays as it is.
writer = vtkUnstructuredGridWriter()
writer.SetInputData(standard_mesh(3))
writer.SetFileName("legacy.vtk")
assert writer.Write()
gtn("pack", "legacy.vtk", "legacy.gtn")
gtn("info", "--json", "legacy.gtn", says='"times": []')
assert not unpacked("legacy.gtn").GetFieldData().HasArray("TimeValue")
for step in (0, 1):
    write(full(), f"same{step}.vtu")  # of one time, and the list has others
with open("same.pvd", "w", encoding="ascii") as file:
    file.write('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="same0.vtu"/>'
               '<DataSet timestep="1" file="same1.vtu"/></Collection></VTKFile>')
gtn("pack", "-q", "same.pvd", "same.gtn")
assert unpacked("same.gtn", "--step", 1).GetFieldData().GetArray("TimeValue").GetValue(0) == 2.5

# Quadrature schemes.
scheme = vtkQuadratureSchemeDefinition()
weights = np.arange(8.) / 8
scheme.Initialize(10, 4, 2, weights, np.array([0.25, 0.75]))
grid = full()
offsets = numpy_to_vtk(np.arange(len(tets)), deep=True)
offsets.SetName("offsets")
grid.GetCellData().AddArray(offsets)
KEY = vtkQuadratureSchemeDefinition.DICTIONARY()
KEY.Set(offsets.GetInformation(), scheme, 10)
grid.GetPointData().GetArray("u").GetInformation().Set(
    vtkQuadratureSchemeDefinition.QUADRATURE_OFFSET_ARRAY_NAME(), "offsets")
write(grid, "scheme.vtu")
gtn("pack", "-q", "scheme.vtu", "scheme.gtn")
gtn("verify", "scheme.gtn", "scheme.vtu", says="identical")
back = unpacked("scheme.gtn")
again = KEY.Get(back.GetCellData().GetArray("offsets").GetInformation(), 10)
assert (again.GetCellType(), again.GetNumberOfNodes(), again.GetNumberOfQuadraturePoints()) == (10, 4, 2)
assert back.GetPointData().GetArray("u").GetInformation().Get(
    vtkQuadratureSchemeDefinition.QUADRATURE_OFFSET_ARRAY_NAME()) == "offsets"


# Exodus files: numbers of elements and nodes that are not 1, 2, 3 ...
def exodus(name, elements, nodes):
    block = make_grid(points.astype(float), tets, {"u": points[:, 0]})
    for data, array, values in ((block.GetCellData(), "GlobalElementId", elements),
                                (block.GetPointData(), "GlobalNodeId", nodes)):
        ids = numpy_to_vtk(values, deep=True, array_type=12)
        ids.SetName(array)
        data.SetGlobalIds(ids)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, block)
    out = vtkExodusIIWriter()
    out.SetInputData(blocks)
    out.SetFileName(name)
    assert out.Write()


for first in (1, 11):
    exodus("ids.e", np.arange(first, first + len(tets)), np.arange(first, first + len(points))[::-1])
    gtn("pack", "-q", "-f", "ids.e", "ids.gtn")
    gtn("verify", "ids.gtn", "ids.e", says="identical")
    reader = vtkExodusIIReader()
    reader.SetFileName("ids.e")
    reader.GenerateGlobalElementIdArrayOn()
    reader.GenerateGlobalNodeIdArrayOn()
    reader.Update()
    source = reader.GetOutput().GetBlock(0).GetBlock(0)
    back = unpacked("ids.gtn")
    for data, original, array, counted in (
            (back.GetCellData(), source.GetCellData(), "GlobalElementId", first == 1),
            (back.GetPointData(), source.GetPointData(), "GlobalNodeId", False)):
        assert data.HasArray(array) != counted, (array, first)
        if not counted:
            assert sorted(vtk_to_numpy(data.GetArray(array))) == sorted(
                vtk_to_numpy(original.GetArray(array)))

# A decomposed case of OpenFOAM is refused with the way out.
os.makedirs("case/processor0/constant/polyMesh")
os.makedirs("case/system")
for name in ("case/case.foam", "case/system/controlDict"):
    with open(name, "w", encoding="ascii"):
        pass
gtn("pack", "case/case.foam", "case.gtn", code=1, says="reconstructPar")

# VTK 9.6 crashes at the end of Python after MakeKey.
sys.stdout.flush()
os._exit(0)
