// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellMask.h"

#include "gatunTableParts.h"

#include <algorithm>

namespace gatun
{
namespace
{
constexpr std::uint8_t Relative = 1;
constexpr std::uint8_t Drops = 2;

/** The lengths of runs of cells that are as in another mask, and of those that are not, in turn. */
std::vector<std::uint64_t> FindRuns(const std::vector<bool>& mask, const std::vector<bool>* other)
{
  std::vector<std::uint64_t> runs;
  std::uint64_t length = 0;
  bool isOther = false;
  for (std::size_t c = 0; c < mask.size(); ++c)
  {
    if ((mask[c] != (other ? (*other)[c] : true)) != isOther)
    {
      runs.push_back(length);
      length = 0;
      isOther = !isOther;
    }
    ++length;
  }
  if (isOther)
  {
    runs.push_back(length); // cells behind the last run are as in the other mask
  }
  return runs;
}
}

//------------------------------------------------------------------------------
std::uint64_t CellMask::Count(std::uint64_t first, std::uint64_t cells) const
{
  const auto begin = this->IsAlive.begin() + static_cast<std::ptrdiff_t>(first);
  return static_cast<std::uint64_t>(
    std::count(begin, begin + static_cast<std::ptrdiff_t>(cells), true));
}

//------------------------------------------------------------------------------
Bytes CellMask::Write(const CellMask* before, bool hasTypes) const
{
  const auto write = [&](const CellMask* other)
  {
    ByteWriter out;
    out.Put(static_cast<std::uint8_t>((other ? Relative : 0) | (this->DropsPoints ? Drops : 0)));
    out.PutVarint(this->Cells);
    out.PutVarint(this->Points);
    for (std::size_t t = 0; hasTypes && t < this->Types.size(); ++t)
    {
      out.PutVarint(this->Types[t].Cells);
    }
    const auto runs = FindRuns(this->IsAlive, other ? &other->IsAlive : nullptr);
    out.PutVarint(runs.size());
    for (const auto length : runs)
    {
      out.PutVarint(length);
    }
    return Pack(out, SmallStep);
  };
  auto alone = write(nullptr);
  if (before)
  {
    auto relative = write(before);
    if (relative.size() < alone.size())
    {
      return relative;
    }
  }
  return alone;
}

//------------------------------------------------------------------------------
bool CellMask::NeedsBefore(std::span<const std::uint8_t> bytes)
{
  const auto data = Unpack(bytes, SmallStep);
  return (ByteReader(data).Get<std::uint8_t>() & Relative) != 0;
}

//------------------------------------------------------------------------------
void CellMask::Read(std::span<const std::uint8_t> bytes, const Mesh& mesh)
{
  const auto data = Unpack(bytes, SmallStep);
  ByteReader in(data);
  const auto flags = in.Get<std::uint8_t>();
  Check((flags & ~(Relative | Drops)) == 0, "a flag has no meaning");
  if (!(flags & Relative))
  {
    this->IsAlive.assign(static_cast<std::size_t>(mesh.Cells), true);
  }
  Check(this->IsAlive.size() == mesh.Cells, "there is no mask before it");
  this->DropsPoints = (flags & Drops) != 0;
  this->Cells = in.GetVarint();
  this->Points = in.GetVarint();
  Check(this->DropsPoints ? this->Points <= mesh.Points : this->Points == mesh.Points,
    "the number of points is wrong");
  this->Types.clear();
  std::uint64_t sum = 0;
  for (const CellTypeCount& type : mesh.Types)
  {
    this->Types.push_back({ type.Type, in.GetVarint() });
    Check(
      this->Types.back().Cells <= type.Cells, "there are more cells of a type than in the mesh");
    sum += this->Types.back().Cells;
  }
  Check(mesh.Types.empty() || sum == this->Cells, "the types of cells do not add up");
  const auto runs = in.GetCount(1);
  std::uint64_t cell = 0;
  for (std::uint64_t i = 0; i < runs; ++i)
  {
    const auto length = in.GetVarint();
    Check(length > 0 || i == 0, "a run is empty");
    Check(length <= mesh.Cells - cell, "there are more cells than in the mesh");
    for (const auto end = cell + length; cell < end; ++cell)
    {
      if (i % 2 == 1)
      {
        this->IsAlive[static_cast<std::size_t>(cell)].flip();
      }
    }
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  Check(this->Count(0, mesh.Cells) == this->Cells, "the number of cells is wrong");
}
}
