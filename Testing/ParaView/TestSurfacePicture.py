# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The surface of a .gtn file, colored by a point array, looks the same on any number of ranks."""

import gatunSample as sample
from gatunParaView import load_plugin
from gatunSurfacePicture import compare_picture
from paraview import smtesting

smtesting.ProcessCommandLineArguments()
simple = load_plugin()
path = sample.temporary("picture.gtn")
simple.SaveData(path, proxy=sample.make_source(), ChunkSize=300)
reader = simple.OpenDataFile(path)
reader.UpdatePipeline()
compare_picture(reader)
