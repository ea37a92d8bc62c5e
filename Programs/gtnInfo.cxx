// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn info: prints the contents of a file.

#include "gtnArraySetting.h"
#include "gtnCommands.h"
#include "gtnDescription.h"
#include "gtnFailure.h"
#include "gtnHistogram.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnLayers.h"
#include "gtnNames.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "gatunQuantizer.h"

#include "gatunCellShapes.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

namespace gtn
{
namespace
{

struct InfoOptions
{
  std::string File;
  bool Json = false;
  std::optional<std::string> Histogram; ///< as given
  int Component = -1;
};

// The ranges of the components of an array over all time steps.
std::vector<gatun::Range> RangesOf(const gatun::FileReader& file, std::size_t array)
{
  std::vector<gatun::Range> ranges(file.GetArrays()[array].Components);
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    const gatun::ArrayRanges& more = file.GetRanges(array, step);
    for (std::size_t i = 0; i < ranges.size() && i < more.size(); ++i)
    {
      ranges[i].Min = std::min(ranges[i].Min, more[i].Min);
      ranges[i].Max = std::max(ranges[i].Max, more[i].Max);
    }
  }
  return ranges;
}

// A list of [smallest, largest] for JSON, and a text with the first few of them.
template <typename Ranges>
Entry EntryOf(const Ranges& ranges, const char* separator, int digits)
{
  constexpr std::size_t enough = 9;
  Json::Value json(Json::arrayValue);
  std::vector<std::string> texts;
  for (const gatun::Range& range : ranges)
  {
    const bool any = range.Min <= range.Max;
    json.append(any ? JsonArray(std::array{ range.Min, range.Max })
                    : JsonArray(std::array<Json::Value, 2>()));
    texts.push_back(
      any ? fmt::format("{:.{}g} to {:.{}g}", range.Min, digits, range.Max, digits) : "(none)");
  }
  if (texts.size() > enough)
  {
    texts.resize(enough);
    texts.emplace_back("...");
  }
  return { json, Joined(texts, separator) };
}

Entry BitsPerCell(const gatun::FileReader& file, std::uint64_t bytes)
{
  const auto cells = static_cast<double>(file.GetNumberOfCells());
  const double bits = cells > 0 ? 8. * static_cast<double>(bytes) / cells : std::nan("");
  return { bits, fmt::format("{:.3f}", bits) };
}

Table DescribeCellTypes(const gatun::FileReader& file)
{
  Table table{ "cellTypes", "cell types",
    { { "type", "number" }, { "name", "type", false }, { "dimension", "dim." },
      { "cells", "cells" } } };
  for (const gatun::CellTypeCount& type : file.GetCellTypes())
  {
    const int dimension = gatun::GetCellKind(type.Type).Dimension;
    table.Rows.push_back({ Entry(std::uint64_t{ type.Type }), Entry(NameOfCell(type.Type)),
      dimension < 0 ? Entry(Json::Value(), "?") : Entry(static_cast<std::uint64_t>(dimension)),
      Entry(type.Cells) });
  }
  return table;
}

// The bound of the errors of an array, and the largest one: "rel:0.001, reached 0.0123".
std::string DescribeError(const gatun::FileReader& file, std::size_t array)
{
  gatun::ErrorBound bound;
  double reached = 0;
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    for (std::uint32_t c = 0; c < file.GetArrays()[array].Components; ++c)
    {
      const gatun::Quantizer rounding = file.GetRounding(array, c, step);
      bound = rounding ? rounding.Bound : bound;
      reached = std::max(reached, rounding.Reached);
    }
  }
  return bound ? fmt::format("{}, reached {:.6g}", ToString(bound), reached) : "";
}

