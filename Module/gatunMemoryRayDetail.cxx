// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMemoryRayDetail.h"

#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunPartition.h"
#include "gatunRaySourceInternals.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <mutex>
#include <string>

namespace gatun
{
RayDetail::~RayDetail() = default;

namespace
{
using Tet = MergeTree::Tet;

/** Tetrahedra of a simpler mesh, those near each other together. */
struct TetList
{
  std::vector<Tet> Tets;
  std::vector<std::uint32_t> Cells; // which tetrahedra of the whole mesh they were, if that matters
};

/** Which place in a block each point gets: one after the other, as they come. */
class PointPlaces
{
public:
  explicit PointPlaces(std::size_t most)
    : Shift(64 - static_cast<unsigned>(std::bit_width(2 * most + 1)))
    , Slots(std::size_t{ 1 } << (64 - this->Shift))
  {
  }

  /** The place of a point, and whether it is new here. */
  std::pair<std::uint32_t, bool> Find(std::uint32_t point)
  {
    auto i = (point * 0x9e3779b97f4a7c15u) >> this->Shift;
    for (;; i = (i + 1) & (this->Slots.size() - 1))
    {
      Slot& slot = this->Slots[i];
      if (slot.Point == point)
      {
        return { slot.Place, false };
      }
      if (slot.Point == None)
      {
        slot = { point, this->Count++ };
        return { slot.Place, true };
      }
    }
  }

private:
  static constexpr std::uint32_t None = 0xffffffffu;
  struct Slot
  {
    std::uint32_t Point = None;
    std::uint32_t Place = 0;
  };
  unsigned Shift;
  std::vector<Slot> Slots;
  std::uint32_t Count = 0;
};

/** How many tetrahedra the blocks of a mesh of so many have: enough blocks for all threads to have
 * work, none so small that its borders count for more than what is in it. */
std::size_t ChooseBlockTets(std::size_t tets)
{
  return std::clamp<std::size_t>(tets / 16, 2048, MemoryRaySource::DefaultBlockTets);
}
}

//------------------------------------------------------------------------------
class MemoryRayDetail::Internals
{
public:
  MeshAccess Mesh;
  const unsigned char* Hidden;
  MergeTree Tree;
  Partition Whole;
  std::vector<RayPoint> Points;
  std::vector<double> CellValues; // if they are what is drawn

  mutable std::mutex Guard;                                    // of what follows
  std::map<std::size_t, std::shared_ptr<const TetList>> Bases; // by halvings, from 1
  std::map<std::uint64_t, std::uint64_t> Counts;               // tetrahedra of numbers of points

  Internals(const MeshAccess& mesh, const unsigned char* hidden, MergeTree tree,
    const RaySource::Progress& progress)
    : Mesh(mesh)
    , Hidden(hidden)
    , Tree(std::move(tree))
    , Whole(MakePartition(mesh, MemoryRaySource::DefaultBlockTets, progress))
  {
  }

  std::uint64_t GetPoints() const { return this->Tree.GetNumberOfPoints(); }
  std::uint64_t GetFewest() const { return this->GetPoints() - this->Tree.GetMerges().size(); }
  bool HasCells() const { return !this->CellValues.empty(); }

  void TakeValues(const RayValuesInput& values);
  std::shared_ptr<const TetList> FindBase(std::uint64_t points) const;
  std::shared_ptr<const TetList> Simplify(const TetList* base, std::uint64_t points) const;
  std::shared_ptr<const TetList> MakeTets(std::uint64_t points);
};

//------------------------------------------------------------------------------
void MemoryRayDetail::Internals::TakeValues(const RayValuesInput& values)
{
  const bool ofCells = values.Where == Association::Cell;
  const auto& mesh = this->Mesh.GetMesh();
  this->Points.resize(mesh.Points);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Points[i] = { this->Mesh.GetCoordinate(i, 0), this->Mesh.GetCoordinate(i, 1),
      this->Mesh.GetCoordinate(i, 2), 0 };
  }
  this->CellValues.resize(ofCells ? mesh.Tets : 0);
  WithValues(values,
    [&](auto&& getValue)
    {
      for (std::size_t i = 0; i < this->CellValues.size(); ++i)
      {
        this->CellValues[i] = getValue(i);
      }
      for (std::size_t i = 0; !ofCells && i < this->Points.size(); ++i)
      {
        this->Points[i].Value = getValue(i);
      }
    });
}

