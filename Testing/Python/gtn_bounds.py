# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Values with a bound of errors: sections 5.5 and 10.7 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from types import SimpleNamespace as Record

from gtn_bytes import require
from gtn_coding import FLOAT32, FLOAT64, RunningSpread, divide

ABSOLUTE, RELATIVE, POINTWISE, BITS = 1, 2, 3, 4
LATTICE, KEEP_ZEROS = 1, 2
MOST_STEPS = 1 << 30


def read_bound(table, kind):
    """The bound of errors of a domain reference (5.5). kind: the type of the values."""
    bound = Record(kind=table.number("B"), flags=table.number("B"), bound=table.number("d"),
                   step=table.number("d"), reached=table.number("d"))
    require(ABSOLUTE <= bound.kind <= BITS, "kind of a bound")
    require(bound.flags <= LATTICE + KEEP_ZEROS, "flags of a bound")
    require(0 < bound.bound < math.inf and bound.reached >= 0, "bound of errors")
    is_floating = kind in (FLOAT32, FLOAT64)
    bound.rounds_keys = not is_floating or bound.kind >= POINTWISE
    if bound.rounds_keys:
        width = {1: 8, 2: 8, 3: 16, 4: 16, 5: 32, 6: 32, 7: 64, 8: 64, 9: 32, 10: 64}[kind]
        require(is_floating or bound.kind <= RELATIVE, "kind of a bound of integers")
        require(2 <= bound.step <= 2.0**53, "step of keys")
        require(bound.step == math.floor(bound.step), "step of keys that is no whole number")
        require(bound.step < 2**width, "step of keys that is too large for the type")
    else:
        require(bound.step > 0 and math.isfinite(2 * bound.step), "step of numbers")
    return bound


class BoundedValues:
    """The values of one component (10.7)."""

    def __init__(self, coded, domain, snap):
        self.coded, self.domain, self.bound = coded, domain, domain.bound
        self.snap = snap or bool(self.bound.flags & LATTICE)
        self.zero = domain.from_number(0.0)
        self.last = self.zero  # the key of the last finite number
        self.steps = {}  # by place
        self.mean = 256
        self.was = 0
        self.last_raw = 0
        self.running = RunningSpread()

    def finite(self, key):
        """The key whose number predictions use."""
        self.last = key if math.isfinite(self.domain.to_number(key)) else self.last
        return self.last

    def value(self, prediction, place, around, error=None):
        """prediction: a key, or a float; around: places; error: of a float, if it is known."""
        c, g, shift = self._context(around, prediction, error)
        special = self.coded.decide("special", self.was)
        self.was = special
        if special:
            return self._special(prediction)
        steps = self._steps(c, g, shift)
        kept = max(-MOST_STEPS, min(steps, MOST_STEPS))
        self.steps[place] = kept
        self.mean += 16 * abs(kept) - (self.mean >> 4)
        return self.key(prediction, steps)

    def _sixteenths(self, number, error):
        """What an error is in sixteenths of a step (10.10)."""
        if self.bound.rounds_keys:
            off = number - error if number < 0 else number + error
            error = float(abs(self.domain.from_number(off) - self.domain.from_number(number)))
        unit = self.bound.step if self.bound.rounds_keys else 2 * self.bound.step
        return int(min(divide(error * 16.0, unit), 2.0**40) + 0.5)

    def _context(self, around, prediction, error):
        known = [self.steps[place] for place in around if place in self.steps]
        size, total = sum(map(abs, known)), sum(known)
        mean = (32 * size + (self.mean >> 4)) // (2 * len(known) + 1)
        if error is not None:
            mean = self._sixteenths(prediction, error)
        length = mean.bit_length()
        c = length if length <= 1 else min(2 * length - 2 + (mean >> length - 2 & 1), 31)
        return c, 1 if total < 0 else 2 if total > 0 else 0, max(length - 6, 0)

    def _steps(self, c, g, shift):
        coded = self.coded
        q = 0
        if coded.decide("not zero", c, g):
            negative = coded.decide("negative", c, g)
            i = 0
            while i < 14 and coded.decide("more", c, i):
                i += 1
            q = i + 1
            if i == 14:
                length = coded.tree(6, "length of steps")
                require(1 <= length <= 47, "length of steps")
                q = 14 + (1 << length - 1) + coded.raw(length - 1)
            q = -q if negative else q
        return signed((q << shift) + coded.raw(shift))

    def key(self, prediction, steps):
        """The key that is so many steps away."""
        bound, domain = self.bound, self.domain
        if bound.rounds_keys:
            step = int(bound.step)
            p = self._key_of(prediction)
            if self.snap:
                return self.zero + signed(self._index(p, step) + steps) * step & domain.mask
            return p + steps * step & domain.mask
        x = prediction if isinstance(prediction, float) else domain.to_number(prediction)
        x = x if math.isfinite(x) else 0.0
        width = 2 * bound.step
        if not self.snap:
            return domain.from_number(x + float(steps) * width)
        y = divide(x, width)
        i = -floor(0.5 - y) if y < 0 else floor(y + 0.5)
        i = i if abs(i) < 2.0**51 else 0.0
        return domain.from_number((i + float(steps)) * width)

    def _index(self, key, step):
        j, rest = divmod(abs(key - self.zero), step)
        j += rest > (step - 1) // 2
        return -j if key < self.zero else j

    def _key_of(self, prediction):
        is_number = isinstance(prediction, float)
        return self.domain.from_number(prediction) if is_number else prediction

    def _special(self, prediction):
        kind = self.coded.tree(2, "kind")
        if kind == 0:
            return self.zero
        if kind == 1:
            d, _ = self.coded.residual("special", self.running.spread())
            self.running.update(d)
            return self.domain.add(self._key_of(prediction), d)
        if kind == 2:
            self._take_raw()
        return self.last_raw

    def plain_special(self):
        """A value without steps in the mode plain quadratic (10.11)."""
        kind = self.coded.raw(2)
        require(kind <= 2, "kind of a value without steps")
        if kind == 2:
            self._take_raw()
        return self.last_raw if kind > 0 else self.zero

    def _take_raw(self):
        bits = self.domain.bits
        low = self.coded.raw(min(bits, 32))
        self.last_raw = low if bits <= 32 else low + (self.coded.raw(bits - 32) << 32)


def signed(number):
    return (number + (1 << 63)) % (1 << 64) - (1 << 63)


def floor(x):
    return float(math.floor(x)) if math.isfinite(x) else x
