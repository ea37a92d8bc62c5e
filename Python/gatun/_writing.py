# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writing of files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

from ._inputs import list_steps
from ._output import Options
from ._series import SeriesWriter
from ._targets import check_bound, check_target
from ._types import Names, Path, list_names
from ._voxels import write_voxels
from ._write import Progress


def _make_point_error(tolerance):
    """The bound of coordinates as the library takes it, or None."""
    if tolerance is None:
        return None
    text = tolerance if isinstance(tolerance, str) else f"abs:{tolerance}"
    if check_bound("point_tolerance", text, ("abs", "rel", "bits")):
        raise ValueError("point_tolerance: coordinates cannot keep zeros")
    return text.encode()


def write(
    data: Any,
    path: Path,
    *,
    overwrite: bool = False,
    arrays: Names | None = None,
    tolerances: str | Mapping[str, str] | None = None,
    profile: str = "fast",
    point_tolerance: float | str | None = None,
    keep_order: bool | Names = "none",
    hierarchy: bool = False,
    levels: int = 0,
    dependencies: bool = False,
    layers: str | tuple[str, int] | None = None,
    boundary: bool = False,
    append: bool = False,
    fill_missing: bool = False,
    times: Iterable[float] | bool | None = None,
    chunk_size: int = 0,
    key_step_interval: int = 8,
    quality: float | None = None,
    rms_error: float | None = None,
    psnr: float | None = None,
    bits_per_voxel: float | None = None,
    block_size: int = 8,
    progress: Progress | None = None,
) -> int:
    """Writes a mesh or a series of meshes to a .gtn file, or a volume to a .ghv file.

    The file appears under its name once it is complete. Meshes are stored without loss unless
    ``tolerances`` or ``point_tolerance`` are given.

    Args:
        data: a vtkUnstructuredGrid or vtkPolyData of any VTK, as meshes of PyVista are; a tree of
            blocks, which become one mesh; a ``gatun.Grid``, or an object with the members of a
            ``meshio.Mesh``, as ``gatun.Mesh``; an algorithm of VTK or its output port. For a .ghv file
            a vtkImageData, a ``gatun.Image``, or an array as ``values[z, y, x]``. Or an iterable of
            meshes, for a file with time steps: a sequence is asked for one mesh at a time, in place of
            others a list is made.
        path: the file to write, with the extension .gtn or .ghv.
        overwrite: whether to replace a file that is there.
        arrays: names of the point and cell arrays to write, or one name; None for all (of a
            volume: the active scalars).
        tolerances: how much arrays may change: a dictionary from names, or ``"*"`` for all others,
            to ``"abs:E"``, ``"rel:E"``, ``"pw:E"`` or ``"bits:N"``, with ``",zeros"`` at the end if
            values of 0 have to stay; or one of these texts for all arrays. Ids and
            vtkGhostType stay exact.
        profile: ``"fast"`` optimizes the file for reading speed, ``"small"`` for size: down to half
            the space, and read several times slower.
        point_tolerance: how much coordinates may change: a number in their units, or ``"abs:E"``,
            ``"rel:E"`` (of the longest side of the bounds) or ``"bits:N"``.
        keep_order: the original order that the file keeps: ``"none"``, ``"points"``, ``"cells"``,
            ``"corners"`` or ``"all"``, or a list of these. True is ``"all"``.
        hierarchy: whether the mesh can be read and drawn with any number of points. It preserves the
            active scalars, or without them all point arrays, of those that are written.
        levels: largest number of base meshes to store with the hierarchy, 0 to 64. A number above 0
            includes the hierarchy.
        dependencies: whether to store, with the hierarchy, which merges depend on which: some 3 bytes
            a point. Views of meshes of more than 4 million tetrahedra can then be finer where they
            are near.
        layers: a point array by whose values the file is organized, for isosurfaces; or a pair of it
            and the largest number of layers, 0 (automatic) to 4096.
        boundary: whether to store the boundary of the mesh, too.
        append: whether to add the time steps to the file, if it exists. They come after those of the
            file, and have the same arrays.
        fill_missing: whether arrays of a series may come and go: a mesh without an array of another
            one gets it, with NaN, or 0 if it is of integers.
        times: for a series, the times of its meshes, ascending (default: 0, 1, 2, ...); for an
            algorithm that has time steps, True to write all of them.
        chunk_size: largest number of cells in a chunk, 64 to 1048576, or 0 (automatic).
        key_step_interval: number of time steps from one that needs no other step to the next.
        quality, rms_error, psnr, bits_per_voxel: for volumes, one of these: quality from 1 to 100
            (default: 60), largest root mean square error (0: lossless), least peak signal-to-noise
            ratio in dB, or size.
        block_size: for volumes, voxels of a block along each axis: 2 to 64, or 0 for one block.
        progress: a function of the fraction from 0 to 1 that is done. It stops the call by returning
            False or raising an exception.

    Returns:
        The size of the file in bytes.

    Raises:
        OSError: there is no such folder, or the path is one; FileExistsError: there is a file.
        ValueError: a parameter or data that do not fit; ``gatun.InputError`` if the library has found
            out.
        TypeError: data of a kind that cannot be written.
        Error: the file cannot be written.
    """
    path = os.fsdecode(path)
    arrays = list_names(arrays)
    check_target(path, overwrite or append, ".gtn", ".ghv")
    rates = {
        "quality": quality,
        "rms_error": rms_error,
        "psnr": psnr,
        "bits_per_voxel": bits_per_voxel,
    }
    if path.lower().endswith(".ghv"):
        if append:
            raise ValueError("append: a volume has no time steps")
        return write_voxels(data, path, rates, block_size, arrays, progress)
    for name, value in rates.items():
        if value is not None:
            raise ValueError(f"{name}: is for volumes; meshes have tolerances")
    options = Options(
        tolerances=tolerances,
        profile=profile,
        keep_order=keep_order,
        hierarchy=hierarchy,
        levels=levels,
        dependencies=dependencies,
        layers=layers,
        boundary=boundary,
        chunk_size=chunk_size,
        key_step_interval=key_step_interval,
    )
    writer = SeriesWriter(
        path,
        list_steps(data, times),
        options,
        arrays=arrays,
        point_error=_make_point_error(point_tolerance),
        append=append,
        fill_missing=fill_missing,
        progress=progress,
    )
    return writer.write()
