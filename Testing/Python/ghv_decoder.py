# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder of `.ghv` files, written from Documentation/ghv-format.md alone."""

import math
import struct
from types import SimpleNamespace as Record

import numpy

from gtn_bytes import Bytes, checksum, require
from gtn_coding import Coded

MAGIC = bytes.fromhex("894748560D0A1A0A")
END_MAGIC = b"GHVEND\r\n"
SECTIONS = (b"META", b"TABL", b"BLKS", b"DIRY")
DTYPES = {1: "i1", 2: "u1", 3: "<i2", 4: "<u2", 5: "<i4", 6: "<u4", 7: "<i8", 8: "<u8", 9: "<f4",
          10: "<f8"}
SEGMENT = 1 << 18


def truncated(a, b):
    """a // b of the text, which rounds towards 0."""
    return a // b if a >= 0 else -(-a // b)


def clamp(value, low, high):
    return low if value < low else high if value > high else value


def level(m):
    if m < 4:
        return m
    width = m.bit_length()
    return min(155, 4 * (width - 2) + ((m >> (width - 3)) & 3))


def count(q):
    return min(abs(q), 1 << 36)


def limited(v):
    return clamp(v, -(1 << 40), 1 << 40)


def fast_size(n):
    while True:
        rest = n
        for factor in (2, 3, 5):
            while rest % factor == 0:
                rest //= factor
        if rest == 1:
            return n
        n += 1


def places(sizes):
    """All triples below sizes, x fastest."""
    return [(x, y, z) for z in range(sizes[2]) for y in range(sizes[1]) for x in range(sizes[0])]


class Order:
    """Positions of the coefficients of a block (5)."""

    def __init__(self, block):
        self.block = block
        longest = max(block)
        self.places = places(block)
        self.index = {place: i for i, place in enumerate(self.places)}
        self.waves = [tuple(self.wave(a, place[a]) for a in range(3)) for place in self.places]
        self.partner = [
            self.index[tuple((block[a] - place[a]) % block[a] for a in range(3))]
            for place in self.places
        ]
        shells = []
        for wave in self.waves:
            x, y, z = (float(wave[a] * longest) / block[a] for a in range(3))
            shells.append(math.floor(math.sqrt(x * x + y * y + z * z)))
        self.positions = []
        leaders = [i for i in range(len(self.places)) if self.partner[i] >= i]
        for i in sorted(leaders, key=lambda i: (shells[i], i)):
            self.positions.append(i)
            if self.partner[i] != i:
                self.positions.append(self.partner[i])
        self.position_of = {i: at for at, i in enumerate(self.positions)}
        number = 1 + max(shells)
        self.bands = [
            s if number <= 16 or s == 0 else 1 + (s - 1) * 15 // (number - 1)
            for s in (shells[i] for i in self.positions)
        ]

    def wave(self, axis, u):
        return u if 2 * u <= self.block[axis] else u - self.block[axis]

    def inner(self, index, axis):
        place = list(self.places[index])
        wave = self.waves[index][axis]
        place[axis] = (wave - 1 if wave > 0 else wave + 1) % self.block[axis]
        return self.index[tuple(place)]


