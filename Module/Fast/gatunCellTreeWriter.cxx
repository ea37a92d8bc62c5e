// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellTreeWriter.h"

#include "gatunNumberStream.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
CellTreeWriter::CellTreeWriter(const CellTemplates& templates, const CodedCells& cells)
  : Templates(templates)
  , Coded(cells)
{
}

//------------------------------------------------------------------------------
void CellTreeWriter::Write(ByteWriter& out) const
{
  this->Templates.Write(out);
  this->WriteIds(out);
  this->WriteSources(out);
  this->WriteFars(out);
  this->WriteRests(out);
}

//------------------------------------------------------------------------------
void CellTreeWriter::WriteIds(ByteWriter& out) const
{
  constexpr std::uint32_t escape = CellTemplate::Escape;
  Bytes symbols;
  NumberWriter more;
  for (std::uint32_t i = 0; i < this->Coded.Items.size(); ++i)
  {
    const auto id = this->Coded.Items[i].Template;
    symbols.push_back(static_cast<std::uint8_t>(std::min(id, escape)));
    if (id >= escape)
    {
      more.Put(id - escape);
    }
  }
  PutPacked(out, symbols);
  if (!more.IsEmpty())
  {
    more.Finish(out);
  }
}

//------------------------------------------------------------------------------
void CellTreeWriter::WriteSources(ByteWriter& out) const
{
  constexpr std::uint8_t escape = CellTemplate::Escape;
  Bytes symbols;
  NumberWriter distances;
  SourceCells last{ CodedCells::None, CodedCells::None, CodedCells::None };
  for (std::uint32_t i = 0; i < this->Coded.Items.size(); ++i)
  {
    const auto& from = this->Coded.Items[i].From;
    const auto& item = this->Templates.Items[this->Coded.Items[i].Template];
    for (unsigned s = 0; s < (item.KnowsSources ? 0 : item.Sources); ++s)
    {
      const auto difference = FromSigned(std::int64_t{ from[s] } - (last[s] + 1));
      symbols.push_back(static_cast<std::uint8_t>(std::min<std::uint64_t>(difference, escape)));
      if (difference >= escape)
      {
        distances.Put(i - 1 - from[s]);
      }
    }
    last = from;
  }
  PutPacked(out, symbols);
  if (!distances.IsEmpty())
  {
    distances.Finish(out);
  }
}

//------------------------------------------------------------------------------
void CellTreeWriter::WriteFars(ByteWriter& out) const
{
  NumberWriter fars;
  for (std::uint32_t i = 0; i < this->Coded.Items.size(); ++i)
  {
    const auto& cell = this->Coded.Items[i];
    const auto& item = this->Templates.Items[this->Coded.Items[i].Template];
    unsigned met = 0;
    for (unsigned k = 0; k < item.Head; ++k)
    {
      if (item.From[k] == CellTemplate::Far + met)
      {
        fars.Put(cell.Next - 1 - this->Coded.Points[cell.First + k]);
        ++met;
      }
    }
  }
  if (!fars.IsEmpty())
  {
    fars.Finish(out);
  }
}

//------------------------------------------------------------------------------
void CellTreeWriter::WriteRests(ByteWriter& out) const
{
  NumberWriter sizes;
  Bytes symbols;
  NumberWriter fars;
  for (std::uint32_t i = 0; i < this->Coded.Items.size(); ++i)
  {
    const auto& cell = this->Coded.Items[i];
    const auto& item = this->Templates.Items[this->Coded.Items[i].Template];
    if (item.IsSized)
    {
      sizes.Put(cell.Points - item.Head);
    }
    auto next = cell.Next + item.News;
    for (auto k = std::uint32_t{ item.Head }; k < cell.Points; ++k)
    {
      const auto vertex = this->Coded.Points[cell.First + k];
      const auto near = vertex < cell.Next
        ? this->Coded.FindNear(vertex, cell.From, item.Sources, CellTemplate::NearCorners)
        : CodedCells::None;
      if (near != CodedCells::None)
      {
        symbols.push_back(static_cast<std::uint8_t>(CellTemplate::NearSymbol + near));
      }
      else if (vertex == next)
      {
        symbols.push_back(CellTemplate::NewSymbol);
        ++next;
      }
      else
      {
        symbols.push_back(CellTemplate::FarSymbol);
        fars.Put(next - 1 - vertex);
      }
    }
  }
  if (!sizes.IsEmpty())
  {
    sizes.Finish(out);
  }
  PutPacked(out, symbols);
  if (!fars.IsEmpty())
  {
    fars.Finish(out);
  }
}
}
