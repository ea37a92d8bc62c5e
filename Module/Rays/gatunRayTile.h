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

/** The pixels of a square of the image. */
struct RayTile
{
  static constexpr int Size = 32;
  static constexpr int Pixels = Size * Size;
  using Cellwise = std::array<float, Pixels>;

  static constexpr float Never = -3e38f; // the End of no fragment
  static constexpr float Always = 8e6f;  // farther than anything
  static constexpr int Slots = 2;        // fragments of a pixel that may grow

  /** Pixels beyond width and height are never drawn. */
  RayTile(int width, int height);

  /** The cell of a pixel. Blocks of four by four pixels are consecutive, row by row, and so are
   * the upper and lower halves of a block. */
  static constexpr int ToCell(int x, int y)
  {
    return (y / 4 * (Size / 4) + x / 4) * 16 + y % 4 * 4 + x % 4;
  }

  static constexpr int ToX(int cell) { return cell / 16 % (Size / 4) * 4 + cell % 4; }
  static constexpr int ToY(int cell) { return cell / 16 / (Size / 4) * 4 + cell % 16 / 4; }

  void Clear(int slot, int cell);
  Fragment Get(int slot, int cell) const;

  /** Moves the fragment in a slot to the others. */
  void SetAside(int slot, int cell);

  /** Merges the two fragments in the slots of a pixel. One must end where the other begins. */
  void MergeSlots(int cell);

  /** Sorts the others by pixel and depth, and merges those that touch. */
  void Consolidate();

  std::size_t CountFragments() const;

  /** Premultiplied r, g, b and transmittance; in mode XRay, the last is 1 plus the optical depth.
   */
  alignas(64) std::array<std::array<Cellwise, 4>, Slots> Sums;
  alignas(64) std::array<Cellwise, Slots> Firsts;
  alignas(64) Cellwise Near; // distances before it are not seen
  alignas(64) Cellwise Far;  // nor those from it on
  alignas(64) std::array<Cellwise, Slots> Begin;
  alignas(
    64) std::array<Cellwise, Slots> End; // in mode Maximum, that of slot 0 is the largest place
  alignas(64) Cellwise LengthPerDepth;   // RayView::GetSamplesPerDepth, in perspective
  alignas(64) Cellwise DepthPerLength;   // its reciprocal
  std::vector<Fragment> Others;          // of pixels with more fragments than slots
  std::size_t MostOthers = std::size_t{ 4 } * Pixels;
  float Limit = Always; // the largest Far
};
}

#endif
