"""Meshes and volumes for the other programs of this folder, as NumPy arrays."""

import sys

import numpy as np


def make_cube(n):
    """Points of a cube from -1 to 1 with n along each edge, and six tetrahedra for each of its cells."""
    x = np.linspace(-1, 1, n)
    points = np.stack(np.meshgrid(x, x, x, indexing="ij"), axis=-1).reshape(-1, 3)
    ids = np.arange(n**3).reshape(n, n, n)
    ends = (slice(None, -1), slice(1, None))
    corners = [ids[a, b, c].ravel() for a in ends for b in ends for c in ends]
    around = [(1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)]
    tets = [np.stack([corners[i] for i in (0, p, q, 7)], axis=1) for p, q in around]
    return points, np.concatenate(tets)


def find_knot(points):
    """The distance of points from a trefoil knot, and the place along it, from 0 to 2 pi."""
    s = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    knot = np.stack(
        [np.sin(s) + 2 * np.sin(2 * s), np.cos(s) - 2 * np.cos(2 * s), -np.sin(3 * s)], axis=1
    )
    knot *= 0.25
    nearest = np.full(len(points), np.inf)
    place = np.zeros(len(points))
    for t, position in zip(s, knot):
        square = ((points - position) ** 2).sum(axis=1)
        nearer = square < nearest
        nearest[nearer] = square[nearer]
        place[nearer] = t
    return np.sqrt(nearest), place


def make_knot(n=30):
    """A cube of tetrahedra, with a value that is high along a knot."""
    points, tets = make_cube(n)
    distance, _ = find_knot(points)
    return points.astype(np.float32), tets, np.exp(-40 * distance**2).astype(np.float32)


def make_pipe(around=32, across=10, along=60):
    """A bent pipe of hexahedra, with the temperature of its wall."""
    angle = np.linspace(0, 2 * np.pi, around, endpoint=False)
    radius = np.linspace(0.25, 0.5, across)
    bend = np.linspace(0, 1.5 * np.pi, along)
    s, r, a = np.meshgrid(bend, radius, angle, indexing="ij")
    ring = 1.2 + r * np.cos(a)
    points = np.stack([ring * np.cos(s), ring * np.sin(s), r * np.sin(a)], axis=-1)
    heat = 20 + 180 * np.exp(-0.4 * s - 8 * (r - 0.25)) * (1 + 0.3 * np.cos(3 * a + 4 * s))
    ids = np.arange(s.size).reshape(s.shape)
    ids = np.concatenate([ids, ids[:, :, :1]], axis=2)  # around the pipe
    ends = (slice(None, -1), slice(1, None))
    order = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [ids[ends[i], ends[j], ends[k]].ravel() for i, j, k in order]
    return points.reshape(-1, 3), np.stack(cells, axis=1), heat.ravel()


def make_shell(n=120):
    """A closed surface of triangles with ridges, and its height."""
    theta = np.linspace(1e-3, np.pi - 1e-3, n)
    phi = np.linspace(0, 2 * np.pi, 2 * n, endpoint=False)
    t, p = np.meshgrid(theta, phi, indexing="ij")
    height = 0.12 * np.sin(7 * p + 5 * np.cos(t)) * np.sin(t) ** 2 + 0.06 * np.cos(9 * t)
    r = 1 + height
    points = np.stack([r * np.sin(t) * np.cos(p), r * np.cos(t), r * np.sin(t) * np.sin(p)], axis=-1)
    ids = np.arange(t.size).reshape(t.shape)
    ids = np.concatenate([ids, ids[:, :1]], axis=1)
    a, b, c, d = ids[:-1, :-1].ravel(), ids[1:, :-1].ravel(), ids[1:, 1:].ravel(), ids[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, d, b], axis=1), np.stack([b, d, c], axis=1)])
    return points.reshape(-1, 3), triangles, height.ravel()


def make_volume(n=72):
    """Voxels of a body with organs, as of a scan."""
    x = np.linspace(-1, 1, n)
    z, y, x = np.meshgrid(x, x, x, indexing="ij")
    values = np.zeros((n, n, n))
    for center, size, value in [
        ((0, 0, 0), (0.75, 0.9, 0.65), 300),
        ((0, 0, 0), (0.68, 0.83, 0.58), -180),
        ((-0.3, 0.2, 0), (0.22, 0.4, 0.3), 250),
        ((0.33, 0.3, 0.1), (0.22, 0.25, 0.25), 350),
        ((0.25, -0.4, -0.1), (0.2, 0.2, 0.2), 450),
        ((0, 0, -0.35), (0.09, 0.8, 0.09), 800),
    ]:
        offset = [(c - m) / s for c, m, s in zip((x, y, z), center, size)]
        values += value / (1 + np.exp(25 * (np.sqrt(sum(o**2 for o in offset)) - 1)))
    return np.rint(values).astype(np.int16)


def get_folder():
    """The folder to write to: the argument of the program, or else this one."""
    return sys.argv[1] if len(sys.argv) > 1 else "."
