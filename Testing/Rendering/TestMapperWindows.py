# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volumes in tiles of a large picture, in several viewports and windows, and several at once: each
place shows the picture that the same volume makes alone."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume, vtkWindowToImageFilter

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader, vtkGatunVolumeMapper

MESH = gv.wave()
OTHER = gv.wave(5, seed=3)
MODES = "Composite", "MaximumIntensity", "XRay"


# --------------------------------------------------------------------------------------------------
# Tiles: those of a window half or a third as large are the parts of the large picture.


def enlarge(window, times):
    """The picture of a window in tiles, as VTK's filter makes it."""
    tiles = vtkWindowToImageFilter()
    tiles.SetInput(window)
    tiles.SetScale(times)
    tiles.ReadFrontBufferOff()
    tiles.Update()
    image = tiles.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[..., :3].astype(float) / 255


def require_tiles(make, times, size, outline=0, part=np.s_[:, :]):
    """Outline: how many pixels there may be that VTK itself draws otherwise in a tile."""
    large = make(size).render()[part][..., :3]
    tiled = enlarge(make([n // times for n in size]).window, times)[part]
    differ = np.abs(tiled - large).max(-1) > 2 / 255 + 1e-9
    assert differ.sum() <= outline, (times, np.argwhere(differ))
    assert large.reshape(-1, 3).std(0).max() > 0.02, "there is nothing to be seen"


def make_scene(size, parallel=False, mode="Composite", plate=False, **options):
    scene = gv.Scene(MESH, size, **options)
    scene.look(0.5, 0.4, distance=2.6, parallel=parallel)
    getattr(scene.mapper, "SetBlendModeTo" + mode)()
    if plate:  # opaque, at an angle, through the middle of the mesh
        actor = gv.cube((-0.2, 0.7, -0.2, 1.2, 0.39, 0.4))
        actor.RotateX(20)
        scene.renderer.AddActor(actor)
    return scene


for times, size in ((2, (160, 120)), (3, (180, 90))):
    for parallel in (False, True):
        for mode in MODES:
            require_tiles(lambda size: make_scene(size, parallel, mode), times, size)
        require_tiles(lambda size: make_scene(size, parallel, plate=True), times, size, outline=4)
    # A viewport whose borders are not those of tiles. What is around it, VTK does not clear.
    part = np.s_[: size[1] * 7 // 10, size[0] // 4 :]
    require_tiles(
        lambda size: make_scene(size, viewport=(0.25, 0, 1, 0.7)), times, size, part=part)

# --------------------------------------------------------------------------------------------------
# Several in one window


def add_renderer(scene, viewport, volume):
    """Into the window of a scene, with its camera."""
    renderer = vtkRenderer()
    renderer.SetBackground(gv.BACKGROUND)
    renderer.SetViewport(*viewport)
    renderer.SetActiveCamera(scene.camera)
    renderer.AddVolume(volume)
    scene.window.AddRenderer(renderer)
    return renderer


def make_volume(source, prop=None, mapper=None):
    if not mapper:
        mapper = vtkGatunVolumeMapper()
        gv.connect(mapper, source)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(prop or gv.make_property())
    return volume


def alone(source, size=(100, 100), prop=None, **options):
    return gv.Scene(source, size, prop, **options).render()


path = gv.gm.temporary("mapper-windows.gtn")
gv.gm.write(MESH, path, ChunkSize=1024)
reader = vtkGatunReader()
reader.SetFileName(path)
left, right = (0, 0, 0.5, 1), (0.5, 0, 1, 1)
thin = gv.make_property(((0, 0.3), (0.5, 0), (1, 0.2)))
first = alone(MESH)
second = alone(OTHER)
assert gv.difference(first, second) > 0.1

# Two mappers, of meshes in memory and of one reader with different colors; also in the next
# pictures, when all is known already.
for sources, expected in (
        ((MESH, OTHER), (first, second)), ((reader, reader), (first, alone(MESH, prop=thin)))):
    scene = gv.Scene(sources[0], (200, 100), viewport=left)
    volume = make_volume(sources[1], thin if sources[1] is reader else None)
    add_renderer(scene, right, volume)
    for _ in range(2):
        picture = scene.render()
        gv.require_same(picture[:, :100], expected[0])
        gv.require_same(picture[:, 100:], expected[1])

# One mapper in two renderers, with one volume, and with a volume for each, of which one is turned.
for of_its_own in (False, True):
    for source in (MESH, reader):
        scene = gv.Scene(source, (200, 100), viewport=left)
        volume = make_volume(source, thin, scene.mapper) if of_its_own else scene.volume
        if of_its_own:
            volume.SetPosition(0.3, 0.1, 0)
        add_renderer(scene, right, volume)
        there = gv.Scene(MESH, (100, 100), volume.GetProperty())
        there.volume.SetPosition(volume.GetPosition())
        for _ in range(2):
            picture = scene.render()
            gv.require_same(picture[:, :100], first)
            gv.require_same(picture[:, 100:], there.render())

# One mapper in two windows, in turns; with another one that goes before the mapper does.
scene = gv.Scene(MESH, (100, 100))
gv.require_same(scene.render(), first)
small = gv.Scene(MESH, (60, 90))
expected = small.render()
small.volume.SetMapper(scene.mapper)
for _ in range(3):
    gv.require_same(small.render(), expected)
    gv.require_same(scene.render(), first)
small.window.Finalize()
gv.require_same(scene.render(), first)

# Two volumes in one renderer: as VTK draws them one after the other, each in front of the picture of
# those before; that one of them is there hides nothing of the other.
for intermix in (True, False):
    scene = gv.Scene(MESH, (100, 100), IntermixIntersectingGeometry=intermix)
    scene.look(0.3, 0.2)
    front = make_volume(OTHER)
    front.GetMapper().SetIntermixIntersectingGeometry(intermix)
    front.SetPosition(0.2, 0, 0.8)
    scene.renderer.AddVolume(front)
    both = scene.render()
    front.VisibilityOff()
    behind = scene.render()
    front.VisibilityOn()
    scene.volume = front
    nearer = gv.cast(scene, OTHER, (100, 100))
    gv.require_same(both[..., :3], gv.over(nearer, behind[..., :3]), tolerance=3 / 255)
    assert gv.difference(both, behind) > 0.1
