// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunLayerDescription.h"

#include "gatunDescriptionText.h"

#include <map>
#include <string>
#include <vector>

namespace gatun
{
namespace
{
const char* NameOfSpacing(LayerSpacing spacing)
{
  return spacing == LayerSpacing::Uniform ? "uniform"
    : spacing == LayerSpacing::Normal     ? "normal"
    : spacing == LayerSpacing::Histogram  ? "histogram"
                                          : "other";
}

/** The chunks whose values are in the same number of layers. */
struct Spanning
{
  std::vector<std::uint32_t> Chunks;
  std::uint64_t Tets = 0;
};

std::map<std::uint32_t, Spanning> SpansOf(const FileReader& file)
{
  std::map<std::uint32_t, Spanning> spans;
  const Layers& layers = file.GetLayers();
  for (std::uint32_t chunk = 0; chunk < layers.Chunks.size(); ++chunk)
  {
    Spanning& span = spans[layers.Chunks[chunk].Last - layers.Chunks[chunk].First + 1];
    span.Chunks.push_back(chunk);
    span.Tets += file.GetChunks()[chunk].Tets;
  }
  return spans;
}

/** Returns the bytes of the mesh and, if it has values, of the array at the first step. */
std::uint64_t BytesOf(const FileReader& file, const Spanning& span)
{
  const std::uint32_t array = file.GetLayers().Array;
  return file.GetNumberOfSteps() > 0 ? file.GetPieceBytes(span.Chunks, { &array, 1 }, 0)
                                     : file.GetPieceBytes(span.Chunks, {}, 0);
}
}

//------------------------------------------------------------------------------
void DescribeLayers(const FileReader& file, Description& description)
{
  const Layers& layers = file.GetLayers();
  const ArrayDescription& array = file.GetArrays()[layers.Array];
  const bool isMagnitude = layers.Component < 0;
  Description& part = description.AddPart("layers", "layers");
  part.Add("array", "array", Entry(array.Name));
  part.Add("component", array.Components == 1 ? nullptr : "component",
    isMagnitude ? Entry("magnitude") : Entry(layers.Component));
  part.Add("spacing", "spacing", Entry(NameOfSpacing(layers.Spacing)));
  part.Add("count", "count", Entry(layers.GetCount()));
  std::vector<std::string> bounds;
  for (const double bound : layers.Bounds)
  {
    bounds.push_back(DescribeNumber(bound, 6));
  }
  part.Add("bounds", "bounds", { MakeJsonArray(layers.Bounds), Join(bounds) });

  Table spans{ "spans", "chunks by the number of layers that their values are in",
    { { "layers", "layers" }, { "chunks", "chunks" }, { "tets", "tetrahedra" },
      { "bytes", "bytes of mesh and array" } } };
  for (const auto& [width, span] : SpansOf(file))
  {
    spans.Rows.push_back(
      { Entry(width), Entry(span.Chunks.size()), Entry(span.Tets), Entry(BytesOf(file, span)) });
  }
  part.Add(std::move(spans));
}
}
