# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Descriptions as in gatunGolden of what gtn_decoder makes of a file."""

import struct

import gatunGolden as golden
import numpy as np
from gtn_bytes import SIZES, checksum
from gtn_container import SURFACE_LISTS
from gtn_decoder import Decoder
from gtn_series import LivingMesh
from gtn_tables import POINTS

WHERE = ("points", "cells")


def describe(array):
    return golden.describe_array(
        array.name, array.vtk_type, array.components, list(array.component_names))


def describe_field_array(array):
    result = describe(array)
    if array.type == 0:
        result["sha256"] = golden.sha256_of_texts(array.values)
    else:
        result["sha256"] = golden.sha256(np.frombuffer(array.values, np.uint8))
    assert array.type == 0 or len(array.values) % (SIZES[array.type] * array.components) == 0
    return result


def cell_order(decoder, restore):
    """The cells of a surface in the order of its lists (16.2), by their numbers; else None."""
    if not decoder.container.is_surface:
        return None
    kinds = [SURFACE_LISTS[kind] for kind, _, _ in decoder.cells(restore)]
    return np.argsort(kinds, kind="stable")


def describe_cells(decoder, restore):
    if decoder.container.cells is None:
        return {"tets": golden.sha256(decoder.tets(restore))}
    cells, order = decoder.cells(restore), cell_order(decoder, restore)
    return {"cells": golden.sha256_of_cells(
        cells if order is None else [cells[i] for i in order])}


def values_of(decoder, step, number, restore, order):
    values = decoder.array(step, number, restore)
    is_of_points = decoder.meta.arrays[number].where == POINTS
    return values if order is None or is_of_points else values[order]


def hashes(decoder, order, restore, steps):
    """order: numbers of the arrays, those of points first. steps: those with this mesh."""
    first = steps[0] if steps else 0
    points = decoder.points(restore, first)
    cells = cell_order(decoder, restore)
    at_steps = [golden.sha256(decoder.points(restore, step)) for step in steps]
    return {
        "points_at": at_steps,
        "points_type": points.dtype.name if len(points) else None,
        "points": golden.sha256(points) if len(points) else None,
        **describe_cells(decoder, restore),
        "arrays": [
            [golden.sha256(values_of(decoder, step, i, restore, cells)) for i in order]
            for step in steps or [0]
        ],
    }


def describe_decoded(data):
    return describe_decoder(Decoder(data))


def describe_decoder(decoder):
    series = decoder.container.series
    if series is None:
        return without_equal_places(describe_mesh(decoder, range(len(decoder.steps))))
    kinds, counts = {}, {}  # steps of each mesh and mask; steps of each mesh so far
    for step in series:
        kinds.setdefault((step.mesh, step.mask), []).append(counts.get(step.mesh, 0))
        counts[step.mesh] = counts.get(step.mesh, 0) + 1
    decoders = {0: decoder}
    described = {}
    for (mesh, mask), steps in kinds.items():
        if mesh not in decoders:
            decoders[mesh] = decoder.mesh(mesh)
        living = LivingMesh(decoders[mesh], mask) if mask else decoders[mesh]
        one = describe_mesh(living, steps)
        key = len(living.points()), *describe_cells(living, False).values()
        if key not in described:
            described[key] = one
            continue
        before = described[key]  # the mesh has returned
        before["times"] += one["times"]
        before["field_data"] += one["field_data"]
        for order in "file_order", "input_order":
            for of_steps in "points_at", "arrays":
                before[order][of_steps] += one[order][of_steps]
    meshes = [without_equal_places(mesh) for mesh in described.values()]
    return {"times": [step.time for step in series], "meshes": meshes}


def without_equal_places(described):
    """Of a mesh; only points that move have checksums at each step."""
    for order in "file_order", "input_order":
        if len(set(described[order]["points_at"])) <= 1:
            del described[order]["points_at"]
    return described


