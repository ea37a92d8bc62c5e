# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gtn volume: volumes and slices go into .ghv files and come back, as exactly as was asked for; info
tells what is there; render draws it from wherever it is told to."""

import json
import os

import numpy as np

import gatunVolumes as gv
from gatunCli import enter_folder, gtn

enter_folder("volume")
values = gv.field().astype(np.int16)
gv.write_image(gv.make_image(values, "density", (0.5, 1, 2), (1, 2, 3)), "in.vti")


def pack(*arguments):
    return json.loads(gtn("volume", "pack", "-f", "--json", *arguments))


# Round trips through every format.
text = gtn("volume", "pack", "--rms-error", 0, "in.vti", "exact.ghv")
assert "18 x 14 x 12 voxels, 'density'" in text and "root mean square error 0" in text, text
for name in ("out.vti", "out.vtk", "out.nii", "out.nii.gz", "out.mha"):
    gtn("volume", "unpack", "exact.ghv", name, says="18 x 14 x 12 voxels")
    image = gv.read_image(name)
    assert (gv.values_of(image) == values).all(), name
    assert image.GetSpacing() == (0.5, 1, 2), (name, image.GetSpacing())
    packed = pack("--rms-error", 0, name, "again.ghv")
    assert packed["rootMeanSquareError"] == 0 and packed["size"] == [18, 14, 12]
    gtn("volume", "unpack", "-f", "again.ghv", "again.vti")
    assert (gv.values_of(gv.read_image("again.vti")) == values).all(), name
assert gv.read_image("out.vti").GetOrigin() == (1, 2, 3)
assert gv.read_image("out.vti").GetPointData().GetScalars().GetName() == "density"

# Slices: what VTK writes is read as VTK would, in the order of numbers.
for kind, extension in ((np.uint8, "png"), (np.uint16, "png"), (np.uint8, "tif"), (np.uint16, "tif"),
                        (np.float32, "tif")):
    os.makedirs("slices", exist_ok=True)
    for name in os.listdir("slices"):
        os.remove("slices/" + name)
    stack = gv.field(scale=200).astype(kind)
    for z, layer in enumerate(stack):
        gv.write_image(gv.make_image(layer[None]), f"slices/s{z}.{extension}")  # s10 is after s9
    files = sorted("slices/" + name for name in os.listdir("slices"))
    for inputs in (["slices"], [f"slices/s*.{extension}"], [f"slices/s?*.{extension}"], files):
        packed = pack("--rms-error", 0, "--spacing", "0.5,0.25,3", *inputs, "stack.ghv")
        assert packed["size"] == [18, 14, 12] and packed["largestError"] < 1e-4, packed
        gtn("volume", "unpack", "-f", "stack.ghv", "stack.vti")
        back = gv.read_image("stack.vti")
        assert abs(gv.values_of(back) - stack).max() < 1e-4 and back.GetSpacing() == (0.5, 0.25, 3)
    assert pack(f"slices/s?.{extension}", "stack.ghv")["size"] == [18, 14, 10]
    assert pack(f"slices/s3.{extension}", "stack.ghv")["size"] == [18, 14, 1]
    pack("--rms-error", 0, "slices", "stack.ghv")
    gtn("volume", "unpack", "-f", "stack.ghv", f"back_%03d.{extension}",
        says=f"back_000.{extension} to back_011.{extension}: 18 x 14 x 12 voxels")
    pack("--rms-error", 0, f"back_*.{extension}", "stack.ghv")
    assert json.loads(gtn("volume", "info", "--json", "stack.ghv"))["type"] == np.dtype(kind).name
    gtn("volume", "unpack", "-f", "stack.ghv", "stack.vti")
    assert abs(gv.values_of(gv.read_image("stack.vti")) - stack).max() < 1e-4
    for z in range(12):
        # VTK's reader of TIFF files does not heed their orientation.
        if extension == "png":
            assert (gv.values_of(gv.read_image(f"back_{z:03d}.png"))[0] == stack[z]).all()
        os.remove(f"back_{z:03d}.{extension}")

# Better costs more; rate control is met; blocks have the requested size.
span = float(values.max()) - float(values.min())
sizes = []
for quality in (20, 50, 80):
    sizes.append(pack("--quality", quality, "in.vti", "q.ghv"))
assert sizes[0]["bytes"] < sizes[1]["bytes"] < sizes[2]["bytes"]
assert sizes[0]["psnr"] < sizes[1]["psnr"] < sizes[2]["psnr"]
assert pack("--psnr", 40, "in.vti", "q.ghv")["psnr"] >= 40
assert pack("--rms-error", 2, "in.vti", "q.ghv")["rootMeanSquareError"] <= 2
for block in (2, 5, 16, "whole"):
    packed = pack("--block", block, "--weight", 1, "in.vti", "q.ghv")
    info = json.loads(gtn("volume", "info", "--json", "-v", "--verify", "q.ghv"))
    assert info["whole"] == (block == "whole")
    assert block == "whole" or info["block"] == [min(block, size) for size in (18, 14, 12)]
    assert info["bytes"] == packed["bytes"] == os.path.getsize("q.ghv") and info["verified"]
    assert info["bitsPerVoxel"] == packed["bitsPerVoxel"]
    assert info["rootMeanSquareError"] == packed["rootMeanSquareError"]
    assert info["size"] == [18, 14, 12] and info["type"] == "int16" and info["array"] == "density"
    assert info["spacing"] == [0.5, 1, 2] and info["origin"] == [1, 2, 3]
    assert info["range"] == [values.min(), values.max()] and info["frequencyWeight"] == 1
    assert info["rateControl"] == "quality" and info["rateControlValue"] == 60 and not info["lossless"]
    assert len(info["chunkBytes"]) == info["chunks"] and 0 < sum(info["chunkBytes"]) < info["bytes"]
# Infinity is no number of JSON.
text = gtn("volume", "info", "--json", "exact.ghv")
assert json.loads(text)["lossless"] and json.loads(text)["psnr"] is None and "9999" not in text
text = gtn("volume", "info", "-v", "--verify", "exact.ghv")
for part in ("18 x 14 x 12", "'density', int16", "lossless", "bits per voxel", "verified", "chunks"):
    assert part in text, (part, text)

# Arrays.
image = gv.make_image(values)
other = gv.make_image(values // 2, "other").GetPointData().GetScalars()
image.GetPointData().AddArray(other)
gv.write_image(image, "two.vti")
for name, expected in (("other", values // 2), ("density", values)):
    assert pack("--rms-error", 0, "--array", name, "two.vti", "q.ghv")["array"] == name
    gtn("volume", "unpack", "-f", "q.ghv", "q.vti")
    assert (gv.values_of(gv.read_image("q.vti")) == expected).all()


# Pictures.
def render(*arguments, out="picture.png"):
    text = gtn("volume", "render", "-f", "--size", "60x50", *arguments, out)
    if out.endswith(".png"):
        picture = gv.read_image(out)
        assert picture.GetDimensions()[:2] == (60, 50)
        return gv.vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(50, 60, -1).astype(int)
    return text


of_file = render("exact.ghv")
assert of_file.shape[2] == 4 and 0 < of_file[..., 3].max() and not of_file[[0, -1]][..., 3].any()
of_image = render("--rms-error", 0, "in.vti")
assert abs(of_file - of_image).max() <= 1
for options in (["--opacity-model", "xray"], ["--opacity-model", "exponential"], ["--zoom", 2],
                ["--azimuth", 90], ["--rotate", "0.25,0.25,0.25"], ["--background", "white"],
                ["--opacity", 0.2], ["--range", "100,200"], ["--unit-distance", 20]):
    other = render(*options, "exact.ghv")
    assert other.shape != of_file.shape or (other != of_file).mean() > 0.05, options
assert (render("--opacity-model", "xray", "--window", "0,1e9", "exact.ghv")[..., :3] == 0).all()
thin, dense = (render("--opacity-model", "exponential", "--extinction", k, "exact.ghv")[..., 3].sum()
               for k in (1e-5, 1e-2))
assert 2 * thin < dense
assert (render("--opacity-model", "exponential", "--zero", 2000, "exact.ghv")[..., 3] == 0).all()
for options in (["--method", "slice"], ["--method", "basis"]):
    assert abs(render("--opacity-model", "xray", "--window", "0,20000", *options, "exact.ghv") -
               render("--opacity-model", "xray", "--window", "0,20000", "exact.ghv")).max() <= 3, options
# Turned by the dissertation's angles: looked at along z, x to the right and y down.
plain = gv.field(seed=5).astype(np.uint16)
gv.write_image(gv.make_image(plain), "plain.vti")
sums = gtn("volume", "render", "-f", "--json", "--opacity-model", "xray", "--rotate", "0,0,0", "--rms-error", 0, "--size",
           "60x50", "plain.vti", "turned.png")
turned = gv.read_image("turned.png")
gray = gv.vtk_to_numpy(turned.GetPointData().GetScalars()).reshape(50, 60, -1)[::-1, :, 0].astype(float)
total = plain.sum(0).astype(float)
rows, columns = np.nonzero(gray > 0.95 * gray.max())
y, x = np.nonzero(total > 0.95 * total.max())
camera = json.loads(sums)["camera"]
pixel = 2 * camera["parallelScale"] / 50
found = (columns.mean() - 29.5) * pixel + 8.5, (rows.mean() - 24.5) * pixel + 6.5
assert np.hypot(found[0] - x.mean(), found[1] - y.mean()) < 0.8, (found, x.mean(), y.mean())

report = json.loads(render("--json", "exact.ghv", out="picture.exr"))
assert report["size"] == [18, 14, 12] and report["opacityModel"] == "transfer"
assert report["method"] == "voxels" and report["statistics"]["terms"] > 0
assert report["statistics"]["bytesRead"] > 0 and os.path.exists("picture.exr")
gtn("volume", "render", "--size", "20x20", "--stats", "exact.ghv", "stats.png", says="coefficients summed")
with open("view.json", "w") as file:
    json.dump(report["camera"], file)
assert abs(render("--camera", "view.json", "exact.ghv") - of_file).max() <= 1
