# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Small files for pictures of the guide."""

import subprocess


def reduce_colors(path, colors=128):
    """Replaces a PNG file by one with a palette."""
    subprocess.run(["pngquant", "--force", "--speed", "1", "--strip", "--output", str(path), str(colors),
                    str(path)], check=True)
