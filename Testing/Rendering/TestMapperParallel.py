# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunVolumeMapper on several processes, in plain VTK: each has some of the cells, at random, and one
has opaque geometry. Images composited by depth are those of one process with everything."""

import sys

import numpy as np

try:
    from mpi4py import MPI
    from vtkmodules.vtkParallelMPI import vtkMPIController
except ImportError:
    sys.exit(125)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIdList

try:
    from vtkmodules.vtkFiltersExtraction import vtkExtractCells
except ImportError:
    from vtkmodules.vtkFiltersCore import vtkExtractCells  # from VTK 9.2 on

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunVolumeMapper

SIZE = (150, 110)
world = MPI.COMM_WORLD
rank, ranks = world.Get_rank(), world.Get_size()
controller = vtkMPIController()
controller.Initialize()
assert (controller.GetLocalProcessId(), controller.GetNumberOfProcesses()) == (rank, ranks)


def scatter(grid):
    """The cells of this process; the last one has none."""
    owner = np.random.default_rng(1).integers(0, max(ranks - 1, 1), grid.GetNumberOfCells())
    ids = vtkIdList()
    for cell in np.flatnonzero(owner == rank):
        ids.InsertNextId(int(cell))
    extract = vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(ids)
    extract.Update()
    return extract.GetOutput()


def depths(scene):
    width, height = scene.window.GetSize()
    data = vtkFloatArray()
    scene.window.GetZbufferData(0, 0, width - 1, height - 1, data)
    return vtk_to_numpy(data).reshape(height, width).copy()


def composite(scene):
    """The nearest of the images of all processes, on the first one; elsewhere nothing."""
    image = scene.render()
    images = world.gather((image, depths(scene)))
    if rank != 0:
        return None
    nearest = np.argmin([depth for _, depth in images], 0)
    return np.choose(nearest[..., None], [colors for colors, _ in images])


def make(source, parallel):
    scene = gv.Scene(source, SIZE, AutoAdjustSampleDistances=False)
    scene.renderer.GetCullers().RemoveAllItems()
    if parallel:
        scene.mapper.SetController(controller)
    if not parallel or rank == ranks - 1:
        scene.renderer.AddActor(gv.cube((0.4, 0.7, 0.3, 0.9, 0.2, 0.6), (1, 1, 0.5)))
    return scene


def require_same(parallel, whole):
    """Within 1 of 255 except for 0.01 % of the pixels."""
    image = composite(parallel)
    if rank == 0:
        expected = whole.render()
        assert expected[..., :3].std() > 0.05, "there is nothing to be seen"
        apart = np.abs(image - expected)[..., :3].max(2) * 255
        assert (apart > 1.5).mean() <= 1e-4, (int((apart > 1.5).sum()), apart.max())


whole_grid = gv.wave()
part = scatter(whole_grid)
cells = world.allgather(part.GetNumberOfCells())
assert sum(cells) == whole_grid.GetNumberOfCells() and (cells[-1] == 0) == (ranks > 1), cells
parallel, whole = make(part, True), make(whole_grid, False)
both = (parallel, whole)
for mode in (0, 1, vtkGatunVolumeMapper.XRAY_BLEND):
    for scene in both:
        scene.set(BlendMode=mode)
    require_same(*both)
for scene in both:
    scene.set(BlendMode=0)
    scene.volume.GetProperty().ShadeOn()
require_same(*both)
for scene in both:
    scene.volume.GetProperty().ShadeOff()
    scene.set(ImageSampleDistance=3.0)
require_same(*both)
for scene in both:
    scene.set(ImageSampleDistance=1.0, IntermixIntersectingGeometry=False)
require_same(*both)
for scene in both:
    scene.set(IntermixIntersectingGeometry=True)
    scene.volume.SetScale(0.8, 1.2, 0.9)
    scene.look(0.3, -0.5, parallel=True)
require_same(*both)
assert (gm.statistic(parallel.mapper, "BytesSent") > 0) == (ranks > 1)

# Bounds are those of all parts, also for processes without cells.
parallel.mapper.ReduceBounds()
assert parallel.mapper.GetBounds() == whole.mapper.GetBounds()

# One process shows all, for programs that blend images in an order.
parallel.set(ImageProcess=0)
colors = parallel.render()
shown = world.allgather(float(np.abs(colors[..., :3] - gv.BACKGROUND).max()) > 0.01)
assert shown == ([True] + [False] * (ranks - 2) + [True])[-ranks:], shown  # the last has the cube
parallel.set(ImageProcess=-1)
require_same(*both)

# All have the same file; or a pipeline that makes pieces, which each asks for.
reader = gv.write(whole_grid, "parallel-%d.gtn" % rank, 100)
world.Barrier()
from_file = make(reader, True)
from_file.volume.SetScale(0.8, 1.2, 0.9)
from_file.look(0.3, -0.5, parallel=True)
require_same(from_file, whole)
assert gm.statistic(from_file.mapper, "BytesRead") > 0
pieces = gv.write(whole_grid, "parallel-pieces-%d.gtn" % rank, 100)
pieces.SetBox(-1, 2, -1, 2, -1, 2)
for count in (1, 3):
    of_pieces = make(pieces, True)
    of_pieces.mapper.SetNumberOfPieces(count)
    of_pieces.volume.SetScale(0.8, 1.2, 0.9)
    of_pieces.look(0.3, -0.5, parallel=True)
    require_same(of_pieces, whole)

# An error in one process is one of all, and nothing is drawn; the next image is right again.
failures = []
parallel.mapper.AddObserver("ErrorEvent", lambda *_: failures.append(1))
if rank == 0:
    parallel.mapper.SetScalarModeToUseCellFieldData()
    parallel.mapper.SelectScalarArray("no such")
image = parallel.render()
assert parallel.mapper.GetErrorCode() != 0 and failures
if rank != ranks - 1:
    assert np.abs(image[..., :3] - gv.BACKGROUND).max() < 0.01
if rank == 0:
    parallel.mapper.SetScalarModeToDefault()
require_same(*both)
assert parallel.mapper.GetErrorCode() == 0
controller.Finalize(1)
print("done")
