# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Merge trees and base meshes of `.gtn` files: section 13 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import struct
from types import SimpleNamespace as Record

import numpy as np

from gtn_bytes import Bytes, require
from gtn_coding import Coded
from gtn_tables import POINTS

MAX_MERGE_COUNTS = MAX_LEVELS = 64
INFINITY_KEY = 0x7F80
TRIANGLE = 5


def read_tree(table, meta, layout, is_surface):
    """Section TREE (13.2)."""
    require(meta.points < 1 << 32, "too many points for merges")
    tree = Record(merges=table.varint())
    unused = 0 if is_surface else meta.unused_points
    require(tree.merges <= meta.points - unused, "more merges than points")

    def ascending(most):
        count = table.varint()
        require(count <= most, "too many merge counts or base meshes")
        numbers = [table.varint() for _ in range(count)]
        require(all(a < b for a, b in zip([0] + numbers, numbers)), "numbers do not ascend")
        require(not numbers or numbers[-1] <= tree.merges, "number of merges")
        return numbers

    tree.levels = ascending(MAX_LEVELS)
    count = table.varint()
    require(count in (0, len(tree.levels) + 1), "parts of merges")
    limits = [0, *tree.levels, tree.merges]
    tree.parts = []
    for first, end in zip(limits[:count], limits[1:]):
        part = Record(points=table.varint(), merges=end - first, all_points=meta.points - first)
        part.stream, part.map, part.dependencies = (table.reference() for _ in range(3))
        require(part.points == meta.points - unused if first == 0 else part.points <= part.all_points,
                "points of a part")
        require(part.merges <= part.points, "merges of a part")
        require((part.stream is None) == (part.merges == 0), "stream of merges")
        require((part.map is None) == (len(tree.parts) + 1 == count), "numbers of points")
        tree.parts.append(part)
    tree.merge_counts = ascending(MAX_MERGE_COUNTS)
    require(tree.merges == 0 or tree.merge_counts and tree.merge_counts[-1] == tree.merges, "last merge count")
    tree.boxes = [[table.ranges(3) for _ in tree.merge_counts] for _ in layout.chunks]
    table.end()
    return tree


def read_tree_step(table, meta, layout, tree):
    """A section TRNG (13.4): ranges by array, None for those of cells, chunk and merge count."""
    result = []
    for array in meta.all_arrays:
        count = array.components + (array.components > 1)
        of_points = array.where == POINTS
        result.append([[table.ranges(count) for _ in tree.merge_counts] for _ in layout.chunks]
                      if of_points else None)
    table.end()
    return result


