# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Stock filters behind a reader stream a mesh piece by piece within a limit of memory in which the
whole mesh does not fit, and the surface has the same triangles as that of the whole mesh."""

import hashlib
import json
import os
import resource
import signal
import subprocess
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkContourGrid
from vtkmodules.vtkFiltersGeneral import vtkPolyDataStreamer
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter, vtkGeometryFilter
from vtkmodules.vtkFiltersParallel import vtkRemoveGhosts

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader

N = 64  # 1.6 million tetrahedra, about 75 bytes each in memory
CHUNK_TETS = 4096
PIECES = 64
LIMIT = 48  # MiB beyond what the process uses before it reads
PLENTY = 4000
NO_MEMORY = 3


def memory():
    """Address space in use and the most memory that was ever resident, in bytes."""
    with open("/proc/self/status", encoding="ascii") as file:
        lines = dict(line.split(":", 1) for line in file)
    return tuple(1024 * int(lines[name].split()[0]) for name in ("VmSize", "VmHWM"))


def make_pipeline(path, kind, pieces):
    """A surface of the file, by a streamer unless it is made in one piece."""
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.SetMemoryBudget(8)
    if kind == "contour":
        surface = vtkContourGrid()
        surface.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        surface.SetValue(0, 0.4)
    else:
        # They ask for ghost cells, so that pieces have no walls between them.
        surface = vtkGeometryFilter() if kind == "geometry" else vtkDataSetSurfaceFilter()
        surface.SetPieceInvariant(1)
    surface.SetInputConnection(reader.GetOutputPort())
    if kind == "surface":
        owned = vtkRemoveGhosts()  # this filter gives the faces of ghost cells, too
        owned.SetInputConnection(surface.GetOutputPort())
        surface = owned
    if pieces == 1:
        return reader, surface
    streamer = vtkPolyDataStreamer()
    streamer.SetInputConnection(surface.GetOutputPort())
    streamer.SetNumberOfStreamDivisions(pieces)
    return reader, surface, streamer


def digest(output):
    """The number of triangles, and a hash of them that does not depend on their order."""
    points = vtk_to_numpy(output.GetPoints().GetData()).astype(np.float64)
    cells = output.GetPolys()
    corners = vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)
    assert len(corners) == output.GetNumberOfCells() == cells.GetNumberOfCells()
    used, ids = np.unique(points[corners.ravel()], axis=0, return_inverse=True)
    triangles = ids.reshape(-1, 3)
    # Each begins with its least corner, which keeps its orientation.
    turns = (triangles.argmin(1)[:, None] + np.arange(3)) % 3
    triangles = np.take_along_axis(triangles, turns, 1)
    triangles = np.ascontiguousarray(triangles[np.lexsort(triangles.T)])
    return len(triangles), hashlib.sha256(used.tobytes() + triangles.tobytes()).hexdigest()


def run(path, small, kind, pieces, limit):
    """In a process of its own: makes a surface within a limit, in MiB, and prints what it is."""
    warm = make_pipeline(small, kind, min(pieces, 2))  # libraries, threads
    warm[-1].Update()
    del warm
    old = resource.getrlimit(resource.RLIMIT_AS)
    used, before = memory()
    resource.setrlimit(resource.RLIMIT_AS, (used + limit * 2**20, old[1]))
    pipeline = make_pipeline(path, kind, pieces)
    errors = gm.Errors(pipeline[0])
    try:
        pipeline[-1].Update()
    except MemoryError:
        sys.exit(NO_MEMORY)
    peak = memory()[1] - before
    resource.setrlimit(resource.RLIMIT_AS, old)
    if pipeline[0].GetErrorCode() or str(errors):
        sys.exit(NO_MEMORY)
    count, content = digest(pipeline[-1].GetOutputDataObject(0))
    print("RESULT " + json.dumps({"triangles": count, "content": content, "peak": peak / 2**20}))


def child(*arguments):
    """The result, or None where memory ran out."""
    made = subprocess.run([sys.executable, __file__, *map(str, arguments)], check=False,
                          stdout=subprocess.PIPE, encoding="utf-8",
                          env={**os.environ, "MALLOC_ARENA_MAX": "1"})
    # VTK's filters may end the process where memory runs out.
    assert made.returncode in (0, NO_MEMORY, -signal.SIGABRT), (made.returncode, made.stdout)
    lines = [line for line in made.stdout.splitlines() if line.startswith("RESULT ")]
    assert bool(lines) == (made.returncode == 0), made.stdout
    return json.loads(lines[0][7:]) if lines else None


def write(n, name):
    points, tets = gm.lattice(n)
    grid = gm.make_grid(points, tets)
    wave = np.sin(4 * points[:, 0]) * np.cos(3 * points[:, 1]) + points[:, 2] ** 2
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    path = gm.temporary(name)
    gm.write(grid, path, ChunkSize=CHUNK_TETS)
    return path


def main():
    if not os.path.exists("/proc/self/status"):
        sys.exit(gm.SKIPPED)
    path, small = write(N, "streaming.gtn"), write(4, "streaming-small.gtn")
    for kind in ("contour", "geometry", "surface"):
        whole = child(path, small, kind, 1, PLENTY)
        assert whole["triangles"] > 10000 and whole["peak"] > 1.5 * LIMIT, whole
        assert kind == "contour" or whole["triangles"] == 12 * N * N, whole
        assert child(path, small, kind, 1, LIMIT) is None, "the whole mesh fits"
        streamed = child(path, small, kind, PIECES, LIMIT)
        print(kind, "whole:", whole, "streamed:", streamed)
        assert streamed, "memory ran out"
        assert streamed["peak"] < LIMIT
        assert (streamed["triangles"], streamed["content"]) == (whole["triangles"], whole["content"])


if len(sys.argv) > 1:
    run(*sys.argv[1:4], *map(int, sys.argv[4:]))
else:
    main()
