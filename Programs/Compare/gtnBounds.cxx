// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnBounds.h"

#include "gatunFileReader.h"
#include "gatunQuantizer.h"

#include "vtkDataArray.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace gtn
{
namespace
{
bool HasErrors(const gatun::FileReader& file, std::size_t array)
{
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    for (std::uint32_t c = 0; c < file.GetArrays()[array].Components; ++c)
    {
      if (file.GetRounding(array, c, step))
      {
        return true;
      }
    }
  }
  return false;
}

// The elements in the order of their hashes, those of equal ones in the order of their keys.
// Without hashes, in their own order.
std::vector<std::size_t> Order(const std::vector<Hash>& hashes, const std::vector<gatun::Key>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  if (hashes.size() == keys.size())
  {
    std::sort(order.begin(), order.end(),
      [&](std::size_t l, std::size_t r)
      { return std::pair(hashes[l], keys[l]) < std::pair(hashes[r], keys[r]); });
  }
  return order;
}

std::vector<gatun::Key> ReadKeys(const ArrayView& array, gatun::ScalarType type, std::size_t c)
{
  std::vector<gatun::Key> keys(static_cast<std::size_t>(array.Owner->GetNumberOfTuples()));
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    keys[i] = gatun::PlainKeys::ReadPlain(type, array.Tuple(i) + c * gatun::SizeOf(type));
  }
  return keys;
}

// Whether values were rounded by more than their bound means for the original: a file may claim any
// step beside its bound.
bool IsTooCoarse(
  const gatun::Quantizer& rounding, gatun::ScalarType type, const std::vector<gatun::Key>& original)
{
  gatun::FiniteRange range;
  for (const auto key : original)
  {
    const double number = gatun::PlainKeys::PlainToNumber(type, key);
    if (std::isfinite(number))
    {
      range.Include(number);
    }
  }
  const auto allowed = gatun::MakeQuantizer(type, rounding.Bound, range);
  return !allowed || rounding.Step > allowed.Step;
}
}

//------------------------------------------------------------------------------
/** Takes the arrays with errors out of the grids. */
std::vector<BoundedComparison::Pair> BoundedComparison::Take(
  GridView& packed, GridView& original, const gatun::FileReader& mesh, bool ofPoints)
{
  std::vector<Pair> taken;
  auto& first = ofPoints ? packed.PointArrays : packed.CellArrays;
  auto& second = ofPoints ? original.PointArrays : original.CellArrays;
  const auto& arrays = mesh.GetArrays();
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    if ((arrays[a].Where == gatun::Association::Point) != ofPoints || !HasErrors(mesh, a))
    {
      continue;
    }
    // The coordinates come first among the points.
    const auto find = [&](std::vector<ArrayView>& views)
    {
      return std::find_if(views.begin() + (ofPoints && !views.empty() ? 1 : 0), views.end(),
        [&](const ArrayView& view) { return view.Owner->GetName() == arrays[a].Name; });
    };
    const auto one = find(first);
    const auto other = find(second);
    if (one != first.end() && other != second.end() && one->Kind == other->Kind)
    {
      taken.push_back({ a, *one, *other });
      first.erase(one);
      second.erase(other);
    }
  }
  return taken;
}

//------------------------------------------------------------------------------
std::string BoundedComparison::CheckArray(
  const Pair& pair, const gatun::FileReader& mesh, std::size_t step, bool ofPoints)
{
  const auto& array = mesh.GetArrays()[pair.Array];
  for (std::uint32_t c = 0; c < array.Components; ++c)
  {
    const auto rounding = mesh.GetRounding(pair.Array, c, step);
    const auto packed = ReadKeys(pair.Packed, array.Type, c);
    const auto original = ReadKeys(pair.Original, array.Type, c);
    if (packed.size() != original.size())
    {
      return pair.Packed.Title +
        " has errors, and points were joined; pack the file with --keep-apart "
        "to compare them";
    }
    const auto first = Order(this->Others.GetFirst(ofPoints), packed);
    const auto second = Order(this->Others.GetSecond(ofPoints), original);
    bool isRounded = false;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      const auto stored = packed[first[i]];
      const auto exact = original[second[i]];
      if (stored == exact)
      {
        continue;
      }
      if (!rounding || !rounding.IsWithin(array.Type, exact, stored))
      {
        return fmt::format("{} is not within its bound ({}): {} instead of {}", pair.Packed.Title,
          ToString(rounding.Bound), pair.Packed.Text(first[i]), pair.Original.Text(second[i]));
      }
      isRounded = true;
      this->Worst = std::max(
        this->Worst, rounding.Measure(array.Type, exact, stored) / rounding.GetAllowed(array.Type));
    }
    if (isRounded && IsTooCoarse(rounding, array.Type, original))
    {
      return fmt::format(
        "{} is rounded by more than its bound ({}) allows for the range of component "
        "{} of the original",
        pair.Packed.Title, ToString(rounding.Bound), c);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void BoundedComparison::BeginMesh()
{
  this->Others.BeginMesh();
  this->AreValuesEqual = true;
}

//------------------------------------------------------------------------------
Differences BoundedComparison::Compare(
  GridView packed, GridView original, const gatun::FileReader& mesh, std::size_t step)
{
  Differences differences = this->Others.MatchArrays(packed, original);
  if (this->Others.AreAlike(packed, original) && this->AreValuesEqual)
  {
    const auto points = Take(packed, original, mesh, true);
    const auto cells = Take(packed, original, mesh, false);
    Differences values = this->Others.CompareValues(packed, original);
    for (const auto* pairs : { &points, &cells })
    {
      for (std::size_t i = 0; values.empty() && i < pairs->size(); ++i)
      {
        this->IsBounded = true;
        if (std::string wrong = this->CheckArray((*pairs)[i], mesh, step, pairs == &points);
            !wrong.empty())
        {
          values.push_back(std::move(wrong));
        }
      }
    }
    this->AreValuesEqual = values.empty();
    differences.insert(differences.end(), values.begin(), values.end());
  }
  const Differences fields = this->Others.CompareFieldData(packed, original);
  differences.insert(differences.end(), fields.begin(), fields.end());
  return differences;
}
}
