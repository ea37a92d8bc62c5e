// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchTriangles_h
#define benchTriangles_h

// Surfaces to be simplified, and how far simplified ones are from them.

#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace bench
{
using Triangles = vtkSmartPointer<vtkPolyData>;

/**
 * A surface of about so many triangles, always the same one, with float points and a point array
 * that is also named "Values":
 *
 *  - sphere: a field of waves;
 *  - terrain: a square with heights of several frequencies and noise, and another field;
 *  - torus: texture coordinates with two seams, where they go from 1 to 0.
 *
 * Throws Failure for other names.
 */
Triangles MakeTriangles(const std::string& name, std::size_t count);

/** Reads a .vtp file, the boundary of a .vtu file, or, with an isovalue of an array, an isosurface
 * of a .vtu, .vti or .vtk file. The array "Values" is that of a name, or of the only array. */
Triangles LoadTriangles(
  const std::string& file, const std::string& array, const std::string& isoArray, double value);

/** A simplified surface beside the original one; lengths are parts of the diagonal. */
struct TriangleDeviation
{
  double Hausdorff = 0;  ///< the larger one of both directions
  double MeanSquare = 0; ///< root, of both directions
  double Forth = 0;      ///< largest, from the original surface
  double Back = 0;
  double FieldRms = 0; ///< as part of the range; NaN without values
};

/** Compares with a surface, at places spread over both evenly by area and at all points. */
class TriangleComparison
{
public:
  TriangleComparison(vtkPolyData* original, std::size_t samples, bool isPeriodic);
  TriangleDeviation Compare(vtkPolyData* simplified) const;

private:
  struct Places;
  Places Sample(vtkPolyData* surface) const;

  Triangles Original;
  std::size_t Samples;
  bool IsPeriodic; ///< values 0 and 1 are the same
};
}

#endif
