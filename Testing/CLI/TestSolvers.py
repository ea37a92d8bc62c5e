# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of solvers, with cells of several types and boundaries: OpenFOAM, CGNS, EnSight. What VTK
reads from them is packed and comes back, and is what was written here."""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkIOParallel import vtkEnSightWriter

from gatun import vtkGatunReader
from gatunCli import enter_folder, gtn, skip

try:
    import h5py
except ImportError:
    skip("there is no h5py to write CGNS files with")

enter_folder("solvers")

# A lattice of bricks, the corners of each one as VTK has them.
SIZE = (4, 3, 2)
AXES = [np.arange(n + 1, dtype=float) for n in SIZE]
POINTS = np.stack([a.ravel() for a in np.meshgrid(*AXES[::-1], indexing="ij")[::-1]], axis=1)
POINTS[:, 0] += 0.1 * np.sin(POINTS[:, 1])
CELLS = int(np.prod(SIZE))
FACES = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]


def point(i, j, k):
    return (k * (SIZE[1] + 1) + j) * (SIZE[0] + 1) + i


BRICKS = np.array([
    [point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k), point(i, j + 1, k),
     point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1)]
    for k in range(SIZE[2]) for j in range(SIZE[1]) for i in range(SIZE[0])])
PRESSURE = 100.0 + np.arange(CELLS) ** 2


def read(name):
    reader = vtkGatunReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def check(name, sets_says):
    """Packs a file with and without its boundaries. Returns both grids."""
    gtn("pack", name, name + ".gtn")
    gtn("verify", name + ".gtn", name, says="identical")
    gtn("pack", "--sets", name, name + "-sets.gtn")
    gtn("verify", "--sets", name + "-sets.gtn", name, says="identical")
    gtn("info", name + "-sets.gtn", says=sets_says)
    return read(name + ".gtn"), read(name + "-sets.gtn")


def check_bricks(grid):
    assert grid.GetNumberOfCells() == CELLS and grid.GetNumberOfPoints() == len(POINTS)
    assert np.allclose(grid.GetBounds(), np.stack([POINTS.min(0), POINTS.max(0)], 1).ravel())
    pressure = vtk_to_numpy(grid.GetCellData().GetArray("p"))
    locator = vtkStaticCellLocator()
    locator.SetDataSet(grid)
    locator.BuildLocator()
    for brick, value in zip(BRICKS, PRESSURE):
        cell = locator.FindCell(POINTS[brick].mean(axis=0))
        assert cell >= 0 and pressure[cell] == np.float32(value), (brick, value)


# OpenFOAM: the faces of all cells, inner ones first; the sides of the block are patches.
def write_foam(folder):
    owners = {}
    for cell, brick in enumerate(BRICKS):
        for side, face in enumerate(FACES):
            corners = [int(brick[c]) for c in face]
            owners.setdefault(frozenset(corners), []).append((cell, side, corners))
    inner = sorted((a[0], b[0], a[2]) for a, b in (f for f in owners.values() if len(f) == 2))
    outer = sorted((f[0][1] // 2, f[0][0], f[0][2]) for f in owners.values() if len(f) == 1)
    mesh = os.path.join(folder, "constant", "polyMesh")
    os.makedirs(mesh)
    os.makedirs(os.path.join(folder, "system"))
    os.makedirs(os.path.join(folder, "0"))

    def put(path, kind, text):
        with open(os.path.join(folder, path), "w", encoding="ascii") as file:
            name = os.path.basename(path)
            file.write("FoamFile\n{\n version 2.0;\n format ascii;\n class %s;\n object %s;\n}\n%s\n"
                       % (kind, name, text))

    def listed(values):
        return "%d\n(\n%s\n)" % (len(values), "\n".join(values))

    put("system/controlDict", "dictionary",
        "startTime 0;\nendTime 0;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;")
    put("constant/polyMesh/points", "vectorField",
        listed(["(%r %r %r)" % tuple(map(float, p)) for p in POINTS]))
    put("constant/polyMesh/faces", "faceList",
        listed(["4(%d %d %d %d)" % tuple(f[2]) for f in inner + outer]))
    put("constant/polyMesh/owner", "labelList",
        listed([str(f[0]) for f in inner] + [str(f[1]) for f in outer]))
    put("constant/polyMesh/neighbour", "labelList", listed([str(f[1]) for f in inner]))
    patches, start = [], len(inner)
    for number, name in enumerate(("ends", "walls", "floor")):
        count = sum(f[0] == number for f in outer)
        patches.append("%s { type wall; nFaces %d; startFace %d; }" % (name, count, start))
        start += count
    put("constant/polyMesh/boundary", "polyBoundaryMesh", listed(patches))
    put("0/p", "volScalarField",
        "dimensions [0 2 -2 0 0 0 0];\ninternalField nonuniform List<scalar> %s;\n"
        "boundaryField { \".*\" { type zeroGradient; } }"
        % listed(["%r" % float(p) for p in PRESSURE]))
    with open(os.path.join(folder, "case.foam"), "w", encoding="ascii"):
        pass
    return len(outer)


outer_faces = write_foam("foam")
inside, everything = check("foam/case.foam", "vtkQuad")
check_bricks(inside)
assert everything.GetNumberOfCells() == CELLS + outer_faces
names = everything.GetFieldData().GetAbstractArray("BlockNames")
assert {"ends", "walls", "floor"} <= {
    names.GetValue(i).split("/")[-1] for i in range(names.GetNumberOfValues())}


# CGNS: nodes of an HDF5 file with names, labels and types.
def write_cgns(name):
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
                   np.array([[len(POINTS)], [CELLS], [0]], dtype="i4"), "I4")
        add(zone, "ZoneType", "ZoneType_t", text("Unstructured"), "C1")
        places = add(zone, "GridCoordinates", "GridCoordinates_t")
        for axis, label in enumerate("XYZ"):
            add(places, "Coordinate" + label, "DataArray_t", POINTS[:, axis].copy(), "R8")
        cells = add(zone, "Bricks", "Elements_t", np.array([17, 0], dtype="i4"), "I4")  # HEXA_8
        add(cells, "ElementRange", "IndexRange_t", np.array([1, CELLS], dtype="i4"), "I4")
        add(cells, "ElementConnectivity", "DataArray_t",
            (BRICKS.ravel() + 1).astype("i4"), "I4")
        solution = add(zone, "Solution", "FlowSolution_t")
        add(solution, "GridLocation", "GridLocation_t", text("CellCenter"), "C1")
        add(solution, "p", "DataArray_t", PRESSURE, "R8")


write_cgns("case.cgns")
gtn("pack", "case.cgns", "case.cgns.gtn")
gtn("verify", "case.cgns.gtn", "case.cgns", says="identical")
check_bricks(read("case.cgns.gtn"))

# EnSight Gold, which holds float.
bricks = read("case.cgns.gtn")
block = numpy_to_vtk(np.ones(CELLS, np.int32), deep=True)
block.SetName("BlockId")
bricks.GetCellData().AddArray(block)
writer = vtkEnSightWriter()
writer.SetInputData(bricks)
writer.SetFileName("gold")
writer.Write()
with open("gold.case", "w", encoding="ascii") as file:
    file.write("FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: gold.0.00000.geo\n\n"
               "VARIABLE\nscalar per element: p gold.0.00000_c.p\n")
gtn("pack", "gold.case", "gold.gtn")
gtn("verify", "gold.gtn", "gold.case", says="identical")
check_bricks(read("gold.gtn"))

# SLC volumes: a header of text, an icon, then a plane of bytes after the other.
voxels = np.random.default_rng(1).integers(0, 256, (4, 5, 6), dtype=np.uint8)
with open("volume.slc", "wb") as file:
    file.write(b"11111\n6 5 4\n8\n1.0 2.0 0.5\n0 1 0\n0\n1 1 X" + bytes(3))
    file.write(voxels.tobytes())
gtn("volume", "pack", "volume.slc", "volume.ghv", says="6 x 5 x 4")

# Damaged files are errors.
with open("bad.cgns", "wb") as file:
    file.write(b"CGNS" + bytes(100))
gtn("pack", "bad.cgns", "bad.gtn", code=1, says="is not a CGNS file")
os.makedirs("empty")
with open("empty/case.foam", "wb"):
    pass
gtn("pack", "empty/case.foam", "bad.gtn", code=1)
assert not os.path.exists("bad.gtn")
