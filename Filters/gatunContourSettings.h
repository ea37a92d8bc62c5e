// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunContourSettings_h
#define gatunContourSettings_h

#include "gatunTypes.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformation;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The point array that isosurfaces are made of, by its name or by its role. */
class ContourArray
{
public:
  /** Takes it from vtkAlgorithm::GetInputArrayInformation. Throws InvalidInput unless it is an
   * array on the points. */
  explicit ContourArray(vtkInformation* info);

  bool IsThis(const ArrayDescription& array) const;

  /** Throws InvalidInput: there is no such array. */
  [[noreturn]] void Fail() const;

private:
  std::string Name; // empty: by its role
  int Attribute;
};

/** The parameters of isosurfaces, whether of a file or of a grid. */
struct ContourSettings
{
  std::vector<double> Values; ///< finite, different and ascending
  ContourArray Array;
  int Component = -1; ///< as vtkGatunContour::ArrayComponent
  bool ComputeNormals = false;
  bool ComputeScalars = true;
  bool OutputStrips = false;
  int Precision = 2; ///< vtkAlgorithm::DesiredOutputPrecision

  ScalarType ChoosePrecision(ScalarType input) const;

  /** The component as the core numbers them: the length of the tuples is -1. */
  int ChooseComponent(const ArrayDescription& array) const;

  /** Whether the surface carries an array, and then in which roles; isContoured: it is the array of
   * the isovalues. */
  bool Carries(ArrayDescription& array, bool isContoured) const;
};

/** Called with the fraction done; returns false to stop. */
using ContourProgress = std::function<bool(double)>;
}

#endif
