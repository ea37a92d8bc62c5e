# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A .vtu file that is read by ranges and divided into pieces becomes the file of the whole mesh, in
bounded memory, or nothing is left behind."""

import json
import os
import re
import signal
import struct
import subprocess
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_LINE, VTK_POLYHEDRON, VTK_TETRA,
                                           VTK_TRIANGLE, VTK_VERTEX, vtkUnstructuredGrid)
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from gatun.vtk import vtkGatunReader
from gatunCli import (PROGRAM, add_text, corners_of, enter_folder, gtn, lattice, make_grid, permute,
                      waves, write)

enter_folder("ranges")


def scattered(n, seed):
    """A mesh whose points and cells are in any order, with arrays."""
    points, tets, _, _ = permute(*lattice(n), seed)
    cell_data = {"material": np.arange(len(tets), dtype=np.int32), "flow": np.sin(points[tets[:, 0]])}
    grid = make_grid(points, tets, waves(points), cell_data)
    grid.GetPointData().SetActiveScalars("pressure")
    grid.GetPointData().GetArray("velocity").SetComponentName(1, "north")
    add_text(grid, "remarks", ["in pieces", ""])
    return grid


def write_as(grid, name, compressor="None", encoded=False, swapped=False, header=64):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    writer.SetDataModeToAppended()
    getattr(writer, "SetCompressorTypeTo" + compressor)()
    writer.SetBlockSize(4096)
    writer.SetEncodeAppendedData(encoded)
    writer.SetByteOrder(int(not swapped))
    writer.SetHeaderType(header)
    assert writer.Write()


def packed(name, *arguments, pieces=5):
    """Packs a file in pieces, and expects what it has; returns what gtn info says."""
    gtn("pack", "-q", "-f", "--pieces", pieces, *arguments, name, "pieces.gtn")
    return json.loads(gtn("info", "--json", "pieces.gtn"))


def sorted_cells(grid):
    """The coordinates and values of all cells, in an order that depends on them only."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    corners = np.sort(corners_of(grid), axis=1)
    columns = [vtk_to_numpy(grid.GetCellData().GetArray(name)).reshape(len(corners), -1)
               for name in ("material", "flow")]
    pressure = vtk_to_numpy(grid.GetPointData().GetArray("pressure"))[corners]
    place = points[corners].astype(np.float64)
    columns += [np.sort(pressure, axis=1), place.sum(axis=1), place.min(axis=1), place.max(axis=1)]
    rows = np.concatenate([np.round(column.astype(np.float64), 4) for column in columns], axis=1)
    return rows[np.argsort(vtk_to_numpy(grid.GetCellData().GetArray("material")))]


