# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The quadratic spatial modes of `.gtn` files: sections 10.8 to 10.11 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math

import numpy as np

from gtn_coding import divide

F = np.float32  # Operations on such numbers are those of binary32.
MOST, EDGES = 24, 32
MOST_CELLS, LAST_CELLS, MOST_CORNERS = 16, 16, 66
BEFORE, IN_BOX = 8, 32


def offset(place, center):
    x, y, z = (a - b for a, b in zip(place, center))
    return x, y, z


def rank(place, center):
    """The squared distance in binary32 (10.8)."""
    x, y, z = offset(place, center)
    square = float(F(x * x + y * y + z * z))
    return math.inf if math.isnan(square) else square


def nearest(center, candidates, places, most=MOST):
    """The nearest of some places around another one, in their order (10.8)."""
    with np.errstate(all="ignore"):
        ranked = sorted((rank(places[u], places[center]), u) for u in set(candidates) - {center})
    return [u for _, u in ranked[:most]]


def find_neighbors(edge_log, own, places):
    """The neighbors of each own vertex (10.8). own: numbers of the own vertices, in order."""
    known = [[] for _ in places]
    is_own = [False] * len(places)
    for v in own:
        is_own[v] = True
    for pair in edge_log:
        a, b = max(pair), min(pair)
        if is_own[a]:
            known[a].append(b)
        else:
            known[b].append(a)
            if not is_own[b]:
                known[a].append(b)
    result = []
    for v in own:
        ring = known[v][-EDGES:]
        candidates = ring + [w for u in ring for w in known[u][-EDGES:]]
        result.append(nearest(v, candidates, places))
        for u in list(known[v]):
            known[u].append(v)
    return result


def find_cell_places(cells, points):
    """The places of cells (10.8). cells: the vertices of each one."""
    result = []
    for corners in cells:
        total = [0.0] * 3
        for v in sorted(corners):
            total = [t + x for t, x in zip(total, points[v])]
        result.append([divide(t, float(len(corners))) for t in total])
    return result


def find_cell_neighbors(cells, places):
    """The neighbors of each cell (10.8)."""
    last, result = {}, []
    for i, corners in enumerate(cells):
        near = corners if len(corners) <= MOST_CORNERS else ()
        candidates = [u for v in near for u in last.get(v, ())[-LAST_CELLS:]]
        result.append(nearest(i, candidates, places, MOST_CELLS))
        for v in corners:
            last.setdefault(v, []).append(i)
    return result


def find_block_neighbors(places):
    """The neighbors of each point of a block (10.8)."""
    size = 1
    while size < 64 and 24 * size * size <= len(places):
        size *= 2
    low, extent = [math.inf] * 3, 0.0
    for k in range(3):
        high = -math.inf
        for place in places:
            low[k] = place[k] if place[k] < low[k] else low[k]
            high = place[k] if place[k] > high else high
        extent = high - low[k] if high - low[k] > extent else extent
    scale = divide(float(size), extent)
    scale = scale if scale < math.inf else 0.0

    def index(a, k):
        x = (a - low[k]) * scale
        return min(int(min(x, 64.0)), size - 1) if x > 0 else 0

    boxes, result = {}, []
    for v, place in enumerate(places):
        at = [index(a, k) for k, a in enumerate(place)]
        candidates = list(range(max(v - BEFORE, 0), v))
        for dx in (-1, 0, 1):
            for dy in (-1, 0, 1):
                for dz in (-1, 0, 1):
                    box = at[0] + dx, at[1] + dy, at[2] + dz
                    candidates += boxes.get(box, ())[-IN_BOX:]
        result.append(nearest(v, candidates, places))
        boxes.setdefault(tuple(at), []).append(v)
    return result


# Weights of many places at once (10.9): each number is an array over these places, of binary32 but
# for coordinates. Lists over the neighbors are as long as the longest one; exists tells for each of
# their entries which places have it, and what others have there is 0, which changes no sum.


