// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMemoryLevelsOfDetail.h"

#include "gatunBaseMeshes.h"
#include "gatunBlockMesh.h"
#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunMemoryRaySource.h"
#include "gatunMergeBuilder.h"
#include "gatunParallel.h"
#include "gatunPartition.h"
#include "gatunVolumeDetail.h"
#include "gatunWithType.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string>

namespace gatun
{
namespace
{
using Tet = MergeTree::Tet;

/** Tetrahedra in spatial order. */
struct TetList
{
  std::vector<Tet> Tets;
  std::vector<double> Values; // of the tetrahedra, if these are drawn

  void Add(const TetList& from)
  {
    this->Tets.insert(this->Tets.end(), from.Tets.begin(), from.Tets.end());
    this->Values.insert(this->Values.end(), from.Values.begin(), from.Values.end());
  }
};

/** Calls use(getValue), where getValue(i) is the value of tuple i that is drawn. */
template <typename Use>
void WithValues(const RayValuesInput& input, Use&& use)
{
  WithComponent(input.Type, input.Values, input.Components, input.Component, use);
}

/** The beginnings of the blocks of a list, and its end. */
using BlockStarts = std::vector<std::size_t>;

/** Makes enough blocks to occupy all threads, but none so small that its boundary dominates its
 * cost. */
BlockStarts CutIntoBlocks(std::size_t tets)
{
  const auto size = std::clamp<std::size_t>(tets / 8, 4096, MemoryRaySource::DefaultBlockTets);
  BlockStarts starts;
  for (std::size_t first = 0; first < tets; first += size)
  {
    starts.push_back(first);
  }
  starts.push_back(tets);
  return starts;
}
}

//------------------------------------------------------------------------------
class MemoryRayMesh::Internals
{
public:
  std::vector<RayPoint> Points;
  std::shared_ptr<const TetList> Whole;
  BlockStarts Starts; // of the whole mesh's blocks

  void TakePoints(const MeshAccess& mesh, const RayValuesInput& values);
  void TakeTets(const MeshAccess& mesh, const RayValuesInput& values, const unsigned char* hidden,
    const Progress& progress);
};

//------------------------------------------------------------------------------
void MemoryRayMesh::Internals::TakePoints(const MeshAccess& mesh, const RayValuesInput& values)
{
  this->Points.resize(mesh.GetMesh().Points);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Points[i] = { mesh.GetCoordinate(i, 0), mesh.GetCoordinate(i, 1),
      mesh.GetCoordinate(i, 2), 0 };
  }
  if (values.Where == Association::Point)
  {
    WithValues(values,
      [&](auto&& getValue)
      {
        for (std::size_t i = 0; i < this->Points.size(); ++i)
        {
          this->Points[i].Value = getValue(i);
        }
      });
  }
}

//------------------------------------------------------------------------------
void MemoryRayMesh::Internals::TakeTets(const MeshAccess& mesh, const RayValuesInput& values,
  const unsigned char* hidden, const Progress& progress)
{
  const auto parts = MakePartition(mesh, { MemoryRaySource::DefaultBlockTets }, progress);
  auto list = std::make_shared<TetList>();
  list->Tets.reserve(parts.Cells.size());
  WithValues(values,
    [&](auto&& getValue)
    {
      for (std::size_t chunk = 0; chunk < parts.GetChunkCount(); ++chunk)
      {
        this->Starts.push_back(list->Tets.size());
        for (auto i = parts.ChunkStart[chunk]; i < parts.ChunkStart[chunk + 1]; ++i)
        {
          const auto tet = parts.Cells[i];
          if (hidden && hidden[tet] != 0)
          {
            continue;
          }
          auto& corners = list->Tets.emplace_back();
          for (unsigned c = 0; c < 4; ++c)
          {
            corners[c] = static_cast<std::uint32_t>(mesh.GetTetId(tet, c));
          }
          if (values.Where == Association::Cell)
          {
            list->Values.push_back(getValue(tet));
          }
        }
      }
    });
  this->Starts.push_back(list->Tets.size());
  this->Whole = std::move(list);
}

//------------------------------------------------------------------------------
MemoryRayMesh::MemoryRayMesh(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, const Progress& progress)
  : Self(std::make_unique<Internals>())
{
  const MeshAccess access(mesh);
  this->Self->TakeTets(access, values, hidden, progress);
  this->Self->TakePoints(access, values);
}

