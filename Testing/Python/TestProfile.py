# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of both profiles have the same contents. In the fast one, values of tetrahedra have the fast mode,
and none is predicted by quadratic functions, in base meshes, the boundary and later time steps neither."""

import os
import sys

import numpy as np

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter
from gatunTimeSource import TimeSource, connect

try:
    import gtn_arrays
    from describe_decoded import describe_decoder
    from gtn_decoder import Decoder
except ImportError as error:
    print(error)
    sys.exit(gm.SKIPPED)

QUADRATIC, FAST = {3, 4}, 5  # spatial modes of format.md, 10.1


class Counted(gtn_arrays.ArrayStream):
    """Collects the spatial modes of streams."""

    modes = set()

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.modes.add(self.spatial)


gtn_arrays.ArrayStream = Counted


def find_modes(path):
    Counted.modes.clear()
    with open(path, "rb") as file:
        decoder = Decoder(file.read())
    describe_decoder(decoder)
    tree = decoder.container.tree
    for other in [decoder.boundary()] + [decoder.level(i) for i in range(len(tree.levels) if tree else 0)]:
        if other is not None:
            describe_decoder(other)
    return set(Counted.modes)


def step(time):
    points, tets = gm.lattice(12)
    points = points + np.random.default_rng(3).uniform(-0.02, 0.02, points.shape)
    grid = gm.make_grid(points, tets)
    wave = np.sin(3 * points[:, 0] + time) * np.cos(2 * points[:, 1]) + points[:, 2] ** 2
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    gm.add_array(grid.GetCellData(), wave[tets].mean(1).astype(np.float32), "cells")
    return grid


def write(path, times, profile, **options):
    writer = vtkGatunWriter()
    writer.SetFileName(path)
    writer.SetProfile(profile)
    if len(times) > 1:
        connect(writer, TimeSource(step, times))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(step(times[0]))
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    return os.path.getsize(path)


assert vtkGatunWriter().GetProfile() == vtkGatunWriter.PROFILE_FAST
path = gm.temporary("fast.gtn")
for times, options in (
        ([0.0], {"ChunkSize": 2000, "KeepOrder": 7}),
        ([0.0], {"Hierarchy": True, "Levels": 2, "WriteBoundary": True}),
        ([0.0, 0.1, 0.2], {"ChunkSize": 2000, "KeyStepInterval": 2})):
    small = write(path, times, vtkGatunWriter.PROFILE_SMALL, **options)
    modes = find_modes(path)
    assert modes & QUADRATIC and FAST not in modes, modes
    whole = gm.read(path)
    large = write(path, times, vtkGatunWriter.PROFILE_FAST, **options)
    modes = find_modes(path)
    assert FAST in modes and not modes & QUADRATIC, modes
    assert small < large < 2 * small, (small, large, options)
    gm.assert_same_mesh(whole, gm.read(path))
