// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOutline.h"

#include "gatunArrayBridge.h"
#include "gatunFileReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gatun
{
namespace
{
constexpr vtkIdType Corners = 8;
constexpr vtkIdType Lines = 12;

using Tuple = std::vector<double>;

//------------------------------------------------------------------------------
double LengthOf(const Tuple& tuple)
{
  double sum = 0;
  for (const double value : tuple)
  {
    sum += value * value;
  }
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
/**
 * Finds a tuple within the ranges whose magnitude is as close as possible to the requested one.
 * Fixed is the index of a component whose value is given, if any.
 */
Tuple FindTuple(
  const ArrayRanges& ranges, std::size_t components, double length, std::size_t fixed, double value)
{
  Tuple shortest(components);
  Tuple longest(components);
  for (std::size_t c = 0; c < components; ++c)
  {
    const Range& range = ranges[c];
    shortest[c] = std::clamp(0.0, range.Min, range.Max);
    longest[c] = std::abs(range.Min) > std::abs(range.Max) ? range.Min : range.Max;
    if (c == fixed)
    {
      shortest[c] = longest[c] = value;
    }
  }
  // The magnitude grows monotonically from the shortest tuple to the longest.
  const auto at = [&](double share)
  {
    Tuple tuple(components);
    for (std::size_t c = 0; c < components; ++c)
    {
      tuple[c] = share >= 1 ? longest[c] : shortest[c] + share * (longest[c] - shortest[c]);
    }
    return tuple;
  };
  double low = 0;
  double high = 1;
  if (LengthOf(shortest) >= length)
  {
    return shortest;
  }
  for (int i = 0; i < 60; ++i)
  {
    const double middle = (low + high) / 2;
    (LengthOf(at(middle)) < length ? low : high) = middle;
  }
  return at(high);
}

//------------------------------------------------------------------------------
/** Generates tuples that together span the ranges. */
std::vector<Tuple> MakeTuples(const ArrayRanges& ranges, std::size_t components, vtkIdType count)
{
  const auto size = static_cast<std::size_t>(count);
  const bool isFinite = std::all_of(ranges.begin(), ranges.end(),
    [](const Range& range)
    { return range.Min <= range.Max && std::isfinite(range.Min) && std::isfinite(range.Max); });
  std::vector<Tuple> tuples;
  if (components > 1 && isFinite && 2 * components + 2 <= size)
  {
    // Keep magnitudes small; otherwise they would exceed those of the mesh.
    const Range& lengths = ranges.back();
    for (std::size_t c = 0; c < components; ++c)
    {
      tuples.push_back(FindTuple(ranges, components, lengths.Min, c, ranges[c].Min));
      tuples.push_back(FindTuple(ranges, components, lengths.Min, c, ranges[c].Max));
    }
    for (bool isLongest = false; tuples.size() < size; isLongest = !isLongest)
    {
      tuples.push_back(
        FindTuple(ranges, components, isLongest ? lengths.Max : lengths.Min, components, 0));
    }
    return tuples;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    Tuple& tuple = tuples.emplace_back(components);
    for (std::size_t c = 0; c < components; ++c)
    {
      const Range& range = ranges[c];
      tuple[c] = range.Min > range.Max ? std::nan("") : i % 2 == 0 ? range.Min : range.Max;
    }
  }
  return tuples;
}

//------------------------------------------------------------------------------
/** Converts a value to the type of an array, saturating at its limits. */
double ToType(vtkDataArray* array, double value)
{
  const int type = array->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return value;
  }
  if (std::isnan(value))
  {
    return 0;
  }
  // The largest 64-bit integers are not representable as double; rounding up would overflow.
  const double largest = array->GetDataTypeMax();
  const double fits = array->GetDataTypeSize() == 8 ? std::nextafter(largest, 0.0) : largest;
  return std::clamp(std::round(value), array->GetDataTypeMin(), fits);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> MakeArray(
  const ArrayDescription& description, const ArrayRanges& ranges, vtkIdType count)
{
  ArrayFiller filler(description, count);
  vtkSmartPointer<vtkDataArray> array = filler.Finish();
  if (count == 0)
  {
    return array;
  }
  const std::vector<Tuple> tuples = MakeTuples(ranges, description.Components, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < description.Components; ++c)
    {
      array->SetComponent(
        i, static_cast<int>(c), ToType(array, tuples[static_cast<std::size_t>(i)][c]));
    }
  }
  return array;
}

//------------------------------------------------------------------------------
void AddMesh(const FileReader& file, std::size_t step, bool isEmpty, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(file.GetCoordinateType() == ScalarType::Float64 ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> cells;
  if (!isEmpty)
  {
    const Bounds box = file.GetBounds(step);
    for (int corner = 0; corner < Corners; ++corner)
    {
      std::array<double, 3> point{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        point[axis] = (corner >> axis & 1) == 0 ? box[axis].Min : box[axis].Max;
      }
      points->InsertNextPoint(point.data());
    }
    for (vtkIdType corner = 0; corner < Corners; ++corner)
    {
      for (const vtkIdType side : { 1, 2, 4 })
      {
        if ((corner & side) == 0)
        {
          const vtkIdType line[2] = { corner, corner + side };
          cells->InsertNextCell(2, line);
        }
      }
    }
  }
  output->SetPoints(points);
  output->SetCells(VTK_LINE, cells);
}
}

//------------------------------------------------------------------------------
void MakeOutline(const FileReader& file, const std::vector<std::uint32_t>& arrays, std::size_t step,
  bool isEmpty, vtkUnstructuredGrid* output)
{
  const Bounds box = file.GetBounds(step);
  isEmpty = isEmpty ||
    std::any_of(box.begin(), box.end(), [](const Range& range) { return range.Min > range.Max; });
  AddMesh(file, step, isEmpty, output);
  constexpr std::uint32_t ids =
    1u << vtkDataSetAttributes::GLOBALIDS | 1u << vtkDataSetAttributes::PEDIGREEIDS;
  for (const std::uint32_t index : arrays)
  {
    const ArrayDescription& description = file.GetArrays()[index];
    if (description.Name == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    const bool ofPoints = description.Where == Association::Point;
    const vtkIdType count = isEmpty ? 0 : ofPoints ? Corners : Lines;
    auto* const attributes =
      ofPoints ? static_cast<vtkDataSetAttributes*>(output->GetPointData()) : output->GetCellData();
    AddWithRoles(attributes, MakeArray(description, file.GetRanges(index, step), count),
      description.AttributeRoles & ~ids);
  }
}

//------------------------------------------------------------------------------
void AddOutlinePoints(const FileReader& file, const std::vector<std::uint32_t>& arrays,
  std::size_t step, vtkUnstructuredGrid* boundary)
{
  const vtkIdType points = boundary->GetNumberOfPoints();
  if (points == 0)
  {
    return;
  }
  vtkNew<vtkUnstructuredGrid> outline;
  AddMesh(file, step, false, outline);
  // The points are kept for other time steps, so these must not change.
  vtkNew<vtkPoints> all;
  all->SetDataType(boundary->GetPoints()->GetDataType());
  all->SetNumberOfPoints(points + Corners);
  all->InsertPoints(0, points, 0, boundary->GetPoints());
  all->InsertPoints(points, Corners, 0, outline->GetPoints());
  boundary->SetPoints(all);
  vtkPointData* const attributes = boundary->GetPointData();
  attributes->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  attributes->SetActiveAttribute(-1, vtkDataSetAttributes::PEDIGREEIDS);
  // The arrays of the file come first, in their order.
  int next = 0;
  for (const std::uint32_t index : arrays)
  {
    const ArrayDescription& description = file.GetArrays()[index];
    if (description.Where == Association::Point)
    {
      vtkDataArray* const array = attributes->GetArray(next++);
      if (description.Name != vtkDataSetAttributes::GhostArrayName())
      {
        array->InsertTuples(
          points, Corners, 0, MakeArray(description, file.GetRanges(index, step), Corners));
      }
    }
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    for (vtkIdType point = array->GetNumberOfTuples(); point < points + Corners; ++point)
    {
      array->InsertTuple1(point, 0); // ghost flags
    }
  }
}
}
