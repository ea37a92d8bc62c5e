# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The libraries that gtn loads on demand are those of its own installation, not what the environment names.
Usage: TestLibraries.py FAKE [without]: a library whose loading ends the program; without TetGen.
"""

import os
import shutil
import sys

from gatunCli import enter_folder, gtn

enter_folder("libraries")
os.mkdir("fake")
for name in ("TetGen", "Formats", "Images"):
    shutil.copy(sys.argv[1], f"fake/libgtn{name}.so")
environment = {**os.environ, "LD_LIBRARY_PATH": os.path.abspath("fake")}
with open("cube.obj", "w") as file:
    for i in range(8):
        file.write("v %g %g %g\n" % (i & 1, i >> 1 & 1, i >> 2))
    for quad in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"):
        file.write(f"f {quad}\n")
for name in ("mesh.exo", "slice.tif"):
    with open(name, "wb") as file:
        file.write(b"not what it is called" * 100)

if "without" not in sys.argv:
    gtn("mesh", "cube.obj", "cube.gtn", says="tetrahedra", env=environment)
gtn("pack", "mesh.exo", "mesh.gtn", code=1, says="mesh.exo", env=environment)
gtn("volume", "pack", "slice.tif", "slice.ghv", code=1, says="slice.tif", env=environment)
