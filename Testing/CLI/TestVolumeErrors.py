# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What gtn volume cannot do it says, and leaves nothing behind; what was there stays."""

import os
import struct
import zlib

import numpy as np

import gatunVolumes as gv
from gatunCli import enter_folder, gtn, standard_mesh, write

enter_folder("volume-errors")
values = gv.field().astype(np.uint8)
gv.write_image(gv.make_image(values), "in.vti")
gtn("volume", "pack", "-q", "in.vti", "in.ghv")


def fails(*arguments, code=1, says=None):
    before = {name: os.path.getmtime(name) for name in os.listdir(".")}
    gtn("volume", *arguments, code=code, says=says)
    assert {name: os.path.getmtime(name) for name in os.listdir(".")} == before, "something changed"


# The command line.
fails(code=2, says="a command is missing; see gtn volume --help")
fails("squeeze", code=2)
fails("pack", "in.vti", code=2, says="followed by the name of a .ghv file")
fails("pack", "in.vti", "out.gtn", code=2, says="out.gtn: the name must end in .ghv")
for option, texts in (("--block", ("0", "1", "65", "x", "8.5", "-8")), ("--quality", ("0", "101", "nan")),
                      ("--rms-error", ("-1", "nan", "inf")), ("--psnr", ("0", "x")),
                      ("--bits-per-voxel", ("0", "65")), ("--weight", ("-1", "5", "nan")),
                      ("--spacing", ("1,1", "1,1,1,1", "1,0,1", "1,-1,1", "1,nan,1", "a,b,c", ""))):
    for text in texts:
        fails("pack", f"{option}={text}", "in.vti", "out.ghv", code=2, says=option)
fails("pack", "--quality", 5, "--bits-per-voxel", 1, "in.vti", "out.ghv", code=2, says="--bits-per-voxel")
fails("unpack", "in.ghv", "out.xyz", code=2, says="out.xyz: the name must end in one of .vti")
fails("unpack", "in.ghv", "out.png", code=2, says="slices need a number, as slice_%04d.png")
fails("unpack", "in.ghv", "out_%d.vti", code=2, says="out_%d.vti: the name must end in .tif")
for name in ("%s.png", "a%d_%d.png", "%", "%12345d.png"):
    fails("unpack", "in.ghv", name, code=2, says=name)
fails("render", "in.ghv", "out.jpg", code=2, says="out.jpg: the name must end in .png or .exr")
for option, text in (("--rotate", "1,2"), ("--rotate", "a,b,c"), ("--opacity-model", "magic"), ("--window", "2,1"),
                     ("--method", "guess"),
                     ("--size", "0x5"), ("--extinction", "-1"), ("--sample-distance", "0")):
    fails("render", f"{option}={text}", "in.ghv", "out.png", code=2, says=option)
fails("render", "--rotate", "0,0,0", "--azimuth", 3, "in.ghv", "out.png", code=2, says="--rotate")
fails("render", "--extinction", 1, "in.ghv", "out.png", code=2, says="require --opacity-model exponential")
fails("render", "--window", "1,2", "in.ghv", "out.png", code=2, says="--window requires --opacity-model xray")
fails("render", "--array", "density", "in.ghv", "out.png", code=2, says="--array and --spacing do not apply")

# What is there stays.
for arguments in (("pack", "in.vti", "in.ghv"), ("unpack", "in.ghv", "in.vti"),):
    fails(*arguments, says="exists; use -f to overwrite it")
fails("pack", "in.vti", "no/out.ghv", says="gtn: no/out.ghv: there is no folder no")

# Input.
for command, out in (("pack", "out.ghv"), ("unpack", "out.vti"), ("render", "out.png")):
    fails(command, "missing.vti", out, says="gtn: missing.vti: no such file")
    fails(command, "missing.ghv", out, says="gtn: missing.ghv: no such file")
    fails(command, "missing*.png", out, says="gtn: missing*.png: fits no slices")
fails("info", "missing.ghv", says="gtn: missing.ghv: no such file")
fails("info", "in.vti", says="gtn: in.vti: ")
os.mkdir("empty")
fails("pack", "empty", "out.ghv", says="gtn: empty: has no slices")
for name, content in (("text.vti", b"no volume"), ("text.nii", b"no volume"), ("text.mha", b"no volume"),
                      ("text.png", b"no picture"), ("text.tif", b"no picture"), ("text.ghv", b"no"),
                      ("text.nrrd", b"no volume"), ("nothing.vti", b""), ("what.xyz", b"abc")):
    with open(name, "wb") as file:
        file.write(content)
    fails("pack", name, "out.ghv", says=f"gtn: {name}: ")
fails("pack", "what.xyz", "out.ghv", says="no reader for this extension; there are those for .vti")
write(standard_mesh(2), "mesh.vtu")
fails("pack", "mesh.vtu", "out.ghv", says="gtn: mesh.vtu: no reader for this extension")
fails("pack", "in.vti", "in.vti", "out.ghv", says="gtn: in.vti: of several files, each must be a slice")
fails("pack", "--array", "heat", "in.vti", "out.ghv",
      says="gtn: in.vti: has no array 'heat' on the points; there are density")
