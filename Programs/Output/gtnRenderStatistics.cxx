// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderStatistics.h"

#include "gtnJson.h"
#include "gtnText.h"

#include "vtkGatunRayCaster.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace gtn
{
const std::array<Statistic, 14> Statistics{ {
  { "seconds", "time", Statistic::Seconds },
  { "fetchSeconds", "  decoding, all threads", Statistic::Seconds },
  { "orderSeconds", "  projecting and ordering", Statistic::Seconds },
  { "setUpSeconds", "  planes of faces", Statistic::Seconds },
  { "drawSeconds", "  samples", Statistic::Seconds },
  { "finishSeconds", "  fragments into pixels", Statistic::Seconds },
  { "tets", "tetrahedra of drawn chunks", Statistic::Count },
  { "seenTets", "  seen", Statistic::Count },
  { "chunks", "chunks drawn", Statistic::Count },
  { "skippedChunks", "chunks skipped", Statistic::Count },
  { "mostWaiting", "most tetrahedra waiting", Statistic::Count },
  { "mostFragments", "most fragments", Statistic::Count },
  { "mostBytes", "most for image and chunks", Statistic::Bytes },
  { "bytesRead", "read while drawing", Statistic::Bytes },
} };

namespace
{

// The number behind a name in a file of the system; NaN if there is none.
double ReadNumber(const char* file, std::string_view name)
{
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    if (line.starts_with(name))
    {
      return std::strtod(line.c_str() + name.size(), nullptr);
    }
  }
  return std::nan("");
}

std::string Text(double value, Statistic::KindType kind)
{
  if (!std::isfinite(value))
  {
    return "unknown";
  }
  const auto whole = static_cast<std::uint64_t>(value);
  return kind == Statistic::Seconds ? fmt::format("{:.3f} s", value)
    : kind == Statistic::Count      ? Grouped(whole)
                                    : ByteSize(whole);
}

} // anonymous namespace

//------------------------------------------------------------------------------
Measurement Measure(vtkGatunRayCaster* caster, double seconds, double bytesRead)
{
  return { seconds, caster->GetStatistic(vtkGatunRayCaster::FetchTime),
    caster->GetStatistic(vtkGatunRayCaster::OrderTime),
    caster->GetStatistic(vtkGatunRayCaster::SetUpTime),
    caster->GetStatistic(vtkGatunRayCaster::DrawTime),
    caster->GetStatistic(vtkGatunRayCaster::FinishTime),
    caster->GetStatistic(vtkGatunRayCaster::NumberOfTetrahedra),
    caster->GetStatistic(vtkGatunRayCaster::NumberOfSeenTetrahedra),
    caster->GetStatistic(vtkGatunRayCaster::NumberOfChunks),
    caster->GetStatistic(vtkGatunRayCaster::NumberOfSkippedChunks),
    caster->GetStatistic(vtkGatunRayCaster::MostWaitingTetrahedra),
    caster->GetStatistic(vtkGatunRayCaster::MostFragments),
    caster->GetStatistic(vtkGatunRayCaster::MostBytes), bytesRead };
}

//------------------------------------------------------------------------------
Measurement MedianOf(const std::vector<Measurement>& all)
{
  Measurement median{};
  for (std::size_t i = 0; i < median.size(); ++i)
  {
    std::vector<double> values;
    for (const Measurement& one : all)
    {
      if (!std::isnan(one[i]))
      {
        values.push_back(one[i]);
      }
    }
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    median[i] = values.empty() ? std::nan("")
      : values.size() % 2 == 1 ? values[middle]
                               : (values[middle - 1] + values[middle]) / 2;
  }
  return median;
}

//------------------------------------------------------------------------------
double CountBytesRead()
{
  return ReadNumber("/proc/self/io", "rchar:");
}

//------------------------------------------------------------------------------
double GetPeakMemory()
{
  return 1024 * ReadNumber("/proc/self/status", "VmHWM:");
}

//------------------------------------------------------------------------------
void PrintTable(const Measurement& measurement, double peakMemory)
{
  for (std::size_t i = 0; i < Statistics.size(); ++i)
  {
    fmt::print("  {:<28} {:>14}\n", Statistics[i].Title, Text(measurement[i], Statistics[i].Kind));
  }
  fmt::print("  {:<28} {:>14}\n", "peak memory of the program", Text(peakMemory, Statistic::Bytes));
}

//------------------------------------------------------------------------------
void AddMeasurement(Json& json, const Measurement& measurement)
{
  for (std::size_t i = 0; i < Statistics.size(); ++i)
  {
    const double value = measurement[i];
    if (Statistics[i].Kind == Statistic::Seconds || !std::isfinite(value))
    {
      json.Add(Statistics[i].Name, value);
    }
    else
    {
      json.Add(Statistics[i].Name, static_cast<std::uint64_t>(value));
    }
  }
}
}
