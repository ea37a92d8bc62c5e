// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnCompare.h"

#include "gtnComplex.h"
#include "gtnFailure.h"
#include "gtnText.h"

#include "gatunParallel.h"
#include "gatunTypes.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

namespace gtn
{
namespace
{

// Calls work(i) for all i, on all threads.
template <typename Work>
void ForEach(std::size_t count, const Work& work)
{
  constexpr std::size_t step = 8192;
  gatun::ParallelFor((count + step - 1) / step,
    [&work, count](std::size_t part)
    {
      const std::size_t end = std::min(count, (part + 1) * step);
      for (std::size_t i = part * step; i < end; ++i)
      {
        work(i);
      }
    });
}

std::vector<Hash> Sorted(std::vector<Hash> hashes)
{
  std::sort(hashes.begin(), hashes.end());
  return hashes;
}

Complex MakeComplex(const GridView& grid, const std::vector<Hash>& points,
  const std::vector<Hash>& cells, bool keepCorners)
{
  Complex complex{ points, cells, std::vector<Tet>(grid.Cells), keepCorners };
  ForEach(grid.Cells, [&](std::size_t i) { complex.Tets[i] = grid.Corners(i); });
  return complex;
}

//------------------------------------------------------------------------------
// Point labels by place, where the order is kept.
std::vector<Hash> Numbered(std::size_t count)
{
  std::vector<Hash> labels(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    labels[i] = { i, 1 };
  }
  return labels;
}

void AddArrays(std::vector<Hash>& hashes, const std::vector<ArrayView>& arrays)
{
  ForEach(hashes.size(),
    [&](std::size_t i)
    {
      for (const ArrayView& array : arrays)
      {
        hashes[i] = HashOf(array.Tuple(i), array.TupleBytes, hashes[i]);
      }
    });
}

std::vector<Hash> HashesOf(
  const ArrayView& array, std::size_t count, const std::vector<Hash>& before)
{
  std::vector<Hash> hashes(before);
  hashes.resize(count);
  ForEach(
    count, [&](std::size_t i) { hashes[i] = HashOf(array.Tuple(i), array.TupleBytes, hashes[i]); });
  return hashes;
}

constexpr auto None = static_cast<std::size_t>(-1);

// The first place in hashes that has no counterpart among the others, which are sorted.
std::size_t FirstMissing(const std::vector<Hash>& hashes, std::vector<Hash> others)
{
  others = Sorted(std::move(others));
  const std::vector<Hash> own = Sorted(hashes);
  std::vector<Hash> missing;
  std::set_difference(
    own.begin(), own.end(), others.begin(), others.end(), std::back_inserter(missing));
  if (missing.empty())
  {
    return None;
  }
  for (std::size_t i = 0; i < hashes.size(); ++i)
  {
    if (std::binary_search(missing.begin(), missing.end(), hashes[i]))
    {
      return i;
    }
  }
  return None;
}

//------------------------------------------------------------------------------
// Descriptions: everything but the values.

std::string Text(const std::vector<std::string>& names)
{
  return names.empty() ? "none" : Printable(Joined(names));
}

std::string CompareDescription(
  const ArrayView& a, const ArrayView& b, const std::string& nameOfA, const std::string& nameOfB)
{
  const auto differs = [&](const std::string& what, const std::string& inA, const std::string& inB)
  { return fmt::format("{}: {} {} in {}, {} in {}", a.Title, what, inA, nameOfA, inB, nameOfB); };
  if (a.Type != b.Type)
  {
    return differs(
      "type is", vtkImageScalarTypeNameMacro(a.Type), vtkImageScalarTypeNameMacro(b.Type));
  }
  if (a.Components != b.Components)
  {
    return differs(
      "number of components is", std::to_string(a.Components), std::to_string(b.Components));
  }
  if (a.ComponentNames != b.ComponentNames)
  {
    return differs("component names are", Text(a.ComponentNames), Text(b.ComponentNames));
  }
  if (a.Roles != b.Roles)
  {
    return differs(
      "roles (bits of vtkDataSetAttributes) are", std::to_string(a.Roles), std::to_string(b.Roles));
  }
  return {};
}

std::string CompareDescriptions(const std::vector<ArrayView>& a, const std::vector<ArrayView>& b,
  const std::string& nameOfA, const std::string& nameOfB)
{
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
  {
    if (i >= a.size())
    {
      return fmt::format("{} is in {} only", b[i].Title, nameOfB);
    }
    if (i >= b.size())
    {
      return fmt::format("{} is in {} only", a[i].Title, nameOfA);
    }
    if (a[i].Name != b[i].Name)
    {
      return fmt::format(
        "array number {} is {} in {}, {} in {}", i, a[i].Title, nameOfA, b[i].Title, nameOfB);
    }
    std::string difference = CompareDescription(a[i], b[i], nameOfA, nameOfB);
    if (!difference.empty())
    {
      return difference;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string CompareFieldArrays(
  vtkAbstractArray* a, vtkAbstractArray* b, const std::string& nameOfA, const std::string& nameOfB)
{
  const std::string title =
    fmt::format("field array '{}'", Printable(a->GetName() ? a->GetName() : ""));
  if (a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return fmt::format("{} has {} tuples in {}, {} in {}", title, a->GetNumberOfTuples(), nameOfA,
      b->GetNumberOfTuples(), nameOfB);
  }
  if (a->GetDataType() != b->GetDataType())
  {
    return fmt::format(
      "{} is {} in {}, {} in {}", title, a->GetClassName(), nameOfA, b->GetClassName(), nameOfB);
  }
  if (auto* textsOfA = vtkStringArray::SafeDownCast(a))
  {
    auto* textsOfB = vtkStringArray::SafeDownCast(b);
    for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
    {
      if (textsOfA->GetValue(i) != textsOfB->GetValue(i))
      {
        return fmt::format("{}: text {} is \"{}\" in {}, \"{}\" in {}", title, i,
          Printable(textsOfA->GetValue(i)), nameOfA, Printable(textsOfB->GetValue(i)), nameOfB);
      }
    }
    return {};
  }
  const ArrayView viewOfA = ViewOf(a, "field array");
  const ArrayView viewOfB = ViewOf(b, "field array");
  std::string difference = CompareDescription(viewOfA, viewOfB, nameOfA, nameOfB);
  for (vtkIdType i = 0; i < a->GetNumberOfTuples() && difference.empty(); ++i)
  {
    if (std::memcmp(viewOfA.Tuple(i), viewOfB.Tuple(i), viewOfA.TupleBytes) != 0)
    {
      difference = fmt::format("{}: tuple {} is {} in {}, {} in {}", title, i, viewOfA.Text(i),
        nameOfA, viewOfB.Text(i), nameOfB);
    }
  }
  return difference;
}

std::string CompareFieldData(
  vtkFieldData* a, vtkFieldData* b, const std::string& nameOfA, const std::string& nameOfB)
{
  const auto title = [](vtkAbstractArray* array)
  { return fmt::format("field array '{}'", Printable(array->GetName() ? array->GetName() : "")); };
  for (int i = 0; i < std::max(a->GetNumberOfArrays(), b->GetNumberOfArrays()); ++i)
  {
    vtkAbstractArray* arrayOfA = i < a->GetNumberOfArrays() ? a->GetAbstractArray(i) : nullptr;
    vtkAbstractArray* arrayOfB = i < b->GetNumberOfArrays() ? b->GetAbstractArray(i) : nullptr;
    if (!arrayOfA || !arrayOfB)
    {
      return fmt::format(
        "{} is in {} only", title(arrayOfA ? arrayOfA : arrayOfB), arrayOfA ? nameOfA : nameOfB);
    }
    if (title(arrayOfA) != title(arrayOfB))
    {
      return fmt::format("field array number {} is {} in {}, {} in {}", i, title(arrayOfA), nameOfA,
        title(arrayOfB), nameOfB);
    }
    std::string difference = CompareFieldArrays(arrayOfA, arrayOfB, nameOfA, nameOfB);
    if (!difference.empty())
    {
      return difference;
    }
  }
  return {};
}

std::string CornersText(const GridView& grid, std::size_t cell)
{
  const Tet tet = grid.Corners(cell);
  std::string text;
  for (const std::int64_t id : tet)
  {
    text += (text.empty() ? "" : ", ") + grid.Coordinates.Text(id);
  }
  return text;
}

} // anonymous namespace

//------------------------------------------------------------------------------
Comparison::Comparison(std::string first, std::string second, std::uint8_t keptOrder)
  : First{ std::move(first), {}, {} }
  , Second{ std::move(second), {}, {} }
  , Kept(keptOrder)
{
}

//------------------------------------------------------------------------------
std::string Comparison::Compare(const GridView& first, const GridView& second)
{
  const std::string& a = this->First.Name;
  const std::string& b = this->Second.Name;
  if (first.Points != second.Points)
  {
    return fmt::format("{} has {} points, {} has {}", a, first.Points, b, second.Points);
  }
  if (first.Cells != second.Cells)
  {
    return fmt::format("{} has {} tetrahedra, {} has {}", a, first.Cells, b, second.Cells);
  }
  std::string difference;
  if (first.Points > 0)
  {
    difference = CompareDescription(first.Coordinates, second.Coordinates, a, b);
  }
  if (difference.empty())
  {
    difference = CompareDescriptions(first.PointArrays, second.PointArrays, a, b);
  }
  if (difference.empty())
  {
    difference = CompareDescriptions(first.CellArrays, second.CellArrays, a, b);
  }
  if (difference.empty())
  {
    difference = this->CompareOrdered(first, second);
  }
  if (difference.empty() && this->Kept != gatun::KeepAll)
  {
    difference = this->CompareUnordered(first, second);
  }
  if (difference.empty())
  {
    difference = CompareFieldData(first.Field, second.Field, a, b);
  }
  return difference;
}

//------------------------------------------------------------------------------
std::string Comparison::CompareOrdered(const GridView& first, const GridView& second) const
{
  const auto compare = [&](const ArrayView& a, const ArrayView& b, std::size_t count,
                         const char* what) -> std::string
  {
    if (count == 0 || std::memcmp(a.Bytes, b.Bytes, count * a.TupleBytes) == 0)
    {
      return {};
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (std::memcmp(a.Tuple(i), b.Tuple(i), a.TupleBytes) != 0)
      {
        return fmt::format("{} of {} {}: {} in {}, {} in {}", a.Title, what, i, a.Text(i),
          this->First.Name, b.Text(i), this->Second.Name);
      }
    }
    return {};
  };

  std::string difference;
  if (this->Kept & gatun::KeepPoints)
  {
    difference = compare(first.Coordinates, second.Coordinates, first.Points, "point");
    for (std::size_t i = 0; i < first.PointArrays.size() && difference.empty(); ++i)
    {
      difference = compare(first.PointArrays[i], second.PointArrays[i], first.Points, "point");
    }
  }
  if (this->Kept & gatun::KeepCells)
  {
    for (std::size_t i = 0; i < first.CellArrays.size() && difference.empty(); ++i)
    {
      difference = compare(first.CellArrays[i], second.CellArrays[i], first.Cells, "cell");
    }
  }
  constexpr std::uint8_t all = gatun::KeepAll;
  for (std::size_t i = 0; i < first.Cells && this->Kept == all && difference.empty(); ++i)
  {
    const Tet a = first.Corners(i);
    const Tet b = second.Corners(i);
    if (a != b)
    {
      difference = fmt::format("the corners of cell {}: points {}, {}, {}, {} in {}, "
                               "{}, {}, {}, {} in {}",
        i, a[0], a[1], a[2], a[3], this->First.Name, b[0], b[1], b[2], b[3], this->Second.Name);
    }
  }
  return difference;
}

//------------------------------------------------------------------------------
std::string Comparison::CompareUnordered(const GridView& first, const GridView& second)
{
  const bool keepCorners = (this->Kept & gatun::KeepCorners) != 0;
  const auto add = [this](Side& side, const GridView& grid)
  {
    const bool isFirst = side.Points.size() != grid.Points || side.Cells.size() != grid.Cells;
    if (isFirst)
    {
      side.Points =
        this->Kept & gatun::KeepPoints ? Numbered(grid.Points) : std::vector<Hash>(grid.Points);
      side.Cells =
        this->Kept & gatun::KeepCells ? Numbered(grid.Cells) : std::vector<Hash>(grid.Cells);
    }
    AddArrays(side.Points, { grid.Coordinates });
    AddArrays(side.Points, grid.PointArrays);
    AddArrays(side.Cells, grid.CellArrays);
  };
  add(this->First, first);
  add(this->Second, second);

  Complex a = MakeComplex(first, this->First.Points, this->First.Cells, keepCorners);
  Complex b = MakeComplex(second, this->Second.Points, this->Second.Cells, keepCorners);
  // Both are refined by the same number of rounds, or labels could not be compared.
  std::size_t classes = CountDistinct(a.Points);
  bool same = Sorted(a.Points) == Sorted(b.Points);
  while (same && classes < a.Points.size())
  {
    a.Refine();
    b.Refine();
    same = Sorted(a.Points) == Sorted(b.Points);
    const std::size_t now = CountDistinct(a.Points);
    if (now == classes)
    {
      break;
    }
    classes = now;
  }
  this->Ambiguous = a.Points.size() - classes;
  same = same && Sorted(a.HashTets()) == Sorted(b.HashTets());
  if (same && this->Ambiguous > 0)
  {
    std::size_t budget = std::max<std::size_t>(1000 * a.Tets.size(), 10000000);
    std::size_t budgetOfSecond = budget;
    std::vector<Hash> partsOfFirst;
    std::vector<Hash> partsOfSecond;
    if (!a.HashAmbiguousParts(budget, partsOfFirst) ||
      !b.HashAmbiguousParts(budgetOfSecond, partsOfSecond))
    {
      return fmt::format("undecided: {} points coincide with others in all values and neighbours, "
                         "too many to try all ways to match them; pack with --keep-order all to "
                         "compare place by place",
        this->Ambiguous);
    }
    same = partsOfFirst == partsOfSecond;
  }
  if (same)
  {
    return {};
  }
  // Look closer, at this step alone.
  std::string difference = this->ExplainPoints(first, second);
  if (difference.empty())
  {
    difference = this->ExplainCells(first, second);
  }
  if (difference.empty())
  {
    difference = fmt::format("{} and {} have the same points, cells and values, but these do not "
                             "belong together in the same way",
      this->First.Name, this->Second.Name);
  }
  return difference;
}

//------------------------------------------------------------------------------
std::string Comparison::ExplainPoints(const GridView& first, const GridView& second) const
{
  const std::vector<Hash> placesOfFirst = HashesOf(first.Coordinates, first.Points, {});
  const std::vector<Hash> placesOfSecond = HashesOf(second.Coordinates, second.Points, {});
  const std::size_t lost = FirstMissing(placesOfSecond, placesOfFirst);
  if (lost != None)
  {
    return fmt::format("point {} of {}, at {}, is not in {}", lost, this->Second.Name,
      second.Coordinates.Text(lost), this->First.Name);
  }
  for (std::size_t j = 0; j < first.PointArrays.size(); ++j)
  {
    const ArrayView& array = second.PointArrays[j];
    const std::vector<Hash> valuesOfFirst =
      HashesOf(first.PointArrays[j], first.Points, placesOfFirst);
    const std::vector<Hash> valuesOfSecond = HashesOf(array, second.Points, placesOfSecond);
    const std::size_t i = FirstMissing(valuesOfSecond, valuesOfFirst);
    if (i != None)
    {
      const auto same = std::find(placesOfFirst.begin(), placesOfFirst.end(), placesOfSecond[i]);
      return fmt::format("{} at {} (point {} of {}): {} in {}, {} in {}", array.Title,
        second.Coordinates.Text(i), i, this->Second.Name,
        first.PointArrays[j].Text(same - placesOfFirst.begin()), this->First.Name, array.Text(i),
        this->Second.Name);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string Comparison::ExplainCells(const GridView& first, const GridView& second) const
{
  const bool keepCorners = (this->Kept & gatun::KeepCorners) != 0;
  const auto tets = [keepCorners](const GridView& grid)
  {
    std::vector<Hash> points = HashesOf(grid.Coordinates, grid.Points, {});
    AddArrays(points, grid.PointArrays);
    return MakeComplex(grid, points, std::vector<Hash>(grid.Cells), keepCorners).HashTets();
  };
  const std::vector<Hash> tetsOfFirst = tets(first);
  const std::vector<Hash> tetsOfSecond = tets(second);
  const std::size_t lost = FirstMissing(tetsOfSecond, tetsOfFirst);
  if (lost != None)
  {
    return fmt::format("cell {} of {}, with corners {}, is not in {}", lost, this->Second.Name,
      CornersText(second, lost), this->First.Name);
  }
  for (std::size_t j = 0; j < first.CellArrays.size(); ++j)
  {
    const ArrayView& array = second.CellArrays[j];
    const std::vector<Hash> valuesOfFirst = HashesOf(first.CellArrays[j], first.Cells, tetsOfFirst);
    const std::vector<Hash> valuesOfSecond = HashesOf(array, second.Cells, tetsOfSecond);
    const std::size_t i = FirstMissing(valuesOfSecond, valuesOfFirst);
    if (i != None)
    {
      const auto same = std::find(tetsOfFirst.begin(), tetsOfFirst.end(), tetsOfSecond[i]);
      return fmt::format("{} of cell {} of {}, with corners {}: {} in {}, {} in {}", array.Title, i,
        this->Second.Name, CornersText(second, i),
        first.CellArrays[j].Text(same - tetsOfFirst.begin()), this->First.Name, array.Text(i),
        this->Second.Name);
    }
  }
  return {};
}
}
