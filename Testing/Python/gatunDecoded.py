# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Compares what gtn_decoder makes of a file with grids."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunMeshes as gm
from gtn_decoder import Decoder
from gtn_tables import CELLS, POINTS


def decode(path):
    with open(path, "rb") as file:
        decoder = Decoder(file.read())
    decoder.container.verify_layout()
    return decoder


def assert_same_bytes(one, other, what):
    one, other = (np.ascontiguousarray(values) for values in (one, other))
    assert one.nbytes == other.nbytes and one.tobytes() == other.tobytes(), what


def assert_decoded_as(grid, decoder, restore, step=0):
    """Points, cells and arrays at a step are those of a grid, in the same order."""
    assert_same_bytes(gm.coordinates(grid), decoder.points(restore), "points")
    cells = decoder.cells(restore)
    assert len(cells) == grid.GetNumberOfCells(), "number of cells"
    if cells:
        kinds = np.array([kind for kind, _, _ in cells], np.uint8)
        assert_same_bytes(gm.cell_types(grid), kinds, "types")
        offsets = np.cumsum([0] + [len(corners) for _, corners, _ in cells])
        points = [point for _, corners, _ in cells for point in corners]
        for name, values in (("Offsets", offsets), ("Connectivity", points)):
            array = vtk_to_numpy(getattr(grid.GetCells(), "Get%sArray" % name)())
            assert np.array_equal(array, values), name
    for i, (_, _, faces) in enumerate(cells):
        stream = [] if faces is None else [
            len(faces), *(number for face in faces for number in (len(face), *face))]
        assert gm.faces_of(grid, i) == stream, "faces of cell %d" % i
    for where, attributes in ((POINTS, grid.GetPointData()), (CELLS, grid.GetCellData())):
        numbers = [i for i, array in enumerate(decoder.meta.arrays) if array.where == where]
        arrays = gm.arrays_of(attributes)
        assert len(arrays) == len(numbers), "number of arrays"
        for i, array in zip(numbers, arrays):
            assert_same_bytes(gm.values_of(array), decoder.array(step, i, restore), array.GetName())
