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

# Programs that run in a Python without VTK, or without modules for its VTK, and the text of their error.
WITHOUT_VTK = """
import sys
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "vtkmodules":
            raise ModuleNotFoundError("No module named 'vtkmodules'", name="vtkmodules")
sys.meta_path.insert(0, Finder())
"""
PROGRAMS = [
    ("import gatun; gatun.Mesh; gatun.Error('text'); dir(gatun)", None),
    ("import gatun; gatun.vtkGatunReader", "ImportError: gatun has no modules for VTK"),
    ("import gatun.vtkGatunIO", "ImportError: gatun has no modules for VTK"),
    (WITHOUT_VTK + "import gatun; dir(gatun); gatun.InputError; gatun.Mesh", None),
    (WITHOUT_VTK + "import gatun; gatun.vtkGatunReader", "ImportError: the classes of gatun need VTK for Python"),
    (WITHOUT_VTK + "from gatun.vtkGatunIO import vtkGatunReader", "ImportError: the classes of gatun need VTK"),
    (WITHOUT_VTK + "import gatun; gatun.read", "ImportError: gatun.read needs VTK for Python"),
]

with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(gatun.__path__[0], os.path.join(folder, "gatun"), ignore=shutil.ignore_patterns("vtk[0-9]*"))
    for program, text in PROGRAMS:
        result = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": folder})
        assert result.returncode == (1 if text else 0) and (text or "") in result.stderr, (program, result.stderr)
