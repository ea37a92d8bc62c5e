# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The package gatun works in ParaView's Python, without the plugin and with it."""

import gatunSample as sample
import numpy as np

import gatun

assert "/Gatun.so" not in open("/proc/self/maps", encoding="ascii").read()
points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], dtype=float)
tets = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
values = points.sum(axis=1) / 3
path = sample.temporary("python-package.gtn")
gatun.write(gatun.from_numpy(points, {"tetra": tets}, point_data={"sum": values}), path, keep_order="all", overwrite=True)
back = gatun.to_numpy(gatun.read(path))
assert np.array_equal(back.points, points) and np.array_equal(back.cells_dict["tetra"], tets)
assert back.point_data["sum"].tobytes() == values.tobytes()
image = gatun.render(path, size=(64, 48))
assert image.shape == (48, 64, 4) and image.max() > image.min()

# The plugin and the package have the same classes, where Python knows them before it meets an object.
from gatun.vtk import vtkGatunContour  # pylint: disable=wrong-import-position
from gatunParaView import load_plugin  # pylint: disable=wrong-import-position

simple = load_plugin()
reader = simple.GatunReader(FileNames=[path])
reader.UpdatePipeline()
contour = simple.GatunContour(Input=reader)
assert isinstance(contour.SMProxy.GetClientSideObject(), vtkGatunContour)
assert reader.GetDataInformation().GetNumberOfCells() == len(tets)
