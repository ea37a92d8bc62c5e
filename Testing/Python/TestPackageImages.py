# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gatun.render against VTK's cameras, vtkGatunRayCaster and colors that can be told in advance."""

import gatun
import numpy as np
from gatun._camera import make_camera
from gatun._scene import Scene
from gatunCube import find, make_cube, require_equal, require_raises
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import (
    vtkCamera,
    vtkColorTransferFunction,
    vtkRenderer,
    vtkVolumeProperty,
)

points, tets = make_cube()
points = points * [2, 1, 1] + [3, 0, 0]
value = points[:, 0] - 3
mesh = gatun.from_numpy(
    points,
    tets,
    point_data={"value": value, "vector": points * [1, 0, 0] - [4, 0, 0]},
    cell_data={"half": (np.arange(len(tets)) % 2).astype(float)},
)
path = find("mesh.gtn")
gatun.write(mesh, path, overwrite=True, hierarchy=True, chunk_size=256)
SIZE = (90, 60)


def draw(source=mesh, **options):
    options = {"size": SIZE, "array": "value", **options}
    return gatun.render(source, **options)


def look(aspect, **view):
    scene = Scene(mesh, "value", None)
    view = {"roll": 0, "zoom": 1, "direction": None, "up": None, "parallel": False, **view}
    return make_camera(scene, scene.make_defaults(), aspect, **view)


def project(camera, aspect):
    """Where the points are in the image, which reaches from -1 to 1 both ways."""
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    seen = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    return seen[:, :2] / seen[:, 3:]


# Cameras look from where VTK's azimuth and elevation put them, and the mesh fills the image.
for azimuth, elevation, roll in ((0, 0, 0), (30, 20, 0), (-100, -40, 30)):
    renderer = vtkRenderer()
    camera = renderer.GetActiveCamera()
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.OrthogonalizeViewUp()
    camera.Roll(roll)
    for parallel in (False, True):
        view = {"azimuth": azimuth, "elevation": elevation, "roll": roll, "parallel": parallel}
        made = look(1.5, **view)
        for name in ("DirectionOfProjection", "ViewUp", "ViewAngle"):
            given, wanted = (np.array(getattr(c, "Get" + name)()) for c in (made, camera))
            assert np.allclose(given, wanted, atol=1e-12), (name, given, wanted)
        seen = project(made, 1.5)
        assert np.isclose(np.abs(seen).max(), 0.94, atol=1e-3), np.abs(seen).max()
        assert np.allclose(seen.min(axis=0), -seen.max(axis=0), atol=1e-3)
        half = 0.5 if parallel else np.tan(np.radians(15)) / np.tan(np.radians(30))
        assert np.allclose(project(look(1.5, zoom=0.5, **view), 1.5), half * seen)
above = look(1, azimuth=0, elevation=90)
assert np.allclose(above.GetDirectionOfProjection(), (0, -1, 0))
assert np.allclose(above.GetViewUp(), (0, 0, -1))

# The image is that of the ray caster.
camera = look(1.5, azimuth=30, elevation=20)
colors = vtkColorTransferFunction()
colors.AddRGBPoint(0.5, 1, 0, 0)
colors.AddRGBPoint(1.5, 0, 0.5, 1)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0.5, 0.1)
opacity.AddPoint(1.5, 0.3)
transfer = vtkVolumeProperty()
transfer.SetColor(colors)
transfer.SetScalarOpacity(opacity)
transfer.SetScalarOpacityUnitDistance(0.25)
caster = gatun.vtk.vtkGatunRayCaster()
caster.SetInputData(mesh)
caster.SetArrayName("value")
caster.SetSize(SIZE)
caster.SetCamera(camera)
caster.SetProperty(transfer)
caster.Update()
wanted = vtk_to_numpy(caster.GetOutput().GetPointData().GetArray("RGBA"))
wanted = wanted.reshape(SIZE[1], SIZE[0], 4)[::-1]
options = {"unit_distance": 0.25, "dtype": np.float32}
for given in (
    draw(colors=[(1, 0, 0), (0, 0.5, 1)], opacity=[0.1, 0.3], range=(0.5, 1.5), **options),
    draw(colors=colors, opacity=[(0.5, 0.1), (1.5, 0.3)], **options),
    draw(colors=lambda x: (1 - x, x / 2, x), opacity=opacity, range=(0.5, 1.5), **options),
    draw(path, colors=colors, opacity=opacity, camera=camera, **options),
):
    assert given.dtype == np.float32 and given.shape == (SIZE[1], SIZE[0], 4)
    assert np.allclose(given[..., 3], wanted[..., 3], atol=1e-5)
    assert np.allclose(given[..., :3] * given[..., 3:], wanted[..., :3], atol=2e-3)

