"""Isosurfaces straight from a file: only the chunks that they pass through are read.

    python3 contour.py [FOLDER]
"""

from shapes import get_folder, make_knot
from vtkmodules.vtkFiltersCore import vtkElevationFilter

import gatun

folder = get_folder()
points, tets, values = make_knot(36)
knot = gatun.from_numpy(points, tets, point_data={"value": values})
gatun.write(knot, f"{folder}/knot.gtn", layers="value", chunk_size=4096, overwrite=True)

reader = gatun.vtk.vtkGatunReader()
reader.SetFileName(f"{folder}/knot.gtn")
contour = gatun.vtk.vtkGatunContour()
contour.SetInputConnection(reader.GetOutputPort())
contour.SetInputArrayToProcess(0, 0, 0, 0, "value")
contour.SetValue(0, 0.5)
contour.ComputeNormalsOn()
contour.Update()
surface = contour.GetOutput()
print(f"{surface.GetNumberOfCells()} triangles")
statistics = contour.GetStatistics()
used, chunks = (statistics.GetColumnByName(name).GetValue(0) for name in ("UsedChunks", "Chunks"))
print(f"{used} of {chunks} chunks read")

# Colors show the height of the knot.
height = vtkElevationFilter()
height.SetInputData(surface)
height.SetLowPoint(0, 0, -0.4)
height.SetHighPoint(0, 0, 0.4)
height.Update()
picture = gatun.render(
    height.GetOutput(),
    size=(360, 300),
    colors=[(0.1, 0.2, 0.5), (0.2, 0.6, 0.8), (1, 0.8, 0.3), (0.9, 0.3, 0.1)],
    background="white",
    azimuth=10,
    elevation=10,
)
gatun.save_png(picture, f"{folder}/contour.png")
