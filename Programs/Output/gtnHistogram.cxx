// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gtnHistogram.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "gatunChunkCache.h"
#include "gatunPieceDecoder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace gtn
{
namespace
{
// So that threads have something to do, and memory stays small.
constexpr std::size_t ChunksAtOnce = 8;
constexpr std::uint64_t CacheBytes = std::uint64_t{ 64 } << 20;

constexpr int BarWidth = 40;

template <typename T>
double ReadAs(const std::uint8_t* at)
{
  T value;
  std::memcpy(&value, at, sizeof(T));
  return static_cast<double>(value);
}

double ReadNumber(gatun::ScalarType type, const std::uint8_t* at)
{
  using gatun::ScalarType;
  switch (type)
  {
    case ScalarType::Int8:
      return ReadAs<std::int8_t>(at);
    case ScalarType::UInt8:
      return ReadAs<std::uint8_t>(at);
    case ScalarType::Int16:
      return ReadAs<std::int16_t>(at);
    case ScalarType::UInt16:
      return ReadAs<std::uint16_t>(at);
    case ScalarType::Int32:
      return ReadAs<std::int32_t>(at);
    case ScalarType::UInt32:
      return ReadAs<std::uint32_t>(at);
    case ScalarType::Int64:
      return ReadAs<std::int64_t>(at);
    case ScalarType::UInt64:
      return ReadAs<std::uint64_t>(at);
    case ScalarType::Float32:
      return ReadAs<float>(at);
    default:
      return ReadAs<double>(at);
  }
}

/** A component of a tuple, or its length. */
double NumberOf(
  const gatun::ArrayDescription& array, const std::uint8_t* tuple, std::uint32_t component)
{
  const std::size_t size = gatun::SizeOf(array.Type);
  if (component < array.Components)
  {
    return ReadNumber(array.Type, tuple + component * size);
  }
  double square = 0;
  for (std::uint32_t c = 0; c < array.Components; ++c)
  {
    const double value = ReadNumber(array.Type, tuple + c * size);
    square += value * value;
  }
  return std::sqrt(square);
}

/** Calls use with the number of each tuple of the file. */
template <typename Use>
void ForEachNumber(const std::shared_ptr<const gatun::FileReader>& file, std::uint32_t array,
  std::uint32_t component, Use&& use)
{
  const gatun::ArrayDescription& description = file->GetArrays()[array];
  const bool ofPoints = description.Where == gatun::Association::Point;
  const std::size_t tuple = description.Components * gatun::SizeOf(description.Type);
  gatun::PieceDecoder decoder(std::make_shared<gatun::ChunkCache>(file, CacheBytes));
  const auto chunks = static_cast<std::uint32_t>(file->GetChunks().size());
  std::uint32_t next = 0;
  do
  {
    gatun::PieceRequest request;
    for (; next < chunks && request.Chunks.size() < ChunksAtOnce; ++next)
    {
      request.Chunks.push_back(next);
    }
    request.WithUnusedPoints = next >= chunks; // a file without chunks has them, too
    request.RestoreOrder = false;
    request.Arrays.assign(1, array);
    decoder.SetRequest(request);
    const auto count =
      static_cast<std::size_t>(ofPoints ? decoder.GetNumberOfPoints() : decoder.GetNumberOfCells());
    std::vector<std::uint8_t> values(count * tuple);
    std::vector<unsigned char> ghosts(ofPoints ? count : 0);
    gatun::PieceTarget target;
    target.Arrays = { values.data() };
    target.PointGhosts = ofPoints ? ghosts.data() : nullptr;
    decoder.Fill(target);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!ofPoints || ghosts[i] == 0)
      {
        use(NumberOf(description, values.data() + i * tuple, component));
      }
    }
  } while (next < chunks);
}

/** Points first, as the same name may be there twice. */
std::uint32_t FindArray(const gatun::FileReader& file, const std::string& name)
{
  for (const auto where : { gatun::Association::Point, gatun::Association::Cell })
  {
    for (std::uint32_t i = 0; i < file.GetArrays().size(); ++i)
    {
      if (file.GetArrays()[i].Name == name && file.GetArrays()[i].Where == where)
      {
        return i;
      }
    }
  }
  throw Failure(file.GetPath(), "there is no array '" + name + "'");
}

std::string Bar(std::uint64_t count, std::uint64_t most)
{
  const double part = most > 0 ? static_cast<double>(count) / static_cast<double>(most) : 0;
  // What is there is seen.
  const auto length = static_cast<std::size_t>(std::lround(part * BarWidth));
  return std::string(count > 0 ? std::max<std::size_t>(1, length) : 0, '#');
}
}

//------------------------------------------------------------------------------
Histogram::Histogram(
  const std::shared_ptr<const gatun::FileReader>& file, const HistogramOptions& options)
  : Array(FindArray(*file, options.Array))
  , Source(file->GetArrays()[this->Array])
  , BinCount(static_cast<std::size_t>(options.Bins))
  , HasTime(file->HasTime())
{
  const std::uint32_t components = this->Source.Components;
  if (options.Component >= static_cast<int>(components))
  {
    throw Failure(file->GetPath(),
      fmt::format("array '{}' has no component {}", options.Array, options.Component));
  }
  this->Component = options.Component >= 0 ? static_cast<std::uint32_t>(options.Component)
    : components > 1                       ? components
                                           : 0;
  if (file->GetNumberOfSteps() == 0)
  {
    throw Failure(file->GetPath(), "the file has no values");
  }
  this->Read(file);
  if (this->Source.Where == gatun::Association::Point)
  {
    this->FindNeeds(*file);
  }
}

