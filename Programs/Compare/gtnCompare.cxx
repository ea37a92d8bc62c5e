// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnCompare.h"

#include "gtnCellHash.h"
#include "gtnNames.h"
#include "gtnText.h"

#include "gatunParallel.h"
#include "gatunTypes.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
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

// Hashes for elements whose order is kept, and for others.
std::vector<Hash> Numbered(std::size_t count, bool isKept)
{
  std::vector<Hash> hashes(count);
  for (std::size_t i = 0; i < count && isKept; ++i)
  {
    hashes[i] = { i, 1 };
  }
  return hashes;
}

void AddArray(std::vector<Hash>& hashes, const ArrayView& array)
{
  ForEach(hashes.size(),
    [&](std::size_t i) { hashes[i] = HashOf(array.Tuple(i), array.TupleBytes, hashes[i]); });
}

// Adds the type and the points of each cell.
void AddCorners(std::vector<Hash>& hashes, const GridView& grid, const std::vector<Hash>& points,
  bool keepCorners)
{
  ForEach(hashes.size(),
    [&](std::size_t cell)
    { hashes[cell] = HashOfCell(grid, cell, points, keepCorners, hashes[cell]); });
}

// "points 1, 2, 3" of a cell, with the faces of a polyhedron.
std::string IdsText(const GridView& grid, std::size_t cell)
{
  const auto list = [](std::span<const std::int64_t> ids)
  {
    constexpr std::size_t enough = 16;
    std::vector<std::string> texts;
    for (const std::int64_t id : ids.first(std::min(ids.size(), enough)))
    {
      texts.push_back(std::to_string(id));
    }
    return Join(texts) + (ids.size() > enough ? ", ..." : "");
  };
  const auto faces = grid.GetFaces(cell);
  return "points " + list(grid.GetIds(cell)) + (faces.empty() ? "" : " with faces " + list(faces));
}

// The elements of hashes that the others do not have, or not as often. Sorted.
std::vector<Hash> Missing(const std::vector<Hash>& hashes, const std::vector<Hash>& others)
{
  const std::vector<Hash> own = Sorted(hashes);
  const std::vector<Hash> sorted = Sorted(others);
  std::vector<Hash> missing;
  std::set_difference(
    own.begin(), own.end(), sorted.begin(), sorted.end(), std::back_inserter(missing));
  return missing;
}

// Whether all elements of two sorted sets are in the other, but in the first one not as often.
bool IsJoined(const std::vector<Hash>& first, const std::vector<Hash>& second)
{
  std::vector<Hash> distinct;
  std::unique_copy(second.begin(), second.end(), std::back_inserter(distinct));
  return std::includes(second.begin(), second.end(), first.begin(), first.end()) &&
    std::includes(first.begin(), first.end(), distinct.begin(), distinct.end());
}

// The property in which two sets differ, an element of the second that shows it, and an element of
// the first that is like it in the properties before.
struct Mismatch
{
  std::size_t Property;
  std::size_t First;
  std::size_t Second;
};

using Property = std::function<void(std::vector<Hash>&)>;

// Adds properties to the hashes of two sets, and compares the sets. Only if they differ, this is
// done again, property by property.
// isJoined: equal elements of the second set may be fewer in the first one.
std::optional<Mismatch> CompareSets(std::vector<Hash>& first, std::vector<Hash>& second,
  const std::vector<std::pair<Property, Property>>& properties, bool isJoined = false)
{
  std::vector<Hash> a = first;
  std::vector<Hash> b = second;
  for (const auto& [addToFirst, addToSecond] : properties)
  {
    addToFirst(a);
    addToSecond(b);
  }
  std::swap(a, first);
  std::swap(b, second);
  if (isJoined ? IsJoined(Sorted(first), Sorted(second)) : Sorted(first) == Sorted(second))
  {
    return {};
  }
  for (std::size_t property = 0;; ++property)
  {
    const std::vector<Hash> beforeA = a;
    const std::vector<Hash> beforeB = b;
    properties[property].first(a);
    properties[property].second(b);
    std::vector<Hash> lost = Missing(b, a);
    if (isJoined)
    {
      const std::vector<Hash> sorted = Sorted(a);
      std::erase_if(lost,
        [&](const Hash& hash) { return std::binary_search(sorted.begin(), sorted.end(), hash); });
    }
    if (lost.empty() && property + 1 < properties.size())
    {
      continue;
    }
    if (lost.empty()) // the first set has elements more often
    {
      return Mismatch{ 0, 0, 0 };
    }
    const auto isIn = [](const std::vector<Hash>& sorted, const Hash& hash)
    { return std::binary_search(sorted.begin(), sorted.end(), hash); };
    const std::vector<Hash> lostOfFirst = Missing(a, b);
    std::size_t j = 0;
    while (!isIn(lost, b[j]))
    {
      ++j;
    }
    std::size_t i = 0;
    while (i < a.size() && !(beforeA[i] == beforeB[j] && isIn(lostOfFirst, a[i])))
    {
      ++i;
    }
    return Mismatch{ property, i, j };
  }
}