Table DescribeArrays(const gatun::FileReader& file)
{
  Table table{ "arrays", "arrays",
    { { "name", "name", false }, { "association", "of", false }, { "type", "type", false },
      { "components", "comp." }, { "componentNames", nullptr }, { "bytes", "bytes" },
      { "bitsPerCell", "bits/cell" }, { "ranges", "values", false },
      { "error", "error", false } } };
  const gatun::FileStatistics sizes = file.GetStatistics();
  for (std::size_t i = 0; i < file.GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = file.GetArrays()[i];
    const std::uint64_t bytes = i < sizes.ArrayBytes.size() ? sizes.ArrayBytes[i] : 0;
    table.Rows.push_back(
      { Entry(array.Name), Entry(array.Where == gatun::Association::Point ? "point" : "cell"),
        Entry(NameOf(array.Type)), Entry(array.Components),
        Entry(JsonArray(array.ComponentNames), {}), Entry(bytes), BitsPerCell(file, bytes),
        EntryOf(RangesOf(file, i), "; ", 7), Entry(DescribeError(file, i)) });
  }
  return table;
}

Table DescribeSizes(const gatun::FileReader& file)
{
  Table table{ "sizes", "sizes",
    { { "part", "part", false }, { "bytes", "bytes" }, { "bitsPerCell", "bits/cell" } }, {}, true };
  const auto add = [&](const char* key, const char* title, std::uint64_t bytes) {
    table.Rows.push_back({ Entry(key, title), Entry(bytes), BitsPerCell(file, bytes) });
  };
  const gatun::FileStatistics sizes = file.GetStatistics();
  add("connectivity", "connectivity", sizes.ConnectivityBytes);
  add("geometry", "points", sizes.GeometryBytes);
  add("sharedGeometry", "shared points", sizes.SharedGeometryBytes);
  if (file.HasMovingPoints())
  {
    add("motion", "points of later steps", sizes.MotionBytes);
  }
  add("arrays", "arrays",
    std::accumulate(sizes.ArrayBytes.begin(), sizes.ArrayBytes.end(), std::uint64_t{ 0 }));
  add("order", "original order", sizes.OrderBytes);
  add("fieldData", "field data", sizes.FieldDataBytes);
  add("hierarchy", "hierarchy", sizes.TreeBytes);
  add("dependencies", "dependencies", sizes.DependencyBytes);
  add("baseMeshes", "base meshes", sizes.LevelBytes);
  add("boundary", "boundary", sizes.BoundaryBytes);
  add("otherMeshes", "other meshes", sizes.OtherMeshBytes);
  add("directory", "directory", sizes.DirectoryBytes);
  add("file", "file", sizes.FileBytes);
  return table;
}

Table DescribeChunks(const gatun::FileReader& file)
{
  Table table{ "chunkTable", "chunks",
    { { nullptr, "number" }, { "cells", "cells" }, { "tets", "tets" }, { "ownPoints", "points" },
      { "sharedPoints", "shared" }, { "firstTet", "first tet" }, { "neighbors", "neighbors" },
      { "meshBytes", "mesh bytes" }, { "bounds", "bounds", false } } };
  if (file.HasLayers())
  {
    table.Columns.push_back({ "layers", "layers", false });
  }
  for (std::size_t i = 0; i < file.GetChunks().size(); ++i)
  {
    const gatun::ChunkInfo& chunk = file.GetChunks()[i];
    std::vector<Entry> row{ Entry(i), Entry(chunk.Cells), Entry(chunk.Tets), Entry(chunk.OwnPoints),
      Entry(chunk.SharedPoints), Entry(chunk.FirstTet), Entry(file.GetNeighbors(i).size()),
      Entry(file.GetChunkMeshBytes(i)), EntryOf(chunk.Box, ", ", 5) };
    if (file.HasLayers())
    {
      const auto& [first, last] = file.GetLayers().Chunks[i];
      row.emplace_back(JsonArray(std::array{ first, last }), fmt::format("{} to {}", first, last));
    }
    table.Rows.push_back(std::move(row));
  }
  return table;
}

