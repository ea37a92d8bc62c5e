# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunWriter on several processes: each has some of the cells, at random, the last one none, and all
write one file. It has the mesh, values and time steps of the whole; errors of one process are those of all."""

import os
import resource
import sys

import numpy as np

try:
    from mpi4py import MPI
    from vtkmodules.vtkParallelMPI import vtkMPIController
except ImportError:
    sys.exit(125)
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunReader
from gatunPieceSource import PieceSource, mark_ghosts, write_pieces

world = MPI.COMM_WORLD
rank, ranks = world.Get_rank(), world.Get_size()
controller = vtkMPIController()
controller.Initialize()
assert (controller.GetLocalProcessId(), controller.GetNumberOfProcesses()) == (rank, ranks)
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], f"writer-processes-{ranks}")
if rank == 0:
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
world.Barrier()
path = os.path.join(folder, "processes.gtn")


def make_source(make, times=(), kind="vtkUnstructuredGrid"):
    """make(step) returns the piece of this process."""

    def make_piece(piece, pieces, step):
        assert (piece, pieces) == (rank if ranks > 1 else 0, ranks)
        return make(step)

    return PieceSource(make_piece, times, kind)


def write(source, expected=1, **options):
    made = write_pieces(source, options.pop("FileName", path), expected, Controller=controller,
                        **options)
    world.Barrier()
    assert len(os.listdir(folder)) == (1 if os.path.exists(path) else 0), os.listdir(folder)
    return made


whole = gm.block(n=7)
cells = whole.GetNumberOfCells()
owner = np.random.default_rng(5).integers(0, max(ranks - 1, 1), cells)  # the last one has none


def own_part(grid):
    return gm.part_of(grid, owner == rank) if (owner == rank).any() else vtkUnstructuredGrid()


writer, messages = write(make_source(lambda step: own_part(whole)))
assert not messages, messages
gm.assert_same_mesh(gm.read(path), whole)
assert gm.statistic(writer, "Points") == whole.GetNumberOfPoints()
assert gm.statistic(writer, "Cells") == cells
assert gm.statistic(writer, "FileBytes") == os.path.getsize(path)
sent = world.allreduce(gm.statistic(writer, "BytesSent"))
assert (sent > 0) == (ranks > 1) and sent < 100 * cells * ranks, sent

# Time steps.
steps = [gm.block(n=7) for _ in range(3)]
for step, grid in enumerate(steps):
    gm.add_array(grid.GetPointData(), gm.coordinates(grid)[:, 0] * step, "moving")
times = [0., .5, 2.]
writer, messages = write(make_source(lambda step: own_part(steps[step]), times), WriteAllTimeSteps=True)
assert not messages, messages
assert gm.statistic(writer, "TimeSteps") == 3
reader = vtkGatunReader()
reader.SetFileName(path)
for step, time in enumerate(times):
    reader.UpdateTimeStep(time)
    gm.assert_same_mesh(reader.GetOutput(), steps[step])
world.Barrier()


# Ghost cells are not written.
def with_ghosts(_step):
    extra = (owner != rank) & (np.arange(cells) % 3 == 0)
    wanted = (owner == rank) | extra
    return mark_ghosts(gm.part_of(whole, wanted), extra[wanted])


if ranks > 1:
    write(make_source(with_ghosts))
    gm.assert_same_mesh(gm.read(path), whole)
    world.Barrier()

# No process has cells.
write(make_source(lambda step: vtkUnstructuredGrid()))
assert gm.read(path).GetNumberOfCells() == 0
world.Barrier()

# Surfaces are joined, too. Processes must agree on what they write.
sheet = pd.wave(20)
polygons = pd.cells_of(sheet)[2]
mine = [polygon for i, polygon in enumerate(polygons) if i * max(ranks - 1, 1) // len(polygons) == rank]


def own_sheet(_step):
    ids = sorted({i for polygon in mine for i in polygon})
    place = {i: n for n, i in enumerate(ids)}
    points = gm.vtk_to_numpy(sheet.GetPoints().GetData())[ids]
    return pd.make(points, Polys=[[place[i] for i in polygon] for polygon in mine])


_, messages = write(make_source(own_sheet, kind="vtkPolyData"))
assert not messages, messages
joined = pd.read(path)
assert joined.GetNumberOfPoints() == len({i for polygon in polygons for i in polygon})
assert pd.canonical(joined)[1] == pd.canonical(sheet)[1]
world.Barrier()
if ranks > 1:
    before = open(path, "rb").read()
    world.Barrier()
    mixed = make_source(own_sheet, kind="vtkPolyData") if rank == 0 else make_source(
        lambda step: own_part(whole))
    _, messages = write(mixed, expected=0)
    assert len(messages) == 1 and "some processes have a surface" in messages[0], messages
    assert open(path, "rb").read() == before
    world.Barrier()

# An array that one process does not have, and a folder that is missing, are errors of all.
if ranks > 2:
    def without_array(_step):
        grid = own_part(whole)
        if rank == 1:
            grid.GetPointData().RemoveArray(0)
        return grid

    before = open(path, "rb").read()
    world.Barrier()
    _, messages = write(make_source(without_array), expected=0)
    assert len(messages) == 1 and "array" in messages[0], messages
    assert open(path, "rb").read() == before
if ranks > 1:
    _, messages = write(make_source(lambda step: own_part(whole)), expected=0,
                        FileName=os.path.join(folder, "missing", "file.gtn"))
    assert len(messages) == 1 and "missing" in messages[0], messages
    _, messages = write(make_source(lambda step: own_part(whole)), expected=0, Hierarchy=True)
    assert len(messages) == 1 and "hierarchy" in messages[0], messages

    # A process whose disk is full, as soon as it begins or near the end.
    before = open(path, "rb").read()
    old = resource.getrlimit(resource.RLIMIT_FSIZE)
    for size in (0, 1000, 4000):
        world.Barrier()
        if rank == ranks - 2:
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, old[1]))
        writer, messages = write(make_source(lambda step: own_part(whole)), expected=0)
        resource.setrlimit(resource.RLIMIT_FSIZE, old)
        assert writer.GetErrorCode() != 0
        assert len(messages) == 1 and "File too large" in messages[0], (size, messages)
        assert os.listdir(folder) == ["processes.gtn"], os.listdir(folder)
        assert open(path, "rb").read() == before
