// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The tables of series of meshes, without compression: one byte for the number of meshes and masks,
// then TIME, the list of runs of GRID, and two sections LIVE.

#include "fuzzInput.h"
#include "gatunCellMask.h"
#include "gatunExtents.h"
#include "gatunFileImage.h"
#include "gatunSeriesTable.h"

#include <array>
#include <cstdlib>

namespace
{
using namespace gatun;

void StopUnless(bool right)
{
  if (!right)
  {
    std::abort();
  }
}

void ReadTime(const Bytes& bytes, std::uint8_t counts)
{
  const std::size_t meshes = counts % 4;
  const std::size_t masks = counts / 4 % 4;
  const auto steps = ReadSeries(bytes, meshes, masks);
  StopUnless(ReadSeries(WriteSeries(steps), meshes, masks).size() == steps.size());
}

void ReadRuns(const Bytes& list)
{
  // A section behind 1000 bytes of a file, with 500 bytes behind the list.
  constexpr std::uint64_t before = 1000;
  const StreamRef where{ before + SectionHeaderSize + 9, list.size(), 0 };
  const StreamRef section{ before + SectionHeaderSize, 9 + list.size() + 500, 0 };
  const ExtentMap map(list, where, section);
  const auto end = section.Offset + section.Length;
  std::uint64_t inSection = 0;
  for (std::uint64_t at = 0; at < map.GetSize();)
  {
    const auto place = map.Find(at);
    StopUnless(place.Length > 0 && place.Length <= map.GetSize() - at);
    StopUnless(place.Offset + place.Length <= before ||
      (place.Offset >= where.Offset + where.Length && place.Offset + place.Length <= end));
    inSection += place.Offset > before ? place.Length : 0;
    at += place.Length;
  }
  StopUnless(inSection == 500 && map.GetSize() <= before + 500);
  StopUnless(map.Find(map.GetSize()).Length == 0);
}

void ReadMasks(const Bytes& first, const Bytes& second)
{
  constexpr std::uint64_t cells = 40;
  const std::array types{ CellTypeCount{ 10, 30 }, CellTypeCount{ 12, 10 } };
  for (const bool hasTypes : { false, true })
  {
    CellMask mask;
    const CellMask::Mesh mesh{ cells, 20,
      hasTypes ? std::span<const CellTypeCount>(types) : std::span<const CellTypeCount>() };
    if (!fuzz::Accepts([&] { mask.Read(first, mesh); }))
    {
      continue;
    }
    const CellMask before = mask;
    fuzz::Accepts([&] { mask.Read(second, mesh); });
    StopUnless(mask.IsAlive.size() == cells);
    if (fuzz::Accepts([&] { mask.Read(first, mesh); }) && mask == before)
    {
      CellMask again;
      again.Read(mask.Write(nullptr, hasTypes), mesh);
      StopUnless(again == mask);
      StopUnless(mask.Count(0, cells) == mask.Cells);
    }
  }
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  const auto next = [&] { return test::Store(fuzz::Copy(in.TakePart())); };
  const auto counts = in.Take<std::uint8_t>();
  const auto time = next();
  const auto runs = next();
  const auto first = next();
  const auto second = next();
  fuzz::Accepts([&] { ReadTime(time, counts); });
  fuzz::Accepts([&] { ReadRuns(runs); });
  fuzz::Accepts([&] { ReadMasks(first, second); });
  return 0;
}