// The part of the points that can be removed, and the coarser meshes that are stored.
void DescribeHierarchy(const gatun::FileReader& file, Description& description)
{
  const bool any = file.HasMergeTree();
  const std::size_t merges = file.GetNumberOfMerges();
  description.Add("hasHierarchy", nullptr, { any, {} });
  description.Add("hasDependencies", nullptr, { file.HasDependencies(), {} });
  description.Add("merges", any ? "hierarchy" : nullptr,
    { std::uint64_t{ merges },
      fmt::format("{} edge collapses, {:.2f} bits per point", Grouped(merges),
        8. * static_cast<double>(file.GetStatistics().TreeBytes) /
          static_cast<double>(std::max<std::uint64_t>(1, file.GetNumberOfPoints()))) });
  Table levels{ "baseMeshes", "base meshes",
    { { nullptr, "number" }, { "points", "points" },
      { file.IsSurface() ? "cells" : "tets", file.IsSurface() ? "cells" : "tetrahedra" } } };
  for (std::size_t i = 0; i < file.GetLevels().size(); ++i)
  {
    const auto level = file.OpenLevel(i);
    levels.Rows.push_back({ Entry(i + 1), Entry(level->GetNumberOfPoints()),
      Entry(file.IsSurface() ? level->GetNumberOfCells() : level->GetNumberOfTets()) });
  }
  description.Add(std::move(levels));
}

void DescribeBoundary(const gatun::FileReader& file, Description& description)
{
  Json::Value value;
  std::string text;
  if (file.HasBoundary())
  {
    const auto boundary = file.OpenBoundary();
    value["points"] = Json::Value::UInt64{ boundary->GetNumberOfPoints() };
    value["cells"] = Json::Value::UInt64{ boundary->GetNumberOfCells() };
    text = fmt::format("{} faces, {} points", Grouped(boundary->GetNumberOfCells()),
      Grouped(boundary->GetNumberOfPoints()));
  }
  description.Add("boundary", file.HasBoundary() ? "boundary" : nullptr, { value, text });
}

Entry DescribeTimes(const gatun::FileReader& file, bool verbose)
{
  const std::vector<double> times = file.GetSeriesTimes();
  std::vector<std::string> texts;
  for (const double time : times)
  {
    texts.push_back(Number(time));
  }
  const std::string span =
    times.empty() ? "none" : fmt::format("{}, {} to {}", times.size(), texts.front(), texts.back());
  return { JsonArray(times), verbose && !times.empty() ? span + ": " + Joined(texts) : span };
}

// The meshes of a file whose mesh changes.
Table DescribeMeshes(const gatun::FileReader& file)
{
  Table table{ "meshes", "meshes",
    { { nullptr, "number" }, { "points", "points" }, { "cells", "cells" },
      { "steps", "time steps" }, { "firstTime", "first time" } } };
  const auto& series = file.GetSeries();
  const auto isWhole = [&](const gatun::SeriesStep& step)
  { return file.GetParentMesh(step.Mesh) == step.Mesh; };
  const bool hasParts = !std::all_of(series.begin(), series.end(), isWhole);
  if (hasParts)
  {
    table.Columns.push_back({ "someCellsOf", "some cells of" });
  }
  for (std::size_t i = 0; file.GetNumberOfMeshes() > 1 && i < file.GetNumberOfMeshes(); ++i)
  {
    const auto other = i > 0 ? file.OpenMesh(i) : nullptr;
    const gatun::FileReader& mesh = other ? *other : file;
    const auto isHere = [i](const gatun::SeriesStep& step) { return step.Mesh == i; };
    const auto steps = std::count_if(series.begin(), series.end(), isHere);
    const double first = std::find_if(series.begin(), series.end(), isHere)->Time;
    table.Rows.push_back(
      { Entry(i + 1), Entry(mesh.GetNumberOfPoints()), Entry(mesh.GetNumberOfCells()),
        Entry(static_cast<std::uint64_t>(steps)), Entry(first, Number(first)) });
    if (hasParts)
    {
      table.Rows.back().push_back(
        mesh.HasAllCells() ? Entry(Json::Value(), "") : Entry(file.GetParentMesh(i) + 1));
    }
  }
  return table;
}

