# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What an image shows: files and data of VTK, with their bounds and the array to draw."""

import math
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._arrays import get_cell_lists
from ._classes import get_class
from ._errors import raising
from ._info import info as _info
from ._reading import choose_time, is_volume, open_reader
from ._scene_input import Input

_POINTS, _CELLS = 0, 1


class Scene:
    """A mesh, a surface or a volume.

    Attributes:
        name: of the file, or of the class of the data.
        kind: ``vtkUnstructuredGrid``, ``vtkPolyData`` or ``vtkImageData``.
        bounds: of all coordinates.
        array, association, component: what to draw; the array is None if a surface has none.
        values: the smallest and the largest value of the array.
        time: to request, or None.
    """

    def __init__(self, source, step, time, array, component):
        self.time = None
        self._table = None
        if isinstance(source, (str, bytes, os.PathLike)):
            self._open(source, step, time)
        else:
            if step is not None or time is not None:
                raise ValueError("step and time are for files")
            self._take(source)
        self.kind = next(
            kind
            for kind in (vtkUnstructuredGrid, vtkPolyData, vtkImageData)
            if isinstance(self._data, kind)
        )
        self.bounds = self._find_bounds()
        if self.kind is vtkUnstructuredGrid:
            self._check_dimension()
        self._choose_array(array)
        self.component = self._choose_component(component)
        self.values = self._find_values()

    # A file stays where it is: VTK is given its outline.
    def _open(self, path, step, time):
        self.name = os.fsdecode(path)
        self.algorithm = reader = open_reader(path)
        self._input = Input(reader)
        if is_volume(reader):
            if step not in (None, 0, -1) or time is not None:
                raise ValueError(f"{self.name}: has no time steps")
            self._data = reader.GetOutputDataObject(0)
            return
        self.time = choose_time(reader, step, time)
        reader.SetLargeMesh(0)
        with raising(reader):
            if self.time is None:
                reader.Update()
            else:
                reader.UpdateTimeStep(self.time)
            self._table = reader.GetChunkTable()
        self._data = reader.GetOutput()

    def _take(self, source):
        self.algorithm = None
        self._input = Input(source)
        self._data = self._input.data
        if self._input.algorithms or isinstance(source, (vtkAlgorithm, vtkAlgorithmOutput)):
            port = source if isinstance(source, vtkAlgorithmOutput) else source.GetOutputPort()
            producer = port.GetProducer()
            with raising(producer):
                producer.Update(port.GetIndex())
            self._data = producer.GetOutputDataObject(port.GetIndex())
        self.name = self._data.GetClassName()
        if not isinstance(self._data, (vtkUnstructuredGrid, vtkPolyData, vtkImageData)):
            raise TypeError(f"a {self.name} cannot be drawn")

    def connect(self, algorithm):
        """Makes this the input of a mapper or a filter."""
        self._input.connect(algorithm)

    def update(self, algorithm):
        """Updates an algorithm behind this."""
        with self.raising(algorithm):
            if self.time is None:
                algorithm.Update()
            else:
                algorithm.UpdateTimeStep(self.time)

    def make_defaults(self):
        """Returns what makes cameras and transfer functions for this."""
        defaults = get_class("vtkGatunDefaults")()
        self.connect(defaults)
        defaults.SetArrayName(self.array)
        defaults.SetArrayAssociation(-1 if self.association is None else self.association)
        defaults.SetArrayComponent(self.component)
        defaults.SetUseTime(self.time is not None)
        defaults.SetTime(self.time or 0.0)
        return defaults

    def raising(self, *consumers):
        """Turns errors of this and of what uses it into exceptions."""
        return raising(*filter(None, (self.algorithm,)), *consumers)

    def get_diagonal(self):
        """Returns the diagonal of the bounds, or 1 if that is 0."""
        return math.dist(self.bounds[::2], self.bounds[1::2]) or 1.0

    def _find_bounds(self):
        if self._table is not None:
            boxes = vtk_to_numpy(self._table.GetColumnByName("Bounds"))
            filled = boxes[boxes[:, 0] <= boxes[:, 1]]
            if not len(filled):
                raise ValueError(f"{self.name}: has no cells to draw")
            low, high = filled.min(axis=0), filled.max(axis=0)
            return [float((low, high)[i % 2][i]) for i in range(6)]
        if self.algorithm:
            return self._find_volume_bounds()
        if self._data.GetNumberOfCells() == 0:
            raise ValueError(f"{self.name}: has no cells to draw")
        bounds = list(self._data.GetBounds())
        if not all(map(math.isfinite, bounds)):
            raise ValueError(f"{self.name}: has no finite coordinates")
        return bounds

    def _check_dimension(self):
        """Raises ValueError for a grid without 3D cells, in which rays meet nothing."""
        if self._table is not None:
            types = _info(self.name).get("cellTypes", [])  # of tetrahedra alone, there are none
            counts = {(kind["name"], kind["dimension"]): kind["cells"] for kind in types}
        else:
            counts = {}
            for numbers, _ in get_cell_lists(self._data):
                for number, count in zip(*np.unique(numbers, return_counts=True)):
                    cell = vtkGenericCell.InstantiateCell(int(number))
                    counts[cell.GetClassName(), cell.GetCellDimension()] = count
        if counts and all(dimension < 3 for _, dimension in counts):
            there = ", ".join(f"{count} {name}" for (name, _), count in counts.items())
            raise ValueError(
                f"{self.name}: has no 3D cells, only {there}; vtkGeometryFilter makes a surface of 2D cells, "
                "which can be drawn"
            )

    def _find_volume_bounds(self):
        from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

        info = self.algorithm.GetOutputInformation(0)
        image = vtkImageData()
        image.SetExtent(info.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()))
        image.CopyInformationFromPipeline(info)
        return list(image.GetBounds())

    def _list_arrays(self):
        """Name, association, number of components and whether it is active, of all arrays."""
        found = []
        for association in (_POINTS, _CELLS):
            attributes = self._data.GetAttributes(association)
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetArray(i)
                if array is not None and array.GetName():
                    active = attributes.GetScalars() is array
                    found.append((array.GetName(), association, array.GetNumberOfComponents(), active))
        return found

    def _choose_array(self, name):
        """The named array, the active scalars, or the first array."""
        self.array = self.association = None
        self._components = 1
        if self.algorithm and is_volume(self.algorithm):
            return
        arrays = self._list_arrays()
        if name is None:
            # Ghost flags and the like are not what anybody wants to see.
            chosen = [a for a in arrays if a[3]] or [a for a in arrays if not a[0].startswith("vtk")]
        else:
            chosen = [a for a in arrays if a[0] == name]
        if chosen:
            self.array, self.association, self._components, _ = chosen[0]
        elif name is not None or self.kind is not vtkPolyData:
            there = ", ".join(repr(a[0]) for a in arrays) or "none"
            raise ValueError(
                f"{self.name}: has no array {'to draw' if name is None else repr(name)}; there are {there}"
            )

    def _choose_component(self, component):
        if self._components == 1 and component in (None, 0, -1):
            return 0
        component = -1 if component is None else component
        if not -1 <= component < self._components:
            raise ValueError(
                f"array {self.array!r} has no component {component}; they are numbered 0 to "
                f"{self._components - 1}, and -1 is the length"
            )
        return component

    def _find_values(self):
        if self.algorithm and is_volume(self.algorithm):
            values = [0.0, 0.0]
            self.algorithm.GetRange(values)
            return tuple(values)
        if self.array is None:
            return (0.0, 1.0)
        if self._table is None:
            array = self._data.GetAttributes(self.association).GetArray(self.array)
            return array.GetRange(self.component)
        kind = ("Point", "Cell")[self.association]
        ranges = vtk_to_numpy(self._table.GetColumnByName(f"{kind}:{self.array}"))
        # The range of the length is the last one.
        column = 2 * self.component if self.component >= 0 else ranges.shape[1] - 2
        return (float(ranges[:, column].min()), float(ranges[:, column + 1].max()))
