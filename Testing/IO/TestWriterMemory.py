# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Whatever runs out of memory, the writer or the pipeline before it: Write returns 0 with a message
that says so, and the old file stays. A VTK with assertions may end the process in its own filter."""

import os
import resource
import signal
import subprocess
import sys

if "filter" in sys.argv:  # VTK's filter would use TBB, which never ends without memory for its threads
    os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"

from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkFiltersCore import vtkAppendFilter

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "writer-memory")
path = os.path.join(folder, "mesh.gtn")


def write_within(mebibytes, with_filter):
    """With so much address space beyond what is in use, in a process of its own."""
    points, tets = gm.lattice(20)
    grid = gm.make_grid(points, tets)
    writer = vtkGatunWriter()
    writer.SetFileName(path)
    append = vtkAppendFilter()
    if with_filter:
        append.AddInputDataObject(grid)
        append.AddInputDataObject(grid)
        writer.SetInputConnection(append.GetOutputPort())
    else:
        writer.SetInputDataObject(grid)
    errors = gm.Errors(writer)
    gm.Errors(append)
    with open("/proc/self/statm") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    old = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + int(mebibytes * 2**20), old[1]))
    written = writer.Write()
    resource.setrlimit(resource.RLIMIT_AS, old)
    if written:
        return 0
    assert writer.GetErrorCode() == vtkErrorCode.UnknownError, writer.GetErrorCode()
    assert len(errors.messages) == 1 and path in str(errors), str(errors)
    reasons = ("not enough memory", "Resource temporarily unavailable", "could not be updated")
    assert any(reason in str(errors) for reason in reasons), str(errors)
    # The next one has memory, and works.
    writer.SetInputDataObject(grid)
    assert writer.Write() == 1 and writer.GetErrorCode() == 0
    return 3


if len(sys.argv) > 1:
    sys.exit(write_within(float(sys.argv[1]), sys.argv[2] == "filter"))

if not os.path.exists("/proc/self/statm"):
    sys.exit(gm.SKIPPED)
os.makedirs(folder, exist_ok=True)
for source in ("grid", "filter"):
    expected = {0, 3, -signal.SIGABRT} if source == "filter" and gm.vtk_aborts() else {0, 3}
    codes = []
    for mebibytes in (0.5, 2, 4, 9, 16, 24, 2000):
        run = subprocess.run([sys.executable, __file__, str(mebibytes), source], check=False)
        assert run.returncode in expected, (source, mebibytes, run.returncode)
        codes.append(run.returncode)
        assert os.listdir(folder) == ["mesh.gtn"], os.listdir(folder)
    assert codes[0] in expected - {0} and 3 in codes and codes[-1] == 0, (source, codes)
