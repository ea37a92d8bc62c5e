# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What the tests of the gtn program share: running it, and meshes to give it."""

import os
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

PROGRAM = os.environ["GATUN_TEST_GTN"]


def skip(why):
    print("skipped:", why)
    sys.exit(125)


def enter_folder(name):
    """Makes an empty folder to work in, and goes there."""
    folder = os.path.join(os.environ.get("GATUN_TEST_TEMP", tempfile.gettempdir()), "cli-" + name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.chdir(folder)


def gtn(*arguments, code=0, says=None, **keywords):
    """Runs gtn, expects an exit code and a part of what it prints; returns stdout.

    Whatever went wrong, stderr has lines that begin with the program's name and no others.
    """
    run = subprocess.run(
        [PROGRAM, *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        check=False,
        timeout=120,
        **keywords,
    )
    what = f"gtn {' '.join(map(str, arguments))}: {run.returncode}\n{run.stdout}{run.stderr}"
    print(what)
    assert run.returncode == code, f"exit code {run.returncode}, not {code}: {what}"
    assert says is None or says in run.stdout + run.stderr, f"not said: {says}"
    for line in run.stderr.splitlines():
        assert line.startswith("gtn: "), f"not of gtn's own: {line}"
        address = re.search(r"\b0x[0-9a-f]{6,}", line)
        assert not address or "nan(0x" in line, f"an address: {line}"
    if code:
        assert run.stderr.count("\n") >= 1, "no message"
    return run.stdout


def lattice(n, seed=1, dtype=np.float32):
    """Points and tetrahedra of an n x n x n lattice of bent cubes, six tetrahedra each."""
    random = np.random.default_rng(seed)
    axis = np.arange(n + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1).astype(np.float64)
    points += random.uniform(-0.2, 0.2, points.shape)
    ids = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    corner = lambda i, j, k: ids[k : k + n, j : j + n, i : i + n].ravel()
    paths = [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)]
    tets = []
    for path in paths:
        place = [0, 0, 0]
        tet = [corner(*place)]
        for axis_number in path:
            place[axis_number] = 1
            tet.append(corner(*place))
        tets.append(np.stack(tet, axis=1))
    tets = np.concatenate(tets)
    tets[len(tets) // 2 :, [0, 1]] = tets[len(tets) // 2 :, [1, 0]]
    return points.astype(dtype), tets


def permute(points, tets, seed):
    """The same mesh in another order: points, cells and, evenly, corners. Also returns where each
    point and each cell was."""
    random = np.random.default_rng(seed)
    old_point = random.permutation(len(points))
    new_point = np.argsort(old_point)
    old_cell = random.permutation(len(tets))
    even = np.array([[0, 1, 2, 3], [1, 2, 0, 3], [2, 0, 1, 3], [1, 0, 3, 2], [3, 2, 1, 0]])
    turn = even[random.integers(0, len(even), len(tets))]
    tets = np.take_along_axis(new_point[tets[old_cell]], turn, axis=1)
    return points[old_point], tets, old_point, old_cell


def make_grid(points, tets, point_data=None, cell_data=None):
    """A vtkUnstructuredGrid; data are dictionaries of name and numpy array."""
    grid = vtkUnstructuredGrid()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    grid.SetPoints(vtk_points)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, 4 * len(tets) + 1, 4), deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(tets, dtype=np.int64).ravel(), deep=True),
    )
    if len(tets):
        grid.SetCells(VTK_TETRA, cells)
    else:
        grid.Allocate(1)  # cells of any types can be added; after SetCells, VTK 9.6 would take them for tetrahedra
    for data, arrays in ((grid.GetPointData(), point_data), (grid.GetCellData(), cell_data)):
        for name, values in (arrays or {}).items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.AddArray(array)
    return grid


def write(grid, name):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    assert writer.Write()


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def add_text(grid, name, texts):
    array = vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    grid.GetFieldData().AddArray(array)


def corners_of(grid):
    return vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def waves(points):
    """Some point arrays."""
    p = points.astype(np.float64)
    return {
        "pressure": np.sin(p[:, 0]).astype(np.float32) + np.float32(2),
        "velocity": np.stack([p[:, 1], -p[:, 0], np.cos(p[:, 2])], axis=1),
        "mark": (np.arange(len(p)) % 7).astype(np.int16),
    }


def standard_mesh(n=6):
    """A mesh with some arrays of points and cells."""
    points, tets = lattice(n)
    cell_data = {
        "material": (np.arange(len(tets)) // 100).astype(np.int32),
        "quality": np.linspace(0, 1, len(tets)),
    }
    grid = make_grid(points, tets, waves(points), cell_data)
    add_text(grid, "remarks", ["made by a test", ""])
    return grid
