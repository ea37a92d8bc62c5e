"""Reads the compressed mesh named on the command line and says how large it is."""

import sys

from gatun import vtkGatunReader

reader = vtkGatunReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "mesh.gtn")
reader.Update()
mesh = reader.GetOutput()
print(mesh.GetNumberOfPoints(), "points,", mesh.GetNumberOfCells(), "cells")
sys.exit(0 if mesh.GetNumberOfCells() > 0 else 1)
