// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeOrder_h
#define gatunMergeOrder_h

#include "gatunMergeInput.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** A mesh whose points and tetrahedra are sorted spatially, so that neighbors are near each other
 * in memory. This makes algorithms that visit neighbors faster. */
class LocalMergeInput
{
public:
  explicit LocalMergeInput(const MergeInput& input);

  /** Valid as long as this object exists. */
  const MergeInput& Get() const { return this->Local; }

  /** For each point, its number in the given mesh. */
  const std::vector<std::uint32_t>& GetIds() const { return this->Ids; }

private:
  void OrderPoints(const MergeInput& input);
  void OrderTets(const MergeInput& input);

  std::vector<std::uint32_t> Ids;
  std::vector<std::array<double, 3>> Points;
  std::vector<MergeTree::Tet> Tets;
  std::vector<std::vector<double>> Values;
  std::vector<std::uint8_t> IsKept;
  MergeInput Local;
};
}

#endif