# Whatever the encoding, the file is that of the whole mesh; compared by gtn, and without it.
mesh = scattered(9, 1)
write_as(mesh, "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "whole.gtn")
whole = json.loads(gtn("info", "--json", "whole.gtn"))
for case, (compressor, encoded, swapped, header) in enumerate((
        ("None", False, False, 64), ("None", False, True, 32), ("None", True, False, 32),
        ("ZLib", False, False, 32), ("ZLib", True, True, 64), ("LZ4", False, True, 64),
        ("LZMA", True, False, 64))):
    write_as(mesh, "case.vtu", compressor, encoded, swapped, header)
    info = packed("case.vtu")
    gtn("verify", "pieces.gtn", "mesh.vtu", says="identical")
    assert info["points"] == whole["points"] and info["chunks"] == 5, info
    if case == 0:
        reader = vtkGatunReader()
        reader.SetFileName("pieces.gtn")
        reader.Update()
        back = reader.GetOutput()
        assert back.GetPointData().GetScalars().GetName() == "pressure"
        assert back.GetPointData().GetArray("velocity").GetComponentName(1) == "north"
        assert np.array_equal(sorted_cells(back), sorted_cells(mesh))
        bounds = {name: array for name, array in whole.items() if name in ("bounds", "arrays")}
        assert set(info) == set(whole) and info["bounds"] == bounds["bounds"]

# Only some arrays; tetrahedra of other cells.
packed("mesh.vtu", "--arrays", "pressure")
gtn("verify", "--arrays", "pressure", "pieces.gtn", "mesh.vtu", says="identical")
gtn("pack", "--pieces", 3, "--arrays", "nothing", "mesh.vtu", "never.gtn", code=1,
    says="has no array 'nothing'")


def make_mixed(n):
    """Hexahedra, polyhedra and tetrahedra beside each other; triangles within them, lines, vertices,
    and points that no cell uses, in no order."""
    axis = np.arange(n + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    places = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(np.float64)
    ids = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    cells = []
    for k, j, i in np.ndindex(n, n, n):
        c = [ids[k + a[2], j + a[1], i + a[0]] for a in
             ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        kind = (i + j + k) % 3
        if kind == 0:
            cells.append((VTK_HEXAHEDRON, c))
        elif kind == 1:
            faces = [[c[f] for f in face] for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4),
                                                       (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))]
            cells.append((VTK_POLYHEDRON, [6] + [v for f in faces for v in [len(f), *f]]))
        else:
            for tet in ((0, 1, 3, 4), (1, 2, 3, 6), (1, 3, 4, 6), (4, 5, 6, 1), (4, 6, 7, 3)):
                cells.append((VTK_TETRA, [c[t] for t in tet]))
        cells.append((VTK_TRIANGLE, [c[0], c[2], c[6]]))
        if i == j:
            cells += [(VTK_LINE, [c[0], c[6]]), (VTK_VERTEX, [c[3]])]
    places = np.concatenate([places, places[: 3 * n] + 0.5])
    order = np.random.default_rng(2).permutation(len(places))
    where = np.argsort(order)
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places[order], deep=True))
    grid.SetPoints(points)
    for c in np.random.default_rng(3).permutation(len(cells)):
        kind, values = cells[c]
        if kind == VTK_POLYHEDRON:
            stream, at = [values[0]], 1
            while at < len(values):
                size = values[at]
                stream += [size] + [int(where[v]) for v in values[at + 1 : at + 1 + size]]
                at += 1 + size
            as_list = vtkIdList()
            for value in stream:
                as_list.InsertNextId(value)
            grid.InsertNextCell(kind, as_list)
        else:
            grid.InsertNextCell(kind, len(values), [int(where[v]) for v in values])
    height = numpy_to_vtk(places[order][:, 2].copy(), deep=True)
    height.SetName("height")
    grid.GetPointData().AddArray(height)
    return grid


mixed = make_mixed(6)
for compressor in ("None", "ZLib"):
    write_as(mixed, "mixed.vtu", compressor)
    info = packed("mixed.vtu", pieces=7)
    gtn("verify", "pieces.gtn", "mixed.vtu", says="identical")
    assert info["points"] == mixed.GetNumberOfPoints(), info
gtn("pack", "-q", "-f", "--split-cells", "mixed.vtu", "whole.gtn")
tets = json.loads(gtn("info", "--json", "whole.gtn"))
info = packed("mixed.vtu", "--split-cells", pieces=4)
assert (info["tets"], info["points"]) == (tets["tets"], tets["points"]), (info, tets)


