// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCoarseCells.h"

#include "gatunCellShapes.h"
#include "gatunMergeTree.h"

#include <algorithm>

namespace gatun
{
namespace
{
template <typename Cell>
bool SimplifyAs(std::span<std::uint32_t> corners, std::span<const std::uint32_t> ancestors)
{
  Cell cell{};
  std::copy_n(corners.begin(), cell.size(), cell.begin());
  const bool isLeft = Simplify(cell, ancestors);
  std::copy(cell.begin(), cell.end(), corners.begin());
  return isLeft;
}

template <typename Id>
void StoreIds(const auto& ids, void* to)
{
  std::transform(
    ids.begin(), ids.end(), static_cast<Id*>(to), [](auto id) { return static_cast<Id>(id); });
}
}

//------------------------------------------------------------------------------
bool SimplifyCell(
  std::uint8_t type, std::span<std::uint32_t> corners, std::span<const std::uint32_t> ancestors)
{
  if (type == TetraType && corners.size() == 4)
  {
    return SimplifyAs<MergeTree::Tet>(corners, ancestors);
  }
  if (type == TriangleType && corners.size() == 3)
  {
    return SimplifyAs<MergeTree::Triangle>(corners, ancestors);
  }
  for (auto& corner : corners)
  {
    corner = ancestors[corner];
  }
  return true;
}

//------------------------------------------------------------------------------
std::uint8_t CoarseCells::GetType(std::size_t cell) const
{
  return this->IsTetrahedral() ? TetraType : this->Types[cell];
}

//------------------------------------------------------------------------------
void CoarseCells::Add(std::uint8_t type, std::span<const std::uint32_t> corners)
{
  if (!this->IsTetrahedral())
  {
    this->Begins.push_back(this->Corners.size());
    this->Types.push_back(type);
  }
  this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
}

//------------------------------------------------------------------------------
bool CoarseCells::AddSimplified(std::uint8_t type, std::span<const std::uint32_t> corners,
  std::span<const std::uint32_t> ancestors)
{
  const auto begin = this->Corners.size();
  this->Add(type, corners);
  const bool isLeft = SimplifyCell(type, std::span(this->Corners).subspan(begin), ancestors);
  if (!isLeft)
  {
    this->Corners.resize(begin);
    if (!this->IsTetrahedral())
    {
      this->Begins.pop_back();
      this->Types.pop_back();
    }
  }
  return isLeft;
}

//------------------------------------------------------------------------------
CoarseCells CoarseCells::Permute(std::span<const std::uint32_t> places) const
{
  std::vector<std::size_t> cellAt(places.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell)
  {
    cellAt[places[cell]] = cell;
  }
  CoarseCells cells(this->Form);
  for (const auto cell : cellAt)
  {
    cells.Add(this->GetType(cell), this->GetCorners(cell));
  }
  return cells;
}

//------------------------------------------------------------------------------
void CoarseCells::Store(const PieceTarget& target) const
{
  const auto store = [&](const auto& ids, void* to)
  {
    if (to && target.WideIds)
    {
      StoreIds<std::int64_t>(ids, to);
    }
    else if (to)
    {
      StoreIds<std::int32_t>(ids, to);
    }
  };
  store(this->Corners, target.Connectivity);
  if (this->IsTetrahedral())
  {
    return;
  }
  auto offsets = this->Begins;
  offsets.push_back(this->Corners.size());
  store(offsets, target.Offsets);
  if (target.Types)
  {
    std::copy(this->Types.begin(), this->Types.end(), target.Types);
  }
  if (target.FaceLocations)
  {
    std::fill_n(target.FaceLocations, this->GetCount(), std::int64_t{ -1 });
  }
}
}
