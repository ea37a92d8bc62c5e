# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gatun_paraview.py reads and writes on any number of ranks without the compiled plugin. What one rank cannot
read fails on all, and none waits.

Argument: the folder of the golden files.
"""

import gc
import json
import os
import shutil
import sys

import gatunSample as sample
from gatunDealt import POINTS, describe, expected, make
from paraview import simple
from paraview.detail.pythonalgorithm import get_plugin_xmls
from vtkmodules.vtkCommonCore import vtkOutputWindow

import gatun

# Garbage that holds proxies must not be collected within a programmable source, when other ranks are busy.
gc.disable()
golden = sys.argv[1]
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
package = os.path.dirname(os.path.abspath(gatun.__file__))
plugin = os.path.join(os.path.dirname(package), "gatun_paraview.py")
simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
make_ghosts = getattr(simple, "GhostCells", None) or simple.GhostCellsGenerator  # its name before ParaView 6


def save_mesh(name, proxy, **options):
    """Saves a proxy as the only new file. Returns its path."""
    path = os.path.join(folder, name)
    before = set(os.listdir(folder))
    simple.SaveData(path, proxy=proxy, **options)
    assert set(os.listdir(folder)) == before | {name}, os.listdir(folder)
    return path


def open_as(kind, path, **options):
    reader = simple.OpenDataFile(path)
    assert type(reader).__name__ == "GatunReader", type(reader)
    for name, value in options.items():
        setattr(reader, name, value)
    reader.UpdatePipeline()
    assert reader.GetDataInformation().GetDataSetTypeAsString() == kind
    return reader


def open_mesh(path, **options):
    return open_as("vtkUnstructuredGrid", path, **options)


def list_names(proxy):
    """The arrays of points and cells, but those that tell pieces apart."""
    proxy.UpdatePipeline()
    hidden = {"vtkGhostType", "GlobalPointIds", "GlobalCellIds"}
    return set(proxy.PointData.keys()) - hidden, set(proxy.CellData.keys()) - hidden


# Programmable filters import names of NumPy into this module: save, copy, and a max that waits for all ranks.

# Cells of all ranks become one mesh, with or without a rank that has none.
for idle in (0, 1):
    reader = open_mesh(save_mesh(f"mixed{idle}.gtn", make("mixed", idle), ChunkSize=200))
    assert describe(reader) == expected("mixed") and sample.owned(reader) == (POINTS, len(expected("mixed")))
ghosts = make_ghosts(Input=reader)
again = open_mesh(save_mesh("ghosts.gtn", ghosts, Profile="Small"))
assert describe(again) == expected("mixed") and sample.owned(again)[0] == POINTS
assert list_names(again) == ({"wave", "moved"}, {"cell"}), list_names(again)

# All time steps, or the current one.
moving = make("mixed", 1, True)
reader = open_mesh(save_mesh("steps.gtn", moving, WriteAllTimeSteps=1))
assert list(reader.TimestepValues) == [0.5, 1.5, 4]
for time in (1.5, 4, 0.5):
    assert describe(reader, time) == expected("mixed", time), time
moving.UpdatePipeline(1.5)
assert describe(open_mesh(save_mesh("one.gtn", moving))) == expected("mixed", 1.5)

# What a writer can add, and what a reader can choose.
options = {"Hierarchy": 1, "WriteBoundary": 1, "LayerArray": "wave", "KeepOrder": "Points, Cells and Corners"}
path = save_mesh("whole.gtn", make("tets"), ChunkSize=100, **options)
assert describe(open_mesh(path)) == expected("tets")
assert abs(sample.volume(open_mesh(path)) - 6**3) < 1e-9
assert sample.owned(open_mesh(path, LargeMesh=0)) == (218, 432)
points, cells = sample.owned(open_mesh(path, SimplificationRatio=0.5))
assert points < POINTS * 0.6 and 0 < cells < 1296, (points, cells)
region = {"Box": [0.1, 1.9, 0.1, 1.9, 0.1, 1.9]}
touched, inside = (sample.owned(open_mesh(path, ExactRegion=exact, **region)) for exact in (0, 1))
assert inside == (27, 48) and 48 < touched[1], (inside, touched)
assert 0 < sample.owned(open_mesh(path, ValueRangeArray="wave", ValueRange=[2.5, 9]))[1] < 1296
assert list_names(open_mesh(path, PointArrays=["wave"], CellArrays=[])) == ({"wave"}, set())
tolerances = {"ArrayTolerances": ["wave=abs:0.01"], "PointTolerance": "abs:0.01"}
rounded = open_mesh(save_mesh("rounded.gtn", make("tets"), **tolerances))
assert sample.owned(rounded) == (POINTS, 1296) and describe(rounded) != expected("tets")
assert sample.owned(open_mesh(os.path.join(golden, "base_meshes.gtn"), Level=1)) == (87, 181)

# Surfaces, polyhedra and volumes.
surface = open_as("vtkPolyData", os.path.join(golden, "surface.gtn"))
second = open_as("vtkPolyData", save_mesh("surface.gtn", surface))
for proxy in (surface, second):
    assert sample.owned(proxy) == (60, 36) and list(proxy.TimestepValues)[:1] == [0], sample.owned(proxy)
shell = simple.ExtractSurface(Input=open_mesh(path))
second = open_as("vtkPolyData", save_mesh("shell.gtn", make_ghosts(Input=shell)))
assert sample.owned(second) == (218, 432) and list_names(second)[0] == {"wave", "moved"}, sample.owned(second)
polyhedra = open_mesh(os.path.join(golden, "polyhedra.gtn"))
second = open_mesh(save_mesh("polyhedra.gtn", polyhedra))
assert sample.owned(second) == sample.owned(polyhedra) == (80, 47) and list_names(second) == list_names(polyhedra)
faces = [sample.owned(simple.ExtractSurface(Input=proxy))[1] for proxy in (polyhedra, second)]
assert faces[0] == faces[1] > 47, faces
voxels = simple.OpenDataFile(os.path.join(golden, "small_volume.ghv"))
voxels.UpdatePipeline()
assert voxels.GetDataInformation().GetDataSetTypeAsString() == "vtkImageData"
assert voxels.PointData["sample"].GetRange(0) == (0, 39)

# A series of files.
files = [save_mesh(f"x_{i}.gtn", make("tets", 0, True), ChunkSize=200) for i in range(3)]
listed = os.path.join(folder, "x.gtn.series")
entries = [{"name": os.path.basename(file), "time": 10.0 * i} for i, file in enumerate(files)]
with open(listed, "w", encoding="utf-8") as file:
    json.dump({"file-series-version": "1.0", "files": entries}, file)
series = simple.OpenDataFile(listed)
series.UpdatePipeline()
assert list(series.TimestepValues) == [0, 10, 20], series.TimestepValues
series = simple.OpenDataFile([os.path.join(folder, "mixed0.gtn"), path])
series.UpdatePipeline()
assert list(series.TimestepValues) == [0, 1]
for time, kind in ((1, "tets"), (0, "mixed")):
    assert describe(series, time) == expected(kind), time

# Progress.
reader = simple.GatunReader(FileNames=[path])
reader.UpdatePipelineInformation()
fractions = []
algorithm = reader.GetClientSideObject()
algorithm.AddObserver("ProgressEvent", lambda *_: fractions.append(algorithm.GetProgress()))
assert sample.counts(reader)[1] >= 1296 and 0 <= sorted(fractions)[-1] <= 1

# Failures. Behind each reader is a filter that lets ranks exchange data.
def fails(proxy):
    return sample.counts(make_ghosts(Input=proxy)) == (0, 0)


def damage(path, second):
    with open(path, "rb") as file:
        data = bytearray(file.read())
    middle = len(data) * 6 // 10
    data[middle : middle + 20] = bytes(byte ^ 0x55 for byte in data[middle : middle + 20])
    with open(second, "wb") as file:
        file.write(data)


def keep_message(_window, _event, text):
    messages.append(text)


messages = []
keep_message.CallDataType = "string0"
vtkOutputWindow.GetInstance().AddObserver("ErrorEvent", keep_message)
bad = os.path.join(folder, "bad.gtn")
damage(os.path.join(folder, "mixed0.gtn"), bad)
reader = simple.GatunReader(FileNames=[bad])
assert fails(reader)
reader.UpdatePipeline()  # which has nothing to do: a server that fails again does not send what its client waits for
assert len([text for text in messages if bad in text and "damaged" in text]) == 1, messages  # even of another rank
assert fails(simple.GatunReader(FileNames=[os.path.join(folder, "none.gtn")]))
assert fails(simple.GatunReader(FileNames=[path], Level=9))
assert fails(simple.GatunReader(FileNames=[path], ValueRangeArray="none"))
assert not fails(simple.GatunReader(FileNames=[path]))
before = sorted(os.listdir(folder))
simple.SaveData(os.path.join(folder, "no", "x.gtn"), proxy=make("tets"))
simple.SaveData(os.path.join(folder, "x.gtn"), proxy=make("tets"), ArrayTolerances=["wave"])
simple.SaveData(os.path.join(folder, "x.gtn"), proxy=simple.GatunReader(FileNames=[bad]))
assert sorted(os.listdir(folder)) == before, os.listdir(folder)

# Where the compiled plugin is, this one adds nothing but a placeholder, without which it is no plugin for ParaView 6.1.
simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))
simple.LoadPlugin(shutil.copy(plugin, os.path.join(folder, "late.py")), remote=False, ns=vars(simple))
(placeholder,) = get_plugin_xmls(sys.modules["late"])
assert "GatunPlaceholder" in placeholder, placeholder
assert simple.GatunReader(FileNames=[path]).SMProxy.GetVTKClassName() == "vtkFileSeriesReader"
