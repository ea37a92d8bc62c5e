# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A reader, a contour, a simplifier, a ray caster and a mapper on one file: it is opened once, a
chunk that one has decoded is there for the others, and all keep to one budget of memory."""

import ctypes
import gc
import os
import struct
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkElevationFilter

import gatunVolumes as gv
from gatun.vtk import vtkGatunContour, vtkGatunFileHandle, vtkGatunReader, vtkGatunSimplify

gm = gv.gm
KEY = vtkGatunFileHandle.FILE_HANDLE()


class Opens:
    """Counts how often a file is opened, by whatever code."""

    IN_ACCESS, IN_OPEN = 0x1, 0x20

    def __init__(self, path):
        libc = ctypes.CDLL(None, use_errno=True)
        self.queue = libc.inotify_init1(os.O_NONBLOCK)
        # The system joins events that are alike and follow each other; between two times that a file
        # is opened and read, there is one of reading.
        mask = self.IN_ACCESS | self.IN_OPEN
        if self.queue < 0 or libc.inotify_add_watch(self.queue, path.encode(), mask) < 0:
            print("the system does not report who opens files")
            sys.exit(gm.SKIPPED)
        self.count = 0

    def __call__(self):
        while True:
            try:
                events = os.read(self.queue, 1 << 16)
            except BlockingIOError:
                return self.count
            while events:
                _, mask, _, length = struct.unpack_from("iIII", events)
                self.count += bool(mask & self.IN_OPEN)
                events = events[16 + length:]


def held_open(path):
    """How many descriptors of this process are of a file."""
    links = []
    for fd in os.listdir("/proc/self/fd"):
        try:
            links.append(os.readlink("/proc/self/fd/" + fd))
        except OSError:
            pass  # that of the folder itself
    return links.count(os.path.realpath(path))


def handle_of(algorithm):
    return algorithm.GetOutputInformation(0).Get(KEY)


def surface_of(contour):
    contour.Update()
    assert contour.GetErrorCode() == 0
    points = vtk_to_numpy(contour.GetOutput().GetPoints().GetData())
    return points[vtk_to_numpy(contour.GetOutput().GetPolys().GetConnectivityArray())]


def make_contour(source):
    contour = vtkGatunContour()
    gv.connect(contour, source)
    contour.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    contour.SetValue(0, 0.35)
    return contour


class Consumers:
    """One of each kind, on one reader."""

    def __init__(self, reader):
        self.reader = reader
        self.contour = make_contour(reader)
        self.simplify = vtkGatunSimplify()
        self.simplify.SetInputConnection(reader.GetOutputPort())
        self.scene = gv.Scene(reader)
        self.caster = gv.make_caster(reader, Camera=self.scene.camera,
                                     Property=self.scene.volume.GetProperty(), Size=(80, 60))
        self.actions = [self.surface, self.simple, self.cast, self.draw, self.mesh]

    def surface(self):
        self.contour.Modified()
        return surface_of(self.contour)

    def simple(self):
        self.simplify.Modified()
        self.simplify.Update()
        assert self.simplify.GetErrorCode() == 0
        return vtk_to_numpy(self.simplify.GetOutput().GetPoints().GetData()).copy()

    def cast(self):
        self.caster.Modified()
        return gv.picture_of(self.caster)[0].copy()

    def draw(self):
        return self.scene.render()

    def mesh(self):
        self.reader.UpdatePiece(0, 1, 0)
        return vtk_to_numpy(self.reader.GetOutput().GetPoints().GetData()).copy()


def make_reader(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    for name, value in options.items():
        getattr(reader, "Set" + name)(value)
    return reader


mesh = gv.wave(24)
path = gm.temporary("shared.gtn")
gm.write(mesh, path, ChunkSize=2000, Hierarchy=True)
opens = Opens(path)

# Each by itself, with a reader of its own: what all must give together.
alone = [Consumers(make_reader(path)).actions[i]() for i in range(5)]
assert opens() == 5, opens()

# All on one reader: the file is opened once, whatever comes first and however often.
before = opens()
together = Consumers(make_reader(path))
order = np.random.default_rng(3)
for i in [*range(5), *order.integers(0, 5, 25)]:
    result = together.actions[i]()
    assert result.shape == alone[i].shape
    assert abs(result - alone[i]).max() <= (2 / 255 if i in (2, 3) else 0), i
assert opens() == before + 1, opens() - before
gc.collect()  # the readers of before
held = held_open(path)
assert held == 1, held

# A chunk is decoded once, whoever needs it first.
reader = make_reader(path)
consumers = Consumers(reader)
reader.UpdateInformation()
chunks = reader.GetChunkTable().GetNumberOfRows()
handle = handle_of(reader)
assert handle.GetFileName() == path and handle.GetIsOpen() and handle.GetReason() == ""
assert handle.GetDecodedChunks() == handle.GetFoundChunks() == handle.GetMemory() == 0
consumers.surface()
passed = gm.statistic(consumers.contour, "UsedChunks")
assert 0 < passed < chunks
assert (handle.GetDecodedChunks(), handle.GetFoundChunks()) == (passed, 0)
assert gm.statistic(reader, "DecodedChunks") == 0 and reader.GetOutput().GetNumberOfCells() == 0
consumers.mesh()
assert gm.statistic(reader, "DecodedChunks") == chunks - passed
assert (handle.GetDecodedChunks(), handle.GetFoundChunks()) == (chunks, passed)
read = handle.GetBytesRead()
assert read == gm.statistic(reader, "BytesRead") == gm.statistic(consumers.contour, "BytesRead")
# The whole mesh is in the output of the reader, and what was decoded for it is not kept as well. The
# ray caster and the mapper decode what is not kept, once each, into blocks of their own.
consumers.cast()
consumers.draw()
decoded = 3 * chunks - 2 * passed
assert handle.GetDecodedChunks() == decoded
read = handle.GetBytesRead()
consumers.surface()
consumers.cast()
consumers.draw()
assert handle.GetDecodedChunks() == decoded, "all is kept"
assert handle.GetFoundChunks() > passed + chunks
assert handle.GetBytesRead() == read == gm.statistic(consumers.scene.mapper, "BytesRead")
# The simplifier reads the tree, and decodes what is not kept.
consumers.simple()
assert handle.GetDecodedChunks() == decoded + chunks - passed and handle.GetBytesRead() > read
assert handle_of(reader).GetMemoryBudget() == 512 << 20
assert 0 < handle.GetMemory() < 512 << 20

# What is drawn counts, too, and one number is for all.
full = handle.GetMemory()
fewer = Consumers(make_reader(path))
fewer.draw()
blocks = handle_of(fewer.reader).GetMemory()
assert 30 * mesh.GetNumberOfCells() < blocks < 100 * mesh.GetNumberOfCells(), blocks
assert full > 1.5 * blocks
for budget in (2, 1, 0):
    reader.SetMemoryBudget(budget)  # holds at once
    assert handle.GetMemory() <= handle.GetMemoryBudget() == budget << 20
    for i, action in enumerate(consumers.actions):
        result = action()
        assert abs(result - alone[i]).max() <= (2 / 255 if i in (2, 3) else 0), i
        assert handle.GetMemory() <= budget << 20, (budget, i, handle.GetMemory())

# The handle describes the reader as it is, and the one of before stays as it was.
old = handle_of(reader)
reader.SetSimplificationRatio(0.5)
reader.UpdateInformation()
assert old.GetNumberOfMerges() == 0
assert handle_of(reader).GetNumberOfMerges() == mesh.GetNumberOfPoints() // 2
assert not handle_of(reader).GetIsOnDemand()
reader.SetLargeMesh(0)
reader.UpdateInformation()
assert handle_of(reader).GetIsOnDemand() and handle_of(reader).GetReason() == ""
reader.SetBox(0, 1, 0, 1, 0, 1)
reader.UpdateInformation()
assert "region of interest" in handle_of(reader).GetReason()
assert not handle_of(reader).GetIsOnDemand()
assert opens() == before + 3, opens() - before
assert "FileName: " + path in str(handle)

# Another filter in between ends it: what is behind gets that filter's output.
reader = make_reader(path)
elevation = vtkElevationFilter()
elevation.SetInputConnection(reader.GetOutputPort())
elevation.UpdateInformation()
assert handle_of(reader) and handle_of(elevation) is None
behind = make_contour(elevation)
behind.SetInputArrayToProcess(0, 0, 0, 0, "Elevation")
surface_of(behind)
assert gm.statistic(behind, "Chunks") == 0 and elevation.GetOutput().GetNumberOfCells() > 0
assert gm.statistic(reader, "DecodedChunks") == chunks

# The file changes: once more it is opened once, and nobody draws the old one.
consumers = Consumers(make_reader(path))
for action in consumers.actions:
    action()
first = handle_of(consumers.reader)
other = gv.wave(10, seed=5)
gm.write(other, path, ChunkSize=2000, Hierarchy=True)
opens = Opens(path)
alone = [Consumers(make_reader(path)).actions[i]() for i in range(5)]
before = opens()
for i in (3, 0, 2, 1, 4):
    result = consumers.actions[i]()
    assert result.shape == alone[i].shape
    assert abs(result - alone[i]).max() <= (2 / 255 if i in (2, 3) else 0), i
assert opens() == before + 1, opens() - before
assert handle_of(consumers.reader) is not first

# A file that is not there, and no file at all.
missing = make_reader(path + "-missing")
errors = gm.Errors(missing)
missing.UpdateInformation()
assert not handle_of(missing).GetIsOpen() and path in handle_of(missing).GetReason(), str(errors)
assert handle_of(missing).GetMemory() == handle_of(missing).GetBytesRead() == 0
nothing = vtkGatunReader()
gm.Errors(nothing)
nothing.UpdateInformation()
assert handle_of(nothing) is None
empty = vtkGatunFileHandle()
assert not empty.GetIsOpen() and empty.GetMemoryBudget() == 0