//------------------------------------------------------------------------------
/** What is left of a base, or of the whole mesh. */
std::shared_ptr<const TetList> MemoryRayDetail::Internals::Simplify(
  const TetList* base, std::uint64_t points) const
{
  const auto ancestors = this->Tree.FindAncestors(this->Tree.CountMergesForPoints(points));
  const std::size_t count = base ? base->Tets.size() : this->Whole.Tets.size();
  constexpr std::size_t most = std::size_t{ 1 } << 16;
  std::vector<TetList> parts((count + most - 1) / most);
  ParallelFor(parts.size(),
    [&](std::size_t part)
    {
      TetList& list = parts[part];
      for (auto i = part * most; i < std::min(count, (part + 1) * most); ++i)
      {
        Tet tet{};
        std::uint32_t cell = 0;
        if (base)
        {
          tet = base->Tets[i];
          cell = this->HasCells() ? base->Cells[i] : 0;
        }
        else
        {
          cell = this->Whole.Tets[i];
          if (this->Hidden && this->Hidden[cell] != 0)
          {
            continue;
          }
          for (unsigned c = 0; c < 4; ++c)
          {
            tet[c] = static_cast<std::uint32_t>(this->Mesh.GetId(cell, c));
          }
        }
        if (gatun::Simplify(tet, ancestors))
        {
          list.Tets.push_back(tet);
          if (this->HasCells())
          {
            list.Cells.push_back(cell);
          }
        }
      }
    });
  auto result = std::make_shared<TetList>();
  for (TetList& part : parts)
  {
    result->Tets.insert(result->Tets.end(), part.Tets.begin(), part.Tets.end());
    result->Cells.insert(result->Cells.end(), part.Cells.begin(), part.Cells.end());
    part = {};
  }
  return result;
}

