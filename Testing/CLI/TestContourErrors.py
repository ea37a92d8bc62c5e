# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What contour cannot do it says, and leaves no surface behind; what was there stays."""

import os
import signal
import subprocess
import time

import numpy as np

from gatunCli import PROGRAM, enter_folder, gtn, lattice, make_grid, skip, standard_mesh, write
from gatunSurfaces import read_surface

enter_folder("contour-errors")
write(standard_mesh(6), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")
FORMATS = ("vtp", "stl", "ply", "obj")


def fails(*arguments, code=1, says=None, mesh="mesh.gtn", out="new.vtp"):
    before = sorted(os.listdir("."))
    gtn("contour", *arguments, mesh, out, code=code, says=says)
    assert sorted(os.listdir(".")) == before, "something is left"


# The command line.
for value in ("nan", "inf", "1,nan", "x", "1e999", "2.5x"):
    fails(f"--value={value}", code=2, says="--value")
fails("--value=", code=2, says="gtn: ")  # CLI11 2.6 takes the next word
fails(code=2, says="give isovalues by --value or their number by --number")
fails("--value", 1, "--number", 2, code=2, says="--number")
for number in ("0", "-1", "1001", "5000000", "nan", "1.5", "many"):
    fails("--number", number, code=2, says="--number")
many = ",".join(str(i) for i in range(1001))
fails("--value", many, code=2, says="--value: 1,001 isovalues are too many; the maximum is 1,000")
for option, value in (("--ratio", 2), ("--points", -1), ("--rms-error", -1),
                      ("--precision", "half"), ("--component", -1), ("--component", "length")):
    fails("--value", 1, option, value, code=2, says=option)
fails("--value", 1, "--ratio", 0.5, "--points", 5, code=2, says="--points")
for out in ("new.vtu", "new.off", "new"):
    fails("--value", 1, code=2, says=f"{out}: the name must end in .gtn, .vtp, .vtk, .stl, .ply or .obj", out=out)
fails("--value", 1, "--normals", code=2, says="--normals: .stl files hold no normals", out="new.stl")
for name in ("stl", "ply", "obj"):
    fails("--value", 1, "--strips", code=2, says=f"--strips: .{name} files hold no", out="new." + name)
for name in ("stl", "ply"):
    fails("--value", 1, "--precision", "double", code=2, says=f"--precision: .{name} files are of",
          out="new." + name)

# The mesh.
for mesh in ("mesh.gtn", "mesh.vtu"):
    there = "has no array 'heat'; there are pressure, velocity, mark"
    fails("--value", 1, "--array", "heat", says=f"gtn: {mesh}: {there}", mesh=mesh)
    fails("--value", 1, "--arrays", "heat", says=f"gtn: {mesh}: {there}, material, quality", mesh=mesh)
    of_cells = "array 'material' is one of the cells; isosurfaces need one of the points"
    fails("--value", 1, "--array", "material", says=f"gtn: {mesh}: {of_cells}", mesh=mesh)
    fails("--value", 1, "--array", "velocity", "--component", 3, says="numbered 0 to 2", mesh=mesh)
    fails("--value", 1, "--time", 1, says=f"gtn: {mesh}: has no time steps", mesh=mesh)
    fails("--value", 1, "--step", 1, says=f"gtn: {mesh}: has no time steps", mesh=mesh)
for mesh in ("missing.gtn", "missing.vtu"):
    fails("--value", 1, says=f"gtn: {mesh}: no such file", mesh=mesh)
os.mkdir("folder.gtn")
fails("--value", 1, says="gtn: folder.gtn: is a folder", mesh="folder.gtn")
for name, content in (("empty.gtn", b""), ("text.gtn", b"no mesh at all\n"), ("mesh.json", b"{}")):
    with open(name, "wb") as file:
        file.write(content)
    fails("--value", 1, says=f"gtn: {name}: ", mesh=name)
points, tets = lattice(2)
for name, values, says in (
    ("without", {}, "has no array of the points; there are none"),
    ("nothing", {"a": np.full(len(points), np.nan)}, "array 'a' has no finite range of values"),
    ("infinite", {"a": np.full(len(points), np.inf)}, "array 'a' has no finite range of values"),
):
    write(make_grid(points, tets, values), name + ".vtu")
    gtn("pack", "-q", name + ".vtu", name + ".gtn")
    for mesh in (name + ".vtu", name + ".gtn"):
        fails("--number", 1, says=f"gtn: {mesh}: {says}", mesh=mesh)
fails("--value", 1, mesh="nothing.gtn", says="no surface at 1: array 'a' has no values")
write(make_grid(points, tets, {"a": np.full(len(points), 7.0)}), "constant.vtu")
fails("--value", 7, mesh="constant.vtu", says="no surface at 7: array 'a' has values from 7 to 7")
write(make_grid(points[:0], tets[:0], {"a": np.zeros(0)}), "none.vtu")
gtn("pack", "-q", "none.vtu", "none.gtn")
for mesh in ("none.vtu", "none.gtn"):
    for name in FORMATS:
        none = f"{mesh}: no surface at 7: array 'a' has no values"
        fails("--value", 7, mesh=mesh, out="new." + name, says=none)

# A damaged file, in whichever part of it.
noise = np.random.default_rng(1).random(len(points))
write(make_grid(points, tets, {"a": noise}), "noise.vtu")
gtn("pack", "-q", "noise.vtu", "noise.gtn")
with open("noise.gtn", "rb") as file:
    good = file.read()
told = set()
for place in range(40, len(good), 53):
    bad = bytearray(good)
    bad[place] ^= 0x55
    with open("damaged.gtn", "wb") as file:
        file.write(bad)
    before = sorted(os.listdir("."))
    run = subprocess.run([PROGRAM, "contour", "--number", "3", "damaged.gtn", "new.vtp"],
                         stderr=subprocess.PIPE, universal_newlines=True, check=False, timeout=60)
    if run.returncode:
        assert run.returncode == 1, run
        assert run.stderr.startswith("gtn: damaged.gtn: ") and run.stderr.count("\n") == 1, run.stderr
        assert run.stderr.count("damaged.gtn") == 1, run.stderr
        assert sorted(os.listdir(".")) == before
        told.add(run.stderr)
    else:
        os.remove("new.vtp")  # such as field data, which a surface does not need
assert len(told) > 3, told
with open("damaged.gtn", "wb") as file:
    file.write(good[:len(good) // 2])
fails("--number", 3, says="gtn: damaged.gtn: ", mesh="damaged.gtn")

# Where it is to go.
for name in FORMATS:
    with open("old." + name, "w") as file:
        file.write("old")
    fails("--value", 2, says=f"gtn: old.{name}: exists; use -f to overwrite it", out="old." + name)
    # Even so it must not be lost when there is none in its place.
    fails("-f", "--value", 2, "--array", "heat", says="heat", out="old." + name)
    with open("old." + name) as file:
        assert file.read() == "old"
    fails("--value", 2, says="there is no folder nowhere", out="nowhere/new." + name)
    fails("--value", 2, says=f"gtn: /proc/new.{name}: ", out="/proc/new." + name)
    gtn("contour", "-f", "-q", "--value", 2, "mesh.gtn", "old." + name)
    assert read_surface("old." + name).GetNumberOfPolys() > 0
    os.mkdir("folder." + name)
    fails("-f", "--value", 2, says="is a folder", out="folder." + name)

if os.geteuid() != 0:
    os.mkdir("locked")
    os.chmod("locked", 0o555)
    for name in FORMATS:
        fails("--value", 2, says=f"gtn: locked/new.{name}: ", out="locked/new." + name)

# Ctrl+C, at several moments.
write(standard_mesh(24), "large.vtu")
gtn("pack", "-q", "--chunk-size", 4000, "large.vtu", "large.gtn")
for name in FORMATS:
    for delay in (0.02, 0.3, 0.9):
        with open("kept." + name, "w") as file:
            file.write("old")
        before = sorted(os.listdir("."))
        process = subprocess.Popen([PROGRAM, "contour", "-f", "--number", "30", "large.gtn",
                                    "kept." + name], stdout=subprocess.DEVNULL)
        time.sleep(delay)
        process.send_signal(signal.SIGINT)
        code = process.wait(timeout=60)
        assert code in (0, -signal.SIGINT), code
        assert sorted(os.listdir(".")) == before
        if code:
            with open("kept." + name, "rb") as file:
                # The signal may come when the file has its name already; it is a whole one then.
                assert file.read() == b"old" or read_surface("kept." + name).GetNumberOfPolys()

# A full disk.
os.mkdir("small")
mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", "small"],
                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
if mounted.returncode:
    skip("a small file system cannot be mounted here")
try:
    for name in FORMATS:
        old = "small/old." + name
        with open(old, "w") as file:
            file.write("old")
        gtn("contour", "-f", "--number", 9, "large.gtn", old, code=1, says=f"gtn: {old}: no space left")
        assert os.listdir("small") == ["old." + name], os.listdir("small")
        with open(old) as file:
            assert file.read() == "old"
        os.remove(old)
    # Too large by a little only: what is in the buffers of a writer counts, too.
    for name in FORMATS:
        gtn("contour", "-q", "--value", 2, "mesh.gtn", "size." + name)
        pages = os.path.getsize("size." + name) // 4096
        with open("small/ballast", "wb") as file:
            file.write(bytes(65536 - pages * 4096))
        new = "small/new." + name
        gtn("contour", "--value", 2, "mesh.gtn", new, code=1, says=f"gtn: {new}: no space left")
        assert os.listdir("small") == ["ballast"], os.listdir("small")
finally:
    subprocess.run(["umount", "small"], check=True)
