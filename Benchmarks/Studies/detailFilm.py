# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The film of a flight into a mesh, from the pictures of "gatunBenchmarks detail-film"; needs PIL, which
matplotlib brings along."""

from PIL import Image, ImageDraw

COLUMNS = (("uniform", "everywhere alike"), ("view", "for the view"))
ROWS = ("", "-sizes")
CAPTION = 16  # pixels
COLORS = 48
MILLISECONDS = 125


def _join(folder, index):
    """One picture of the film: as it looks above, sizes of tetrahedra below."""
    parts = [[Image.open(folder / f"{name}{row}-{index:03}.png").convert("RGB")
              for name, _ in COLUMNS] for row in ROWS]
    width, height = parts[0][0].size
    picture = Image.new("RGB", (2 * width, 2 * height + CAPTION), "white")
    draw = ImageDraw.Draw(picture)
    for column, (_, text) in enumerate(COLUMNS):
        draw.text((column * width + 4, 2), text, fill="black")
        for row, line in enumerate(parts):
            picture.paste(line[column], (column * width, CAPTION + row * height))
    return picture


def make(folder, frames, target):
    """Writes the film: there and back."""
    pictures = [_join(folder, i) for i in range(frames)]
    # One palette for all, so that what stays does not flicker.
    sheet = Image.new("RGB", (pictures[0].width, pictures[0].height * len(pictures)))
    for i, picture in enumerate(pictures):
        sheet.paste(picture, (0, i * pictures[0].height))
    palette = sheet.quantize(COLORS)
    film = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    film += film[-2:0:-1]
    film[0].save(target, save_all=True, append_images=film[1:], duration=MILLISECONDS, loop=0,
                 optimize=True)
