# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Memory and time that ParaView takes to show a .gtn file as a volume, 1024 by 1024 pixels, in each way
that there is: its own "Volume", "Gatun Volume" of the mesh in memory, and on demand. Each in processes
of their own, several times in turn; medians. Memory is the peak above that of a pvbatch with an
empty view.

Usage, with a display, where the plugin was built (pv-env.sh finds it):

  xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' Utilities/pv-env.sh \\
    python3 Testing/ParaView/measureVolume.py FILE.gtn [TIMES [FOLDER FOR PICTURES]]
"""

import os
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
WAYS = ("idle", "Volume", "Gatun Volume", "Gatun Volume, on demand",
        "Gatun Volume, on demand, keeping nothing")


def measure(way, path, folder):
    picture = os.path.join(folder, way.replace(", ", "-").replace(" ", "-") + ".png")
    environment = dict(os.environ)
    environment["PYTHONPATH"] = HERE + ":" + environment.get("PYTHONPATH", "")
    done = subprocess.run(
        ["pvbatch", os.path.join(HERE, "measureVolumeOnce.py"), way, path, picture],
        env=environment, stdout=subprocess.PIPE, text=True, check=True)
    line = next(line for line in done.stdout.splitlines() if line.startswith("measured "))
    return [float(word) for word in line.split()[1:]]


def main(path, times=3, folder=None):
    folder = folder or tempfile.mkdtemp()
    taken = {way: [] for way in WAYS}
    for _ in range(int(times)):
        for way in WAYS:
            taken[way].append(measure(way, os.path.abspath(path), folder))
    median = {way: [statistics.median(column) for column in zip(*runs)]
              for way, runs in taken.items()}
    print("| representation | MiB above idle | seconds to the first picture |")
    print("|---|---|---|")
    for way in WAYS[1:]:
        print("| %s | %.0f | %.1f |" % (way, median[way][0] - median["idle"][0], median[way][1]))


if __name__ == "__main__":
    main(*sys.argv[1:])
