# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What readers of VTK drop, change or do not survive: each is kept, named, or refused with what to do."""

import json
import os
import shutil
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (vtkCompositeDataSet, vtkDataObject, vtkMultiBlockDataSet)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOXML import (vtkXMLMultiBlockDataWriter, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader,
                                 vtkXMLUnstructuredGridWriter)

import gatunSolverFiles
import gatunVolumes as gv
from gatun.vtk import vtkGatunWriter
from gatunCli import add_text, enter_folder, gtn, lattice, make_grid, read, standard_mesh, write

enter_folder("reader-faults")
PIPELINE = vtkStreamingDemandDrivenPipeline


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def unpacked(name="out.gtn", target="out.vtu", reader=vtkXMLUnstructuredGridReader):
    gtn("unpack", "-q", "-f", name, target)
    made = reader()
    made.SetFileName(target)
    made.Update()
    return made.GetOutput()


def field_of(grid):
    field = grid.GetFieldData()
    return {field.GetArrayName(i): [field.GetAbstractArray(i).GetVariantValue(k).ToString()
                                    for k in range(field.GetAbstractArray(i).GetNumberOfValues())]
            for i in range(field.GetNumberOfArrays())}


# Field arrays of blocks: once if they are equal, else by block.
blocks = vtkMultiBlockDataSet()
for number in range(3):
    points, tets = lattice(2)
    grid = make_grid(points + np.float32(3 * number), tets)
    add(grid.GetFieldData(), "same", np.array([1.5, np.nan]))
    add(grid.GetFieldData(), "serial", np.array([10 + number // 2]))
    add(grid.GetFieldData(), f"own{number}", np.array([number]))
    add_text(grid, "remark", [f"of {number}"])
    blocks.SetBlock(number, grid)
    blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), ("wing", "wing", "tail")[number])
writer = vtkXMLMultiBlockDataWriter()
writer.SetInputData(blocks)
writer.SetFileName("fields.vtm")
assert writer.Write()
for options in ((), ("--pieces", 2)):
    gtn("pack", "-f", *options, "fields.vtm", "out.gtn")
    gtn("verify", "out.gtn", "fields.vtm", says="identical")
    field = field_of(unpacked())
    assert field["same"] == ["1.5", "nan"] and "same (wing)" not in field, field
    assert [field[f"own{i}"] for i in range(3)] == [["0"], ["1"], ["2"]], field
    assert field["serial (wing)"] == ["10"] == field["serial (wing) (2)"] and field["serial (tail)"] == ["11"]
    assert field["remark (wing)"] == ["of 0"] and field["remark (tail)"] == ["of 2"] and "remark" not in field
# Pieces of one mesh.
for number in range(2):
    points, tets = lattice(2)
    grid = make_grid(points + np.float32(3 * number), tets)
    add(grid.GetFieldData(), "serial", np.array([number]))
    write(grid, f"piece{number}.vtu")
with open("pieces.pvtu", "w") as file:
    file.write('<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"><PUnstructuredGrid '
               'GhostLevel="0"><PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="3"/>'
               '</PPoints><Piece Source="piece0.vtu"/><Piece Source="piece1.vtu"/></PUnstructuredGrid></VTKFile>')
gtn("pack", "-f", "pieces.pvtu", "out.gtn", says="the field array 'serial' differs between pieces")


# Arrays without a name get that of their role.
grid = standard_mesh(2)
for place in range(3):
    array = numpy_to_vtk(np.full((grid.GetNumberOfPoints(), 3), place, np.float32), deep=True)
    grid.GetPointData().SetNormals(array) if place == 0 else grid.GetPointData().AddArray(array)
writer = vtkGatunWriter()
writer.SetInputData(grid)
writer.SetFileName("nameless.gtn")
assert writer.Write()
gtn("pack", "-f", "nameless.gtn", "out.gtn", says="a point array without a name is called 'Normals'")
data = unpacked().GetPointData()
assert [vtk_to_numpy(data.GetArray(name))[0, 0] for name in ("Normals", "Array", "Array (2)")] == [0, 1, 2]
assert data.GetNormals().GetName() == "Normals"

# A scene of glTF: names and ids of its meshes, arrays of some of them.
def scene(name, coordinates):
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0]], np.float32)
    texture = np.array([[0, 0], [1, 0], [1, 1]], np.float32)
    binary = corners.tobytes() + texture.tobytes()
    attributes = [{"POSITION": 0, **({"TEXCOORD_0": 1} if on else {})} for on in coordinates]
    meshes = [{"name": f"part {i}", "primitives": [{"attributes": a}]} for i, a in enumerate(attributes)]
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(meshes)))}],
        "nodes": [{"mesh": i, "translation": [5 * i, 0, 0]} for i in range(len(meshes))], "meshes": meshes,
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": corners.nbytes},
                        {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": texture.nbytes}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]}).encode()
    text += b" " * (-len(text) % 4)
    with open(name, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text)
        out.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


scene("scene.glb", (False, True, False))
gtn("pack", "-f", "--keep-order", "all", "scene.glb", "out.gtn", says="3 blocks were merged into one surface")
gtn("verify", "out.gtn", "scene.glb", says="identical")
surface = unpacked(target="out.vtp", reader=vtkXMLPolyDataReader)
assert vtk_to_numpy(surface.GetCellData().GetArray("BlockId")).tolist() == [0, 1, 2]
assert len(field_of(surface)["BlockNames"]) == 3, field_of(surface)
texture = vtk_to_numpy(surface.GetPointData().GetArray("TEXCOORD_0"))
assert np.isnan(texture[[0, 1, 2, 6, 7, 8]]).all() and texture[5].tolist() == [1, 1], texture

# Types of VTK's files that are not read, under any name.
write(standard_mesh(2), "mesh.vtu")
for kind, name in (("vtkHierarchicalBoxDataSet", "amr.vtm"), ("vtkOverlappingAMR", "amr.vtu"),
                   ("vtkNonOverlappingAMR", "amr.vti"), ("HyperTreeGrid", "tree.vtu"), ("Table", "table.vtp"),
                   ("Molecule", "molecule.vtp")):
    with open(name, "w") as file:
        file.write(f'<?xml version="1.0"?>\n<!-- by hand -->\n<VTKFile type="{kind}" version="1.1"><{kind}>'
                   f'<DataSet group="0" dataset="0" amr_box="0 7 0 7 0 7" file="a.vti"/></{kind}></VTKFile>')
    gtn("pack", name, "new.gtn", code=1, says=f"gtn: {name}: holds a {kind}, which gtn does not read; ")
    with open("list.vtm", "w") as file:
        file.write('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                   f'<DataSet index="0" file="mesh.vtu"/><DataSet index="1" file="{name}"/>'
                   '</vtkMultiBlockDataSet></VTKFile>')
    gtn("pack", "list.vtm", "new.gtn", code=1, says=f"{name}: holds a {kind}")
shutil.copy("fields.vtm", "other.vtp")
gtn("pack", "other.vtp", "new.gtn", code=1, says="other.vtp: holds a vtkMultiBlockDataSet, and not the PolyData")

# Several time steps in one file of VTK.
grid = standard_mesh(2)
count = grid.GetNumberOfPoints()
writer = vtkXMLUnstructuredGridWriter()
writer.SetFileName("steps.vtu")
writer.SetNumberOfTimeSteps(3)
writer.SetInputData(grid)
writer.Start()
for step in range(3):
    add(grid.GetPointData(), "rising", np.arange(count) + 100.0 * step)
    grid.Modified()
    writer.WriteNextTime(0.5 * step)
writer.Stop()
gtn("pack", "-f", "--keep-order", "all", "steps.vtu", "out.gtn", says="3 time steps")
gtn("verify", "out.gtn", "steps.vtu", says="identical")
for step in range(3):
    gtn("unpack", "-q", "-f", "--step", step, "out.gtn", "step.vtu")
    back = read("step.vtu")
    assert back.GetNumberOfCells() == grid.GetNumberOfCells()
    assert (vtk_to_numpy(back.GetPointData().GetArray("rising")) == np.arange(count) + 100 * step).all(), step
gtn("pack", "-f", "--steps", "1:2", "steps.vtu", "out.gtn", says="2 time steps")


class Moving(VTKPythonAlgorithmBase):
    """A mesh with displacements at some times."""

    def __init__(self, times):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self.times = times

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(PIPELINE.TIME_STEPS(), self.times, len(self.times))
        info.Set(PIPELINE.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        time = outputs.GetInformationObject(0).Get(PIPELINE.UPDATE_TIME_STEP())
        points, tets = lattice(2, dtype=np.float64)
        made = make_grid(points, tets, {"DISPL": np.full(points.shape, 1 + time)})
        output = vtkDataObject.GetData(outputs)
        output.ShallowCopy(made)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


# Exodus: coordinates are those of the file, and two equal times are named.
def write_moving(name, times):
    writer = vtkExodusIIWriter()
    moving = Moving(times)
    writer.SetInputConnection(moving.GetOutputPort())
    writer.SetFileName(name)
    writer.WriteAllTimeStepsOn()
    assert writer.Write()


TIMES = [0.0, 1 + 2**-20, 2.0]
write_moving("moving.e", TIMES)
gtn("pack", "-f", "--keep-order", "all", "moving.e", "out.gtn", says="3 time steps")
for step, time in enumerate(TIMES):
    gtn("unpack", "-q", "-f", "--step", step, "out.gtn", "step.vtu")
    back = read("step.vtu")
    have = vtk_to_numpy(back.GetPoints().GetData())
    places = lattice(2, dtype=np.float64)[0].astype(have.dtype)
    assert np.array_equal(have[np.lexsort(have.T)], places[np.lexsort(places.T)]), step
    displaced = vtk_to_numpy(back.GetPointData().GetArray("DISPL"))
    assert np.array_equal(displaced, np.full(displaced.shape, 1 + time, displaced.dtype)), (step, displaced)
write_moving("twice.e", [0.0, TIMES[1], TIMES[1]])
gtn("pack", "-f", "twice.e", "new.gtn", code=1,
    says=f"twice.e: the times of the steps must ascend: step 1 is at {TIMES[1]!r}, and step 2 at {TIMES[1]!r}; "
    "--steps chooses some of them, such as --steps 0:1")
gtn("pack", "-f", "--steps", "0:1", "twice.e", "out.gtn", says="2 time steps")

# A cell with a wrong number of points.
with open("cell.vtk", "w") as file:
    file.write("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 20 float\n"
               + " ".join(map(str, range(60))) + "\nCELLS 1 21\n20 " + " ".join(map(str, range(20)))
               + "\nCELL_TYPES 1\n12\n")
gtn("pack", "cell.vtk", "new.gtn", code=1,
    says="cell.vtk: cell 0 (type 12, vtkHexahedron) has 20 points, not 8")

# Points that global ids join.
blocks = vtkMultiBlockDataSet()
for number in range(2):
    points, tets = lattice(2)
    grid = make_grid(points, tets)
    add(grid.GetPointData(), "ids", np.arange(len(points)))
    grid.GetPointData().SetActiveGlobalIds("ids")
    blocks.SetBlock(number, grid)
writer = vtkXMLMultiBlockDataWriter()
writer.SetInputData(blocks)
writer.SetFileName("joined.vtm")
assert writer.Write()
gtn("pack", "-f", "joined.vtm", "out.gtn",
    says=f"{len(points)} points of blocks were joined with others that have the same global id")

# A field of OpenFOAM that VTK does not read.
corners = np.array([[x, y, z] for z in range(2) for y in range(2) for x in range(3)], float)
bricks = np.array([[0, 1, 4, 3, 6, 7, 10, 9], [1, 2, 5, 4, 7, 8, 11, 10]])
gatunSolverFiles.write_foam("foam", corners, bricks, [1.5, 2.5])
with open("foam/0/p") as file:
    pressure = file.read()
with open("foam/0/T", "w") as file:
    file.write(pressure.replace("[0 2 -2 0 0 0 0]", "[temperature]").replace("object p", "object T"))
for options in ((), ("--arrays", "p")):
    gtn("pack", "-f", *options, "foam/case.foam", "out.gtn",
        says="the field 'T' is left out, which VTK does not read: ")
    back = unpacked()
    assert sorted(vtk_to_numpy(back.GetCellData().GetArray("p"))) == [1.5, 2.5]
    assert not back.GetCellData().HasArray("T")
with open("foam/constant/polyMesh/points", "a") as file:
    file.seek(0)
    file.truncate()
gtn("pack", "-f", "foam/case.foam", "new.gtn", code=1)

# Tables of colors.
with open("table.vtk", "w") as file:
    file.write("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
               "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
               "SCALARS u float 1\nLOOKUP_TABLE mine\n1 2 3 4\nLOOKUP_TABLE mine 2\n1 0 0 1\n0 0 1 1\n")
gtn("pack", "-f", "table.vtk", "out.gtn", says="the lookup table of the point array 'u' is left out")
gtn("verify", "out.gtn", "table.vtk", code=1, says="the lookup table of the point array 'u'")
gtn("pack", "-f", "mesh.vtu", "out.gtn")

# Volumes: values in text, several components, floats that are rounded.
header = "NRRD0004\ntype: {}\ndimension: 3\nsizes: 12 2 2\nencoding: {}\n\n"
for word in ("ascii", "text", "TXT"):
    with open("text.nrrd", "w") as file:
        file.write(header.format("uint8", word) + "1 2 3 4 5 6 7 8\n")
    gtn("volume", "pack", "text.nrrd", "new.ghv", code=1, says="text.nrrd: has its values as text")
with open("raw.nrrd", "wb") as file:
    file.write(header.format("uint8", "raw").encode() + bytes(range(48)))
gtn("volume", "pack", "-f", "--rms-error", 0, "raw.nrrd", "raw.ghv", says="largest error 0")
with open("zipped.nrrd", "wb") as file:
    file.write(header.format("uint8", "bzip2").encode() + bytes(48))
gtn("volume", "pack", "zipped.nrrd", "new.ghv", code=1, says="write it with the encoding raw or gzip")
color = gv.make_image(np.zeros((4, 5, 6), np.uint8), "color")
color.GetPointData().RemoveArray("color")
add(color.GetPointData(), "color", np.zeros((120, 3), np.uint8))
gv.write_image(color, "color.vti")
gtn("volume", "pack", "color.vti", "new.ghv", code=1,
    says="color.vti: the point array 'color' has 3 components, and a volume has one; save one of them")
gv.write_image(gv.make_image(gv.field().astype(np.float32) * np.float32(1.1), "u"), "float.vti")
gtn("volume", "pack", "-f", "--rms-error", 0, "float.vti", "float.ghv", says="floating-point values are rounded")

# Texts that are no files of their kind.
with open("wide.obj", "wb") as file:
    file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".encode("utf-16"))
gtn("pack", "wide.obj", "new.gtn", code=1, says="wide.obj: is text in UTF-16")
with open("empty.obj", "w") as file:
    file.write("# nothing\n")
gtn("pack", "empty.obj", "new.gtn", code=1, says="empty.obj: has no points")
with open("spaced.stl", "w") as file:
    file.write("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
               "endfacet\nend solid\n")
gtn("pack", "spaced.stl", "new.gtn", code=1, says="spaced.stl: has 'end solid' where 'endsolid' must be")
assert not [name for name in os.listdir(".") if name.startswith("new")], os.listdir(".")
