#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes a mesh by several processes, for runParallel.py and runScaling.py.

    parallelWrite.py split MESH FOLDER PROCESSES compact|scattered
    mpiexec -n PROCESSES parallelWrite.py write PROGRAMS FOLDER gtn|pvtu OUT [CHUNK]

split puts a part of MESH for each process into FOLDER: halves of halves along the longest axis, or cells at
random. write loads the parts, writes them together, and prints as JSON what each process has needed.
CHUNK is the largest number of tetrahedra in a chunk (default: that of the writer).
"""

import ctypes
import json
import os
import pathlib
import sys
import time

import numpy as np


def split(mesh, folder, processes, partition):
    """Writes the parts of a mesh."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(mesh)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    if partition == "scattered":
        owner = np.random.default_rng(1).integers(0, processes, len(tets))
    else:
        owner = halve(points[tets].mean(1), processes)
    for process in range(processes):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(part_of(grid, tets, owner == process))
        writer.SetFileName(os.path.join(folder, f"part-{process}.vtu"))
        writer.SetCompressorTypeToNone()
        writer.EncodeAppendedDataOff()
        writer.Write()


def halve(centers, processes):
    """The process of each cell; a power of two of them."""
    owner = np.zeros(len(centers), int)
    if processes > 1:
        axis = np.ptp(centers, axis=0).argmax()
        order = centers[:, axis].argsort(kind="stable")
        for half, cells in enumerate(np.array_split(order, 2)):
            owner[cells] = half * (processes // 2) + halve(centers[cells], processes // 2)
    return owner


def part_of(grid, tets, wanted):
    """Some of the cells, with their points and arrays."""
    from vtkmodules.util.numpy_support import (
        numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
    used, corners = np.unique(tets[wanted], return_inverse=True)
    part = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(vtk_to_numpy(grid.GetPoints().GetData())[used], deep=1))
    part.SetPoints(places)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, corners.size + 1, 4), deep=1),
                  numpy_to_vtkIdTypeArray(corners.ravel().astype(np.int64), deep=1))
    part.SetCells(10, cells)
    for data, to, kept in ((grid.GetPointData(), part.GetPointData(), used),
                           (grid.GetCellData(), part.GetCellData(), wanted)):
        for i in range(data.GetNumberOfArrays()):
            array = numpy_to_vtk(vtk_to_numpy(data.GetArray(i))[kept], deep=1)
            array.SetName(data.GetArrayName(i))
            to.AddArray(array)
    return part


def memory(what):
    """A number of /proc/self/status, in bytes."""
    with open("/proc/self/status", encoding="ascii") as status:
        for line in status:
            if line.startswith(what + ":"):
                return int(line.split()[1]) * 1024
    return 0


def reset_peak():
    """Gives freed memory back and lets the peak begin here."""
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")


def make_writer(form, grid, controller, out, chunk):
    """The writer of a form, and what it knows about bytes that were sent."""
    process, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    if form == "gtn":
        from gatun import vtkGatunWriter
        writer = vtkGatunWriter()
        writer.SetChunkTets(chunk)
    else:
        from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter
        writer = vtkXMLPUnstructuredGridWriter()
        writer.SetNumberOfPieces(processes)
        writer.SetStartPiece(process)
        writer.SetEndPiece(process)
        writer.SetCompressorTypeToZLib()
        writer.EncodeAppendedDataOff()
    writer.SetController(controller)
    writer.SetInputData(grid)
    writer.SetFileName(out)
    return writer


def watch(writer):
    """The times at which a writer tells its progress, those of the processor, and that progress."""
    events = []
    writer.AddObserver("ProgressEvent",
                       lambda caller, _: events.append(
                           (time.monotonic(), time.process_time(), caller.GetProgress())))
    return events


def stages(events, start):
    """The seconds of the survey of the own part, and the processor time of all that ranks do until they write
    their parts, and of what follows behind that, with waiting for other ranks. The survey ends and the
    writing begins with a progress of 0.5. The last two events are those of the part and of the file."""
    surveyed, writing = [event for event in events if event[2] == 0.5][:2]
    return {"survey": surveyed[0] - start, "agreement": writing[1] - surveyed[1],
            "finish": events[-1][1] - events[-2][1]}


def write(programs, folder, form, out, chunk=0):
    """Loads and writes the part of this process."""
    sys.path[:0] = [str(pathlib.Path(programs).parent / "lib/python3/dist-packages")]
    from mpi4py import MPI
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    from vtkmodules.vtkParallelMPI import vtkMPIController
    world = MPI.COMM_WORLD
    controller = vtkMPIController()
    controller.Initialize()
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, f"part-{world.Get_rank()}.vtu"))
    reader.Update()
    grid = reader.GetOutput()
    reader = None
    writer = make_writer(form, grid, controller, out, int(chunk))
    world.Barrier()
    reset_peak()
    before = memory("VmRSS")
    events = watch(writer)
    world.Barrier()
    start = time.monotonic()
    succeeded = writer.Write() == 1
    world.Barrier()
    seconds = time.monotonic() - start
    mine = {"share": grid.GetActualMemorySize() * 1024, "extra": memory("VmHWM") - before,
            "sent": writer.GetBytesSent() if form == "gtn" else 0, "succeeded": succeeded}
    if form == "gtn":
        mine |= {"points": grid.GetNumberOfPoints(), **stages(events, start)}
    everything = world.gather(mine, 0)
    if world.Get_rank() == 0:
        assert all(one["succeeded"] for one in everything)
        print(json.dumps({"seconds": seconds, "processes": everything}))


if __name__ == "__main__":
    if sys.argv[1] == "split":
        split(sys.argv[2], sys.argv[3], int(sys.argv[4]), sys.argv[5])
    else:
        write(*sys.argv[2:])
