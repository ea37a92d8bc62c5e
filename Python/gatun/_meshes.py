# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes and their arrays for the library, with the memory that they refer to."""

from __future__ import annotations

import ctypes
import hashlib

import numpy as np

from . import _library as _c
from ._cells import as_points, join_corners, list_blocks
from ._description import KINDS_OF_DOUBLES
from ._numbers import as_numbers
from ._piece import to_buffer

_TETRA = 10
_KINDS_OF_TEXTS = (5, 8)  # of keys


def _address(array):
    return None if array is None else array.ctypes.data


def _as_ids(values, what, dtype=np.int64):
    """Integers as an array of a type."""
    array = np.asarray(values)
    if array.ndim != 1 or (array.size and array.dtype.kind not in "iu"):
        raise ValueError(f"{what}: has to be an array of integers with one dimension")
    return np.ascontiguousarray(array, dtype)


def _hash(*arrays):
    found = hashlib.blake2b(digest_size=16)
    for array in arrays:
        size = 0 if array is None else array.nbytes
        found.update(size.to_bytes(8, "little"))
        if size:
            found.update(memoryview(array).cast("B"))
    return found.digest()


class CellInput:
    """A mesh for the library.

    Args:
        points: n x 3.
        cells: as for ``gatun.from_numpy``; or else these:
        connectivity, offsets, types, faces, face_locations: as the members of ``gatun.Grid``.
        is_surface: whether cells are in the order of vtkPolyData.
        point_array: names and keys of the points, a ``gatun.Array``.
    """

    def __init__(
        self,
        points,
        cells=None,
        *,
        connectivity=None,
        offsets=None,
        types=None,
        faces=None,
        face_locations=None,
        is_surface=False,
        point_array=None,
    ):
        self.points = np.ascontiguousarray(as_points(points))
        self.sizes = []  # of the blocks of cells
        self._faces = self._face_locations = None
        if (cells is None) == (connectivity is None):
            raise ValueError("a mesh has either cells, or connectivity, offsets and types")
        if cells is not None:
            self._take_blocks(cells, is_surface)
        else:
            self._take_lists(connectivity, offsets, types)
            self._take_faces(faces, face_locations)
        self.structure = _c.Mesh(
            points=len(self.points),
            cells=self.count,
            coordinate_type=_c.TYPES[self.points.dtype.name],
            wide_ids=self._connectivity.dtype == np.int64,
            is_surface=bool(is_surface),
            coordinates=_address(self.points),
            connectivity=_address(self._connectivity),
            types=_address(self._types),
            offsets=_address(self._offsets),
            face_locations=_address(self._face_locations),
            faces=_address(self._faces),
            faces_size=0 if self._faces is None else self._faces.size,
        )
        if point_array is not None:
            self._point_array = describe(point_array)
            self.structure.point_array = ctypes.pointer(self._point_array.structure)

    def _take_blocks(self, cells, is_surface):
        blocks = list_blocks(cells)
        self.sizes = [len(corners) for _, corners in blocks]
        self.count = sum(self.sizes)
        ids, ends = join_corners([corners for _, corners in blocks], len(self.points))
        self._connectivity = ids
        self._types = self._offsets = None
        if is_surface or any(number != _TETRA for number, _ in blocks):
            self._offsets = ends
            self._types = np.concatenate(
                [np.empty(0, np.uint8)]
                + [np.full(len(corners), number, np.uint8) for number, corners in blocks]
            )

    def _take_lists(self, connectivity, offsets, types):
        if offsets is None or types is None:
            raise ValueError("connectivity: needs offsets and types")
        integer = np.int32 if np.asarray(connectivity).dtype == np.int32 else np.int64
        self._connectivity = _as_ids(connectivity, "connectivity", integer)
        self._offsets = _as_ids(offsets, "offsets", integer)
        kinds = types
        if getattr(types, "dtype", None) != np.uint8:
            kinds = _as_ids(types, "types")
        if kinds.size and not (kinds.min() >= 0 and kinds.max() <= 255):
            raise ValueError("types: are numbers from 0 to 255")
        self._types = np.ascontiguousarray(kinds, np.uint8)
        self.count = len(self._types)
        if len(self._offsets) != self.count + 1:
            raise ValueError(f"offsets: has {len(self._offsets)} numbers for {self.count} cells")
        if self._offsets[0] != 0 or self._offsets[-1] > len(self._connectivity):
            raise ValueError("offsets: begin at 0, and end in the connectivity")
        if np.any(self._offsets[1:] < self._offsets[:-1]):
            raise ValueError("offsets: have to ascend")

    def set_points(self, points):
        """Gives the mesh other coordinates, of the same type."""
        self.points = points
        self.structure.coordinates = _address(points)

    def has_form_of(self, other):
        """Whether another mesh has as many points and cells, of the same types of numbers."""
        names = ("points", "cells", "coordinate_type", "wide_ids")
        return all(getattr(self.structure, name) == getattr(other.structure, name) for name in names)

    def hash_cells(self):
        """A fingerprint of the cells."""
        return _hash(self._connectivity, self._offsets, self._types, self._face_locations, self._faces)

    def hash_points(self):
        """A fingerprint of the coordinates."""
        return _hash(self.points)

    def shares_memory(self, other):
        """Whether another mesh has its points or cells in the same place, where they have changed."""
        pairs = ((self.points, other.points), (self._connectivity, other._connectivity))
        return any(one.size and one.ctypes.data == two.ctypes.data for one, two in pairs)

    def _take_faces(self, faces, face_locations):
        if (faces is None) != (face_locations is None):
            raise ValueError("faces and face_locations come together")
        if faces is not None:
            self._faces = _as_ids(faces, "faces")
            self._face_locations = _as_ids(face_locations, "face_locations")
            if len(self._face_locations) != self.count:
                raise ValueError(f"face_locations: has not one number for each of {self.count} cells")


