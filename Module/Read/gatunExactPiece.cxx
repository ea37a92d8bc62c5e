// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunExactPiece.h"

#include "gatunBytes.h"
#include "gatunGatherTuples.h"
#include "gatunPieceCells.h"
#include "gatunWithType.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
ExactPiece::ExactPiece(std::shared_ptr<ChunkCache> cache, const PieceRequest& request,
  const Region& region, const Progress& progress)
  : Decoder(std::move(cache))
  , Request(request)
{
  this->Decoder.SetRequest(request, progress);
  PieceCells all(this->Decoder.IsTetrahedral(),
    static_cast<std::size_t>(this->Decoder.GetNumberOfCells()),
    static_cast<std::size_t>(this->Decoder.GetConnectivitySize()),
    static_cast<std::size_t>(this->Decoder.GetFacesSize()));
  this->Decoder.Fill(all.GetTarget(), progress);
  std::vector<char> isChosen(all.GetNumber(), 1);
  if (region.Box)
  {
    this->ChooseInBox(all, *region.Box, isChosen);
  }
  if (region.Interval)
  {
    this->ChooseByValue(all, *region.Interval, isChosen);
  }
  std::vector<std::int64_t> placeOf(
    static_cast<std::size_t>(this->Decoder.GetNumberOfPoints()), -1);
  for (std::size_t cell = 0; cell < isChosen.size(); ++cell)
  {
    if (isChosen[cell])
    {
      this->Cells.push_back(cell);
      all.ForEachPoint(cell, [&](std::size_t point) { placeOf[point] = 0; });
    }
  }
  for (std::size_t point = 0; point < placeOf.size(); ++point)
  {
    if (placeOf[point] == 0)
    {
      placeOf[point] = static_cast<std::int64_t>(this->Points.size());
      this->Points.push_back(point);
    }
  }
  this->Memory = std::make_unique<PieceCells>(all.Select(this->Cells, placeOf));
}

//------------------------------------------------------------------------------
ExactPiece::~ExactPiece() = default;

//------------------------------------------------------------------------------
void ExactPiece::ChooseInBox(const PieceCells& all, const Bounds& box, std::vector<char>& isChosen)
{
  const auto type = this->Decoder.GetFile()->GetCoordinateType();
  Bytes points(static_cast<std::size_t>(this->Decoder.GetNumberOfPoints()) * 3 * SizeOf(type));
  PieceTarget target;
  target.Points = points.data();
  this->Decoder.Fill(target);
  WithType(type, points.data(),
    [&](const auto* xyz)
    {
      for (std::size_t cell = 0; cell < isChosen.size(); ++cell)
      {
        Bounds own;
        own.fill(Range::MakeEmpty());
        all.ForEachPoint(cell,
          [&](std::size_t point)
          {
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
              own[axis].Include(static_cast<double>(xyz[3 * point + axis]));
            }
          });
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          isChosen[cell] &= own[axis].Min <= box[axis].Max && own[axis].Max >= box[axis].Min;
        }
      }
    });
}

//------------------------------------------------------------------------------
void ExactPiece::ChooseByValue(
  const PieceCells& all, const Region::Values& interval, std::vector<char>& isChosen)
{
  const auto& array = this->Decoder.GetFile()->GetArrays()[interval.Array];
  const bool ofPoints = array.Where == Association::Point;
  const auto tuples =
    ofPoints ? this->Decoder.GetNumberOfPoints() : this->Decoder.GetNumberOfCells();
  Bytes values(static_cast<std::size_t>(tuples) * array.Components * SizeOf(array.Type));
  auto request = this->Request;
  request.Arrays = { interval.Array };
  this->Decoder.SetRequest(request);
  PieceTarget target;
  target.Arrays = { values.data() };
  this->Decoder.Fill(target);
  this->Decoder.SetRequest(this->Request);
  WithComponent(array.Type, values.data(), array.Components,
    array.Components == 1 ? 0 : interval.Component,
    [&](auto&& getValue)
    {
      for (std::size_t cell = 0; cell < isChosen.size(); ++cell)
      {
        Range own = Range::MakeEmpty();
        if (ofPoints)
        {
          all.ForEachPoint(cell, [&](std::size_t point) { own.Include(getValue(point)); });
        }
        else
        {
          own.Include(getValue(cell));
        }
        isChosen[cell] &= own.Min <= interval.Within.Max && own.Max >= interval.Within.Min;
      }
    });
}

//------------------------------------------------------------------------------
std::uint64_t ExactPiece::GetConnectivitySize() const
{
  return this->Memory->GetConnectivitySize();
}

//------------------------------------------------------------------------------
std::uint64_t ExactPiece::GetFacesSize() const
{
  return this->Memory->GetFacesSize();
}

//------------------------------------------------------------------------------
void ExactPiece::Fill(const PieceTarget& target, const Progress& progress)
{
  this->Memory->Store(target);
  const auto points = this->Decoder.GetNumberOfPoints();
  const auto cells = this->Decoder.GetNumberOfCells();
  Bytes whole;
  // One buffer after the other, so that one is in memory twice.
  const auto copy = [&](auto* to, bool ofPoints, std::size_t tupleBytes, auto&& aim)
  {
    if (!to)
    {
      return;
    }
    const auto& numbers = ofPoints ? this->Points : this->Cells;
    whole.resize(static_cast<std::size_t>(ofPoints ? points : cells) * tupleBytes);
    PieceTarget own;
    const bool isDirect = numbers.size() == (ofPoints ? points : cells);
    aim(own, isDirect ? static_cast<void*>(to) : whole.data());
    this->Decoder.Fill(own, progress);
    if (!isDirect)
    {
      GatherTuples(whole.data(), numbers, tupleBytes, to);
    }
  };
  const auto& file = *this->Decoder.GetFile();
  copy(target.Points, true, 3 * SizeOf(file.GetCoordinateType()),
    [](PieceTarget& own, void* to) { own.Points = to; });
  copy(target.GlobalPointIds, true, sizeof(std::int64_t),
    [](PieceTarget& own, void* to) { own.GlobalPointIds = static_cast<std::int64_t*>(to); });
  copy(target.GlobalCellIds, false, sizeof(std::int64_t),
    [](PieceTarget& own, void* to) { own.GlobalCellIds = static_cast<std::int64_t*>(to); });
  copy(target.PointGhosts, true, 1,
    [](PieceTarget& own, void* to) { own.PointGhosts = static_cast<unsigned char*>(to); });
  copy(target.CellGhosts, false, 1,
    [](PieceTarget& own, void* to) { own.CellGhosts = static_cast<unsigned char*>(to); });
  for (std::size_t i = 0; i < target.Arrays.size(); ++i)
  {
    const auto& array = file.GetArrays()[this->Request.Arrays[i]];
    copy(target.Arrays[i], array.Where == Association::Point, array.Components * SizeOf(array.Type),
      [&](PieceTarget& own, void* to)
      {
        own.Arrays.resize(target.Arrays.size());
        own.Arrays[i] = to;
      });
  }
}
}
