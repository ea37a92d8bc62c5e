"""Reads a compressed mesh into NumPy arrays and prints some statistics:

    python3 MeshToNumPy.py mesh.gtn
"""

import sys

import numpy as np
from gatun.vtk import vtkGatunReader
from vtkmodules.util.numpy_support import vtk_to_numpy

reader = vtkGatunReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "mesh.gtn")
reader.Update()
if reader.GetErrorCode() != 0:
    sys.exit(1)  # the reader has printed why
mesh = reader.GetOutput()
points = vtk_to_numpy(mesh.GetPoints().GetData())
tets = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 4)
edges = points[tets[:, 1:]] - points[tets[:, :1]]
volumes = np.abs(np.linalg.det(edges.astype(float))) / 6
print(f"{len(points)} points, {len(tets)} tetrahedra, volume {volumes.sum():g}")
for index in range(mesh.GetPointData().GetNumberOfArrays()):
    array = mesh.GetPointData().GetArray(index)
    values = vtk_to_numpy(array)
    print(f"{array.GetName()}: {values.min():g} to {values.max():g}, mean {values.mean():g}")
