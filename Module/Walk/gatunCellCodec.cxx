// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellCodec.h"

#include "gatunCellBuilder.h"
#include "gatunCellListCoder.h"
#include "gatunCellTree.h"
#include "gatunCellTreeChunk.h"
#include "gatunChunkPlaces.h"
#include "gatunEncoderPolygons.h"
#include "gatunFaceMarks.h"
#include "gatunFloatEnvironment.h"
#include "gatunMorton.h"
#include "gatunPolygonWalk.h"
#include "gatunSurfaceWalk.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
using Order = std::vector<std::uint32_t>;

constexpr std::uint8_t FlagWalk = 1;
constexpr std::uint8_t FlagMarks = 2;
constexpr std::uint8_t FlagSurface = 4;
constexpr std::uint8_t FlagHexahedra = 8;
constexpr std::uint8_t FlagUniform = 16;
constexpr std::uint8_t FlagTree = 32; // alone

/** One way to encode the connectivity of a chunk. */
struct CellAttempt
{
  Bytes Stream;
  ChunkMesh Mesh; // without keys
  std::vector<std::uint32_t> InputOf;
  std::vector<std::uint32_t> OwnOrder;
  std::vector<std::uint32_t> CellOrder;
  std::size_t Others = 0; // cells that no walk takes
};

/** The length that a connectivity stream must have at least. */
std::size_t GetLeastBytes(const CellCounts& counts)
{
  const std::size_t values = std::size_t{ counts.Corners } + counts.FaceValues;
  return std::max<std::size_t>(counts.Cells / MaxItemsPerByte, values / MaxCornersPerByte) + 1;
}

/** Sorts cells by their centers in space. */
void SortByPlace(Order& order, const CellList& cells, const Bounds& box,
  std::span<const std::array<double, 3>> places)
{
  std::vector<std::uint64_t> codes(cells.GetNumber());
  for (const auto c : order)
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
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
}

/** Runs the walk that the flags name. Returns its border. */
template <typename Coder, typename Side>
ClosedFaces WalkCells(unsigned flags, Coder& coder, CellBuilder<Side>& mesh,
  AttachedNodes<Coder, Side>& nodes, const FormTable& forms, EncoderPolygons* actual)
{
  if ((flags & FlagHexahedra) != 0)
  {
    PolygonWalk<Coder, Side, HexForm> walk(coder, mesh, nodes, forms, actual);
    return walk.Run();
  }
  PolygonWalk<Coder, Side, CellForm> walk(coder, mesh, nodes, forms, actual);
  return walk.Run();
}

/** What all attempts start from. */
struct CellInput
{
  const ChunkFrame& Frame;
  const CellList& Cells;
  const FormTable& Forms;
  bool KeepCorners;
  std::span<const LatticePoint> Shared, OwnPlaces;

  /** Whether there are cells for a walk over cells. */
  bool HasSolids() const { return this->Forms.GetSize() > 0 || !this->Cells.Faces.empty(); }
};

/** Encodes cells by walks if they are wanted, and those that they do not take in an order that
 * sort(cells) gives. */
template <typename Sort>
CellAttempt TryCells(const CellInput& input, bool withWalks, Sort&& sort)
{
  CellAttempt result;
  EntropyEncoder coder;
  CellEncoderSide side(
    input.Cells, static_cast<std::uint32_t>(input.Shared.size()), input.OwnPlaces);
  CellBuilder mesh(input.Frame, input.Shared, side, result.Mesh);
  AttachedNodes nodes(coder, mesh);
  std::uint8_t flags = 0;
  Order others(input.Cells.GetNumber());
  std::iota(others.begin(), others.end(), 0u);
  if (withWalks && input.HasSolids())
  {
    flags |= FlagWalk;
    EncoderPolygons actual(input.Cells, input.Forms);
    others = actual.GetOthers();
    flags |= actual.IsOfHexahedra() ? FlagHexahedra : 0;
    const auto borders = WalkCells(flags, coder, mesh, nodes, input.Forms, &actual);
    EncoderMarks marks(input.Cells, others);
    if (marks.HasCells())
    {
      FaceMarks(coder, mesh, nodes).Run(borders, &marks);
      flags |= FlagMarks;
      std::erase_if(others, [&](std::uint32_t cell) { return marks.IsTaken(cell); });
    }
  }
  if (withWalks)
  {
    EncoderSurface actual(input.Cells, others, input.KeepCorners);
    if (actual.HasCells())
    {
      flags |= FlagSurface | (actual.IsUniform() ? FlagUniform : 0);
      SurfaceWalk(coder, mesh, nodes, (flags & FlagUniform) != 0, &actual).Run();
      std::erase_if(others, [&](std::uint32_t cell) { return actual.IsTaken(cell); });
    }
  }
  sort(others);
  CellListCoder list(coder, mesh, nodes);
  for (const auto cell : others)
  {
    list.Code(cell);
  }
  mesh.Finish();
  const auto body = coder.Finish();
  result.Stream.push_back(flags);
  result.Stream.insert(result.Stream.end(), body.begin(), body.end());
  result.Stream.resize(std::max(result.Stream.size(), GetLeastBytes(input.Frame.Cells)), 0);
  result.InputOf = std::move(side.InputOf);
  result.OwnOrder = std::move(side.OwnOrder);
  result.CellOrder = std::move(side.CellOrder);
  result.Others = others.size();
  return result;
}

