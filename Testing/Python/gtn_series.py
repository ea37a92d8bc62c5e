# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series of meshes in `.gtn` files: sections 18.2 and 18.4 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import numpy as np

from gtn_container import POINTS, masks_of, require, times_of


def open_mesh(whole, number, make):
    """Another mesh, which must fit the first one. make: a decoder from bytes."""
    mesh = make(whole.container.meshes[number - 1])
    require(mesh.container.series is None, "meshes of a mesh")
    require(mesh.meta.has_time and mesh.meta.arrays == whole.meta.arrays, "arrays of a mesh")
    require(mesh.container.is_surface == whole.container.is_surface, "kind of a mesh")
    times = times_of(whole.container.series, number)
    require([step.time for step in mesh.steps] == times, "steps of a mesh")
    require(len(mesh.container.masks) == masks_of(whole.container.series, number), "masks of a mesh")
    return mesh


class LivingMesh:
    """A mesh with the living cells of a mask, from 1; has what is asked of a decoder."""

    def __init__(self, decoder, number):
        self.decoder, self.container = decoder, decoder.container
        self.meta, self.steps = decoder.meta, decoder.steps
        mask = decoder.container.masks[number - 1]
        self._alive = np.array(mask.alive, bool)
        self._kept = np.full(self.meta.points, not mask.drops)
        cells = decoder.cells()
        for cell, alive in zip(cells, mask.alive):
            for point in points_of(cell) if alive and mask.drops else []:
                self._kept[point] = True
        require(self._kept.sum() == mask.points, "points of a mask")
        if decoder.container.cells is not None:
            kinds = [cell[0] for cell, alive in zip(cells, mask.alive) if alive]
            require(all(kinds.count(k) == n for k, n in mask.types.items()), "types of a mask")

    def _flags(self, is_of_points, restore):
        """Which points or cells there are, in the order of the file or the original one."""
        flags, order = ((self._kept, self.decoder.point_order) if is_of_points
                        else (self._alive, self.decoder.cell_order))
        if not restore or order is None:
            return flags
        result = np.empty_like(flags)
        result[order] = flags
        return result

    def points(self, restore=False, step=0):
        return self.decoder.points(restore, step)[self._flags(True, restore)]

    def cells(self, restore=False):
        numbers = (np.cumsum(self._flags(True, restore)) - 1).tolist()
        cells = []
        for cell, alive in zip(self.decoder.cells(restore), self._flags(False, restore)):
            if alive:
                kind, corners, faces = cell
                faces = faces and [[numbers[point] for point in face] for face in faces]
                cells.append((kind, [numbers[point] for point in corners], faces))
        return cells

    def tets(self, restore=False):
        return np.array([corners for _, corners, _ in self.cells(restore)], np.int64).reshape(-1, 4)

    def array(self, step, number, restore=False):
        is_of_points = self.meta.arrays[number].where == POINTS
        return self.decoder.array(step, number, restore)[self._flags(is_of_points, restore)]

    def field_data(self, step):
        return self.decoder.field_data(step)


def points_of(cell):
    """Those that a cell uses, with those of the faces of a polyhedron."""
    _, corners, faces = cell
    return corners + [point for face in faces or [] for point in face]
