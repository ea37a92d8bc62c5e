# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The vertices of a chunk of a `.gtn` file: the lattice, meeting a vertex, and the search for
shared ones, sections 8.2, 8.5 and 8.13 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math

import numpy as np

from gtn_bytes import require
from gtn_coding import divide

INF = math.inf
F = np.float32  # Operations on such numbers are those of binary32.


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    )


def clamp(x, low, high):
    return max(low, min(x, high))


def square(v):
    return dot(v, v)


class Lattice:
    """Places of coordinates (8.2)."""

    def __init__(self, box):
        extent = 0.0
        for low, high in box:
            if high - low > extent:
                extent = high - low
        self.scale = divide(65535.0, extent)
        if not math.isfinite(self.scale):
            self.scale = 0.0
        self.low = [low for low, _ in box]

    def place(self, values):
        """A place, as binary32 numbers."""
        result = []
        for x, low in zip(values, self.low):
            w = (x - low) * self.scale
            w = (math.floor(w) if w < 65535 else 65535) if w > 0 else 0
            result.append(F(w / 256))
        return tuple(result)


def outwards(a, b):
    m = (a + b) // 2
    return sorted(range(a, b + 1), key=lambda i: (abs(i - m), i < m))


class Vertices:
    """The vertices of a chunk, by the numbers that they get when they are met:

    keys         of the coordinates of each vertex
    places       on the lattice
    shared       shared index of each vertex, or None if it is an own one
    users        masks of the chunks that use it
    records      of the own vertices, in order
    edge_log     pairs of vertices
    """

    def __init__(self, chunk, geometry, domains, shared_keys, shared_users):
        """chunk: its entry in TABL; shared_keys, shared_users: of the shared points."""
        self.chunk, self.geometry, self.domains = chunk, geometry, domains
        self.lattice = Lattice(chunk.box)
        self.shared_keys, self.shared_users = shared_keys, shared_users
        self.shared_places = [self.place_of(key) for key in shared_keys]
        self.shared_met = [False] * len(shared_keys)
        self.grid = self.make_grid()
        self.keys, self.places, self.shared, self.users = [], [], [], []
        self.records, self.edge_log = [], []

    def check_all_met(self):
        require(len(self.records) == self.chunk.own_points, "own points that were not met")
        require(all(self.shared_met), "shared points that were not met")

    def place_of(self, key):
        return self.lattice.place([domain.to_value(k) for domain, k in zip(self.domains, key)])

    def meet(self, key, place, shared, users):
        self.keys.append(key)
        self.places.append(place)
        self.shared.append(shared)
        self.users.append(users)
        return len(self.keys) - 1

    def meet_shared(self, index):
        require(index < len(self.shared_keys), "shared point that does not exist")
        require(not self.shared_met[index], "shared point that was met before")
        self.shared_met[index] = True
        key, users = self.shared_keys[index], self.shared_users[index]
        return self.meet(key, self.shared_places[index], index, users)

    def meet_own(self, record):
        require(len(self.records) < self.chunk.own_points, "too many own points")
        key = self.geometry.vertex(record, self.keys)
        self.records.append(record)
        return self.meet(key, self.place_of(key), None, 0)

    # ----- Shared vertices by their place (8.13)

    def make_grid(self):
        count = len(self.shared_keys)
        self.depth = clamp((count.bit_length() - 4) // 2, 0, 6)
        grid = {}
        for index, place in enumerate(self.shared_places):
            grid.setdefault(self.cell(place), []).append(index)
        return grid

    def cell(self, place):
        top = (1 << self.depth) - 1
        return tuple(clamp(math.floor(x * F(2.0 ** (self.depth - 8))), 0, top) for x in place)

    def search(self, m, limit, rank):
        """Hits near a place m as pairs of rank and index, in ascending order. rank: of a place and
        its squared distance."""
        radius = np.sqrt(limit)
        low, high = self.cell([x - radius for x in m]), self.cell([x + radius for x in m])
        hits = []
        patience = 512
        for z in outwards(low[2], high[2]):
            for y in outwards(low[1], high[1]):
                row = []
                for x in range(low[0], high[0] + 1):
                    row += self.grid.get((x, y, z), [])
                for four in range(0, len(row), 4):
                    for index in row[four : four + 4]:
                        self.look(index, m, limit, rank, hits)
                    patience -= 1
                    if patience == 0:
                        return hits
        return hits

    def look(self, index, m, limit, rank, hits):
        place = self.shared_places[index]
        distance = square(minus(place, m))
        if self.shared_met[index] or not distance <= limit:
            return
        rank = rank(place, distance)
        if rank != INF:
            hits.append((rank, index))
            hits.sort(key=lambda hit: hit[0])  # keeps the order of equal ones
            del hits[8:]
