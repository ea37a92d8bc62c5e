// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyStencil_h
#define gatunHartleyStencil_h

#include "gatunHartleyKernel.h"
#include "gatunHartleyPainter.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** The voxels of blocks that HartleyStencil uses, as many as a budget allows. The first ones are
 * kept, because all are used in a cycle. Threads may use different blocks at the same time. */
class HartleyBlockVoxels
{
public:
  HartleyBlockVoxels(std::size_t blocks, std::uint64_t bytes)
    : Kept(blocks)
    , Left(static_cast<std::int64_t>(bytes))
  {
  }

  bool IsKept(std::size_t block) const { return !this->Kept[block].empty(); }
  std::span<const float> Get(std::size_t block) const { return this->Kept[block]; }

  /** Keeps the voxels of a block if there is room for them. */
  void Keep(std::size_t block, std::span<const float> voxels);

private:
  static constexpr std::size_t Overhead = sizeof(std::vector<float>) + 2 * sizeof(void*);

  std::vector<std::vector<float>> Kept;
  std::atomic<std::int64_t> Left;
};

/**
 * Computes the images of blocks from their voxels. In sheared coordinates, the voxels of a plane of
 * a block have the same positions relative to the lattice. So the weights of the voxels next to a
 * lattice point, in the integral along its ray, depend on its parity only: the image of a plane is
 * a convolution with a few weights. The result is exact except for rounding, and the time does not
 * depend on the number of coefficients.
 */
class HartleyStencil : public HartleyPainter
{
public:
  HartleyStencil(const HartleyLattice& lattice, const HartleyLayout::Triple& block,
    std::shared_ptr<HartleyBlockVoxels> voxels);

  std::unique_ptr<Brush> MakeBrush() const override;
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;
  bool IsKept(std::size_t block) const override { return this->Voxels->IsKept(block); }

private:
  class StencilBrush;

  // The kernel computes up to this many groups of eight pairs of points at a time.
  static constexpr std::size_t GroupsAtOnce = 4;

  /** A part of a row of the image. */
  struct Run
  {
    std::size_t FirstTap = 0;
    std::size_t EndTap = 0;
    std::size_t Groups = 0;
  };

  /** The voxels of a plane along an axis across the rays: the first one next to the first points of
   * both parities, and the distances of these points from it. */
  struct Start
  {
    std::ptrdiff_t Voxel = 0;
    double Distance = 0;
  };
  Start GetStart(std::size_t axis, std::size_t point, std::size_t plane) const;

  void ListTaps();
  void AddTaps(std::size_t row, std::size_t plane, std::size_t firstPair, std::size_t groups);

  HartleyLattice Lattice;
  HartleyLayout::Triple Block;
  std::shared_ptr<HartleyBlockVoxels> Voxels;
  std::array<std::size_t, 3> Size{};       // of a block along the lattice's axes
  std::array<std::ptrdiff_t, 3> Strides{}; // of these axes in a block
  std::size_t Margin = 0;                  // zeros between rows of voxels
  std::vector<float> Weights;              // by plane, parity of the row, row and column of a voxel
  std::vector<HartleyTap> Taps;
  std::vector<Run> Runs; // of each row of the image
  std::size_t RunsPerRow = 1;
};
}

#endif
