// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchHits_h
#define benchHits_h

#include <cstdint>

class vtkCamera;
class vtkUnstructuredGrid;

namespace bench
{
/**
 * How many pairs there are of a pixel and a tetrahedron that the ray of its center goes through:
 * the work of a ray caster, if nothing hides anything. Counted by projecting the faces,
 * independently of all ray casters. All of the mesh must be in front of the camera; the picture is
 * a square.
 */
std::uint64_t CountHits(vtkUnstructuredGrid* grid, vtkCamera* camera, int size);
}

#endif
