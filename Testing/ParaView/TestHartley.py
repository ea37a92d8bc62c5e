# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes are saved as .ghv, opened and drawn in ParaView, the same on one rank and on several."""

import os

import gatunSample as sample
import numpy as np
from gatunParaView import load_plugin
from vtkmodules.util.numpy_support import vtk_to_numpy

simple = load_plugin()
wavelet = simple.Wavelet(WholeExtent=[-10, 12, -9, 9, -8, 10])
wavelet.UpdatePipeline()
path = sample.temporary("wavelet.ghv")
simple.SaveData(path, proxy=wavelet, Goal="Error", MaximumError=0)
assert os.path.getsize(path) > 1000


def values(proxy, array):
    """All of an image's array, on the client."""
    proxy.UpdatePipeline()
    image = simple.servermanager.Fetch(proxy)
    return image, vtk_to_numpy(image.GetPointData().GetArray(array)).copy()


reader = simple.OpenDataFile(path)
assert reader.GetXMLName() == "HartleyVolumeReader", reader
read, found = values(reader, "RTData")
made, expected = values(wavelet, "RTData")
assert read.GetExtent() == made.GetExtent() and read.GetSpacing() == made.GetSpacing()
assert abs(found - expected).max() < 1e-3, abs(found - expected).max()
assert reader.GetProperty("BitsPerVoxel") is not None

# Drawn from the file, and from voxels.
low, high = wavelet.PointData["RTData"].GetRange()


def draw(source, **options):
    projection = simple.GatunHartleyProjection(Input=source)
    for name, value in options.items():
        setattr(projection, name, value)
    return projection


settings = dict(PictureSize=[60, 40], ViewDirection=[0.3, 0.5, -1], Goal="Error", MaximumError=0)
pictures = [values(draw(source, **settings), "Color")[1].astype(int) for source in (reader, wavelet)]
assert pictures[0].shape == (2400, 4) and pictures[0][:, 3].max() > 100
assert abs(pictures[0] - pictures[1]).max() <= 2
projection = draw(reader, **settings)
assert sample.counts(projection)[0] == 2400, sample.counts(projection)
assert abs(projection.ValueRange[0] - low) < 0.01 and abs(projection.ValueRange[1] - high) < 0.01
for name, value in (("Law", "X-Ray"), ("Law", "Exponential"), ("Law", "Transfer Function"),
                    ("ColourMap", "Heat"), ("Opacities", [0, 1, 1, 0]), ("Zoom", 2),
                    ("ViewUp", [1, 0, 0]), ("UseBackground", 1)):
    before = values(projection, "Color")[1]
    setattr(projection, name, value)
    assert (values(projection, "Color")[1] != before).any(), name

# A state.
state = sample.temporary("hartley.pvsm")
kept = values(projection, "Color")[1]
simple.SaveState(state)
for source in list(simple.GetSources().values()):
    simple.Delete(source)
simple.LoadState(state)
again = [source for source in simple.GetSources().values()
         if source.GetXMLName() == "GatunHartleyProjection" and source.UseBackground]
assert len(again) == 1 and list(again[0].Opacities) == [0, 1, 1, 0]
assert (values(again[0], "Color")[1] == kept).all()
assert np.isfinite(kept).all()
os.remove(state)
