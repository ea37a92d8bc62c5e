// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellCodec.h"

#include "gatunCellBuilder.h"
#include "gatunCellListCoder.h"
#include "gatunChunkPlaces.h"
#include "gatunFloatEnvironment.h"
#include "gatunMorton.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
using Order = std::vector<std::uint32_t>;

/** One way to encode the connectivity of a chunk. */
struct CellAttempt
{
  Bytes Stream;
  ChunkMesh Mesh; // without keys
  std::vector<std::uint32_t> InputOf;
  std::vector<std::uint32_t> OwnOrder;
  std::vector<std::uint32_t> CellOrder;
};

/** The length that a connectivity stream must have at least. */
std::size_t GetLeastBytes(const CellCounts& counts)
{
  const std::size_t values = std::size_t{ counts.Corners } + counts.FaceValues;
  return std::max<std::size_t>(counts.Cells / MaxItemsPerByte, values / MaxCornersPerByte) + 1;
}

/** The cells in the order of their centers in space. */
Order SortByPlace(
  const CellList& cells, const Bounds& box, std::span<const std::array<double, 3>> places)
{
  std::vector<std::uint64_t> codes(cells.GetNumber());
  for (std::size_t c = 0; c < codes.size(); ++c)
  {
    const auto corners = cells.GetCorners(c);
    std::array<double, 3> center{ 0, 0, 0 };
    for (const auto v : corners)
    {
      for (unsigned i = 0; i < 3; ++i)
      {
        center[i] += places[v][i] / static_cast<double>(corners.size());
      }
    }
    codes[c] = GetMortonCode(box, center);
  }
  Order order(codes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
  return order;
}

CellAttempt TryList(const ChunkFrame& frame, const CellList& cells, const Order& order,
  std::span<const LatticePoint> shared, std::span<const LatticePoint> ownPlaces)
{
  CellAttempt result;
  EntropyEncoder coder;
  CellEncoderSide side(cells, static_cast<std::uint32_t>(shared.size()), ownPlaces);
  CellBuilder mesh(frame, shared, side, result.Mesh);
  CellListCoder list(coder, mesh);
  for (const auto cell : order)
  {
    list.Code(cell);
  }
  mesh.Finish();
  const auto body = coder.Finish();
  result.Stream.push_back(0);
  result.Stream.insert(result.Stream.end(), body.begin(), body.end());
  result.Stream.resize(std::max(result.Stream.size(), GetLeastBytes(frame.Cells)), 0);
  result.InputOf = std::move(side.InputOf);
  result.OwnOrder = std::move(side.OwnOrder);
  result.CellOrder = std::move(side.CellOrder);
  return result;
}

CellAttempt EncodeConnectivity(
  const ChunkFrame& frame, const CellList& cells, std::span<const PointKeys> ownKeys)
{
  const Lattice lattice(frame.Box);
  const auto shared = MapShared(lattice, frame.Domains, frame.SharedKeys, frame.SharedUsers);
  std::vector<LatticePoint> ownPlaces(ownKeys.size());
  std::vector<std::array<double, 3>> places;
  const auto addPlace = [&](const PointKeys& keys)
  {
    places.push_back({ frame.Domains[0].ToValue(keys[0]), frame.Domains[1].ToValue(keys[1]),
      frame.Domains[2].ToValue(keys[2]) });
  };
  std::for_each(frame.SharedKeys.begin(), frame.SharedKeys.end(), addPlace);
  for (std::size_t i = 0; i < ownKeys.size(); ++i)
  {
    ownPlaces[i] = MapKeys(lattice, frame.Domains, ownKeys[i]);
    addPlace(ownKeys[i]);
  }

  Order given(cells.GetNumber());
  std::iota(given.begin(), given.end(), 0u);
  auto best = TryList(frame, cells, given, shared, ownPlaces);
  const auto sorted = SortByPlace(cells, frame.Box, places);
  if (sorted != given)
  {
    auto other = TryList(frame, cells, sorted, shared, ownPlaces);
    if (other.Stream.size() < best.Stream.size())
    {
      best = std::move(other);
    }
  }
  return best;
}
}

//------------------------------------------------------------------------------
EncodedCells EncodeCells(const ChunkFrame& frame, const CellList& cells, const ShapeTable&,
  std::span<const PointKeys> ownKeys, bool keepCorners)
{
  const FloatEnvironment guard;
  auto best = EncodeConnectivity(frame, cells, ownKeys);

  EncodedCells result;
  result.Connectivity = std::move(best.Stream);
  result.OwnOrder = std::move(best.OwnOrder);
  result.CellOrder = std::move(best.CellOrder);
  result.Mesh = std::move(best.Mesh);
  auto& mesh = result.Mesh;
  mesh.Domains = frame.Domains;
  mesh.Keys.resize(mesh.Walk.Sources.size());
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    mesh.Keys[v] = mesh.Walk.IsShared(v) ? frame.SharedKeys[source & ~Topology::SharedFlag]
                                         : ownKeys[result.OwnOrder[source]];
  }
  result.Geometry = EncodeCellGeometry(mesh);
  if (keepCorners)
  {
    result.Corners = EncodeCorners(mesh.Cells, cells, result.CellOrder, best.InputOf);
  }
  return result;
}

ChunkMesh DecodeCells(const ChunkFrame& frame, const ShapeTable&,
  std::span<const std::uint8_t> connectivity, std::span<const std::uint8_t> geometry)
{
  const FloatEnvironment guard;
  if (connectivity.size() < GetLeastBytes(frame.Cells) ||
    frame.OwnPoints + frame.SharedKeys.size() >
      std::size_t{ frame.Cells.Corners } + frame.Cells.FaceValues)
  {
    ThrowCorrupt("a chunk claims more cells or points than its stream can hold");
  }
  if (connectivity[0] != 0)
  {
    ThrowCorrupt("a connectivity stream has unknown flags");
  }
  ByteReader in(geometry);
  const auto rules = CellRuleTable::Read(in);
  ChunkMesh mesh;
  mesh.Domains = frame.Domains;
  mesh.CellRules = rules.Rules;
  const Lattice lattice(frame.Box);
  const auto shared = MapShared(lattice, frame.Domains, frame.SharedKeys, frame.SharedUsers);
  EntropyDecoder symbols(connectivity.subspan(1));
  EntropyDecoder coordinates(in.GetBytes(in.GetRemaining()));
  CellDecoderSide side(frame, lattice, coordinates, rules, mesh);
  CellBuilder builder(frame, std::span<const LatticePoint>(shared), side, mesh);
  CellListCoder list(symbols, builder);
  while (!builder.IsFull())
  {
    list.Code(0);
  }
  builder.Finish();
  return mesh;
}
}
