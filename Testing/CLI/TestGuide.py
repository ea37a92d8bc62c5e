# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The commands and snippets of the user guide run, page by page, with the samples that it names. Messages of
VTK fail the test, too."""

import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Python"))
import gatunGuide as guide  # pylint: disable=wrong-import-position

from gatunCli import PROGRAM, enter_folder  # pylint: disable=wrong-import-position

# Commands for which something is missing here. They may be left out.
NEEDS = {"flow.cgns": lambda: pathlib.Path("flow.cgns").exists(),
         "pvbatch": lambda: False,  # paraview.TestGuide runs it
         "mpiexec": lambda: shutil.which("mpiexec") and has_mpi()}


def has_mpi():
    run = subprocess.run([sys.executable, "-c", "import mpi4py.MPI, vtkmodules.vtkParallelMPI"], check=False,
                         stderr=subprocess.DEVNULL)
    return run.returncode == 0


def environment():
    """That of a user: gtn and python3 are in the path."""
    os.makedirs("bin", exist_ok=True)
    for name, target in (("gtn", PROGRAM), ("python3", sys.executable)):
        os.symlink(target, os.path.join("bin", name))
    path = os.path.abspath("bin") + ":" + os.environ["PATH"]
    return dict(os.environ, PATH=path, PYTHONDONTWRITEBYTECODE="1")


def run_page(page, samples, around):
    folder = os.path.abspath(page.stem)
    shutil.copytree(samples, folder)
    before = os.getcwd()
    os.chdir(folder)
    names = {"__name__": "__main__"}
    good = True
    for block in guide.blocks_of(page):
        missing = [word for word, has in NEEDS.items() if word in block.text and not has()]
        if missing:
            print(f"{block.place}: left out without {missing}")
        elif block.language == "sh" and guide.SAMPLES in block.text:
            print(f"{block.place}: done before")
        elif block.language == "sh":
            good = guide.run_shell(block, folder, around) is not None and good
        elif block.is_for_paraview():
            pass  # paraview.TestGuide runs them
        elif block.language == "python":
            good = guide.run_python(block, folder, names) and good
        elif block.language == "cpp":
            good = guide.is_in_examples(block) and good
        elif block.language != "text":
            print(f"{block.place}: nothing runs {block.language!r}")
            good = False
    os.chdir(before)
    return good


def main():
    enter_folder("guide")
    around = environment()
    subprocess.run([sys.executable, str(guide.ROOT / guide.SAMPLES), "samples", "6"], check=True)
    failed = [page.name for page in guide.pages() if not run_page(page, "samples", around)]
    if failed:
        print("failed:", *failed)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
