// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMemoryRaySource.h"

#include "gatunBlockMesh.h"
#include "gatunMeshAccess.h"
#include "gatunParallel.h"
#include "gatunPartition.h"
#include "gatunRayBlockCache.h"
#include "gatunRayBlockMaker.h"
#include "gatunWithType.h"

#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** Numbers points from 0 in the order in which they are first met. */
class PointNumbers
{
public:
  explicit PointNumbers(std::size_t tets)
  {
    // A block has about a fifth as many points as tetrahedra.
    this->Reserve(std::bit_ceil(std::max<std::size_t>(tets / 2, 16)));
  }

  std::uint32_t Find(std::uint32_t point)
  {
    Slot& slot = this->Search(point);
    if (slot.Point == None)
    {
      slot = { point, static_cast<std::uint32_t>(this->Points.size()) };
      this->Points.push_back(point);
      if (2 * this->Points.size() > this->Slots.size())
      {
        const auto number = slot.Number;
        this->Reserve(2 * this->Slots.size());
        return number;
      }
    }
    return slot.Number;
  }

  const std::vector<std::uint32_t>& GetPoints() const { return this->Points; }

private:
  // No index of a point: a mesh has fewer than 2^32 - 1 points.
  static constexpr std::uint32_t None = 0xffffffffu;

  struct Slot
  {
    std::uint32_t Point = None;
    std::uint32_t Number = 0;
  };

  Slot& Search(std::uint32_t point)
  {
    auto i = (point * 0x9e3779b97f4a7c15u) >> this->Shift;
    while (this->Slots[i].Point != point && this->Slots[i].Point != None)
    {
      i = (i + 1) & (this->Slots.size() - 1);
    }
    return this->Slots[i];
  }

  /** The number of slots must be a power of 2. */
  void Reserve(std::size_t slots)
  {
    this->Slots.assign(slots, {});
    this->Shift = 64 - static_cast<unsigned>(std::countr_zero(slots));
    for (std::uint32_t number = 0; number < this->Points.size(); ++number)
    {
      this->Search(this->Points[number]) = { this->Points[number], number };
    }
  }

  unsigned Shift = 0;
  std::vector<Slot> Slots;
  std::vector<std::uint32_t> Points;
};

//------------------------------------------------------------------------------
/** A mesh in the caller's memory. */
class InputMesh final : public BlockMesh
{
public:
  InputMesh(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    std::uint32_t blockTets, const RaySource::Progress& progress)
    : Mesh(mesh)
    , Values(values)
    , Hidden(hidden)
    , Parts(MakePartition(this->Mesh, { blockTets }, progress))
  {
  }

  std::size_t GetNumberOfBlocks() const override { return this->Parts.GetChunkCount(); }

  void GetTets(
    std::size_t block, std::vector<RayBlock::Tet>& tets, std::vector<double>& values) const override
  {
    std::vector<std::uint32_t> seen;
    for (auto i = this->Parts.ChunkStart[block]; i < this->Parts.ChunkStart[block + 1]; ++i)
    {
      const auto tet = this->Parts.Cells[i];
      if (!this->Hidden || this->Hidden[tet] == 0)
      {
        seen.push_back(tet);
      }
    }
    tets.resize(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
      for (unsigned corner = 0; corner < 4; ++corner)
      {
        tets[i][corner] = static_cast<std::uint32_t>(this->Mesh.GetTetId(seen[i], corner));
      }
    }
    if (this->Values.Where == Association::Cell)
    {
      values.resize(seen.size());
      this->WithValues(
        [&](auto&& getValue)
        {
          for (std::size_t i = 0; i < seen.size(); ++i)
          {
            values[i] = getValue(seen[i]);
          }
        });
    }
  }

