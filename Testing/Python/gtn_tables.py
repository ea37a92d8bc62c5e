# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sections META, TABL and CELL of `.gtn` files: sections 3.2, 3.3 and 15.1 of
Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

from types import SimpleNamespace as Record

from gtn_bytes import COPY, SIZES, require

POINTS, CELLS = 0, 1
KEEP_POINTS, KEEP_CELLS, KEEP_CORNERS = 1, 2, 4
MAX_TETS = MAX_CELLS = 1 << 20
MAX_VALUES = 1 << 24
PAGE_CHUNKS = 256


def read_keys(table):
    """Keys of an array (3.2): class, name, kind and values of each."""
    keys = []
    for _ in range(table.varint()):
        key = Record(location=table.string(), name=table.string(), kind=table.number("B"))
        require(key.location and key.name, "name of a key")
        require(1 <= key.kind <= 9, "kind of a key")
        count = table.varint()
        require(key.kind > 5 or count == 1, "values of a key")
        read = {5: table.raw_string, 8: table.raw_string}.get(
            key.kind, lambda kind=key.kind: table.number("d" if kind in (2, 7, 9) else "q"))
        key.values = [read() for _ in range(count)]
        keys.append(key)
    require(keys, "empty list of keys")
    return keys


def read_point_array(table):
    """The array of the points in META (3.2)."""
    array = Record(name=table.string(), keys=[])
    names = table.varint()
    require(names <= 3, "names of the components of points")
    array.component_names = [table.string() for _ in range(names)]
    has_keys = table.number("B")
    require(has_keys <= 1, "keys of points")
    if has_keys:
        array.keys = read_keys(table)
    return array


def read_meta(table):
    """Section META (3.2)."""
    meta = Record()
    meta.writer_version = table.string()
    meta.points = table.varint()
    meta.tets = table.varint()
    meta.unused_points = table.varint()
    meta.coordinate_type = table.number("B")
    meta.wide_ids = table.number("B")
    flags = table.number("B")
    require(flags <= 15, "flags of META")
    meta.has_time = flags & 1 != 0
    meta.points_move = flags & 2 != 0
    require(not meta.points_move or meta.has_time, "motion without time")
    meta.keep = table.number("B")
    meta.chunk_size = table.varint()
    meta.key_step_interval = table.varint()
    meta.box = table.ranges(3)
    require(meta.coordinate_type in (9, 10), "type of the coordinates")
    require(meta.keep <= 7, "kept order")
    require(max(meta.chunk_size, meta.key_step_interval) < 1 << 32, "number too large")
    meta.point_array = Record(name="Points", component_names=[], keys=[])
    if flags & 4:
        meta.point_array = read_point_array(table)
    meta.arrays = []
    for _ in range(table.varint()):
        array = Record()
        array.name = table.string()
        where = table.number("B")
        require(where <= 3, "array")
        array.where = where & 1
        array.type = table.number("B")
        array.components = table.varint()
        array.vtk_type = table.number("i")
        array.roles = table.number("I")
        require(array.where in (POINTS, CELLS) and array.type in SIZES, "array")
        require(1 <= array.components <= 65536, "number of components")
        names = table.varint()
        require(names <= array.components, "number of component names")
        array.component_names = [table.string() for _ in range(names)]
        array.keys = read_keys(table) if where & 2 else []
        meta.arrays.append(array)
    table.end()
    # Tables of steps have the coordinates of points that move as one more array.
    meta.all_arrays = list(meta.arrays)
    if meta.points_move:
        meta.all_arrays.append(
            Record(name="", where=POINTS, type=meta.coordinate_type, components=3))
    return meta


def read_cells(table):
    """Section CELL (15.1)."""
    cells = Record(types={}, chunks=[])
    before = -1
    for _ in range(table.varint()):
        kind = table.number("B")
        require(kind > before, "order of types")
        before = kind
        cells.types[kind] = table.varint()
        require(cells.types[kind] >= 1, "cells of a type")
    for _ in range(table.varint()):
        kind = table.number("B")
        require(kind <= 1, "kind of a chunk")
        chunk = None
        if kind:
            chunk = Record(cells=table.varint(), corners=table.varint())
            chunk.face_values, chunk.polyhedra = table.varint(), table.varint()
            require(1 <= chunk.cells <= MAX_CELLS, "cells of a chunk")
            require(chunk.corners + chunk.face_values <= MAX_VALUES, "corners of a chunk")
            require(chunk.polyhedra <= chunk.cells, "polyhedra of a chunk")
            require(chunk.polyhedra or not chunk.face_values, "faces without polyhedra")
        cells.chunks.append(chunk)
    cells.shapes = table.raw_string()
    table.end()
    return cells


def check_cells(cells, table):
    """What 15.1 says of CELL and TABL."""
    require(len(cells.chunks) == len(table.chunks), "chunks of cells")
    counts = [chunk.tets if chunk.cells is None else chunk.cells.cells for chunk in table.chunks]
    require(sum(counts) == sum(cells.types.values()), "cells of all types")


