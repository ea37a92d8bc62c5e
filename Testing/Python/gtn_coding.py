# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Values and entropy coding of `.gtn` files: sections 5 to 7 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import struct

from gtn_container import SIZES, Bytes, require

INT_TYPES, UINT_TYPES = (1, 3, 5, 7), (2, 4, 6, 8)
UINT8, UINT32, FLOAT32, FLOAT64 = 2, 6, 9, 10

MAX_FLOAT32 = struct.unpack("<f", bytes.fromhex("ffff7f7f"))[0]


def divide(a, b):
    """a / b of IEEE 754, where Python raises an exception for b = 0."""
    if b != 0:
        return a / b
    if a == 0 or math.isnan(a) or math.isnan(b):
        return math.nan
    return math.copysign(math.inf, a) * math.copysign(1.0, b)


class Domain:
    """How the values of one component are mapped to keys (5.1, 5.2, 5.3)."""

    def __init__(self, kind, palette=None):
        self.kind = kind
        self.palette = palette
        self.width = 8 * SIZES[kind]
        self.sign = 1 << (self.width - 1)
        self.bits = self.width if palette is None else len(palette).bit_length()
        self.mask = (1 << self.bits) - 1

    def add(self, key, residual):
        """The key of a value from its prediction and its residual (5.4)."""
        key = (key + residual) & self.mask
        require(self.palette is None or key < len(self.palette), "key outside of the palette")
        return key

    def plain(self, key):
        return key if self.palette is None else self.palette[key]

    def pattern(self, key):
        """The bits of a value as an unsigned integer, from its key."""
        key = self.plain(key)
        if self.kind in UINT_TYPES:
            return key
        if self.kind in INT_TYPES or key & self.sign:
            return key ^ self.sign
        return key ^ ((1 << self.width) - 1)

    def to_value(self, key):
        if self.kind in UINT_TYPES:
            return float(self.plain(key))
        if self.kind in INT_TYPES:
            return float(self.plain(key) - self.sign)
        size = SIZES[self.kind]
        code = "<f" if self.kind == FLOAT32 else "<d"
        return struct.unpack(code, self.pattern(key).to_bytes(size, "little"))[0]

    def to_number(self, key):
        return self.to_value(key) if self.palette is None else float(key)

    def from_number(self, x):
        if math.isnan(x) or math.isinf(x):
            x = 0.0
        if self.palette is not None:
            return max(0, min(math.floor(x + 0.5), len(self.palette) - 1))
        if self.kind == FLOAT32:
            x = max(-MAX_FLOAT32, min(x, MAX_FLOAT32))
            r = int.from_bytes(struct.pack("<f", x), "little")
        elif self.kind == FLOAT64:
            r = int.from_bytes(struct.pack("<d", x), "little")
        else:
            zero = self.sign if self.kind in INT_TYPES else 0
            return max(0, min(math.floor(x + 0.5) + zero, self.mask))
        return ~r & self.mask if r & self.sign else r | self.sign

    def to_bytes(self, keys):
        size = SIZES[self.kind]
        return b"".join([self.pattern(key).to_bytes(size, "little") for key in keys])


class Coded:
    """An entropy-coded part (section 6)."""

    def __init__(self, stream):
        """stream: Bytes, which are taken up to their end."""
        self.words = Bytes(stream.take(stream.varint()))
        self.bits_left = 8 * stream.left()
        self.bits = int.from_bytes(stream.take(stream.left()), "little")
        self.state = None
        if self.words.left():
            self.state = self.words.number("Q")
        self.models = {}

    def new_models(self):
        self.models = {}

    def decide(self, *model):
        """A decision, 0 or 1, by the model of this name and these indices."""
        require(self.state is not None, "no decisions")
        one, used = self.models.get(model, (1 << 21, 0))
        p = max(1, one >> 6)
        slot, rest = self.state & 65535, self.state >> 16
        if slot < p:
            decision, self.state, goal = 1, p * rest + slot, 1 << 22
        else:
            decision, self.state, goal = 0, (65536 - p) * rest + slot - p, 0
        if self.state < 1 << 32:
            self.state = (self.state << 32) + self.words.number("I")
        one += (goal - one) * (131072 // (2 * used + 3)) >> 16
        self.models[model] = (one, min(used + 1, 250))
        return decision

    def raw(self, count):
        require(count <= self.bits_left, "raw part ends too early")
        result = self.bits & ((1 << count) - 1)
        self.bits >>= count
        self.bits_left -= count
        return result

    def index(self, count):
        value = self.raw((count - 1).bit_length() if count else 0)
        require(value < count, "index")
        return value

    def residual(self, models, spread):
        """A residual (section 7) and its class. models: a tuple that names the set."""
        if self.decide(models, "zero"):
            return 0, -1
        negative = self.decide(models, "sign")
        node = 1
        for _ in range(5):
            node = 2 * node + self.decide(models, "tree", node)
        kind = node - 32
        length = self.raw(7) if kind in (0, 31) else kind + spread - 20
        require(1 <= length <= 64, "length of a residual")
        size = 1
        if length >= 2:
            second = self.decide(models, "second", kind)
            size = (2 + second << (length - 2)) + self.raw(length - 2)
        d = -size if negative else size
        return (d + (1 << 63)) % (1 << 64) - (1 << 63), kind


class RunningSpread:
    """The running spread (10.2)."""

    def __init__(self):
        self.sum = 80

    def spread(self):
        return self.sum >> 2

    def update(self, residual):
        self.sum += abs(residual).bit_length() - (self.sum >> 2)