class Walk:
    """Decodes a stream of blocks, or of a segment of one (6)."""

    def __init__(self, order, grid, data):
        self.order = order
        self.grid = grid
        self.blocks = places(grid)
        self.number = {place: i for i, place in enumerate(self.blocks)}
        self.values = [[0] * len(order.places) for _ in self.blocks]
        self.coded = Coded(Bytes(data))

    def size(self, name, m):
        shift = max(0, (m >> 4).bit_length() - 3)
        v = self.coded.symbol(name, "symbols", level(m))
        if v == 15:
            n = 1
            while self.coded.decide(name, "escape", n):
                n += 1
                require(n < 64, "size")
            v = 14 + (1 << (n - 1)) + self.coded.raw(n - 1)
        require(v <= (1 << 62) >> shift, "size")
        return (v << shift) + self.coded.raw(shift) + 1

    def before(self, place, *axes):
        """The number of the block one before along axes, or none."""
        moved = tuple(place[a] - (a in axes) for a in range(3))
        return self.number.get(moved)

    def decode_blocks(self):
        for block, place in enumerate(self.blocks):
            self.decode_mean(block, place)
        ends = self.decode_ends()
        self.running = [0] * len(self.order.places) if len(self.blocks) > 1 else None
        for block, place in enumerate(self.blocks):
            self.block = block
            self.neighbors = [self.before(place, a) for a in range(3)]
            self.slopes = [self.slope(block, place, a) for a in range(3)]
            for position in range(1, ends[block]):
                self.decode_value(position, 0)
        return self.values

    def decode_segment(self, segment, values):
        self.values = [values]
        self.running = None
        self.block = 0
        self.neighbors = [None] * 3
        self.slopes = [0] * 3
        first = segment * SEGMENT
        length = min(SEGMENT, len(values) - first)
        used = self.coded.raw(length.bit_length())
        require(used <= length, "length of a segment")
        for position in range(first, first + used):
            self.decode_value(position, first)

    def decode_mean(self, block, place):
        axes = [a for a in range(3) if place[a] > 0]
        near = [self.values[self.before(place, a)][0] for a in axes]
        diagonal = sum(
            self.values[self.before(place, a, b)][0] for a in axes for b in axes if a < b
        )
        guess, spread = 0, 64
        if near:
            low, high = min(near), max(near)
            spread = high - low
            guess = near[0]
            if len(near) == 2:
                guess = clamp(sum(near) - diagonal, low, high)
            elif len(near) == 3:
                guess = clamp(truncated(2 * sum(near) - diagonal, 3), low, high)
            spread += abs(guess) >> 5
        m = 8 * min(spread, 1 << 36)
        if self.coded.decide("mean_zero", level(m)):
            negative = self.coded.decide("mean_sign", int(guess > 0))
            size = self.size("mean_sizes", m)
            guess += -size if negative else size
        require(abs(guess) <= 1 << 59, "mean")
        self.values[block][0] = guess

    def decode_ends(self):
        length = len(self.order.places)
        ends = []
        if length >= 1 << 15:
            for _ in self.blocks:
                n = self.coded.raw((length - 1).bit_length())
                require(n <= length - 1, "end of a block")
                ends.append(1 + n)
            return ends
        bands = []
        most = max(self.order.bands)
        for block, place in enumerate(self.blocks):
            near = [bands[self.before(place, a)] for a in range(3) if place[a] > 0]
            c = len(near)
            where = (2 * sum(near) + c) // (2 * c) if c else 16
            band = self.coded.symbol("end", 2 * where + (self.values[block][0] == 0))
            require(band <= most, "band")
            bands.append(band)
            ends.append(sum(b <= band for b in self.order.bands))
        return ends

    def slope(self, block, place, axis):
        before = self.before(place, axis)
        behind = self.number.get(tuple(place[a] + (a == axis) for a in range(3)))
        own = self.values[block][0]
        slope = (own if behind is None else self.values[behind][0]) - (
            own if before is None else self.values[before][0]
        )
        return slope if before is not None and behind is not None else 2 * slope

    def decode_value(self, position, first):
        order = self.order
        index = order.positions[position]
        own = self.values[self.block]
        wave = order.waves[index]

        def known(i):
            return first <= order.position_of[i] < position

        total = weight = foretold = 0
        axes = sum(k != 0 for k in wave)
        partner = order.partner[index]
        second = known(partner)
        if second:
            total += 4 * count(own[partner])
            weight += 4
        for a in range(3):
            size = abs(wave[a])
            if size > 1:
                inner = order.inner(index, a)
                if known(inner):
                    total += 6 * count(own[inner])
                    weight += 6
                    foretold -= truncated(limited(own[inner]) * 16 * (size - 1), size)
                    if known(order.partner[inner]):
                        total += 6 * count(own[order.partner[inner]])
                        weight += 6
            if self.neighbors[a] is not None:
                other = self.values[self.neighbors[a]]
                total += count(other[index]) + count(other[partner])
                weight += 2
        if axes == 1:
            a = next(a for a in range(3) if wave[a])
            size = abs(wave[a])
            t = truncated(limited(self.slopes[a]) * 163, 128 * size)
            foretold += t if (wave[a] > 0) == (size % 2 == 1) else -t
            total += 6 * (abs(foretold) // 16)
            weight += 6
        m = total * ((65536 + weight // 2) // weight if weight else 0) >> 12
        trend = 0
        if self.running is not None:
            r = self.running[position]
            m = (14 * m + 2 * r) // 16
            trend = 2 if r > 2 * m + 4 else 1 if 2 * r + 4 < m else 0
        q = 0
        if self.coded.decide("zero", 4 * trend + 2 * second + (axes > 1), level(m)):
            strength = min(7, (abs(foretold) >> 1).bit_length())
            down = foretold < 0
            p = own[partner] if second else 0
            relation = 0 if p == 0 else 1 if (p < 0) == down else 2
            other = self.coded.decide("sign", 4 * axes + relation, strength)
            size = self.size("sizes", m)
            q = -size if down != bool(other) else size
            own[index] = q
        if self.running is not None:
            self.running[position] = r + truncated(16 * count(q) - r, 16)


class Volume:
    """A file, whose tables are read and checked."""

    def __init__(self, data):
        self.data = data
        sections = self._sections()
        self._read_meta(Bytes(self._section(sections, b"META")))
        self._read_table(Bytes(self._section(sections, b"TABL")))
        self.order = Order(self.block)

    def _sections(self):
        data = self.data
        require(len(data) >= 48, "too short")
        require(data[:8] == MAGIC and data[-8:] == END_MAGIC, "not a .ghv file, or truncated")
        version, zero = struct.unpack("<II", data[8:16])
        require(version == 1 and zero == 0, "header")
        offset, length, check = struct.unpack("<3Q", data[-32:-8])
        require(offset >= 40 and offset + length == len(data) - 32, "place of the directory")
        require(checksum(data[:16] + data[offset:-32]) == check, "checksum of the directory")
        table = Bytes(data[offset:-32])
        sections = []
        for _ in range(table.varint()):
            name, version, flags, size, check = struct.unpack("<4sHHQQ", table.take(24))
            section = Record(name=name, length=size, checksum=check, offset=table.number("Q"))
            if name in SECTIONS:
                require(version == 1, "another version of a section")
                sections.append(section)
            else:
                require(not flags & 1, "unknown mandatory section")
        table.end()
        return sections

    def _section(self, sections, name):
        found = [section for section in sections if section.name == name]
        require(len(found) == 1, "number of sections")
        return self._stream(found[0])

    def _stream(self, reference):
        end = reference.offset + reference.length
        require(end <= len(self.data), "stream behind the end of the file")
        data = self.data[reference.offset : end]
        require(checksum(data) == reference.checksum, "checksum of a stream")
        return data

    def _read_meta(self, table):
        self.writer = table.string()
        self.size = tuple(table.varint() for _ in range(3))
        self.block_size = table.varint()
        self.kind = table.number("B")
        require(self.kind in DTYPES, "type")
        self.vtk_type = table.number("i")
        self.name = table.string()
        self.origin = [table.number("d") for _ in range(3)]
        self.spacing = [table.number("d") for _ in range(3)]
        self.direction = [table.number("d") for _ in range(9)]
        self.first_index = [table.number("i") for _ in range(3)]
        self.min, self.max = table.number("d"), table.number("d")
        self.flags = table.number("B")
        self.step, self.weight = table.number("d"), table.number("d")
        self.shifts = [table.number("h") for _ in range(3)]
        self.quality = table.number("B"), table.number("d")
        self.errors = table.number("d"), table.number("d")
        table.end()
        self.corrected = self.flags == 1 and self.kind <= 8
        if self.block_size:
            self.block = tuple(min(n, self.block_size) for n in self.size)
            most = tuple(max(1, 64 // n) for n in self.block)
        else:
            self.block = tuple(fast_size(n) for n in self.size)
            most = (1, 1, 1)
        self.blocks = tuple(-(-self.size[a] // self.block[a]) for a in range(3))
        self.chunk = tuple(min(most[a], self.blocks[a]) for a in range(3))
        self.chunks = places(tuple(-(-self.blocks[a] // self.chunk[a]) for a in range(3)))

    def _read_table(self, table):
        self.entries = []
        self.segments = max(1, -(-math.prod(self.block) // SEGMENT))
        end = 0
        for _ in self.chunks:
            entry = Record(terms=table.varint(), streams=[])
            for _ in range(self.segments + self.corrected):
                offset = end + table.varint()
                length = table.varint()
                end = offset + length
                entry.streams.append(
                    Record(offset=offset, length=length, checksum=table.number("Q")))
            self.entries.append(entry)
        table.end()

    def grid(self, chunk):
        """The first block of a chunk, and how many blocks it has along each axis."""
        place = self.chunks[chunk]
        first = tuple(place[a] * self.chunk[a] for a in range(3))
        return first, tuple(min(self.chunk[a], self.blocks[a] - first[a]) for a in range(3))

    def integers(self, chunk):
        """The coefficients of a chunk's blocks, a list for each."""
        entry = self.entries[chunk]
        _, grid = self.grid(chunk)
        if self.segments == 1:
            values = Walk(self.order, grid, self._stream(entry.streams[0])).decode_blocks()
        else:
            values = [[0] * math.prod(self.block)]
            for segment in range(self.segments):
                data = self._stream(entry.streams[segment])
                Walk(self.order, grid, data).decode_segment(segment, values[0])
        require(sum(q != 0 for block in values for q in block) == entry.terms, "terms")
        return values

    def coefficients(self, block):
        """H of a block from its integers (4.3)."""
        result = []
        for i, q in enumerate(block):
            step = self.step
            if self.weight:
                x, y, z = (k / n for k, n in zip(self.order.waves[i], self.block))
                step = self.step * (1 + self.weight * ((x * x + y * y + z * z) / 0.75))
            if q == 0 or i == 0:
                result.append(q * step)
            else:
                size = abs(q)
                h = (size - self.shifts[min(size, 3) - 1] / 256) * step
                result.append(-h if q < 0 else h)
        return result

    def inverse(self, coefficients):
        """f of a block (4.2), by the definition with all sums but for their order."""
        nx, ny, nz = self.block
        h = numpy.array(coefficients).reshape(nz, ny, nx)
        # cas(t) is the sum of the real and the imaginary part of exp(i t).
        for axis, n in ((2, nx), (1, ny), (0, nz)):
            k = numpy.array([u if 2 * u <= n else u - n for u in range(n)])
            x = numpy.arange(n) - (n - 1) / 2
            h = numpy.moveaxis(
                numpy.tensordot(h, numpy.exp(2j * numpy.pi * numpy.outer(k, x) / n), ((axis,), (0,))),
                -1, axis)
        return (h.real + h.imag) / math.sqrt(nx * ny * nz)

    def voxels(self):
        """All voxels as an array [z, y, x]."""
        nx, ny, nz = self.size
        result = numpy.zeros((nz, ny, nx), DTYPES[self.kind])
        for chunk, entry in enumerate(self.entries):
            coded = Coded(Bytes(self._stream(entry.streams[-1]))) if self.corrected else None
            recent = 0
            first, grid = self.grid(chunk)
            for place, block in zip(places(grid), self.integers(chunk)):
                begin = [(first[a] + place[a]) * self.block[a] for a in range(3)]
                filled = [min(self.block[a], self.size[a] - begin[a]) for a in range(3)]
                values = self.inverse(self.coefficients(block))
                values = values[: filled[2], : filled[1], : filled[0]]
                if coded:
                    flat = []
                    for value in values.reshape(-1):
                        voxel, recent = self.correct(coded, float(value), recent)
                        flat.append(voxel)
                    values = numpy.array(flat).reshape(values.shape)
                if self.kind <= 8:
                    values = numpy.floor(values + 0.5)
                values = numpy.clip(values + self.min, self.min, self.max)
                result[
                    begin[2] : begin[2] + filled[2],
                    begin[1] : begin[1] + filled[1],
                    begin[0] : begin[0] + filled[0],
                ] = values
        return result

    def correct(self, coded, value, recent):
        """A voxel less the smallest, and what is recent then (7)."""
        length = int(self.max - self.min)

        def nearest(n):
            o = coded.raw(n)
            return o + 2**n * math.floor((value - o) / 2**n + 0.5)

        wrong = coded.decide("wrong", recent)
        if not wrong:
            v = math.floor(value + 0.5)
        elif not coded.decide("far"):
            v = nearest(1)
        elif not coded.decide("farther"):
            v = nearest(4)
        else:
            v = coded.raw(length.bit_length())
        return clamp(v, 0, length), 2 * (recent & 1) + wrong