  void GetPoints(std::span<const std::uint32_t> points, RayPoint* result) const override
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      result[i] = { this->Mesh.GetCoordinate(points[i], 0), this->Mesh.GetCoordinate(points[i], 1),
        this->Mesh.GetCoordinate(points[i], 2), 0 };
    }
    if (this->Values.Where == Association::Point)
    {
      this->WithValues(
        [&](auto&& getValue)
        {
          for (std::size_t i = 0; i < points.size(); ++i)
          {
            result[i].Value = getValue(points[i]);
          }
        });
    }
  }

private:
  template <typename Use>
  void WithValues(Use&& use) const
  {
    WithComponent(
      this->Values.Type, this->Values.Values, this->Values.Components, this->Values.Component, use);
  }

  MeshAccess Mesh;
  RayValuesInput Values;
  const unsigned char* Hidden;
  Partition Parts;
};

//------------------------------------------------------------------------------
/** A block that is not prepared yet. */
void MakeBlock(const BlockMesh& mesh, std::size_t index, RayBlock& block)
{
  mesh.GetTets(index, block.Tets, block.CellValues);
  PointNumbers numbers(block.Tets.size());
  for (RayBlock::Tet& tet : block.Tets)
  {
    for (auto& corner : tet)
    {
      corner = numbers.Find(corner);
    }
  }
  block.Points.resize(numbers.GetPoints().size());
  mesh.GetPoints(numbers.GetPoints(), block.Points.data());
}

/** The finite coordinates and the values of a block. */
void Measure(const RayBlock& block, Bounds& box, Range& range)
{
  for (const RayPoint& point : block.Points)
  {
    const std::array<double, 3> place{ point.X, point.Y, point.Z };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(place[axis]))
      {
        box[axis].Include(place[axis]);
      }
    }
    if (block.CellValues.empty())
    {
      range.Include(point.Value);
    }
  }
  for (const double value : block.CellValues)
  {
    range.Include(value);
  }
}
}

//------------------------------------------------------------------------------
class MemoryRaySource::Internals
{
public:
  Internals(std::unique_ptr<const BlockMesh> mesh, std::uint64_t budget)
    : Mesh(std::move(mesh))
    , Cache(budget)
    , Boxes(Mesh->GetNumberOfBlocks())
    , Ranges(Boxes.size())
  {
    ParallelFor(this->Boxes.size(),
      [&](std::size_t index)
      {
        RayBlock block;
        MakeBlock(*this->Mesh, index, block);
        Measure(block, this->Boxes[index], this->Ranges[index]);
      });
  }

  std::unique_ptr<const BlockMesh> Mesh;
  RayBlockCache Cache;
  std::vector<Bounds> Boxes;
  std::vector<Range> Ranges;
};

//------------------------------------------------------------------------------
MemoryRaySource::MemoryRaySource(const MeshInput& mesh, const RayValuesInput& values,
  const unsigned char* hidden, std::uint64_t budget, std::uint32_t blockTets,
  const Progress& progress)
  : MemoryRaySource(std::make_unique<InputMesh>(mesh, values, hidden, blockTets, progress), budget)
{
}

MemoryRaySource::MemoryRaySource(std::unique_ptr<const BlockMesh> mesh, std::uint64_t budget)
  : Self(std::make_unique<Internals>(std::move(mesh), budget))
{
}

MemoryRaySource::~MemoryRaySource() = default;

//------------------------------------------------------------------------------
std::size_t MemoryRaySource::GetNumberOfBlocks() const
{
  return this->Self->Boxes.size();
}

//------------------------------------------------------------------------------
const Bounds& MemoryRaySource::GetBounds(std::size_t block) const
{
  return this->Self->Boxes[block];
}

//------------------------------------------------------------------------------
Range MemoryRaySource::GetRange(std::size_t block) const
{
  return this->Self->Ranges[block];
}

//------------------------------------------------------------------------------
RaySource::Blocks MemoryRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  return FindOrMake(this->Self->Cache, blocks, progress,
    [&](std::size_t index, RayBlock& block) { MakeBlock(*this->Self->Mesh, index, block); });
}
}
