# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Windows with a surface in them."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkMapper, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunSurfaceMapper

BACKGROUND = (0.1, 0.2, 0.3)
VIEWS = ((0, 0), (30, 40), (200, -60), (90, 85))


def ball(n=60, radius=1.0, place=(0, 0, 0), dtype=np.float32):
    """A closed surface of 4 n^2 triangles, normals outward, with values, normals and colors."""
    across, along = np.meshgrid(np.linspace(0, np.pi, n + 1), np.arange(2 * n) * np.pi / n,
                                indexing="ij")
    unit = np.stack([np.sin(across) * np.cos(along), np.sin(across) * np.sin(along),
                     np.cos(across)], -1).reshape(-1, 3)
    polygons = []
    for i in range(n):
        for j in range(2 * n):
            k = (j + 1) % (2 * n)
            a, b = 2 * n * i + j, 2 * n * i + k
            c, d = a + 2 * n, b + 2 * n
            polygons += [[a, c, b], [b, c, d]]
    bumps = 1 + 0.1 * np.sin(9 * unit[:, :1]) * np.cos(7 * unit[:, 1:2])
    surface = pd.make((radius * bumps * unit + place).astype(dtype), Polys=polygons)
    point, cell = surface.GetPointData(), surface.GetCellData()
    rng = np.random.default_rng(4)
    point.SetNormals(gm.add_array(point, unit.astype(np.float32), "Normals"))
    point.SetScalars(gm.add_array(point, unit[:, 0] + unit[:, 2] ** 2, "height"))
    gm.add_array(point, unit.astype(np.float32), "direction")
    point.SetTCoords(gm.add_array(point, unit[:, :2].astype(np.float32), "places"))
    count = len(polygons)
    cell.SetScalars(gm.add_array(cell, (np.arange(count) // 7 % 50).astype(np.int32), "stripes"))
    gm.add_array(cell, rng.integers(0, 256, (count, 4)).astype(np.uint8), "colors")
    return surface


class Scene:
    """A surface, drawn by the mapper under test or by VTK's."""

    def __init__(self, source, is_ours=True, size=(200, 150)):
        self.source = source
        self.mapper = vtkGatunSurfaceMapper() if is_ours else vtkPolyDataMapper()
        if hasattr(source, "GetOutputPort"):
            self.mapper.SetInputConnection(source.GetOutputPort())
        else:
            self.mapper.SetInputData(source)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(BACKGROUND)
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()

    def renew(self):
        """Another mapper of VTK with the same properties: it may show colors of before once scalars
        were hidden."""
        mapper = vtkPolyDataMapper()
        vtkMapper.ShallowCopy(mapper, self.mapper)
        mapper.SetInputDataObject(self.mapper.GetInput())
        self.mapper = mapper
        self.actor.SetMapper(mapper)

    def look(self, azimuth=0, elevation=0, zoom=1.0, bounds=None):
        self.camera.SetPosition(0, 0, 1)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 1, 0)
        self.camera.SetViewAngle(30)
        self.camera.Azimuth(azimuth)
        self.camera.Elevation(elevation)
        self.camera.OrthogonalizeViewUp()
        if bounds:
            self.renderer.ResetCamera(*bounds)
        else:
            self.renderer.ResetCamera()
        self.camera.Zoom(zoom)

    def render(self):
        self.window.Render()
        width, height = self.window.GetSize()
        data = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, data)
        return vtk_to_numpy(data).reshape(height, width, 4)[..., :3].astype(int)


def pair(path, whole=None, **options):
    """The same file drawn on demand by ours, and as a whole by VTK's mapper."""
    ours = Scene(pd.reader_of(path, LargeMesh=0))
    theirs = Scene(whole if whole else pd.read(path), False)
    return ours, theirs


def covered(picture):
    """The part of a picture that is not background."""
    return (picture != picture[0, 0]).any(-1).mean()


def require_equal(ours, theirs, what, share=0.0, least=0.02):
    """Pictures without a difference, but for a share of pixels."""
    theirs.renew()
    one, other = ours.render(), theirs.render()
    different = (np.abs(one - other) > 1).any(-1).mean()
    assert covered(other) > least, (what, "nothing there")
    assert different <= share, (what, different)
    return one
