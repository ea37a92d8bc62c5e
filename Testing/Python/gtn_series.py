# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series of meshes in `.gtn` files: section 18.2 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_container import require, times_of


def open_mesh(whole, number, make):
    """Another mesh, which must fit the first one. make: a decoder from bytes."""
    mesh = make(whole.container.meshes[number - 1])
    require(mesh.container.series is None, "meshes of a mesh")
    require(mesh.meta.has_time and mesh.meta.arrays == whole.meta.arrays, "arrays of a mesh")
    require(mesh.container.is_surface == whole.container.is_surface, "kind of a mesh")
    times = times_of(whole.container.series, number)
    require([step.time for step in mesh.steps] == times, "steps of a mesh")
    return mesh
