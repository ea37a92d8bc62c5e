// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartDecoder.h"

#include "gatunArrayContext.h"
#include "gatunCellCodec.h"
#include "gatunCellSplitter.h"
#include "gatunCellStore.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gatun
{
namespace
{
std::string Name(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index);
}

void CheckBelow(const std::vector<Key>& ids, Key end)
{
  if (std::any_of(ids.begin(), ids.end(), [&](Key id) { return id >= end; }))
  {
    ThrowCorrupt("it names a place that is not there");
  }
}

template <typename Part>
std::shared_ptr<const Part> KeepIn(
  ChunkCache::Internals& cache, const PartKey& key, std::shared_ptr<const Part> part)
{
  cache.Keep(key, part, BytesOf(*part));
  return part;
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const DomainsPart> PartDecoder::GetDomains(
  std::uint32_t array, std::size_t step) const
{
  const PartKey key{ PartKind::Domains, 0, array, step };
  if (auto found = this->Kept().Find<DomainsPart>(key))
  {
    return found;
  }
  return KeepIn<DomainsPart>(this->Kept(), key,
    std::make_shared<const DomainsPart>(this->Content().MakeDomains(array, step)));
}

std::shared_ptr<const PointsPart> PartDecoder::GetBlockPoints(std::uint32_t block) const
{
  const PartKey key{ PartKind::BlockPoints, block };
  if (auto found = this->Kept().Find<PointsPart>(key))
  {
    return found;
  }
  const auto& content = this->Content();
  const auto entry = content.GetTables().GetBlock(block);
  const auto count = static_cast<std::size_t>(entry->Points);
  const auto what = Name("the points of block", block);
  const auto stream = content.File.Read(entry->Geometry, what);
  std::vector<ComponentKeys> keys(3);
  for (auto& component : keys)
  {
    component.Now.resize(count);
  }
  content.File.Guarded(
    what, entry->Geometry, [&] { DecodeCellValues(stream, {}, content.Domains, keys); });
  auto points = std::make_shared<PointsPart>(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    (*points)[i] = { keys[0].Now[i], keys[1].Now[i], keys[2].Now[i] };
  }
  return KeepIn<PointsPart>(this->Kept(), key, std::move(points));
}

std::shared_ptr<const OrderPart> PartDecoder::GetBlockOrder(std::uint32_t block) const
{
  const PartKey key{ PartKind::BlockOrder, block };
  if (auto found = this->Kept().Find<OrderPart>(key))
  {
    return found;
  }
  const auto& content = this->Content();
  const auto entry = content.GetTables().GetBlock(block);
  const auto& where = entry->Order;
  const auto what = Name("the order of the points of block", block);
  const auto stream = content.File.Read(where, what);
  ComponentKeys keys;
  keys.Now.resize(static_cast<std::size_t>(entry->Points));
  const Domain ids(GetNumberType(content.Meta.Points));
  content.File.Guarded(what, where,
    [&]
    {
      DecodeCellValues(stream, {}, { &ids, 1 }, { &keys, 1 });
      CheckBelow(keys.Now, content.Meta.Points);
    });
  return KeepIn<OrderPart>(
    this->Kept(), key, std::make_shared<const OrderPart>(keys.Now, ids.GetType()));
}

//------------------------------------------------------------------------------
template <typename Part, typename Use>
void PartDecoder::EachShared(
  std::uint32_t chunk, const ChunkMesh& mesh, const OfBlock<Part>& partOf, Use&& use) const
{
  const auto entry = this->Content().GetTables().GetChunk(chunk);
  std::vector<std::shared_ptr<const Part>> held;               // one for each part of the chunk
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places; // part, position in its block
  for (const auto& part : entry->Shared)
  {
    for (std::uint32_t i = 0; i < part.Points; ++i)
    {
      places.emplace_back(
        static_cast<std::uint32_t>(held.size()), static_cast<std::uint32_t>(part.FirstInBlock) + i);
    }
    held.push_back(partOf(part.Block));
  }
  for (Vertex v = 0; v < mesh.Walk.Sources.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    if (source & Topology::SharedFlag)
    {
      const auto& place = places[source & ~Topology::SharedFlag];
      use(v, *held[place.first], place.second);
    }
  }
}

std::shared_ptr<const ChunkMesh> PartDecoder::FindMesh(std::uint32_t chunk) const
{
  auto found = this->Kept().Find<ChunkMesh>({ PartKind::ChunkMesh, chunk });
  if (found)
  {
    this->Kept().Count(&ChunkCacheStatistics::MeshesFound);
  }
  return found;
}

std::shared_ptr<const ChunkMesh> PartDecoder::DecodeMesh(
  std::uint32_t chunk, const OfBlock<PointsPart>& pointsOf) const
{
  const auto& content = this->Content();
  const auto held = content.GetTables().GetChunk(chunk);
  const auto& entry = *held;
  ChunkFrame frame;
  entry.Sizes.SetIn(frame);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = content.Domains;
  frame.SharedUsers = content.GetTables().GetSharedUsers(chunk);
  frame.SharedKeys.reserve(frame.SharedUsers.size());
  for (const auto& part : entry.Shared)
  {
    const auto points = pointsOf(part.Block);
    const auto begin = points->begin() + static_cast<std::ptrdiff_t>(part.FirstInBlock);
    frame.SharedKeys.insert(frame.SharedKeys.end(), begin, begin + part.Points);
  }
  const auto what = Name("the mesh of chunk", chunk);
  const auto connectivity = content.File.Read(entry.Connectivity, what);
  const auto geometry = content.File.Read(entry.Geometry, what);
  auto mesh = content.File.Guarded(what, entry.Connectivity,
    [&]
    {
      return std::make_shared<ChunkMesh>(entry.Sizes.IsTetrahedral
          ? DecodeChunk(frame, connectivity, geometry)
          : DecodeCells(frame, content.Cells->Shapes, connectivity, geometry));
    });
  this->CheckPolyhedra(chunk, *mesh);
  this->Kept().Count(&ChunkCacheStatistics::MeshesDecoded);
  return KeepIn<ChunkMesh>(this->Kept(), { PartKind::ChunkMesh, chunk }, std::move(mesh));
}

template <typename AnyFit, typename Make>
void PartDecoder::FindFit(
  std::shared_ptr<const AnyFit>& fit, PartKind kind, std::uint32_t number, Make&& make) const
{
  if (fit)
  {
    return;
  }
  // Separate from the mesh, which other threads may use, because not every chunk needs it.
  const PartKey key{ kind, number };
  fit = this->Kept().Find<AnyFit>(key);
  if (!fit)
  {
    fit = std::make_shared<const AnyFit>(make());
    this->Kept().Keep(key, fit, sizeof(*fit) + fit->GetBytes());
  }
}

void PartDecoder::DecodePoints(std::uint32_t chunk, const ChunkMesh& mesh,
  std::span<const std::uint8_t> stream, std::span<const Domain> domains,
  std::span<ComponentKeys> keys, PartFits& fits) const
{
  const auto mode = ArrayModes::Read(stream).Spatial;
  CheckPointMode(mode, mesh.Walk);
  auto context = MakePointContext(mesh);
  if (mode == SpatialMode::Fit)
  {
    this->FindFit(fits.Linear, PartKind::ChunkFit, chunk,
      [&] { return NeighborFit(mesh.Walk, mesh.GetPlaces()); });
    context.Fit = fits.Linear.get();
  }
  else if (IsQuadratic(mode))
  {
    this->FindFit(fits.Points, PartKind::ChunkQuadratic, chunk,
      [&] { return QuadraticFit(mesh.Walk, mesh.GetPlaces()); });
    context.Quadratic = fits.Points.get();
  }
  DecodePointValues(stream, context, domains, keys);
}

std::vector<Key> PartDecoder::DecodeCellIntegers(const StreamRef& where, const std::string& what,
  const ChunkMesh& mesh, ScalarType type, Key end) const
{
  const auto& content = this->Content();
  const auto stream = content.File.Read(where, what);
  const Domain domain(type);
  ComponentKeys keys;
  keys.Now.resize(mesh.Walk.Parents.size());
  content.File.Guarded(what, where,
    [&]
    {
      DecodeCellValues(stream, { mesh.Walk.Parents }, { &domain, 1 }, { &keys, 1 });
      CheckBelow(keys.Now, end);
    });
  return std::move(keys.Now);
}

std::shared_ptr<const OrderPart> PartDecoder::GetCellOrder(
  std::uint32_t chunk, const ChunkMesh& mesh) const
{
  const PartKey key{ PartKind::ChunkCellOrder, chunk };
  if (auto found = this->Kept().Find<OrderPart>(key))
  {
    return found;
  }
  const auto& content = this->Content();
  const auto cells = content.GetTables().GetNumberOfCells();
  const auto ids = this->DecodeCellIntegers(content.GetTables().GetChunk(chunk)->CellOrder,
    Name("the original order of the cells of chunk", chunk), mesh, GetNumberType(cells), cells);
  return KeepIn<OrderPart>(
    this->Kept(), key, std::make_shared<const OrderPart>(ids, GetNumberType(cells)));
}

std::shared_ptr<const OrderPart> PartDecoder::GetPointOrder(
  std::uint32_t chunk, const ChunkMesh& mesh, const OfBlock<OrderPart>& orderOf) const
{
  const PartKey key{ PartKind::ChunkPointOrder, chunk };
  if (auto found = this->Kept().Find<OrderPart>(key))
  {
    return found;
  }
  const auto& content = this->Content();
  const auto where = content.GetTables().GetChunk(chunk)->PointOrder;
  const auto what = Name("the original order of the points of chunk", chunk);
  const auto stream = content.File.Read(where, what);
  const Domain ids(GetNumberType(content.Meta.Points));
  ComponentKeys keys;
  keys.Now.resize(mesh.Keys.size());
  this->EachShared<OrderPart>(chunk, mesh, orderOf,
    [&](Vertex v, const OrderPart& order, std::uint32_t place) { keys.Now[v] = order[place]; });
  content.File.Guarded(what, where,
    [&]
    {
      PartFits fits;
      this->DecodePoints(chunk, mesh, stream, { &ids, 1 }, { &keys, 1 }, fits);
      CheckBelow(keys.Now, content.Meta.Points);
    });
  std::vector<Key> own(mesh.OwnIds.size());
  std::transform(mesh.OwnIds.begin(), mesh.OwnIds.end(), own.begin(),
    [&](std::uint32_t vertex) { return keys.Now[vertex]; });
  return KeepIn<OrderPart>(
    this->Kept(), key, std::make_shared<const OrderPart>(own, ids.GetType()));
}

std::vector<Key> PartDecoder::DecodeCorners(std::uint32_t chunk, const ChunkMesh& mesh) const
{
  return this->DecodeCellIntegers(this->Content().GetTables().GetChunk(chunk)->Corners,
    Name("the corners of chunk", chunk), mesh, ScalarType::UInt8, 12);
}

//------------------------------------------------------------------------------
CellList PartDecoder::GetCells(
  std::uint32_t chunk, const ChunkMesh& mesh, bool restoreCorners) const
{
  const auto& content = this->Content();
  const auto held = content.GetTables().GetChunk(chunk);
  const auto& entry = *held;
  if (entry.Sizes.IsTetrahedral)
  {
    auto tets = mesh.Walk.CopyTets();
    const auto rotations = restoreCorners ? this->DecodeCorners(chunk, mesh) : std::vector<Key>{};
    for (std::size_t t = 0; t < rotations.size(); ++t)
    {
      tets[t] = RotateCorners(tets[t], static_cast<unsigned>(rotations[t]));
    }
    return MakeTetList(tets);
  }
  auto cells = mesh.Cells;
  if (restoreCorners && entry.Corners.Length > 0)
  {
    const auto what = Name("the corners of chunk", chunk);
    const auto stream = content.File.Read(entry.Corners, what);
    content.File.Guarded(what, entry.Corners, [&] { RestoreCorners(cells, stream); });
  }
  return cells;
}

//------------------------------------------------------------------------------
ChunkSize PartDecoder::SplitCells(std::uint32_t chunk, const ChunkMesh& mesh) const
{
  const auto& content = this->Content();
  const auto held = content.GetTables().GetChunk(chunk);
  const auto& entry = *held;
  auto split = gatun::SplitCells(mesh);
  if (split.Tets.size() != entry.Info.Tets)
  {
    content.File.Fail(ErrorCode::Corrupt, Name("the mesh of chunk", chunk),
      entry.Connectivity.Offset, "is damaged: it does not have the tetrahedra that it should have");
  }
  return split;
}

//------------------------------------------------------------------------------
/** Throws unless a chunk has as many polyhedra as the table of cells says. */
void PartDecoder::CheckPolyhedra(std::uint32_t chunk, const ChunkMesh& mesh) const
{
  const auto& content = this->Content();
  const auto held = content.GetTables().GetChunk(chunk);
  const auto& entry = *held;
  const auto& types = mesh.Cells.Types;
  if (static_cast<std::size_t>(std::count(types.begin(), types.end(), PolyhedronType)) !=
    entry.Sizes.Polyhedra)
  {
    content.File.Fail(ErrorCode::Corrupt, Name("the mesh of chunk", chunk),
      entry.Connectivity.Offset, "is damaged: it does not have the polyhedra that it should have");
  }
}

//------------------------------------------------------------------------------
ArrayAtStep PartDecoder::FindBlockArray(
  std::uint32_t block, std::uint32_t array, std::size_t first, std::size_t step) const
{
  auto [values, at] =
    this->Kept().FindLatest<ArrayPart>({ PartKind::BlockArray, block, array, step }, first);
  return { std::move(values), at };
}

ArrayAtStep PartDecoder::FindChunkArray(
  std::uint32_t chunk, std::uint32_t array, std::size_t first, std::size_t step) const
{
  auto [values, at] =
    this->Kept().FindLatest<ArrayPart>({ PartKind::ChunkArray, chunk, array, step }, first);
  if (values && at == step)
  {
    this->Kept().Count(&ChunkCacheStatistics::ArraysFound);
  }
  return { std::move(values), at };
}

std::vector<ComponentKeys> PartDecoder::MakeKeys(
  std::uint32_t array, std::size_t step, std::size_t count, const ArrayPart* before) const
{
  std::vector<ComponentKeys> keys(this->Content().Meta.Arrays[array].Components);
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    if (before && this->Content().HasBefore(array, step))
    {
      keys[c].Before = (*before)[c];
    }
    keys[c].Now.resize(count);
  }
  return keys;
}

//------------------------------------------------------------------------------
namespace
{
/** The key of a value in another domain of the same type, plain or with a scale, which must contain
 * it. */
Key Convert(Key key, const Domain& from, const Domain& to)
{
  try
  {
    return to.FromPlain(from.ToPlain(key));
  }
  catch (const Error&)
  {
    ThrowCorrupt("coordinates of another time step are not on its scale");
  }
}
}

template <typename MeshKeys>
std::vector<ComponentKeys> PartDecoder::MakePointKeys(std::size_t step, std::size_t count,
  const DomainsPart& domains, const ArrayPart* before, MeshKeys&& mesh) const
{
  const auto& content = this->Content();
  const auto array = content.GetPointArray();
  const auto reference = content.GetTables().GetPointReference(step);
  std::vector<ComponentKeys> keys(domains.size());
  for (auto& component : keys)
  {
    component.Now.resize(count);
  }
  if (!content.HasBefore(array, step))
  {
    return keys;
  }
  const auto others = reference > 0 ? this->GetDomains(array, reference) : nullptr;
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    auto& to = keys[c].Before;
    const auto& from = others ? (*others)[c] : content.Domains[c];
    if (others && from.GetScale() == domains[c].GetScale())
    {
      to = (*before)[c];
      continue;
    }
    to.resize(count);
    const bool isSame = !from.GetPalette() && from.GetScale() == domains[c].GetScale();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Key key = others ? (*before)[c][i] : mesh(i)[c];
      to[i] = isSame ? key : Convert(key, from, domains[c]);
    }
  }
  return keys;
}

