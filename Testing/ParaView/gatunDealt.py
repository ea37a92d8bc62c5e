# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes whose cells are dealt out to the ranks at random, and what is known about them."""

import numpy as np
from gatunParaView import rank_and_ranks
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

SIDE = 6
POINTS = (SIDE + 1) ** 3

# A grid of boxes with arrays. Boxes are hexahedra, or tetrahedra, or one or the other. The owner of each
# cell is random; with an idle rank, the last one has none.
SCRIPT = """
def gatun_deal(output, kind, idle, time, block=0, everything=False, failing=""):
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
    from vtkmodules.vtkFiltersCore import vtkExtractCells
    from vtkmodules.vtkCommonCore import vtkIdList
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    module = vtkProcessModule.GetProcessModule()
    rank, ranks = module.GetPartitionId(), module.GetNumberOfLocalPartitions()
    n = %d
    axis = np.arange(n + 1)
    x, y, z = (a.ravel() for a in np.meshgrid(axis, axis, axis, indexing="ij"))
    points = np.stack([x + 2 * n * block, y, z], 1).astype(np.float64)
    inside = (x < n) & (y < n) & (z < n)
    at = lambda i, j, k: (((x + i) * (n + 1) + y + j) * (n + 1) + z + k)[inside]
    box = [at(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    paths = ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1))
    whole = vtkUnstructuredGrid()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=1))
    whole.SetPoints(coordinates)
    for i in range(len(box[0])):
        if kind == "hexes" or kind == "mixed" and i %% 3:
            whole.InsertNextCell(12, 8, [int(box[c][i]) for c in (0, 4, 6, 2, 1, 5, 7, 3)])
        else:
            for a, b in paths:
                whole.InsertNextCell(10, 4, [int(box[c][i]) for c in (0, b, a, 7)])
    count = whole.GetNumberOfCells()
    def add(data, values, name):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.AddArray(array)
    add(whole.GetPointData(), np.sin(points / 3).sum(1) + time, "wave")
    add(whole.GetPointData(), points * (1 + time), "moved")
    add(whole.GetCellData(), np.arange(count, dtype=np.int32) + 10000 * block, "cell")
    owner = np.random.default_rng(7 + block).integers(0, ranks - idle if ranks > idle else 1, count)
    if everything:
        owner[:] = rank
    mine = vtkIdList()
    for cell in np.flatnonzero(owner == rank):
        mine.InsertNextId(int(cell))
    extract = vtkExtractCells()
    extract.SetInputData(whole)
    extract.SetCellList(mine)
    extract.Update()
    part = extract.GetOutput()
    part.GetPointData().RemoveArray("vtkOriginalPointIds")
    part.GetCellData().RemoveArray("vtkOriginalCellIds")
    if mine.GetNumberOfIds() == 0:
        part = vtkUnstructuredGrid()
    if failing and rank == ranks - 1:
        if failing == "cells":
            part.InsertNextCell(12, 8, [1000000] * 8)
        elif failing == "array":
            part.GetPointData().RemoveArray("wave")
    output.ShallowCopy(part)
""" % SIDE

TIMES = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
gatun_info = self.GetOutputInformation(0)
gatun_info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), [0.5, 1.5, 4], 3)
gatun_info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [0.5, 4], 2)
"""
NOW = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
gatun_now = self.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
"""


def make(kind, idle=0, moving=False, failing=""):
    source = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
    source.ScriptRequestInformation = TIMES if moving else ""
    source.Script = SCRIPT + (NOW if moving else "gatun_now = 0") + \
        "\ngatun_deal(output.VTKObject, %r, %d, gatun_now, failing=%r)" % (kind, idle, failing)
    return source


def make_blocks():
    """Three blocks: one on the first rank, one on all, and one, with an array of its own, on the last."""
    source = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet")
    source.Script = SCRIPT + """
def gatun_blocks(output):
    from vtkmodules.vtkCommonCore import vtkFloatArray
    from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    module = vtkProcessModule.GetProcessModule()
    rank, ranks = module.GetPartitionId(), module.GetNumberOfLocalPartitions()
    inner = vtkMultiBlockDataSet()
    output.SetNumberOfBlocks(3)
    inner.SetNumberOfBlocks(1)
    for block, (tree, index, has) in enumerate(
            ((output, 0, rank == 0), (inner, 0, True), (output, 2, rank == ranks - 1))):
        if has:
            grid = vtkUnstructuredGrid()
            gatun_deal(grid, "mixed", 0, 0, block, everything=block != 1)
            if block == 2:
                only = vtkFloatArray()
                only.SetName("only")
                only.SetNumberOfValues(grid.GetNumberOfCells())
                only.Fill(3)
                grid.GetCellData().AddArray(only)
            tree.SetBlock(index, grid)
        tree.GetMetaData(index).Set(vtkMultiBlockDataSet.NAME(), "block %d" % block)
    if inner.GetBlock(0) is not None:
        output.SetBlock(1, inner)
gatun_blocks(output.VTKObject)
"""
    return source


def expected(kind, time=0, block=0):
    """What describe returns for the whole mesh."""
    variables = {}
    exec(SCRIPT, variables)  # pylint: disable=exec-used
    whole = vtkUnstructuredGrid()
    variables["gatun_deal"](whole, kind, 0, time, block, everything=True)
    return cells_of(whole)


def cells_of(grid):
    """Type, corners and arrays of each cell but ghosts, in the order of the array "cell"."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    each = np.concatenate([points] + [
        vtk_to_numpy(grid.GetPointData().GetArray(name)).reshape(len(points), -1)
        for name in ("wave", "moved")], 1)
    names = [grid.GetCellData().GetArrayName(i) for i in range(grid.GetCellData().GetNumberOfArrays())]
    arrays = {name: vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in names
              if name not in ("GlobalCellIds", "vtkGhostType", "vtkOriginalCellIds")}
    ghosts = grid.GetCellData().GetArray("vtkGhostType")
    found = {}
    for cell in range(grid.GetNumberOfCells()):
        if ghosts and int(ghosts.GetValue(cell)) & 1:
            continue
        ids = grid.GetCell(cell).GetPointIds()
        corners = each[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        key = int(arrays["cell"][cell])
        assert key not in found, key
        found[key] = (grid.GetCellType(cell), sorted(map(tuple, corners.tolist())),
                      {name: float(array[cell]) for name, array in arrays.items()})
    return found


def describe(reader, time=None):
    """The cells of a proxy on all ranks."""
    if time is None:
        reader.UpdatePipeline()
    else:
        reader.UpdatePipeline(time)
    found = {}
    for rank in range(rank_and_ranks()[1]):
        part = simple.servermanager.Fetch(reader, rank)
        if part.GetNumberOfCells() > 0:
            cells = cells_of(part)
            assert not found.keys() & cells.keys()
            found.update(cells)
    return found