Description Describe(const gatun::FileReader& file, bool verbose)
{
  const std::uint8_t kept = file.GetKeptOrder();
  Json::Value order;
  order["points"] = (kept & gatun::KeepPoints) != 0;
  order["cells"] = (kept & gatun::KeepCells) != 0;
  order["corners"] = (kept & gatun::KeepCorners) != 0;

  Description description(Printable(file.GetPath()));
  description.Add("file", nullptr, Entry(file.GetPath()));
  description.Add("formatVersion", "format", Entry(std::uint64_t{ file.GetFormatVersion() }));
  description.Add("writerVersion", "written by Gatun", Entry(file.GetWriterVersion()));
  description.Add(
    "surface", file.IsSurface() ? "mesh" : nullptr, { file.IsSurface(), "surface (vtkPolyData)" });
  description.Add(
    "cells", file.IsTetrahedral() ? nullptr : "cells", Entry(file.GetNumberOfCells()));
  description.Add("tets", "tetrahedra", Entry(file.GetNumberOfTets()));
  description.Add("points", "points", Entry(file.GetNumberOfPoints()));
  description.Add("sharedPoints", "  of many chunks", Entry(file.GetNumberOfSharedPoints()));
  description.Add("unusedPoints", "  of no cell", Entry(file.GetNumberOfUnusedPoints()));
  description.Add("coordinateType", "coordinates", Entry(NameOf(file.GetCoordinateType())));
  description.Add("idBits", "id bits", Entry(std::uint64_t{ file.HasWideIds() ? 64U : 32U }));
  description.Add("chunks", "chunks", Entry(file.GetChunks().size()));
  description.Add("keptOrder", "kept order", { order, NameOfOrder(kept) });
  description.Add("bounds", "bounds", EntryOf(file.GetBounds(), ", ", 7));
  const bool pointsMove = file.HasMovingPoints();
  description.Add("pointsMove", pointsMove ? "points" : nullptr, { pointsMove, "move with time" });
  description.Add("times", "time steps", DescribeTimes(file, verbose));
  description.Add(DescribeMeshes(file));
  description.Add("hasLayers", nullptr, { file.HasLayers(), {} });
  DescribeHierarchy(file, description);
  DescribeBoundary(file, description);
  if (!file.IsTetrahedral())
  {
    description.Add(DescribeCellTypes(file));
  }
  description.Add(DescribeArrays(file));
  description.Add(DescribeSizes(file));
  if (file.HasLayers())
  {
    DescribeLayers(file, description);
  }
  if (verbose)
  {
    description.Add(DescribeChunks(file));
  }
  return description;
}

// Parses --histogram. The name is empty without it.
HistogramOptions HistogramOf(const InfoOptions& options)
{
  constexpr int most = 1000;
  HistogramOptions wanted;
  if (options.Histogram)
  {
    const ArraySetting choice = ParseArraySetting("--histogram", *options.Histogram, most, {});
    wanted.Array = choice.Name;
    wanted.Bins = choice.Count.value_or(wanted.Bins);
    wanted.Component = options.Component;
    if (wanted.Bins < 1)
    {
      throw UsageError("--histogram " + *options.Histogram + ": there must be a bin");
    }
  }
  return wanted;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddInfo(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = AddCommand(app, settings, "info",
    "Print the contents of a .gtn file and the sizes of its parts. Only the directory of the file "
    "is\n"
    "read; with --histogram also one array, a few chunks at a time.",
    "  gtn info mesh.gtn\n"
    "  gtn info -v mesh.gtn             # with the times and the chunk table\n"
    "  gtn info --histogram pressure:30 mesh.gtn\n"
    "  gtn info --json mesh.gtn | jq .sizes.connectivity.bitsPerCell");
  command->add_flag("--json", options->Json, "Print JSON");
  auto* histogramOption = command
                            ->add_option("--histogram", options->Histogram,
                              "Print the histogram of an array at the first time step, with 1 to "
                              "1000 bins (default: 20). For a point array, also print how much of "
                              "the file an isosurface in the middle of each bin reads")
                            ->option_text("ARRAY[:BINS]");
  AddComponent(command, "--component", options->Component,
    "Component for --histogram: a number from 0, or magnitude (default: magnitude)")
    ->needs(histogramOption);
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->callback(
    [options, &settings]
    {
      const HistogramOptions wanted = HistogramOf(*options);
      CheckReadable(options->File);
      const auto file = std::make_shared<const gatun::FileReader>(options->File);
      Description description = Describe(*file, settings.Verbose);
      if (!wanted.Array.empty())
      {
        Histogram(file, wanted).Describe(description);
      }
      fmt::print("{}", options->Json ? JsonText(description.GetJson()) : description.GetText());
    });
}
}