namespace
{
bool NeedsQuadraticFit(std::span<const std::uint8_t> stream)
{
  return IsQuadratic(ArrayModes::Read(stream).Spatial);
}

std::shared_ptr<const ArrayPart> TakeValues(std::vector<ComponentKeys>& keys)
{
  auto values = std::make_shared<ArrayPart>();
  values->reserve(keys.size());
  for (auto& component : keys)
  {
    values->push_back(std::move(component.Now));
  }
  return values;
}
}

std::shared_ptr<const ArrayPart> PartDecoder::DecodeBlockArray(std::uint32_t block,
  std::uint32_t array, std::size_t step, const DomainsPart& domains,
  const std::shared_ptr<const ArrayPart>& before, PartFits& fits) const
{
  if (this->StandsStill(array, step))
  {
    return before;
  }
  const auto& content = this->Content();
  const auto& description = content.Meta.Arrays[array];
  if (content.IsCopy(array, step))
  {
    return std::make_shared<const ArrayPart>(description.Components);
  }
  const auto what = Name("array '" + description.Name + "' of block", block);
  const auto where = content.GetTables().GetBlockValues(block, array, step);
  const auto count = static_cast<std::size_t>(content.GetTables().GetBlock(block)->Points);
  std::vector<ComponentKeys> keys;
  const auto stream = content.File.Read(where, what);
  content.File.Guarded(what, where,
    [&]
    {
      keys = this->Content().Meta.IsPoints(array)
        ? this->MakePointKeys(step, count, domains, before.get(),
            [points = std::shared_ptr<const PointsPart>(), block, this](std::size_t i) mutable
            {
              points = points ? points : this->GetBlockPoints(block);
              return (*points)[i];
            })
        : this->MakeKeys(array, step, count, before.get());
      if (NeedsQuadraticFit(stream))
      {
        this->FindFit(fits.Points, PartKind::BlockQuadratic, block,
          [&] { return QuadraticFit(GetPlaces(*this->GetBlockPoints(block), content.Domains)); });
      }
      DecodeCellValues(stream, { {}, fits.Points.get() }, domains, keys);
    });
  return TakeValues(keys);
}

