# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A merge of blocks that runs out of memory, wherever that may be, says so by an error code and a
message, leaves an empty output, and succeeds once there is memory again. Nothing is thrown. A VTK with
assertions may end the process in its own filter."""

import os
import resource
import signal
import sys
import traceback

# No threads: they would need memory that nobody can do without.
os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunMeshes as gm
from gatun.vtk import vtkGatunMergeBlocks

BLOCKS = 3
MERGED, REFUSED = 0, 3
OUT_OF_MEMORY = {REFUSED, -signal.SIGABRT} if gm.vtk_aborts() else {REFUSED}


def make_blocks():
    """Blocks of which each has an array that the others lack."""
    blocks = vtkMultiBlockDataSet()
    points, tets = gm.lattice(16)
    for i in range(BLOCKS):
        grid = gm.make_grid(points, tets)
        gm.add_array(grid.GetPointData(), np.arange(len(points)), "point %d" % i)
        gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell %d" % i)
        blocks.SetBlock(i, grid)
    return blocks, BLOCKS * len(tets)


def merge_within(size, coincident):
    """With so many bytes of address space beyond what is in use."""
    blocks, count = make_blocks()
    merge = vtkGatunMergeBlocks()
    merge.SetInputDataObject(blocks)
    merge.SetMergeCoincidentPoints(coincident)
    merge.UpdateInformation()
    errors = gm.Errors(merge)
    merge.AddObserver("WarningEvent", lambda *_: None)  # about arrays that are filled up
    with open("/proc/self/statm") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    old = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + size, old[1]))
    merge.Update()
    resource.setrlimit(resource.RLIMIT_AS, old)
    output = merge.GetOutput()
    if merge.GetErrorCode() == vtkErrorCode.NoError:
        assert output.GetNumberOfCells() == count and not errors.messages, str(errors)
        return MERGED
    assert merge.GetErrorCode() == vtkErrorCode.UnknownError, merge.GetErrorCode()
    assert len(errors.messages) == 1 and "not enough memory" in str(errors), str(errors)
    assert output.GetNumberOfPoints() == 0 and output.GetNumberOfCells() == 0
    assert output.GetFieldData().GetNumberOfArrays() == 0
    merge.Modified()
    merge.Update()
    assert merge.GetErrorCode() == vtkErrorCode.NoError
    assert merge.GetOutput().GetNumberOfCells() == count
    return REFUSED


def in_child(*arguments):
    """Exit code of merge_within() in a process of its own; negative: it was killed by a signal."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            code = merge_within(*arguments)
        except BaseException:
            traceback.print_exc()
        os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


if not os.path.exists("/proc/self/statm"):
    sys.exit(gm.SKIPPED)
for coincident in (False, True):
    size, codes = 0, [REFUSED]
    while codes[-1] in OUT_OF_MEMORY and size < 1 << 28:
        codes.append(in_child(size, coincident))
        size += 200 << 10
    assert codes[-1] == MERGED and len(codes) > 20 and codes[1] == REFUSED, (coincident, size, codes)
    print(len(codes) - 2, "times out of memory")
