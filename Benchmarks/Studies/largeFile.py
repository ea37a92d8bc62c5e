#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes the mesh of largeMesh.py as one raw .vtu file with its points and cubes in a scattered order, and
with memory for a small part of it.

    largeFile.py FILE CUBES
"""

import math
import sys

import numpy as np

import largeMesh

BLOCK = 1 << 20


class Scattered:
    """A permutation of numbers below count, and its inverse, without a table."""

    def __init__(self, count):
        self.count = count
        self.factor = int(count * 0.381966) | 1
        while math.gcd(self.factor, count) != 1:
            self.factor += 2
        self.inverse = pow(self.factor, -1, count)

    def __call__(self, numbers):
        return self._times(numbers, self.factor)

    def undo(self, numbers):
        return self._times(numbers, self.inverse)

    def _times(self, numbers, factor):
        # Numbers and factor are below 2^31, and so their product is below 2^62.
        assert self.count < 1 << 31
        return numbers.astype(np.int64) * factor % self.count


def blocks(count):
    return (np.arange(i, min(i + BLOCK, count)) for i in range(0, count, BLOCK))


def main(path, n):
    points, cubes = Scattered((n + 1) ** 3), Scattered(n**3)
    cells = 6 * cubes.count
    arrays = {
        "Points": ("Float32", 3, points.count, lambda i: largeMesh.points_of(n, points.undo(i))[0]),
        "field": ("Float32", 1, points.count, lambda i: largeMesh.points_of(n, points.undo(i))[1]),
        "connectivity": ("Int64", 24, cubes.count,
                         lambda i: points(largeMesh.tets_of(n, cubes.undo(i)))),
        "offsets": ("Int64", 1, cells, lambda i: 4 * (i + 1)),
        "types": ("UInt8", 1, cells, lambda i: np.full(len(i), 10, np.uint8)),
    }
    offset, element = 0, {}
    for name, (kind, values, count, _) in arrays.items():
        size = values * count * np.dtype(kind.lower()).itemsize
        shown = values if values == 3 else 1
        element[name] = (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{shown}" '
                         f'format="appended" offset="{offset}"/>')
        offset += 8 + size
    with open(path, "wb") as file:
        file.write(f"""<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"
 header_type="UInt64"><UnstructuredGrid>
<Piece NumberOfPoints="{points.count}" NumberOfCells="{cells}">
<PointData Scalars="field">{element["field"]}</PointData><Points>{element["Points"]}</Points>
<Cells>{element["connectivity"]}{element["offsets"]}{element["types"]}</Cells>
</Piece></UnstructuredGrid><AppendedData encoding="raw">_""".encode("ascii"))
        for kind, values, count, make in arrays.values():
            np.array([values * count * np.dtype(kind.lower()).itemsize], np.uint64).tofile(file)
            for numbers in blocks(count):
                make(numbers).astype(kind.lower()).tofile(file)
        file.write(b"</AppendedData></VTKFile>")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
