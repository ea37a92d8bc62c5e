# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Small meshes of Lagrange and Bezier cells, for the independent decoder."""

import numpy as np

from gatunCellMeshes import bent, cubes, grid_of, outer
from gtn_lattice import (
    HEXAHEDRON, QUADRILATERAL, SHAPES, TETRAHEDRON, TRIANGLE, WEDGE, points_of, shape_of)
from gtn_shapes import SURFACES

PARTS = {
    HEXAHEDRON: [list(range(8))], WEDGE: [[0, 2, 1, 4, 6, 5], [0, 3, 2, 4, 7, 6]],
    TETRAHEDRON: [[0, a, b, 6] for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))],
    QUADRILATERAL: [[0, 1, 2, 3]], TRIANGLE: [[0, 1, 2], [0, 2, 3]]}


class OrderPoints:
    """Points of cells, by the corners that they lie between."""

    def __init__(self, points):
        self.points = [np.array(point, float) for point in points]
        self.found = {}

    def cell(self, shape, order, corners):
        """All points of a cell."""
        ids = list(corners)
        for point in points_of(shape, order)[len(corners):]:
            weights = self._weights(shape, order, point)
            key = tuple(sorted((c, w) for c, w in zip(corners, weights) if w))
            if key not in self.found:
                place = sum(w * self.points[c] for c, w in key) / sum(w for _, w in key)
                self.found[key] = len(self.points)
                self.points.append(place)
            ids.append(self.found[key])
        return ids

    @staticmethod
    def _weights(shape, order, point):
        """Those of the corners, without common divisors."""
        i, j, k = point
        rest = order - i - j
        if shape in (TRIANGLE, TETRAHEDRON):
            weights = [rest - k, i, j, k][: len(SHAPES[shape][0])]
        elif shape == WEDGE:
            weights = [w * t for t in (order - k, k) for w in (rest, i, j)]
        else:
            weights = []
            for corner in SHAPES[shape][0]:
                weight = 1
                for x, c in zip(point, corner):
                    weight *= x if c else order - x
                weights.append(weight)
        divisor = np.gcd.reduce(weights)
        return [int(w // divisor) for w in weights]


def solids(rng, kind, orders, n=(3, 2, 2)):
    """Cells of one type and of these orders in turn, with faces on them."""
    points, boxes = cubes(n)
    added = OrderPoints(points)
    shape = shape_of(kind)
    cells, faces = [], []
    for i, box in enumerate(boxes):
        order = orders[i % len(orders)]
        for part in PARTS[shape]:
            corners = [box[c] for c in part]
            cells.append((kind, added.cell(shape, order, corners)))
            faces += [([corners[c] for c in face], order) for face in SURFACES[kind]]
    border = {tuple(face) for face in outer([face for face, _ in faces])}
    first = kind - shape
    for i, (face, order) in enumerate(faces):
        if tuple(face) in border and i % 5:
            of_face = TRIANGLE if len(face) == 3 else QUADRILATERAL
            cells.append((first + of_face, added.cell(of_face, order, face)))
    return grid_of(bent(np.array(added.points), rng, 0.02), cells, rng)


def shell(rng, kind, order, n=5):
    """A surface of one type, and a curve."""
    points, boxes = cubes((n, n, 1))
    added = OrderPoints(points)
    shape = shape_of(kind)
    cells = [(kind, added.cell(shape, order, [box[c] for c in part]))
             for box in boxes for part in PARTS[shape]]
    cells.append((kind - shape, cells[0][1][:2] + cells[1][1][-1:]))
    return grid_of(bent(np.array(added.points), rng), cells, rng)
