# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The demo packs a part and a mesh of the user, verifies them, and draws sheets on which no panel is empty."""

import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np

from gatunCli import PROGRAM, enter_folder, skip
from gatunPictures import read_png

DEMO = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "demo.sh"
COLUMNS, ROWS = 3, 3
GAP, TITLE, WIDTH, HEIGHT, CAPTION = 14, 70, 700, 500, 78  # of the sheet, in pixels


def check_sheet(file):
    pixels = read_png(file)[::-1].astype(int)
    assert pixels.shape[:2] == (TITLE + ROWS * (HEIGHT + CAPTION + GAP), GAP + COLUMNS * (WIDTH + GAP)), pixels.shape
    for row in range(ROWS):
        for column in range(COLUMNS):
            top, left = TITLE + row * (HEIGHT + CAPTION + GAP), GAP + column * (WIDTH + GAP)
            # The background is gray, and so is a mesh without the colors of its array. On the right there is a scale.
            panel = pixels[top:top + HEIGHT, left:left + WIDTH * 3 // 4]
            assert (np.ptp(panel, axis=2) > 40).mean() > 0.005, (file, row, column)
            caption = pixels[top + HEIGHT:top + HEIGHT + CAPTION, left:left + WIDTH]
            assert (caption.min(axis=2) < 128).any(), (file, row, column)


def run_demo(output, *file):
    run = subprocess.run([DEMO, "--size", "small", "--output", output, *file], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, check=False, timeout=600,
                         env=dict(os.environ, GATUN_BUILD=str(pathlib.Path(PROGRAM).parents[1]),
                                  GATUN_PYTHON=sys.executable))
    print(run.stdout)
    assert run.returncode == 0 and "identical to" in run.stdout
    sheet = os.path.abspath(os.path.join(output, "sheet.png"))
    assert run.stdout.rstrip().endswith(sheet)
    check_sheet(sheet)


if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
    skip("there is no display, nor xvfb-run")
enter_folder("demo")
run_demo("part")
shutil.copy("part/part.vtu", "a mesh.vtu")
run_demo("mesh", "a mesh.vtu")
