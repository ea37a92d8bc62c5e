// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointRounding.h"

#include "gatunError.h"
#include "gatunParallel.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
constexpr int MostBits = 31;
constexpr std::size_t PointsPerTask = 1 << 16;

/** Places that coordinates are rounded to. */
struct Lattice
{
  std::array<double, 3> Origin{};
  double Step = 0;
  double MostError = 0; // what is farther away stays

  template <typename T>
  T Round(T value, std::size_t axis) const
  {
    // Beyond this, all numbers are multiples of the step.
    constexpr double large = 4503599627370496.0; // 2^52
    const double place = (static_cast<double>(value) - this->Origin[axis]) / this->Step;
    if (!(std::abs(place) < large))
    {
      return value; // infinity and NaN, too
    }
    const double rounded = this->Origin[axis] + std::nearbyint(place) * this->Step;
    const auto result = std::abs(rounded) <= std::numeric_limits<T>::max() && rounded != 0
      ? static_cast<T>(rounded)
      : T{ 0 };
    const double error = std::abs(static_cast<double>(result) - static_cast<double>(value));
    return error <= this->MostError ? result : value; // -0 becomes 0
  }
};

//------------------------------------------------------------------------------
Lattice MakeLattice(double error)
{
  // Multiples of a power of two are exact as floating-point numbers.
  constexpr int mostExponent = 1023;
  Lattice lattice;
  lattice.Step = std::ldexp(1.0, std::min(std::ilogb(error) + 1, mostExponent));
  lattice.MostError = error;
  return lattice;
}

//------------------------------------------------------------------------------
template <typename ArrayT>
Lattice MakeLattice(ArrayT* points, int bits)
{
  std::array<double, 3> least;
  least.fill(std::numeric_limits<double>::infinity());
  std::array<double, 3> largest;
  largest.fill(-std::numeric_limits<double>::infinity());
  const auto* const values = points->GetPointer(0);
  for (vtkIdType i = 0; i < points->GetNumberOfValues(); ++i)
  {
    const auto axis = static_cast<std::size_t>(i % 3);
    const auto value = static_cast<double>(values[i]);
    if (std::isfinite(value))
    {
      least[axis] = std::min(least[axis], value);
      largest[axis] = std::max(largest[axis], value);
    }
  }
  Lattice lattice;
  double side = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (least[axis] <= largest[axis])
    {
      lattice.Origin[axis] = least[axis];
      side = std::max(side, largest[axis] - least[axis]);
    }
  }
  lattice.Step = side / (std::ldexp(1.0, bits) - 1);
  lattice.MostError = lattice.Step;
  return lattice;
}

//------------------------------------------------------------------------------
/** Rounds the values of an array. Returns the largest difference. */
template <typename ArrayT>
double RoundValues(ArrayT* from, const Lattice& lattice, ArrayT* to)
{
  const auto count = static_cast<std::size_t>(from->GetNumberOfTuples());
  std::vector<double> errors(count / PointsPerTask + 1);
  const auto* const values = from->GetPointer(0);
  auto* const results = to->GetPointer(0);
  ParallelFor(errors.size(),
    [&](std::size_t task)
    {
      const std::size_t end = 3 * std::min(count, (task + 1) * PointsPerTask);
      for (std::size_t i = 3 * task * PointsPerTask; i < end; ++i)
      {
        results[i] = lattice.Round(values[i], i % 3);
        const double error =
          std::abs(static_cast<double>(results[i]) - static_cast<double>(values[i]));
        errors[task] = std::max(errors[task], std::isfinite(error) ? error : 0.0);
      }
    });
  return *std::max_element(errors.begin(), errors.end());
}

//------------------------------------------------------------------------------
template <typename ArrayT>
vtkSmartPointer<vtkDataArray> RoundArray(
  vtkDataArray* points, const PointRounding& rounding, double& largest)
{
  auto* from = ArrayT::FastDownCast(points);
  vtkNew<ArrayT> copy;
  if (!from)
  {
    copy->DeepCopy(points);
    from = copy;
  }
  const Lattice lattice =
    rounding.Bits > 0 ? MakeLattice(from, rounding.Bits) : MakeLattice(rounding.Error);
  if (!(lattice.Step > 0))
  {
    return nullptr;
  }
  auto to = vtkSmartPointer<ArrayT>::New();
  to->SetNumberOfComponents(3);
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  const double error = RoundValues(from, lattice, to.Get());
  largest = std::max(largest, error);
  return error > 0 ? vtkSmartPointer<vtkDataArray>(to) : nullptr;
}
}

//------------------------------------------------------------------------------
void CheckRounding(const PointRounding& rounding)
{
  if (!(rounding.Error >= 0 && std::isfinite(rounding.Error)))
  {
    ThrowInvalid("the largest error of coordinates must be a finite number of 0 or more");
  }
  if (rounding.Bits < 0 || rounding.Bits > MostBits)
  {
    ThrowInvalid("coordinates must have from 1 to 31 bits, or 0 to keep them");
  }
  if (rounding.Error > 0 && rounding.Bits > 0)
  {
    ThrowInvalid("coordinates can be rounded by an error or to a number of bits, not by both");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> RoundPoints(
  vtkUnstructuredGrid* grid, const PointRounding& rounding, double& largest)
{
  const int type = grid->GetNumberOfPoints() > 0 ? grid->GetPoints()->GetDataType() : VTK_VOID;
  if (rounding.IsExact() || (type != VTK_FLOAT && type != VTK_DOUBLE))
  {
    return grid;
  }
  vtkDataArray* const points = grid->GetPoints()->GetData();
  const auto rounded = type == VTK_FLOAT ? RoundArray<vtkFloatArray>(points, rounding, largest)
                                         : RoundArray<vtkDoubleArray>(points, rounding, largest);
  if (!rounded)
  {
    return grid;
  }
  vtkNew<vtkPoints> places;
  places->SetData(rounded);
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->ShallowCopy(grid);
  result->SetPoints(places);
  return result;
}
}