std::shared_ptr<const ArrayPart> PartDecoder::DecodeChunkArray(std::uint32_t chunk,
  const ChunkMesh& mesh, std::uint32_t array, std::size_t step, const DomainsPart& domains,
  const std::shared_ptr<const ArrayPart>& before, const OfBlock<ArrayPart>& valuesOf,
  PartFits& fits) const
{
  const auto& content = this->Content();
  const auto& description = content.Meta.Arrays[array];
  const bool ofPoints = description.Where == Association::Point;
  if (this->StandsStill(array, step))
  {
    return before;
  }
  if (content.IsCopy(array, step))
  {
    return std::make_shared<const ArrayPart>(description.Components);
  }
  const auto what = Name("array '" + description.Name + "' of chunk", chunk);
  const auto where = content.GetTables().GetChunkValues(chunk, array, step);
  std::vector<ComponentKeys> keys;
  const auto stream = content.File.Read(where, what);
  content.File.Guarded(what, where,
    [&]
    {
      const auto count = ofPoints ? mesh.Keys.size() : mesh.Walk.Parents.size();
      keys = content.Meta.IsPoints(array) ? this->MakePointKeys(step, count, domains, before.get(),
                                              [&](std::size_t i) { return mesh.Keys[i]; })
                                          : this->MakeKeys(array, step, count, before.get());
      if (!ofPoints)
      {
        if (NeedsQuadraticFit(stream))
        {
          this->FindFit(
            fits.Cells, PartKind::ChunkCellQuadratic, chunk, [&] { return FitCells(mesh); });
        }
        DecodeCellValues(stream, { mesh.Walk.Parents, fits.Cells.get() }, domains, keys);
        return;
      }
      this->EachShared<ArrayPart>(chunk, mesh, valuesOf,
        [&](Vertex v, const ArrayPart& values, std::uint32_t place)
        {
          for (std::size_t c = 0; c < keys.size(); ++c)
          {
            keys[c].Now[v] = values[c][place];
          }
        });
      this->DecodePoints(chunk, mesh, stream, domains, keys, fits);
    });
  this->Kept().Count(&ChunkCacheStatistics::ArraysDecoded);
  return TakeValues(keys);
}

void PartDecoder::KeepBlockArray(
  std::uint32_t block, std::uint32_t array, const ArrayAtStep& values) const
{
  KeepIn(this->Kept(), { PartKind::BlockArray, block, array, values.Step }, values.Values);
}

void PartDecoder::KeepChunkArray(
  std::uint32_t chunk, std::uint32_t array, const ArrayAtStep& values) const
{
  KeepIn(this->Kept(), { PartKind::ChunkArray, chunk, array, values.Step }, values.Values);
}
}
