# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Parallel files as they are: pieces that are empty or missing, wrong declarations, faults."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter

from gatunCli import add_text, enter_folder, gtn, lattice, make_grid, read, write

enter_folder("part-files")
N = 3
POINTS, TETS = lattice(N)
TWO = ("--pieces", 2)


def box(number, kind=np.float32, values=np.float64):
    """A box in a row of boxes that have faces in common, bit for bit."""
    places = np.round(POINTS.astype(np.float64) * 64) / 64
    places[:, 0] = np.arange(len(places)) % (N + 1)
    places[:, 1:] = np.repeat(places[:: N + 1, 1:], N + 1, axis=0)
    places += [N * number, 0, 0]
    return make_grid(places.astype(kind), TETS, {"u": (places[:, 0] / 3).astype(values)})


def parallel(name, pieces, points="Float32", arrays='<PDataArray type="Float64" Name="u"/>',
             element="PUnstructuredGrid"):
    listed = "".join(f'<Piece Source="{piece}"/>' for piece in pieces)
    with open(name, "w", encoding="ascii") as file:
        file.write(f'<VTKFile type="{element}" version="1.0" byte_order="LittleEndian"><{element} '
                   f'GhostLevel="0"><PPointData>{arrays}</PPointData><PPoints><PDataArray '
                   f'type="{points}" NumberOfComponents="3"/></PPoints>{listed}</{element}>'
                   "</VTKFile>")


def same(mesh, grids, points=None):
    """A packed file has the cells and values of some grids, by VTK's own reader of each."""
    gtn("unpack", "-q", "-f", mesh, "back.vtu")
    back = read("back.vtu")
    assert back.GetNumberOfCells() == sum(grid.GetNumberOfCells() for grid in grids)
    assert back.GetNumberOfPoints() == (points or sum(g.GetNumberOfPoints() for g in grids))
    rows = lambda grid: np.column_stack([vtk_to_numpy(grid.GetPoints().GetData()).astype(float),
                                         vtk_to_numpy(grid.GetPointData().GetArray("u"))])
    corners = lambda grid: rows(grid)[vtk_to_numpy(grid.GetCells().GetConnectivityArray())]
    sort = lambda table: table[np.lexsort(table.T)]
    expected = np.concatenate([corners(grid) for grid in grids])
    assert np.array_equal(sort(corners(back)), sort(expected))


one, other = box(0), box(1)
write(one, "one.vtu")
write(other, "other.vtu")
COMMON = (N + 1) ** 2
APART = 2 * len(POINTS)

# Empty pieces, whole and one by one. An empty piece alone is an empty file.
write(vtkUnstructuredGrid(), "empty.vtu")
parallel("run.pvtu", ["empty.vtu", "one.vtu", "empty.vtu", "other.vtu"])
gtn("pack", "-q", "run.pvtu", "run.gtn")
same("run.gtn", [one, other])
gtn("verify", "run.gtn", "run.pvtu", says="identical")
for pieces in (2, 3, 4):
    gtn("pack", "-f", "--pieces", pieces, "run.pvtu", "run.gtn")
    gtn("verify", "run.gtn", "run.pvtu", says="identical")
gtn("pack", "-q", "-f", "--memory", 2000, "run.pvtu", "run.gtn")
same("run.gtn", [one, other], APART - COMMON)
for arguments in ((), TWO):
    gtn("pack", "-q", "-f", *arguments, "empty.vtu", "empty.gtn")
    assert json.loads(gtn("info", "--json", "empty.gtn"))["points"] == 0
parallel("empty.pvtu", ["empty.vtu", "empty.vtu"])
for arguments in ((), TWO, ("--memory", 2000)):
    gtn("pack", "-q", "-f", *arguments, "empty.pvtu", "empty.gtn")
    assert json.loads(gtn("info", "--json", "empty.gtn"))["points"] == 0
gtn("verify", "empty.gtn", "empty.pvtu", says="identical")

# One file with an empty piece before another one.
with open("one.vtu", "rb") as file:
    text = file.read()
with open("first.vtu", "wb") as file:
    file.write(text.replace(b"<Piece ", b'<Piece NumberOfPoints="0" NumberOfCells="0"></Piece><Piece ',
                            1))
gtn("pack", "-q", "first.vtu", "first.gtn")
same("first.gtn", [one])

