// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRelease_h
#define gatunRelease_h

#include "gatunRayBlock.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The side from which rays must have reached a tetrahedron before it is ready. */
enum class ReleaseFrom : std::uint8_t
{
  Front, ///< from the eye
  Both   ///< from the eye, or from behind
};

/**
 * The order in which tetrahedra are drawn and released as they arrive one after the other: the
 * readiness check of Yang, Mitra and Chiueh (On-the-fly rendering of losslessly compressed
 * irregular volume data, 2000). A face is processed when one of its tetrahedra has been drawn, or
 * if it is on the boundary. A tetrahedron is ready once all its faces towards the eye are
 * processed; or all those away from the eye, if rays may grow from both ends. The newest ready
 * tetrahedron is drawn first. Tetrahedra that wait for each other in a cycle are drawn at the end.
 */
class Release
{
public:
  /** Neighbors: see RayBlock; facing: see RayKernel::Look. */
  void FindOrder(std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing,
    ReleaseFrom from);

  const std::vector<std::uint32_t>& GetOrder() const { return this->Order; }

  /** The maximum number of tetrahedra that had arrived but were not ready. */
  std::size_t GetMostWaiting() const { return this->MostWaiting; }

  std::size_t GetMemorySize() const
  {
    return (this->Order.capacity() + this->Ready.capacity()) * 4 + this->State.capacity() * 2;
  }

private:
  template <ReleaseFrom From>
  void Find(std::span<const RayBlock::Tet> neighbors, std::span<const std::uint8_t> facing);

  std::vector<std::uint32_t> Order;
  std::vector<std::uint32_t> Ready;
  std::vector<std::uint16_t> State; // open faces, and whether it is drawn or ready
  std::size_t MostWaiting = 0;
};
}

#endif
