#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the inputs of a soak: soakMake.py FOLDER SIZE, the number of cubes along a side of the meshes.

Two of each kind, a and b, which differ in their values; those for the reader have few cells and many
chunks.
"""

import os
import sys

import numpy as np
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter)

import gatunHartley as gh
import gatunMeshes as gm
from gatun import vtkGatunWriter
from gatunTimeSource import TimeSource, connect

folder, size = sys.argv[1], int(sys.argv[2])


def lattice(n, name, step=0):
    """A cube of tetrahedra with values that depend on the name and the step."""
    points, tets = gm.lattice(n)
    grid = gm.make_grid(points + np.float32(0.01 * step), tets)
    turn = (1 if name == "a" else 2) + 0.1 * step
    wave = np.sin(5 * turn * points[:, 0] + points[:, 1]) * np.cos(4 * points[:, 2])
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    gm.add_array(grid.GetPointData(), turn * points.astype(np.float64), "vector")
    gm.add_array(grid.GetCellData(), (np.arange(len(tets)) * turn).astype(np.int32), "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def surface_of(grid):
    skin = vtkGeometryFilter()
    skin.SetInputData(grid)
    skin.Update()
    return skin.GetOutput()


def write_xml(writer, data, file):
    """Uncompressed behind the tags, so that gtn can read ranges of it."""
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(folder, file))
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    assert writer.Write()


for name in "a", "b":
    write_xml(vtkXMLUnstructuredGridWriter(), lattice(size, name), f"{name}.vtu")
    write_xml(vtkXMLPolyDataWriter(), surface_of(lattice(2 * size, name)), f"{name}.vtp")
    field = gh.blobs((2 * size, 2 * size + 1, 2 * size + 2), seed=ord(name), scale=200)
    write_xml(vtkXMLImageDataWriter(), gh.make_volume(field.astype(np.float32)), f"{name}.vti")
    gh.write(gh.make_volume(field[:20, :20, :20].astype(np.float32)),
             os.path.join(folder, f"{name}.ghv"), BlockSize=8)
    gm.write(lattice(9, name), os.path.join(folder, f"{name}.gtn"), ChunkTets=128, Hierarchy=True,
             Levels=2)
    writer = vtkGatunWriter()
    connect(writer, TimeSource(lambda i, of=name: lattice(7, of, i), [0.0, 1.0, 2.0, 3.0]))
    writer.SetFileName(os.path.join(folder, f"{name}-steps.gtn"))
    writer.SetChunkTets(128)
    writer.WriteAllTimeStepsOn()
    assert writer.Write()
    gm.write(surface_of(lattice(9, name)), os.path.join(folder, f"{name}-surface.gtn"), ChunkTets=128)
for step in range(3):
    write_xml(vtkXMLUnstructuredGridWriter(), lattice(max(4, size // 2), "a", step), f"step_{step}.vtu")
print("{}")
