// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunShapeTable.h"

namespace gatun
{
void ShapeTable::Add(const CellList&) {}

void ShapeTable::Merge(const ShapeTable&) {}

Bytes ShapeTable::Write() const
{
  ByteWriter out;
  out.PutVarint(0);
  return std::move(out.Data);
}

ShapeTable ShapeTable::Read(std::span<const std::uint8_t> bytes)
{
  ByteReader in(bytes);
  if (in.GetVarint() != 0)
  {
    ThrowCorrupt("a table of shapes is longer than this version allows");
  }
  return {};
}
}
