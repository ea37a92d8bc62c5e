#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the pictures of Documentation/guide/gallery.md by the commands of that page. Utilities/guide.sh calls it.

    gallery.py [FOLDER]      default: Documentation/images/guide

GATUN_TEST_GTN in the environment names the gtn program. Needs pngquant."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import pictures

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Python"))
import gatunGuide  # pylint: disable=wrong-import-position

SIZE = "40"  # of the samples: a million tetrahedra


def main():
    out = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "Documentation" / "images" / "guide"
    out.mkdir(parents=True, exist_ok=True)
    page = gatunGuide.GUIDE / "gallery.md"
    with tempfile.TemporaryDirectory(prefix="gatun-guide-") as work:
        subprocess.run([sys.executable, str(ROOT / gatunGuide.SAMPLES), work, SIZE], check=True)
        (pathlib.Path(work) / "bin").mkdir()
        os.symlink(os.environ["GATUN_TEST_GTN"], os.path.join(work, "bin", "gtn"))
        environment = dict(os.environ, PATH=f"{work}/bin:{os.environ['PATH']}")
        for block in gatunGuide.blocks_of(page):
            if gatunGuide.run_shell(block, work, environment, None) is None:
                raise SystemExit(1)
        for picture in sorted(pathlib.Path(work).glob("*.png")):
            target = out / f"gallery-{picture.name}"
            shutil.copyfile(picture, target)
            pictures.reduce_colors(target, 256)
            print(target, target.stat().st_size)


if __name__ == "__main__":
    main()
