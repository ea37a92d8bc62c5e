# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""One picture of many: panels with captions, and bars for numbers."""

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (texts)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageResize
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

WIDTH, HEIGHT = 700, 500  # of a panel
TITLE, CAPTION = 70, 78  # heights
GAP = 14
FILL = 0.94  # the part of a panel that is not margin
COLUMNS = 3

PAPER = np.array([1.0, 1.0, 1.0])
FLOOR, SKY = np.array([0.86, 0.88, 0.91]), np.array([0.99, 0.99, 1.0])  # behind what is shown
INK = (0.13, 0.16, 0.20)
BAR, OURS = np.array([0.72, 0.76, 0.82]), np.array([0.14, 0.51, 0.545])


def _to_array(image):
    """Rows from the top, colors from 0 to 1."""
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[::-1] / 255


def _resize(pixels, width, height):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    values = np.ascontiguousarray(pixels[::-1]).reshape(-1, pixels.shape[2])
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    resize = vtkImageResize()
    resize.SetInputData(image)
    resize.SetOutputDimensions(width, height, 1)
    resize.Update()
    made = vtk_to_numpy(resize.GetOutput().GetPointData().GetScalars())
    return np.clip(made.reshape(height, width, -1)[::-1], 0, 1)


def _make_background():
    along = np.linspace(0, 1, HEIGHT)[:, None, None]
    return np.tile(SKY * (1 - along) + FLOOR * along, (1, WIDTH, 1))


def read_picture(name):
    """A picture as a panel. One that is transparent is put before the background of the others,
    without its empty margins."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    pixels = _to_array(reader.GetOutput())
    if pixels.shape[2] < 4:
        return _resize(pixels[:, :, :3], WIDTH, HEIGHT)
    panel = _make_background()
    rows, columns = np.nonzero(pixels[:, :, 3] > 0.03)
    if not len(rows):
        return panel
    pixels = pixels[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
    pixels = np.dstack([pixels[:, :, :3] * pixels[:, :, 3:], pixels[:, :, 3]])
    factor = FILL * min(WIDTH / pixels.shape[1], HEIGHT / pixels.shape[0])
    width, height = (max(1, round(factor * n)) for n in (pixels.shape[1], pixels.shape[0]))
    pixels = _resize(pixels, width, height)
    top, left = (HEIGHT - height) // 2, (WIDTH - width) // 2
    place = panel[top : top + height, left : left + width]
    place[:] = pixels[:, :, :3] + place * (1 - pixels[:, :, 3:])
    return panel


def write_text(pixels, words, left, top, size, bold=False, room=None):
    """Draws words with their upper left corner at a place, smaller if they are wider than the room."""
    look = vtkTextProperty()
    look.SetFontSize(size)
    look.SetBold(bold)
    look.SetColor(*INK)
    look.SetVerticalJustificationToTop()
    image = vtkImageData()
    renderer = vtkTextRenderer.GetInstance()
    renderer.SetScaleToPowerOfTwo(False)
    renderer.RenderString(look, words, image, [0, 0], 72)
    width, height, _ = image.GetDimensions()
    if room and width > room:
        write_text(pixels, words, left, top, int(size * room / width), bold)
        return
    text = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 4)[::-1] / 255
    text = text[: pixels.shape[0] - top, : pixels.shape[1] - left]
    rows, columns = text.shape[:2]
    alpha = text[:, :, 3:]
    place = pixels[top : top + rows, left : left + columns]
    place[:] = text[:, :, :3] * alpha + place * (1 - alpha)


def draw_bars(sizes, unit, ours):
    """A panel with a bar for each size; those whose names begin with ours stand out."""
    panel = _make_background()
    step = (HEIGHT - 40) // len(sizes)
    left = 210
    for i, (name, size) in enumerate(sizes.items()):
        top = 30 + i * step
        length = max(2, round((WIDTH - left - 170) * size / max(sizes.values())))
        color = OURS if name.startswith(ours) else BAR
        panel[top : top + step - 18, left : left + length] = color
        middle = top + (step - 18) // 2 - 11
        write_text(panel, name, 24, middle, 21, name.startswith(ours))
        write_text(panel, f"{size:,.2f} {unit}", left + length + 12, middle, 21)
    return panel


def write_sheet(title, panels, name):
    """Panels: tuples of a picture, a heading and a line of figures."""
    rows = -(-len(panels) // COLUMNS)
    width = COLUMNS * (WIDTH + GAP) + GAP
    sheet = np.tile(PAPER, (TITLE + rows * (HEIGHT + CAPTION + GAP), width, 1))
    write_text(sheet, title, 24, 22, 30, True)
    for i, (picture, heading, figures) in enumerate(panels):
        row = TITLE + (i // COLUMNS) * (HEIGHT + CAPTION + GAP)
        column = GAP + (i % COLUMNS) * (WIDTH + GAP)
        sheet[row : row + HEIGHT, column : column + WIDTH] = picture
        room = WIDTH - 28
        write_text(sheet, heading, column + 14, row + HEIGHT + 10, 22, True, room)
        write_text(sheet, figures, column + 14, row + HEIGHT + 42, 19, False, room)
    height, width = sheet.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    pixels = np.ascontiguousarray((255 * sheet[::-1] + 0.5).astype(np.uint8)).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(name)
    writer.Write()
