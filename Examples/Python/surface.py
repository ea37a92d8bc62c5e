"""A surface from its file, whole and with 5 % of its points. OpenGL draws it: this needs a display.

    python3 surface.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_shell

import gatun

folder = get_folder()
points, triangles, height = make_shell()
shell = gatun.from_numpy(
    points, {"triangle": triangles}, point_data={"height": height}, surface=True
)
size = gatun.write(shell, f"{folder}/shell.gtn", hierarchy=True, overwrite=True)
print(f"{len(triangles)} triangles in {size} bytes")

pictures = [
    gatun.render(
        f"{folder}/shell.gtn",
        ratio=ratio,
        size=(210, 200),
        colors=[(0.15, 0.25, 0.35), (0.3, 0.55, 0.5), (0.95, 0.9, 0.75)],
        background="white",
    )
    for ratio in (0, 0.95)
]
gatun.save_png(np.hstack(pictures), f"{folder}/surface.png")
