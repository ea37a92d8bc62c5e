# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files with the field arrays by which a representation tells other processes what file to draw in place of a
piece. They are drawn as if they had no such arrays, and the file that they name is not opened.
Usage: TestHostileMark.py [PVSERVER MPIEXEC], as the client of a server of two processes.
"""

import os
import sys

from vtkmodules.vtkCommonCore import (
    vtkDoubleArray, vtkIdList, vtkIdTypeArray, vtkPoints, vtkStringArray)
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks
from gatunServer import connected
from paraview import simple


def make_corners(data):
    """Gives the data the corners of a tetrahedron, with values."""
    points = vtkPoints()
    wave = vtkDoubleArray()
    wave.SetName("wave")
    for i, corner in enumerate(((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))):
        points.InsertNextPoint([sample.SIDE * x for x in corner])
        wave.InsertNextValue(2.0 - i)
    data.SetPoints(points)
    data.GetPointData().AddArray(wave)
    return data


def make_grid():
    grid = make_corners(vtkUnstructuredGrid())
    ids = vtkIdList()
    for i in range(4):
        ids.InsertNextId(i)
    grid.InsertNextCell(VTK_TETRA, ids)
    return grid


def make_surface():
    surface = make_corners(vtkPolyData())
    cells = vtkCellArray()
    for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
        cells.InsertNextCell(3, face)
    surface.SetPolys(cells)
    return surface


def mark(data, path, cells):
    """Adds the arrays of gatun::MarkPiece."""
    for kind, name, value in ((vtkStringArray, "File", path), (vtkDoubleArray, "Time", 0),
                              (vtkIdTypeArray, "Merges", 0), (vtkIdTypeArray, "Cells", cells)):
        array = kind()
        array.SetName("GatunDrawn" + name)
        array.InsertNextValue(value)
        data.GetFieldData().AddArray(array)
    return data


def write(data, name):
    """Writes a file by VTK and one by Gatun, and returns both names."""
    isSurface = data.IsA("vtkPolyData")
    paths = [sample.temporary(name + ending)
             for ending in ((".vtp" if isSurface else ".vtu"), ".gtn")]
    writer = (vtkXMLPolyDataWriter if isSurface else vtkXMLUnstructuredGridWriter)()
    writer.SetFileName(paths[0])
    writer.SetInputData(data)
    assert writer.Write()
    simple.SaveData(paths[1], proxy=simple.OpenDataFile(paths[0]))
    assert os.path.getsize(paths[1])
    return paths


def is_open(path):
    """Whether this process has the file open."""
    for number in os.listdir("/proc/self/fd"):
        try:
            if os.readlink("/proc/self/fd/" + number) == os.path.realpath(path):
                return True
        except FileNotFoundError:
            pass
    return False


def picture_of(path, representation, victim=None, **options):
    """Draws a file, by which another one must not be opened. Returns the picture and the names of the field
    arrays."""
    if path.endswith(".gtn"):
        # Not by OpenDataFile, which would choose a reader by what is in the file.
        isSurface = representation != "Gatun Volume"
        reader = simple.GatunSurfaceReader if isSurface else simple.GatunReader
        source = reader(FileNames=[path], **options)
    else:
        source = simple.OpenDataFile(path)
    shown = drawing.show(source, view, representation)
    picture = drawing.draw(view)
    assert not victim or not is_open(victim)
    names = set(source.FieldData.keys())
    simple.Delete(shown)
    simple.Delete(source)
    return picture, names


def run():
    global view
    # Several processes take longer.
    isAlone = len(sys.argv) < 3 and rank_and_ranks()[1] == 1
    view = drawing.make_view()
    cases = (
        ("grid", make_grid, sample.make_source(), ["Gatun Volume", "Gatun Surface"]),
        ("surface", make_surface, simple.ExtractSurface(Input=sample.make_source()),
         ["Gatun Surface", "Gatun Volume"]))
    for name, make, other, representations in cases:
        victim = sample.temporary(name + "-other.gtn")
        simple.SaveData(victim, proxy=other)
        plain = write(make(), name + "-plain")
        hostile = write(mark(make(), victim, 1), name + "-hostile")
        marked = [hostile]
        if isAlone:
            marked.append(write(mark(make(), victim + ".missing", 1), name + "-missing"))
        for representation in representations[:2 if isAlone else 1]:
            isOwn = representation == representations[0]
            for i in range(2 if isOwn else 1):
                expected, _ = picture_of(plain[i], representation)
                for paths in marked:
                    picture, names = picture_of(paths[i], representation, victim)
                    assert "GatunDrawnFile" in names, names
                    drawing.require_same(picture, expected)
        # A file on demand that has such arrays itself is the one that is drawn.
        expected, _ = picture_of(plain[1], representations[0], LargeMesh=0)
        picture, _ = picture_of(hostile[1], representations[0], victim, LargeMesh=0)
        drawing.require_same(picture, expected)
        # The other file shows something else, and is seen to be open where it is.
        picture, _ = picture_of(victim, representations[0], LargeMesh=0)
        drawing.require_other(picture, expected)
        if len(sys.argv) < 3:
            reader = simple.OpenDataFile(victim)
            reader.UpdatePipeline()
            assert is_open(victim)
            simple.Delete(reader)


if len(sys.argv) > 2:
    with connected(sys.argv[1], sys.argv[2], 2):
        run()
else:
    load_plugin()
    run()
print("done")