CellAttempt EncodeConnectivity(const ChunkFrame& frame, const CellList& cells,
  const FormTable& forms, std::span<const PointKeys> ownKeys, bool keepCorners)
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

  // Cells one by one take about this number of bytes or less.
  constexpr std::size_t listBytes = 3;
  const CellInput input{ frame, cells, forms, keepCorners, shared, ownPlaces };
  const auto keep = [](Order&) {};
  const auto sort = [&](Order& order) { SortByPlace(order, cells, frame.Box, places); };
  CellAttempt best;
  const auto consider = [&](CellAttempt attempt)
  {
    if (best.Stream.empty() || attempt.Stream.size() < best.Stream.size())
    {
      best = std::move(attempt);
    }
  };
  consider(TryCells(input, true, keep));
  if (best.Stream[0] != 0 && best.Others > cells.GetNumber() / 16)
  {
    consider(TryCells(input, true, sort));
  }
  if (best.Stream[0] == 0)
  {
    consider(TryCells(input, false, sort));
  }
  else if (best.Stream.size() > listBytes * cells.GetNumber())
  {
    consider(TryCells(input, false, keep));
    consider(TryCells(input, false, sort));
  }
  return best;
}
}

//------------------------------------------------------------------------------
EncodedCells EncodeCells(const ChunkFrame& frame, const CellList& cells, const ShapeTable& shapes,
  std::span<const PointKeys> ownKeys, bool keepCorners, Profile profile)
{
  const FloatEnvironment guard;
  if (profile == Profile::Fast &&
    FitsCellTree(cells.GetNumber(), frame.SharedKeys.size() + ownKeys.size()))
  {
    auto result = EncodeCellTreeChunk(frame, cells, ownKeys, keepCorners);
    auto& stream = result.Connectivity;
    stream.insert(stream.begin(), FlagTree);
    stream.resize(std::max(stream.size(), GetLeastBytes(frame.Cells)), 0);
    return result;
  }
  auto best = EncodeConnectivity(frame, cells, *shapes.GetForms(), ownKeys, keepCorners);

  EncodedCells result;
  result.Connectivity = std::move(best.Stream);
  result.OwnOrder = std::move(best.OwnOrder);
  result.CellOrder = std::move(best.CellOrder);
  result.Mesh = std::move(best.Mesh);
  auto& mesh = result.Mesh;
  mesh.Domains = frame.Domains;
  mesh.OwnIds = mesh.Walk.FindOwnIds();
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

ChunkMesh DecodeCells(const ChunkFrame& frame, const ShapeTable& shapes,
  std::span<const std::uint8_t> connectivity, std::span<const std::uint8_t> geometry)
{
  const FloatEnvironment guard;
  const std::uint64_t values = std::uint64_t{ frame.Cells.Corners } + frame.Cells.FaceValues;
  if (frame.Cells.Cells > MaxChunkTets || values > MaxChunkCorners ||
    connectivity.size() < GetLeastBytes(frame.Cells) ||
    frame.OwnPoints + frame.SharedKeys.size() > values)
  {
    ThrowCorrupt("a chunk claims more cells or points than its stream can hold");
  }
  const unsigned flags = connectivity[0];
  if (flags == FlagTree)
  {
    return DecodeCellTreeChunk(frame, connectivity.subspan(1), geometry);
  }
  if (flags > (FlagWalk | FlagMarks | FlagSurface | FlagHexahedra | FlagUniform) ||
    ((flags & FlagWalk) == 0 && (flags & (FlagMarks | FlagHexahedra)) != 0) ||
    ((flags & FlagSurface) == 0 && (flags & FlagUniform) != 0))
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
  AttachedNodes nodes(symbols, builder);
  if ((flags & FlagWalk) != 0)
  {
    const auto forms = shapes.GetForms();
    const auto borders = WalkCells(flags, symbols, builder, nodes, *forms, nullptr);
    if ((flags & FlagMarks) != 0)
    {
      FaceMarks(symbols, builder, nodes).Run(borders, nullptr);
    }
  }
  if ((flags & FlagSurface) != 0)
  {
    SurfaceWalk(symbols, builder, nodes, (flags & FlagUniform) != 0, nullptr).Run();
  }
  CellListCoder list(symbols, builder, nodes);
  while (!builder.IsFull())
  {
    list.Code(0);
  }
  builder.Finish();
  mesh.OwnIds = mesh.Walk.FindOwnIds();
  return mesh;
}
}
