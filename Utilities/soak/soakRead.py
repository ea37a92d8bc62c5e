#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Reads damaged files in all ways that a VTK program has: soakRead.py NOW FILE...

NOW gets the name of the file that is being read. Each file gives a result, or an error with its name.
Prints counts as JSON; ends with exit code 3 and a message if something else happens.
"""

import json
import pathlib
import sys

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkCamera, vtkVolumeProperty

import gatunMeshes as gm
from gatun import (vtkGatunContour, vtkGatunHartleyProjection, vtkGatunHartleyReader,
                   vtkGatunRayCaster, vtkGatunReader, vtkGatunSurfaceReader)

MIB = 1 << 20
MOST_RESIDENT = 512 * MIB

counts = {"reads in a VTK program": 0, "refused by readers": 0}
path = ""


def stop(what):
    print(f"{path}: {what}")
    sys.exit(3)


def peak():
    """The most memory that was resident since the last call, in bytes."""
    status = pathlib.Path("/proc/self/status").read_text(encoding="ascii")
    kib = next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM"))
    pathlib.Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    return 1024 * kib


def check(algorithm, errors):
    """A result without errors, or an error that names the file."""
    counts["reads in a VTK program"] += 1
    code = algorithm.GetErrorCode()
    if code == 0 and not errors.messages:
        return True
    counts["refused by readers"] += 1
    if code == 0:
        stop(f"{algorithm.GetClassName()}: a message and no error code: {errors}")
    if not errors.messages:
        stop(f"{algorithm.GetClassName()}: error code {code} and no message")
    if path not in str(errors):
        stop(f"{algorithm.GetClassName()}: the message does not name the file: {errors}")
    return False


def read_mesh(reader_type):
    """Whole, at the last step, in pieces with ghost cells, on demand."""
    reader = reader_type()
    errors = gm.Errors(reader)
    reader.SetFileName(path)
    reader.Update()
    good = check(reader, errors)
    information = reader.GetOutputInformation(0)
    times = information.Get(Pipeline.TIME_STEPS()) if good else None
    errors.messages.clear()
    if times:
        reader.UpdateTimeStep(times[-1])
        check(reader, errors)
        errors.messages.clear()
    for piece in range(2):
        reader.UpdatePiece(piece, 2, 1)
        check(reader, errors)
        errors.messages.clear()
    return reader.GetOutput().GetBounds() if good else None


def look_at(bounds):
    """A camera that sees all of it."""
    camera = vtkCamera()
    center = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
    size = max(bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3)) or 1
    camera.SetFocalPoint(center)
    camera.SetPosition(center[0] + size, center[1] + 2 * size, center[2] + 3 * size)
    return camera


def draw_mesh(bounds):
    """An image and isosurfaces, chunk by chunk."""
    reader, caster, contour = vtkGatunReader(), vtkGatunRayCaster(), vtkGatunContour()
    reader.SetFileName(path)
    reader.UpdateInformation()
    arrays = reader.GetPointDataArraySelection()
    name = arrays.GetArrayName(0) if arrays.GetNumberOfArrays() else ""
    caster.SetSize(16, 16)
    caster.SetCamera(look_at(bounds))
    caster.SetProperty(vtkVolumeProperty())
    caster.SetArrayName(name)
    contour.SetInputArrayToProcess(0, 0, 0, 0, name)
    contour.GenerateValues(3, -1, 1)
    for algorithm in caster, contour:
        errors, more = gm.Errors(algorithm), gm.Errors(reader)
        algorithm.SetInputConnection(reader.GetOutputPort())
        algorithm.Update()
        counts["reads in a VTK program"] += 1
        counts["refused by readers"] += bool(errors.messages or more.messages)


def read_volume():
    reader, projection = vtkGatunHartleyReader(), vtkGatunHartleyProjection()
    errors, more = gm.Errors(reader), gm.Errors(projection)
    reader.SetFileName(path)
    reader.Update()
    check(reader, errors)
    projection.SetInputConnection(reader.GetOutputPort())
    projection.Update()
    counts["reads in a VTK program"] += 1
    counts["refused by readers"] += bool(more.messages)


def main():
    global path
    now = pathlib.Path(sys.argv[1])
    for path in sys.argv[2:]:
        now.write_text(path, encoding="utf-8")
        peak()
        if path.endswith(".ghv"):
            read_volume()
        else:
            reader = vtkGatunSurfaceReader()
            is_surface = reader.CanReadFile(path) and not vtkGatunReader().CanReadFile(path)
            bounds = read_mesh(vtkGatunSurfaceReader if is_surface else vtkGatunReader)
            if not is_surface and bounds:
                draw_mesh(bounds)
        most = peak()
        if most > MOST_RESIDENT:
            stop(f"{most // MIB} MiB resident")
    print(json.dumps(counts))


main()
