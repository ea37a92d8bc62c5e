// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayTile_h
#define gatunRayTile_h

// The image while it is being drawn.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A segment of a ray. Distances are in samples. */
struct Fragment
{
  float Begin, End; // a fragment that begins where this one ends follows it
  float First;      // where its first visible part begins
  std::uint32_t Cell;
  alignas(16) std::array<float, 4> Sum; // premultiplied r, g, b and transmittance

  /** Appends a fragment behind this one. */
  void Append(const Fragment& behind);
};

/**
 * The pixels of a block of four by four, row by row. All that is known of them is in one place:
 * arrays for the whole tile would be apart by a power of two, so that the numbers of a pixel would
 * compete for the same lines of the cache.
 */
struct alignas(64) RayPixels
{
  static constexpr int Count = 16;
  using Numbers = std::array<float, Count>;

  /** A fragment of each pixel that may grow. */
  struct Slot
  {
    /** Premultiplied r, g, b and transmittance; in mode XRay, the last is 1 plus the optical depth.
     */
    std::array<Numbers, 4> Sums;
    Numbers First;
    Numbers Begin;
    Numbers End; // in mode Maximum, that of slot 0 is the largest place
  };

  std::array<Slot, 2> Slots;
  Numbers Near;           // distances before it are not seen
  Numbers Far;            // nor those from it on
  Numbers LengthPerDepth; // RayView::GetSamplesPerDepth, in perspective
  Numbers DepthPerLength; // its reciprocal
};

/** The pixels of a square of the image. */
struct RayTile
{
  static constexpr int Size = 32;
  static constexpr int Pixels = Size * Size;

  static constexpr float Never = -3e38f; // the End of no fragment
  static constexpr float Always = 8e6f;  // farther than anything

  /** Pixels beyond width and height are never drawn. */
  RayTile(int width, int height);

  /** The cell of a pixel: blocks are consecutive, row by row. */
  static constexpr int ToCell(int x, int y)
  {
    return (y / 4 * (Size / 4) + x / 4) * RayPixels::Count + y % 4 * 4 + x % 4;
  }

  RayPixels& GetBlock(int cell) { return this->Blocks[static_cast<unsigned>(cell) / 16]; }
  const RayPixels& GetBlock(int cell) const
  {
    return this->Blocks[static_cast<unsigned>(cell) / 16];
  }

  /** The place of a cell in its block. */
  static constexpr unsigned ToLane(int cell) { return static_cast<unsigned>(cell) % 16; }

  static constexpr int ToX(int cell) { return cell / 16 % (Size / 4) * 4 + cell % 4; }
  static constexpr int ToY(int cell) { return cell / 16 / (Size / 4) * 4 + cell % 16 / 4; }

  void Clear(unsigned slot, int cell);
  Fragment Get(unsigned slot, int cell) const;
  void Set(unsigned slot, const Fragment& fragment);

  /** Moves the fragment in a slot to the others. */
  void SetAside(unsigned slot, int cell);

  /** Merges the two fragments in the slots of a pixel. One must end where the other begins. */
  void MergeSlots(int cell);

  /** Sorts the others by pixel and depth, and merges those that touch. */
  void Consolidate();

  std::size_t CountFragments() const;

  std::array<RayPixels, Pixels / RayPixels::Count> Blocks;
  std::vector<Fragment> Others; // of pixels with more fragments than slots
  std::size_t MostOthers = std::size_t{ 4 } * Pixels;
  float Limit = Always; // the largest Far
};
}

#endif
