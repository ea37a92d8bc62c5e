# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes hexahedra with a cell array as solvers do, for the guide and for tests: OpenFOAM, CGNS, EnSight.

Points are a numpy array of (n, 3), bricks one of (m, 8) with corners in VTK's order, values one of m numbers."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkIOParallel import vtkEnSightWriter

FACES = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]
PATCHES = ("ends", "walls", "floor")


def _put_foam(folder, path, kind, text):
    with open(os.path.join(folder, path), "w", encoding="ascii") as file:
        name = os.path.basename(path)
        file.write("FoamFile\n{\n version 2.0;\n format ascii;\n class %s;\n object %s;\n}\n%s\n"
                   % (kind, name, text))


def _listed(values):
    return "%d\n(\n%s\n)" % (len(values), "\n".join(values))


def write_foam(folder, points, bricks, values, array="p"):
    """An OpenFOAM case, read by folder/case.foam: the faces of all cells, inner ones first; outer ones are
    patches by the side of the brick. Returns the number of outer faces."""
    owners = {}
    for cell, brick in enumerate(bricks):
        for side, face in enumerate(FACES):
            corners = [int(brick[c]) for c in face]
            owners.setdefault(frozenset(corners), []).append((cell, side, corners))
    inner = sorted((a[0], b[0], a[2]) for a, b in (f for f in owners.values() if len(f) == 2))
    outer = sorted((f[0][1] // 2, f[0][0], f[0][2]) for f in owners.values() if len(f) == 1)
    for name in ("constant/polyMesh", "system", "0"):
        os.makedirs(os.path.join(folder, name))
    _put_foam(folder, "system/controlDict", "dictionary",
              "startTime 0;\nendTime 0;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;")
    mesh = "constant/polyMesh/"
    _put_foam(folder, mesh + "points", "vectorField",
              _listed(["(%r %r %r)" % tuple(map(float, p)) for p in points]))
    _put_foam(folder, mesh + "faces", "faceList",
              _listed(["4(%d %d %d %d)" % tuple(f[2]) for f in inner + outer]))
    _put_foam(folder, mesh + "owner", "labelList",
              _listed([str(f[0]) for f in inner] + [str(f[1]) for f in outer]))
    _put_foam(folder, mesh + "neighbour", "labelList", _listed([str(f[1]) for f in inner]))
    patches, start = [], len(inner)
    for number, name in enumerate(PATCHES):
        count = sum(f[0] == number for f in outer)
        patches.append("%s { type wall; nFaces %d; startFace %d; }" % (name, count, start))
        start += count
    _put_foam(folder, mesh + "boundary", "polyBoundaryMesh", _listed(patches))
    _put_foam(folder, "0/" + array, "volScalarField",
              "dimensions [0 2 -2 0 0 0 0];\ninternalField nonuniform List<scalar> %s;\n"
              "boundaryField { \".*\" { type zeroGradient; } }"
              % _listed(["%r" % float(p) for p in values]))
    with open(os.path.join(folder, "case.foam"), "w", encoding="ascii"):
        pass
    return len(outer)


def write_cgns(name, points, bricks, values, array="p"):
    """A CGNS file: nodes of an HDF5 file with names, labels and types. Needs h5py."""
    import h5py  # pylint: disable=import-outside-toplevel

    def add(parent, child, label, data=None, kind="MT"):
        group = parent.create_group(child, track_order=True)
        for key, text, size in (("name", child, 33), ("label", label, 33), ("type", kind, 3)):
            group.attrs.create(key, np.array(text.encode(), dtype="S%d" % size))
        group.attrs.create("flags", np.array([1], dtype=np.int32))
        if data is not None:
            # Fortran's order of indices.
            group.create_dataset(" data", data=np.asarray(data))
        return group

    def text(value):
        return np.frombuffer(value.encode(), dtype=np.int8)

    with h5py.File(name, "w", libver="earliest", track_order=True) as file:
        for key, value, size in (("name", "HDF5 MotherNode", 33), ("label", "Root Node of HDF5 File", 33),
                                 ("type", "MT", 3)):
            file.attrs.create(key, np.array(value.encode(), dtype="S%d" % size))
        file.create_dataset(" format", data=text("IEEE_LITTLE_32\0"))
        file.create_dataset(" hdf5version", data=text("HDF5 Version 1.10.8".ljust(33, "\0")))
        add(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", np.array([3.3], dtype="f4"), "R4")
        base = add(file, "Base", "CGNSBase_t", np.array([3, 3], dtype="i4"), "I4")
        zone = add(base, "Zone", "Zone_t",
                   np.array([[len(points)], [len(bricks)], [0]], dtype="i4"), "I4")
        add(zone, "ZoneType", "ZoneType_t", text("Unstructured"), "C1")
        places = add(zone, "GridCoordinates", "GridCoordinates_t")
        for axis, label in enumerate("XYZ"):
            add(places, "Coordinate" + label, "DataArray_t", points[:, axis].astype(float), "R8")
        cells = add(zone, "Bricks", "Elements_t", np.array([17, 0], dtype="i4"), "I4")  # HEXA_8
        add(cells, "ElementRange", "IndexRange_t", np.array([1, len(bricks)], dtype="i4"), "I4")
        add(cells, "ElementConnectivity", "DataArray_t", (bricks.ravel() + 1).astype("i4"), "I4")
        solution = add(zone, "Solution", "FlowSolution_t")
        add(solution, "GridLocation", "GridLocation_t", text("CellCenter"), "C1")
        add(solution, array, "DataArray_t", np.asarray(values, dtype=float), "R8")


def write_ensight(name, grid, array="p"):
    """EnSight Gold files of a grid with a cell array, read by name.case."""
    shallow = grid.NewInstance()
    shallow.ShallowCopy(grid)
    block = numpy_to_vtk(np.ones(grid.GetNumberOfCells(), np.int32), deep=True)
    block.SetName("BlockId")
    shallow.GetCellData().AddArray(block)
    writer = vtkEnSightWriter()
    writer.SetInputData(shallow)
    writer.SetFileName(name)
    writer.Write()
    # VTK's own WriteCaseFile closes the file when the program ends.
    base = os.path.basename(name)
    with open(name + ".case", "w", encoding="ascii") as file:
        file.write(f"FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: {base}.0.00000.geo\n\n"
                   f"VARIABLE\nscalar per element: {array} {base}.0.00000_c.{array}\n")
