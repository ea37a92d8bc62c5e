// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellTable.h"

#include "gatunCellCodec.h"
#include "gatunTableParts.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint8_t KindTets = 0;
constexpr std::uint8_t KindCells = 1;

void PutChunk(ByteWriter& out, const CellSizes& chunk)
{
  out.Put(chunk.IsTetrahedral ? KindTets : KindCells);
  if (!chunk.IsTetrahedral)
  {
    out.PutVarint(chunk.Cells);
    out.PutVarint(chunk.Corners);
    out.PutVarint(chunk.FaceValues);
    out.PutVarint(chunk.Polyhedra);
  }
}

CellSizes GetChunk(ByteReader& in)
{
  CellSizes chunk;
  const auto kind = in.Get<std::uint8_t>();
  Check(kind <= KindCells, "a chunk has an unknown kind of cells");
  chunk.IsTetrahedral = kind == KindTets;
  if (!chunk.IsTetrahedral)
  {
    chunk.Cells = GetSmall(in);
    chunk.Corners = GetSmall(in);
    chunk.FaceValues = GetSmall(in);
    chunk.Polyhedra = GetSmall(in);
    Check(
      chunk.Cells >= 1 && chunk.Cells <= MaxChunkTets, "a chunk has an impossible number of cells");
    Check(chunk.GetMostPoints() <= MaxChunkCorners, "the cells of a chunk have too many points");
    Check(chunk.Polyhedra <= chunk.Cells, "a chunk has more polyhedra than cells");
    Check(chunk.Polyhedra > 0 || chunk.FaceValues == 0, "a chunk has faces without polyhedra");
  }
  return chunk;
}
}

//------------------------------------------------------------------------------
void CellTable::SetShapes(Bytes stored)
{
  this->Shapes = ShapeTable::Read(stored);
  this->StoredShapes = std::move(stored);
}

//------------------------------------------------------------------------------
Bytes CellTable::Write() const
{
  ByteWriter out;
  out.PutVarint(this->Types.size());
  for (const auto& type : this->Types)
  {
    out.Put(type.Type);
    out.PutVarint(type.Cells);
  }
  out.PutVarint(this->Chunks.size());
  for (const auto& chunk : this->Chunks)
  {
    PutChunk(out, chunk);
  }
  out.PutVarint(this->StoredShapes.size());
  out.PutBytes(this->StoredShapes);
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
CellTable CellTable::Read(std::span<const std::uint8_t> bytes)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  CellTable table;
  table.Types.resize(in.GetCount(2));
  for (std::size_t i = 0; i < table.Types.size(); ++i)
  {
    auto& type = table.Types[i];
    type.Type = in.Get<std::uint8_t>();
    type.Cells = in.GetVarint();
    Check(type.Cells >= 1, "a type of cells has no cells");
    Check(i == 0 || type.Type > table.Types[i - 1].Type, "the types of cells do not ascend");
  }
  table.Chunks.resize(in.GetCount(1));
  std::generate(table.Chunks.begin(), table.Chunks.end(), [&] { return GetChunk(in); });
  const auto length = in.GetCount(1);
  const auto shapes = in.GetBytes(length);
  table.SetShapes(Bytes(shapes.begin(), shapes.end()));
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return table;
}
}
