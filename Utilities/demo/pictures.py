# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Pictures of a mesh in a .gtn file, drawn without a window."""

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter, vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import sheet

SIZE = (2 * sheet.WIDTH, 2 * sheet.HEIGHT)

# Dark blue over green and yellow to pale: even steps for the eye, and for color-blind ones.
COLORS = (
    (0.00, (0.110, 0.165, 0.340)),
    (0.15, (0.126, 0.310, 0.490)),
    (0.35, (0.140, 0.510, 0.545)),
    (0.55, (0.400, 0.690, 0.475)),
    (0.75, (0.850, 0.790, 0.370)),
    (0.90, (0.940, 0.560, 0.240)),
    (1.00, (0.760, 0.200, 0.170)),
)


def make_table(low, high):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(512)
    places = [place for place, _ in COLORS]
    for i in range(512):
        color = [np.interp(i / 511, places, [c[k] for _, c in COLORS]) for k in range(3)]
        table.SetTableValue(i, *color, 1)
    table.SetRange(low, high)
    table.SetNanColor(0.7, 0.7, 0.7, 1)
    table.Build()
    return table


def skin_of(grid):
    """The surface with smooth normals where it is smooth."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputDataObject(grid)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(40)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def values_of(array):
    """Numbers of an array; of vectors, their lengths."""
    values = vtk_to_numpy(array).astype(np.float64)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values


def set_scalars(data, values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.GetPointData().SetScalars(array)


class Field:
    """What to color by: a point or cell array, and the range that its colors span."""

    def __init__(self, grid):
        self.array = None
        self.of_points = True
        self.low, self.high = 0.0, 1.0
        for of_points, data in ((True, grid.GetPointData()), (False, grid.GetCellData())):
            names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
            names = [name for name in names if name and data.GetArray(name)]
            if data.GetScalars():
                names.insert(0, data.GetScalars().GetName())
            for name in names:
                if self._take(data.GetArray(name)):
                    self.array, self.of_points = name, of_points
                    return

    def _take(self, array):
        """Takes the range of an array; false if all its values are the same."""
        values = values_of(array)
        values = values[np.isfinite(values)]
        if len(values) == 0 or values.min() == values.max():
            return False
        # A few extreme values must not take all the colors.
        low, high = np.percentile(values, [0.5, 99.5])
        if low == high:
            low, high = values.min(), values.max()
        self.low, self.high = 0.0 if 0 < low < 0.1 * high else low, high
        return True


def color_by(mapper, field):
    if not field.array:
        mapper.ScalarVisibilityOff()
        return
    table = make_table(field.low, field.high)
    # The table picks the length of vectors by itself.
    table.SetVectorModeToMagnitude()
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    if field.of_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(field.array)
    mapper.SetColorModeToMapScalars()


def actor_of(data, field=None, color=(0.8, 0.82, 0.85), edges=False):
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    if field:
        color_by(mapper, field)
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*color)
    look.SetAmbient(0.26)
    look.SetDiffuse(0.80)
    look.SetSpecular(0.18)
    look.SetSpecularPower(25)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.10, 0.13, 0.18)
        look.SetLineWidth(0.7)
    return actor


def scalar_bar(mapper, title):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle(title + "\n ")
    bar.SetNumberOfLabels(5)
    bar.SetMaximumNumberOfColors(512)
    bar.SetTextPad(10)
    bar.SetLabelFormat("%-#.3g")
    bar.SetPosition(0.80, 0.14)
    bar.SetWidth(0.18)
    bar.SetHeight(0.66)
    bar.SetBarRatio(0.14)
    bar.SetUnconstrainedFontSize(True)
    for text, size in ((bar.GetTitleTextProperty(), 22), (bar.GetLabelTextProperty(), 21)):
        text.SetColor(*sheet.INK)
        text.SetFontSize(size)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    bar.GetTitleTextProperty().SetJustificationToLeft()
    return bar


def fit(renderer, horizontal, vertical):
    """Moves and zooms the camera so that all points are in a part of the window, which reaches from
    -1 to 1 both ways."""
    camera = renderer.GetActiveCamera()
    points = np.concatenate([vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())
                             for actor in renderer.GetActors()])
    points = np.column_stack([points, np.ones(len(points))])
    for _ in range(3):
        camera.SetWindowCenter(0, 0)
        matrix = camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
        matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        seen = points @ matrix.T
        seen = seen[:, :2] / seen[:, 3:]
        low, high = seen.min(axis=0), seen.max(axis=0)
        room = np.array([horizontal[1] - horizontal[0], vertical[1] - vertical[0]])
        camera.Zoom(min(room / (high - low)))
    camera.SetWindowCenter(*(0.5 * (low + high) - 0.5 * np.array([sum(horizontal), sum(vertical)])))


def draw(actors, name, bar=None, direction=(0.62, -0.95, 0.72)):
    """Renders to a PNG file, seen from a direction."""
    renderer = vtkRenderer()
    renderer.SetBackground(*sheet.FLOOR)
    renderer.SetBackground2(*sheet.SKY)
    renderer.GradientBackgroundOn()
    renderer.AutomaticLightCreationOff()
    for place, strength in (((-0.6, 0.9, 1.2), 0.88), ((1.2, 0.3, 0.5), 0.46), ((0, -1, 0.3), 0.18)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*place)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    for actor in actors:
        renderer.AddActor(actor)
    if bar:
        renderer.AddViewProp(bar)
    renderer.SetUseDepthPeeling(False)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(24)
    camera.SetPosition(*direction)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    # Room for the scale on the right.
    fit(renderer, (-0.94, 0.58 if bar else 0.94), (-0.94, 0.94))
    renderer.ResetCameraClippingRange()
    window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def draw_surface(grid, field, name, vectors=None):
    """The whole, bent as its displacement says, but much more. Returns words about that."""
    shown = grid
    words = ""
    if vectors:
        largest = grid.GetPointData().GetArray(vectors).GetMaxNorm()
        bounds = grid.GetBounds()
        size = np.linalg.norm([bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]])
        warp = vtkWarpVector()
        warp.SetInputDataObject(grid)
        warp.SetInputArrayToProcess(0, 0, 0, 0, vectors)
        warp.SetScaleFactor(0.04 * size / largest if largest else 0)
        words = f", displacement {warp.GetScaleFactor():.0f} times as large"
        warp.Update()
        shown = warp.GetOutput()
    actor = actor_of(skin_of(shown), field)
    bar = scalar_bar(actor.GetMapper(), field.array) if field.array else None
    draw([actor], name, bar)
    return words


def draw_cut(grid, field, name):
    """The tetrahedra on one side of a plane through the middle, with their edges."""
    plane = vtkPlane()
    plane.SetOrigin(*grid.GetCenter())
    plane.SetNormal(0.0, 1.0, 0.0)
    keep = vtkExtractGeometry()
    keep.SetInputDataObject(grid)
    keep.SetImplicitFunction(plane)
    keep.ExtractInsideOff()
    keep.Update()
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(keep.GetOutputPort())
    surface.Update()
    actor = actor_of(surface.GetOutput(), field, edges=True)
    actor.GetProperty().SetInterpolationToFlat()
    bar = scalar_bar(actor.GetMapper(), field.array) if field.array else None
    draw([actor], name, bar, direction=(0.35, -1.0, 0.42))


def draw_isosurfaces(file, grid, field, name):
    """Surfaces in a .vtp file, and the whole as a shadow around them."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    actor = actor_of(reader.GetOutput(), field)
    shadow = actor_of(skin_of(grid), color=(0.45, 0.5, 0.58))
    shadow.GetProperty().SetOpacity(0.12)
    shadow.GetProperty().SetSpecular(0)
    draw([actor, shadow], name, scalar_bar(actor.GetMapper(), field.array))


def piece_color(index):
    """Colors that follow each other far apart on the wheel, all of the same strength."""
    hue = (0.55 + index * 0.61803398875) % 1.0
    wheel = [0.5 + 0.5 * np.cos(2 * np.pi * (hue - third / 3)) for third in range(3)]
    return [0.30 + 0.55 * part for part in wheel]


def draw_pieces(pieces, name):
    """The pieces, each moved outwards from the middle of all."""
    bounds = np.array([piece.GetBounds() for piece in pieces]).reshape(-1, 3, 2)
    center = 0.5 * (bounds[:, :, 0].min(axis=0) + bounds[:, :, 1].max(axis=0))
    actors = []
    for index, piece in enumerate(pieces):
        skin = skin_of(piece)
        away = 0.30 * (np.array(piece.GetCenter()) - center)
        shift = vtkTransform()
        shift.Translate(*away)
        move = vtkTransformPolyDataFilter()
        move.SetInputDataObject(skin)
        move.SetTransform(shift)
        move.Update()
        actors.append(actor_of(move.GetOutput(), color=piece_color(index)))
    draw(actors, name)


def copy_of(grid):
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(grid)
    return copy
