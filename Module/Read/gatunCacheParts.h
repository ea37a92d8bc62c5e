// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCacheParts_h
#define gatunCacheParts_h

// The parts that the cache keeps, and their exact memory.

#include "gatunChunkCodec.h"
#include "gatunDomain.h"
#include "gatunOriginalNumbers.h"

#include <cstdint>
#include <vector>

namespace gatun
{
using PointsPart = std::vector<PointKeys>;       // of a block
using OrderPart = OriginalNumbers;               // of points or cells
using ArrayPart = std::vector<std::vector<Key>>; // keys of all vertices, for each component
using DomainsPart = std::vector<Domain>;         // one for each component

template <typename T>
std::uint64_t BytesIn(const std::vector<T>& list)
{
  return list.capacity() * sizeof(T);
}

template <typename T>
std::uint64_t BytesOf(const std::vector<T>& list)
{
  return sizeof(list) + BytesIn(list);
}

inline std::uint64_t BytesOf(const OrderPart& order)
{
  return order.GetBytes();
}

inline std::uint64_t BytesOf(const ArrayPart& array)
{
  auto bytes = sizeof(array) + BytesIn(array);
  for (const auto& component : array)
  {
    bytes += BytesIn(component);
  }
  return bytes;
}

inline std::uint64_t BytesOf(const DomainsPart& domains)
{
  auto bytes = sizeof(domains) + BytesIn(domains);
  for (const auto& domain : domains)
  {
    bytes += domain.GetPalette() ? BytesOf(*domain.GetPalette()) : 0;
  }
  return bytes;
}

inline std::uint64_t BytesOf(const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  return sizeof(mesh) + BytesIn(walk.Tets) + BytesIn(walk.Gates) +
    walk.Packed.capacity() * sizeof(PackedTet) + BytesIn(walk.Parents) + BytesIn(walk.Sources) +
    BytesIn(walk.Records) + BytesIn(walk.EdgeLog) + BytesIn(walk.CellRecords) +
    BytesIn(mesh.CellRules) + BytesIn(mesh.Keys) + BytesIn(mesh.Rules) + BytesIn(mesh.UsedRules) +
    BytesIn(mesh.OwnIds) + BytesIn(mesh.Cells.Types) + BytesIn(mesh.Cells.Starts) +
    BytesIn(mesh.Cells.Corners) + BytesIn(mesh.Cells.FaceStarts) + BytesIn(mesh.Cells.Faces);
}
}

#endif
