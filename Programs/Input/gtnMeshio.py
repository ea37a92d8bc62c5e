# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes what meshio reads as a .vtu file; gtn has this text in it and runs it.

Arguments: the file, and the number of an open file. Sets are as gatun.from_meshio makes them: arrays that are
1 in the set and 0 elsewhere, whose names the field arrays PointSets and CellSets list.
"""

import sys

sys.path = [path for path in sys.path if path]  # not what lies in the current folder
try:
    import meshio
    import numpy as np
    from meshio._vtk_common import meshio_to_vtk_type as kinds
except ImportError:
    sys.exit(3)

def fail(text):
    print("error: " + text)
    sys.exit(1)

try:
    mesh = meshio.read(sys.argv[1])
except SystemExit:
    fail("meshio cannot read it")
except BaseException as error:
    fail("meshio: " + (str(error) or type(error).__name__).replace("\n", " "))

def plain(values):
    values = np.asarray(values)
    if values.dtype == bool:
        values = values.astype(np.uint8)
    if values.dtype == np.float16:
        values = values.astype(np.float32)
    if values.dtype.kind not in "iuf" or values.dtype.itemsize > 8:
        return None
    values = values.astype(values.dtype.newbyteorder("<"))
    return np.ascontiguousarray(values.reshape(len(values), -1) if values.ndim > 2 else values)

def put(arrays, name, values, what):
    values = plain(values)
    if values is None:
        print("warning: the %s '%s' is left out: its values are no numbers" % (what, name))
        return
    while name in arrays:
        name += " (2)"
    arrays[name] = values

points = plain(mesh.points)
if len(points) == 0 or not any(len(block.data) for block in mesh.cells):
    fail("meshio finds no %s in it; it may be a file of another kind" % ("cells" if len(points) else "points"))
if points.shape[1] < 3:
    points = np.hstack([points, np.zeros((len(points), 3 - points.shape[1]), points.dtype)])
if points.dtype.kind != "f":
    points = points.astype(np.float64)
sizes, types, ids, faces, places, count = [], [], [], [], [], 0
for block in mesh.cells:
    kind, data = block.type, block.data
    if kind.startswith("polyhedron"):
        for cell in data:
            corners = np.unique(np.concatenate([np.asarray(face) for face in cell]))
            ids.append(corners)
            sizes.append([len(corners)])
            stream = [len(cell)]
            for face in cell:
                stream += [len(face), *map(int, face)]
            faces.append(stream)
            count += len(stream)
            places.append([count])
        types.append(np.full(len(data), 42))
        continue
    number = 7 if kind.startswith("polygon") else kinds.get(kind)
    if number is None:
        fail("has cells of the type %s of meshio, which VTK does not have" % kind)
    data = np.asarray(data).reshape(len(data), -1)
    if number == 13:  # meshio's and VTK's triangles have opposite directions
        data = data[:, [0, 2, 1, 3, 5, 4]]
    ids.append(data.ravel())
    sizes.append(np.full(len(data), data.shape[1]))
    types.append(np.full(len(data), number))
    places.append(np.full(len(data), -1))

def join(parts, kind):
    return np.concatenate([np.asarray(p) for p in parts]).astype(kind) if parts else np.zeros(0, kind)

lengths = [len(block.data) for block in mesh.cells]
cells = sum(lengths)
point_data, cell_data, field_data = {}, {}, {}
for name, values in mesh.point_data.items():
    put(point_data, name, values, "point array")
for name, blocks in mesh.cell_data.items():
    put(cell_data, name, np.concatenate([np.asarray(b) for b in blocks]), "cell array")
for name, values in mesh.field_data.items():
    values = np.atleast_1d(np.asarray(values)).reshape(1, -1)
    if values.size:
        put(field_data, name, values, "field array")
for tags in (getattr(mesh, "point_tags", {}), getattr(mesh, "cell_tags", {})):  # of MED
    for number, names in tags.items():
        for name in names:
            put(field_data, name, np.array([[number]]), "name of a group")

def marks(length, members):
    members = np.asarray([] if members is None else members)
    if members.dtype == bool:
        return members.astype(np.uint8)
    found = np.zeros(length, np.uint8)
    found[members.astype(np.int64)] = 1
    return found

def put_set(sets, arrays, name, values, what):
    """Adds a set under its name, or another one if an array has that."""
    own = name
    while own in arrays:
        own += " (set)"
    if own != name:
        print("warning: the %s '%s' is called '%s': its name is that of an array" % (what, name, own))
    arrays[own] = values
    sets.append(own)

point_sets, cell_sets = [], []
for name, members in mesh.point_sets.items():
    put_set(point_sets, point_data, name, marks(len(points), members), "point set")
for name, blocks in mesh.cell_sets.items():
    if name.startswith("gmsh:bounding_entities"):
        print("warning: the sets of bounding entities of Gmsh are left out")
        continue
    values = np.concatenate([marks(n, b) for n, b in zip(lengths, blocks)])
    put_set(cell_sets, cell_data, name, values, "cell set")

from xml.sax.saxutils import quoteattr
head, raw, offset = [], [], 0

def array(name, values, more=""):
    global offset
    names = {"i": "Int", "u": "UInt", "f": "Float"}
    kind = names[values.dtype.kind] + str(8 * values.dtype.itemsize)
    width = values.shape[1] if values.ndim > 1 else 1
    head.append('<DataArray type="%s" Name=%s NumberOfComponents="%d" format="appended" offset="%d"%s/>'
                % (kind, quoteattr(name), width, offset, more))
    values = np.ascontiguousarray(values)
    raw.append(values)
    offset += 8 + values.nbytes

head.append('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt64"><UnstructuredGrid><FieldData>')
for name, values in field_data.items():
    array(name, values, ' NumberOfTuples="1"')
for name, names in (("PointSets", point_sets), ("CellSets", cell_sets)):
    if names:
        text = np.frombuffer("".join(set_name + "\0" for set_name in names).encode("utf-8"), np.uint8)
        head.append('<Array type="String" Name="%s" NumberOfTuples="%d" format="appended" offset="%d"/>'
                    % (name, len(names), offset))
        raw.append(text)
        offset += 8 + text.nbytes
head.append('</FieldData><Piece NumberOfPoints="%d" NumberOfCells="%d"><PointData>' % (len(points), cells))
for name, values in point_data.items():
    array(name, values)
head.append("</PointData><CellData>")
for name, values in cell_data.items():
    array(name, values)
head.append("</CellData><Points>")
array("Points", points)
head.append("</Points><Cells>")
array("connectivity", join(ids, "<i8"))
array("offsets", np.cumsum(join(sizes, "<i8")))
array("types", join(types, np.uint8))
if faces:
    array("faces", join(faces, "<i8"))
    array("faceoffsets", join(places, "<i8"))
head.append('</Cells></Piece></UnstructuredGrid><AppendedData encoding="raw">_')
with open(int(sys.argv[2]), "wb") as out:
    out.write("".join(head).encode("utf-8"))
    for values in raw:
        out.write(np.array([values.nbytes], "<u8").tobytes())
        out.write(values.data if values.size else b"")
    out.write(b"</AppendedData></VTKFile>")
