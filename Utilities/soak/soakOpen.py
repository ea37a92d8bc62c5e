#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Opens and reads many files in one process: soakOpen.py INPUTS FOLDER COUNT

Good and damaged files of all kinds, whole, in part or not at all. Prints as JSON the number of opens, and
memory and open descriptors after the first tenth and at the end.
"""

import json
import os
import pathlib
import random
import shutil
import sys

from vtkmodules.vtkRenderingCore import vtkCamera, vtkVolumeProperty

import gatunMeshes as gm
from gatun import (vtkGatunContour, vtkGatunHartleyReader, vtkGatunRayCaster, vtkGatunReader,
                   vtkGatunSurfaceReader)

FILES = {"a.gtn": vtkGatunReader, "a-steps.gtn": vtkGatunReader,
         "a-surface.gtn": vtkGatunSurfaceReader, "a.ghv": vtkGatunHartleyReader}
WAYS = "open", "piece", "whole", "image", "isosurface"
CAMERA = vtkCamera()
CAMERA.SetPosition(2, 3, 4)


def resident():
    """Bytes of memory, and open descriptors, of this process."""
    pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return {"resident": pages * os.sysconf("SC_PAGE_SIZE"),
            "descriptors": len(os.listdir("/proc/self/fd"))}


def damage(data, choice):
    """Cut off, or with some wrong bytes."""
    at = choice.randrange(len(data))
    if choice.random() < 0.3:
        return data[:at]
    changed = bytearray(data)
    changed[at:at + 16] = choice.randbytes(len(changed[at:at + 16]))
    return bytes(changed)


def make_files(inputs, folder, choice):
    """(path, type of the reader, whether it is good) of each file."""
    found = []
    for name, reader_type in FILES.items():
        shutil.copy(inputs / name, folder)
        found.append((folder / name, reader_type, True))
        data = (inputs / name).read_bytes()
        for number in range(12):
            path = folder / f"damaged-{number}-{name}"
            path.write_bytes(damage(data, choice))
            found.append((path, reader_type, False))
    return found


def open_once(path, reader_type, way):
    """Whether it could be read, as far as the way reads."""
    reader = reader_type()
    errors = gm.Errors(reader)
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    consumer = reader
    if way == "piece":
        reader.UpdatePiece(0, 4, 0)
    elif way == "whole":
        reader.Update()
    elif way in ("image", "isosurface") and reader_type is vtkGatunReader:
        if way == "image":
            consumer = vtkGatunRayCaster()
            consumer.SetSize(8, 8)
            consumer.SetArrayName("wave")
            consumer.SetCamera(CAMERA)
            consumer.SetProperty(vtkVolumeProperty())
        else:
            consumer = vtkGatunContour()
            consumer.SetInputArrayToProcess(0, 0, 0, 0, "wave")
            consumer.SetValue(0, 0.25)
        more = gm.Errors(consumer)
        consumer.SetInputConnection(reader.GetOutputPort())
        consumer.Update()
        errors.messages += more.messages
    return not (errors.messages or reader.GetErrorCode() or consumer.GetErrorCode())


def main():
    inputs, folder, count = sys.argv[1:]
    folder, count, choice = pathlib.Path(folder), int(count), random.Random(int(count))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    files = make_files(pathlib.Path(inputs), folder, choice)
    refused, early = 0, None
    for number in range(count):
        # As many of the good files as of the damaged ones.
        path, reader_type, is_good = choice.choice(files if number % 2 else files[::13])
        read = open_once(path, reader_type, choice.choice(WAYS))
        refused += not read
        if is_good and not read:
            print(f"{path}: a good file was refused at open {number}")
            sys.exit(3)
        if number == count // 10:
            early = resident()
    print(json.dumps({"opens": count, "refused": refused, "early": early, "late": resident()}))


main()
