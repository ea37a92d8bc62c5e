# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""When one rank cannot draw its part of a volume, all ranks report it, none shows anything, and the next
image is as it should be. A rank without cells, or with nothing at all, is no error.
"""

import os
import sys

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()

view = drawing.make_view()
background = drawing.draw(view)

# All cells are on the first rank; the others have nothing, not even arrays.
whole = sample.make_source()
shown = drawing.show(whole, view)
first = drawing.draw(view)
drawing.require_other(first, background)

# The last rank has cells without the array.
broken = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
broken.Script = sample.SCRIPT + """
from paraview.modules.vtkRemotingCore import vtkProcessModule
gatun_module = vtkProcessModule.GetProcessModule()
gatun_fill(output)
if gatun_module.GetPartitionId() == gatun_module.GetNumberOfLocalPartitions() - 1:
    output.VTKObject.GetPointData().RemoveArray("wave")
"""
simple.Hide(whole, view)
simple.Show(broken, view)
shown_broken = drawing.show(broken, view)
drawing.require_same(drawing.draw(view), background)
simple.Hide(broken, view)
simple.Show(whole, view)
drawing.require_same(drawing.draw(view), first)

# A file that is damaged.
path = sample.temporary("volume-rank-errors.gtn")
simple.SaveData(path, proxy=whole, ChunkSize=300)
simple.Hide(whole, view)
reader = simple.GatunReader(FileNames=[path], LargeMesh=0)
drawing.show(reader, view)
near = {"by": 2, "pixels": 0}
drawing.require_same(drawing.draw(view), first, **near)
if rank == 0:
    size = os.path.getsize(path)
    with open(path, "r+b") as file:
        file.seek(size // 8)
        file.write(bytes(size // 2))
simple.ReloadFiles(reader)
drawing.require_same(drawing.draw(view), background)
simple.Hide(reader, view)
simple.Show(whole, view)
drawing.require_same(drawing.draw(view), first)
print("done")
sys.stdout.flush()
