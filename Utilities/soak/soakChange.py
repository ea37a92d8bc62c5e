#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files that change while they are open: soakChange.py INPUTS FOLDER SEED SECONDS

Another process truncates, overwrites, replaces and deletes a file while this one reads and draws it. Each
result is that of one of two whole files, or there is an error. Prints counts as JSON; ends with exit code
3 and a message if a result is anything else.
"""

import hashlib
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkCamera, vtkVolumeProperty

import gatunMeshes as gm
from gatun import (vtkGatunContour, vtkGatunHartleyProjection, vtkGatunHartleyReader,
                   vtkGatunRayCaster, vtkGatunReader, vtkGatunSimplify, vtkGatunSurfaceReader)

CAMERA = vtkCamera()
CAMERA.SetPosition(2, 3, 4)

counts = {"results": 0, "errors": 0, "changes": 0}


# --------------------------------------------------------------------------------------------------
# The process that changes the file


def change(path, whole, choice):
    """One change; whole: the contents that a file may have."""
    content = choice.choice(whole)
    size = len(content)
    at = choice.randrange(size)
    how = choice.randrange(8)
    if how == 0:
        os.truncate(path, at)
    elif how == 1:
        # In place, with the size of before or of the new content.
        with open(path, "r+b") as file:
            file.write(content)
            if choice.random() < 0.5:
                file.truncate(size)
    elif how == 2:
        with open(path, "r+b") as file:
            file.seek(at)
            file.write(content[at:at + choice.choice((1, 100, 10000))])
    elif how == 3:
        with open(path, "r+b") as file:
            file.seek(at)
            file.write(choice.randbytes(choice.choice((1, 16, 1000))))
    elif how == 4:
        os.remove(path)
    elif how == 5:
        # Nobody can tell by size and time.
        before = os.stat(path)
        with open(path, "r+b") as file:
            file.write(content)
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    else:
        put_whole(path, content)


def put_whole(path, content):
    beside = path.with_suffix(".new")
    beside.write_bytes(content)
    os.replace(beside, path)


def keep_changing(path, whole, seed):
    """Until killed; the file is whole again and again. Counts its changes in a file."""
    choice = random.Random(seed)
    for number in range(1 << 40):
        try:
            change(path, whole, choice)
        except FileNotFoundError:
            pass
        path.with_suffix(".count").write_text(str(number + 1), encoding="ascii")
        time.sleep(choice.choice((0, 0.001, 0.01)))
        if choice.random() < 0.8:
            put_whole(path, choice.choice(whole))
            time.sleep(choice.choice((0, 0.005, 0.03)))


class Changer:
    """Changes a file as long as the block runs."""

    def __init__(self, path, whole, seed):
        self.path, self.whole, self.seed = path, whole, seed

    def __enter__(self):
        put_whole(self.path, self.whole[0])
        self.process = os.fork()
        if self.process == 0:
            try:
                keep_changing(self.path, self.whole, self.seed)
            finally:
                os._exit(1)
        return self

    def __exit__(self, *_):
        ended, _ = os.waitpid(self.process, os.WNOHANG)
        if ended:
            stop(self.path, "the process that changes the file has ended")
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        count = self.path.with_suffix(".count")
        counts["changes"] += int(count.read_text(encoding="ascii") or 0) if count.exists() else 0
        put_whole(self.path, self.whole[0])


# --------------------------------------------------------------------------------------------------
# Those who read it


def stop(path, what):
    print(f"{path}: {what}")
    sys.exit(3)


def fingerprint(data):
    """Of all that is in a data set."""
    found = hashlib.sha256()
    arrays = [data.GetPoints().GetData()] if data.IsA("vtkPointSet") and data.GetPoints() else []
    if data.IsA("vtkUnstructuredGrid"):
        arrays.append(data.GetCells().GetConnectivityArray())
    if data.IsA("vtkPolyData"):
        arrays.append(data.GetPolys().GetConnectivityArray())
    for attributes in data.GetPointData(), data.GetCellData():
        arrays += [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    for array in arrays:
        found.update(vtk_to_numpy(array).tobytes())
    return found.hexdigest()


class Reads:
    """A reader whose output is asked for in a way."""

    def __init__(self, path, reader_type=vtkGatunReader, **options):
        self.path = path
        self.last = self.reader = reader_type()
        self.reader.SetFileName(str(path))
        for name, value in options.items():
            getattr(self.reader, "Set" + name)(value)
        self.said = [gm.Errors(self.reader)]

    def ask(self, number):
        """A fingerprint of the result, or None if there is an error."""
        self.last.Modified()  # what is in a file is no matter of the pipeline
        self.update(number)
        failed = self.last.GetErrorCode() or self.reader.GetErrorCode()
        for errors in self.said:
            failed = failed or errors.messages
            errors.messages.clear()
        return None if failed else fingerprint(self.last.GetOutputDataObject(0))

    def update(self, _):
        self.last.Update()


class ReadsPieces(Reads):
    def update(self, number):
        self.last.UpdatePiece(number % 4, 4, number % 2)


class ReadsSteps(Reads):
    def update(self, number):
        self.last.UpdateInformation()
        times = self.last.GetOutputInformation(0).Get(Pipeline.TIME_STEPS())
        if times and number < len(times):
            self.last.UpdateTimeStep(times[number])
        else:
            self.said[0].messages.append("no such step")


class Consumes(Reads):
    """A filter that takes the file from its reader, chunk by chunk."""

    def __init__(self, path, filter_type, reader_type=vtkGatunReader, **options):
        super().__init__(path, reader_type)
        self.last = filter_type()
        for name, value in options.items():
            getattr(self.last, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        self.last.SetInputConnection(self.reader.GetOutputPort())
        self.said.append(gm.Errors(self.last))


WAYS = {
    "whole": ("a.gtn", 1, Reads),
    "without cache": ("a.gtn", 1, lambda path: Reads(path, MemoryBudget=0)),
    "in pieces": ("a.gtn", 4, ReadsPieces),
    "simplified": ("a.gtn", 1, lambda path: Reads(
        path, SimplificationRatio=0.6)),
    "steps": ("a-steps.gtn", 4, ReadsSteps),
    "surface": ("a-surface.gtn", 1, lambda path: Reads(path, vtkGatunSurfaceReader)),
    "volume": ("a.ghv", 1, lambda path: Reads(path, vtkGatunHartleyReader)),
    "image": ("a.gtn", 1, lambda path: Consumes(path, vtkGatunRayCaster, Size=(16, 16),
                                                ArrayName="wave", Camera=CAMERA,
                                                Property=vtkVolumeProperty())),
    "isosurface": ("a.gtn", 1, lambda path: Consumes(
        path, vtkGatunContour, InputArrayToProcess=(0, 0, 0, 0, "wave"), Value=(0, 0.25))),
    "filter": ("a.gtn", 1, lambda path: Consumes(path, vtkGatunSimplify)),
    "projection": ("a.ghv", 1, lambda path: Consumes(
        path, vtkGatunHartleyProjection, vtkGatunHartleyReader, Size=(16, 16))),
}


def try_way(inputs, folder, way, choice, seconds):
    """For some time."""
    name, requests, make = WAYS[way]
    both = [inputs / name, inputs / name.replace("a", "b", 1)]
    whole = [file.read_bytes() for file in both]
    right = [{make(file).ask(number) for file in both} for number in range(requests)]
    if any(len(one) != 2 or None in one for one in right):
        stop(name, f"{way}: the files cannot be told from each other: {right}")
    path = folder / name
    end = time.monotonic() + seconds
    with Changer(path, whole, choice.random()):
        consumer = make(path)
        while True:
            number = choice.randrange(requests)
            found = consumer.ask(number)
            counts["results" if found else "errors"] += 1
            if found and found not in right[number]:
                stop(path, f"{way}: neither the one file nor the other")
            if choice.random() < 0.1:
                consumer = make(path)
            if time.monotonic() > end:
                break
    # Once the file is whole again, so is the result.
    if consumer.ask(0) not in right[0]:
        stop(path, f"{way}: no result from a file that is whole again")


def try_program(inputs, folder, choice, seconds):
    """gtn in place of this process."""
    gtn = os.environ["GATUN_TEST_GTN"]
    both = [inputs / f"{name}.gtn" for name in "ab"]
    path, out = folder / "program.gtn", folder / "out.vtu"

    def unpack(file):
        run = subprocess.run([gtn, "unpack", "-q", "-f", file, out], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, check=False)
        if run.returncode not in (0, 1) or run.returncode == 1 and not run.stdout.startswith("gtn: "):
            stop(path, f"gtn unpack: {run.returncode}: {run.stdout}")
        return hashlib.sha256(out.read_bytes()).hexdigest() if run.returncode == 0 else None

    right = {unpack(file) for file in both}
    end = time.monotonic() + seconds
    with Changer(path, [file.read_bytes() for file in both], choice.random()):
        while True:
            found = unpack(path)
            counts["results" if found else "errors"] += 1
            if found and found not in right:
                stop(path, "gtn unpack: neither the one file nor the other")
            if time.monotonic() > end:
                break


def main():
    inputs, folder, seed, seconds = sys.argv[1:]
    inputs, folder, choice = pathlib.Path(inputs), pathlib.Path(folder), random.Random(int(seed))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    each = float(seconds) / (len(WAYS) + 1)
    for way in WAYS:
        try_way(inputs, folder, way, choice, each)
    try_program(inputs, folder, choice, each)
    print(json.dumps(counts))


main()
