// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayCopies_h
#define gatunArrayCopies_h

// Arrays whose components are components of another array, bit by bit.

#include "gatunBytes.h"
#include "gatunErrorBound.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** The array with the values of another one, and their components there. */
struct ArrayCopy
{
  std::uint32_t Source = 0;
  std::vector<std::uint32_t> Components;
};

/** For each array that from which it is copied. Sources are no copies. */
using ArrayCopies = std::vector<std::optional<ArrayCopy>>;

/** Finds copies among the arrays of a time step whose values come in parts. The result does not
 * depend on the order of the parts. */
class CopySurvey
{
public:
  /** values: of each array, for these numbers of points and cells. */
  void Add(const std::vector<ArrayDescription>& arrays, std::span<const void* const> values,
    std::uint64_t points, std::uint64_t cells);

  /** Serializes the survey for another process, and adds such a message. */
  void Put(ByteWriter& out) const;
  void Add(ByteReader& in);

  /** Arrays of other bounds of errors are no copies. Equal values have equal hashes; CheckCopies
   * tells whether the opposite holds, too. */
  ArrayCopies Finish(
    const std::vector<ArrayDescription>& arrays, const std::vector<ArrayError>& errors = {}) const;

private:
  std::vector<std::uint64_t> Hashes; // of component after component, 0 if there are no values
};

/** Throws Error(InvalidInput) unless the values of copies are those of their sources. */
void CheckCopies(const ArrayCopies& copies, const std::vector<ArrayDescription>& arrays,
  std::span<const void* const> values, std::uint64_t points, std::uint64_t cells);
}

#endif
