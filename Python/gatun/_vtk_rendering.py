# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images of data of VTK, and of the files of surfaces and volumes."""

from __future__ import annotations

import functools
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkCamera

from ._camera import make_camera
from ._classes import get_class
from ._colors import parse_color
from ._errors import set_property
from ._exceptions import Error
from ._file import File
from ._pixels import check_size, check_type, finish_image
from ._scene import FileScene, Scene
from ._transfer import make_property
from ._volume import Volume

if TYPE_CHECKING:
    from numpy.typing import DTypeLike

_MESH_MODES = {"composite": 0, "mip": 1, "xray": 101}
_VOLUME_MODES = {"xray": 0, "exponential": 1, "composite": 2}
_SAMPLES = 8  # of a pixel at the edges of triangles


def _choose_mode(blend, modes, what):
    if blend not in modes:
        there = ", ".join(map(repr, modes))
        raise ValueError(f"blend: {blend!r} is not for {what}; there are {there}")
    return modes[blend]


def _get_pixels(array, size):
    """An image of floats, the top row first."""
    return vtk_to_numpy(array).reshape(size[1], size[0], -1)[::-1]


def _draw_mesh(scene, size, camera, transfer, blend, ratio):
    caster = get_class("vtkGatunRayCaster")()
    caster.SetSize(size)
    caster.SetBlendMode(_choose_mode(blend, _MESH_MODES, "meshes"))
    caster.SetCamera(camera)
    caster.SetProperty(transfer)
    caster.SetArrayName(scene.array)
    caster.SetArrayAssociation(scene.association)
    caster.SetArrayComponent(scene.component)
    set_property(caster.GetDetailPolicy(), "ratio", "SimplificationRatio", ratio)
    # There is no next image for which anything could be kept.
    caster.SetMemoryBudget(0)
    scene.connect(caster)
    scene.update(caster)
    return _get_pixels(caster.GetOutput().GetPointData().GetArray("RGBA"), size)


def _draw_volume(scene, size, camera, transfer, blend):
    projection = get_class("vtkGatunHartleyProjection")()
    projection.SetSize(size)
    projection.SetOpacityModel(_choose_mode(blend, _VOLUME_MODES, "volumes"))
    projection.OutputFloatsOn()
    if scene.array is not None:
        projection.SetInputArrayToProcess(0, 0, 0, scene.association, scene.array)
    projection.SetProperty(transfer)
    projection.SetCamera(camera)
    scene.connect(projection)
    scene.update(projection)
    return _get_pixels(projection.GetOutput().GetPointData().GetArray("RGBA"), size)


@functools.lru_cache(maxsize=None)
def _open_display(name):
    """Connects to an X server, and stays connected: without any client it may start anew, and would
    refuse the next one meanwhile."""
    import ctypes

    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XOpenDisplay.argtypes = [ctypes.c_char_p]
    return x11.XOpenDisplay(name.encode())


def _require_display(window):
    """Raises Error without a display, where VTK would end the program."""
    if window.GetClassName() != "vtkXOpenGLRenderWindow":
        return
    name = os.environ.get("DISPLAY", "")
    if not (name and _open_display(name)):
        raise Error("surfaces are drawn by OpenGL, which needs a display; try xvfb-run -a")


def _make_actor(scene, transfer, ratio):
    from vtkmodules.vtkRenderingCore import vtkActor

    mapper = get_class("vtkGatunSurfaceMapper")()
    scene.connect(mapper)
    set_property(mapper.GetDetailPolicy(), "ratio", "SimplificationRatio", ratio)
    mapper.SetScalarVisibility(scene.array is not None)
    if scene.array is not None:
        colors = transfer.GetRGBTransferFunction()
        if scene.component < 0:
            colors.SetVectorModeToMagnitude()
        else:
            colors.SetVectorModeToComponent()
            colors.SetVectorComponent(scene.component)
        mapper.SetLookupTable(colors)
        mapper.UseLookupTableScalarRangeOn()
        mapper.SetColorModeToMapScalars()
        mapper.InterpolateScalarsBeforeMappingOn()
        if scene.association == 0:
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(scene.array)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return mapper, actor


def _draw_surface(scene, size, camera, transfer, ratio):
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (VTK's drawing)
    from vtkmodules.vtkCommonCore import vtkFloatArray
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

    window = vtkRenderWindow()
    _require_display(window)
    mapper, actor = _make_actor(scene, transfer, ratio)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetBackground(0, 0, 0)
    renderer.SetBackgroundAlpha(0)
    # A camera that was made before OpenGL was loaded cannot be used by it.
    renderer.GetActiveCamera().DeepCopy(camera)
    renderer.ResetCameraClippingRange(scene.bounds)
    window.SetShowWindow(False)
    window.SetUseOffScreenBuffers(True)
    window.SetAlphaBitPlanes(1)
    window.SetMultiSamples(_SAMPLES)
    window.SetSize(size)
    window.AddRenderer(renderer)
    with scene.raising(mapper):
        window.Render()
    colors = vtkFloatArray()
    window.GetRGBAPixelData(0, 0, size[0] - 1, size[1] - 1, 0, colors)
    pixels = np.array(_get_pixels(colors, size))
    window.Finalize()
    return pixels


def draw(
    source: Any,
    *,
    size: Sequence[int] = (1024, 768),
    array: str | None = None,
    component: int | None = None,
    step: int | None = None,
    time: float | None = None,
    colors: Any = None,
    opacity: Any = 1.0,
    range: Sequence[float] | None = None,
    unit_distance: float | None = None,
    shade: bool = False,
    blend: str = "composite",
    ratio: float = 0.0,
    background: str | Sequence[float] | None = None,
    azimuth: float = 30.0,
    elevation: float = 20.0,
    roll: float = 0.0,
    zoom: float = 1.0,
    direction: Sequence[float] | None = None,
    up: Sequence[float] | None = None,
    parallel: bool = False,
    camera: vtkCamera | None = None,
    dtype: DTypeLike = np.uint8,
) -> np.ndarray:
    """Draws data, or the File or Volume of a surface or volume. For the parameters, see ``gatun.render``."""
    check_type(dtype)
    size = check_size(size)
    color = None if background is None else parse_color(background)
    if isinstance(source, (File, Volume)):
        scene = FileScene(source, step, time, array, component)
    elif step is not None or time is not None:
        raise ValueError("step and time are for files")
    else:
        scene = Scene(source, array, component)
    is_volume = scene.kind is vtkImageData
    defaults = scene.make_defaults()
    if camera is None:
        camera = make_camera(
            scene,
            defaults,
            size[0] / size[1],
            azimuth=azimuth,
            elevation=elevation,
            roll=roll,
            zoom=zoom,
            direction=direction,
            up=up,
            parallel=parallel or is_volume,
        )
    distance = scene.get_diagonal() / 100 if unit_distance is None else unit_distance
    # Neither surfaces nor these modes have opacities of lengths.
    is_flat = scene.kind is vtkPolyData or blend == "mip" or (is_volume and blend == "xray")
    transfer = make_property(
        scene, None if is_flat else defaults, colors, opacity, range, distance
    )
    transfer.SetShade(bool(shade))
    if is_volume:
        if ratio:
            raise ValueError("ratio: is for meshes")
        pixels = _draw_volume(scene, size, camera, transfer, blend)
    elif scene.kind is vtkPolyData:
        if blend != "composite":
            raise ValueError("blend: is for meshes and volumes")
        pixels = _draw_surface(scene, size, camera, transfer, ratio)
    else:
        pixels = _draw_mesh(scene, size, camera, transfer, blend, ratio)
    return finish_image(pixels, color, dtype)
