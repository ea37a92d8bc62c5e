// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunBrickFile.h"

#include <cstring>
#include <span>
#include <type_traits>

namespace gatun
{
namespace
{
/** Calls visit with each list of a brick, in the order of the file. */
template <typename Brick, typename Visit>
void VisitLists(Brick& brick, Visit&& visit)
{
  visit(brick.Samples);
  visit(brick.Points);
  visit(brick.Hints);
  visit(brick.Tets);
  visit(brick.Keys);
  visit(brick.Cells);
  visit(brick.Last);
  visit(brick.Bared);
}

std::vector<std::uint8_t> ToBytes(const MergeBrick& brick)
{
  std::vector<std::uint8_t> bytes;
  VisitLists(brick,
    [&](const auto& list)
    {
      static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(list[0])>>);
      const auto* const begin = reinterpret_cast<const std::uint8_t*>(list.data());
      bytes.insert(bytes.end(), begin, begin + list.size() * sizeof(list[0]));
    });
  return bytes;
}
}

//------------------------------------------------------------------------------
void BrickFile::Add(const MergeBrick& brick)
{
  const auto bytes = ToBytes(brick);
  this->Entries.push_back({ this->File.GetSize(), brick.Points.size(), brick.Tets.size(),
    brick.Bared.size(), bytes.size() });
  this->File.Write(bytes);
}

//------------------------------------------------------------------------------
void BrickFile::Replace(std::size_t brick, const MergeBrick& by)
{
  Entry& entry = this->Entries[brick];
  const auto bytes = ToBytes(by);
  if (bytes.size() > entry.Room) // as merges of other bricks have bared tetrahedra
  {
    const std::scoped_lock lock(this->Mutex);
    entry.Offset = this->File.Skip(bytes.size());
    entry.Room = bytes.size();
  }
  this->File.Overwrite(entry.Offset, bytes);
  entry.Points = by.Points.size();
  entry.Tets = by.Tets.size();
  entry.Bared = by.Bared.size();
}

//------------------------------------------------------------------------------
MergeBrick BrickFile::Read(std::size_t brick) const
{
  const Entry& entry = this->Entries[brick];
  MergeBrick read;
  read.Samples.resize(entry.Points * (1 + this->Fields));
  read.Points.resize(entry.Points);
  read.Hints.resize(entry.Points);
  read.Tets.resize(entry.Tets);
  read.Keys.resize(entry.Tets);
  read.Cells.resize(this->HasCells ? entry.Tets : 0);
  read.Last.resize(entry.Tets);
  read.Bared.resize(entry.Bared);
  std::uint64_t at = entry.Offset;
  VisitLists(read,
    [&](auto& list)
    {
      const auto size = list.size() * sizeof(list[0]);
      this->File.ReadAt(at, { reinterpret_cast<std::uint8_t*>(list.data()), size });
      at += size;
    });
  return read;
}
}
