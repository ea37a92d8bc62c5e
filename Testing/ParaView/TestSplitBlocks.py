# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Blocks that are saved as a .gtn file come back by Gatun Split Blocks with their names and arrays, on
one rank and on several."""

import gatunSample as sample
from gatunParaView import load_plugin

simple = load_plugin()
mesh = sample.make_source()
more = simple.Calculator(Input=mesh, ResultArrayName="second only", Function="2*coordsX")
faces = simple.AppendDatasets(Input=simple.ExtractSurface(Input=mesh))  # an unstructured grid
group = simple.GroupDatasets(Input=[mesh, more, faces])
group.BlockNames = ["first", "second", "faces"]
path = sample.temporary("blocks.gtn")
simple.SaveData(path, proxy=simple.GatunMergeBlocks(Input=group), ChunkSize=300)
reader = simple.OpenDataFile(path)
# Programmable filters import names such as split and block into this module.
gatun_split = simple.GatunSplitBlocks(Input=reader)

# One block as a grid, on each rank, after a look at it.
CHECK = """
gatun_blocks = self.GetInputDataObject(0, 0)
assert gatun_blocks.GetNumberOfPartitionedDataSets() == 3
assert gatun_blocks.GetMetaData(INDEX).Get(gatun_blocks.NAME()) == "TITLE"
gatun_grid = gatun_blocks.GetPartition(INDEX, 0)
assert gatun_grid.GetPointData().HasArray("second only") == (INDEX == 1)
assert gatun_grid.GetPointData().HasArray("wave")
assert not gatun_grid.GetCellData().HasArray("BlockId")
output.VTKObject.ShallowCopy(gatun_grid)
"""
gatun_cells = [sample.TETS, sample.TETS, sample.BOUNDARY]
for gatun_index, name in enumerate(["first", "second", "faces"]):
    gatun_block = simple.ProgrammableFilter(Input=gatun_split,
                                            OutputDataSetType="vtkUnstructuredGrid")
    gatun_block.Script = CHECK.replace("INDEX", str(gatun_index)).replace("TITLE", name)
    owned = sample.owned(gatun_block)[1]
    assert owned == gatun_cells[gatun_index], (name, owned, gatun_cells)
    if gatun_index < 2:
        assert abs(sample.volume(gatun_block) - sample.VOLUME) < 1e-5 * sample.VOLUME
