#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder of `.gtn` files written from Documentation/format.md and cell-codec.md alone, to prove
that these texts suffice. It is slow (thousands of tetrahedra a second), and checks all that it reads.

Here is the whole mesh in its numbering: section 4. As a program it prints what a file holds:

    gtn_decoder.py FILE...
"""

import sys
from collections import Counter
from functools import partial

import numpy as np

from gtn_arrays import ChunkMesh, decode_list, decode_palette
from gtn_boundary import open_boundary
from gtn_bounds import read_bound
from gtn_bytes import BINARY, BOUND, PALETTE, SHIFT, Bytes, FormatError, require
from gtn_coding import (
    FLOAT32, FLOAT64, UINT32, UINT64, Decimals, Domain, Multiples, Shift)
from gtn_container import Container
from gtn_dependencies import decode_all_dependencies
from gtn_quadratic import Lists, find_block_neighbors
from gtn_series import open_mesh
from gtn_shapes import Shapes
from gtn_steps import is_copy
from gtn_tables import CELLS, KEEP_CELLS, KEEP_CORNERS, KEEP_POINTS, POINTS
from gtn_tree import SimplerMesh, decode_parts, open_level

TYPES = {1: "<i1", 2: "<u1", 3: "<i2", 4: "<u2", 5: "<i4", 6: "<u4", 7: "<i8", 8: "<u8",
         FLOAT32: "<f4", FLOAT64: "<f8"}

class Decoder:
    """A file with its whole mesh; arrays are decoded when they are asked for.

    All that is given out is in the file's own order (section 4) or, with restore, in the original
    one as far as the file keeps it.
    """

    def __init__(self, data, whole=None, part=0):
        """whole, part: of a base mesh, the decoder of its file, and the part of the merges that is
        the first one of this mesh."""
        self.container = Container(data)
        self.meta, self.table = self.container.meta, self.container.table
        self.steps = self.container.steps
        coordinate_type = self.meta.coordinate_type
        self.domains = [self._domain(coordinate_type, domain) for domain in self.table.domains]
        cells = self.container.cells
        shapes = None if cells is None else Shapes(cells.shapes)
        self._values = {}

        self.block_points = []  # global number of the first point of each block
        users = []  # chunks that use each of the shared points
        for block in self.table.blocks:
            self.block_points.append(len(users))
            for group in block.groups:
                users += [group.chunks] * group.points
        first_own = len(users)

        coordinates = self._decode_blocks([b.coordinates for b in self.table.blocks], self.domains)
        self._shared_places = [
            [domain.to_value(k) for domain, k in zip(self.domains, key)]
            for key in zip(*coordinates)]
        self._block_lists = {}
        shared_of = [[] for _ in self.table.chunks]
        for point, chunks in enumerate(users):
            for chunk in chunks:
                shared_of[chunk].append((point, chunks))
        self.chunks = []
        self.first_own = []
        for number, shared in enumerate(shared_of):
            keys = [tuple(axis[point] for axis in coordinates) for point, _ in shared]
            self.chunks.append(
                ChunkMesh(self.container, number, self.domains, shared, keys, shapes))
            self.first_own.append(first_own)
            first_own += self.table.chunks[number].own_points

        if cells is not None:
            kinds = Counter(kind for chunk in self.chunks for kind, _, _ in chunk.cells())
            require(kinds == cells.types, "cells of the types")
        unused = self._decode_unused(self.table.unused.coordinates, self.domains)
        for axis in range(3):
            for chunk in self.chunks:
                coordinates[axis] += [chunk.walk.keys[v][axis] for v in chunk.own]
            coordinates[axis] += unused[axis]
        self._coordinates = coordinates
        self._mesh_places = ArrayValues()
        self._mesh_places.domains = self.domains
        self._mesh_places.shared = [keys[:len(users)] for keys in coordinates]
        self._mesh_places.unused = unused
        self._mesh_places.chunks = [
            [[key[axis] for key in chunk.walk.keys] for axis in range(3)] for chunk in self.chunks]
        self._decode_original_order()
        self.merges, self.bonds = [], []  # whether each merge is bound, of a surface
        self.dependencies = None
        if self.container.tree is not None:
            require((whole is None) == bool(self.container.tree.parts), "parts of merges")
            self.merges, self.bonds = decode_parts(whole or self, part)
            self.dependencies = decode_all_dependencies(whole or self, part)

    # ----- The mesh

    def points(self, restore=False, step=0):
        values = self._places(self._place_step(step))
        keys = values.shared
        if values is not self._mesh_places:
            keys = [shared + [of_chunk[c][v] for chunk, of_chunk in zip(self.chunks, values.chunks)
                              for v in chunk.own] + unused
                    for c, (shared, unused) in enumerate(zip(values.shared, values.unused))]
        else:
            keys = self._coordinates
        points = as_array(values.domains, keys)
        return self._restore(points, self.point_order) if restore else points

    def _place_step(self, step):
        """The step that has the coordinates of a step; 0 is the mesh (3.4)."""
        while step > 0 and not (step < len(self.steps) and self.steps[step].moves):
            step -= 1
        return step

    def _places(self, s):
        """Keys of coordinates at step s, which has them, and before that where they come from."""
        if s == 0:
            return self._mesh_places
        number = len(self.meta.arrays)
        if (s, number) not in self._values:
            reference, key = self._place_step(s - 1), s
            while not self.steps[key].key:
                key -= 1
            before = self._places(reference if reference >= key else 0)
            at = self.steps[s].arrays[number]
            domains = [self._domain(self.meta.coordinate_type, domain) for domain in at.domains]
            self._values[s, number] = self._decode_array_after(
                self.steps[s], number, before.convert(domains))
        return self._values[s, number]

    def cells(self, restore=False):
        """Type, points and, of polyhedra, faces of each cell."""
        cells = []
        for chunk, numbers in zip(self.chunks, self._numbers()):
            for kind, corners, faces in chunk.original_cells if restore else chunk.cells():
                if faces is not None:
                    faces = [[numbers[v] for v in face] for face in faces]
                cells.append((kind, [numbers[v] for v in corners], faces))
        if restore and self.point_order is not None:
            order = self.point_order
            cells = [(kind, [order[point] for point in corners],
                      faces and [[order[point] for point in face] for face in faces])
                     for kind, corners, faces in cells]
        if not restore or self.cell_order is None:
            return cells
        result = [None] * len(cells)
        for cell, place in zip(cells, self.cell_order):
            result[place] = cell
        return result

    def tets(self, restore=False):
        """The points of each tetrahedron; those of cells of other types (15.3), too. Only cells that
        are tetrahedra have an original order."""
        if restore:
            require(self.container.cells is None, "original tetrahedra of a file of cells")
            tets = [corners for _, corners, _ in self.cells(True)]
        else:
            tets = [[numbers[v] for v in tet]
                    for chunk, numbers in zip(self.chunks, self._numbers())
                    for _, tet in chunk.tets()]
        return np.array(tets, np.int64).reshape(-1, 4)

    def cells_of_tets(self):
        """The cell that each tetrahedron is in."""
        cells, first = [], 0
        for chunk in self.chunks:
            cells += [first + cell for cell, _ in chunk.tets()]
            first += len(chunk.walk.parents)
        return cells

    def _numbers(self):
        """Global point numbers of the vertices of each chunk."""
        for chunk, first in zip(self.chunks, self.first_own):
            numbers = list(chunk.walk.shared)
            for i, v in enumerate(chunk.own):
                numbers[v] = first + i
            for v, index in enumerate(chunk.walk.shared):
                if index is not None:
                    numbers[v] = chunk.shared_points[index]
            yield numbers

    # ----- Arrays

    def array(self, step, number, restore=False):
        """Values (tuples, components) of an array at a step."""
        array = self.meta.arrays[number]
        values = self._decode_array(step, number)
        keys = [[] for _ in range(array.components)]
        for c, part in enumerate(keys):
            if array.where == POINTS:
                part += values.shared[c]
                for chunk, of_chunk in zip(self.chunks, values.chunks):
                    part += [of_chunk[c][v] for v in chunk.own]
                part += values.unused[c]
            else:
                for of_chunk in values.chunks:
                    part += of_chunk[c]
        result = as_array(values.domains, keys)
        order = self.point_order if array.where == POINTS else self.cell_order
        return self._restore(result, order) if restore else result

    def field_data(self, step):
        return self.container.field_data(self.steps[step])

    def _decode_array(self, s, number):
        """Keys of an array at step s and, before that, at those that it depends on."""
        if (s, number) not in self._values:
            step = self.steps[s]
            before = None if step.key else self._decode_array(s - 1, number)
            self._values[s, number] = self._decode_array_after(step, number, before)
        return self._values[s, number]

    def _decode_array_after(self, step, number, before):
        array, at = self.meta.all_arrays[number], step.arrays[number]
        values = ArrayValues()
        if is_copy(at):
            source = self._decode_array(self.steps.index(step), at.domains[0].array)
            values.copy(source, [domain.component for domain in at.domains])
            return values
        values.domains = [self._domain(array.type, domain) for domain in at.domains]
        values.scales = [
            None if domain is None or domain.kind == BOUND
            else (domain.kind, domain.digits, domain.first)
            for domain in at.domains if domain is None or domain.kind != PALETTE]
        is_points = number == len(self.meta.arrays)  # before is in these domains then
        if not is_points and (
                len(values.scales) < array.components or before and before.scales != values.scales):
            before = None  # of a copy, scales are no list
        if array.where == POINTS:
            old = before and before.shared
            values.shared = self._decode_blocks(at.blocks, values.domains, old, True)
            values.unused = self._decode_unused(at.unused, values.domains, before and before.unused)
        for i, (chunk, reference) in enumerate(zip(self.chunks, at.chunks)):
            stream = self._stream(reference)
            old = before and before.chunks[i]
            if array.where == POINTS:
                shared = [[keys[p] for p in chunk.shared_points] for keys in values.shared]
                decoded = chunk.decode_points(stream, values.domains, shared, old)
            else:
                parents = chunk.walk.parents
                decoded = decode_list(
                    stream, values.domains, len(parents), old, parents, chunk.cell_lists)
            values.chunks.append(decoded)
        return values

    # ----- Parts

    def _stream(self, reference):
        return None if reference is None else self.container.stream(reference)

    def _domain(self, kind, palette):
        plain = Domain(kind)
        if palette is None:
            return plain
        if palette.kind == BOUND:
            plain.bound = read_bound(Bytes(palette.bytes), kind)
            return plain
        if palette.kind == SHIFT:
            return Domain(kind, None, (Shift, palette.digits))
        if palette.kind == BINARY:
            return Domain(kind, None, (Multiples, palette.first))
        if palette.kind != PALETTE:
            return Domain(kind, None, (Decimals, palette.digits, palette.first))
        keys = decode_palette(self._stream(palette.stream), plain, palette.entries)
        require(all(a < b for a, b in zip(keys, keys[1:])), "palette does not ascend")
        return Domain(kind, keys)

    def _lists_of_block(self, first, last):
        """Those of shared points for the mode quadratic."""
        if first not in self._block_lists:
            places = self._shared_places[first:last]
            self._block_lists[first] = Lists(
                find_block_neighbors(places), range(len(places)), places)
        return self._block_lists[first]

    def _decode_blocks(self, references, domains, before=None, are_values=False):
        """Keys of each component on all shared points. before: the same at the step before.
        are_values: of an array, not of the mesh."""
        result = [[] for _ in domains]
        for block, reference, first in zip(self.table.blocks, references, self.block_points):
            last = first + block.points
            old = before and [keys[first:last] for keys in before]
            lists = partial(self._lists_of_block, first, last) if are_values else None
            decoded = decode_list(
                self._stream(reference), domains, block.points, old, lists=lists)
            for keys, more in zip(result, decoded):
                keys += more
        return result

    def _decode_unused(self, reference, domains, before=None):
        return decode_list(self._stream(reference), domains, self.meta.unused_points, before)

    # ----- Simpler meshes

    def after(self, n):
        """The mesh after n merges, in the file's own order."""
        require(0 <= n <= len(self.merges), "number of merges")
        return SimplerMesh(self, n)

    def level(self, number):
        """A base mesh, as a decoder of its own."""
        return open_level(self, number, Decoder)

    def boundary(self):
        """The boundary in the file, as a decoder of its own, or None."""
        return None if self.container.boundary is None else open_boundary(self, Decoder)

    def mesh(self, number):
        """Another mesh of a series, from 1, as a decoder of its own."""
        return open_mesh(self, number, Decoder)

    def stream(self, reference):
        """The bytes of a stream, whose checksum is right."""
        return self._stream(reference)

    # ----- Original order

    def _decode_original_order(self):
        """Sets point_order and cell_order (original numbers, or None); corners of chunks."""
        self.point_order = self.cell_order = None
        if self.meta.keep & KEEP_POINTS:
            numbers = [Domain(UINT32 if self.meta.points < 2**32 else UINT64)]
            shared = self._decode_blocks([b.original for b in self.table.blocks], numbers)
            order = list(shared[0])
            for chunk, entry in zip(self.chunks, self.table.chunks):
                known = [[shared[0][point] for point in chunk.shared_points]]
                keys = chunk.decode_points(self._stream(entry.original_points), numbers, known)[0]
                order += [keys[v] for v in chunk.own]
            order += self._decode_unused(self.table.unused.original, numbers)[0]
            self.point_order = permutation(order)
        if self.meta.keep & KEEP_CELLS:
            types = self.container.cells and self.container.cells.types
            cells = sum(types.values()) if types else self.meta.tets
            numbers = [Domain(UINT32 if cells < 2**32 else UINT64)]
            references = [entry.original_cells for entry in self.table.chunks]
            self.cell_order = permutation(self._decode_cells(references, numbers))
        for chunk, entry in zip(self.chunks, self.table.chunks):
            keeps = self.meta.keep & KEEP_CORNERS
            chunk.restore_corners(self._stream(entry.corners) if keeps else None, keeps)

    def _decode_cells(self, references, domains):
        result = []
        for chunk, reference in zip(self.chunks, references):
            parents = chunk.walk.parents
            result += decode_list(
                self._stream(reference), domains, len(parents), None, parents)[0]
        return result

    @staticmethod
    def _restore(values, order):
        if order is None:
            return values
        result = np.empty_like(values)
        result[order] = values
        return result


