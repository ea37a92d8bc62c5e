# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What readers and filters make, as surfaces."""

import gatunScenes as gs
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonCore import vtkIdTypeArray

from gatun.vtk import vtkGatunContour, vtkGatunSimplify


def draw_surface(source, **options):
    view = gs.View()
    view.add_surface(source, **options)
    return view.draw()


def SurfaceOfFile():
    """The decoded mesh, cut open, by its point data."""
    plane = vtkPlane()
    plane.SetNormal(-0.6, -0.2, -1)
    plane.SetOrigin(0, 0, 0.3)
    clip = vtkClipDataSet()
    gs.connect(clip, gs.ball_file("surface"))
    clip.SetClipFunction(plane)
    return draw_surface(clip, array="heat")


def SurfaceOfPieces():
    """Six pieces with a layer of ghost cells, each in its color. There are no inner walls, and the
    whole is closed."""
    reader = gs.ball_file("six")
    append = vtkAppendPolyData()
    for piece in range(6):
        surface = vtkDataSetSurfaceFilter()
        surface.SetInputConnection(reader.GetOutputPort())
        surface.UpdatePiece(piece, 6, 1)
        part = surface.GetOutput().NewInstance()
        part.DeepCopy(surface.GetOutput())
        part.RemoveGhostCells()
        number = vtkIdTypeArray()
        number.SetName("piece")
        number.SetNumberOfTuples(part.GetNumberOfCells())
        number.Fill(piece)
        part.GetCellData().SetScalars(number)
        append.AddInputData(part)
    append.Update()
    view = gs.View()
    actor = view.add_surface(append.GetOutput())
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SelectColorArray("piece")
    mapper.SetScalarModeToUseCellFieldData()
    table = vtkLookupTable()
    table.SetNumberOfTableValues(6)
    table.SetTableRange(0, 5)
    table.Build()
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(0, 5)
    return view.draw()


def SurfaceOfRegion():
    """The chunks that touch a box."""
    reader = gs.ball_file("region")
    reader.SetBox(0.2, 1, -1, 1, -0.2, 1)
    return draw_surface(reader, array="heat")


def SimplifiedByReader():
    """A fifth of the points, with the edges of the triangles."""
    reader = gs.ball_file("half", Hierarchy=True)
    reader.SetSimplificationRatio(0.8)
    return draw_surface(reader, array="heat", edges=True)


def SimplifiedByFilter():
    """The same by the filter from a mesh in memory. The baseline is the one of
    SimplifiedByReader."""
    simplify = vtkGatunSimplify()
    gs.connect(simplify, gs.ball())
    simplify.SetSimplificationRatio(0.8)
    return draw_surface(simplify, array="heat", edges=True)


def SimplifiedFar():
    """As few points as the topology allows, nearly."""
    reader = gs.ball_file("far", Hierarchy=True)
    reader.SetSimplificationRatio(0.985)
    return draw_surface(reader, edges=True)


def draw_contour(source, **options):
    contour = vtkGatunContour()
    gs.connect(contour, source)
    contour.SetValue(0, 0.4)
    contour.SetValue(1, 0.6)
    contour.SetValue(2, 0.75)
    contour.ComputeNormalsOn()
    for name, value in options.items():
        getattr(contour, "Set" + name)(value)
    return draw_surface(contour, array="heat")


def ContourOfMemory():
    """The baseline is the one of ContourOfFile."""
    return draw_contour(gs.ball())


def ContourOfFile():
    return draw_contour(gs.ball_file("contour"))


def ContourOfLayers():
    """Strips from a file with layers. The baseline is the one of ContourOfFile."""
    return draw_contour(gs.ball_file("layers", Layers="heat"), OutputStrips=True)


def ContourSimplified():
    reader = gs.ball_file("coarse", Hierarchy=True)
    reader.SetSimplificationRatio(0.9)
    return draw_contour(reader)


gs.run(globals())
