// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnHistogram_h
#define gtnHistogram_h

// How the values of an array of a .gtn file are spread, and what an isosurface of it would read.

#include "gtnDescription.h"

#include "gatunFileReader.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gtn
{
struct HistogramOptions
{
  std::string Array;
  int Component = -1; ///< -1: the length of the tuples
  int Bins = 20;
};

/** Values from From to below To; the last bin has its To as well. */
struct HistogramBin
{
  double From = 0;
  double To = 0;
  std::uint64_t Count = 0;

  // What an isosurface of the value in the middle needs; of point arrays only.
  std::uint64_t Chunks = 0;
  std::uint64_t Tets = 0;
  std::uint64_t Bytes = 0;
};

/** Of the first time step. Points that chunks share are counted once. */
class Histogram
{
public:
  /** Decodes the array, some chunks at a time. Throws Failure if it is not there. */
  Histogram(const std::shared_ptr<const gatun::FileReader>& file, const HistogramOptions& options);

  /** Adds a part with the histogram. */
  void Describe(Description& description) const;

private:
  void Read(const std::shared_ptr<const gatun::FileReader>& file);
  void FindNeeds(const gatun::FileReader& file);

  std::uint32_t Array = 0;
  gatun::ArrayDescription Source;
  std::uint32_t Component = 0; // their number: the length
  std::size_t BinCount;
  std::vector<HistogramBin> Bins;
  std::uint64_t NoNumbers = 0;
  std::uint64_t Infinite = 0;
  std::uint64_t AllBytes = 0; // of the mesh and the array
  bool HasTime = false;
};
}

#endif
