// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunBrickBuilder_h
#define gatunBrickBuilder_h

#include "gatunMergeBrick.h"
#include "gatunMergeInput.h"
#include "gatunMergeRange.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace gatun
{
/** A part of a mesh. A tetrahedron is in one part, and a point in any number of them. */
struct MergePart
{
  MergeInput Mesh;                          ///< without IsKept; all parts have the same fields
  std::span<const std::uint32_t> Numbers;   ///< of its points in the whole mesh
  std::span<const std::uint8_t> IsShared{}; ///< whether other parts may have a point; empty: none
  std::span<const std::uint32_t> Cells{}; ///< a number that each tetrahedron keeps; empty: none has
};

/** Cuts the parts of a mesh into bricks, and finds what the costs of merges are relative to. */
class BrickBuilder
{
public:
  using Take = std::function<void(const MergeBrick&, const Bounds&)>;

  /** fields: their number. most: tetrahedra of a brick. */
  BrickBuilder(std::size_t fields, std::size_t most)
    : Most(most)
    , Fields(fields)
  {
  }

  /** Calls take with each brick of a part and the box of its points. The samples are sums over the
   * part. Throws InvalidInput. */
  void Add(const MergePart& part, const Take& take);

  /** To be called once behind the last part. */
  void End();

  /** Makes samples of the whole mesh (MergeFields::GetData) of those of a brick of a part. */
  void Finish(MergeBrick& brick) const;

  double GetPerWhole() const { return this->Volume > 0 ? 1 / this->Volume : 0; }
  double GetPerTet() const { return this->Tets > 0 ? 1 / static_cast<double>(this->Tets) : 0; }

private:
  void AddSums(const MergePart& part, const MergeSums& sums);
  void Finish(std::span<FieldSample> samples) const;
  MergeBrick Make(const MergePart& part, const MergeSums& sums, std::span<std::uint32_t> tets);

  const std::size_t Most;
  std::vector<FieldRange> Fields;
  std::vector<double> Scales; // of the values of fields
  double Volume = 0;
  std::size_t Tets = 0;
  std::unordered_map<std::uint32_t, std::vector<FieldSample>> Shared; // by the number of a point
  std::vector<std::uint32_t> Places; // scratch: of each point of a part, its place in a brick
};
}

#endif