def describe_mesh(decoder, steps):
    """Of a mesh with the steps that have it."""
    decoder.container.verify_layout()
    meta = decoder.meta
    order = sorted(range(len(meta.arrays)), key=lambda i: meta.arrays[i].where)
    roles = {where: {} for where in WHERE}
    for role in range(32):
        for array in meta.arrays:
            if array.roles >> role & 1:
                roles[WHERE[array.where]][str(role)] = array.name
    return {
        "times": [decoder.steps[step].time for step in steps] if meta.has_time else [],
        "wide_ids": meta.wide_ids != 0 if decoder.cells() else None,
        "arrays": [
            dict(describe(meta.arrays[i]), where=WHERE[meta.arrays[i].where != POINTS])
            for i in order
        ],
        "roles": roles,
        "field_data": [
            [describe_field_array(array) for array in decoder.field_data(step)]
            for step in steps
        ],
        "file_order": hashes(decoder, order, False, steps),
        "input_order": hashes(decoder, order, True, steps),
    }


def checksum_of(values):
    """Of the bytes of a numpy array, which are little-endian."""
    values = np.ascontiguousarray(values)
    return "%016x" % checksum(values.astype(values.dtype.newbyteorder("<")).tobytes())


def describe_dependencies(decoder):
    """A line on those that are stored of a file's dependencies of merges, if it has any."""
    if decoder.dependencies is None:
        return []
    numbers = [number for earlier in decoder.dependencies for number in [len(earlier), *earlier]]
    stored = len(numbers) - len(decoder.dependencies)
    return ["dependencies %d %016x" % (stored, checksum(struct.pack("<%dI" % len(numbers), *numbers)))]


def describe_tree(decoder, name):
    """Lines, as in trees.txt, on how the mesh of a file becomes simpler; base meshes come last."""
    meta, tree = decoder.meta, decoder.container.tree
    merges = b"".join(struct.pack("<IIf", *merge) for merge in decoder.merges)
    lines = [
        "= %s" % name,
        "points %d unused %d tets %d" % (meta.points, meta.unused_points, meta.tets),
        "merges %d %016x" % (len(decoder.merges), checksum(merges)),
        *(["bonds %d" % sum(decoder.bonds)] if decoder.container.is_surface else []),
        *describe_dependencies(decoder),
        " ".join(map(str, ["rungs", *tree.rungs])),
        " ".join(map(str, ["levels", *tree.levels])),
        "boxes %s" % checksum_of(np.array(tree.boxes, float)),
    ]
    for s, ranges in enumerate(tree.ranges):
        for a, of_array in enumerate(ranges):
            if of_array is not None:
                lines.append("step %d array %d ranges %s" % (
                    s, a, checksum_of(np.array(of_array, float))))
    count = len(decoder.merges)
    for n in sorted({1, count // 3, count // 2, count} - {0}) if count else []:
        mesh = decoder.after(n)
        corners = mesh.tets
        if mesh.types is not None:
            corners = np.array([x for kind, cell in zip(mesh.types, mesh.tets)
                                for x in [kind, len(cell), *cell]], np.int64)
        lines.append("after %d points %d %s %s %d %s" % (
            n, len(mesh.kept), checksum_of(mesh.points()),
            "tets" if mesh.types is None else "cells", len(mesh.tets), checksum_of(corners)))
        for s in range(len(decoder.steps)):
            for a in range(len(meta.arrays)):
                lines.append("after %d step %d array %d %s" % (
                    n, s, a, checksum_of(mesh.array(s, a))))
    for i in range(len(tree.levels)):
        lines += describe_tree(decoder.level(i), "%s, base mesh %d" % (name, i + 1))
    return lines


def describe_layers(decoder, name):
    """Lines, as in layers.txt, on the layers of a file; base meshes come last."""
    layers, tree = decoder.container.layers, decoder.container.tree
    lines = [
        "= %s" % name,
        "array %d component %d spacing %d layers %d" % (
            layers.array, layers.component, layers.spacing, layers.count),
        " ".join(["bounds", *(struct.pack(">d", bound).hex() for bound in layers.bounds)]),
        " ".join(["chunks", *("%d-%d" % span for span in layers.chunks)]),
    ]
    for i in range(len(tree.levels) if tree is not None else 0):
        lines += describe_layers(decoder.level(i), "%s, base mesh %d" % (name, i + 1))
    return lines
