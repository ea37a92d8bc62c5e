// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellTemplates.h"

#include "gatunCellShapes.h"
#include "gatunPackedBytes.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::uint8_t FlagKnowsSources = 1;
constexpr std::uint8_t FlagIsSized = 2;
constexpr std::uint32_t MostCorners = 1u << 24; // of a chunk

[[noreturn]] void ThrowBadTemplate()
{
  ThrowCorrupt("a template of cells is damaged");
}

void Check(bool right)
{
  if (!right)
  {
    ThrowBadTemplate();
  }
}

std::uint32_t GetNumber(ByteReader& in, std::uint64_t most)
{
  const auto number = in.GetVarint();
  Check(number <= most);
  return static_cast<std::uint32_t>(number);
}

template <std::size_t Size>
std::array<std::uint8_t, Size> GetArray(ByteReader& in)
{
  std::array<std::uint8_t, Size> array{};
  const auto bytes = in.GetBytes(Size);
  std::copy(bytes.begin(), bytes.end(), array.begin());
  return array;
}

/** Whether a place is known before new vertex w of the head. */
bool IsKnownPlace(const CellTemplate& item, unsigned place, unsigned w)
{
  return place < CellTemplate::New + w ||
    (place >= CellTemplate::Far && place < CellTemplate::Far + item.Fars);
}

void WriteItem(ByteWriter& out, const CellTemplate& item, const CellTemplates& all)
{
  out.Put(item.Type);
  out.Put(static_cast<std::uint8_t>(
    (item.KnowsSources ? FlagKnowsSources : 0) | (item.IsSized ? FlagIsSized : 0)));
  out.Put(static_cast<std::uint8_t>(item.Head | item.Sources << 4));
  out.PutBytes(std::span(item.From).first(item.Head));
  for (unsigned w = 0; w < item.News; ++w)
  {
    out.PutBytes(item.Gates[w]);
  }
  if (!item.IsSized)
  {
    out.PutVarint(item.Rest);
  }
  if (item.IsSized || item.Rest > 0)
  {
    out.Put(item.RestGateCount);
    for (unsigned k = 0; k < item.RestGateCount; ++k)
    {
      out.PutBytes(all.RestGates[item.FirstRestGate + k]);
    }
  }
  if (item.Type == PolyhedronType)
  {
    out.PutVarint(item.Hidden);
    out.PutVarint(item.Pattern);
  }
}

void ReadHead(ByteReader& in, CellTemplate& item)
{
  const auto sizes = in.Get<std::uint8_t>();
  item.Head = sizes & 15;
  item.Sources = sizes >> 4;
  Check(item.Head <= CellTemplate::MaxHead && item.Sources <= CellTemplate::MaxSources);
  const auto from = in.GetBytes(item.Head);
  std::copy(from.begin(), from.end(), item.From.begin());
  Check(item.Count());
  for (unsigned w = 0; w < item.News; ++w)
  {
    item.Gates[w] = GetArray<4>(in);
    for (const auto place : item.Gates[w])
    {
      Check(IsKnownPlace(item, place, w));
    }
  }
}

void ReadRest(ByteReader& in, CellTemplate& item, CellTemplates& all)
{
  if (!item.IsSized)
  {
    item.Rest = GetNumber(in, MostCorners);
  }
  if (item.IsSized || item.Rest > 0)
  {
    item.RestGateCount = in.Get<std::uint8_t>();
    Check(item.RestGateCount <= CellTemplate::MaxRestGates);
    item.FirstRestGate = static_cast<std::uint32_t>(all.RestGates.size());
    for (unsigned k = 0; k < item.RestGateCount; ++k)
    {
      const auto gate = GetArray<4>(in);
      for (const auto place : gate)
      {
        Check(place == CellTemplate::Before || place < item.Head + k);
      }
      all.RestGates.push_back(gate);
    }
  }
}

