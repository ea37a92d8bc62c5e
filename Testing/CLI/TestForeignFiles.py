# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files that are told by their content, files of meshio, and files that are not what their names
say: each is packed as it is, or refused with the cause and what to do."""

import os
import shutil
import signal
import subprocess
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_TRIANGLE
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

from gatunCli import PROGRAM, enter_folder, gtn, make_grid, lattice, read, standard_mesh, write

enter_folder("foreign")
grid = standard_mesh(4)
write(grid, "mesh.vtu")
TETS = grid.GetNumberOfCells()

# Exodus under any name; a name of Exodus alone is not enough.
writer = vtkExodusIIWriter()
writer.SetInputData(grid)
writer.SetFileName("mesh.e")
assert writer.Write()
del writer
for name in ("mesh.gen", "mesh.exii", "mesh.e-s002", "mesh.e.4.0", "mesh.E", "no_extension", "mesh.e.128.007"):
    shutil.copy("mesh.e", name)
    gtn("pack", "-f", name, "exodus.gtn", says="tetrahedra")
    gtn("verify", "exodus.gtn", "mesh.e", says="identical")
with open("mesh.gen", "w") as file:
    file.write("this is text")
gtn("pack", "mesh.gen", "new.gtn", code=1, says="mesh.gen: is not an Exodus file")
with open("mesh.e.9", "w") as file:
    file.write("this is text")
gtn("pack", "mesh.e.9", "new.gtn", code=1, says="mesh.e.9: no reader for this extension")

# What is no file, or not the one that it seems to be.
os.mkfifo("pipe.vtu")
os.mkfifo("pipe.gtn")
os.symlink("/dev/zero", "device.vtk")
for name in ("pipe.vtu", "device.vtk"):
    gtn("pack", name, "new.gtn", code=1, says=f"{name}: is not a regular file")
gtn("info", "pipe.gtn", code=1, says="pipe.gtn: is not a regular file")
gtn("pack", "--pieces", 2, "pipe.vtu", "new.gtn", code=1, says="is not a regular file")
for name in ("pointer.vtu", "pointer.gtn", "pointer.stl"):
    with open(name, "w") as file:
        file.write("version https://git-lfs.github.com/spec/v1\noid sha256:" + "0" * 64 + "\nsize 12345\n")
    gtn("pack", name, "new.gtn", code=1, says=f"{name}: is a pointer of Git LFS")
with open("mesh.vtu", "rb") as file:
    whole = file.read()
text = vtkXMLUnstructuredGridWriter()
text.SetInputData(grid)
text.SetFileName("text.vtu")
text.SetDataModeToAscii()
assert text.Write()
with open("text.vtu", "rb") as file:
    words = file.read()
for name, content in (("cut.vtu", whole[: len(whole) // 2]), ("end.vtu", whole[:-100]),
                      ("words.vtu", words[: len(words) // 3])):
    with open(name, "wb") as file:
        file.write(content)
    gtn("pack", name, "new.gtn", code=1, says=f"{name}: is truncated")
LEGACY = ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
          "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
          "SCALARS u float 1\nLOOKUP_TABLE default\n1 %s 2 3\n")
for word in ("nan", "-NaN", "inf"):
    with open("word.vtk", "w") as file:
        file.write(LEGACY % word)
    gtn("pack", "word.vtk", "new.gtn", code=1, says=f"word.vtk: has {word} in text")
gtn("info", "mesh.vtu", code=1, says="mesh.vtu: is not a .gtn file; gtn pack makes one")

# Surfaces among others: the right one is named.
geometry = vtkGeometryFilter()
geometry.SetInputData(grid)
triangles = vtkTriangleFilter()
triangles.SetInputConnection(geometry.GetOutputPort())
for kind, name in ((vtkXMLPolyDataWriter, "surface.vtp"), (vtkSTLWriter, "surface.stl")):
    writer = kind()
    writer.SetInputConnection(triangles.GetOutputPort())
    writer.SetFileName(name)
    assert writer.Write()
    for files in (("mesh.vtu", name), (name, "mesh.vtu")):
        gtn("pack", *files, "new.gtn", code=1, says=f"gtn: {name}: is a surface (vtkPolyData), and mesh.vtu is not")
gtn("contour", "--value", 1, "surface.vtp", "new.vtp", code=1, says="surface.vtp: is a surface")

# Meshes of 2D cells alone, and isovalues that nothing has: no empty files.
places = np.array([[i % 3, i // 3, 0] for i in range(9)], np.float32)
plane = make_grid(places, np.zeros((0, 4), np.int64), {"u": np.arange(9.0)})
plane.InsertNextCell(VTK_QUAD, 4, [0, 1, 4, 3])
plane.InsertNextCell(VTK_TRIANGLE, 3, [1, 2, 4])
write(plane, "flat.vtu")
gtn("pack", "-q", "flat.vtu", "flat.gtn")
for name in ("flat.vtu", "flat.gtn"):
    for command in (("contour", "--value", 1, name, "new.vtp"), ("render", name, "new.png")):
        gtn(*command, code=1, says=f"gtn: {name}: has no 3D cells, only 1 vtkTriangle, 1 vtkQuad; ")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")
for name in ("mesh.vtu", "mesh.gtn"):
    gtn("contour", "--array", "pressure", "--value", 100, name, "new.vtp", code=1,
        says=f"gtn: {name}: no surface at 100: array 'pressure' has values from ")
assert not [name for name in os.listdir(".") if name.startswith("new")], "an empty file is left"

# One signal is enough, also while a reader of VTK takes its time.
big = standard_mesh(40)
writer = vtkXMLUnstructuredGridWriter()
writer.SetInputData(big)
writer.SetFileName("big.vtu")
writer.SetDataModeToAscii()
assert writer.Write()
for number in (signal.SIGTERM, signal.SIGINT):
    for command in (("pack", "big.vtu", "new.gtn"), ("simplify", "big.vtu", "new.vtu")):
        with subprocess.Popen([PROGRAM, *command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
            time.sleep(0.3)
            run.send_signal(number)
            assert run.wait(timeout=15) == -number, run.returncode
        assert not [name for name in os.listdir(".") if name.startswith("new")], os.listdir(".")

# meshio, in a process of its own.
with open("mesh.msh", "w") as file:
    file.write("no mesh")
os.mkdir("without")
with open("without/meshio.py", "w") as file:
    file.write("raise ImportError")
for path in (os.environ["PATH"], "/nowhere"):
    gtn("pack", "mesh.msh", "new.gtn", code=1, says="apt-get install python3-meshio",
        env=dict(os.environ, PATH=path, PYTHONPATH="without"))
try:
    import meshio
except ImportError:
    meshio = None
if not meshio:
    print("no meshio, so its formats are not tested")
else:
    # What lies in the current folder is not run.
    with open("meshio.py", "w") as file:
        file.write("raise SystemExit('run')")
    gtn("pack", "mesh.msh", "new.gtn", code=1, says="mesh.msh: meshio")
    places, tets = lattice(3, dtype=np.float64)
    values = {"u": places[:, 0] * 2, "v": places[:, ::-1].copy()}
    wedge = np.array([[0, 1, 4, 16, 17, 20]])
    blocks = [("tetra", tets), ("triangle", tets[:5, :3]), ("wedge", wedge)]
    tags = [np.arange(len(block)) + i for i, (_, block) in enumerate(blocks)]
    for name, options in (("a.msh", {"file_format": "gmsh22"}), ("a.med", {}), ("a.xdmf", {}), ("a.su2", {}),
                          ("a.bdf", {}), ("a.inp", {}), ("a.mesh", {})):
        cells = blocks if name in ("a.msh", "a.xdmf", "a.inp") else blocks[:1]
        mesh = meshio.Mesh(places, cells)
        if name in ("a.msh", "a.xdmf", "a.med"):
            mesh.point_data = dict(values)
        if name == "a.msh":
            mesh.cell_data = {"gmsh:physical": tags[: len(cells)], "gmsh:geometrical": tags[: len(cells)]}
            mesh.field_data = {"inlet": np.array([1, 2]), "fluid": np.array([2, 3])}
        if name == "a.inp":
            mesh.cell_sets = {"front": [np.array([0, 2]), np.array([1]), np.array([], int)]}
            mesh.point_sets = {"fixed": np.array([3, 5])}
        try:
            mesh.write(name, **options)
        except Exception as error:  # a format that this meshio does not write
            print(name, "is not written:", error)
            continue
        expected = meshio.read(name)
        gtn("pack", "-q", "--keep-order", "all", name, "meshio.gtn", "-f")
        gtn("unpack", "-q", "-f", "meshio.gtn", "meshio.vtu")
        back = read("meshio.vtu")
        assert (vtk_to_numpy(back.GetPoints().GetData()) == expected.points).all(), name
        assert back.GetNumberOfCells() == sum(len(block.data) for block in expected.cells), name
        cell = 0
        for block in expected.cells:
            for ids in block.data:
                have = back.GetCell(cell).GetPointIds()
                order = [0, 2, 1, 3, 5, 4] if block.type == "wedge" else range(len(ids))
                assert [have.GetId(i) for i in range(len(ids))] == [ids[i] for i in order], (name, cell)
                cell += 1
        for array, numbers in expected.point_data.items():
            assert (vtk_to_numpy(back.GetPointData().GetArray(array)) == numbers).all(), (name, array)
        for array, parts in expected.cell_data.items():
            have = vtk_to_numpy(back.GetCellData().GetArray(array))
            assert (have == np.concatenate(parts)).all(), (name, array)
        for array, numbers in expected.field_data.items():
            have = back.GetFieldData().GetArray(array)
            assert np.asarray(numbers).size == 0 or list(have.GetTuple(0)) == list(numbers), (name, array)
        if name == "a.inp":
            marked = np.flatnonzero(vtk_to_numpy(back.GetPointData().GetArray("fixed")))
            assert set(expected.point_sets) >= {"fixed"} and list(marked) == [3, 5], marked
            assert back.GetCellData().HasArray("front") == ("front" in expected.cell_sets)
            assert back.GetFieldData().GetAbstractArray("PointSets").GetValue(0) == "fixed"
        if name == "a.msh":
            assert expected.field_data, "Gmsh has names of groups"
    for text, what in (("*HEADING\nnone\n", "points"), ("*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n", "cells")):
        with open("empty.inp", "w") as file:
            file.write(text)
        gtn("pack", "empty.inp", "new.gtn", code=1, says=f"empty.inp: meshio finds no {what} in it")
