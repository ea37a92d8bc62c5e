# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Where VTK's loops have one thread by default, as in Debian's ParaView, Gatun has more, and leaves the
backend of the process as it is: another thread may be within a loop of VTK."""

import os
import sys

from vtkmodules.vtkCommonCore import vtkSMPTools

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunWriter

if not os.path.exists("/proc/self/status"):
    sys.exit(gm.SKIPPED)
os.environ.pop("VTK_SMP_BACKEND_IN_USE", None)
os.environ["VTK_SMP_MAX_THREADS"] = "2"
assert vtkSMPTools.SetBackend("Sequential")
path = gm.temporary("threads.gtn")
points, tets = gm.lattice(24)
grid = gm.make_grid(points, tets)
gm.add_array(grid.GetPointData(), points[:, 0] * points[:, 1], "product")


def count_threads():
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("Threads:"))


seen, most = set(), 0


def look(*_):
    global most
    seen.add(vtkSMPTools.GetBackend())
    most = max(most, count_threads())


before = count_threads()
writer = vtkGatunWriter()
writer.SetInputData(grid)
writer.SetFileName(path)
writer.SetChunkSize(500)
writer.SetKeepOrder(7)
writer.AddObserver("ProgressEvent", look)
assert writer.Write() == 1
assert seen == {"Sequential"}, seen
assert most == before + (os.cpu_count() > 1), (before, most)

reader = vtkGatunReader()
reader.SetFileName(path)
reader.RestoreOrderOn()
reader.AddObserver("ProgressEvent", look)
reader.Update()
assert seen == {"Sequential"}, seen
gm.assert_equal(reader.GetOutput(), grid)

# What the user chose counts.
os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"
most = 0
writer.Modified()
assert writer.Write() == 1
assert most == before, (before, most)
