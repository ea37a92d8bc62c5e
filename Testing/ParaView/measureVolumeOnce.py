# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""For measureVolume.py, in a process of its own: draws a .gtn file as a volume in one way, and prints
the peak of the process's memory in MiB and the seconds from opening the file to the picture.

Usage: pvbatch measureVolumeOnce.py WAY FILE PICTURE
"""

import sys
import time

from gatunParaView import load_plugin

# How: the reader's LargeMesh, the representation, the memory budget of whichever has the mesh.
WAYS = {"idle": None,
        "Volume": (-1, "Volume", None),
        "Gatun Volume": (-1, "Gatun Volume", 512),
        "Gatun Volume, on demand": (0, "Gatun Volume", 512),
        "Gatun Volume, on demand, keeping nothing": (0, "Gatun Volume", 0)}

way, path, picture = sys.argv[1:4]
simple = load_plugin()
view = simple.CreateRenderView()
view.ViewSize = [1024, 1024]
view.OrientationAxesVisibility = 0
simple.Render(view)

seconds = 0
if WAYS[way]:
    large, representation, budget = WAYS[way]
    begin = time.time()
    reader = simple.GatunReader(FileNames=[path], LargeMesh=large)
    reader.UpdatePipeline()
    shown = simple.Show(reader, view)
    array = reader.PointData[0].GetName()
    shown.SetRepresentationType(representation)
    if budget is not None:
        shown.MemoryBudget = reader.MemoryBudget = budget
    simple.ColorBy(shown, ("POINTS", array))
    simple.ResetCamera(view)
    simple.Render(view)
    seconds = time.time() - begin

with open("/proc/self/status") as status:
    peak = next(line for line in status if line.startswith("VmHWM"))
if WAYS[way]:
    simple.SaveScreenshot(picture, view)
print("measured %.1f %.2f" % (int(peak.split()[1]) / 1024, seconds))
