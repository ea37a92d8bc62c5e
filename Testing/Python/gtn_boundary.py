# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Boundaries in `.gtn` files: section 17 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

from collections import Counter

from gtn_bytes import require
from gtn_shapes import CYCLES, FLAT, PIXEL, STRIP, SURFACES
from gtn_tables import CELLS, POINTS

POLYHEDRON, POLYLINE = 42, 4
VERTICES, CURVES = (1, 2), (3, 4, 21, 35, 68, 75)


def open_boundary(whole, make):
    """The boundary in a file, which must fit it (17.1). make: a decoder from bytes."""
    boundary = make(whole.container.boundary)
    one, other = whole.meta, boundary.meta
    require(boundary.container.is_surface, "boundary that is no surface")
    require(other.points <= one.points, "points of a boundary")
    require(other.coordinate_type == one.coordinate_type, "coordinates of a boundary")
    require(other.has_time == one.has_time and other.arrays == one.arrays, "arrays of a boundary")
    times = [[step.time for step in decoder.steps] for decoder in (whole, boundary)]
    require(times[0] == times[1], "steps of a boundary")
    if boundary.container.tree is not None:
        require(whole.container.tree is not None, "merges of a boundary, but not of the mesh")
    return boundary


def faces_of(kind, corners, faces):
    """The faces of a 3D cell; none of others."""
    if kind == POLYHEDRON:
        return faces
    return [[corners[place] for place in face] for face in SURFACES.get(kind, ())]


def flat_cell(kind, corners):
    """The corners of a cell of a lower dimension, or None."""
    if kind in VERTICES:
        return corners
    if kind in CURVES and len(corners) >= 2:
        return corners if kind == POLYLINE else corners[:2]
    if kind == PIXEL:
        return [corners[place] for place in (0, 1, 3, 2)]
    if kind == STRIP:
        return corners
    return corners[: CYCLES.get(kind, len(corners))] if kind in FLAT else None


def boundary_cells(cells):
    """The corners of each cell of the boundary of some cells, and the cell that it comes from (17.2)."""
    found, count = [], Counter()
    for number, (kind, corners, faces) in enumerate(cells):
        flat = flat_cell(kind, list(corners))
        if flat is not None:
            found.append((None, flat, number))
        for face in faces_of(kind, corners, faces):
            if len(set(face)) >= 3:
                count[frozenset(face)] += 1
                found.append((frozenset(face), list(face), number))
    return [(corners, number) for key, corners, number in found if key is None or count[key] == 1]


def described(decoder, cells):
    """How often there is each cell, by all that is known of its points and of where it is from."""
    steps = range(len(decoder.steps))
    values = {where: [decoder.array(step, i) for step in steps
                      for i, array in enumerate(decoder.meta.arrays) if array.where == where]
              for where in (POINTS, CELLS)}
    points = decoder.points()

    def row(arrays, i):
        return b"|".join(array[i].tobytes() for array in arrays)

    result = Counter()
    for corners, number in cells:
        keys = [row([points, *values[POINTS]], point) for point in corners]
        first = keys.index(min(keys)) if keys else 0
        result[tuple(keys[first:] + keys[:first]), row(values[CELLS], number)] += 1
    return result


def check_boundary(whole, boundary):
    """Whether the boundary in a file is that of its mesh, with all values."""
    kept = [(list(corners), i) for i, (_, corners, _) in enumerate(boundary.cells())]
    require(described(boundary, kept) == described(whole, boundary_cells(whole.cells())),
            "boundary of another mesh")
