# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The plugin loads on every rank, and its reader and writer can be made."""

import os

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
assert rank_and_ranks() == (0, int(os.environ["GATUN_RANKS"])), rank_and_ranks()

path = sample.temporary("load-plugin.gtn")
writer = simple.CreateWriter(path, sample.make_source())
assert writer.GetXMLName() == "GatunWriter"
writer.UpdatePipeline()
reader = simple.GatunReader(FileNames=[path])
assert reader.FileNames[0] == path

# Every rank has the library: a filter that runs on all of them looks for it.
look = simple.ProgrammableFilter(Input=simple.Sphere())
look.Script = """
output.ShallowCopy(inputs[0].VTKObject)
with open("/proc/self/maps") as maps:
    if "/Gatun.so" not in maps.read():
        raise RuntimeError("the plugin is not loaded on this rank")
"""
look.UpdatePipeline()
assert look.GetDataInformation().GetNumberOfPoints() > 0
