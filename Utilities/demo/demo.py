# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Shows what Gatun does with a mesh: sizes, verification, pictures, all on one sheet.

    demo.py [--size small|full] [--output FOLDER] [FILE]

FILE is a mesh that `gtn pack` takes; without it, a machine part is made and put under load.
GATUN_TEST_GTN in the environment names the gtn program.
"""

import argparse
import os

import meshes
import steps
from report import Report


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--size", choices=sorted(meshes.SIZES), default="full")
    parser.add_argument("--output", default="gatun-demo")
    parser.add_argument("file", nargs="?")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    report = Report(os.path.abspath(options.output))

    if options.file:
        original = options.file
        title = os.path.basename(original)
    else:
        report.say("making the part")
        original = os.path.join(options.output, "part.vtu")
        title = "A machine part under load"
        meshes.write(meshes.make_part(options.size, report.say), original, "ZLib")

    demo = steps.Demo(report, original, is_part=not options.file)
    # Pieces enough for a picture.
    demo.pack("4096" if options.size == "small" else "16384" if options.file else "65536")
    demo.compare_sizes()
    demo.show_surface()
    demo.show_pieces()
    demo.render_volume()
    demo.contour()
    demo.simplify()
    demo.pack_surface()
    demo.bound_error()
    demo.project_scan()
    report.finish(f"{title}: {demo.cells:,} tetrahedra")


if __name__ == "__main__":
    main()
