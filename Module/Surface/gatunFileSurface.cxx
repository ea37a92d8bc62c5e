// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileSurface.h"

#include "gatunBytePlan.h"
#include "gatunChunkSurface.h"
#include "gatunCoarsePiece.h"
#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunPieceDecoder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gatun
{
namespace
{
// With merges, chunks of so many tetrahedra are simplified together, as they get points from each
// other.
constexpr std::uint64_t CoarseBatch = 1u << 21;

// Bytes kept in any case: of points that chunks share; with merges, of chunks.
constexpr std::uint64_t SharedCache = 32u << 20;
constexpr std::uint64_t CoarseCache = 64u << 20;

/** The arrays to decode: those that the surface carries, and at last the one that it is made of
 * unless it is among them. */
std::vector<std::uint32_t> ListArrays(const FileSurfaceRequest& request)
{
  auto arrays = request.Arrays;
  if (!std::binary_search(arrays.begin(), arrays.end(), request.Array))
  {
    arrays.push_back(request.Array);
  }
  return arrays;
}
}

/** Simplified chunks. */
struct FileSurface::Mesh
{
  std::uint64_t Tets = 0;
  SurfaceInput Input; // looks at the others
  std::vector<std::uint8_t> Points;
  std::vector<std::int32_t> Connectivity;
  std::vector<std::vector<std::uint8_t>> Arrays;
  std::vector<double> Values;
};

//------------------------------------------------------------------------------
FileSurface::FileSurface(std::shared_ptr<const FileReader> file, std::uint64_t cacheBudget,
  std::shared_ptr<const MergeTree> tree, std::size_t merges)
  : FileSurface(std::make_shared<ChunkCache>(std::move(file)), std::move(tree), merges)
{
  this->SetCacheBudget(cacheBudget);
}

FileSurface::FileSurface(
  std::shared_ptr<ChunkCache> cache, std::shared_ptr<const MergeTree> tree, std::size_t merges)
  : Cache(std::move(cache))
{
  if (merges > 0)
  {
    this->Layout =
      std::make_shared<const CoarseLayout>(this->GetFile(), *tree, MergeCut(*tree, merges));
  }
}

FileSurface::~FileSurface() = default;

//------------------------------------------------------------------------------
std::uint64_t FileSurface::GetLeastCache() const
{
  return this->Layout ? CoarseCache : SharedCache;
}

//------------------------------------------------------------------------------
/** While it lives, the surface has a cache that is large enough to work with. */
class FileSurface::WorkingCache
{
public:
  explicit WorkingCache(FileSurface& surface)
    : Surface(surface)
    , Given(surface.Cache)
  {
    const auto least = surface.GetLeastCache();
    if (this->Given->GetBudget() < least)
    {
      surface.Cache = std::make_shared<ChunkCache>(this->Given->GetFile(), least);
      surface.Cache->SetKeepsChunks(surface.Layout != nullptr);
    }
  }
  ~WorkingCache() { this->Surface.Cache = this->Given; }
  /** Whether the cache is gone afterwards. */
  bool IsTemporary() const { return this->Surface.Cache != this->Given; }

  WorkingCache(const WorkingCache&) = delete;
  WorkingCache& operator=(const WorkingCache&) = delete;

private:
  FileSurface& Surface;
  const std::shared_ptr<ChunkCache> Given;
};

//------------------------------------------------------------------------------
void FileSurface::SetCacheBudget(std::uint64_t bytes)
{
  // After merges, chunks are decoded for their tetrahedra first, and then again for points.
  const bool keepsChunks = bytes > 0 || this->Layout;
  this->KeepsBlocks = bytes > 0;
  this->Cache->SetKeepsChunks(keepsChunks);
  this->Cache->SetBudget(bytes + this->GetLeastCache());
}

//------------------------------------------------------------------------------
void FileSurface::Check(const FileSurfaceRequest& request) const
{
  const FileReader& file = *this->GetFile();
  const auto& arrays = file.GetArrays();
  const auto fail = [&](const std::string& what) { ThrowInvalid(what, file.GetPath()); };
  if (request.Array >= arrays.size() || arrays[request.Array].Where != Association::Point)
  {
    fail("there is no such point array to make isosurfaces of");
  }
  if (request.Component < -1 ||
    request.Component >= static_cast<int>(arrays[request.Array].Components))
  {
    fail("array '" + arrays[request.Array].Name + "' has no component " +
      std::to_string(request.Component));
  }
  if (request.Step >= file.GetNumberOfSteps())
  {
    fail("there is no time step " + std::to_string(request.Step));
  }
  const auto& carried = request.Arrays;
  if (std::adjacent_find(carried.begin(), carried.end(), std::greater_equal<>()) != carried.end() ||
    (!carried.empty() && carried.back() >= arrays.size()))
  {
    fail("the file has no such array");
  }
  const auto& values = request.Options.Values;
  if (std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) != values.end() ||
    !std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
  {
    fail("isovalues must be finite, different and ascending");
  }
  if (request.Piece >= request.Pieces)
  {
    fail("there is no such piece");
  }
}

//------------------------------------------------------------------------------
const IntervalTree& FileSurface::GetRanges(const FileSurfaceRequest& request)
{
  const TreeKey key{ request.Array, request.Component, request.Step };
  if (!this->Ranges || this->Ranges->first != key)
  {
    const FileReader& file = *this->GetFile();
    std::vector<Range> ranges(file.GetChunks().size());
    for (std::size_t chunk = 0; chunk < ranges.size(); ++chunk)
    {
      const auto& all = this->Layout
        ? file.GetChunkRanges(request.Array, request.Step, chunk, this->Layout->GetCut().GetLast())
        : file.GetChunkRanges(request.Array, request.Step, chunk);
      ranges[chunk] =
        request.Component < 0 ? all.back() : all[static_cast<std::size_t>(request.Component)];
    }
    this->Ranges.emplace(key, IntervalTree(ranges));
  }
  return this->Ranges->second;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FileSurface::FindChunks(const FileSurfaceRequest& request)
{
  this->Check(request);
  return this->GetRanges(request).FindAny(request.Options.Values);
}

//------------------------------------------------------------------------------
Bounds FileSurface::GetBounds(std::uint32_t chunk, std::size_t step) const
{
  return this->GetFile()->GetChunkBounds(
    chunk, this->Layout ? this->Layout->GetCut().GetLast() : 0, step);
}

//------------------------------------------------------------------------------
bool FileSurface::Touch(std::uint32_t a, std::uint32_t b, std::size_t step) const
{
  const Bounds one = this->GetBounds(a, step);
  const Bounds other = this->GetBounds(b, step);
  return std::equal(one.begin(), one.end(), other.begin(),
    [](const Range& x, const Range& y) { return x.Min <= y.Max && y.Min <= x.Max; });
}

//------------------------------------------------------------------------------
/** Tells a remote source what will be read. */
void FileSurface::Fetch(std::vector<std::uint32_t> chunks, const FileSurfaceRequest& request) const
{
  PieceRequest piece;
  piece.Chunks = std::move(chunks);
  piece.Arrays = ListArrays(request);
  piece.Step = request.Step;
  piece.Merges = this->Layout ? this->Layout->GetCut().GetLast() : 0;
  FetchPiece(*this->GetFile(), piece);
}

//------------------------------------------------------------------------------
FileSurface::Mesh FileSurface::DecodeCoarse(
  std::vector<std::uint32_t> chunks, const FileSurfaceRequest& request) const
{
  const FileReader& file = *this->GetFile();
  const auto arrays = ListArrays(request);
  Mesh mesh;
  PieceRequest piece;
  piece.Chunks = std::move(chunks);
  piece.RestoreOrder = false;
  const CoarsePiece coarse(this->Cache, this->Layout, piece, {});
  const std::uint64_t points = coarse.GetNumberOfPoints();
  const ScalarType coordinates = file.GetCoordinateType();
  mesh.Tets = coarse.GetCells().GetCount();
  mesh.Points.resize(static_cast<std::size_t>(3 * SizeOf(coordinates) * points));
  mesh.Connectivity.resize(static_cast<std::size_t>(4 * mesh.Tets));
  mesh.Input.Points = { mesh.Points.data(), coordinates, 3 };
  mesh.Input.Mesh.Points = points;
  mesh.Input.Mesh.Connectivity = mesh.Connectivity.data();
  mesh.Input.Mesh.WideIds = false;
  PieceTarget target;
  target.Points = mesh.Points.data();
  target.Connectivity = mesh.Connectivity.data();
  target.WideIds = false;
  mesh.Arrays.resize(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const ArrayDescription& array = file.GetArrays()[arrays[i]];
    const bool ofPoints = array.Where == Association::Point;
    TupleView view{ nullptr, array.Type, array.Components };
    mesh.Arrays[i].resize(
      static_cast<std::size_t>(ofPoints ? points : mesh.Tets) * view.GetTupleSize());
    view.Values = mesh.Arrays[i].data();
    target.Arrays.push_back(mesh.Arrays[i].data());
    if (i < request.Arrays.size())
    {
      (ofPoints ? mesh.Input.PointArrays : mesh.Input.CellArrays).push_back(view);
    }
  }
  coarse.Fill(target, arrays, request.Step, {});
  const auto scalars = std::find(arrays.begin(), arrays.end(), request.Array) - arrays.begin();
  const ArrayDescription& array = file.GetArrays()[request.Array];
  SetMarchValues(mesh.Input.Mesh,
    { mesh.Arrays[static_cast<std::size_t>(scalars)].data(), array.Type, array.Components },
    static_cast<std::size_t>(points), request.Component, mesh.Values);
  return mesh;
}

//------------------------------------------------------------------------------
std::vector<SurfacePart> FileSurface::MakeParts(ChunkSurface& maker,
  const std::vector<std::uint32_t>& chunks, const SurfaceOptions& options, const Progress& progress)
{
  std::vector<SurfacePart> parts(chunks.size());
  ParallelFor(
    chunks.size(), [&](std::size_t i) { parts[i] = maker.Make(chunks[i], options); }, progress);
  return parts;
}

//------------------------------------------------------------------------------
std::vector<SurfacePart> FileSurface::MakeCoarseParts(const std::vector<std::uint32_t>& chunks,
  const FileSurfaceRequest& request, const Progress& progress) const
{
  const auto& infos = this->GetFile()->GetChunks();
  std::vector<SurfacePart> parts;
  for (std::size_t begin = 0, end = 0; begin < chunks.size(); begin = end)
  {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(chunks.size())))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    std::uint64_t tets = 0;
    for (; end < chunks.size() && tets < CoarseBatch; ++end)
    {
      tets += infos[chunks[end]].Tets;
    }
    const auto at = [&](std::size_t i) { return chunks.begin() + static_cast<std::ptrdiff_t>(i); };
    const Mesh mesh = this->DecodeCoarse({ at(begin), at(end) }, request);
    auto made = MakeSurfaceParts(mesh.Input, request.Options, mesh.Tets);
    std::move(made.begin(), made.end(), std::back_inserter(parts));
  }
  return parts;
}

