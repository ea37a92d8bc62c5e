// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMetaTable.h"

#include "gatunTableParts.h"

namespace gatun
{
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
  out.Put(static_cast<std::uint8_t>(this->HasTime));
  out.Put(this->Keep);
  out.PutVarint(this->ChunkTets);
  out.PutVarint(this->KeyStepInterval);
  for (const auto& range : this->Box)
  {
    PutRange(out, range);
  }
  PutArrays(out, this->Arrays);
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
  meta.HasTime = in.Get<std::uint8_t>() != 0;
  meta.Keep = in.Get<std::uint8_t>();
  Check(meta.Keep <= KeepAll, "the kept order is unknown");
  meta.ChunkTets = GetSmall(in);
  meta.KeyStepInterval = GetSmall(in);
  for (auto& range : meta.Box)
  {
    range = GetRange(in);
  }
  meta.Arrays = GetArrays(in);
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the meta data");
  return meta;
}
}
