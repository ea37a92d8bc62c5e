// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunExtents.h"

#include "gatunTableParts.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
Bytes WriteExtents(std::span<const Extent> extents)
{
  if (extents.empty())
  {
    return Bytes(1, 0);
  }
  ByteWriter list;
  list.PutVarint(extents.size());
  for (const Extent& extent : extents)
  {
    list.PutVarint(extent.Length);
    list.PutVarint(extent.Source);
  }
  const Bytes packed = Pack(list, SmallTable);
  ByteWriter out;
  out.PutVarint(packed.size());
  out.Put(Checksum(packed));
  out.PutBytes(packed);
  return out.Data;
}

//------------------------------------------------------------------------------
StreamRef ExtentMap::FindList(std::span<const std::uint8_t> head, const StreamRef& section)
{
  ByteReader in(head);
  StreamRef list;
  list.Length = in.GetVarint();
  list.Sum = list.Length > 0 ? in.Get<std::uint64_t>() : 0;
  const auto begin = head.size() - in.GetRemaining();
  Check(list.Length <= section.Length - begin, "the list of its parts is not all there");
  list.Offset = section.Offset + begin;
  return list;
}

//------------------------------------------------------------------------------
ExtentMap::ExtentMap(
  std::span<const std::uint8_t> list, const StreamRef& where, const StreamRef& section)
{
  constexpr std::uint64_t leastBytes = 2;
  Check(section.Offset >= HeaderSize + SectionHeaderSize, "it begins before the first section");
  const auto data = Unpack(list, SmallTable);
  ByteReader in(data);
  const auto before = section.Offset - SectionHeaderSize;
  auto next = where.Offset + where.Length; // of the bytes that are in the section
  auto inSection = section.Offset + section.Length - next;
  auto shared = before;
  this->Parts.resize(static_cast<std::size_t>(in.GetCount(leastBytes)));
  for (Part& part : this->Parts)
  {
    const auto length = in.GetVarint();
    const auto source = in.GetVarint();
    Check(length > 0, "one of its parts is empty");
    auto& rest = source == 0 ? inSection : shared;
    Check(length <= rest, "its parts are longer than what is there");
    Check(source == 0 || (source <= before && length <= before - source),
      "one of its parts is not before it");
    part = { this->Size, source == 0 ? next : source };
    rest -= length;
    next += source == 0 ? length : 0;
    this->Size += length;
  }
  Check(inSection == 0, "there are bytes behind its last part");
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
}

//------------------------------------------------------------------------------
ExtentMap::Place ExtentMap::Find(std::uint64_t offset) const
{
  const auto next = std::partition_point(
    this->Parts.begin(), this->Parts.end(), [&](const Part& p) { return p.Begin <= offset; });
  if (next == this->Parts.begin())
  {
    return { offset, 0 };
  }
  const Part& part = *(next - 1);
  const auto end = next == this->Parts.end() ? this->Size : next->Begin;
  return { part.Source + (offset - part.Begin), std::max(end, offset) - offset };
}
}
