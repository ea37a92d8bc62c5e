# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Point and cell arrays of every numeric VTK type and several component counts come back bit for
bit, with their names, types and roles; field data too."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.vtkConstants import VTK_BIT
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes as roles

import gatunMeshes as gm

TYPES = {
    c.VTK_CHAR: np.int8, c.VTK_SIGNED_CHAR: np.int8, c.VTK_UNSIGNED_CHAR: np.uint8,
    c.VTK_SHORT: np.int16, c.VTK_UNSIGNED_SHORT: np.uint16,
    c.VTK_INT: np.int32, c.VTK_UNSIGNED_INT: np.uint32,
    c.VTK_LONG: np.int64, c.VTK_UNSIGNED_LONG: np.uint64,
    c.VTK_LONG_LONG: np.int64, c.VTK_UNSIGNED_LONG_LONG: np.uint64,
    c.VTK_ID_TYPE: np.int64, c.VTK_FLOAT: np.float32, c.VTK_DOUBLE: np.float64,
    VTK_BIT: np.uint8}


def random_values(rng, dtype, shape, how):
    """Any bits (how 0), smooth values with all the odd ones strewn in (1), or just one value (2)."""
    dtype = np.dtype(dtype)
    noise = rng.integers(0, 256, (int(np.prod(shape)), dtype.itemsize), np.uint8)
    noise = noise.view(dtype).reshape(shape)
    if how == 0:
        return noise
    if how == 2:
        return np.broadcast_to(noise.reshape(-1)[:1], shape).copy()
    ramp = np.arange(np.prod(shape)).reshape(shape)
    values = (ramp % 100).astype(dtype) if dtype.kind in "iu" else np.sin(ramp / 50).astype(dtype)
    flat = values.reshape(-1)
    if dtype.kind == "f":
        bits = "u%d" % dtype.itemsize
        odd = np.array([0.0, -0.0, np.inf, -np.inf, np.finfo(dtype).tiny / 8,
                        np.finfo(dtype).max, -np.finfo(dtype).max], dtype).view(bits)
        # Quiet and signalling NaN, of either sign, with payloads.
        quiet = np.array([np.nan], dtype).view(bits)[0]
        one = np.array(1, bits)
        sign = np.array(1 << (8 * dtype.itemsize - 1), bits)
        exponent = np.array([np.inf], dtype).view(bits)[0]
        odd = np.concatenate([odd, [quiet, quiet | one, quiet | sign, exponent | one,
                                    exponent | one | sign]]).astype(bits)
        flat.view(bits)[:len(odd)] = odd
    else:
        info = np.iinfo(dtype)
        flat[:4] = [info.min, info.max, 0, 1]
    return values


def fill(attributes, tuples, components, rng):
    for vtk_type, dtype in TYPES.items():
        for how in range(3):
            values = random_values(rng, dtype, (tuples, components), how)
            if vtk_type == VTK_BIT:
                values &= 1
            gm.add_array(attributes, values, "type %d how %d" % (vtk_type, how), vtk_type)


rng = np.random.default_rng(7)
points, tets = gm.lattice(4)
for components in (1, 2, 3, 4, 6, 9, 13):
    grid = gm.make_grid(points, tets)
    fill(grid.GetPointData(), len(points), components, rng)
    fill(grid.GetCellData(), len(tets), components, rng)
    for chunk in (0, 64):
        back = gm.round_trip(grid, "types.gtn", KeepOrder=7, ChunkSize=chunk)
        gm.assert_equal(grid, back)
        back = gm.round_trip(grid, "types.gtn", ChunkSize=chunk)
        gm.assert_same_mesh(grid, back)
        for one, other in ((grid.GetPointData(), back.GetPointData()),
                           (grid.GetCellData(), back.GetCellData())):
            assert list(map(gm.description, gm.arrays_of(one))) == \
                list(map(gm.description, gm.arrays_of(other)))

# Names of components, names that repeat or are missing, and roles.
grid = gm.make_grid(points, tets)
n, m = len(points), len(tets)
pd, cd = grid.GetPointData(), grid.GetCellData()
gm.add_array(pd, rng.random((n, 3)), "velocity", components=["u", "v", "w"])
gm.add_array(pd, rng.random((n, 3)), "normal \u00e9\u4e2d\n\"<&>", components=["", "only", ""])
gm.add_array(pd, rng.random((n, 9)), "stress")
gm.add_array(pd, rng.random(n).astype(np.float32), "heat")
gm.add_array(pd, rng.random((n, 2)), "uv")
gm.add_array(pd, np.arange(n)[::-1] * 3, "ids", c.VTK_ID_TYPE)
gm.add_array(pd, rng.random(n), None)
pd.SetActiveScalars("heat")
pd.SetActiveVectors("velocity")
pd.SetActiveNormals("normal \u00e9\u4e2d\n\"<&>")
pd.SetActiveTensors("stress")
pd.SetActiveTCoords("uv")
pd.SetActiveGlobalIds("ids")
twin = gm.add_array(cd, np.arange(m), "twin, for now by another name")
gm.add_array(cd, rng.random(m), "twin")
twin.SetName("twin")
gm.add_array(cd, np.arange(m) + 5, "pedigree", c.VTK_ID_TYPE)
cd.SetActivePedigreeIds("pedigree")
cd.SetActiveAttribute(0, roles.SCALARS)

field = grid.GetFieldData()
for vtk_type, dtype in TYPES.items():
    values = random_values(rng, dtype, (5, 3), 0)
    gm.add_array(field, values & 1 if vtk_type == VTK_BIT else values, "field %d" % vtk_type,
                 vtk_type, components=["a", "b", "c"])
gm.add_array(field, np.zeros((0, 4)), "nothing", c.VTK_DOUBLE)
texts = vtkStringArray()
texts.SetName("texts")
texts.SetNumberOfComponents(2)
for text in ("", "one", "\u00fcber\nmany lines", "x" * 100000):
    texts.InsertNextValue(text)
field.AddArray(texts)
empty = vtkStringArray()
empty.SetName("no texts")
field.AddArray(empty)

back = gm.round_trip(grid, "types.gtn", KeepOrder=7)
gm.assert_equal(grid, back)
back = gm.round_trip(grid, "types.gtn", ChunkSize=64)
gm.assert_same_mesh(grid, back)
gm.assert_same_field(grid.GetFieldData(), back.GetFieldData())
assert gm.roles_of(pd) == gm.roles_of(back.GetPointData())
assert gm.roles_of(cd) == gm.roles_of(back.GetCellData())
assert "ids" in gm.roles_of(pd) and "pedigree" in gm.roles_of(cd)
