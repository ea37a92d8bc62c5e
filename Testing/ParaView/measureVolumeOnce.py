# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""For measureVolume.py, in a process of its own: draws a .gtn file as a volume in one way, and prints
the peak of the process's memory in MiB and the seconds from opening the file to the picture.

Usage: pvbatch measureVolumeOnce.py WAY FILE PICTURE
"""

import sys
import time

from gatunParaView import load_plugin

# How: the reader's OnDemand, the representation.
WAYS = {"idle": None,
        "Volume": (0, "Volume"),
        "Gatun Volume": (0, "Gatun Volume"),
        "Gatun Volume, on demand": (1, "Gatun Volume")}

way, path, picture = sys.argv[1:4]
simple = load_plugin()
view = simple.CreateRenderView()
view.ViewSize = [1024, 1024]
view.OrientationAxesVisibility = 0
simple.Render(view)

seconds = 0
if WAYS[way]:
    begin = time.time()
    reader = simple.GatunReader(FileNames=[path], OnDemand=WAYS[way][0])
    reader.UpdatePipeline()
    shown = simple.Show(reader, view)
    array = reader.PointData[0].GetName()
    shown.SetRepresentationType(WAYS[way][1])
    simple.ColorBy(shown, ("POINTS", array))
    simple.ResetCamera(view)
    simple.Render(view)
    seconds = time.time() - begin

with open("/proc/self/status") as status:
    peak = next(line for line in status if line.startswith("VmHWM"))
if WAYS[way]:
    simple.SaveScreenshot(picture, view)
print("measured %.1f %.2f" % (int(peak.split()[1]) / 1024, seconds))
