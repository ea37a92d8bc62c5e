# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""mesh reads every .obj file that means a closed surface, and says what is wrong with surfaces that
name what does not exist: in which line, where the format has lines."""

import json

from gatunCli import enter_folder, gtn

enter_folder("mesh-hostile")
POINTS = ["v %g %g %g" % ((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5) for i in range(8)]
QUADS = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]


def save(name, content):
    with open(name, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def faces(corner="{0}"):
    return ["f " + " ".join(corner.format(int(c), int(c) - 9) for c in q.split()) for q in QUADS]


def accept(name, lines, end="\n", says="tetrahedra"):
    save(name + ".obj", end.join(lines) + end)
    gtn("mesh", "-f", name + ".obj", name + ".gtn", says=says)
    info = json.loads(gtn("info", "--json", name + ".gtn"))
    assert info["bounds"] == [[-0.5, 0.5]] * 3 and info["tets"] >= 5


accept("plain", POINTS + faces())
accept("windows", POINTS + faces(), "\r\n")
accept("textures-missing", POINTS + faces("{0}/{0}"))
accept("normals-missing", POINTS + faces("{0}//{0}"))
accept("negative", POINTS + faces("{1}/-1/-1"))
accept("points-last", faces() + POINTS)
accept("odd", ["# cube", "", "mtllib x.mtl", "o cube", "g", "s 1", "usemtl none", "vt 0 0", "vn 0 0 1"]
       + [line.replace(" ", "\t ") + " 1.0 # red" for line in POINTS]
       + [line.replace(" 4", " \\\n4", 1) for line in faces("{0}/1/1")] + ["l 1 2", "p 1"],
       says="not read of the file: groups, lines, materials, normals, points without faces, texture coordinates")
accept("colors", [line + " 1 0 0" for line in POINTS] + faces(), says="not read of the file: colors")
# A seam of the texture: the same point with two texture coordinates is one point.
accept("seam", POINTS + ["vt 0 0", "vt 1 1"] + faces("{0}/1")[:3] + faces("{0}/2")[3:])


def refuse(name, content, says):
    save(name, content)
    gtn("mesh", name, "new.gtn", code=1, says=f"gtn: {name}: {says}")


def refuse_obj(face, says):
    refuse("bad.obj", "\n".join(POINTS + faces()[:-1] + [face]), says)


refuse_obj("f 2 4 8 9", "line 14: a face names point 9 of 8")
refuse_obj("f 2 4 8 999999999", "line 14: a face names point 999999999 of 8")
refuse_obj("f 2/9/9 4/9/9 8/9/9 9/9/9", "line 14: a face names point 9 of 8")
refuse_obj("f 0 4 8 6", "line 14: a face names point 0 of 8")
refuse_obj("f -9 4 8 6", "line 14: a face names point -9 of 8")
refuse_obj("f 2 4 8 99999999999999999999", "line 14: '99999999999999999999' is not a corner")
refuse_obj("f 2 4 8 -9223372036854775808", "line 14: a face names point -9223372036854775808 of 8")
refuse_obj("f 2 4", "line 14: a face has less than 3 corners")
refuse_obj("f", "line 14: a face has less than 3 corners")
refuse_obj("f a b c", "line 14: 'a' is not a corner of a face")
refuse_obj("f 2. 4. 8.", "line 14: '2.' is not a corner of a face")
refuse_obj("f /1 /2 /3", "line 14: '/1' is not a corner of a face")
refuse("bad.obj", "v 0 0\n", "line 1: a point has less than 3 coordinates")
refuse("bad.obj", "v 0 0 zero\n", "line 1: 'zero' is not a coordinate")
refuse("bad.obj", "v 0 0 1e999\n", "line 1: '1e999' is not a coordinate")
refuse("bad.obj", "v nan 0 0\nf 1 1 1\n", "the surface has a coordinate that is not finite")
refuse("bad.obj", bytes(range(256)) * 40, "has no points")
refuse("bad.obj", b"v 0 0 0\nf 1 1 1\0\n", "line 2: ")

PLY = "ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(
    f"property float {axis}\n" for axis in "xyz") + (
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n")
refuse("bad.ply", PLY + "3 0 1 7\n", "a cell names point 7 of 3")
refuse("bad.ply", PLY + "3 0 1 -1\n", "a cell names point -1 of 3")
LEGACY = "# vtk DataFile Version {}\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
refuse("bad.vtk", LEGACY.format("4.2") + "POLYGONS 1 4\n3 0 1 70000000\n",
       "a cell names point 70000000 of 3")
offsets = "POLYGONS 2 3\nOFFSETS vtktypeint64\n{}\nCONNECTIVITY vtktypeint64\n0 1 2\n"
for wrong in ("0 900000", "0 -3", "1 3"):
    refuse("bad.vtk", LEGACY.format("5.1") + offsets.format(wrong), "the offsets of the cells")
