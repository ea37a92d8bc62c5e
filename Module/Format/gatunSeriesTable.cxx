// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSeriesTable.h"

#include "gatunTableParts.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
bool HasMasks(std::span<const StoredStep> steps)
{
  return std::any_of(
    steps.begin(), steps.end(), [](const StoredStep& step) { return step.Mask > 0; });
}

//------------------------------------------------------------------------------
Bytes WriteSeries(std::span<const StoredStep> steps)
{
  ByteWriter out;
  out.PutVarint(steps.size());
  for (const StoredStep& step : steps)
  {
    out.PutVarint(step.Mesh);
    out.PutVarint(step.Mask);
    out.Put(step.Time);
  }
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
std::vector<StoredStep> ReadSeries(
  std::span<const std::uint8_t> bytes, std::size_t meshes, std::size_t masks)
{
  constexpr std::size_t leastBytes = 2 + sizeof(double);
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  std::vector<std::uint32_t> masksOf; // of each mesh so far
  const auto count = GetSmall(in);
  Check(count <= in.GetRemaining() / leastBytes, "the time steps are not all there");
  std::vector<StoredStep> steps(count);
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    auto& step = steps[i];
    step.Mesh = GetSmall(in);
    step.Mask = GetSmall(in);
    step.Time = in.Get<double>();
    Check(step.Mesh <= masksOf.size(), "a mesh has a number that is not the next one");
    if (step.Mesh == masksOf.size())
    {
      Check(step.Mask == 0, "the first step of a mesh has not all of its cells");
      masksOf.push_back(0);
    }
    auto& last = masksOf[step.Mesh];
    Check(step.Mask <= std::uint64_t{ last } + 1, "a mask has a number that is not the next one");
    last = std::max(last, step.Mask);
    Check(i == 0 || step.Time > steps[i - 1].Time, "the times of the steps do not ascend");
  }
  Check(masksOf.size() == meshes, "the number of meshes is wrong");
  Check(masksOf.empty() || masksOf.front() == masks, "the number of masks is wrong");
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return steps;
}
}
