# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Without options, render shows the whole object, as large as the image allows, and what is rare in
it; from a file of any chunks as from memory."""

import json

import numpy as np
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from gatunCli import enter_folder, gtn, lattice, make_grid, write
from gatunPictures import read_png

enter_folder("defaults")

# A crooked body with a medium of one value and a small ball of others.
points, tets = lattice(14)
points = (points - 7) * (1, 0.4, 0.2) + (300, -70, 5)
points[:, 1] += 0.04 * (points[:, 0] - 300) ** 2
ball = np.exp(-(((points - points.mean(axis=0)) / (1, 0.6, 0.5)) ** 2).sum(axis=1))
random = np.random.default_rng(2)
ball += 0.01 * random.random(len(ball))
write(make_grid(points, tets, {"ball": ball.astype(np.float32)}), "body.vtu")
gtn("pack", "-q", "body.vtu", "body.gtn")
gtn("pack", "-q", "--chunk-size", 400, "body.vtu", "chunks.gtn")


def frame_of(picture):
    """The rows and columns where something is: first and last of each, and those of the image."""
    seen = picture[:, :, 3] > 0
    rows, columns = np.nonzero(seen.any(axis=1))[0], np.nonzero(seen.any(axis=0))[0]
    return rows[0], rows[-1], columns[0], columns[-1], seen.shape[0], seen.shape[1]


def check_frame(picture, least=0.9, what=None):
    """Touches no border, and fills one direction."""
    top, bottom, left, right, height, width = frame_of(picture)
    assert top > 0 and left > 0 and bottom < height - 1 and right < width - 1, what
    parts = (bottom - top + 1) / height, (right - left + 1) / width
    assert max(parts) >= least, (what, parts)
    # In the middle, but for what hardly shows at an edge.
    assert abs(top + bottom - height + 1) <= max(4, 0.04 * height), (what, top, bottom)
    assert abs(left + right - width + 1) <= max(4, 0.04 * width), (what, left, right)


# Any direction and aspect, with all values visible.
ALL = ("--mode", "mip", "--opacity", 1000)
views = [("--azimuth", azimuth, "--elevation", elevation) for azimuth, elevation in
         ((0, 0), (90, 0), (30, 20), (-120, 65), (0, 90))] + [("--roll", 40), ("--roll", -75)]
for i, view in enumerate(views):
    size = ("120x90", "60x160", "200x50")[i % 3]
    for more in ((), ("--parallel",)):
        gtn("render", "-q", "-f", *ALL, *view, *more, "--size", size, "chunks.gtn", "view.png")
        check_frame(read_png("view.png"), what=(view, size, more))

# Chunks are not seen in the camera, nor whether there is a file.
cameras = []
for name in ("body.vtu", "body.gtn", "chunks.gtn"):
    told = json.loads(gtn("render", "-f", "--json", "--size", "90x60", name, "out.png"))
    cameras.append((told["camera"], read_png("out.png")))
for camera, picture in cameras[1:]:
    for key, value in cameras[0][0].items():
        np.testing.assert_allclose(camera[key], value, rtol=1e-12, atol=1e-12, err_msg=key)
    assert np.abs(picture - cameras[0][1]).max() <= 2

# The ball is seen, and the medium around it hardly.
alpha = cameras[0][1][:, :, 3]
assert alpha.max() > 120, alpha.max()
assert 0 < np.median(alpha[alpha > 0]) < 60, np.median(alpha[alpha > 0])
assert (alpha > 100).mean() < 0.25
# Options of opacity still count.
for options, factor in ((("--opacity", 0.2), 0.5), (("--unit-distance", 5), 0.5)):
    gtn("render", "-q", "-f", *options, "--size", "90x60", "body.gtn", "thin.png")
    assert read_png("thin.png")[:, :, 3].sum() < factor * alpha.sum(), options
gtn("render", "-q", "-f", "--range", "0.5,0.9", "--size", "90x60", "body.gtn", "range.png")
assert np.abs(read_png("range.png") - cameras[0][1]).max() > 20

# A constant is an even haze; so are cells with one label.
for name, data in (("point", ({"same": np.full(len(points), 3.5)}, {})),
                   ("cell", ({}, {"same": np.zeros(len(tets), np.int32)}))):
    write(make_grid(points, tets, *data), "same.vtu")
    gtn("render", "-q", "-f", "--size", "90x60", "same.vtu", "same.png")
    picture = read_png("same.png")
    check_frame(picture, what=name)
    inside = picture[:, :, 3][picture[:, :, 3] > 0]
    assert 20 < np.median(inside) < 220 and inside.max() < 250, (name, np.median(inside), inside.max())

# A surface, and a volume.
source = vtkSuperquadricSource()
source.SetSize(4)
source.SetScale(3, 1, 0.5)
source.SetCenter(50, 60, 70)
writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(source.GetOutputPort())
writer.SetFileName("surface.vtp")
writer.Write()
gtn("pack", "-q", "--chunk-size", 100, "surface.vtp", "surface.gtn")
for name in ("surface.vtp", "surface.gtn"):
    for more in (("--size", "150x80"), ("--parallel", "--size", "50x130")):
        gtn("render", "-q", "-f", *more, name, "surface.png")
        check_frame(read_png("surface.png"), what=name)

x, y, z = np.meshgrid(*[np.linspace(-1, 1, n) for n in (40, 24, 30)], indexing="ij")
volume = vtkImageData()
volume.SetDimensions(40, 24, 30)
volume.SetSpacing(1, 2, 0.5)
density = np.exp(-6 * (x ** 2 + y ** 2 + z ** 2)) + 0.002 * random.random(x.shape)
scalars = numpy_to_vtk(density.astype(np.float32).ravel(order="F"), deep=True)
scalars.SetName("density")
volume.GetPointData().SetScalars(scalars)
writer = vtkXMLImageDataWriter()
writer.SetInputData(volume)
writer.SetFileName("volume.vti")
writer.Write()
gtn("volume", "pack", "-q", "--psnr", 70, "volume.vti", "volume.ghv")
for name in ("volume.vti", "volume.ghv"):
    for view in ((), ("--azimuth", 80, "--elevation", -40, "--roll", 20)):
        for size in ("100x80", "60x140"):
            gtn("volume", "render", "-q", "-f", "--opacity", 1000, *view, "--size", size, name, "volume.png")
            check_frame(read_png("volume.png"), 0.85, (name, view, size))
    # The blob is opaque and the noise around it is not.
    gtn("volume", "render", "-q", "-f", "--size", "100x80", name, "volume.png")
    alpha = read_png("volume.png")[:, :, 3]
    assert alpha.max() > 100 and (alpha > 60).mean() < 0.4 and alpha[2:8, 45:55].max() < 30, name
