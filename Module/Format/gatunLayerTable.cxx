// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunLayerTable.h"

#include "gatunTableParts.h"

#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
Bytes WriteLayers(const Layers& layers, const MetaTable& meta)
{
  // Files number the length of the tuple behind the components.
  const auto component = layers.Component < 0 ? meta.Arrays.at(layers.Array).Components
                                              : static_cast<std::uint32_t>(layers.Component);
  ByteWriter out;
  out.PutVarint(layers.Array);
  out.PutVarint(component);
  out.Put(static_cast<std::uint8_t>(layers.Spacing));
  out.PutVarint(layers.GetCount());
  for (const double bound : layers.Bounds)
  {
    out.Put(bound);
  }
  for (const LayerSpan& span : layers.Chunks)
  {
    out.PutVarint(span.First);
    out.PutVarint(span.Last);
  }
  return Pack(out, SmallTable);
}

//------------------------------------------------------------------------------
Layers ReadLayers(
  std::span<const std::uint8_t> bytes, const MetaTable& meta, std::size_t numberOfChunks)
{
  const auto data = Unpack(bytes, SmallTable);
  ByteReader in(data);
  Layers layers;
  layers.Array = GetSmall(in);
  Check(layers.Array < meta.Arrays.size() && meta.Arrays[layers.Array].Where == Association::Point,
    "the layers are those of no point array");
  const auto components = meta.Arrays[layers.Array].Components;
  const auto component = GetSmall(in);
  Check(component < GetRangeCount(components), "the layers are those of no component");
  layers.Component = component < components ? static_cast<int>(component) : -1;
  const auto spacing = in.Get<std::uint8_t>();
  layers.Spacing = spacing <= static_cast<std::uint8_t>(LayerSpacing::Histogram)
    ? static_cast<LayerSpacing>(spacing)
    : LayerSpacing::Other;
  const auto count = GetSmall(in);
  Check(count >= 1 && count <= MaxLayers, "the number of layers is not from 1 to 4096");
  Check(count - 1 <= in.GetRemaining() / sizeof(double), "the bounds of layers are not all there");
  layers.Bounds.resize(count - 1);
  for (std::size_t i = 0; i < layers.Bounds.size(); ++i)
  {
    auto& bound = layers.Bounds[i];
    bound = in.Get<double>();
    Check(std::isfinite(bound), "the bound of a layer is not a finite number");
    Check(i == 0 || bound > layers.Bounds[i - 1], "the bounds of layers do not ascend");
  }
  Check(numberOfChunks <= in.GetRemaining() / 2, "the layers of some of the chunks are missing");
  layers.Chunks.resize(numberOfChunks);
  for (LayerSpan& span : layers.Chunks)
  {
    span.First = GetSmall(in);
    span.Last = GetSmall(in);
    Check(span.First <= span.Last && span.Last < count, "a chunk is in layers that do not exist");
  }
  Check(in.GetRemaining() == 0, "there are bytes behind the end of the table");
  return layers;
}

//------------------------------------------------------------------------------
bool IsInside(const Layers& layers, const LayerSpan& span, const Range& values)
{
  return values.IsEmpty() ||
    (layers.Find(values.Min) >= span.First && layers.Find(values.Max) <= span.Last);
}
}
