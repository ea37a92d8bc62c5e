// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchDeviation_h
#define benchDeviation_h

// How far a simplified mesh is from the one that it was made of.

#include "benchMeshes.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace bench
{
/** Places all over a mesh, evenly by volume and always the same ones, and the field there; and
 * places all over its boundary, evenly by area. */
struct Samples
{
  std::vector<std::array<double, 3>> Places;
  std::vector<double> Values;
  double Range = 0; ///< of the field at the points of the mesh
  std::vector<std::array<double, 3>> OnBoundary;
  double Diagonal = 0; ///< of the mesh's box
};

Samples MakeSamples(vtkUnstructuredGrid* grid, const std::string& array, std::size_t count);

/** Of a field, as parts of its range, and of the boundary, as parts of the diagonal. */
struct Deviation
{
  double Rms = 0;
  double Largest = 0;
  double RmsInside = 0; ///< of the samples that are inside of both meshes

  /** Samples that are in no tetrahedron, by more than a millionth of the diagonal. They have the
   * value of the nearest place on the boundary. */
  std::size_t Outside = 0;

  double BoundaryMean = 0; ///< distance of the first mesh's boundary from that of the other
  double BoundaryLargest = 0;
};

Deviation Compare(const Samples& samples, vtkUnstructuredGrid* grid, const std::string& array);

/** What tetrahedra look like. */
struct Shapes
{
  double Volume = 0; ///< of all, none taken for negative

  /** Mean ratio: 1 is regular, 0 flat. */
  double Worst = 0;
  double FirstPercentile = 0;
  double Median = 0;

  std::size_t Flat = 0;     ///< a volume of 0
  std::size_t Inverted = 0; ///< oriented as the fewer are
};

Shapes LookAtShapes(vtkUnstructuredGrid* grid);
}

#endif
