# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""pack --layers organises a file by values, info tells how, and info --histogram how values are spread
and what an isosurface would read."""

import json
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from gatunCli import enter_folder, gtn, lattice, make_grid, standard_mesh, write

enter_folder("layers")
grid = standard_mesh(12)
write(grid, "mesh.vtu")
pressure = vtk_to_numpy(grid.GetPointData().GetArray("pressure"))
velocity = vtk_to_numpy(grid.GetPointData().GetArray("velocity"))


def info_of(name, *options):
    return json.loads(gtn("info", "--json", *options, name))


# Every way to say it.
CHOICES = (
    ("pressure", {"array": "pressure", "spacing": "histogram", "count": 4}),
    ("pressure:7", {"spacing": "histogram", "count": 7}),
    ("pressure:uniform", {"spacing": "uniform", "count": 4}),
    ("pressure:6:normal", {"spacing": "normal", "count": 6}),
    ("pressure:1", {"count": 1, "bounds": []}),
    ("velocity:5", {"array": "velocity", "component": "magnitude", "count": 5}),
    ("velocity:5 --layer-component 1", {"array": "velocity", "component": 1}),
    ("velocity:5 --layer-component magnitude", {"component": "magnitude"}),
)
for choice, expected in CHOICES:
    gtn("pack", "-fq", "--chunk-size", 500, "--layers", *choice.split(), "mesh.vtu", "layers.gtn")
    gtn("verify", "-q", "layers.gtn", "mesh.vtu")
    info = info_of("layers.gtn")
    assert info["hasLayers"] and info["formatVersion"] == 1
    layers = info["layers"]
    for key, value in expected.items():
        assert layers[key] == value, (choice, key, layers[key])
    assert len(layers["bounds"]) == layers["count"] - 1
    assert sum(span["tets"] for span in layers["spans"]) == info["tets"]
    assert sum(span["chunks"] for span in layers["spans"]) == info["chunks"]

gtn("pack", "-fq", "--chunk-size", 500, "--layers", "pressure:4:uniform", "mesh.vtu", "layers.gtn")
gtn("pack", "-fq", "--chunk-size", 500, "mesh.vtu", "plain.gtn")
low, high = pressure.min(), pressure.max()
info = info_of("layers.gtn", "-v")
np.testing.assert_allclose(info["layers"]["bounds"], np.linspace(low, high, 5)[1:4], rtol=1e-6)
for chunk in info["chunkTable"]:
    first, last = chunk["layers"]
    assert 0 <= first <= last < 4
plain = info_of("plain.gtn")
assert not plain["hasLayers"] and "layers" not in plain and plain["formatVersion"] == 1
text = gtn("info", "layers.gtn")
for words in ("\nlayers\n", "  array            pressure\n", "  count            4\n",
              "  spacing          uniform\n"):
    assert words in text, (words, text)
assert "layers" not in gtn("info", "plain.gtn")
gtn("pack", "-fq", "--layers", "velocity", "mesh.vtu", "v.gtn")
gtn("info", "v.gtn", says="  array            velocity\n  component        magnitude\n")

# Names with colons, and names that look as if they had settings.
points, tets = lattice(4)
names = ("a:b", "c:5", "d:uniform", ":9")
odd = make_grid(points, tets, {name: points[:, 0].copy() for name in names})
write(odd, "odd.vtu")
for text, name, count, spacing in (
        ("a:b", "a:b", 4, "histogram"), ("a:b:2", "a:b", 2, "histogram"),
        ("c:5:0", "c:5", 4, "histogram"), ("d:uniform:3:histogram", "d:uniform", 3, "histogram"),
        ("d:uniform:uniform", "d:uniform", 4, "uniform"), (":9", ":9", 4, "histogram")):
    gtn("pack", "-fq", "--layers", text, "odd.vtu", "odd.gtn")
    layers = info_of("odd.gtn")["layers"]
    assert (layers["array"], layers["count"], layers["spacing"]) == (name, count, spacing), text
gtn("pack", "-fq", "--layers", "c:5", "odd.vtu", "odd.gtn", code=1,
    says="there is no point array 'c' to make layers of")

# What makes no sense.
gtn("pack", "--layers", "pressure:4097", "mesh.vtu", "no.gtn", code=2, says="from 0 to 4096")
gtn("pack", "--layers", "pressure:99999999999", "mesh.vtu", "no.gtn", code=2, says="from 0 to 4096")
gtn("pack", "--layers", "", "mesh.vtu", "no.gtn", code=2, says="no name")
gtn("pack", "--layers", "pressure", "--layer-component", "x", "mesh.vtu", "no.gtn", code=2,
    says="neither a number from 0 nor 'magnitude'")
gtn("pack", "--layer-component", 0, "mesh.vtu", "no.gtn", code=2, says="--layers")
gtn("pack", "--layers", "material", "mesh.vtu", "no.gtn", code=1, says="layers need a point array")
gtn("pack", "--layers", "pressure", "--layer-component", 1, "mesh.vtu", "no.gtn", code=1,
    says="has no component 1")
gtn("pack", "--layers", "none", "mesh.vtu", "no.gtn", code=1, says="there is no point array 'none'")

# Histograms: as numpy counts, whatever the organisation.
needs = {}
for name in ("plain.gtn", "layers.gtn"):
    for choice, values in (
            ("pressure:8", pressure), ("velocity:8", np.linalg.norm(velocity, axis=1)),
            ("velocity:8 --component 2", velocity[:, 2]),
            ("quality:8", vtk_to_numpy(grid.GetCellData().GetArray("quality"))),
            ("mark:7", vtk_to_numpy(grid.GetPointData().GetArray("mark")))):
        histogram = info_of(name, "--histogram", *choice.split())["histogram"]
        bins = histogram["bins"]
        edges = [bin["from"] for bin in bins] + [bins[-1]["to"]]
        counts = [bin["count"] for bin in bins]
        assert sum(counts) == len(values) and histogram["notANumber"] == 0, choice
        assert edges[0] == values.min() and edges[-1] == values.max(), choice
        np.testing.assert_array_equal(counts, np.histogram(values, edges)[0], choice)
        assert ("bytes" in bins[0]) == (not choice.startswith("quality"))
    histogram = info_of(name, "--histogram", "pressure")["histogram"]
    assert len(histogram["bins"]) == 20
    for bin in histogram["bins"]:
        assert 0 < bin["bytes"] <= histogram["allBytes"]
        assert bin["tets"] > 0 and bin["chunks"] > 0
    needs[name] = sum(bin["tets"] for bin in histogram["bins"])
assert needs["layers.gtn"] < 0.7 * needs["plain.gtn"], needs

# What is read of the file when a surface is made needs no less than cells that have the value.
histogram = info_of("layers.gtn", "--histogram", "pressure:8")["histogram"]
of_corners = pressure[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
for bin in histogram["bins"]:
    middle = (bin["from"] + bin["to"]) / 2
    crossed = (of_corners.min(axis=1) < middle) & (middle <= of_corners.max(axis=1))
    assert bin["tets"] >= crossed.sum() > 0

text = gtn("info", "--histogram", "pressure:8", "layers.gtn")
assert "\nhistogram\n  array            pressure\n  of               point\n" in text, text
most = max(bin["count"] for bin in histogram["bins"])
for bin in histogram["bins"]:
    length = max(1, int(np.floor(40 * bin["count"] / most + 0.5)))
    line = rf"  {bin['count']:,} +{bin['chunks']} +{bin['tets']:,} .* {'#' * length}\n"
    assert re.search(line, text), (line, text)
assert "chunks" not in gtn("info", "--histogram", "quality", "layers.gtn").split("histogram")[1]

# Values that are no numbers or not finite, one value, none.
strange = pressure.astype(np.float64)
strange[::10] = np.nan
strange[5] = np.inf
strange[6] = -np.inf
points, tets = lattice(12)
odd = make_grid(points, tets, {
    "strange": strange, "same": np.full(len(points), 3), "nothing": np.full(len(points), np.nan)})
write(odd, "odd.vtu")
gtn("pack", "-fq", "--chunk-size", 500, "--layers", "strange:5", "odd.vtu", "odd.gtn")
gtn("verify", "-q", "odd.gtn", "odd.vtu")
histogram = info_of("odd.gtn", "--histogram", "strange:4")["histogram"]
assert histogram["notANumber"] == np.isnan(strange).sum() and histogram["infinite"] == 2
finite = strange[np.isfinite(strange)]
assert sum(bin["count"] for bin in histogram["bins"]) == len(finite)
assert histogram["bins"][0]["from"] == finite.min() and histogram["bins"][3]["to"] == finite.max()
gtn("info", "--histogram", "strange", "odd.gtn",
    says=f"  not a number     {np.isnan(strange).sum()}\n  infinite         2\n")
assert len(info_of("odd.gtn", "--histogram", "same")["histogram"]["bins"]) == 1
nothing = info_of("odd.gtn", "--histogram", "nothing")["histogram"]
assert nothing["bins"] == [] and nothing["notANumber"] == len(points)
gtn("info", "--histogram", "nothing", "odd.gtn", says="  not a number     2,197\n")

gtn("info", "--histogram", "no", "odd.gtn", code=1, says="there is no array 'no'")
gtn("info", "--histogram", "same", "--component", 1, "odd.gtn", code=1, says="no component 1")
gtn("info", "--histogram", "same:0", "odd.gtn", code=2, says="there must be a bin")
gtn("info", "--histogram", "same:1001", "odd.gtn", code=2, says="from 0 to 1000")
gtn("info", "--component", 1, "odd.gtn", code=2, says="--histogram")
