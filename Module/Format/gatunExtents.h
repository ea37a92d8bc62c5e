// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExtents_h
#define gatunExtents_h

// Embedded files that have bytes in common with earlier parts of the file. See
// Documentation/format.md, 18.3.

#include "gatunBytes.h"
#include "gatunContainer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** A run of bytes of an embedded file. */
struct Extent
{
  std::uint64_t Length = 0;
  std::uint64_t Source = 0; // where the bytes are in the whole file; 0: in the section
};

/** The beginning of a section with a file of these runs; none: all of it is in the section. The
 * bytes that are in the section follow. */
Bytes WriteExtents(std::span<const Extent> extents);

/** Where the bytes of an embedded file are in the whole file. Safe on hostile input. */
class ExtentMap
{
public:
  /** The longest beginning of the section that tells where the list of runs is. */
  static constexpr std::size_t HeadBytes = 10 + sizeof(std::uint64_t);

  /** The list, as a packed part in the section. Its length is 0 if there is none; the file begins
   * at its offset then. head: the first bytes of the section's payload. Throws Error(Corrupt). */
  static StreamRef FindList(std::span<const std::uint8_t> head, const StreamRef& section);

  /** Throws Error(Corrupt) unless the runs fill the section, and the others are before it. */
  ExtentMap(std::span<const std::uint8_t> list, const StreamRef& where, const StreamRef& section);

  std::uint64_t GetSize() const { return this->Size; }

  /** The place of a byte in the whole file, and the number of bytes that follow each other there.
   */
  struct Place
  {
    std::uint64_t Offset = 0;
    std::uint64_t Length = 0;
  };
  Place Find(std::uint64_t offset) const;

private:
  struct Part
  {
    std::uint64_t Begin = 0; // in the embedded file
    std::uint64_t Source = 0;
  };
  std::vector<Part> Parts;
  std::uint64_t Size = 0;
};
}

#endif