void ReadItem(ByteReader& in, CellTemplates& all)
{
  CellTemplate item;
  item.Type = in.Get<std::uint8_t>();
  const auto flags = in.Get<std::uint8_t>();
  Check(flags <= (FlagKnowsSources | FlagIsSized));
  item.KnowsSources = (flags & FlagKnowsSources) != 0;
  item.IsSized = (flags & FlagIsSized) != 0;
  ReadHead(in, item);
  ReadRest(in, item, all);
  if (item.Type == PolyhedronType)
  {
    Check(!item.IsSized);
    item.Hidden = GetNumber(in, item.Rest);
    item.Pattern = GetNumber(in, MostCorners);
  }
  item.IsPlain = item.Rest == 0 && !item.IsSized && item.Pattern == CellTemplate::NoPattern;
  all.Items.push_back(item);
}

FacePattern ReadPattern(ByteReader& in)
{
  std::vector<std::uint32_t> values;
  for (auto faces = in.GetCount(1); faces > 0; --faces)
  {
    auto left = in.GetCount(1);
    values.push_back(static_cast<std::uint32_t>(left));
    for (; left > 0; --left)
    {
      values.push_back(GetNumber(in, MostCorners));
    }
  }
  return FacePattern(std::move(values));
}

void WritePattern(ByteWriter& out, const FacePattern& pattern)
{
  out.PutVarint(
    static_cast<std::uint64_t>(std::count(pattern.IsSize.begin(), pattern.IsSize.end(), 1)));
  for (const auto value : pattern.Values)
  {
    out.PutVarint(value);
  }
}
}

//------------------------------------------------------------------------------
bool CellTemplate::Count()
{
  this->News = 0;
  this->Fars = 0;
  for (unsigned k = 0; k < this->Head; ++k)
  {
    const unsigned place = this->From[k];
    this->News += place == New + this->News ? 1 : 0;
    this->Fars += place == Far + this->Fars ? 1 : 0;
    const bool isKnown = place < Far ? place < New + this->News : place < Far + this->Fars;
    if (!isKnown)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
FacePattern::FacePattern(std::vector<std::uint32_t> values)
  : Values(std::move(values))
  , IsSize(this->Values.size(), 0)
{
  for (std::size_t at = 0; at < this->Values.size(); at += 1 + this->Values[at])
  {
    this->IsSize[at] = 1;
    for (std::size_t i = 1; i <= this->Values[at]; ++i)
    {
      this->Points = std::max(this->Points, this->Values[at + i] + 1);
    }
  }
}

//------------------------------------------------------------------------------
void CellTemplates::Write(ByteWriter& out) const
{
  ByteWriter plain;
  plain.PutVarint(this->Items.size());
  for (const auto& item : this->Items)
  {
    WriteItem(plain, item, *this);
  }
  plain.PutVarint(this->Patterns.size());
  for (const auto& pattern : this->Patterns)
  {
    WritePattern(plain, pattern);
  }
  out.PutVarint(plain.Data.size());
  PutPacked(out, plain.Data);
}

//------------------------------------------------------------------------------
CellTemplates CellTemplates::Read(ByteReader& in, std::uint64_t mostBytes, std::uint32_t most)
{
  const auto size = in.GetVarint();
  Check(size <= mostBytes);
  Bytes plain(static_cast<std::size_t>(size));
  GetPacked(in, plain);
  ByteReader bytes(plain);
  CellTemplates all;
  for (auto count = GetNumber(bytes, most); count > 0; --count)
  {
    ReadItem(bytes, all);
  }
  for (auto count = GetNumber(bytes, most); count > 0; --count)
  {
    all.Patterns.push_back(ReadPattern(bytes));
  }
  for (const auto& item : all.Items)
  {
    Check(item.Pattern == CellTemplate::NoPattern ||
      (item.Pattern < all.Patterns.size() &&
        all.Patterns[item.Pattern].Points <= item.Head + item.Rest));
  }
  Check(bytes.GetRemaining() == 0);
  return all;
}
}
