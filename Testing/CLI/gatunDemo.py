# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the demo, and looks at its sheet of pictures."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np

from gatunCli import PROGRAM, enter_folder, skip
from gatunPictures import read_png

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(ROOT, "Utilities", "demo"))
import sheet  # noqa: E402

PANELS = ["Compression without loss", "The mesh", "Read piece by piece",
          "Volume, straight from the file", "Isosurfaces, straight from the file",
          "Simplified, cut open", "Its surface as a file", "Values with a bounded error",
          "A volume by Hartley projection"]


def check_panel(panel, heading):
    """What a panel shows is large. The background is the same all along each line; on the right
    there may be a scale of colors."""
    panel = panel[:, : 3 * sheet.WIDTH // 4].astype(int)
    shown = np.abs(panel - panel[:, :1]).max(axis=2) > 8
    rows, columns = (np.flatnonzero(shown.any(axis=axis)) for axis in (1, 0))
    assert len(rows), f"{heading}: there is nothing"
    filled = [np.ptp(places) / size for places, size in zip((rows, columns), shown.shape)]
    # Thin meshes cover a twentieth.
    assert shown.mean() > 0.03 and max(filled) > 0.8, (heading, shown.mean(), filled)


def check_caption(caption, heading):
    """Two lines that can be read: as high as letters are, and not cut off on the right."""
    ink = caption.min(axis=2) < 128
    for line, least in ((ink[:37], 14), (ink[37:], 12)):
        rows, columns = (np.flatnonzero(line.any(axis=axis)) for axis in (1, 0))
        assert len(rows) and np.ptp(rows) + 1 >= least, (heading, rows)
        assert columns[-1] < sheet.WIDTH - 2, heading


def check_sheet(file, headings):
    pixels = read_png(file)[::-1]
    height, width = sheet.HEIGHT + sheet.CAPTION + sheet.GAP, sheet.WIDTH + sheet.GAP
    for i, heading in enumerate(headings):
        top = sheet.TITLE + i // sheet.COLUMNS * height
        left = sheet.GAP + i % sheet.COLUMNS * width
        panel = pixels[top : top + sheet.HEIGHT + sheet.CAPTION, left : left + sheet.WIDTH]
        check_panel(panel[: sheet.HEIGHT], heading)
        check_caption(panel[sheet.HEIGHT :], heading)
    rows = -(-len(headings) // sheet.COLUMNS)
    assert pixels.shape[0] == sheet.TITLE + rows * height, "there are other panels"


def run_demo(name, files):
    """Runs the demo on files, or on a small part of its own making for None."""
    if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
        skip("there is no display, nor xvfb-run")
    enter_folder(name)
    environment = dict(os.environ)
    environment["GATUN_BUILD"] = os.path.dirname(os.path.dirname(PROGRAM))
    environment["GATUN_PYTHON"] = sys.executable
    for file in files:
        output = os.path.basename(file or "part")
        command = [os.path.join(ROOT, "Utilities", "demo.sh"), "--size", "small", "--output", output]
        run = subprocess.run(
            command + ([file] if file else []),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            universal_newlines=True,
            check=False,
            env=environment,
            timeout=600,
        )
        print(run.stdout)
        assert run.returncode == 0, output
        assert "identical to" in run.stdout
        picture = os.path.join(os.path.abspath(output), "sheet.png")
        assert run.stdout.rstrip().endswith(picture)
        # The table in the end; its first row has no picture.
        told = re.findall(r"^  (\S.*?)  +\S", run.stdout, re.MULTILINE)
        headings = told[told.index("Packed and read") + 1 :]
        # Meshes need not have an array of their points that is not the same everywhere.
        assert headings == (PANELS if file is None else [p for p in PANELS if p in headings])
        check_sheet(picture, headings)