# Bytes are rounded floats. Over a background, what is not covered shows it.
floats, integers = draw(dtype=np.float32), draw()
assert integers.dtype == np.uint8 and integers[..., 3].max() > 100
assert np.abs(integers - floats * 255.0).max() <= 0.5 + 1e-3
over = draw(background="#ff8000", dtype=np.float32)
mixed = floats[..., :3] * floats[..., 3:] + (1 - floats[..., 3:]) * [1, 128 / 255, 0]
assert np.allclose(over[..., :3], mixed, atol=1e-5) and (over[..., 3] == 1).all()
assert (draw(background=(1, 1, 1))[0, 0] == 255).all()

# Opaque meshes have the color of their value: red on the left, where it is 0, and blue on the right.
opaque = draw(colors=[(1, 0, 0), (0, 0, 1)], opacity=[1, 1], unit_distance=1e-4, azimuth=0, elevation=0)
row = opaque[SIZE[1] // 2]
covered = np.flatnonzero(row[:, 3] == 255)
assert tuple(row[covered[1]])[0] > 230 and tuple(row[covered[-2]])[2] > 230
assert (np.diff(row[covered, 0].astype(int)) <= 0).all() and (np.diff(covered) == 1).all()
# From the other side it is the other way round, and so it is upside down.
for turned in ({"azimuth": 180, "elevation": 0}, {"azimuth": 0, "elevation": 0, "roll": 180}):
    other = draw(colors=[(1, 0, 0), (0, 0, 1)], opacity=[1, 1], unit_distance=1e-4, **turned)
    assert other[SIZE[1] // 2][covered[2], 2] > 200
# Directions: along y, z is up.
front = draw(direction=(0, 0, -1))
require_equal(front, draw(azimuth=0, elevation=0))
require_equal(draw(direction=(0, 3, 0)), draw(direction=(0, 1, 0), up=(0, 0, 1)))

# By default, what vtkGatunDefaults makes; from a file as from memory.
defaults = gatun.vtk.vtkGatunDefaults()
defaults.SetInputData(mesh)
defaults.SetArrayName("value")
defaults.SetUnitDistance(0.02)
colors, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
assert defaults.MakeFunctions(colors, opacity)
wanted = draw(colors=colors, opacity=opacity, unit_distance=0.02)
for source in (mesh, path):
    assert np.abs(draw(source, unit_distance=0.02).astype(int) - wanted).max() <= 1
# With other colors, the opacities stay; with other values, they do not.
other = draw(colors=[(1, 0, 0), (0, 0, 1)], unit_distance=0.02)
assert np.abs(other[..., 3].astype(int) - wanted[..., 3]).max() <= 1
assert np.abs(draw(range=(0.8, 1), unit_distance=0.02).astype(int) - wanted).max() > 20
# From a file as from memory, whatever of the three is given.
for choice in ({}, {"range": (0.3, 0.9)}, {"colors": [(1, 0, 0), (0, 0, 1)]}, {"opacity": [0, 0.3]}, {"blend": "mip"}):
    for more in ({}, {"range": (0.3, 0.9)}):
        options = {**more, **choice}
        differences = np.abs(draw(path, **options).astype(int) - draw(**options))
        assert differences.max() <= 1, (options, differences.max())
# The largest value of a ray is the more opaque the larger it is.
largest = draw(blend="mip", azimuth=0, elevation=0)[SIZE[1] // 2, covered[1:-1], 3].astype(int)
assert (np.diff(largest) >= 0).all() and largest[0] < 10 and largest[-1] > 100, largest

# Components, the length of tuples, cell arrays, modes, and a mesh that is simplified.
x = draw(array="vector", component=0, colors=[(0, 0, 0), (1, 1, 1)], opacity=[1, 1])
length = draw(array="vector", colors=[(0, 0, 0), (1, 1, 1)], opacity=[1, 1])
assert x[30, 12, 0] < 60 < 150 < length[30, 12, 0] and x[30, 80, 0] > 240 < length[30, 80, 0]
assert draw(array="half")[..., 3].max() > 0
for choice in ({"array": "half"}, {"array": "vector"}, {"array": "vector", "component": 0}, {}):
    assert np.abs(draw(path, **choice)[..., 3].astype(int) - draw(**choice)[..., 3]).max() <= 1
images = [draw(blend=blend) for blend in ("composite", "mip", "xray")]
assert not any(np.array_equal(a, b) for i, a in enumerate(images) for b in images[:i])
assert 0 < np.abs(draw(path, ratio=0.99).astype(int) - draw(path)).max()
more = draw(opacity=3)[..., 3].astype(int) - integers[..., 3]
assert more.min() >= 0 and more.max() > 50
assert 0 < np.abs(draw(shade=True).astype(int) - integers).max()

# Colors of a file with time steps are those of the range of all of them.
series = find("series.gtn")
gatun.write([gatun.from_numpy(points, tets, point_data={"v": value * k}) for k in (1, 2)], series, overwrite=True)
two = [
    draw(series, array=None, step=k, colors=[(0, 0, 0), (1, 1, 1)], opacity=[1, 1])[30, 60, 0]
    for k in (0, 1)
]
assert 0.4 * two[1] < two[0] < 0.6 * two[1], two
# With default opacities, too.
shown = [draw(series, array=None, step=k, colors=[(0, 0, 0), (1, 1, 1)])[..., 0].max() for k in (0, 1)]
assert shown[0] < 140 < 220 < shown[1], shown
require_equal(draw(series, array=None, time=0.5), draw(series, array=None, step=0))

# Volumes, in memory and in files, by the view of a mesh: a bright corner is where it belongs.
voxels = np.zeros((24, 24, 24), np.float32)
voxels[16:, 16:, :8] = 100  # far along z and y, and near along x
volume = gatun.image_from_numpy(voxels, name="v")
file = find("volume.ghv")
gatun.write(volume, file, overwrite=True, rms_error=0)
for source in (volume, file):
    image = draw(source, array=None, azimuth=0, elevation=0, size=(60, 60), opacity=[0, 1])
    rows, columns = np.nonzero(image[..., 3] > 128)
    assert len(rows) > 20 and rows.max() < 30 and columns.max() < 30, (rows, columns)
assert draw(file, array=None, blend="xray").max() > 0

# Files of images, the top row first.
picture = np.zeros((3, 5, 3), np.uint8)
picture[0, 4] = (10, 20, 30)
for image, channels in ((picture, 3), (picture / 255.0, 3), (picture[..., 2], 1), (integers, 4)):
    gatun.save_png(image, find("picture.png"))
    reader = vtkPNGReader()
    reader.SetFileName(find("picture.png"))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    height, width = image.shape[:2]
    assert reader.GetOutput().GetNumberOfScalarComponents() == channels
    pixels = pixels.reshape(height, width, -1)[::-1]
    assert np.array_equal(pixels, np.rint(image.reshape(pixels.shape) * (1 if image.dtype == np.uint8 else 255)))

assert isinstance(camera, vtkCamera)
require_raises(ValueError, "colors", draw, colors="no such map")