class ArrayValues:
    """Keys of an array at a step; of point arrays chunks have those of all vertices."""

    def __init__(self):
        self.domains = []
        self.scales = []
        self.shared = None
        self.unused = None
        self.chunks = []

    def convert(self, domains):
        """The same values in other domains, which must have them."""
        result = ArrayValues()
        result.domains = domains

        def change(keys):
            return [[to_key(domain, old.plain(key)) for key in part]
                    for part, old, domain in zip(keys, self.domains, domains)]

        result.shared, result.unused = change(self.shared), change(self.unused)
        result.chunks = [change(keys) for keys in self.chunks]
        return result

    def copy(self, source, components):
        """Becomes a copy of components of another array."""
        def select(keys):
            return keys and [keys[c] for c in components]

        self.domains = select(source.domains)
        self.scales = None
        self.shared, self.unused = select(source.shared), select(source.unused)
        self.chunks = [select(keys) for keys in source.chunks]


def to_key(domain, plain):
    """The key of a plain key, by bisection: both are in the order of the values."""
    if domain.scale is None:
        return plain
    low, high = 0, domain.scale.last
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if domain.plain(middle) >= plain else (middle + 1, high)
    require(domain.plain(low) == plain, "a coordinate that is not on the scale of the next step")
    return low


def permutation(numbers):
    require(sorted(numbers) == list(range(len(numbers))), "original numbers are no permutation")
    return numbers


