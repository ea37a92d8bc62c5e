"""One file, any number of points: images of simplified meshes beside that of the whole one.

    python3 simplify_and_compare.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_knot

import gatun

folder = get_folder()
points, tets, values = make_knot()
knot = gatun.from_numpy(points, tets, point_data={"value": values})
gatun.write(knot, f"{folder}/detail.gtn", hierarchy=True, overwrite=True)

pictures = []
print("removed   points    cells   RMS of the image (of 255)")
for ratio in (0, 0.9, 0.99, 0.995):
    mesh = gatun.read(f"{folder}/detail.gtn", ratio=ratio)
    picture = gatun.render(
        f"{folder}/detail.gtn",
        ratio=ratio,
        size=(160, 140),
        colors=[(0.2, 0.1, 0.4), (0.1, 0.5, 0.6), (0.5, 0.9, 0.3), (1, 1, 0.6)],
        opacity=[0, 0.05, 0.4],
        background="white",
        zoom=1.4,
        azimuth=10,
        elevation=10,
    )
    pictures.append(picture)
    error = np.sqrt(((picture - pictures[0].astype(float)) ** 2).mean())
    print(
        f"{ratio:7.1%} {mesh.GetNumberOfPoints():8} {mesh.GetNumberOfCells():8} {error:8.2f}"
    )
gatun.save_png(np.hstack(pictures), f"{folder}/simplify_and_compare.png")
