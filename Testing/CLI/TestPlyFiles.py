# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of the format PLY: text and binary, every kind of cells and properties exactly, what is left out named,
and damaged ones refused with the cause. Surfaces with polygons and strips of less than 3 corners."""

import os
import struct

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter

from gatunCli import enter_folder, gtn
from gatunSurfaces import read_surface

enter_folder("ply-files")
POINTS = [(0.1, 0, 0), (1, 0, 1e-9), (1, 1, 0), (0, 1, 0.3)]
CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
         "double": "d", "int8": "b", "uint16": "H", "float64": "d"}


def make(name, elements, kind="ascii", comment="comment of nobody"):
    """elements: the name, the properties (type, name), and the rows, whose lists are lists."""
    order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[kind]
    head, body = ["ply", f"format {kind} 1.0", comment], b""
    for element, properties, rows in elements:
        head.append(f"element {element} {len(rows)}")
        head += [f"property {kinds} {what}" for kinds, what in properties]
        for row in rows:
            words = []
            for (kinds, _), value in zip(properties, row, strict=True):
                if kinds.startswith("list"):
                    words += [(kinds.split()[1], len(value))] + [(kinds.split()[2], v) for v in value]
                else:
                    words.append((kinds, value))
            body += b"".join(struct.pack(order + CODES[k], v) for k, v in words) if order else \
                (" ".join(repr(v) for _, v in words) + "\n").encode()
    with open(name, "wb") as file:
        file.write(("\n".join(head) + "\nend_header\n").encode() + body)
    return name


def packed(name, **keywords):
    """Packs a file, and returns the surface as VTK reads it, and what was said."""
    said = gtn("pack", "-f", "--keep-order", "all", name, "out.gtn", **keywords)
    gtn("verify", "out.gtn", name, says="identical")
    gtn("unpack", "-q", "-f", "out.gtn", "out.vtp")
    return read_surface("out.vtp"), said


def places(kind="double"):
    return [(kind, axis) for axis in "xyz"]


def cells_of(cells):
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    return [list(part) for part in np.split(ids, vtk_to_numpy(cells.GetOffsetsArray())[1:-1])]


FACES = ("face", [("list uchar int", "vertex_indices"), ("float", "heat")], [([0, 1, 2], 0.5), ([0, 1, 2, 3], 7)])

# All that is read, in all three forms.
for form in ("ascii", "binary_little_endian", "binary_big_endian"):
    vertices = [(*p, 10.5 * i, i, 100 + i, 255 - i, i, 0, 0, 1, 3e9 + i) for i, p in enumerate(POINTS)]
    vertices = [(*v[:4], *map(int, v[4:8]), *v[8:11], int(v[11])) for v in vertices]
    make("all.ply", [
        ("vertex", [*places(), ("float", "quality"), ("uchar", "red"), ("uchar", "green"), ("uchar", "blue"),
                    ("short", "flags"), ("float", "nx"), ("float", "ny"), ("float", "nz"), ("uint", "number")],
         vertices),
        FACES], form)
    surface, _ = packed("all.ply")
    assert (vtk_to_numpy(surface.GetPoints().GetData()) == np.array(POINTS)).all(), form
    data = {surface.GetPointData().GetArrayName(i): vtk_to_numpy(surface.GetPointData().GetArray(i))
            for i in range(surface.GetPointData().GetNumberOfArrays())}
    assert sorted(data) == ["Normals", "RGB", "flags", "number", "quality"], data
    assert data["RGB"].dtype == np.uint8 and data["RGB"].tolist() == [[i, 100 + i, 255 - i] for i in range(4)]
    assert data["flags"].dtype == np.int16 and data["quality"].dtype == np.float32
    assert data["number"].dtype == np.uint32 and data["number"].tolist() == [3 * 10**9 + i for i in range(4)]
    assert surface.GetPointData().GetNormals().GetName() == "Normals"
    assert cells_of(surface.GetPolys()) == [[0, 1, 2], [0, 1, 2, 3]]
    assert vtk_to_numpy(surface.GetCellData().GetArray("heat")).tolist() == [0.5, 7]
    make("strips.ply", [("vertex", places(), POINTS), FACES, ("tristrips", [("list int int", "vertex_indices")],
                                                              [([0, 1, 2, 3, -1, 3, 2, 1, -1],)])], form)
    surface, _ = packed("strips.ply", says="properties of faces, because there are strips, too")
    assert cells_of(surface.GetPolys()) == [[0, 1, 2], [0, 1, 2, 3]]
    assert cells_of(surface.GetStrips()) == [[0, 1, 2, 3], [3, 2, 1]]

# Floats stay floats, ends of lines of any system, and a cloud of points.
text = ["ply", "format ascii 1.0", "element vertex 2", *(f"property float {a}" for a in "xyz"), "end_header",
        "0.1 +2 nan", "1e-3 0.3 -inf", ""]
for end in ("\n", "\r\n", "\r"):
    with open("cloud.ply", "w", newline="") as file:
        file.write(end.join(text))
    surface, _ = packed("cloud.ply", says="out.gtn: no cells, 2 points")
    have = vtk_to_numpy(surface.GetPoints().GetData())
    assert have.dtype == np.float32 and np.array_equal(
        have, np.array([[0.1, 2, np.nan], [1e-3, 0.3, -np.inf]], np.float32), equal_nan=True), have

# What is left out is named.
make("more.ply", [
    ("camera", [("float", "view_px")], [(1,)]),
    ("vertex", [*places("float"), ("list uchar int", "neighbors")], [(*p, [1, 2]) for p in POINTS]),
    ("face", [("list uchar uint", "vertex_index"), ("list uchar float", "texcoord")], [([0, 1, 2], [0.5] * 6)]),
    ("edge", [("int", "vertex1"), ("int", "vertex2")], [(0, 3)])])
surface, _ = packed("more.ply", says="what is not read of the file: the element 'camera', the element 'edge', the list "
                    "'neighbors' of the element 'vertex', the list 'texcoord' of the element 'face'")
assert cells_of(surface.GetPolys()) == [[0, 1, 2]]

# Damaged files.
good = ["ply", "format ascii 1.0", "element vertex 3", *(f"property float {a}" for a in "xyz"), "element face 1",
        "property list uchar int vertex_indices", "end_header", "0 0 0", "1 0 0", "0 1 0", "3 0 1 2"]


def damage(says, *changes, drop=0, add=()):
    lines = "\n".join(good[: len(good) - drop] + list(add))
    for old, new in changes:
        assert old in lines
        lines = lines.replace(old, new)
    with open("damaged.ply", "w") as file:
        file.write(lines + "\n")
    gtn("pack", "damaged.ply", "new.gtn", code=1, says="gtn: damaged.ply: " + says)
    assert not os.path.exists("new.gtn")


damage("is not a .ply file", ("ply\n", "plain\n"))
damage("its header tells no format", ("ascii", "words"))
damage("its header has no end", drop=5)
damage("its header has the unknown line '0 0 0'", ("end_header", "comment"))
damage("its header has the unknown type 'real'", ("property float x", "property real x"))
damage("its header has no number in 'element face one'", ("face 1", "face one"))
damage("has vertices without the properties x, y and z", ("float z", "float w"))
damage("has the element 'face' without the list 'vertex_indices'", ("vertex_indices", "corners"))
damage("is truncated: it has no room for the 2000000000 of 'vertex'", ("vertex 3", "vertex 2000000000"))
damage("is truncated: it has no room for the 18446744073709551615 of 'face'",
       ("face 1", "face 18446744073709551615"))
damage("is truncated", ("face 1", "face 2"))
damage("is truncated", drop=1)
damage("is truncated", ("3 0 1 2", "200 0 1 2"))
damage("has more values than its header declares", add=["3 0 1 2"])
damage("'ten' is not a number", ("1 0 0", "ten 0 0"))
damage("300 is not a value of the type", ("3 0 1 2", "300 0 1 2"))
for ids in ("3 0 1 7", "3 0 1 -1", "3 0 1 3"):
    damage("", ("3 0 1 2", ids))
damage("its header has the element 'vertex' twice", ("element face", "element vertex"))
damage("has no points", ("vertex 3", "point 3"))
damage("its header has a property before all elements", ("element vertex 3\n", ""))
make("whole.ply", [("vertex", places(), POINTS), FACES], "binary_little_endian")
with open("whole.ply", "rb") as file:
    whole = file.read()
for size in range(0, len(whole), 7):
    with open("cut.ply", "wb") as file:
        file.write(whole[:size])
    gtn("pack", "cut.ply", "new.gtn", code=1, says="gtn: cut.ply: is" if size > whole.index(b"end_header\n") + 11
        or size == 0 else "gtn: cut.ply: ")

# Polygons and strips of less than 3 corners: written where the format has them, named where not.
points = vtkPoints()
for point in POINTS:
    points.InsertNextPoint(point)
for lists in (("polys",), ("strips",), ("polys", "strips")):
    surface = vtkPolyData()
    surface.SetPoints(points)
    cells = vtkCellArray()
    for ids in ([0, 1, 2], [2, 3], [1]):
        cells.InsertNextCell(len(ids))
        for i in ids:
            cells.InsertCellPoint(i)
    if "polys" in lists:
        surface.SetPolys(cells)
    if "strips" in lists:
        surface.SetStrips(cells)
    writer = vtkPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName("two.vtk")
    assert writer.Write()
    gtn("pack", "-f", "--keep-order", "all", "two.vtk", "two.gtn")
    gtn("verify", "two.gtn", "two.vtk", says="identical")
    gtn("pack", "-f", "--triangles", "two.vtk", "new.gtn",
        says=f"{2 * len(lists)} polygons and strips of less than 3 corners are left out")
    os.remove("new.gtn")
    for name, lost in (("two.vtp", 0), ("again.vtk", 0), ("two.ply", 2 * len(lists) if "strips" in lists else 0),
                       ("two.obj", 2 * len(lists)), ("two.stl", 2 * len(lists))):
        if name == "two.ply" and lists == ("polys", "strips"):
            lost = 2
        gtn("unpack", "-f", "two.gtn", name,
            says=f"{lost} polygons and strips of less than 3 corners" if lost else "cells")
        if name.endswith(("vtp", "vtk")):
            gtn("verify", "two.gtn", name, says="identical")
    if lists == ("polys",):
        gtn("pack", "-f", "--keep-order", "all", "two.ply", "back.gtn")
        gtn("unpack", "-f", "back.gtn", "back.vtk")
        reader = vtkPolyDataReader()
        reader.SetFileName("back.vtk")
        reader.Update()
        assert cells_of(reader.GetOutput().GetPolys()) == [[0, 1, 2], [2, 3], [1]]
    gtn("simplify", "-f", "--ratio", 0.1, "two.gtn", "simple.vtp")