MemoryRayMesh::~MemoryRayMesh() = default;

//------------------------------------------------------------------------------
std::uint64_t MemoryRayMesh::GetNumberOfPoints() const
{
  return this->Self->Points.size();
}

//------------------------------------------------------------------------------
MergeTree MemoryRayMesh::BuildTree(const Progress& progress) const
{
  const auto& self = *this->Self;
  std::vector<std::array<double, 3>> points;
  std::vector<double> field;
  points.reserve(self.Points.size());
  field.reserve(self.Points.size());
  for (const RayPoint& p : self.Points)
  {
    points.push_back({ p.X, p.Y, p.Z });
    field.push_back(p.Value);
  }
  const TetList& list = *self.Whole;
  std::vector<std::uint32_t> uses(list.Values.empty() ? 0 : points.size(), 0);
  for (std::size_t i = 0; i < list.Values.size(); ++i)
  {
    for (const auto point : list.Tets[i])
    {
      field[point] += list.Values[i];
      ++uses[point];
    }
  }
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    field[i] /= std::max(uses[i], 1u);
  }
  return BuildMergeTree({ points, list.Tets, { { field, 1 } } }, {}, progress);
}

namespace
{
/** A list of tetrahedra in blocks. */
class ListMesh final : public BlockMesh
{
public:
  ListMesh(std::shared_ptr<const MemoryRayMesh> mesh, std::shared_ptr<const TetList> list,
    BlockStarts starts)
    : Mesh(std::move(mesh))
    , List(std::move(list))
    , Starts(std::move(starts))
  {
  }

  std::size_t GetNumberOfBlocks() const override { return this->Starts.size() - 1; }

  void GetTets(
    std::size_t block, std::vector<Tet>& tets, std::vector<double>& values) const override
  {
    const auto first = static_cast<std::ptrdiff_t>(this->Starts[block]);
    const auto last = static_cast<std::ptrdiff_t>(this->Starts[block + 1]);
    const TetList& list = *this->List;
    tets.assign(list.Tets.begin() + first, list.Tets.begin() + last);
    if (!list.Values.empty())
    {
      values.assign(list.Values.begin() + first, list.Values.begin() + last);
    }
  }

  void GetPoints(std::span<const std::uint32_t> points, RayPoint* result) const override
  {
    const auto& all = this->Mesh->GetInternals().Points;
    std::transform(
      points.begin(), points.end(), result, [&](std::uint32_t point) { return all[point]; });
  }

private:
  std::shared_ptr<const MemoryRayMesh> Mesh;
  std::shared_ptr<const TetList> List;
  BlockStarts Starts;
};

std::shared_ptr<RaySource> MakeListSource(std::shared_ptr<const MemoryRayMesh> mesh,
  std::shared_ptr<const TetList> list, BlockStarts starts, std::uint64_t budget)
{
  return std::make_shared<MemoryRaySource>(
    std::make_unique<ListMesh>(std::move(mesh), std::move(list), std::move(starts)), budget);
}
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> MakeWholeSource(
  std::shared_ptr<const MemoryRayMesh> mesh, std::uint64_t budget)
{
  const auto& internals = mesh->GetInternals();
  return MakeListSource(std::move(mesh), internals.Whole, internals.Starts, budget);
}

//------------------------------------------------------------------------------
class MemoryLevelsOfDetail::Internals
{
public:
  std::shared_ptr<const MemoryRayMesh> Mesh;
  MergeTree Tree;
  std::uint64_t Budget;
  Bounds Box;

  mutable std::mutex Guard;                                    // of what follows
  std::map<std::size_t, std::shared_ptr<const TetList>> Bases; // by halvings
  std::map<std::uint64_t, std::uint64_t> Counts;               // tetrahedra by numbers of points

  std::uint64_t GetPoints() const { return this->Tree.GetNumberOfPoints(); }
  std::uint64_t GetFewest() const { return this->GetPoints() - this->Tree.GetMerges().size(); }

  std::shared_ptr<const TetList> Simplify(
    const TetList& base, const std::vector<std::uint32_t>& ancestors) const;
  std::shared_ptr<const TetList> MakeTets(std::uint64_t points);
  std::size_t FindBase(const DetailView& view, std::uint64_t points) const;
  const VolumeDetail& GetDetail(std::size_t halvings, const RaySource::Progress& progress);
  std::shared_ptr<RaySource> MakeSource(std::shared_ptr<const TetList> list) const;