def solve(m):
    """g with m g = (0, ..., 0, 1); m: the lower half of a matrix (10.9)."""
    n = len(m)
    m = [row + [F(0)] * (n - len(row)) for row in m]
    g = [F(0)] * n
    for j in range(n):
        for k in range(j):
            m[j][j] = m[j][j] - m[j][k] * m[k][j]
        inverse = F(1) / m[j][j]
        g[j] = inverse
        for r in range(j + 1, n):
            v = m[r][j]
            for k in range(j):
                v = v - m[r][k] * m[k][j]
            m[j][r] = v
            m[r][j] = v * inverse
    for j in range(n - 2, -1, -1):
        v = F(0)
        for k in range(j + 1, n):
            v = v - m[k][j] * g[k]
        g[j] = v
    return g


def offsets_of(center, places, exists):
    """Offsets of neighbors in binary32, 0 if they cannot be used."""
    total = 0.0
    for place, has in zip(places, exists):
        x, y, z = offset(place, center)
        total = total + np.where(has, x * x + y * y + z * z, 0.0)
    mean = total / sum(exists)
    is_usable = (mean > 0) & (mean < math.inf)
    scale = 1.0 / np.sqrt(mean)
    return [tuple(np.where(has & is_usable, a * scale, 0.0).astype(F) for a in offset(place, center))
            for place, has in zip(places, exists)]


def whitened(offsets, exists):
    xx = xy = xz = yy = yz = zz = F(0)
    for x, y, z in offsets:
        xx, xy, xz = xx + x * x, xy + x * y, xz + x * z
        yy, yz, zz = yy + y * y, yz + y * z, zz + z * z
    part = F(3) / sum(exists).astype(F)
    ridge = F(0.01) * (xx * part + yy * part + zz * part)
    a = F(1) / np.sqrt(xx * part + ridge)
    xy_a = xy * part * a
    xz_a = xz * part * a
    b = F(1) / np.sqrt(yy * part + ridge - xy_a * xy_a)
    yz_b = (yz * part - xy_a * xz_a) * b
    c = F(1) / np.sqrt(zz * part + ridge - xz_a * xz_a - yz_b * yz_b)
    result = []
    for (x, y, z), has in zip(offsets, exists):
        x = x * a
        y = (y - xy_a * x) * b
        z = (z - xz_a * x - yz_b * y) * c
        result.append(tuple(np.where(has, value, F(0)) for value in (x, y, z)))
    return result


def nearness(x, y, z, has):
    return np.where(has, F(1) / (x * x + y * y + z * z + F(0.001)), F(0))


# Exponents of the functions 0 to 9, of which the last is 1, and of the smooth fit.
QUADRATIC = ["xx", "xy", "xz", "yy", "yz", "zz", "x", "y", "z", ""]
LINEAR = ["x", "y", "z", ""]


def quadratic_sums(h, x, y, z, sums):
    """Adds h times all monomials up to the degree of 4 (10.9)."""
    square = {"xx": x * x, "xy": x * y, "xz": x * z, "yy": y * y, "yz": y * z, "zz": z * z}
    terms = {"": h, "x": h * x, "y": h * y, "z": h * z}
    h2 = {name: h * value for name, value in square.items()}
    terms.update(h2)
    last = {"x": x, "y": y, "z": z}
    for name in ("xxx", "xxy", "xxz", "xyy", "xyz", "xzz", "yyy", "yyz", "yzz", "zzz"):
        terms[name] = h2[name[:2]] * last[name[2]]
    for name in ("xxxx", "xxxy", "xxxz", "xxyy", "xxyz", "xxzz", "xyyy", "xyyz", "xyzz", "xzzz",
                 "yyyy", "yyyz", "yyzz", "yzzz", "zzzz"):
        terms[name] = h2[name[:2]] * square[name[2:]]
    for name, value in terms.items():
        sums[name] = sums.get(name, F(0)) + value


