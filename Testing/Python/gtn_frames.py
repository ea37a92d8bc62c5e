# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Coordinates in the frames of gates: section 9.4 of Documentation/format.md, in which names are the
same.

Part of gtn_decoder, which is written from that text alone.
"""

import math

from gtn_bytes import require
from gtn_coding import divide
from gtn_vertices import cross, dot, minus

HEIGHT, CENTER, FAR, ACROSS, ALONG = range(5)


def root(x):
    return math.sqrt(x) if x >= 0 else math.nan


class Frame:
    """The shape of a gate. known: the places of K[0] to K[6]."""

    def __init__(self, known):
        a, b, c, apex = known[:4]
        self.middle = [(x + y + z) * (1.0 / 3.0) for x, y, z in zip(a, b, c)]
        corners = [minus(p, self.middle) for p in (a, b, c)]
        u, v, w = minus(b, a), minus(c, a), minus(c, b)
        uu, vv, ww = dot(u, u), dot(v, v), dot(w, w)
        across = cross(u, v)
        nn = dot(across, across)
        inverse = divide(1.0, nn)
        self.normal, self.center, self.far = [0.0] * 3, [0.0] * 3, [0.0] * 3
        if nn > 0:
            unit = root(inverse)
            if dot(across, minus(a, apex)) < 0:
                unit = -unit
            self.normal = [x * unit for x in across]
        if uu * vv * ww * inverse * 0.75 <= uu + vv + ww:
            p, q = cross(v, across), cross(across, u)
            half = 0.5 * inverse
            self.center = [a[i] + (uu * p[i] + vv * q[i]) * half - self.middle[i] for i in range(3)]
        total = 0.0
        for k in range(3):
            far = minus(known[4 + k], self.middle)
            height = dot(self.normal, far)
            e, f = minus(far, corners[(k + 1) % 3]), minus(far, corners[(k + 2) % 3])
            ee, ff = dot(e, e), dot(f, f)
            total += divide(ee + ff, ee * ff)
            high = height if height > 0 else 0.0
            self.far = [x + high * y for x, y in zip(self.far, corners[k])]
        self.size = root(divide(6.0, total))


class Frames:
    """What a stream with frames has: five numbers. rules: how many rules there are."""

    def __init__(self, coded, domains, weights, rules):
        self.coded, self.domains, self.rules = coded, domains, rules
        require(weights[ACROSS] > 0 and weights[ALONG] > 0, "frame")
        self.weights = [w * 0.00390625 for w in weights]
        across, along = self.weights[ACROSS], self.weights[ALONG]
        self.stretch = along * along / (across * across) - 1.0

    def vertex(self, record, keys):
        """Keys of the next vertex, which is not a seed."""
        known = [[domain.to_number(k) for domain, k in zip(self.domains, keys[v])]
                 for v in record.known]
        frame = Frame(known)
        height = self.weights[HEIGHT] * frame.size
        of_far = divide(self.weights[FAR], frame.size)
        deviation = self.weights[ACROSS] * frame.size
        way, variance = 0.0, 1.0
        key = []
        for i, domain in enumerate(self.domains):
            n = frame.normal[i]
            place = (frame.middle[i] + height * n + self.weights[CENTER] * frame.center[i]
                     + of_far * frame.far[i])
            inverse = divide(1.0, variance)
            variance += self.stretch * (n * n)
            number = place + self.stretch * n * inverse * way
            error = deviation * root(variance * inverse)
            p = domain.from_number(number)
            distance = abs(domain.from_number(number - error if number < 0 else number + error) - p)
            spread = distance.bit_length()
            fraction = distance >> (spread - 3) & 3 if spread >= 3 else 0
            d, _ = self.coded.residual(("Frame", fraction), spread)
            key.append(domain.add(p, d))
            way += n * (domain.to_number(key[i]) - place)
        return tuple(key)
