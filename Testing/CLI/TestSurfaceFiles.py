# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gtn packs, verifies, describes and unpacks surfaces in VTK's formats, rounds their coordinates, writes
isosurfaces as .gtn, and says what it cannot do with surfaces."""

import json
import os
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkStripper
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from gatun.vtk import vtkGatunSurfaceReader
from gatunCli import enter_folder, gtn, standard_mesh, write
from gatunSurfaces import read_surface

enter_folder("surfaces")
sphere = vtkSphereSource()
sphere.SetThetaResolution(40)
sphere.SetPhiResolution(30)
sphere.Update()
whole_sphere = vtkPolyData()
whole_sphere.DeepCopy(sphere.GetOutput())
TRIANGLES = whole_sphere.GetNumberOfPolys()
stripper = vtkStripper()
stripper.SetInputConnection(sphere.GetOutputPort())
plane = vtkPlaneSource()
plane.SetResolution(9, 9)
line = vtkLineSource()
line.SetResolution(5)
all_lists = vtkAppendPolyData()
for source in (stripper, plane, line):
    all_lists.AddInputConnection(source.GetOutputPort())
all_lists.Update()
mixed = all_lists.GetOutput()
numbers = numpy_to_vtk(np.arange(mixed.GetNumberOfCells(), dtype=np.int32), deep=True)
numbers.SetName("number")
mixed.GetCellData().AddArray(numbers)
heights = numpy_to_vtk(np.linspace(0, 1, mixed.GetNumberOfPoints()).astype(np.float32), deep=True)
heights.SetName("height")
mixed.GetPointData().AddArray(heights)


def save(writer, data, name):
    writer.SetInputData(data)
    writer.SetFileName(name)
    assert writer.Write()


save(vtkXMLPolyDataWriter(), mixed, "mixed.vtp")
save(vtkPolyDataWriter(), mixed, "mixed.vtk")
save(vtkSTLWriter(), whole_sphere, "sphere.stl")
save(vtkPLYWriter(), whole_sphere, "sphere.ply")
save(vtkOBJWriter(), whole_sphere, "sphere.obj")
parallel = vtkXMLPPolyDataWriter()
parallel.SetNumberOfPieces(3)
parallel.SetStartPiece(0)
parallel.SetEndPiece(2)
parallel.SetInputConnection(sphere.GetOutputPort())
parallel.SetFileName("sphere.pvtp")
assert parallel.Write()


def info(name):
    return json.loads(gtn("info", "--json", name))


for name, cells in (("mixed.vtp", mixed.GetNumberOfCells()), ("mixed.vtk", mixed.GetNumberOfCells()),
                    ("sphere.stl", TRIANGLES), ("sphere.ply", TRIANGLES), ("sphere.obj", TRIANGLES),
                    ("sphere.pvtp", TRIANGLES)):
    for options in ((), ("--keep-order", "all", "--chunk-size", "64")):
        gtn("pack", "-f", *options, name, name + ".gtn")
        gtn("verify", name + ".gtn", name, says="identical")
        gtn("verify", name + ".gtn", says="intact")
    told = info(name + ".gtn")
    assert told["surface"] is True and told["cells"] == cells, told
    assert told["formatVersion"] == 1 and told["tets"] == 0
    assert "surface (vtkPolyData)" in gtn("info", name + ".gtn")

# Chosen arrays, and a difference that is found.
gtn("pack", "--arrays", "number", "mixed.vtp", "number.gtn")
gtn("verify", "--arrays", "number", "number.gtn", "mixed.vtp", says="identical")
gtn("verify", "number.gtn", "mixed.vtp", code=1, says="differs")
gtn("verify", "number.gtn", "sphere.stl", code=1, says="differs")
write(standard_mesh(2), "mesh.vtu")
gtn("pack", "mesh.vtu", "mesh.gtn")
gtn("verify", "mesh.gtn", "mixed.vtp", code=1, says="differs: it is a vtkUnstructuredGrid")
assert info("mesh.gtn")["surface"] is False and "vtkPolyData" not in gtn("info", "mesh.gtn")

# Pieces of a .pvtp are packed one after the other, and joined.
gtn("pack", "--pieces", 3, "sphere.pvtp", "pieces.gtn")
assert info("pieces.gtn")["cells"] == TRIANGLES and info("pieces.gtn")["chunks"] == 3
assert info("pieces.gtn")["points"] < info("sphere.pvtp.gtn")["points"]

# Steps.
for step in range(3):
    moved = vtkPolyData()
    moved.ShallowCopy(mixed)
    values = numpy_to_vtk(np.arange(mixed.GetNumberOfPoints(), dtype=np.float32) + step, deep=True)
    values.SetName("rising")
    moved.GetPointData().AddArray(values)
    save(vtkXMLPolyDataWriter(), moved, f"step{step}.vtp")
files = [f"step{step}.vtp" for step in range(3)]
gtn("pack", *files, "steps.gtn", says="3 time steps")
gtn("verify", "steps.gtn", *files, says="identical")
gtn("unpack", "--step", 2, "steps.gtn", "last.vtp")
rising = vtk_to_numpy(read_surface("last.vtp").GetPointData().GetArray("rising"))
assert np.array_equal(np.sort(rising), np.arange(mixed.GetNumberOfPoints()) + 2)
for files in (("step0.vtp", "mesh.vtu"), ("mesh.vtu", "step0.vtp")):
    gtn("pack", *files, "both.gtn", code=1, says="gtn: step0.vtp: is a surface")
assert not os.path.exists("both.gtn")

# Unpacked to every format, with what it cannot hold told.
for name, lost in (("vtp", None), ("vtk", None), ("stl", "1 lines, 2 arrays"),
                   ("ply", "1 lines, 2 arrays"), ("obj", "1 lines, 2 arrays")):
    out = gtn("unpack", "mixed.vtp.gtn", "out." + name, says=lost)
    if lost is None:
        gtn("verify", "mixed.vtp.gtn", "out." + name, says="identical")
    else:
        assert lost not in gtn("unpack", "-q", "-f", "mixed.vtp.gtn", "out." + name)
assert read_surface("out.stl").GetNumberOfPolys() == TRIANGLES + 2 * 81
for name in ("ply", "obj"):
    assert read_surface("out." + name).GetNumberOfPolys() == TRIANGLES + 81, name
# A polygon with more points than a byte counts.
t = 2 * np.pi * np.arange(300) / 300
with open("large.obj", "w", encoding="ascii") as file:
    file.writelines(f"v {np.cos(x)} {np.sin(x)} 0\n" for x in t)
    file.write("f " + " ".join(map(str, range(1, 301))) + "\n")
gtn("pack", "large.obj", "large.gtn", says="1 vtkPolygon")
gtn("unpack", "large.gtn", "large.ply")
with open("large.ply", "rb") as file:  # which VTK does not read
    head, faces = file.read().split(b"end_header\n")
assert b"property list uint int vertex_indices" in head
faces = np.frombuffer(faces[-4 * 301:], "<i4")
assert faces[0] == 300 and sorted(faces[1:]) == list(range(300))
gtn("unpack", "large.gtn", "large.stl")
assert read_surface("large.stl").GetNumberOfPolys() == 298
gtn("unpack", "mixed.vtp.gtn", "out.vtu", code=1, says="mixed.vtp.gtn: is a surface")
gtn("unpack", "mesh.gtn", "out.off", code=2, says="the name must end in")
gtn("unpack", "-f", "mesh.gtn", "out.vtp", code=1, says="mesh.gtn: is no surface")

# Rounded coordinates.
places = vtk_to_numpy(whole_sphere.GetPoints().GetData())


def packed_places(*options):
    told = gtn("pack", "-f", "--keep-order", "all", *options, "sphere.ply", "rounded.gtn")
    reader = vtkGatunSurfaceReader()
    reader.SetFileName("rounded.gtn")
    reader.Update()
    return told, vtk_to_numpy(reader.GetOutput().GetPoints().GetData())


longest = np.ptp(places, 0).max().astype(float)
for option, most in (
        ("abs:1e-3", 1e-3), ("rel:1e-3", 1e-3 * longest), ("bits:10", 0.5 / 1023 * 1.0001)):
    told, rounded = packed_places("--point-tolerance", option)
    error = np.abs(rounded.astype(float) - places).max()
    assert 0.3 * most < error <= most and f"coordinates differ by at most {error:.6g}" in told, told
told, exact = packed_places()
assert np.array_equal(exact, places) and "differ" not in told
for wrong in ("abs:0", "abs:-1", "abs:nan", "abs:inf", "abs:", "abs", "bits:0", "bits:32", "bits:x",
              "rel:0", "rel:1", "rel:x", "pw:0.1", "abs:1e-3,zeros", "1e-3", ""):
    gtn("pack", "--point-tolerance", wrong, "sphere.ply", "new.gtn", code=2)
gtn("pack", "--pieces", 3, "--point-tolerance", "bits:9", "sphere.pvtp", "new.gtn", code=1,
    says="needs the bounds of the whole mesh")

# A scene of glTF: a mesh of two triangles that is moved by its node.
corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
sides = np.array([0, 1, 2, 0, 2, 3], np.uint16)
binary = corners.tobytes() + sides.tobytes()
scene = json.dumps({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [10, 0, 0]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "buffers": [{"byteLength": len(binary)}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": corners.nbytes},
                    {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": sides.nbytes}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
         "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]}).encode()
scene += b" " * (-len(scene) % 4)
with open("scene.glb", "wb") as file:
    file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(scene) + len(binary)))
    file.write(struct.pack("<I4s", len(scene), b"JSON") + scene)
    file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
gtn("pack", "scene.glb", "scene.gtn")
gtn("verify", "scene.gtn", "scene.glb", says="identical")
assert info("scene.gtn")["cells"] == 2
assert np.allclose(info("scene.gtn")["bounds"], [[10, 11], [0, 1], [0, 0]])
with open("bad.glb", "wb") as file:
    file.write(b"glTF" + bytes(30))
gtn("pack", "bad.glb", "bad.gtn", code=1)

# Isosurfaces.
gtn("contour", "--array", "pressure", "--value", 2.4, "mesh.gtn", "contour.vtp")
gtn("contour", "--array", "pressure", "--value", 2.4, "mesh.gtn", "contour.gtn", says="triangles")
gtn("verify", "contour.gtn", "contour.vtp", says="identical")
gtn("contour", "--array", "pressure", "--value", 2.4, "--strips", "mesh.vtu", "strips.gtn")
assert info("strips.gtn")["surface"] is True

# What needs 3D cells.
for surface in ("mixed.vtp", "mixed.vtp.gtn"):
    gtn("contour", "--value", 1, surface, "new.vtp", code=1,
        says=surface + ": is a surface (vtkPolyData), without 3D cells")
    gtn("pack", "--split-cells", surface, "new.gtn", code=1, says=surface + ": is a surface")
    for option in ("--hierarchy", "--levels=2"):
        gtn("pack", option, surface, "new.gtn", code=1, says="gtn pack --triangles")

# Hierarchies: of triangles, which pack can make.
gtn("pack", "-q", "--triangles", "--hierarchy", "mixed.vtp", "triangles.gtn")
gtn("verify", "--triangles", "triangles.gtn", "mixed.vtp", says="identical")
gtn("pack", "--triangles", "mesh.vtu", "new.gtn", code=1, says="mesh.vtu: is no surface")
gtn("pack", "-q", "--hierarchy", "--keep-order", "all", "sphere.ply", "tree.gtn")
told = json.loads(gtn("info", "--json", "tree.gtn"))
assert told["hasHierarchy"] and told["surface"] and told["merges"] > 0
for target in (("--ratio", 0.8), ("--points", 40), ("--rms-error", 0.01)):
    gtn("simplify", "-f", *target, "sphere.ply", "memory.vtp")
    gtn("simplify", "-f", *target, "tree.gtn", "file.vtp", says="triangles")
    gtn("pack", "-qf", "memory.vtp", "memory.gtn")
    gtn("verify", "memory.gtn", "file.vtp", says="identical")
gtn("simplify", "-f", "--feature-angle", 5, "--weight", "none", "tree.gtn", "new.vtp", code=1,
    says="there is no point array 'none'")
gtn("simplify", "-f", "tree.gtn", "new.vtu", code=1, says="is a surface")
plane.SetResolution(120, 100)
plane.Update()
save(vtkXMLPolyDataWriter(), plane.GetOutput(), "plane.vtp")
told = gtn("pack", "--triangles", "--levels", 4, "plane.vtp", "plane.gtn")
assert "hierarchy" in told and "base meshes" in told, told
told = json.loads(gtn("info", "--json", "plane.gtn"))
(coarse,) = told["baseMeshes"]
assert 5500 < coarse["points"] <= 6111, coarse
assert 10000 < told["baseMeshes"][0]["cells"] < 13000, told["baseMeshes"]
assert "\nbase meshes\n" in gtn("info", "plane.gtn")
gtn("verify", "--triangles", "plane.gtn", "plane.vtp", says="identical")

# Damaged files.
with open("sphere.stl", "rb") as file:
    start = file.read(300)
with open("cut.stl", "wb") as file:
    file.write(start)
gtn("pack", "cut.stl", "new.gtn", code=1, says="cut.stl: ")
with open("wrong.obj", "w", encoding="ascii") as file:
    file.write("v 0 0 0\nf 1 1 9\n")
gtn("pack", "wrong.obj", "new.gtn", code=1, says="wrong.obj: line 2: a face names point 9 of 1")
for name in ("missing.vtp", "missing.stl", "missing.obj", "missing.pvtp"):
    gtn("pack", name, "new.gtn", code=1, says=name + ": no such file")
with open("mixed.vtp.gtn", "rb") as file:
    whole = bytearray(file.read())
whole[len(whole) // 2] ^= 1
with open("damaged.gtn", "wb") as file:
    file.write(whole)
gtn("verify", "damaged.gtn", code=1, says="damaged.gtn: ")
gtn("unpack", "damaged.gtn", "new.vtp", code=1, says="damaged.gtn: ")
assert not os.path.exists("new.gtn") and not os.path.exists("new.vtp")
