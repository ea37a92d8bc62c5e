# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The scripts of the user guide for ParaView run, with the commands that the guide gives. Program names of its
commands are found in PATH. Usage: python TestGuide.py PVBATCH MPIEXEC"""

import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Python"))
import gatunGuide as guide  # pylint: disable=wrong-import-position

# Without gtn, which another build makes, ParaView itself writes the file that the scripts open.
MAKE = """
import os
from paraview import simple
simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))
simple.SaveData("mesh.gtn", proxy=simple.XMLUnstructuredGridReader(FileName=["mesh.vtu"]))
"""
PROGRAMS = ("pvbatch", "mpiexec")


def main(*programs):
    folder = pathlib.Path(os.environ["GATUN_TEST_TEMP"]) / "guide-paraview"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "bin").mkdir(parents=True)
    for name, program in zip(PROGRAMS, programs):
        # ParaView finds its modules beside the file, not beside a link.
        script = folder / "bin" / name
        script.write_text(f'#!/bin/sh\nexec "{program}" "$@"\n', encoding="ascii")
        script.chmod(0o755)
    around = dict(os.environ, PATH=f"{folder / 'bin'}:{os.environ['PATH']}")
    (folder / "make.py").write_text(MAKE, encoding="ascii")
    samples = str(guide.ROOT / guide.SAMPLES)
    subprocess.run(["pvbatch", samples, str(folder), "6"], env=around, check=True)
    subprocess.run(["pvbatch", "make.py"], cwd=folder, env=around, check=True)
    failed, ran = [], 0
    for page in guide.pages():
        blocks = guide.blocks_of(page)
        if not any(block.is_for_paraview() for block in blocks):
            continue
        for block in blocks:
            if block.is_for_paraview():
                good = guide.run_python(block, folder, {})
            elif block.language == "sh" and "pvbatch" in block.text:
                good = guide.run_shell(block, folder, around) is not None
                ran += 1
            else:
                continue
            if not good:
                failed.append(block.place)
    for name in ("volume.png", "surface.gtn"):
        if not (folder / name).exists():
            failed.append(f"{name} was not made")
    if failed or not ran:
        print("failed:", *failed)
    return 1 if failed or not ran else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
