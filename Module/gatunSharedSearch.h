// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSharedSearch_h
#define gatunSharedSearch_h

#include "gatunMeasure.h"
#include "gatunTopology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Finds the shared vertices, not met yet, that lie in front of a gate and near it. */
class SharedSearch
{
public:
  static constexpr unsigned Most = 8;

  struct Hit
  {
    double Rank;
    std::uint32_t Index;
  };

  struct Hits
  {
    std::array<Hit, Most> List;
    unsigned Count = 0;
  };

  explicit SharedSearch(std::span<const SharedVertex> vertices);

  /**
   * The vertices in front of the gate a, b, c whose distance to its centroid is at most 4 times its
   * longest edge; the nearest Most of them (ties by index), then sorted by the ranking.
   */
  Hits Find(const GateMeasure& measure, const LatticePoint& a, const LatticePoint& b,
    const LatticePoint& c, Ranking ranking) const;

  void Remove(std::uint32_t index) { this->Gone[index] = 1; }
  bool IsGone(std::uint32_t index) const { return this->Gone[index] != 0; }

private:
  unsigned CellOf(double coordinate) const
  {
    return static_cast<unsigned>(coordinate) >> this->Shift;
  }

  std::span<const SharedVertex> Vertices;
  std::vector<char> Gone;
  std::vector<std::uint32_t> CellStart; // of each cell, its first place in Sorted
  std::vector<std::uint32_t> Sorted;    // vertices by cell, ascending within
  unsigned Shift = 16;
  int Cells = 1; // along each axis
};
}

#endif
