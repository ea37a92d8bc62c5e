# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A file of meshes that the library writes."""

from __future__ import annotations

import ctypes

from . import _library as _c
from ._library import Call, check, encode, library
from ._meshes import StepInput, describe
from ._targets import check_bound, check_number, find_order, find_profile

_LAYERS_BY_HISTOGRAM = 3
_MOST_LAYERS = 4096


class Options:
    """The options of a file, as of ``gatun.write``."""

    def __init__(
        self,
        *,
        tolerances=None,
        profile="fast",
        keep_order="none",
        hierarchy=False,
        levels=0,
        dependencies=False,
        layers=None,
        boundary=False,
        chunk_size=0,
        key_step_interval=8,
    ):
        self._tolerances = {"*": tolerances} if isinstance(tolerances, str) else dict(tolerances or {})
        for name, bound in self._tolerances.items():
            if not isinstance(bound, str):
                raise ValueError(
                    f"tolerances: {bound!r} of {name!r} has to be a text such as 'rel:1e-3' or 'abs:0.1'"
                )
            check_bound("tolerances", bound, ("abs", "rel", "pw", "bits"))
        self._layers = (layers, 0) if layers is None or isinstance(layers, str) else layers
        check_number("layers", self._layers[1], 0, _MOST_LAYERS)
        if chunk_size != 0:
            check_number("chunk_size", chunk_size, 64, 1048576)
        self.has_hierarchy = bool(hierarchy or levels or dependencies)
        self.has_boundary = bool(boundary)
        self._structure = _c.Options(
            keep_order=find_order(keep_order),
            # The library counts from the fast one, and VTK from the small one.
            profile=1 - find_profile(profile),
            chunk_size=chunk_size,
            key_step_interval=check_number("key_step_interval", key_step_interval, 1, 2**31 - 1),
            boundary=self.has_boundary,
            hierarchy=self.has_hierarchy,
            levels=check_number("levels", levels, 0, 64),
            dependencies=bool(dependencies),
        )

    def describe(self, arrays, values=None):
        """Structures of arrays for the library, and what has to be kept with them.

        Args:
            arrays: their descriptions.
            values: those of the first step, for hierarchies and layers, or None.
        """
        descriptions = [describe(array) for array in arrays]
        names = {array.name for array in arrays}
        unknown = [name for name in self._tolerances if name != "*" and name not in names]
        if unknown:
            raise ValueError(f"tolerances: there is no array {unknown[0]!r}")
        for i, (array, own) in enumerate(zip(arrays, descriptions)):
            bound = self._tolerances.get(array.name) if array.name != "*" else None
            own.structure.error = bound and bound.encode()
            own.structure.values = None if values is None else values[i].ctypes.data
        structures = (_c.Array * len(descriptions))(*(own.structure for own in descriptions))
        return structures, descriptions

    def make(self, arrays, points_move=False, parts=0):
        """The structure of the library.

        Args:
            arrays: the descriptions of those of the file.
            points_move: whether each step has coordinates.
            parts: about how many there are.
        """
        made = _c.Options.from_buffer_copy(self._structure)
        made.points_move = bool(points_move)
        made.parts = parts
        everything = self._tolerances.get("*")
        made.error = everything and everything.encode()
        name, count = self._layers
        if name is not None:
            made.layers = _LAYERS_BY_HISTOGRAM
            made.layer_array = _find_layers(arrays, name)
            made.layer_component = 0 if arrays[made.layer_array].components == 1 else -1
            made.layer_count = count
        return made


def _find_layers(arrays, name):
    """The number of a point array."""
    for number, array in enumerate(arrays):
        if array.name == name and not array.is_cell:
            return number
    raise ValueError(f"layers: there is no point array {name!r}")


class Output:
    """A file that is being written. It appears with ``finish``.

    Args:
        path: of the file.
        options: of it.
    """

    def __init__(self, path, options):
        self._path = path
        self._options = options
        self._pointer = ctypes.c_void_p()
        self._kept = []  # what the library refers to until the end

    @property
    def is_open(self):
        """Whether it has been begun."""
        return bool(self._pointer)

    def create(self, mesh, arrays, values, points_move=False, progress=None):
        """Begins a file.

        Args:
            mesh: the first one, a CellInput.
            arrays: the descriptions of all arrays.
            values: their values at the first step, or None.
            points_move: whether each step has coordinates.
            progress: a function.
        """
        structures, descriptions = self._options.describe(arrays, values)
        options = self._options.make(arrays, points_move)
        self._kept += [mesh, structures, descriptions, values]
        call = Call(progress)
        status = library.gatun_create(
            encode(self._path),
            ctypes.byref(mesh.structure),
            structures,
            len(structures),
            ctypes.byref(options),
            *call.arguments,
            ctypes.byref(self._pointer),
        )
        call.check(status, self._path)

    def create_parts(self, arrays, parts):
        """Begins a file of a mesh in parts.

        Args:
            arrays: the descriptions of all arrays.
            parts: about how many there are.
        """
        structures, descriptions = self._options.describe(arrays)
        options = self._options.make(arrays, parts=parts)
        status = library.gatun_create_parts(
            encode(self._path), structures, len(structures), ctypes.byref(options), ctypes.byref(self._pointer)
        )
        check(status, self._path)
        del descriptions

    def append(self, arrays, points_move=False):
        """Begins to add steps to a file.

        Args:
            arrays: the descriptions of those of the file.
            points_move: whether each step has coordinates.
        """
        structures, descriptions = self._options.describe(arrays)
        options = self._options.make(arrays, points_move)
        status = library.gatun_append(
            encode(self._path), structures, len(structures), ctypes.byref(options), ctypes.byref(self._pointer)
        )
        check(status, self._path)
        del descriptions

    def add_mesh(self, mesh, values, progress=None):
        """Adds a mesh for the next steps. Returns its number.

        Args:
            mesh: a CellInput.
            values: of all arrays at its first step, or None.
            progress: a function.
        """
        number = ctypes.c_uint32()
        first = None if values is None else StepInput(values)
        self._kept += [mesh, values]
        self.call(
            library.gatun_add_mesh,
            ctypes.byref(mesh.structure),
            None if first is None else ctypes.byref(first.structure),
            progress=progress,
            tail=(ctypes.byref(number),),
        )
        return number.value

    def use_mesh(self, number):
        """Selects the mesh of the next steps: the last or the first one."""
        check(library.gatun_use_mesh(self._pointer, number), self._path)

    def survey_step(self, step):
        """Surveys a StepInput of a part."""
        check(library.gatun_survey_step(self._pointer, ctypes.byref(step.structure)), self._path)

    def write_step(self, step, progress=None):
        """Writes a StepInput."""
        self.call(library.gatun_write_step, ctypes.byref(step.structure), progress=progress)

    def call(self, function, *arguments, progress=None, tail=()):
        """Calls a function of the library with this file, and raises its failure."""
        call = Call(progress)
        call.check(function(self._pointer, *arguments, *call.arguments, *tail), self._path)

    def finish(self):
        """Completes the file. Returns its size in bytes."""
        pointer, self._pointer = self._pointer, ctypes.c_void_p()
        size = ctypes.c_uint64()
        try:
            check(library.gatun_finish(pointer, ctypes.byref(size)), self._path)
        finally:
            self._kept.clear()
        return size.value

    def discard(self):
        """Gives the file up. One that is there stays as it was."""
        pointer, self._pointer = self._pointer, ctypes.c_void_p()
        if pointer:
            library.gatun_discard(pointer)
        self._kept.clear()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.discard()

    def __del__(self):
        self.discard()
