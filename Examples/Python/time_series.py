"""A file with time steps, from an iterable of meshes: pulses that run along a knot.

    python3 time_series.py [FOLDER]
"""

import os

import numpy as np
from shapes import find_knot, get_folder, make_cube

import gatun

folder = get_folder()
points, tets = make_cube(24)
distance, place = find_knot(points)
times = np.linspace(0, 2 * np.pi, 9, endpoint=False)


def make_step(time):
    """The mesh at a time. It shares points and cells with those of other times."""
    value = np.exp(-40 * distance**2) * (1.2 + np.cos(3 * place - time)) / 2.2
    return gatun.from_numpy(points, tets, point_data={"value": value.astype(np.float32)})


gatun.write(map(make_step, times), f"{folder}/pulses.gtn", times=times, overwrite=True)
single = gatun.write(make_step(0), f"{folder}/pulse.gtn", overwrite=True)
size = os.path.getsize(f"{folder}/pulses.gtn")
print(f"{len(gatun.steps(f'{folder}/pulses.gtn'))} steps in {size} bytes; one by one {9 * single}")

pictures = [
    gatun.render(
        f"{folder}/pulses.gtn",
        step=step,
        size=(200, 180),
        colors=[(0.1, 0, 0.3), (0.2, 0.3, 0.9), (0.3, 0.9, 0.9), (1, 1, 1)],
        opacity=[0, 0.05, 0.6],
        background="#0c0c14",
        zoom=1.4,
        azimuth=10,
        elevation=10,
    )
    for step in (0, 3, 6)
]
gatun.save_png(np.hstack(pictures), f"{folder}/time_series.png")