def fit_quadratic(offsets, exists):
    sums, h = {}, []
    for (x, y, z), has in zip(offsets, exists):
        near = nearness(x, y, z, has)
        h.append(near * near * near)
        quadratic_sums(h[-1], x, y, z, sums)
    m = [[sums["".join(sorted(f + e))] for e in QUADRATIC[: i + 1]]
         for i, f in enumerate(QUADRATIC)]
    for i in range(9):
        m[i][i] = m[i][i] + (F(0.001) if i < 6 else F(0.0001))
    g = solve(m)
    return [
        w * (g[9] + x * g[6] + y * g[7] + z * g[8] + x * x * g[0] + x * y * g[1] + x * z * g[2]
             + y * y * g[3] + y * z * g[4] + z * z * g[5])
        for w, (x, y, z) in zip(h, offsets)]


def fit_linear(offsets, exists):
    sums, h = {name: F(0) for name in ("", *QUADRATIC)}, []
    for (x, y, z), has in zip(offsets, exists):
        near = nearness(x, y, z, has)
        w = near * near
        h.append(w)
        wx, wy, wz = w * x, w * y, w * z
        for name, value in (("", w), ("x", wx), ("y", wy), ("z", wz), ("xx", wx * x),
                            ("xy", wx * y), ("xz", wx * z), ("yy", wy * y), ("yz", wy * z),
                            ("zz", wz * z)):
            sums[name] = sums[name] + value
    m = [[sums["".join(sorted(f + e))] for e in LINEAR[: i + 1]] for i, f in enumerate(LINEAR)]
    for i in range(3):
        m[i][i] = m[i][i] + F(0.001)
    g = solve(m)
    return [w * (g[3] + x * g[0] + y * g[1] + z * g[2]) for w, (x, y, z) in zip(h, offsets)]


def checked(weights, exists):
    total = F(0)
    for w, has in zip(weights, exists):
        total = total + np.where(has, abs(w), F(0))
    return [np.where(total <= F(10000), w, F(1) / sum(exists).astype(F)) for w in weights]


def find_weights(center, places, exists, has_error):
    """Quadratic and linear weights, and shares (10.9). center: x, y, z; places: the same of each
    neighbor; has_error: whether each one is an own vertex."""
    with np.errstate(all="ignore"):
        offsets = offsets_of(center, places, exists)
        shares, total = [], F(0)
        for (x, y, z), has in zip(offsets, has_error & exists):
            share = has.astype(F) / (x * x + y * y + z * z + F(0.3))
            shares.append(share)
            total = total + share
        shares = [np.where(total > 0, share / total, share) for share in shares]
        offsets = whitened(offsets, exists)
        quadratic, linear = fit_quadratic(offsets, exists), fit_linear(offsets, exists)
        return checked(quadratic, exists), checked(linear, exists), shares


def blend(a, b, c, errors):
    """The mean of three predictions by their errors (10.10)."""
    errors = [error + 1e-300 for error in errors]
    best = min(errors)
    weights = []
    for error in errors:
        relative = best / error
        square = relative * relative
        weights.append(square * square)
    u, v, w = weights
    return a + (v * (b - a) + w * (c - a)) / (u + v + w)


class Lists:
    """Neighbors, their quadratic and linear weights, and shares of each place to decode."""

    def __init__(self, lists, centers, places, is_shared=None):
        self.lists = [([], [], [], [])] * len(lists)
        some = [i for i, found in enumerate(lists) if found]
        if not some:
            return
        places = np.array(places, float)
        has_error = np.ones(len(places), bool) if is_shared is None else ~np.array(is_shared, bool)
        most = max(len(lists[i]) for i in some)
        exists = np.array([[k < len(lists[i]) for i in some] for k in range(most)])
        neighbors = np.array([lists[i] + [0] * (most - len(lists[i])) for i in some]).T
        weights = find_weights(
            places[[centers[i] for i in some]].T, [places[u].T for u in neighbors], exists,
            has_error[neighbors])
        for i, *of_place in zip(some, *(np.array(w, float).T.tolist() for w in weights)):
            self.lists[i] = lists[i], *of_place

    def __getitem__(self, i):
        return self.lists[i]


