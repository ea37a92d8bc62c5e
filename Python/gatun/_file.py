# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of meshes, read without VTK."""

from __future__ import annotations

import ctypes
import functools
import json
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _library as _c
from ._colors import parse_color
from ._description import Array, Level, Step, decode_array, make_key
from ._fields import read_fields, visit_fields
from ._grid import Grid
from ._library import library
from ._piece import make_request, read_piece
from ._pixels import check_type, finish_image
from ._rays import draw_mesh
from ._sources import Handle, get_ranges, get_text
from ._types import Allocate, Names, Progress, Source

if TYPE_CHECKING:
    from numpy.typing import DTypeLike

_FUNCTIONS = (library.gatun_open, library.gatun_open_source, library.gatun_close)


class File:
    """An open .gtn file, which any number of threads may read at once.

    Args:
        source: the path of a file, its bytes, or an object with ``size``, the size of the file, and
            ``read(offset, length)``, which returns so many bytes. ``read`` is called by several
            threads at once. It may raise ``gatun.NotHere`` for bytes that have not come yet.
        cache_bytes: memory for decoded parts, which further calls use; 0 for 512 MiB.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError.
        Error: the file is damaged, or no file of a mesh.
    """

    def __init__(self, source: Source, *, cache_bytes: int = 0) -> None:
        self._handle = Handle(source, _FUNCTIONS, cache_bytes)
        self._info = _c.Info()
        self._handle.get(library.gatun_get_info, ctypes.byref(self._info))

    def close(self) -> None:
        """Closes the file. Calls of other threads end first."""
        self._handle.close()

    def __enter__(self) -> File:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # Description

    @functools.cached_property
    def info(self) -> dict[str, Any]:
        """A description of the file, that of ``gtn info --json``."""
        return json.loads(get_text(self._handle, library.gatun_describe))

    @functools.cached_property
    def arrays(self) -> list[Array]:
        """The arrays of points and cells."""
        found = []
        taken = {False: [], True: []}
        for i in range(self._info.arrays):
            array = self._describe_array(i)
            keys = taken[bool(array.is_cell)]
            keys.append(make_key(_c.decode_text(array.name), len(keys), keys))
            found.append(decode_array(array, keys[-1]))
        return found

    @functools.cached_property
    def point_array(self) -> Array:
        """The array of the points, with its names and keys."""
        return decode_array(self._describe_array(_c.POINT_ARRAY), "points")

    @functools.cached_property
    def times(self) -> list[float]:
        """The times of the steps, empty for a file without time."""
        return [float(time) for time in self.info["times"]]

    @functools.cached_property
    def steps(self) -> list[Step]:
        """The time steps; a file without time has one at most."""
        found = []
        for i in range(self._info.steps):
            step = self._get(library.gatun_get_step, _c.Step, i)
            time = step.time if self._info.has_time else None
            found.append(Step(time, step.mesh, step.points, step.cells, tuple(step.bounds)))
        return found

    @functools.cached_property
    def levels(self) -> list[Level]:
        """Coarser meshes in the file. ``levels[0]`` is the finest of them, which ``level=1`` reads."""
        found = []
        for i in range(self._info.levels):
            level = self._get(library.gatun_get_level, _c.Level, i + 1)
            found.append(Level(level.points, level.cells))
        return found

    @property
    def file_name(self) -> str:
        """The name of the file, for messages."""
        return self._handle.name

    @property
    def path(self) -> str | None:
        """The path of the file, or None if it comes from elsewhere."""
        return self._handle.path

    @property
    def has_time(self) -> bool:
        """Whether the file has time steps with times."""
        return bool(self._info.has_time)

    @property
    def has_wide_ids(self) -> bool:
        """Whether ids have 64 bits."""
        return bool(self._info.has_wide_ids)

    @property
    def is_surface(self) -> bool:
        """Whether the file is one of a surface (vtkPolyData)."""
        return bool(self._info.is_surface)

    @property
    def bytes_read(self) -> int:
        """The bytes of the file that have been read since it was opened."""
        info = _c.Info()
        self._handle.get(library.gatun_get_info, ctypes.byref(info))
        return info.bytes_read

    def get_range(
        self, array: str | int, component: int | None = None, step: int = 0
    ) -> tuple[float, float]:
        """The smallest and largest value of an array at a step, without NaN.

        Args:
            array: its name, or its number in ``arrays``.
            component: of it, or -1 for the length of the tuples, the default.
            step: as for ``read``.
        """
        number = self._find_array(array)
        component = self._find_component(number, component)
        found = (ctypes.c_double * 2)()
        index = self.find_step(step, None)
        self._handle.get(library.gatun_get_range, number, component, index, found)
        return tuple(found)

    def find_range(self, array: str | int, component: int | None = None) -> tuple[float, float]:
        """The smallest and largest value of an array over all steps, as ``get_range`` tells them."""
        ranges = [self.get_range(array, component, step) for step in range(max(len(self.times), 1))]
        return min(low for low, _ in ranges), max(high for _, high in ranges)

    def get_field_data(self, step: int = 0) -> dict[str, Any]:
        """The arrays of the whole mesh at a step: numbers, or lists of strings."""
        return read_fields(self._handle, self.find_step(step, None))

    def make_fields(self, make, step=None, time=None):
        """What a function makes of each field array of the library at a step. It is for this package."""
        return list(map(make, visit_fields(self._handle, self.find_step(step, time))))

    def _get(self, function, kind, number):
        found = kind()
        self._handle.get(function, number, ctypes.byref(found))
        return found

    def _describe_array(self, number):
        return self._get(library.gatun_get_array, _c.Array, number)

    # Parameters

    def find_step(self, step, time):
        """The number of a step from 0, from the step or time of ``read``."""
        if step is not None and time is not None:
            raise ValueError("step and time exclude each other")
        if time is not None:
            if not self.times or math.isnan(time):
                raise ValueError("time: is not a number" if self.times else f"{self.file_name}: has no time steps")
            return max(int(np.searchsorted(self.times, time, "right")) - 1, 0)
        count = max(self._info.steps, 1)
        index = 0 if step is None else int(step)
        if not -count <= index < count:
            there = f"step {step}; they are numbered 0 to {count - 1}" if self.has_time else "time steps"
            raise ValueError(f"{self.file_name}: has no {there}")
        return index % count

    def _find_arrays(self, arrays):
        """The numbers of arrays, ascending."""
        if self._info.steps == 0:
            return []
        if arrays is None:
            return list(range(len(self.arrays)))
        found = set()
        for name in [arrays] if isinstance(arrays, (str, int)) else arrays:
            found.update(self._match_array(name))
        return sorted(found)

    def _match_array(self, name):
        """The numbers of all arrays of a name or key."""
        if not isinstance(name, str):
            if not 0 <= name < len(self.arrays):
                raise ValueError(f"{self.file_name}: has no array {name}; there are {len(self.arrays)}")
            return [int(name)]
        found = [i for i, array in enumerate(self.arrays) if name in (array.name, array.key)]
        if not found:
            there = ", ".join(repr(array.key) for array in self.arrays) or "none"
            raise ValueError(f"{self.file_name}: has no array {name!r}; there are {there}")
        return found

    def _find_array(self, array):
        return self._match_array(array)[0]

    def _find_component(self, number, component):
        """A component of an array; that of scalars is the only one, whatever its name."""
        count = self.arrays[number].components
        if count == 1 and component in (None, 0, -1):
            return 0
        component = -1 if component is None else component
        if not -1 <= component < count:
            raise ValueError(
                f"array {self.arrays[number].key!r} has no component {component}; they are numbered 0 "
                f"to {count - 1}, and -1 is the length"
            )
        return component

    def _make_request(self, options):
        options = dict(options)
        number = self.find_step(options.pop("step"), options.pop("time"))
        arrays = self._find_arrays(options.pop("arrays"))
        values = options.pop("values", None)
        if values is not None:
            name, low, high = values
            chosen = self._find_array(name)
            values = (chosen, self._find_component(chosen, None), float(low), float(high))
        return make_request(number, arrays, values=values, **options)

    # Reading

    def read(
        self,
        *,
        step: int | None = None,
        time: float | None = None,
        arrays: Names | Iterable[int] | None = None,
        piece: int = 0,
        pieces: int = 1,
        ghost_levels: int = 0,
        box: Sequence[float] | None = None,
        values: tuple[str | int, float, float] | None = None,
        exact: bool = False,
        ratio: float = 0.0,
        level: int = 0,
        boundary: bool = False,
        tetrahedra: bool = False,
        restore_order: bool = True,
        ids: bool = False,
        wide_ids: bool | None = None,
        allocate: Allocate | None = None,
        progress: Progress | None = None,
    ) -> Grid:
        """Reads the mesh or a part of it.

        Args:
            step: number of the time step, from 0; negative ones count from the end. Default: the first.
            time: a time in place of a step: the last step that is not later, or else the first.
            arrays: names or numbers of the point and cell arrays to read; None for all.
            piece, pieces: one of several pieces, from 0 to ``pieces - 1``.
            ghost_levels: the number of layers of cells around a piece to add.
            box: xmin, xmax, ymin, ymax, zmin, zmax: only the chunks that touch this box.
            values: an array and the smallest and largest value: only the chunks that have such values.
            exact: whether only the cells that meet box and values are read, not all of their chunks.
            ratio: fraction of points to remove, 0 to 1. Above 0, the file must have a hierarchy.
            level: a coarser mesh in the file, from 1 for the finest of them; 0 for the mesh itself.
            boundary: whether the boundary in the file is read in place of the mesh.
            tetrahedra: whether the tetrahedra that other cells consist of are read in their place.
            restore_order: whether points and cells come in the order of the mesh that was written, as
                far as the file keeps it.
            ids: whether the original numbers of points and cells are read.
            wide_ids: whether connectivity and offsets have 64 bits. Default: as in the mesh that was
                written.
            allocate: a function of name, type and shape that returns the array to fill, for memory that
                another library manages. Names are those of the members of ``Grid``, and
                ``"point_data/NAME"`` and ``"cell_data/NAME"``.
            progress: a function of the fraction that is done; it may return False to stop.

        Raises:
            ValueError: a parameter that does not fit, as an array or a step that the file does not have.
            NotHere: the source does not have the bytes yet.
            Error: the file is damaged, or reading was stopped.
        """
        request = self._make_request(
            dict(
                step=step,
                time=time,
                arrays=arrays,
                piece=piece,
                pieces=pieces,
                ghost_levels=ghost_levels,
                box=box,
                values=values,
                exact=exact,
                ratio=ratio,
                level=level,
                boundary=boundary,
                tetrahedra=tetrahedra,
                restore_order=restore_order,
            )
        )
        options = {"ids": ids, "ghosts": pieces > 1 or ghost_levels > 0, "wide_ids": wide_ids}
        arguments = (ctypes.byref(request.structure),)
        return read_piece(
            self, self._handle, request, library.gatun_prepare, arguments, options, allocate, progress
        )

    def plan(self, *, gap: int = 0, **options: Any) -> list[tuple[int, int]]:
        """The ranges of the file that ``read`` needs and that have not been read before.

        Args:
            gap: ranges with at most so many bytes between them are joined.
            options: as for ``read``, without ``allocate`` and ``progress``.

        Returns:
            Pairs of offset and length, by ascending offset.

        Raises:
            NotHere: the source does not have tables that tell it; its ``ranges`` are theirs.
        """
        for name in ("ids", "wide_ids"):
            options.pop(name, None)
        request = self._make_request({"step": None, "time": None, "arrays": None, **options})
        return get_ranges(self._handle, library.gatun_plan, ctypes.byref(request.structure), gap)

    def contour(
        self,
        array: str | int,
        values: float | Sequence[float],
        *,
        component: int | None = None,
        normals: bool = False,
        step: int | None = None,
        time: float | None = None,
        arrays: Names | Iterable[int] | None = None,
        piece: int = 0,
        pieces: int = 1,
        ratio: float = 0.0,
        level: int = 0,
        allocate: Allocate | None = None,
        progress: Progress | None = None,
    ) -> Grid:
        """Makes isosurfaces of triangles. Only chunks that have the values are decoded.

        Args:
            array: name or number of a point array.
            values: one or several isovalues.
            component: of the array, from 0; -1 for the length of the tuples, the default.
            normals: whether the normals of the surface are computed.
            step, time, arrays, piece, pieces, ratio, level, allocate, progress: as for ``read``.
        """
        number = self._find_array(array)
        if self.arrays[number].is_cell:
            raise ValueError(f"array {self.arrays[number].key!r} is one of cells, and has no isosurface")
        sorted_values = np.unique(np.asarray(values, float))
        if not (sorted_values.size and np.isfinite(sorted_values).all()):
            raise ValueError("values: have to be finite numbers")
        part = {"step": step, "time": time, "piece": piece, "pieces": pieces, "ratio": ratio, "level": level}
        request = self._make_request({**part, "arrays": arrays})
        contour = _c.Contour(
            array=number,
            component=self._find_component(number, component),
            values=sorted_values.ctypes.data_as(ctypes.POINTER(ctypes.c_double)),
            value_count=sorted_values.size,
            normals=bool(normals),
        )
        return read_piece(
            self,
            self._handle,
            request,
            library.gatun_prepare_contour,
            (ctypes.byref(request.structure), ctypes.byref(contour)),
            {"normals": normals, "surface": True},
            allocate,
            progress,
        )

    def slice(
        self,
        origin: Sequence[float],
        normal: Sequence[float],
        *,
        step: int | None = None,
        time: float | None = None,
        arrays: Names | Iterable[int] | None = None,
        piece: int = 0,
        pieces: int = 1,
        ratio: float = 0.0,
        level: int = 0,
        allocate: Allocate | None = None,
        progress: Progress | None = None,
    ) -> Grid:
        """Makes the section with a plane, of triangles. Only chunks at the plane are decoded.

        Args:
            origin: a point of the plane.
            normal: the direction across it.
            step, time, arrays, piece, pieces, ratio, level, allocate, progress: as for ``read``.
        """
        part = {"step": step, "time": time, "piece": piece, "pieces": pieces, "ratio": ratio, "level": level}
        request = self._make_request({**part, "arrays": arrays, "plane": (origin, normal)})
        return read_piece(
            self,
            self._handle,
            request,
            library.gatun_prepare_slice,
            (ctypes.byref(request.structure),),
            {"surface": True},
            allocate,
            progress,
        )

    def render(
        self,
        *,
        size: Sequence[int] = (1024, 768),
        array: str | int | None = None,
        component: int | None = None,
        step: int | None = None,
        time: float | None = None,
        colors: Any = None,
        opacity: Any = 1.0,
        range: Sequence[float] | None = None,  # pylint: disable=redefined-builtin
        unit_distance: float | None = None,
        shade: bool = False,
        blend: str = "composite",
        ratio: float = 0.0,
        level: int = 0,
        background: str | Sequence[float] | None = None,
        azimuth: float = 30.0,
        elevation: float = 20.0,
        roll: float = 0.0,
        zoom: float = 1.0,
        direction: Sequence[float] | None = None,
        up: Sequence[float] | None = None,
        parallel: bool = False,
        camera: Any = None,
        dtype: DTypeLike = np.uint8,
        progress: Progress | None = None,
    ) -> np.ndarray:
        """Draws the mesh as a volume into an image.

        Args:
            size: width and height of the image in pixels, 1 to 32768 each.
            array: name or number of the array to draw. Default: the active scalars, or else the first.
            component: of the array, from 0; -1 for the length of the tuples, the default.
            step, time, ratio, level, progress: as for ``read``.
            colors: the name of a color map of Matplotlib or a function like it, or a list of colors,
                spread over ``range``; or a vtkColorTransferFunction. Default: one from dark to light.
            opacity: a factor for the default opacities; opacities from 0 to 1, spread over ``range``;
                pairs of values and opacities; a function of the value; or a vtkPiecewiseFunction. By
                default, values that fill most of the volume are nearly transparent, and rare ones are
                opaque.
            range: smallest and largest value of ``colors`` and ``opacity``, also of the default ones. Default:
                those of the array over all time steps; without time steps, a few outliers are left out of
                default opacities and the colors with them.
            unit_distance: the length that opacities refer to, in units of the coordinates. Default: 1/100
                of the diagonal of the bounds.
            shade: whether a light at the camera shades surfaces of equal values.
            blend: ``"composite"``, ``"mip"`` (maximum intensity) or ``"xray"``.
            background: red, green and blue from 0 to 1, ``"#RRGGBB"``, ``"black"`` or ``"white"``. Default:
                none, so that the image is transparent.
            azimuth, elevation: angles of the camera in degrees, from the z axis about the y axis, and up.
            roll: of the camera, in degrees.
            zoom: magnification; with 1, everything just fits into the image.
            direction, up: a direction to look along in place of the angles, and one that points up.
            parallel: whether the projection is parallel.
            camera: a vtkCamera in place of all of this.
            dtype: ``numpy.uint8``, or ``numpy.float32`` for values from 0 to 1.

        Returns:
            An array of height x width x 4: red, green, blue and opacity, the top row first. Colors are not
            multiplied by the opacity.
        """
        check_type(dtype)
        color = None if background is None else parse_color(background)
        number = self._find_array(self._choose_array() if array is None else array)
        chosen = self._find_component(number, component)
        index = self.find_step(step, time)
        view = {"azimuth": azimuth, "elevation": elevation, "roll": roll, "zoom": zoom}
        view.update(direction=direction, up=up, parallel=parallel, camera=camera)
        transfer = {"colors": colors, "opacity": opacity, "range": range, "blend": blend}
        transfer.update(unit_distance=unit_distance, shade=shade)
        pixels = draw_mesh(
            self, self._handle, size, (number, chosen, index, ratio, level), view, transfer, progress
        )
        return finish_image(pixels, color, dtype)

    def _choose_array(self):
        """The number of the active scalars, or else of the first array."""
        found = [i for i, array in enumerate(self.arrays) if array.roles & 1]
        found += [i for i, array in enumerate(self.arrays) if not array.name.startswith("vtk")]
        if not found or self._info.steps == 0:
            raise ValueError(f"{self.file_name}: has no array to draw")
        return found[0]

    def verify(self, progress: Progress | None = None) -> None:
        """Checks all checksums, and decodes everything.

        Args:
            progress: as for ``read``.

        Raises:
            Error: the file is damaged.
        """
        self._handle.call(library.gatun_verify, progress=progress)
