# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Values and entropy coding of `.gtn` files: sections 5 to 7 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import struct

from gtn_bytes import SIZES, Bytes, require

INT_TYPES, UINT_TYPES = (1, 3, 5, 7), (2, 4, 6, 8)
UINT8, UINT32, UINT64, FLOAT32, FLOAT64 = 2, 6, 8, 9, 10

MAX_FLOAT32 = struct.unpack("<f", bytes.fromhex("ffff7f7f"))[0]


def divide(a, b):
    """a / b of IEEE 754, where Python raises an exception for b = 0."""
    if b != 0:
        return a / b
    if a == 0 or math.isnan(a) or math.isnan(b):
        return math.nan
    return math.copysign(math.inf, a) * math.copysign(1.0, b)


def power(i):
    """P(i): the binary64 number nearest to 10^i (5.3)."""
    return float("1e%d" % i)


def scaled(mantissa, e):
    return mantissa * power(e) if e >= 0 else mantissa / power(-e)


class Shift:
    """A scale whose values have low bits of 0 (5.2)."""

    def __init__(self, kind, digits):
        self.width = 8 * SIZES[kind]
        require(1 <= digits < self.width, "shift")
        self.digits = digits
        self.is_floating = kind in (FLOAT32, FLOAT64)
        self.bits = self.width - digits
        self.last = (1 << self.bits) - 1
        self.plain_domain = Domain(kind)

    def is_inverted(self, key):
        return self.is_floating and key < 1 << (self.bits - 1)

    def plain(self, key):
        return (key << self.digits) + ((1 << self.digits) - 1 if self.is_inverted(key) else 0)

    def from_number(self, x):
        p = self.plain_domain.from_number(x)
        key, half = p >> self.digits, (p >> (self.digits - 1)) & 1
        if self.is_inverted(key):
            return key if half else max(key - 1, 0)
        return min(key + 1, self.last) if half else key


class Decimals:
    """A scale of decimal or fixed-point numbers (5.2)."""

    def __init__(self, kind, digits, first=None):
        """first: None for fixed-point numbers."""
        require(kind in (FLOAT32, FLOAT64), "decimal numbers that are integers")
        self.digits, self.first = digits, first
        if first is None:
            require(digits <= 22, "fixed-point numbers")
            self.zero = 1 << 53
        else:
            require(1 <= digits <= 15 and -22 <= first - (digits - 1) <= 22, "decimal numbers")
            self.least = 10 ** (digits - 1)
            self.decade = 9 * self.least
            self.zero = (22 + digits - first) * self.decade
        self.last = 2 * self.zero
        self.bits = (self.last + 1).bit_length()
        self.plain_domain = Domain(kind)

    def magnitude(self, r):
        if self.first is None:
            return scaled(float(r), -self.digits)
        if r == 0:
            return 0.0
        decade, m = divmod(r - 1, self.decade)
        return scaled(float(self.least + m), self.first + decade - (self.digits - 1))

    def plain(self, key):
        r = key - self.zero
        return self.plain_domain.from_number(self.magnitude(r) if r >= 0 else -self.magnitude(-r))

    def from_number(self, x):
        r = self.rank(abs(x))
        return self.zero - r if x < 0 else self.zero + r

    def rank(self, a):
        if self.first is None:
            w = a * power(self.digits) + 0.5
            return self.zero if w >= self.zero else math.floor(w)
        level = None
        for i in range(36, self.first - 1, -1):
            if a >= power(i):
                level = i
                break
        if level is None:
            return 1 if a + a >= power(self.first) else 0
        e = self.digits - 1 - level
        m = 10 * self.least
        if e >= -22:
            m = min(max(math.floor(scaled(a, e) + 0.5), self.least), m)
        return min(1 + (level - self.first) * self.decade + m - self.least, self.zero)


class Multiples:
    """A scale of multiples of a power of two (5.2)."""

    def __init__(self, kind, first):
        require(kind in (FLOAT32, FLOAT64), "multiples of a power of two that are integers")
        require(-126 <= first <= 103, "multiples of a power of two")
        self.unit = math.ldexp(1.0, first)
        self.zero = 1 << (24 if kind == FLOAT32 else 52)
        self.last = 2 * self.zero
        self.bits = (self.last + 1).bit_length()
        self.plain_domain = Domain(kind)

    def plain(self, key):
        return self.plain_domain.from_number((key - self.zero) * self.unit)

    def from_number(self, x):
        w = abs(x) / self.unit + 0.5
        r = self.zero if w >= self.zero else math.floor(w)
        return self.zero - r if x < 0 else self.zero + r


