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
from gatun.vtk import vtkGatunMeshReader, vtkGatunReader, vtkGatunSurfaceReader, vtkGatunWriter
from gatun.vtk.vtkGatunIO import vtkGatunReader as reader_of_module
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

assert vtkGatunReader is reader_of_module
assert issubclass(vtkGatunReader, vtkGatunMeshReader)
assert issubclass(vtkGatunSurfaceReader, vtkGatunMeshReader)
assert issubclass(vtkGatunMeshReader, vtkAlgorithm)
assert gatun.vtk.vtkGatunReader is vtkGatunReader
assert "vtkGatunWriter" in dir(gatun.vtk) and "vtk" in dir(gatun)
assert vtkGatunWriter().GetFileName() is None

try:
    gatun.vtk.vtkNoSuchClass
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
OTHER_VTK = f"ImportError: gatun.vtk has no classes for VTK {vtkVersion.GetVTKVersion()}, only for VTK 1.2.3"
PROGRAMS = [
    ("import gatun; gatun.Mesh; gatun.Error('text'); dir(gatun); gatun.read", None),
    ("import gatun; gatun.vtk.vtkGatunReader", OTHER_VTK),
    ("import gatun.vtk.vtkGatunIO", OTHER_VTK),
    (WITHOUT_VTK + "import gatun; dir(gatun); gatun.InputError; gatun.Mesh; gatun.read", None),
    (WITHOUT_VTK + "import gatun; gatun.vtk.vtkGatunReader", "ImportError: gatun.vtk needs VTK for Python"),
    (WITHOUT_VTK + "from gatun.vtk.vtkGatunIO import vtkGatunReader", "ImportError: gatun.vtk needs VTK"),
    (WITHOUT_VTK + "import gatun; gatun.from_numpy", "ImportError: gatun.from_numpy needs VTK for Python"),
]

with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(gatun.__path__[0], os.path.join(folder, "gatun"), ignore=shutil.ignore_patterns("vtk[0-9]*"))
    os.makedirs(os.path.join(folder, "gatun", "vtk", "vtk1.2.3"))
    for program, text in PROGRAMS:
        result = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True,
                                env={**os.environ, "PYTHONPATH": folder})
        assert result.returncode == (1 if text else 0) and (text or "") in result.stderr, (program, result.stderr)