class Predictor:
    """Predicts the numbers of one component (10.10)."""

    def __init__(self, lists, count, other):
        """other: a function of i and of the numbers that gives what another rule predicts."""
        self.lists, self.other = lists, other
        self.numbers = [0.0] * count
        self.errors = [(0.0,) * 4] * count
        self.last = self.last_shared = 0.0

    def set_shared(self, v, number):
        if math.isfinite(number):
            self.last_shared = number
        self.numbers[v] = self.last_shared

    def predict(self, i):
        """Number, expected error or None, and whether there are neighbors."""
        neighbors, quadratic, linear, shares = self.lists[i]
        if not neighbors:
            self.predicted = (self.last,) * 4
            return self.last, None, False
        first = self.numbers[neighbors[0]]
        a = b = total = 0.0
        errors = [0.0] * 4
        for u, wa, wb, share in zip(neighbors, quadratic, linear, shares):
            difference = self.numbers[u] - first
            a += wa * difference
            b += wb * difference
            errors = [e + share * known for e, known in zip(errors, self.errors[u])]
            total += share
        a, b = (s if math.isfinite(s) else first for s in (first + a, first + b))
        other = self.other(i, self.numbers)
        c = other if other is not None and math.isfinite(other) else a
        number = blend(a, b, c, errors[:3])
        number = number if math.isfinite(number) else first
        self.predicted = (a, b, c, number)
        return number, errors[3] if total > 0 else None, True

    def learn(self, v, number):
        number = number if math.isfinite(number) else self.predicted[3]
        errors = (abs(number - p) for p in self.predicted)
        self.errors[v] = tuple(e if e <= 1e300 else 1e300 for e in errors)
        self.numbers[v] = self.last = number


class PlainPredictor(Predictor):
    """Predicts by the quadratic function alone (10.11)."""

    def predict(self, i):
        neighbors, weights, _, _ = self.lists[i]
        number = self.last
        if neighbors:
            first, sums = self.numbers[neighbors[0]], [0.0] * 4
            for k, (u, weight) in enumerate(zip(neighbors, weights)):
                sums[k % 4] += weight * (self.numbers[u] - first)
            number = first + ((sums[0] + sums[1]) + (sums[2] + sums[3]))
            number = number if math.isfinite(number) else first
        self.predicted = (number,) * 4
        return number, None, bool(neighbors)


def decode_component(stream, predictor, domain, own, now, before):
    """Values of a quadratic mode (10.10, 10.11). own: the places to decode, in order; keys at
    others are in now. before: None without the temporal mode change."""
    base = [0.0] * len(now) if before is None else [domain.to_number(k) for k in before]
    for v in sorted(set(range(len(now))) - set(own)):
        predictor.set_shared(v, domain.to_number(now[v]) - base[v])
    for i, v in enumerate(own):
        difference, error, has_neighbors = predictor.predict(i)
        group = 1 if has_neighbors else 0
        if math.isfinite(base[v]):
            now[v] = stream.guess(base[v] + difference, error, group, v)
        else:
            now[v] = stream.value(before[v], group, None, v)
        predictor.learn(v, domain.to_number(now[v]) - base[v])


def decode_places(stream, kind, lists, domain, parents, count, before):
    """Values on all cells of a chunk or, without parents, on all points of a block."""
    def other(i, numbers):
        start = i - 1 if parents is None or parents[i] is None else parents[i]
        return numbers[start] if start >= 0 else None

    now = [None] * count
    decode_component(stream, kind(lists, count, other), domain, range(count), now, before)
    return now
