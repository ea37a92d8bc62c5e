# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Volume shows hexahedra, wedges and polyhedra in memory and in a file on demand, on any number of
ranks, as the tetrahedra that the rule makes of them: the picture of TestVolumePicture, whose mesh has
these tetrahedra. The cells come back from the file as they were.

Arguments: that picture.
"""

import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()

# Of every three cubes, one is a hexahedron, one is two wedges and one is a polyhedron; a wall of
# quadrilaterals is nothing to a volume.
cells = simple.ProgrammableFilter(Input=sample.make_source())
cells.Script = """
from vtkmodules.vtkCommonCore import vtkIdList
gatun_side = %d
gatun_at = lambda i, j, k: (i * (gatun_side + 1) + j) * (gatun_side + 1) + k
output.VTKObject.GetCellData().Initialize()
output.VTKObject.Reset()
output.VTKObject.Allocate(2 * gatun_side ** 3)
gatun_in = inputs[0].VTKObject
output.VTKObject.SetPoints(gatun_in.GetPoints())
for gatun_array in range(gatun_in.GetPointData().GetNumberOfArrays()):
    output.VTKObject.GetPointData().AddArray(gatun_in.GetPointData().GetArray(gatun_array))
gatun_faces = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
for gatun_cell in range(gatun_side ** 3 if gatun_in.GetNumberOfPoints() else 0):
    i, j, k = gatun_cell // gatun_side ** 2, gatun_cell // gatun_side %% gatun_side, gatun_cell %% gatun_side
    c = [gatun_at(i + a, j + b, k + d) for d in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    if gatun_cell %% 3 == 0:
        output.VTKObject.InsertNextCell(12, 8, c)
    elif gatun_cell %% 3 == 1:
        output.VTKObject.InsertNextCell(13, 6, [c[0], c[1], c[2], c[4], c[5], c[6]])
        output.VTKObject.InsertNextCell(13, 6, [c[0], c[2], c[3], c[4], c[6], c[7]])
    else:
        gatun_list = vtkIdList()
        gatun_list.InsertNextId(6)
        for face in gatun_faces:
            gatun_list.InsertNextId(4)
            for corner in face:
                gatun_list.InsertNextId(c[corner])
        output.VTKObject.InsertNextCell(42, gatun_list)
    if i == 0:
        output.VTKObject.InsertNextCell(9, 4, [c[0], c[4], c[7], c[3]])
""" % sample.SIDE

path = sample.temporary("cells.gtn")
simple.SaveData(path, proxy=cells, ChunkSize=300)
readers = [simple.GatunReader(FileNames=[path]),
           simple.GatunReader(FileNames=[path], LargeMesh=0)]
cubes = sample.SIDE ** 3
assert sample.counts(readers[0])[1] >= cubes + cubes // 3 + sample.SIDE ** 2
if ranks == 1:
    assert sample.counts(readers[0]) == sample.counts(cells)

file = vtkPNGReader()
file.SetFileName(sys.argv[1])
file.Update()
expected = vtk_to_numpy(file.GetOutput().GetPointData().GetScalars())
expected = expected.reshape(drawing.SIZE, drawing.SIZE, -1)[:, :, :3].astype(int)

view = drawing.make_view()
background = drawing.draw(view)
for reader in readers:
    drawing.show(reader, view)
    made = drawing.draw(view)
    simple.Hide(reader, view)
    drawing.require_other(made, background)
    drawing.require_same(expected, made, by=2 if ranks == 1 else 3)