//------------------------------------------------------------------------------
/** Of so many points, less than all. Makes the bases on the way to it. */
std::shared_ptr<const TetList> MemoryRayDetail::Internals::MakeTets(std::uint64_t points)
{
  std::shared_ptr<const TetList> base;
  for (std::size_t halvings = 1;; ++halvings)
  {
    const std::uint64_t ofBase = this->GetPoints() >> halvings;
    if (ofBase < points || ofBase <= this->GetFewest())
    {
      return this->Simplify(base.get(), points);
    }
    std::shared_ptr<const TetList> next;
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      next = this->Bases[halvings];
    }
    if (!next)
    {
      next = this->Simplify(base.get(), ofBase);
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

namespace
{
/** The tetrahedra of a list, or all of the mesh, in blocks. */
template <typename Detail>
class DetailSource final : public RaySource
{
public:
  DetailSource(
    std::shared_ptr<const Detail> detail, std::shared_ptr<const TetList> list, std::uint64_t budget)
    : Self(std::move(detail))
    , List(std::move(list))
    , Cache(budget)
  {
    if (this->List)
    {
      const auto count = this->List->Tets.size();
      const auto size = ChooseBlockTets(count);
      for (std::size_t first = 0; first < count; first += size)
      {
        this->Starts.push_back(first);
      }
      this->Starts.push_back(count);
    }
    else
    {
      this->Starts = this->Self->Whole.ChunkStart;
    }
    this->Boxes.resize(this->Starts.size() - 1);
    this->Ranges.resize(this->Boxes.size());
    ParallelFor(this->Boxes.size(), [&](std::size_t block) { this->Measure(block); });
  }

  std::size_t GetNumberOfBlocks() const override { return this->Boxes.size(); }
  const Bounds& GetBounds(std::size_t block) const override { return this->Boxes[block]; }
  Range GetRange(std::size_t block) const override { return this->Ranges[block]; }

  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override
  {
    return FindOrMake(this->Cache, blocks, progress,
      [&](std::size_t index, RayBlock& block) { this->Make(index, block); });
  }

private:
  /** Calls use(corners, which tetrahedron of the whole mesh) for each of a block. */
  template <typename Use>
  void ForEachTet(std::size_t block, Use&& use) const
  {
    const auto& self = *this->Self;
    for (auto i = this->Starts[block]; i < this->Starts[block + 1]; ++i)
    {
      if (this->List)
      {
        use(this->List->Tets[i], self.HasCells() ? this->List->Cells[i] : 0);
        continue;
      }
      const auto cell = self.Whole.Tets[i];
      if (!self.Hidden || self.Hidden[cell] == 0)
      {
        Tet tet{};
        for (unsigned c = 0; c < 4; ++c)
        {
          tet[c] = static_cast<std::uint32_t>(self.Mesh.GetId(cell, c));
        }
        use(tet, cell);
      }
    }
  }

  void Measure(std::size_t block)
  {
    const auto& self = *this->Self;
    this->ForEachTet(block,
      [&](const Tet& tet, std::uint32_t cell)
      {
        for (const auto point : tet)
        {
          self.Mesh.Extend(this->Boxes[block], point);
          Extend(this->Ranges[block],
            self.HasCells() ? self.CellValues[cell] : self.Points[point].Value);
        }
      });
  }

  void Make(std::size_t index, RayBlock& block) const
  {
    const auto& self = *this->Self;
    const auto most = this->Starts[index + 1] - this->Starts[index];
    PointPlaces places(most);
    block.Tets.reserve(most);
    block.Points.reserve(most / 4);
    this->ForEachTet(index,
      [&](Tet tet, std::uint32_t cell)
      {
        for (auto& corner : tet)
        {
          const auto [place, isNew] = places.Find(corner);
          if (isNew)
          {
            block.Points.push_back(self.Points[corner]);
          }
          corner = place;
        }
        block.Tets.push_back(tet);
        if (self.HasCells())
        {
          block.CellValues.push_back(self.CellValues[cell]);
        }
      });
    block.Points.shrink_to_fit();
  }

  std::shared_ptr<const Detail> Self;
  std::shared_ptr<const TetList> List; // null for all of the mesh
  RayBlockCache Cache;
  std::vector<std::size_t> Starts;
  std::vector<Bounds> Boxes;
  std::vector<Range> Ranges;
};
}

//------------------------------------------------------------------------------
MemoryRayDetail::MemoryRayDetail(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, MergeTree tree, const Progress& progress)
{
  if (tree.GetNumberOfPoints() != mesh.Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "the merges are those of a mesh of " + std::to_string(tree.GetNumberOfPoints()) +
        " points, not of " + std::to_string(mesh.Points));
  }
  this->Self = std::make_shared<Internals>(MeshAccess(mesh), hidden, std::move(tree), progress);
  this->Self->TakeValues(values);
  const std::uint64_t tets = hidden ? mesh.Tets -
      static_cast<std::uint64_t>(std::count_if(
        hidden, hidden + mesh.Tets, [](unsigned char isHidden) { return isHidden != 0; }))
                                    : mesh.Tets;
  this->Self->Counts = { { 0, 0 }, { mesh.Points, tets } };
}

MemoryRayDetail::~MemoryRayDetail() = default;

//------------------------------------------------------------------------------
std::uint64_t MemoryRayDetail::GetNumberOfPoints() const
{
  return this->Self->GetPoints();
}

//------------------------------------------------------------------------------
std::uint64_t MemoryRayDetail::GetFewestPoints() const
{
  return this->Self->GetFewest();
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> MemoryRayDetail::MakeSource(std::uint64_t points, std::uint64_t budget)
{
  auto& self = *this->Self;
  points = std::clamp(points, self.GetFewest(), self.GetPoints());
  std::shared_ptr<const TetList> list;
  if (points < self.GetPoints())
  {
    list = self.MakeTets(points);
    const std::lock_guard<std::mutex> lock(self.Guard);
    self.Counts[points] = list->Tets.size();
  }
  return std::make_shared<DetailSource<Internals>>(this->Self, std::move(list), budget);
}

//------------------------------------------------------------------------------
std::uint64_t MemoryRayDetail::EstimateTets(std::uint64_t points) const
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

//------------------------------------------------------------------------------
MergeTree BuildRayTree(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, const RaySource::Progress& progress)
{
  const MeshAccess access(mesh);
  std::vector<std::array<double, 3>> points(mesh.Points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      points[i][axis] = access.GetCoordinate(i, axis);
    }
  }
  std::vector<Tet> tets;
  std::vector<std::uint64_t> cells;
  for (std::uint64_t i = 0; i < mesh.Tets; ++i)
  {
    if (hidden && hidden[i] != 0)
    {
      continue;
    }
    Tet& tet = tets.emplace_back();
    cells.push_back(i);
    for (unsigned c = 0; c < 4; ++c)
    {
      const auto point = access.GetId(i, c);
      if (point >= mesh.Points)
      {
        throw Error(ErrorCode::InvalidInput,
          "tetrahedron " + std::to_string(i) + " has a point that does not exist");
      }
      tet[c] = static_cast<std::uint32_t>(point);
    }
  }
  std::vector<double> field(mesh.Points);
  WithValues(values,
    [&](auto&& getValue)
    {
      if (values.Where == Association::Point)
      {
        for (std::size_t i = 0; i < field.size(); ++i)
        {
          field[i] = getValue(i);
        }
        return;
      }
      std::vector<std::uint32_t> uses(mesh.Points, 0);
      for (std::size_t i = 0; i < tets.size(); ++i)
      {
        for (const auto point : tets[i])
        {
          field[point] += getValue(cells[i]);
          ++uses[point];
        }
      }
      for (std::size_t i = 0; i < field.size(); ++i)
      {
        field[i] /= std::max(uses[i], 1u);
      }
    });
  return BuildMergeTree({ points, tets, { { field, 1 } } }, {}, progress);
}
}
