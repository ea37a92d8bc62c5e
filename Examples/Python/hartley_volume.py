"""A regular volume as Hartley coefficients, drawn straight from them at three sizes.

    python3 hartley_volume.py [FOLDER]
"""

import numpy as np
from shapes import get_folder, make_volume

import gatun

folder = get_folder()
values = make_volume()
volume = gatun.image_from_numpy(values, spacing=(0.5, 0.5, 0.5), name="density")

pictures = []
print("bits per voxel   bytes   RMS error of the values")
for bits in (1, 0.1, 0.02):
    size = gatun.write(volume, f"{folder}/body.ghv", bits_per_voxel=bits, overwrite=True)
    back = gatun.image_to_numpy(gatun.read(f"{folder}/body.ghv"))
    error = np.sqrt(((back - values.astype(float)) ** 2).mean())
    print(f"{bits:14} {size:7} {error:8.2f}")
    pictures.append(
        gatun.render(
            f"{folder}/body.ghv",
            size=(240, 280),
            colors=[(0.5, 0.2, 0.1), (0.9, 0.6, 0.5), (1, 0.95, 0.8)],
            opacity=[(60, 0), (120, 0.02), (350, 0.08), (800, 0.9)],
            background="#101018",
            zoom=1.3,
        )
    )
gatun.save_png(np.hstack(pictures), f"{folder}/hartley_volume.png")
