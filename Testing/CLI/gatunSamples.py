#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the small files with which the commands of Documentation/guide can be tried:

    python3 Testing/CLI/gatunSamples.py [FOLDER [SIZE]]      default: samples, 10

    mesh.vtu                    a bent duct of 18,000 tetrahedra: point arrays temperature and velocity, cell
                                array age
    run_00.vtu ... run_04.vtu   its temperature at five times, and run.pvd, which lists them
    parts.pvtu                  mesh.vtu in four files
    bricks.vtu                  the duct of hexahedra
    part.stl                    a surface
    scan.vti                    a regular volume
    points.csv, tets.csv        coordinates, temperatures and corners in text
    crash.e, gold.case, pipe/case.foam, flow.cgns
                                the bricks as files of Exodus, EnSight, OpenFOAM and, if Python has h5py, CGNS

SIZE is the number of bricks across. The mesh has 18 times its third power of tetrahedra."""

import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_TETRA, vtkCellArray, vtkImageData,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLUnstructuredGridWriter

import gatunSolverFiles

STEPS = 5


class Duct:
    """A duct with a bend of a right angle; a warm stream enters and mixes."""

    def __init__(self, size):
        self.size = (size, size, 3 * size)
        u, v, w = (a.ravel() for a in np.meshgrid(*(np.arange(n + 1) / n for n in self.size), indexing="ij"))
        angle = w * np.pi / 2
        radius = 2 + u
        self.u, self.v, self.w = u, v, w
        self.points = np.stack([radius * np.cos(angle), radius * np.sin(angle), v], 1).astype(np.float32)
        speed = 16 * u * (1 - u) * v * (1 - v)
        self.velocity = (speed[:, None] * np.stack([-np.sin(angle), np.cos(angle), 0 * v], 1)).astype(np.float32)
        ids = np.arange(len(u)).reshape([n + 1 for n in self.size])
        self._corner = lambda i, j, k: ids[i:i + self.size[0], j:j + self.size[1], k:k + self.size[2]].ravel()
        self.bricks = np.stack([self._corner(*c) for c in (
            (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))], 1)

    def temperature(self, time=1.0):
        """Kelvin: two warm streams wind around each other and mix; they have come so far."""
        warm = np.zeros_like(self.w)
        for turn, strength in ((0, 1.0), (np.pi, 0.7)):
            angle = 3 * np.pi * self.w + turn
            far = (self.u - 0.5 - 0.21 * np.cos(angle)) ** 2 + (self.v - 0.5 - 0.21 * np.sin(angle)) ** 2
            wide = 0.008 + 0.02 * self.w
            warm += strength * np.exp(-far / wide) * (0.008 / wide) ** 0.5
        front = 1 / (1 + np.exp((self.w - 1.15 * time) * 16))
        return (300 + 65 * warm * front).astype(np.float32)

    def tetrahedra(self):
        """Six for each brick."""
        around = ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1))
        corners = [self._corner(n & 1, n >> 1 & 1, n >> 2) for n in range(8)]
        return np.concatenate([np.stack([corners[0], corners[a], corners[b], corners[7]], 1)
                               for a, b in around])


def named(values, name):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    return array


def make_grid(points, kind, cells, point_data, cell_data=None):
    """A grid of cells of one type; data are dictionaries of name and numpy array."""
    grid = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(places)
    lists = vtkCellArray()
    lists.SetData(numpy_to_vtkIdTypeArray(np.arange(0, cells.size + 1, cells.shape[1]), deep=True),
                  numpy_to_vtkIdTypeArray(cells.ravel().astype(np.int64), deep=True))
    grid.SetCells(kind, lists)
    for data, arrays in ((grid.GetPointData(), point_data), (grid.GetCellData(), cell_data or {})):
        for name, values in arrays.items():
            data.AddArray(named(values, name))
    return grid


def make_mesh(duct, time=1.0):
    """The duct of tetrahedra."""
    tets = duct.tetrahedra()
    mesh = make_grid(duct.points, VTK_TETRA, tets,
                     {"temperature": duct.temperature(time), "velocity": duct.velocity},
                     {"age": (100 * duct.w[tets].mean(1)).astype(np.float32)})
    mesh.GetPointData().SetActiveScalars("temperature")
    return mesh


def make_bricks(duct):
    """The duct of hexahedra with a cell array."""
    values = duct.temperature()[duct.bricks].mean(1)
    return make_grid(duct.points, VTK_HEXAHEDRON, duct.bricks, {}, {"p": values}), values


def write_xml(grid, name):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    assert writer.Write()


def write_meshes(duct, folder):
    mesh = make_mesh(duct)
    write_xml(mesh, os.path.join(folder, "mesh.vtu"))
    names = [f"run_{step:02d}.vtu" for step in range(STEPS)]
    for step, name in enumerate(names):
        write_xml(make_mesh(duct, (step + 1) / STEPS), os.path.join(folder, name))
    with open(os.path.join(folder, "run.pvd"), "w", encoding="ascii") as file:
        file.write('<VTKFile type="Collection" version="0.1"><Collection>')
        file.writelines(f'<DataSet timestep="{step / 2}" part="0" file="{name}"/>' for step, name in enumerate(names))
        file.write("</Collection></VTKFile>")
    return mesh


def write_parts(duct, folder):
    """A mesh in four files and the file that names them, as a parallel solver writes them."""
    tets = duct.tetrahedra()
    along = duct.w[tets].mean(1)
    temperature = duct.temperature()
    pieces = []
    for part in range(4):
        inside = tets[(along >= part / 4) & (along < (part + 1) / 4)]
        used, local = np.unique(inside, return_inverse=True)
        pieces.append(f"part_{part}.vtu")
        write_xml(make_grid(duct.points[used], VTK_TETRA, local.reshape(inside.shape),
                            {"temperature": temperature[used]}), os.path.join(folder, pieces[-1]))
    with open(os.path.join(folder, "parts.pvtu"), "w", encoding="ascii") as file:
        file.write('<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0"><PPoints>'
                   '<PDataArray type="Float32" NumberOfComponents="3"/></PPoints><PPointData>'
                   '<PDataArray type="Float32" Name="temperature"/></PPointData>')
        file.writelines(f'<Piece Source="{name}"/>' for name in pieces)
        file.write("</PUnstructuredGrid></VTKFile>")


def write_others(duct, mesh, folder):
    """A surface, a volume and text."""
    skin = vtkGeometryFilter()
    skin.SetInputData(mesh)
    stl = vtkSTLWriter()
    stl.SetInputConnection(skin.GetOutputPort())
    stl.SetFileName(os.path.join(folder, "part.stl"))
    assert stl.Write()
    n = 4 * duct.size[0]
    axis = np.linspace(-1, 1, n)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    radius = np.sqrt(x * x + y * y + z * z)
    ribs = np.sin(9 * x) * np.cos(9 * y) + np.sin(9 * y) * np.cos(9 * z) + np.sin(9 * z) * np.cos(9 * x)
    voxels = 1000 / (1 + np.exp(30 * (radius - 0.85))) / (1 + np.exp(-9 * (ribs - 0.4)))
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.GetPointData().SetScalars(named(voxels.astype(np.int16).ravel(), "density"))
    vti = vtkXMLImageDataWriter()
    vti.SetInputData(image)
    vti.SetFileName(os.path.join(folder, "scan.vti"))
    assert vti.Write()
    np.savetxt(os.path.join(folder, "points.csv"), np.c_[duct.points, duct.temperature()], "%.9g", ",",
               header="x,y,z,temperature", comments="")
    np.savetxt(os.path.join(folder, "tets.csv"), duct.tetrahedra(), "%d", ",", header="a,b,c,d", comments="")


def write_solvers(duct, folder):
    bricks, values = make_bricks(duct)
    exodus = vtkExodusIIWriter()
    exodus.SetInputData(bricks)
    exodus.SetFileName(os.path.join(folder, "crash.e"))
    assert exodus.Write()
    gatunSolverFiles.write_foam(os.path.join(folder, "pipe"), duct.points, duct.bricks, values)
    gatunSolverFiles.write_ensight(os.path.join(folder, "gold"), bricks)
    write_xml(bricks, os.path.join(folder, "bricks.vtu"))
    try:
        gatunSolverFiles.write_cgns(os.path.join(folder, "flow.cgns"), duct.points, duct.bricks, values)
    except ImportError:
        print("there is no h5py, so flow.cgns was not written")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "samples"
    os.makedirs(folder, exist_ok=True)
    duct = Duct(int(sys.argv[2]) if len(sys.argv) > 2 else 10)
    mesh = write_meshes(duct, folder)
    write_parts(duct, folder)
    write_others(duct, mesh, folder)
    write_solvers(duct, folder)


if __name__ == "__main__":
    main()
