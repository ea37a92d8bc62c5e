# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Panels with captions, drawn into one picture without a window. A panel is a vtkRenderer."""

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

COLUMNS = 3
WIDTH, HEIGHT = 700, 500  # of a panel
TITLE, CAPTION, GAP = 70, 78, 14
SCALE = 2  # so many pixels each way become one, for smooth edges
FILL = 0.94  # the part of a panel that is not margin
BACKGROUND = {"Background": (0.86, 0.88, 0.91), "Background2": (0.99, 0.99, 1.0), "GradientBackground": True}
INK, BAR, OURS = (0.13, 0.16, 0.20), (0.72, 0.76, 0.82), (0.14, 0.51, 0.545)


def new(kind, **properties):
    """An object of VTK with these properties."""
    made = kind()
    for name, value in properties.items():
        getattr(made, "Set" + name)(value)
    return made


def output_of(algorithm, data=None):
    if data:
        algorithm.SetInputDataObject(data)
    algorithm.Update()
    return algorithm.GetOutput()


def _write(panel, words, left, bottom, size, bold=False, room=WIDTH):
    """Writes words, smaller if they are wider than the room."""
    look = new(vtk.vtkTextProperty, Color=INK, Bold=bold, FontSize=SCALE * size)
    box = [0] * 4
    vtk.vtkTextRenderer.GetInstance().GetBoundingBox(look, words, box, 72)
    look.SetFontSize(int(SCALE * size * min(1, SCALE * room / (box[1] - box[0]))))
    panel.AddViewProp(new(vtk.vtkTextActor, Input=words, TextProperty=look, Position=(SCALE * left, SCALE * bottom)))


def make_bars(sizes):
    """A bar for each number of bytes; the last one stands out."""
    panel = new(vtk.vtkRenderer, **BACKGROUND)
    step, left = (HEIGHT - 40) // len(sizes), 210
    for i, (name, size) in enumerate(sizes.items()):
        bottom, is_ours = HEIGHT - 12 - (i + 1) * step, i == len(sizes) - 1
        right, top = left + max(2, (WIDTH - left - 170) * size / max(sizes.values())), bottom + step - 18
        plane = new(vtk.vtkPlaneSource, Origin=(SCALE * left, SCALE * bottom, 0),
                    Point1=(SCALE * right, SCALE * bottom, 0), Point2=(SCALE * left, SCALE * top, 0))
        mapper = new(vtk.vtkPolyDataMapper2D, InputConnection=plane.GetOutputPort())
        look = new(vtk.vtkProperty2D, Color=OURS if is_ours else BAR)
        panel.AddViewProp(new(vtk.vtkActor2D, Mapper=mapper, Property=look))
        _write(panel, name, 24, (bottom + top) // 2 - 8, 21, is_ours)
        _write(panel, f"{size / 1e6:,.2f} MB", right + 12, (bottom + top) // 2 - 8, 21)
    return panel


def make_picture(file):
    """What a PNG file shows, without its transparent margins."""
    reader = new(vtk.vtkPNGReader, FileName=file)
    columns, rows, _ = output_of(reader).GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, -1)
    shown = np.nonzero(pixels[:, :, -1] > 8)
    (bottom, top), (left, right) = ((n.min(), n.max()) if len(n) else (0, 1) for n in shown)
    actor = new(vtk.vtkImageActor, DisplayExtent=(left, right, bottom, top, 0, 0))
    actor.GetMapper().SetInputConnection(reader.GetOutputPort())
    panel = new(vtk.vtkRenderer, **BACKGROUND)
    panel.AddViewProp(actor)
    panel.SetActiveCamera(new(vtk.vtkCamera, ParallelProjection=True))
    panel.ResetCamera()
    panel.GetActiveCamera().SetParallelScale(0.5 / FILL * max(top - bottom, (right - left) * HEIGHT / WIDTH))
    return panel


def make_scene(actors, title=None, direction=(0.62, -0.95, 0.72)):
    """Actors seen from a direction; with a title, a scale of the colors of the first one."""
    panel = new(vtk.vtkRenderer, **BACKGROUND)
    vtk.vtkLightKit().AddLightsToRenderer(panel)
    for actor in actors:
        panel.AddActor(actor)
    panel.SetActiveCamera(new(vtk.vtkCamera, ViewAngle=24, Position=direction, FocalPoint=(0, 0, 0), ViewUp=(0, 0, 1)))
    if title:
        look, colors = new(vtk.vtkTextProperty, Color=INK, FontSize=11 * SCALE), actors[0].GetMapper().GetLookupTable()
        panel.AddViewProp(new(
            vtk.vtkScalarBarActor, LookupTable=colors, Title=title + "\n ", NumberOfLabels=5, MaximumNumberOfColors=512,
            TextPad=10, LabelFormat="%-#.3g", Position=(0.80, 0.14), Width=0.18, Height=0.66, BarRatio=0.14,
            UnconstrainedFontSize=True, TitleTextProperty=look, LabelTextProperty=look))
    # All points fill the panel, but for room for the scale; zooming changes the perspective.
    points = np.concatenate([vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData()) + actor.GetPosition()
                             for actor in actors])
    camera, right = panel.GetActiveCamera(), 0.58 if title else FILL
    panel.ResetCamera()
    for _ in range(3):
        matrix = camera.GetCompositeProjectionTransformMatrix(WIDTH / HEIGHT, -1, 1)
        matrix = np.reshape([matrix.GetElement(i // 4, i % 4) for i in range(16)], (4, 4))
        seen = np.c_[points, np.ones(len(points))] @ matrix.T
        low, high = (extreme(seen[:, :2] / seen[:, 3:], axis=0) for extreme in (np.min, np.max))
        camera.Zoom(min(np.array([right + FILL, 2 * FILL]) / (high - low)))
    camera.SetWindowCenter(*(0.5 * (low + high - [right - FILL, 0])))
    return panel


def write_sheet(title, panels, file):
    """Panels: tuples of a renderer, a heading and a line of figures."""
    width = COLUMNS * (WIDTH + GAP) + GAP
    height = TITLE - (-len(panels) // COLUMNS) * (HEIGHT + CAPTION + GAP)
    window = new(vtk.vtkRenderWindow, OffScreenRendering=1, MultiSamples=0, Size=(SCALE * width, SCALE * height))
    paper = new(vtk.vtkRenderer, Background=(1, 1, 1))
    window.AddRenderer(paper)
    _write(paper, title, 24, height - 45, 30, True)
    for i, (panel, heading, figures) in enumerate(panels):
        left = GAP + i % COLUMNS * (WIDTH + GAP)
        bottom = height - TITLE - HEIGHT - i // COLUMNS * (HEIGHT + CAPTION + GAP)
        panel.SetViewport(left / width, bottom / height, (left + WIDTH) / width, (bottom + HEIGHT) / height)
        window.AddRenderer(panel)
        _write(paper, heading, left + 14, bottom - 27, 22, True, WIDTH - 28)
        _write(paper, figures, left + 14, bottom - 57, 19, False, WIDTH - 28)
    window.Render()
    image = new(vtk.vtkWindowToImageFilter, Input=window, ReadFrontBuffer=False)
    small = new(vtk.vtkImageResize, InputConnection=image.GetOutputPort(), OutputDimensions=(width, height, 1))
    new(vtk.vtkPNGWriter, InputConnection=small.GetOutputPort(), FileName=file).Write()
