# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Container and tables of `.gtn` files: sections 2, 3, 13, 14 and 15.1 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import struct
from types import SimpleNamespace as Record

import xxhash
import zstandard

POINTS, CELLS = 0, 1
KEEP_POINTS, KEEP_CELLS, KEEP_CORNERS = 1, 2, 4
MAX_TETS = MAX_CELLS = 1 << 20
MAX_VALUES = 1 << 24
MAX_PALETTE = 1 << 16
SCALES = SHIFT, DECIMAL, FIXED = 65537, 65538, 65539
COPY = 65540
BOUND = 65541
PALETTE = 0
PAGE_CHUNKS = 256
MAX_RUNGS = MAX_LEVELS = 64
MAX_LAYERS = 4096

#: The lists of cells of a surface (16.2), by types of cells.
SURFACE_LISTS = {1: 0, 2: 0, 3: 1, 4: 1, 5: 2, 7: 2, 9: 2, 6: 3}

#: Bytes of a value of each type (5.1).
SIZES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 8, 8: 8, 9: 4, 10: 8}

MAGIC = bytes.fromhex("8947544E0D0A1A0A")
END_MAGIC = b"GTNEND\r\n"
SECTIONS = (
    b"META", b"TABL", b"PAGE", b"STEP", b"MESH", b"VALS", b"TREE", b"MERG", b"TRNG", b"LEVL",
    b"DEPS", b"LAYR", b"CELL", b"SURF", b"BNDY", b"GRID", b"TIME", b"LIVE", b"DIRY")
VERSIONS = {b"META": 2, b"TABL": 3, b"STEP": 4, b"GRID": 2, b"TIME": 2}  # the highest ones of sections, if not 1
STREAMS = (b"PAGE", b"MESH", b"VALS", b"MERG")  # sections of streams


class FormatError(Exception):
    """What is not a conforming file."""


def require(condition, message):
    if not condition:
        raise FormatError(message)


def checksum(data):
    return xxhash.xxh3_64_intdigest(data)


