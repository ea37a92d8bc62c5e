# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Bad files and parameters become exceptions with a message; nothing is printed or left behind."""

import functools
import math
import os
import warnings

import gatun
import numpy as np
from gatun._values import to_vtk
from gatunCube import find, make_cube, require_raises
from vtkmodules.vtkCommonCore import vtkPoints

points, tets = make_cube(5)
value = points[:, 0].copy()
mesh = gatun.from_numpy(points, tets, point_data={"value": value}, cell_data={"id": range(len(tets))})
good, target, volume = find("good.gtn"), find("target.gtn"), find("volume.ghv")
gatun.write(mesh, good, overwrite=True)
image = gatun.image_from_numpy(value.reshape(5, 5, 5))
gatun.write(image, volume, overwrite=True)
nowhere = find(os.path.join("nowhere", "a.gtn"))
folder = os.path.dirname(good)
os.path.exists(target) and os.remove(target)
missing = os.path.dirname(nowhere)
os.path.isdir(missing) and os.rmdir(missing)
os.makedirs(missing)
os.rmdir(missing)

# Files that are not there, not files, not Gatun's, truncated or damaged.
for function in (gatun.read, gatun.render, gatun.steps, gatun.info):
    require_raises(FileNotFoundError, nowhere, function, nowhere)
    require_raises(IsADirectoryError, folder, function, folder)
    error = require_raises(gatun.Error, "neither", function, __file__)
    assert error.name == "UnrecognizedFileTypeError" and error.code != 0
with open(good, "rb") as file:
    contents = bytearray(file.read())