def as_array(domains, keys):
    """Keys of each component as an array (tuples, components) of numpy."""
    kind = np.dtype(TYPES[domains[0].kind])
    columns = [np.frombuffer(d.to_bytes(k), kind) for d, k in zip(domains, keys)]
    return np.ascontiguousarray(np.stack(columns, axis=1))


def main(names):
    for name in names:
        with open(name, "rb") as file:
            decoder = Decoder(file.read())
        decoder.container.verify_layout()
        meta = decoder.meta
        print(name, "points", meta.points, "cells", len(decoder.cells()), "tetrahedra", meta.tets,
              "chunks", len(decoder.chunks), "steps", len(decoder.steps))
        for s, step in enumerate(decoder.steps):
            for i, array in enumerate(meta.arrays):
                values = decoder.array(s, i, restore=True)
                where = "cells" if array.where == CELLS else "points"
                print("  time", step.time, where, repr(array.name), values.dtype, values.shape)
            for array in decoder.field_data(s):
                print("  time", step.time, "field data", repr(array.name))
        if decoder.container.tree is not None:
            levels = decoder.container.tree.levels
            print("  merges", len(decoder.merges), "base meshes after", levels)
            print("  tetrahedra after all merges", len(decoder.after(len(decoder.merges)).tets))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, FormatError) as error:
        sys.exit("gtn_decoder.py: %s" % error)
