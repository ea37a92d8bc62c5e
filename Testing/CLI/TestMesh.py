# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""mesh fills a closed surface, from each format, and says what is wrong with others."""

import json
import sys

from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from gatunCli import enter_folder, gtn

enter_folder("mesh")
cube = vtkCubeSource()
triangles = vtkTriangleFilter()
triangles.SetInputConnection(cube.GetOutputPort())
clean = vtkCleanPolyData()
clean.SetInputConnection(triangles.GetOutputPort())
for name, writer in {
    "cube.stl": vtkSTLWriter(),
    "cube.ply": vtkPLYWriter(),
    "cube.vtp": vtkXMLPolyDataWriter(),
    "cube.vtk": vtkPolyDataWriter(),
}.items():
    writer.SetInputConnection(clean.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()

with open("cube.obj", "w") as file:
    for i in range(8):
        file.write("v %g %g %g\n" % ((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5))
    for quad in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"):
        file.write(f"f {quad}\n")

if sys.argv[1:] == ["without"]:
    gtn("mesh", "cube.stl", "cube.gtn", code=1, says="built without TetGen")
    gtn("mesh", "--help", says="not built in")
    sys.exit(0)

for extension in ("stl", "ply", "obj", "vtp", "vtk"):
    gtn("mesh", "--max-volume", "0.01", "cube." + extension, extension + ".gtn", says="tetrahedra")
    info = json.loads(gtn("info", "--json", extension + ".gtn"))
    assert info["tets"] > 100 and info["bounds"] == [[-0.5, 0.5]] * 3
gtn("mesh", "--quality", "1.2", "--min-dihedral", "10", "cube.stl", "cube.vtu")
gtn("mesh", "-f", "--preserve-surface", "cube.stl", "cube.vtu", says="tetrahedra")
gtn("mesh", "cube.stl", "cube.vtu", code=1, says="exists")
gtn("mesh", "--quality", "0.5", "cube.stl", "new.vtu", code=1, says="gtn: cube.stl: ")
gtn("mesh", "--quality", "-1", "cube.stl", "new.vtu", code=2)
gtn("mesh", "--switches", "o2", "cube.stl", "new.vtu", code=1, says="cannot be used")
gtn("mesh", "cube.stl", "new.xyz", code=2)
gtn("mesh", "missing.stl", "new.gtn", code=1, says="gtn: missing.stl: no such file")

sphere = vtkSphereSource()
sphere.SetEndTheta(180)
writer = vtkSTLWriter()
writer.SetInputConnection(sphere.GetOutputPort())
writer.SetFileName("open.stl")
writer.Write()
gtn("mesh", "open.stl", "new.gtn", code=1, says="gtn: open.stl: the surface is not closed")
