// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Tables of layers, written without compression: META, then TABL, LAYR.

#include "fuzzInput.h"
#include "gatunFileImage.h"
#include "gatunLayerTable.h"

#include <cstdlib>
#include <limits>

namespace
{
using namespace gatun;

void ReadTables(fuzz::Input& in)
{
  const auto next = [&] { return test::Store(fuzz::Copy(in.TakePart())); };
  const auto meta = MetaTable::Read(next());
  const auto mesh = MeshIndex::Read(next(), meta);
  const auto layers = ReadLayers(next(), meta, mesh.Chunks);
  // What was read must be read again from what it writes, and make sense.
  const auto again = ReadLayers(WriteLayers(layers, meta), meta, mesh.Chunks);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (again.Bounds != layers.Bounds || again.Chunks != layers.Chunks ||
    layers.Chunks.size() != mesh.Chunks || layers.Find(-infinity) != 0 ||
    layers.Find(infinity) + 1 != layers.GetCount() || layers.GetCount() > MaxLayers)
  {
    std::abort();
  }
  for (std::uint32_t i = 0; i < layers.Bounds.size(); ++i)
  {
    if (layers.Find(layers.Bounds[i]) != i + 1)
    {
      std::abort();
    }
  }
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  fuzz::Accepts([&] { ReadTables(in); });
  return 0;
}
