// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPalette.h"

#include "gatunArrayCodec.h"
#include "gatunEntropy.h"
#include "gatunProgression.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
/** The first byte of the stream of a progression, where others have a SpatialMode. */
constexpr std::uint8_t ProgressionMode = 3;

/** The most values of a palette of so many tuples. Those of arrays do without prediction from the
 * time step before. */
std::size_t GetMostEntries(std::uint64_t count, PaletteUse use)
{
  const auto most = use == PaletteUse::Coordinates ? count / 4 : count / 16;
  return static_cast<std::size_t>(std::min<std::uint64_t>(most, MaxPalette));
}
}

//------------------------------------------------------------------------------
PaletteBuilder::PaletteBuilder(ScalarType type, std::size_t most)
  : Type(type)
  , Most(IsFloating(type) ? most : 0)
{
}

//------------------------------------------------------------------------------
std::size_t PaletteBuilder::GetMost(std::uint64_t count, PaletteUse use)
{
  return use == PaletteUse::Coordinates ? MaxPalette : GetMostEntries(count, use);
}

//------------------------------------------------------------------------------
void PaletteBuilder::Add(
  const void* values, std::size_t count, std::size_t components, std::size_t component)
{
  const auto size = SizeOf(this->Type);
  // No values may have no address.
  const auto* next =
    count == 0 ? nullptr : static_cast<const std::uint8_t*>(values) + component * size;
  Key last = 0;
  for (std::size_t i = 0; i<count&& this->Most> 0; ++i, next += components * size)
  {
    const Key key = Domain::ReadPlain(this->Type, next);
    if (i > 0 && key == last)
    {
      continue;
    }
    last = key;
    if (this->Distinct.Add(key) && this->Distinct.GetSize() > this->Most)
    {
      this->Most = 0;
      this->Distinct = {};
      this->Sorted = {};
    }
  }
}

//------------------------------------------------------------------------------
void PaletteBuilder::Compress()
{
  this->Distinct.AppendTo(this->Sorted);
  this->Distinct = {};
  std::sort(this->Sorted.begin(), this->Sorted.end());
  this->Sorted.erase(std::unique(this->Sorted.begin(), this->Sorted.end()), this->Sorted.end());
  this->Sorted.shrink_to_fit();
  if (this->Sorted.size() > this->Most)
  {
    this->Most = 0;
    this->Sorted = {};
  }
}

//------------------------------------------------------------------------------
void PaletteBuilder::Put(ByteWriter& out)
{
  this->Compress();
  out.Put<std::uint8_t>(this->Most > 0);
  out.PutVarint(this->Sorted.size());
  for (const auto key : this->Sorted)
  {
    out.Put(key);
  }
}

//------------------------------------------------------------------------------
void PaletteBuilder::Add(ByteReader& in)
{
  this->Most = in.Get<std::uint8_t>() != 0 ? this->Most : 0;
  for (auto count = in.GetCount(sizeof(Key)); count > 0; --count)
  {
    this->Sorted.push_back(in.Get<Key>());
  }
  this->Compress();
}

//------------------------------------------------------------------------------
std::shared_ptr<const Palette> PaletteBuilder::Finish(std::uint64_t count, PaletteUse use)
{
  this->Compress();
  const auto distinct = this->Sorted.size();
  const bool isRare = distinct <= GetMostEntries(count, use);
  const bool isVeryRare = distinct <= GetMostEntries(count, PaletteUse::Array);
  const auto progression = use == PaletteUse::Coordinates && !this->Sorted.empty()
    ? FitProgression(this->Type, this->Sorted, MaxPalette)
    : std::nullopt;
  // A few values with large gaps in between are closer to each other by their ranks.
  if (progression && (!isVeryRare || progression->Count <= 2 * distinct))
  {
    return std::make_shared<Palette>(progression->MakeKeys(this->Type));
  }
  return isRare && distinct > 0 ? std::make_shared<Palette>(std::move(this->Sorted)) : nullptr;
}

//------------------------------------------------------------------------------
Bytes EncodePalette(ScalarType type, const Palette& palette)
{
  // Shorter ones are seldom coordinates, and take little.
  constexpr std::size_t leastProgression = 16;
  if (IsFloating(type) && palette.size() >= leastProgression)
  {
    const auto progression = FitProgression(type, palette, palette.size());
    if (progression)
    {
      ByteWriter out;
      out.Put(ProgressionMode);
      out.Put(progression->Origin);
      out.Put(progression->Step);
      out.Data.resize(std::max(out.Data.size(), palette.size() / MaxItemsPerByte), 0);
      return std::move(out.Data);
    }
  }
  const Domain domain(type);
  ComponentKeys keys;
  keys.Now = palette;
  auto stream = EncodeCellValues({}, { &domain, 1 }, { &keys, 1 });
  return stream;
}

//------------------------------------------------------------------------------
std::shared_ptr<const Palette> DecodePalette(
  ScalarType type, std::span<const std::uint8_t> stream, std::uint64_t count)
{
  if (count < 1 || count > MaxPalette)
  {
    ThrowCorrupt("a palette has an impossible size");
  }
  ComponentKeys keys;
  if (IsFloating(type) && !stream.empty() && stream[0] == ProgressionMode)
  {
    ByteReader in(stream.subspan(1));
    const auto origin = in.Get<double>();
    const auto step = in.Get<double>();
    const Progression progression{ origin, step, static_cast<std::size_t>(count) };
    if (!progression.IsWithin(type))
    {
      ThrowCorrupt("the values of a palette are beyond their type");
    }
    keys.Now = progression.MakeKeys(type);
  }
  else
  {
    const Domain domain(type);
    keys.Now.resize(static_cast<std::size_t>(count));
    DecodeCellValues(stream, {}, { &domain, 1 }, { &keys, 1 });
  }
  if (std::adjacent_find(keys.Now.begin(), keys.Now.end(), std::greater_equal<>()) !=
    keys.Now.end())
  {
    ThrowCorrupt("the values of a palette do not ascend");
  }
  return std::make_shared<Palette>(std::move(keys.Now));
}
}
