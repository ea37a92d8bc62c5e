// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSeriesTable.h"

#include "gatunTableParts.h"

namespace gatun
{
//------------------------------------------------------------------------------
Bytes WriteSeries(std::span<const SeriesStep> steps)
{
  ByteWriter out;
  out.PutVarint(steps.size());
  for (const SeriesStep& step : steps)
  {
    out.PutVarint(step.Mesh);
    out.Put(step.Time);
  }
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
std::vector<SeriesStep> ReadSeries(std::span<const std::uint8_t> bytes, std::size_t meshes)
{
  constexpr std::size_t leastBytes = 1 + sizeof(double);
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  std::size_t seen = 0;
  const auto count = GetSmall(in);
  Check(count <= in.GetRemaining() / leastBytes, "the time steps are not all there");
  std::vector<SeriesStep> steps(count);
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    auto& step = steps[i];
    step.Mesh = GetSmall(in);
    step.Time = in.Get<double>();
    Check(step.Mesh <= seen, "a mesh has a number that is not the next one");
    seen += step.Mesh == seen ? 1 : 0;
    Check(i == 0 || step.Time > steps[i - 1].Time, "the times of the steps do not ascend");
  }
  Check(seen == meshes, "the number of meshes is wrong");
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return steps;
}
}
