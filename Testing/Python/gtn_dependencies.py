# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Dependencies between merges: section 13.9 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import Bytes, require
from gtn_coding import Coded, RunningSpread
from gtn_tree import decode_parts

TRIANGLE = 5
MOST_NEAR = 8
MOST_PER_MERGE = 64


class DependencyDecoder:
    """The state while dependencies are decoded."""

    def __init__(self, stream, points, merges):
        self.coded = Coded(Bytes(stream))
        self.points = points
        self.into = [[] for _ in range(points)]
        self.near = [[] for _ in range(points)]
        self.spreads = [RunningSpread(), RunningSpread()]
        self.room = MOST_PER_MERGE * len(merges)
        self.result = [self.merge(k, a, b) for k, (a, b, _) in enumerate(merges)]

    def merge(self, k, a, b):
        points = self.decode_points(a, b)
        found = set()
        for p in points:
            self.decode_merges(self.into[p], found)
        for i, p in enumerate(points):
            self.meet(b, p)
            for q in points[:i]:
                self.meet(q, p)
        for q in reversed(list(self.near[a])):
            self.meet(b, q)
        self.into[b].append(k)
        return sorted(found)

    def candidates(self, a, b):
        """Points with their sources, from that which was merged into last."""
        sources = {}
        named = [(b, 0), (a, 1)] + [(p, 2) for p in self.near[a]] + [(p, 3) for p in self.near[b]]
        for p, source in named:
            if self.into[p]:
                first = sources.setdefault(p, source)
                if first == 2 and source == 3:
                    sources[p] = 4
        return sorted(sources.items(), key=lambda item: -self.into[item[0]][-1])

    def decode_points(self, a, b):
        points = [p for i, (p, source) in enumerate(self.candidates(a, b))
                  if self.coded.decide("needed", source, min(i, 9))]
        count = self.coded.tree(3, "few", min(len(points), 3))
        if count == 7:
            count += self.coded.large("many")
        at = a
        for i in range(count):
            which = min(i, 1)
            d, _ = self.coded.residual(("step", which), self.spreads[which].spread())
            self.spreads[which].update(d)
            require(i == 0 or d > 0, "points do not ascend")
            at += d
            require(0 <= at < self.points, "no such point")
            points.append(at)
        return points

    def decode_merges(self, into, found):
        place = len(into) - 1 - self.number(0)
        while True:
            require(place >= 0, "no such merge")
            found.add(into[place])
            self.take(1)
            if place == 0:
                return
            step = self.number(1)
            if step == 0:
                return
            place -= step

    def number(self, which):
        """Skipped[which]. Counts the merges that are skipped."""
        number = self.coded.large("skipped", which)
        self.take(max(0, number - which))
        return number

    def take(self, count):
        self.room -= count
        require(self.room >= 0, "too many dependencies")

    def meet(self, p, q):
        if p != q:
            for one, other in ((p, q), (q, p)):
                rest = [x for x in self.near[one] if x != other]
                self.near[one] = [other, *rest][:MOST_NEAR]


def decode_dependencies(stream, points, merges):
    """Of each merge the earlier ones that it is said to depend on, ascending."""
    return DependencyDecoder(stream, points, merges).result


def decode_all_dependencies(whole, first):
    """Those of the merges from a part on, or None if they are not stored. whole: the decoder of the
    file."""
    parts = [part for part in whole.container.tree.parts[first:] if part.merges > 0]
    if not parts or any(part.dependencies is None for part in parts):
        return None
    result = []
    for i in reversed(range(len(parts))):
        merges, _ = decode_parts(whole, first + i)
        own = decode_dependencies(
            whole.stream(parts[i].dependencies), parts[i].all_points, merges)
        count = parts[i].merges
        later = [[j + count for j in earlier] for earlier in result]
        result = own[:count] + [a + b for a, b in zip(own[count:], later)]
    return result


def find_dependencies(cells, merges):
    """All dependencies, by doing all merges. cells: lists of corners."""
    cells = [list(cell) if len(set(cell)) == len(cell) else None for cell in cells]
    around = {}
    for number, cell in enumerate(cells):
        for corner in cell or ():
            around.setdefault(corner, set()).add(number)
    changed = [set() for _ in cells]  # by which merge last, and what bared it since
    result = []
    for k, (point, into, _) in enumerate(merges):
        ring = around.pop(point, set())
        result.append(set().union(*(changed[cell] for cell in ring)))
        bared = []
        for number in ring:
            rest = set(cells[number]) - {point, into}
            if into in cells[number] and not any(
                    other != number and rest <= set(cells[other]) for other in ring):
                bared += [other for other in around[into] - ring if rest <= set(cells[other])]
        for number in bared:
            changed[number].add(k)
        for number in ring:
            if into in cells[number]:
                for corner in set(cells[number]) - {point}:
                    around[corner].remove(number)
                cells[number] = None
            else:
                cells[number] = [into if corner == point else corner for corner in cells[number]]
                around.setdefault(into, set()).add(number)
                changed[number] = {k}
    return result


def join_bound(dependencies, bonds):
    """Merges that are bound together depend on the same ones before them, and on one another."""
    first = 0
    for k, bond in enumerate(bonds):
        if not bond:
            common = {j for one in dependencies[first:k + 1] for j in one if j < first}
            if k > first:
                for i in range(first, k + 1):
                    dependencies[i] = common | set(range(first, i))
            first = k + 1
    return dependencies


def close(dependencies):
    """Of each merge all that it depends on, directly or not."""
    result = []
    for earlier in dependencies:
        result.append(set(earlier).union(*(result[j] for j in earlier)))
    return result


def check_dependencies(decoder):
    """Whether the dependencies of a file are those of its mesh."""
    if decoder.dependencies is None:
        return
    if decoder.container.is_surface:
        cells = [points for kind, points, _ in decoder.cells() if kind == TRIANGLE]
    else:
        cells = decoder.tets().tolist()
    found = join_bound(find_dependencies(cells, decoder.merges), decoder.bonds)
    require(close(decoder.dependencies) == close(found), "dependencies of another mesh")
