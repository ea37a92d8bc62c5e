// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetSeparation.h"

#include "gatunChunkTets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
// A tetrahedron takes about 0.7 bits less in a chunk of tetrahedra alone, and a shared point about
// 20 bits more than one of a single chunk. More chunks have more tables.
constexpr std::size_t TetsPerSharedPoint = 32;
constexpr std::size_t TetsPerBucket = 4096;

/** Decides which buckets to divide. */
class Separation
{
public:
  explicit Separation(const MeshAccess& mesh)
    : Mesh(mesh)
    , LastBucket(static_cast<std::size_t>(mesh.GetMesh().Points), 0)
  {
  }

  bool IsTet(std::uint32_t cell) const { return this->Mesh.GetType(cell) == TetraType; }

  /** Whether to divide a bucket, whose tetrahedra come first. */
  bool Pays(std::span<const std::uint32_t> tets, std::span<const std::uint32_t> others)
  {
    if (tets.empty() || others.empty())
    {
      return false;
    }
    ++this->Bucket;
    for (const auto cell : others)
    {
      this->Mesh.ForEachPoint(
        cell, [&](std::uint64_t point) { this->LastBucket[point] = this->Bucket; });
    }
    std::size_t between = 0;
    for (const auto cell : tets)
    {
      this->Mesh.ForEachPoint(cell,
        [&](std::uint64_t point)
        {
          // Each point counts once.
          between += std::exchange(this->LastBucket[point], 0) == this->Bucket;
        });
    }
    return TetsPerBucket + TetsPerSharedPoint * between < tets.size();
  }

private:
  const MeshAccess& Mesh;
  std::vector<std::uint32_t> LastBucket; // whose other cells use a point
  std::uint32_t Bucket = 0;
};
}

//------------------------------------------------------------------------------
void SeparateTets(const MeshAccess& mesh, LayerBuckets& buckets)
{
  if (mesh.IsTetrahedral())
  {
    return;
  }
  Separation separation(mesh);
  std::vector<std::size_t> starts;
  for (std::size_t b = 0; b + 1 < buckets.Start.size(); ++b)
  {
    const std::span cells(
      buckets.Cells.data() + buckets.Start[b], buckets.Start[b + 1] - buckets.Start[b]);
    const auto isTet = [&](std::uint32_t cell) { return separation.IsTet(cell); };
    const auto others = std::stable_partition(cells.begin(), cells.end(), isTet);
    const auto tets = static_cast<std::size_t>(others - cells.begin());
    starts.push_back(buckets.Start[b]);
    if (separation.Pays(cells.first(tets), cells.subspan(tets)))
    {
      starts.push_back(buckets.Start[b] + tets);
    }
    else
    {
      std::inplace_merge(cells.begin(), others, cells.end());
    }
  }
  starts.push_back(buckets.Start.back());
  buckets.Start = std::move(starts);
}
}