# Missing pieces are named, or skipped.
parallel("gone.pvtu", ["one.vtu", "lost.vtu", "other.vtu"])
for arguments in ((), TWO, ("--memory", 2000)):
    gtn("pack", *arguments, "gone.pvtu", "never.gtn", code=1, says="lost.vtu; gtn pack --skip-missing")
    gtn("pack", "-f", "--skip-missing", *arguments, "gone.pvtu", "gone.gtn", says="missing: lost.vtu")
    gtn("verify", "gone.gtn", "gone.pvtu", code=1, says="lost.vtu")
    gtn("verify", "--skip-missing", "gone.gtn", "gone.pvtu", says="identical")
parallel("none.pvtu", ["lost.vtu"])
gtn("pack", "--skip-missing", "none.pvtu", "never.gtn", code=1, says="lost.vtu")

# Arrays that are declared and absent, that are there and not declared, and those of some pieces.
parallel("listed.pvtu", ["one.vtu", "other.vtu"], arrays='<PDataArray type="Float32" Name="normals"'
         ' NumberOfComponents="3"/>')
for arguments in ((), TWO):
    gtn("pack", "-f", *arguments, "listed.pvtu", "listed.gtn", says="array 'normals', which no piece")
    gtn("verify", "listed.gtn", "listed.pvtu", says="identical")
gtn("pack", "-q", "-f", "listed.pvtu", "listed.gtn")
same("listed.gtn", [one, other])
more = box(1)
add_text(more, "remark", ["of one piece"])
more.GetCellData().AddArray(box(0).GetPointData().GetArray("u"))
more.GetCellData().GetArray("u").SetNumberOfTuples(more.GetNumberOfCells())
write(more, "more.vtu")
parallel("some.pvtu", ["one.vtu", "more.vtu"])
for arguments in ((), TWO):
    gtn("pack", *arguments, "some.pvtu", "never.gtn", code=1,
        says="the cell array 'u' is in more.vtu, but not in one.vtu")

# Types that are declared wrongly, and types that differ: the values are right.
double, single = box(0, np.float64), box(1, np.float64, np.float32)
write(double, "double.vtu")
write(single, "single.vtu")
parallel("points.pvtu", ["double.vtu"], points="Float32")
gtn("pack", "-q", "points.pvtu", "points.gtn")
same("points.gtn", [double])
parallel("values.pvtu", ["double.vtu", "single.vtu", "one.vtu"])
for arguments, points in (((), APART + len(POINTS)), (("--pieces", 3, "--keep-apart"),
                                                      APART + len(POINTS))):
    gtn("pack", "-f", *arguments, "values.pvtu", "values.gtn",
        says="array 'u' is Float32 in some pieces and Float64 in others")
    same("values.gtn", [double, single, one], points)
    gtn("verify", "values.gtn", "values.pvtu", says="identical")
whole = box(1, values=np.int32)
write(whole, "int.vtu")
parallel("kinds.pvtu", ["one.vtu", "int.vtu"])
for arguments in ((), TWO):
    gtn("pack", *arguments, "kinds.pvtu", "never.gtn", code=1,
        says="the point array 'u' is Float64 in one.vtu, and Int32 in int.vtu")

# Points on both sides of a face between files are joined, which is told, or not.
parallel("fault.pvtu", ["one.vtu", "other.vtu"])
gtn("pack", "-f", *TWO, "fault.pvtu", "fault.gtn",
    says=f"{COMMON} points that pieces have in common were joined")
same("fault.gtn", [one, other], APART - COMMON)
gtn("verify", "fault.gtn", "fault.pvtu", says=f"but for {COMMON} points that its files have")
gtn("pack", "-q", "-f", *TWO, "--keep-order", "all", "fault.pvtu", "fault.gtn")
gtn("verify", "fault.gtn", "fault.pvtu", says=f"but for {COMMON} points that its files have")
said = gtn("pack", "-f", *TWO, "--keep-apart", "fault.pvtu", "apart.gtn")
assert "joined" not in said
same("apart.gtn", [one, other])
assert "but for" not in gtn("verify", "apart.gtn", "fault.pvtu", says="identical")
gtn("pack", "--keep-apart", "fault.pvtu", "never.gtn", code=2, says="--keep-apart needs --pieces")

# What is not joined is a difference: another value, and a point too few.
changed = box(1)
changed.GetPointData().GetArray("u").SetValue(5, 7)
write(changed, "changed.vtu")
parallel("changed.pvtu", ["one.vtu", "changed.vtu"])
gtn("verify", "fault.gtn", "changed.pvtu", code=1, says="differs")
fewer = box(1)
fewer.GetPoints().InsertNextPoint(99, 0, 0)
fewer.GetPointData().GetArray("u").InsertNextValue(1)
write(fewer, "fewer.vtu")
parallel("fewer.pvtu", ["one.vtu", "fewer.vtu"])
gtn("verify", "fault.gtn", "fewer.pvtu", code=1, says="at (99, 0, 0), is not in fault.gtn")