class Domain:
    """How the values of one component are mapped to keys (5.1, 5.2, 5.3)."""

    def __init__(self, kind, palette=None, scale=None):
        """scale: its class and what that takes behind the type."""
        self.kind = kind
        self.bound = None  # of errors (5.5)
        self.palette = palette
        self.scale = scale and scale[0](kind, *scale[1:])
        self.width = 8 * SIZES[kind]
        self.sign = 1 << (self.width - 1)
        self.bits = self.width if palette is None else len(palette).bit_length()
        self.bits = self.scale.bits if scale else self.bits
        self.mask = (1 << self.bits) - 1

    def add(self, key, residual):
        """The key of a value from its prediction and its residual (5.4)."""
        key = (key + residual) & self.mask
        require(self.palette is None or key < len(self.palette), "key outside of the palette")
        require(self.scale is None or key <= self.scale.last, "key outside of the scale")
        return key

    def plain(self, key):
        if self.scale is not None:
            return self.scale.plain(key)
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
        if self.scale is not None:
            return self.scale.from_number(x)
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


class SymbolModel:
    """The adaptive probabilities of the symbols 0 to 15 (6.2). starts: S[0] to S[16]."""

    def __init__(self):
        self.starts = [2048 * i for i in range(17)]
        self.used = 0

    def update(self, symbol):
        n = self.used
        rate = 2 if n < 2 else 3 if n < 6 else 4 if n < 16 else 5 if n < 48 else 6
        for i in range(16):
            target = 4 * i if i <= symbol else 32768 - 4 * (16 - i)
            self.starts[i] += (target - self.starts[i]) >> rate
        self.used = min(n + 1, 63)


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
        self.new_models()

    def new_models(self):
        self.models = {}
        self.symbol_models = {}

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
        self._refill()
        one += (goal - one) * (131072 // (2 * used + 3)) >> 16
        self.models[model] = (one, min(used + 1, 250))
        return decision

    def symbol(self, *model):
        """A symbol, 0 to 15, by the symbol model of this name and these indices."""
        require(self.state is not None, "no symbols")
        if model not in self.symbol_models:
            self.symbol_models[model] = SymbolModel()
        model = self.symbol_models[model]
        slot, rest = self.state & 32767, self.state >> 15
        symbol = max(i for i in range(16) if model.starts[i] <= slot)
        start, end = model.starts[symbol : symbol + 2]
        self.state = (end - start) * rest + slot - start
        self._refill()
        model.update(symbol)
        return symbol

    def _refill(self):
        if self.state < 1 << 32:
            self.state = (self.state << 32) + self.words.number("I")

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

    def tree(self, bits, *models):
        """tree(M, bits), likewise."""
        node = 1
        for _ in range(bits):
            node = 2 * node + self.decide(*models, node)
        return node - (1 << bits)

    def large(self, *models):
        """number(M) of 6.4."""
        length = self.tree(6, *models)
        require(length <= 32, "length of a number")
        return length if length < 2 else (1 << (length - 1)) + self.raw(length - 1)

    def length(self, models, spread):
        """The length of a residual (section 7), and which model the second bit has."""
        near = self.symbol(models, "near")
        if near == 0:
            return 0, 0
        length = near + spread - 12
        which = near
        if near == 15:
            far = self.symbol(models, "far")
            length = far + spread - 27 if far > 0 else self.raw(7)
            which = 15 + far
        require(1 <= length <= 64, "length of a residual")
        return length, which

    def residual(self, models, spread):
        """A residual (section 7) and its grade. models: a tuple that names the set."""
        length, which = self.length(models, spread)
        if length == 0:
            return 0, 0
        relative = length - spread
        grade = 1 if relative < -7 else 2 if relative < -3 else 3
        negative = self.decide(models, "sign")
        size = 1
        if length >= 2:
            second = self.decide(models, "second", which)
            size = (2 + second << (length - 2)) + self.raw(length - 2)
        d = -size if negative else size
        return (d + (1 << 63)) % (1 << 64) - (1 << 63), grade


class RunningSpread:
    """The running spread (10.2)."""

    def __init__(self):
        self.sum = 80

    def spread(self):
        return self.sum >> 2

    def update(self, residual):
        self.sum += abs(residual).bit_length() - (self.sum >> 2)
