// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gtnLayers.h"

#include "gtnText.h"

#include <fmt/core.h>

#include <map>
#include <string>
#include <vector>

namespace gtn
{
namespace
{
const char* NameOf(gatun::LayerSpacing spacing)
{
  return spacing == gatun::LayerSpacing::Uniform ? "uniform"
    : spacing == gatun::LayerSpacing::Normal     ? "normal"
    : spacing == gatun::LayerSpacing::Histogram  ? "histogram"
                                                 : "other";
}

/** Chunks whose values are in as many layers. */
struct Spanning
{
  std::vector<std::uint32_t> Chunks;
  std::uint64_t Tets = 0;
};

std::map<std::uint32_t, Spanning> SpansOf(const gatun::FileReader& file)
{
  std::map<std::uint32_t, Spanning> spans;
  const gatun::Layers& layers = file.GetLayers();
  for (std::uint32_t chunk = 0; chunk < layers.Chunks.size(); ++chunk)
  {
    Spanning& span = spans[layers.Chunks[chunk].Last - layers.Chunks[chunk].First + 1];
    span.Chunks.push_back(chunk);
    span.Tets += file.GetChunks()[chunk].Tets;
  }
  return spans;
}

/** Of the mesh and, if there is any value, of the array at the first step. */
std::uint64_t BytesOf(const gatun::FileReader& file, const Spanning& span)
{
  const std::uint32_t array = file.GetLayers().Array;
  return file.GetNumberOfSteps() > 0 ? file.GetPieceBytes(span.Chunks, { &array, 1 }, 0)
                                     : file.GetPieceBytes(span.Chunks, {}, 0);
}
}

//------------------------------------------------------------------------------
void PrintLayers(const gatun::FileReader& file)
{
  if (!file.HasLayers())
  {
    return;
  }
  const gatun::Layers& layers = file.GetLayers();
  const gatun::ArrayDescription& array = file.GetArrays()[layers.Array];
  const std::string component = array.Components == 1 ? ""
    : layers.Component < array.Components ? fmt::format(", component {}", layers.Component)
                                          : std::string(", length of the tuples");
  fmt::print("  layers           {} of {}{} ({})\n", layers.GetCount(), Printable(array.Name),
    component, NameOf(layers.Spacing));
  for (const auto& [width, span] : SpansOf(file))
  {
    fmt::print("    in {:<4}        {} chunks, {} tetrahedra, {} bytes of mesh and array\n", width,
      Grouped(span.Chunks.size()), Grouped(span.Tets), Grouped(BytesOf(file, span)));
  }
}

//------------------------------------------------------------------------------
void AddLayers(Json& json, const gatun::FileReader& file)
{
  if (!file.HasLayers())
  {
    return;
  }
  const gatun::Layers& layers = file.GetLayers();
  json.BeginObject("layers");
  json.Add("array", file.GetArrays()[layers.Array].Name);
  if (layers.Component >= 0)
  {
    json.Add("component", static_cast<std::uint64_t>(layers.Component));
  }
  else
  {
    json.Add("component", "magnitude");
  }
  json.Add("spacing", NameOf(layers.Spacing));
  json.Add("count", static_cast<std::uint64_t>(layers.GetCount()));
  json.BeginArray("bounds");
  for (const double bound : layers.Bounds)
  {
    json.Add({}, bound);
  }
  json.EndArray();
  json.BeginArray("spans");
  for (const auto& [width, span] : SpansOf(file))
  {
    json.BeginObject();
    json.Add("layers", static_cast<std::uint64_t>(width));
    json.Add("chunks", static_cast<std::uint64_t>(span.Chunks.size()));
    json.Add("tets", span.Tets);
    json.Add("bytes", BytesOf(file, span));
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
}
}
