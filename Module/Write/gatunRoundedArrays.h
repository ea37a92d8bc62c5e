// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRoundedArrays_h
#define gatunRoundedArrays_h

// Arrays whose values may have an error, while they are written.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunDomainSurvey.h"
#include "gatunErrorBound.h"
#include "gatunTypes.h"
#include "gatunWriterOptions.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace gatun
{
/** The bound of an array: that of its name, otherwise that of "*". */
ErrorBound FindBound(const std::vector<ArrayError>& errors, const ArrayDescription& array);

/** The bound, and whether values are on a lattice: base meshes, the boundary and layers have to
 * have the same values as the mesh. */
RoundingRequest GetRoundingRequest(const WriterOptions& options, const ArrayDescription& array);

/** Throws Error(InvalidInput) if bounds are impossible or are those of no array. */
void CheckErrors(
  const std::vector<ArrayDescription>& arrays, const std::vector<ArrayError>& errors);

/** The values of an array at one time step that readers will have, and their errors. */
class RoundedArray
{
public:
  /** Begins with the original values, which must exist as long as this does. */
  RoundedArray(const ArrayDescription& array, const void* original, std::size_t tuples);

  const std::uint8_t* GetValues() const { return this->Values.data(); }

  /** Rounds the values on the lattices of the domains: all tuples, or those of the lists. */
  void PutOnLattice(std::span<const Domain> domains, std::span<const std::uint32_t> shared,
    std::span<const std::uint32_t> unused);

  /** Takes the value of a plain key that was encoded, if the domain has errors. Throws
   * Error(InvalidInput) if the error is larger than the bound, which would be a mistake of the
   * encoder. Threads may take different tuples. */
  void Take(const Domain& domain, std::size_t tuple, std::size_t component, Key key);

  /** Takes tuples of components of another array, which has the same original values. */
  void Copy(const RoundedArray& source, std::span<const std::uint32_t> components,
    std::span<const std::uint32_t> tuples);

  /** The largest error of a component in the measure of its bound. */
  double GetError(std::size_t component) const { return this->Errors[component]; }

private:
  std::size_t Place(std::size_t tuple, std::size_t component) const
  {
    return (tuple * this->Array.Components + component) * SizeOf(this->Array.Type);
  }

  const ArrayDescription& Array;
  const std::uint8_t* Original;
  std::size_t Tuples;
  Bytes Values;
  std::vector<double> Errors;
  std::mutex ErrorsMutex;
};
}

#endif
