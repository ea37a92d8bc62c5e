"""Opens a file of hexahedra and cuts it: the pipe, and a slice through its plane.

    python3 open_and_slice.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_pipe
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkProbeFilter

import gatun

folder = get_folder()
points, cells, heat = make_pipe()
pipe = gatun.from_numpy(points, {"hexahedron": cells}, point_data={"temperature": heat})
gatun.write(pipe, f"{folder}/pipe.gtn", overwrite=True)

mesh = gatun.read(f"{folder}/pipe.gtn")
print(f"{mesh.GetNumberOfCells()} cells, {mesh.GetNumberOfPoints()} points")

# Any filter of VTK takes the mesh. This one samples it in a plane.
width, height = 360, 324
xmin, xmax, ymin, ymax, _, _ = mesh.GetBounds()
plane = vtkImageData()
plane.SetDimensions(width, height, 1)
plane.SetOrigin(xmin, ymin, 0)
plane.SetSpacing((xmax - xmin) / (width - 1), (ymax - ymin) / (height - 1), 1)
probe = vtkProbeFilter()
probe.SetInputData(plane)
probe.SetSourceData(mesh)
probe.Update()
values = gatun.image_to_numpy(probe.GetOutput(), "temperature")[0, ::-1]
inside = gatun.image_to_numpy(probe.GetOutput(), "vtkValidPointMask")[0, ::-1] != 0

COLORS = np.array([(0, 0, 0.45), (1, 0.35, 0.16), (1, 1, 0)])
place = np.clip((values - heat.min()) / (heat.max() - heat.min()), 0, 1)
cut = np.ones((height, width, 4))
for channel in range(3):
    cut[inside, channel] = np.interp(place[inside], [0, 0.5, 1], COLORS[:, channel])
picture = gatun.render(
    f"{folder}/pipe.gtn",
    size=(width, height),
    colors=COLORS,
    opacity=[0.1, 0.3, 0.9],
    background="white",
    direction=(0.3, 0.4, -1),
    dtype=np.float32,
)
gatun.save_png(np.hstack([picture, cut]), f"{folder}/open_and_slice.png")