broken = gv.field()
broken[1, 2, 3] = np.nan
gv.write_image(gv.make_image(broken), "nan.vti")
gv.write_image(gv.make_image(np.zeros((3, 3, 3, 2))), "vectors.vti")
for name, says in (("nan.vti", "finite"), ("vectors.vti", "'density' has 2 components")):
    fails("pack", name, "out.ghv", says=f"gtn: {name}: ")
    fails("pack", name, "out.ghv", says=says)
    fails("render", name, "out.png", says=says)

# Slices that do not fit together.
for name, content in (("a1", values[0][None]), ("a2", values[0][None, :, :9]),
                      ("b1", values[0][None]), ("b2", values[0][None].astype(np.uint16)),
                      ("c1", np.zeros((1, 5, 5, 3), np.uint8)), ("c2", np.zeros((1, 5, 5, 3), np.uint8))):
    gv.write_image(gv.make_image(content), name + ".png")
fails("pack", "a*.png", "out.ghv", says="gtn: a2.png: has 9 x 14 pixels, unlike a1.png with 18 x 14")
fails("pack", "b1.png", "b2.png", "out.ghv",
      says="gtn: b2.png: has values of type uint16, unlike b1.png with uint8")
fails("pack", "c?.png", "out.ghv", says="gtn: c1.png: is an image of 3 channels, and slices have one")
gv.write_image(gv.make_image(gv.field()), "double.vti")
gtn("volume", "pack", "-q", "double.vti", "double.ghv")
fails("unpack", "double.ghv", "s%d.png", says="do not fit into .png files, which take uint8 and uint16")

# PNG files of all kinds that hold one number a pixel, and others.
def png(width, height, bits, color_type, rows, *more):
    def chunk(kind, content):
        return (struct.pack(">I", len(content)) + kind + content +
                struct.pack(">I", zlib.crc32(kind + content)))
    header = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + b"".join(chunk(*pair) for pair in more) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b""))


def put(name, content):
    with open(name, "wb") as image:
        image.write(content)


for name, content, values in (
        ("one.png", png(4, 1, 1, 0, [b"\xa0"]), [255, 0, 255, 0]),
        ("eight.png", png(4, 1, 8, 0, [b"\1\2\3\xff"]), [1, 2, 3, 255]),
        ("see.png", png(4, 1, 8, 0, [b"\1\2\3\4"], (b"tRNS", b"\0\1")), [1, 2, 3, 4]),
        ("wide.png", png(4, 1, 16, 0, [b"\1\0\0\1\xff\xff\0\0"]), [256, 1, 65535, 0])):
    put(name, content)
    gtn("volume", "pack", "-qf", "--rms-error", 0, name, "png.ghv")
    gtn("volume", "unpack", "-qf", "png.ghv", "png.vti")
    found = gv.vtk_to_numpy(gv.read_image("png.vti").GetPointData().GetScalars())
    assert list(found) == values, (name, found)
put("palette.png", png(2, 1, 8, 3, [b"\0\1"], (b"PLTE", bytes(6))))
fails("pack", "palette.png", "out.ghv", says="gtn: palette.png: is an image of 3 channels")
put("huge.png", png(1 << 30, 1 << 30, 8, 0, [b"\0"]))
fails("pack", "huge.png", "out.ghv", says="gtn: huge.png: is too short for its size")
noise = np.random.default_rng(1).integers(0, 65536, (40, 40), np.uint16)
good = png(40, 40, 16, 0, [row.astype(">u2").tobytes() for row in noise])
# All but the checksum of the last chunk, which has no content and which libpng 1.6.48 ignores.
for place in range(0, len(good) - 4, len(good) // 40):
    put("hurt.png", good[:place])
    fails("pack", "hurt.png", "out.ghv", says="gtn: hurt.png: ")
    put("hurt.png", good[:place] + bytes([good[place] ^ 0x55]) + good[place + 1:])
    fails("pack", "hurt.png", "out.ghv", says="gtn: hurt.png: ")

# Damaged files: right, or one message for the file.
with open("in.ghv", "rb") as file:
    good = file.read()
told = 0
for place in range(0, len(good), max(1, len(good) // 25)):
    with open("damaged.ghv", "wb") as file:
        file.write(good[:place] + bytes([good[place] ^ 0x55]) + good[place + 1:])
    fails("info", "--verify", "damaged.ghv", says="gtn: damaged.ghv: ")
    told += 1
assert told > 20
with open("damaged.ghv", "wb") as file:
    file.write(good[:len(good) // 2])
for command, out in (("unpack", "out.vti"), ("render", "out.png")):
    fails(command, "damaged.ghv", out, says="gtn: damaged.ghv: ")
