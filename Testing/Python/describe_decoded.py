# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Descriptions of what gtn_decoder and ghv_decoder make of a file: of meshes as in gatunGolden, and of
merges, layers and volumes as lines, which tests of the core compare with their own."""

import struct

import gatunGolden as golden
import numpy as np
from gtn_boundary import check_boundary
from gtn_bytes import SIZES, checksum
from gtn_container import SURFACE_LISTS
from gtn_decoder import Decoder
from gtn_dependencies import check_dependencies
from gtn_layers import check_layers
from gtn_series import RemainingMesh
from gtn_tables import POINTS
from gtn_tree import check_level, check_ranges

WHERE = ("points", "cells")


def describe(array):
    return golden.describe_array(
        array.name, array.vtk_type, array.components, list(array.component_names),
        describe_keys(array))


def describe_keys(array):
    """Location, name, kind and values as texts."""
    return sorted(
        [key.location, key.name, key.kind,
         [v.decode() if isinstance(v, bytes) else str(v) for v in key.values]]
        for key in array.keys)


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
        remaining = RemainingMesh(decoders[mesh], mask) if mask else decoders[mesh]
        one = describe_mesh(remaining, steps)
        key = len(remaining.points()), *describe_cells(remaining, False).values()
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
    points = meta.point_array
    return {
        **golden.describe_points(points.name, list(points.component_names), describe_keys(points)),
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
    """Lines on how the mesh of a file becomes simpler; base meshes come last."""
    meta, tree = decoder.meta, decoder.container.tree
    merges = b"".join(struct.pack("<IIf", *merge) for merge in decoder.merges)
    lines = [
        "= %s" % name,
        "points %d unused %d tets %d" % (meta.points, meta.unused_points, meta.tets),
        "merges %d %016x" % (len(decoder.merges), checksum(merges)),
        *(["bonds %d" % sum(decoder.bonds)] if decoder.container.is_surface else []),
        *describe_dependencies(decoder),
        " ".join(map(str, ["merge_counts", *tree.merge_counts])),
        " ".join(map(str, ["levels", *tree.levels])),
        "boxes %s" % checksum_of(np.array(tree.boxes, float)),
    ]
    for s, ranges in enumerate(tree.ranges):
        for a, of_array in enumerate(ranges):
            if of_array is not None and a < len(meta.arrays):
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
    """Lines on the layers of a file; base meshes come last."""
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


def check_tree(decoder):
    """Ranges after merges enclose just what they have to, base meshes are what is left, and
    dependencies are those of the mesh."""
    check_ranges(decoder)
    check_dependencies(decoder)
    for i in range(len(decoder.container.tree.levels)):
        level = decoder.level(i)
        check_level(decoder, i, level)
        check_tree(level)


def describe_core(name, decoder):
    """The lines of a file by their kind: merges and layers, if it has any. Checks them, and the
    boundary."""
    decoder.container.verify_layout()
    boundary = decoder.boundary()
    if boundary is not None:
        check_boundary(decoder, boundary)
    lines = {}
    if decoder.container.tree is not None:
        check_tree(decoder)
        lines["merges"] = describe_tree(decoder, name)
    if decoder.container.layers is not None:
        check_layers(decoder)
        lines["layers"] = describe_layers(decoder, name)
    return lines


def cells_of_decoder(decoder, restore):
    """Triples of a type, points and faces, also of a file of tetrahedra."""
    if decoder.container.cells is not None:
        return decoder.cells(restore)
    return [(10, tet, None) for tet in decoder.tets(restore).tolist()]


def describe_volume(name, volume):
    """Lines on a volume."""
    lines = [f"= {name}", "size {} {} {} type {} block {} {} {} chunks {}".format(
        *volume.size, volume.kind, *volume.block, len(volume.chunks))]
    place = [*volume.origin, *volume.spacing, *volume.direction, volume.min, volume.max]
    packed = struct.pack(f"<{len(place)}d3ii", *place, *volume.first_index, volume.vtk_type)
    lines.append(f"place {checksum(packed):016x} name {volume.name}")
    for chunk in range(len(volume.chunks)):
        packed = b""
        terms = 0
        for number, block in enumerate(volume.integers(chunk)):
            values = volume.coefficients(block)
            for index, value in enumerate(values):
                if value:
                    packed += struct.pack("<IIf", number, index, value)
                    terms += 1
        lines.append(f"chunk {chunk} terms {terms} {checksum(packed):016x}")
    # Those of floating point may differ in their last bits.
    if volume.kind <= 8:
        lines.append(f"voxels {checksum(volume.voxels().tobytes()):016x}")
    return lines
