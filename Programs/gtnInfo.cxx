// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn info: what is in a file, from its directory alone.

#include "gtnArraySetting.h"
#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnHistogram.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnLayers.h"
#include "gtnNames.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "gatunFileReader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace gtn
{
namespace
{

struct Options
{
  std::string File;
  bool Json = false;
  std::optional<std::string> Histogram; ///< as given
  int Component = -1;
};

std::string Version(const gatun::FileReader& file)
{
  const auto [major, minor] = file.GetFormatVersion();
  return fmt::format("{}.{}", major, minor);
}

// One of each component, over all time steps.
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

std::string Text(const gatun::Range& range)
{
  return range.Min > range.Max ? "(none)" : fmt::format("{:.7g} to {:.7g}", range.Min, range.Max);
}

double BitsPerTet(const gatun::FileReader& file, std::uint64_t bytes)
{
  const auto tets = static_cast<double>(file.GetNumberOfTets());
  return tets > 0 ? 8. * static_cast<double>(bytes) / tets : std::nan("");
}

struct Part
{
  std::string Name; ///< as in JSON
  std::string Title;
  std::uint64_t Bytes;
};

std::vector<Part> PartsOf(const gatun::FileReader& file)
{
  const gatun::FileStatistics sizes = file.GetStatistics();
  std::vector<Part> parts{ { "connectivity", "connectivity", sizes.ConnectivityBytes },
    { "geometry", "points", sizes.GeometryBytes },
    { "sharedGeometry", "points of several chunks", sizes.SharedGeometryBytes },
    { "order", "original order", sizes.OrderBytes },
    { "fieldData", "field data", sizes.FieldDataBytes },
    { "hierarchy", "hierarchy", sizes.TreeBytes },
    { "baseMeshes", "base meshes", sizes.LevelBytes },
    { "directory", "directory", sizes.DirectoryBytes } };
  for (std::size_t i = 0; i < sizes.ArrayBytes.size() && i < file.GetArrays().size(); ++i)
  {
    const std::string& name = file.GetArrays()[i].Name;
    parts.push_back({ {}, "array " + Printable(name), sizes.ArrayBytes[i] });
  }
  return parts;
}

void PrintChunks(const gatun::FileReader& file)
{
  fmt::print("\nchunks\n  {:>7} {:>9} {:>9} {:>9} {:>9} {:>11}  {}\n", "number", "tets", "points",
    "shared", "neighb.", "mesh bytes", "bounds");
  for (std::size_t i = 0; i < file.GetChunks().size(); ++i)
  {
    const gatun::ChunkInfo& chunk = file.GetChunks()[i];
    fmt::print("  {:>7} {:>9} {:>9} {:>9} {:>9} {:>11}  [{:.5g}, {:.5g}] x [{:.5g}, {:.5g}] x "
               "[{:.5g}, {:.5g}]\n",
      i, chunk.Tets, chunk.OwnPoints, chunk.SharedPoints, chunk.Neighbours.size(),
      file.GetChunkMeshBytes(i), chunk.Box[0].Min, chunk.Box[0].Max, chunk.Box[1].Min,
      chunk.Box[1].Max, chunk.Box[2].Min, chunk.Box[2].Max);
  }
}

/** How the mesh becomes simpler: with so many merges of points, and from which base meshes. */
void PrintHierarchy(const gatun::FileReader& file)
{
  const std::size_t merges = file.GetNumberOfMerges();
  fmt::print("  hierarchy        {} of the points can be merged away ({:.2f} bits a point)\n",
    Grouped(merges),
    8. * static_cast<double>(file.GetStatistics().TreeBytes) /
      static_cast<double>(std::max<std::uint64_t>(1, file.GetNumberOfPoints())));
  for (std::size_t i = 0; i < file.GetLevels().size(); ++i)
  {
    const auto level = file.OpenLevel(i);
    fmt::print("  base mesh {:<2}     {} points, {} tetrahedra\n", i + 1,
      Grouped(level->GetNumberOfPoints()), Grouped(level->GetNumberOfTets()));
  }
}

void PrintText(const gatun::FileReader& file, bool verbose)
{
  fmt::print("{}\n", Printable(file.GetPath()));
  fmt::print("  format           {}, written by Gatun {}\n", Version(file),
    Printable(file.GetWriterVersion()));
  fmt::print("  tetrahedra       {}\n", Grouped(file.GetNumberOfTets()));
  fmt::print("  points           {} ({} of several chunks, {} of no tetrahedron), {}\n",
    Grouped(file.GetNumberOfPoints()), Grouped(file.GetNumberOfSharedPoints()),
    Grouped(file.GetNumberOfUnusedPoints()), NameOf(file.GetCoordinateType()));
  fmt::print("  chunks           {}\n", Grouped(file.GetChunks().size()));
  fmt::print("  kept order       {}\n", NameOfOrder(file.GetKeptOrder()));
  if (file.HasMergeTree())
  {
    PrintHierarchy(file);
  }
  PrintLayers(file);
  const gatun::Bounds& bounds = file.GetBounds();
  for (int i = 0; i < 3; ++i)
  {
    fmt::print("  {}                {}\n", "xyz"[i], Text(bounds[i]));
  }
  if (file.HasTime())
  {
    const std::vector<double>& times = file.GetTimes();
    fmt::print("  time steps       {}, {} to {}\n", times.size(), Number(times.front()),
      Number(times.back()));
    if (verbose)
    {
      std::vector<std::string> list;
      for (const double time : times)
      {
        list.push_back(Number(time));
      }
      fmt::print("  times            {}\n", Joined(list));
    }
  }

  if (!file.GetArrays().empty())
  {
    fmt::print("\narrays\n");
  }
  for (std::size_t i = 0; i < file.GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = file.GetArrays()[i];
    const std::vector<gatun::Range> ranges = RangesOf(file, i);
    fmt::print("  {} {} {}", array.Where == gatun::Association::Point ? "point" : "cell ",
      Printable(array.Name), NameOf(array.Type));
    if (array.Components != 1)
    {
      fmt::print("({})", array.Components);
    }
    constexpr std::size_t enough = 9;
    for (std::size_t j = 0; j < ranges.size() && j < enough; ++j)
    {
      fmt::print("{} {}", j == 0 ? "," : ";", Text(ranges[j]));
    }
    fmt::print("{}\n", ranges.size() > enough ? "; ..." : "");
  }

  const std::uint64_t all = file.GetStatistics().FileBytes;
  fmt::print("\n{:<32} {:>14} {:>10}\n", "sizes", "bytes", "bits/tet");
  for (const Part& part : PartsOf(file))
  {
    fmt::print(
      "  {:<30} {:>14} {:>10.3f}\n", part.Title, Grouped(part.Bytes), BitsPerTet(file, part.Bytes));
  }
  fmt::print("  {:<30} {:>14} {:>10.3f}\n", "file", Grouped(all), BitsPerTet(file, all));
  if (verbose)
  {
    PrintChunks(file);
  }
}

void AddRange(Json& json, const gatun::Range& range)
{
  const bool any = range.Min <= range.Max;
  json.BeginArray();
  json.Add({}, any ? range.Min : std::nan(""));
  json.Add({}, any ? range.Max : std::nan(""));
  json.EndArray();
}

void AddSize(Json& json, const gatun::FileReader& file, std::string_view name, std::uint64_t bytes)
{
  json.BeginObject(name);
  json.Add("bytes", bytes);
  json.Add("bitsPerTet", BitsPerTet(file, bytes));
  json.EndObject();
}

void AddChunks(Json& json, const gatun::FileReader& file)
{
  json.BeginArray("chunkTable");
  for (std::size_t i = 0; i < file.GetChunks().size(); ++i)
  {
    const gatun::ChunkInfo& chunk = file.GetChunks()[i];
    json.BeginObject();
    json.Add("tets", chunk.Tets);
    json.Add("ownPoints", chunk.OwnPoints);
    json.Add("sharedPoints", chunk.SharedPoints);
    json.Add("firstTet", chunk.FirstTet);
    json.Add("neighbours", static_cast<std::uint64_t>(chunk.Neighbours.size()));
    json.Add("meshBytes", file.GetChunkMeshBytes(i));
    if (file.HasLayers())
    {
      json.BeginArray("layers");
      json.Add({}, static_cast<std::uint64_t>(file.GetLayers().Chunks[i].First));
      json.Add({}, static_cast<std::uint64_t>(file.GetLayers().Chunks[i].Last));
      json.EndArray();
    }
    json.BeginArray("bounds");
    for (const gatun::Range& range : chunk.Box)
    {
      AddRange(json, range);
    }
    json.EndArray();
    json.EndObject();
  }
  json.EndArray();
}

void PrintJson(const gatun::FileReader& file, bool verbose, const Histogram* histogram)
{
  Json json;
  json.BeginObject();
  json.Add("file", file.GetPath());
  json.Add("formatVersion", Version(file));
  json.Add("writerVersion", file.GetWriterVersion());
  json.Add("tets", file.GetNumberOfTets());
  json.Add("points", file.GetNumberOfPoints());
  json.Add("sharedPoints", file.GetNumberOfSharedPoints());
  json.Add("unusedPoints", file.GetNumberOfUnusedPoints());
  json.Add("coordinateType", NameOf(file.GetCoordinateType()));
  json.Add("idBits", file.HasWideIds() ? 64 : 32);
  json.Add("chunks", static_cast<std::uint64_t>(file.GetChunks().size()));
  json.Add("hasHierarchy", file.HasMergeTree());
  json.Add("merges", static_cast<std::uint64_t>(file.GetNumberOfMerges()));
  json.BeginArray("baseMeshes");
  for (std::size_t i = 0; i < file.GetLevels().size(); ++i)
  {
    const auto level = file.OpenLevel(i);
    json.BeginObject();
    json.Add("points", level->GetNumberOfPoints());
    json.Add("tets", level->GetNumberOfTets());
    json.EndObject();
  }
  json.EndArray();
  json.Add("hasLayers", file.HasLayers());
  AddLayers(json, file);
  json.BeginObject("keptOrder");
  json.Add("points", (file.GetKeptOrder() & gatun::KeepPoints) != 0);
  json.Add("cells", (file.GetKeptOrder() & gatun::KeepCells) != 0);
  json.Add("corners", (file.GetKeptOrder() & gatun::KeepCorners) != 0);
  json.EndObject();
  json.BeginArray("bounds");
  for (const gatun::Range& range : file.GetBounds())
  {
    AddRange(json, range);
  }
  json.EndArray();
  json.BeginArray("times");
  if (file.HasTime())
  {
    for (const double time : file.GetTimes())
    {
      json.Add({}, time);
    }
  }
  json.EndArray();

  const gatun::FileStatistics sizes = file.GetStatistics();
  json.BeginArray("arrays");
  for (std::size_t i = 0; i < file.GetArrays().size(); ++i)
  {
    const gatun::ArrayDescription& array = file.GetArrays()[i];
    json.BeginObject();
    json.Add("name", array.Name);
    json.Add("association", array.Where == gatun::Association::Point ? "point" : "cell");
    json.Add("type", NameOf(array.Type));
    json.Add("components", static_cast<std::uint64_t>(array.Components));
    json.BeginArray("componentNames");
    for (const std::string& name : array.ComponentNames)
    {
      json.Add({}, name);
    }
    json.EndArray();
    json.BeginArray("ranges");
    for (const gatun::Range& range : RangesOf(file, i))
    {
      AddRange(json, range);
    }
    json.EndArray();
    const std::uint64_t bytes = i < sizes.ArrayBytes.size() ? sizes.ArrayBytes[i] : 0;
    json.Add("bytes", bytes);
    json.Add("bitsPerTet", BitsPerTet(file, bytes));
    json.EndObject();
  }
  json.EndArray();

  json.BeginObject("sizes");
  for (const Part& part : PartsOf(file))
  {
    if (!part.Name.empty())
    {
      AddSize(json, file, part.Name, part.Bytes);
    }
  }
  AddSize(json, file, "file", sizes.FileBytes);
  json.EndObject();
  if (verbose)
  {
    AddChunks(json, file);
  }
  if (histogram)
  {
    histogram->Add(json);
  }
  json.EndObject();
  fmt::print("{}", json.GetText());
}

// What --histogram says; without a name if it is not there.
HistogramOptions HistogramOf(const Options& options)
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
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "info",
    "Tell what a .gtn file holds and what its parts take. Only its directory is read, and with\n"
    "--histogram one array, some chunks at a time.",
    "  gtn info mesh.gtn\n"
    "  gtn info -v mesh.gtn             also the times and the chunk table\n"
    "  gtn info --histogram pressure:30 mesh.gtn\n"
    "  gtn info --json mesh.gtn | jq .sizes.connectivity.bitsPerTet");
  command->add_flag("--json", options->Json, "Print JSON");
  auto* histogramOption =
    command
      ->add_option("--histogram", options->Histogram,
        "How the values of an array are spread at the first time step, in 1 to 1000 bins; of a "
        "point "
        "array besides what an isosurface in the middle of each bin would read of the file")
      ->option_text("ARRAY[:BINS [20]]");
  AddComponent(command, "--component", options->Component,
    "Component for --histogram, from 0, or magnitude, the length of tuples (the default)")
    ->needs(histogramOption);
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->callback(
    [options, &settings]
    {
      const HistogramOptions wanted = HistogramOf(*options);
      CheckReadable(options->File);
      const auto file = std::make_shared<const gatun::FileReader>(options->File);
      std::unique_ptr<Histogram> histogram;
      if (!wanted.Array.empty())
      {
        histogram = std::make_unique<Histogram>(file, wanted);
      }
      if (options->Json)
      {
        PrintJson(*file, settings.Verbose, histogram.get());
        return;
      }
      PrintText(*file, settings.Verbose);
      if (histogram)
      {
        histogram->Print();
      }
    });
}
}