  // For views, of one base at a time, and only for who makes sources.
  std::size_t Halvings = 0;
  std::shared_ptr<const TetList> CutTets;
  std::unique_ptr<VolumeDetail> Detail;
};

//------------------------------------------------------------------------------
/** Simplifies a base further. */
std::shared_ptr<const TetList> MemoryLevelsOfDetail::Internals::Simplify(
  const TetList& base, const std::vector<std::uint32_t>& ancestors) const
{
  const std::size_t count = base.Tets.size();
  constexpr std::size_t most = std::size_t{ 1 } << 16;
  std::vector<TetList> parts((count + most - 1) / most);
  ParallelFor(parts.size(),
    [&](std::size_t part)
    {
      TetList& list = parts[part];
      for (auto i = part * most; i < std::min(count, (part + 1) * most); ++i)
      {
        Tet tet = base.Tets[i];
        if (gatun::Simplify(tet, ancestors))
        {
          list.Tets.push_back(tet);
          if (!base.Values.empty())
          {
            list.Values.push_back(base.Values[i]);
          }
        }
      }
    });
  auto result = std::make_shared<TetList>();
  for (TetList& part : parts)
  {
    result->Add(part);
    part = {};
  }
  result->Tets.shrink_to_fit();
  return result;
}

//------------------------------------------------------------------------------
/** Returns the tetrahedra of the level with a given number of points. Makes the bases on the way
 * to it. */
std::shared_ptr<const TetList> MemoryLevelsOfDetail::Internals::MakeTets(std::uint64_t points)
{
  auto base = this->Mesh->GetInternals().Whole;
  const auto simplify = [&](std::uint64_t left) {
    return this->Simplify(*base, this->Tree.FindAncestors(this->Tree.CountMergesForPoints(left)));
  };
  for (std::size_t halvings = 1;; ++halvings)
  {
    const std::uint64_t ofBase = this->GetPoints() >> halvings;
    if (ofBase < points || ofBase <= this->GetFewest())
    {
      return simplify(points);
    }
    std::shared_ptr<const TetList> next;
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      next = this->Bases[halvings];
    }
    if (!next)
    {
      next = simplify(ofBase);
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Bases[halvings] = next;
      this->Counts[ofBase] = next->Tets.size();
    }
    base = std::move(next);
    if (ofBase == points)
    {
      return base;
    }
  }
}

//------------------------------------------------------------------------------
/** The coarsest base that is fine enough for a view, by halvings. */
std::size_t MemoryLevelsOfDetail::Internals::FindBase(
  const DetailView& view, std::uint64_t points) const
{
  const double weight = DetailWeights(view.View, GetDiagonal(this->Box)).Get(this->Box);
  std::size_t halvings = 0;
  for (;; ++halvings)
  {
    const auto next = this->GetPoints() >> (halvings + 1);
    const bool isEnough = next >= FinestToUniform * points ||
      this->Tree.GetLargestError(this->Tree.CountMergesForPoints(next)) * weight <= view.PixelError;
    if (!isEnough || next <= this->GetFewest())
    {
      return halvings;
    }
  }
}

