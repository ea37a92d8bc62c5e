"""Volume rendering of a mesh, without a display: color, maximum intensity, X-ray and shading.

    python3 render_volume.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_knot

import gatun

folder = get_folder()
points, tets, values = make_knot()
gatun.write(gatun.from_numpy(points, tets, point_data={"value": values}), f"{folder}/knot.gtn", overwrite=True)

glow = [(0.1, 0, 0.2), (0.6, 0.1, 0.4), (1, 0.5, 0.1), (1, 1, 0.8)]
common = {"size": (180, 150), "background": "#101018", "zoom": 1.4, "azimuth": 10, "elevation": 10}
pictures = [
    gatun.render(f"{folder}/knot.gtn", colors=glow, opacity=[0, 0.02, 0.1, 0.6], **common),
    gatun.render(f"{folder}/knot.gtn", colors=glow, opacity=[0, 1], blend="mip", **common),
    gatun.render(
        f"{folder}/knot.gtn",
        colors=[(1, 1, 1), (1, 1, 1)],
        opacity=[0, 0.05],
        blend="xray",
        **common,
    ),
    gatun.render(
        f"{folder}/knot.gtn",
        colors=[(0.2, 0.5, 0.9), (0.9, 0.9, 0.95)],
        opacity=[(0.3, 0), (0.35, 0.9), (1, 1)],
        shade=True,
        **common,
    ),
]
rows = [np.hstack(pictures[:2]), np.hstack(pictures[2:])]
gatun.save_png(np.vstack(rows), f"{folder}/render_volume.png")