class _Description:
    """A description of an array for the library."""

    def __init__(self, array):
        what = f"array {array.name!r}"
        names = [_c.encode_text(name, what) for name in array.component_names]
        self._names = (ctypes.c_char_p * len(names))(*names) if names else None
        self._kept = []
        keys = [self._make_key(what, *key) for key in array.keys]
        self._keys = (_c.Key * len(keys))(*keys)
        self.structure = _c.Array(
            name=_c.encode_text(array.name, what),
            is_cell=array.is_cell,
            type=_c.TYPES.get(array.dtype.name, 0),  # 0 for field arrays of texts
            components=array.components,
            vtk_type=array.vtk_type,
            roles=array.roles,
            component_names=self._names,
            keys=self._keys,
            key_count=len(keys),
        )

    def _make_key(self, what, location, name, kind, values):
        key = _c.Key(
            location=_c.encode_text(location, what),
            name=_c.encode_text(name, what),
            kind=kind,
            count=len(values),
        )
        if kind in _KINDS_OF_TEXTS:
            key.texts = (ctypes.c_char_p * len(values))(*(_c.encode_text(v, what) for v in values))
            self._kept.append(key.texts)
        else:
            if kind in KINDS_OF_DOUBLES:
                bits = np.array(values, np.float64).view(np.uint64)
            else:
                bits = np.array([value % (1 << 64) for value in values], np.uint64)
            self._kept.append(bits)
            key.numbers = bits.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64))
        return key


def describe(array):
    """A ``gatun.Array`` for the library: an object whose member ``structure`` it is."""
    return _Description(array)


def take_values(values, what, count, like=None):
    """Values of an array of points or cells, one or a row for each.

    Args:
        values: the values.
        what: they are, for messages.
        count: the number of points or cells.
        like: the Array that they have to fit, if any.
    """
    array = as_numbers(values, what)
    if array.dtype.kind == "U":
        raise ValueError(f"{what}: arrays of texts are for field_data")
    if array.ndim == 0 or len(array) != count:
        there = len(array) if array.ndim else "no"
        raise ValueError(f"{what}: has {there} values for {count} of them")
    if like is not None:
        components = int(np.prod(array.shape[1:], dtype=int))
        if components != like.components:
            raise ValueError(f"{what}: has {components} components, and {like.components} before")
        if array.dtype != like.dtype:
            raise ValueError(f"{what}: is of {array.dtype}, and of {like.dtype} before")
    return np.ascontiguousarray(array)


class StepInput:
    """The values of a step for the library."""

    def __init__(self, arrays, fields=None, time=None, points=None, cells=None, dropped_to=None):
        self._kept = [arrays, fields, points, cells, dropped_to]
        self._buffers = (_c.Buffer * len(arrays))(*map(to_buffer, arrays))
        self.structure = _c.Values(
            arrays=self._buffers,
            array_count=len(arrays),
        )
        if fields is not None:
            self.structure.fields = fields.list
            self.structure.field_count = len(fields.list)
        if time is not None:
            self.structure.has_time = 1
            self.structure.time = time
        if points is not None:
            self._points = to_buffer(points)
            self.structure.coordinates = ctypes.pointer(self._points)
        if cells is not None:
            self._set_remaining("cell", cells)
        if dropped_to is not None:
            self.structure.drops_points = 1
            self._set_remaining("point", dropped_to)

    def _set_remaining(self, what, numbers):
        pointer = numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_uint64))
        setattr(self.structure, f"remaining_{what}s", pointer)
        setattr(self.structure, f"remaining_{what}_count", len(numbers))
