# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files with a hierarchy: what pack stores and tells of it, simplify and render by it, and without it."""

import json

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from gatunCli import enter_folder, gtn, read, standard_mesh, write
from gatunPictures import read_png

enter_folder("hierarchy")
write(standard_mesh(16), "mesh.vtu")
gtn("pack", "-q", "--keep-order", "all", "--chunk-size", 2000, "--hierarchy", "mesh.vtu", "kept.gtn")
told = gtn("pack", "--chunk-size", 2000, "--levels", 9, "--dependencies", "mesh.vtu", "levels.gtn")
assert "hierarchy" in told and "base meshes" in told and "bits per point" in told, told
assert "dependencies" in told, told
gtn("pack", "-q", "mesh.vtu", "plain.gtn")
points = read("mesh.vtu").GetNumberOfPoints()

# What info tells.
info = json.loads(gtn("info", "--json", "levels.gtn"))
assert info["hasHierarchy"] and info["merges"] > 0.9 * points
assert points / 10 < info["baseMeshes"][0]["points"] <= (points + 7) // 8
assert info["hasDependencies"] and info["formatVersion"] == 1
sizes = info["sizes"]
assert 0 < sizes["dependencies"]["bytes"] < sizes["hierarchy"]["bytes"]
parts = sum(part["bytes"] for name, part in sizes.items() if name != "file")
assert parts == sizes["file"]["bytes"], sizes
assert not json.loads(gtn("info", "--json", "plain.gtn"))["hasHierarchy"]
assert "\nbase meshes\n" in gtn("info", "levels.gtn")
gtn("verify", "-q", "levels.gtn", "mesh.vtu")
gtn("verify", "-q", "kept.gtn", "mesh.vtu")
gtn("pack", "--weight", "pressure", "mesh.vtu", "no.gtn", code=2, says="--hierarchy, --levels or --dependencies")


def assert_same(one, other):
    """The same meshes, point by point and cell by cell."""
    one, other = read(one), read(other)
    for of in (lambda g: g.GetPoints().GetData(), lambda g: g.GetPointData().GetArray("velocity")):
        np.testing.assert_array_equal(vtk_to_numpy(of(one)), vtk_to_numpy(of(other)))
    corners = [np.sort(vtk_to_numpy(g.GetCells().GetConnectivityArray()).reshape(-1, 4), axis=1)
               for g in (one, other)]
    np.testing.assert_array_equal(*corners)


# simplify: by the hierarchy as without.
for number, target in enumerate((("--ratio", 0.9), ("--ratio", 0.7), ("--points", 500),
                                 ("--rms-error", 0.01))):
    gtn("simplify", "-q", *target, "mesh.vtu", f"expected{number}.vtu")
    gtn("simplify", "-q", *target, "kept.gtn", f"got{number}.vtu")
    assert_same(f"expected{number}.vtu", f"got{number}.vtu")
    gtn("simplify", "-q", *target, "levels.gtn", f"level{number}.gtn")
    gtn("verify", "-q", f"level{number}.gtn", f"expected{number}.vtu")
# Other weights: not by the hierarchy.
gtn("simplify", "-q", "--ratio", 0.9, "--weight", "velocity", "mesh.vtu", "velocity.vtu")
gtn("simplify", "-q", "--ratio", 0.9, "--weight", "velocity", "kept.gtn", "velocity2.vtu")
assert_same("velocity.vtu", "velocity2.vtu")

# render: the picture of the simplified mesh.
with open("camera.json", "w") as file:
    json.dump({"position": (28, 20, 45), "focalPoint": (8, 8, 8), "viewUp": (0, 1, 0)}, file)
look = ["render", "-q", "--size", "90x70", "--array", "velocity", "--component", 0,
        "--mode", "mip", "--range=-1,1", "--camera", "camera.json"]
gtn("simplify", "-q", "--ratio", 0.8, "mesh.vtu", "simple.vtu")
gtn(*look, "simple.vtu", "expected.png")
gtn(*look, "mesh.vtu", "whole.png")
expected, whole = read_png("expected.png").astype(int), read_png("whole.png").astype(int)
assert np.abs(expected - whole).max() > 8
for name in ("kept", "levels"):
    gtn(*look, "--ratio", 0.8, f"{name}.gtn", f"{name}.png")
    assert np.abs(read_png(f"{name}.png").astype(int) - expected).max() <= 2
gtn(*look, "--ratio", 0.8, "mesh.vtu", "memory.png")
assert read_png("memory.png").shape == expected.shape

# A budget: with next to no time, next to nothing is drawn of the mesh; with much, all of it.
drawn = []
for seconds in ("1e-5", "100"):
    stats = json.loads(gtn(*look, "-f", "--json", "--budget", seconds, "levels.gtn", "b.png"))
    drawn.append(stats["statistics"]["tets"])
assert drawn[0] < 0.2 * drawn[1] and drawn[1] == stats["tets"], drawn
np.testing.assert_array_equal(read_png("b.png"), whole)

# What is wrong is said.
hint = "plain.gtn: there is no hierarchy in the file; make one with gtn pack --hierarchy"
gtn(*look, "--ratio", 0.5, "plain.gtn", "no.png", code=1, says=hint)
gtn(*look, "--budget", 0.5, "plain.gtn", "no.png", code=1, says=hint)
gtn(*look, "--ratio", 1.5, "levels.gtn", "no.png", code=2, says="--ratio")
gtn(*look, "--ratio", "nan", "levels.gtn", "no.png", code=1, says="SimplificationRatio is not a number")
gtn("pack", "--levels", -1, "mesh.vtu", "no.gtn", code=2, says="--levels")
gtn("pack", "--hierarchy", "--weight", "nothing", "mesh.vtu", "no.gtn", code=1, says="nothing")
gtn("pack", "--weight", "velocity", "mesh.vtu", "no.gtn", code=2, says="--hierarchy")
