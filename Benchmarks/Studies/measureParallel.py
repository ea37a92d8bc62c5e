# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Parallel volume rendering in ParaView, 1024 by 1024 pixels: "Gatun Volume", which exchanges segments of
rays, beside ParaView's own "Volume", which redistributes the cells, and the filter that does so. Cells are
partitioned compactly, as the reader gives them, or scattered over the ranks at random.

Usage, with a display, where the plugin was built (pv-env.sh finds it):

  xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' Utilities/pv-env.sh \\
    python3 Benchmarks/Studies/measureParallel.py FILE.gtn [RANKS,RANKS,... [FOLDER FOR PICTURES]]
"""

import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
WAYS = (("Volume", "compact"), ("Volume", "scattered"),
        ("Gatun Volume", "compact"), ("Gatun Volume", "scattered"),
        ("Gatun Volume", "redistributed"), ("Gatun Volume", "on-demand"))


def measure(ranks, representation, partition, path, folder):
    picture = os.path.join(folder, "%s-%s-%d.png" % (
        representation.replace(" ", "-"), partition, ranks))
    launch = [] if ranks == 1 else ["mpiexec", "--oversubscribe", "-n", str(ranks)]
    done = subprocess.run(
        launch + ["pvbatch", os.path.join(HERE, "measureParallelOnce.py"),
                  representation, partition, path, picture],
        stdout=subprocess.PIPE, text=True, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("measured ")]
    return [float(word) for word in lines[-1].split()[1:]] if lines else None


def main(path, counts="1,2,4", folder=None):
    folder = folder or tempfile.mkdtemp()
    print("| ranks | representation | cells | seconds to the mesh | first image | later images "
          "| MiB sent for an image |")
    print("|---|---|---|---|---|---|---|")
    for ranks in map(int, counts.split(",")):
        for representation, partition in WAYS:
            taken = measure(ranks, representation, partition, os.path.abspath(path), folder)
            numbers = ("%.2f | %.2f | %.2f | %.2f" % (*taken[:3], taken[3] / 2**20)
                       if taken else "failed | | |")
            print("| %d | %s | %s | %s |" % (ranks, representation, partition, numbers))
            sys.stdout.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