//------------------------------------------------------------------------------
Surface FileSurface::Extract(const FileSurfaceRequest& request, const Progress& progress)
{
  const auto all = this->FindChunks(request);
  const WorkingCache working(*this);
  const auto at = [&](std::size_t piece)
  { return all.begin() + static_cast<std::ptrdiff_t>(all.size() * piece / request.Pieces); };
  const std::vector<std::uint32_t> own(at(request.Piece), at(request.Piece + 1));

  // The normals of points that other pieces have, too, are made of the tetrahedra on both sides.
  std::vector<std::uint32_t> around;
  if (request.Options.Normals && own.size() < all.size())
  {
    std::set_difference(all.begin(), all.end(), own.begin(), own.end(), std::back_inserter(around));
    std::erase_if(around,
      [&](std::uint32_t chunk)
      {
        return std::none_of(own.begin(), own.end(),
          [&](std::uint32_t other) { return this->Touch(chunk, other, request.Step); });
      });
  }

  // In the order of the file, so that gradients are added as for the whole surface. (With merges,
  // batches differ, and with them the last bits of the sums.)
  const auto first = std::lower_bound(around.begin(), around.end(), own.empty() ? 0 : own.front());
  const std::vector<std::uint32_t> lists[] = { { around.begin(), first }, own,
    { first, around.end() } };
  this->Statistics = { own.size() + around.size(), 0 };
  std::vector<std::uint32_t> chunks;
  for (const auto& list : lists)
  {
    chunks.insert(chunks.end(), list.begin(), list.end());
    for (const std::uint32_t chunk : list)
    {
      this->Statistics.Tets += this->GetFile()->GetChunks()[chunk].Tets;
    }
  }
  this->Fetch(std::move(chunks), request);
  std::optional<ChunkSurface> maker;
  if (!this->Layout)
  {
    maker.emplace(this->Cache,
      ChunkSurfaceArrays{ request.Array, request.Component, request.Arrays, request.Step });
    if (!this->KeepsBlocks || working.IsTemporary())
    {
      maker->RemoveUsedBlocks(own);
      maker->RemoveUsedBlocks(around);
    }
  }
  std::vector<SurfacePart> parts;
  std::vector<std::size_t> ghosts;
  double done = 0;
  for (const auto& list : lists)
  {
    const double share = static_cast<double>(list.size()) /
      static_cast<double>(std::max<std::size_t>(this->Statistics.Chunks, 1));
    const auto advance = [&](double fraction)
    { return !progress || progress(0.9 * (done + share * fraction)); };
    auto made = maker ? MakeParts(*maker, list, request.Options, advance)
                      : this->MakeCoarseParts(list, request, advance);
    for (auto& part : made)
    {
      if (&list != &lists[1])
      {
        ghosts.push_back(parts.size());
      }
      parts.push_back(std::move(part));
    }
    done += share;
  }
  return Surface(std::move(parts), request.Options.CoordinateType, ghosts);
}
}
