#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Draws the figures of Documentation/guide/how-it-works.md, on a plate of triangles in place of tetrahedra.

    figures.py [FOLDER]      default: Documentation/images/guide

Needs matplotlib and, to make the files smaller, pngquant."""

import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import numpy as np
from matplotlib import pyplot
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import FancyArrowPatch, Rectangle

import pictures
import plate

ROOT = pathlib.Path(__file__).resolve().parents[2]
# A palette that readers who confuse red and green can tell apart.
COLORS = ["#88ccee", "#ddcc77", "#cc6677", "#117733", "#999933", "#aa4499", "#44aa99", "#6699cc"]
INK, PALE, RED, BLUE = "#222222", "#cccccc", "#c8102e", "#0060a8"


def canvas(columns, width, height, ratios=None):
    figure, axes = pyplot.subplots(1, columns, figsize=(width, height), layout="constrained",
                                   gridspec_kw={"width_ratios": ratios} if ratios else None)
    for one in np.atleast_1d(axes):
        one.set_aspect("equal")
        one.axis("off")
    return figure, np.atleast_1d(axes)


def triangles_on(axes, points, triangles, face="white", edge="#888888", width=0.6, **more):
    axes.add_collection(PolyCollection(points[triangles], facecolors=face, edgecolors=edge, linewidths=width, **more))
    axes.autoscale_view()


def title(axes, text):
    axes.set_title(text, fontsize=11, color=INK)


def arrow(axes, begin, end, color=INK, width=1.2):
    axes.add_patch(FancyArrowPatch(begin, end, arrowstyle="-|>", mutation_scale=12, color=color, linewidth=width,
                                   shrinkA=0, shrinkB=0))


def note(axes, text, at, to=None, color=INK, **more):
    more.setdefault("fontsize", 9)
    if to is None:
        axes.text(*at, text, color=color, ha=more.pop("ha", "center"), va=more.pop("va", "center"), **more)
    else:
        axes.annotate(text, to, at, color=color, ha="center", va="center",
                      arrowprops={"arrowstyle": "-", "color": color, "linewidth": 0.8}, **more)


# 1. From a mesh to a file.

def draw_file():
    figure, (mesh, file) = canvas(2, 10, 3.6, [3, 3.4])
    points, triangles = plate.make_plate(0.16)
    chunk = plate.bisect(points, triangles, 8)
    triangles_on(mesh, points, triangles, [COLORS[c] for c in chunk])
    users = [set() for _ in points]
    for triangle, c in zip(triangles, chunk):
        for point in triangle:
            users[point].add(c)
    shared = [i for i, chunks in enumerate(users) if len(chunks) > 1]
    mesh.plot(*points[shared].T, "o", color=INK, markersize=2.6)
    title(mesh, "The mesh is divided into chunks;\npoints of several chunks are shared")

    title(file, "The file: a reader takes the parts that it needs")
    file.set_xlim(-0.1, 10.1)
    file.set_ylim(-1.5, 5.2)
    rows = [("shared points", 3.6), ("connectivity\nand points", 2.5), ("array A", 1.5), ("array B", 0.7)]
    taken = 5
    for label, y in rows:
        height = 0.85 if "\n" in label else 0.6
        note(file, label, (1.55, y + height / 2), ha="right", fontsize=9)
        for c in range(8):
            wanted = c == taken and label != "array B" or label == "shared points" and c in (3, 4, 5)
            file.add_patch(Rectangle((1.8 + c, y), 0.86, height, facecolor=COLORS[c] if y != 3.6 else "#e4e4e4",
                                     edgecolor=RED if wanted else "#777777", linewidth=2.4 if wanted else 0.7,
                                     zorder=2 if wanted else 1))
    file.add_patch(Rectangle((1.8, -0.35), 7.86, 0.62, facecolor="#f4f4f4", edgecolor="#777777", linewidth=0.7))
    note(file, "tables: bounds, ranges of values, places", (5.7, -0.04))
    note(file, "for array A in one chunk, a reader takes the framed parts", (5.7, -1.0), color=RED)
    return figure


# 2. Connectivity.

def draw_walk():
    figure, axes = canvas(3, 10, 3.3)
    points, triangles = plate.make_plate(0.24)
    centers = points[triangles].mean(1)
    seed = int(np.argmin(np.hypot(*(centers - [2.35, 1.0]).T)))
    order, gates = plate.walk([tuple(t) for t in triangles.tolist()], seed)
    for one, count in zip(axes[:2], (24, 90)):
        triangles_on(one, points, triangles[order[:count]], "#d7e6f2", "#7a9cb8")
        one.plot(*points.T, "o", color=PALE, markersize=2, zorder=0)
        front = plate.open_edges([tuple(t) for t in triangles.tolist()], order[:count])
        one.add_collection(LineCollection(points[np.array(front)], colors=BLUE, linewidths=2.2))
        one.set_xlim(-0.08, plate.WIDTH + 0.08)
        one.set_ylim(-0.08, plate.HEIGHT + 0.08)
    title(axes[0], "The mesh grows from one cell\nover its open sides (blue) ...")
    title(axes[1], "... in an order that the decoder\nrepeats")
    _draw_gate(axes[2])
    return figure


def _draw_gate(axes):
    known = np.array([[0, 0], [1, 0], [0.45, -0.8], [-0.75, -0.35], [-0.75, 0.55], [1.7, -0.45], [1.75, 0.55],
                      [0.4, 0.85], [2.3, 1.15]])
    cells = np.array([[0, 2, 1], [3, 2, 0], [4, 3, 0], [1, 2, 5], [1, 5, 6]])
    triangles_on(axes, known, cells, "#d7e6f2", "#7a9cb8")
    triangles_on(axes, known, np.array([[0, 1, 6]]), (0, 0, 0, 0), "#888888", 1.0, linestyles="dashed")
    triangles_on(axes, known, np.array([[0, 1, 4]]), (0, 0, 0, 0), "#888888", 1.0, linestyles="dashed")
    triangles_on(axes, known, np.array([[0, 1, 7]]), (0, 0, 0, 0), "#888888", 1.0, linestyles="dotted")
    axes.add_collection(LineCollection([known[[0, 1]]], colors=RED, linewidths=3.5))
    for edge in ((0, 4), (1, 6)):
        axes.add_collection(LineCollection([known[list(edge)]], colors=BLUE, linewidths=2.2))
    axes.plot(*known[[4, 6]].T, "o", color=BLUE, markersize=6)
    axes.plot(*known[7], "o", markerfacecolor="white", markeredgecolor=INK, markersize=6)
    note(axes, "gate", (0.5, -0.2), color=RED)
    note(axes, "1", (1.93, 0.62), color=BLUE, fontsize=11)
    note(axes, "2", (-0.93, 0.62), color=BLUE, fontsize=11)
    note(axes, "or a new point", (0.4, 1.07))
    axes.set_xlim(-1.3, 2.4)
    axes.set_ylim(-1.0, 1.45)
    title(axes, "One decision a cell: which candidate\ncloses it best? Mostly the first.")


# 3. Values.

def draw_values():
    figure, axes = pyplot.subplots(1, 3, figsize=(10, 3.3), layout="constrained")
    points, triangles = plate.make_plate(0.045)
    values = plate.field(points).astype(np.float32)
    predicted, at, used = _predict(points, triangles, values)
    axes[0].set_aspect("equal")
    axes[0].axis("off")
    near = [i for i in triangles.ravel() if np.hypot(*(points[i] - points[at])) < 0.16]
    shown = triangles[np.isin(triangles, near).all(1)]
    color = pyplot.get_cmap("viridis")((values - values.min()) / np.ptp(values))
    axes[0].add_collection(PolyCollection(points[shown], facecolors="white", edgecolors=PALE, linewidths=0.8))
    for i in used:
        axes[0].plot(*points[[at, i]].T, color=INK, linewidth=1)
        axes[0].plot(*points[i], "o", color=color[i], markersize=9, markeredgecolor=INK)
    axes[0].plot(*points[at], "o", color="white", markersize=11, markeredgecolor=RED, markeredgewidth=2)
    note(axes[0], "?", points[at], color=RED, fontsize=9)
    title(axes[0], "A value is predicted from those of\nknown neighbors")

    done = np.isfinite(predicted)
    keys, guesses = _keys(values[done]), _keys(predicted[done].astype(np.float32))
    bits = _signed_length(keys - guesses)
    steps = _signed_length(np.diff(_keys(values)))
    bins = np.arange(-0.5, 33)
    axes[1].hist(steps, bins, color=PALE, label="to the previous value", density=True)
    axes[1].hist(bits, bins, color=BLUE, alpha=0.8, label="to the prediction", density=True)
    axes[1].set_xlabel("bits of the difference (of 32)", fontsize=9)
    axes[1].set_ylabel("share of the values", fontsize=9)
    axes[1].set_xlim(-0.5, 30)
    axes[1].legend(fontsize=8, frameon=False, loc="upper left")
    axes[1].set_ylim(0, axes[1].get_ylim()[1] * 1.35)
    axes[1].tick_params(labelsize=8)
    title(axes[1], "Only the difference is stored,\nand it is short")

    axes[2].axis("off")
    axes[2].set_xlim(0, 10)
    axes[2].set_ylim(0, 10)
    for y, text, parts in ((7.6, "value", [(32, PALE, "32 bits")]),
                           (5.0, "prediction", [(32, "white", "computed, not stored")]),
                           (2.4, "difference", [(4, RED, ""), (int(round(bits.mean())) - 4, BLUE, "")])):
        note(axes[2], text, (0, y + 1.65), ha="left")
        x = 0.0
        for count, shade, inside in parts:
            axes[2].add_patch(Rectangle((x, y), count * 9.5 / 32, 1.1, facecolor=shade, edgecolor=INK, linewidth=0.8))
            note(axes[2], inside, (x + count * 9.5 / 64, y + 0.52), fontsize=8)
            x += count * 9.5 / 32
    note(axes[2], "its length, by entropy coding", (1.0, 1.1), ha="left", color=RED)
    note(axes[2], "its bits, as they are", (1.0, 0.2), ha="left", color=BLUE)
    title(axes[2], "The decoder adds both: not a bit\nis lost")
    return figure


def _predict(points, triangles, values):
    """Each value by a linear fit to the nearest known points, in the order of a walk."""
    order = []
    seen = set()
    for i in plate.walk([tuple(t) for t in triangles.tolist()], len(triangles) // 2)[0]:
        for p in triangles[i]:
            if p not in seen:
                seen.add(p)
                order.append(p)
    predicted = np.full(len(points), np.nan)
    place = np.empty(len(points), int)
    place[order] = np.arange(len(order))
    used = {}
    for n, p in enumerate(order[12:], 12):
        known = np.array(order[max(0, n - 600):n])
        near = known[np.argsort(np.hypot(*(points[known] - points[p]).T))[:8]]
        matrix = np.c_[np.ones(len(near)), points[near] - points[p], ((points[near] - points[p]) ** 2).sum(1)]
        predicted[p] = np.linalg.lstsq(matrix, values[near].astype(float), rcond=None)[0][0]
        used[p] = near
    at = min(order[200:], key=lambda p: np.hypot(*(points[p] - [2.2, 1.0])))
    return predicted, at, used[at]


def _keys(values):
    """Whole numbers in the order of the values."""
    bits = values.astype(np.float32).view(np.int32).astype(np.int64)
    return np.where(bits < 0, -(bits & 0x7FFFFFFF), bits)


def _signed_length(differences):
    return np.where(differences == 0, 0, np.floor(np.log2(np.maximum(np.abs(differences), 1))) + 2)


# 4. Drawing.

def draw_rays():
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 3.8), layout="constrained", gridspec_kw={
        "width_ratios": [1.5, 1]})
    scene, ray = axes
    scene.set_aspect("equal")
    scene.axis("off")
    points, triangles = plate.make_plate(0.16)
    chunk = plate.bisect(points, triangles, 16)
    centers = np.array([points[triangles[chunk == c]].reshape(-1, 2).mean(0) for c in range(16)])
    eye = np.array([4.6, 1.0])
    order = np.argsort(np.hypot(*(centers - eye).T))
    angle = np.arctan2(centers[:, 1] - eye[1], eye[0] - centers[:, 0])
    values = np.array([plate.field(points[triangles[chunk == c]].reshape(-1, 2)).max() for c in range(16)])
    state = np.full(16, "drawn", dtype=object)
    state[values < 0.85] = "transparent"
    state[np.abs(angle) > 0.29] = "out of view"
    hidden = [c for c in order if state[c] == "drawn"][4:]
    state[hidden] = "behind opaque ones"
    behind = [c for c in order if np.hypot(*(centers[c] - eye)) > np.hypot(*(centers[hidden[0]] - eye))]
    state[[c for c in behind if state[c] == "transparent"]] = "behind opaque ones"
    shades = {"drawn": "#f2c14e", "out of view": "white", "transparent": "#d7e6f2", "behind opaque ones": "#bbbbbb"}
    triangles_on(scene, points, triangles, [shades[state[c]] for c in chunk], "#999999", 0.5)
    for n, c in enumerate([c for c in order if state[c] == "drawn"], 1):
        scene.text(*centers[c], str(n), ha="center", va="center", fontsize=13, weight="bold", color=INK)
    for slope in np.linspace(-0.22, 0.22, 9):
        scene.plot([eye[0], -0.15], [eye[1], eye[1] + slope * (eye[0] + 0.15)], color=RED, linewidth=0.8, alpha=0.8)
    scene.plot(*eye, "o", color=INK, markersize=9)
    note(scene, "eye", eye - [0, 0.2])
    for n, (name, shade) in enumerate(shades.items()):
        words = "decoded and drawn" if name == "drawn" else "never decoded: " + name
        scene.add_patch(Rectangle((-0.1 + 2.3 * (n % 2), -0.36 - 0.28 * (n // 2)), 0.16, 0.16, facecolor=shade,
                                  edgecolor="#777777"))
        note(scene, words, (0.13 + 2.3 * (n % 2), -0.285 - 0.28 * (n // 2)), ha="left", fontsize=9)
    scene.set_xlim(-0.2, 4.9)
    scene.set_ylim(-0.75, plate.HEIGHT + 0.1)
    title(scene, "Chunks are decoded from front to back, if they can show anything,\nand are dropped when they are drawn")
    _draw_fragments(ray)
    return figure


def _draw_fragments(axes):
    axes.axis("off")
    axes.set_xlim(-0.6, 10.4)
    axes.set_ylim(-0.8, 9)
    rows = [("cells, as they come", [(2.0, 3.1), (5.2, 6.0), (3.1, 4.4), (6.0, 7.6), (4.4, 5.2)]),
            ("after three", [(2.0, 4.4), (5.2, 6.0)]),
            ("after all", [(2.0, 7.6)])]
    for (label, spans), y in zip(rows, (6.2, 3.7, 1.2)):
        note(axes, label, (-0.4, y + 1.35), ha="left")
        axes.plot([-0.4, 9.6], [y + 0.45, y + 0.45], color=RED, linewidth=0.8, zorder=0)
        for n, (begin, end) in enumerate(spans, 1):
            axes.add_patch(Rectangle((begin, y), end - begin, 0.9, facecolor="#f2c14e", edgecolor=INK, linewidth=0.9))
            note(axes, str(n) if len(spans) == 5 else "", ((begin + end) / 2, y + 0.43), fontsize=9)
    arrow(axes, (9.2, 1.65), (9.9, 1.65), RED, 0.8)
    note(axes, "color and opacity", (4.8, 0.6), fontsize=9)
    title(axes, "Along a ray, parts that touch\nbecome one fragment")


# 5. Levels of detail.

def draw_levels():
    figure, axes = canvas(4, 12, 2.7)
    points, triangles = plate.make_plate(0.13)
    count = len(points)
    shades = pyplot.get_cmap("viridis")
    eye = np.array([0.05, 0.1])
    weight = 1 / np.maximum(np.hypot(*(points - eye).T), 0.12) ** 3
    meshes = [("all %d points" % count, triangles),
              ("%d points" % (count // 2), plate.merge(points, triangles, count // 2)),
              ("%d points" % (count // 5), plate.merge(points, triangles, count // 5)),
              ("%d points, for an eye\nat the lower left" % (count // 5),
               plate.merge(points, triangles, count // 5, weight))]
    low, high = plate.field(points).min(), plate.field(points).max()
    for one, (words, cells) in zip(axes, meshes):
        middle = plate.field(points)[cells].mean(1)
        triangles_on(one, points, cells, shades((middle - low) / (high - low)), "white", 0.5)
        title(one, words)
    axes[3].plot(*(eye - 0.12), "o", color=INK, markersize=8)
    return figure


FIGURES = {"how-1-file": draw_file, "how-2-walk": draw_walk, "how-3-values": draw_values, "how-4-rays": draw_rays,
           "how-5-levels": draw_levels}


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "Documentation" / "images" / "guide"
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in FIGURES.items():
        figure = draw()
        figure.savefig(folder / f"{name}.png", dpi=110, facecolor="white", bbox_inches="tight", pad_inches=0.1)
        pyplot.close(figure)
        pictures.reduce_colors(folder / f"{name}.png", 64)
        print(folder / f"{name}.png")


if __name__ == "__main__":
    main()