damaged = find("damaged.gtn")
for data, name in ((contents[: len(contents) // 2], "PrematureEndOfFileError"), (b"", "")):
    with open(damaged, "wb") as file:
        file.write(data)
    error = require_raises(gatun.Error, damaged, gatun.read, damaged)
    assert not name or error.name == name, error.name
contents[60] ^= 1  # in the first section, which has coordinates
with open(damaged, "wb") as file:
    file.write(contents)
for function in (gatun.read, gatun.render):
    error = require_raises(gatun.Error, "checksum", function, damaged)
    assert str(error).startswith(damaged) and "\n" not in str(error)
    assert error.name == "FileFormatError"

# Parameters of reading.
read = gatun.read
require_raises(ValueError, "no array 'x'; there are 'value', 'id'", read, good, arrays=["value", "x"])
require_raises(ValueError, "no time steps", read, good, step=1)
require_raises(ValueError, "no time steps", read, good, time=1.0)
require_raises(ValueError, "exclude each other", read, good, step=0, time=1.0)
require_raises(ValueError, "the range is 0 to 1", read, good, ratio=1.5)
require_raises(ValueError, "ratio", read, good, ratio=math.nan)
require_raises(TypeError, "ratio", read, good, ratio="half")
require_raises(ValueError, "above its maximum", read, good, box=(1, 0, 0, 1, 0, 1))
require_raises(ValueError, "box", read, good, box=(0, 1))
require_raises(gatun.InputError, "hierarchy", read, good, ratio=0.5)
require_raises(ValueError, "is a volume", read, volume, step=1)
require_raises(ValueError, "no voxels", read, volume, box=(9, 10, 9, 10, 9, 10))
gatun.write([mesh, mesh], target, overwrite=True)
require_raises(ValueError, "no step 2; they are numbered 0 to 1", read, target, step=2)
require_raises(ValueError, "no step -3", read, target, step=-3)
os.remove(target)

# Parameters of writing. No file appears.
with open(good, "rb") as file:
    before = file.read()
require_raises(FileExistsError, "good.gtn", gatun.write, mesh, good)
require_raises(FileExistsError, "overwrite=True", gatun.write, image, volume)
write = functools.partial(gatun.write, overwrite=True)
for name in ("mesh.vtu", "mesh.GTN.txt", "mesh"):
    require_raises(ValueError, f"{name}: meshes are written to .gtn files", write, mesh, os.path.join(folder, name))
with open(good, "rb") as file:
    assert file.read() == before
require_raises(FileNotFoundError, "nowhere", write, mesh, nowhere)
require_raises(IsADirectoryError, folder, write, mesh, folder)
other = gatun.from_numpy(points, tets, point_data={"other": value})
refused = [
    (ValueError, "arrays", {"arrays": "x"}),
    (ValueError, "'x'", {"tolerances": {"x": "rel:1e-3"}}),
    (ValueError, "much", {"tolerances": "much"}),
    (ValueError, "has to be a text", {"tolerances": {"value": 0.1}}),
    (ValueError, "point_tolerance", {"point_tolerance": "small"}),
    (gatun.InputError, "tolerance of coordinates", {"point_tolerance": -1}),
    (gatun.InputError, "bits from 1 to 31", {"point_tolerance": "bits:40"}),
    (ValueError, "cannot keep zeros", {"point_tolerance": "abs:1,zeros"}),
    (ValueError, "keep_order: 'x'", {"keep_order": "x"}),
    (ValueError, "the range is 0 to 64", {"levels": 65}),
    (ValueError, "'x'", {"layers": "x"}),
    (ValueError, "layers", {"layers": ("value", 9999)}),
    (ValueError, "chunk_size", {"chunk_size": 3}),
    (ValueError, "profile: 'tiny' is not known; there are 'small', 'fast'", {"profile": "tiny"}),
    (ValueError, "key_step_interval", {"key_step_interval": 0}),
    (ValueError, "quality", {"quality": 50}),
]
for kind, text, options in refused:
    require_raises(kind, text, write, mesh, target, **options)
assert issubclass(gatun.InputError, ValueError) and issubclass(gatun.InputError, gatun.Error)
require_raises(TypeError, "int", write, 3, target)
require_raises(TypeError, "vtkImageData", write, image, target)
require_raises(TypeError, "vtkUnstructuredGrid", write, mesh, volume)
require_raises(ValueError, "quality and psnr", write, image, volume, quality=50, psnr=50)
require_raises(ValueError, "the range is 1 to 200", write, image, volume, psnr=0)
require_raises(ValueError, "block_size", write, image, volume, block_size=1)
require_raises(ValueError, "no meshes", write, [], target)
require_raises(TypeError, "int", write, [mesh, 3], target)
require_raises(TypeError, "step 1", write, [mesh, gatun.from_numpy(points, {}, surface=True)], target)
require_raises(ValueError, "times", write, [mesh, mesh], target, times=[1])
require_raises(ValueError, "times", write, [mesh, mesh], target, times=[1, 1])
require_raises(gatun.InputError, "step 1", write, [mesh, other], target)
require_raises(ValueError, "times", write, mesh, target, times=np.arange(3.0))
require_raises(NotADirectoryError, good, write, mesh, os.path.join(good, "a.gtn"))
strange = np.full(len(points), np.inf).reshape(5, 5, 5)
require_raises(gatun.InputError, "volume.ghv", write, gatun.image_from_numpy(strange), volume)


class Broken:
    def __len__(self):
        return 2

    def __getitem__(self, step):
        if step == 1:
            raise KeyError("no such step")
        return mesh


require_raises(KeyError, "no such step", write, Broken(), target)
assert not os.path.exists(target)
assert gatun.read(volume).GetNumberOfPoints() == 125  # the one from before

# Grids without 3D cells, in memory and in a file.
flat = gatun.from_numpy(points, [("triangle", [[0, 1, 5], [1, 2, 6]])], point_data={"value": value})
flat_file = find("flat.gtn")
write(flat, flat_file)
for source in (flat, flat_file):
    require_raises(ValueError, "no 3D cells, only 2 vtkTriangle", gatun.render, source, size=(8, 8))

# A caution is a warning of Python.
plane = gatun.from_numpy(points, [("hexahedron", [[0, 1, 6, 5, 25, 26, 31, 30]])])
places = vtkPoints()
places.SetData(to_vtk((10 * points).astype(int), "Points", "points"))
plane.SetPoints(places)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    gatun.write(plane, target, overwrite=True)
assert any("integer coordinates" in str(caution.message) for caution in caught), [str(c.message) for c in caught]
assert caught[0].filename == __file__, caught[0].filename
assert gatun.read(target).GetPoints().GetData().GetClassName() == "vtkDoubleArray"

# Parameters of images.
render = gatun.render
for text, options in [
    ("no array 'x'", {"array": "x"}),
    ("no component 1", {"component": 1}),
    ("size", {"size": (0, 10)}),
    ("size", {"size": (10, 32001)}),
    ("'best'", {"blend": "best"}),
    ("background", {"background": "blueish"}),
    ("background", {"background": (0, 0, 2)}),
    ("range", {"range": (2, 1)}),
    ("range", {"range": (0, math.inf)}),
    ("opacity", {"opacity": [0, 2]}),
    ("opacity", {"opacity": -1}),
    ("colors", {"colors": [(1, 1, 1)]}),
    ("unit_distance", {"unit_distance": 0}),
    ("zoom", {"zoom": 0}),
    ("direction", {"direction": (0, 0, 0)}),
    ("up", {"direction": (0, 1, 0), "up": (0, 2, 0)}),
    ("needs a direction", {"up": (0, 2, 0)}),
    ("ratio", {"ratio": 2}),
    ("dtype", {"dtype": np.int32}),
]:
    require_raises(ValueError, text, render, mesh, **options)
require_raises(ValueError, "files", render, mesh, step=0)
require_raises(gatun.InputError, "hierarchy", render, good, ratio=0.5)
require_raises(ValueError, "'mip' is not for volumes", render, volume, blend="mip")
require_raises(ValueError, "for meshes", render, volume, ratio=0.5)
require_raises(ValueError, "no cells", render, gatun.from_numpy(points[:0], {}))
require_raises(ValueError, "no array to draw", render, gatun.from_numpy(points, tets))
nothing = gatun.from_numpy(points, tets, point_data={"nothing": np.full(len(points), np.nan)})
require_raises(ValueError, "no finite range", render, nothing)
require_raises(TypeError, "int", render, 3)
require_raises(ValueError, "shape of an image", gatun.save_png, np.zeros((2, 2, 2)), find("a.png"))
require_raises(FileNotFoundError, "nowhere", gatun.save_png, np.zeros((2, 2)), nowhere)
