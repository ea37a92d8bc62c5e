// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMetaTable.h"

#include "gatunTableParts.h"

namespace gatun
{
namespace
{
// Flags of time.
constexpr std::uint8_t FlagTime = 1;
constexpr std::uint8_t FlagMotion = 2;
constexpr std::uint8_t FlagPoints = 4; // the array of the points is described
constexpr std::uint8_t FlagFast = 8;
constexpr std::uint8_t AllFlags = FlagTime | FlagMotion | FlagPoints | FlagFast;
}

//------------------------------------------------------------------------------
ArrayDescription DescribePoints(ScalarType type)
{
  ArrayDescription points;
  points.Name = "coordinates";
  points.Type = type;
  points.Components = 3;
  return points;
}

//------------------------------------------------------------------------------
Bytes MetaTable::Write() const
{
  ByteWriter out;
  out.PutString(this->WriterVersion);
  out.PutVarint(this->Points);
  out.PutVarint(this->Tets);
  out.PutVarint(this->UnusedPoints);
  out.Put(static_cast<std::uint8_t>(this->CoordinateType));
  out.Put(static_cast<std::uint8_t>(this->WideIds));
  const bool hasPoints = this->PointArray != PointsDescription();
  out.Put(
    static_cast<std::uint8_t>((this->HasTime ? FlagTime : 0) | (this->PointsMove ? FlagMotion : 0) |
      (hasPoints ? FlagPoints : 0) | (this->Coding == Profile::Fast ? FlagFast : 0)));
  out.Put(this->Keep);
  out.PutVarint(this->ChunkSize);
  out.PutVarint(this->KeyStepInterval);
  for (const auto& range : this->Box)
  {
    PutRange(out, range);
  }
  if (hasPoints)
  {
    PutPoints(out, this->PointArray);
  }
  PutArrays(out, std::span(this->Arrays).first(this->GetListedArrays()));
  return Pack(out, SmallTable);
}

MetaTable MetaTable::Read(std::span<const std::uint8_t> bytes)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  MetaTable meta;
  meta.WriterVersion = in.GetString();
  meta.Points = in.GetVarint();
  meta.Tets = in.GetVarint();
  meta.UnusedPoints = in.GetVarint();
  meta.CoordinateType = GetScalarType(in);
  Check(IsFloating(meta.CoordinateType), "the coordinates have an unknown type");
  meta.WideIds = in.Get<std::uint8_t>() != 0;
  const auto flags = in.Get<std::uint8_t>();
  Check(flags <= AllFlags, "the meta data have unknown flags");
  meta.HasTime = (flags & FlagTime) != 0;
  meta.PointsMove = (flags & FlagMotion) != 0;
  meta.Coding = (flags & FlagFast) != 0 ? Profile::Fast : Profile::Small;
  Check(!meta.PointsMove || meta.HasTime, "points move in a file that has no time");
  meta.Keep = in.Get<std::uint8_t>();
  Check(meta.Keep <= KeepAll, "the kept order is unknown");
  meta.ChunkSize = GetSmall(in);
  meta.KeyStepInterval = GetSmall(in);
  for (auto& range : meta.Box)
  {
    range = GetRange(in);
  }
  if (flags & FlagPoints)
  {
    meta.PointArray = GetPoints(in);
  }
  meta.Arrays = GetArrays(in);
  if (meta.PointsMove)
  {
    meta.Arrays.push_back(DescribePoints(meta.CoordinateType));
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the meta data");
  return meta;
}
}
