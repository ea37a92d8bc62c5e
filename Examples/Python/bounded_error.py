"""Sizes of files whose values may have an error, which is never exceeded.

    python3 bounded_error.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_knot

import gatun

folder = get_folder()
points, tets, values = make_knot()
rng = np.random.default_rng(1)
values = (values + 0.001 * rng.standard_normal(len(values))).astype(np.float32)
knot = gatun.from_numpy(points, tets, point_data={"value": values})
span = float(values.max() - values.min())

print("bound      file in bytes   largest error / range")
for bound in (None, "rel:1e-5", "rel:1e-4", "rel:1e-3", "rel:1e-2"):
    size = gatun.write(knot, f"{folder}/bounded.gtn", tolerances=bound, keep_order="points", overwrite=True)
    back = gatun.to_numpy(gatun.read(f"{folder}/bounded.gtn")).point_data["value"]
    error = np.abs(back.astype(float) - values).max() / span
    print(f"{bound or 'lossless':10} {size:13} {error:15.2e}")
    assert error <= (float(bound[4:]) if bound else 0)