class Distances:
    """distance() of 13.3."""

    def __init__(self, coded):
        self.coded = coded
        self.before = 0

    def next(self):
        length = self.coded.tree(6, "length", self.before // 4)
        require(length <= 33, "length of a distance")
        self.before = length
        if length == 0:
            return 0
        negative = self.coded.decide("sign", length)
        value = 1
        if length > 1:
            value = 2 + self.coded.decide("second", length) << length - 2
            value += self.coded.raw(length - 2)
        return -value if negative else value


def block_sizes(points, merges):
    """The number of merges of each block, and of points left when its section begins (13.3)."""
    k = 0
    while k < merges:
        left = points - k
        end = min(merges, k + (left if left < 4096 else left - left // 2))
        while k < end:
            yield min(131072, end - k), left
            k += min(131072, end - k)


def decode_block(data, count, left, bonds):
    """Of each merge of a block: two places among the points left, key, whether it begins a round."""
    coded = Coded(Bytes(data))
    distances = Distances(coded)
    key = 0
    result = []
    while len(result) < count:
        run = 1 + coded.large("run")
        begins = coded.decide("round")
        key += coded.large("growth")
        require(run <= count - len(result), "run of merges")
        require(key <= INFINITY_KEY, "key of a merge")
        place = -1
        for _ in range(run):
            place += 1 + coded.large("skipped", (left // run).bit_length())
            d = distances.next()
            require(place < left and 0 <= place + d < left, "place of a point")
            result.append((place, place + d, key, begins))
            begins = 0
            if bonds is not None:
                bonds.append(coded.decide("bond"))
    return result


def decode_merges(stream, points, merges, bonds=None):
    """Triples of point, into and error (13.3). bonds: a list that gets, of a surface, whether each
    merge is bound to the next one."""
    require(len(stream) >= merges // 256, "stream of merges too short")
    table = Bytes(stream)
    blocks = list(block_sizes(points, merges))
    lengths = [table.varint() for _ in blocks]
    left = list(range(points))
    gone = set()
    result = []
    last = 0
    for (count, in_section), length in zip(blocks, lengths):
        if len(left) != in_section:
            left = [point for point in left if point not in gone]
        for place, into, key, _ in decode_block(table.take(length), count, in_section, bonds):
            point, into = left[place], left[into]
            require(point != into and point not in gone and into not in gone, "merge of no point")
            require(key >= last, "errors do not ascend")
            last = key
            gone.add(point)
            result.append((point, into, struct.unpack("<f", struct.pack("<I", key << 16))[0]))
    require(not bonds or not bonds[-1], "bond of the last merge")
    return result


def decode_map(stream, points):
    """Numbers of points in a base mesh (13.3)."""
    steps = Distances(Coded(Bytes(stream)))
    result = []
    number = -1
    for _ in range(points):
        number += 1 + steps.next()
        result.append(number)
    require(sorted(result) == list(range(points)), "numbers of points")
    return result


def decode_parts(whole, first):
    """The merges of a file from a part on, in the numbers of the mesh of that part, and whether each
    is bound to the next one (13.2). whole: the decoder of the file."""
    is_surface = whole.container.is_surface
    merges, bonds = [], []
    for part in reversed(whole.container.tree.parts[first:]):
        own_bonds = [] if is_surface else None
        own = [] if part.stream is None else decode_merges(
            whole.stream(part.stream), part.points, part.merges, own_bonds)
        if part.map is not None:
            gone = {point for point, _, _ in own}
            left = [point for point in range(part.all_points) if point not in gone]
            number_of = dict(zip(decode_map(whole.stream(part.map), len(left)), left))
            require(not merges or not own or own[-1][2] <= merges[0][2], "errors do not ascend")
            merges = [(number_of[point], number_of[into], error) for point, into, error in merges]
        merges = own + merges
        bonds = (own_bonds or []) + bonds
    return merges, bonds


def find_ancestors(points, merges):
    """Of each point, after these merges (13.1)."""
    ancestors = list(range(points))
    for point, into, _ in reversed(merges):
        ancestors[point] = ancestors[into]
    return ancestors


class SimplerMesh:
    """What is left of the mesh of a decoder after n merges, in the file's own order (13.1).

    kept: global numbers of the points that are left; cells: of the tetrahedra, or of a surface;
    tets: corners by their place in kept; types: of the cells of a surface, else None.
    """

    def __init__(self, decoder, n):
        self.decoder = decoder
        ancestors = find_ancestors(decoder.meta.points, decoder.merges[:n])
        self.kept = [i for i, ancestor in enumerate(ancestors) if i == ancestor]
        places = {point: place for place, point in enumerate(self.kept)}
        self.cells, tets, self.types = [], [], None
        if decoder.container.is_surface:
            self.types, self.tets = [], []
            for cell, (kind, points, _) in enumerate(decoder.cells()):
                corners = [ancestors[point] for point in points]
                if kind != TRIANGLE or len(set(corners)) == len(set(points)):
                    self.cells.append(cell)
                    self.types.append(kind)
                    self.tets.append([places[point] for point in corners])
            return
        for cell, tet in zip(decoder.cells_of_tets(), decoder.tets().tolist()):
            corners = [ancestors[point] for point in tet]
            if len(set(corners)) == 4:
                self.cells.append(cell)
                tets.append([places[point] for point in corners])
        self.tets = np.array(tets, np.int64).reshape(-1, 4)

    def points(self):
        return self.decoder.points()[self.kept]

    def array(self, step, number):
        where = self.decoder.meta.arrays[number].where
        return self.decoder.array(step, number)[self.kept if where == POINTS else self.cells]


def find_paths(points, merges):
    """Of each point, the set of what it is merged into by these merges, itself included (13.1)."""
    paths = [{i} for i in range(points)]
    for point, into, _ in reversed(merges):
        paths[point] |= paths[into]
    return paths


def values_of(decoder, step, array):
    """Those of an array of TRNG, with the lengths of tuples; the last one are coordinates (3.6)."""
    if array < len(decoder.meta.arrays):
        return with_lengths(decoder.array(step, array))
    places = with_lengths(decoder.points(False, step).astype(float))
    return np.where(np.isfinite(places), places, np.nan)


def check_ranges(decoder):
    """Whether the ranges of TREE and TRNG enclose what they are said to enclose, and nothing else."""
    tree = decoder.container.tree
    for count, n in enumerate(tree.merge_counts):
        paths = find_paths(decoder.meta.points, decoder.merges[:n])
        for c, chunk in enumerate(decoder.chunks):
            first = decoder.first_own[c]
            own = range(first, first + len(chunk.own))
            path = sorted(set().union(*(paths[i] for i in [*chunk.shared_points, *own])))
            places = decoder.points()[path].astype(float)
            check_tight(tree.boxes[c][count], np.where(np.isfinite(places), places, np.nan))
            for s, ranges in enumerate(tree.ranges):
                for a, of_array in enumerate(ranges):
                    if of_array is not None:
                        check_tight(of_array[c][count], values_of(decoder, s, a)[path])


def with_lengths(values):
    """Components as numbers, and the lengths of tuples of two and more (3.1)."""
    numbers = [[float(x) for x in row] for row in values]
    if values.shape[1] > 1:
        for row in numbers:
            total = 0.0
            for x in row:
                total += x * x
            row.append(math.sqrt(total))
    return np.array(numbers)


def check_tight(ranges, columns):
    for (low, high), column in zip(ranges, columns.T):
        column = column[~np.isnan(column)]
        tight = (column.min(), column.max()) if len(column) else (1e300, -1e300)
        require((low, high) == tight, "range after merges")


def open_level(whole, number, make):
    """A base mesh, which must be one of this file (13.6). make: a decoder from bytes."""
    level = make(whole.container.tree.files[number], whole, number + 1)
    merges = whole.container.tree.levels[number]
    one, other = whole.meta, level.meta
    require(other.points == one.points - merges, "points of a base mesh")
    require(other.unused_points >= one.unused_points, "unused points of a base mesh")
    require(other.tets <= one.tets, "tetrahedra of a base mesh")
    require(other.coordinate_type == one.coordinate_type, "coordinates of a base mesh")
    require(other.has_time == one.has_time and other.arrays == one.arrays, "arrays of a base mesh")
    times = [[step.time for step in decoder.steps] for decoder in (whole, level)]
    require(times[0] == times[1], "steps of a base mesh")
    require(level.container.boundary is None, "boundary of a base mesh")
    tree = level.container.tree
    require(tree is not None and not tree.levels and not tree.parts, "tree of a base mesh")
    unused = 0 if level.container.is_surface else other.unused_points
    require(whole.container.tree.parts[number + 1].points == other.points - unused, "points of a part")
    require(tree.merges == whole.container.tree.merges - merges, "merges of a base mesh")
    require(level.container.is_surface == whole.container.is_surface, "kind of a base mesh")
    return level


def corners_of(mesh):
    """The tetrahedra of a mesh, or cells of a surface, by the values of their corners and their own,
    each corner list turned so that it does not depend on the order of points, cells or corners;
    sorted."""
    decoder = mesh.decoder
    columns = [mesh.points()]
    own = []
    for step in range(len(decoder.steps)):
        for a, array in enumerate(decoder.meta.arrays):
            (columns if array.where == POINTS else own).append(mesh.array(step, a))
    rows = [b"".join(column[i].tobytes() for column in columns) for i in range(len(mesh.kept))]
    result = []
    tets = mesh.tets.tolist() if mesh.types is None else mesh.tets
    for cell, tet in enumerate(tets):
        # Even permutations only, as orientation counts.
        kind = None if mesh.types is None else mesh.types[cell]
        orders = EVEN if kind is None else TURNS if kind == TRIANGLE else [range(len(tet))]
        turned = [tuple(rows[tet[k]] for k in order) for order in orders]
        result.append((kind, min(turned), *(values[cell].tobytes() for values in own)))
    return Record(points=sorted(rows), tets=sorted(result))


TURNS = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
EVEN = [
    (0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 0, 3, 2),
    (1, 3, 2, 0), (1, 2, 0, 3), (2, 3, 0, 1), (2, 0, 1, 3),
    (2, 1, 3, 0), (3, 2, 1, 0), (3, 1, 0, 2), (3, 0, 2, 1)]


def check_level(whole, number, level):
    """Whether a base mesh is the mesh of the whole file after its merges, and goes on as it does."""
    merges = whole.container.tree.levels[number]
    more = len(level.merges)
    errors = [merge[2] for merge in whole.merges[merges:]]
    require(errors == [merge[2] for merge in level.merges], "errors of a base mesh")
    if whole.container.is_surface:
        require(level.bonds == whole.bonds[merges:], "bonds of a base mesh")
        require(merges == 0 or not whole.bonds[merges - 1], "base mesh between bound merges")
    for m in sorted({0, more // 2, more}):
        require(corners_of(SimplerMesh(level, m)) == corners_of(SimplerMesh(whole, merges + m)),
                "mesh of a base mesh")