// The properties of elements that have arrays.
std::vector<std::pair<Property, Property>> PropertiesOf(
  const std::vector<ArrayView>& first, const std::vector<ArrayView>& second)
{
  std::vector<std::pair<Property, Property>> properties;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    properties.emplace_back([&array = first[i]](std::vector<Hash>& hashes)
      { AddArray(hashes, array); },
      [&array = second[i]](std::vector<Hash>& hashes) { AddArray(hashes, array); });
  }
  return properties;
}

std::string TitleOfField(vtkAbstractArray* array)
{
  return fmt::format(
    "field array '{}'", MakePrintableLine(array->GetName() ? array->GetName() : ""));
}

std::string CornersText(const GridView& grid, std::size_t cell)
{
  std::vector<std::string> texts;
  for (const std::int64_t id : grid.GetIds(cell))
  {
    texts.push_back(grid.PointArrays[0].Text(static_cast<std::size_t>(id)));
  }
  return Join(texts);
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
void Comparison::BeginMesh()
{
  this->Indistinguishable = this->GetIndistinguishablePoints();
  for (Side* side : { &this->First, &this->Second })
  {
    side->Points.clear();
    side->Cells.clear();
  }
}

//------------------------------------------------------------------------------
std::size_t Comparison::GetIndistinguishablePoints() const
{
  const std::vector<Hash> sorted = Sorted(this->First.Points);
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    count +=
      (i > 0 && sorted[i] == sorted[i - 1]) || (i + 1 < sorted.size() && sorted[i] == sorted[i + 1])
      ? 1
      : 0;
  }
  return std::max(count, this->Indistinguishable);
}

//------------------------------------------------------------------------------
bool Comparison::HavePoints(const GridView& first, const GridView& second) const
{
  return first.Points == second.Points || (this->MayBeJoined && first.Points < second.Points);
}

//------------------------------------------------------------------------------
bool Comparison::AreAlike(const GridView& first, const GridView& second) const
{
  return this->HavePoints(first, second) && first.Cells == second.Cells &&
    first.HasCoordinates() == (first.Points > 0);
}

//------------------------------------------------------------------------------
Differences Comparison::MatchArrays(GridView& first, GridView& second) const
{
  const std::string& a = this->First.Name;
  const std::string& b = this->Second.Name;
  Differences differences;
  if (!this->HavePoints(first, second))
  {
    differences.push_back(
      fmt::format("{} has {} points, {} has {}", a, first.Points, b, second.Points));
  }
  if (first.Cells != second.Cells)
  {
    differences.push_back(
      fmt::format("{} has {} cells, {} has {}", a, first.Cells, b, second.Cells));
  }
  this->Match(first.PointArrays, second.PointArrays, differences);
  this->Match(first.CellArrays, second.CellArrays, differences);
  return differences;
}

//------------------------------------------------------------------------------
Differences Comparison::CompareValues(const GridView& first, const GridView& second)
{
  Differences differences;
  if (first.Points < second.Points)
  {
    this->JoinedPoints = second.Points - first.Points;
    this->Kept &= static_cast<std::uint8_t>(~(gatun::KeepPoints | gatun::KeepCorners));
  }
  const auto compare = [&](const std::vector<ArrayView>& a, const std::vector<ArrayView>& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      if (const std::string difference = this->CompareTuples(a[i], b[i]); !difference.empty())
      {
        differences.push_back(difference);
      }
    }
  };
  if (this->Kept & gatun::KeepPoints)
  {
    compare(first.PointArrays, second.PointArrays);
  }
  if (this->Kept & gatun::KeepCells)
  {
    compare(first.CellArrays, second.CellArrays);
  }
  std::string difference;
  if (this->Kept == gatun::KeepAll)
  {
    difference = this->CompareInOrder(first, second);
  }
  else if (differences.empty())
  {
    difference = this->ComparePoints(first, second);
    difference = difference.empty() ? this->CompareCells(first, second) : difference;
  }
  if (!difference.empty())
  {
    differences.push_back(difference);
  }
  return differences;
}

