# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Reading of files into meshes of VTK, PyVista, meshio or NumPy."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from ._file import File
from ._grid import Grid
from ._open import opened
from ._types import Names, Progress, Source
from ._volume import Volume

_KINDS = ("vtk", "pyvista", "meshio", "numpy")


def _has_vtk():
    try:
        return importlib.util.find_spec("vtkmodules") is not None
    except ModuleNotFoundError:
        return False


def _choose_kind(to):
    """What to make: by default, what VTK has where it is installed."""
    if to is None:
        return "vtk" if _has_vtk() else "numpy"
    if to not in _KINDS:
        raise ValueError(f"to: {to!r} is not known; there are {', '.join(map(repr, _KINDS))}")
    return to


def _load(to):
    """The module that makes meshes and volumes of VTK."""
    try:
        from . import _vtk_mesh, _vtk_volume
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] != "vtkmodules":
            raise
        raise ImportError(f"to: {to!r} needs VTK for Python, which is not installed ({error})") from None
    return _vtk_mesh, _vtk_volume


def _wrap(mesh, to):
    if to == "vtk":
        return mesh
    import pyvista

    return pyvista.wrap(mesh)


def _make_mesh(file: File, to: str, method: Callable[..., Grid], *arguments: Any, **options: Any) -> Any:
    if to in ("vtk", "pyvista"):
        return _wrap(_load(to)[0].make_mesh(file, method, *arguments, **options), to)
    grid = method(*arguments, **options)
    if to == "numpy":
        return grid
    from ._meshio import to_meshio

    return to_meshio(grid)


def _make_volume(volume: Volume, to: str, options: dict[str, Any]) -> Any:
    box, progress = options.pop("box"), options.pop("progress")
    given = {name: value for name, value in options.items() if value not in (None, 0)}
    if given:
        raise ValueError(f"{next(iter(given))}: is for meshes, and {volume.file_name} is a volume")
    if to == "meshio":
        raise ValueError(f"to: {to!r} is for meshes, and {volume.file_name} is a volume")
    first, end = volume.find_box(box) if box is not None else (None, None)
    if to == "numpy":
        return volume.read(first, end, progress=progress)
    return _wrap(_load(to)[1].read_volume(volume, first, end, progress), to)


def read(
    source: Source,
    *,
    to: str | None = None,
    arrays: Names | Iterable[int] | None = None,
    step: int | None = None,
    time: float | None = None,
    box: Sequence[float] | None = None,
    ratio: float = 0.0,
    restore_order: bool = True,
    progress: Progress | None = None,
    **options: Any,
) -> Any:
    """Reads a .gtn or .ghv file into memory.

    Args:
        source: what ``gatun.open`` takes, such as a path or an address, or what it has returned. The contents
            tell what a file is, not its name.
        to: what to make: ``"vtk"``, ``"pyvista"``, ``"meshio"`` or ``"numpy"``. Default: what VTK has where it is
            installed, or else ``"numpy"``.
        arrays: names of the point and cell arrays to read, or one name; None for all. Other arrays
            are not read from the file.
        step: index of the time step, from 0; negative ones count from the end. Default: the first.
        time: a time in place of a step: the last step that is not later, or else the first.
        box: xmin, xmax, ymin, ymax, zmin, zmax: only the chunks of the mesh that touch this box,
            which have cells outside of it, or the voxels of a volume that lie in it and those around.
        ratio: fraction of points to remove, 0 to 1. Above 0, the file must have a hierarchy (see
            ``write``).
        restore_order: whether points and cells come in the order of the mesh that was written, as
            far as the file keeps it.
        progress: a function of the fraction that is done; it may return False to stop.
        options: others of ``gatun.File.read``: ``values``, ``exact``, ``level``, ``boundary``, ``tetrahedra``,
            ``piece``, ``pieces``, ``ghost_levels``, ``ids`` and ``wide_ids``.

    Returns:
        Of a mesh, a vtkUnstructuredGrid, or a vtkPolyData for the file of a surface; a ``gatun.Grid``
        for ``"numpy"``. Of a .ghv file, a vtkImageData, or an array ``values[z, y, x]``.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError or PermissionError.
        ValueError: a parameter that does not fit, as an array or a step that the file does not have.
        Error: the file is damaged, or no file of Gatun.
    """
    options.update(arrays=arrays, step=step, time=time, box=box, ratio=ratio, progress=progress)
    to = _choose_kind(to)
    with opened(source) as file:
        if isinstance(file, Volume):
            return _make_volume(file, to, options)
        return _make_mesh(file, to, file.read, restore_order=restore_order, **options)


def contour(
    source: Source,
    array: str | int,
    values: float | Sequence[float],
    *,
    to: str | None = None,
    component: int | None = None,
    normals: bool = False,
    **options: Any,
) -> Any:
    """Makes isosurfaces of the mesh in a file. Only chunks that have the values are decoded.

    Args:
        source: as for ``read``.
        array: name or number of a point array.
        values: one or several isovalues.
        to: as for ``read``.
        component: of the array, from 0; -1 for the length of the tuples, the default.
        normals: whether the normals of the surface are computed.
        options: others of ``gatun.File.contour``: ``step``, ``time``, ``arrays``, ``piece``, ``pieces``, ``ratio``,
            ``level`` and ``progress``.

    Returns:
        A vtkPolyData of triangles, or what ``to`` says.
    """
    with opened(source, File) as file:
        options.update(component=component, normals=normals)
        return _make_mesh(file, _choose_kind(to), file.contour, array, values, **options)


def slice(  # pylint: disable=redefined-builtin
    source: Source,
    origin: Sequence[float],
    normal: Sequence[float],
    *,
    to: str | None = None,
    **options: Any,
) -> Any:
    """Makes the section of the mesh in a file with a plane. Only chunks at the plane are decoded.

    Args:
        source: as for ``read``.
        origin: a point of the plane.
        normal: the direction across it.
        to: as for ``read``.
        options: others of ``gatun.File.slice``: ``step``, ``time``, ``arrays``, ``piece``, ``pieces``, ``ratio``,
            ``level`` and ``progress``.

    Returns:
        A vtkPolyData of triangles, or what ``to`` says.
    """
    with opened(source, File) as file:
        return _make_mesh(file, _choose_kind(to), file.slice, origin, normal, **options)
