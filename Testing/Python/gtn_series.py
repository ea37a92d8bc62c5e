# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series of meshes in `.gtn` files: sections 18.1, 18.2 and 18.4 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

from types import SimpleNamespace as Record

import numpy as np

from gtn_bytes import require
from gtn_tables import POINTS


def read_series(table, meta, steps):
    """Section TIME (18.1). steps: those of the first mesh. A list of steps with mesh, mask and
    time."""
    series, masks = [], []
    for _ in range(table.varint()):
        step = Record(mesh=table.varint())
        step.mask = table.varint()
        step.time = table.number("d")
        require(step.mesh <= len(masks), "number of a mesh")
        if step.mesh == len(masks):
            require(step.mask == 0, "mask of the first step of a mesh")
            masks.append(0)
        require(step.mask <= masks[step.mesh] + 1, "number of a mask")
        masks[step.mesh] = max(masks[step.mesh], step.mask)
        require(not series or step.time > series[-1].time, "order of the steps of all meshes")
        series.append(step)
    table.end()
    require(meta.has_time, "meshes without time")
    require(times_of(series, 0) == [step.time for step in steps], "steps of the first mesh")
    return series


def times_of(series, mesh):
    """Those of the steps of a mesh."""
    return [step.time for step in series if step.mesh == mesh]


def masks_of(series, mesh):
    """The number of masks of a mesh."""
    return max((step.mask for step in series if step.mesh == mesh), default=0)


def read_mask(table, meta, layout, cells, before):
    """A section LIVE (18.4): alive, a list of one value for each cell in the order of the file,
    drops, and points."""
    flags = table.number("B")
    require(flags <= 3, "flags of a mask")
    require(not flags & 1 or before is not None, "first mask")
    mask = Record(drops=flags & 2 != 0, cells=table.varint(), points=table.varint())
    if mask.drops:
        require(mask.points <= meta.points, "points of a mask")
    else:
        require(mask.points == meta.points, "points of a mask")
    if cells is not None:
        mask.types = {kind: table.varint() for kind in cells.types}
        require(all(mask.types[kind] <= cells.types[kind] for kind in mask.types), "types of a mask")
        require(sum(mask.types.values()) == mask.cells, "types of a mask")
    count = sum(chunk.tets if chunk.cells is None else chunk.cells.cells for chunk in layout.chunks)
    mask.alive = list(before.alive) if flags & 1 else [True] * count
    at = 0
    for i in range(table.varint()):
        length = table.varint()
        require(length >= 1 or i == 0, "empty run of a mask")
        require(at + length <= count, "runs of a mask")
        if i % 2:
            mask.alive[at : at + length] = [not alive for alive in mask.alive[at : at + length]]
        at += length
    table.end()
    require(sum(mask.alive) == mask.cells, "remaining cells")
    return mask


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


class RemainingMesh:
    """A mesh with the remaining cells of a mask, from 1; has what is asked of a decoder."""

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
