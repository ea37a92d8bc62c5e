# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Volume rendering as users see it: vtkGatunVolumeMapper in a window, vtkGatunRayCaster without."""

import gatunScenes as gs
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from gatun.vtk import vtkGatunRayCaster, vtkGatunVolumeMapper


def draw_volume(source, shade=False, camera=None, **options):
    view = gs.View()
    view.add_volume(source, shade=shade, **options)
    return view.draw(**(camera or {}))


def VolumeFromMemory():
    """The baseline is the one of VolumeFromFile."""
    return draw_volume(gs.ball())


def VolumeFromFile():
    return draw_volume(gs.ball_file("file"))


def VolumeFromPieces():
    """The pipeline makes eight pieces, one in memory at a time. The baseline is the one of
    VolumeFromFile."""
    reader = gs.ball_file("pieces")
    reader.SetBox(-2, 2, -2, 2, -2, 2)  # all: the mapper takes pieces of the output, not the file
    return draw_volume(reader, NumberOfPieces=8)


def VolumeOnDemand():
    """The reader's output is an outline. The baseline is the one of VolumeFromFile."""
    reader = gs.ball_file("demand")
    reader.SetLargeMesh(0)
    reader.Update()
    assert reader.GetOutput().GetNumberOfCells() == 12
    return draw_volume(reader)


def VolumeParallel():
    return draw_volume(gs.ball_file("parallel"), camera={"parallel": True, "azimuth": -20})


def VolumeInside():
    """Perspective from within the mesh."""
    return draw_volume(gs.ball_file("inside"), camera={"distance": 0.5, "azimuth": -70, "elevation": -10})


def VolumeShaded():
    prop = gs.volume_property(opacities=((0.5, 0), (0.55, 0.9)))
    prop.SetSpecular(0.3)
    return draw_volume(gs.ball_file("shaded"), shade=True, prop=prop)


def VolumeMaximumIntensity():
    return draw_volume(gs.ball_file("maximum"),
                       BlendMode=vtkGatunVolumeMapper.MAXIMUM_INTENSITY_BLEND)


def VolumeXRay():
    return draw_volume(gs.ball_file("xray"), BlendMode=vtkGatunVolumeMapper.XRAY_BLEND)


def VolumeSimplified():
    """A tenth of the points, by the hierarchy of the file."""
    return draw_volume(gs.ball_file("simplified", Hierarchy=True), SimplificationRatio=0.9)


def VolumeLayered():
    """Organized by layers of the values. The baseline is the one of VolumeFromFile."""
    return draw_volume(gs.ball_file("layered", Layers="heat"))


def VolumeAndGeometry():
    """A ball inside of the volume, an arrow in front of it."""
    view = gs.View()
    view.add_volume(gs.ball_file("geometry"))
    sphere = vtkSphereSource()
    sphere.SetRadius(0.35)
    sphere.SetThetaResolution(32)
    sphere.SetPhiResolution(24)
    sphere.SetCenter(0.35, 0.2, 0.3)
    view.add_surface(sphere, color=(0.9, 0.9, 0.9))
    arrow = vtkArrowSource()
    actor = view.add_surface(arrow, color=(0.2, 0.9, 0.3))
    actor.SetPosition(-0.9, 0.1, 1.2)
    return view.draw()


def VolumeTransformed():
    """A volume that is scaled, turned and moved, cut by a clipping plane."""
    view = gs.View()
    volume = view.add_volume(gs.ball_file("transformed"))
    volume.SetScale(0.8, 1.1, 0.5)
    volume.RotateZ(30)
    volume.SetPosition(0.1, -0.1, 0)
    plane = vtkPlane()
    plane.SetOrigin(0, 0.2, 0)
    plane.SetNormal(0, -1, 0)
    volume.GetMapper().AddClippingPlane(plane)
    return view.draw()


def cast(source, **options):
    caster = vtkGatunRayCaster()
    gs.connect(caster, source)
    caster.SetCamera(gs.make_camera())
    caster.SetProperty(gs.volume_property())
    caster.SetSize(gs.SIZE, gs.SIZE)
    for name, value in options.items():
        getattr(caster, "Set" + name)(value)
    caster.Update()
    assert caster.GetErrorCode() == 0
    return gs.over_background(gs.to_array(caster.GetOutput()))


def CasterFromFile():
    """The baseline is the one of VolumeFromFile: a window adds nothing."""
    return cast(gs.ball_file("caster"))


def CasterClipped():
    planes = vtkPlaneCollection()
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 0.3)
    plane.SetNormal(-0.3, 0, -1)
    planes.AddItem(plane)
    matrix = vtkMatrix4x4()
    matrix.SetElement(0, 0, 0.7)
    return cast(gs.ball_file("clipped"), ClippingPlanes=planes, VolumeMatrix=matrix)


gs.run(globals())
