# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Classes can be had from the package and from its modules, and are the same."""

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
