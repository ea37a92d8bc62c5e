# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunDefaults makes the same functions and cameras from a file as from memory, decodes no more
than it needs, and says what it cannot do."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPolyData, vtkTable
from vtkmodules.vtkRenderingCore import vtkCamera, vtkColorTransferFunction, vtkVolumeProperty

import gatun
import gatunMeshes as gm
from gatun.vtk import vtkGatunDefaults, vtkGatunReader

points, tets = gm.lattice(12, seed=3)
values = np.exp(-30 * ((points - points.mean(axis=0)) ** 2).sum(axis=1)).astype(np.float32)
grid = gm.make_grid(points, tets)
gm.add_array(grid.GetPointData(), values, "blob")
gm.add_array(grid.GetPointData(), np.stack([values, -values, 0 * values], axis=1), "vector")
gm.add_array(grid.GetCellData(), (np.arange(len(tets)) % 5).astype(np.int32), "label")
path = gm.temporary("defaults.gtn")
gm.write(grid, path, ChunkSize=512)


def make(source, **options):
    defaults = vtkGatunDefaults()
    if source is not None and source.IsA("vtkAlgorithm"):
        defaults.SetInputConnection(source.GetOutputPort())
    else:
        defaults.SetInputData(source)
    for name, value in {"ArrayName": "blob", **options}.items():
        getattr(defaults, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    return defaults


def open_reader():
    reader = vtkGatunReader()
    reader.SetFileName(path)
    return reader


def nodes_of(function, width):
    nodes = np.zeros((function.GetSize(), width))
    node = [0.0] * width
    for i in range(function.GetSize()):
        function.GetNodeValue(i, node)
        nodes[i] = node
    return nodes


def functions_of(defaults):
    look = vtkVolumeProperty()
    assert defaults.MakeProperty(look)
    return (nodes_of(look.GetRGBTransferFunction(), 6), nodes_of(look.GetScalarOpacity(), 4),
            look.GetScalarOpacityUnitDistance())


# The same from a file, of which the reader decodes nothing, and from memory.
for options in ({}, {"ArrayName": "vector", "ArrayComponent": 1},
                {"ArrayName": "vector", "ArrayComponent": -1}, {"ArrayName": "label"},
                {"UnitDistance": 0.5}, {"Range": (0.1, 0.6)}):
    reader = open_reader()
    of_file = functions_of(make(reader, **options))
    assert reader.GetOutput().GetNumberOfCells() == 0, options
    of_memory = functions_of(make(grid, **options))
    for a, b in zip(of_file, of_memory):
        np.testing.assert_array_equal(a, b, err_msg=str(options))
    assert len(of_file[1]) >= 2 and of_file[1][:, 1].max() > 0, options
assert of_file[0][0, 0] == 0.1 and of_file[0][-1, 0] == 0.6
diagonal = np.linalg.norm(np.ptp(points[np.unique(tets)], axis=0))
assert np.isclose(functions_of(make(grid))[2], diagonal / 100)
assert functions_of(make(grid, UnitDistance=0.5))[2] == 0.5

# Ramps replace what there was; nothing is not a function, and is left alone.
ramp, colors = vtkPiecewiseFunction(), vtkColorTransferFunction()
ramp.AddPoint(50, 1)
vtkGatunDefaults.MakeRamp(-2, 8, ramp)
vtkGatunDefaults.MakeColors(-2, 8, colors)
assert tuple(ramp.GetRange()) == tuple(colors.GetRange()) == (-2, 8)
assert (np.diff(nodes_of(ramp, 4)[:, 1]) > 0).all() and 0 < ramp.GetValue(-2) < 0.02 < 0.4 < ramp.GetValue(8) < 1
light = [np.dot((0.2126, 0.7152, 0.0722), colors.GetColor(x)) for x in np.linspace(-2, 8, 30)]
assert (np.diff(light) > 0).all()
vtkGatunDefaults.MakeRamp(-2, 8, None)
vtkGatunDefaults.MakeColors(-2, 8, None)

# Opacities for another unit distance are those of as much light.
one, two = (functions_of(make(grid, UnitDistance=u))[1] for u in (0.01, 0.02))
probe = np.linspace(0, values.max(), 50)
log = [np.log1p(-np.interp(probe, nodes[:, 0], nodes[:, 1])) for nodes in (one, two)]
np.testing.assert_allclose(2 * log[0], log[1], rtol=0.15, atol=0.01)


# Cameras.
def seen_by(camera, aspect, corners):
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    m = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    h = np.c_[corners, np.ones(len(corners))] @ m.T
    assert (h[:, 3] > 0).all()
    return h[:, :2] / h[:, 3:]


used = points[np.unique(tets)]
for parallel in (False, True):
    for aspect in (0.4, 1, 2.5):
        places = []
        for source in (open_reader(), grid):
            camera = vtkCamera()
            camera.SetParallelProjection(parallel)
            camera.SetPosition(3, 5, 2)
            camera.SetViewUp(0.1, 0.2, 1)
            direction = np.array(camera.GetDirectionOfProjection())
            assert make(source).FitCamera(camera, aspect)
            np.testing.assert_allclose(camera.GetDirectionOfProjection(), direction, atol=1e-12)
            seen = seen_by(camera, aspect, used)
            extent = np.ptp(seen, axis=0) / 2
            assert np.isclose(extent.max(), 0.94, atol=0.002), (parallel, aspect, extent)
            assert np.abs(seen.max(axis=0) + seen.min(axis=0)).max() < 0.01
            places.append(camera.GetPosition() + camera.GetFocalPoint() + (camera.GetParallelScale(),))
        np.testing.assert_allclose(places[0], places[1], rtol=1e-12)
camera = vtkCamera()
camera.SetPosition(0, 0, 1)
assert make(grid).FitCameraAt(camera, 1, *used[0])
np.testing.assert_allclose(camera.GetFocalPoint(), used[0])
assert np.isclose(np.abs(seen_by(camera, 1, used)).max(), 0.94)

# Of a large file few chunks are decoded.
reader = open_reader()
assert make(reader).FitCamera(camera, 1)
handle = reader.GetOutputInformation(0).Get(gatun.vtk.vtkGatunFileHandle.FILE_HANDLE())
chunks = reader.GetChunkTable().GetNumberOfRows()
assert 0 < handle.GetDecodedChunks() < chunks, (handle.GetDecodedChunks(), chunks)

# Of a series, the time that is set counts, or else the one that was requested of the reader last.
moved = gm.make_grid(2 * points, tets)
gm.add_array(moved.GetPointData(), values ** 3, "blob")
first = gm.make_grid(points, tets)
gm.add_array(first.GetPointData(), values, "blob")
series = gm.temporary("series.gtn")
gatun.write([first, moved], series, times=[1, 5], overwrite=True)
for step, mesh in enumerate((first, moved)):
    for is_set in (True, False):
        reader = vtkGatunReader()
        reader.SetFileName(series)
        if is_set:
            defaults = make(reader, Time=(1, 5)[step], UseTime=True)
        else:
            reader.UpdateTimeStep((1, 5)[step])
            defaults = make(reader)
        for a, b in zip(functions_of(defaults), functions_of(make(mesh))):
            np.testing.assert_array_equal(a, b)
        cameras = vtkCamera(), vtkCamera()
        assert defaults.FitCamera(cameras[0], 1) and make(mesh).FitCamera(cameras[1], 1)
        np.testing.assert_allclose(cameras[0].GetPosition(), cameras[1].GetPosition(), rtol=1e-12)

# What cannot be: a message, and nothing is changed.
image = vtkImageData()
image.SetDimensions(3, 3, 3)
empty = gm.make_grid(points[:0], tets[:0])
for source, options, fails in (
        (None, {}, "both"), (vtkTable(), {}, "both"), (vtkPolyData(), {}, "both"), (empty, {}, "both"),
        (image, {}, "functions"), (grid, {"ArrayName": "nothing"}, "functions"),
        (grid, {"ArrayName": "vector", "ArrayComponent": 7}, "functions")):
    defaults = make(source, **options)
    messages = []
    defaults.AddObserver("ErrorEvent", lambda *_: messages.append(1))
    colors, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
    opacities.AddPoint(5, 0.5)
    assert not defaults.MakeFunctions(colors, opacities), (source, options)
    assert messages and opacities.GetSize() == 1 and colors.GetSize() == 0
    camera = vtkCamera()
    before = camera.GetPosition()
    assert defaults.FitCamera(camera, 1) == (fails == "functions"), (source, options)
    assert fails == "functions" or camera.GetPosition() == before
defaults = make(grid)
defaults.AddObserver("ErrorEvent", lambda *_: None)
for aspect in (0, -1, float("nan"), float("inf")):
    assert not defaults.FitCamera(vtkCamera(), aspect)
for call in (lambda: defaults.FitCamera(None, 1), lambda: defaults.MakeProperty(None)):
    messages = []
    defaults.AddObserver("ErrorEvent", lambda *_: messages.append(1))
    assert not call() and messages
assert "UnitDistance" in str(defaults)

# A damaged file is a message, too.
with open(path, "rb") as file:
    data = bytearray(file.read())
for i in range(len(data) // 3, len(data) // 2, 7):
    data[i] ^= 255
bad = gm.temporary("bad.gtn")
with open(bad, "wb") as file:
    file.write(data)
reader = vtkGatunReader()
reader.SetFileName(bad)
reader.AddObserver("ErrorEvent", lambda *_: None)
defaults = make(reader)
defaults.AddObserver("ErrorEvent", lambda *_: None)
assert not defaults.MakeProperty(vtkVolumeProperty())
