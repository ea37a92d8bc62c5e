#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes a mesh of any number of tetrahedra as a .gtn file, without ever having more than a piece of it.

    largeMesh.py PROGRAMS FILE CUBES PIECES [CHUNK]

PROGRAMS is the folder of gtn, next to which the Python package is.
The mesh is a box of CUBES^3 cubes of six tetrahedra each, bent and jittered, in slabs, with a field on its
points. PIECES 1: as a whole. CHUNK: the most tetrahedra of a chunk. Prints the seconds of the writer, those of
them in which pieces were made, and the peak memory as JSON.
"""

import json
import pathlib
import resource
import sys
import time

import numpy as np

PATHS = ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1))


def noise(numbers, seed):
    """-1 to 1, by the number of a point alone, so that pieces agree."""
    x = numbers.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15) + np.uint64(seed)
    x ^= x >> np.uint64(29)
    x *= np.uint64(0xBF58476D1CE4E5B9)
    return ((x >> np.uint64(40)).astype(np.float64) / 2**23 - 1).astype(np.float32)


def make_points(n, first, last):
    """The points of the layers first to last, and their values."""
    return points_of(n, np.arange(first * (n + 1) ** 2, (last + 1) * (n + 1) ** 2))


def points_of(n, numbers):
    """Points by their numbers, and their values."""
    grid = np.stack([numbers % (n + 1), numbers // (n + 1) % (n + 1), numbers // (n + 1) ** 2], 1)
    points = grid.astype(np.float32)
    for axis in range(3):
        points[:, axis] += 0.2 * noise(numbers, axis)
    points /= n
    points[:, 0] += 0.1 * np.sin(3 * points[:, 1]) * np.cos(2 * points[:, 2])
    values = np.sin(7 * points[:, 0]) * np.cos(5 * points[:, 1]) + points[:, 2] ** 2
    return points, values.astype(np.float32)


def make_tets(n, layers):
    """The corners of the tetrahedra of some layers of cubes."""
    return tets_of(n, np.arange(layers * n * n))


def tets_of(n, cubes):
    """The corners of the tetrahedra of cubes by their numbers."""
    corner = cubes // (n * n) * (n + 1) ** 2 + cubes // n % n * (n + 1) + cubes % n
    at = [((bits >> 2) * (n + 1) + (bits >> 1 & 1)) * (n + 1) + (bits & 1) for bits in range(8)]
    offsets = np.array([[0, at[a], at[b], at[7]] for a, b in PATHS])
    return (corner[:, None, None] + offsets[None]).reshape(-1)


def make_source(n):
    """A source of the pieces of the mesh; its member seconds is the time that it took."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
    from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

    class Source(VTKPythonAlgorithmBase):
        seconds = 0

        def __init__(self):
            super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")

        def RequestInformation(self, _request, _in, out):
            out.GetInformationObject(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
            return 1

        def RequestData(self, _request, _in, out):
            start = time.monotonic()
            info = out.GetInformationObject(0)
            piece = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER())
            pieces = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES())
            first, last = n * piece // pieces, n * (piece + 1) // pieces
            output = vtkUnstructuredGrid.GetData(out, 0)
            output.Initialize()
            if first < last:
                fill(output, first, last)
            Source.seconds += time.monotonic() - start
            return 1

    def fill(output, first, last):
        places, values = make_points(n, first, last)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=1))
        output.SetPoints(points)
        tets = make_tets(n, last - first)
        cells = vtkCellArray()
        cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, len(tets) + 1, 4), deep=1),
                      numpy_to_vtkIdTypeArray(tets, deep=1))
        output.SetCells(10, cells)
        field = numpy_to_vtk(values, deep=1)
        field.SetName("field")
        output.GetPointData().SetScalars(field)

    return Source()


def main(programs, path, cubes, pieces, chunk=0):
    sys.path[:0] = [str(pathlib.Path(programs).parent / "lib/python3/dist-packages")]
    from gatun import vtkGatunWriter
    start = time.monotonic()
    source = make_source(int(cubes))
    writer = vtkGatunWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(path)
    writer.SetNumberOfPieces(int(pieces))
    writer.SetChunkTets(int(chunk))
    if writer.Write() != 1:
        sys.exit(1)
    print(json.dumps({"seconds": time.monotonic() - start, "making": source.seconds,
                      "peak": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}))


if __name__ == "__main__":
    main(*sys.argv[1:])