class Bytes:
    """Reads the types of 1.2 from a run of bytes, front to back."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def left(self):
        return len(self.data) - self.at

    def take(self, count):
        require(count <= self.left(), "ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self, code):
        """One number, by the letter that the module struct has for its type."""
        return struct.unpack("<" + code, self.take(struct.calcsize("<" + code)))[0]

    def varint(self):
        value = 0
        for place in range(10):
            byte = self.number("B")
            require(place < 9 or byte & 127 <= 1, "varint of more than 64 bits")
            value |= (byte & 127) << (7 * place)
            if byte < 128:
                return value
        raise FormatError("varint of more than ten bytes")

    def raw_string(self):
        return self.take(self.varint())

    def string(self):
        """Text; bytes that are not UTF-8 become surrogates, as in Python's file names."""
        return self.raw_string().decode("utf-8", "surrogateescape")

    def end(self):
        require(self.left() == 0, "bytes behind the last field")

    # Of section 3.1 and 2.7.

    def range(self):
        low, high = self.number("d"), self.number("d")
        require(not math.isnan(low) and not math.isnan(high), "range of NaN")
        return low, high

    def ranges(self, count):
        return [self.range() for _ in range(count)]

    def reference(self):
        """A stream reference, or none."""
        length = self.varint()
        if length == 0:
            return None
        return Record(length=length, offset=self.varint(), checksum=self.number("Q"))

    def domain(self):
        """A domain reference, or none: a palette with entries and stream, a scale with kind, digits
        and first, a copy with array and component, or a bound with its bytes."""
        entries = self.varint()
        if entries == 0:
            return None
        if entries == COPY:
            return Record(kind=COPY, array=self.varint(), component=self.varint())
        if entries in SCALES:
            scale = Record(kind=entries, digits=self.number("B"), first=None)
            if entries == DECIMAL:
                scale.first = self.number("b")
            return scale
        if entries == BOUND:
            return Record(kind=BOUND, bytes=self.take(26))
        require(entries <= MAX_PALETTE, "palette too large")
        stream = self.reference()
        require(stream is not None, "palette without a stream")
        require(stream.length >= entries // 256, "stream of a palette too short")
        return Record(kind=PALETTE, entries=entries, stream=stream)


def unpack(data, limit):
    """The content of a packed part (2.6)."""
    part = Bytes(data)
    length = part.varint()
    require(length <= limit(len(data)), "packed part too large")
    frame = part.take(part.left())
    try:
        decompressor = zstandard.ZstdDecompressor(max_window_size=1 << 27).decompressobj()
        content = decompressor.decompress(frame)
    except zstandard.ZstdError as error:
        raise FormatError(str(error)) from None
    require(decompressor.eof and not decompressor.unused_data, "not one Zstandard frame")
    require(len(content) == length, "packed part of another length")
    return content


def table_limit(packed):
    """Of META, TABL, TREE, LAYR and CELL (11.1)."""
    return max(1 << 20, 512 * packed)


def step_limit(packed):
    """Of STEP and TRNG."""
    return max(1 << 24, 512 * packed)


def steps_limit(file):
    """Of all STEP and TRNG together."""
    return max(1 << 24, 512 * file)


def field_data_limit(packed):
    return 65536 * (packed + 1)


class Container:
    """A file, whose tables are read and checked; attributes meta, table, steps, and, None if there
    are none, cells, layers and tree, which has ranges, one table a step, dependencies, the section
    DEPS or None, and files, the bytes of base meshes; meshes, the bytes of other meshes, and series,
    the mesh and the time of each step, None if there is one mesh."""

    def __init__(self, data):
        self.data = data
        self._step_bytes = 0
        sections = self._directory()
        self.meta = read_meta(self._packed(sections, b"META"))
        self.cells = None
        if any(section.name == b"CELL" for section in sections):
            self.cells = read_cells(self._packed(sections, b"CELL"))
        self.table = read_table(
            self._packed(sections, b"TABL"), self.meta, self._page, len(data), self.cells)
        self.steps = []
        for section in sections:
            if section.name == b"STEP":
                self.steps.append(read_step(
                    Bytes(self._content(section)), self.meta, self.table, self._step_page))
                require(self.steps[0].moves or not self.meta.points_move, "no coordinates")
        for i, step in enumerate(self.steps):
            require(step.key if i == 0 else step.time > self.steps[i - 1].time, "order of steps")
        require(self.meta.has_time or len(self.steps) <= 1, "steps without time")
        self.layers = None
        if any(section.name == b"LAYR" for section in sections):
            self.layers = read_layers(self._packed(sections, b"LAYR"), self.meta, self.table)
        self.is_surface = any(section.name == b"SURF" for section in sections)
        if self.is_surface:
            self._check_surface(sections)
        self.tree = None
        if any(section.name == b"TREE" for section in sections):
            self._read_tree(sections)
        boundaries = [section for section in sections if section.name == b"BNDY"]
        require(len(boundaries) <= 1 - self.is_surface, "number of boundaries")
        self.boundary = self._content(boundaries[0]) if boundaries else None
        self.meshes = [self._mesh(section) for section in sections if section.name == b"GRID"]
        self.series = None
        self._read_masks(sections)
        if self.meshes or any(section.name == b"TIME" for section in sections):
            version = next((struct.unpack("<H", section.header[4:6])[0] for section in sections
                            if section.name == b"TIME"), 1)
            self.series = read_series(
                self._packed(sections, b"TIME"), self.meta, self.steps, version)
        require(len(self.meshes) == (max(s.mesh for s in self.series) if self.series else 0),
                "number of meshes")
        require(self.series is None or masks_of(self.series, 0) == len(self.masks),
                "number of masks")

    def _read_masks(self, sections):
        """Sections LIVE (18.4): attribute masks."""
        self.masks = []
        for section in sections:
            if section.name == b"LIVE":
                before = self.masks[-1] if self.masks else None
                self.masks.append(read_mask(
                    Bytes(self._content(section)), self.meta, self.table, self.cells, before))
        if self.masks:
            require(self.meta.has_time and self.tree is None and self.boundary is None,
                    "masks of a mesh")

    def _check_surface(self, sections):
        """Section SURF (16.1)."""
        section = [section for section in sections if section.name == b"SURF"]
        require(len(section) == 1 and self._payload(section[0]) == b"\x01", "kind of surface")
        kinds = list(self.cells.types) if self.cells else []
        require(all(kind in SURFACE_LISTS for kind in kinds), "cells of a surface")
        require(self.cells or not self.table.chunks, "cells of a surface")

    def stream(self, reference):
        """The bytes of a stream, whose checksum is right."""
        end = reference.offset + reference.length
        require(end <= len(self.data), "stream behind the end of the file")
        data = self.data[reference.offset : end]
        require(checksum(data) == reference.checksum, "checksum of a stream")
        return data

    def field_data(self, step):
        """Field data of a step: a list of arrays (3.5)."""
        if step.field_data is None:
            return []
        table = Bytes(unpack(self.stream(step.field_data), field_data_limit))
        arrays = [read_field_array(table) for _ in range(table.varint())]
        table.end()
        return arrays

    def verify_layout(self):
        """What 11.2 asks of a program that verifies a file, but for the streams."""
        at = 16
        for section in self._directory(only_known=False):
            require(section.offset == at + 24, "gap between sections")
            require(self.data[at : at + 24] == section.header, "header of a section")
            self._payload(section)
            at = section.offset + section.length
        offset, length, _ = struct.unpack("<3Q", self.data[-32:-8])
        header = struct.pack(
            "<4sHHQQ", b"DIRY", 1, 1, length, checksum(self.data[offset : offset + length])
        )
        require(self.data[at : at + 24] == header and offset == at + 24, "header of DIRY")

    def _directory(self, only_known=True):
        data = self.data
        require(len(data) >= 16 + 32, "too short")
        require(data[:8] == MAGIC and data[-8:] == END_MAGIC, "not a .gtn file, or truncated")
        major, _, zero = struct.unpack("<HHI", data[8:16])
        require(major == 1, "another major version")
        require(zero == 0, "header")
        offset, length, check = struct.unpack("<3Q", data[-32:-8])
        require(offset >= 40 and offset + length == len(data) - 32, "place of the directory")
        require(checksum(data[:16] + data[offset:-32]) == check, "checksum of the directory")

        table = Bytes(data[offset:-32])
        sections = []
        for _ in range(table.varint()):
            header = table.take(24)
            name, version, flags, size, check = struct.unpack("<4sHHQQ", header)
            section = Record(
                header=header, name=name, length=size, checksum=check, offset=table.number("Q")
            )
            require(section.offset >= 40 and section.offset + size <= len(data), "section")
            known = name in SECTIONS and 1 <= version <= VERSIONS.get(name, 1)
            require(known or not flags & 1, "unknown mandatory section")
            if known or not only_known:
                sections.append(section)
        table.end()
        return sections

    def _payload(self, section):
        data = self.data[section.offset : section.offset + section.length]
        require(checksum(data) == section.checksum, "checksum of a section")
        return data

    def _content(self, section):
        data = self._payload(section)
        if section.name in STREAMS or section.name in (b"DEPS", b"LEVL", b"SURF", b"BNDY", b"GRID"):
            return data
        of_step = section.name in (b"STEP", b"TRNG")
        is_large = of_step or section.name == b"LIVE"
        content = unpack(data, step_limit if is_large else table_limit)
        if of_step:
            self._step_bytes += len(content)
            require(self._step_bytes <= steps_limit(len(self.data)), "tables of steps too large")
        return content

    def _mesh(self, section):
        """The file of a mesh, put together from runs if it is not in one piece (18.3)."""
        payload = self._payload(section)
        if struct.unpack("<H", section.header[4:6])[0] == 1:
            return payload
        part = Bytes(payload)
        length, check = part.varint(), part.number("Q")
        packed = part.take(length)
        require(checksum(packed) == check, "checksum of the runs of a mesh")
        runs = Bytes(unpack(packed, table_limit))
        before = self.data[: section.offset - 24]
        pieces, shared = [], 0
        for _ in range(runs.varint()):
            length, source = runs.varint(), runs.varint()
            require(length >= 1, "empty run")
            if source == 0:
                pieces.append(part.take(length))
                continue
            shared += length
            require(source + length <= len(before) and shared <= len(before), "run of a mesh")
            pieces.append(before[source : source + length])
        runs.end()
        part.end()
        return b"".join(pieces)

    def _page(self, reference):
        require(reference is not None, "page")
        return Bytes(unpack(self.stream(reference), table_limit))

    def _step_page(self, reference):
        require(reference is not None, "page of a step")
        return Bytes(unpack(self.stream(reference), step_limit))

    def _read_tree(self, sections):
        """Sections TREE, TRNG, DEPS and LEVL (13)."""
        tree = read_tree(
            self._packed(sections, b"TREE"), self.meta, self.table, self.is_surface)
        contents = {name: [self._content(section) for section in sections if section.name == name]
                    for name in (b"TRNG", b"DEPS", b"LEVL")}
        require(len(contents[b"TRNG"]) == len(self.steps), "number of TRNG")
        require(len(contents[b"LEVL"]) == len(tree.levels), "number of LEVL")
        tree.ranges = [
            read_tree_step(Bytes(content), self.meta, self.table, tree)
            for content in contents[b"TRNG"]
        ]
        tree.files = contents[b"LEVL"]
        require(len(contents[b"DEPS"]) <= 1, "number of DEPS")
        tree.dependencies = contents[b"DEPS"][0] if contents[b"DEPS"] else None
        self.tree = tree

    def _packed(self, sections, name):
        found = [section for section in sections if section.name == name]
        require(len(found) == 1, "not one section " + name.decode())
        return Bytes(self._content(found[0]))


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
    meta.has_time = flags != 0
    meta.points_move = flags & 2 != 0
    require(not meta.points_move or flags & 1 != 0, "motion without time")
    meta.keep = table.number("B")
    meta.chunk_tets = table.varint()
    meta.key_step_interval = table.varint()
    meta.box = table.ranges(3)
    require(meta.coordinate_type in (9, 10), "type of the coordinates")
    require(meta.keep <= 7, "kept order")
    require(max(meta.chunk_tets, meta.key_step_interval) < 1 << 32, "number too large")
    meta.arrays = []
    for _ in range(table.varint()):
        array = Record()
        array.name = table.string()
        array.where = table.number("B")
        array.type = table.number("B")
        array.components = table.varint()
        array.vtk_type = table.number("i")
        array.roles = table.number("I")
        require(array.where in (POINTS, CELLS) and array.type in SIZES, "array")
        require(1 <= array.components <= 65536, "number of components")
        names = table.varint()
        require(names <= array.components, "number of component names")
        array.component_names = [table.string() for _ in range(names)]
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


def read_step(table, meta, layout, open_page):
    """A section STEP and its pages (3.4)."""
    step = Record(time=table.number("d"), key=table.number("B") != 0)
    require(not math.isnan(step.time), "time")
    step.field_data = table.reference()
    moves = table.number("B") if meta.points_move else 0
    require(moves <= 1, "motion of a step")
    step.moves = moves == 1
    step.arrays = []
    arrays = meta.all_arrays if step.moves else meta.arrays
    for array in arrays:
        values = Record(domains=[table.domain() for _ in range(array.components)])
        values.ranges = table.ranges(array.components + (array.components > 1))
        values.unused = table.reference()
        values.chunks, values.chunk_ranges, values.blocks = [], [], []
        step.arrays.append(values)
    check_copies(meta.arrays, step.arrays)
    for values in step.arrays[len(meta.arrays):]:
        require(all(d is None or d.kind in SCALES for d in values.domains), "domain of points")
    pages = [table.reference() for _ in layout.pages] if arrays else []
    table.end()
    for reference, place in zip(pages, layout.pages):
        page = open_page(reference)
        for array, values in zip(arrays, step.arrays):
            for _ in range(place.chunks):
                values.chunk_ranges.append(page.ranges(array.components + (array.components > 1)))
                values.chunks.append(page.reference())
            if array.where == POINTS:
                values.blocks += [page.reference() for _ in range(place.blocks)]
        page.end()
    return step


def is_copy(values):
    return values.domains[0] is not None and values.domains[0].kind == COPY


def check_copies(arrays, steps):
    """Copies of arrays at a step (3.1)."""
    for array, values in zip(arrays, steps):
        copies = [d for d in values.domains if d is not None and d.kind == COPY]
        if not copies:
            continue
        require(len(copies) == array.components, "components that are copies and others")
        source = copies[0].array
        require(all(d.array == source for d in copies), "copies of several arrays")
        require(source < len(arrays) and not is_copy(steps[source]), "source of a copy")
        other = arrays[source]
        require((other.where, other.type) == (array.where, array.type), "kind of a copy")
        require(all(d.component < other.components for d in copies), "component of a copy")


def read_tree(table, meta, layout, is_surface):
    """Section TREE (13.2)."""
    require(meta.points < 1 << 32, "too many points for merges")
    tree = Record(merges=table.varint())
    unused = 0 if is_surface else meta.unused_points
    require(tree.merges <= meta.points - unused, "more merges than points")
    tree.stream = table.reference()
    require((tree.stream is None) == (tree.merges == 0), "stream of merges")

    def ascending(most):
        count = table.varint()
        require(count <= most, "too many rungs or base meshes")
        numbers = [table.varint() for _ in range(count)]
        require(all(a < b for a, b in zip([0] + numbers, numbers)), "numbers do not ascend")
        require(not numbers or numbers[-1] <= tree.merges, "number of merges")
        return numbers

    tree.rungs = ascending(MAX_RUNGS)
    require(tree.merges == 0 or tree.rungs and tree.rungs[-1] == tree.merges, "last rung")
    tree.boxes = [[table.ranges(3) for _ in tree.rungs] for _ in layout.chunks]
    tree.levels = ascending(MAX_LEVELS)
    table.end()
    return tree


def read_tree_step(table, meta, layout, tree):
    """A section TRNG (13.4): ranges by array, None for those of cells, chunk and rung."""
    result = []
    for array in meta.all_arrays:
        count = array.components + (array.components > 1)
        of_points = array.where == POINTS
        result.append([[table.ranges(count) for _ in tree.rungs] for _ in layout.chunks]
                      if of_points else None)
    table.end()
    return result


def read_series(table, meta, steps, version):
    """Section TIME (18.1). steps: those of the first mesh. A list of steps with mesh, mask and
    time."""
    series, masks = [], []
    for _ in range(table.varint()):
        step = Record(mesh=table.varint())
        step.mask = table.varint() if version == 2 else 0
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
    require(sum(mask.alive) == mask.cells, "living cells")
    return mask


def read_layers(table, meta, layout):
    """A section LAYR (14.1)."""
    layers = Record(array=table.varint(), component=table.varint(), spacing=table.number("B"))
    require(layers.array < len(meta.arrays), "array of the layers")
    array = meta.arrays[layers.array]
    require(array.where == POINTS, "layers of an array on cells")
    require(layers.component < array.components + (array.components > 1), "component of the layers")
    layers.count = table.varint()
    require(1 <= layers.count <= MAX_LAYERS, "number of layers")
    layers.bounds = [table.number("d") for _ in range(layers.count - 1)]
    require(all(map(math.isfinite, layers.bounds)), "bound of a layer")
    require(all(a < b for a, b in zip(layers.bounds, layers.bounds[1:])), "order of bounds")
    layers.chunks = [(table.varint(), table.varint()) for _ in layout.chunks]
    require(all(first <= last < layers.count for first, last in layers.chunks), "layers of a chunk")
    table.end()
    return layers


def read_field_array(table):
    """An array of the field data (3.5): values are bytes, or a list of texts (bytes as well)."""
    array = Record(name=table.string(), vtk_type=table.number("i"), components=table.varint())
    array.component_names = [table.string() for _ in range(table.varint())]
    array.type = table.number("B")
    require(array.components < 1 << 31, "components of field data")
    if array.type == 0:
        array.values = [table.raw_string() for _ in range(table.varint())]
    else:
        require(array.type in SIZES, "type of field data")
        length = table.varint()
        require(length % SIZES[array.type] == 0, "bytes of field data")
        array.values = table.take(length)
    return array
