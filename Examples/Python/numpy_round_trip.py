"""NumPy arrays of many types into a file and back, bit for bit.

    python3 numpy_round_trip.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_pipe

import gatun

folder = get_folder()
points, cells, heat = make_pipe(16, 4, 20)
rng = np.random.default_rng(7)
point_data = {
    "temperature": heat,
    "velocity": rng.standard_normal((len(points), 3)).astype(np.float32),
    "measured": np.where(heat > 100, np.nan, heat),
}
cell_data = {
    "material": rng.integers(0, 5, len(cells), dtype=np.uint8),
    "number": np.arange(len(cells), dtype=np.int64) * 1000003,
}
mesh = gatun.from_numpy(points, {"hexahedron": cells}, point_data=point_data, cell_data=cell_data)
gatun.write(mesh, f"{folder}/arrays.gtn", keep_order="all", overwrite=True)

back = gatun.to_numpy(gatun.read(f"{folder}/arrays.gtn"))
arrays = {"points": (points, back.points), "cells": (cells, back.cells_dict["hexahedron"])}
arrays.update((name, (values, back.point_data[name])) for name, values in point_data.items())
arrays.update((name, (values, back.cell_data[name][0])) for name, values in cell_data.items())
for name, (given, read) in arrays.items():
    assert read.dtype == given.dtype and read.shape == given.shape and read.tobytes() == given.tobytes()
    print(f"{name:12} {given.dtype!s:8} {'x'.join(map(str, given.shape)):>8}  equal")
