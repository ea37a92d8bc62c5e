// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshDescription.h"

#include "gatunCellShapes.h"
#include "gatunDescriptionText.h"
#include "gatunFileReader.h"
#include "gatunLayerDescription.h"
#include "gatunQuantizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gatun
{
namespace
{
// The ranges of the components of an array over all time steps.
std::vector<Range> RangesOf(const FileReader& file, std::size_t array)
{
  std::vector<Range> ranges(file.GetArrays()[array].Components);
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    const ArrayRanges& more = file.GetRanges(array, step);
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
Entry EntryOfRanges(const Ranges& ranges, const char* separator, int digits)
{
  constexpr std::size_t enough = 9;
  Json::Value json(Json::arrayValue);
  std::vector<std::string> texts;
  for (const Range& range : ranges)
  {
    const bool any = range.Min <= range.Max;
    json.append(any ? MakeJsonArray(std::array{ range.Min, range.Max })
                    : MakeJsonArray(std::array<Json::Value, 2>()));
    texts.push_back(any
        ? DescribeNumber(range.Min, digits) + " to " + DescribeNumber(range.Max, digits)
        : "(none)");
  }
  if (texts.size() > enough)
  {
    texts.resize(enough);
    texts.emplace_back("...");
  }
  return { json, Join(texts, separator) };
}

Entry BitsPerCell(const FileReader& file, std::uint64_t bytes)
{
  const auto cells = static_cast<double>(file.GetNumberOfCells());
  const double bits = cells > 0 ? 8. * static_cast<double>(bytes) / cells : std::nan("");
  return { bits, DescribeFixed(bits, 3) };
}

Table DescribeCellTypes(const FileReader& file)
{
  Table table{ "cellTypes", "cell types",
    { { "type", "number" }, { "name", "type", false }, { "dimension", "dim." },
      { "cells", "cells" } } };
  for (const CellTypeCount& type : file.GetCellTypes())
  {
    const int dimension = GetCellKind(type.Type).Dimension;
    table.Rows.push_back({ Entry(std::uint64_t{ type.Type }), Entry(NameOfCellType(type.Type)),
      dimension < 0 ? Entry(Json::Value(), "?") : Entry(static_cast<std::uint64_t>(dimension)),
      Entry(type.Cells) });
  }
  return table;
}

// The bound of the errors of an array, and the largest one: "rel:0.001, reached 0.0123".
std::string DescribeError(const FileReader& file, std::size_t array)
{
  ErrorBound bound;
  double reached = 0;
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    for (std::uint32_t c = 0; c < file.GetArrays()[array].Components; ++c)
    {
      const Quantizer rounding = file.GetRounding(array, c, step);
      bound = rounding ? rounding.Bound : bound;
      reached = std::max(reached, rounding.Reached);
    }
  }
  return bound ? ToString(bound) + ", reached " + DescribeNumber(reached, 6) : "";
}

Table DescribeArrays(const FileReader& file)
{
  Table table{ "arrays", "arrays",
    { { "name", "name", false }, { "association", "of", false }, { "type", "type", false },
      { "components", "comp." }, { "componentNames", nullptr }, { "bytes", "bytes" },
      { "bitsPerCell", "bits/cell" }, { "ranges", "values", false },
      { "error", "error", false } } };
  const FileStatistics sizes = file.GetStatistics();
  for (std::size_t i = 0; i < file.GetArrays().size(); ++i)
  {
    const ArrayDescription& array = file.GetArrays()[i];
    const std::uint64_t bytes = i < sizes.ArrayBytes.size() ? sizes.ArrayBytes[i] : 0;
    table.Rows.push_back(
      { Entry(array.Name), Entry(array.Where == Association::Point ? "point" : "cell"),
        Entry(NameOfType(array.Type)), Entry(array.Components),
        Entry(MakeJsonArray(array.ComponentNames), {}), Entry(bytes), BitsPerCell(file, bytes),
        EntryOfRanges(RangesOf(file, i), "; ", 7), Entry(DescribeError(file, i)) });
  }
  return table;
}

Table DescribeSizes(const FileReader& file)
{
  Table table{ "sizes", "sizes",
    { { "part", "part", false }, { "bytes", "bytes" }, { "bitsPerCell", "bits/cell" } }, {}, true };
  const auto add = [&](const char* key, const char* title, std::uint64_t bytes) {
    table.Rows.push_back({ Entry(key, title), Entry(bytes), BitsPerCell(file, bytes) });
  };
  const FileStatistics sizes = file.GetStatistics();
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

Table DescribeMeshChunks(const FileReader& file)
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
    const ChunkInfo& chunk = file.GetChunks()[i];
    std::vector<Entry> row{ Entry(i), Entry(chunk.Cells), Entry(chunk.Tets), Entry(chunk.OwnPoints),
      Entry(chunk.SharedPoints), Entry(chunk.FirstTet), Entry(file.GetNeighbors(i).size()),
      Entry(file.GetChunkMeshBytes(i)), EntryOfRanges(chunk.Box, ", ", 5) };
    if (file.HasLayers())
    {
      const auto& [first, last] = file.GetLayers().Chunks[i];
      row.emplace_back(MakeJsonArray(std::array{ first, last }),
        std::to_string(first) + " to " + std::to_string(last));
    }
    table.Rows.push_back(std::move(row));
  }
  return table;
}

// The part of the points that can be removed, and the coarser meshes that are stored.
void DescribeHierarchy(const FileReader& file, Description& description)
{
  const bool any = file.HasMergeTree();
  const std::size_t merges = file.GetNumberOfMerges();
  description.Add("hasHierarchy", nullptr, { any, {} });
  description.Add("hasDependencies", nullptr, { file.HasDependencies(), {} });
  description.Add("merges", any ? "hierarchy" : nullptr,
    { std::uint64_t{ merges },
      GroupDigits(merges) + " edge collapses, " +
        DescribeFixed(8. * static_cast<double>(file.GetStatistics().TreeBytes) /
            static_cast<double>(std::max<std::uint64_t>(1, file.GetNumberOfPoints())),
          2) +
        " bits per point" });
  Table levels{ "baseMeshes", "base meshes",
    { { nullptr, "number" }, { "points", "points" },
      { file.IsSurface() ? "cells" : "tets", file.IsSurface() ? "cells" : "tetrahedra" } } };
  for (std::size_t i = 0; i < file.GetLevels().size(); ++i)
  {
    const MeshCounts level = file.CountLevel(i);
    levels.Rows.push_back(
      { Entry(i + 1), Entry(level.Points), Entry(file.IsSurface() ? level.Cells : level.Tets) });
  }
  description.Add(std::move(levels));
}

void DescribeBoundary(const FileReader& file, Description& description)
{
  Json::Value value;
  std::string text;
  if (file.HasBoundary())
  {
    const MeshCounts boundary = file.CountBoundary();
    value["points"] = Json::Value::UInt64{ boundary.Points };
    value["cells"] = Json::Value::UInt64{ boundary.Cells };
    text = GroupDigits(boundary.Cells) + " faces, " + GroupDigits(boundary.Points) + " points";
  }
  description.Add("boundary", file.HasBoundary() ? "boundary" : nullptr, { value, text });
}

Entry DescribeTimes(const FileReader& file, bool verbose)
{
  const std::vector<double> times = file.GetSeriesTimes();
  std::vector<std::string> texts;
  for (const double time : times)
  {
    texts.push_back(DescribeNumber(time));
  }
  const std::string span = times.empty()
    ? "none"
    : std::to_string(times.size()) + ", " + texts.front() + " to " + texts.back();
  return { MakeJsonArray(times), verbose && !times.empty() ? span + ": " + Join(texts) : span };
}

// The meshes of a file whose mesh changes.
Table DescribeMeshes(const FileReader& file)
{
  Table table{ "meshes", "meshes",
    { { nullptr, "number" }, { "points", "points" }, { "cells", "cells" },
      { "steps", "time steps" }, { "firstTime", "first time" } } };
  const auto& series = file.GetSeries();
  const auto isWhole = [&](const SeriesStep& step)
  { return file.GetParentMesh(step.Mesh) == step.Mesh; };
  const bool hasParts = !std::all_of(series.begin(), series.end(), isWhole);
  if (hasParts)
  {
    table.Columns.push_back({ "someCellsOf", "some cells of" });
  }
  for (std::size_t i = 0; file.GetNumberOfMeshes() > 1 && i < file.GetNumberOfMeshes(); ++i)
  {
    const auto other = i > 0 ? file.OpenMesh(i) : nullptr;
    const FileReader& mesh = other ? *other : file;
    const auto isHere = [i](const SeriesStep& step) { return step.Mesh == i; };
    const auto steps = std::count_if(series.begin(), series.end(), isHere);
    const double first = std::find_if(series.begin(), series.end(), isHere)->Time;
    table.Rows.push_back(
      { Entry(i + 1), Entry(mesh.GetNumberOfPoints()), Entry(mesh.GetNumberOfCells()),
        Entry(static_cast<std::uint64_t>(steps)), Entry(first, DescribeNumber(first)) });
    if (hasParts)
    {
      table.Rows.back().push_back(
        mesh.HasAllCells() ? Entry(Json::Value(), "") : Entry(file.GetParentMesh(i) + 1));
    }
  }
  return table;
}

} // anonymous namespace

//------------------------------------------------------------------------------
Description DescribeMesh(const FileReader& file, bool verbose)
{
  file.AnnounceDescription();
  const std::uint8_t kept = file.GetKeptOrder();
  Json::Value order;
  order["points"] = (kept & KeepPoints) != 0;
  order["cells"] = (kept & KeepCells) != 0;
  order["corners"] = (kept & KeepCorners) != 0;

  Description description(MakePrintableLine(file.GetPath()));
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
  description.Add("coordinateType", "coordinates", Entry(NameOfType(file.GetCoordinateType())));
  description.Add("idBits", "id bits", Entry(std::uint64_t{ file.HasWideIds() ? 64U : 32U }));
  description.Add("chunks", "chunks", Entry(file.GetChunks().size()));
  description.Add("profile", "profile", Entry(NameOfProfile(file.GetProfile())));
  description.Add("keptOrder", "kept order", { order, NameOfKeptOrder(kept) });
  description.Add("bounds", "bounds", EntryOfRanges(file.GetBounds(), ", ", 7));
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
    description.Add(DescribeMeshChunks(file));
  }
  return description;
}
}