//------------------------------------------------------------------------------
/** What chooses the merges of a base. */
const VolumeDetail& MemoryLevelsOfDetail::Internals::GetDetail(
  std::size_t halvings, const RaySource::Progress& progress)
{
  if (this->Detail && this->Halvings == halvings)
  {
    return *this->Detail;
  }
  this->Detail.reset();
  const auto points = this->GetPoints() >> halvings;
  this->CutTets = halvings == 0 ? this->Mesh->GetInternals().Whole : this->MakeTets(points);
  const auto& all = this->Tree.GetMerges();
  const auto done = halvings == 0 ? 0 : this->Tree.CountMergesForPoints(points);
  const auto tree = std::make_shared<const MergeTree>(this->Tree.GetNumberOfPoints(),
    std::vector<Merge>(all.begin() + static_cast<std::ptrdiff_t>(done), all.end()));
  auto dependencies =
    std::make_shared<const MergeDependencies>(*tree, this->CutTets->Tets, progress);
  // Only merges ask for places.
  std::vector<VolumeDetail::Place> places;
  const auto none = static_cast<std::uint32_t>(tree->GetMerges().size());
  std::vector<std::uint32_t> placeOf(this->GetPoints(), none);
  const auto& known = this->Mesh->GetInternals().Points;
  for (const Merge& merge : tree->GetMerges())
  {
    placeOf[merge.Point] = static_cast<std::uint32_t>(places.size());
    places.push_back({ known[merge.Point], {} });
  }
  IncludeValues(this->CutTets->Tets, known, this->CutTets->Values,
    [&](std::uint32_t corner)
    { return placeOf[corner] != none ? &places[placeOf[corner]] : nullptr; });
  this->Detail = std::make_unique<VolumeDetail>(
    CutChooser(tree, std::move(dependencies), this->GetPoints() - done), std::move(places),
    std::move(placeOf), std::vector<std::uint32_t>{}, GetDiagonal(this->Box));
  this->Halvings = halvings;
  return *this->Detail;
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> MemoryLevelsOfDetail::Internals::MakeSource(
  std::shared_ptr<const TetList> list) const
{
  auto starts = CutIntoBlocks(list->Tets.size());
  return MakeListSource(this->Mesh, std::move(list), std::move(starts), this->Budget);
}

//------------------------------------------------------------------------------
MemoryLevelsOfDetail::MemoryLevelsOfDetail(
  std::shared_ptr<const MemoryRayMesh> mesh, MergeTree tree, std::uint64_t budget)
  : Self(std::make_unique<Internals>())
{
  const auto points = mesh->GetNumberOfPoints();
  if (tree.GetNumberOfPoints() != points)
  {
    throw Error(ErrorCode::InvalidInput,
      "the merges are those of a mesh of " + std::to_string(tree.GetNumberOfPoints()) +
        " points, not of " + std::to_string(points));
  }
  this->Self->Counts = { { 0, 0 }, { points, mesh->GetInternals().Whole->Tets.size() } };
  for (const RayPoint& point : mesh->GetInternals().Points)
  {
    this->Self->Box.Include(std::array{ point.X, point.Y, point.Z });
  }
  this->Self->Mesh = std::move(mesh);
  this->Self->Tree = std::move(tree);
  this->Self->Budget = budget;
}

MemoryLevelsOfDetail::~MemoryLevelsOfDetail() = default;

//------------------------------------------------------------------------------
std::uint64_t MemoryLevelsOfDetail::GetNumberOfPoints() const
{
  return this->Self->GetPoints();
}

//------------------------------------------------------------------------------
std::uint64_t MemoryLevelsOfDetail::GetFewestPoints() const
{
  return this->Self->GetFewest();
}

//------------------------------------------------------------------------------
DetailLevel MemoryLevelsOfDetail::MakeLevel(
  const DetailRequest& wanted, const RaySource::Progress& progress)
{
  auto& self = *this->Self;
  const auto [points, view] = this->Clamp(wanted);
  if (!view && points == self.GetPoints())
  {
    return { MakeWholeSource(self.Mesh, self.Budget), points };
  }
  if (!view)
  {
    auto list = self.MakeTets(points);
    {
      const std::lock_guard<std::mutex> lock(self.Guard);
      self.Counts[points] = list->Tets.size();
    }
    return { self.MakeSource(std::move(list)), points };
  }
  const VolumeDetail& detail = self.GetDetail(self.FindBase(*view, points), progress);
  const auto before = self.Tree.GetMerges().size() - detail.GetTree().GetMerges().size();
  const MergeCut cut = detail.Choose(*view, points);
  return { self.MakeSource(self.Simplify(*self.CutTets, cut.GetAncestors())),
    self.GetPoints() - before - cut.GetNumberOfMerges() };
}

//------------------------------------------------------------------------------
std::uint64_t MemoryLevelsOfDetail::EstimateTets(std::uint64_t points) const
{
  const auto& self = *this->Self;
  points = std::clamp(points, self.GetFewest(), self.GetPoints());
  const std::lock_guard<std::mutex> lock(self.Guard);
  const auto high = self.Counts.lower_bound(points);
  if (high->first == points)
  {
    return high->second;
  }
  const auto low = std::prev(high);
  const double part =
    static_cast<double>(points - low->first) / static_cast<double>(high->first - low->first);
  return low->second +
    static_cast<std::uint64_t>(part * static_cast<double>(high->second - low->second));
}
}
