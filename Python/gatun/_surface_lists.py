# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The lists of cells of vtkPolyData."""

import numpy as np

#: The lists in their order: names in VTK, types of cells by the numbers of their points, and the type of all others.
SURFACE_LISTS = (("Verts", {1: 1}, 2), ("Lines", {2: 3}, 4), ("Polys", {3: 5, 4: 9}, 7), ("Strips", {}, 6))

#: The number of the list of each type of cells, or -1.
LIST_OF_TYPE = np.full(256, -1)
for _number, (_, _known, _other) in enumerate(SURFACE_LISTS):
    LIST_OF_TYPE[[*_known.values(), _other]] = _number


def find_types(sizes, known, other):
    """The types of the cells of a list, by the numbers of their points."""
    types = np.full(len(sizes), other, np.uint8)
    for size, number in known.items():
        types[sizes == size] = number
    return types
