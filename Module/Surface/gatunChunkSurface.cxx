// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunChunkSurface.h"

#include "gatunChunkCacheInternals.h"
#include "gatunDomainWriter.h"
#include "gatunFloatEnvironment.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace gatun
{
namespace
{
/** Stores the values of a component of tuples of a given size. */
void Store(const Domain& domain, std::span<const Key> keys, std::size_t tupleSize, std::uint8_t* to)
{
  WithWriter(domain,
    [&](auto&& write)
    {
      for (std::size_t i = 0; i < keys.size(); ++i)
      {
        write(keys[i], to + i * tupleSize);
      }
    });
}

/** The coordinates of all vertices of a chunk. */
std::vector<std::uint8_t> GetCoordinates(const ChunkMesh& mesh)
{
  const std::size_t size = SizeOf(mesh.Domains[0].GetType());
  std::vector<std::uint8_t> points(3 * size * mesh.Keys.size());
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    WithWriter(mesh.Domains[axis],
      [&](auto&& write)
      {
        auto* to = points.data() + axis * size;
        for (const PointKeys& keys : mesh.Keys)
        {
          write(keys[axis], to);
          to += 3 * size;
        }
      });
  }
  return points;
}

/** Provides a part of each block, which is asked for once and held. */
template <typename Part, typename Get>
auto HoldBlocks(Get&& get)
{
  return [held = std::map<std::uint32_t, std::shared_ptr<const Part>>{},
           get = std::forward<Get>(get)](std::uint32_t block) mutable
  {
    auto& part = held[block];
    if (!part)
    {
      part = get(block);
    }
    return part;
  };
}
}

namespace
{
/** The tetrahedra of a chunk without those of cells that are not alive. */
class RemainingTets
{
public:
  using Tets = std::vector<std::array<Vertex, 4>>;
  using Cells = std::vector<std::uint32_t>;

  /** cells: of which the tetrahedra are; null if each is one. */
  RemainingTets(const PartDecoder& parts, std::uint32_t chunk, const Tets& all, const Cells* cells)
    : List(&all)
    , Parents(cells)
  {
    const auto mask = MaskOf(*parts.GetFile());
    const auto& info = parts.Content().GetTables().GetChunks()[chunk];
    if (!mask || mask->Count(info.FirstCell, info.Cells) == info.Cells)
    {
      return;
    }
    for (std::size_t t = 0; t < all.size(); ++t)
    {
      const auto cell = cells ? (*cells)[t] : static_cast<std::uint32_t>(t);
      if (mask->IsAlive[static_cast<std::size_t>(info.FirstCell) + cell])
      {
        this->Left.push_back(all[t]);
        this->LeftCells.push_back(cell);
      }
    }
    this->List = &this->Left;
    this->Parents = &this->LeftCells;
  }
  RemainingTets(const RemainingTets&) = delete;
  RemainingTets& operator=(const RemainingTets&) = delete;

  const Tets& GetTets() const { return *this->List; }

  /** The cell of each tetrahedron, or null if they are the cells. */
  const Cells* GetCells() const { return this->Parents; }

private:
  Tets Left;
  Cells LeftCells;
  const Tets* List;
  const Cells* Parents;
};
}

/** The values of an array in a chunk. */
struct ChunkSurface::Values
{
  std::vector<std::uint8_t> Bytes;
  TupleView View;

  /** Replaces the tuples by the given ones. */
  void Select(std::span<const std::uint32_t> tuples)
  {
    const std::size_t size = this->View.GetTupleSize();
    std::vector<std::uint8_t> selected(tuples.size() * size);
    for (std::size_t i = 0; i < tuples.size(); ++i)
    {
      std::memcpy(selected.data() + i * size, this->Bytes.data() + tuples[i] * size, size);
    }
    this->Bytes = std::move(selected);
    this->View.Values = this->Bytes.data();
  }
};

//------------------------------------------------------------------------------
ChunkSurface::ChunkSurface(const std::shared_ptr<ChunkCache>& cache, ChunkSurfaceArrays arrays)
  : Cache(cache)
  , Parts(cache)
  , Arrays(std::move(arrays))
{
}

//------------------------------------------------------------------------------
void ChunkSurface::RemoveUsedBlocks(std::span<const std::uint32_t> chunks)
{
  const auto& tables = this->Parts.Content().GetTables();
  if (this->Users.empty())
  {
    this->Users = std::vector<std::atomic<std::uint32_t>>(tables.GetNumberOfBlocks());
  }
  for (const std::uint32_t chunk : chunks)
  {
    const auto entry = tables.GetChunk(chunk);
    for (const auto& part : entry->Shared)
    {
      ++this->Users[part.Block];
    }
  }
}

