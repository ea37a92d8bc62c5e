# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Classes can be had from the package and from its modules, and are the same. A package without modules for the VTK
of this Python is refused."""

import os
import shutil
import subprocess
import sys
import tempfile

import gatun
from gatun import vtkGatunMeshReader, vtkGatunReader, vtkGatunSurfaceReader, vtkGatunWriter
from gatun.vtkGatunIO import vtkGatunReader as reader_of_module
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

assert vtkGatunReader is reader_of_module
assert issubclass(vtkGatunReader, vtkGatunMeshReader)
assert issubclass(vtkGatunSurfaceReader, vtkGatunMeshReader)
assert issubclass(vtkGatunMeshReader, vtkAlgorithm)
assert "vtkGatunWriter" in dir(gatun)
assert vtkGatunWriter().GetFileName() is None

try:
    gatun.vtkNoSuchClass
except AttributeError as error:
    assert "vtkNoSuchClass" in str(error)
else:
    raise AssertionError("a class that does not exist was found")

with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(gatun.__path__[0], os.path.join(folder, "gatun"), ignore=shutil.ignore_patterns("vtk[0-9]*"))
    result = subprocess.run([sys.executable, "-c", "import gatun"], check=False, capture_output=True, text=True,
                            env={**os.environ, "PYTHONPATH": folder})
    assert result.returncode == 1 and "ImportError: gatun has no modules for VTK" in result.stderr, result.stderr