//------------------------------------------------------------------------------
// Compares the cells one by one.
std::string Comparison::CompareInOrder(const GridView& first, const GridView& second) const
{
  for (std::size_t i = 0; i < first.Cells; ++i)
  {
    if (first.GetType(i) != second.GetType(i))
    {
      return fmt::format("cell {} is a {} in {}, a {} in {}", i, NameOfCellType(first.GetType(i)),
        this->First.Name, NameOfCellType(second.GetType(i)), this->Second.Name);
    }
    if (!std::ranges::equal(first.GetIds(i), second.GetIds(i)) ||
      !std::ranges::equal(first.GetFaces(i), second.GetFaces(i)))
    {
      return fmt::format("the corners of cell {}: {} in {}, {} in {}", i, IdsText(first, i),
        this->First.Name, IdsText(second, i), this->Second.Name);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string Comparison::CompareTuples(const ArrayView& first, const ArrayView& second) const
{
  const auto count = static_cast<std::size_t>(first.Owner->GetNumberOfTuples());
  if (count == 0 || std::memcmp(first.Bytes, second.Bytes, count * first.TupleBytes) == 0)
  {
    return {};
  }
  std::size_t i = 0;
  while (std::memcmp(first.Tuple(i), second.Tuple(i), first.TupleBytes) == 0)
  {
    ++i;
  }
  const char* const what = first.Title.starts_with("cell") ? "cell"
    : first.Title.starts_with("field")                     ? "tuple"
                                                           : "point";
  return fmt::format("{} of {} {}: {} in {}, {} in {}", first.Title, what, i, first.Text(i),
    this->First.Name, second.Text(i), this->Second.Name);
}

//------------------------------------------------------------------------------
// Finds the arrays that both have.
void Comparison::Match(
  std::vector<ArrayView>& first, std::vector<ArrayView>& second, Differences& differences) const
{
  std::vector<ArrayView> ofFirst;
  std::vector<ArrayView> ofSecond;
  for (ArrayView& view : first)
  {
    const auto found = std::find_if(second.begin(), second.end(),
      [&](const ArrayView& other) { return other.Title == view.Title; });
    if (found == second.end())
    {
      differences.push_back(fmt::format("{} is in {} only", view.Title, this->First.Name));
      continue;
    }
    const bool areAlike = view.Kind == found->Kind;
    if (!areAlike || view.Roles != found->Roles)
    {
      differences.push_back(fmt::format("{} is {}{} in {}, {}{} in {}", view.Title, view.Kind,
        view.Roles, this->First.Name, found->Kind, found->Roles, this->Second.Name));
    }
    this->CompareKeys(view.Title, view.Keys, found->Keys, differences);
    if (areAlike)
    {
      ofFirst.push_back(std::move(view));
      ofSecond.push_back(std::move(*found));
    }
    second.erase(found);
  }
  for (const ArrayView& view : second)
  {
    differences.push_back(fmt::format("{} is in {} only", view.Title, this->Second.Name));
  }
  first = std::move(ofFirst);
  second = std::move(ofSecond);
}

//------------------------------------------------------------------------------
void Comparison::CompareKeys(const std::string& title, const std::vector<std::string>& first,
  const std::vector<std::string>& second, Differences& differences) const
{
  const auto list = [&](const std::vector<std::string>& some,
                      const std::vector<std::string>& others, const std::string& name)
  {
    for (const std::string& key : some)
    {
      if (std::find(others.begin(), others.end(), key) == others.end())
      {
        differences.push_back(fmt::format("{}: the key {} is in {} only", title, key, name));
      }
    }
  };
  list(first, second, this->First.Name);
  list(second, first, this->Second.Name);
}

//------------------------------------------------------------------------------
Differences Comparison::CompareFieldData(const GridView& first, const GridView& second) const
{
  const auto list = [](const GridView& grid)
  {
    std::vector<vtkAbstractArray*> arrays;
    for (int i = 0; i < grid.Grid->GetFieldData()->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(grid.Grid->GetFieldData()->GetAbstractArray(i));
    }
    return arrays;
  };
  Differences differences;
  std::vector<vtkAbstractArray*> others = list(second);
  for (vtkAbstractArray* array : list(first))
  {
    const auto found = std::find_if(others.begin(), others.end(),
      [&](vtkAbstractArray* other) { return TitleOfField(other) == TitleOfField(array); });
    if (found == others.end())
    {
      differences.push_back(fmt::format("{} is in {} only", TitleOfField(array), this->First.Name));
      continue;
    }
    this->CompareFieldArrays(array, *found, differences);
    others.erase(found);
  }
  for (vtkAbstractArray* array : others)
  {
    differences.push_back(fmt::format("{} is in {} only", TitleOfField(array), this->Second.Name));
  }
  return differences;
}

//------------------------------------------------------------------------------
void Comparison::CompareFieldArrays(
  vtkAbstractArray* first, vtkAbstractArray* second, Differences& differences) const
{
  const std::string title = TitleOfField(first);
  const std::string& nameOfA = this->First.Name;
  const std::string& nameOfB = this->Second.Name;
  const auto kind = [](vtkAbstractArray* array)
  {
    return fmt::format("{} tuples of {}, {} component(s)", array->GetNumberOfTuples(),
      array->GetDataTypeAsString(), array->GetNumberOfComponents());
  };
  this->CompareKeys(title, KeyTexts(first), KeyTexts(second), differences);
  if (kind(first) != kind(second))
  {
    differences.push_back(
      fmt::format("{} is {} in {}, {} in {}", title, kind(first), nameOfA, kind(second), nameOfB));
    return;
  }
  auto* const texts = vtkStringArray::SafeDownCast(first);
  if (!texts && !vtkDataArray::SafeDownCast(first))
  {
    differences.push_back(
      fmt::format("{} is a {}, whose values are not compared", title, first->GetClassName()));
    return;
  }
  if (!texts)
  {
    const ArrayView a(first, "field array");
    const ArrayView b(second, "field array");
    const std::string difference = a.Roles == b.Roles
      ? this->CompareTuples(a, b)
      : fmt::format(
          "{} has components{} in {},{} in {}", title, a.Roles, nameOfA, b.Roles, nameOfB);
    if (!difference.empty())
    {
      differences.push_back(difference);
    }
    return;
  }
  for (vtkIdType j = 0; j < first->GetNumberOfValues(); ++j)
  {
    const std::string& ofA = texts->GetValue(j);
    const std::string& ofB = vtkStringArray::SafeDownCast(second)->GetValue(j);
    if (ofA != ofB)
    {
      differences.push_back(fmt::format("{}: string {} is \"{}\" in {}, \"{}\" in {}", title, j,
        MakePrintableLine(ofA), nameOfA, MakePrintableLine(ofB), nameOfB));
      return;
    }
  }
}

//------------------------------------------------------------------------------
std::string Comparison::ComparePoints(const GridView& first, const GridView& second)
{
  const bool isKept = (this->Kept & gatun::KeepPoints) != 0;
  if (this->First.Points.size() != first.Points)
  {
    this->First.Points = Numbered(first.Points, isKept);
    this->Second.Points = Numbered(second.Points, isKept);
  }
  const auto mismatch = isKept
    ? std::nullopt
    : CompareSets(this->First.Points, this->Second.Points,
        PropertiesOf(first.PointArrays, second.PointArrays), this->JoinedPoints > 0);
  if (!mismatch)
  {
    return {};
  }
  const auto [property, i, j] = *mismatch;
  const ArrayView& array = second.PointArrays[property];
  const std::string place = second.PointArrays[0].Text(j);
  return property == 0 ? fmt::format("point {} of {}, at {}, is not in {}", j, this->Second.Name,
                           place, this->First.Name)
                       : fmt::format("{} at {} (point {} of {}): {} in {}, {} in {}", array.Title,
                           place, j, this->Second.Name, first.PointArrays[property].Text(i),
                           this->First.Name, array.Text(j), this->Second.Name);
}

//------------------------------------------------------------------------------
std::string Comparison::CompareCells(const GridView& first, const GridView& second)
{
  const bool isKept = (this->Kept & gatun::KeepCells) != 0;
  const bool keepCorners = (this->Kept & gatun::KeepCorners) != 0;
  if (this->First.Cells.size() != first.Cells)
  {
    this->First.Cells = Numbered(first.Cells, isKept);
    this->Second.Cells = Numbered(second.Cells, isKept);
  }
  std::vector<std::pair<Property, Property>> properties =
    PropertiesOf(first.CellArrays, second.CellArrays);
  properties.insert(properties.begin(),
    { [&](std::vector<Hash>& hashes)
      { AddCorners(hashes, first, this->First.Points, keepCorners); },
      [&](std::vector<Hash>& hashes)
      { AddCorners(hashes, second, this->Second.Points, keepCorners); } });
  const auto mismatch = CompareSets(this->First.Cells, this->Second.Cells, properties);
  if (!mismatch)
  {
    return {};
  }
  const auto [property, i, j] = *mismatch;
  const std::string cell =
    fmt::format("cell {} of {}, with corners {}", j, this->Second.Name, CornersText(second, j));
  if (property == 0)
  {
    return fmt::format("{}, is not in {}", cell, this->First.Name);
  }
  const ArrayView& array = second.CellArrays[property - 1];
  return fmt::format("{} of {}: {} in {}, {} in {}", array.Title, cell,
    first.CellArrays[property - 1].Text(i), this->First.Name, array.Text(j), this->Second.Name);
}
}