void ChunkSurface::Release(std::uint32_t chunk)
{
  if (this->Users.empty())
  {
    return;
  }
  std::vector<std::uint32_t> unused;
  const auto entry = this->Parts.Content().GetTables().GetChunk(chunk);
  for (const auto& part : entry->Shared)
  {
    if (--this->Users[part.Block] == 0)
    {
      unused.push_back(part.Block);
    }
  }
  if (!unused.empty())
  {
    std::sort(unused.begin(), unused.end());
    InternalsOf(*this->Cache).RemoveBlocks(unused);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const ChunkMesh> ChunkSurface::GetMesh(std::uint32_t chunk) const
{
  auto mesh = this->Parts.FindMesh(chunk);
  return mesh ? mesh
              : this->Parts.DecodeMesh(chunk,
                  HoldBlocks<PointsPart>(
                    [this](std::uint32_t block) { return this->Parts.GetBlockPoints(block); }));
}

std::shared_ptr<const ArrayPart> ChunkSurface::GetBlockArray(
  std::uint32_t block, std::uint32_t array, std::size_t step) const
{
  const auto key = this->Parts.Content().FindKeyStep(array, step);
  auto reached = this->Parts.FindBlockArray(block, array, key, step);
  if (reached.Values && reached.Step == step)
  {
    return reached.Values;
  }
  PartFits fits;
  for (auto at = reached.Values ? reached.Step + 1 : key; at <= step; ++at)
  {
    reached = { this->Parts.DecodeBlockArray(
                  block, array, at, *this->Parts.GetDomains(array, at), reached.Values, fits),
      at };
  }
  this->Parts.KeepBlockArray(block, array, reached);
  return reached.Values;
}

std::shared_ptr<const ArrayPart> ChunkSurface::GetArray(
  std::uint32_t chunk, const ChunkMesh& mesh, std::uint32_t array) const
{
  const auto& content = this->Parts.Content();
  const bool isPoints = content.Meta.IsPoints(array);
  const auto step =
    isPoints ? content.GetTables().GetPointStep(this->Arrays.Step) : this->Arrays.Step;
  const auto key = content.FindKeyStep(array, step);
  auto reached = this->Parts.FindChunkArray(chunk, array, key, step);
  if (reached.Values && reached.Step == step)
  {
    return reached.Values;
  }
  PartFits fits;
  for (auto at = reached.Values ? reached.Step + 1 : key; at <= step; ++at)
  {
    reached = { this->Parts.DecodeChunkArray(chunk, mesh, array, at,
                  *this->Parts.GetDomains(array, at), reached.Values,
                  HoldBlocks<ArrayPart>(
                    [&](std::uint32_t block) { return this->GetBlockArray(block, array, at); }),
                  fits),
      at };
  }
  this->Parts.KeepChunkArray(chunk, array, reached);
  return reached.Values;
}

//------------------------------------------------------------------------------
ChunkSurface::Values ChunkSurface::GetValues(
  std::uint32_t chunk, const ChunkMesh& mesh, std::uint32_t array) const
{
  const ArrayDescription& description = this->Parts.Content().Meta.Arrays[array];
  const auto source = this->Parts.Content().FindSource(array, this->Arrays.Step);
  const auto keys = this->GetArray(chunk, mesh, source.Array);
  const auto domains = this->Parts.GetDomains(source.Array, this->Arrays.Step);
  Values values{ {}, { nullptr, description.Type, description.Components } };
  const std::size_t size = values.View.GetTupleSize();
  values.Bytes.resize(keys->front().size() * size);
  auto* component = values.Bytes.data();
  for (const auto c : source.Components)
  {
    Store((*domains)[c], (*keys)[c], size, component);
    component += SizeOf(description.Type);
  }
  values.View.Values = values.Bytes.data();
  return values;
}

//------------------------------------------------------------------------------
SurfacePart ChunkSurface::Make(std::uint32_t chunk, const SurfaceOptions& options)
{
  const FloatEnvironment guard;
  const auto mesh = this->GetMesh(chunk);
  // Several tetrahedra may have the values of one cell.
  const bool isSplit = !this->Parts.GetFile()->GetChunks()[chunk].IsTetrahedral;
  const bool isPacked = !isSplit && mesh->Walk.HasTree();
  auto split = isSplit ? this->Parts.SplitCells(chunk, *mesh) : ChunkSize();
  if (isPacked)
  {
    split.Tets = mesh->Walk.CopyTets();
  }
  const RemainingTets remaining(this->Parts, chunk,
    isSplit || isPacked ? split.Tets : mesh->Walk.Tets, isSplit ? &split.Cells : nullptr);
  const auto& tets = remaining.GetTets();
  SurfaceInput input;
  input.Mesh.Points = mesh->Keys.size();
  input.Mesh.Connectivity = tets.data();
  input.Mesh.WideIds = false;
  std::vector<Values> values;
  const auto& carried = this->Arrays.Carried;
  for (const std::uint32_t array : carried)
  {
    values.push_back(this->GetValues(chunk, *mesh, array));
    const auto where = this->Parts.Content().Meta.Arrays[array].Where;
    if (remaining.GetCells() && where == Association::Cell)
    {
      values.back().Select(*remaining.GetCells());
    }
    (where == Association::Point ? input.PointArrays : input.CellArrays)
      .push_back(values.back().View);
  }
  auto scalars = static_cast<std::size_t>(
    std::find(carried.begin(), carried.end(), this->Arrays.Scalars) - carried.begin());
  if (scalars == carried.size())
  {
    values.push_back(this->GetValues(chunk, *mesh, this->Arrays.Scalars));
  }
  std::vector<double> converted;
  SetMarchValues(
    input.Mesh, values[scalars].View, mesh->Keys.size(), this->Arrays.Component, converted);
  std::vector<std::uint8_t> points;
  const auto& content = this->Parts.Content();
  if (content.GetTables().GetPointStep(this->Arrays.Step) > 0)
  {
    points = this->GetValues(chunk, *mesh, content.GetPointArray()).Bytes;
  }
  else
  {
    points = GetCoordinates(*mesh);
  }
  input.Points = { points.data(), mesh->Domains[0].GetType(), 3 };
  this->Release(chunk);
  return MakeSurfacePart(input, options, 0, tets.size());
}
}
