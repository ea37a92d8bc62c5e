# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A full disk, or Ctrl+C, leaves no half file behind, and the old one as it was."""

import os
import signal
import subprocess
import time

from gatunCli import PROGRAM, enter_folder, gtn, skip, standard_mesh, write

enter_folder("disk")
write(standard_mesh(24), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")

# Ctrl+C, at several moments.
for delay in (0.02, 0.1, 0.2):
    process = subprocess.Popen([PROGRAM, "pack", "-f", "mesh.vtu", "new.gtn"])
    time.sleep(delay)
    process.send_signal(signal.SIGINT)
    code = process.wait(timeout=60)
    assert code in (0, -signal.SIGINT), code
    left = [name for name in os.listdir(".") if name not in ("mesh.vtu", "mesh.gtn")]
    # The signal may come when the file has its name already; it is a whole one then.
    assert left == ["new.gtn"] or (code and not left), (code, left)
    if left:
        gtn("verify", "-q", "new.gtn", "mesh.vtu")
        os.remove("new.gtn")

os.mkdir("small")
mounted = subprocess.run(
    ["mount", "-t", "tmpfs", "-o", "size=64k", "none", "small"],
    stdout=subprocess.DEVNULL,
    stderr=subprocess.DEVNULL,
    check=False,
)
if mounted.returncode:
    skip("a small file system cannot be mounted here")
try:
    with open("small/old.gtn", "w") as file:
        file.write("old")
    gtn("pack", "-f", "mesh.vtu", "small/old.gtn", code=1, says="gtn: small/old.gtn: ")
    gtn("unpack", "mesh.gtn", "small/new.vtu", code=1, says="gtn: small/new.vtu: ")
    gtn("unpack", "mesh.gtn", "small/new.vtk", code=1, says="gtn: small/new.vtk: ")
    gtn("render", "--size", "900x900", "--shade", "mesh.gtn", "small/new.png", code=1,
        says="gtn: small/new.png: no space left on the disk")
    assert os.listdir("small") == ["old.gtn"], os.listdir("small")
    with open("small/old.gtn") as file:
        assert file.read() == "old"
finally:
    subprocess.run(["umount", "small"], check=True)
