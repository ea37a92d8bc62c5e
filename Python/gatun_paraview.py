# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Plugin for any ParaView: reads and writes .gtn files, and reads .ghv files.

Tools > Manage Plugins > Load New..., or ``paraview.simple.LoadPlugin("gatun_paraview.py", ns=globals())``. It needs
the package gatun beside it, or where Python finds packages, and nothing of the plugin that is compiled for one
ParaView. Where that one is loaded, this one adds nothing.
"""

import os
import sys
import weakref

from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smproperty, smproxy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkDataArraySelection, vtkLogger, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

try:
    import gatun
except ImportError:
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
try:
    import gatun
    from gatun import _paraview_xml as xml
    from gatun._paraview_files import find_entry, list_files, merge_times
    from gatun._ranks import GatheredSeries, Ranks, pause_collection
    from gatun._vtk_mesh import read_mesh
except ImportError as error:  # of which ParaView 5 would say that there is no module imp
    raise RuntimeError(f"{__file__}: the package gatun, which belongs beside this file: {error}") from None

paraview_plugin_version = gatun.__version__


# ------------------------------------------------------------------------------
# What readers and writer have in common


# Results of a request, the worst first.
_FAILED, _ABORTED, _DONE = range(3)


class _ReportedError(Exception):
    """A failure that follows from one before."""


def _make_setter(name):
    """A method that sets the member of a name, and tells if it has changed."""

    def set_value(self, *values):
        value = values[0] if len(values) == 1 else values
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.Modified()

    return set_value


def _describe(error):
    known = (gatun.Error, OSError, ValueError, TypeError, MemoryError)
    text = str(error) if isinstance(error, known) else f"{type(error).__name__}: {error}"
    if isinstance(error, OSError) and error.filename is not None:
        text = f"{error.filename}: {error.strerror}"
    return text


def _report(text):
    """Shows why something has failed as filters in C++ do. The client of a server sees it if the first process calls
    this."""
    vtkOutputWindow.GetInstance().DisplayErrorText(f"ERROR: Gatun: {text}\n")


def _get_stamp(path):
    """What changes when a file is replaced."""
    status = os.stat(path)
    return path, status.st_ino, status.st_size, status.st_mtime_ns


class _Reader(VTKPythonAlgorithmBase):
    """A reader that fails on all processes, or on none: a filter behind it that lets them exchange data would wait
    for those that have failed.

    Attributes:
        has_failed: whether the last request has failed.
    """

    def __init__(self, output_type, kind):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=output_type)
        self.has_failed = False
        self._kind = kind
        self._budget = 512
        self._file = None
        self._stamp = None

    def _open(self, path):
        """The open file of a path, which may have been replaced."""
        stamp = (*_get_stamp(path), self._budget)
        if self._stamp != stamp:
            self._file = self._stamp = None
            self._file = gatun.open(path, cache_bytes=max(self._budget << 20, 1))
            self._stamp = stamp
        if not isinstance(self._file, self._kind):
            raise gatun.Error(f"{path}: is not a file of a {'mesh' if self._kind is gatun.File else 'volume'}")
        return self._file

    def _run(self, work, out_info):
        """Calls a function. Returns 1, or 0 if it fails on any process."""
        info = out_info.GetInformationObject(0)
        result, text = _DONE, ""
        try:
            work(info)
        except Exception as error:  # pylint: disable=broad-except
            result, text = self._fail(error)
        result, text = self._agree(result, text)
        if text:
            _report(text)
        output = info.Get(vtkDataObject.DATA_OBJECT())
        self.has_failed = result == _FAILED or bool(text)
        if self.has_failed and output:
            # Up to date, though empty: without data, a server does not send what its client waits for.
            output.Initialize()
        elif result == _ABORTED and output:
            # The next update starts anew.
            output.ReleaseData()
            info.Set(Pipeline.DATA_NOT_GENERATED(), 1)
        return int(result != _FAILED)

    def _fail(self, error):
        """The result of a request after an error, and what to report."""
        if getattr(error, "name", "") == "AbortedError":
            return _ABORTED, ""
        self._file = self._stamp = None
        return _FAILED, "" if isinstance(error, _ReportedError) else _describe(error)

    def _agree(self, result, text):
        """The worst result of all processes, and what this one reports: the first one may get its text from another."""
        ranks = Ranks()
        result = ranks.find_least(result)
        return result, ranks.find_text(text) if result == _FAILED else text

    @pause_collection()
    def RequestInformation(self, _request, _in_info, out_info):
        return self._run(self._inform, out_info)

    @pause_collection()
    def RequestData(self, _request, _in_info, out_info):
        return self._run(self._read, out_info)

    def _progress(self, fraction):
        self.UpdateProgress(fraction)
        return not self.CheckAbort()


def _set_times(info, times):
    info.Remove(Pipeline.TIME_STEPS())
    info.Remove(Pipeline.TIME_RANGE())
    if times:
        info.Set(Pipeline.TIME_STEPS(), times, len(times))
        info.Set(Pipeline.TIME_RANGE(), [times[0], times[-1]], 2)


def _get(info, key, default):
    return info.Get(key) if info.Has(key) else default


# ------------------------------------------------------------------------------
# Meshes


def _make_selection(reader):
    """Check boxes of arrays, whose changes modify a reader."""
    selection = vtkDataArraySelection()
    owner = weakref.ref(reader)

    def tell(*_):
        if owner():
            owner().Modified()

    selection.AddObserver("ModifiedEvent", tell)
    return selection


def _get_label(array):
    """The name of an array as a text of VTK."""
    return array.name.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def _list_arrays(selection, names):
    """Gives a selection the arrays of a file. New ones are selected."""
    for i in reversed(range(selection.GetNumberOfArrays())):
        if selection.GetArrayName(i) not in names:
            selection.RemoveArrayByIndex(i)
    for name in names:
        if not selection.ArrayExists(name):
            selection.AddArray(name)


@smproxy.reader(
    name="GatunReader",
    label="Gatun Reader",
    extensions="gtn gtn.series",
    file_description="Gatun mesh",
    support_reload=False,
)
@smproperty.xml(xml.READER)
class GatunReader(_Reader):
    """Reads meshes and surfaces, single files or series."""

    def __init__(self):
        super().__init__("vtkPointSet", gatun.File)
        self._paths = []
        self._series = []
        self._restores_order = 1
        self._splits_cells = 0
        self._has_ids = 0
        self._ratio = 0.0
        self._level = 0
        self._large_mesh = 5000000
        self._is_on_demand = 0
        self._box = (1, -1, 1, -1, 1, -1)
        self._range_array = ""
        self._range = (0, 1)
        self._is_exact = 0
        self._selections = {is_cell: _make_selection(self) for is_cell in (False, True)}

    SetRestoreOrder = _make_setter("_restores_order")
    SetSplitCells = _make_setter("_splits_cells")
    SetGenerateGlobalIds = _make_setter("_has_ids")
    SetMemoryBudget = _make_setter("_budget")
    SetSimplificationRatio = _make_setter("_ratio")
    SetLevel = _make_setter("_level")
    SetLargeMesh = _make_setter("_large_mesh")
    SetBox = _make_setter("_box")
    SetValueRangeArray = _make_setter("_range_array")
    SetValueRange = _make_setter("_range")
    SetExactRegion = _make_setter("_is_exact")

    def AddFileName(self, path):
        self._paths.append(path)
        self.Modified()

    def RemoveAllFileNames(self):
        self._paths.clear()
        self.Modified()

    def GetPointDataArraySelection(self):
        return self._selections[False]

    def GetCellDataArraySelection(self):
        return self._selections[True]

    def GetHasHierarchy(self):
        return int(self._file is not None and self._file.info["hasHierarchy"])

    def GetIsOnDemand(self):
        return self._is_on_demand

    @pause_collection()
    def RequestDataObject(self, _request, _in_info, out_info):
        kind = vtkUnstructuredGrid
        try:
            paths, _ = list_files(self._paths)
            kind = vtkPolyData if self._open(paths[0]).is_surface else kind
        except Exception:  # pylint: disable=broad-except
            pass  # RequestInformation reports it
        if not isinstance(vtkDataObject.GetData(out_info, 0), kind):
            out_info.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), kind())
        return 1

    def _inform(self, info):
        # First, as without it only the first process would be asked for data, and would wait for the others.
        info.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        self._series = []
        _set_times(info, [])
        paths, times = list_files(self._paths)
        first = self._open(paths[0])
        self._series = merge_times(paths, times, lambda path: self._open(path).times)
        first = self._open(paths[0])
        for is_cell, selection in self._selections.items():
            _list_arrays(selection, [_get_label(a) for a in first.arrays if a.name and a.is_cell == is_cell])
        _set_times(info, [entry.time for entry in self._series if entry.time is not None])

    def _choose_arrays(self, file):
        """The numbers of the arrays to read. One without a name has no check box."""
        return [
            number
            for number, array in enumerate(file.arrays)
            if not array.name or self._selections[array.is_cell].GetArraySetting(_get_label(array))
        ]

    def _choose_region(self):
        low_above_high = any(low > high for low, high in zip(self._box[::2], self._box[1::2]))
        box = None if low_above_high else self._box
        values = (self._range_array, *self._range) if self._range_array else None
        return {"box": box, "values": values, "exact": bool(self._is_exact and (box or values))}

    def _shows_boundary(self, file, region):
        """Whether the mesh is too large to read it in full."""
        if self._large_mesh < 0 or file.info["boundary"] is None or region["box"] or region["values"]:
            return False
        size = file.info["cells" if file.is_surface else "tets"]
        if self._level:
            size = file.levels[self._level - 1].cells
        return size * (1 - self._ratio) > self._large_mesh

    def _read(self, info):
        if not self._series:
            raise _ReportedError
        time = _get(info, Pipeline.UPDATE_TIME_STEP(), None)
        entry = find_entry(self._series, time)
        file = self._open(entry.path)
        if self._level > len(file.levels):
            raise gatun.Error(f"{entry.path}: has {len(file.levels)} coarser meshes, and no level {self._level}")
        region = self._choose_region()
        self._is_on_demand = int(self._shows_boundary(file, region))
        options = {
            "step": entry.step,
            "arrays": self._choose_arrays(file),
            "piece": _get(info, Pipeline.UPDATE_PIECE_NUMBER(), 0),
            "pieces": max(_get(info, Pipeline.UPDATE_NUMBER_OF_PIECES(), 1), 1),
            "ghost_levels": max(_get(info, Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0), 0),
            "ratio": self._ratio,
            "level": self._level,
            "boundary": bool(self._is_on_demand),
            "tetrahedra": bool(self._splits_cells),
            "restore_order": bool(self._restores_order),
            "ids": bool(self._has_ids),
            **region,
        }
        try:
            mesh = read_mesh(file, progress=self._progress, **options)
        except ValueError as error:
            if str(error).startswith(entry.path):
                raise
            raise ValueError(f"{entry.path}: {error}") from None
        self._give(mesh, info, entry)

    @staticmethod
    def _give(mesh, info, entry):
        """Makes a mesh the output."""
        output = info.Get(vtkDataObject.DATA_OBJECT())
        if not isinstance(mesh, type(output)):
            raise gatun.Error(f"{entry.path}: is a {mesh.GetClassName()}, and the first file is a {output.GetClassName()}")
        output.ShallowCopy(mesh)
        if entry.time is not None:
            output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), entry.time)


# ------------------------------------------------------------------------------
# Volumes


@smproxy.reader(
    name="GatunHartleyReader",
    label="Gatun Hartley Reader",
    extensions="ghv",
    file_description="Hartley volume",
    support_reload=False,
)
@smproperty.xml(xml.VOLUME_READER)
class GatunHartleyReader(_Reader):
    """Reads volumes."""

    def __init__(self):
        super().__init__("vtkImageData", gatun.Volume)
        self._path = ""

    SetFileName = _make_setter("_path")

    def _agree(self, result, text):
        # Processes without voxels are not asked for data, and cannot agree. One that fails has no voxels, either.
        return result if Ranks().count == 1 else max(result, _ABORTED), text

    def _inform(self, info):
        volume = self._open(self._path)
        size = volume.shape[::-1]
        ends = [(low, low + count - 1) for low, count in zip(volume.first_index, size)]
        info.Set(Pipeline.WHOLE_EXTENT(), [end for pair in ends for end in pair], 6)
        info.Set(vtkDataObject.ORIGIN(), volume.origin, 3)
        info.Set(vtkDataObject.SPACING(), volume.spacing, 3)
        info.Set(vtkDataObject.DIRECTION(), volume.direction.ravel(), 9)
        info.Set(vtkAlgorithm.CAN_PRODUCE_SUB_EXTENT(), 1)

    def _read(self, info):
        volume = self._open(self._path)
        extent = info.Get(Pipeline.UPDATE_EXTENT())
        output = info.Get(vtkDataObject.DATA_OBJECT())
        output.SetExtent(extent)
        output.SetOrigin(volume.origin)
        output.SetSpacing(volume.spacing)
        output.SetDirectionMatrix(volume.direction.ravel())
        if output.GetNumberOfPoints() == 0:
            return
        first = [low - start for low, start in zip(extent[::2], volume.first_index)]
        end = [high + 1 - start for high, start in zip(extent[1::2], volume.first_index)]
        values = numpy_to_vtk(volume.read(first, end, progress=self._progress).ravel(), deep=1)
        values.SetName(volume.name)
        output.GetPointData().SetScalars(values)


# ------------------------------------------------------------------------------
# Writing

_ORDERS = {1: "points", 2: "cells", 4: "corners"}


@smproxy.writer(
    name="GatunWriter",
    label="Gatun Writer",
    extensions="gtn",
    file_description="Gatun mesh or surface",
    supports_parallel="1",
    support_reload=False,
)
@smproperty.xml(xml.WRITER)
class GatunWriter(VTKPythonAlgorithmBase):
    """Writes a mesh or a surface, of all processes to one file."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=0, inputType="vtkPointSet")
        self._path = ""
        self._order = 0
        self._chunk_size = 0
        self._has_hierarchy = 0
        self._levels = 0
        self._has_boundary = 0
        self._layer_array = "(none)"
        self._layers = 0
        self._writes_all_steps = 0
        self._key_step_interval = 8
        self._point_tolerance = ""
        self._tolerances = []
        self._fills = 0
        self._profile = 1

    SetFileName = _make_setter("_path")
    SetKeepOrder = _make_setter("_order")
    SetChunkSize = _make_setter("_chunk_size")
    SetHierarchy = _make_setter("_has_hierarchy")
    SetLevels = _make_setter("_levels")
    SetWriteBoundary = _make_setter("_has_boundary")
    SetLayerArray = _make_setter("_layer_array")
    SetNumberOfLayers = _make_setter("_layers")
    SetWriteAllTimeSteps = _make_setter("_writes_all_steps")
    SetKeyStepInterval = _make_setter("_key_step_interval")
    SetPointTolerance = _make_setter("_point_tolerance")
    SetFillMissingArrays = _make_setter("_fills")
    SetProfile = _make_setter("_profile")

    def AddArrayTolerance(self, text):
        if text:
            self._tolerances.append(text)
        self.Modified()

    def ClearArrayTolerances(self):
        self._tolerances.clear()
        self.Modified()

    def _list_options(self):
        """The parameters of ``gatun.write``."""
        options = {
            "keep_order": [name for flag, name in _ORDERS.items() if self._order & flag] or "none",
            "chunk_size": self._chunk_size,
            "hierarchy": bool(self._has_hierarchy),
            "levels": self._levels if self._has_hierarchy else 0,
            "boundary": bool(self._has_boundary),
            "key_step_interval": self._key_step_interval,
            "profile": "fast" if self._profile else "small",
            "tolerances": self._parse_tolerances(),
            "point_tolerance": self._point_tolerance or None,
            "fill_missing": bool(self._fills),
        }
        if self._layer_array not in ("", "(none)"):
            options["layers"] = (self._layer_array, self._layers)
        return options

    def _parse_tolerances(self):
        pairs = [text.rpartition("=") for text in self._tolerances]
        for text, (name, _, bound) in zip(self._tolerances, pairs):
            if not (name and bound):
                raise ValueError(f"Array Tolerances: {text!r} has to be a name, '=' and a bound, as pressure=rel:1e-3")
        return {name: bound for name, _, bound in pairs}

    @pause_collection()
    def Write(self):
        """Writes the file. Returns 1, or 0 if it fails on any process."""
        series = GatheredSeries(self.GetInputConnection(0, 0), self._writes_all_steps)
        is_done = True
        try:
            series.run(self._write)
        except Exception as error:  # pylint: disable=broad-except
            is_done = False
            _report(_describe(error))
        return Ranks().find_least(int(is_done))

    def _write(self, series):
        """Writes meshes on the first process."""
        if not self._path:
            raise gatun.Error("no file name was set")
        options = self._list_options()
        if series.times is None:
            gatun.write(series[0], self._path, overwrite=True, **options)
        else:
            gatun.write(series, self._path, overwrite=True, times=series.times, **options)


# ------------------------------------------------------------------------------


def _has_compiled_plugin():
    """Whether this process has the compiled plugin, whose reader is for the same files."""
    plugins = vtkPVPluginTracker.GetInstance()
    return any(
        plugins.GetPluginName(i) == "Gatun" and plugins.GetPluginLoaded(i)
        for i in range(plugins.GetNumberOfPlugins())
    )


if _has_compiled_plugin():
    vtkLogger.Log(vtkLogger.VERBOSITY_INFO, __file__, 0, "adds nothing, as the plugin Gatun is loaded")
    del GatunReader, GatunHartleyReader, GatunWriter

    # A file that adds nothing at all is no plugin for ParaView 6.1. Nothing shows this group.
    @smproxy.source(name="GatunPlaceholder", group="internal_gatun", support_reload=False)
    class _Placeholder(VTKPythonAlgorithmBase):
        pass
