# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The container of `.gtn` files with the tables of all sections: sections 2, 11.2, 16.1 and 18.3 of
Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import struct
from types import SimpleNamespace as Record

from gtn_bytes import (
    Bytes, checksum, field_data_limit, require, step_limit, steps_limit, table_limit, unpack)
from gtn_layers import read_layers
from gtn_series import masks_of, read_mask, read_series
from gtn_steps import read_field_array, read_step
from gtn_tables import read_cells, read_meta, read_table
from gtn_tree import read_tree, read_tree_step

#: The lists of cells of a surface (16.2), by types of cells.
SURFACE_LISTS = {1: 0, 2: 0, 3: 1, 4: 1, 5: 2, 7: 2, 9: 2, 6: 3}

MAGIC = bytes.fromhex("8947544E0D0A1A0A")
END_MAGIC = b"GTNEND\r\n"
SECTIONS = (
    b"META", b"TABL", b"PAGE", b"STEP", b"MESH", b"VALS", b"TREE", b"MERG", b"TRNG", b"LEVL",
    b"DEPS", b"LAYR", b"CELL", b"SURF", b"BNDY", b"GRID", b"TIME", b"LIVE", b"DIRY")
STREAMS = (b"PAGE", b"MESH", b"VALS", b"MERG")  # sections of streams


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
            self.series = read_series(self._packed(sections, b"TIME"), self.meta, self.steps)
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
        version, zero = struct.unpack("<II", data[8:16])
        require(version == 1, "another version")
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
            known = name in SECTIONS
            require(not known or version == 1, "another version of a section")
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
        part = Bytes(self._payload(section))
        length = part.varint()
        if length == 0:
            return part.take(part.left())
        check = part.number("Q")
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
        """Sections TREE, TRNG and LEVL (13)."""
        tree = read_tree(
            self._packed(sections, b"TREE"), self.meta, self.table, self.is_surface)
        contents = {name: [self._content(section) for section in sections if section.name == name]
                    for name in (b"TRNG", b"LEVL")}
        require(len(contents[b"TRNG"]) == len(self.steps), "number of TRNG")
        require(len(contents[b"LEVL"]) == len(tree.levels), "number of LEVL")
        tree.ranges = [
            read_tree_step(Bytes(content), self.meta, self.table, tree)
            for content in contents[b"TRNG"]
        ]
        tree.files = contents[b"LEVL"]
        self.tree = tree

    def _packed(self, sections, name):
        found = [section for section in sections if section.name == name]
        require(len(found) == 1, "not one section " + name.decode())
        return Bytes(self._content(found[0]))
