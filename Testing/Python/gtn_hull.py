# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
"""The faces of convex point sets (15.3 of format.md)."""

import itertools
import math


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def hull_faces(places):
    """Faces by the positions of their corners in places."""
    if not 4 <= len(places) <= 64 or not all(map(math.isfinite, itertools.chain(*places))):
        return []
    low = [min(axis) for axis in zip(*places)]
    high = [max(axis) for axis in zip(*places)]
    size = max(b - a for a, b in zip(low, high))
    if size == 0 or math.isinf(size):
        return []
    tolerance = max(1e-6, 2.0**-22 * max(map(abs, itertools.chain(*places))) / size)
    p = [tuple((x - a) / size for x, a in zip(place, low)) for place in places]
    points = [i for i in range(len(p)) if p.index(p[i]) == i]

    found, faces = [], []
    for i, j, k in itertools.combinations(points, 3):
        if any({i, j, k} <= face for face in found):
            continue
        u = subtract(p[j], p[i])
        n = cross(u, subtract(p[k], p[i]))
        length = math.sqrt(dot(n, n))
        if length < tolerance:
            continue
        d = {q: dot(n, subtract(p[q], p[i])) / length for q in points}
        above = any(x > tolerance for x in d.values())
        below = any(x < -tolerance for x in d.values())
        if above == below:
            continue
        if above:
            n = tuple(-x for x in n)
        inside = [q for q in points if abs(d[q]) <= tolerance]
        found.append(set(inside))
        v = cross(n, u)
        scale = math.sqrt(dot(u, u) / dot(v, v))
        faces.append(polygon({q: (dot(p[q], u), dot(p[q], v) * scale) for q in inside}))
    return faces


def polygon(places):
    """The convex hull in a plane."""
    order = sorted(places, key=lambda q: (*places[q], q))
    chain = []

    def put(c, first):
        while len(chain) >= first + 2:
            (ua, va), (ub, vb), (uc, vc) = (places[q] for q in (*chain[-2:], c))
            if (ub - ua) * (vc - va) - (vb - va) * (uc - ua) > 0:
                break
            chain.pop()
        chain.append(c)

    for q in order:
        put(q, 0)
    turn = len(chain) - 1
    for q in order[-2::-1]:
        put(q, turn)
    return chain[:-1]