//------------------------------------------------------------------------------
void Histogram::Read(const std::shared_ptr<const gatun::FileReader>& file)
{
  gatun::Range range = file->GetRanges(this->Array, 0)[this->Component];
  if (!std::isfinite(range.Min) || !std::isfinite(range.Max))
  {
    range = {};
    ForEachNumber(file, this->Array, this->Component,
      [&](double value)
      {
        if (std::isfinite(value))
        {
          range.Min = std::min(range.Min, value);
          range.Max = std::max(range.Max, value);
        }
      });
  }
  if (range.Min <= range.Max)
  {
    // One bin if there is one value.
    this->Bins.resize(range.Min < range.Max ? this->BinCount : 1);
    const auto bins = static_cast<double>(this->Bins.size());
    for (std::size_t i = 0; i < this->Bins.size(); ++i)
    {
      const auto edge = [&](double part) { return range.Min * (1 - part) + range.Max * part; };
      this->Bins[i].From = edge(static_cast<double>(i) / bins);
      this->Bins[i].To = edge(static_cast<double>(i + 1) / bins);
    }
  }
  ForEachNumber(file, this->Array, this->Component,
    [&](double value)
    {
      if (std::isnan(value))
      {
        ++this->NoNumbers;
        return;
      }
      if (std::isinf(value))
      {
        ++this->Infinite;
        return;
      }
      const auto above = std::partition_point(this->Bins.begin(), this->Bins.end(),
        [value](const HistogramBin& bin) { return bin.From <= value; });
      ++(above == this->Bins.begin() ? above : above - 1)->Count;
    });
}

//------------------------------------------------------------------------------
void Histogram::FindNeeds(const gatun::FileReader& file)
{
  std::vector<std::uint32_t> chunks(file.GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  this->AllBytes = file.GetPieceBytes(chunks, { &this->Array, 1 }, 0);
  for (HistogramBin& bin : this->Bins)
  {
    const double value = bin.From / 2 + bin.To / 2;
    std::vector<std::uint32_t> needed;
    for (const auto chunk : chunks)
    {
      const gatun::Range range = file.GetChunkRanges(this->Array, 0, chunk)[this->Component];
      if (range.Min < value && value <= range.Max)
      {
        needed.push_back(chunk);
        bin.Tets += file.GetChunks()[chunk].Tets;
      }
    }
    bin.Chunks = needed.size();
    bin.Bytes = file.GetPieceBytes(needed, { &this->Array, 1 }, 0);
  }
}

//------------------------------------------------------------------------------
void Histogram::Describe(Description& description) const
{
  const bool ofPoints = this->Source.Where == gatun::Association::Point;
  const bool isMagnitude = this->Component >= this->Source.Components;
  Description& part = description.AddPart(
    "histogram", this->HasTime ? "histogram of the first time step" : "histogram");
  part.Add("array", "array", Entry(this->Source.Name));
  part.Add("association", "of", Entry(ofPoints ? "point" : "cell"));
  part.Add("component", this->Source.Components > 1 ? "component" : nullptr,
    isMagnitude ? Entry("magnitude") : Entry(this->Component));
  part.Add("notANumber", this->NoNumbers > 0 ? "not a number" : nullptr, Entry(this->NoNumbers));
  part.Add("infinite", this->Infinite > 0 ? "infinite" : nullptr, Entry(this->Infinite));

  Table table{ "bins", "bins", { { "from", "from" }, { "to", "to" }, { "count", "values" } } };
  if (ofPoints)
  {
    part.Add("allBytes", nullptr, Entry(this->AllBytes));
    table.Title = "bins, and the chunks that an isosurface in the middle of each reads";
    table.Columns.insert(table.Columns.end(),
      { { "chunks", "chunks" }, { "tets", "tetrahedra" }, { "bytes", "bytes" }, { nullptr, "%" } });
  }
  table.Columns.push_back({ nullptr, "", false });
  std::uint64_t most = 0;
  for (const HistogramBin& bin : this->Bins)
  {
    most = std::max(most, bin.Count);
  }
  for (const HistogramBin& bin : this->Bins)
  {
    std::vector<Entry> row{ { bin.From, fmt::format("{:.6g}", bin.From) },
      { bin.To, fmt::format("{:.6g}", bin.To) }, Entry(bin.Count) };
    if (ofPoints)
    {
      const double share = static_cast<double>(bin.Bytes) /
        static_cast<double>(std::max<std::uint64_t>(1, this->AllBytes));
      row.insert(row.end(),
        { Entry(bin.Chunks), Entry(bin.Tets), Entry(bin.Bytes),
          Entry({}, fmt::format("{:.0f}", 100 * share)) });
    }
    row.emplace_back(Json::Value(), Bar(bin.Count, most));
    table.Rows.push_back(std::move(row));
  }
  part.Add(std::move(table));
}
}
