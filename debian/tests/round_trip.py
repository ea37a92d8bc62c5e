"""A mesh by TetGen with values comes back bit for bit, and is drawn. For Python's VTK, and for ParaView's."""

import numpy as np
from vtkmodules.vtkFiltersSources import vtkSphereSource

import gatun

sphere = vtkSphereSource()
mesher = gatun.vtk.vtkGatunTetrahedralize()
mesher.SetMaximumVolume(0.001)
mesher.SetInputConnection(sphere.GetOutputPort())
mesher.Update()
made = gatun.to_numpy(mesher.GetOutput())
values = {"height": made.points[:, 2] / 3}
mesh = gatun.from_numpy(made.points, made.cells_dict, point_data=values)
gatun.write(mesh, "mesh.gtn", keep_order="all", overwrite=True)

back = gatun.to_numpy(gatun.read("mesh.gtn"))
assert np.array_equal(back.points, made.points)
assert np.array_equal(back.cells_dict["tetra"], made.cells_dict["tetra"])
assert np.array_equal(back.point_data["height"], values["height"])
image = gatun.render("mesh.gtn", size=(320, 240))
assert image.shape == (240, 320, 4) and image.max() > image.min()
print("the same:", len(made.cells_dict["tetra"]), "tetrahedra, by", gatun.vtk.vtkGatunIO.__file__)
