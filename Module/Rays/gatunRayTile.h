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
/** The sum of consecutive samples of a ray. */
struct Fragment
{
  float Begin, End; // in samples; a fragment that begins where this one ends follows it
  float First;      // its first visible sample
  std::uint32_t Pixel;
  alignas(16) std::array<float, 4> Sum; // premultiplied r, g, b and transmittance

  /** Appends a fragment behind this one. */
  void Append(const Fragment& behind);
};

/** The pixels of a square of the image. */
struct RayTile
{
  static constexpr int Size = 32;
  static constexpr int Pixels = Size * Size;

  // Numbers that are loaded four by two, with padding behind the last pixels.
  static constexpr int Stride = Size + 4;
  static constexpr int Cells = Stride * (Size + 1);
  using Cellwise = std::array<float, Cells>;

  static constexpr float Never = -3e38f; // the End of no fragment
  static constexpr float Always = 8e6f;  // farther than any sample
  static constexpr int Slots = 2;        // fragments of a pixel that may grow

  /** Pixels beyond width and height are never drawn. */
  RayTile(int width, int height);

  static constexpr int ToCell(int pixel) { return pixel / Size * Stride + pixel % Size; }

  void Clear(int slot, int pixel);
  Fragment Get(int slot, int pixel) const;

  /** Moves the fragment in a slot to the others. */
  void SetAside(int slot, int pixel);

  /** Merges the two fragments in the slots of a pixel. One must end where the other begins. */
  void MergeSlots(int pixel);

  /** Sorts the others by pixel and depth, and merges those that touch. */
  void Consolidate();

  std::size_t CountFragments() const;

  alignas(16) std::array<std::array<std::array<float, 4>, Pixels>, Slots> Sums;
  std::array<std::array<float, Pixels>, Slots> Firsts;
  Cellwise Near; // samples before it are not seen
  Cellwise Far;  // nor those from it on
  std::array<Cellwise, Slots> Begin;
  std::array<Cellwise, Slots> End; // in mode Maximum, that of slot 0 is the largest place
  std::vector<Fragment> Others;    // of pixels with more fragments than slots
  std::size_t MostOthers = std::size_t{ 4 } * Pixels;
  float Limit = Always; // the largest Far
};
}

#endif
