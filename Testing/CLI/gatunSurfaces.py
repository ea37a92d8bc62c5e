# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What the tests of isosurfaces share: reading surfaces of any format, and what is true of them."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {".vtp": vtkXMLPolyDataReader, ".stl": vtkSTLReader, ".ply": vtkPLYReader,
           ".obj": vtkOBJReader}


def read_surface(name):
    reader = READERS[name[name.rindex("."):]]()
    reader.SetFileName(name)
    if hasattr(reader, "MergingOff"):
        reader.MergingOff()
    reader.Update()
    return reader.GetOutput()


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).reshape(-1, 3)


def triangles_of(surface):
    """Three points each, of strips, too: every other triangle of these is turned."""
    polys = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    strips = surface.GetStrips()
    ids = vtk_to_numpy(strips.GetConnectivityArray())
    offsets = vtk_to_numpy(strips.GetOffsetsArray())
    parts = [polys]
    for begin, end in zip(offsets[:-1], offsets[1:]):
        strip = ids[begin:end]
        three = np.stack([strip[:-2], strip[1:-1], strip[2:]], axis=1)
        three[1::2] = three[1::2, [1, 0, 2]]
        parts.append(three)
    return np.concatenate(parts)


def places_of(surface):
    """The coordinates of the corners of each triangle."""
    return points_of(surface)[triangles_of(surface)]


def area_of(surface):
    a, b, c = np.moveaxis(places_of(surface).astype(np.float64), 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def is_closed(surface):
    """Whether each edge has a triangle on either side, turned as it should be."""
    triangles = triangles_of(surface)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges = edges[np.lexsort(edges.T)]
    back = edges[:, ::-1]
    return len(np.unique(edges, axis=0)) == len(edges) and \
        np.array_equal(edges, back[np.lexsort(back.T)])


def holes_of(surface):
    """Points, less edges, and triangles: 2 of a sphere."""
    triangles = triangles_of(surface)
    return len(np.unique(triangles)) - len(triangles) // 2