def write_lists(grid, name, change=None, shared=True, appended=True):
    """A file as VTK 9.4 and later write it, whose polyhedra share faces: cells name their faces, the
    last one first. change: of the arrays by name. With appended data, or as text."""
    numbers = {}
    arrays = {name: [] for name in ("connectivity", "offsets", "types", "polyhedron_to_faces",
                                    "polyhedron_offsets", "face_connectivity", "face_offsets")}
    ids, stream = vtkIdList(), vtkIdList()
    faces = []
    for cell in range(grid.GetNumberOfCells()):
        grid.GetCells().GetCellAtId(cell, ids)
        arrays["connectivity"] += [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        arrays["offsets"].append(len(arrays["connectivity"]))
        arrays["types"].append(grid.GetCellType(cell))
        if grid.GetCellType(cell) == VTK_POLYHEDRON:
            grid.GetFaceStream(cell, stream)
            values = [stream.GetId(i) for i in range(1, stream.GetNumberOfIds())]
            while values:
                face = values[1:values[0] + 1]
                key = tuple(sorted(face)) if shared else len(faces)
                if key not in numbers:
                    numbers[key] = len(faces)
                    faces.append(face)
                arrays["polyhedron_to_faces"].append(numbers[key])
                values = values[values[0] + 1:]
        arrays["polyhedron_offsets"].append(len(arrays["polyhedron_to_faces"]))
    # No order can be relied on.
    arrays["polyhedron_to_faces"] = [len(faces) - 1 - f for f in arrays["polyhedron_to_faces"]]
    for face in reversed(faces):
        arrays["face_connectivity"] += face
        arrays["face_offsets"].append(len(arrays["face_connectivity"]))
    if change:
        change(arrays)
    data, elements = b"", {}

    def element(name, values, type_, components=1):
        nonlocal data
        values = np.asarray(values, {"Int64": "<i8", "UInt8": "u1", "Float64": "<f8"}[type_])
        head = '<DataArray type="%s" Name="%s" NumberOfComponents="%d"' % (type_, name, components)
        if not appended:
            text = " ".join(repr(value) for value in values.ravel().tolist())
            return head + ' format="ascii">%s</DataArray>' % text
        head += ' format="appended" offset="%d"/>' % len(data)
        data += struct.pack("<Q", values.nbytes) + values.tobytes()
        return head

    points = element("Points", vtk_to_numpy(grid.GetPoints().GetData()), "Float64", 3)
    height = element("height", vtk_to_numpy(grid.GetPointData().GetArray("height")), "Float64")
    cells = "".join(element(name, values, "UInt8" if name == "types" else "Int64")
                    for name, values in arrays.items())
    text = ('<VTKFile type="UnstructuredGrid" version="2.3" byte_order="LittleEndian" '
            'header_type="UInt64"><UnstructuredGrid><Piece NumberOfPoints="%d" NumberOfCells="%d">'
            '<PointData>%s</PointData><Points>%s</Points><Cells>%s</Cells></Piece></UnstructuredGrid>'
            % (grid.GetNumberOfPoints(), grid.GetNumberOfCells(), height, points, cells)).encode()
    with open(name, "wb") as file:
        file.write(text)
        if appended:
            file.write(b'<AppendedData encoding="raw">_' + data + b"</AppendedData>")
        file.write(b"</VTKFile>")


# Polyhedra as VTK 9.4 and later write them, in ranges and whole, whatever VTK reads them.
write_as(mixed, "mixed.vtu")
for appended in (True, False):
    write_lists(mixed, "lists.vtu", shared=False, appended=appended)
    gtn("pack", "-q", "-f", "--keep-order", "all", "lists.vtu", "whole.gtn")
    gtn("verify", "whole.gtn", "mixed.vtu", says="identical")
write_lists(mixed, "lists.vtu", shared=False)
for pieces in (2, 7):
    packed("lists.vtu", pieces=pieces)
    gtn("verify", "pieces.gtn", "mixed.vtu", says="identical")
write_lists(mixed, "shared.vtu")
packed("shared.vtu", pieces=3)
gtn("verify", "pieces.gtn", "shared.vtu", says="identical")


def set_value(name, place, value):
    return lambda arrays: arrays[name].__setitem__(place, value)


for change in (set_value("polyhedron_to_faces", 5, 1 << 40), set_value("polyhedron_to_faces", 5, -1),
               set_value("face_offsets", 3, 1 << 60), set_value("face_offsets", 0, -4),
               set_value("polyhedron_offsets", -1, 1 << 50), set_value("polyhedron_offsets", 4, -1),
               set_value("face_connectivity", 7, 1 << 33),
               lambda arrays: arrays["polyhedron_offsets"].pop(),
               lambda arrays: arrays.pop("face_offsets")):
    write_lists(mixed, "bad.vtu", change)
    for options, says in ((("--pieces", 3), "bad.vtu"), ((), "gtn: ")):
        gtn("pack", "-q", "-f", *options, "bad.vtu", "never.gtn", code=1, says=says)
        assert not os.path.exists("never.gtn")

# Points that are nowhere, and all at the same place: then the order of the cells decides.
odd = scattered(6, 4)
coordinates = vtk_to_numpy(odd.GetPoints().GetData())
coordinates[::7] = np.nan
coordinates[5] = np.inf
write_as(odd, "odd.vtu")
packed("odd.vtu")
gtn("verify", "pieces.gtn", "odd.vtu", says="identical")
coordinates[:] = 1
odd.GetPoints().GetData().Modified()
write_as(odd, "odd.vtu")
info = packed("odd.vtu")
gtn("verify", "pieces.gtn", "odd.vtu", says="identical")
write_as(make_grid(coordinates, np.zeros((0, 4), np.int64)), "loose.vtu")
packed("loose.vtu")
gtn("verify", "pieces.gtn", "loose.vtu", says="identical")

# Two pieces of a file, with points of their own.
with open("mesh.vtu", "rb") as file:
    text = file.read()
piece = re.search(rb"<Piece .*?</Piece>", text, re.DOTALL).group(0)
with open("twice.vtu", "wb") as file:
    file.write(text.replace(piece, piece + b"\n" + piece, 1))
info = packed("twice.vtu")
assert info["points"] == 2 * whole["points"], info
gtn("verify", "pieces.gtn", "twice.vtu", says="identical")

# Time steps in files: one mesh.
for step in range(3):
    later = scattered(7, 5)
    values = vtk_to_numpy(later.GetPointData().GetArray("pressure"))
    values += step
    write_as(later, f"step{step}.vtu", "ZLib" if step == 1 else "None")
steps = [f"step{step}.vtu" for step in range(3)]
gtn("pack", "-q", "-f", "--pieces", 4, *steps, "pieces.gtn")
gtn("verify", "pieces.gtn", *steps, says="identical")
with open("steps.pvd", "w", encoding="ascii") as file:
    sets = "".join(f'<DataSet timestep="{s / 4}" file="{f}"/>' for s, f in enumerate(steps))
    file.write(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')
gtn("pack", "-q", "-f", "--pieces", 4, "steps.pvd", "pieces.gtn")
gtn("verify", "pieces.gtn", "steps.pvd", says="identical")


# What cannot be done leaves nothing behind.
def refuse(*arguments, says):
    files = sorted(os.listdir("."))
    gtn("pack", "-q", *arguments, "never.gtn", code=1, says=says)
    assert sorted(os.listdir(".")) == files


write_as(scattered(7, 6), "moved.vtu")
refuse("--pieces", 3, "step0.vtu", "moved.vtu", says="the points or the cells change in time step 1")
write_as(scattered(6, 5), "smaller.vtu")
refuse("--pieces", 3, "step0.vtu", "smaller.vtu", says="the points or the cells change in time step 1")
less = scattered(7, 5)
less.GetPointData().RemoveArray("mark")
write_as(less, "less.vtu")
refuse("--pieces", 3, "step0.vtu", "less.vtu", says="the point array 'mark' of the first step is missing")
refuse("--pieces", 3, "--layers", "pressure", "mesh.vtu", says="need the whole mesh")
refuse("--pieces", 3, "--keep-order", "all", "mesh.vtu", says="original order needs the whole mesh")
refuse("--pieces", 3, "--spill", "/proc", "mesh.vtu", says="/proc")
write(mesh, "text.vtu")
ascii_writer = vtkXMLUnstructuredGridWriter()
ascii_writer.SetInputData(mesh)
for mode in ("Ascii", "Binary"):
    ascii_writer.SetFileName("text.vtu")
    getattr(ascii_writer, "SetDataModeTo" + mode)()
    assert ascii_writer.Write()
    refuse("--pieces", 3, "text.vtu", says="has no appended data")

# Damaged files.
DATA = text.index(b"_", text.index(b"<AppendedData")) + 1


def array_at(name, content=text):
    """Where the values of an array begin, and their type."""
    element = re.search(rb"<DataArray[^>]*Name=\"" + name + rb"\"[^>]*>", content).group(0)
    offset = int(re.search(rb'offset="(\d+)"', element).group(1))
    data = content.index(b"_", content.index(b"<AppendedData")) + 1
    return data + offset + 8, re.search(rb'type="(\w+)"', element).group(1)


def damage(name, at, value, says, form="<q"):
    begin, kind = array_at(name)
    assert kind == {"<q": b"Int64", "<B": b"UInt8"}[form], kind
    damaged = bytearray(text)
    struct.pack_into(form, damaged, begin + at * struct.calcsize(form), value)
    with open("damaged.vtu", "wb") as broken:
        broken.write(damaged)
    refuse("--pieces", 3, "damaged.vtu", says=says)


damage(b"connectivity", 10, mesh.GetNumberOfPoints(), "has the point 1000, which does not exist")
damage(b"connectivity", 10, -1, "has the point -1, which does not exist")
damage(b"connectivity", 10, 1 << 62, "which does not exist")
damage(b"offsets", 7, 0, "the offsets of cell 7 are wrong")
damage(b"offsets", 7, 1 << 62, "the offsets of cell 7 are wrong")
damage(b"offsets", 7, -5, "the offsets of cell 7 are wrong")
damage(b"connectivity", -1, 8, "the offsets of cell 0 are wrong")  # the number of bytes
damage(b"connectivity", -1, 1 << 40, "reaches behind the end of the file")
damage(b"types", 3, 12, "cell 3 (type 12, vtkHexahedron) has 4 points, not 8", form="<B")


def replace(old, new, says):
    assert old in text
    with open("damaged.vtu", "wb") as broken:
        broken.write(text.replace(old, new, 1))
    refuse("--pieces", 3, "damaged.vtu", says=says)


replace(b'NumberOfPoints="1000"', b'NumberOfPoints="1001"', "has too few values")
replace(b'NumberOfCells="4374"', b'NumberOfCells="4375"', "has too few values")
replace(b'NumberOfCells="4374"', b'NumberOfCells="999999999999"', "more than 2^32")
begin = array_at(b"pressure")[0] - 8 - DATA
replace(b'offset="%d"' % begin, b'offset="99999999999"', "begins behind the end of the file")
for length, says in ((DATA + 4, "damaged.vtu"), (DATA + 20000, "the end of the file"),
                     (len(text) - 30000, "the end of the file")):
    with open("damaged.vtu", "wb") as file:
        file.write(text[:length])
    refuse("--pieces", 3, "damaged.vtu", says=says)

# Compressed blocks: numbers, sizes and content.
write_as(mesh, "case.vtu", "ZLib")
with open("case.vtu", "rb") as file:
    compressed = file.read()
begin = array_at(b"velocity", compressed)[0] - 8
for word, value, says in ((0, 1 << 60, "more compressed blocks"), (1, 0, "blocks of a wrong size"),
                          (1, 1 << 50, "blocks of a wrong size"), (2, 5000, "blocks of a wrong size"),
                          (3, 1 << 60, "the end of the file"), (0, 0, "has too few values"),
                          (40, 0x123456789, "cannot be decompressed")):
    damaged = bytearray(compressed)
    struct.pack_into("<Q", damaged, begin + 8 * word, value)
    with open("damaged.vtu", "wb") as file:
        file.write(damaged)
    refuse("--pieces", 3, "damaged.vtu", says=says)


# Memory: less than the whole mesh takes. A small program measures, because the peak of a process
# begins with that of the one that starts it.
MEASURE = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


def peak(*arguments):
    command = [sys.executable, "-c", MEASURE, PROGRAM, "pack", "-q", "-f", *map(str, arguments)]
    return int(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout) / 1024


LIMIT = 260
write_as(scattered(66, 7), "large.vtu")
whole = peak("large.vtu", "large.gtn")
parts = peak("--memory", LIMIT, "large.vtu", "parts.gtn")
print(f"peak memory: {whole:.0f} MiB as a whole, {parts:.0f} MiB in pieces")
assert whole > LIMIT > parts
info = json.loads(gtn("info", "--json", "parts.gtn"))
assert info["points"] == 67**3 and info["tets"] == 6 * 66**3
gtn("verify", "parts.gtn", "large.vtu", says="identical")
refuse("--memory", 100, "large.vtu", says="takes at least")

# With all points at one place, only the order of the cells divides the mesh.
points, tets = lattice(66)
dense = make_grid(np.ones_like(points), tets, {"height": points[:, 2].copy()})
write_as(dense, "dense.vtu")
parts = peak("--memory", LIMIT, "dense.vtu", "parts.gtn")
print(f"peak memory: {parts:.0f} MiB in pieces at one place")
assert parts < LIMIT
gtn("verify", "parts.gtn", "dense.vtu", says="identical")

# Killed at any time, it leaves no file.
files = sorted(os.listdir("."))
os.mkdir("spill")
for wait in (0.2, 0.5, 0.9):
    with subprocess.Popen([PROGRAM, "pack", "-q", "--memory", str(LIMIT), "--spill", "spill", "large.vtu",
                           "never.gtn"]) as run:
        time.sleep(wait)
        run.send_signal(signal.SIGKILL)
    assert not os.listdir("spill")
    assert sorted(os.listdir(".")) == sorted([*files, "spill"])
for wait in (0.2, 0.6):
    with subprocess.Popen([PROGRAM, "pack", "-q", "--memory", str(LIMIT), "large.vtu", "never.gtn"],
                          stderr=subprocess.DEVNULL) as run:
        time.sleep(wait)
        run.send_signal(signal.SIGINT)
    assert run.returncode != 0
    assert sorted(os.listdir(".")) == sorted([*files, "spill"])
