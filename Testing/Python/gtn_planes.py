# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Coordinates on planes: section 7.4 of Documentation/cell-codec.md, in which names are the same.

Part of gtn_decoder, which is written from that text alone.
"""

import math

from gtn_coding import divide
from gtn_vertices import clamp, cross, minus

N1, N2, D12 = 0, 1, 3
PLANES, REPEATS = 1, 3


def smaller(a, b):
    return b if b < a else a


def larger(a, b):
    return b if a < b else a


class Frame:
    """The plane and the size of the triangles at an edge ab, with c behind and d ahead."""

    def __init__(self, a, b, c, d):
        edge = minus(b, a)
        ahead, behind = cross(edge, minus(d, a)), cross(minus(c, a), edge)
        self.normal = [2.0 * p + q for p, q in zip(ahead, behind)]
        self.extent = 0.0
        for x, y, z in zip(a, b, c):
            length = larger(larger(x, y), z) - smaller(smaller(x, y), z)
            self.extent = larger(self.extent, length)
        sizes = [abs(x) for x in self.normal]
        last = 1 if sizes[1] > sizes[0] else 0
        last = 2 if sizes[2] > sizes[last] else last
        self.axes = [axis for axis in range(3) if axis != last] + [last]


class Planes:
    """What a stream of a chunk on planes remembers."""

    def __init__(self, coded, domains, repeats):
        self.coded, self.domains, self.repeats = coded, domains, repeats
        self.mean = 128
        self.levels, self.repeated = [], []  # of each vertex

    def can_code(self, record):
        return record.slots[N2] is not None and record.slots[D12] is not None

    def meet_until(self, count):
        """The vertices met before vertex number `count` that were not coded here."""
        while len(self.levels) < count:
            self.levels.append(self.mean >> 4)
            self.repeated.append(set())

    def vertex(self, record, group, place, keys):
        """Keys of the next vertex. place: the numbers that the rule predicts."""
        corners = [record.slots[slot] for slot in (N1, N2, D12)]
        numbers = [[domain.to_number(k) for domain, k in zip(self.domains, keys[v])]
                   for v in corners]
        frame = Frame(*numbers, place)
        level = (sum(self.levels[v] for v in corners) + 2) // 3
        key = [None] * 3
        own_level, own_repeated = None, set()
        grade, shift = 0, 0.0
        for k, i in enumerate(frame.axes):
            domain = self.domains[i]
            if self.repeats:
                key[i] = self._repeat(i, len(own_repeated), corners, [keys[v][i] for v in corners])
            if key[i] is not None:
                own_repeated.add(i)
            else:
                number = place[i]
                if k == 2:
                    height = place[i] - divide(shift, frame.normal[i])
                    number = height if math.isfinite(height) else place[i]
                p, far = domain.from_number(number), domain.from_number(number + frame.extent)
                spread = abs(far - p).bit_length()
                models = ("Normal", level, grade) if k == 2 else ("Along", k, group, grade)
                d, new_grade = self.coded.residual(models, spread)
                grade = max(grade, new_grade)
                key[i] = domain.add(p, d)
                if k == 2:
                    length = abs(d).bit_length()
                    own_level = 0 if d == 0 else clamp(length - spread + 12, 1, 15)
                    self.mean += own_level - (self.mean >> 4)
            shift += frame.normal[i] * (domain.to_number(key[i]) - place[i])
        self.levels.append(self.mean >> 4 if own_level is None else own_level)
        self.repeated.append(own_repeated)
        return tuple(key)

    def _repeat(self, axis, number, corners, known):
        """The key of a corner, or None."""
        a, b, c = known
        equal = int(a == b) + 2 * int(a == c) + 4 * int(b == c)
        context = (number, *(int(axis in self.repeated[v]) for v in corners[:2]), equal)
        if not self.coded.decide("IsRepeated", *context):
            return None
        if self.coded.decide("IsFirst", *context):
            return a
        if equal == 1 or equal == 0 and not self.coded.decide("IsSecond", *context):
            return c
        return b