# Time steps of such files.
for number, files in enumerate((["one.vtu", "empty.vtu"], ["empty.vtu", "one.vtu"])):
    parallel(f"step{number}.pvtu", files)
gtn("pack", "-q", "step0.pvtu", "step1.pvtu", "steps.gtn")
gtn("verify", "steps.gtn", "one.vtu", "one.vtu", says="identical")
with open("run.pvd", "w", encoding="ascii") as file:
    sets = "".join(f'<DataSet timestep="{t}" part="{p}" file="{f}"/>' for t, p, f in (
        (0, 0, "one.vtu"), (0, 1, "other.vtu"), (1, 0, "one.vtu"), (1, 1, "lost.vtu"),
        (1, 2, "other.vtu"), (2, 0, "lost.vtu")))
    file.write(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')
gtn("pack", *TWO, "run.pvd", "never.gtn", code=1, says="2 of 6 files that it lists are missing")
gtn("pack", "-q", "--skip-missing", *TWO, "run.pvd", "run-steps.gtn")
assert json.loads(gtn("info", "--json", "run-steps.gtn"))["times"] == [0, 1]
gtn("verify", "--skip-missing", "run-steps.gtn", "run.pvd", says=f"but for {COMMON} points")

# Surfaces.
surfaces = []
for grid, name in ((one, "one.vtp"), (other, "other.vtp"), (vtkUnstructuredGrid(), "empty.vtp")):
    skin = vtkGeometryFilter()
    skin.SetInputData(grid)
    skin.Update()
    writer = vtkXMLPolyDataWriter()
    surfaces.append(skin.GetOutput() if grid.GetNumberOfCells() else vtkPolyData())
    writer.SetInputData(surfaces[-1])
    writer.SetFileName(name)
    writer.Write()
parallel("run.pvtp", ["empty.vtp", "one.vtp", "other.vtp", "lost.vtp"], element="PPolyData")
gtn("pack", "run.pvtp", "never.gtn", code=1, says="lost.vtp")
for arguments in ((), TWO, ("--pieces", 3)):
    gtn("pack", "-q", "-f", "--skip-missing", *arguments, "run.pvtp", "surface.gtn")
    assert json.loads(gtn("info", "--json", "surface.gtn"))["surface"]
    gtn("verify", "--skip-missing", "surface.gtn", "run.pvtp", says="identical")
gtn("pack", "-q", "-f", "empty.vtp", "surface.gtn")

# Blocks that are empty or missing, and lists in lists.
blocks = vtkMultiBlockDataSet()
for number, grid in enumerate((one, vtkUnstructuredGrid(), other)):
    blocks.SetBlock(number, grid)
writer = vtkXMLMultiBlockDataWriter()
writer.SetInputData(blocks)
writer.SetFileName("blocks.vtm")
writer.Write()
with open("outer.vtm", "w", encoding="ascii") as file:
    file.write('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
               '<DataSet index="0" name="inner" file="blocks.vtm"/>'
               '<DataSet index="1" name="more" file="single.vtu"/>'
               "</vtkMultiBlockDataSet></VTKFile>")
for arguments in ((), ("--memory", 2000), TWO):
    gtn("pack", "-q", "-f", *arguments, "blocks.vtm", "blocks.gtn")
    same("blocks.gtn", [one, other])
    gtn("verify", "blocks.gtn", "blocks.vtm", says="identical")
    gtn("pack", "-q", "-f", *arguments, "outer.vtm", "outer.gtn")
    gtn("verify", "outer.gtn", "outer.vtm", says="identical")
assert json.loads(gtn("info", "--json", "outer.gtn"))["points"] == APART + len(POINTS)
with open("self.vtm", "w", encoding="ascii") as file:
    file.write('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
               '<DataSet index="0" file="self.vtm"/></vtkMultiBlockDataSet></VTKFile>')
gtn("pack", "self.vtm", "never.gtn", code=1, says="list each other")
os.remove("blocks/blocks_2.vtu")
for arguments in ((), ("--memory", 2000), TWO):
    gtn("pack", *arguments, "blocks.vtm", "never.gtn", code=1, says="blocks_2.vtu; gtn pack --skip-missing")
    gtn("pack", "-q", "-f", "--skip-missing", *arguments, "blocks.vtm", "blocks.gtn")
    same("blocks.gtn", [one])
assert not os.path.exists("never.gtn")
