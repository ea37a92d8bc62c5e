# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A file that is organised by layers of values is drawn as the mesh in memory, also simplified."""

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunReader

grid = gv.box(16)
expected = gv.draw(grid)
gv.require_same(expected[0], expected[0])
for layers in (("wave", -1, 4), ("wave", -1, 40), "vector"):
    name = gm.temporary("drawn-layers.gtn")
    gm.write(grid, name, Layers=layers, ChunkSize=700)
    reader = vtkGatunReader()
    reader.SetFileName(name)
    for budget in (0, 512):
        reader.SetMemoryBudget(budget)
        drawn = gv.draw(reader)
        gv.require_same(drawn[0], expected[0], tolerance=1 / 255)
    assert reader.GetOutput().GetNumberOfCells() == 0, "drawn from the file"

# With a hierarchy: as from a file without layers.
drawn = []
for layers in ("wave", ""):
    name = gm.temporary("drawn-tree%s.gtn" % layers)
    gm.write(grid, name, Layers=layers, ChunkSize=700, Hierarchy=True, Levels=2)
    reader = vtkGatunReader()
    reader.SetFileName(name)
    reader.SetSimplificationRatio(0.97)
    drawn.append(gv.draw(reader)[0])
gv.require_same(*drawn, tolerance=1 / 255)
assert gv.difference(drawn[0], expected[0]) > 2 / 255, "it is not simplified"
