// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTableParts.h"

#include "gatunChunkCodec.h"
#include "gatunCompress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gatun
{
namespace
{
constexpr std::uint32_t MaxComponents = 1u << 16;

// What stands for a scale in place of the size of a palette, before its kind is added.
constexpr std::uint64_t ScaleMark = 1u << 16;
constexpr std::uint64_t LastScaleKind = static_cast<std::uint64_t>(ScaleKind::Fixed); // but Binary
constexpr std::uint64_t CopyMark = ScaleMark + LastScaleKind + 1;
constexpr std::uint64_t BoundMark = CopyMark + 1;
constexpr std::uint64_t BinaryMark = BoundMark + 1;

// Flags of a quantizer.
constexpr std::uint8_t FlagLattice = 1;
constexpr std::uint8_t FlagKeepZeros = 2;

constexpr std::uint8_t FlagKeys = 2; // beside what an array belongs to

void PutQuantizer(ByteWriter& out, const Quantizer& rounding)
{
  out.Put(static_cast<std::uint8_t>(rounding.Bound.Kind));
  out.Put(static_cast<std::uint8_t>(
    (rounding.OnLattice ? FlagLattice : 0) | (rounding.Bound.KeepZeros ? FlagKeepZeros : 0)));
  out.Put(rounding.Bound.Bound);
  out.Put(rounding.Step);
  out.Put(rounding.Reached);
}

Quantizer GetQuantizer(ByteReader& in, ScalarType type)
{
  Quantizer rounding;
  rounding.Bound.Kind = static_cast<ErrorKind>(in.Get<std::uint8_t>());
  const auto flags = in.Get<std::uint8_t>();
  Check(flags <= (FlagLattice | FlagKeepZeros), "a bound of errors has unknown flags");
  rounding.OnLattice = (flags & FlagLattice) != 0;
  rounding.Bound.KeepZeros = (flags & FlagKeepZeros) != 0;
  rounding.Bound.Bound = in.Get<double>();
  rounding.Step = in.Get<double>();
  rounding.Reached = in.Get<double>();
  Check(rounding.IsValid(type), "a bound of errors is impossible");
  return rounding;
}

void PutScale(ByteWriter& out, const Scale& scale)
{
  const bool isBinary = scale.Kind == ScaleKind::Binary;
  out.PutVarint(isBinary ? BinaryMark : ScaleMark + static_cast<std::uint64_t>(scale.Kind));
  if (!isBinary)
  {
    out.Put(scale.Digits);
  }
  if (isBinary || scale.Kind == ScaleKind::Decimal)
  {
    out.Put(scale.First);
  }
}

bool IsScaleMark(std::uint64_t mark)
{
  return mark == BinaryMark || (mark > ScaleMark && mark <= ScaleMark + LastScaleKind);
}

/** mark: that of the scale, which has been read. */
Scale GetScale(ByteReader& in, std::uint64_t mark, ScalarType type)
{
  Scale scale;
  scale.Kind = mark == BinaryMark ? ScaleKind::Binary : static_cast<ScaleKind>(mark - ScaleMark);
  if (scale.Kind != ScaleKind::Binary)
  {
    scale.Digits = in.Get<std::uint8_t>();
  }
  if (scale.Kind == ScaleKind::Binary || scale.Kind == ScaleKind::Decimal)
  {
    scale.First = in.Get<std::int8_t>();
  }
  Check(scale.IsValid(type), "a scale is impossible for its type");
  return scale;
}

std::uint64_t GetLimit(std::span<const std::uint8_t> packed, std::uint64_t small)
{
  return std::max(small, TableExpansion * packed.size());
}
}

//------------------------------------------------------------------------------
void PutStream(ByteWriter& out, const StreamRef& stream)
{
  out.PutVarint(stream.Length);
  if (stream.Length > 0)
  {
    out.PutVarint(stream.Offset);
    out.Put(stream.Sum);
  }
}

//------------------------------------------------------------------------------
StreamRef GetStream(ByteReader& in)
{
  StreamRef stream;
  stream.Length = in.GetVarint();
  if (stream.Length > 0)
  {
    stream.Offset = in.GetVarint();
    stream.Sum = in.Get<std::uint64_t>();
  }
  return stream;
}

//------------------------------------------------------------------------------
void PutPalette(ByteWriter& out, const PaletteRef& palette)
{
  if (palette.IsCopy())
  {
    out.PutVarint(CopyMark);
    out.PutVarint(palette.SourceArray);
    out.PutVarint(palette.SourceComponent);
    return;
  }
  if (palette.Rounding)
  {
    out.PutVarint(BoundMark);
    PutQuantizer(out, palette.Rounding);
    return;
  }
  if (palette.Steps)
  {
    PutScale(out, palette.Steps);
    return;
  }
  out.PutVarint(palette.Count);
  if (palette.Count > 0)
  {
    PutStream(out, palette.Stream);
  }
}

//------------------------------------------------------------------------------
PaletteRef GetPalette(ByteReader& in, ScalarType type)
{
  PaletteRef palette;
  palette.Count = in.GetVarint();
  if (palette.Count == CopyMark)
  {
    palette.Count = 0;
    palette.SourceArray = GetSmall(in);
    palette.SourceComponent = GetSmall(in);
    Check(palette.IsCopy(), "an array is copied from one that is not there");
  }
  if (palette.Count == BoundMark)
  {
    palette.Count = 0;
    palette.Rounding = GetQuantizer(in, type);
  }
  if (IsScaleMark(palette.Count))
  {
    palette.Steps = GetScale(in, palette.Count, type);
    palette.Count = 0;
  }
  if (palette.Count > 0)
  {
    palette.Stream = GetStream(in);
    Check(palette.Count / MaxItemsPerByte <= palette.Stream.Length, "a palette is too large");
  }
  return palette;
}

//------------------------------------------------------------------------------
void PutRange(ByteWriter& out, const Range& range)
{
  out.Put(range.Min);
  out.Put(range.Max);
}

//------------------------------------------------------------------------------
Range GetRange(ByteReader& in)
{
  Range range;
  range.Min = in.Get<double>();
  range.Max = in.Get<double>();
  Check(!std::isnan(range.Min) && !std::isnan(range.Max), "a range is not a number");
  return range;
}

//------------------------------------------------------------------------------
void PutStrings(ByteWriter& out, const std::vector<std::string>& strings)
{
  out.PutVarint(strings.size());
  for (const auto& s : strings)
  {
    out.PutString(s);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GetStrings(ByteReader& in)
{
  std::vector<std::string> strings(in.GetCount(1));
  for (auto& s : strings)
  {
    s = in.GetString();
  }
  return strings;
}

//------------------------------------------------------------------------------
ScalarType GetScalarType(ByteReader& in)
{
  const auto type = in.Get<std::uint8_t>();
  Check(type >= 1 && type <= 10, "a value type is unknown");
  return static_cast<ScalarType>(type);
}

//------------------------------------------------------------------------------
void PutKeys(ByteWriter& out, const std::vector<ArrayKey>& keys)
{
  out.PutVarint(keys.size());
  for (const auto& key : keys)
  {
    out.PutString(key.Location);
    out.PutString(key.Name);
    out.Put(static_cast<std::uint8_t>(key.Kind));
    if (IsOfTexts(key.Kind))
    {
      PutStrings(out, key.Texts);
      continue;
    }
    out.PutVarint(key.Numbers.size());
    for (const auto number : key.Numbers)
    {
      out.Put(number);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<ArrayKey> GetKeys(ByteReader& in)
{
  constexpr std::uint64_t least = 6; // bytes of a key with a name of one letter and an empty text
  std::vector<ArrayKey> keys(in.GetCount(least));
  Check(!keys.empty(), "an array has an empty list of keys");
  for (auto& key : keys)
  {
    key.Location = in.GetString();
    key.Name = in.GetString();
    Check(!key.Location.empty() && !key.Name.empty(), "a key has no name");
    const auto kind = in.Get<std::uint8_t>();
    Check(kind >= 1 && kind <= static_cast<std::uint8_t>(KeyKind::Quadrature),
      "a key is of an unknown kind");
    key.Kind = static_cast<KeyKind>(kind);
    if (IsOfTexts(key.Kind))
    {
      key.Texts = GetStrings(in);
    }
    else
    {
      key.Numbers.resize(in.GetCount(sizeof(std::uint64_t)));
      for (auto& number : key.Numbers)
      {
        number = in.Get<std::uint64_t>();
      }
    }
    Check(key.Kind > KeyKind::Text || key.Numbers.size() + key.Texts.size() == 1,
      "a key of one value has another number of values");
  }
  return keys;
}

//------------------------------------------------------------------------------
void PutPoints(ByteWriter& out, const PointsDescription& points)
{
  out.PutString(points.Name);
  PutStrings(out, points.ComponentNames);
  out.Put(static_cast<std::uint8_t>(!points.Keys.empty()));
  if (!points.Keys.empty())
  {
    PutKeys(out, points.Keys);
  }
}

//------------------------------------------------------------------------------
PointsDescription GetPoints(ByteReader& in)
{
  PointsDescription points;
  points.Name = in.GetString();
  points.ComponentNames = GetStrings(in);
  Check(points.ComponentNames.size() <= 3, "points have too many names of components");
  const auto hasKeys = in.Get<std::uint8_t>();
  Check(hasKeys <= 1, "it is unknown whether the points have keys");
  if (hasKeys)
  {
    points.Keys = GetKeys(in);
  }
  return points;
}

//------------------------------------------------------------------------------
void PutArrays(ByteWriter& out, std::span<const ArrayDescription> arrays)
{
  out.PutVarint(arrays.size());
  for (const auto& array : arrays)
  {
    out.PutString(array.Name);
    out.Put(static_cast<std::uint8_t>(
      static_cast<std::uint8_t>(array.Where) | (array.Keys.empty() ? 0 : FlagKeys)));
    out.Put(static_cast<std::uint8_t>(array.Type));
    out.PutVarint(array.Components);
    out.Put(array.VTKType);
    out.Put(array.AttributeRoles);
    PutStrings(out, array.ComponentNames);
    if (!array.Keys.empty())
    {
      PutKeys(out, array.Keys);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<ArrayDescription> GetArrays(ByteReader& in)
{
  std::vector<ArrayDescription> arrays(in.GetCount(13));
  for (auto& array : arrays)
  {
    array.Name = in.GetString();
    const auto where = in.Get<std::uint8_t>();
    Check(where <= (1 | FlagKeys), "an array belongs to neither points nor cells");
    array.Where = static_cast<Association>(where & 1);
    array.Type = GetScalarType(in);
    const auto components = in.GetVarint();
    Check(components >= 1 && components <= MaxComponents, "an array has too many components");
    array.Components = static_cast<std::uint32_t>(components);
    array.VTKType = in.Get<std::int32_t>();
    array.AttributeRoles = in.Get<std::uint32_t>();
    array.ComponentNames = GetStrings(in);
    Check(array.ComponentNames.size() <= array.Components, "too many names of components");
    if (where & FlagKeys)
    {
      array.Keys = GetKeys(in);
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
std::uint32_t GetSmall(ByteReader& in)
{
  const auto value = in.GetVarint();
  Check(value <= std::numeric_limits<std::uint32_t>::max(), "a number is too large");
  return static_cast<std::uint32_t>(value);
}

//------------------------------------------------------------------------------
Bytes Pack(const ByteWriter& out, std::uint64_t small)
{
  auto packed = Compress(out.Data);
  if (out.Data.size() > GetLimit(packed, small))
  {
    throw Error(ErrorCode::InvalidInput,
      "the tables would be too large: there are too many components, or chunks that share points");
  }
  return packed;
}

//------------------------------------------------------------------------------
Bytes Unpack(std::span<const std::uint8_t> bytes, std::uint64_t small)
{
  return Decompress(bytes, GetLimit(bytes, small));
}
}
