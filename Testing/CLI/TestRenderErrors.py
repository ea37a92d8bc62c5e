# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What render cannot do it says, and leaves no picture behind; cameras from files are checked in all
they hold."""

import json
import os
import subprocess

import numpy as np

from gatunCli import PROGRAM, enter_folder, gtn, lattice, make_grid, standard_mesh, write
from gatunPictures import read_png

enter_folder("render-errors")
write(standard_mesh(4), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")
SMALL = ("render", "--size", "40x30")


def fails(*arguments, code=1, says=None, mesh="mesh.gtn", out="new.png"):
    before = sorted(os.listdir("."))
    size = () if "--size" in arguments else SMALL[1:]
    gtn("render", *size, *arguments, mesh, out, code=code, says=says)
    assert sorted(os.listdir(".")) == before, "something is left"


# The command line.
for size in ("0x5", "5x0", "40000x1", "-4x4", "4", "4x", "4x4x4", "axb", "4.5x4"):
    fails("--size", size, code=2, says=f"--size: '{size}' is not WxH with 1 to 32000 pixels")
for option, value in (
    ("--unit-distance", "0"), ("--unit-distance", "inf"), ("--opacity", "-1"), ("--zoom", "0"),
    ("--azimuth", "nan"), ("--elevation", "181"), ("--roll", "1e9"),
    ("--mode", "surface"), ("--component", "-1"),
    ("--component", "length"), ("--range", "1"), ("--range", "2,1"), ("--range", "nan,1"),
    ("--range", "1,1"), ("--background", "green"), ("--background", "#12345g"),
):
    fails(option, value, code=2, says=option)
fails(code=2, says="new.jpg: the name must end in .png or .exr", out="new.jpg")

# The mesh.
for mesh in ("mesh.gtn", "mesh.vtu"):
    there = "has no array 'heat'; there are pressure, velocity, mark, material, quality"
    fails("--array", "heat", says=f"gtn: {mesh}: {there}", mesh=mesh)
    fails("--array", "velocity", "--component", 3, says="numbered 0 to 2", mesh=mesh)
    fails("--time", 1, says="has no time steps", mesh=mesh)
fails(says="gtn: missing.gtn: no such file", mesh="missing.gtn")
with open("mesh.json", "w") as file:
    file.write("{}")
fails(says="no reader for this extension", mesh="mesh.json")
points, tets = lattice(2)
for name, values, says in (
    ("without", {}, "has no array to draw; there are none"),
    ("nothing", {"a": np.full(len(points), np.nan)}, "array 'a' has no finite range of values"),
    ("infinite", {"a": np.full(len(points), np.inf)}, "array 'a' has no finite range of values"),
):
    write(make_grid(points, tets, values), name + ".vtu")
    gtn("pack", "-q", name + ".vtu", name + ".gtn")
    fails(says=says, mesh=name + ".vtu")
    fails(says=says, mesh=name + ".gtn")
write(make_grid(points, tets, {"a": np.full(len(points), 7.0)}), "constant.vtu")
gtn(*SMALL, "constant.vtu", "constant.png", says="constant.png: 40 x 30, 'a' of 48 tetrahedra")
assert read_png("constant.png")[:, :, 3].max() > 10
write(make_grid(points[:0], tets[:0], {"a": np.zeros(0)}), "empty.vtu")
fails(says="gtn: empty.vtu: has no cells", mesh="empty.vtu")

# A damaged file: in the values that are drawn, or in the mesh.
write(make_grid(points, tets, {"a": np.random.default_rng(1).random(len(points))}), "noise.vtu")
gtn("pack", "-q", "noise.vtu", "noise.gtn")
with open("noise.gtn", "rb") as file:
    good = file.read()
middle = len(good) // 2
with open("damaged.gtn", "wb") as file:
    file.write(good[:middle] + bytes(255 - byte for byte in good[middle : middle + 8]) + good[middle + 8 :])
fails(says="gtn: damaged.gtn: ", mesh="damaged.gtn")
with open("cut.gtn", "wb") as file:
    file.write(good[:middle])
fails(says="gtn: cut.gtn: ", mesh="cut.gtn")

# In many places of a file of many chunks: the right picture, or none and a message.
write(standard_mesh(6), "many.vtu")
gtn("pack", "-q", "--chunk-size", 100, "many.vtu", "many.gtn")
gtn(*SMALL, "-q", "many.gtn", "many.png")
right = read_png("many.png")
with open("many.gtn", "rb") as file:
    good = file.read()
found = 0
for number in range(30):
    random = np.random.default_rng(number)
    at = int(random.integers(len(good)))
    content = bytearray(good)
    if number % 3 == 0:
        content[at] ^= 1 << int(random.integers(8))
    elif number % 3 == 1:
        content[at : at + 16] = random.bytes(len(content[at : at + 16]))
    else:
        del content[at:]
    with open("hurt.gtn", "wb") as file:
        file.write(content)
    run = subprocess.run(
        [PROGRAM, *SMALL, "-q", "-f", "hurt.gtn", "hurt.png"], stderr=subprocess.PIPE, timeout=60,
        check=False, universal_newlines=True)
    if run.returncode == 0:
        assert not run.stderr and np.abs(read_png("hurt.png") - right).max() <= 1, number
        os.remove("hurt.png")
    else:
        found += 1
        assert run.returncode == 1 and run.stderr.startswith("gtn: hurt.gtn: "), run
        assert not os.path.exists("hurt.png"), number
assert 10 < found < 30, found

# An old picture stays, unless -f is given and the new one is complete.
gtn(*SMALL, "-q", "mesh.gtn", "old.png")
with open("old.png", "rb") as file:
    old = file.read()
fails(says="gtn: old.png: exists; use -f to overwrite it", out="old.png")
fails("-f", says="gtn: damaged.gtn: ", mesh="damaged.gtn", out="old.png")
fails(says="there is no folder nowhere", out="nowhere/new.png")
with open("old.png", "rb") as file:
    assert file.read() == old
assert gtn(*SMALL, "-q", "-f", "--opacity", 3, "mesh.gtn", "old.png") == ""
with open("old.png", "rb") as file:
    assert file.read() != old

def write_json(name, content):
    with open(name, "w") as file:
        file.write(content if isinstance(content, str) else json.dumps(content))


def draw(*more):
    gtn(*SMALL, "-q", "-f", "--array", "pressure", *more, "mesh.gtn", "map.png")
    return read_png("map.png")


# Beyond its ends a range goes on as at the ends: with the color of the largest value.
beyond = draw("--mode", "mip", "--range=-9,-8")
assert len(np.unique(beyond[beyond[:, :, 3] > 0][:, :3], axis=0)) == 1
# Opacities are multiplied, and stay at most 1.
assert np.abs(draw() - draw("--opacity", 0.2)).max() > 2
assert draw("--opacity", 0)[:, :, 3].max() == 0
assert draw("--mode", "mip", "--opacity", 1000)[:, :, 3].max() == 255

# Cameras.
for content, says in (
    ("{", "is not JSON: line 1, column 2: "),
    ('{"position": [1, 2, NaN]}', "is not JSON: line 1, column "),
    ("[" * 5000, "is not JSON"),
    ("position", "is not JSON: "),
    ([1, 2, 3], "is not a camera"),
    ({"Position": [1, 2, 3]}, "'Position' is nothing that a camera has; there are position, "),
    ({"position": [1, 2]}, "position has 2 numbers, not three"),
    ({"position": "near"}, "position is not a list of finite numbers"),
    ({"viewAngle": 180}, "viewAngle is not a number above 0 and below 180"),
    ({"viewAngle": "wide"}, "viewAngle is not a number"),
    ({"parallelScale": 0}, "parallelScale is not a number above 0"),
    ({"position": [1, 2, 3], "focalPoint": [1, 2, 3]}, "position and focalPoint are the same"),
    ({"viewUp": [0, 0, 0]}, "viewUp has no direction across the view"),
    ({"viewUp": [0, 0, -2], "position": [4, 4, 30], "focalPoint": [4, 4, 4]},
     "viewUp has no direction across the view"),
):
    write_json("bad.json", content)
    fails("--camera", "bad.json", says="gtn: bad.json: ")
    fails("--camera", "bad.json", says=says)
fails("--camera", "missing.json", says="gtn: missing.json: no such file")
