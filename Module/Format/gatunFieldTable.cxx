// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCompress.h"
#include "gatunMetaTable.h"
#include "gatunTableParts.h"

#include <limits>

namespace gatun
{
namespace
{
constexpr std::uint8_t FlagFieldKeys = 128; // beside the type of values
}

//------------------------------------------------------------------------------
Bytes WriteFieldData(const FieldData& field)
{
  ByteWriter out;
  out.PutVarint(field.size());
  for (const auto& array : field)
  {
    out.PutString(array.Name);
    out.Put(array.VTKType);
    out.PutVarint(array.Components);
    PutStrings(out, array.ComponentNames);
    out.Put(static_cast<std::uint8_t>((array.IsText ? 0 : static_cast<std::uint8_t>(array.Type)) |
      (array.Keys.empty() ? 0 : FlagFieldKeys)));
    if (!array.Keys.empty())
    {
      PutKeys(out, array.Keys);
    }
    if (array.IsText)
    {
      PutStrings(out, array.Texts);
    }
    else
    {
      out.PutVarint(array.Values.size());
      out.PutBytes(array.Values);
    }
  }
  return Compress(out.Data);
}

FieldData ReadFieldData(std::span<const std::uint8_t> bytes)
{
  // Field data may be long runs of one value, so the limit is generous.
  const auto data = Decompress(bytes, 65536 * (bytes.size() + 1));
  ByteReader in(data);
  FieldData field(in.GetCount(9));
  for (auto& array : field)
  {
    array.Name = in.GetString();
    array.VTKType = in.Get<std::int32_t>();
    const auto components = in.GetVarint();
    Check(components <= std::numeric_limits<std::int32_t>::max(), "too many components");
    array.Components = static_cast<std::uint32_t>(components);
    array.ComponentNames = GetStrings(in);
    const auto mark = in.Get<std::uint8_t>();
    const auto type = static_cast<std::uint8_t>(mark & ~FlagFieldKeys);
    Check(type <= 10, "a value type is unknown");
    if (mark & FlagFieldKeys)
    {
      array.Keys = GetKeys(in);
    }
    array.IsText = type == 0;
    if (array.IsText)
    {
      array.Texts = GetStrings(in);
    }
    else
    {
      array.Type = static_cast<ScalarType>(type);
      const auto values = in.GetBytes(in.GetVarint());
      array.Values.assign(values.begin(), values.end());
      Check(array.Values.size() % SizeOf(array.Type) == 0, "a field array ends within a value");
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the field data");
  return field;
}
}
