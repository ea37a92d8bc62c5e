# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A plate with a hole as a mesh of triangles, on which the figures of the guide explain what Gatun does with
tetrahedra: partition, walk, prediction, merges."""

import collections
import heapq

import numpy as np
from matplotlib.tri import Triangulation

WIDTH, HEIGHT = 3.0, 2.0
HOLE, RADIUS = np.array([1.05, 1.05]), 0.38


def make_plate(spacing, seed=3):
    """Points and triangles, counterclockwise."""
    random = np.random.default_rng(seed)

    def side(begin, end):
        count = max(int(round(np.hypot(*np.subtract(end, begin)) / spacing)), 1)
        t = np.arange(count)[:, None] / count
        return np.asarray(begin) * (1 - t) + np.asarray(end) * t
    corners = [(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)]
    border = [side(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    angles = np.linspace(0, 2 * np.pi, int(2 * np.pi * RADIUS / spacing * 1.3), endpoint=False)
    rim = HOLE + RADIUS * np.stack([np.cos(angles), np.sin(angles)], 1)
    x, y = np.meshgrid(np.arange(spacing, WIDTH - spacing / 2, spacing),
                       np.arange(spacing, HEIGHT - spacing / 2, spacing * np.sqrt(3) / 2))
    x[1::2] += spacing / 2
    inner = np.stack([x.ravel(), y.ravel()], 1)
    inner += random.uniform(-0.27, 0.27, inner.shape) * spacing
    inner = inner[(np.hypot(*(inner - HOLE).T) > RADIUS + 0.45 * spacing)
                  & (inner.min(1) > 0.4 * spacing) & (inner[:, 0] < WIDTH - 0.4 * spacing)
                  & (inner[:, 1] < HEIGHT - 0.4 * spacing)]
    points = np.concatenate([*border, rim, inner])
    triangles = Triangulation(*points.T).triangles
    centers = points[triangles].mean(1)
    triangles = triangles[np.hypot(*(centers - HOLE).T) > RADIUS * 0.985]
    return points, triangles[np.abs(area(points, triangles)) > 1e-9]


def area(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


def field(points):
    """A smooth value with a front around the hole."""
    far = np.hypot(*(points - HOLE).T)
    return 1.5 * np.exp(-((far - RADIUS) / 0.5) ** 2) * (1 + 0.4 * np.sin(2 * points[:, 1])) + 0.25 * points[:, 0]


def bisect(points, triangles, parts):
    """The chunk of each triangle: centers are bisected along the longest axis."""
    centers = points[triangles].mean(1)
    chunk = np.zeros(len(triangles), int)

    def divide(members, first, count):
        if count == 1:
            chunk[members] = first
            return
        axis = int(np.argmax(np.ptp(centers[members], axis=0)))
        order = members[np.argsort(centers[members, axis], kind="stable")]
        divide(order[:len(order) // 2], first, count // 2)
        divide(order[len(order) // 2:], first + count // 2, count - count // 2)
    divide(np.arange(len(triangles)), 0, parts)
    return chunk


def edges_of(triangle):
    return [(triangle[i], triangle[(i + 1) % 3]) for i in range(3)]


def walk(triangles, seed):
    """Order in which triangles are met breadth-first over open edges, with the edge that led to each."""
    across = {edge: i for i, triangle in enumerate(triangles) for edge in edges_of(triangle)}
    order, gates = [seed], [None]
    seen = {seed}
    front = collections.deque(edges_of(triangles[seed]))
    while front:
        a, b = front.popleft()
        other = across.get((b, a))
        if other is None or other in seen:
            continue
        seen.add(other)
        order.append(other)
        gates.append((a, b))
        front.extend(edge for edge in edges_of(triangles[other]) if edge != (b, a))
    return order, gates


def open_edges(triangles, known):
    """The edges between known and unknown triangles, in the sense of the known ones."""
    across = {edge: i for i, triangle in enumerate(triangles) for edge in edges_of(triangle)}
    known = set(known)
    return [(a, b) for i in known for a, b in edges_of(triangles[i])
            if across.get((b, a)) is not None and across[(b, a)] not in known]


def merge(points, triangles, keep, weight=None):
    """Merges points into neighbors, the cheapest one first, until `keep` remain. No triangle turns over, and
    points of the border stay on it. A weight of each point raises its costs."""
    values = field(points)
    border = {p for edge in _border(triangles) for p in edge}
    corners = {i for i in border if min(np.abs(points[i] - c).sum() for c in (
        (0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT))) < 1e-9}
    cells = {i: list(triangle) for i, triangle in enumerate(triangles.tolist())}
    around = collections.defaultdict(set)
    for i, triangle in cells.items():
        for point in triangle:
            around[point].add(i)
    weight = np.ones(len(points)) if weight is None else weight

    def cost(a, b):
        bend = 0.0
        if a in border:
            if b not in border or a in corners or not _on_border(a, b, cells, around):
                return None
            bend = _bend(a, b, points, border, cells, around)
        for i in around[a] - around[b]:
            moved = [b if p == a else p for p in cells[i]]
            if area(points, np.array([moved]))[0] < 1e-4 * weight.min():
                return None
        shared = {p for i in around[a] for p in cells[i]} & {p for i in around[b] for p in cells[i]} - {a, b}
        if len(shared) != len(around[a] & around[b]):
            return None
        size = sum(area(points, np.array([cells[i]]))[0] for i in around[a])
        return weight[a] * (abs(values[a] - values[b]) * size + 0.002 * size + bend)

    heap = []

    def push(a):
        best = min(((c, b) for b in {p for i in around[a] for p in cells[i]} - {a}
                    if (c := cost(a, b)) is not None), default=None)
        if best:
            heapq.heappush(heap, (*best, a))
    alive = set(around)
    for a in sorted(alive):
        push(a)
    while len(alive) > keep and heap:
        was, b, a = heapq.heappop(heap)
        if a not in alive or b not in alive or cost(a, b) != was:
            if a in alive:
                push(a)
            continue
        for i in list(around[a]):
            cells[i] = [b if p == a else p for p in cells[i]]
            if len(set(cells[i])) < 3:
                for p in set(cells.pop(i)) - {a}:
                    around[p].discard(i)
            else:
                around[b].add(i)
        alive.discard(a)
        del around[a]
    return np.array(list(cells.values()))


def _border(triangles):
    edges = {edge for triangle in triangles for edge in edges_of(triangle.tolist())}
    return {(a, b) for a, b in edges if (b, a) not in edges}


def _on_border(a, b, cells, around):
    return len(around[a] & around[b]) == 1


def _bend(a, b, points, border, cells, around):
    """The area between the old border and the new one."""
    others = [p for i in around[a] for p in cells[i]
              if p in border and p not in (a, b) and len(around[a] & around[p]) == 1]
    return 3 * sum(abs(area(points, np.array([[a, b, p]]))[0]) for p in set(others))
