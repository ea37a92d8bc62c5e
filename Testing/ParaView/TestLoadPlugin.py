# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The plugin loads on every rank, and its reader and writer can be made."""

import os

from gatunParaView import load_plugin, rank_and_ranks
from paraview import servermanager

simple = load_plugin()
assert rank_and_ranks() == (0, int(os.environ["GATUN_RANKS"])), rank_and_ranks()

reader = simple.GatunReader(FileNames=["some.gtn"])
assert reader.FileNames[0] == "some.gtn"
writer = servermanager.writers.GatunWriter(FileName="other.gtn")
assert writer.FileName == "other.gtn"

# Every rank has the library: a filter that runs everywhere counts those that mapped it.
count = simple.ProgrammableFilter(Input=simple.Sphere())
count.Script = """
with open("/proc/self/maps") as maps:
    loaded = any(line.rstrip().endswith("/Gatun.so") for line in maps)
output.ShallowCopy(inputs[0].VTKObject)
loads = vtk.vtkIntArray()
loads.SetName("loaded")
loads.InsertNextValue(int(loaded))
output.GetFieldData().AddArray(loads)
if not loaded:
    raise RuntimeError("the plugin is not loaded on this rank")
"""
count.UpdatePipeline()
assert count.FieldData["loaded"].GetRange(0) == (1, 1)