def check_chunk(chunk):
    """Sizes that 3.3 bounds by the tetrahedra of a chunk, and 15.2 by its cells."""
    length = chunk.connectivity_bytes
    require(chunk.geometry_bytes > 0, "no geometry")
    if chunk.cells is None:
        require(1 <= chunk.tets <= MAX_TETS, "tetrahedra of a chunk")
        require(length >= chunk.tets // 256 + 1, "connectivity too short")
        return
    values = chunk.cells.corners + chunk.cells.face_values
    require(chunk.tets <= values, "tetrahedra of a chunk of cells")
    require(length >= chunk.cells.cells // 256 + 1, "connectivity too short")
    require(length >= values // 16384 + 1, "connectivity too short")


def read_table(table, meta, open_page, file_size, cells=None):
    """Section TABL and its pages (3.3). open_page: gives the content of a page from its stream
    reference. cells: section CELL, if there is one."""
    result = Record(domains=[table.domain() for _ in range(3)], blocks=[], chunks=[])
    require(all(d is None or d.kind != COPY for d in result.domains), "copies of coordinates")
    result.unused = read_points(table, meta, meta.unused_points)
    count = table.varint()
    require(count < 1 << 32, "number of chunks")
    require(cells is None or len(cells.chunks) == count, "chunks of cells")
    result.pages = []
    for first in range(0, count, PAGE_CHUNKS):
        page = Record(first=first, chunks=min(PAGE_CHUNKS, count - first))
        page.summary, page.details = table.reference(), table.reference()
        page.blocks, page.points, page.bytes = (table.varint() for _ in range(3))
        require(page.points == 0 or page.bytes >= page.points // 256 + 1, "points of a page")
        result.pages.append(page)
    table.end()
    for page in result.pages:
        read_summary(open_page(page.summary), page, result, cells)
    check_sums(result, meta, file_size)
    for page in result.pages:
        read_details(open_page(page.details), page, result, meta, count)
    if cells is not None:
        check_cells(cells, result)
    link_chunks(result)
    return result


def read_points(table, meta, points):
    """The streams of a block or of the unused points."""
    block = Record(points=points, coordinates=table.reference(), original=None)
    if meta.keep & KEEP_POINTS:
        block.original = table.reference()
    require(points < 1 << 32, "points of a block")
    if points:
        length = block.coordinates.length if block.coordinates else 0
        require(length >= points // 256 + 1, "stream of a block too short")
    return block


def read_summary(table, page, result, cells):
    """The summary of a page (3.3)."""
    for _ in range(page.chunks):
        chunk = Record(cells=None)
        if cells is not None:
            chunk.cells = cells.chunks[len(result.chunks)]
        chunk.tets = table.varint()
        chunk.own_points = table.varint()
        chunk.shared_points = table.varint()
        chunk.connectivity_bytes = table.varint()
        chunk.geometry_bytes = table.varint()
        require(max(chunk.connectivity_bytes, chunk.geometry_bytes) < 1 << 32, "length of a stream")
        chunk.box = table.ranges(3)
        check_chunk(chunk)
        most = 4 * chunk.tets
        if chunk.cells is not None:
            most = chunk.cells.corners + chunk.cells.face_values
        require(chunk.own_points + chunk.shared_points <= most, "points of a chunk")
        result.chunks.append(chunk)
    table.end()


def check_sums(result, meta, file_size):
    points = sum(page.points for page in result.pages) + meta.unused_points
    points += sum(chunk.own_points for chunk in result.chunks)
    require(points == meta.points, "number of points")
    require(sum(chunk.tets for chunk in result.chunks) == meta.tets, "number of tetrahedra")
    length = sum(page.bytes for page in result.pages)
    length += result.unused.coordinates.length if result.unused.coordinates else 0
    length += sum(chunk.connectivity_bytes + chunk.geometry_bytes for chunk in result.chunks)
    require(length <= file_size, "streams longer than the file")


def read_ascending(table, what):
    numbers = []
    for i in range(table.varint()):
        step = table.varint()
        require(i == 0 or step >= 1, what)
        numbers.append(step + (numbers[-1] if numbers else 0))
    return numbers


def read_details(table, page, result, meta, chunk_count):
    """The details of a page (3.3)."""
    first_block = len(result.blocks)
    for _ in range(page.blocks):
        groups = []
        for _ in range(table.varint()):
            points = table.varint()
            chunks = read_ascending(table, "chunks of a group")
            require(1 <= points < 1 << 32 and len(chunks) >= 2, "group")
            require(chunks[-1] < chunk_count, "group names a chunk that is not there")
            require(0 <= chunks[0] - page.first < page.chunks, "block in a wrong page")
            groups.append(Record(points=points, chunks=chunks))
        require(groups, "block without groups")
        block = read_points(table, meta, sum(group.points for group in groups))
        block.groups = groups
        result.blocks.append(block)
    blocks = result.blocks[first_block:]
    require(sum(block.points for block in blocks) == page.points, "points of a page")
    length = sum(block.coordinates.length for block in blocks)
    require(length == page.bytes, "geometry of a page")

    def reference(length):
        return Record(length=length, offset=table.varint(), checksum=table.number("Q"))

    for chunk in result.chunks[page.first : page.first + page.chunks]:
        chunk.connectivity = reference(chunk.connectivity_bytes)
        chunk.geometry = reference(chunk.geometry_bytes)
        chunk.original_points = table.reference() if meta.keep & KEEP_POINTS else None
        chunk.original_cells = table.reference() if meta.keep & KEEP_CELLS else None
        chunk.corners = table.reference() if meta.keep & KEEP_CORNERS else None
        chunk.blocks = read_ascending(table, "blocks of a chunk")
        require(not chunk.blocks or chunk.blocks[-1] < len(result.blocks), "block of a chunk")
    table.end()


def link_chunks(result):
    """Checks that chunks and groups name each other."""
    naming = [set() for _ in result.chunks]
    points = [0] * len(result.chunks)
    for number, block in enumerate(result.blocks):
        for group in block.groups:
            for chunk in group.chunks:
                naming[chunk].add(number)
                points[chunk] += group.points
    for chunk, named, shared in zip(result.chunks, naming, points):
        require(chunk.blocks == sorted(named), "blocks of a chunk")
        require(chunk.shared_points == shared, "shared points of a chunk")
