# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What an image of VTK shows: data in memory, or files, with their bounds and the array to draw."""

import math

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._arrays import get_cell_lists
from ._classes import get_class
from ._errors import raising
from ._pixels import require_solid
from ._scene_input import Input
from ._volume import Volume

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

    def __init__(self, source, array, component):
        self.time = None
        self.algorithm = None
        self._open(source)
        self.bounds = self._find_bounds()
        if self.kind is vtkUnstructuredGrid:
            self._check_dimension()
        self._choose_array(array)
        self.component = self._choose_component(component)
        self.values = self._find_values()

    def _open(self, source):
        self._input = Input(source)
        self._data = self._input.data
        if self._input.algorithms or isinstance(source, (vtkAlgorithm, vtkAlgorithmOutput)):
            port = source if isinstance(source, vtkAlgorithmOutput) else source.GetOutputPort()
            producer = port.GetProducer()
            with raising(producer):
                producer.Update(port.GetIndex())
            self._data = producer.GetOutputDataObject(port.GetIndex())
        self.name = self._data.GetClassName()
        kinds = (vtkUnstructuredGrid, vtkPolyData, vtkImageData)
        self.kind = next((kind for kind in kinds if isinstance(self._data, kind)), None)
        if self.kind is None:
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
        if self._data.GetNumberOfCells() == 0:
            raise ValueError(f"{self.name}: has no cells to draw")
        bounds = list(self._data.GetBounds())
        if not all(map(math.isfinite, bounds)):
            raise ValueError(f"{self.name}: has no finite coordinates")
        return bounds

    def _check_dimension(self):
        """Raises ValueError for a grid without 3D cells, in which rays meet nothing."""
        counts = {}
        for numbers, _ in get_cell_lists(self._data):
            for number, count in zip(*np.unique(numbers, return_counts=True)):
                cell = vtkGenericCell.InstantiateCell(int(number))
                counts[cell.GetClassName(), cell.GetCellDimension()] = count
        require_solid(self.name, counts)

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
        if self.array is None:
            return (0.0, 1.0)
        return self._data.GetAttributes(self.association).GetArray(self.array).GetRange(self.component)


class FileScene(Scene):
    """The file of a surface or a volume, which stays where it is.

    Args:
        file: a File or a Volume.
        step, time: as for ``gatun.read``.
        array, component: as for ``gatun.render``.
    """

    def __init__(self, file, step, time, array, component):
        self._step, self._time = step, time
        super().__init__(file, array, component)

    def _open(self, source):
        self._file = source
        self.name = source.file_name
        is_volume = isinstance(source, Volume)
        self.kind = vtkImageData if is_volume else vtkPolyData
        if source.path is None:
            raise ValueError(f"{self.name}: surfaces and volumes are drawn from files on disk, or by what gatun.read makes")
        if is_volume and (self._step not in (None, 0, -1) or self._time is not None):
            raise ValueError(f"{self.name}: has no time steps")
        self.algorithm = reader = get_class("vtkGatunHartleyReader" if is_volume else "vtkGatunSurfaceReader")()
        reader.SetFileName(source.path)
        with raising(reader):
            reader.UpdateInformation()
        self._input = Input(reader)
        if is_volume:
            return
        number = source.find_step(self._step, self._time)
        self.time = source.times[number] if source.times else None
        reader.SetLargeMesh(0)

    def _find_bounds(self):
        if self.kind is vtkImageData:
            return self._file.bounds
        boxes = np.array([step.bounds for step in self._file.steps] or [self._file.info["bounds"]])
        low, high = boxes[:, ::2].min(axis=0), boxes[:, 1::2].max(axis=0)
        if not self._file.info["cells"] or not np.all(low <= high):
            raise ValueError(f"{self.name}: has no cells to draw")
        return np.column_stack([low, high]).ravel().tolist()

    def _choose_array(self, name):
        if self.kind is vtkPolyData:
            super()._choose_array(name)
        else:  # which has one
            self.array, self.association, self._components = None, None, 1

    def _list_arrays(self):
        return [
            (array.name, _CELLS if array.is_cell else _POINTS, array.components, bool(array.roles & 1))
            for array in self._file.arrays
            if array.name
        ]

    def _find_values(self):
        if self.kind is vtkImageData:
            return self._file.range
        return self._file.find_range(self.array, self.component) if self.array else (0.0, 1.0)
