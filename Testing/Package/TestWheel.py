# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A wheel has what its tag and its record say, and works where it is installed, without VTK.

Arguments: the wheel.
"""

import base64
import hashlib
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "Utilities"))

import wheel  # noqa: E402  (in the folder just added)

PATH = pathlib.Path(sys.argv[1])
GOLDEN = ROOT / "Testing" / "Data" / "Golden"

# What is done with the installed package: VTK cannot be imported.
PROGRAM = """
import sys

class Finder:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("vtk", "vtkmodules", "meshio", "pyvista"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Finder())
import gatun
import numpy as np

golden, folder = sys.argv[1:]
assert gatun.__file__.startswith(sys.prefix), gatun.__file__
with gatun.open(golden + "/time_steps.gtn") as file:
    grids = [file.read(step=step) for step in range(len(file.times))]
    file.verify()
    with gatun.Writer(folder + "/copy.gtn", keep_order=True, arrays=file.arrays) as writer:
        first = grids[0]
        writer.add_mesh(first.points, connectivity=first.connectivity, offsets=first.offsets, types=first.types)
        for grid in grids:
            writer.write_step(point_data=grid.point_data, cell_data=grid.cell_data, time=grid.time)
    image = file.render(size=(80, 60), background="black")
    assert image.shape == (60, 80, 4) and image[..., :3].max() > 50
with gatun.open(folder + "/copy.gtn") as file:
    for step, grid in enumerate(grids):
        copy = file.read(step=step)
        assert copy.points.tobytes() == grid.points.tobytes()
        assert all(copy.point_data[key].tobytes() == values.tobytes() for key, values in grid.point_data.items())
with gatun.open(golden + "/lossless_volume.ghv") as volume:
    assert volume.read().shape == volume.shape
path = golden + "/time_steps.gtn"
grid = gatun.read(path, step=-1)
assert isinstance(grid, gatun.Grid) and grid.time == gatun.steps(path)[-1]
assert gatun.info(path)["points"] == len(grid.points) and gatun.render(path, size=(8, 6)).shape == (6, 8, 4)
assert gatun.slice(path, grid.points.mean(axis=0), (1, 0, 0)).is_surface
gatun.verify(path)
for call in (lambda: gatun.vtk, lambda: gatun.from_numpy, lambda: gatun.read(path, to="vtk"),
             lambda: gatun.render(golden + "/lossless_volume.ghv")):
    try:
        call()
    except ImportError as error:
        assert "VTK" in str(error), error
    else:
        raise AssertionError(call)
assert "read" in dir(gatun) and "open" in dir(gatun)
"""

# The same with VTK, and PyVista if it is there: its meshes are read, drawn and written.
WITH_VTK = """
import sys
import gatun
from vtkmodules.vtkCommonCore import vtkVersion

golden, folder = sys.argv[1:]
for name in ("time_steps", "polyhedra", "surface", "attributes", "names_and_keys", "names_and_keys"):
    path = f"{golden}/{name}.gtn"
    mesh = gatun.read(path)
    assert mesh.GetNumberOfCells() == gatun.info(path)["cells"] == len(gatun.read(path, to="numpy").types), name
    gatun.write(mesh, f"{folder}/{name}.gtn", overwrite=True)
    assert gatun.read(f"{folder}/{name}.gtn").GetNumberOfCells() == mesh.GetNumberOfCells()
assert gatun.read(golden + "/lossless_volume.ghv").IsA("vtkImageData")
assert gatun.render(golden + "/time_steps.gtn", size=(8, 6)).shape == (6, 8, 4)
try:
    gatun.vtk
except ImportError as error:
    assert "classes" in str(error), error
else:
    raise AssertionError("a wheel has no classes of VTK")
try:
    import pyvista
except ImportError:
    pyvista = None
if pyvista:
    grid = gatun.read(golden + "/time_steps.gtn", to="pyvista")
    assert isinstance(grid, pyvista.UnstructuredGrid)
    if tuple(map(int, pyvista.__version__.split(".")[:2])) >= (0, 48):
        grid.save(folder + "/saved.gtn")
        assert pyvista.read(folder + "/saved.gtn").n_cells == grid.n_cells
print("VTK", vtkVersion.GetVTKVersion(), "PyVista", pyvista and pyvista.__version__)
"""


class Wheel(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.archive = zipfile.ZipFile(PATH)
        self.addCleanup(self.archive.close)

    def test_library(self):
        """The library needs no newer C library than the tag says, and neither C++ nor other libraries."""
        library = self.archive.extract("gatun/libgatun.so", self.folder.name)
        libraries, versions = wheel.find_needs(library)
        self.assertLessEqual(libraries, wheel.SYSTEM_LIBRARIES)
        self.assertEqual({name for name, _ in versions} - {"GLIBC", "GCC"}, set())
        newest = max(version for name, version in versions if name == "GLIBC")
        promised = tuple(map(int, re.search(r"manylinux_(\d+)_(\d+)_", PATH.name).groups()))
        self.assertLessEqual(newest, promised)
        self.assertLessEqual(promised, (2, 34))
        exported = [line.split()[-1] for line in wheel.run("objdump", "-T", library).splitlines()
                    if " g " in line and "*UND*" not in line]
        exported.remove("GATUN_0")  # the version of the symbols
        self.assertTrue(all(name.startswith("gatun_") for name in exported), exported)
        self.assertGreater(len(exported), 40)

    def test_record(self):
        info = next(name for name in self.archive.namelist() if name.endswith("/RECORD")).rpartition("/")[0]
        listed = {}
        for line in self.archive.read(f"{info}/RECORD").decode().splitlines():
            name, digest, size = line.split(",")
            listed[name] = (digest, size)
        self.assertEqual(set(listed), set(self.archive.namelist()))
        self.assertEqual(listed.pop(f"{info}/RECORD"), ("", ""))
        for name, (digest, size) in listed.items():
            data = self.archive.read(name)
            own = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
            self.assertEqual((digest, size), (f"sha256={own}", str(len(data))), name)
        description = self.archive.read(f"{info}/WHEEL").decode()
        self.assertIn("Root-Is-Purelib: false", description)
        self.assertIn(f"Tag: {'-'.join(PATH.stem.split('-')[2:])}\n", description)
        self.assertIn(f"{info}/licenses/LICENSE", self.archive.namelist())

    def test_use(self):
        """Installed beside a NumPy, it reads, writes and draws."""
        environment = os.path.join(self.folder.name, "venv")
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", environment], check=True)
        python = os.path.join(environment, "bin", "python3")
        install = [python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", str(PATH.resolve())]
        subprocess.run(install, check=True)
        clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "GATUN"))}
        programs = [PROGRAM] + ([WITH_VTK] if importlib.util.find_spec("vtkmodules") else [])
        for program in programs:
            subprocess.run([python, "-B", "-c", program, str(GOLDEN), self.folder.name], check=True, env=clean)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
