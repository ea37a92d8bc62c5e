# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes are saved as .ghv, opened and drawn in ParaView, the same on one rank and on several."""

import os

import gatunSample as sample
import numpy as np
from gatunParaView import load_plugin, load_state, rank_and_ranks
from vtkmodules.util.numpy_support import vtk_to_numpy

simple = load_plugin()
ranks = rank_and_ranks()[1]
wavelet = simple.Wavelet(WholeExtent=[-10, 12, -9, 9, -8, 10])
wavelet.UpdatePipeline()
path = sample.temporary("wavelet.ghv")
simple.SaveData(path, proxy=wavelet, RateControl="RMS Error", RMSError=0)
assert os.path.getsize(path) > 1000


def values(proxy, array):
    """The array of an image, of the first rank's part."""
    proxy.UpdatePipeline()
    image = simple.servermanager.Fetch(proxy)
    return image, vtk_to_numpy(image.GetPointData().GetArray(array)).copy()


def place_of(proxy):
    """Bounds, voxels and values of all of an image."""
    proxy.UpdatePipeline()
    information = proxy.GetDataInformation()
    return information.GetBounds(), information.GetNumberOfPoints(), \
        [round(value, 2) for value in proxy.PointData["RTData"].GetRange()]


reader = simple.OpenDataFile(path)
assert reader.GetXMLName() == "GatunHartleyReader", reader
assert place_of(reader)[0] == place_of(wavelet)[0], (place_of(reader), place_of(wavelet))
assert place_of(reader)[2] == place_of(wavelet)[2], (place_of(reader), place_of(wavelet))
if ranks == 1:
    read, found = values(reader, "RTData")
    made, expected = values(wavelet, "RTData")
    assert read.GetExtent() == made.GetExtent() and read.GetSpacing() == made.GetSpacing()
    assert abs(found - expected).max() < 1e-3, abs(found - expected).max()
else:
    # The integral over all ranks.
    sums = [simple.IntegrateVariables(Input=source) for source in (reader, wavelet)]
    sums = [values(source, "RTData")[1][0] for source in sums]
    assert abs(sums[0] / sums[1] - 1) < 1e-4, sums
assert reader.GetProperty("BitsPerVoxel") is not None

# Drawn from the file, from an encoder, and from voxels by default parameters.
low, high = wavelet.PointData["RTData"].GetRange()


def draw(source, **options):
    projection = simple.GatunHartleyProjection(Input=source)
    for name, value in options.items():
        setattr(projection, name, value)
    return projection


settings = dict(ImageSize=[60, 40], ViewDirection=[0.3, 0.5, -1])
encoder = simple.GatunHartleyEncoder(Input=wavelet, RateControl="RMS Error", RMSError=0)
pictures = [values(draw(source, **settings), "Color")[1].astype(int) for source in (reader, encoder)]
assert pictures[0].shape == (2400 // ranks, 4) and pictures[0][:, 3].max() > 100
difference = abs(pictures[0] - pictures[1])
assert difference.max() <= 2
encoder.RateControl = "Quality"
by_default = values(draw(wavelet, **settings), "Color")[1].astype(int)
encoded = values(draw(encoder, **settings), "Color")[1].astype(int)
assert (by_default == encoded).all()
# Close to lossless, but not the same. Colors of pixels that are nearly transparent mean little.
assert 0 < abs(encoded - pictures[1])[:, 3].max() < 30
encoder.Quality = 10
assert (values(draw(encoder, **settings), "Color")[1] != encoded).any()
projection = draw(reader, **settings)
# Each rank has its part; neighbors have the points where they meet.
assert 2400 <= sample.counts(projection)[0] < 2400 + 60 * ranks, sample.counts(projection)
assert abs(projection.ValueRange[0] - low) < 0.01 and abs(projection.ValueRange[1] - high) < 0.01
for name, value in (("OpacityModel", "X-Ray"), ("OpacityModel", "Exponential"),
                    ("OpacityModel", "Transfer Function"), ("ColorMap", "Heat"), ("Opacities", [0, 1, 1, 0]), ("Zoom", 2),
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
load_state(state)
again = [source for source in simple.GetSources().values()
         if source.GetXMLName() == "GatunHartleyProjection" and source.UseBackground]
assert len(again) == 1 and list(again[0].Opacities) == [0, 1, 1, 0]
assert (values(again[0], "Color")[1] == kept).all()
assert np.isfinite(kept).all()
os.remove(state)
